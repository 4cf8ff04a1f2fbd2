//! Uniforms of a picture, laid out as in `shaders/common.wgsl`.

use bytemuck::{Pod, Zeroable};
use glam::{Mat4, Vec3, Vec4};

use crate::frame::Frame;
use crate::render::contact::ground;
use crate::render::light::{Light, SunBox};
use crate::render::look;
use crate::render::renderer::Viewport;

/// The ground's height in a scene without ground, in scene units.
const NO_GROUND: f32 = -1e6;

/// `Globals` in WGSL.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Globals {
    clip_from_world: Mat4,
    /// x and y from −1 to 1, depth from 0 nearest the sun.
    map_from_world: Mat4,
    /// In world space; w is the size of a pixel at distance 1.
    eye_in_world: Vec4,
    /// The view ray at the viewport's top left corner.
    first_ray_in_world: Vec4,
    /// The ray's change from a pixel to its right neighbour; w is the viewport's width in pixels.
    ray_right_in_world: Vec4,
    /// The ray's change from a pixel to the one below; w is the viewport's height in pixels.
    ray_down_in_world: Vec4,
    /// Unit direction.
    towards_sun_in_world: Vec4,
    /// Unit direction to the light of the shadow map; w is a shadow texel's side in scene units.
    towards_light_in_world: Vec4,
    /// How much the shadow map counts for the sun and for the sky; z is one over the number of sub-frames.
    weights: Vec4,
    /// Light before the tone curve; w is the outline's width in pixels.
    horizon: Vec4,
    /// Light before the tone curve; w is the ground's height in scene units.
    zenith: Vec4,
    /// The light of the sun on surfaces that face it, exposure included.
    sun: Vec4,
    /// The light of the whole sky, exposure included.
    sky: Vec4,
    /// The light from below, exposure included; w is the exposure.
    ground: Vec4,
    /// Linear light.
    accent: Vec4,
    /// The light behind everything in a sub-frame, and its opacity.
    backdrop: Vec4,
}

impl Globals {
    /// The globals of a picture that fills a viewport.
    pub fn new(frame: &Frame, light: &Light, sun: Option<&SunBox>, viewport: Viewport) -> Self {
        let (view, lighting) = (&frame.view, &frame.lighting);
        let [width, height] = [viewport.width, viewport.height].map(|side| side as f32);
        let up = (view.vertical_fov * 0.5).tan();
        let right = up * view.aspect;
        let (right_step, down_step) = (2.0 * right / width, -2.0 * up / height);
        // The middle of the picture is beside the view's axis where a sub-frame's is moved.
        let middle = view.clip_from_eye.z_axis;
        let first = Vec3::new((middle.x - 1.0) * right, (middle.y + 1.0) * up, -1.0);
        let ray = |in_eye: Vec3, w: f32| view.world_from_eye.transform_vector3(in_eye).extend(w);
        let eye_in_world = Vec3::from(view.world_from_eye.translation);
        // Without shadows everything is nearer the sun than the map's content.
        let no_shadow = Mat4::from_cols(Vec4::ZERO, Vec4::ZERO, Vec4::ZERO, Vec4::new(0.0, 0.0, -1.0, 1.0));
        Self {
            clip_from_world: view.clip_from_eye * Mat4::from(view.eye_from_world),
            map_from_world: sun.map_or(no_shadow, |sun| sun.map_from_world),
            eye_in_world: eye_in_world.extend(2.0 * up / height),
            first_ray_in_world: ray(first, 0.0),
            ray_right_in_world: ray(Vec3::X * right_step, width),
            ray_down_in_world: ray(Vec3::Y * down_step, height),
            towards_sun_in_world: lighting.towards_sun_in_world.extend(0.0),
            towards_light_in_world: light.towards_in_world.extend(sun.map_or(0.0, |sun| sun.texel)),
            weights: Vec4::new(light.of_sun, light.of_sky, light.of_mean, 0.0),
            horizon: lighting.horizon.map(look::untoned).extend(look::OUTLINE_PX),
            zenith: lighting
                .zenith
                .map(look::untoned)
                .extend(ground(frame).map_or(NO_GROUND, |item| item.world_from_shape.translation.y)),
            sun: (lighting.sun * look::EXPOSURE).extend(0.0),
            sky: (lighting.sky * look::EXPOSURE).extend(0.0),
            ground: (lighting.ground * look::EXPOSURE).extend(look::EXPOSURE),
            accent: look::PALETTE.accent.extend(0.0),
            backdrop: light.backdrop,
        }
    }
}
