//! The mesh of planes.

use glam::Vec3;

use super::Mesh;
use super::levels::{Cut, Level};
use crate::scene::MeshKind;

/// Cells along each side of a plane: large triangles interpolate inaccurately.
const PLANE_CELLS: u16 = 8;

/// Its levels, the finest first.
pub(super) const LEVELS: [Level; 1] = [Level::new(MeshKind::Plane, Cut::Flat, 1.0, 0.0)];

/// A square of cells.
pub(super) fn mesh() -> Mesh {
    let mut mesh = Mesh::default();
    let at = |cell: u16| 2.0 * f32::from(cell) / f32::from(PLANE_CELLS) - 1.0;
    for z in 0..=PLANE_CELLS {
        for x in 0..=PLANE_CELLS {
            mesh.vertex(Vec3::new(at(x), 0.0, at(z)), Vec3::Y);
        }
    }
    let index = |x: u16, z: u16| z * (PLANE_CELLS + 1) + x;
    for z in 0..PLANE_CELLS {
        for x in 0..PLANE_CELLS {
            mesh.quad(index(x, z), index(x, z + 1), index(x + 1, z + 1), index(x + 1, z));
        }
    }
    mesh
}
