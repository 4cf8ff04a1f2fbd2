//! Meshes are closed, face outwards, and keep their roundings.

use std::collections::HashMap;

use glam::Vec3;

use super::Mesh;
use crate::scene::{MeshKind, Shape};

/// A shape of each kind, in [`MeshKind::ALL`]'s order.
fn samples() -> [Shape; 6] {
    [
        Shape::Box { size: Vec3::new(1.0, 2.0, 0.5), bevel: 0.1 },
        Shape::Sphere { radius: 0.7 },
        Shape::Cylinder { radius: 0.4, height: 1.5 },
        Shape::Cone { radius: 0.5, height: 1.2 },
        Shape::Capsule { radius: 0.3, height: 1.4 },
        Shape::Plane { size: [4.0, 6.0] },
    ]
}

fn corners(shape: &Shape) -> (Mesh, Vec<Vec3>) {
    let mesh = Mesh::unit(shape.mesh());
    let place = |v: &super::Vertex| {
        Vec3::from_array(v.core) * (shape.half_extents() - shape.rounding())
            + Vec3::from_array(v.normal) * shape.rounding()
    };
    let places = mesh.vertices.iter().map(place).collect();
    (mesh, places)
}

#[test]
fn samples_cover_every_kind() {
    assert_eq!(samples().map(|shape| shape.mesh()), MeshKind::ALL);
}

#[test]
fn every_edge_of_a_solid_is_shared_by_two_triangles_that_run_opposite_ways() {
    for shape in &samples()[..5] {
        let (mesh, places) = corners(shape);
        let key = |index: u16| places[usize::from(index)].to_array().map(|c| (c * 1e4).round() as i32);
        let mut edges: HashMap<_, i32> = HashMap::new();
        for t in mesh.indices.chunks_exact(3) {
            for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
                assert_ne!(key(a), key(b), "{shape:?}: an edge of no length");
                *edges.entry((key(a), key(b))).or_default() += 1;
            }
        }
        for (&(a, b), &count) in &edges {
            assert_eq!(count, 1, "{shape:?}: edge {a:?} {b:?}");
            assert!(edges.contains_key(&(b, a)), "{shape:?}: edge {a:?} {b:?} is open");
        }
    }
}

#[test]
fn triangles_face_outwards_and_agree_with_their_normals() {
    for shape in samples() {
        let (mesh, places) = corners(&shape);
        for t in mesh.indices.chunks_exact(3) {
            let [a, b, c] = [t[0], t[1], t[2]].map(|i| places[usize::from(i)]);
            let face = (b - a).cross(c - a);
            assert!(shape.mesh() == MeshKind::Plane || face.dot(a + b + c) > 0.0, "{shape:?}: faces inwards");
            if shape.mesh() == MeshKind::Cone {
                continue; // Its normals are those of the unit cone.
            }
            for &i in t {
                let normal = Vec3::from_array(mesh.vertices[usize::from(i)].normal);
                assert!((normal.length() - 1.0).abs() < 1e-5);
                assert!(face.normalize().dot(normal) > 0.8, "{shape:?}: {face} against {normal}");
            }
        }
    }
}

#[test]
fn meshes_fill_their_extents_exactly_and_stay_small() {
    for shape in samples() {
        let (mesh, places) = corners(&shape);
        let most = places.iter().fold(Vec3::ZERO, |most, place| most.max(place.abs()));
        let slack = shape.half_extents() - most;
        assert!(slack.min_element() > -1e-5 && slack.max_element() < 0.06, "{shape:?}: {most}");
        assert!(mesh.indices.len() / 3 <= 330, "{shape:?}: {} triangles", mesh.indices.len() / 3);
    }
}
