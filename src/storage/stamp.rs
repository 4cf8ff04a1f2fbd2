//! The state of a file when it was last read or written, to notice changes by other programs.

use std::io::{self, Write};
use std::path::Path;

use sha2::{Digest as _, Sha256};
use web_time::SystemTime;

use super::fs;

/// The SHA-256 of bytes, in hexadecimal digits.
#[must_use]
pub fn sha256(bytes: &[u8]) -> String {
    format!("{:x}", Sha256::digest(bytes))
}

/// The state of a file at one moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stamp {
    /// Its length in bytes.
    length: u64,
    /// The file system's modification time; `None` if it was not read yet.
    modified: Option<SystemTime>,
    /// SHA-256 of its content; `None` if it was not read.
    hash: Option<[u8; 32]>,
}

impl Stamp {
    /// The stamp of a file with these bytes.
    #[must_use]
    pub fn of(path: &Path, bytes: &[u8]) -> Self {
        Self { length: bytes.len() as u64, modified: modified(path), hash: Some(Sha256::digest(bytes).into()) }
    }

    /// The stamp of a regular file whose content is not read; `None` if there is none.
    #[must_use]
    pub fn unread(path: &Path) -> Option<Self> {
        let metadata = fs::metadata(path).ok().filter(fs::Metadata::is_file)?;
        Some(Self { length: metadata.len(), modified: metadata.modified().ok(), hash: None })
    }

    /// The stamp of a regular file, whose content is read; `None` if there is none.
    #[must_use]
    pub fn of_file(path: &Path) -> Option<Self> {
        let unread = Self::unread(path)?;
        Some(Self { hash: hash_of(path).ok(), ..unread })
    }

    /// Whether a file has the same length and time. Cheap: the content is not read.
    #[must_use]
    pub fn looks_same(&self, path: &Path) -> bool {
        fs::metadata(path).is_ok_and(|metadata| metadata.len() == self.length)
            && self.modified.is_some()
            && modified(path) == self.modified
    }

    /// Whether a file has the same content; false if it does not exist. Where the content was never read, length and time decide.
    #[must_use]
    pub fn is_same(&self, path: &Path) -> bool {
        let Some(own) = self.hash else { return self.looks_same(path) };
        let same_length = fs::metadata(path).is_ok_and(|metadata| metadata.is_file() && metadata.len() == self.length);
        same_length && hash_of(path).is_ok_and(|hash| hash == own)
    }
}

/// Passes bytes on and hashes them.
#[derive(Debug)]
pub struct Stamping<W> {
    inner: W,
    length: u64,
    hash: Sha256,
}

impl<W: Write> Stamping<W> {
    /// A writer with no bytes yet.
    pub fn new(inner: W) -> Self {
        Self { inner, length: 0, hash: Sha256::new() }
    }

    /// The inner writer, and the stamp that the file will have.
    pub fn finish(self) -> (W, Stamp) {
        (self.inner, Stamp { length: self.length, modified: None, hash: Some(self.hash.finalize().into()) })
    }
}

impl Stamp {
    /// The same stamp with the file's current time.
    #[must_use]
    pub fn placed_at(self, path: &Path) -> Self {
        Self { modified: modified(path), ..self }
    }
}

impl<W: Write> Write for Stamping<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.inner.write(bytes)?;
        self.hash.update(&bytes[..written]);
        self.length += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.inner.flush()
    }
}

fn modified(path: &Path) -> Option<SystemTime> {
    fs::metadata(path).and_then(|metadata| metadata.modified()).ok()
}

fn hash_of(path: &Path) -> io::Result<[u8; 32]> {
    let mut hash = Sha256::new();
    io::copy(&mut fs::File::open(path)?, &mut hash)?;
    Ok(hash.finalize().into())
}
