//! `inbetween compare`: compares images.

mod pairs;

use std::path::Path;

use serde_json::json;

use super::arguments::CompareArguments;
use super::each::{Done, Telling, each, tell};
use super::places::Places;
use super::targets::{make_folder, targets};
use super::{CliError, Common, Ended};
use crate::files::{self, FileError};
use crate::flip::{CompareError, Scores, check_sizes, compare};
use crate::storage::input_name;
use crate::words::texts;
use pairs::{Pair, pairs};

/// Compares pairs of images, writes their differences where asked to, and prints the results; quiet, only those that differ.
///
/// # Errors
/// [`CliError`] with status 2: an image cannot be read, two have different sizes, or a difference cannot be written.
pub fn run(arguments: &CompareArguments, common: Common<'_>) -> Result<Ended, CliError> {
    let output = arguments.output.as_deref();
    let pairs = pairs(&arguments.first, &arguments.others)?;
    let with_differences = match output {
        Some(output) => {
            let others: Vec<_> = pairs.iter().filter_map(Pair::other).collect();
            targets(&others, output, "png", pairs.iter().any(|pair| pair.is_of_folders))?
        }
        None => Vec::new(),
    };
    // All pairs of one image have it as their first.
    let places = pairs.iter().take(1).fold(Places::default(), |places, pair| places.reads("A.png", &pair.first));
    let places = pairs.iter().filter_map(Pair::other).fold(places, |places, other| places.reads("B.png", &other));
    with_differences.iter().fold(places, |places, target| places.writes("--output", target)).check()?;
    let mut targets = with_differences.into_iter();
    let jobs: Vec<_> = pairs
        .into_iter()
        .map(|pair| {
            let target = pair.second.as_ref().and_then(|_| targets.next());
            (pair, target)
        })
        .collect();
    let is_single = jobs.len() == 1;
    let named = |(pair, _): &(Pair, _)| pair.json();
    let outcomes = each(
        &jobs,
        common,
        |(pair, _)| pair.name(),
        named,
        |(pair, target), _| {
            let Some(second) = &pair.second else {
                let line = format!("{}\n", texts::compare_alone(pair.first.display(), pair.folder.display()));
                return Ok(Done::ended(Ended::Beyond, line, json!({"within": false})));
            };
            let (scores, striking, difference) = scores(&pair.first, second).map_err(CliError::into_trouble)?;
            if let (Some(target), Some(output)) = (target, output) {
                let written = difference().and_then(|png| {
                    make_folder(output, target)?;
                    Ok(files::write(target, &png)?)
                });
                written.map_err(CliError::into_trouble)?;
            }
            let is_within = scores.is_within(arguments.tolerance);
            let result = scores.sentence(arguments.tolerance);
            let lines = match (is_single, is_within && common.is_quiet) {
                (_, true) => String::new(),
                (true, _) => format!("{}\n", texts::flip_explained(result)),
                (false, _) => format!("{}: {result}\n", pair.name()),
            };
            let ended = if is_within { Ended::Well } else { Ended::Beyond };
            Ok(Done::ended(ended, lines, json(scores, striking, arguments.tolerance)))
        },
    )?;
    tell(outcomes, Telling { is_json: arguments.json, data: output }).map_err(CliError::into_trouble)
}

type Png<'a> = Box<dyn FnOnce() -> Result<Vec<u8>, CliError> + 'a>;

/// The scores of two images, the share of pixels that differ strikingly, and what makes the picture of their difference.
fn scores(first: &Path, second: &Path) -> Result<(Scores, f32, Png<'static>), CliError> {
    let incomparable = |error: CompareError| {
        let location = format!("{} and {}", input_name(first), input_name(second));
        FileError::new(location, error)
    };
    // What the heads of the files say is checked before either is decoded.
    let sizes = [files::image_size(first)?, files::image_size(second)?];
    if let [Some(one), Some(other)] = sizes {
        check_sizes(one, other).map_err(incomparable)?;
    }
    let [one, other] = [files::image(first)?, files::image(second)?];
    let found = compare(&one, &other).map_err(incomparable)?;
    Ok((found.scores(), found.striking(), Box::new(move || Ok(found.difference().to_png()?))))
}

fn json(scores: Scores, striking: f32, tolerance: f32) -> serde_json::Value {
    // The shortest number that names the value, not the digits of its double.
    let short = |number: f32| number.to_string().parse::<f64>().unwrap_or(f64::NAN);
    let Scores { score, mean, largest } = scores;
    json!({
        "score": short(score),
        "mean": short(mean),
        "largest": short(largest),
        "striking": short(striking),
        "tolerance": short(tolerance),
        "within": scores.is_within(tolerance),
    })
}
