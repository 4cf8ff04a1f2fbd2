//! Errors in texts, with line and column.

use thiserror::Error;

use crate::text::line_and_column;
use crate::words::{self, Argument, Message, display_by_message, texts};

/// An error in a text, with its location.
#[derive(Clone, Debug, Error, PartialEq)]
pub struct TextError {
    /// The line, from 1.
    pub line: usize,
    /// The column, from 1, in characters.
    pub column: usize,
    /// The error.
    pub problem: TextProblem,
    /// Whether whole keyframes before the error can be salvaged.
    pub can_be_salvaged: bool,
}

impl TextError {
    /// A problem at a byte of a text.
    pub(super) fn new(bytes: &[u8], at: usize, problem: TextProblem) -> Self {
        let (line, column) = line_and_column(bytes, at);
        Self { line, column, problem, can_be_salvaged: false }
    }
}

/// The kinds of errors in texts.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum TextProblem {
    /// There is nothing to read.
    Empty,
    /// The bytes are not text in a known encoding.
    Utf16,
    /// It is a model or a motion of another program.
    OtherProgram,
    /// An unexpected token.
    Unexpected {
        /// The text found, quoted, or `the end of the file`.
        found: Argument,
        /// The expected text.
        expected: Argument,
    },
    /// A number is not finite, such as `nan`, or beyond single precision.
    NotFinite {
        /// The text found.
        found: String,
    },
    /// The header and the rows do not agree.
    Header {
        /// The number of keyframes in the header.
        keyframes: usize,
        /// The number of nodes in the header.
        nodes: usize,
        /// The number of numbers that follows from them.
        expected: usize,
        /// The number of numbers found.
        found: usize,
        /// The probable location of the error, as a part of the sentence, if known.
        hint: Option<Message>,
    },
    /// The text ends inside a keyframe.
    Incomplete {
        /// The number of numbers found.
        found: usize,
        /// The number of nodes per keyframe.
        nodes: usize,
        /// The number of numbers per node.
        width: usize,
        /// The probable location of the error, as a part of the sentence, if known.
        hint: Option<Message>,
    },
    /// A keyframe between marks has another length than the others.
    KeyframeLength {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The number of numbers found.
        found: usize,
        /// The number of numbers expected.
        expected: usize,
    },
    /// A number has a decimal comma.
    DecimalComma {
        /// The number as it is written.
        found: String,
    },
    /// Without a header the number of nodes was guessed, and the offsets match no robot.
    Guessed {
        /// The number of nodes that would make whole keyframes.
        nodes: usize,
        /// The supported numbers of nodes, as a phrase.
        expected: Argument,
    },
    /// The keyframes are of another scene.
    NodeCount {
        /// The number of nodes per keyframe found.
        found: usize,
        /// The supported numbers of nodes, as a phrase.
        expected: Argument,
    },
    /// A rotation is not a unit quaternion.
    NotUnit {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The row within it, from 0.
        row: usize,
        /// Whether the quaternion is the last four numbers of the row, or the first four.
        is_last: bool,
        /// The quaternion's length.
        length: f32,
        /// A remark about the other order, as a part of the sentence, if there is one.
        hint: Option<Message>,
    },
    /// A coordinate is out of bounds: [`crate::rbt::LARGEST_COORDINATE`].
    TooFar {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The row within it, from 0.
        row: usize,
    },
    /// A matrix scales, shears or mirrors.
    NotRigid {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The matrix within it, from 0.
        row: usize,
    },
    /// An expression of a program whose value is known only when it runs.
    Unknown {
        /// The expression, quoted.
        found: Argument,
    },
    /// A program nests too deep.
    TooDeep,
    /// A program is too large.
    TooLarge {
        /// The most bytes that are read, in MiB.
        limit: usize,
    },
    /// A Python program has no keys.
    NoKeys,
    /// There is more than one group of keys.
    Groups {
        /// How many there are.
        count: usize,
        /// The groups, with number, line and name.
        list: Message,
    },
    /// There is no group of this number.
    NoGroup {
        /// The number.
        group: usize,
        /// The groups, with number, line and name.
        list: Message,
    },
    /// A dictionary has too many keys.
    TooManyKeys {
        /// The largest number of keys.
        limit: usize,
    },
    /// Two keys of a dictionary have the same time.
    TwoAtOneTime {
        /// The time in seconds.
        seconds: f64,
    },
    /// There is no complete keyframe to salvage.
    NothingToSalvage,
}

display_by_message!(TextError, TextProblem);

impl TextError {
    /// The error as a message, with line and column.
    #[must_use]
    pub fn message(&self) -> Message {
        let problem = self.problem.message();
        let problem = if self.can_be_salvaged { texts::text_can_be_salvaged(problem) } else { problem };
        texts::text_at(self.line, self.column, problem)
    }
}

impl TextProblem {
    /// Whether it is a problem of how many numbers there are: what stands before it may be whole.
    pub(super) fn is_of_counts(&self) -> bool {
        matches!(self, Self::Header { .. } | Self::Incomplete { .. } | Self::KeyframeLength { .. })
    }

    /// The error as a message without its location.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::Empty => texts::TEXT_EMPTY.into(),
            Self::Utf16 => texts::TEXT_UTF_16.into(),
            Self::OtherProgram => texts::MODEL_NOT_HERE.into(),
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
            Self::DecimalComma { found } => texts::text_decimal_comma(words::quoted(found), found.replace(',', ".")),
            Self::Guessed { nodes, expected } => texts::text_guessed(*nodes, expected.clone()),
            Self::NodeCount { found, expected } => texts::text_node_count(*found, expected.clone()),
            Self::NotUnit { keyframe, row, is_last: true, length, hint } => {
                texts::text_not_unit_last(*keyframe, *row, *length, optional(hint.as_ref()))
            }
            Self::NotUnit { keyframe, row, is_last: false, length, hint } => {
                texts::text_not_unit_first(*keyframe, *row, *length, optional(hint.as_ref()))
            }
            Self::TooFar { keyframe, row } => texts::text_too_far(*keyframe, *row, texts::SCENE_EXPECTED_COORDINATES),
            Self::NotRigid { keyframe, row } => texts::text_not_rigid(*keyframe, *row),
            Self::Unknown { found } => texts::text_unknown(found.clone()),
            Self::TooDeep => texts::TEXT_TOO_DEEP.into(),
            Self::TooLarge { limit } => texts::text_program_too_large(*limit),
            Self::NoKeys => texts::TEXT_NO_KEYS.into(),
            Self::Groups { count, list } => texts::text_groups(*count, list.clone()),
            Self::NoGroup { group, list } => texts::text_no_group(*group, list.clone()),
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
