//! `inbetween diagnose`: names the known mistake that explains a student's samples.

use std::fmt::Write as _;
use std::path::Path;

use super::arguments::DiagnoseArguments;
use super::places::Places;
use super::{CliError, output, scene};
use crate::diagnosis::{self, Candidate, Diagnosis, LARGEST_SAMPLES_BYTES, Sequence, samples_from_csv};
use crate::files::{self, FileError};
use crate::keyframe::{DEFAULT_MS_BETWEEN_KEYFRAMES, LARGEST_FILE_BYTES};
use crate::storage::input_name;
use crate::text::counted;
use crate::text_layouts::read_keyframes;

/// The number of runners-up in the text output.
const RUNNERS_UP: usize = 3;

/// Prints the diagnosis, as sentences or as JSON.
///
/// # Errors
/// [`CliError`]: the keyframes or the samples are bad.
pub fn run(arguments: &DiagnoseArguments, scene: Option<&Path>) -> Result<(), CliError> {
    let (keyframes, samples) = (&arguments.keyframes, &arguments.samples);
    Places::with_scene(scene).reads("KEYFRAMES", keyframes).reads("SAMPLES.csv", samples).check()?;
    let scene = &scene::load(scene)?;
    let keyframe_bytes = files::read(keyframes, LARGEST_FILE_BYTES)?;
    let sample_bytes = files::read(samples, LARGEST_SAMPLES_BYTES)?;
    let file = read_keyframes(&keyframe_bytes, scene)
        .map_err(|problems| FileError::all(input_name(keyframes), problems))?
        .file;
    let sequence = Sequence::new(&file.keyframes).map_err(|error| FileError::new(input_name(keyframes), error))?;
    let ms_between_keyframes = file.ms_between_keyframes.unwrap_or(DEFAULT_MS_BETWEEN_KEYFRAMES);
    let located = |error| FileError::new(input_name(samples), error);
    let samples = samples_from_csv(&sample_bytes, scene.rbt_count(), ms_between_keyframes).map_err(located)?;
    let diagnosis = diagnosis::diagnose(&sequence, &samples);
    let text = if arguments.json { to_json(&diagnosis) } else { sentences(&diagnosis) };
    output::say(&text)
}

/// The diagnosis as one line of JSON.
fn to_json(diagnosis: &Diagnosis) -> String {
    let candidates: Vec<_> = diagnosis
        .candidates
        .iter()
        .map(|Candidate { name, residual, .. }| format!("{{\"name\": \"{name}\", \"residual\": {residual:?}}}"))
        .collect();
    let also: Vec<_> = diagnosis.also().iter().map(|candidate| format!("\"{}\"", candidate.name)).collect();
    let best = diagnosis.best();
    format!(
        "{{\"best\": \"{}\", \"also\": [{}], \"residual\": {:?}, \"candidates\": [{}]}}\n",
        best.name,
        also.join(", "),
        best.residual,
        candidates.join(", ")
    )
}

/// The diagnosis as text: explanation, advice and runners-up.
fn sentences(diagnosis: &Diagnosis) -> String {
    let best = diagnosis.best();
    let rows = counted(diagnosis.rows, "row");
    let mut text = if diagnosis.is_explained() {
        format!("{} explains the samples, with a residual of {:.2e} over {rows}.\n", best.name, best.residual)
    } else {
        format!(
            "No known mistake explains the samples; {} is nearest, with a residual of {:.2e} over {rows}.\n",
            best.name, best.residual
        )
    };
    if diagnosis.is_explained() {
        let advice = best.advice();
        let _ = writeln!(text, "{}", advice.what);
        if !advice.change.is_empty() {
            let _ = writeln!(text, "What to change: {}", advice.change);
        }
    }
    let names = |candidates: &[Candidate]| candidates.iter().map(|c| c.name).collect::<Vec<_>>().join(", ");
    if !diagnosis.also().is_empty() {
        let _ = writeln!(text, "These keyframes cannot tell it from: {}.", names(diagnosis.also()));
    }
    let runners_up: Vec<String> = diagnosis
        .runners_up()
        .iter()
        .take(RUNNERS_UP)
        .map(|Candidate { name, residual, .. }| format!("{name} ({residual:.2e})"))
        .collect();
    if !runners_up.is_empty() {
        let _ = writeln!(text, "Runners-up: {}.", runners_up.join(", "));
    }
    text
}
