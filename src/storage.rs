//! The file system. No other module accesses it. A page has files in memory in its place.

#[cfg(not(target_arch = "wasm32"))]
mod destination;
#[cfg(not(target_arch = "wasm32"))]
mod draft;
mod known;
#[cfg(not(target_arch = "wasm32"))]
mod log;
#[cfg(not(target_arch = "wasm32"))]
mod open;
#[cfg(target_arch = "wasm32")]
pub mod page;
#[cfg(not(target_arch = "wasm32"))]
mod place;
mod stamp;
#[cfg(not(target_arch = "wasm32"))]
mod walk;

use std::ffi::{OsStr, OsString};
#[cfg(not(target_arch = "wasm32"))]
use std::fs;
use std::io::{self, Read as _, Write as _};
use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::text::system_words;
use crate::words::{Message, display_by_message, texts};

pub use known::{KnownFiles, OutsideChange};
#[cfg(target_arch = "wasm32")]
pub use page::{
    Committed, Draft, Entry, Foreign, LeftLog, Log, Opened, Place, epoch_seconds, input_name, inside, is_standard,
    is_stream, list, logs, open, output_name, state_folder,
};
#[cfg(target_arch = "wasm32")]
use page::{config_folder, fs};
pub use stamp::{Stamp, Stamping, sha256};
#[cfg(not(target_arch = "wasm32"))]
pub use {
    destination::{is_stream, standard_error},
    draft::{Committed, Draft, Foreign},
    log::{LeftLog, Log, begins_with, epoch_seconds, logs, state_folder},
    open::{Opened, open},
    place::{Place, input_name, is_standard, output_name},
    walk::{Entry, EntryKind, entries as list, inside, kind},
};

/// The longest name of a file that file systems accept, in bytes.
const LONGEST_NAME_BYTES: usize = 255;

/// Why a file was not read or written. The message does not name the file; the caller adds the name.
#[derive(Debug, Error)]
pub enum StorageError {
    /// The system's error.
    System(#[from] io::Error),
    /// The file's mode has no write bit. It is not replaced, even by root.
    ReadOnly,
    /// Another program uses the file.
    InUse,
    /// A stream, whose size is not known before it is read, has more bytes than the limit.
    StreamTooLarge {
        /// The limit in bytes.
        limit: u64,
    },
    /// Standard input was read before.
    ReadTwice,
    /// The file is larger than the limit.
    TooLarge {
        /// Its size in bytes.
        found: u64,
        /// The limit in bytes.
        limit: u64,
    },
}

display_by_message!(StorageError);

impl StorageError {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::System(error) => match error.kind() {
                io::ErrorKind::NotFound => texts::STORAGE_NOT_FOUND.into(),
                io::ErrorKind::PermissionDenied => texts::STORAGE_PERMISSION_DENIED.into(),
                io::ErrorKind::AlreadyExists => texts::STORAGE_IN_THE_WAY.into(),
                io::ErrorKind::NotADirectory => texts::STORAGE_NO_FOLDER.into(),
                io::ErrorKind::IsADirectory => texts::STORAGE_IS_FOLDER.into(),
                _ => texts::foreign(system_words(error)),
            },
            Self::ReadOnly => texts::STORAGE_READ_ONLY.into(),
            Self::InUse => texts::STORAGE_IN_USE.into(),
            Self::StreamTooLarge { limit } => texts::storage_stream_too_large(*limit),
            Self::ReadTwice => texts::STORAGE_READ_TWICE.into(),
            Self::TooLarge { found, limit } => texts::storage_too_large(*found, *limit),
        }
    }
}

/// Reads a whole file of at most `limit` bytes; a larger one is refused before it is read. `-` is standard input.
///
/// # Errors
/// [`StorageError`]
pub fn read(path: &Path, limit: u64) -> Result<Vec<u8>, StorageError> {
    #[cfg(not(target_arch = "wasm32"))]
    if is_standard(path) {
        return read_stream(place::standard_input()?, limit, 0);
    }
    let file = fs::File::open(path)?;
    let metadata = file.metadata()?;
    if metadata.is_dir() {
        return Err(io::Error::from(io::ErrorKind::IsADirectory).into());
    }
    if metadata.len() > limit {
        return Err(StorageError::TooLarge { found: metadata.len(), limit });
    }
    read_stream(file, limit, metadata.len())
}

/// Whether a file holds these bytes.
#[must_use]
pub fn is_held(path: &Path, bytes: &[u8]) -> bool {
    fs::metadata(path).is_ok_and(|metadata| metadata.is_file() && metadata.len() == bytes.len() as u64)
        && fs::read(path).is_ok_and(|held| held == bytes)
}

/// Reads the first bytes of a file, at most `most`.
///
/// # Errors
/// [`StorageError`]
pub fn read_head(path: &Path, most: usize) -> Result<Vec<u8>, StorageError> {
    let mut head = Vec::with_capacity(most);
    fs::File::open(path)?.take(most as u64).read_to_end(&mut head)?;
    Ok(head)
}

/// Reads a stream of at most `limit` bytes. Reserves memory for `expected` bytes.
fn read_stream(stream: impl io::Read, limit: u64, expected: u64) -> Result<Vec<u8>, StorageError> {
    let mut bytes = Vec::with_capacity(usize::try_from(expected).unwrap_or_default());
    let read = stream.take(limit + 1).read_to_end(&mut bytes)?;
    if u64::try_from(read).unwrap_or(u64::MAX) > limit {
        return Err(StorageError::StreamTooLarge { limit });
    }
    Ok(bytes)
}

/// Replaces a file atomically: writes a draft next to it, syncs it, and renames it over the file. A symbolic link stays a link; its target
/// is replaced. A device or pipe is written to directly.
///
/// # Errors
/// [`StorageError`]; a regular file is then unchanged.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), StorageError> {
    let mut draft = Draft::new(path)?;
    draft.write_all(bytes)?;
    draft.commit()?;
    Ok(())
}

/// Like [`write()`], for content that is formatted while it is written.
///
/// # Errors
/// [`StorageError`]; a regular file is then unchanged.
pub fn write_with(path: &Path, write: impl FnOnce(&mut dyn io::Write) -> io::Result<()>) -> Result<(), StorageError> {
    let mut draft = Draft::new(path)?;
    write(&mut draft)?;
    draft.commit()?;
    Ok(())
}

/// Like [`write()`]; also returns the stamp of the new content and what became of the replaced file.
///
/// # Errors
/// [`StorageError`]; a regular file is then unchanged.
pub fn write_stamped(
    path: &Path,
    write: impl FnOnce(&mut dyn io::Write) -> io::Result<()>,
) -> Result<(Stamp, Committed), StorageError> {
    let mut stamping = io::BufWriter::with_capacity(1 << 16, Stamping::new(Draft::new(path)?));
    write(&mut stamping)?;
    let (draft, stamp) = stamping.into_inner().map_err(io::IntoInnerError::into_error)?.finish();
    let committed = draft.put()?;
    Ok((stamp.placed_at(path), committed))
}

/// Like [`write()`], without syncing: for pictures that can be made again. A power cut may lose them; a killed program leaves complete
/// files or none.
///
/// # Errors
/// [`StorageError`]; a regular file is then unchanged.
pub fn write_unsynced(path: &Path, bytes: &[u8]) -> Result<(), StorageError> {
    let mut draft = Draft::new(path)?.unsynced();
    draft.write_all(bytes)?;
    draft.commit()?;
    Ok(())
}

/// Copies a file, if it exists, to the first free name of `NAME.bak`, `NAME.bak2` and on, and returns the new name.
///
/// # Errors
/// [`StorageError::System`]
pub fn keep_copy(path: &Path) -> Result<Option<PathBuf>, StorageError> {
    if !fs::metadata(path).is_ok_and(|metadata| metadata.is_file()) {
        return Ok(None);
    }
    let name = path.file_name().unwrap_or_default();
    let free = std::iter::once(String::new())
        .chain((2..).map(|count: u32| count.to_string()))
        .map(|count| path.with_file_name(with_ending(name, &format!(".bak{count}"))))
        .find(|candidate| !exists(candidate))
        .expect("the numbers do not end");
    fs::copy(path, &free)?;
    Ok(Some(free))
}

/// A name with an ending. The end of a long name is cut off, so that the system accepts it.
fn with_ending(name: &OsStr, ending: &str) -> OsString {
    let mut whole = name.to_owned();
    if name.len() + ending.len() > LONGEST_NAME_BYTES {
        let text = name.to_string_lossy();
        whole = text[..text.floor_char_boundary(LONGEST_NAME_BYTES - ending.len())].into();
    }
    whole.push(ending);
    whole
}

/// The first free name of `inbetween-0001.png` and on, in the folder of `beside`; `taken` are not free.
#[must_use]
pub fn next_screenshot_path(beside: &Path, taken: &[&Path]) -> PathBuf {
    let folder = beside.parent().unwrap_or_else(|| Path::new(""));
    (1_u32..)
        .map(|count| folder.join(format!("inbetween-{count:04}.png")))
        .find(|candidate| !exists(candidate) && !taken.contains(&candidate.as_path()))
        .expect("the numbers do not end")
}

/// This path if nothing is there, or the first free one with a number: `walk-2.json`.
#[must_use]
pub fn free_path(path: &Path) -> PathBuf {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let ending = path.extension().map(|ending| format!(".{}", ending.to_string_lossy())).unwrap_or_default();
    let others = (2_u32..).map(|count| path.with_file_name(format!("{stem}-{count}{ending}")));
    std::iter::once(path.to_owned()).chain(others).find(|path| !exists(path)).expect("the numbers do not end")
}

/// Writes bytes at the end of a file, which is created if it is missing.
///
/// # Errors
/// [`StorageError::System`]
#[cfg(not(target_arch = "wasm32"))]
pub fn append(path: &Path, bytes: &[u8]) -> Result<(), StorageError> {
    let mut file = fs::OpenOptions::new().append(true).create(true).open(path)?;
    Ok(file.write_all(bytes)?)
}

/// Creates a folder and its parents if they are missing.
///
/// # Errors
/// [`StorageError::System`]
pub fn create_folder(path: &Path) -> Result<(), StorageError> {
    // In a page folders are there where something is in them.
    #[cfg(not(target_arch = "wasm32"))]
    fs::create_dir_all(path)?;
    let _ = path;
    Ok(())
}

/// The system's folder of settings.
#[cfg(not(target_arch = "wasm32"))]
fn config_folder() -> Option<PathBuf> {
    let folders = etcetera::base_strategy::choose_native_strategy().ok()?;
    Some(etcetera::BaseStrategy::config_dir(&folders).join("inbetween"))
}

/// The settings file in the system's configuration folder; `None` if there is no such folder.
#[must_use]
pub fn settings_path() -> Option<PathBuf> {
    Some(config_folder()?.join("settings.json"))
}

/// The user's own folder of poses, beside the settings file; `None` if there is no such folder.
#[must_use]
pub fn poses_path() -> Option<PathBuf> {
    settings_path().map(|path| path.with_file_name("poses"))
}

/// The absolute form of a path.
#[must_use]
pub fn absolute(path: &Path) -> PathBuf {
    if cfg!(target_arch = "wasm32") {
        return Path::new("/").join(path);
    }
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}

/// The path of an entry without links above it and without `..`; the entry itself may be a link.
#[must_use]
#[cfg(not(target_arch = "wasm32"))]
pub fn resolved(path: &Path) -> PathBuf {
    let path = absolute(path);
    let found = match (path.parent(), path.file_name()) {
        (Some(folder), Some(name)) => fs::canonicalize(folder).map(|folder| folder.join(name)),
        _ => fs::canonicalize(&path),
    };
    found.unwrap_or(path)
}

/// Whether a file or folder exists.
#[must_use]
pub fn exists(path: &Path) -> bool {
    fs::metadata(path).is_ok()
}

/// Whether the path is a folder.
#[must_use]
pub fn is_folder(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|metadata| metadata.is_dir())
}

/// What is in a folder: names, and whether each is a folder. A name that is not UTF-8 is left out.
///
/// # Errors
/// [`StorageError`]
pub fn folder_contents(path: &Path) -> Result<Vec<(String, bool)>, StorageError> {
    #[cfg(target_arch = "wasm32")]
    let paths = fs::names_in(path).into_iter();
    #[cfg(not(target_arch = "wasm32"))]
    let paths = fs::read_dir(path)?.filter_map(Result::ok).map(|entry| entry.path());
    let named = paths.filter_map(|path| Some((path.file_name()?.to_str()?.to_owned(), is_folder(&path))));
    Ok(named.collect())
}

/// The user's own folder, if the system says where it is.
#[must_use]
pub fn home_folder() -> Option<PathBuf> {
    std::env::home_dir().filter(|home| home.is_absolute())
}

/// Removes a file if it exists.
///
/// # Errors
/// [`StorageError::System`]
pub fn remove(path: &Path) -> Result<(), StorageError> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error.into()),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests;
