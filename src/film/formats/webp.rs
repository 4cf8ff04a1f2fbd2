//! WebP: single pictures, lossless, every colour and opacity as drawn.

use image::ExtendedColorType;
use image::codecs::webp::WebPEncoder;

use super::MOST_FRAMES_PER_SECOND;
use crate::film::{Encoder, EncodingError, Format, StillEncoder};
use crate::picture::Rows;
use crate::words::texts;

/// The longest side in pixels: the format has 14 bits for it.
const LONGEST_SIDE: u32 = 16_384;

/// WebP: lossless, with opacity.
pub static WEBP: Format = Format {
    name: "WebP",
    ending: "webp",
    has_opacity: true,
    usual_frames_per_second: 30,
    most_frames_per_second: MOST_FRAMES_PER_SECOND,
    limit: |size, _| size.iter().any(|side| *side > LONGEST_SIDE).then_some(texts::EXPORT_WEBP_TOO_LARGE),
    encoder: Encoder::Still(|_| Box::new(WebP::default())),
};

/// Memory for encoding WebPs.
#[derive(Default)]
struct WebP {
    packed: Vec<u8>,
    bytes: Vec<u8>,
}

impl StillEncoder for WebP {
    fn encode(&mut self, rows: &Rows<'_>) -> Result<(), EncodingError> {
        let Self { packed, bytes } = self;
        let colour_type = if rows.pack(packed) { ExtendedColorType::Rgb8 } else { ExtendedColorType::Rgba8 };
        bytes.clear();
        WebPEncoder::new_lossless(bytes)
            .encode(packed, rows.width, rows.height, colour_type)
            .map_err(|error| EncodingError(error.into()))
    }

    fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    fn into_bytes(self: Box<Self>) -> Vec<u8> {
        self.bytes
    }
}
