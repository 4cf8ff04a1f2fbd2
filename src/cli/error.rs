//! Why a command ended before its time, and with which exit status.

use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::editor::CommandError;
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
    /// A comparison found more than passes: the report on standard output says what.
    #[error("the difference is beyond the tolerance")]
    Beyond,
    /// A comparison could not be made.
    #[error(transparent)]
    Trouble(Box<CliError>),
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
            Self::Usage(_) | Self::Gpu(GpuError::Size { .. }) | Self::Trouble(_) => 2,
            Self::Gpu(_) | Self::Window(WindowError::NoDisplay { .. } | WindowError::Gpu(_)) => 3,
            Self::BadInput { .. }
            | Self::Unwritten { .. }
            | Self::ScriptEnded(_)
            | Self::Window(WindowError::Ended { .. })
            | Self::Png(_)
            | Self::Beyond
            | Self::StandardOutput(_) => 1,
        }
    }
}
