//! Films and pictures of an animation: which moments, seen by whom, drawn and written. The window and the command line share it, so
//! that both write the same bytes.
//!
//! It draws on an adapter of its own and waits for nobody: whoever calls it is told of each frame, and may end the work there. What is
//! not finished then is not kept.

mod ffmpeg;
mod job;
mod moments;
mod painter;
mod pipeline;
mod stage;
mod target;
mod times;
mod write;

use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::film::FilmError;
use crate::interpolation::Interpolation;
use crate::keyframe::KeyframeList;
use crate::render::GpuError;
use crate::storage::StorageError;
use crate::words::{Argument, Message, display_by_message, texts};

pub use ffmpeg::find_ffmpeg;
pub use job::Job;
pub use moments::{Moment, Moments, Shown, Source, Span};
pub use painter::{Painter, Size};
pub use pipeline::{Drawing, Watch};
pub use stage::{Stage, View};
pub use target::Target;
pub use times::{FrameTime, frame_times};
pub use write::{write_film, write_folder};

/// Keyframes with what it takes to play them.
#[derive(Clone, Debug)]
pub struct Animation {
    /// The keyframes.
    pub keyframes: KeyframeList,
    /// How to interpolate between them.
    pub interpolation: Interpolation,
    /// Milliseconds from one to the next.
    pub ms_between_keyframes: u32,
}

/// Why there is no film.
#[derive(Debug, Error)]
pub enum ExportError {
    /// Options that do not go together.
    Misuse(Message),
    /// What was given to work on is bad.
    BadInput {
        /// A file, a scene or an option.
        place: Argument,
        /// What is wrong there.
        problem: Message,
    },
    /// There is no GPU adapter, or it cannot draw the picture.
    Gpu(#[from] GpuError),
    /// A picture could not be made a PNG.
    Png(#[from] png::EncodingError),
    /// A file could not be written.
    Unwritten {
        /// Which file.
        path: PathBuf,
        /// Why.
        #[source]
        reason: StorageError,
    },
    /// A film could not be written.
    Film {
        /// Which file.
        path: PathBuf,
        /// Why.
        #[source]
        reason: FilmError,
    },
    /// Whoever watches ended it.
    Cancelled,
}

display_by_message!(ExportError);

impl ExportError {
    /// Why, as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::Misuse(message) => message.clone(),
            Self::BadInput { place, problem } => texts::export_at(place.clone(), problem.clone()),
            Self::Gpu(error) => error.message(),
            Self::Png(error) => texts::export_picture_not_encoded(error.to_string()),
            Self::Unwritten { path, reason } => texts::export_at(path.display(), reason.message()),
            Self::Film { path, reason } => texts::export_at(path.display(), reason.message()),
            Self::Cancelled => texts::EXPORT_INTERRUPTED.into(),
        }
    }

    fn misuse(message: impl Into<Message>) -> Self {
        Self::Misuse(message.into())
    }

    fn bad_input(place: impl Into<Argument>, problem: impl Into<Message>) -> Self {
        Self::BadInput { place: place.into(), problem: problem.into() }
    }

    fn unwritten(path: &Path, reason: StorageError) -> Self {
        Self::Unwritten { path: path.to_owned(), reason }
    }
}
