//! What a file held when it was last read or written, to notice that another program has changed it.

use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::time::SystemTime;

use sha2::{Digest as _, Sha256};

/// What a file held at some moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stamp {
    /// Its length in bytes.
    length: u64,
    /// When it was changed last, as far as the file system says; `None`: not asked for yet.
    modified: Option<SystemTime>,
    /// SHA-256 of its content.
    hash: [u8; 32],
}

impl Stamp {
    /// The stamp of a file that holds these bytes.
    #[must_use]
    pub fn of(path: &Path, bytes: &[u8]) -> Self {
        Self { length: bytes.len() as u64, modified: modified(path), hash: Sha256::digest(bytes).into() }
    }

    /// Whether a file looks like this: the same length and time. Cheap: nothing is read.
    #[must_use]
    pub fn looks_same(&self, path: &Path) -> bool {
        fs::metadata(path).is_ok_and(|metadata| metadata.len() == self.length)
            && self.modified.is_some()
            && modified(path) == self.modified
    }

    /// Whether a file holds these very bytes; a file that is gone does not.
    #[must_use]
    pub fn is_same(&self, path: &Path) -> bool {
        let same_length = fs::metadata(path).is_ok_and(|metadata| metadata.is_file() && metadata.len() == self.length);
        same_length && hash_of(path).is_ok_and(|hash| hash == self.hash)
    }
}

/// Passes bytes on, and remembers what they were.
#[derive(Debug)]
pub struct Stamping<W> {
    inner: W,
    length: u64,
    hash: Sha256,
}

impl<W: Write> Stamping<W> {
    /// Nothing has been written.
    pub fn new(inner: W) -> Self {
        Self { inner, length: 0, hash: Sha256::new() }
    }

    /// Where the bytes went, and the stamp that a file at `path` will have once they are there.
    pub fn finish(self) -> (W, Stamp) {
        (self.inner, Stamp { length: self.length, modified: None, hash: self.hash.finalize().into() })
    }
}

impl Stamp {
    /// The same with the time that the file has now.
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
