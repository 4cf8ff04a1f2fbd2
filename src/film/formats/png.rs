//! PNG: single pictures, every colour and opacity as drawn.

use super::{MOST_FRAMES_PER_SECOND, no_limit};
use crate::film::{Encoder, EncodingError, Format, StillEncoder};
use crate::picture::{PngMemory, Rows};

/// PNG: lossless, with opacity.
pub static PNG: Format = Format {
    name: "PNG",
    ending: "png",
    has_opacity: true,
    usual_frames_per_second: 30,
    most_frames_per_second: MOST_FRAMES_PER_SECOND,
    limit: no_limit,
    encoder: Encoder::Still(|size| {
        Box::new(size.map_or_else(PngMemory::default, |[width, height]| PngMemory::new(width, height)))
    }),
};

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
