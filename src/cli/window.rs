//! `inbetween [FILE]`: the window.

use std::path::{Path, PathBuf};

use super::arguments::DEFAULT_KEYFRAME_FILE;
use super::{CliError, misuse, scene};
use crate::editor::{Command, FileCommand};
use crate::storage;
use crate::ui::PathPurpose;
use crate::window::{ForTests, Signals};
use crate::words::texts;

/// Opens the window on a scene, with a keyframe file, which is loaded if it is named and exists. The window reports errors of the file.
///
/// # Errors
/// [`CliError`]: a bad scene, no display, no GPU adapter.
pub fn run(scene: Option<&Path>, file: Option<PathBuf>, tests: ForTests) -> Result<(), CliError> {
    if file.as_deref().is_some_and(storage::is_standard) {
        return Err(misuse(&texts::places_needs_a_file("FILE").to_string()));
    }
    let signals = Signals::listen();
    let loaded = scene::load(scene)?;
    let (at_start, path) = match file {
        Some(path) if storage::exists(&path) => match PathPurpose::Open.command(path.clone()) {
            Some(model @ Command::Window(_)) => (vec![model], path.with_file_name(DEFAULT_KEYFRAME_FILE)),
            _ => (vec![Command::File(FileCommand::Import)], path),
        },
        Some(path) => (Vec::new(), path),
        None => (Vec::new(), PathBuf::from(DEFAULT_KEYFRAME_FILE)),
    };
    Ok(crate::window::run(scene::editor_of(loaded, scene, path), at_start, &signals, tests)?)
}
