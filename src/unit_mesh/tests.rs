//! Meshes are closed, face outwards, and keep their roundings.

use std::collections::HashMap;
use std::f32::consts::PI;

use glam::Vec3;

use super::levels::Cut;
use super::{LEVELS, Level, Mesh, PLANE, Vertex};
use crate::scene::shapes::{Capsule, Cone, Cylinder, Plane, RoundedBox, Sphere};
use crate::scene::{MeshKind, Shape};

/// A shape of each kind, in [`MeshKind::ALL`]'s order.
fn samples() -> [Shape; 6] {
    [
        Shape::Box(RoundedBox { size: Vec3::new(1.0, 2.0, 0.5), bevel: 0.1 }),
        Shape::Sphere(Sphere { radius: 0.7 }),
        Shape::Cylinder(Cylinder { radius: 0.4, height: 1.5 }),
        Shape::Cone(Cone { radius: 0.5, height: 1.2 }),
        Shape::Capsule(Capsule { radius: 0.3, height: 1.4 }),
        Shape::Plane(Plane { size: [4.0, 6.0] }),
    ]
}

/// A level's shape, its mesh and where the mesh's corners are.
fn corners(level: Level) -> (Shape, Mesh, Vec<Vec3>) {
    let shape =
        samples().into_iter().find(|shape| shape.mesh() == Some(level.kind)).expect("there is one of each kind");
    let (half_extents, rounding) = level.fitted(shape.half_extents(), shape.rounding());
    let mesh = level.mesh();
    let position =
        |v: &Vertex| Vec3::from_array(v.core) * (half_extents - rounding) + Vec3::from_array(v.normal) * rounding;
    let positions = mesh.vertices.iter().map(position).collect();
    (shape, mesh, positions)
}

/// The three edges of each triangle.
fn edges(mesh: &Mesh) -> impl Iterator<Item = [usize; 2]> {
    mesh.indices.chunks_exact(3).flat_map(|t| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]]).map(|e| e.map(usize::from))
}

#[test]
fn samples_cover_every_kind() {
    assert_eq!(samples().map(|shape| shape.mesh()), MeshKind::ALL.map(Some));
}

#[test]
fn every_edge_of_a_solid_is_shared_by_two_triangles_that_run_opposite_ways() {
    for level in &LEVELS[..PLANE] {
        let (_, mesh, positions) = corners(*level);
        let key = |index: usize| positions[index].to_array().map(|c| (c * 1e4).round() as i32);
        let mut counts: HashMap<_, i32> = HashMap::new();
        for [a, b] in edges(&mesh) {
            assert_ne!(key(a), key(b), "{level:?}: an edge of no length");
            *counts.entry((key(a), key(b))).or_default() += 1;
        }
        for (&(a, b), &count) in &counts {
            assert_eq!(count, 1, "{level:?}: edge {a:?} {b:?}");
            assert!(counts.contains_key(&(b, a)), "{level:?}: edge {a:?} {b:?} is open");
        }
    }
}

#[test]
fn triangles_face_outwards_and_agree_with_their_normals() {
    for level in LEVELS {
        let (shape, mesh, positions) = corners(level);
        for t in mesh.indices.chunks_exact(3) {
            let [a, b, c] = [t[0], t[1], t[2]].map(|i| positions[usize::from(i)]);
            let face = (b - a).cross(c - a);
            assert!(shape.mesh() == Some(MeshKind::Plane) || face.dot(a + b + c) > 0.0, "{level:?}: faces inwards");
            if shape.mesh() == Some(MeshKind::Cone) {
                continue; // Its normals are those of the unit cone.
            }
            for &i in t {
                let normal = Vec3::from_array(mesh.vertices[usize::from(i)].normal);
                assert!((normal.length() - 1.0).abs() < 1e-5);
                // The coarser, the farther; on a sharp box normals are the faces' own.
                assert!(
                    face.normalize().dot(normal) > 0.8 - 6.0 * level.flattening,
                    "{level:?}: {face} against {normal}"
                );
            }
        }
    }
}

#[test]
fn meshes_fill_their_extents_but_for_their_error_and_stay_small() {
    for level in LEVELS {
        let (shape, mesh, positions) = corners(level);
        let radius = if level.kind == MeshKind::Box { 0.0 } else { shape.half_extents().x };
        let most = positions.iter().fold(Vec3::ZERO, |most, position| most.max(position.abs()));
        let slack = shape.half_extents() - most;
        assert!(slack.min_element() > -1e-5 - level.flattening * radius, "{level:?}: {most}");
        assert!(slack.max_element() < 0.06, "{level:?}: {most}");
        assert!(mesh.indices.len() / 3 <= 330, "{level:?}: {} triangles", mesh.indices.len() / 3);
    }
}

#[test]
fn levels_are_as_far_outside_what_is_round_as_inside_and_say_how_far() {
    for level in LEVELS {
        let (shape, mesh, _) = corners(level);
        let [inside, outside] = match level.cut {
            Cut::Flat => [0.0; 2],
            // The corner of a sharp box is outside the rounded box.
            Cut::Bevel(0) => [3.0_f32.sqrt() - 1.0; 2],
            _ => edges(&mesh)
                .map(|[a, b]| [a, b].map(|i| &mesh.vertices[i]))
                .filter(|[a, b]| is_round(&shape, a, b))
                .map(|[a, b]| {
                    let [a, b] = around(level, [a, b]);
                    [1.0 - ((a + b) / 2.0).length(), a.length().max(b.length()) - 1.0]
                })
                .fold([0.0_f32; 2], |most, of_edge| [most[0].max(of_edge[0]), most[1].max(of_edge[1])]),
        };
        let measured = match level.cut {
            // The corners of the triangle that replaces a rounded corner stick out most.
            Cut::Bevel(1) => (1.0 + 2.0 * (1.0 - level.radius).powi(2)).sqrt() - 1.0,
            _ => inside.max(outside),
        };
        assert!((measured - level.flattening).abs() < 2e-4, "{level:?}: measured {measured}");
        let (inside, slack) = match level.cut {
            // Its ends are cut more coarsely than it is around, where other shapes may lie close to it.
            Cut::Capsule(steps, _) => (1.0 - level.radius * (PI / f32::from(steps)).cos(), 2e-4),
            _ => (inside, 0.002),
        };
        assert!((inside - outside).abs() < slack, "{level:?}: measured {inside} and {outside}");
    }
}

/// How far a corner is from the Y axis, before it is fitted.
fn core_from_axis(vertex: &Vertex) -> f32 {
    vertex.core[0].hypot(vertex.core[2])
}

/// Whether an edge approximates a round surface: not across a disc, to an apex, between two cores of a box or inside its corners.
fn is_round(shape: &Shape, a: &Vertex, b: &Vertex) -> bool {
    match shape.mesh() {
        Some(MeshKind::Box) => {
            a.core == b.core && (0..3).any(|axis| a.normal[axis].abs() < 1e-6 && b.normal[axis].abs() < 1e-6)
        }
        Some(MeshKind::Cylinder | MeshKind::Cone) => {
            [a, b].iter().all(|v| v.normal[1].abs() < 0.9 && core_from_axis(v) > 0.9)
        }
        Some(MeshKind::Capsule) => {
            let [[ax, ay, az], [bx, by, bz]] = [a.normal, b.normal];
            // Around it, or from pole to pole.
            (ay - by).abs() < 1e-4 || (ax * bz - az * bx).abs() < 1e-4
        }
        _ => true,
    }
}

/// An edge's ends from the middle of the unit circle or ball that its shape is rounded by.
fn around(level: Level, ends: [&Vertex; 2]) -> [Vec3; 2] {
    let (half_extents, rounding) = level.fitted(Vec3::ONE, 1.0);
    let normals = ends.map(|end| Vec3::from_array(end.normal));
    // Along one of a box's edges it is a circle.
    let across = Vec3::select((normals[0].abs() + normals[1].abs()).cmpgt(Vec3::splat(1e-6)), Vec3::ONE, Vec3::ZERO);
    [0, 1].map(|end| {
        let core = Vec3::from_array(ends[end].core);
        match level.kind {
            MeshKind::Cylinder | MeshKind::Cone => core * half_extents * Vec3::new(1.0, 0.0, 1.0),
            MeshKind::Box => core * (1.0 - rounding) * across + normals[end] * rounding,
            _ => normals[end] * rounding,
        }
    })
}

#[test]
fn levels_of_a_kind_go_from_fine_to_coarse() {
    for pair in LEVELS.windows(2).filter(|pair| pair[0].kind == pair[1].kind) {
        assert!(pair[0].flattening < pair[1].flattening, "{pair:?}");
        assert!(pair[0].mesh().indices.len() > pair[1].mesh().indices.len(), "{pair:?}");
    }
}
