//! Scripts in a folder of their own that is nowhere on the disk: what they read and write stays in memory.
//!
//! Only plain names are in that folder: a path that leads elsewhere is refused with a message. No picture is taken, and work is
//! bounded by counts, so that the outcome is the same on every machine.

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use serde_json::Value;

use crate::cli::arguments::DEFAULT_KEYFRAME_FILE;
use crate::cli::script::parse::{self, Action, Line};
use crate::cli::script::trace::line_json;
use crate::clock::AnimationClock;
use crate::editor::{Command, Editor, Effect};
use crate::keyframe::keyframes_to_json;
use crate::scene::SceneGraph;
use crate::words::texts;

/// The most lines of a script that is run while grading.
pub const MOST_LINES: usize = 2_000;
/// The longest that a script may wait, all in all.
const LONGEST_WAIT: Duration = Duration::from_hours(1);
/// The most keyframes at a time.
const MOST_KEYFRAMES: usize = 2_000;
/// The most bytes that a script may write, all in all.
const MOST_WRITTEN_BYTES: usize = 32 << 20;

/// Reads a script.
///
/// # Errors
/// The first line that makes no sense, or the bound that is hit.
pub fn parse(bytes: &[u8], scene: &SceneGraph) -> Result<Vec<Line>, String> {
    let lines =
        parse::parse(bytes, scene).map_err(|problems| problems.first().map(ToString::to_string).unwrap_or_default())?;
    if lines.len() > MOST_LINES {
        return Err(format!("{} commands, and at most {MOST_LINES} are run", lines.len()));
    }
    Ok(lines)
}

/// What a script left.
pub struct Ran {
    /// The trace, a JSON object for each command.
    pub trace: Vec<Value>,
    /// The keyframes, as a file.
    pub keyframes: Vec<u8>,
}

/// The keyframes that a script makes, as a file.
///
/// # Errors
/// [`run`]'s.
pub fn made_keyframes(script: &[u8], scene: &SceneGraph) -> Result<Vec<u8>, String> {
    Ok(run(script, scene, None)?.keyframes)
}

/// Runs a script with `keyframes` as the keyframe file, if there is one.
///
/// # Errors
/// A line that makes no sense, a path out of the folder, a bound that is hit.
pub fn run(script: &[u8], scene: &SceneGraph, keyframes: Option<&[u8]>) -> Result<Ran, String> {
    let lines = parse(script, scene)?;
    let mut folder = Folder { files: BTreeMap::new(), written: 0 };
    if let Some(bytes) = keyframes {
        folder.files.insert(DEFAULT_KEYFRAME_FILE.to_owned(), bytes.to_owned());
    }
    let mut editor = Editor::new(Arc::new(scene.clone()), PathBuf::from(DEFAULT_KEYFRAME_FILE));
    let mut clock = AnimationClock::new();
    let mut waited = Duration::ZERO;
    let mut trace = Vec::with_capacity(lines.len());
    for line in &lines {
        let place = |problem: String| format!("line {}: {problem}", line.number);
        let mut goes_on = true;
        let message = match &line.action {
            Action::Wait(duration) => {
                waited = waited.saturating_add(*duration);
                if waited > LONGEST_WAIT {
                    return Err(place(format!("it waits for more than {} s", LONGEST_WAIT.as_secs())));
                }
                let was_playing = editor.is_playing();
                editor.tick(clock.advance(*duration));
                let has_ended = was_playing && !editor.is_playing();
                if has_ended { editor.message_text() } else { String::new() }
            }
            Action::Apply(command) => {
                goes_on = apply(&mut editor, command, &mut clock, &mut folder).map_err(place)?;
                editor.message_text()
            }
        };
        if editor.document().keyframes.len() > MOST_KEYFRAMES {
            return Err(place(format!("more than {MOST_KEYFRAMES} keyframes")));
        }
        trace.push(serde_json::from_str(&line_json(line, &message, &editor)).map_err(|error| error.to_string())?);
        if !goes_on {
            break;
        }
    }
    let document = editor.document();
    let keyframes =
        keyframes_to_json(scene, &document.keyframes, document.interpolation, document.ms_between_keyframes);
    Ok(Ran { trace, keyframes: keyframes.into_bytes() })
}

/// Does a command; says whether the script goes on.
fn apply(
    editor: &mut Editor,
    command: &Command,
    clock: &mut AnimationClock,
    folder: &mut Folder,
) -> Result<bool, String> {
    let was_playing = editor.is_playing();
    let effects = editor.apply(command.clone()).unwrap_or_default();
    if editor.is_playing() && !was_playing {
        clock.restart();
    }
    let mut goes_on = true;
    for effect in effects {
        match effect {
            Effect::ReadKeyframes { path } => {
                let name = plain_name(&path)?;
                let bytes = folder.files.get(&name).cloned();
                let bytes = bytes.ok_or_else(|| texts::STORAGE_NOT_FOUND.into());
                // What is wrong with the file is the editor's message, and the script goes on.
                let _ = editor.keyframes_read(&path, bytes);
            }
            Effect::WriteKeyframes { path, text, .. } => {
                folder.write(plain_name(&path)?, text.to_string().into_bytes())?;
                let _ = editor.keyframes_written(&path, Ok(None));
            }
            Effect::Screenshot { path: Some(path) } => {
                plain_name(&path)?;
                let _ = editor.screenshot_taken(&path, Ok(()));
            }
            Effect::Quit => goes_on = false,
            _ => {}
        }
    }
    Ok(goes_on)
}

/// The files that a script sees.
struct Folder {
    files: BTreeMap<String, Vec<u8>>,
    written: usize,
}

impl Folder {
    fn write(&mut self, name: String, bytes: Vec<u8>) -> Result<(), String> {
        self.written += bytes.len();
        if self.written > MOST_WRITTEN_BYTES {
            return Err(format!("it writes more than {MOST_WRITTEN_BYTES} bytes"));
        }
        self.files.insert(name, bytes);
        Ok(())
    }
}

/// The name of a file in the script's own folder.
fn plain_name(path: &Path) -> Result<String, String> {
    let refused = || format!("{}: a script that is graded reads and writes only in its own folder", path.display());
    let mut parts = path.components().filter(|part| *part != Component::CurDir);
    match (parts.next(), parts.next()) {
        (Some(Component::Normal(name)), None) => name.to_str().map(str::to_owned).ok_or_else(refused),
        _ => Err(refused()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_plain_names_are_in_the_folder() {
        assert_eq!(plain_name(Path::new("a.png")), Ok("a.png".to_owned()));
        assert_eq!(plain_name(Path::new("./a.png")), Ok("a.png".to_owned()));
        for out in ["/etc/passwd", "../a.png", "a/../../b", "a/b.png", "", "..", "/"] {
            assert!(plain_name(Path::new(out)).is_err(), "{out}");
        }
    }
}
