//! Films: pictures in their order become one stream of bytes, as they come.
//!
//! Nothing here draws, waits or touches a file: a [`Film`] takes pictures and writes to whatever takes bytes. The same pictures always
//! give the same bytes.

mod apng;
mod gif;
mod letters;
mod palette;
mod sheet;
mod y4m;

use std::io::{self, Write};

use thiserror::Error;

use crate::render::Image;
use crate::words::{Message, display_by_message, texts};

pub use palette::Palette;
pub use sheet::{Cell, Grid, contact_sheet};

/// How films are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Animated GIF: 255 colours, shown everywhere; times are whole hundredths of a second.
    Gif,
    /// Animated PNG: every colour and opacity as drawn.
    Apng,
    /// Uncompressed YUV 4:2:0 (YUV4MPEG2), which other programs encode.
    Y4m,
}

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
    /// The bytes cannot be written.
    Unwritten(#[from] io::Error),
    /// The encoder refuses.
    Encoding(String),
}

display_by_message!(FilmError);

impl FilmError {
    /// Why, as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::Size { width, height, found_width, found_height } => {
                texts::film_size(*found_width, *found_height, *width, *height)
            }
            Self::TooLarge { width, height } => texts::film_too_large(*width, *height),
            Self::Unwritten(error) => texts::foreign(error.to_string()),
            Self::Encoding(reason) => texts::film_not_encoded(reason),
        }
    }
}

impl From<png::EncodingError> for FilmError {
    fn from(error: png::EncodingError) -> Self {
        match error {
            png::EncodingError::IoError(error) => Self::Unwritten(error),
            other => Self::Encoding(other.to_string()),
        }
    }
}

impl From<::gif::EncodingError> for FilmError {
    fn from(error: ::gif::EncodingError) -> Self {
        match error {
            ::gif::EncodingError::Io(error) => Self::Unwritten(error),
            other => Self::Encoding(other.to_string()),
        }
    }
}

/// What is known of a film before its first picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Pictures in all.
    pub frames: u32,
    /// Pictures a second.
    pub frames_per_second: u32,
    /// Whether every pixel is opaque.
    pub is_opaque: bool,
}

/// A film that is being written.
pub enum Film<W: Write> {
    /// A GIF.
    Gif(Box<gif::GifFilm<W>>),
    /// An animated PNG.
    Apng(Box<apng::ApngFilm<W>>),
    /// A YUV4MPEG2 stream.
    Y4m(y4m::Y4mFilm<W>),
}

impl<W: Write> Film<W> {
    /// A film with no pictures yet. The palette is a GIF's; others do not look at it.
    ///
    /// # Errors
    /// [`FilmError`]
    pub fn new(format: Format, plan: Plan, palette: Palette, output: W) -> Result<Self, FilmError> {
        Ok(match format {
            Format::Gif => Self::Gif(Box::new(gif::GifFilm::new(plan, palette, output)?)),
            Format::Apng => Self::Apng(Box::new(apng::ApngFilm::new(plan, output)?)),
            Format::Y4m => Self::Y4m(y4m::Y4mFilm::new(plan, output)?),
        })
    }

    /// Adds a picture that is shown from `start_ms` to `end_ms` of the film. Y4M shows all for the same time.
    ///
    /// # Errors
    /// [`FilmError`]
    pub fn push(&mut self, image: &Image, start_ms: f64, end_ms: f64) -> Result<(), FilmError> {
        let plan = match self {
            Self::Gif(film) => film.plan(),
            Self::Apng(film) => film.plan(),
            Self::Y4m(film) => film.plan(),
        };
        let Plan { width, height, .. } = plan;
        if (width, height) != (image.width, image.height) {
            return Err(FilmError::Size { width, height, found_width: image.width, found_height: image.height });
        }
        match self {
            Self::Gif(film) => film.push(image, start_ms, end_ms),
            Self::Apng(film) => film.push(image, start_ms, end_ms),
            Self::Y4m(film) => film.push(image),
        }
    }

    /// Ends the film. Without this it is no whole one.
    ///
    /// # Errors
    /// [`FilmError`]
    pub fn finish(self) -> Result<(), FilmError> {
        match self {
            Self::Gif(film) => film.finish(),
            Self::Apng(film) => film.finish(),
            Self::Y4m(film) => film.finish(),
        }
    }
}

#[cfg(test)]
mod tests;
