//! Files that only grow, private and locked as long as a program uses them.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, SystemTime};

use super::StorageError;
use crate::unfinished::{self, Unfinished};

/// What is appended reaches the disk within a second: this long after the first of it, and however long the disk takes.
const SYNC_DELAY: Duration = Duration::from_millis(500);

/// A file that this program appends to and no other.
#[derive(Debug)]
pub struct Log {
    file: Arc<File>,
    path: PathBuf,
    syncing: Arc<Syncing>,
    thread: Option<JoinHandle<()>>,
    /// Until it has its own name.
    unfinished: Option<Unfinished>,
}

#[derive(Debug, Default)]
struct Syncing {
    wanted: Mutex<Wanted>,
    changed: Condvar,
}

#[derive(Debug, Default)]
struct Wanted {
    is_dirty: bool,
    is_over: bool,
}

impl Log {
    /// A new file in a folder, which is made where it is missing, for its owner alone. `ending` ends the name, which begins with the
    /// time.
    ///
    /// # Errors
    /// [`StorageError::System`]
    pub fn create_in(folder: &Path, ending: &str) -> Result<Self, StorageError> {
        create_private_folder(folder)?;
        // Two journals of one second keep their order.
        let prefix = format!("{}-", since_epoch().as_micros());
        let file =
            tempfile::Builder::new().prefix(&prefix).suffix(ending).rand_bytes(8).append(true).tempfile_in(folder)?;
        let (file, path) = file.keep().map_err(|error| error.error)?;
        // Whoever looks at it at this moment lets go of it at once. Where the file system has no locks, it is unprotected.
        let _ = file.lock();
        Ok(Self::of(file, path))
    }

    /// A file of this name, emptied where `may_replace` says so of what it holds.
    ///
    /// # Errors
    /// [`StorageError`]: another program uses it, it may not be replaced, or the system refuses.
    pub fn create(path: &Path, may_replace: impl FnOnce(&[u8]) -> bool) -> Result<Self, StorageError> {
        let mut options = OpenOptions::new();
        options.read(true).append(true).create(true);
        #[cfg(unix)]
        std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
        let mut file = options.open(path)?;
        if matches!(file.try_lock(), Err(TryLockError::WouldBlock)) {
            return Err(StorageError::InUse);
        }
        let mut start = Vec::new();
        (&mut file).take(256).read_to_end(&mut start)?;
        if !start.is_empty() && !may_replace(&start) {
            return Err(io::Error::from(io::ErrorKind::AlreadyExists).into());
        }
        file.set_len(0)?;
        Ok(Self::of(file, path.to_owned()))
    }

    /// A new file that is to take the place of `path`, beside it; `None` where that is a device or a pipe.
    ///
    /// # Errors
    /// [`StorageError::System`]
    pub fn create_for(path: &Path) -> Result<Option<Self>, StorageError> {
        let target = super::destination::followed(path)?;
        if super::is_stream(&target) {
            return Ok(None);
        }
        let hold = unfinished::hold();
        let mut builder = tempfile::Builder::new();
        builder.prefix(super::draft::DRAFT_PREFIX).rand_bytes(12).append(true);
        let file = builder.tempfile_in(super::draft::folder_of(&target))?;
        let (file, path) = file.keep().map_err(|error| error.error)?;
        let _ = file.lock();
        let left = path.clone();
        let unfinished = hold.begin(move || {
            let _ = fs::remove_file(left);
        });
        let mut log = Self::of(file, path);
        log.unfinished = Some(unfinished);
        Ok(Some(log))
    }

    /// Takes the place of a file, once the disk has all that was appended.
    ///
    /// # Errors
    /// [`StorageError::System`]; the other file is then unchanged, and this one goes.
    pub fn take_place_of(&mut self, path: &Path) -> Result<(), StorageError> {
        let moved = self.sync().and_then(|()| Ok(fs::rename(&self.path, super::destination::followed(path)?)?));
        self.unfinished = None;
        match moved {
            Ok(()) => path.clone_into(&mut self.path),
            Err(_) => super::remove(&self.path)?,
        }
        moved
    }

    fn of(file: File, path: PathBuf) -> Self {
        let file = Arc::new(file);
        let syncing = Arc::new(Syncing::default());
        let (synced, by) = (Arc::clone(&file), Arc::clone(&syncing));
        // Without the thread the system writes in its own time.
        let thread = std::thread::Builder::new().name("journal".to_owned()).spawn(move || by.run(&synced)).ok();
        Self { file, path, syncing, thread, unfinished: None }
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Hands bytes to the system, in one write.
    ///
    /// # Errors
    /// [`StorageError::System`]
    pub fn append(&mut self, bytes: &[u8]) -> Result<(), StorageError> {
        (&*self.file).write_all(bytes)?;
        let mut wanted = self.syncing.wanted.lock().unwrap_or_else(PoisonError::into_inner);
        if !std::mem::replace(&mut wanted.is_dirty, true) {
            self.syncing.changed.notify_one();
        }
        Ok(())
    }

    /// Waits until the disk has all that was appended.
    ///
    /// # Errors
    /// [`StorageError::System`]
    pub fn sync(&self) -> Result<(), StorageError> {
        Ok(self.file.sync_data()?)
    }
}

impl Drop for Log {
    fn drop(&mut self) {
        self.syncing.wanted.lock().unwrap_or_else(PoisonError::into_inner).is_over = true;
        self.syncing.changed.notify_one();
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

impl Syncing {
    /// Sleeps as long as nothing is appended.
    fn run(&self, file: &File) {
        let lock = || self.wanted.lock().unwrap_or_else(PoisonError::into_inner);
        loop {
            let idle = self.changed.wait_while(lock(), |wanted| !wanted.is_dirty && !wanted.is_over);
            drop(idle.unwrap_or_else(PoisonError::into_inner));
            let more = self.changed.wait_timeout_while(lock(), SYNC_DELAY, |wanted| !wanted.is_over);
            let mut wanted = more.unwrap_or_else(PoisonError::into_inner).0;
            let (is_dirty, is_over) = (std::mem::take(&mut wanted.is_dirty), wanted.is_over);
            drop(wanted);
            if is_dirty {
                // What the disk refuses is refused at the next write.
                let _ = file.sync_data();
            }
            if is_over {
                return;
            }
        }
    }
}

/// A file that another program left, held so that nobody else takes it.
#[derive(Debug)]
pub struct LeftLog {
    file: File,
    path: PathBuf,
}

impl LeftLog {
    /// Takes hold of a file; `None` where a program uses it.
    ///
    /// # Errors
    /// [`StorageError::System`]
    pub fn open(path: &Path) -> Result<Option<Self>, StorageError> {
        let file = OpenOptions::new().read(true).append(true).open(path)?;
        match file.try_lock() {
            // It may have been removed before it was locked.
            Ok(()) if path.exists() => Ok(Some(Self { file, path: path.to_owned() })),
            Ok(()) | Err(TryLockError::WouldBlock) => Ok(None),
            Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => {
                Ok(Some(Self { file, path: path.to_owned() }))
            }
            Err(TryLockError::Error(error)) => Err(error.into()),
        }
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
        use std::io::Seek as _;
        (&self.file).rewind()?;
        let length = self.file.metadata()?.len();
        super::read_stream(&self.file, limit, length.min(limit))
    }

    /// Appends bytes, and waits until the disk has them.
    ///
    /// # Errors
    /// [`StorageError::System`]
    pub fn append(&self, bytes: &[u8]) -> Result<(), StorageError> {
        (&self.file).write_all(bytes)?;
        Ok(self.file.sync_data()?)
    }

    /// Appends bytes if a signal ends the program before what this returns is dropped.
    #[must_use]
    pub fn append_when_ended(&self, bytes: &'static [u8]) -> Option<Unfinished> {
        let file = self.file.try_clone().ok()?;
        Some(unfinished::hold().begin(move || {
            // What cannot be written is taken for an ending by the last line.
            let _ = (&file).write_all(bytes);
        }))
    }

    /// Removes it.
    ///
    /// # Errors
    /// [`StorageError::System`]
    pub fn remove(self) -> Result<(), StorageError> {
        super::remove(&self.path)
    }
}

/// The files of a folder whose names have this ending, the newest first; none where there is no folder.
#[must_use]
pub fn logs(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let paths = entries.filter_map(Result::ok).map(|entry| entry.path());
    let mut logs: Vec<PathBuf> = paths.filter(|path| path.to_string_lossy().ends_with(ending)).collect();
    // Their names begin with the time, which has as many digits for centuries.
    logs.sort_unstable_by(|a, b| b.cmp(a));
    logs
}

/// The folder for what a program keeps of its runs; `None` where the system has no place for it.
#[must_use]
pub fn state_folder() -> Option<PathBuf> {
    use etcetera::BaseStrategy as _;
    let folders = etcetera::base_strategy::choose_native_strategy().ok()?;
    Some(folders.state_dir().unwrap_or_else(|| folders.data_dir()).join("inbetween"))
}

/// What a predicate says of the first bytes of a file, at most 256; `false` where it cannot be read. A pipe is not read.
#[must_use]
pub fn begins_with(path: &Path, is_meant: impl FnOnce(&[u8]) -> bool) -> bool {
    let mut start = Vec::new();
    let is_file = fs::metadata(path).is_ok_and(|metadata| metadata.is_file());
    let read = File::open(path).ok().filter(|_| is_file).map(|file| file.take(256).read_to_end(&mut start));
    matches!(read, Some(Ok(_))) && is_meant(&start)
}

/// Whole seconds since 1970, in UTC.
#[must_use]
pub fn epoch_seconds() -> u64 {
    since_epoch().as_secs()
}

fn since_epoch() -> Duration {
    SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default()
}

fn create_private_folder(folder: &Path) -> io::Result<()> {
    let mut builder = fs::DirBuilder::new();
    builder.recursive(true);
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.create(folder)
}
