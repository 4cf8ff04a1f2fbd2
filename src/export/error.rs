//! The error of exports, with its cause.

use std::path::PathBuf;

use thiserror::Error;

use super::Size;
use super::ffmpeg::FfmpegError;
use crate::film::{EncodingError, FilmError, FormatProblem};
use crate::keyframe::SampleError;
use crate::render::GpuError;
use crate::storage::{StorageError, output_name};
use crate::words::{Message, all_of, display_by_message, texts};

/// Why there is no film or picture.
#[derive(Debug, Error)]
pub enum ExportError {
    /// The format does not support the request.
    Format(#[from] FormatProblem),
    /// The span ends before it begins.
    Backwards {
        /// Key time of the beginning.
        from: f64,
        /// Key time of the end.
        to: f64,
    },
    /// More pictures than a film can have.
    TooManyFrames,
    /// More pixels than a contact sheet may have.
    SheetTooLarge {
        /// Its width in pixels.
        width: u64,
        /// Its height in pixels.
        height: u64,
        /// The most pixels in all.
        limit: u64,
    },
    /// The scene has no such camera.
    NoCamera {
        /// The requested value.
        name: String,
        /// The paths of the scene's eyes.
        eyes: Vec<String>,
    },
    /// The scene has no such node to be sharp at.
    NoFocus {
        /// The requested path.
        path: String,
    },
    /// The scene has no such node whose angular speed could be shown.
    NoComparedNode {
        /// The requested path.
        path: String,
    },
    /// A picture is too small for what it is to compare.
    TooSmallToCompare {
        /// Its size.
        size: Size,
        /// How many interpolations it compares.
        count: u32,
        /// A size that is large enough.
        least: Size,
    },
    /// The keyframes cannot be played, or not at the requested time.
    Unplayable {
        /// The name of the keyframe file, or of the scene.
        source_name: String,
        /// The cause.
        #[source]
        cause: SampleError,
    },
    /// The list has no such keyframe.
    NoKeyframe {
        /// The name of the keyframe file, or of the scene.
        source_name: String,
        /// The requested value.
        index: i64,
        /// The last keyframe of the list, if there is one.
        last: Option<usize>,
    },
    /// The film has no such frame.
    NoFrame {
        /// The name of the keyframe file, or of the scene.
        source_name: String,
        /// The requested number.
        frame: usize,
        /// The number of the film's last frame.
        last: usize,
        /// Frames per second.
        fps: u32,
    },
    /// Nothing in the scene moves.
    NothingMoves {
        /// The scene's name.
        source_name: String,
    },
    /// ffmpeg is missing, or did not do its work.
    Ffmpeg {
        /// The film's file.
        path: PathBuf,
        /// The cause.
        #[source]
        cause: FfmpegError,
    },
    /// There is no GPU adapter, or it cannot draw the picture.
    Gpu(#[from] GpuError),
    /// A picture cannot be encoded.
    Picture(#[from] EncodingError),
    /// A file cannot be written.
    Unwritten {
        /// The file's path.
        path: PathBuf,
        /// The cause.
        #[source]
        cause: StorageError,
    },
    /// A folder cannot be read.
    Unread {
        /// Its path.
        path: PathBuf,
        /// The cause.
        #[source]
        cause: StorageError,
    },
    /// The folder holds no numbered pictures.
    NoFrames {
        /// The folder.
        folder: PathBuf,
    },
    /// The folder holds numbered pictures of several formats.
    SeveralFormats {
        /// The folder.
        folder: PathBuf,
        /// The endings of their names.
        endings: Vec<&'static str>,
    },
    /// Pictures of a film are missing, or not whole.
    MissingFrames {
        /// The folder.
        folder: PathBuf,
        /// How many.
        count: usize,
        /// The name of the first of them.
        first: String,
        /// The name of the last of them.
        last: String,
    },
    /// Pictures of a film have different sizes.
    UnequalFrames {
        /// The first whose size is not that of the film's first picture.
        path: PathBuf,
        /// Its size.
        size: Size,
        /// The name of the film's first picture.
        first: String,
        /// The size of that.
        first_size: Size,
    },
    /// Another program has changed or removed a picture while the film was made.
    FrameGone {
        /// Its path.
        path: PathBuf,
    },
    /// The folder holds pictures of an earlier, longer film.
    Stale {
        /// The folder.
        folder: PathBuf,
        /// How many.
        count: usize,
        /// The name of the first of them.
        first: String,
        /// The name of the last of them.
        last: String,
    },
    /// A film cannot be encoded.
    Film {
        /// The file's path.
        path: PathBuf,
        /// The cause.
        #[source]
        cause: FilmError,
    },
    /// The watcher cancelled it.
    Cancelled,
}

display_by_message!(ExportError);

impl ExportError {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::Format(problem) => problem.message(),
            Self::Backwards { from, to } => texts::export_ends_before_it_begins(*to, *from),
            Self::TooManyFrames => texts::EXPORT_TOO_MANY_FRAMES.into(),
            Self::SheetTooLarge { width, height, limit } => texts::export_sheet_too_large(*width, *height, *limit),
            Self::NoCamera { name, eyes } => texts::export_camera_missing(name, eyes.join(", ")),
            Self::NoFocus { path } => texts::export_no_focus(path),
            Self::NoComparedNode { path } => texts::export_no_compared_node(path),
            Self::TooSmallToCompare { size, count, least } => {
                texts::export_too_small_to_compare(size.to_string(), *count, least.to_string())
            }
            Self::Unplayable { source_name, cause } => texts::export_at(source_name.clone(), cause.message()),
            Self::NoKeyframe { source_name, index, last } => {
                let problem = match last {
                    Some(last) => texts::export_no_keyframe(*index, *last),
                    None => texts::export_no_keyframe_in_empty_list(*index),
                };
                texts::export_at(source_name.clone(), problem)
            }
            Self::NoFrame { source_name, frame, last, fps } => {
                texts::export_at(source_name.clone(), texts::export_no_frame(*frame, *fps, *last))
            }
            Self::NothingMoves { source_name } => texts::export_at(source_name.clone(), texts::EXPORT_NOTHING_MOVES),
            Self::Ffmpeg { path, cause } => texts::export_at(output_name(path), cause.message()),
            Self::Gpu(error) => error.message(),
            Self::Picture(error) => error.message(),
            Self::Unwritten { path, cause } => texts::export_at(output_name(path), cause.message()),
            Self::Unread { path, cause } => texts::export_at(path.display(), cause.message()),
            Self::NoFrames { folder } => texts::export_at(folder.display(), texts::EXPORT_NO_FRAMES),
            Self::SeveralFormats { folder, endings } => {
                texts::export_at(folder.display(), texts::export_several_formats(all_of(endings)))
            }
            Self::MissingFrames { folder, count, first, last } => {
                texts::export_at(folder.display(), texts::export_missing_frames(*count, first, last))
            }
            Self::UnequalFrames { path, size, first, first_size } => texts::export_at(
                path.display(),
                texts::export_unequal_frames(size.to_string(), first, first_size.to_string()),
            ),
            Self::FrameGone { path } => texts::export_at(path.display(), texts::EXPORT_FRAME_GONE),
            Self::Stale { folder, count, first, last } => {
                texts::export_at(folder.display(), texts::export_stale(*count, first, last))
            }
            Self::Film { path, cause } => texts::export_at(output_name(path), cause.message()),
            Self::Cancelled => texts::EXPORT_INTERRUPTED.into(),
        }
    }
}

impl From<png::EncodingError> for ExportError {
    fn from(error: png::EncodingError) -> Self {
        Self::Picture(error.into())
    }
}

/// The class of an error. The command line maps it to an exit status.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorKind {
    /// Options that contradict each other.
    Usage,
    /// Bad input, or a file that cannot be written.
    Input,
    /// A fault of the GPU adapter.
    Gpu,
    /// Cancelled by the watcher.
    Cancelled,
}

impl ExportError {
    /// The class of the error.
    #[must_use]
    pub const fn kind(&self) -> ErrorKind {
        match self {
            Self::Format(_)
            | Self::Backwards { .. }
            | Self::TooManyFrames
            | Self::SheetTooLarge { .. }
            | Self::TooSmallToCompare { .. } => ErrorKind::Usage,
            Self::NoCamera { .. }
            | Self::NoFocus { .. }
            | Self::NoComparedNode { .. }
            | Self::Unplayable { .. }
            | Self::NoKeyframe { .. }
            | Self::NoFrame { .. }
            | Self::NothingMoves { .. }
            | Self::Unread { .. }
            | Self::NoFrames { .. }
            | Self::SeveralFormats { .. }
            | Self::MissingFrames { .. }
            | Self::UnequalFrames { .. }
            | Self::FrameGone { .. }
            | Self::Ffmpeg { .. }
            | Self::Picture(_)
            | Self::Unwritten { .. }
            | Self::Stale { .. }
            | Self::Film { .. } => ErrorKind::Input,
            Self::Gpu(_) => ErrorKind::Gpu,
            Self::Cancelled => ErrorKind::Cancelled,
        }
    }
}
