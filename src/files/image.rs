//! Pictures in PNG files.

use std::path::Path;

use super::FileError;
use crate::picture::{PNG_HEAD_BYTES, png_size};
use crate::render::Image;
use crate::storage;

/// The largest PNG that is read: 1 GiB.
pub const LARGEST_IMAGE_BYTES: u64 = 1 << 30;

/// Reads a PNG. One that is too large is refused by its head, before the rest is read.
///
/// # Errors
/// [`FileError`]
pub fn image(path: &Path) -> Result<Image, FileError> {
    image_size(path)?;
    let bytes = super::read(path, LARGEST_IMAGE_BYTES)?;
    Image::from_png(&bytes).map_err(|error| FileError::new(storage::input_name(path), error))
}

/// The width and height of a PNG in pixels, of which only the head is read; `None` for standard input or a pipe, which can be read once
/// only.
///
/// # Errors
/// [`FileError`]: it is no PNG, or too large to be read.
pub fn image_size(path: &Path) -> Result<Option<[u32; 2]>, FileError> {
    if storage::is_stream(path) {
        return Ok(None);
    }
    let head = storage::read_head(path, PNG_HEAD_BYTES).map_err(|reason| FileError::storage(path.display(), reason))?;
    png_size(&head).map(Some).map_err(|error| FileError::new(path.display(), error))
}
