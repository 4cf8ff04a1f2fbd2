//! The sun's box: the part of the world that the shadow map covers.
//!
//! The box is fitted to the shapes that cast a shadow into the view. Its size and centre change in steps, so that shadows do not shimmer
//! and the map is not drawn again for small movements. It depends on the frame alone.

use glam::{Mat4, Vec3, Vec4};

use crate::frame::Frame;
use crate::lighting::Lighting;
use crate::render::bounds::{Bounds, ViewSides};
use crate::render::look;

/// Texels along the map's longest side for each row of the picture. Texels are then about as large as pixels.
const TEXELS_PER_ROW: f32 = 1.2;
/// The same in a plain picture if the CPU draws: one bilinear tap is the whole filter, so that a texel is larger than a pixel.
const SOFTWARE_TEXELS_PER_ROW: f32 = 0.65;
/// Sizes are rounded up to this many texels so that the texture can be reused.
const TEXEL_STEP: u32 = 64;
/// The longest side of the map in texels.
const MOST_TEXELS: u32 = 2048;
/// Empty texels around the casters, for filtered lookups at the edge.
const BORDER_TEXELS: u32 = 4;
/// Shapes farther than this from the eye cast no shadow, in scene units.
const FARTHEST_CASTER: f32 = 120.0;
/// The longest distance from a caster to its shadow, in scene units.
const LONGEST_THROW: f32 = 80.0;
/// The box centre snaps to multiples of this many texels, so texel edges stay fixed in the world while the box moves (no shimmering).
const CENTRE_TEXELS: u32 = 16;
/// Steps for each doubling of a texel's side.
const STEPS_PER_DOUBLING: f32 = 6.0;
/// The smallest side of the box, in scene units.
const SMALLEST_SIDE: f32 = 2.0;

/// The part of the world that the shadow map covers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SunBox {
    /// World space to the map: x and y from −1 to 1 (Y up), depth from 0 nearest the sun to 1.
    pub map_from_world: Mat4,
    /// A texel's side, in scene units.
    pub texel: f32,
    /// The map's width and height, in texels: no more than the box needs.
    pub size_texels: [u32; 2],
}

/// The light of a shadow map, and how much the map counts: in a plain picture the sun's middle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Unit direction from any point towards the light, in world space.
    pub towards_in_world: Vec3,
    /// The map's turn around that direction, in radians. `None` in a plain picture, whose map is steady while shapes move, and as small as
    /// they need.
    pub turn: Option<f32>,
    /// How much the map counts for the sun: sub-frames for each of those with the sun, or 0.
    pub of_sun: f32,
    /// The same for the sky: twice the sub-frames for each of those with the sky, or 0. Twice, since the directions of the upper half are
    /// equally likely, and the mean of their cosines is one half.
    pub of_sky: f32,
    /// One over the number of sub-frames so far, with this one.
    pub of_mean: f32,
    /// The light behind everything in a sub-frame without a sky, and its opacity.
    pub backdrop: Vec4,
}

impl Light {
    /// The light of a plain picture: the middle of the sun.
    pub const fn plain(lighting: &Lighting) -> Self {
        Self {
            towards_in_world: lighting.towards_sun_in_world,
            turn: None,
            of_sun: 0.0,
            of_sky: 0.0,
            of_mean: 1.0,
            backdrop: Vec4::ZERO,
        }
    }

    /// The axes of its map in world space: across, up and towards the light.
    fn axes(&self) -> [Vec3; 3] {
        let z = self.towards_in_world;
        let Some(turn) = self.turn else {
            // Under a sun overhead any direction is across.
            let x = Vec3::Y.cross(z).normalize_or(Vec3::X);
            return [x, z.cross(x), z];
        };
        let (x, y) = z.any_orthonormal_pair();
        let (sin, cos) = turn.sin_cos();
        [x * cos + y * sin, y * cos - x * sin, z]
    }
}

/// The number of constants of a lighting.
pub const CONSTANTS: usize = 18;

/// A lighting as constants of `shaders/material.wgsl`: light before the tone curve, exposure included.
pub fn constants(lighting: &Lighting) -> [(&'static str, f64); CONSTANTS] {
    const NAMES: [[&str; 3]; 6] = [
        ["TOWARDS_SUN_X", "TOWARDS_SUN_Y", "TOWARDS_SUN_Z"],
        ["SUN_RED", "SUN_GREEN", "SUN_BLUE"],
        ["SKY_RED", "SKY_GREEN", "SKY_BLUE"],
        ["GROUND_RED", "GROUND_GREEN", "GROUND_BLUE"],
        ["HORIZON_RED", "HORIZON_GREEN", "HORIZON_BLUE"],
        ["ZENITH_RED", "ZENITH_GREEN", "ZENITH_BLUE"],
    ];
    let [sun, sky, ground] = [lighting.sun, lighting.sky, lighting.ground].map(|light| light * look::EXPOSURE);
    let [horizon, zenith] = [lighting.horizon, lighting.zenith].map(|colour| colour.map(look::untoned));
    let values = [lighting.towards_sun_in_world, sun, sky, ground, horizon, zenith];
    std::array::from_fn(|at| (NAMES[at / 3][at % 3], f64::from(values[at / 3][at % 3])))
}

/// The largest number of texels along the map's longest side, for a picture's height in pixels. Maps of sub-frames are coarser, since no
/// edge of a single one shows, and those of the sky most of all.
pub fn most_texels(height_px: u32, light: &Light, is_software: bool) -> u32 {
    let per_row = match light.turn {
        None if is_software => SOFTWARE_TEXELS_PER_ROW,
        None => TEXELS_PER_ROW,
        Some(_) if light.of_sky > 0.0 => 0.45 * TEXELS_PER_ROW,
        Some(_) => 0.8 * TEXELS_PER_ROW,
    };
    ((height_px as f32 * per_row) as u32).next_multiple_of(TEXEL_STEP).clamp(4 * TEXEL_STEP, MOST_TEXELS)
}

impl SunBox {
    /// The box around all shapes that cast a shadow into the frame's view; `bounds` are the boxes of the items. The map has at most
    /// `most_texels` along each side. `None` if nothing casts a shadow.
    pub fn fit(frame: &Frame, light: &Light, bounds: &[Bounds], most_texels: u32) -> Option<Self> {
        let sides = ViewSides::of(&frame.view, 0.0);
        let [x, y, z] = light.axes();
        let floor = bounds
            .iter()
            .filter(|bounds| sides.may_see(bounds, Vec3::ZERO))
            .map(|bounds| bounds.centre_in_world.y - bounds.reach(Vec3::Y))
            .fold(f32::INFINITY, f32::min);
        let (mut least, mut most) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for (_, bounds) in frame.items.iter().zip(bounds).filter(|(item, _)| !item.is_ground()) {
            let centre = bounds.centre_in_world;
            let throw = ((centre.y + bounds.reach(Vec3::Y) - floor) / z.y).clamp(0.0, LONGEST_THROW);
            let near_enough = centre.distance(sides.eye_in_world) < FARTHEST_CASTER;
            if near_enough && sides.may_see(bounds, -z * throw) {
                let centre = Vec3::new(centre.dot(x), centre.dot(y), centre.dot(z));
                let reach = Vec3::new(bounds.reach(x), bounds.reach(y), bounds.reach(z));
                least = least.min(centre - reach);
                most = most.max(centre + reach);
            }
        }
        if !(most - least).is_finite() || least.x > most.x {
            return None;
        }
        let extent = (most - least).truncate();
        let beside = CENTRE_TEXELS + BORDER_TEXELS;
        let needed = extent.max_element() * most_texels as f32 / (most_texels - beside) as f32;
        let steps = (needed.max(SMALLEST_SIDE).log2() * STEPS_PER_DOUBLING).ceil();
        let texel = (steps / STEPS_PER_DOUBLING).exp2() / most_texels as f32;
        let texels =
            |extent: f32| ((extent / texel).ceil() as u32 + beside).next_multiple_of(TEXEL_STEP).min(most_texels);
        // The maps of sub-frames have one size, so that they are one texture.
        let size_texels = light.turn.map_or_else(|| extent.to_array().map(texels), |_| [most_texels; 2]);
        let centre_step = texel * CENTRE_TEXELS as f32;
        let snap = |v: f32| (v / centre_step).round() * centre_step;
        let centre = [snap(f32::midpoint(least.x, most.x)), snap(f32::midpoint(least.y, most.y))];
        let (nearest, farthest) = (most.z.ceil() + 1.0, least.z.floor() - 1.0);
        let deep = 1.0 / (nearest - farthest);
        let [across, up] = size_texels.map(|texels| 2.0 / (texel * texels as f32));
        let map_from_world = Mat4::from_cols(
            Vec3::new(x.x * across, y.x * up, -z.x * deep).extend(0.0),
            Vec3::new(x.y * across, y.y * up, -z.y * deep).extend(0.0),
            Vec3::new(x.z * across, y.z * up, -z.z * deep).extend(0.0),
            Vec3::new(-centre[0] * across, -centre[1] * up, nearest * deep).extend(1.0),
        );
        Some(Self { map_from_world, texel, size_texels })
    }
}
