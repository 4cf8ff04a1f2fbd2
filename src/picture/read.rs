//! Decoding of PNG files.

use std::io::Cursor;

use image::{ImageError, ImageFormat, ImageReader, Limits};
use thiserror::Error;

use super::Image;
use crate::words::{Message, display_by_message, texts};

/// The longest side of a picture that is read, in pixels.
const LONGEST_SIDE: u32 = 16_384;
/// The most pixels of a picture that is read: those of the largest contact sheet. To compare two such takes some 8 GB.
pub const MOST_PIXELS: u64 = 1 << 26;
/// The bytes of the file up to and including the size: signature, length and name of the first chunk, two sides.
pub const PNG_HEAD_BYTES: usize = 24;

/// Why a PNG could not be read.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum ImageReadError {
    /// It does not begin as a PNG does.
    NotPng,
    /// It has more pixels than are read, or a longer side.
    TooLarge {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    },
    /// It begins as a PNG does, and then is none.
    Damaged,
}

display_by_message!(ImageReadError);

impl ImageReadError {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::NotPng => texts::PICTURE_NOT_PNG.into(),
            Self::TooLarge { width, height } => texts::picture_too_large(*width, *height, LONGEST_SIDE, MOST_PIXELS),
            Self::Damaged => texts::PICTURE_DAMAGED.into(),
        }
    }
}

/// The width and height of a PNG in pixels, out of its first [`PNG_HEAD_BYTES`] bytes.
///
/// # Errors
/// [`ImageReadError`]: these are not the first bytes of a PNG, or it is too large to be read.
pub fn png_size(head: &[u8]) -> Result<[u32; 2], ImageReadError> {
    let sides = head.strip_prefix(b"\x89PNG\r\n\x1a\n").ok_or(ImageReadError::NotPng)?;
    let (name, sides) = sides.get(4..).and_then(<[u8]>::split_first_chunk::<4>).ok_or(ImageReadError::Damaged)?;
    let side = |at: usize| sides.get(at..)?.first_chunk().map(|bytes| u32::from_be_bytes(*bytes));
    match (name, side(0), side(4)) {
        (b"IHDR", Some(width), Some(height)) if width > 0 && height > 0 => {
            let is_too_large = width.max(height) > LONGEST_SIDE || u64::from(width) * u64::from(height) > MOST_PIXELS;
            if is_too_large { Err(ImageReadError::TooLarge { width, height }) } else { Ok([width, height]) }
        }
        _ => Err(ImageReadError::Damaged),
    }
}

impl Image {
    /// The picture in a PNG of any kind, at most 16384 pixels wide and high and 2^26 in all; 16 bits a channel become 8. A picture that is
    /// too large is refused before it is decoded.
    ///
    /// # Errors
    /// [`ImageReadError`]
    pub fn from_png(bytes: &[u8]) -> Result<Self, ImageReadError> {
        let [width, height] = png_size(bytes)?;
        let mut reader = ImageReader::with_format(Cursor::new(bytes), ImageFormat::Png);
        let mut limits = Limits::default();
        // At most 16 bits a channel, and as much again for what is decoded of it at a time.
        limits.max_alloc = Some(16 * u64::from(width) * u64::from(height) + (1 << 20));
        reader.limits(limits);
        let read = reader.decode().map_err(|error| match error {
            ImageError::Limits(_) => ImageReadError::TooLarge { width, height },
            _ => ImageReadError::Damaged,
        })?;
        let read = read.into_rgba8();
        let (width, height) = read.dimensions();
        Ok(Self { width, height, rgba: read.into_raw() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The head of a PNG, with no pixels behind it.
    fn head(width: u32, height: u32) -> Vec<u8> {
        [&b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR"[..], &width.to_be_bytes(), &height.to_be_bytes()].concat()
    }

    #[test]
    fn the_size_is_read_from_the_head_and_bounded_before_anything_is_decoded() {
        assert_eq!(head(1, 1).len(), PNG_HEAD_BYTES);
        assert_eq!(png_size(&head(16_384, 4096)), Ok([16_384, 4096]));
        for (width, height) in [(16_385, 1), (1, 16_385), (16_384, 4097), (u32::MAX, u32::MAX)] {
            let refused = Err(ImageReadError::TooLarge { width, height });
            assert_eq!(png_size(&head(width, height)), refused);
            assert_eq!(Image::from_png(&head(width, height)).map(|_| [0; 2]), refused);
        }
        assert_eq!(png_size(&head(0, 1)), Err(ImageReadError::Damaged));
        assert_eq!(png_size(&head(1, 1)[..20]), Err(ImageReadError::Damaged));
        assert_eq!(png_size(b"GIF89a"), Err(ImageReadError::NotPng));
        assert_eq!(Image::from_png(&head(9, 9)), Err(ImageReadError::Damaged));
    }
}
