//! `inbetween compare`: whether two images look the same.

use std::path::Path;

use super::arguments::CompareArguments;
use super::{CliError, output};
use crate::compare::{Comparison, compare};
use crate::render::Image;
use crate::storage;

/// The largest PNG that is read: 1 GiB.
pub const LARGEST_IMAGE_BYTES: u64 = 1 << 30;

/// Compares two images, writes their difference where asked to, and prints the result.
///
/// # Errors
/// [`CliError::Beyond`]; [`CliError::Trouble`] where an image cannot be read, they have different sizes, or the difference cannot be written.
pub fn run(arguments: &CompareArguments) -> Result<(), CliError> {
    let trouble = |sentence: String| CliError::Trouble { sentences: vec![sentence] };
    let first = read(&arguments.first).map_err(trouble)?;
    let second = read(&arguments.second).map_err(trouble)?;
    let found = compare(&first, &second).map_err(|error| {
        trouble(format!("{} and {}: {error}", arguments.first.display(), arguments.second.display()))
    })?;
    if let Some(path) = &arguments.output {
        let place = path.display();
        let png = found.difference().to_png()?;
        storage::write(path, &png).map_err(|error| trouble(format!("{place}: {error}")))?;
    }
    let line = if arguments.json { json(&found, arguments.tolerance) } else { sentence(&found, arguments.tolerance) };
    output::print(|output| writeln!(output, "{line}"))?;
    if found.is_within(arguments.tolerance) { Ok(()) } else { Err(CliError::Beyond) }
}

/// Reads a PNG.
///
/// # Errors
/// A sentence with the file's name.
pub fn read(path: &Path) -> Result<Image, String> {
    let place = path.display();
    let bytes = storage::read(path, LARGEST_IMAGE_BYTES).map_err(|error| format!("{place}: {error}"))?;
    Image::from_png(&bytes).map_err(|error| format!("{place}: {error}"))
}

/// The result as people read it.
pub fn sentence(found: &Comparison, tolerance: f32) -> String {
    let verdict = if found.is_within(tolerance) { "within" } else { "beyond" };
    let [score, mean, largest] = [found.score(), found.mean(), found.largest()];
    format!("score {score:.6}, {verdict} the tolerance {tolerance} (mean {mean:.6}, largest {largest:.6})")
}

fn json(found: &Comparison, tolerance: f32) -> String {
    let [score, mean, largest] = [found.score(), found.mean(), found.largest()];
    let is_within = found.is_within(tolerance);
    format!(
        "{{\"score\": {score:?}, \"mean\": {mean:?}, \"largest\": {largest:?}, \"tolerance\": {tolerance:?}, \"within\": {is_within}}}"
    )
}
