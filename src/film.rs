//! Film and picture files: the table of formats, their encoders, and the options of an export.
//!
//! This module does not draw, wait or open files: encoders take pictures and write to any `Write`. The same pictures always give the same
//! bytes. To add a format, add a file under `formats/` and a row to the table there.

mod compared;
mod format;
mod formats;
mod letters;
mod numbers;
mod options;
mod plot;
mod quality;
mod sheet;

use std::io;

use thiserror::Error;

use crate::text::system_words;
use crate::words::{Message, display_by_message, texts};
pub use compared::{COMPARED_AT_MOST, ComparedAs, ComparedBoard, ComparedLayout};
pub use format::{
    Encoder, EncodingError, Film, FilmEncoder, FilmFormat, Format, FormatProblem, Plan, StartStill, StillEncoder,
    StillFormat,
};
pub use formats::{
    APNG, FORMATS, GIF, MOST_FRAMES_PER_SECOND, MP4, NOT_WRITTEN, PNG, Palette, SmallPng, Y4M, films, format_of_ending,
    format_of_path, opaque, still_names, stills, translucent, written_endings,
};
pub use numbers::{FrameNumbers, FrameNumbersError};
pub use options::{ExportBackground, ExportEnd, ExportOptions};
pub use plot::{Plot, PlotCurve, axis_end};
pub use quality::Quality;
pub use sheet::{Cell, Grid, contact_sheet};

/// Why a film cannot be written.
#[derive(Debug, Error)]
pub enum FilmError {
    /// A picture has another size than the film.
    Size {
        /// The film's width in pixels.
        width: u32,
        /// The film's height in pixels.
        height: u32,
        /// The picture's width in pixels.
        found_width: u32,
        /// The picture's height in pixels.
        found_height: u32,
    },
    /// A GIF's sides are at most 65535 pixels.
    TooLarge {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    },
    /// The output refuses the bytes.
    Unwritten(#[from] io::Error),
    /// The encoder refuses the picture.
    Encoding(#[source] Box<dyn std::error::Error + Send + Sync>),
}

display_by_message!(FilmError);

impl FilmError {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::Size { width, height, found_width, found_height } => {
                texts::film_size(*found_width, *found_height, *width, *height)
            }
            Self::TooLarge { width, height } => texts::film_too_large(*width, *height),
            Self::Unwritten(error) => texts::foreign(system_words(error)),
            Self::Encoding(reason) => texts::film_not_encoded(reason.to_string()),
        }
    }
}

impl From<png::EncodingError> for FilmError {
    fn from(error: png::EncodingError) -> Self {
        match error {
            png::EncodingError::IoError(error) => Self::Unwritten(error),
            other => Self::Encoding(other.into()),
        }
    }
}

impl From<gif::EncodingError> for FilmError {
    fn from(error: gif::EncodingError) -> Self {
        match error {
            gif::EncodingError::Io(error) => Self::Unwritten(error),
            other => Self::Encoding(other.into()),
        }
    }
}

#[cfg(test)]
mod tests;
