//! Colours: sRGB for files and people, linear light for drawing, the conversion between them, and named colours.
//!
//! The curve is that of IEC 61966-2-1. `shaders/common.wgsl` has a copy of one direction; a test here compares the two.

use glam::Vec3;

/// Below this in linear light the curve is a straight line.
const LINE_BELOW_LINEAR: f32 = 0.003_130_8;
/// Below this in sRGB the curve is a straight line.
const LINE_BELOW_SRGB: f32 = 0.040_45;
/// The line's slope, sRGB over linear light.
const SLOPE: f32 = 12.92;
const OFFSET: f32 = 0.055;
const SCALE: f32 = 1.055;
const GAMMA: f32 = 2.4;

/// The linear light of an sRGB channel; both from 0 to 1.
#[must_use]
pub fn linear_from_srgb(channel: f32) -> f32 {
    if channel <= LINE_BELOW_SRGB { channel / SLOPE } else { ((channel + OFFSET) / SCALE).powf(GAMMA) }
}

/// The sRGB value of a channel in linear light; both from 0 to 1.
#[must_use]
pub fn srgb_from_linear(channel: f32) -> f32 {
    if channel <= LINE_BELOW_LINEAR { channel * SLOPE } else { SCALE * channel.powf(1.0 / GAMMA) - OFFSET }
}

/// A colour as files and people write it: red, green and blue in sRGB, each from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Colour(pub Vec3);

impl Colour {
    /// The default colour of shapes: a light grey.
    pub const DEFAULT: Self = Self(Vec3::splat(0.7));

    /// The current keyframe, the playhead, the selection; the outline of the chosen node.
    pub const ACCENT: Self = Self::from_rgb(0xf2, 0xa3, 0x3a);
    /// The darkest surface: the window behind its panels, the gaps of a contact sheet.
    pub const BACKDROP: Self = Self::from_rgb(0x1b, 0x1d, 0x21);
    /// Text on [`Colour::BACKDROP`].
    pub const TEXT: Self = Self::from_rgb(0xd7, 0xda, 0xe0);
    /// Text that matters less on [`Colour::BACKDROP`].
    pub const DIM: Self = Self::from_rgb(0x8b, 0x91, 0x9c);
    /// Thin lines on [`Colour::BACKDROP`].
    pub const LINE: Self = Self::from_rgb(0x32, 0x36, 0x3d);
    /// The sky where it meets the ground.
    pub const HORIZON: Self = Self::from_rgb(0xae, 0xbf, 0xce);
    /// The sky overhead.
    pub const ZENITH: Self = Self::from_rgb(0x5f, 0x7f, 0x9e);
    /// The arcball.
    pub const ARCBALL: Self = Self::from_rgb(0xd9, 0xec, 0xfb);
    /// The motion path and the dots on it.
    pub const PATH: Self = Self::from_rgb(0xf6, 0xf1, 0xe4);
    /// Ghosts of earlier keyframes: warm.
    pub const EARLIER: Self = Self::from_rgb(0xe0, 0x8a, 0x4b);
    /// Ghosts of later keyframes: cool.
    pub const LATER: Self = Self::from_rgb(0x4b, 0xa3, 0xd9);
    /// Ghosts of a comparison: the other of the two interpolations. Also the colour of information messages in the window.
    pub const BLUE: Self = Self::from_rgb(0x5a, 0xa9, 0xe6);
    /// Ghosts of a comparison: blended quaternions (nlerp).
    pub const GREEN: Self = Self::from_rgb(0x63, 0xc0, 0x8a);
    /// Ghosts of a comparison: blended matrices.
    pub const RED: Self = Self::from_rgb(0xe5, 0x64, 0x5a);
    /// The axes x, y and z.
    pub const AXES: [Self; 3] =
        [Self::from_rgb(0xe0, 0x60, 0x5a), Self::from_rgb(0x7f, 0xb8, 0x6a), Self::from_rgb(0x5b, 0x8f, 0xe0)];

    /// Ghosts of the animation of another file.
    pub const OTHER_FILE: Self = Self::from_rgb(0xc0, 0x86, 0xe8);

    /// The colour of red, green and blue in sRGB, each 0 to 255.
    #[must_use]
    pub const fn from_rgb(red: u8, green: u8, blue: u8) -> Self {
        Self(Vec3::new(red as f32 / 255.0, green as f32 / 255.0, blue as f32 / 255.0))
    }

    /// The colour of `[red, green, blue]` in sRGB, each 0 to 255.
    #[must_use]
    pub const fn from_bytes([red, green, blue]: [u8; 3]) -> Self {
        Self::from_rgb(red, green, blue)
    }

    /// Red, green and blue in sRGB, each 0 to 255, rounded to the nearest.
    #[must_use]
    pub const fn to_bytes(self) -> [u8; 3] {
        const fn byte(channel: f32) -> u8 {
            (channel.clamp(0.0, 1.0) * 255.0).round() as u8
        }
        let [red, green, blue] = self.0.to_array();
        [byte(red), byte(green), byte(blue)]
    }

    /// Red, green, blue and full opacity, each 0 to 255: a pixel of a picture.
    #[must_use]
    pub const fn to_pixel(self) -> [u8; 4] {
        let [red, green, blue] = self.to_bytes();
        [red, green, blue, 0xff]
    }

    /// Linear-light red, green and blue, 0 to 1.
    #[must_use]
    pub fn to_linear(self) -> Vec3 {
        self.0.map(linear_from_srgb)
    }

    /// The colour nearest to a linear-light one that `#rrggbb` can express.
    #[must_use]
    pub fn nearest_to_linear(linear: Vec3) -> Self {
        Self::nearest(linear.map(srgb_from_linear))
    }

    /// The colour nearest to an sRGB one (0 to 1) that `#rrggbb` can express.
    #[must_use]
    pub const fn nearest(srgb: Vec3) -> Self {
        Self::from_bytes(Self(srgb).to_bytes())
    }

    /// The colour as text, `#rrggbb`.
    #[must_use]
    pub fn to_hex(self) -> String {
        let [red, green, blue] = self.to_bytes();
        format!("#{red:02x}{green:02x}{blue:02x}")
    }

    /// The colour that `#rrggbb` means; `None` for any other text.
    #[must_use]
    pub fn from_hex(text: &str) -> Option<Self> {
        let digits = text.strip_prefix('#')?;
        if digits.len() != 6 || !digits.bytes().all(|byte| byte.is_ascii_hexdigit()) {
            return None;
        }
        let [_, red, green, blue] = u32::from_str_radix(digits, 16).ok()?.to_be_bytes();
        Some(Self::from_rgb(red, green, blue))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_level_of_a_colour_survives_linear_light() {
        for level in 0..=255 {
            let colour = Colour::from_bytes([level, 255 - level, level / 2]);
            assert_eq!(Colour::nearest_to_linear(colour.to_linear()), colour, "level {level}");
            assert_eq!(Colour::from_hex(&colour.to_hex()), Some(colour));
            assert_eq!(Colour::from_bytes(colour.to_bytes()), colour);
        }
    }

    #[test]
    fn what_is_no_colour_is_none() {
        for text in ["", "#", "aabbcc", "#aabbc", "#aabbccd", "#aabbcg", "#+aabbc", "#äabbc"] {
            assert_eq!(Colour::from_hex(text), None, "{text}");
        }
    }

    #[test]
    fn the_shaders_curve_is_this_one() {
        let shader = include_str!("../shaders/common.wgsl");
        let (_, body) = shader.split_once("fn finished(").expect("it encodes what is drawn");
        let (body, _) = body.split_once("\n}\n").expect("the function ends");
        let numbers: Vec<f32> = body
            .split(|c: char| !c.is_ascii_digit() && c != '.')
            .filter(|word| word.contains('.'))
            .filter_map(|word| word.parse().ok())
            .collect();
        assert_eq!(numbers, [SLOPE, SCALE, 0.0, 1.0, GAMMA, OFFSET, LINE_BELOW_LINEAR]);
    }
}
