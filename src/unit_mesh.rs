//! The unit meshes that shapes are drawn with, in levels of detail, each vertex a core point and a normal; and shapes as triangles.
//!
//! A vertex lies at `core * (half_extents − rounding) + normal * rounding` in shape space, so that bevels keep their radius and capsules
//! their caps at any size. Triangles run anticlockwise seen from outside.

mod capsule;
mod cone;
mod cylinder;
mod edges;
mod levels;
mod plane;
mod round;
mod rounded_box;
mod sphere;
mod triangles;

use std::ops::Range;
use std::sync::LazyLock;

use bytemuck::{Pod, Zeroable};
use glam::Vec3;

pub use edges::{Edge, edges};
pub use levels::{LEVELS, LEVELS_OF_KIND, Level, MESHES, PLANE};
pub use triangles::triangle_mesh;

/// One corner of a mesh.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Vertex {
    /// The position in the unit cube, −1 to 1, before rounding.
    pub core: [f32; 3],
    /// Unit normal; rounding moves the corner along it.
    pub normal: [f32; 3],
}

/// Corners and triangles, three indices each.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// The vertices.
    pub vertices: Vec<Vertex>,
    /// Three vertex indices per triangle.
    pub indices: Vec<u16>,
}

/// The range of a mesh in [`Geometry`].
#[derive(Clone, Debug, Default)]
pub struct MeshRange {
    /// The range of its indices.
    pub indices: Range<u32>,
    /// The vertex of its index 0.
    pub first_vertex: i32,
}

/// All meshes, one after the other.
#[derive(Debug, Default)]
pub struct Geometry {
    /// The vertices of all meshes.
    pub vertices: Vec<Vertex>,
    /// Three vertex indices per triangle, relative to the mesh's first vertex.
    pub indices: Vec<u16>,
    /// The range of each of [`LEVELS`].
    pub ranges: [MeshRange; MESHES],
}

/// All meshes, computed once per process.
#[must_use]
pub fn geometry() -> &'static Geometry {
    static GEOMETRY: LazyLock<Geometry> = LazyLock::new(|| {
        let mut geometry = Geometry::default();
        for (range, mesh) in geometry.ranges.iter_mut().zip(Mesh::all()) {
            let start = geometry.indices.len() as u32;
            let first_vertex = geometry.vertices.len() as i32;
            geometry.vertices.extend(mesh.vertices);
            geometry.indices.extend(mesh.indices);
            *range = MeshRange { indices: start..geometry.indices.len() as u32, first_vertex };
        }
        geometry
    });
    &GEOMETRY
}

impl Mesh {
    /// All [`MESHES`], in the order of [`LEVELS`].
    fn all() -> [Self; MESHES] {
        LEVELS.map(Level::mesh)
    }

    fn vertex(&mut self, core: Vec3, normal: Vec3) -> u16 {
        let index = u16::try_from(self.vertices.len()).expect("a unit mesh has far fewer than 65536 corners");
        self.vertices.push(Vertex { core: core.to_array(), normal: normal.to_array() });
        index
    }

    fn triangle(&mut self, a: u16, b: u16, c: u16) {
        self.indices.extend([a, b, c]);
    }

    /// A quad whose corners run anticlockwise.
    fn quad(&mut self, a: u16, b: u16, c: u16, d: u16) {
        self.triangle(a, b, c);
        self.triangle(a, c, d);
    }

    /// A triangle turned so that it faces `outwards`.
    fn triangle_facing(&mut self, outwards: Vec3, [a, b, c]: [u16; 3], at: impl Fn(u16) -> Vec3) {
        if (at(b) - at(a)).cross(at(c) - at(a)).dot(outwards) >= 0.0 {
            self.triangle(a, b, c);
        } else {
            self.triangle(a, c, b);
        }
    }
}

#[cfg(test)]
mod tests;
