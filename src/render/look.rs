//! Constants of the look of pictures: exposure, strokes, and named colours in linear light.

use std::sync::LazyLock;

use glam::Vec3;

use crate::colour::Colour;

/// Named colours in linear light, each computed once.
#[derive(Debug)]
pub struct Palette {
    /// The chosen node's outline.
    pub accent: Vec3,
    /// The arcball.
    pub arcball: Vec3,
    /// The colour around the scene in a window until the panels are drawn.
    pub surround: Vec3,
}

/// The colours that pictures are drawn with.
pub static PALETTE: LazyLock<Palette> = LazyLock::new(|| Palette {
    accent: Colour::ACCENT.to_linear(),
    arcball: Colour::ARCBALL.to_linear(),
    surround: Colour::BACKDROP.to_linear(),
});

/// The light that the tone curve of `shaders/common.wgsl` brings to a channel of a colour.
pub fn untoned(channel: f32) -> f32 {
    (1.0 - (1.0 - 0.94 * channel).max(0.0).sqrt()) / 0.47
}

/// The factor of all light that falls on shapes and meshes.
pub const EXPOSURE: f32 = 1.22;

/// Width of the chosen node's outline in pixels.
pub const OUTLINE_PX: f32 = 2.0;
