//! Animated PNGs: whole pictures, every colour as drawn.

use std::io::Write;

use png::{BlendOp, DisposeOp, Encoder, Writer};

use super::{FilmError, Plan};
use crate::render::{Image, set_up_png};

/// An animated PNG that is being written.
pub struct ApngFilm<W: Write> {
    plan: Plan,
    writer: Writer<W>,
    rgb: Vec<u8>,
}

impl<W: Write> ApngFilm<W> {
    pub(super) fn new(plan: Plan, output: W) -> Result<Self, FilmError> {
        let mut encoder = Encoder::new(output, plan.width, plan.height);
        set_up_png(&mut encoder, plan.is_opaque);
        encoder.set_animated(plan.frames, 0)?;
        encoder.set_blend_op(BlendOp::Source)?;
        encoder.set_dispose_op(DisposeOp::None)?;
        Ok(Self { plan, writer: encoder.write_header()?, rgb: Vec::new() })
    }

    pub(super) fn plan(&self) -> Plan {
        self.plan
    }

    pub(super) fn push(&mut self, image: &Image, start_ms: f64, end_ms: f64) -> Result<(), FilmError> {
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

    pub(super) fn finish(self) -> Result<(), FilmError> {
        Ok(self.writer.finish()?)
    }
}
