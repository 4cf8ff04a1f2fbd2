//! Script lines of commands: parsing and printing.

use std::sync::Arc;

use thiserror::Error;

use super::values::{read_quoted, word_and_rest};
use crate::editor::Command;
use crate::pose::RbtIndex;
use crate::rotation_rules::beyond_half_turn;
use crate::scene::SceneGraph;
use crate::words::Message;

/// The arguments of a script line, and the scene for node paths.
#[derive(Clone, Copy)]
pub struct Arguments<'a> {
    /// The scene as it is before the line.
    pub scene: &'a SceneGraph,
    /// The text as it is written, without outer blanks.
    pub text: &'a str,
    /// Its words.
    pub words: &'a [&'a str],
    /// Whether numbers out of range are allowed; the editor moves them into their range. The line `clamped` sets it.
    pub allows_out_of_range: bool,
}

/// Why the arguments of a line mean nothing.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ArgumentError {
    /// Not a number, or not finite.
    #[error("{word:?} is not a finite number")]
    Number {
        /// The word as written.
        word: String,
    },
    /// Not a number, or out of range.
    #[error("{word:?} is not a {what}; expected a {kind} from {low} to {high}")]
    Range {
        /// The word as written.
        word: String,
        /// What is wanted, as in "duration".
        what: &'static str,
        /// `number` or `whole number`.
        kind: &'static str,
        /// The smallest valid value.
        low: f64,
        /// The largest valid value.
        high: f64,
    },
    /// Not one of the allowed words.
    #[error("{word:?} is not {what}; expected {expected}")]
    Choice {
        /// The word as written.
        word: String,
        /// What is wanted, as in "an easing".
        what: &'static str,
        /// What can stand there.
        expected: String,
    },
    /// Not `x`, `y` or `z`.
    #[error("{word:?} is not an axis; expected x, y or z")]
    Axis {
        /// The word as written.
        word: String,
    },
    /// No channel has that name.
    #[error("{word:?} has no keys; expected translation, rotation, scale or colour")]
    Channel {
        /// The word as written.
        word: String,
    },
    /// A key cannot hold that.
    #[error("{word:?} is not a {channel}; expected {expected}")]
    Value {
        /// The word as written.
        word: String,
        /// What it should be.
        channel: &'static str,
        /// How that is written.
        expected: &'static str,
    },
    /// The scene has no such node.
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

/// Reads a line's arguments; `None`: it is not written like this.
pub type Read = fn(&Arguments<'_>) -> Result<Option<Command>, ArgumentError>;

/// Writes a command's arguments; `None`: the command is not of this line, or has no such form.
pub type Write = fn(&Command, &SceneGraph) -> Option<String>;

/// The angles in degrees that a line's arguments give.
pub(super) type Angles = fn(&Arguments<'_>) -> Vec<f64>;

fn no_angles(_: &Arguments<'_>) -> Vec<f64> {
    Vec::new()
}

/// Where a `#` of a line is not the beginning of a comment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// Nowhere.
    Plain,
    /// In the path of a node, which stands last: the longest text that names a node is the path.
    NodePath,
    /// In a name in double quotes, which stands last.
    Name,
    /// In a file's path, if it stands in double quotes; this option may stand before it.
    FilePath(Option<&'static str>),
    /// In words in double quotes.
    QuotedWords,
}

/// The action of a line.
#[derive(Clone, Debug)]
enum Form {
    /// It is a word that means this command.
    Word(Command),
    /// It has arguments.
    Arguments(Read, Write),
}

/// One kind of script line.
#[derive(Clone, Debug)]
pub struct Line {
    /// Its first word.
    pub name: &'static str,
    /// How it is written.
    pub usage: &'static str,
    /// What it does, for the manual.
    pub does: &'static str,
    /// Where a `#` is not the beginning of a comment.
    pub ending: Ending,
    /// The angles in degrees that its arguments give.
    angles: Angles,
    form: Form,
}

impl Line {
    pub(super) const fn new(usage: &'static str, does: &'static str, read: Read, write: Write) -> Self {
        let form = Form::Arguments(read, write);
        Self { name: first_word(usage), usage, does, ending: Ending::Plain, angles: no_angles, form }
    }

    pub(super) const fn word(name: &'static str, does: &'static str, command: Command) -> Self {
        Self { name, usage: name, does, ending: Ending::Plain, angles: no_angles, form: Form::Word(command) }
    }

    pub(super) fn ending(self, ending: Ending) -> Self {
        Self { ending, ..self }
    }

    pub(super) fn angles(self, angles: Angles) -> Self {
        Self { angles, ..self }
    }

    /// What to say of arguments whose command was done: that an angle beyond half a turn is the same as a smaller one.
    #[must_use]
    pub fn note(&self, arguments: &Arguments<'_>) -> Option<Message> {
        (self.angles)(arguments).into_iter().find_map(beyond_half_turn)
    }

    /// The command that the arguments mean; `None`: the line is not written like this.
    ///
    /// # Errors
    /// [`ArgumentError`]
    pub fn read(&self, arguments: &Arguments<'_>) -> Result<Option<Command>, ArgumentError> {
        match &self.form {
            Form::Word(command) => Ok(arguments.words.is_empty().then(|| command.clone())),
            Form::Arguments(read, _) => read(arguments),
        }
    }

    /// The whole line for a command; `None` where it has no such form.
    #[must_use]
    pub fn write(&self, command: &Command, scene: &SceneGraph) -> Option<String> {
        let arguments = match &self.form {
            Form::Word(own) => (own == command).then(String::new)?,
            Form::Arguments(_, write) => write(command, scene)?,
        };
        Some(if arguments.is_empty() { self.name.to_owned() } else { format!("{} {arguments}", self.name) })
    }
}

const fn first_word(usage: &'static str) -> &'static str {
    let mut end = 0;
    while end < usage.len() && usage.as_bytes()[end] != b' ' {
        end += 1;
    }
    usage.split_at(end).0
}

impl<'a> Arguments<'a> {
    /// The RBT node of a path, which may stand in double quotes.
    pub(super) fn rbt(&self, path: &str) -> Result<RbtIndex, ArgumentError> {
        let find = |path: &str| self.scene.find_rbt(path);
        find(path).or_else(|| find(&read_quoted(path)?)).ok_or_else(|| self.missing(path))
    }

    /// The path of any node, which may stand in double quotes.
    pub(super) fn node(&self, path: &str) -> Result<Arc<str>, ArgumentError> {
        if self.scene.find(path).is_some() {
            return Ok(path.into());
        }
        let unquoted = read_quoted(path).filter(|path| self.scene.find(path).is_some());
        unquoted.map(Into::into).ok_or_else(|| self.missing(path))
    }

    pub(super) fn missing(&self, path: &str) -> ArgumentError {
        ArgumentError::Node { path: path.to_owned(), scene: self.scene.name().to_owned() }
    }

    /// The first `N` words, and the text after them; `None` where that is empty.
    pub(super) fn then_text<const N: usize>(&self) -> Option<([&'a str; N], &'a str)> {
        let mut words = [""; N];
        let mut text = self.text;
        for word in &mut words {
            (*word, text) = word_and_rest(text)?;
        }
        (!text.is_empty()).then_some((words, text))
    }
}
