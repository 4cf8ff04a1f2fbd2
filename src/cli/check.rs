//! `inbetween check`: whether keyframe files are good.

use std::path::Path;

use super::{CliError, animation, output};
use crate::cli::arguments::CheckArguments;
use crate::scene::SceneGraph;

/// Checks the files: a line for each, or one for each problem, in the order of the files.
///
/// # Errors
/// [`CliError::BadInput`] with all of the lines, where any file is bad.
pub fn run(arguments: &CheckArguments, scene: &SceneGraph) -> Result<(), CliError> {
    let mut lines = Vec::new();
    let mut are_good = true;
    for file in &arguments.files {
        match verdict(file, scene) {
            Ok(line) => lines.push(line),
            Err(problems) => {
                are_good = false;
                lines.extend(problems);
            }
        }
    }
    if are_good {
        output::print(|output| writeln!(output, "{}", lines.join("\n")))
    } else {
        Err(CliError::BadInput { sentences: lines })
    }
}

fn verdict(file: &Path, scene: &SceneGraph) -> Result<String, Vec<String>> {
    let place = file.display();
    match animation::read(file, scene) {
        Ok(read) => {
            let (keyframes, interpolation, ms) = read.into_parts();
            let count = keyframes.len();
            let keyframes = if count == 1 { "keyframe" } else { "keyframes" };
            Ok(format!("{place}: ok, {count} {keyframes}, {}, {ms} ms", interpolation.name()))
        }
        Err(problems) => Err(problems.iter().map(|problem| format!("{place}: {problem}")).collect()),
    }
}
