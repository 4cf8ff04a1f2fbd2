//! What is wrong with a text: a sentence with its line and column.

use thiserror::Error;

use crate::text::{counted, line_and_column};

/// A text that cannot be read, and where.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("line {line} column {column}: {problem}")]
pub struct TextError {
    /// The line, from 1.
    pub line: usize,
    /// The column, from 1, in characters.
    pub column: usize,
    /// What is wrong there.
    pub problem: TextProblem,
}

impl TextError {
    /// A problem at a byte of a text.
    pub(super) fn new(bytes: &[u8], at: usize, problem: TextProblem) -> Self {
        let (line, column) = line_and_column(bytes, at);
        Self { line, column, problem }
    }
}

/// What is wrong at a place of a text.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum TextProblem {
    /// There is nothing to read.
    #[error("the file is empty, expected keyframes")]
    Empty,
    /// The bytes are no text that this program reads.
    #[error("the file is UTF-16, expected UTF-8: save it so")]
    Utf16,
    /// Something stands where something else belongs.
    #[error("found {found}, expected {expected}")]
    Unexpected {
        /// What stands there, quoted, or `the end of the file`.
        found: String,
        /// What belongs there.
        expected: String,
    },
    /// A number that is none, such as `nan`, or is beyond single precision.
    #[error("{found:?} is not finite, expected a number")]
    NotFinite {
        /// What stands there.
        found: String,
    },
    /// The header and the rows do not agree.
    #[error(
        "the header says {keyframes} keyframes of {nodes} nodes, expected {} after it, found {}{hint}; --salvage takes the whole keyframes",
        in_rows(*expected), in_rows(*found)
    )]
    Header {
        /// How many keyframes it says.
        keyframes: usize,
        /// How many nodes it says.
        nodes: usize,
        /// How many numbers that makes.
        expected: usize,
        /// How many there are.
        found: usize,
        /// Where it may have gone wrong, as a part of the sentence; may be empty.
        hint: String,
    },
    /// The rows end within a keyframe.
    #[error(
        "found {found} numbers, {}, expected whole keyframes of {nodes} nodes with {width} numbers each{hint}; --salvage takes the whole keyframes",
        in_keyframes(*found, nodes * width)
    )]
    Incomplete {
        /// How many numbers there are.
        found: usize,
        /// How many nodes a keyframe has.
        nodes: usize,
        /// How many numbers a node has.
        width: usize,
        /// Where it may have gone wrong, as a part of the sentence; may be empty.
        hint: String,
    },
    /// A keyframe between marks is not as long as the others.
    #[error(
        "keyframe {keyframe} has {found} numbers, expected {expected}; --salvage takes the whole keyframes before it"
    )]
    KeyframeLength {
        /// The keyframe, from 0.
        keyframe: usize,
        /// How many numbers it has.
        found: usize,
        /// How many it should have.
        expected: usize,
    },
    /// The keyframes are of another scene.
    #[error("a keyframe has {found} nodes, expected {expected}")]
    NodeCount {
        /// How many it has.
        found: usize,
        /// How many this program can use, in words.
        expected: String,
    },
    /// A rotation is not a unit quaternion.
    #[error(
        "keyframe {keyframe}, row {row}: the {four} four numbers have length {length}, expected a quaternion of length 1{hint}"
    )]
    NotUnit {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The row within it, from 0.
        row: usize,
        /// `first` or `last`.
        four: &'static str,
        /// Their length.
        length: f32,
        /// What is known of the other order, as a part of the sentence; may be empty.
        hint: &'static str,
    },
    /// A matrix scales, shears or mirrors.
    #[error(
        "keyframe {keyframe}, node {row}: the matrix is not rigid, expected a rotation and a translation in column order"
    )]
    NotRigid {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The matrix within it, from 0.
        row: usize,
    },
    /// A dictionary is longer than what is read.
    #[error("there are more than {limit} keys in one dictionary")]
    TooManyKeys {
        /// The most there can be.
        limit: usize,
    },
    /// Two keys of a dictionary are at one time.
    #[error("a second key at {seconds} s, expected one at each time")]
    TwoAtOneTime {
        /// The time.
        seconds: f64,
    },
    /// There is not one whole keyframe to be saved.
    #[error("there is not one whole keyframe to be salvaged")]
    NothingToSalvage,
}

/// A count of numbers as rows of seven.
pub(super) fn in_rows(numbers: usize) -> String {
    let rows = counted(numbers / 7, "row");
    match numbers % 7 {
        0 => format!("{rows} ({})", counted(numbers, "number")),
        rest => format!("{rows} and {} ({numbers} in all)", counted(rest, "number")),
    }
}

/// A count of numbers as keyframes.
fn in_keyframes(numbers: usize, in_one: usize) -> String {
    format!("{} and {}", counted(numbers / in_one, "whole keyframe"), counted(numbers % in_one, "number"))
}

/// A piece of a text, quoted and short enough for a message.
pub(super) fn quoted(piece: &[u8]) -> String {
    let text = String::from_utf8_lossy(&piece[..piece.len().min(160)]);
    let mut short: String = text.chars().take(40).collect();
    if short.len() < text.len() || piece.len() > 160 {
        short.push('…');
    }
    format!("{short:?}")
}
