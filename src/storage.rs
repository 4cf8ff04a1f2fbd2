//! The file system: the only place that touches it.

mod walk;

use std::fs;
use std::io::{self, Read as _, Write as _};
use std::path::{Path, PathBuf};

use atomic_write_file::AtomicWriteFile;
use thiserror::Error;

use crate::words::{Message, display_by_message, texts};

pub use walk::{Entry, EntryKind, entries as list, inside, kind};

/// Why a file was not read or written. The message does not name the file; whoever says it does.
#[derive(Debug, Error)]
pub enum StorageError {
    /// The system refused.
    System(#[from] io::Error),
    /// The file is larger than what is read.
    TooLarge {
        /// Its size in bytes.
        found: u64,
        /// The limit in bytes.
        limit: u64,
    },
}

display_by_message!(StorageError);

impl StorageError {
    /// Why, as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::System(error) => match error.kind() {
                io::ErrorKind::NotFound => texts::STORAGE_NOT_FOUND.into(),
                io::ErrorKind::PermissionDenied => texts::STORAGE_PERMISSION_DENIED.into(),
                io::ErrorKind::IsADirectory => texts::STORAGE_IS_FOLDER.into(),
                _ => texts::foreign(error.to_string()),
            },
            Self::TooLarge { found, limit } => texts::storage_too_large(*found, *limit),
        }
    }
}

/// Reads a whole file of at most `limit` bytes; a larger one is refused before it is read.
///
/// # Errors
/// [`StorageError`]
pub fn read(path: &Path, limit: u64) -> Result<Vec<u8>, StorageError> {
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

/// Reads a stream, such as standard input or a pipe, of at most `limit` bytes. `expected` bytes are made room for.
///
/// # Errors
/// [`StorageError`]
pub fn read_stream(stream: impl io::Read, limit: u64, expected: u64) -> Result<Vec<u8>, StorageError> {
    let mut bytes = Vec::with_capacity(usize::try_from(expected).unwrap_or_default());
    let read = stream.take(limit + 1).read_to_end(&mut bytes)?;
    if u64::try_from(read).unwrap_or(u64::MAX) > limit {
        return Err(StorageError::TooLarge { found: limit + 1, limit });
    }
    Ok(bytes)
}

/// Writes a whole file so that it holds either all of `bytes` or what it held before: beside it, synced, renamed over it.
/// A symbolic link stays one; the file it leads to is written.
///
/// # Errors
/// [`StorageError::System`]; the file is as it was then.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), StorageError> {
    write_with(path, |file| file.write_all(bytes))
}

/// The same for content that is made while it is written.
///
/// # Errors
/// [`StorageError::System`]; the file is as it was then.
pub fn write_with(path: &Path, write: impl FnOnce(&mut dyn io::Write) -> io::Result<()>) -> Result<(), StorageError> {
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    if target.is_dir() {
        return Err(io::Error::from(io::ErrorKind::IsADirectory).into());
    }
    let mut file = AtomicWriteFile::open(target)?;
    let mut buffered = io::BufWriter::with_capacity(1 << 16, &mut file);
    write(&mut buffered)?;
    buffered.flush()?;
    drop(buffered);
    file.commit()?;
    Ok(())
}

/// As [`write`], but without waiting for the disk: for pictures that can be made again. After a power cut they may be gone; an
/// interrupted program leaves them whole or not at all.
///
/// # Errors
/// [`StorageError::System`]; the file is as it was then.
pub fn write_unsynced(path: &Path, bytes: &[u8]) -> Result<(), StorageError> {
    let (foreign, mut file) = Foreign::open(path)?;
    file.write_all(bytes)?;
    drop(file);
    foreign.put()
}

/// Copies a file, if it exists, to the first free name of `NAME.bak`, `NAME.bak2` and on, and says which.
///
/// # Errors
/// [`StorageError::System`]
pub fn keep_copy(path: &Path) -> Result<Option<PathBuf>, StorageError> {
    if !path.is_file() {
        return Ok(None);
    }
    let mut name = path.as_os_str().to_owned();
    name.push(".bak");
    let first = PathBuf::from(&name);
    let free = std::iter::once(first)
        .chain((2..).map(|count| {
            let mut counted = name.clone();
            counted.push(count.to_string());
            PathBuf::from(counted)
        }))
        .find(|candidate| !candidate.exists())
        .expect("the numbers do not end");
    fs::copy(path, &free)?;
    Ok(Some(free))
}

/// The first free name of `inbetween-0001.png` and on, in the folder of `beside`.
#[must_use]
pub fn next_screenshot_path(beside: &Path) -> PathBuf {
    let folder = beside.parent().unwrap_or_else(|| Path::new(""));
    (1_u32..)
        .map(|count| folder.join(format!("inbetween-{count:04}.png")))
        .find(|candidate| !candidate.exists())
        .expect("the numbers do not end")
}

/// Makes a folder and those above it, where they are missing.
///
/// # Errors
/// [`StorageError::System`]
pub fn create_folder(path: &Path) -> Result<(), StorageError> {
    Ok(fs::create_dir_all(path)?)
}

/// The file of the settings, in the system's folder for such; `None` where there is no such folder.
#[must_use]
pub fn settings_path() -> Option<PathBuf> {
    let folders = etcetera::base_strategy::choose_native_strategy().ok()?;
    Some(etcetera::BaseStrategy::config_dir(&folders).join("inbetween").join("settings.json"))
}

/// A path that means the same wherever the program is started.
#[must_use]
pub fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}

/// Whether a file or folder stands there.
#[must_use]
pub fn exists(path: &Path) -> bool {
    path.exists()
}

/// A file that is being written, piece by piece, beside the one whose place it takes at the end. Dropped before, it leaves nothing.
#[derive(Debug)]
pub struct Draft {
    file: io::BufWriter<AtomicWriteFile>,
}

impl Draft {
    /// An empty file for that place. A symbolic link stays one; the file it leads to is replaced.
    ///
    /// # Errors
    /// [`StorageError::System`]
    pub fn new(path: &Path) -> Result<Self, StorageError> {
        let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        if target.is_dir() {
            return Err(io::Error::from(io::ErrorKind::IsADirectory).into());
        }
        Ok(Self { file: io::BufWriter::with_capacity(1 << 18, AtomicWriteFile::open(target)?) })
    }

    /// Syncs what was written and puts it in its place.
    ///
    /// # Errors
    /// [`StorageError::System`]; what stood there before is as it was.
    pub fn commit(self) -> Result<(), StorageError> {
        Ok(self.file.into_inner().map_err(io::IntoInnerError::into_error)?.commit()?)
    }
}

impl io::Write for Draft {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// A file that another program writes beside the one whose place it takes at the end. Dropped before, it is removed.
#[derive(Debug)]
pub struct Foreign {
    beside: PathBuf,
    target: PathBuf,
    is_put: bool,
}

impl Foreign {
    /// A name beside that place, which nothing has yet.
    ///
    /// # Errors
    /// [`StorageError::System`]: the place is a folder, or lies in none.
    pub fn new(path: &Path) -> Result<Self, StorageError> {
        Ok(Self::open(path)?.0)
    }

    fn open(path: &Path) -> Result<(Self, fs::File), StorageError> {
        let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        if target.is_dir() {
            return Err(io::Error::from(io::ErrorKind::IsADirectory).into());
        }
        let mut name = std::ffi::OsString::from(".");
        name.push(target.file_name().ok_or(io::ErrorKind::InvalidInput).map_err(io::Error::from)?);
        name.push(format!(".{}.part", std::process::id()));
        let beside = target.with_file_name(name);
        // Made now, so that a folder that is missing or cannot be written is found out before the work.
        let file = fs::File::create_new(&beside)?;
        Ok((Self { beside, target, is_put: false }, file))
    }

    /// Where the other program writes: an empty file stands there.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.beside
    }

    /// Puts what was written in its place.
    ///
    /// # Errors
    /// [`StorageError::System`]; what stood there before is as it was.
    pub fn commit(self) -> Result<(), StorageError> {
        fs::File::open(&self.beside)?.sync_all()?;
        self.put()
    }

    fn put(mut self) -> Result<(), StorageError> {
        fs::rename(&self.beside, &self.target)?;
        self.is_put = true;
        Ok(())
    }
}

impl Drop for Foreign {
    fn drop(&mut self) {
        if !self.is_put {
            // Where it cannot be removed there is no one to tell.
            let _ = fs::remove_file(&self.beside);
        }
    }
}

/// Whether a folder stands there.
#[must_use]
pub fn is_folder(path: &Path) -> bool {
    path.is_dir()
}

/// Removes a file, if it is there.
///
/// # Errors
/// [`StorageError::System`]
pub fn remove(path: &Path) -> Result<(), StorageError> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error.into()),
        _ => Ok(()),
    }
}
