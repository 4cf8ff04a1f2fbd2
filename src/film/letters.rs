//! The letters of captions: five pixels by seven, so that captions have the same bytes on all systems.

use crate::picture::Image;

/// Height of a letter in pixels, at scale 1.
pub const HEIGHT: u32 = 7;
/// Width of a letter in pixels, at scale 1.
const WIDTH: u32 = 5;

/// The glyphs: rows from the top, the leftmost pixel in the highest of five bits. Other characters are blank.
#[rustfmt::skip]
const LETTERS: [(char, [u8; 7]); 40] = [
    ('0', [0b0_1110, 0b1_0001, 0b1_0011, 0b1_0101, 0b1_1001, 0b1_0001, 0b0_1110]),
    ('1', [0b0_0100, 0b0_1100, 0b0_0100, 0b0_0100, 0b0_0100, 0b0_0100, 0b0_1110]),
    ('2', [0b0_1110, 0b1_0001, 0b0_0001, 0b0_0010, 0b0_0100, 0b0_1000, 0b1_1111]),
    ('3', [0b1_1111, 0b0_0010, 0b0_0100, 0b0_0010, 0b0_0001, 0b1_0001, 0b0_1110]),
    ('4', [0b0_0010, 0b0_0110, 0b0_1010, 0b1_0010, 0b1_1111, 0b0_0010, 0b0_0010]),
    ('5', [0b1_1111, 0b1_0000, 0b1_1110, 0b0_0001, 0b0_0001, 0b1_0001, 0b0_1110]),
    ('6', [0b0_0110, 0b0_1000, 0b1_0000, 0b1_1110, 0b1_0001, 0b1_0001, 0b0_1110]),
    ('7', [0b1_1111, 0b0_0001, 0b0_0010, 0b0_0100, 0b0_1000, 0b0_1000, 0b0_1000]),
    ('8', [0b0_1110, 0b1_0001, 0b1_0001, 0b0_1110, 0b1_0001, 0b1_0001, 0b0_1110]),
    ('9', [0b0_1110, 0b1_0001, 0b1_0001, 0b0_1111, 0b0_0001, 0b0_0010, 0b0_1100]),
    ('.', [0b0_0000, 0b0_0000, 0b0_0000, 0b0_0000, 0b0_0000, 0b0_1100, 0b0_1100]),
    ('-', [0b0_0000, 0b0_0000, 0b0_0000, 0b1_1111, 0b0_0000, 0b0_0000, 0b0_0000]),
    ('°', [0b0_1100, 0b1_0010, 0b1_0010, 0b0_1100, 0b0_0000, 0b0_0000, 0b0_0000]),
    ('k', [0b1_0000, 0b1_0000, 0b1_0010, 0b1_0100, 0b1_1000, 0b1_0100, 0b1_0010]),
    ('e', [0b0_0000, 0b0_0000, 0b0_1110, 0b1_0001, 0b1_1111, 0b1_0000, 0b0_1110]),
    ('y', [0b0_0000, 0b0_0000, 0b1_0001, 0b1_0001, 0b0_1111, 0b0_0001, 0b0_1110]),
    ('s', [0b0_0000, 0b0_0000, 0b0_1111, 0b1_0000, 0b0_1110, 0b0_0001, 0b1_1110]),
    ('a', [0b0_0000, 0b0_0000, 0b0_1110, 0b0_0001, 0b0_1111, 0b1_0001, 0b0_1111]),
    ('b', [0b1_0000, 0b1_0000, 0b1_0110, 0b1_1001, 0b1_0001, 0b1_0001, 0b1_1110]),
    ('c', [0b0_0000, 0b0_0000, 0b0_1110, 0b1_0000, 0b1_0000, 0b1_0001, 0b0_1110]),
    ('d', [0b0_0001, 0b0_0001, 0b0_1101, 0b1_0011, 0b1_0001, 0b1_0001, 0b0_1111]),
    ('f', [0b0_0110, 0b0_1001, 0b0_1000, 0b1_1100, 0b0_1000, 0b0_1000, 0b0_1000]),
    ('g', [0b0_0000, 0b0_1111, 0b1_0001, 0b1_0001, 0b0_1111, 0b0_0001, 0b0_1110]),
    ('h', [0b1_0000, 0b1_0000, 0b1_0110, 0b1_1001, 0b1_0001, 0b1_0001, 0b1_0001]),
    ('i', [0b0_0100, 0b0_0000, 0b0_1100, 0b0_0100, 0b0_0100, 0b0_0100, 0b0_1110]),
    ('j', [0b0_0010, 0b0_0000, 0b0_0110, 0b0_0010, 0b0_0010, 0b1_0010, 0b0_1100]),
    ('l', [0b0_1100, 0b0_0100, 0b0_0100, 0b0_0100, 0b0_0100, 0b0_0100, 0b0_1110]),
    ('m', [0b0_0000, 0b0_0000, 0b1_1010, 0b1_0101, 0b1_0101, 0b1_0001, 0b1_0001]),
    ('n', [0b0_0000, 0b0_0000, 0b1_0110, 0b1_1001, 0b1_0001, 0b1_0001, 0b1_0001]),
    ('o', [0b0_0000, 0b0_0000, 0b0_1110, 0b1_0001, 0b1_0001, 0b1_0001, 0b0_1110]),
    ('p', [0b0_0000, 0b0_0000, 0b1_1110, 0b1_0001, 0b1_1110, 0b1_0000, 0b1_0000]),
    ('q', [0b0_0000, 0b0_0000, 0b0_1101, 0b1_0011, 0b0_1111, 0b0_0001, 0b0_0001]),
    ('r', [0b0_0000, 0b0_0000, 0b1_0110, 0b1_1001, 0b1_0000, 0b1_0000, 0b1_0000]),
    ('t', [0b0_1000, 0b0_1000, 0b1_1100, 0b0_1000, 0b0_1000, 0b0_1001, 0b0_0110]),
    ('u', [0b0_0000, 0b0_0000, 0b1_0001, 0b1_0001, 0b1_0001, 0b1_0011, 0b0_1101]),
    ('v', [0b0_0000, 0b0_0000, 0b1_0001, 0b1_0001, 0b1_0001, 0b0_1010, 0b0_0100]),
    ('w', [0b0_0000, 0b0_0000, 0b1_0001, 0b1_0001, 0b1_0101, 0b1_0101, 0b0_1010]),
    ('x', [0b0_0000, 0b0_0000, 0b1_0001, 0b0_1010, 0b0_0100, 0b0_1010, 0b1_0001]),
    ('z', [0b0_0000, 0b0_0000, 0b1_1111, 0b0_0010, 0b0_0100, 0b0_1000, 0b1_1111]),
    ('+', [0b0_0000, 0b0_0100, 0b0_0100, 0b1_1111, 0b0_0100, 0b0_0100, 0b0_0000]),
];

/// The width of a text in pixels, with a pixel between letters.
#[must_use]
pub fn text_width(text: &str, scale: u32) -> u32 {
    let letters = u32::try_from(text.chars().count()).unwrap_or(u32::MAX);
    (letters.saturating_mul(WIDTH + 1)).saturating_sub(1).saturating_mul(scale)
}

/// Draws a text with its top left corner at a pixel. Pixels outside the picture are clipped.
pub fn write_text(image: &mut Image, [left, top]: [u32; 2], text: &str, scale: u32, colour: [u8; 4]) {
    for (index, letter) in (0_u32..).zip(text.chars()) {
        let Some((_, rows)) = LETTERS.iter().find(|(known, _)| *known == letter) else { continue };
        for y in 0..HEIGHT * scale {
            let row = rows[(y / scale) as usize];
            for x in 0..WIDTH * scale {
                let at = [left + index * (WIDTH + 1) * scale + x, top + y];
                if row >> (WIDTH - 1 - x / scale) & 1 == 1 && at[0] < image.width && at[1] < image.height {
                    let start = 4 * (at[1] as usize * image.width as usize + at[0] as usize);
                    image.rgba[start..start + 4].copy_from_slice(&colour);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_are_told_apart() {
        for (index, (letter, rows)) in LETTERS.iter().enumerate() {
            assert!(rows.iter().all(|row| *row < 32) && rows.iter().any(|row| *row > 0), "{letter}");
            assert!(LETTERS[..index].iter().all(|(_, other)| other != rows), "{letter}");
        }
    }

    #[test]
    fn a_text_is_as_wide_as_it_says() {
        let mut image = Image { width: 40, height: 9, rgba: vec![0; 4 * 40 * 9] };
        write_text(&mut image, [1, 1], "k8", 1, [255; 4]);
        let lit = |x: u32| (0..9).any(|y| image.pixel(x, y).is_some_and(|pixel| pixel[3] > 0));
        assert_eq!((0..40).filter(|x| lit(*x)).min(), Some(1));
        assert_eq!((0..40).filter(|x| lit(*x)).max(), Some(text_width("k8", 1)));
        // Pixels outside are clipped.
        write_text(&mut image, [38, 8], "888", 2, [255; 4]);
    }
}
