//! A finished picture on the CPU, and PNG encoding and decoding.
//!
//! Pixels and bytes only: this module does not draw or open files.

mod mean;
mod read;

use std::io::Write;

pub use mean::PictureSum;
pub use read::{ImageReadError, MOST_PIXELS, PNG_HEAD_BYTES, png_size};
pub(crate) use read::{decode_png, rgba_of};

/// Rows of pixels from the top, tightly packed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Red, green, blue in sRGB and opacity, 8 bits each.
    pub rgba: Vec<u8>,
}

impl Image {
    /// The red, green, blue and opacity of one pixel, counted from the top left corner; `None` outside.
    #[must_use]
    pub fn pixel(&self, x: u32, y: u32) -> Option<[u8; 4]> {
        if x >= self.width || y >= self.height {
            return None;
        }
        let start = 4 * (y as usize * self.width as usize + x as usize);
        self.rgba.get(start..start + 4)?.try_into().ok()
    }

    /// The picture as a PNG: [`Rows::to_png`].
    ///
    /// # Errors
    ///
    /// [`png::EncodingError`] if the sides and the bytes do not agree, or a side is 0.
    pub fn to_png(&self) -> Result<Vec<u8>, png::EncodingError> {
        self.rows().to_png()
    }

    /// Replaces the pixels from `[left, top]` on by a picture that lies within this one.
    pub(crate) fn paste(&mut self, [left, top]: [u32; 2], picture: &Rows<'_>) {
        for (y, row) in (top as usize..).zip(picture.rows()) {
            let start = 4 * (y * self.width as usize + left as usize);
            self.rgba[start..start + row.len()].copy_from_slice(row);
        }
    }

    /// The picture as borrowed rows.
    #[must_use]
    pub fn rows(&self) -> Rows<'_> {
        let row_bytes = 4 * self.width as usize;
        Rows { width: self.width, height: self.height, row_bytes, bytes: &self.rgba }
    }
}

/// Borrowed rows of pixels from the top, each padded to `row_bytes`.
#[derive(Clone, Copy, Debug)]
pub struct Rows<'a> {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Bytes from a row's start to the next one's.
    pub row_bytes: usize,
    /// Four a pixel: red, green, blue in sRGB and opacity.
    pub bytes: &'a [u8],
}

impl Rows<'_> {
    fn rows(&self) -> impl Iterator<Item = &[u8]> {
        self.bytes.chunks(self.row_bytes.max(1)).map(|row| &row[..row.len().min(4 * self.width as usize)])
    }

    /// The rows, tightly packed.
    #[must_use]
    pub fn to_image(&self) -> Image {
        let mut rgba = Vec::with_capacity(4 * self.width as usize * self.height as usize);
        self.rows().for_each(|row| rgba.extend_from_slice(row));
        Image { width: self.width, height: self.height, rgba }
    }

    /// Packs the pixels tightly, three bytes each if all are opaque, otherwise four. Returns whether all are.
    pub(crate) fn pack(&self, packed: &mut Vec<u8>) -> bool {
        packed.resize(3 * self.width as usize * self.height as usize, 0);
        let (mut least_opacity, mut read) = (u8::MAX, 0);
        for row in self.rows() {
            let pixels = row.as_chunks::<4>().0;
            let outputs = packed.as_chunks_mut::<3>().0.iter_mut().skip(read);
            for (output, &[red, green, blue, opacity]) in outputs.zip(pixels) {
                *output = [red, green, blue];
                least_opacity = least_opacity.min(opacity);
            }
            read += pixels.len();
        }
        // The encoder reports a wrong number of rows.
        packed.resize(3 * read, 0);
        let is_opaque = least_opacity == u8::MAX;
        if !is_opaque {
            packed.clear();
            self.rows().for_each(|row| packed.extend_from_slice(row));
        }
        is_opaque
    }

    /// The picture as a PNG: 8 bits a channel, not interlaced, marked as sRGB; without an alpha channel if all is opaque. The same picture
    /// always gives the same bytes.
    ///
    /// # Errors
    ///
    /// [`png::EncodingError`] if the sides and the bytes do not agree, or a side is 0.
    pub fn to_png(&self) -> Result<Vec<u8>, png::EncodingError> {
        let mut memory = PngMemory::default();
        self.to_png_in(&mut memory)?;
        Ok(memory.into_png())
    }

    /// Like [`Rows::to_png`], but reuses the memory of `memory`.
    ///
    /// # Errors
    ///
    /// As [`Rows::to_png`].
    pub fn to_png_in<'a>(&self, memory: &'a mut PngMemory) -> Result<&'a [u8], png::EncodingError> {
        let PngMemory { packed, bytes } = memory;
        let is_opaque = self.pack(packed);
        let pixels = self.width as usize * self.height as usize;
        bytes.clear();
        bytes.reserve(PngMemory::usual_bytes(pixels));
        let mut encoder = png::Encoder::new(&mut *bytes, self.width, self.height);
        set_up_png(&mut encoder, is_opaque);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(packed)?;
        writer.finish()?;
        Ok(bytes)
    }
}

/// Memory for encoding PNGs one after the other. Allocating it anew takes a quarter of the encoding time, because the system provides each
/// page on its first write.
#[derive(Debug, Default)]
pub struct PngMemory {
    packed: Vec<u8>,
    bytes: Vec<u8>,
}

impl PngMemory {
    /// Memory for pictures of this size. All pages are written to once.
    #[must_use]
    pub fn new(width: u32, height: u32) -> Self {
        let pixels = width as usize * height as usize;
        // Not zeros: an allocator provides those without writing to the pages.
        Self { packed: vec![1; 3 * pixels], bytes: vec![1; Self::usual_bytes(pixels)] }
    }

    /// The PNG that was made in it last.
    #[must_use]
    pub fn png(&self) -> &[u8] {
        &self.bytes
    }

    /// The PNG that was made in it last.
    #[must_use]
    pub fn into_png(self) -> Vec<u8> {
        self.bytes
    }

    /// An upper estimate of a PNG's bytes.
    fn usual_bytes(pixels: usize) -> usize {
        3 * pixels / 4 + 1024
    }
}

/// The settings for all PNGs, single pictures and films: 8 bits a channel, marked as sRGB; without an alpha channel if all is opaque.
pub fn set_up_png<W: Write>(encoder: &mut png::Encoder<'_, W>, is_opaque: bool) {
    encoder.set_color(if is_opaque { png::ColorType::Rgb } else { png::ColorType::Rgba });
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    // An adaptive filter and Paeth's filter take longer and give no smaller files.
    encoder.set_filter(png::Filter::Sub);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_that_is_kept_leaves_nothing_of_one_png_in_the_next() {
        let image = |width: u32, height: u32, opacity: u8| {
            let pixel = |index: u32| [index as u8, (index / 7) as u8, 90, opacity];
            Image { width, height, rgba: (0..width * height).flat_map(pixel).collect() }
        };
        let mut memory = PngMemory::new(8, 8);
        for image in [image(30, 20, 255), image(30, 20, 40), image(5, 3, 255), image(64, 31, 0), image(30, 20, 255)] {
            assert_eq!(image.rows().to_png_in(&mut memory).expect("a PNG"), image.to_png().expect("a PNG"));
        }
    }
}
