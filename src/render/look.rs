//! The picture's named colours and the sun: the one place on the CPU that says them.

use glam::Vec3;

use crate::scene::Colour;

/// The sky where it meets the ground.
pub const HORIZON: &str = "#aebfce";
/// The sky overhead.
pub const ZENITH: &str = "#5f7f9e";
/// The chosen node's outline.
pub const ACCENT: &str = "#f2a33a";
/// The arcball.
pub const ARCBALL: &str = "#d9ecfb";
/// What surrounds the scene in a window until the panels cover it.
pub const SURROUND: &str = "#1b1d21";

/// Direction from any point towards the sun, in world space, not yet of unit length: warm, from the upper left.
pub const TOWARDS_SUN_IN_WORLD: Vec3 = Vec3::new(-0.5, 0.78, 0.5);

/// Width of the chosen node's outline in pixels.
pub const OUTLINE_PX: f32 = 2.0;

/// Linear-light red, green and blue of a colour named above.
pub fn linear(hex: &str) -> Vec3 {
    Colour::from_hex(hex).map_or(Vec3::splat(0.5), Colour::to_linear)
}

/// A linear-light channel as sRGB, 0 to 1 (IEC 61966-2-1).
pub fn srgb_from_linear(channel: f32) -> f32 {
    if channel <= 0.003_130_8 { channel * 12.92 } else { 1.055 * channel.powf(1.0 / 2.4) - 0.055 }
}
