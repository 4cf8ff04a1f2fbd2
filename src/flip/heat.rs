//! Errors as colours: nine steps of the colour map "magma", from black to pale yellow with linear lightness.

use crate::picture::Image;

const STEPS: [[f32; 3]; 9] = [
    [0.0, 0.0, 4.0],
    [28.0, 16.0, 68.0],
    [79.0, 18.0, 123.0],
    [129.0, 37.0, 129.0],
    [181.0, 54.0, 122.0],
    [229.0, 80.0, 100.0],
    [251.0, 135.0, 97.0],
    [254.0, 194.0, 135.0],
    [252.0, 253.0, 191.0],
];

/// Opaque pixels for errors from 0 to 1.
pub fn picture(width: u32, height: u32, errors: &[f32]) -> Image {
    let rgba = errors.iter().flat_map(|&error| colour(error)).collect();
    Image { width, height, rgba }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the position is in the table, channels in 0 to 255"
)]
fn colour(error: f32) -> [u8; 4] {
    let position = error.clamp(0.0, 1.0) * 8.0;
    let step = (position as usize).min(7);
    let fraction = position - position.floor().min(7.0);
    let channel = |channel: usize| {
        let (from, to) = (STEPS[step][channel], STEPS[step + 1][channel]);
        (from + (to - from) * fraction).round() as u8
    };
    [channel(0), channel(1), channel(2), u8::MAX]
}
