//! `inbetween compare`: compares two images.

use super::arguments::CompareArguments;
use super::{CliError, Ended, output};
use crate::files::{self, FileError};
use crate::flip::{Comparison, compare};

/// Compares two images, writes their difference where asked to, and prints the result.
///
/// # Errors
/// [`CliError`] with status 2: an image cannot be read, they have different sizes, or the difference cannot be written.
pub fn run(arguments: &CompareArguments) -> Result<Ended, CliError> {
    let trouble = |error: FileError| CliError::from(error).into_trouble();
    let (first, second) = (&arguments.first, &arguments.second);
    let [one, other] = [files::image(first).map_err(trouble)?, files::image(second).map_err(trouble)?];
    let found = compare(&one, &other).map_err(|error| {
        trouble(FileError::new(format_args!("{} and {}", first.display(), second.display()), error))
    })?;
    if let Some(path) = &arguments.output {
        files::write(path, &found.difference().to_png()?).map_err(trouble)?;
    }
    let tolerance = arguments.tolerance;
    let line = if arguments.json { json(&found, tolerance) } else { found.sentence(tolerance) };
    output::say(&format!("{line}\n"))?;
    Ok(if found.is_within(tolerance) { Ended::Well } else { Ended::Beyond })
}

fn json(found: &Comparison, tolerance: f32) -> String {
    let [score, mean, largest] = [found.score(), found.mean(), found.largest()];
    let is_within = found.is_within(tolerance);
    format!(
        "{{\"score\": {score:?}, \"mean\": {mean:?}, \"largest\": {largest:?}, \"tolerance\": {tolerance:?}, \"within\": {is_within}}}"
    )
}
