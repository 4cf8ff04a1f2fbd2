//! Why a command ended before its time, and with which exit status.

use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::editor::CommandError;
use crate::export::ExportError;
use crate::film::FilmError;
use crate::render::GpuError;
use crate::storage::StorageError;
use crate::window::WindowError;

/// Why a command was not done.
#[derive(Debug, Error)]
pub enum CliError {
    /// The arguments make no sense; also help and version, which are no errors.
    #[error(transparent)]
    Usage(#[from] clap::Error),
    /// What was given to work on is bad: a sentence for each problem.
    #[error("{}", .sentences.join("\n"))]
    BadInput {
        /// The sentences, each with its place; never empty.
        sentences: Vec<String>,
    },
    /// What was compared differs by more than the tolerance; the command has said so on standard output.
    #[error("beyond the tolerance")]
    Beyond,
    /// What was to be compared could not be: a sentence for each problem.
    #[error("{}", .sentences.join("\n"))]
    Trouble {
        /// The sentences, each with its place; never empty.
        sentences: Vec<String>,
    },
    /// A file could not be written.
    #[error("{}: {reason}", path.display())]
    Unwritten {
        /// Which file.
        path: PathBuf,
        /// Why.
        #[source]
        reason: StorageError,
    },
    /// A script's file could not be written.
    #[error(transparent)]
    ScriptEnded(#[from] CommandError),
    /// There is no GPU adapter, or it cannot draw the picture.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// There is no display, or the window ended.
    #[error(transparent)]
    Window(#[from] WindowError),
    /// A picture could not be made a PNG.
    #[error("the picture cannot be encoded: {0}")]
    Png(#[from] png::EncodingError),
    /// A film could not be written.
    #[error("{}: {reason}", path.display())]
    Film {
        /// Which file.
        path: PathBuf,
        /// Why.
        #[source]
        reason: FilmError,
    },
    /// Ctrl+C, or the system asked the program to end.
    #[error("interrupted: what was not finished is not kept")]
    Interrupted,
    /// Standard output does not take what is written to it.
    #[error("standard output: {0}")]
    StandardOutput(#[source] io::Error),
}

impl CliError {
    /// Bad input with one thing wrong, at a place: a file, or a line of one.
    pub fn bad_input(place: impl std::fmt::Display, problem: impl std::fmt::Display) -> Self {
        Self::BadInput { sentences: vec![format!("{place}: {problem}")] }
    }

    /// A file that could not be written.
    pub fn unwritten(path: &Path, reason: StorageError) -> Self {
        Self::Unwritten { path: path.to_owned(), reason }
    }

    /// The exit status of the process.
    pub fn exit_status(&self) -> u8 {
        match self {
            Self::Usage(_) | Self::Trouble { .. } | Self::Gpu(GpuError::Size { .. }) => 2,
            Self::Interrupted => 130,
            Self::Gpu(_) | Self::Window(WindowError::NoDisplay { .. } | WindowError::Gpu(_)) => 3,
            Self::BadInput { .. }
            | Self::Beyond
            | Self::Unwritten { .. }
            | Self::ScriptEnded(_)
            | Self::Window(WindowError::Ended { .. })
            | Self::Png(_)
            | Self::Film { .. }
            | Self::StandardOutput(_) => 1,
        }
    }
}

impl From<ExportError> for CliError {
    fn from(error: ExportError) -> Self {
        match error {
            ExportError::Misuse(message) => super::misuse(&message.to_string()),
            ExportError::BadInput { .. } => Self::BadInput { sentences: vec![error.to_string()] },
            ExportError::Gpu(error) => Self::Gpu(error),
            ExportError::Png(error) => Self::Png(error),
            ExportError::Unwritten { path, reason } => Self::Unwritten { path, reason },
            ExportError::Film { path, reason } => Self::Film { path, reason },
            ExportError::Cancelled => Self::Interrupted,
        }
    }
}
