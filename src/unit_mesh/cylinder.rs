//! The meshes of cylinders.

use glam::Vec3;

use super::Mesh;
use super::levels::{Cut, Level};
use super::round::{around, disc};
use crate::scene::MeshKind;

/// Its levels, the finest first.
pub(super) const LEVELS: [Level; 3] = [
    Level::new(MeshKind::Cylinder, Cut::Around(32), 1.002_4, 0.002_4),
    Level::new(MeshKind::Cylinder, Cut::Around(20), 1.006_2, 0.006_2),
    Level::new(MeshKind::Cylinder, Cut::Around(10), 1.025_1, 0.025_1),
];

/// A cylinder with steps around the axis.
pub(super) fn mesh(steps: u16) -> Mesh {
    let mut mesh = Mesh::default();
    let ring = |mesh: &mut Mesh, y: f32| -> Vec<u16> {
        (0..steps).map(|s| mesh.vertex(around(s, steps) + Vec3::Y * y, around(s, steps))).collect()
    };
    let (low, high) = (ring(&mut mesh, -1.0), ring(&mut mesh, 1.0));
    for s in 0..usize::from(steps) {
        let next = (s + 1) % usize::from(steps);
        mesh.quad(low[s], low[next], high[next], high[s]);
    }
    disc(&mut mesh, 1.0, steps);
    disc(&mut mesh, -1.0, steps);
    mesh
}
