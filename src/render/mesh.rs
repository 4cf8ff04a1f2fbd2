//! The unit meshes, in levels of detail, each vertex a core point and a normal.
//!
//! A vertex lies at `core * (half_extents − rounding) + normal * rounding` in shape space, so that a bevel keeps its radius and
//! a capsule its caps whatever the size. Triangles run anticlockwise seen from outside.

mod levels;

use std::f32::consts::{FRAC_PI_2, TAU};
use std::ops::Range;
use std::sync::LazyLock;

use bytemuck::{Pod, Zeroable};
use glam::Vec3;

pub use levels::{LEVELS, Level, MESHES, PLACES, PLANE};

/// Cells along each side of a plane: large triangles interpolate badly.
const PLANE_CELLS: u16 = 8;

/// One corner of a mesh.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Vertex {
    /// Where it is in the unit cube, −1 to 1, before rounding.
    pub core: [f32; 3],
    /// Unit normal, and the direction in which rounding moves it.
    pub normal: [f32; 3],
}

/// Corners and triangles, three indices each.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// Its corners.
    pub vertices: Vec<Vertex>,
    /// Its triangles' corners.
    pub indices: Vec<u16>,
}

/// Where a mesh lies in [`Geometry`].
#[derive(Clone, Debug, Default)]
pub struct Place {
    /// Its triangles' corners among all indices.
    pub indices: Range<u32>,
    /// The vertex that its index 0 means.
    pub first_vertex: i32,
}

/// All meshes, one after the other.
#[derive(Debug, Default)]
pub struct Geometry {
    /// Corners.
    pub vertices: Vec<Vertex>,
    /// Triangles' corners, three indices each, each counted from its mesh's first vertex.
    pub indices: Vec<u16>,
    /// Where each of [`LEVELS`] lies.
    pub places: [Place; MESHES],
}

/// All meshes, made once in a process for all renderers.
pub fn geometry() -> &'static Geometry {
    static GEOMETRY: LazyLock<Geometry> = LazyLock::new(|| {
        let mut geometry = Geometry::default();
        for (place, mesh) in geometry.places.iter_mut().zip(Mesh::all()) {
            let start = geometry.indices.len() as u32;
            let first_vertex = geometry.vertices.len() as i32;
            geometry.vertices.extend(mesh.vertices);
            geometry.indices.extend(mesh.indices);
            *place = Place { indices: start..geometry.indices.len() as u32, first_vertex };
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

/// Six faces, and the eight corner patches and twelve rounded edges that join them.
fn rounded_box(n: u16) -> Mesh {
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
    let places: Vec<Vec3> =
        mesh.vertices.iter().map(|v| Vec3::from_array(v.core) + 0.5 * Vec3::from_array(v.normal)).collect();
    let place = |index: u16| places[usize::from(index)];
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
            mesh.triangle_facing(outwards, [a, b, c], place);
            mesh.triangle_facing(outwards, [a, c, d], place);
        }
    }
    for corner in 0..8 {
        for i in 0..n {
            for j in 0..=i {
                mesh.triangle_facing(
                    signs(corner),
                    [at(corner, i, j), at(corner, i + 1, j), at(corner, i + 1, j + 1)],
                    place,
                );
                if j < i {
                    mesh.triangle_facing(
                        signs(corner),
                        [at(corner, i, j), at(corner, i + 1, j + 1), at(corner, i, j + 1)],
                        place,
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
                mesh.triangle_facing(outwards, [a, b, c], place);
                mesh.triangle_facing(outwards, [a, c, d], place);
            }
        }
    }
    mesh
}

fn sign(corner: u16, axis: u16) -> f32 {
    if corner >> axis & 1 == 1 { 1.0 } else { -1.0 }
}

/// An icosahedron whose edges are each cut in so many, on the ball.
fn sphere(cuts: u16) -> Mesh {
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

/// The unit vector at one of `steps` places around Y.
fn around(step: u16, steps: u16) -> Vec3 {
    let (sin, cos) = (TAU * f32::from(step % steps) / f32::from(steps)).sin_cos();
    Vec3::new(sin, 0.0, cos)
}

fn disc(mesh: &mut Mesh, y: f32, steps: u16) {
    let rim: Vec<u16> = (0..steps).map(|s| mesh.vertex(around(s, steps) + Vec3::Y * y, Vec3::Y * y)).collect();
    for pair in rim[1..].windows(2) {
        if y > 0.0 {
            mesh.triangle(rim[0], pair[0], pair[1]);
        } else {
            mesh.triangle(rim[0], pair[1], pair[0]);
        }
    }
}

fn cylinder(steps: u16) -> Mesh {
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

/// Normals of the unit cone, of radius 1 and height 2; an instance's affine carries them to its own slope.
fn cone(steps: u16) -> Mesh {
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

fn capsule(steps: u16, latitudes: u16) -> Mesh {
    let mut mesh = Mesh::default();
    let mut rings: Vec<Vec<u16>> = Vec::new();
    for half in [-1.0, 1.0] {
        for ring in 0..latitudes {
            // From just off the lower pole to the lower equator, then from the upper equator to just off the upper pole.
            let from_equator = if half < 0.0 { latitudes - 1 - ring } else { ring };
            let latitude = FRAC_PI_2 * f32::from(from_equator) / f32::from(latitudes);
            let points = (0..steps).map(|s| {
                let normal = around(s, steps) * latitude.cos() + Vec3::Y * half * latitude.sin();
                mesh.vertex(Vec3::Y * half, normal)
            });
            rings.push(points.collect());
        }
    }
    let poles = [-1.0, 1.0].map(|half| mesh.vertex(Vec3::Y * half, Vec3::Y * half));
    for s in 0..usize::from(steps) {
        let next = (s + 1) % usize::from(steps);
        for (low, high) in rings.iter().zip(rings.iter().skip(1)) {
            mesh.quad(low[s], low[next], high[next], high[s]);
        }
        mesh.triangle(poles[0], rings[0][next], rings[0][s]);
        let last = &rings[rings.len() - 1];
        mesh.triangle(last[s], last[next], poles[1]);
    }
    mesh
}

fn plane() -> Mesh {
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

#[cfg(test)]
mod tests;
