//! PNG: single pictures, every colour and opacity as drawn.

use super::{MOST_FRAMES_PER_SECOND, no_limit};
use crate::film::{Encoder, EncodingError, Format, StillEncoder, StillFormat};
use crate::picture::{Image, PngMemory, Rows};

/// PNG: lossless, with opacity.
pub static PNG: Format = Format {
    name: "PNG",
    ending: "png",
    has_opacity: true,
    usual_frames_per_second: 30,
    most_frames_per_second: MOST_FRAMES_PER_SECOND,
    limit: no_limit,
    encoder: Encoder::Still(StillFormat {
        start: |size| Box::new(size.map_or_else(PngMemory::default, |[width, height]| PngMemory::new(width, height))),
        decode,
    }),
};

/// The last chunk. A decoder stops at the last pixel, before it.
const END: [u8; 12] = *b"\0\0\0\0IEND\xae\x42\x60\x82";

fn decode(bytes: &[u8]) -> Option<Image> {
    bytes.ends_with(&END).then(|| Image::from_png(bytes).ok())?
}

impl StillEncoder for PngMemory {
    fn encode(&mut self, rows: &Rows<'_>) -> Result<(), EncodingError> {
        rows.to_png_in(self)?;
        Ok(())
    }

    fn bytes(&self) -> &[u8] {
        self.png()
    }

    fn into_bytes(self: Box<Self>) -> Vec<u8> {
        self.into_png()
    }
}
