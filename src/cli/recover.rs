//! `inbetween recover`: what was not saved when a program ended, out of its journal.

use std::path::{Path, PathBuf};

use serde_json::json;

use super::arguments::RecoverArguments;
use super::places::Places;
use super::{CliError, Common, misuse, output};
use crate::editor::Editor;
use crate::files;
use crate::journal::{self, Left};
use crate::keyframe::keyframes_to_json;
use crate::scene::scene_to_json;
use crate::storage;
use crate::words::texts;

/// Lists journals, or writes what one holds to a keyframe file.
///
/// # Errors
/// [`CliError`]: nothing is to be recovered, a journal that is in use or none, a file that cannot be written.
pub fn run(arguments: &RecoverArguments, common: Common<'_>) -> Result<(), CliError> {
    if arguments.list {
        return list(&all(), arguments.json);
    }
    if arguments.journal.as_deref().is_some_and(storage::is_standard) {
        return Err(misuse(&texts::places_needs_a_file("JOURNAL").to_string()));
    }
    let places = arguments.journal.iter().fold(Places::default(), |places, journal| places.reads("JOURNAL", journal));
    arguments.output.iter().fold(places, |places, output| places.writes("--output", output)).check()?;
    let left = match &arguments.journal {
        Some(path) => named(path)?,
        None => all().into_iter().next().ok_or_else(|| CliError::bad_input("recover", "nothing is left to recover"))?,
    };
    let location = left.log.path().display().to_string();
    let (editor, played, _) = journal::recover(&left.log).map_err(|error| CliError::bad_input(&location, error))?;
    let target = arguments.output.clone().unwrap_or_else(|| free_path(&left.survey.keyframes));
    write(&editor, &target)?;
    if let Some((number, problem)) = played.damage {
        output::complain(&format!("{location}: line {number}: {problem}; what comes after it is lost"));
    } else if played.is_cut {
        output::complain(&format!("{location}: its last line is cut off, and is lost"));
    }
    if played.passed_over > 0 {
        output::complain(&format!("{location}: passed over {}", lines(played.passed_over)));
    }
    left.take_over();
    let keyframes = editor.document().keyframes.len();
    let name = storage::output_name(&target);
    let said = if arguments.json {
        format!("{}\n", json!({"output": name, "keyframes": keyframes, "lines": played.lines, "journal": location}))
    } else {
        format!("{name}: {keyframes} keyframes out of {}\n", lines(played.lines))
    };
    if common.is_quiet && !arguments.json { Ok(()) } else { output::say_beside(Some(&target), &said) }
}

fn lines(count: usize) -> String {
    if count == 1 { "1 line".to_owned() } else { format!("{count} lines") }
}

fn all() -> Vec<Left> {
    storage::state_folder().map(|folder| journal::left(&folder)).unwrap_or_default()
}

fn named(path: &Path) -> Result<Left, CliError> {
    let bytes = files::read(path, journal::LARGEST_READ_BYTES)?;
    if !journal::is_journal(&bytes) {
        return Err(CliError::bad_input(path.display(), "it is no journal"));
    }
    Left::open(path).ok_or_else(|| CliError::bad_input(path.display(), storage::StorageError::InUse))
}

fn list(all: &[Left], is_json: bool) -> Result<(), CliError> {
    output::print(|out| {
        for left in all {
            let (survey, path) = (&left.survey, left.log.path().display());
            if is_json {
                let object = json!({
                    "journal": path.to_string(),
                    "keyframes": survey.keyframes.display().to_string(),
                    "commands": survey.commands,
                    "begun": survey.began,
                });
                writeln!(out, "{object}")?;
                continue;
            }
            let minutes = storage::epoch_seconds().saturating_sub(survey.began) / 60;
            writeln!(
                out,
                "{path}: {}, {} commands, begun {minutes} min ago",
                survey.keyframes.display(),
                survey.commands
            )?;
        }
        Ok(())
    })
}

/// `walk.recovered.json` beside `walk.json`, or the first free name after that.
fn free_path(keyframes: &Path) -> PathBuf {
    let stem = keyframes.file_stem().unwrap_or_default().to_string_lossy();
    let named = |more: &str| keyframes.with_file_name(format!("{stem}.recovered{more}.json"));
    let counted = (2_u32..).map(|count| named(&count.to_string()));
    std::iter::once(named("")).chain(counted).find(|path| !storage::exists(path)).expect("the numbers do not end")
}

/// Writes the keyframes, and beside them the scene where that was not saved.
fn write(editor: &Editor, target: &Path) -> Result<(), CliError> {
    let document = editor.document();
    let (interpolation, ms) = (document.interpolation, document.ms_between_keyframes);
    let text = keyframes_to_json(editor.scene(), &document.keyframes, interpolation, ms);
    files::write(target, text.as_bytes())?;
    // Standard output takes one of the two.
    if editor.has_unsaved_scene() && !storage::is_standard(target) {
        let scene = target.with_extension("scene.json");
        files::write(&scene, scene_to_json(editor.scene()).as_bytes())?;
    }
    Ok(())
}
