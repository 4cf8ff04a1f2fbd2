//! The meshes of cones.

use glam::Vec3;

use super::Mesh;
use super::levels::{Cut, Level};
use super::round::{around, disc};
use crate::scene::MeshKind;

/// Its levels, the finest first.
pub(super) const LEVELS: [Level; 3] = [
    Level::new(MeshKind::Cone, Cut::Around(32), 1.002_4, 0.002_4),
    Level::new(MeshKind::Cone, Cut::Around(20), 1.006_2, 0.006_2),
    Level::new(MeshKind::Cone, Cut::Around(10), 1.025_1, 0.025_1),
];

/// The unit cone has radius 1 and height 2. An instance's affine transforms its normals.
pub(super) fn mesh(steps: u16) -> Mesh {
    let mut mesh = Mesh::default();
    let slope = |direction: Vec3| (direction * 2.0 + Vec3::Y).normalize();
    let rim: Vec<u16> = (0..steps).map(|s| mesh.vertex(around(s, steps) - Vec3::Y, slope(around(s, steps)))).collect();
    for s in 0..steps {
        let between = around(2 * s + 1, 2 * steps);
        let apex = mesh.vertex(Vec3::Y, slope(between));
        mesh.triangle(rim[usize::from(s)], rim[usize::from((s + 1) % steps)], apex);
    }
    disc(&mut mesh, -1.0, steps);
    mesh
}
