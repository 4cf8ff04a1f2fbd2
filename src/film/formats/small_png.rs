//! Small PNGs for pages: 255 colours without dither; of a film, what changes from picture to picture.

use std::borrow::Cow;

use png::{BitDepth, BlendOp, ColorType, Compression, DisposeOp, EncodingError, Filter};

use super::changes::changes;
use super::mapping::Mapping;
use super::palette::{MOST_COLOURS, Palette};
use crate::picture::Image;

/// Encodes pictures of one palette.
pub struct SmallPng {
    mapping: Mapping,
}

impl SmallPng {
    /// An encoder of pictures whose colours are like those of the sample pictures.
    #[must_use]
    pub fn new(samples: &[Image]) -> Self {
        Self { mapping: Mapping::undithered(Palette::of(samples)) }
    }

    /// One picture as a PNG, or several opaque ones of one size, each shown for `frame_ms` milliseconds, as an animated PNG that repeats.
    ///
    /// # Errors
    /// [`EncodingError`] if there is no picture, or its sides and its bytes do not agree.
    pub fn encode(&mut self, pictures: &[Image], frame_ms: u16) -> Result<Vec<u8>, EncodingError> {
        let (width, height) = pictures.first().map_or((0, 0), |first| (first.width, first.height));
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, width, height);
        encoder.set_color(ColorType::Indexed);
        encoder.set_depth(BitDepth::Eight);
        encoder.set_compression(Compression::Balanced);
        encoder.set_filter(Filter::NoFilter);
        let mut colours = self.mapping.palette().colours().concat();
        colours.resize(3 * (MOST_COLOURS + 1), 0);
        encoder.set_palette(colours);
        let mut opacities = vec![u8::MAX; MOST_COLOURS];
        opacities.push(0);
        encoder.set_trns(opacities);
        let is_film = pictures.len() > 1;
        if is_film {
            encoder.set_animated(u32::try_from(pictures.len()).unwrap_or(u32::MAX), 0)?;
            encoder.set_frame_delay(frame_ms, 1000)?;
            encoder.set_blend_op(BlendOp::Over)?;
            encoder.set_dispose_op(DisposeOp::None)?;
        }
        let mut writer = encoder.write_header()?;
        let (mut shown, mut next) = (Vec::new(), Vec::new());
        for picture in pictures {
            self.mapping.indices(picture, &mut next);
            let part = if shown.is_empty() {
                Cow::Borrowed(&next[..])
            } else {
                let side = |side: u32| u16::try_from(side).map_err(|_| EncodingError::LimitsExceeded);
                let ([left, top, width, height], part) = changes(&shown, &next, side(picture.width)?);
                // The old rectangle may not fit at the new place.
                writer.reset_frame_position()?;
                writer.set_frame_dimension(width.into(), height.into())?;
                writer.set_frame_position(left.into(), top.into())?;
                part
            };
            writer.write_image_data(&part)?;
            std::mem::swap(&mut shown, &mut next);
        }
        writer.finish()?;
        Ok(bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image(pixel: impl Fn(u32, u32) -> [u8; 3]) -> Image {
        let rgba = (0..30).flat_map(|y| (0..40).map(move |x| (x, y))).flat_map(|(x, y)| {
            let [r, g, b] = pixel(x, y);
            [r, g, b, 255]
        });
        Image { width: 40, height: 30, rgba: rgba.collect() }
    }

    #[test]
    fn each_frame_holds_what_changed() {
        let is_in = |x: u32, y: u32, left: u32| (left..left + 5).contains(&x) && (10..14).contains(&y);
        let square = |left: u32| image(|x, y| if is_in(x, y, left) { [200, 30, 10] } else { [90, 120, y as u8] });
        let films = [square(3), square(4), square(4), square(30)];
        let bytes = SmallPng::new(&films).encode(&films, 150).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes[..])).read_info().unwrap();
        let mut canvas = vec![0; 3 * 40 * 30];
        let mut sizes = Vec::new();
        for film in &films {
            let mut part = vec![0; reader.output_buffer_size().unwrap()];
            let info = reader.next_frame(&mut part).unwrap();
            let control = *reader.info().frame_control().unwrap();
            assert_eq!((control.delay_num, control.delay_den), (150, 1000));
            sizes.push([control.x_offset, control.y_offset, info.width, info.height]);
            let palette = reader.info().palette.clone().unwrap();
            for (index, colour) in part[..info.buffer_size()].iter().enumerate() {
                let (x, y) = (index as u32 % info.width, index as u32 / info.width);
                let at = 3 * ((y + control.y_offset) * 40 + x + control.x_offset) as usize;
                if *colour != u8::MAX {
                    canvas[at..at + 3].copy_from_slice(&palette[3 * usize::from(*colour)..][..3]);
                }
            }
            let expected: Vec<u8> = film.rgba.chunks(4).flat_map(|pixel| pixel[..3].to_vec()).collect();
            assert!(canvas == expected);
        }
        assert_eq!(sizes, [[0, 0, 40, 30], [3, 10, 6, 4], [0, 0, 1, 1], [4, 10, 31, 4]]);
    }

    #[test]
    fn nothing_is_no_picture() {
        assert!(SmallPng::new(&[]).encode(&[], 1).is_err());
    }
}
