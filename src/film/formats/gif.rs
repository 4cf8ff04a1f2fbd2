//! Animated GIFs. Each picture after the first holds the rectangle that changed, and only the changed pixels in it are opaque.

use std::borrow::Cow;
use std::io::Write;

use gif::{DisposalMethod, Frame, Repeat};

use super::changes::changes;
use super::mapping::Mapping;
use super::palette::{MOST_COLOURS, Palette};
use crate::film::{Encoder, FilmEncoder, FilmError, FilmFormat, Format, Plan};
use crate::picture::Image;
use crate::words::texts;

/// The number of frames from which the palette is chosen.
const PALETTE_FRAMES: usize = 6;
/// The highest frame rate: a picture lasts at least 0.02 s.
const MOST_FRAMES_PER_SECOND: u32 = 50;

/// Animated GIF: 255 colours, shown everywhere; times are whole hundredths of a second.
pub static GIF: Format = Format {
    name: "GIF",
    ending: "gif",
    has_opacity: true,
    // Four hundredths of a second exactly.
    usual_frames_per_second: 25,
    most_frames_per_second: MOST_FRAMES_PER_SECOND,
    limit: |_, fps| fps.is_some_and(|fps| fps > MOST_FRAMES_PER_SECOND).then_some(texts::EXPORT_GIF_TOO_FAST),
    encoder: Encoder::Film(FilmFormat {
        sample_frames: PALETTE_FRAMES,
        start: |plan, samples, output| Ok(Box::new(GifFilm::new(plan, Palette::of(samples), output)?)),
    }),
};

/// A pixel keeps its colour while no channel is farther from it than this, in levels: the eye sees no difference, and what does not change
/// need not be written.
const HELD_LEVELS: u8 = 1;

/// The shortest time that programs show a picture for, in hundredths of a second: they replace shorter ones by 0.1 s.
const SHORTEST: u32 = 2;

/// A GIF that is being written.
struct GifFilm<W: Write> {
    plan: Plan,
    sides: [u16; 2],
    encoder: gif::Encoder<W>,
    mapping: Mapping,
    /// The current picture with the colours that it keeps.
    held: Image,
    /// The current picture, as indices into the palette.
    shown: Vec<u8>,
    next: Vec<u8>,
    /// The end of the last picture, in hundredths of a second.
    given: u32,
}

impl<W: Write> GifFilm<W> {
    fn new(plan: Plan, palette: Palette, output: W) -> Result<Self, FilmError> {
        let too_large = |_| FilmError::TooLarge { width: plan.width, height: plan.height };
        let sides = [u16::try_from(plan.width).map_err(too_large)?, u16::try_from(plan.height).map_err(too_large)?];
        let mut colours: Vec<u8> = palette.colours().concat();
        colours.resize(3 * (MOST_COLOURS + 1), 0);
        let mut encoder = gif::Encoder::new(output, sides[0], sides[1], &colours)?;
        encoder.set_repeat(Repeat::Infinite)?;
        let mapping = Mapping::new(palette);
        let held = Image { width: plan.width, height: plan.height, rgba: Vec::new() };
        Ok(Self { plan, sides, encoder, mapping, held, shown: Vec::new(), next: Vec::new(), given: 0 })
    }

    /// Takes over the pixels that have changed: all, if the palette has all colours.
    fn take(&mut self, image: &Image) {
        if self.held.rgba.is_empty() || self.mapping.palette().is_exact() {
            self.held.rgba.clone_from(&image.rgba);
            return;
        }
        for (held, new) in self.held.rgba.as_chunks_mut::<4>().0.iter_mut().zip(image.rgba.as_chunks::<4>().0) {
            if held.iter().zip(new).any(|(held, new)| held.abs_diff(*new) > HELD_LEVELS) {
                *held = *new;
            }
        }
    }
}

impl<W: Write + Send> FilmEncoder for GifFilm<W> {
    fn push(&mut self, image: &Image, _start_ms: f64, end_ms: f64) -> Result<(), FilmError> {
        self.take(image);
        self.mapping.indices(&self.held, &mut self.next);
        let transparent = u8::MAX;
        let (rectangle, buffer) = if self.shown.is_empty() || !self.plan.is_opaque {
            ([0, 0, self.sides[0], self.sides[1]], Cow::Borrowed(&self.next[..]))
        } else {
            changes(&self.shown, &self.next, self.sides[0])
        };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "films are far shorter than 2^31 hundredths"
        )]
        let end = (end_ms / 10.0).round() as u32;
        let delay = end.saturating_sub(self.given).max(SHORTEST);
        self.given += delay;
        let [left, top, width, height] = rectangle;
        self.encoder.write_frame(&Frame {
            delay: u16::try_from(delay).unwrap_or(u16::MAX),
            // If pixels are transparent, the previous picture is cleared; otherwise it is kept.
            dispose: if self.plan.is_opaque { DisposalMethod::Keep } else { DisposalMethod::Background },
            transparent: Some(transparent),
            left,
            top,
            width,
            height,
            buffer,
            ..Frame::default()
        })?;
        std::mem::swap(&mut self.shown, &mut self.next);
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<(), FilmError> {
        self.encoder.into_inner()?.flush()?;
        Ok(())
    }
}
