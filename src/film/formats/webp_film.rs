//! Animated WebPs: lossy, with opacity. libwebp packs each picture; the file around them is written here, so that each picture holds only
//! what changed.

use std::io::Write;

use webp::{WebPConfig, WebPEncodingError};

use super::blocks::{Canvas, Part};
use crate::film::{Encoder, FilmEncoder, FilmError, FilmFormat, Format, Plan};
use crate::picture::Image;
use crate::words::texts;

/// The longest side that libwebp encodes, in pixels.
const LONGEST_SIDE: u32 = 16_383;
/// The highest frame rate: programs show a picture of 10 ms or less for 100 ms.
const MOST_FRAMES_PER_SECOND: u32 = 90;
/// libwebp's quality, 0 to 100. By measure: the lowest with smaller visible differences than a GIF has.
const QUALITY: f32 = 92.0;

/// Animated WebP: lossy, with opacity; smaller than a GIF, without its bands. Times are whole milliseconds.
pub static WEBP_FILM: Format = Format {
    name: "WebP",
    ending: "webp",
    has_opacity: true,
    usual_frames_per_second: 30,
    most_frames_per_second: MOST_FRAMES_PER_SECOND,
    limit: |size, fps| {
        if size.iter().any(|side| *side > LONGEST_SIDE) {
            Some(texts::EXPORT_WEBP_FILM_TOO_LARGE)
        } else {
            fps.is_some_and(|fps| fps > MOST_FRAMES_PER_SECOND).then_some(texts::EXPORT_WEBP_TOO_FAST)
        }
    },
    encoder: Encoder::Film(FilmFormat {
        sample_frames: 0,
        start: |plan, _, output| Ok(Box::new(WebPFilm::new(plan, output))),
    }),
};

/// A chunk of the file whose size is known when the film ends.
const HEAD: usize = 8;
/// The longest time of one picture, in milliseconds: 24 bits.
const LONGEST_MS: u32 = (1 << 24) - 1;
/// Of the file's flags: it is animated.
const IS_ANIMATED: u8 = 1 << 1;
/// Of the file's flags: a picture has opacity.
const HAS_OPACITY: u8 = 1 << 4;
/// Of a picture's flags: it replaces what it covers instead of lying over it.
const REPLACES: u8 = 1 << 1;

/// A WebP that is being written. Its first bytes say how long it is, so it is written when it ends.
struct WebPFilm<W: Write> {
    output: W,
    plan: Plan,
    canvas: Canvas,
    /// The pictures' chunks.
    body: Vec<u8>,
    has_opacity: bool,
    /// The time of the last picture, in milliseconds, and its place in the body.
    last: Option<(u32, usize)>,
    /// The end of the last picture, in milliseconds.
    given: u32,
}

impl<W: Write> WebPFilm<W> {
    fn new(plan: Plan, output: W) -> Self {
        let canvas = Canvas::new(plan.width as usize, plan.is_opaque);
        Self { output, plan, canvas, body: Vec::new(), has_opacity: false, last: None, given: 0 }
    }

    fn add(&mut self, part: &Part, ms: u32) -> Result<(), FilmError> {
        let picture = encoded(part, self.plan.is_opaque)?;
        self.has_opacity |= picture.starts_with(b"ALPH");
        let body = &mut self.body;
        body.extend(b"ANMF");
        body.extend((16 + picture.len() as u32).to_le_bytes());
        // Places are counted in steps of two pixels.
        for number in [part.left / 2, part.top / 2, part.width - 1, part.height - 1] {
            body.extend(three_bytes(number));
        }
        self.last = Some((ms, body.len()));
        body.extend(three_bytes(ms));
        body.push(if self.plan.is_opaque { 0 } else { REPLACES });
        body.extend(picture);
        Ok(())
    }
}

impl<W: Write + Send> FilmEncoder for WebPFilm<W> {
    fn push(&mut self, image: &Image, _start_ms: f64, end_ms: f64) -> Result<(), FilmError> {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "films are far shorter than 2^32 ms"
        )]
        let end = end_ms.round() as u32;
        let ms = end.saturating_sub(self.given).clamp(1, LONGEST_MS);
        self.given += ms;
        let part = self.canvas.changes(image);
        match (part, self.last) {
            // The same picture again: the last one lasts longer.
            (None, Some((before, at))) if before + ms <= LONGEST_MS => {
                self.last = Some((before + ms, at));
                self.body[at..at + 3].copy_from_slice(&three_bytes(before + ms));
                Ok(())
            }
            (None, _) => self.add(&self.canvas.corner(), ms),
            (Some(part), _) => self.add(&part, ms),
        }
    }

    fn finish(mut self: Box<Self>) -> Result<(), FilmError> {
        let mut head = b"WEBPVP8X\x0a\0\0\0".to_vec();
        head.extend([IS_ANIMATED | if self.has_opacity { HAS_OPACITY } else { 0 }, 0, 0, 0]);
        head.extend([self.plan.width - 1, self.plan.height - 1].map(three_bytes).concat());
        // Transparent behind the pictures, repeated for ever.
        head.extend(b"ANIM\x06\0\0\0\0\0\0\0\0\0");
        let bytes = u32::try_from(head.len() + self.body.len()).map_err(|error| FilmError::Encoding(error.into()))?;
        self.output.write_all(b"RIFF")?;
        self.output.write_all(&bytes.to_le_bytes())?;
        self.output.write_all(&head)?;
        self.output.write_all(&self.body)?;
        Ok(self.output.flush()?)
    }
}

fn three_bytes(number: u32) -> [u8; 3] {
    let [low, middle, high, _] = number.to_le_bytes();
    [low, middle, high]
}

/// The chunks of a part's pixels: opacity, if there is any, and colours.
fn encoded(part: &Part, is_opaque: bool) -> Result<Vec<u8>, FilmError> {
    let failed = |error: WebPEncodingError| FilmError::Encoding(format!("libwebp: {error:?}").into());
    let mut config = WebPConfig::new().map_err(|()| failed(WebPEncodingError::VP8_ENC_ERROR_INVALID_CONFIGURATION))?;
    config.quality = QUALITY;
    // Coloured edges stay sharp.
    config.use_sharp_yuv = 1;
    // Flat areas get the bits that detail would hide.
    config.sns_strength = 100;
    config.filter_strength = 0;
    config.alpha_filtering = 0;
    // What is under an opacity of 0 was chosen to be packed well.
    config.exact = is_opaque.into();
    let packed = if part.rgba.chunks_exact(4).all(|pixel| pixel[3] == u8::MAX) {
        let rgb: Vec<u8> = part.rgba.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
        webp::Encoder::from_rgb(&rgb, part.width, part.height).encode_advanced(&config)
    } else {
        webp::Encoder::from_rgba(&part.rgba, part.width, part.height).encode_advanced(&config)
    };
    Ok(chunks(&packed.map_err(failed)?))
}

/// The chunks of a WebP of one picture that a picture of an animation may hold.
fn chunks(webp: &[u8]) -> Vec<u8> {
    let mut kept = Vec::with_capacity(webp.len());
    // After "RIFF", the size, and "WEBP".
    let mut rest = webp.get(12..).unwrap_or_default();
    while let Some(size) = rest.get(4..HEAD).and_then(|size| size.first_chunk()) {
        let bytes = u32::from_le_bytes(*size) as usize;
        let (chunk, after) = rest.split_at((HEAD + bytes.next_multiple_of(2)).min(rest.len()));
        if !chunk.starts_with(b"VP8X") {
            kept.extend(chunk);
        }
        rest = after;
    }
    kept
}
