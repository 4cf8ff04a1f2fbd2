//! The script's text: bytes to lines that can be run.

mod scene_lines;

use std::path::PathBuf;
use std::time::Duration;

use glam::Vec3;
use thiserror::Error;

use crate::editor::keymap::{Binding, binding_for, bindings, press_from_word};
use crate::editor::{Command, Edit, FileCommand, ViewCommand};
use crate::scene::SceneGraph;

/// A line that does something.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Its number, from 1.
    pub number: usize,
    /// Its text without comment and outer blanks.
    pub text: String,
    /// What it does.
    pub action: Action,
}

/// What a line does.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Asks this of the editor.
    Apply(Command),
    /// Lets so much time pass for the animation clock.
    Wait(Duration),
}

impl Line {
    /// Whether it needs a renderer.
    #[must_use]
    pub fn takes_screenshot(&self) -> bool {
        matches!(self.action, Action::Apply(Command::File(FileCommand::Screenshot(_))))
    }
}

/// A line that cannot be understood.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("line {number}: {problem}")]
pub struct ScriptError {
    /// Its number, from 1.
    pub number: usize,
    /// What is wrong with it.
    pub problem: LineProblem,
}

/// What is wrong with a line.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum LineProblem {
    /// The bytes are no text.
    #[error("not UTF-8")]
    NotUtf8,
    /// The first word is no command.
    #[error(
        "{word:?} is not a command; the commands are select, rotate, translate, key, wait, undo, redo, screenshot, \
         put-control, remove-control, rename-control, add-key, set-key, move-key, delete-key, seconds and save-scene"
    )]
    Unknown {
        /// The word.
        word: String,
    },
    /// The words after the command are not those that it takes.
    #[error("expected `{usage}`, found `{found}`")]
    Usage {
        /// How the command is written.
        usage: &'static str,
        /// What the line says.
        found: String,
    },
    /// A number is none, or not finite.
    #[error("{word:?} is not a finite number")]
    Number {
        /// What stands there.
        word: String,
    },
    /// The axis is none of the three.
    #[error("{word:?} is not an axis; expected x, y or z")]
    Axis {
        /// What stands there.
        word: String,
    },
    /// The time is none.
    #[error("{word:?} is not a time; expected as in 500ms or 2s, at least 0")]
    Time {
        /// What stands there.
        word: String,
    },
    /// Nothing of that name has keys at their own times.
    #[error("{word:?} has no keys; expected translation, rotation, scale or colour")]
    Channel {
        /// What stands there.
        word: String,
    },
    /// A key cannot hold that.
    #[error("{word:?} is not a {channel}; expected {expected}")]
    Value {
        /// What stands there.
        word: String,
        /// What it should be.
        channel: &'static str,
        /// How that is written.
        expected: &'static str,
    },
    /// No hotkey is bound to that.
    #[error("{word:?} is not a hotkey")]
    Hotkey {
        /// What stands there.
        word: String,
    },
    /// The scene has no such RBT node.
    #[error("node {path:?} is not in the scene {scene:?}")]
    Node {
        /// The path.
        path: String,
        /// The scene's name.
        scene: String,
    },
}

/// Reads a whole script for a scene. A byte order mark is passed over; blank lines and comments give nothing.
///
/// # Errors
/// Every line that cannot be understood, in order; never empty.
pub fn parse(bytes: &[u8], scene: &SceneGraph) -> Result<Vec<Line>, Vec<ScriptError>> {
    let mut parser = Parser { scene: scene.clone(), bindings: bindings() };
    let mut lines = Vec::new();
    let mut problems = Vec::new();
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    for (number, bytes) in (1..).zip(bytes.split(|&byte| byte == b'\n')) {
        match std::str::from_utf8(bytes).map_err(|_| LineProblem::NotUtf8).and_then(|text| parser.line(text)) {
            Ok(None) => {}
            Ok(Some((text, action))) => lines.push(Line { number, text: text.to_owned(), action }),
            Err(problem) => problems.push(ScriptError { number, problem }),
        }
    }
    if problems.is_empty() { Ok(lines) } else { Err(problems) }
}

struct Parser {
    /// The scene as it is after the lines so far.
    scene: SceneGraph,
    bindings: Vec<Binding>,
}

impl Parser {
    /// The line's text without its comment, and what it does; nothing where nothing is left.
    fn line<'t>(&mut self, line: &'t str) -> Result<Option<(&'t str, Action)>, LineProblem> {
        if let Some(text) = self.select_of_a_path_with_number_signs(line) {
            return self.action(text).map(|action| Some((text, action)));
        }
        let text = line.split('#').next().unwrap_or_default().trim();
        if text.is_empty() {
            return Ok(None);
        }
        self.action(text).map(|action| Some((text, action)))
    }

    /// A path may hold what elsewhere starts a comment: the longest reading that names a node counts.
    fn select_of_a_path_with_number_signs<'t>(&self, line: &'t str) -> Option<&'t str> {
        let line = line.trim();
        let ends = line.match_indices('#').map(|(end, _)| end).skip(1).chain([line.len()]);
        let readings: Vec<&str> = ends.map(|end| line[..end].trim_end()).filter(|text| text.contains('#')).collect();
        readings.into_iter().rev().find(|text| {
            text.strip_prefix("select").is_some_and(|path| {
                path.starts_with(char::is_whitespace) && self.scene.find_rbt(path.trim_start()).is_some()
            })
        })
    }

    fn action(&mut self, text: &str) -> Result<Action, LineProblem> {
        let (name, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
        let rest = rest.trim_start();
        if let Some(action) = self.scene_line(name, rest, text) {
            return action;
        }
        let words: Vec<&str> = rest.split_whitespace().collect();
        let usage = |usage| LineProblem::Usage { usage, found: text.to_owned() };
        Ok(Action::Apply(match (name, words.as_slice()) {
            ("select", ["none"]) => Command::View(ViewCommand::Choose(None)),
            ("select", [_, ..]) => {
                Command::View(ViewCommand::Choose(Some(self.scene.find_rbt(rest).ok_or_else(|| {
                    LineProblem::Node { path: rest.to_owned(), scene: self.scene.name().to_owned() }
                })?)))
            }
            ("select", []) => return Err(usage("select PATH")),
            ("rotate", &[axis, degrees]) => {
                Command::Edit(Edit::RotateChosen { axis_in_node: self::axis(axis)?, radians: radians(degrees)? })
            }
            ("rotate", _) => return Err(usage("rotate AXIS DEGREES")),
            ("translate", &[x, y, z]) => {
                Command::Edit(Edit::TranslateChosen(Vec3::new(number(x)?, number(y)?, number(z)?)))
            }
            ("translate", _) => return Err(usage("translate X Y Z")),
            ("key", &[word]) => self.hotkey(word)?,
            ("key", _) => return Err(usage("key K")),
            ("wait", &[word]) => return duration(word).map(Action::Wait),
            ("wait", _) => return Err(usage("wait TIME")),
            ("undo", []) => Command::Undo,
            ("undo", _) => return Err(usage("undo")),
            ("redo", []) => Command::Redo,
            ("redo", _) => return Err(usage("redo")),
            ("screenshot", [_, ..]) => Command::File(FileCommand::Screenshot(Some(PathBuf::from(rest)))),
            ("screenshot", []) => return Err(usage("screenshot PATH")),
            _ => return Err(LineProblem::Unknown { word: name.to_owned() }),
        }))
    }

    fn hotkey(&self, word: &str) -> Result<Command, LineProblem> {
        press_from_word(word)
            .and_then(|press| binding_for(&self.bindings, press))
            .map(|binding| binding.command.clone())
            .ok_or_else(|| LineProblem::Hotkey { word: word.to_owned() })
    }
}

fn axis(word: &str) -> Result<Vec3, LineProblem> {
    match word {
        "x" => Ok(Vec3::X),
        "y" => Ok(Vec3::Y),
        "z" => Ok(Vec3::Z),
        _ => Err(LineProblem::Axis { word: word.to_owned() }),
    }
}

fn number(word: &str) -> Result<f32, LineProblem> {
    word.parse()
        .ok()
        .filter(|number: &f32| number.is_finite())
        .ok_or_else(|| LineProblem::Number { word: word.to_owned() })
}

/// An angle in degrees as radians; whole turns are left out before anything is rounded.
fn radians(word: &str) -> Result<f32, LineProblem> {
    let degrees: Option<f64> = word.parse().ok().filter(|degrees: &f64| degrees.is_finite());
    let degrees = degrees.ok_or_else(|| LineProblem::Number { word: word.to_owned() })?;
    #[expect(clippy::cast_possible_truncation, reason = "rotations are held in f32")]
    let radians = (degrees % 360.0).to_radians() as f32;
    Ok(radians)
}

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
        .ok_or_else(|| LineProblem::Time { word: word.to_owned() })
}

#[cfg(test)]
mod tests;
