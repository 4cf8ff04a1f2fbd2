//! What is wrong with a line of a script, in a sentence.

use thiserror::Error;

use super::forms::names_sentence;
use crate::scene::Channel;

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
    #[error("{word:?} is not a command; the commands are {}", names_sentence())]
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
    /// A number is none, or out of its range.
    #[error("{word:?} is not a {what}; expected a {kind} from {low} to {high}")]
    Range {
        /// What stands there.
        word: String,
        /// What is wanted, as in "duration".
        what: &'static str,
        /// `number` or `whole number`.
        kind: &'static str,
        /// The least.
        low: f64,
        /// The most.
        high: f64,
    },
    /// A word is none of those that can stand there.
    #[error("{word:?} is not {what}; expected {expected}")]
    Choice {
        /// What stands there.
        word: String,
        /// What is wanted, as in "an easing".
        what: &'static str,
        /// What can stand there.
        expected: String,
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
    #[error("{word:?} has no keys; expected {}", Channel::names())]
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
    /// The list of commands has no such name.
    #[error("{name:?} is not in the list of commands")]
    Name {
        /// What stands there.
        name: String,
    },
    /// The scene has no such RBT node.
    #[error("node {path:?} is not in the scene {scene:?}")]
    Node {
        /// The path.
        path: String,
        /// The scene's name.
        scene: String,
    },
    /// The scene cannot be looked at from that node.
    #[error("node {path:?} is not an eye of the scene; expected {expected}")]
    Eye {
        /// The path.
        path: String,
        /// The eyes' paths.
        expected: String,
    },
}
