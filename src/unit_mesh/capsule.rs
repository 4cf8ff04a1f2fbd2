//! The meshes of capsules.

use std::f32::consts::FRAC_PI_2;

use glam::Vec3;

use super::Mesh;
use super::levels::{Cut, Level};
use super::round::around;
use crate::scene::MeshKind;

/// Its levels, the finest first.
pub(super) const LEVELS: [Level; 3] = [
    Level::new(MeshKind::Capsule, Cut::Capsule(18, 4), 1.007_7, 0.011_7),
    Level::new(MeshKind::Capsule, Cut::Capsule(12, 3), 1.017_3, 0.017_4),
    Level::new(MeshKind::Capsule, Cut::Capsule(10, 2), 1.025_1, 0.052_9),
];

/// A capsule with steps around the axis and from the equator to each pole.
pub(super) fn mesh(steps: u16, latitudes: u16) -> Mesh {
    let mut mesh = Mesh::default();
    let mut rings: Vec<Vec<u16>> = Vec::new();
    for half in [-1.0, 1.0] {
        for ring in 0..latitudes {
            // From just off the lower pole to the lower equator, then from the upper equator to just off the upper pole.
            let from_equator = if half < 0.0 { latitudes - 1 - ring } else { ring };
            let latitude = FRAC_PI_2 * f32::from(from_equator) / f32::from(latitudes);
            let points = (0..steps).map(|s| {
                let normal = around(s, steps) * latitude.cos() + Vec3::Y * half * latitude.sin();
                mesh.vertex(Vec3::Y * half, normal)
            });
            rings.push(points.collect());
        }
    }
    let poles = [-1.0, 1.0].map(|half| mesh.vertex(Vec3::Y * half, Vec3::Y * half));
    for s in 0..usize::from(steps) {
        let next = (s + 1) % usize::from(steps);
        for (low, high) in rings.iter().zip(rings.iter().skip(1)) {
            mesh.quad(low[s], low[next], high[next], high[s]);
        }
        mesh.triangle(poles[0], rings[0][next], rings[0][s]);
        let last = &rings[rings.len() - 1];
        mesh.triangle(last[s], last[next], poles[1]);
    }
    mesh
}
