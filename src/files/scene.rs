//! Scenes by name: built-in ones and files.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::FileError;
use crate::editor::Editor;
use crate::scene::{
    DEFAULT_SCENE, LARGEST_MESHES_BYTES, LARGEST_SCENE_BYTES, SceneFiles, SceneGraph, built_in_scene,
    built_in_scene_names, scene_to_json, scene_with_meshes,
};
use crate::storage::{self, StorageError};
use crate::words::{Message, texts};

/// The built-in scene of that name, or the scene in that file; the default one where nothing is named.
///
/// # Errors
/// [`FileError`]: there is neither, or the file is no scene.
pub fn load(name_or_file: Option<&Path>) -> Result<SceneGraph, FileError> {
    let name_or_file = name_or_file.unwrap_or(Path::new(DEFAULT_SCENE));
    if let Some(scene) = name_or_file.to_str().and_then(built_in_scene) {
        return Ok(scene);
    }
    let location = storage::input_name(name_or_file);
    let bytes = storage::read(name_or_file, LARGEST_SCENE_BYTES).map_err(|error| {
        let names = built_in_scene_names().collect::<Vec<_>>().join(", ");
        FileError::new(&location, format!("neither a built-in scene ({names}) nor a file that can be read: {error}"))
    })?;
    scene_with_meshes(&bytes, meshes_beside(name_or_file)).map_err(|error| FileError::new(&location, error))
}

/// The scene in a file.
///
/// # Errors
/// Why it cannot be read, without the file's name.
pub fn load_file(path: &Path) -> Result<SceneGraph, Message> {
    let bytes = storage::read(path, LARGEST_SCENE_BYTES).map_err(|error| error.message())?;
    scene_with_meshes(&bytes, meshes_beside(path)).map_err(|error| error.message())
}

/// Reads the file of meshes that a scene names: in the folder of the scene's file, all links followed, and nowhere else.
pub(super) fn meshes_beside(scene: &Path) -> impl FnOnce(&str) -> Result<Vec<u8>, Message> + Send {
    move |name: &str| {
        if storage::is_standard(scene) {
            return Err(texts::SCENE_MESHES_APART.into());
        }
        let path = scene.with_file_name(name);
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        if storage::exists(&path) && storage::inside(&path, folder).is_none() {
            return Err(texts::SCENE_MESHES_OUTSIDE.into());
        }
        storage::read(&path, LARGEST_MESHES_BYTES).map_err(|error| error.message())
    }
}

/// Writes a scene, and its meshes beside it. What other files of these names held is copied. Returns where, for each that was.
///
/// # Errors
/// [`FileError`]: a file cannot be written; the scene's file is then unchanged.
pub fn save(scene: &SceneGraph, path: &Path) -> Result<Vec<PathBuf>, FileError> {
    save_files(SceneFiles::new(scene, path), path)
}

/// Writes a scene with its meshes within. What another file of this name held is copied. Returns where, if one was.
///
/// # Errors
/// [`FileError`]: the file cannot be written; it is then unchanged.
pub fn save_with_meshes_within(scene: &SceneGraph, path: &Path) -> Result<Vec<PathBuf>, FileError> {
    save_files(SceneFiles { text: scene_to_json(scene), meshes: None }, path)
}

fn save_files(SceneFiles { text, meshes }: SceneFiles, path: &Path) -> Result<Vec<PathBuf>, FileError> {
    let failed = |path: &Path, error: StorageError| FileError::new(storage::output_name(path), error);
    let mut kept = Vec::new();
    let all = meshes.iter().map(|meshes| (&*meshes.path, &*meshes.glb)).chain([(path, text.as_bytes())]);
    for (path, bytes) in all.filter(|(path, bytes)| !storage::is_held(path, bytes)) {
        kept.extend(storage::keep_copy(path).map_err(|error| failed(path, error))?);
        storage::write(path, bytes).map_err(|error| failed(path, error))?;
    }
    Ok(kept)
}

/// The file that [`load`] reads for `name_or_file`; `None` for a built-in scene.
#[must_use]
pub fn file_of(name_or_file: Option<&Path>) -> Option<&Path> {
    name_or_file.filter(|file| file.to_str().and_then(built_in_scene).is_none())
}

/// An editor of a scene that [`load`] gave for `name_or_file`. A scene from a file is saved to that file.
#[must_use]
pub fn editor_of(scene: SceneGraph, name_or_file: Option<&Path>, keyframes: PathBuf) -> Editor {
    let editor = Editor::new(Arc::new(scene), keyframes);
    match file_of(name_or_file) {
        Some(file) => editor.with_scene_path(file.to_owned()),
        None => editor,
    }
}
