//! What a page has in place of a file system: files in memory. [`super`] says what each item does.

pub mod fs;

use std::collections::BTreeSet;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use web_time::SystemTime;

use super::StorageError;
use crate::unfinished::Unfinished;

/// The folder of what the browser keeps: settings, poses, journals.
pub const KEPT: &str = "/browser";

/// The folder of settings.
#[expect(clippy::unnecessary_wraps, reason = "elsewhere there may be none")]
pub(super) fn config_folder() -> Option<PathBuf> {
    Some(PathBuf::from(KEPT))
}

/// The folder for what a program keeps of its runs.
#[must_use]
#[expect(clippy::unnecessary_wraps, reason = "elsewhere there may be none")]
pub fn state_folder() -> Option<PathBuf> {
    config_folder()
}

/// A file that is being written.
#[derive(Debug)]
pub struct Draft {
    path: PathBuf,
    bytes: Vec<u8>,
}

/// What became of a replaced file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Committed {
    /// Other names of it, which keep the old content: there are none.
    pub other_links: u64,
}

impl Draft {
    /// Begins a file.
    ///
    /// # Errors
    /// The path is a folder.
    pub fn new(path: &Path) -> Result<Self, StorageError> {
        if super::is_folder(path) {
            return Err(io::Error::from(io::ErrorKind::IsADirectory).into());
        }
        Ok(Self { path: path.to_owned(), bytes: Vec::new() })
    }

    /// There is no disk to wait for.
    #[must_use]
    pub fn unsynced(self) -> Self {
        self
    }

    /// Puts the file there.
    ///
    /// # Errors
    /// None; elsewhere there are.
    pub fn commit(self) -> Result<(), StorageError> {
        self.put().map(|_| ())
    }

    /// The same.
    ///
    /// # Errors
    /// None; elsewhere there are.
    pub fn put(self) -> Result<Committed, StorageError> {
        fs::write(self.path, self.bytes)?;
        Ok(Committed::default())
    }
}

impl Write for Draft {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.bytes.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// A file for another program to write: a page has no other programs.
#[derive(Debug)]
pub enum Foreign {}

impl Foreign {
    /// Refuses.
    ///
    /// # Errors
    /// Always.
    pub fn new(_: &Path) -> Result<Self, StorageError> {
        Err(io::Error::from(io::ErrorKind::Unsupported).into())
    }

    /// Its path.
    #[must_use]
    pub const fn path(&self) -> &Path {
        match *self {}
    }

    /// Puts it there.
    ///
    /// # Errors
    /// None.
    pub const fn commit(self) -> Result<(), StorageError> {
        match self {}
    }
}

/// The logs of this page.
static HELD: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn held<R>(act: impl FnOnce(&mut BTreeSet<PathBuf>) -> R) -> R {
    act(&mut HELD.lock().unwrap_or_else(PoisonError::into_inner))
}

/// A file that only grows.
#[derive(Debug)]
pub struct Log {
    path: PathBuf,
}

impl Log {
    /// Creates one in a folder. Its name begins with the time.
    ///
    /// # Errors
    /// None; elsewhere there are.
    pub fn create_in(folder: &Path, ending: &str) -> Result<Self, StorageError> {
        // Two pages may begin in the same microsecond.
        let tail = super::sha256(format!("{}", js_sys::Math::random()).as_bytes());
        let path = folder.join(format!("{}-{}{ending}", since_epoch().as_micros(), &tail[..8]));
        fs::write(&path, [])?;
        held(|held| held.insert(path.clone()));
        Ok(Self { path })
    }

    /// For a journal that begins anew where it is.
    ///
    /// # Errors
    /// None; elsewhere there are.
    pub fn create_for(path: &Path) -> Result<Option<Self>, StorageError> {
        let folder = path.parent().unwrap_or(Path::new("/"));
        Self::create_in(folder, ".begun").map(Some)
    }

    /// Takes the place of another log.
    ///
    /// # Errors
    /// [`StorageError::System`]
    pub fn take_place_of(&mut self, path: &Path) -> Result<(), StorageError> {
        fs::write(path, fs::read(&self.path)?)?;
        fs::remove_file(&self.path)?;
        held(|held| held.remove(&self.path));
        path.clone_into(&mut self.path);
        held(|held| held.insert(self.path.clone()));
        Ok(())
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Appends bytes.
    ///
    /// # Errors
    /// It was removed.
    pub fn append(&mut self, bytes: &[u8]) -> Result<(), StorageError> {
        Ok(fs::append(&self.path, bytes)?)
    }

    /// The browser keeps it in its own time.
    ///
    /// # Errors
    /// None; elsewhere there are.
    pub fn sync(&self) -> Result<(), StorageError> {
        Ok(())
    }
}

impl Drop for Log {
    fn drop(&mut self) {
        held(|held| held.remove(&self.path));
    }
}

/// A log that an earlier page left.
#[derive(Debug)]
pub struct LeftLog {
    path: PathBuf,
}

impl LeftLog {
    /// Takes hold of a file; `None` where this page uses it. Logs of other pages that are open are not here.
    ///
    /// # Errors
    /// [`StorageError::System`]
    pub fn open(path: &Path) -> Result<Option<Self>, StorageError> {
        fs::metadata(path)?;
        let is_held = held(|held| held.contains(path));
        Ok((!is_held).then(|| Self { path: path.to_owned() }))
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// All that it holds, of at most `limit` bytes.
    ///
    /// # Errors
    /// [`StorageError`]
    pub fn read(&self, limit: u64) -> Result<Vec<u8>, StorageError> {
        super::read(&self.path, limit)
    }

    /// Appends bytes.
    ///
    /// # Errors
    /// It was removed.
    pub fn append(&self, bytes: &[u8]) -> Result<(), StorageError> {
        Ok(fs::append(&self.path, bytes)?)
    }

    /// No signal ends a page.
    #[must_use]
    pub const fn append_when_ended(&self, _: &'static [u8]) -> Option<Unfinished> {
        None
    }

    /// Removes it.
    ///
    /// # Errors
    /// [`StorageError::System`]
    pub fn remove(self) -> Result<(), StorageError> {
        super::remove(&self.path)
    }
}

/// The files of a folder whose names have this ending, the newest first.
#[must_use]
pub fn logs(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut logs = fs::names_in(folder);
    logs.retain(|path| path.to_string_lossy().ends_with(ending));
    logs.reverse();
    logs
}

/// Whole seconds since 1970, in UTC.
#[must_use]
pub fn epoch_seconds() -> u64 {
    since_epoch().as_secs()
}

fn since_epoch() -> std::time::Duration {
    SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default()
}

/// A file that is read in parts.
#[derive(Clone, Debug)]
pub struct Opened(io::Cursor<std::sync::Arc<[u8]>>);

/// Opens a file.
///
/// # Errors
/// [`StorageError::System`]
pub fn open(path: &Path) -> Result<Opened, StorageError> {
    Ok(Opened(io::Cursor::new(fs::read(path)?.into())))
}

impl Opened {
    /// Its length in bytes.
    #[must_use]
    pub fn length(&self) -> u64 {
        self.0.get_ref().len() as u64
    }
}

impl Read for Opened {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.0.read(buffer)
    }
}

impl Seek for Opened {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.0.seek(to)
    }
}

/// Where a path leads.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Place {
    /// Standard input or output: a page has neither.
    Standard,
    /// A stream: a page has none.
    Stream,
    /// A file.
    File(PathBuf),
}

impl Place {
    /// Of a path that is written.
    #[must_use]
    pub fn of_output(path: &Path) -> Self {
        Self::File(super::absolute(path))
    }
}

/// A page has no streams.
#[must_use]
pub const fn is_stream(_: &Path) -> bool {
    false
}

/// A page has no standard streams.
#[must_use]
pub const fn is_standard(_: &Path) -> bool {
    false
}

/// What a file is called.
#[must_use]
pub fn input_name(path: &Path) -> String {
    path.display().to_string()
}

/// What a file is called.
#[must_use]
pub fn output_name(path: &Path) -> String {
    path.display().to_string()
}

/// An entry of a folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Its path.
    pub path: PathBuf,
    /// Its name.
    pub name: String,
}

/// The entries of a folder, at most so many, by name, and how many there are.
///
/// # Errors
/// None; elsewhere there are.
pub fn list(folder: &Path, most: usize) -> Result<(Vec<Entry>, usize), StorageError> {
    let mut paths = fs::names_in(folder);
    let count = paths.len();
    paths.truncate(most);
    let name = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    Ok((paths.into_iter().map(|path| Entry { name: name(&path), path }).collect(), count))
}

/// The absolute form of a path in a folder; `None` where it is not in it.
#[must_use]
pub fn inside(path: &Path, folder: &Path) -> Option<PathBuf> {
    let path = super::absolute(path);
    (super::exists(&path) && path.starts_with(super::absolute(folder))).then_some(path)
}
