//! Decoding of PNG files.

use std::io::Cursor;

use image::{ImageFormat, ImageReader, Limits};
use thiserror::Error;

use super::Image;

/// The longest side of a picture that is read, in pixels.
const LONGEST_SIDE: u32 = 16_384;

/// Why a PNG could not be read.
#[derive(Debug, Error)]
#[error("no picture can be read: {reason}")]
pub struct ImageReadError {
    /// The decoder's reason.
    reason: String,
}

impl Image {
    /// The picture in a PNG of any kind, at most 16384 pixels wide and high; 16 bits a channel become 8.
    ///
    /// # Errors
    /// [`ImageReadError`]
    pub fn from_png(bytes: &[u8]) -> Result<Self, ImageReadError> {
        let mut reader = ImageReader::with_format(Cursor::new(bytes), ImageFormat::Png);
        let mut limits = Limits::default();
        limits.max_image_width = Some(LONGEST_SIDE);
        limits.max_image_height = Some(LONGEST_SIDE);
        limits.max_alloc = Some(2 << 30);
        reader.limits(limits);
        let read = reader.decode().map_err(|error| ImageReadError { reason: error.to_string() })?.into_rgba8();
        let (width, height) = read.dimensions();
        Ok(Self { width, height, rgba: read.into_raw() })
    }
}
