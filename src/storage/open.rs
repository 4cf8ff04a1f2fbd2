//! Files that are read in parts.

use std::fs;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use super::StorageError;

/// A regular file that is read in parts. A clone has a position of its own: it opens the file again when it is read.
#[derive(Debug)]
pub struct Opened {
    path: PathBuf,
    file: Option<fs::File>,
    position: u64,
    length: u64,
}

/// Opens a regular file.
///
/// # Errors
/// [`StorageError::System`]
pub fn open(path: &Path) -> Result<Opened, StorageError> {
    // A pipe would block when it is opened.
    let metadata = fs::metadata(path)?;
    if !metadata.is_file() {
        let kind = if metadata.is_dir() { io::ErrorKind::IsADirectory } else { io::ErrorKind::InvalidInput };
        return Err(io::Error::from(kind).into());
    }
    let file = fs::File::open(path)?;
    let length = file.metadata()?.len();
    Ok(Opened { path: path.to_owned(), file: Some(file), position: 0, length })
}

impl Opened {
    /// The length of the file in bytes when it was opened.
    #[must_use]
    pub fn length(&self) -> u64 {
        self.length
    }
}

impl Clone for Opened {
    fn clone(&self) -> Self {
        Self { path: self.path.clone(), file: None, position: self.position, length: self.length }
    }
}

impl Read for Opened {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let file = if let Some(file) = &mut self.file {
            file
        } else {
            let mut file = fs::File::open(&self.path)?;
            file.seek(SeekFrom::Start(self.position))?;
            self.file.insert(file)
        };
        let read = file.read(buffer)?;
        self.position += read as u64;
        Ok(read)
    }
}

impl Seek for Opened {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let place = match to {
            SeekFrom::Start(place) => Some(place),
            SeekFrom::End(offset) => self.length.checked_add_signed(offset),
            SeekFrom::Current(offset) => self.position.checked_add_signed(offset),
        };
        let place = place.ok_or_else(|| io::Error::from(io::ErrorKind::InvalidInput))?;
        if let Some(file) = &mut self.file {
            file.seek(SeekFrom::Start(place))?;
        }
        self.position = place;
        Ok(place)
    }
}
