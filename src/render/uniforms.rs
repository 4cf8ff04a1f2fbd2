//! What is the same for every corner and pixel of a picture, laid out as in `shaders/common.wgsl`.

use bytemuck::{Pod, Zeroable};
use glam::{Mat4, Vec3, Vec4};

use crate::frame::View;
use crate::render::light::{SunBox, towards_sun_in_world};
use crate::render::look;

/// `Globals` in WGSL.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Globals {
    clip_from_world: Mat4,
    /// x and y from −1 to 1, depth from 0 nearest the sun.
    map_from_world: Mat4,
    /// In world space; w is the size of a pixel at distance 1.
    eye_in_world: Vec4,
    /// The view ray at the picture's centre.
    ray_ahead_in_world: Vec4,
    /// From the centre to the right border; w is the viewport's width in pixels.
    ray_right_in_world: Vec4,
    /// From the centre to the upper border; w is the viewport's height in pixels.
    ray_up_in_world: Vec4,
    /// Unit direction; w is a shadow texel's side in scene units.
    towards_sun_in_world: Vec4,
    /// Linear light; w is the outline's width in pixels.
    horizon: Vec4,
    /// Linear light.
    zenith: Vec4,
    /// Linear light.
    accent: Vec4,
}

impl Globals {
    /// The globals of a picture of so many pixels.
    pub fn new(view: &View, sun: Option<&SunBox>, size_px: [u32; 2]) -> Self {
        let size = [size_px[0] as f32, size_px[1] as f32];
        let up = (view.vertical_fov * 0.5).tan();
        let ray = |in_eye: Vec3, w: f32| view.world_from_eye.transform_vector3(in_eye).extend(w);
        let eye_in_world = Vec3::from(view.world_from_eye.translation);
        // With no shadows everything is nearer the sun than anything in the map.
        let no_shadow = Mat4::from_cols(Vec4::ZERO, Vec4::ZERO, Vec4::ZERO, Vec4::new(0.0, 0.0, -1.0, 1.0));
        Self {
            clip_from_world: view.clip_from_eye * Mat4::from(view.eye_from_world),
            map_from_world: sun.map_or(no_shadow, |sun| sun.map_from_world),
            eye_in_world: eye_in_world.extend(2.0 * up / size[1]),
            ray_ahead_in_world: ray(Vec3::NEG_Z, 0.0),
            ray_right_in_world: ray(Vec3::X * up * view.aspect, size[0]),
            ray_up_in_world: ray(Vec3::Y * up, size[1]),
            towards_sun_in_world: towards_sun_in_world().extend(sun.map_or(0.0, |sun| sun.texel)),
            horizon: look::linear(look::HORIZON).extend(look::OUTLINE_PX),
            zenith: look::linear(look::ZENITH).extend(0.0),
            accent: look::linear(look::ACCENT).extend(0.0),
        }
    }
}
