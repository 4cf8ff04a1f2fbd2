//! The scene that `--scene` names.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::CliError;
use crate::editor::Editor;
use crate::scene::{DEFAULT_SCENE, SceneGraph, built_in_scene, built_in_scene_names, scene_from_json};
use crate::storage;

/// The largest scene file that is read: 256 MiB.
pub const LARGEST_SCENE_BYTES: u64 = 256 << 20;

/// The built-in scene of that name, or the scene in that file; the default one where nothing is named.
///
/// # Errors
/// [`CliError::BadInput`]: there is neither, or the file is no scene.
pub fn load(name_or_file: Option<&Path>) -> Result<SceneGraph, CliError> {
    let name_or_file = name_or_file.unwrap_or(Path::new(DEFAULT_SCENE));
    if let Some(scene) = name_or_file.to_str().and_then(built_in_scene) {
        return Ok(scene);
    }
    let place = name_or_file.display();
    let bytes = storage::read(name_or_file, LARGEST_SCENE_BYTES).map_err(|error| {
        let names = built_in_scene_names().collect::<Vec<_>>().join(", ");
        CliError::bad_input(&place, format!("neither a built-in scene ({names}) nor a file that can be read: {error}"))
    })?;
    let text = std::str::from_utf8(&bytes)
        .map_err(|error| CliError::bad_input(&place, format!("not UTF-8 at byte {}", error.valid_up_to())))?;
    scene_from_json(text.strip_prefix('\u{feff}').unwrap_or(text)).map_err(|error| CliError::bad_input(&place, error))
}

/// An editor of a scene that was loaded so; where it came from a file, that is where it is saved.
pub fn editor_of(scene: SceneGraph, name_or_file: Option<&Path>, keyframes: PathBuf) -> Editor {
    let editor = Editor::new(Arc::new(scene), keyframes);
    match name_or_file {
        Some(file) if file.to_str().and_then(built_in_scene).is_none() => editor.with_scene_path(file.to_owned()),
        _ => editor,
    }
}
