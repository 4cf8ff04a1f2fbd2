//! Named files to values, with errors that name the file: scenes, animations, pictures, and results that are written.
//!
//! The rooms above get file names from users or from other files. Errors of [`storage`] do not contain names and
//! parsers know no files; this room adds the names.

mod animation;
mod beginning;
mod error;
mod image;
mod known;
pub mod model;
pub mod poses;
pub mod scene;

pub use animation::{keyframes, keyframes_in};
pub use beginning::{Begun, begun};
pub use error::{FileError, WorkError};
pub use image::{LARGEST_IMAGE_BYTES, image, image_size};
pub use known::{known_at_start, read_known, write_known};

use std::path::Path;

use crate::storage;

/// Reads a file of at most `limit` bytes.
///
/// # Errors
/// [`FileError`]
pub fn read(path: &Path, limit: u64) -> Result<Vec<u8>, FileError> {
    storage::read(path, limit).map_err(|reason| FileError::storage(storage::input_name(path), reason))
}

/// Writes a whole file, as [`storage::write`].
///
/// # Errors
/// [`FileError`]; the file is as it was then.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
    storage::write(path, bytes).map_err(|reason| FileError::storage(storage::output_name(path), reason))
}

/// Makes a folder and those above it, where they are missing.
///
/// # Errors
/// [`FileError`]
pub fn create_folder(path: &Path) -> Result<(), FileError> {
    storage::create_folder(path).map_err(|reason| FileError::storage(path.display(), reason))
}
