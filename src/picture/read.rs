//! Decoding of PNG files.

use std::io::Cursor;

use png::{BitDepth, Decoder, DecodingError, Limits, Transformations};
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
        // At most 16 bits a channel, and as much again for what is decoded of it at a time.
        let limit = 16 * u64::from(width) * u64::from(height) + (1 << 20);
        let read = decode_png(bytes, usize::try_from(limit).unwrap_or(usize::MAX)).map_err(|error| match error {
            DecodingError::LimitsExceeded => ImageReadError::TooLarge { width, height },
            _ => ImageReadError::Damaged,
        })?;
        Ok(read)
    }
}

/// The picture in a PNG of any kind, whose decoder takes at most `limit` bytes of memory. Of 16 bits a channel the nearest 8 are kept.
pub(crate) fn decode_png(bytes: &[u8], limit: usize) -> Result<Image, DecodingError> {
    let mut decoder = Decoder::new_with_limits(Cursor::new(bytes), Limits { bytes: limit });
    decoder.set_transformations(Transformations::EXPAND);
    let mut reader = decoder.read_info()?;
    let mut pixels = vec![0; reader.output_buffer_size().ok_or(DecodingError::LimitsExceeded)?];
    let info = reader.next_frame(&mut pixels)?;
    pixels.truncate(info.buffer_size());
    if info.bit_depth == BitDepth::Sixteen {
        let nearest = |pair: &[u8; 2]| ((u32::from(u16::from_be_bytes(*pair)) + 128) / 257) as u8;
        pixels = pixels.as_chunks().0.iter().map(nearest).collect();
    }
    let rgba = rgba_of(&pixels, info.color_type.samples());
    Ok(Image { width: info.width, height: info.height, rgba })
}

/// Pixels of four channels out of pixels of one (grey), two (grey, opacity), three (red, green, blue) or four.
pub(crate) fn rgba_of(pixels: &[u8], channels: usize) -> Vec<u8> {
    let rgba = |pixel: &[u8]| match *pixel {
        [grey] => [grey, grey, grey, u8::MAX],
        [grey, opacity] => [grey, grey, grey, opacity],
        [red, green, blue] => [red, green, blue, u8::MAX],
        _ => [pixel[0], pixel[1], pixel[2], pixel[3]],
    };
    pixels.chunks_exact(channels).flat_map(rgba).collect()
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

    /// A PNG of 2x1 pixels.
    fn png(colour: png::ColorType, depth: BitDepth, data: &[u8], palette: Option<&[u8]>) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, 2, 1);
        encoder.set_color(colour);
        encoder.set_depth(depth);
        if let Some(palette) = palette {
            encoder.set_palette(palette.to_vec());
            encoder.set_trns(vec![255, 9]);
        }
        encoder.write_header().and_then(|mut writer| writer.write_image_data(data)).expect("it is written");
        bytes
    }

    #[test]
    fn every_kind_of_png_becomes_four_channels_of_eight_bits() {
        use BitDepth::{Eight, One, Sixteen};
        use png::ColorType::{Grayscale, GrayscaleAlpha, Indexed, Rgb, Rgba};
        #[track_caller]
        fn check(colour: png::ColorType, depth: BitDepth, data: &[u8], palette: Option<&[u8]>, expected: [u8; 8]) {
            let read = Image::from_png(&png(colour, depth, data, palette)).expect("it can be read");
            assert_eq!((read.width, read.height, &read.rgba[..]), (2, 1, &expected[..]));
        }
        check(Grayscale, One, &[0b0100_0000], None, [0, 0, 0, 255, 255, 255, 255, 255]);
        check(Grayscale, Eight, &[7, 8], None, [7, 7, 7, 255, 8, 8, 8, 255]);
        check(GrayscaleAlpha, Eight, &[7, 1, 8, 2], None, [7, 7, 7, 1, 8, 8, 8, 2]);
        check(Indexed, One, &[0b0100_0000], Some(&[1, 2, 3, 4, 5, 6]), [1, 2, 3, 255, 4, 5, 6, 9]);
        check(Rgb, Eight, &[1, 2, 3, 4, 5, 6], None, [1, 2, 3, 255, 4, 5, 6, 255]);
        check(Rgba, Eight, &[1, 2, 3, 4, 5, 6, 7, 8], None, [1, 2, 3, 4, 5, 6, 7, 8]);
        // 0x0080 is nearer to 0 than to 257, 0x0081 is not; 0xfefe is 254 exactly.
        check(Grayscale, Sixteen, &[0x00, 0x80, 0x00, 0x81], None, [0, 0, 0, 255, 1, 1, 1, 255]);
        check(Grayscale, Sixteen, &[0xfe, 0xfe, 0xff, 0xff], None, [254, 254, 254, 255, 255, 255, 255, 255]);
    }
}
