//! WebP: single pictures, lossless, every colour and opacity as drawn.

use std::io::Cursor;

use image_webp::{ColorType, WebPDecoder, WebPEncoder};

use super::MOST_FRAMES_PER_SECOND;
use crate::film::{Encoder, EncodingError, Format, StillEncoder, StillFormat};
use crate::picture::{Image, MOST_PIXELS, Rows, rgba_of};
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
    encoder: Encoder::Still(StillFormat { start: |_| Box::new(WebP::default()), decode }),
};

fn decode(bytes: &[u8]) -> Option<Image> {
    // The head says how many bytes follow it; a decoder need not read the last ones.
    let said = u32::from_le_bytes(*bytes.get(4..)?.first_chunk()?);
    if bytes.len() as u64 != 8 + u64::from(said) {
        return None;
    }
    let mut decoder = WebPDecoder::new(Cursor::new(bytes)).ok()?;
    let (width, height) = decoder.dimensions();
    if u64::from(width) * u64::from(height) > MOST_PIXELS {
        return None;
    }
    let mut pixels = vec![0; decoder.output_buffer_size()?];
    decoder.read_image(&mut pixels).ok()?;
    let rgba = if decoder.has_alpha() { pixels } else { rgba_of(&pixels, 3) };
    Some(Image { width, height, rgba })
}

/// Memory for encoding WebPs.
#[derive(Default)]
struct WebP {
    packed: Vec<u8>,
    bytes: Vec<u8>,
}

impl StillEncoder for WebP {
    fn encode(&mut self, rows: &Rows<'_>) -> Result<(), EncodingError> {
        let Self { packed, bytes } = self;
        let colour_type = if rows.pack(packed) { ColorType::Rgb8 } else { ColorType::Rgba8 };
        bytes.clear();
        WebPEncoder::new(bytes)
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
