//! Errors with file names.

use std::fmt::Display;

use thiserror::Error;

use crate::export::ExportError;
use crate::render::GpuError;
use crate::storage::StorageError;

/// The problems of a file: a sentence for each, with the file's name.
#[derive(Debug, Error)]
#[error("{}", .sentences.join("\n"))]
pub struct FileError {
    sentences: Vec<String>,
    #[source]
    source: Option<StorageError>,
}

impl FileError {
    /// One problem; `location` is a file, a line of one, or what else was named.
    pub fn new(location: impl Display, problem: impl Display) -> Self {
        Self::all(location, [problem])
    }

    /// Problems at one location, of which there is at least one.
    pub fn all(location: impl Display, problems: impl IntoIterator<Item = impl Display>) -> Self {
        let sentences = problems.into_iter().map(|problem| format!("{location}: {problem}")).collect();
        Self { sentences, source: None }
    }

    /// Problems that name their locations, of which there is at least one.
    #[must_use]
    pub fn of_sentences(sentences: Vec<String>) -> Self {
        Self { sentences, source: None }
    }

    /// A file that could not be read or written; `location` is what it is called.
    #[must_use]
    pub fn storage(location: impl Display, reason: StorageError) -> Self {
        let sentences = vec![format!("{location}: {reason}")];
        Self { sentences, source: Some(reason) }
    }

    /// The same problems of a file that something else refers to: `context` is put before each.
    #[must_use]
    pub fn within(self, context: impl Display) -> Self {
        let sentences = self.sentences.iter().map(|sentence| format!("{context}: {sentence}")).collect();
        Self { sentences, ..self }
    }

    /// The sentences, never none.
    #[must_use]
    pub fn sentences(&self) -> &[String] {
        &self.sentences
    }
}

/// Why work on files or pictures failed.
#[derive(Debug, Error)]
pub enum WorkError {
    /// A file is bad, or could not be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A picture could not be drawn or encoded.
    #[error(transparent)]
    Export(#[from] ExportError),
}

impl From<GpuError> for WorkError {
    fn from(error: GpuError) -> Self {
        Self::Export(error.into())
    }
}

impl From<png::EncodingError> for WorkError {
    fn from(error: png::EncodingError) -> Self {
        Self::Export(error.into())
    }
}
