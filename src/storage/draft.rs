//! Files that are being written. A regular file is replaced atomically; a device or a pipe is written to directly.

use std::fs::{self, File, Metadata};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use super::StorageError;
use super::destination::{Destination, destination_of};
use crate::unfinished::{self, Unfinished};

/// The prefix of every draft's name.
pub(super) const DRAFT_PREFIX: &str = ".inbetween-";

/// A new file next to the one that it replaces at the end. If it is dropped before, it is removed.
///
/// A device, a pipe or an open descriptor (`/dev/stdout`) is never replaced: it is written to directly.
#[derive(Debug)]
pub struct Draft {
    file: Output,
    is_synced: bool,
}

#[derive(Debug)]
enum Output {
    /// A draft next to a regular file.
    Beside(io::BufWriter<Beside>),
    /// The whole content, kept in memory until the end: the folder allows no new file, so the old file must be overwritten.
    InPlace { content: Vec<u8>, target: PathBuf },
    /// A device or pipe.
    Stream(io::BufWriter<File>),
}

/// A draft with its lock and its target.
#[derive(Debug)]
pub(super) struct Beside {
    draft: NamedTempFile,
    target: PathBuf,
    /// Last, so that it is finished when the draft is removed.
    unfinished: Unfinished,
}

/// The effect of a write on the replaced file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Committed {
    /// The number of other hard links of the replaced file. They keep the old content.
    pub other_links: u64,
}

impl Draft {
    /// An empty draft for a destination. A symbolic link stays a link: its target is replaced, or created if it is missing.
    ///
    /// # Errors
    /// [`StorageError`]: the destination is a folder, is in no folder, is read-only, or the system refuses.
    pub fn new(path: &Path) -> Result<Self, StorageError> {
        let file = match destination_of(path)? {
            Destination::Stream(file) => Output::Stream(io::BufWriter::with_capacity(1 << 16, file)),
            Destination::File { target } => match Beside::new(&target) {
                Ok(beside) => Output::Beside(io::BufWriter::with_capacity(1 << 18, beside)),
                Err(error) if is_folder_closed(&error) && target.exists() => {
                    // Opened now, so that a file that cannot be written is reported before the work.
                    fs::OpenOptions::new().write(true).open(&target)?;
                    Output::InPlace { content: Vec::new(), target }
                }
                Err(error) => return Err(error.into()),
            },
        };
        Ok(Self { file, is_synced: true })
    }

    /// Like [`Draft::new`], without syncing at the end: for pictures that can be made again. A power cut may lose them; a killed program
    /// leaves complete files or none.
    #[must_use]
    pub fn unsynced(self) -> Self {
        Self { is_synced: false, ..self }
    }

    /// Replaces the destination by the draft.
    ///
    /// # Errors
    /// [`StorageError::System`]; a regular file is then unchanged.
    pub fn commit(self) -> Result<(), StorageError> {
        self.put().map(|_| ())
    }

    /// Like [`Draft::commit`]; also returns what became of the replaced file.
    ///
    /// # Errors
    /// [`StorageError::System`]; a regular file is then unchanged.
    pub fn put(self) -> Result<Committed, StorageError> {
        match self.file {
            Output::Stream(mut file) => {
                file.flush()?;
                Ok(Committed::default())
            }
            Output::InPlace { content, target } => {
                let mut file = fs::OpenOptions::new().write(true).open(target)?;
                file.write_all(&content)?;
                file.set_len(content.len() as u64)?;
                file.sync_all()?;
                Ok(Committed::default())
            }
            Output::Beside(file) => {
                Ok(file.into_inner().map_err(io::IntoInnerError::into_error)?.commit(self.is_synced)?)
            }
        }
    }
}

impl io::Write for Draft {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.file {
            Output::Beside(file) => file.write(bytes),
            Output::InPlace { content, .. } => content.write(bytes),
            Output::Stream(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.file {
            Output::Beside(file) => file.flush(),
            Output::InPlace { .. } => Ok(()),
            Output::Stream(file) => file.flush(),
        }
    }
}

/// A new file that another program writes, next to the one that it replaces at the end, or in the folder of temporary files where a stream
/// gets its content at the end. If it is dropped before, it is removed.
#[derive(Debug)]
pub struct Foreign(ForeignOutput);

#[derive(Debug)]
enum ForeignOutput {
    Beside(Beside),
    /// Programs go back in what they write, which no stream allows.
    Stream(Beside, File),
}

impl Foreign {
    /// An empty draft for a destination.
    ///
    /// # Errors
    /// [`StorageError`]: the destination is a folder, is in no folder, is read-only, or the system refuses.
    pub fn new(path: &Path) -> Result<Self, StorageError> {
        Ok(Self(match destination_of(path)? {
            Destination::Stream(stream) => {
                ForeignOutput::Stream(Beside::new(&std::env::temp_dir().join("stream"))?, stream)
            }
            Destination::File { target } => ForeignOutput::Beside(Beside::new(&target)?),
        }))
    }

    /// The path to which the other program writes: an empty file.
    #[must_use]
    pub fn path(&self) -> &Path {
        match &self.0 {
            ForeignOutput::Beside(beside) | ForeignOutput::Stream(beside, _) => beside.draft.path(),
        }
    }

    /// Replaces the destination by the draft, or writes it to the stream.
    ///
    /// # Errors
    /// [`StorageError::System`]; a regular file is then unchanged.
    pub fn commit(self) -> Result<(), StorageError> {
        match self.0 {
            ForeignOutput::Beside(beside) => Ok(beside.commit(true).map(|_| ())?),
            ForeignOutput::Stream(beside, mut stream) => {
                io::copy(&mut File::open(beside.draft.path())?, &mut stream)?;
                Ok(())
            }
        }
    }
}

impl Beside {
    /// A locked, empty draft. Removes drafts of killed programs for the same destination: they have no lock.
    fn new(target: &Path) -> io::Result<Self> {
        let folder = folder_of(target);
        let prefix = draft_prefix(target);
        remove_leftovers(folder, &prefix);
        loop {
            let hold = unfinished::hold();
            let draft = builder(&prefix).tempfile_in(folder)?;
            let path = draft.path().to_owned();
            let unfinished = hold.begin(move || {
                let _ = fs::remove_file(path);
            });
            // Without locks in the file system a draft is not protected while it is written.
            let _ = draft.as_file().try_lock();
            // Another program may have removed the draft as a leftover before it was locked.
            if draft.path().exists() {
                return Ok(Self { draft, target: target.to_owned(), unfinished });
            }
        }
    }

    fn commit(self, is_synced: bool) -> io::Result<Committed> {
        let Self { draft, target, unfinished } = self;
        let old = fs::metadata(&target).ok();
        if let Some(old) = &old {
            take_over(draft.as_file(), old)?;
        }
        if is_synced {
            draft.as_file().sync_all()?;
        }
        let hold = unfinished::hold();
        let persisted = draft.persist(&target);
        drop(hold);
        drop(unfinished);
        persisted.map_err(|error| error.error)?;
        if is_synced {
            sync_folder(folder_of(&target));
        }
        Ok(Committed { other_links: old.as_ref().map_or(0, other_links) })
    }
}

impl io::Write for Beside {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.draft.as_file_mut().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.draft.as_file_mut().flush()
    }
}

/// The folder of a file, as a path that can be opened.
pub(super) fn folder_of(target: &Path) -> &Path {
    match target.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// The prefix of all drafts for a destination. It has a hash of the name, because a name may already have 255 bytes.
fn draft_prefix(target: &Path) -> String {
    use sha2::Digest as _;
    let name = target.file_name().unwrap_or_default();
    let hash = sha2::Sha256::digest(name.as_encoded_bytes());
    format!("{DRAFT_PREFIX}{:02x}{:02x}{:02x}{:02x}-", hash[0], hash[1], hash[2], hash[3])
}

/// Creates drafts with the mode that the umask gives a new file.
fn builder(prefix: &str) -> tempfile::Builder<'_, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(prefix).rand_bytes(12);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt as _;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder
}

/// Removes drafts without a lock. Errors are ignored: a leftover does no harm.
fn remove_leftovers(folder: &Path, prefix: &str) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.filter_map(Result::ok) {
        let is_draft = entry.file_name().as_encoded_bytes().starts_with(prefix.as_bytes());
        if is_draft
            && let Ok(file) = File::open(entry.path())
            && file.try_lock().is_ok()
        {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// Gives a draft the mode and the owner of the file that it replaces.
#[cfg(unix)]
fn take_over(draft: &File, old: &Metadata) -> io::Result<()> {
    use std::os::unix::fs::MetadataExt as _;
    let new = draft.metadata()?;
    if (new.uid(), new.gid()) != (old.uid(), old.gid()) {
        // Only root can change the owner. For others the new file is their own, as with every editor that renames.
        let _ = std::os::unix::fs::fchown(draft, Some(old.uid()), Some(old.gid()));
    }
    draft.set_permissions(old.permissions())
}

#[cfg(not(unix))]
fn take_over(_: &File, _: &Metadata) -> io::Result<()> {
    Ok(())
}

#[cfg(unix)]
fn other_links(old: &Metadata) -> u64 {
    use std::os::unix::fs::MetadataExt as _;
    old.nlink().saturating_sub(1)
}

#[cfg(not(unix))]
fn other_links(_: &Metadata) -> u64 {
    0
}

/// Syncs the folder so that a rename survives a power cut. Errors are ignored: some systems cannot sync folders.
fn sync_folder(folder: &Path) {
    if let Ok(folder) = File::open(folder) {
        let _ = folder.sync_all();
    }
}

/// Whether a folder allows no new file, so that a file in it can only be overwritten.
fn is_folder_closed(error: &io::Error) -> bool {
    matches!(error.kind(), io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem)
}
