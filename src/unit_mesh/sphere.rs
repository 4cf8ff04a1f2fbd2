//! The meshes of spheres.

use glam::Vec3;

use super::Mesh;
use super::levels::{Cut, Level};
use crate::scene::MeshKind;

/// Its levels, the finest first.
pub(super) const LEVELS: [Level; 3] = [
    Level::new(MeshKind::Sphere, Cut::Faces(4), 1.006_7, 0.006_7),
    Level::new(MeshKind::Sphere, Cut::Faces(3), 1.010_9, 0.010_9),
    Level::new(MeshKind::Sphere, Cut::Faces(2), 1.025_1, 0.025_1),
];

/// An icosahedron with each edge divided into `cuts` parts, projected on the ball.
pub(super) fn mesh(cuts: u16) -> Mesh {
    let golden = f32::midpoint(1.0, 5.0_f32.sqrt());
    let mut corners = Vec::new();
    for (a, b) in [(-1.0, -golden), (1.0, -golden), (-1.0, golden), (1.0, golden)] {
        corners.extend([Vec3::new(0.0, a, b), Vec3::new(a, b, 0.0), Vec3::new(b, 0.0, a)]);
    }
    let mut mesh = Mesh::default();
    for (i, &a) in corners.iter().enumerate() {
        for (j, &b) in corners.iter().enumerate().skip(i + 1) {
            for &c in corners.iter().skip(j + 1) {
                let is_face = [a - b, b - c, c - a].iter().all(|edge| (edge.length() - 2.0).abs() < 0.01);
                if is_face {
                    let (b, c) = if (b - a).cross(c - a).dot(a) > 0.0 { (b, c) } else { (c, b) };
                    cut_face(&mut mesh, [a, b, c], cuts);
                }
            }
        }
    }
    mesh
}

fn cut_face(mesh: &mut Mesh, [a, b, c]: [Vec3; 3], cuts: u16) {
    let mut rows: Vec<Vec<u16>> = Vec::new();
    for i in 0..=cuts {
        let row = (0..=i).map(|j| {
            let (down, across) = (f32::from(i) / f32::from(cuts), f32::from(j) / f32::from(cuts));
            let normal = (a * (1.0 - down) + b * (down - across) + c * across).normalize();
            let same = mesh.vertices.iter().position(|v| Vec3::from_array(v.normal).distance(normal) < 1e-4);
            same.and_then(|index| u16::try_from(index).ok()).unwrap_or_else(|| mesh.vertex(Vec3::ZERO, normal))
        });
        rows.push(row.collect());
    }
    for (upper, lower) in rows.iter().zip(rows.iter().skip(1)) {
        for j in 0..upper.len() {
            mesh.triangle(upper[j], lower[j], lower[j + 1]);
            if j + 1 < upper.len() {
                mesh.triangle(upper[j], lower[j + 1], upper[j + 1]);
            }
        }
    }
}
