//! A palette of at most 255 colours for a whole film, and a mapping to it that does not flicker.
//!
//! One palette serves all pictures, and the dither depends only on a pixel's position and colour, so unchanged pixels stay unchanged.

use std::collections::BTreeSet;

use color_quant::NeuQuant;

use crate::picture::Image;

/// Colours in a palette; the one after them is transparent.
pub const MOST_COLOURS: usize = 255;
/// Approximate number of pixels that are read from the sampled pictures.
const SAMPLED_PIXELS: usize = 120_000;
/// Approximate smallest number of pixels that the network learns from.
const LEARNED_PIXELS: usize = 60_000;
/// The largest change of a dithered channel, in levels of 256.
const DITHER_LEVELS: i32 = 9;
/// Bits per channel of the table of nearest colours.
const TABLE_BITS: u32 = 6;

/// Bayer's matrix of order 8: each number of 0 to 63 once, with neighbours far apart.
const BAYER: [[u8; 8]; 8] = {
    let mut matrix = [[0; 8]; 8];
    let mut y = 0;
    while y < 8 {
        let mut x = 0;
        while x < 8 {
            let mut value = 0;
            let mut bit = 0;
            while bit < 3 {
                let (x_bit, y_bit) = ((x >> bit) & 1, (y >> bit) & 1);
                value |= ((x_bit ^ y_bit) << (5 - 2 * bit)) | (y_bit << (4 - 2 * bit));
                bit += 1;
            }
            matrix[y][x] = value as u8;
            x += 1;
        }
        y += 1;
    }
    matrix
};

/// The palette of a film.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Palette {
    colours: Vec<[u8; 3]>,
    /// Whether the palette has all colours of the film, so that no dither is needed.
    is_exact: bool,
}

impl Palette {
    /// The palette of a film from sample pictures: their own colours if they are few, otherwise 255 that NeuQuant finds. Pixels with less
    /// than half opacity are ignored.
    #[must_use]
    pub fn of(pictures: &[Image]) -> Self {
        let pixels =
            || pictures.iter().flat_map(|picture| picture.rgba.chunks_exact(4)).filter(|pixel| pixel[3] >= 128);
        let mut few = BTreeSet::new();
        for pixel in pixels() {
            few.insert([pixel[0], pixel[1], pixel[2]]);
            if few.len() > MOST_COLOURS {
                return Self { colours: Self::found(pixels()), is_exact: false };
            }
        }
        Self { colours: few.into_iter().collect(), is_exact: true }
    }

    fn found<'a>(pixels: impl Iterator<Item = &'a [u8]> + Clone) -> Vec<[u8; 3]> {
        // An odd step that does not divide usual widths samples every column.
        let step = (pixels.clone().count() / SAMPLED_PIXELS).max(1) | 1;
        let sample: Vec<u8> = pixels.step_by(step).flat_map(|pixel| [pixel[0], pixel[1], pixel[2], u8::MAX]).collect();
        // The network learns by repetition: if there are few pixels they are repeated.
        let sample = sample.repeat((LEARNED_PIXELS * 4 / sample.len().max(1)).max(1));
        let found = NeuQuant::new(3, MOST_COLOURS, &sample).color_map_rgb();
        let mut colours: Vec<[u8; 3]> = found.chunks_exact(3).map(|colour| [colour[0], colour[1], colour[2]]).collect();
        colours.sort_unstable();
        colours.dedup();
        colours
    }

    /// The colours.
    #[must_use]
    pub fn colours(&self) -> &[[u8; 3]] {
        &self.colours
    }

    fn nearest(&self, colour: [i32; 3]) -> u8 {
        // Weights: the eye is most sensitive to green, least to blue.
        let distance = |other: &[u8; 3]| {
            let [r, g, b] = [0, 1, 2].map(|channel| i32::from(other[channel]) - colour[channel]);
            3 * r * r + 6 * g * g + 2 * b * b
        };
        let index = (0..self.colours.len()).min_by_key(|&index| distance(&self.colours[index]));
        index.and_then(|index| u8::try_from(index).ok()).unwrap_or_default()
    }
}

/// A cached mapping of colours to palette indices.
pub struct Mapping {
    palette: Palette,
    /// The largest change of a dithered channel, in levels of 256.
    dither_levels: i32,
    /// For each cell, the index of the colour nearest to its middle, plus one; 0 if not computed yet.
    table: Vec<u16>,
}

impl Mapping {
    /// A mapping that dithers, unless the palette has all colours.
    pub fn new(palette: Palette) -> Self {
        Self { palette, dither_levels: DITHER_LEVELS, table: vec![0; 1 << (3 * TABLE_BITS)] }
    }

    /// A mapping to the nearest colours: pictures show bands, and are packed to half the size.
    pub fn undithered(palette: Palette) -> Self {
        Self { dither_levels: 0, ..Self::new(palette) }
    }

    /// The palette.
    pub const fn palette(&self) -> &Palette {
        &self.palette
    }

    /// The palette indices of a picture's pixels; [`MOST_COLOURS`] for pixels with less than half opacity.
    pub fn indices(&mut self, image: &Image, out: &mut Vec<u8>) {
        out.clear();
        let width = image.width as usize;
        let transparent = u8::MAX;
        for (y, row) in image.rgba.chunks_exact(4 * width).enumerate() {
            let thresholds = &BAYER[y % 8];
            for (x, pixel) in row.chunks_exact(4).enumerate() {
                out.push(if pixel[3] < 128 {
                    transparent
                } else {
                    self.index([pixel[0], pixel[1], pixel[2]], thresholds[x % 8])
                });
            }
        }
    }

    fn index(&mut self, colour: [u8; 3], threshold: u8) -> u8 {
        if self.palette.is_exact
            && let Ok(index) = self.palette.colours.binary_search(&colour)
        {
            return index.to_le_bytes()[0];
        }
        let moved = (2 * i32::from(threshold) - 63) * self.dither_levels / 126;
        let shift = 8 - TABLE_BITS;
        let cells = colour.map(|channel| (i32::from(channel) + moved).clamp(0, 255) >> shift);
        let cell = cells.iter().fold(0, |cell, &part| (cell << TABLE_BITS) | part.unsigned_abs() as usize);
        if self.table[cell] == 0 {
            let middle = 1 << (shift - 1);
            self.table[cell] = u16::from(self.palette.nearest(cells.map(|part| (part << shift) + middle))) + 1;
        }
        self.table[cell].wrapping_sub(1).to_le_bytes()[0]
    }
}
