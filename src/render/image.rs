//! A finished picture on the CPU, and its PNG.

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

    /// The picture as a PNG: 8 bits a channel, not interlaced, marked as sRGB; without an alpha channel where all is opaque.
    /// The same picture always gives the same bytes.
    ///
    /// # Errors
    ///
    /// [`png::EncodingError`] where the sides and the bytes do not agree, or a side is 0.
    pub fn to_png(&self) -> Result<Vec<u8>, png::EncodingError> {
        let opaque = self.rgba.chunks_exact(4).all(|pixel| pixel[3] == u8::MAX);
        let mut bytes = Vec::with_capacity(self.rgba.len() / 8 + 1024);
        let mut encoder = png::Encoder::new(&mut bytes, self.width, self.height);
        encoder.set_color(if opaque { png::ColorType::Rgb } else { png::ColorType::Rgba });
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::Fast);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let mut writer = encoder.write_header()?;
        if opaque {
            let mut rgb = Vec::with_capacity(self.rgba.len() / 4 * 3);
            for pixel in self.rgba.chunks_exact(4) {
                rgb.extend_from_slice(&pixel[..3]);
            }
            writer.write_image_data(&rgb)?;
        } else {
            writer.write_image_data(&self.rgba)?;
        }
        writer.finish()?;
        Ok(bytes)
    }
}
