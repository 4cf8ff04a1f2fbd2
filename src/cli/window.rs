//! `inbetween [FILE]`: the window.

use std::path::{Path, PathBuf};

use super::CliError;

/// Opens the window on a scene, with a keyframe file.
///
/// # Errors
/// [`CliError`]
pub fn run(_scene: Option<&Path>, _file: Option<PathBuf>) -> Result<(), CliError> {
    Err(CliError::bad_input("inbetween", "this build has no window"))
}
