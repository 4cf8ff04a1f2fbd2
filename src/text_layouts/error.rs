//! What is wrong with a text: a sentence with its line and column.

use thiserror::Error;

use crate::text::line_and_column;
use crate::words::{self, Argument, Message, display_by_message, texts};

/// A text that cannot be read, and where.
#[derive(Clone, Debug, Error, PartialEq)]
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
    Empty,
    /// The bytes are no text that this program reads.
    Utf16,
    /// Something stands where something else belongs.
    Unexpected {
        /// What stands there, quoted, or `the end of the file`.
        found: Argument,
        /// What belongs there.
        expected: Argument,
    },
    /// A number that is none, such as `nan`, or is beyond single precision.
    NotFinite {
        /// What stands there.
        found: String,
    },
    /// The header and the rows do not agree.
    Header {
        /// How many keyframes it says.
        keyframes: usize,
        /// How many nodes it says.
        nodes: usize,
        /// How many numbers that makes.
        expected: usize,
        /// How many there are.
        found: usize,
        /// Where it may have gone wrong, as a part of the sentence; if it is known.
        hint: Option<Message>,
    },
    /// The rows end within a keyframe.
    Incomplete {
        /// How many numbers there are.
        found: usize,
        /// How many nodes a keyframe has.
        nodes: usize,
        /// How many numbers a node has.
        width: usize,
        /// Where it may have gone wrong, as a part of the sentence; if it is known.
        hint: Option<Message>,
    },
    /// A keyframe between marks is not as long as the others.
    KeyframeLength {
        /// The keyframe, from 0.
        keyframe: usize,
        /// How many numbers it has.
        found: usize,
        /// How many it should have.
        expected: usize,
    },
    /// The keyframes are of another scene.
    NodeCount {
        /// How many it has.
        found: usize,
        /// How many this program can use, in words.
        expected: Argument,
    },
    /// A rotation is not a unit quaternion.
    NotUnit {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The row within it, from 0.
        row: usize,
        /// Whether they are the last four of the row, or the first.
        is_last: bool,
        /// Their length.
        length: f32,
        /// What is known of the other order, as a part of the sentence, if it is known.
        hint: Option<Message>,
    },
    /// A matrix scales, shears or mirrors.
    NotRigid {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The matrix within it, from 0.
        row: usize,
    },
    /// A dictionary is longer than what is read.
    TooManyKeys {
        /// The most there can be.
        limit: usize,
    },
    /// Two keys of a dictionary are at one time.
    TwoAtOneTime {
        /// The time.
        seconds: f64,
    },
    /// There is not one whole keyframe to be saved.
    NothingToSalvage,
}

display_by_message!(TextError, TextProblem);

impl TextError {
    /// What is wrong and where, as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        texts::text_at(self.line, self.column, self.problem.message())
    }
}

impl TextProblem {
    /// What is wrong, as a message without its place.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::Empty => texts::TEXT_EMPTY.into(),
            Self::Utf16 => texts::TEXT_UTF_16.into(),
            Self::Unexpected { found, expected } => texts::text_unexpected(found.clone(), expected.clone()),
            Self::NotFinite { found } => texts::text_not_finite(words::quoted(found)),
            Self::Header { keyframes, nodes, expected, found, hint } => {
                texts::text_header(*keyframes, *nodes, in_rows(*expected), in_rows(*found), optional(hint.as_ref()))
            }
            Self::Incomplete { found, nodes, width, hint } => {
                let keyframes = in_keyframes(*found, nodes * width);
                texts::text_incomplete(*found, keyframes, *nodes, *width, optional(hint.as_ref()))
            }
            Self::KeyframeLength { keyframe, found, expected } => {
                texts::text_keyframe_length(*keyframe, *found, *expected)
            }
            Self::NodeCount { found, expected } => texts::text_node_count(*found, expected.clone()),
            Self::NotUnit { keyframe, row, is_last: true, length, hint } => {
                texts::text_not_unit_last(*keyframe, *row, *length, optional(hint.as_ref()))
            }
            Self::NotUnit { keyframe, row, is_last: false, length, hint } => {
                texts::text_not_unit_first(*keyframe, *row, *length, optional(hint.as_ref()))
            }
            Self::NotRigid { keyframe, row } => texts::text_not_rigid(*keyframe, *row),
            Self::TooManyKeys { limit } => texts::text_too_many_keys(*limit),
            Self::TwoAtOneTime { seconds } => texts::text_two_at_one_time(*seconds),
            Self::NothingToSalvage => texts::TEXT_NOTHING_TO_SALVAGE.into(),
        }
    }
}

fn optional(hint: Option<&Message>) -> Argument {
    hint.cloned().map_or_else(|| "".into(), Argument::from)
}

/// A count of numbers as rows of seven.
pub(super) fn in_rows(numbers: usize) -> Message {
    let rows = texts::count_rows(numbers / 7);
    match numbers % 7 {
        0 => texts::text_whole_rows(rows, texts::count_numbers(numbers)),
        rest => texts::text_rows_and_more(rows, texts::count_numbers(rest), numbers),
    }
}

/// A count of numbers as keyframes.
fn in_keyframes(numbers: usize, in_one: usize) -> Message {
    texts::text_keyframes_and_more(
        texts::count_whole_keyframes(numbers / in_one),
        texts::count_numbers(numbers % in_one),
    )
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
