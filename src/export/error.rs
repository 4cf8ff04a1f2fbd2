//! Why there is no film or picture: one error, with its cause.

use std::path::PathBuf;

use thiserror::Error;

use super::ffmpeg::FfmpegError;
use crate::film::{EncodingError, FilmError, FormatProblem};
use crate::keyframe::SampleError;
use crate::render::GpuError;
use crate::storage::StorageError;

/// Why there is no film or picture.
#[derive(Debug, Error)]
pub enum ExportError {
    /// The format cannot hold what is asked for.
    #[error(transparent)]
    Format(#[from] FormatProblem),
    /// The span ends before it begins.
    #[error("it would end (key time {to}) before it begins (key time {from})")]
    Backwards {
        /// Key time of the beginning.
        from: f64,
        /// Key time of the end.
        to: f64,
    },
    /// More pictures than a film can count.
    #[error("a film has fewer than 2^32 frames")]
    TooManyFrames,
    /// The scene has no such camera.
    #[error("camera \"{name}\": the scene's eyes are {}; or: turntable", eyes.join(", "))]
    NoCamera {
        /// What was asked for.
        name: String,
        /// The paths of the scene's eyes.
        eyes: Vec<String>,
    },
    /// The keyframes cannot be played, or not there.
    #[error("{source_name}: {cause}")]
    Unplayable {
        /// The keyframe file, or the scene.
        source_name: String,
        /// Why.
        #[source]
        cause: SampleError,
    },
    /// The list has no such keyframe.
    #[error("{source_name}: there is no keyframe {index}: {}", match last {
        Some(last) => format!("they are 0 to {last}"),
        None => "the list is empty".to_owned(),
    })]
    NoKeyframe {
        /// The keyframe file, or the scene.
        source_name: String,
        /// What was asked for.
        index: i64,
        /// The last keyframe of the list, if there is one.
        last: Option<usize>,
    },
    /// There is nothing to make a film of.
    #[error("{source_name}: nothing moves: name a keyframe file, or --camera turntable")]
    NothingMoves {
        /// The scene.
        source_name: String,
    },
    /// ffmpeg is missing, or did not do its work.
    #[error("{}: {cause}", path.display())]
    Ffmpeg {
        /// The film's file.
        path: PathBuf,
        /// Why.
        #[source]
        cause: FfmpegError,
    },
    /// There is no GPU adapter, or it cannot draw the picture.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// A picture cannot be encoded.
    #[error(transparent)]
    Picture(#[from] EncodingError),
    /// A file cannot be written.
    #[error("{}: {cause}", path.display())]
    Unwritten {
        /// Which file.
        path: PathBuf,
        /// Why.
        #[source]
        cause: StorageError,
    },
    /// A film cannot be encoded.
    #[error("{}: {cause}", path.display())]
    Film {
        /// Which file.
        path: PathBuf,
        /// Why.
        #[source]
        cause: FilmError,
    },
    /// The watcher ended it.
    #[error("interrupted: what was not finished is not kept")]
    Cancelled,
}

impl From<png::EncodingError> for ExportError {
    fn from(error: png::EncodingError) -> Self {
        Self::Picture(error.into())
    }
}

/// Whose fault an error is: what a command line makes its exit status of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorKind {
    /// Options that do not go together.
    Usage,
    /// What was given to work on is bad, or a file cannot be written.
    Input,
    /// The GPU adapter.
    Gpu,
    /// The watcher.
    Cancelled,
}

impl ExportError {
    /// Whose fault it is.
    #[must_use]
    pub const fn kind(&self) -> ErrorKind {
        match self {
            Self::Format(_) | Self::Backwards { .. } | Self::TooManyFrames => ErrorKind::Usage,
            Self::NoCamera { .. }
            | Self::Unplayable { .. }
            | Self::NoKeyframe { .. }
            | Self::NothingMoves { .. }
            | Self::Ffmpeg { .. }
            | Self::Picture(_)
            | Self::Unwritten { .. }
            | Self::Film { .. } => ErrorKind::Input,
            Self::Gpu(_) => ErrorKind::Gpu,
            Self::Cancelled => ErrorKind::Cancelled,
        }
    }
}
