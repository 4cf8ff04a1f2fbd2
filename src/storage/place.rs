//! Where a path leads, and the path `-`.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use super::StorageError;
use super::destination::{followed, is_stream, own_descriptor};

/// Where a path leads, all links followed. Two paths that lead to one file give equal places, also if it does not exist yet.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Place {
    /// Standard input or standard output: `-`, or a name that the system has for it.
    Standard,
    /// Another device or pipe. Whoever names one twice means it.
    Stream,
    /// A file or a folder.
    File(PathBuf),
}

impl Place {
    /// Where something is read from.
    #[must_use]
    pub fn of_input(path: &Path) -> Self {
        Self::of(path, 0)
    }

    /// Where something is written.
    #[must_use]
    pub fn of_output(path: &Path) -> Self {
        Self::of(path, 1)
    }

    fn of(path: &Path, descriptor: u32) -> Self {
        let target = followed(path).unwrap_or_else(|_| path.to_owned());
        if is_standard(path) || own_descriptor(&target) == Some(descriptor) {
            return Self::Standard;
        }
        if is_stream(path) {
            return Self::Stream;
        }
        let in_folder = || {
            let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty());
            Some(fs::canonicalize(folder.unwrap_or_else(|| Path::new("."))).ok()?.join(target.file_name()?))
        };
        Self::File(fs::canonicalize(&target).ok().or_else(in_folder).unwrap_or(target))
    }
}

/// Whether a path is `-`: standard input for what is read, standard output for what is written. A file of that name is `./-`.
#[must_use]
pub fn is_standard(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// What an input is called in a sentence: its path, or standard input.
#[must_use]
pub fn input_name(path: &Path) -> String {
    if is_standard(path) { "standard input".to_owned() } else { path.display().to_string() }
}

/// What an output is called in a sentence: its path, or standard output.
#[must_use]
pub fn output_name(path: &Path) -> String {
    if is_standard(path) { "standard output".to_owned() } else { path.display().to_string() }
}

/// Standard input, which a process can read once.
pub(super) fn standard_input() -> Result<io::StdinLock<'static>, StorageError> {
    static READ: OnceLock<()> = OnceLock::new();
    READ.set(()).map_err(|()| StorageError::ReadTwice)?;
    Ok(io::stdin().lock())
}
