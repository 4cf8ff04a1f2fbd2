//! Smaller and smaller copies of a texture, made on the processor so that they are the same everywhere.

use std::sync::LazyLock;

use crate::colour::{linear_from_srgb, srgb_from_linear};

/// Linear light of each sRGB byte.
static LINEAR: LazyLock<[f32; 256]> =
    LazyLock::new(|| std::array::from_fn(|byte| linear_from_srgb(byte as f32 / 255.0)));
/// Steps of linear light that have an sRGB byte of their own.
const STEPS: usize = 1 << 14;
/// The sRGB byte of each step of linear light.
static SRGB: LazyLock<Vec<u8>> = LazyLock::new(|| {
    (0..=STEPS).map(|step| (srgb_from_linear(step as f32 / STEPS as f32) * 255.0).round() as u8).collect()
});

/// One size of a texture: rows from the top, four bytes a pixel, of which the first three are sRGB.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mip {
    /// Width and height in pixels.
    pub size_px: [u32; 2],
    /// The pixels.
    pub pixels: Vec<u8>,
}

impl Mip {
    /// Half the width and height, each pixel the mean of four in linear light, by their opacity. `None` for a single pixel.
    fn half(&self) -> Option<Self> {
        let [width, height] = self.size_px;
        if width.max(height) == 1 {
            return None;
        }
        let size_px = [(width / 2).max(1), (height / 2).max(1)];
        let mut pixels = Vec::with_capacity(size_px[0] as usize * size_px[1] as usize * 4);
        for y in 0..size_px[1] {
            for x in 0..size_px[0] {
                let (mut colour, mut plain, mut opacity) = ([0.0; 3], [0.0; 3], 0.0);
                for [right, down] in [[0, 0], [1, 0], [0, 1], [1, 1]] {
                    let (x, y) = ((2 * x + right).min(width - 1), (2 * y + down).min(height - 1));
                    let at = (y as usize * width as usize + x as usize) * 4;
                    let share = f32::from(self.pixels[at + 3]);
                    opacity += share;
                    for channel in 0..3 {
                        let linear = LINEAR[usize::from(self.pixels[at + channel])];
                        colour[channel] += linear * share;
                        plain[channel] += linear;
                    }
                }
                for channel in 0..3 {
                    // What is clear all over keeps its colour: it may be blended with its neighbours.
                    let mean = if opacity > 0.0 { colour[channel] / opacity } else { plain[channel] / 4.0 };
                    pixels.push(SRGB[((mean * STEPS as f32).round() as usize).min(STEPS)]);
                }
                pixels.push((opacity / 4.0).round() as u8);
            }
        }
        Some(Self { size_px, pixels })
    }

    /// A texture and its smaller copies down to a pixel, each half as wide and high. The first is at most `most_px` wide and high.
    pub fn all(size_px: [u32; 2], pixels: &[u8], most_px: u32) -> Vec<Self> {
        let whole = Self { size_px, pixels: pixels.to_vec() };
        let all = std::iter::successors(Some(whole), Self::half);
        all.skip_while(|mip| mip.size_px[0].max(mip.size_px[1]) > most_px).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_are_means_in_linear_light() {
        let (black, white) = ([0, 0, 0, 255], [255, 255, 255, 255]);
        let mips = Mip::all([2, 2], &[black, white, white, black].concat(), 16);
        assert_eq!(mips.len(), 2);
        assert_eq!(mips[1], Mip { size_px: [1, 1], pixels: vec![188, 188, 188, 255] });
        // Clear pixels give no colour.
        let mips = Mip::all([2, 1], &[255, 0, 0, 255, 0, 255, 0, 0], 16);
        assert_eq!(mips[1].pixels, [255, 0, 0, 128]);
    }

    #[test]
    fn a_texture_gets_down_to_a_pixel_and_is_no_larger_than_the_adapter_takes() {
        let pixels = vec![77; 13 * 5 * 4];
        let sizes = |most| Mip::all([13, 5], &pixels, most).iter().map(|mip| mip.size_px).collect::<Vec<_>>();
        assert_eq!(sizes(64), [[13, 5], [6, 2], [3, 1], [1, 1]]);
        assert_eq!(sizes(6), [[6, 2], [3, 1], [1, 1]]);
        assert!(Mip::all([13, 5], &pixels, 64).iter().all(|mip| mip.pixels.iter().all(|&byte| byte == 77)));
    }
}
