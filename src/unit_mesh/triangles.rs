//! Shapes as triangles, for other programs.

use glam::Vec3;

use super::Level;
use crate::model::{Material, TriangleMesh};
use crate::scene::{MeshKind, Shape};

/// The triangles of a shape as the renderer draws it from near: hard edges where it has them. A plane is two triangles, a mesh its
/// own ones.
#[must_use]
pub fn triangle_mesh(shape: &Shape, name: String) -> TriangleMesh {
    let kind = match shape {
        Shape::Mesh(shape) => return TriangleMesh { name, ..(**shape.mesh()).clone() },
        _ => shape.mesh().unwrap_or(MeshKind::Box),
    };
    let level = Level::finest(kind);
    let (half_extents, rounding) = level.fitted(shape.half_extents(), shape.rounding());
    let (positions, normals, indices) = if level.kind == MeshKind::Plane {
        let corners = [[-1.0, -1.0], [-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]];
        let positions = corners.map(|[x, z]| Vec3::new(x, 0.0, z) * half_extents);
        (positions.to_vec(), vec![Vec3::Y; 4], vec![0, 1, 2, 0, 2, 3])
    } else {
        let mesh = level.mesh();
        let corners = mesh.vertices.iter().map(|vertex| {
            let (core, normal) = (Vec3::from(vertex.core), Vec3::from(vertex.normal));
            // A cone's slope depends on its size.
            let turned = if level.kind == MeshKind::Cone { (normal / half_extents).normalize() } else { normal };
            (core * (half_extents - rounding) + normal * rounding, turned)
        });
        let (positions, normals): (Vec<Vec3>, Vec<Vec3>) = corners.unzip();
        (positions, normals, mesh.indices.iter().map(|&index| u32::from(index)).collect())
    };
    TriangleMesh {
        name,
        positions,
        normals,
        colours: Vec::new(),
        texture_coordinates: Vec::new(),
        indices,
        material: Material::default(),
        skin: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::shapes::{Capsule, Cone, Cylinder, Plane, RoundedBox, Sphere};

    #[test]
    fn triangles_face_outwards_and_fill_the_shape() {
        let shapes = [
            Shape::Box(RoundedBox { size: Vec3::new(1.0, 2.0, 0.5), bevel: 0.1 }),
            Shape::Sphere(Sphere { radius: 0.7 }),
            Shape::Cylinder(Cylinder { radius: 0.4, height: 1.5 }),
            Shape::Cone(Cone { radius: 0.5, height: 3.0 }),
            Shape::Capsule(Capsule { radius: 0.3, height: 1.4 }),
            Shape::Plane(Plane { size: [4.0, 6.0] }),
        ];
        for shape in shapes {
            let mesh = triangle_mesh(&shape, String::new());
            assert!(mesh.half_extents().abs_diff_eq(shape.half_extents(), 0.02), "{shape:?} {}", mesh.half_extents());
            let mut volume = 0.0;
            for ([a, b, c], corners) in mesh.triangles().zip(mesh.indices.chunks_exact(3)) {
                let across = (b - a).cross(c - a);
                volume += a.dot(across) / 6.0;
                for &corner in corners {
                    let normal = mesh.normals[corner as usize];
                    assert!(normal.is_normalized() && normal.dot(across) >= 0.0, "{shape:?}: {normal} {across}");
                }
            }
            let expected = match shape {
                Shape::Cone(Cone { radius, height }) => std::f32::consts::PI * radius * radius * height / 3.0,
                Shape::Sphere(Sphere { radius }) => 4.0 / 3.0 * std::f32::consts::PI * radius.powi(3),
                Shape::Plane(_) => 0.0,
                _ => continue,
            };
            assert!((volume - expected).abs() <= 0.02 * expected, "{shape:?}: {volume} and {expected}");
        }
        let cone = triangle_mesh(&Shape::Cone(Cone { radius: 0.5, height: 3.0 }), String::new());
        // The slope rises by 3 over 0.5.
        assert!((cone.normals[0].y - (1.0 / 37.0_f32).sqrt()).abs() < 0.01, "{}", cone.normals[0]);
    }
}
