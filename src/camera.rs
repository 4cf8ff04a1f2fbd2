//! Cameras, projection, rays through pixels, and the arcball's mathematics. This module does not know what is moved.

use glam::{Affine3A, Mat4, Quat, Vec2, Vec3};

use crate::rbt::Rbt;
use crate::scene::Ray;

/// Distance of the near plane from the eye, in scene units.
pub const NEAR: f32 = 0.05;

/// A perspective camera: position, field of view and picture size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Eye space (−Z forward, Y up) to world space.
    pub world_from_eye: Rbt,
    /// Vertical field of view in radians, between 0 and π.
    pub vertical_fov: f32,
    /// Size of the picture in pixels; both above 0.
    pub size_px: Vec2,
}

impl Camera {
    /// Eye to clip space: reversed depth, infinite far plane, so that depth precision does not depend on the view distance.
    #[must_use]
    pub fn clip_from_eye(&self) -> Mat4 {
        let focal = 1.0 / (self.vertical_fov * 0.5).tan();
        let aspect = self.size_px.x / self.size_px.y;
        Mat4::from_cols_array_2d(&[
            [focal / aspect, 0.0, 0.0, 0.0],
            [0.0, focal, 0.0, 0.0],
            [0.0, 0.0, 0.0, -1.0],
            [0.0, 0.0, NEAR, 0.0],
        ])
    }

    /// World to eye space.
    #[must_use]
    pub fn eye_from_world(&self) -> Affine3A {
        self.world_from_eye.inverse().to_affine()
    }

    /// The side of a pixel in scene units at depth 1.
    #[must_use]
    pub fn units_per_pixel_at_unit_depth(&self) -> f32 {
        2.0 * (self.vertical_fov * 0.5).tan() / self.size_px.y
    }

    /// The ray through a pixel (origin at the top left, y down), from the eye.
    #[must_use]
    pub fn ray_through(&self, pixel: Vec2) -> Ray {
        let scale = self.units_per_pixel_at_unit_depth();
        let from_centre = pixel - self.size_px * 0.5;
        let direction_in_eye = Vec3::new(from_centre.x * scale, -from_centre.y * scale, -1.0);
        Ray {
            origin_in_world: self.world_from_eye.translation,
            direction_in_world: self.world_from_eye.transform_vector(direction_in_eye),
        }
    }

    /// The pixel where a point is seen, and its depth in front of the eye; `None` at or behind the near plane.
    #[must_use]
    pub fn project(&self, point_in_world: Vec3) -> Option<(Vec2, f32)> {
        let in_eye = self.world_from_eye.inverse().transform_point(point_in_world);
        let depth = -in_eye.z;
        if depth <= NEAR {
            return None;
        }
        let scale = self.units_per_pixel_at_unit_depth() * depth;
        Some((self.size_px * 0.5 + Vec2::new(in_eye.x, -in_eye.y) / scale, depth))
    }
}

/// The ball that a drag turns, in pixels (Gortler, chapter 8).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arcball {
    /// Its centre, in pixels from the top left.
    pub centre_px: Vec2,
    /// Its radius in pixels; above 0.
    pub radius_px: f32,
}

impl Arcball {
    /// The rotation, in axes of the eye, for a drag from one pixel to another: `(0, v₂)(0, −v₁)` for the two points on the ball, which
    /// turns by twice the angle between them. A pixel outside the ball stands for the nearest point of its silhouette.
    #[must_use]
    pub fn rotation(&self, from_px: Vec2, to_px: Vec2) -> Quat {
        let (from, to) = (self.on_ball(from_px), self.on_ball(to_px));
        let vector = from.cross(to);
        let rotation = Quat::from_xyzw(vector.x, vector.y, vector.z, from.dot(to));
        if rotation.length_squared() > 0.0 { rotation.normalize() } else { Quat::IDENTITY }
    }

    /// The direction from the centre to the point of the ball under a pixel, in axes of the eye; unit.
    fn on_ball(&self, pixel: Vec2) -> Vec3 {
        let from_centre = (pixel - self.centre_px) / self.radius_px;
        let planar = Vec2::new(from_centre.x, -from_centre.y);
        let length_squared = planar.length_squared();
        if length_squared >= 1.0 {
            (planar / length_squared.sqrt()).extend(0.0)
        } else {
            planar.extend((1.0 - length_squared).sqrt())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera() -> Camera {
        Camera {
            world_from_eye: Rbt::new(Vec3::new(1.0, 2.0, 3.0), Quat::from_rotation_y(0.7)),
            vertical_fov: 1.0,
            size_px: Vec2::new(640.0, 480.0),
        }
    }

    #[test]
    fn a_ray_passes_through_what_projects_to_its_pixel() {
        let camera = camera();
        let pixel = Vec2::new(100.0, 200.0);
        let ray = camera.ray_through(pixel);
        let (back, depth) = camera.project(ray.origin_in_world + ray.direction_in_world * 5.0).unwrap();
        assert!(back.distance(pixel) < 1e-2 && (depth - 5.0).abs() < 1e-4, "{back} at {depth}");
    }

    #[test]
    fn the_matrix_agrees_with_the_projection() {
        let camera = camera();
        let point = Vec3::new(0.0, 1.5, -2.0);
        let clip = camera.clip_from_eye() * glam::Mat4::from(camera.eye_from_world()) * point.extend(1.0);
        let ndc = clip / clip.w;
        let (pixel, depth) = camera.project(point).unwrap();
        let expected = Vec2::new((ndc.x + 1.0) * 320.0, (1.0 - ndc.y) * 240.0);
        assert!(pixel.distance(expected) < 1e-2);
        assert!((ndc.z - NEAR / depth).abs() < 1e-6);
    }

    #[test]
    fn a_drag_across_half_the_ball_turns_it_by_half_a_turn() {
        let ball = Arcball { centre_px: Vec2::new(320.0, 240.0), radius_px: 100.0 };
        let rotation = ball.rotation(Vec2::new(320.0, 240.0), Vec2::new(420.0, 240.0));
        assert!((rotation * Vec3::Z).distance(Vec3::NEG_Z) < 1e-5);
        assert_eq!(ball.rotation(Vec2::ZERO, Vec2::ZERO), Quat::IDENTITY);
    }
}
