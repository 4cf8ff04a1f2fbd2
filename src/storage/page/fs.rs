//! The files of a page, in memory, by the names that `std::fs` has for what this program uses of it.
//!
//! A page has no file system. Files that users open are put here, and what is written here goes on its way to them: [`take_changes`] says
//! what that is. What stands in [`super::KEPT`] the browser keeps for the next visit.

use std::collections::BTreeMap;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use web_time::SystemTime;

/// What happened to a file, in order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Change {
    /// It has this content.
    Written(PathBuf),
    /// These bytes were appended at this offset.
    Appended(PathBuf, u64, Vec<u8>),
    /// It is gone.
    Removed(PathBuf),
}

#[derive(Debug)]
struct Entry {
    bytes: Vec<u8>,
    modified: SystemTime,
}

#[derive(Debug, Default)]
struct Files {
    entries: BTreeMap<PathBuf, Entry>,
    changes: Vec<Change>,
}

static FILES: Mutex<Option<Files>> = Mutex::new(None);

fn files() -> MutexGuard<'static, Option<Files>> {
    let mut files = FILES.lock().unwrap_or_else(PoisonError::into_inner);
    files.get_or_insert_with(Files::default);
    files
}

fn with<R>(act: impl FnOnce(&mut Files) -> R) -> R {
    act(files().as_mut().expect("it was just made"))
}

/// The folder of relative paths is the root.
fn absolute(path: impl AsRef<Path>) -> PathBuf {
    Path::new("/").join(path)
}

/// Puts a file there that comes from outside: it is no change.
pub fn put(path: &Path, bytes: Vec<u8>) {
    with(|files| files.entries.insert(absolute(path), Entry { bytes, modified: SystemTime::now() }));
}

/// What was changed since this was last asked.
pub fn take_changes() -> Vec<Change> {
    with(|files| std::mem::take(&mut files.changes))
}

fn not_found() -> io::Error {
    io::ErrorKind::NotFound.into()
}

/// A file that was opened.
#[derive(Debug)]
pub struct File {
    path: PathBuf,
    at: u64,
}

impl File {
    /// Opens it.
    ///
    /// # Errors
    /// It is not there.
    pub fn open(path: impl AsRef<Path>) -> io::Result<Self> {
        metadata(&path)?;
        Ok(Self { path: absolute(path), at: 0 })
    }

    /// What is known of it.
    ///
    /// # Errors
    /// It is not there any more.
    pub fn metadata(&self) -> io::Result<Metadata> {
        metadata(&self.path)
    }
}

impl Read for File {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = with(|files| {
            let entry = files.entries.get(&self.path).ok_or_else(not_found)?;
            let left = entry.bytes.get(self.at as usize..).unwrap_or_default();
            let read = left.len().min(buffer.len());
            buffer[..read].copy_from_slice(&left[..read]);
            io::Result::Ok(read)
        })?;
        self.at += read as u64;
        Ok(read)
    }
}

/// What is known of a file or folder.
#[derive(Clone, Copy, Debug)]
pub struct Metadata {
    length: Option<u64>,
    modified: Option<SystemTime>,
}

impl Metadata {
    /// Whether it is a folder.
    #[must_use]
    pub const fn is_dir(&self) -> bool {
        self.length.is_none()
    }

    /// Whether it is a file.
    #[must_use]
    pub const fn is_file(&self) -> bool {
        self.length.is_some()
    }

    /// Its length in bytes.
    #[must_use]
    pub fn len(&self) -> u64 {
        self.length.unwrap_or_default()
    }

    /// When it was written last.
    ///
    /// # Errors
    /// It is a folder.
    pub fn modified(&self) -> io::Result<SystemTime> {
        self.modified.ok_or_else(not_found)
    }
}

/// What is known of a file or folder.
///
/// # Errors
/// It is not there.
pub fn metadata(path: impl AsRef<Path>) -> io::Result<Metadata> {
    let path = &absolute(path);
    with(|files| match files.entries.get(path) {
        Some(entry) => Ok(Metadata { length: Some(entry.bytes.len() as u64), modified: Some(entry.modified) }),
        None if is_folder(files, path) => Ok(Metadata { length: None, modified: None }),
        None => Err(not_found()),
    })
}

/// Folders are there where something is in them.
fn is_folder(files: &Files, path: &Path) -> bool {
    files.entries.keys().any(|file| file.starts_with(path) && file != path)
}

/// All that a file holds.
///
/// # Errors
/// It is not there.
pub fn read(path: impl AsRef<Path>) -> io::Result<Vec<u8>> {
    with(|files| files.entries.get(&absolute(path)).map(|entry| entry.bytes.clone()).ok_or_else(not_found))
}

/// Writes a file.
///
/// # Errors
/// None; elsewhere there are.
pub fn write(path: impl AsRef<Path>, bytes: impl AsRef<[u8]>) -> io::Result<()> {
    let path = absolute(path);
    put(&path, bytes.as_ref().to_owned());
    with(|files| files.changes.push(Change::Written(path)));
    Ok(())
}

/// Appends to a file.
///
/// # Errors
/// It is not there.
pub fn append(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let path = absolute(path);
    with(|files| {
        let entry = files.entries.get_mut(&path).ok_or_else(not_found)?;
        let at = entry.bytes.len() as u64;
        entry.bytes.extend_from_slice(bytes);
        entry.modified = SystemTime::now();
        files.changes.push(Change::Appended(path, at, bytes.to_owned()));
        Ok(())
    })
}

/// Copies a file.
///
/// # Errors
/// It is not there.
pub fn copy(from: impl AsRef<Path>, to: impl AsRef<Path>) -> io::Result<u64> {
    let bytes = read(from)?;
    write(to, &bytes)?;
    Ok(bytes.len() as u64)
}

/// Removes a file.
///
/// # Errors
/// It is not there.
pub fn remove_file(path: impl AsRef<Path>) -> io::Result<()> {
    let path = absolute(path);
    with(|files| {
        files.entries.remove(&path).ok_or_else(not_found)?;
        files.changes.push(Change::Removed(path));
        Ok(())
    })
}

/// The paths of what is in a folder, in order.
pub fn names_in(folder: &Path) -> Vec<PathBuf> {
    let folder = &absolute(folder);
    with(|files| {
        let mut inside: Vec<PathBuf> = files
            .entries
            .keys()
            .filter_map(|path| Some(folder.join(path.strip_prefix(folder).ok()?.components().next()?)))
            .collect();
        inside.dedup();
        inside
    })
}
