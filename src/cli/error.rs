//! Errors of the command line: the exit status and the sentences for standard error.

use std::error::Error;
use std::fmt::Display;
use std::io;
use std::path::Path;

use clap::error::ErrorKind as ClapKind;

use super::arguments;
use crate::editor::CommandError;
use crate::export::{ErrorKind, ExportError};
use crate::files::{FileError, WorkError};
use crate::render::GpuError;
use crate::script::DiskStop;
use crate::storage::{self, StorageError};
use crate::text::system_words;
use crate::window::WindowError;
#[cfg(target_os = "linux")]
use crate::words::texts;

/// How a successful command ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// All is well: status 0.
    Well,
    /// Something is not as it should be, and the command has said what: status 1.
    Beyond,
}

impl Ended {
    /// The process's exit status.
    pub fn status(self) -> u8 {
        match self {
            Self::Well => 0,
            Self::Beyond => BAD_INPUT,
        }
    }
}

const BAD_INPUT: u8 = 1;
/// Wrong usage; trouble of a command that compares.
pub const MISUSE: u8 = 2;
/// No display, or no GPU adapter that draws.
pub const NO_DRAWING: u8 = 3;
/// The exit status that Rust uses for a program that panicked.
const PANICKED: u8 = 101;
/// The exit status that shells use for a program that SIGINT ended.
const INTERRUPTED: u8 = 130;

/// Why a command failed.
#[derive(Debug)]
pub enum CliError {
    /// Wrong usage; also help and version. clap prints these in a form of its own.
    Usage(clap::Error),
    /// Wrong usage that a command found.
    Misuse(String),
    /// What is wrong has been said.
    Said {
        /// The process's exit status.
        status: u8,
    },
    /// Anything else.
    Failed {
        /// The process's exit status.
        status: u8,
        /// What is said on standard error: a sentence a line; never empty.
        sentences: Vec<String>,
        /// The error of the room that gave up, where one did.
        source: Option<Box<dyn Error + Send + Sync>>,
    },
}

impl CliError {
    /// Bad input with one thing wrong, at a location: a file, or a line of one.
    pub fn bad_input(location: impl Display, problem: impl Display) -> Self {
        Self::bad_inputs(vec![format!("{location}: {problem}")])
    }

    /// Bad input: a sentence for each problem, each with its location; never empty.
    pub fn bad_inputs(sentences: Vec<String>) -> Self {
        Self::Failed { status: BAD_INPUT, sentences, source: None }
    }

    /// A file that could not be written.
    pub fn unwritten(path: &Path, reason: StorageError) -> Self {
        FileError::storage(storage::output_name(path), reason).into()
    }

    /// Standard output does not take what is written to it.
    pub fn standard_output(error: io::Error) -> Self {
        Self::failed(BAD_INPUT, format!("standard output: {}", system_words(&error)), error)
    }

    fn failed(status: u8, sentence: String, source: impl Into<Box<dyn Error + Send + Sync>>) -> Self {
        Self::Failed { status, sentences: vec![sentence], source: Some(source.into()) }
    }

    fn of(status: u8, error: impl Error + Send + Sync + 'static) -> Self {
        Self::failed(status, error.to_string(), error)
    }

    /// The same as the failure of a command that compares: status 2, since 1 would mean a difference.
    pub fn into_trouble(self) -> Self {
        match self {
            Self::Failed { sentences, source, .. } => Self::Failed { status: MISUSE, sentences, source },
            other => other,
        }
    }

    /// The exit status, and what is left to say: a sentence a line.
    pub fn into_sentences(self) -> (u8, Vec<String>) {
        match self {
            Self::Usage(error) => (MISUSE, vec![error.to_string()]),
            Self::Misuse(sentence) => (MISUSE, vec![sentence]),
            Self::Said { status } => (status, Vec::new()),
            Self::Failed { status, sentences, .. } => (status, sentences),
        }
    }

    /// Wrong usage that a command found, with the usage of that command; of the program where there is none. Other errors stay as they
    /// are.
    pub fn with_usage_of(self, name: Option<&str>) -> Self {
        let Self::Misuse(sentence) = self else { return self };
        let mut program = arguments::command();
        program.build();
        let command = match name {
            Some(name) if program.find_subcommand(name).is_some() => program.find_subcommand_mut(name),
            _ => None,
        };
        let error = match command {
            Some(command) => command.error(ClapKind::ArgumentConflict, sentence),
            None => arguments::command().error(ClapKind::ArgumentConflict, sentence),
        };
        Self::Usage(error)
    }
}

impl From<clap::Error> for CliError {
    fn from(error: clap::Error) -> Self {
        Self::Usage(error)
    }
}

impl From<FileError> for CliError {
    fn from(error: FileError) -> Self {
        Self::Failed { status: BAD_INPUT, sentences: error.sentences().to_vec(), source: Some(error.into()) }
    }
}

impl From<GpuError> for CliError {
    fn from(error: GpuError) -> Self {
        Self::failed(gpu_status(&error), with_drivers(&error, &error), error)
    }
}

/// A sentence, with the drivers that are loaded where one of them hangs and has not said its name.
fn with_drivers(sentence: impl Display, error: &GpuError) -> String {
    #[cfg(target_os = "linux")]
    if let (GpuError::Hangs { adapter: None, .. }, Some(drivers)) = (error, super::drivers::loaded()) {
        return texts::gpu_loaded(sentence.to_string(), drivers).to_string();
    }
    let _ = error;
    sentence.to_string()
}

fn gpu_status(error: &GpuError) -> u8 {
    if matches!(error, GpuError::Size { .. }) { MISUSE } else { NO_DRAWING }
}

fn window_status(error: &WindowError) -> u8 {
    match error {
        WindowError::NoDisplay { .. } | WindowError::Gpu(_) => NO_DRAWING,
        WindowError::Ended { .. } | WindowError::DisplayGone => BAD_INPUT,
        // As shells have it.
        WindowError::Signalled { signal } => u8::try_from(128 + signal).unwrap_or(BAD_INPUT),
        WindowError::Panicked { .. } => PANICKED,
        WindowError::Unsaved { error, .. } => window_status(error),
    }
}

impl From<WindowError> for CliError {
    fn from(error: WindowError) -> Self {
        let sentence = match &error {
            WindowError::Gpu(gpu) => with_drivers(&error, gpu),
            _ => error.to_string(),
        };
        Self::failed(window_status(&error), sentence, error)
    }
}

impl From<png::EncodingError> for CliError {
    fn from(error: png::EncodingError) -> Self {
        ExportError::from(error).into()
    }
}

impl From<ExportError> for CliError {
    fn from(error: ExportError) -> Self {
        let status = match (&error, error.kind()) {
            (_, ErrorKind::Usage) => return super::misuse(&error.to_string()),
            (ExportError::Gpu(error), _) => gpu_status(error),
            (_, ErrorKind::Cancelled) => INTERRUPTED,
            (_, ErrorKind::Input | ErrorKind::Gpu) => BAD_INPUT,
        };
        Self::of(status, error)
    }
}

impl From<WorkError> for CliError {
    fn from(error: WorkError) -> Self {
        match error {
            WorkError::File(error) => error.into(),
            WorkError::Export(error) => error.into(),
        }
    }
}

impl From<CommandError> for CliError {
    fn from(error: CommandError) -> Self {
        Self::of(BAD_INPUT, error)
    }
}

impl From<DiskStop> for CliError {
    fn from(error: DiskStop) -> Self {
        match error {
            DiskStop::Unwritten(error) => error.into(),
            DiskStop::Picture(error) => error.into(),
        }
    }
}
