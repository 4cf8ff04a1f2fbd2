//! Scenes by name: built-in ones and files.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::FileError;
use crate::editor::Editor;
use crate::scene::{
    DEFAULT_SCENE, LARGEST_SCENE_BYTES, SceneGraph, built_in_scene, built_in_scene_names, scene_from_bytes,
};
use crate::storage;
use crate::words::Message;

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
    scene_from_bytes(&bytes).map_err(|error| FileError::new(&location, error))
}

/// The scene in a file.
///
/// # Errors
/// Why it cannot be read, without the file's name.
pub fn load_file(path: &Path) -> Result<SceneGraph, Message> {
    let bytes = storage::read(path, LARGEST_SCENE_BYTES).map_err(|error| error.message())?;
    scene_from_bytes(&bytes).map_err(|error| error.message())
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
