//! The mean of pictures of one size.

use std::sync::LazyLock;

use super::{Image, Rows};
use crate::colour::{linear_from_srgb, srgb_from_linear};

/// Linear light of each level of sRGB, in 65535ths.
static LINEAR: LazyLock<[u32; 256]> =
    LazyLock::new(|| std::array::from_fn(|level| (linear_from_srgb(level as f32 / 255.0) * 65535.0).round() as u32));

/// The sum of pictures of one size, in linear light.
#[derive(Clone, Debug)]
pub struct PictureSum {
    /// The first of them.
    first: Image,
    /// Of each pixel red, green and blue times opacity, and the opacity.
    sums: Vec<[u64; 4]>,
    count: u64,
}

impl PictureSum {
    /// A sum that begins with a picture.
    #[must_use]
    pub fn of(first: &Rows<'_>) -> Self {
        let mut sum = Self { first: first.to_image(), sums: Vec::new(), count: 0 };
        sum.sums.resize(sum.first.rgba.len() / 4, [0; 4]);
        sum.add(first);
        sum
    }

    /// Adds a picture of the same size.
    pub fn add(&mut self, picture: &Rows<'_>) {
        self.count += 1;
        let pixels = picture.rows().flat_map(|row| row.as_chunks::<4>().0);
        for (sum, pixel) in self.sums.iter_mut().zip(pixels) {
            for (sum, term) in sum.iter_mut().zip(terms(*pixel)) {
                *sum += term;
            }
        }
    }

    /// The mean: a pixel that all pictures have alike is kept to the bit.
    #[must_use]
    pub fn mean(self) -> Image {
        let Self { mut first, sums, count } = self;
        for (pixel, sum) in first.rgba.as_chunks_mut::<4>().0.iter_mut().zip(sums) {
            if terms(*pixel).map(|term| term * count) == sum {
                continue;
            }
            let [red, green, blue, opacity] = sum;
            let channel = |sum: u64| {
                let linear = sum as f32 / (opacity.max(1) as f32 * 65535.0);
                (srgb_from_linear(linear) * 255.0).round() as u8
            };
            *pixel = [channel(red), channel(green), channel(blue), (opacity as f32 / count as f32).round() as u8];
        }
        first
    }
}

fn terms([red, green, blue, opacity]: [u8; 4]) -> [u64; 4] {
    let opacity = u64::from(opacity);
    let [red, green, blue] = [red, green, blue].map(|level| u64::from(LINEAR[usize::from(level)]) * opacity);
    [red, green, blue, opacity]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mean(pixels: &[[u8; 4]]) -> [u8; 4] {
        let images = pixels.iter().map(|pixel| Image { width: 1, height: 1, rgba: pixel.to_vec() });
        let images: Vec<Image> = images.collect();
        let mut sum = PictureSum::of(&images[0].rows());
        images[1..].iter().for_each(|image| sum.add(&image.rows()));
        sum.mean().pixel(0, 0).unwrap()
    }

    #[test]
    fn what_all_have_alike_is_kept_and_the_rest_is_mixed_in_linear_light() {
        for level in 0..=255 {
            let pixel = [level, 255 - level, level / 2, level];
            assert_eq!(mean(&[pixel; 3]), pixel);
        }
        // Half of the light of white is level 188.
        assert_eq!(mean(&[[0, 0, 0, 255], [255, 255, 255, 255]]), [188, 188, 188, 255]);
        // What cannot be seen has no colour.
        assert_eq!(mean(&[[200, 10, 10, 255], [0, 255, 0, 0]]), [200, 10, 10, 128]);
        assert_eq!(mean(&[[0; 4], [0, 0, 0, 0], [9, 9, 9, 0]])[3], 0);
    }
}
