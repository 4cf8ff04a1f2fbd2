//! Files that the editor reads and writes, with the knowledge of what they were.

use std::path::{Path, PathBuf};

use super::scene::meshes_beside;
use crate::editor::{Editor, FileAccess, FileOutcome, Writing, Written};
use crate::keyframe::LARGEST_FILE_BYTES;
use crate::scene::{LARGEST_SCENE_BYTES, MeshesFile, SceneFiles, with_meshes_within};
use crate::storage::{self, KnownFiles, StorageError};
use crate::words::{quoted, texts};

/// What the files of an editor are before anything is read or written for it. Its scene was read already.
#[must_use]
pub fn known_at_start(editor: &Editor) -> KnownFiles {
    let mut known = KnownFiles::default();
    known.begin(editor.keyframe_file());
    if let Some(path) = editor.scene_path() {
        known.begin_with_content(path);
        let meshes = SceneFiles::new(editor.scene(), path).meshes;
        // The scene may have its meshes from a file of another name.
        if let Some(meshes) = meshes.filter(|meshes| storage::is_held(&meshes.path, &meshes.glb)) {
            known.begin_with_content(&meshes.path);
        }
    }
    known
}

/// Reads a file of keyframes or of a scene, with the meshes that the scene names within. One that may be written later is known once [`KnownFiles::took_in`] says that it was taken in.
///
/// # Errors
/// Why it cannot be read.
pub fn read_known(known: &mut KnownFiles, access: FileAccess, path: &Path) -> FileOutcome<Vec<u8>> {
    let limit = if access == FileAccess::SceneRead { LARGEST_SCENE_BYTES } else { LARGEST_FILE_BYTES };
    let bytes = storage::read(path, limit).map_err(|error| error.message())?;
    if access != FileAccess::ComparedRead {
        known.read(path, &bytes);
    }
    if access != FileAccess::SceneRead {
        return Ok(bytes);
    }
    with_meshes_within(bytes, |name| {
        let meshes = meshes_beside(path)(name)?;
        known.read_with_it(&path.with_file_name(name), &meshes);
        Ok(meshes)
    })
}

/// Writes a file and remembers what it is now. `keeps`: whether what it held is copied beside it first. The scene's meshes are written
/// before it; another file of their name is copied in any case.
///
/// # Errors
/// Why it was not written; a regular file is then unchanged.
pub fn write_known(known: &mut KnownFiles, writing: Writing<'_>, keeps: bool) -> FileOutcome<Written> {
    let Writing { path, text, meshes, .. } = writing;
    let kept_meshes = match meshes {
        Some(meshes) => write_meshes(known, meshes)
            .map_err(|error| texts::scene_meshes_file(quoted(&meshes.path.display().to_string()), error.message()))?,
        None => None,
    };
    let write = || {
        let kept = if keeps { storage::keep_copy(path)? } else { None };
        let (stamp, committed) = storage::write_stamped(path, |file| write!(file, "{text}"))?;
        Ok((stamp, Written { kept, other_links: committed.other_links, kept_meshes }))
    };
    let (stamp, written) = write().map_err(|error: StorageError| error.message())?;
    known.wrote(path, stamp);
    Ok(written)
}

/// Writes a file of meshes, and nothing if it holds them already. Returns where what it held was put, unless that was known and of this
/// program's making.
fn write_meshes(known: &mut KnownFiles, meshes: &MeshesFile) -> Result<Option<PathBuf>, StorageError> {
    let MeshesFile { path, glb } = meshes;
    if storage::is_held(path, glb) {
        known.begin_with_content(path);
        return Ok(None);
    }
    let is_own = known.knows(path) && known.change(path).is_none();
    let kept = if is_own { None } else { storage::keep_copy(path)? };
    let (stamp, _) = storage::write_stamped(path, |file| file.write_all(glb))?;
    known.wrote(path, stamp);
    Ok(kept)
}
