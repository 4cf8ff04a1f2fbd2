//! Files that the editor reads and writes, with the knowledge of what they were.

use std::path::Path;

use crate::editor::{Editor, FileAccess, FileOutcome, Writing, Written};
use crate::keyframe::LARGEST_FILE_BYTES;
use crate::scene::LARGEST_SCENE_BYTES;
use crate::storage::{self, KnownFiles, StorageError};

/// What the files of an editor are before anything is read or written for it. Its scene was read already.
#[must_use]
pub fn known_at_start(editor: &Editor) -> KnownFiles {
    let mut known = KnownFiles::default();
    known.begin(editor.keyframe_file());
    if let Some(path) = editor.scene_path() {
        known.begin_with_content(path);
    }
    known
}

/// Reads a file of keyframes or of a scene. One that may be written later is known once [`KnownFiles::took_in`] says that it was taken in.
///
/// # Errors
/// Why it cannot be read.
pub fn read_known(known: &mut KnownFiles, access: FileAccess, path: &Path) -> FileOutcome<Vec<u8>> {
    let limit = if access == FileAccess::SceneRead { LARGEST_SCENE_BYTES } else { LARGEST_FILE_BYTES };
    let bytes = storage::read(path, limit).map_err(|error| error.message())?;
    if access != FileAccess::ComparedRead {
        known.read(path, &bytes);
    }
    Ok(bytes)
}

/// Writes a file and remembers what it is now. `keeps`: whether what it held is copied beside it first.
///
/// # Errors
/// Why it was not written; a regular file is then unchanged.
pub fn write_known(known: &mut KnownFiles, writing: Writing<'_>, keeps: bool) -> FileOutcome<Written> {
    let Writing { path, text, .. } = writing;
    let write = || {
        let kept = if keeps { storage::keep_copy(path)? } else { None };
        let (stamp, committed) = storage::write_stamped(path, |file| write!(file, "{text}"))?;
        Ok((stamp, Written { kept, other_links: committed.other_links }))
    };
    let (stamp, written) = write().map_err(|error: StorageError| error.message())?;
    known.wrote(path, stamp);
    Ok(written)
}
