//! Poses of other programs: they may hold NaN, and rotations that are not of unit length.

use super::Painter;
use crate::camera::Camera;
use crate::pose::Pose;
use crate::render::{GpuError, Image};
use crate::scene::SceneGraph;
use crate::view::frame_of_scene;

/// Shapes that are farther from the world's centre are not drawn, in scene units.
const FARTHEST: f32 = 1e5;

impl Painter {
    /// Draws a pose as another program showed it, from the scene's first eye. Shapes whose transforms are not finite, or that are farther
    /// than 1e5 scene units away, are left out; a camera with such a transform is put where it is in `right`.
    ///
    /// # Errors
    /// [`GpuError`]
    pub fn loose_pose(&mut self, scene: &SceneGraph, pose: &Pose, right: &Pose) -> Result<Image, GpuError> {
        let eye = scene.eyes()[0];
        let own = scene.world_from_rbt(pose, 0.0, eye);
        let is_sound = own.translation.abs().max_element() < FARTHEST && (own.rotation.length() - 1.0).abs() < 0.5;
        let mut world_from_eye = if is_sound { own } else { scene.world_from_rbt(right, 0.0, eye) };
        world_from_eye.rotation = world_from_eye.rotation.normalize();
        let camera = Camera { world_from_eye, vertical_fov: scene.vertical_fov(), size_px: self.size_px() };
        let mut frame = frame_of_scene(scene, pose, 0.0, &camera, Some(eye));
        frame.items.retain(|item| {
            let matrix = item.world_from_shape;
            matrix.is_finite() && matrix.to_cols_array().iter().all(|number| number.abs() < FARTHEST)
        });
        self.image(&frame)
    }
}
