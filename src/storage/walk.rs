//! Listing folders without following links.

use std::fs;
use std::path::{Path, PathBuf};

use super::StorageError;

/// The kind of an entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EntryKind {
    /// A regular file.
    File,
    /// A folder.
    Folder,
    /// A symbolic link, wherever it leads.
    Link,
    /// A device, a pipe, a socket.
    Other,
}

/// One entry of a folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Its path: the folder's path and the name.
    pub path: PathBuf,
    /// Its own name; bytes that are not UTF-8 are replaced.
    pub name: String,
    /// Its kind.
    pub kind: EntryKind,
}

/// The kind of the entry at a path; links are not followed.
///
/// # Errors
/// [`StorageError::System`]
pub fn kind(path: &Path) -> Result<EntryKind, StorageError> {
    let kind = fs::symlink_metadata(path)?.file_type();
    Ok(if kind.is_symlink() {
        EntryKind::Link
    } else if kind.is_dir() {
        EntryKind::Folder
    } else if kind.is_file() {
        EntryKind::File
    } else {
        EntryKind::Other
    })
}

/// The first `most` entries of a folder in the order of their names, and a lower bound of their number.
///
/// # Errors
/// [`StorageError::System`]
pub fn entries(folder: &Path, most: usize) -> Result<(Vec<Entry>, usize), StorageError> {
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder)?.take(most.saturating_mul(4).max(most + 1)) {
        paths.push(entry?.path());
    }
    paths.sort();
    let count = paths.len();
    paths.truncate(most);
    let entry = |path: PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        kind(&path).map(|kind| Entry { path, name, kind })
    };
    Ok((paths.into_iter().map(entry).collect::<Result<_, _>>()?, count))
}

/// The path with all links followed, if it is inside a folder.
#[must_use]
pub fn inside(path: &Path, folder: &Path) -> Option<PathBuf> {
    let (path, folder) = (fs::canonicalize(path).ok()?, fs::canonicalize(folder).ok()?);
    path.starts_with(folder).then_some(path)
}
