//! Animated PNGs: whole pictures, every colour as drawn.

use std::io::Write;

use png::{BlendOp, DisposeOp, Writer};

use super::{MOST_FRAMES_PER_SECOND, no_limit};
use crate::film::{Encoder, FilmEncoder, FilmError, FilmFormat, Format, Plan};
use crate::picture::{Image, set_up_png};

/// Animated PNG: every colour and opacity as drawn.
pub static APNG: Format = Format {
    name: "APNG",
    ending: "apng",
    has_opacity: true,
    usual_frames_per_second: 30,
    most_frames_per_second: MOST_FRAMES_PER_SECOND,
    limit: no_limit,
    encoder: Encoder::Film(FilmFormat {
        sample_frames: 0,
        start: |plan, _, output| Ok(Box::new(ApngFilm::new(plan, output)?)),
    }),
};

/// An animated PNG that is being written.
struct ApngFilm<W: Write> {
    plan: Plan,
    writer: Writer<W>,
    rgb: Vec<u8>,
}

impl<W: Write> ApngFilm<W> {
    fn new(plan: Plan, output: W) -> Result<Self, FilmError> {
        let mut encoder = png::Encoder::new(output, plan.width, plan.height);
        set_up_png(&mut encoder, plan.is_opaque);
        encoder.set_animated(plan.frames, 0)?;
        encoder.set_blend_op(BlendOp::Source)?;
        encoder.set_dispose_op(DisposeOp::None)?;
        Ok(Self { plan, writer: encoder.write_header()?, rgb: Vec::new() })
    }
}

impl<W: Write + Send> FilmEncoder for ApngFilm<W> {
    fn push(&mut self, image: &Image, start_ms: f64, end_ms: f64) -> Result<(), FilmError> {
        let whole = 1000.0 / f64::from(self.plan.frames_per_second);
        let (numerator, denominator) = if (end_ms - start_ms - whole).abs() < 1e-6 {
            (1, u16::try_from(self.plan.frames_per_second).unwrap_or(u16::MAX))
        } else {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "kept within u16")]
            let tenths = ((end_ms - start_ms) * 10.0).round().clamp(1.0, 65_535.0) as u16;
            (tenths, 10_000)
        };
        let writer = &mut self.writer;
        writer.set_frame_delay(numerator, denominator)?;
        if self.plan.is_opaque {
            self.rgb.clear();
            for pixel in image.rgba.chunks_exact(4) {
                self.rgb.extend_from_slice(&pixel[..3]);
            }
            writer.write_image_data(&self.rgb)?;
        } else {
            writer.write_image_data(&image.rgba)?;
        }
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<(), FilmError> {
        Ok(self.writer.finish()?)
    }
}
