//! Reading of JSON and TOML. What is wrong is a sentence with its line and column, in every language of the program.
//!
//! This is the one place that knows the wordings of the libraries (`wordings`). Where a type's own form needs a sentence, its visitor
//! or `#[serde(expecting)]` names the id of a phrase, such as `decode.kind.rotation`. No wording of a library reaches a user: one that is
//! not known becomes a general sentence.

mod nested;
mod wordings;

use serde::Deserialize;
use serde::de::DeserializeOwned;
use thiserror::Error;

pub use nested::nested_json;

use crate::text::{line_and_column, without_byte_order_mark};
use crate::words::{Message, display_by_message, texts};

/// The levels of brackets within each other that serde_json reads by default.
const USUAL_LEVELS: usize = 127;

/// What is wrong with a text, and where.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub struct DecodeError {
    /// The line, from 1.
    pub line: usize,
    /// The column in characters, from 1.
    pub column: usize,
    /// What is wrong, without the place.
    pub problem: Message,
}

display_by_message!(DecodeError);

impl DecodeError {
    /// The error as a message with its line and column.
    #[must_use]
    pub fn message(&self) -> Message {
        texts::text_at(self.line, self.column, self.problem.clone())
    }

    /// The same in a text of which only line `number` was read.
    #[must_use]
    pub fn in_line(self, number: usize) -> Self {
        Self { line: number, ..self }
    }

    fn of_json(bytes: &[u8], error: &serde_json::Error, is_after_the_end: bool) -> Self {
        let lines_before = error.line().saturating_sub(1);
        let newlines = bytes.iter().enumerate().filter(|(_, byte)| **byte == b'\n');
        let line_start = match lines_before {
            0 => 0,
            before => newlines.map(|(at, _)| at + 1).nth(before - 1).unwrap_or(bytes.len()),
        };
        // The column that is given counts bytes up to and including the one where reading stopped; 0 means that there is none yet.
        let at = (line_start + error.column().saturating_sub(1)).min(bytes.len());
        let problem = if is_after_the_end && error.is_syntax() {
            texts::DECODE_AFTER_THE_END.into()
        } else {
            wordings::json(error, bytes.get(at).copied())
        };
        let (line, column) = line_and_column(bytes, at);
        Self { line, column, problem }
    }
}

/// Reads JSON. A byte order mark is skipped.
///
/// # Errors
/// [`DecodeError`]
pub fn json<'de, T: Deserialize<'de>>(bytes: &'de [u8]) -> Result<T, DecodeError> {
    let bytes = without_byte_order_mark(bytes);
    whole(bytes, &mut serde_json::Deserializer::from_slice(bytes))
}

/// Reads a value and the end of the text.
fn whole<'de, T: Deserialize<'de>>(
    bytes: &'de [u8],
    reader: &mut serde_json::Deserializer<serde_json::de::SliceRead<'de>>,
) -> Result<T, DecodeError> {
    let value = T::deserialize(&mut *reader).map_err(|error| DecodeError::of_json(bytes, &error, false))?;
    reader.end().map_err(|error| DecodeError::of_json(bytes, &error, true))?;
    Ok(value)
}

/// Reads TOML. A byte order mark is skipped.
///
/// # Errors
/// [`DecodeError`]
pub fn toml<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, DecodeError> {
    let bytes = without_byte_order_mark(bytes);
    let placed = |at: usize, problem: Message| {
        let (line, column) = line_and_column(bytes, at);
        DecodeError { line, column, problem }
    };
    let text =
        std::str::from_utf8(bytes).map_err(|error| placed(error.valid_up_to(), texts::DECODE_NOT_UTF_8.into()))?;
    toml::from_str(text).map_err(|error| {
        let start = error.span().map_or(bytes.len(), |span| span.start);
        // A field that is missing in the whole is reported at the start: it is missing at the end.
        let is_missing = start == 0 && wordings::is_missing_field(error.message());
        placed(if is_missing { bytes.len() } else { start }, wordings::toml(error.message()))
    })
}

#[cfg(test)]
mod tests;
