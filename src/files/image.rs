//! Pictures in PNG files.

use std::path::Path;

use super::FileError;
use crate::render::Image;

/// The largest PNG that is read: 1 GiB.
pub const LARGEST_IMAGE_BYTES: u64 = 1 << 30;

/// Reads a PNG.
///
/// # Errors
/// [`FileError`]
pub fn image(path: &Path) -> Result<Image, FileError> {
    let bytes = super::read(path, LARGEST_IMAGE_BYTES)?;
    Image::from_png(&bytes).map_err(|error| FileError::new(path.display(), error))
}
