//! `inbetween compare`: compares two images.

use super::arguments::CompareArguments;
use super::places::Places;
use super::{CliError, Ended, output};
use crate::files::{self, FileError};
use crate::flip::{CompareError, Scores, check_sizes, compare};
use crate::storage;
use crate::words::texts;

/// Compares two images, writes their difference where asked to, and prints the result.
///
/// # Errors
/// [`CliError`] with status 2: an image cannot be read, they have different sizes, or the difference cannot be written.
pub fn run(arguments: &CompareArguments) -> Result<Ended, CliError> {
    let trouble = |error: FileError| CliError::from(error).into_trouble();
    let (first, second) = (&arguments.first, &arguments.second);
    let places = Places::default().reads("A.png", first).reads("B.png", second);
    arguments.output.iter().fold(places, |places, output| places.writes("--output", output)).check()?;
    let incomparable = |error: CompareError| {
        let location = format!("{} and {}", storage::input_name(first), storage::input_name(second));
        trouble(FileError::new(location, error))
    };
    // What the heads of the files say is checked before either is decoded.
    let sizes = [files::image_size(first).map_err(trouble)?, files::image_size(second).map_err(trouble)?];
    if let [Some(one), Some(other)] = sizes {
        check_sizes(one, other).map_err(incomparable)?;
    }
    let [one, other] = [files::image(first).map_err(trouble)?, files::image(second).map_err(trouble)?];
    let found = compare(&one, &other).map_err(incomparable)?;
    let scores = found.scores();
    if let Some(path) = &arguments.output {
        files::write(path, &found.difference().to_png()?).map_err(trouble)?;
    }
    let tolerance = arguments.tolerance;
    let line = if arguments.json {
        json(scores, tolerance)
    } else {
        texts::flip_explained(scores.sentence(tolerance)).to_string()
    };
    output::say_beside(arguments.output.as_deref(), &format!("{line}\n"))?;
    Ok(if scores.is_within(tolerance) { Ended::Well } else { Ended::Beyond })
}

fn json(scores: Scores, tolerance: f32) -> String {
    let Scores { score, mean, largest } = scores;
    let is_within = scores.is_within(tolerance);
    format!(
        "{{\"score\": {score:?}, \"mean\": {mean:?}, \"largest\": {largest:?}, \"tolerance\": {tolerance:?}, \"within\": {is_within}}}"
    )
}
