//! `inbetween diagnose`: which known mistake explains what a student's own program showed.

use std::fmt::Write as _;
use std::path::Path;

use super::arguments::DiagnoseArguments;
use super::{CliError, output, reading};
use crate::diagnosis::{self, Candidate, Diagnosis, LARGEST_SAMPLES_BYTES, Sequence, advice, samples_from_csv};
use crate::keyframe::{DEFAULT_MS_BETWEEN_KEYFRAMES, LARGEST_FILE_BYTES};
use crate::scene::SceneGraph;
use crate::storage;

/// How many runners-up are named to people.
const RUNNERS_UP: usize = 3;

/// Prints the diagnosis, as sentences or as JSON.
///
/// # Errors
/// [`CliError::BadInput`]: the keyframes or the samples are bad.
pub fn run(arguments: &DiagnoseArguments, scene: &SceneGraph) -> Result<(), CliError> {
    let bytes = read(&arguments.keyframes, LARGEST_FILE_BYTES)?;
    let samples = read(&arguments.samples, LARGEST_SAMPLES_BYTES)?;
    let place = arguments.keyframes.display();
    let diagnosis = diagnose(&bytes, &samples, scene).map_err(|problem| match problem {
        Problem::Keyframes(problems) => {
            CliError::BadInput { sentences: problems.iter().map(|problem| format!("{place}: {problem}")).collect() }
        }
        Problem::Samples(problem) => CliError::bad_input(arguments.samples.display(), problem),
    })?;
    let text = if arguments.json { to_json(&diagnosis) } else { sentences(&diagnosis) };
    output::print(|output| output.write_all(text.as_bytes()))
}

fn read(path: &Path, limit: u64) -> Result<Vec<u8>, CliError> {
    storage::read(path, limit).map_err(|error| CliError::bad_input(path.display(), error))
}

/// Which of the two files is bad, and why.
#[derive(Clone, Debug)]
pub enum Problem {
    /// The keyframes: a sentence a problem.
    Keyframes(Vec<String>),
    /// The samples.
    Samples(String),
}

/// Diagnoses samples of a keyframe file.
///
/// # Errors
/// [`Problem`]
pub fn diagnose(keyframes: &[u8], samples: &[u8], scene: &SceneGraph) -> Result<Diagnosis, Problem> {
    let file = reading::keyframes(keyframes, scene).map_err(Problem::Keyframes)?.file;
    let sequence = Sequence::new(&file.keyframes).map_err(|error| Problem::Keyframes(vec![error.to_string()]))?;
    let ms_between_keyframes = file.ms_between_keyframes.unwrap_or(DEFAULT_MS_BETWEEN_KEYFRAMES);
    let samples = samples_from_csv(samples, scene.rbt_count(), ms_between_keyframes)
        .map_err(|error| Problem::Samples(error.to_string()))?;
    Ok(diagnosis::diagnose(&sequence, &samples))
}

/// The diagnosis as one line of JSON.
pub fn to_json(diagnosis: &Diagnosis) -> String {
    let candidates: Vec<_> = diagnosis
        .candidates
        .iter()
        .map(|Candidate { name, residual }| format!("{{\"name\": \"{name}\", \"residual\": {residual:?}}}"))
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

/// The diagnosis for people: what explains the samples, what to change, and the runners-up.
pub fn sentences(diagnosis: &Diagnosis) -> String {
    let best = diagnosis.best();
    let rows = if diagnosis.rows == 1 { "1 row".to_owned() } else { format!("{} rows", diagnosis.rows) };
    let mut text = if diagnosis.is_explained() {
        format!("{} explains the samples, with a residual of {:.2e} over {rows}.\n", best.name, best.residual)
    } else {
        format!(
            "No known mistake explains the samples; {} is nearest, with a residual of {:.2e} over {rows}.\n",
            best.name, best.residual
        )
    };
    if let Some(advice) = advice(best.name).filter(|_| diagnosis.is_explained()) {
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
        .map(|Candidate { name, residual }| format!("{name} ({residual:.2e})"))
        .collect();
    if !runners_up.is_empty() {
        let _ = writeln!(text, "Runners-up: {}.", runners_up.join(", "));
    }
    text
}
