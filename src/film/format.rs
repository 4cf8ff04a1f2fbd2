//! What a format is: a row of the table of formats, and what its encoders do.

use std::fmt;
use std::io::Write;
use std::path::{Path, PathBuf};

use thiserror::Error;

use super::{FilmError, films, formats};
use crate::picture::{Image, Rows};
use crate::words::{Message, Phrase, all_of, display_by_message, one_of, texts};

/// A format: a row of [`FORMATS`](super::FORMATS). Two are equal where their names are.
pub struct Format {
    /// What people call it, as in "GIF".
    pub name: &'static str,
    /// The ending of its files' names, in lower case and without the dot.
    pub ending: &'static str,
    /// Whether it keeps opacity.
    pub has_opacity: bool,
    /// Frames a second where none are named.
    pub usual_frames_per_second: u32,
    /// The most frames a second.
    pub most_frames_per_second: u32,
    /// The format's own limits: why there is no file of a width and height in pixels and, of what moves, so many frames a second.
    pub limit: fn([u32; 2], Option<u32>) -> Option<Phrase>,
    /// What writes it.
    pub encoder: Encoder,
}

/// What writes a format.
pub enum Encoder {
    /// One picture a file, encoded here. What moves becomes a folder of numbered files.
    Still(StartStill),
    /// A film, encoded here.
    Film(FilmFormat),
    /// A film that the user's ffmpeg encodes out of this one.
    Ffmpeg(FilmFormat),
}

/// Makes an encoder; one for pictures of that width and height has its memory at once.
pub type StartStill = fn(Option<[u32; 2]>) -> Box<dyn StillEncoder>;

/// Encodes pictures, one after the other, in memory that it keeps.
pub trait StillEncoder: Send {
    /// Encodes a picture. The same picture always gives the same bytes.
    ///
    /// # Errors
    /// [`EncodingError`] where the format does not take it.
    fn encode(&mut self, rows: &Rows<'_>) -> Result<(), EncodingError>;

    /// The picture that was encoded last.
    fn bytes(&self) -> &[u8];

    /// As [`StillEncoder::bytes`], at the end.
    fn into_bytes(self: Box<Self>) -> Vec<u8>;
}

/// How a film is begun.
#[derive(Clone, Copy)]
pub struct FilmFormat {
    /// Frames, spread over the film, that the encoder must see before the first one: it chooses its colours by them.
    pub sample_frames: usize,
    /// Begins a film, having seen those frames.
    pub start: StartFilm,
}

/// Begins a film.
pub type StartFilm =
    for<'a> fn(Plan, &[Image], &'a mut (dyn Write + Send)) -> Result<Box<dyn FilmEncoder + 'a>, FilmError>;

/// A film that is being encoded.
pub trait FilmEncoder: Send {
    /// Adds a picture of the film's size, shown from `start_ms` to `end_ms` of the film.
    ///
    /// # Errors
    /// [`FilmError`]
    fn push(&mut self, image: &Image, start_ms: f64, end_ms: f64) -> Result<(), FilmError>;

    /// Ends the film.
    ///
    /// # Errors
    /// [`FilmError`]
    fn finish(self: Box<Self>) -> Result<(), FilmError>;
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
pub struct Film<'a> {
    plan: Plan,
    encoder: Box<dyn FilmEncoder + 'a>,
}

impl<'a> Film<'a> {
    /// A film with no pictures yet. `samples` are [`FilmFormat::sample_frames`] of its pictures, or fewer in a short film.
    ///
    /// # Errors
    /// [`FilmError`]
    pub fn new(
        format: FilmFormat,
        plan: Plan,
        samples: &[Image],
        output: &'a mut (dyn Write + Send),
    ) -> Result<Self, FilmError> {
        Ok(Self { plan, encoder: (format.start)(plan, samples, output)? })
    }

    /// Adds a picture that is shown from `start_ms` to `end_ms` of the film. Y4M shows all for the same time.
    ///
    /// # Errors
    /// [`FilmError`]
    pub fn push(&mut self, image: &Image, start_ms: f64, end_ms: f64) -> Result<(), FilmError> {
        let Plan { width, height, .. } = self.plan;
        if (width, height) != (image.width, image.height) {
            return Err(FilmError::Size { width, height, found_width: image.width, found_height: image.height });
        }
        self.encoder.push(image, start_ms, end_ms)
    }

    /// Ends the film. A film that is dropped instead is not whole.
    ///
    /// # Errors
    /// [`FilmError`]
    pub fn finish(self) -> Result<(), FilmError> {
        self.encoder.finish()
    }
}

/// Why a picture cannot be encoded.
#[derive(Debug, Error)]
pub struct EncodingError(#[source] pub Box<dyn std::error::Error + Send + Sync>);

impl From<png::EncodingError> for EncodingError {
    fn from(error: png::EncodingError) -> Self {
        Self(error.into())
    }
}

/// Why a format cannot hold what is asked for. In a few words, to stand after a colon.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum FormatProblem {
    /// It keeps no opacity.
    NoOpacity,
    /// It is of films, and one picture is asked for.
    NoPicture,
    /// A limit of its own.
    Limit(Phrase),
}

display_by_message!(EncodingError);

impl EncodingError {
    /// Why, as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        texts::export_picture_not_encoded(self.0.to_string())
    }
}

display_by_message!(FormatProblem);

impl FormatProblem {
    /// Why, as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::NoOpacity => texts::export_no_opacity(all_of(&formats::opaque()), all_of(&formats::translucent())),
            Self::NoPicture => texts::export_one_image(one_of(&formats::still_names())),
            Self::Limit(limit) => (*limit).into(),
        }
    }
}

impl Format {
    /// Whether it is of single pictures: a film is a folder of them.
    #[must_use]
    pub const fn is_still(&self) -> bool {
        matches!(self.encoder, Encoder::Still(_))
    }

    /// A path, ending as this format's films do, which is not at all where they are folders: the ending of another format's films is
    /// replaced, anything else is kept.
    #[must_use]
    pub fn film_path(&self, path: &Path) -> PathBuf {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        let is_films = films().any(|format| ending.as_deref() == Some(format.ending));
        let bare = if is_films { path.with_extension("") } else { path.to_owned() };
        if self.is_still() {
            return bare;
        }
        let mut name = bare.into_os_string();
        name.push(".");
        name.push(self.ending);
        name.into()
    }

    /// Why it cannot hold pictures of a width and height in pixels, so many a second where it is a film, transparent or not; `None` where
    /// it can.
    #[must_use]
    pub fn problem(&self, size: [u32; 2], fps: Option<u32>, is_seen_through: bool) -> Option<FormatProblem> {
        if is_seen_through && !self.has_opacity {
            return Some(FormatProblem::NoOpacity);
        }
        (self.limit)(size, fps).map(FormatProblem::Limit)
    }
}

impl PartialEq for Format {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Format {}

impl fmt::Debug for Format {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.name)
    }
}
