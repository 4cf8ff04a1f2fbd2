//! A row of the table of formats, and the interface of encoders.

use std::fmt;
use std::io::Write;
use std::path::{Path, PathBuf};

use thiserror::Error;

use super::{FilmError, films, formats};
use crate::picture::{Image, Rows};
use crate::words::{Message, Phrase, all_of, display_by_message, one_of, texts};

/// A format: a row of [`FORMATS`](super::FORMATS). Two formats are equal if their names are and both or neither are of films.
pub struct Format {
    /// The name for people, such as "GIF".
    pub name: &'static str,
    /// The ending of its files' names, in lower case and without the dot.
    pub ending: &'static str,
    /// Whether it keeps opacity.
    pub has_opacity: bool,
    /// The default frames per second.
    pub usual_frames_per_second: u32,
    /// The highest frame rate, in frames per second.
    pub most_frames_per_second: u32,
    /// The format's own limits. Takes width and height in pixels and, for a film, frames per second; returns the reason if the format
    /// cannot hold it.
    pub limit: fn([u32; 2], Option<u32>) -> Option<Phrase>,
    /// The encoder.
    pub encoder: Encoder,
}

/// The encoder of a format.
pub enum Encoder {
    /// One picture per file, encoded here. A film becomes a folder of numbered files.
    Still(StillFormat),
    /// A film, encoded here.
    Film(FilmFormat),
    /// ffmpeg encodes the film. It reads the stream that this `FilmFormat` writes.
    Ffmpeg(FilmFormat),
}

/// How single pictures are written and read.
#[derive(Clone, Copy)]
pub struct StillFormat {
    /// Makes an encoder.
    pub start: StartStill,
    /// The picture in a file's bytes; `None` if they are not a whole picture of the format, or one that is too large to be read.
    pub decode: fn(&[u8]) -> Option<Image>,
}

/// Makes an encoder for pictures of this width and height in pixels. `None`: the size is not known yet. An encoder for a known
/// size may allocate its memory at once.
pub type StartStill = fn(Option<[u32; 2]>) -> Box<dyn StillEncoder>;

/// Encodes pictures one after the other and reuses its memory.
pub trait StillEncoder: Send {
    /// Encodes a picture. The same picture always gives the same bytes.
    ///
    /// # Errors
    /// [`EncodingError`] if the format does not support the picture.
    fn encode(&mut self, rows: &Rows<'_>) -> Result<(), EncodingError>;

    /// The bytes of the last encoded picture.
    fn bytes(&self) -> &[u8];

    /// Like [`StillEncoder::bytes`], but gives up the memory.
    fn into_bytes(self: Box<Self>) -> Vec<u8>;
}

/// How to begin a film.
#[derive(Clone, Copy)]
pub struct FilmFormat {
    /// Frames, spread over the film, that the encoder must see before the first one: it chooses its palette by them.
    pub sample_frames: usize,
    /// Begins a film with those frames as samples.
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

/// The properties of a film that are known before its first picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Pictures in all.
    pub frames: u32,
    /// Pictures per second.
    pub frames_per_second: u32,
    /// Whether every pixel is opaque.
    pub is_opaque: bool,
}

impl Plan {
    /// The plan of a film of `frames` pictures; `None` if there are 2^32 or more. The size is width and height in pixels.
    #[must_use]
    pub fn new([width, height]: [u32; 2], frames: usize, frames_per_second: u32, is_opaque: bool) -> Option<Self> {
        let frames = u32::try_from(frames).ok()?;
        Some(Self { width, height, frames, frames_per_second, is_opaque })
    }
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

    /// Adds a picture that is shown from `start_ms` to `end_ms` of the film. Y4M and MP4 ignore the times: all pictures last
    /// equally long.
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

    /// Ends the film. A film that is dropped instead is incomplete.
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

/// Why a format does not support a request. The message is a phrase that follows a colon.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum FormatProblem {
    /// The format has no opacity.
    NoOpacity,
    /// It is for films, and a single picture was requested.
    NoPicture,
    /// It is for single pictures, and a film was requested.
    NoFilm,
    /// A limit of the format, such as the longest side.
    Limit(Phrase),
}

display_by_message!(EncodingError);

impl EncodingError {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        texts::export_picture_not_encoded(self.0.to_string())
    }
}

display_by_message!(FormatProblem);

impl FormatProblem {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::NoOpacity => texts::export_no_opacity(all_of(&formats::opaque()), all_of(&formats::translucent())),
            Self::NoPicture => texts::export_one_image(one_of(&formats::still_names())),
            Self::NoFilm => texts::export_one_film(one_of(&formats::film_names())),
            Self::Limit(limit) => (*limit).into(),
        }
    }
}

impl Format {
    /// Whether it is for single pictures, so that a film is a folder.
    #[must_use]
    pub const fn is_still(&self) -> bool {
        matches!(self.encoder, Encoder::Still(_))
    }

    /// The format of films with this ending, or itself if there is none.
    #[must_use]
    pub fn of_films(&'static self) -> &'static Self {
        films().find(|format| format.ending == self.ending).unwrap_or(self)
    }

    /// Replaces a film extension by this format's; any other text is kept. A still format gets no extension, because its films are
    /// folders.
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

    /// Why the format does not support a request: width and height in pixels, frames per second for a film, opaque or not. `None` if it
    /// does.
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
        self.name == other.name && self.is_still() == other.is_still()
    }
}

impl Eq for Format {}

impl fmt::Debug for Format {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.name)
    }
}
