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
    #[error("{0}")]
    Misuse(String),
    /// What was given to work on is bad.
    #[error("{place}: {problem}")]
    BadInput {
        /// A file, a scene or an option.
        place: String,
        /// What is wrong there.
        problem: String,
    },
    /// There is no GPU adapter, or it cannot draw the picture.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// A picture could not be made a PNG.
    #[error("the picture cannot be encoded: {0}")]
    Png(#[from] png::EncodingError),
    /// A file could not be written.
    #[error("{}: {reason}", path.display())]
    Unwritten {
        /// Which file.
        path: PathBuf,
        /// Why.
        #[source]
        reason: StorageError,
    },
    /// A film could not be written.
    #[error("{}: {reason}", path.display())]
    Film {
        /// Which file.
        path: PathBuf,
        /// Why.
        #[source]
        reason: FilmError,
    },
    /// Whoever watches ended it.
    #[error("interrupted: what was not finished is not kept")]
    Cancelled,
}

impl ExportError {
    fn misuse(sentence: impl Into<String>) -> Self {
        Self::Misuse(sentence.into())
    }

    fn bad_input(place: impl std::fmt::Display, problem: impl std::fmt::Display) -> Self {
        Self::BadInput { place: place.to_string(), problem: problem.to_string() }
    }

    fn unwritten(path: &Path, reason: StorageError) -> Self {
        Self::Unwritten { path: path.to_owned(), reason }
    }
}
