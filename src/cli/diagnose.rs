//! `inbetween diagnose`: names the known mistake that explains a student's samples.

mod film;

use std::fmt::Write as _;

use super::arguments::DiagnoseArguments;
use super::places::Places;
use super::{CliError, Common, output, reading, scene};
use crate::diagnosis::{
    self, Candidate, Diagnosis, LARGEST_SAMPLES_BYTES, Listing, Row, Samples, Sequence, samples_from_csv,
};
use crate::export::Animation;
use crate::files::{self, FileError};
use crate::interpolation::Interpolation;
use crate::storage::input_name;
use crate::text::counted;

/// The number of runners-up in the text output.
const RUNNERS_UP: usize = 3;

/// Prints the diagnosis, as sentences or as JSON, and draws the film that is asked for.
///
/// # Errors
/// [`CliError`]: the keyframes or the samples are bad, the film cannot be drawn or written.
pub fn run(arguments: &DiagnoseArguments, common: Common<'_>) -> Result<(), CliError> {
    let keyframes = arguments.keyframes.as_path();
    let places = Places::with_scene(common.scene).reads("KEYFRAMES", keyframes);
    let places = arguments.samples.iter().fold(places, |places, samples| places.reads("SAMPLES.csv", samples));
    arguments.film.iter().fold(places, |places, film| places.writes("--film", film)).check()?;
    let film = arguments.film.as_deref().map(|path| Ok::<_, CliError>((path, film::format_of(path)?))).transpose()?;
    let scene = &scene::load(common.scene)?;
    let file = reading::keyframes(keyframes, scene, common)?.file;
    let sequence = Sequence::new(&file.keyframes).map_err(|error| FileError::new(input_name(keyframes), error))?;
    let (list, in_file, ms_between_keyframes) = file.into_parts();
    let draw = |interpolation: Interpolation, rows: &[Row], name: &str| {
        let Some(film) = film else { return Ok(()) };
        let animation = Animation { keyframes: list.clone(), interpolation, ms_between_keyframes };
        film::write(film, scene, (keyframes, &animation), rows, name)
    };
    let Some(samples) = &arguments.samples else {
        let name = arguments.mistake.unwrap_or_default();
        let Some((interpolation, rows)) = diagnosis::played(&sequence, name, in_file) else { return Ok(()) };
        return draw(interpolation, &rows, name);
    };
    let sample_bytes = files::read(samples, LARGEST_SAMPLES_BYTES)?;
    let located = |error| FileError::new(input_name(samples), error);
    let samples = samples_from_csv(&sample_bytes, scene.rbt_count(), ms_between_keyframes).map_err(located)?;
    let diagnosis = diagnosis::diagnose(&sequence, &samples, Listing::All);
    let text = if arguments.json {
        to_json(&diagnosis)
    } else if common.is_quiet {
        format!("{}\n", verdict(&diagnosis))
    } else {
        sentences(&diagnosis, &sequence, &samples)
    };
    output::say(&text)?;
    let name = if diagnosis.is_explained() { &diagnosis.best().name } else { "none of the known mistakes" };
    draw(diagnosis.best().interpolation(), &samples.rows, name)
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
        "{{\"best\": \"{}\", \"explained\": {}, \"also\": [{}], \"residual\": {:?}, \"candidates\": [{}]}}\n",
        best.name,
        diagnosis.is_explained(),
        also.join(", "),
        best.residual,
        candidates.join(", ")
    )
}

/// The diagnosis in one sentence.
fn verdict(diagnosis: &Diagnosis) -> String {
    let best = diagnosis.best();
    let rows = counted(diagnosis.rows, "row");
    let (name, residual) = (&best.name, best.residual);
    if !diagnosis.is_explained() {
        return format!(
            "None of the known mistakes explains the samples. {name} is nearest, with a residual of {residual:.2e} over {rows}."
        );
    }
    let explains = if best.mistakes.len() == 1 { "explains" } else { "explain" };
    format!("{name} {explains} the samples, with a residual of {residual:.2e} over {rows}.")
}

/// The diagnosis as text: explanation, advice and runners-up.
fn sentences(diagnosis: &Diagnosis, sequence: &Sequence, samples: &Samples) -> String {
    let best = diagnosis.best();
    let mut text = format!("{}\n", verdict(diagnosis));
    if diagnosis.is_explained() {
        for mistake in &best.mistakes {
            let _ = writeln!(text, "{}", mistake.what);
            if !mistake.change.is_empty() {
                let _ = writeln!(text, "What to change: {}", mistake.change);
            }
        }
        if let Some(degrees) = best.frozen_below_degrees {
            let _ = writeln!(text, "Here turns of less than about {degrees:.2} degrees are left out.");
        }
    }
    if let Some(early) = diagnosis.ends_before {
        let end = sequence.last_key_time();
        let _ = writeln!(text, "The samples end {} before the end, at key time {}.", short(early), short(end - early));
    }
    let names = |candidates: &[&Candidate]| candidates.iter().map(|c| c.name.as_str()).collect::<Vec<_>>().join(", ");
    if diagnosis.is_explained() {
        let [too_few, same] = diagnosis.also_by_cause(sequence, samples);
        if !too_few.is_empty() {
            let _ = writeln!(text, "The samples are too few to tell it from: {}.", names(&too_few));
        }
        if !same.is_empty() {
            let _ = writeln!(text, "These keyframes cannot tell it from: {}.", names(&same));
        }
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

/// A key time with at most six decimals.
fn short(key_time: f64) -> String {
    let text = format!("{key_time:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
