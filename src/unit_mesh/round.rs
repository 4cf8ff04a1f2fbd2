//! Shared by cylinders, cones and capsules: points around the axis, and discs.

use std::f32::consts::TAU;

use glam::Vec3;

use super::Mesh;

/// The unit vector at one of `steps` directions around Y.
pub(super) fn around(step: u16, steps: u16) -> Vec3 {
    let (sin, cos) = (TAU * f32::from(step % steps) / f32::from(steps)).sin_cos();
    Vec3::new(sin, 0.0, cos)
}

/// A disc across the axis at y = ±1, which faces away from the centre.
pub(super) fn disc(mesh: &mut Mesh, y: f32, steps: u16) {
    let rim: Vec<u16> = (0..steps).map(|s| mesh.vertex(around(s, steps) + Vec3::Y * y, Vec3::Y * y)).collect();
    for pair in rim[1..].windows(2) {
        if y > 0.0 {
            mesh.triangle(rim[0], pair[0], pair[1]);
        } else {
            mesh.triangle(rim[0], pair[1], pair[0]);
        }
    }
}
