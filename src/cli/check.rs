//! `inbetween check`: checks keyframe files.

use std::path::Path;

use super::arguments::CheckArguments;
use super::places::Places;
use super::{CliError, output, scene};
use crate::files::{self, FileError};
use crate::scene::SceneGraph;
use crate::storage;
use crate::text::counted;

/// Checks the files: a line for each, or one for each problem, in the order of the files.
///
/// # Errors
/// [`CliError`] with all of the lines, where any file is bad.
pub fn run(arguments: &CheckArguments, scene: Option<&Path>) -> Result<(), CliError> {
    let places = Places::with_scene(scene);
    arguments.files.iter().fold(places, |places, file| places.reads("FILE", file)).check()?;
    let scene = &scene::load(scene)?;
    let mut lines = Vec::new();
    let mut are_good = true;
    for file in &arguments.files {
        match verdict(file, scene) {
            Ok(line) => lines.push(line),
            Err(problems) => {
                are_good = false;
                lines.extend(problems.sentences().iter().cloned());
            }
        }
    }
    if are_good { output::say(&(lines.join("\n") + "\n")) } else { Err(CliError::bad_inputs(lines)) }
}

fn verdict(file: &Path, scene: &SceneGraph) -> Result<String, FileError> {
    let (keyframes, interpolation, ms) = files::keyframe_file(file, scene)?.into_parts();
    let keyframes = counted(keyframes.len(), "keyframe");
    Ok(format!("{}: ok, {keyframes}, {}, {ms} ms", storage::input_name(file), interpolation.name()))
}
