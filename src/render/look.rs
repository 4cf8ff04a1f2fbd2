//! Constants of the look of pictures: the sun, strokes, and named colours in linear light.

use std::sync::LazyLock;

use glam::Vec3;

use crate::colour::Colour;

/// Named colours in linear light, each computed once.
#[derive(Debug)]
pub struct Palette {
    /// The sky where it meets the ground.
    pub horizon: Vec3,
    /// The sky overhead.
    pub zenith: Vec3,
    /// The chosen node's outline.
    pub accent: Vec3,
    /// The arcball.
    pub arcball: Vec3,
    /// The colour around the scene in a window until the panels are drawn.
    pub surround: Vec3,
}

/// The colours that pictures are drawn with.
pub static PALETTE: LazyLock<Palette> = LazyLock::new(|| Palette {
    horizon: Colour::HORIZON.to_linear(),
    zenith: Colour::ZENITH.to_linear(),
    accent: Colour::ACCENT.to_linear(),
    arcball: Colour::ARCBALL.to_linear(),
    surround: Colour::BACKDROP.to_linear(),
});

/// The light that the tone curve of `shaders/common.wgsl` brings to a channel of a colour.
pub fn untoned(channel: f32) -> f32 {
    (1.0 - (1.0 - 0.94 * channel).max(0.0).sqrt()) / 0.47
}

/// Direction from any point towards the sun, in world space, not of unit length: warm, from the upper left.
pub const TOWARDS_SUN_IN_WORLD: Vec3 = Vec3::new(-0.5, 0.78, 0.5);

/// Width of the chosen node's outline in pixels.
pub const OUTLINE_PX: f32 = 2.0;
