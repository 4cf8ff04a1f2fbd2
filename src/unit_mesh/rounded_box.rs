//! The meshes of boxes.

use std::f32::consts::FRAC_PI_2;

use glam::Vec3;

use super::Mesh;
use super::levels::{Cut, Level};
use crate::scene::MeshKind;

/// Its levels, the finest first.
pub(super) const LEVELS: [Level; 4] = [
    Level::new(MeshKind::Box, Cut::Bevel(3), 0.945, 0.020_3),
    Level::new(MeshKind::Box, Cut::Bevel(2), 0.905, 0.039_4),
    Level::new(MeshKind::Box, Cut::Bevel(1), 0.664, 0.107_2),
    Level::new(MeshKind::Box, Cut::Bevel(0), 0.0, 0.732_1),
];

/// A box whose rounded edges have this number of steps; with 0 it has sharp edges.
pub(super) fn mesh(steps: u16) -> Mesh {
    let mut mesh = rounded(steps.max(1));
    if steps == 0 {
        // The faces come first.
        mesh.indices.truncate(6 * 6);
    }
    mesh
}

/// Six faces, and the eight corner patches and twelve rounded edges that join them.
fn rounded(n: u16) -> Mesh {
    let mut mesh = Mesh::default();
    // Corner patches: rings from the x axis (i = 0) to the edge between y and z (i = n).
    let direction = |i: u16, j: u16| {
        let on_edge = |steps: u16, of: u16| if of == 0 { 0.0 } else { FRAC_PI_2 * f32::from(steps) / f32::from(of) };
        let (down, around) = (on_edge(i, n), on_edge(j, i));
        Vec3::new(down.cos(), down.sin() * around.cos(), down.sin() * around.sin())
    };
    let index_in_patch = |i: u16, j: u16| i * (i + 1) / 2 + j;
    let patch_size = (n + 1) * (n + 2) / 2;
    let signs = |corner: u16| Vec3::new(sign(corner, 0), sign(corner, 1), sign(corner, 2));
    for corner in 0..8 {
        for i in 0..=n {
            for j in 0..=i {
                let mut normal = direction(i, j) * signs(corner);
                normal = Vec3::from_array(normal.to_array().map(|c| if c.abs() < 1e-6 { 0.0 } else { c }));
                mesh.vertex(signs(corner), normal.normalize());
            }
        }
    }
    let at = |corner: u16, i: u16, j: u16| corner * patch_size + index_in_patch(i, j);
    let positions: Vec<Vec3> =
        mesh.vertices.iter().map(|v| Vec3::from_array(v.core) + 0.5 * Vec3::from_array(v.normal)).collect();
    let position = |index: u16| positions[usize::from(index)];
    let pole = |axis: u16, corner: u16| match axis {
        0 => at(corner, 0, 0),
        1 => at(corner, n, 0),
        _ => at(corner, n, n),
    };
    for axis in 0..3u16 {
        let (u, v) = (1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3));
        for side in [0, 1 << axis] {
            let [a, b, c, d] = [side, side | u, side | u | v, side | v].map(|corner| pole(axis, corner));
            let outwards = Vec3::from_array(mesh.vertices[usize::from(a)].normal);
            mesh.triangle_facing(outwards, [a, b, c], position);
            mesh.triangle_facing(outwards, [a, c, d], position);
        }
    }
    for corner in 0..8 {
        for i in 0..n {
            for j in 0..=i {
                mesh.triangle_facing(
                    signs(corner),
                    [at(corner, i, j), at(corner, i + 1, j), at(corner, i + 1, j + 1)],
                    position,
                );
                if j < i {
                    mesh.triangle_facing(
                        signs(corner),
                        [at(corner, i, j), at(corner, i + 1, j + 1), at(corner, i, j + 1)],
                        position,
                    );
                }
            }
        }
    }
    // The three borders of a patch: towards z = 0, y = 0 and x = 0.
    let border = |axis: u16, corner: u16, step: u16| match axis {
        2 => at(corner, step, 0),
        1 => at(corner, step, step),
        _ => at(corner, n, step),
    };
    for axis in 0..3 {
        for corner in (0..8).filter(|corner| corner >> axis & 1 == 0) {
            let across = corner | 1 << axis;
            for step in 0..n {
                let [a, b] = [step, step + 1].map(|s| border(axis, corner, s));
                let [c, d] = [step + 1, step].map(|s| border(axis, across, s));
                let outwards = signs(corner) + signs(across);
                mesh.triangle_facing(outwards, [a, b, c], position);
                mesh.triangle_facing(outwards, [a, c, d], position);
            }
        }
    }
    mesh
}

fn sign(corner: u16, axis: u16) -> f32 {
    if corner >> axis & 1 == 1 { 1.0 } else { -1.0 }
}
