//! Pictures as indices into a palette, dithered so that nothing flickers.
//!
//! A colour between two of the palette is shown as a mixture of pixels of both. Which pixel gets which depends only on its position and
//! colour, so unchanged pixels stay unchanged from picture to picture.

use super::oklab::{Lab, distance_squared, from_levels};
use super::palette::{Palette, nearest};
use crate::picture::Image;

/// How much the grain of a mixture counts against its being nearer on average. By measure: more dither shows more grain and packs
/// worse, less shows more bands.
const GRAIN: f32 = 0.6;
/// Mixtures that are remembered: a power of two.
const REMEMBERED: usize = 1 << 16;

/// Two colours of the palette for one colour.
#[derive(Clone, Copy)]
struct Mixture {
    /// The colour, in the low 24 bits. [`NO_COLOUR`] if there is none yet.
    of: u32,
    /// The nearest, and the one that is mixed in.
    indices: [u8; 2],
    /// The part of pixels that show the second, of 65536; at most half.
    share: u16,
}

const NO_COLOUR: u32 = u32::MAX;

/// A mapping of colours to palette indices.
pub struct Mapping {
    palette: Palette,
    colours: Vec<Lab>,
    dithers: bool,
    /// Each at the place that its colour's bits say; a newer one replaces an older one.
    mixtures: Vec<Mixture>,
}

impl Mapping {
    /// A mapping that dithers, unless the palette has all colours.
    pub fn new(palette: Palette) -> Self {
        let colours = palette.colours().iter().map(|colour| from_levels(colour.map(f32::from))).collect();
        let mixtures = vec![Mixture { of: NO_COLOUR, indices: [0; 2], share: 0 }; REMEMBERED];
        Self { dithers: !palette.is_exact(), palette, colours, mixtures }
    }

    /// A mapping to the nearest colours: pictures show bands, and are packed to half the size.
    pub fn undithered(palette: Palette) -> Self {
        Self { dithers: false, ..Self::new(palette) }
    }

    /// The palette.
    pub const fn palette(&self) -> &Palette {
        &self.palette
    }

    /// The palette indices of a picture's pixels; [`MOST_COLOURS`](super::palette::MOST_COLOURS) for pixels with less than half opacity.
    pub fn indices(&mut self, image: &Image, out: &mut Vec<u8>) {
        out.clear();
        let width = image.width as usize;
        let transparent = u8::MAX;
        for (y, row) in image.rgba.chunks_exact(4 * width).enumerate() {
            for (x, pixel) in row.chunks_exact(4).enumerate() {
                out.push(if pixel[3] < 128 {
                    transparent
                } else {
                    let Mixture { indices: [first, second], share, .. } = self.mixture([pixel[0], pixel[1], pixel[2]]);
                    let noise = noise(x as u32, y as u32);
                    // The two colours keep their pixels where the other one becomes the nearest.
                    let is_second = if first < second { noise < share } else { u16::MAX - noise < share };
                    if is_second { second } else { first }
                });
            }
        }
    }

    fn mixture(&mut self, levels: [u8; 3]) -> Mixture {
        let of = u32::from_be_bytes([0, levels[0], levels[1], levels[2]]);
        let place = (of.wrapping_mul(0x9e37_79b1) >> 16) as usize % REMEMBERED;
        if self.mixtures[place].of != of {
            let colour = from_levels(levels.map(f32::from));
            let first = nearest(&self.colours, colour);
            let (second, share) = if self.dithers { self.mixed_in(first, colour) } else { (first, 0.0) };
            self.mixtures[place] =
                Mixture { of, indices: [first as u8, second as u8], share: (65_536.0 * share) as u16 };
        }
        self.mixtures[place]
    }

    /// What to mix into the nearest colour, and how much of it.
    fn mixed_in(&self, first: usize, colour: Lab) -> (usize, f32) {
        let from = self.colours[first];
        let mut best = (distance_squared(from, colour), first, 0.0);
        for (second, to) in self.colours.iter().enumerate() {
            let apart = distance_squared(from, *to);
            if apart == 0.0 {
                continue;
            }
            let along: f32 = (0..3).map(|part| (colour[part] - from[part]) * (to[part] - from[part])).sum();
            let share = (along / apart).clamp(0.0, 0.5);
            let mean = [0, 1, 2].map(|part| from[part] + share * (to[part] - from[part]));
            let error = distance_squared(mean, colour) + GRAIN * share * (1.0 - share) * apart;
            if error < best.0 {
                best = (error, second, share);
            }
        }
        (best.1, best.2)
    }
}

/// Interleaved gradient noise (Jiménez 2014): every value as often as every other in any small area, without the grid of a matrix.
fn noise(x: u32, y: u32) -> u16 {
    // fract(52.9829189 · fract(0.06711056 · x + 0.00583715 · y)), in fractions of 2^32.
    let inner = x.wrapping_mul(288_237_660).wrapping_add(y.wrapping_mul(25_070_368));
    let outer = (u64::from(inner) * 3_472_288) >> 16;
    ((outer >> 16) & 0xffff) as u16
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_even_in_any_small_area() {
        for (left, top) in [(0, 0), (37, 5), (600, 411)] {
            let values = (0..64).map(|place| f64::from(noise(left + place % 8, top + place / 8)));
            let mean = values.sum::<f64>() / 64.0 / 65_536.0;
            assert!((mean - 0.5).abs() < 0.06, "{mean}");
        }
    }

    /// A slow change of two greys, far more colours than in the palette.
    #[test]
    fn areas_have_the_colour_of_the_picture() {
        let (width, height) = (64_u32, 64_u32);
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let rgba = pixels.flat_map(|(x, y)| [60 + (x + y) as u8, 120 + y as u8, 200 - x as u8, 255]).collect();
        let image = Image { width, height, rgba };
        let mean_error = |mapping: &mut Mapping| {
            let mut indices = Vec::new();
            mapping.indices(&image, &mut indices);
            let mut sum = 0.0;
            for block in 0..64 {
                let (left, top) = (block % 8 * 8, block / 8 * 8);
                for channel in 0..3 {
                    let mut error = 0;
                    for place in (0..64).map(|place| ((top + place / 8) * 64 + left + place % 8) as usize) {
                        let shown = mapping.palette().colours()[usize::from(indices[place])][channel];
                        error += i32::from(shown) - i32::from(image.rgba[4 * place + channel]);
                    }
                    sum += f64::from(error).abs() / 64.0;
                }
            }
            sum / 192.0
        };
        let palette = Palette::of(std::slice::from_ref(&image));
        assert!(!palette.is_exact() && palette.colours().len() > 200);
        let flat = mean_error(&mut Mapping::undithered(palette.clone()));
        let dithered = mean_error(&mut Mapping::new(palette));
        assert!(dithered < 0.5 && dithered < flat, "{dithered} levels dithered, {flat} not");
    }
}
