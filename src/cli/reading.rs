//! Keyframes for every command that reads them: a keyframe file, or a text in any layout.

use std::path::Path;

use super::{Common, output};
use crate::export::Animation;
use crate::files::{self, FileError};
use crate::interpolation::Interpolation;
use crate::scene::SceneGraph;
use crate::storage::input_name;
use crate::text_layouts::Reading;
use crate::words::texts;

/// Reads keyframes. What was inferred from a text is said on standard error; a person should check the warnings, which are said also
/// where a command is to be quiet.
///
/// # Errors
/// [`FileError`] with everything that is wrong with the file.
pub fn keyframes(file: &Path, scene: &SceneGraph, common: Common<'_>) -> Result<Reading, FileError> {
    let reading = files::keyframes(file, scene)?;
    let name = input_name(file);
    if let (Some(report), false) = (&reading.report, common.is_quiet) {
        output::complain(&texts::reading_as_text(&name, report.summary.clone()).to_string());
    }
    for warning in reading.warnings() {
        output::complain(&format!("{name}: warning: {warning}"));
    }
    Ok(reading)
}

/// Reads keyframes as [`keyframes`] does, as an animation; `interpolation`, where given, replaces the file's.
///
/// # Errors
/// [`FileError`] with everything that is wrong with the file.
pub fn animation(
    file: &Path,
    scene: &SceneGraph,
    interpolation: Option<Interpolation>,
    common: Common<'_>,
) -> Result<Animation, FileError> {
    Ok(Animation::of(keyframes(file, scene, common)?.file, interpolation))
}
