//! `inbetween check`: checks keyframes.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::arguments::CheckArguments;
use super::each::{Done, Outcome, Telling, each, tell};
use super::places::Places;
use super::reading::Notes;
use super::{CliError, Common, Ended, output, reading, scene};
use crate::scene::SceneGraph;
use crate::storage::input_name;
use crate::text::counted;
use crate::text_layouts::Reading;
use crate::words::texts;

/// Checks the files: a line for each, or one for each problem, in the order of the files. Where any file is bad, all of the lines go to
/// standard error. A quiet check prints problems and a summary.
///
/// # Errors
/// [`CliError`]: a file is bad, which has been said then.
pub fn run(arguments: &CheckArguments, common: Common<'_>) -> Result<Ended, CliError> {
    let places = Places::with_scene(common.scene);
    arguments.files.iter().fold(places, |places, file| places.reads("FILE", file)).check()?;
    let scene = &scene::load(common.scene)?;
    let shown = |file: &PathBuf| input_name(file);
    let named = |file: &PathBuf| json!({"file": input_name(file)});
    let outcomes = each(&arguments.files, common, shown, named, |file, notes| verdict(file, scene, common, notes))?;
    if arguments.json {
        return tell(outcomes, Telling { is_json: true, data: None });
    }
    let bad = outcomes.iter().filter(|outcome| outcome.result.is_err()).count();
    let summary = if bad == 0 {
        texts::check_all_good(outcomes.len())
    } else {
        texts::check_some_bad(bad.to_string(), outcomes.len())
    };
    let mut text = lines(outcomes, common.is_quiet);
    if common.is_quiet {
        let _ = writeln!(text, "{summary}");
    }
    if bad == 0 {
        output::say(&text)?;
        return Ok(Ended::Well);
    }
    output::complain(text.trim_end());
    Ok(Ended::Beyond)
}

fn lines(outcomes: Vec<Outcome>, is_quiet: bool) -> String {
    let mut text = String::new();
    for Outcome { notes, result, .. } in outcomes {
        notes.say();
        match result {
            Ok(done) if !is_quiet => text.push_str(&done.lines),
            Ok(_) => {}
            Err(error) => text.extend(error.into_sentences().1.iter().map(|sentence| format!("{sentence}\n"))),
        }
    }
    text
}

fn verdict(file: &Path, scene: &SceneGraph, common: Common<'_>, notes: &mut Notes) -> Result<Done, CliError> {
    let Reading { file: content, report } = reading::noted_keyframes(file, scene, common, notes)?;
    let (keyframes, interpolation, ms) = content.into_parts();
    let (count, interpolation) = (keyframes.len(), interpolation.name());
    let fields = json!({
        "ok": true,
        "keyframes": count,
        "interpolation": interpolation,
        "ms_between_keyframes": ms,
        "text": report.map_or(Value::Null, |report| report.json()),
    });
    let keyframes = counted(count, "keyframe");
    Ok(Done::well(format!("{}: ok, {keyframes}, {interpolation}, {ms} ms\n", input_name(file)), fields))
}
