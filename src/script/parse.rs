//! The script's text: bytes to lines that can be run.

use std::borrow::Cow;
use std::time::Duration;

use super::problem::{LineProblem, ScriptError};
use super::restore::{self, Restore};
use super::table::OWN_LINES;
use crate::editor::commands::{self, ArgumentError, Arguments, Ending, quoted_prefix, split_option, tokens};
use crate::editor::gizmo::DragKey;
use crate::editor::keymap::{KeyPress, binding_for, bindings, press_from_word};
use crate::editor::{Command, Edit, FileCommand, SceneEdit};
use crate::scene::SceneGraph;
use crate::words::Message;

/// A line that does something.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Its number, from 1.
    pub number: usize,
    /// Its text without comment and outer blanks.
    pub text: String,
    /// What it does.
    pub action: Action,
    /// The key that it presses, which belongs to a turn or move that a key has begun, if one is on.
    pub key: Option<KeyPress>,
    /// What to say if that is done and nothing else is said.
    pub note: Option<Message>,
}

/// The action of a line.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Applies a command.
    Apply(Command),
    /// Advances the animation clock by a time.
    Wait(Duration),
    /// Lets so many ticks of the animation clock pass.
    Ticks(u64),
    /// Restores what a journal says.
    Restore(Restore),
}

impl Line {
    /// Whether it needs a renderer.
    #[must_use]
    pub fn takes_screenshot(&self) -> bool {
        matches!(self.action, Action::Apply(Command::File(FileCommand::Screenshot { .. })))
    }
}

/// Reads a whole script for a scene. A byte order mark is skipped; blank lines and comments produce no `Line`.
///
/// # Errors
/// One error for each invalid line, in order. `Err` is never empty.
pub fn parse(bytes: &[u8], scene: &SceneGraph) -> Result<Vec<Line>, Vec<ScriptError>> {
    let mut parser = Parser { scene: Cow::Borrowed(scene) };
    let mut lines = Vec::new();
    let mut problems = Vec::new();
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    for (number, bytes) in (1..).zip(bytes.split(|&byte| byte == b'\n')) {
        match std::str::from_utf8(bytes).map_err(|_| LineProblem::NotUtf8).and_then(|text| parser.line(text)) {
            Ok(None) => {}
            Ok(Some(read)) => lines.push(read.numbered(number)),
            Err(problem) => problems.push(ScriptError { number, problem }),
        }
    }
    if problems.is_empty() { Ok(lines) } else { Err(problems) }
}

/// Reads one line for a scene as it is before it; nothing where only blanks and a comment stand there.
///
/// # Errors
/// Why it cannot be understood.
pub fn parse_line(number: usize, bytes: &[u8], scene: &SceneGraph) -> Result<Option<Line>, ScriptError> {
    let mut parser = Parser { scene: Cow::Borrowed(scene) };
    let text = std::str::from_utf8(bytes).map_err(|_| LineProblem::NotUtf8);
    match text.and_then(|text| parser.line(text)) {
        Ok(read) => Ok(read.map(|read| read.numbered(number))),
        Err(problem) => Err(ScriptError { number, problem }),
    }
}

/// What a line says.
struct Read<'t> {
    /// Its text without its comment.
    text: &'t str,
    action: Action,
    key: Option<KeyPress>,
    note: Option<Message>,
}

impl Read<'_> {
    fn numbered(self, number: usize) -> Line {
        Line { number, text: self.text.to_owned(), action: self.action, key: self.key, note: self.note }
    }
}

/// The state of the parser.
struct Parser<'s> {
    /// The scene as it is after the lines so far.
    scene: Cow<'s, SceneGraph>,
}

impl Parser<'_> {
    /// What a line says; `None` for a blank one.
    fn line<'t>(&mut self, line: &'t str) -> Result<Option<Read<'t>>, LineProblem> {
        let text = self.text_if_hash_allowed(line.trim());
        let text = text.unwrap_or_else(|| line.split('#').next().unwrap_or_default().trim());
        if text.is_empty() {
            return Ok(None);
        }
        let action = self.action(text)?;
        let note = self.note(text);
        let key = name_and_rest(text);
        let key = if key.0 == "key" { press_from_word(key.1) } else { None };
        self.track_scene_edit(&action);
        Ok(Some(Read { text, action, key, note }))
    }

    /// The text without its comment, for lines whose arguments may contain `#`. `None` if the first `#` starts the comment.
    fn text_if_hash_allowed<'t>(&self, line: &'t str) -> Option<&'t str> {
        let (name, _) = name_and_rest(line);
        if restore::is_restore(name) {
            return Some(&line[..restore::end(line)]);
        }
        let form = line_of(name)?;
        match form.ending {
            Ending::Plain => None,
            Ending::NodePath => self.longest_path(form, line),
            Ending::Name => text_to_end_of_quotes(line, line.find('"')?),
            Ending::FilePath(option) => {
                let rest = name_and_rest(line).1;
                text_to_end_of_quotes(line, line.len() - split_option(rest, option).1.len())
            }
            Ending::QuotedWords => Some(&line[..tokens(line).1]),
        }
    }

    /// A node path may contain `#`: take the longest reading that names a node.
    fn longest_path<'t>(&self, form: &commands::Line, line: &'t str) -> Option<&'t str> {
        // The first `#` cannot end a text that contains one.
        let ends = line.match_indices('#').map(|(end, _)| end).skip(1).chain([line.len()]);
        let readings: Vec<&str> = ends.map(|end| line[..end].trim_end()).filter(|text| text.contains('#')).collect();
        readings.into_iter().rev().find(|text| {
            let (_, rest) = name_and_rest(text);
            matches!(self.read(form, rest, false), Ok(Some(_)))
        })
    }

    fn note(&self, text: &str) -> Option<Message> {
        let (name, rest) = name_and_rest(text);
        let words: Vec<&str> = rest.split_whitespace().collect();
        line_of(name)?.note(&Arguments { scene: &self.scene, text: rest, words: &words, allows_out_of_range: false })
    }

    fn read(
        &self,
        form: &commands::Line,
        rest: &str,
        allows_out_of_range: bool,
    ) -> Result<Option<Command>, ArgumentError> {
        let words: Vec<&str> = rest.split_whitespace().collect();
        form.read(&Arguments { scene: &self.scene, text: rest, words: &words, allows_out_of_range })
    }

    fn action(&self, text: &str) -> Result<Action, LineProblem> {
        let (name, rest) = name_and_rest(text);
        let own = OWN_LINES.iter().find(|(own, ..)| *own == name);
        let (usage, action) = match (own, rest) {
            (Some((_, usage, _)), "") if *usage != name => (*usage, None),
            (Some((_, usage, _)), _) => (*usage, self.own_action(text, name, rest)?),
            (None, _) => return self.command(text, false).map(Action::Apply),
        };
        action.ok_or_else(|| LineProblem::Usage { usage, found: text.to_owned() })
    }

    fn own_action(&self, text: &str, name: &str, rest: &str) -> Result<Option<Action>, LineProblem> {
        let is_one_word = !rest.contains(char::is_whitespace);
        match name {
            "wait" => is_one_word.then(|| wait(rest)).transpose(),
            name if restore::is_restore(name) => Ok(restore::read(text)?.map(Action::Restore)),
            "key" => is_one_word.then(|| hotkey(rest).map(Action::Apply)).transpose(),
            "clamped" => self.command(rest, true).map(|command| Some(Action::Apply(command))),
            "do" => by_name(rest).map(|command| Some(Action::Apply(command))),
            _ => Ok(None),
        }
    }

    /// The command of a line that stands in the table of commands.
    fn command(&self, text: &str, allows_out_of_range: bool) -> Result<Command, LineProblem> {
        let (name, rest) = name_and_rest(text);
        let form = line_of(name).ok_or_else(|| LineProblem::Unknown { word: name.to_owned() })?;
        let command = self.read(form, rest, allows_out_of_range)?;
        command.ok_or_else(|| LineProblem::Usage { usage: form.usage, found: text.to_owned() })
    }

    /// Applies an action to the parser's copy of the scene, so that later lines may name nodes it creates. A refused
    /// edit is reported when the line runs.
    fn track_scene_edit(&mut self, action: &Action) {
        match action {
            Action::Restore(Restore::Scene { scene, .. }) => self.scene = Cow::Owned(scene.as_ref().clone()),
            Action::Restore(Restore::Snapshot(snapshot) | Restore::Document(snapshot)) => {
                self.scene = Cow::Owned(snapshot.scene.as_ref().clone());
            }
            _ => {}
        }
        let Action::Apply(Command::Edit(Edit::Scene(edit))) = action else { return };
        let changed = match edit {
            SceneEdit::PutControlAbove(path) => {
                self.scene.find(path).and_then(|id| Some(self.scene.with_control_above(id).ok()?.0))
            }
            SceneEdit::RemoveControl(path) => self.scene.find(path).and_then(|id| self.scene.without_control(id).ok()),
            SceneEdit::RenameControl(path, name) => {
                self.scene.find(path).and_then(|id| self.scene.with_control_renamed(id, name).ok())
            }
            _ => None,
        };
        if let Some(scene) = changed {
            self.scene = Cow::Owned(scene);
        }
    }
}

/// The first word of a text, and what stands after it without blanks before it.
fn name_and_rest(text: &str) -> (&str, &str) {
    let (name, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    (name, rest.trim_start())
}

/// The line of the table of commands with this first word.
fn line_of(name: &str) -> Option<&'static commands::Line> {
    commands::lines().find(|line| line.name == name)
}

/// The command of a default hotkey, or else of a key that means something in a turn or move that a key has begun.
fn hotkey(word: &str) -> Result<Command, LineProblem> {
    let table = bindings();
    let press = press_from_word(word);
    let bound = press.and_then(|press| binding_for(&table, press)).map(|binding| binding.command.clone());
    let in_drag = || press.and_then(DragKey::of).map(DragKey::command);
    bound.or_else(in_drag).ok_or_else(|| LineProblem::Hotkey { word: word.to_owned() })
}

/// The command of an id or of an English name, in any case.
fn by_name(name: &str) -> Result<Command, LineProblem> {
    let is_meant = |own: &str| own.eq_ignore_ascii_case(name);
    let mut bindings = commands::rows().iter().flat_map(|row| &row.bindings);
    let binding = bindings.find(|binding| is_meant(binding.id) || is_meant(binding.title().english()));
    binding.map(|binding| binding.command.clone()).ok_or_else(|| LineProblem::Name { name: name.to_owned() })
}

/// What a `wait` lets pass.
fn wait(word: &str) -> Result<Action, LineProblem> {
    match word.strip_suffix('t').map(str::parse) {
        Some(Ok(ticks)) => Ok(Action::Ticks(ticks)),
        _ => duration(word).map(Action::Wait),
    }
}

/// The text up to the end of the quoted string that starts at byte `at`, if only a comment follows.
fn text_to_end_of_quotes(line: &str, at: usize) -> Option<&str> {
    let (length, _) = quoted_prefix(&line[at..])?;
    let (text, rest) = line.split_at(at + length);
    let rest = rest.trim_start();
    (rest.is_empty() || rest.starts_with('#')).then_some(text)
}

/// The longest time that one line waits: as much as timed keys have.
const LONGEST_WAIT: Duration = Duration::from_secs(1_000_000);

/// A time in milliseconds or seconds, to the nanosecond.
fn duration(word: &str) -> Result<Duration, LineProblem> {
    let (digits, per_second) = match word.strip_suffix("ms") {
        Some(digits) => (digits, 1000.0),
        None => (word.strip_suffix('s').unwrap_or_default(), 1.0),
    };
    digits
        .parse::<f64>()
        .ok()
        .and_then(|count| Duration::try_from_secs_f64(count / per_second).ok())
        .filter(|duration| *duration <= LONGEST_WAIT)
        .ok_or_else(|| LineProblem::Time { word: word.to_owned() })
}

#[cfg(test)]
mod tests;
