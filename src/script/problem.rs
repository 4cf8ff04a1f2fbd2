//! Problems of script lines, as messages.

use thiserror::Error;

use super::table::names;
use crate::editor::commands::ArgumentError;
use crate::words::{Message, texts};

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
    /// Not UTF-8.
    #[error("not UTF-8")]
    NotUtf8,
    /// The first word is not a command.
    #[error("{}", unknown(.word))]
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
    /// The words after the command have no meaning.
    #[error(transparent)]
    Argument(#[from] ArgumentError),
    /// The text of a scene is none.
    #[error("not a scene: {reason}")]
    Scene {
        /// Why.
        reason: String,
    },
    /// Not a time.
    #[error("{word:?} is not a time; expected as in 500ms or 2s, 0 to 1e6 seconds")]
    Time {
        /// The word as written.
        word: String,
    },
    /// No hotkey is bound to that.
    #[error("{word:?} is not a hotkey")]
    Hotkey {
        /// The word as written.
        word: String,
    },
    /// The list of commands has no such name or id.
    #[error("{name:?} is not in the list of commands")]
    Name {
        /// The word as written.
        name: String,
    },
}

/// How alike a word and a command are, from 0 to 1, from which on the command is suggested.
const ALIKE: f64 = 0.8;

fn unknown(word: &str) -> Message {
    let alike = names().map(|name| (strsim::jaro(word, name), name)).max_by(|a, b| a.0.total_cmp(&b.0));
    // Of one or two letters nothing can be told.
    let is_long = word.chars().count() > 2;
    let word = format!("{word:?}");
    match alike.filter(|(likeness, _)| is_long && *likeness >= ALIKE) {
        Some((_, name)) => texts::script_unknown_command_alike(word, name),
        None => texts::script_unknown_command(word),
    }
}
