//! The edges of unit meshes: where two triangles meet.

use std::collections::HashMap;
use std::sync::OnceLock;

use glam::Vec3;

use super::levels::Cut;
use super::{LEVELS, Level, MESHES, geometry};

/// Where two triangles of a mesh meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    /// The two triangles.
    pub triangles: [u16; 2],
    /// Of each triangle the two vertices of the edge, as the triangle runs.
    pub vertices: [[u16; 2]; 2],
    /// Whether the surface bends there at once, so that the edge shows also between two triangles that face the eye.
    pub is_sharp: bool,
}

/// The cosine of the angle between the normals of a vertex, beyond which an edge is sharp.
const SHARP_COSINE: f32 = 0.9;

/// The edges of the mesh of a level, by its index in [`LEVELS`], computed on first use.
#[must_use]
pub fn edges(level: usize) -> &'static [Edge] {
    static EDGES: [OnceLock<Vec<Edge>>; MESHES] = [const { OnceLock::new() }; MESHES];
    EDGES[level].get_or_init(|| edges_of(level))
}

fn edges_of(level: usize) -> Vec<Edge> {
    let range = &geometry().ranges[level];
    let vertices = &geometry().vertices[range.first_vertex as usize..];
    let indices = &geometry().indices[range.indices.start as usize..range.indices.end as usize];
    let place = |index: u16| {
        let vertex = &vertices[usize::from(index)];
        let (core, normal) = (Vec3::from(vertex.core), Vec3::from(vertex.normal));
        let at = if is_rounded(LEVELS[level]) { core * 0.63 + normal * 0.37 } else { core };
        (at * 4096.0).round().as_ivec3().to_array()
    };
    let normal = |index: u16| Vec3::from(vertices[usize::from(index)].normal);
    let mut edges = Vec::new();
    let mut open: HashMap<[[i32; 3]; 2], (u16, [u16; 2])> = HashMap::new();
    for (triangle, corners) in (0..).zip(indices.chunks_exact(3)) {
        for (from, to) in [(corners[0], corners[1]), (corners[1], corners[2]), (corners[2], corners[0])] {
            let ends = [place(from), place(to)];
            if ends[0] == ends[1] {
                continue;
            }
            match open.remove(&[ends[1], ends[0]]) {
                Some((other, [other_from, other_to])) => edges.push(Edge {
                    triangles: [other, triangle],
                    vertices: [[other_from, other_to], [from, to]],
                    is_sharp: normal(other_from).dot(normal(to)) < SHARP_COSINE,
                }),
                None => {
                    open.insert(ends, (triangle, [from, to]));
                }
            }
        }
    }
    edges
}

/// Whether the vertices are where their normals move them to.
const fn is_rounded(level: Level) -> bool {
    match level.cut {
        Cut::Bevel(steps) => steps > 0,
        Cut::Faces(_) | Cut::Capsule(..) => true,
        Cut::Around(_) | Cut::Flat => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::MeshKind;

    /// A closed mesh has three half edges a triangle, and each half has its other half. A plane is open.
    #[test]
    fn closed_meshes_have_three_edges_for_two_triangles() {
        for (level, range) in geometry().ranges.iter().enumerate() {
            let triangles = range.indices.len() / 3;
            let is_open = LEVELS[level].kind == MeshKind::Plane;
            assert_eq!(edges(level).len() == triangles * 3 / 2, !is_open, "{:?}", LEVELS[level]);
        }
    }

    #[test]
    fn a_sharp_box_has_twelve_sharp_edges_and_a_sphere_none() {
        for (index, level) in LEVELS.iter().enumerate() {
            let sharp = edges(index).iter().filter(|edge| edge.is_sharp).count();
            match level.cut {
                Cut::Bevel(0) => assert_eq!(sharp, 12),
                Cut::Faces(cuts) if cuts > 2 => assert_eq!(sharp, 0),
                Cut::Around(steps) => assert!(sharp >= usize::from(steps), "{sharp} of {steps}"),
                _ => {}
            }
        }
    }
}
