//! Packs a frame into the bytes of one upload to the GPU: globals, then instances by mesh, then strokes.

use std::f32::consts::TAU;
use std::mem;
use std::ops::Range;

use bytemuck::{Pod, Zeroable, bytes_of};
use glam::{Affine3A, Mat3A, Vec3, Vec4};

use crate::frame::{ArcballMark, DrawItem, Frame, ItemMesh, View};
use crate::lighting::Lighting;
use crate::render::arrange::Arranged;
use crate::render::bounds::ViewSides;
use crate::render::contact::contacts;
use crate::render::detail::Detail;
use crate::render::edges::{self, EdgeLine, Edges};
use crate::render::look;
use crate::render::mesh::{LEVELS, Level, MESHES, PLANE};
use crate::render::triangles::{Skins, TriangleDraws};
use crate::render::uniforms::Globals;
use crate::scene::MeshKind;

/// One shape: the layout of the instance buffer.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Instance {
    /// The three rows of an affine, shape space to world space, that does not mirror.
    world_from_shape: [[f32; 4]; 3],
    /// Of a mesh of triangles the index of its first joint, and the length in the mesh of a unit of the world.
    pub half_extents: Vec3,
    /// In scene units.
    pub rounding: f32,
    /// Linear light.
    pub colour: Vec3,
    node: u32,
    pub finish: Finish,
}

/// What fragments need of a surface besides its colour, the same for all of a shape.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Finish {
    /// The width of the highlight: alpha of GGX, widened by the size of the sun.
    alpha: f32,
    /// How sharp the horizon is mirrored.
    sharpness: f32,
    /// How much of what comes at grazing angles is mirrored.
    grazing: f32,
    /// 0 to 1; of ghosts the opacity.
    metalness_or_opacity: f32,
}

impl Finish {
    fn of(item: &DrawItem, lighting: &Lighting, opacity: Option<f32>) -> Self {
        let DrawItem { roughness, metalness, .. } = *item;
        let alpha = roughness * roughness;
        // Half the sun's radius, as mirrors turn half as far as what they show.
        let of_sun = 0.5 * (0.25 * lighting.sun_degrees.to_radians()).tan();
        let grazing = 1.0 - 0.7 * roughness;
        Self {
            alpha: alpha.hypot(of_sun).max(LEAST_ALPHA),
            sharpness: 0.7 / (alpha + 0.04),
            grazing: metalness + (1.0 - metalness) * grazing * grazing,
            metalness_or_opacity: opacity.unwrap_or(metalness),
        }
    }
}

impl Finish {
    /// Of a shade on the ground: the alpha of surfaces is never negative.
    pub const fn of_shade(opacity: f32) -> Self {
        Self { alpha: -1.0, sharpness: 0.0, grazing: 0.0, metalness_or_opacity: opacity }
    }
}

/// A smaller alpha is lost in rounding.
const LEAST_ALPHA: f32 = 0.003;

impl Instance {
    /// The instance of an item drawn with the unit mesh of a level.
    pub fn of_unit(item: &DrawItem, level: Level, lighting: &Lighting, opacity: Option<f32>) -> Self {
        let mut world_from_shape = item.world_from_shape;
        // Every mesh is its own mirror image, so a mirrored shape is the same shape unmirrored; culling then needs one winding.
        if world_from_shape.matrix3.determinant() < 0.0 {
            world_from_shape *= Affine3A::from_scale(Vec3::new(-1.0, 1.0, 1.0));
        }
        // A cone's slope depends on its size, so the affine scales the unit cone, normals included.
        let (mut half_extents, mut rounding) = level.fitted(item.half_extents, item.rounding);
        if level.kind == MeshKind::Cone {
            world_from_shape *= Affine3A::from_scale(half_extents);
            (half_extents, rounding) = (Vec3::ONE, 0.0);
        }
        Self::new(item, &world_from_shape, half_extents, rounding, Finish::of(item, lighting, opacity))
    }

    /// The instance of an item drawn as a mesh of triangles: `first_joint` where joints place it. `world_per_mesh`: how long a unit of the
    /// mesh is in the world.
    pub fn of_triangles(
        item: &DrawItem,
        world_from_shape: &Affine3A,
        first_joint: u32,
        world_per_mesh: f32,
        lighting: &Lighting,
        opacity: Option<f32>,
    ) -> Self {
        let parameters = Vec3::new(first_joint as f32, 1.0 / world_per_mesh.max(1e-9), 0.0);
        Self::new(item, world_from_shape, parameters, 0.0, Finish::of(item, lighting, opacity))
    }

    /// Shape space to world space.
    pub fn world_from_shape(&self) -> Affine3A {
        let [x, y, z] = self.world_from_shape.map(Vec4::from);
        let moved = Vec3::new(x.w, y.w, z.w);
        let rows = Mat3A::from_cols(x.truncate().into(), y.truncate().into(), z.truncate().into());
        Affine3A { matrix3: rows.transpose(), translation: moved.into() }
    }

    fn new(item: &DrawItem, world_from_shape: &Affine3A, half_extents: Vec3, rounding: f32, finish: Finish) -> Self {
        let [x, y, z] = rows(world_from_shape);
        Self { world_from_shape: [x, y, z], half_extents, rounding, colour: item.colour, node: item.node, finish }
    }
}

/// The rows of an affine.
pub fn rows(affine: &Affine3A) -> [[f32; 4]; 3] {
    let rows = affine.matrix3.transpose();
    let moved = affine.translation;
    let row = |row: glam::Vec3A, moved: f32| [row.x, row.y, row.z, moved];
    [row(rows.x_axis, moved.x), row(rows.y_axis, moved.y), row(rows.z_axis, moved.z)]
}

/// One line or dot.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Stroke {
    from_in_world: Vec3,
    to_in_world: Vec3,
    colour: [f32; 4],
    width_px: f32,
}

/// Line segments per circle of the arcball.
const CIRCLE_PIECES: u16 = 72;

/// The bytes of a frame and the ranges in them. Memory is reused from frame to frame.
#[derive(Debug, Default)]
pub struct Packed {
    /// The bytes to upload.
    pub bytes: Vec<u8>,
    /// Instances of each mesh that may be visible, the outlined ones last.
    pub seen: [Range<u32>; MESHES],
    /// Outlined instances of each mesh.
    pub outlined: [Range<u32>; MESHES],
    /// Instances of each mesh for the sun's map: of all items except planes, or of none if the map is not drawn.
    pub casters: [Range<u32>; MESHES],
    /// Ghosts' instances of each mesh.
    pub ghosts: [Range<u32>; MESHES],
    /// The draw calls of meshes of triangles.
    pub triangles: TriangleDraws,
    /// Offset of the strokes in the bytes.
    pub strokes_start: usize,
    /// Strokes that are lines.
    pub lines: Range<u32>,
    /// Strokes of the arcball.
    pub arcball: Range<u32>,
    /// Strokes that are dots.
    pub dots: Range<u32>,
    /// Offset in the bytes of shades on the ground and of edges.
    pub edges_start: usize,
    /// Shades on the ground, then edges of items.
    pub edges: Range<u32>,
    /// Edges of ghosts.
    pub ghost_edges: Range<u32>,
    /// Finds edges.
    finder: Edges,
    /// Indices in the frame by mesh: of casters, then of ghosts.
    by_mesh: [Vec<u32>; MESHES],
}

/// Offset of the instances in the bytes: after the globals, at a size that every adapter accepts for a uniform binding.
pub const INSTANCES_START: usize = 512;

impl Packed {
    /// Packs a frame: its items as arranged, its ghosts in the picture's detail, and its casters in the shadow map's detail, if that map
    /// is due.
    pub fn pack(
        &mut self,
        frame: &Frame,
        arranged: &Arranged,
        globals: &Globals,
        of_picture: Detail,
        of_sun_map: Option<Detail>,
        skins: &Skins,
    ) {
        self.bytes.clear();
        self.bytes.extend_from_slice(bytes_of(globals));
        self.bytes.resize(INSTANCES_START, 0);
        let mut instances = Instances { bytes: &mut self.bytes, lighting: &frame.lighting, count: 0 };
        for (mesh, [plain, outlined]) in arranged.seen.iter().enumerate() {
            let plain = instances.push(mesh, opaque(frame, plain));
            self.outlined[mesh] = instances.push(mesh, opaque(frame, outlined));
            self.seen[mesh] = plain.start..self.outlined[mesh].end;
        }
        self.by_mesh.iter_mut().for_each(Vec::clear);
        if let Some(detail) = of_sun_map {
            for (item, index) in frame.items.iter().zip(0..).filter(|(item, _)| !item.is_ground()) {
                if let ItemMesh::Unit(kind) = item.mesh {
                    self.by_mesh[detail.mesh(item, kind)].push(index);
                }
            }
        }
        for (mesh, indices) in self.by_mesh.iter().enumerate() {
            self.casters[mesh] = instances.push(mesh, opaque(frame, indices));
        }
        self.by_mesh.iter_mut().for_each(Vec::clear);
        for (ghost, index) in frame.ghosts.iter().zip(0..) {
            if let ItemMesh::Unit(kind) = ghost.item.mesh {
                self.by_mesh[of_picture.mesh(&ghost.item, kind)].push(index);
            }
        }
        for (mesh, indices) in self.by_mesh.iter().enumerate() {
            let ghosts = indices.iter().map(|&index| &frame.ghosts[index as usize]);
            self.ghosts[mesh] = instances.push(mesh, ghosts.map(|ghost| (&ghost.item, Some(ghost.opacity))));
        }
        let mut triangles = mem::take(&mut self.triangles);
        triangles.pack(frame, arranged, of_sun_map.is_some(), skins, |instance| instances.push_one(instance));
        self.triangles = triangles;
        self.strokes_start = self.bytes.len();
        let mut strokes = 0;
        let mut push = |stroke: Stroke| {
            self.bytes.extend_from_slice(bytes_of(&stroke));
            strokes += 1;
            strokes
        };
        let mut end = 0;
        for line in &frame.lines {
            let (from_in_world, to_in_world) = (line.from_in_world, line.to_in_world);
            end = push(Stroke { from_in_world, to_in_world, colour: line.colour.to_array(), width_px: line.width_px });
        }
        self.lines = 0..end;
        if let Some(mark) = &frame.arcball {
            arcball(mark, &frame.view, |stroke| end = push(stroke));
        }
        self.arcball = self.lines.end..end;
        for dot in &frame.dots {
            let (from_in_world, to_in_world) = (dot.centre_in_world, dot.centre_in_world);
            end = push(Stroke { from_in_world, to_in_world, colour: dot.colour.to_array(), width_px: dot.diameter_px });
        }
        self.dots = self.arcball.end..end;
        self.edges_start = self.bytes.len();
        (self.edges, self.ghost_edges) = (0..0, 0..0);
    }

    /// Adds the shades on the ground.
    pub fn pack_contacts(&mut self, frame: &Frame, arranged: &Arranged) {
        for contact in contacts(frame, &arranged.bounds) {
            self.bytes.extend_from_slice(bytes_of(&EdgeLine::from(contact)));
            self.edges.end += 1;
        }
    }

    /// Adds the edges of what was packed: of the items that may be visible, if `of_items`, and of ghosts.
    pub fn pack_edges(&mut self, frame: &Frame, arranged: &Arranged, of_picture: Detail, of_items: bool) {
        let eye = frame.view.world_from_eye.translation;
        let mut count = self.edges.end;
        if of_items {
            let seen = arranged.seen[..PLANE].iter().enumerate();
            let seen = seen.flat_map(|(level, seen)| seen.iter().flatten().map(move |&index| (level, index)));
            // The same shapes have smooth edges whether or not others were left out before.
            let sides = ViewSides::of(&frame.view, of_picture.widest_error());
            let may_see = |&(_, index): &(usize, u32)| sides.may_see(&arranged.bounds[index as usize], Vec3::ZERO);
            let seen = seen.filter(may_see);
            for (level, index) in edges::order(&frame.view, &arranged.bounds, seen) {
                let instance = Instance::of_unit(&frame.items[index as usize], LEVELS[level], &frame.lighting, None);
                count += self.finder.append(&instance, level, true, eye, &mut self.bytes);
            }
        }
        self.edges = 0..count;
        for ghost in frame.ghosts.iter().take(edges::MOST_SHAPES) {
            if let ItemMesh::Unit(kind) = ghost.item.mesh {
                let level = of_picture.mesh(&ghost.item, kind);
                let instance = Instance::of_unit(&ghost.item, LEVELS[level], &frame.lighting, Some(ghost.opacity));
                count += self.finder.append(&instance, level, false, eye, &mut self.bytes);
            }
        }
        self.ghost_edges = self.edges.end..count;
    }
}

/// A frame's items with these indices, which are opaque.
fn opaque<'a>(frame: &'a Frame, indices: &'a [u32]) -> impl Iterator<Item = (&'a DrawItem, Option<f32>)> {
    indices.iter().map(|&index| (&frame.items[index as usize], None))
}

/// Appends instances to a byte buffer.
struct Instances<'a> {
    bytes: &'a mut Vec<u8>,
    lighting: &'a Lighting,
    count: u32,
}

impl Instances<'_> {
    /// Appends items with their opacities, all drawn as one mesh. Returns the range of instances.
    fn push<'a>(&mut self, mesh: usize, items: impl Iterator<Item = (&'a DrawItem, Option<f32>)>) -> Range<u32> {
        let start = self.count;
        for (item, opacity) in items {
            self.push_one(&Instance::of_unit(item, LEVELS[mesh], self.lighting, opacity));
        }
        start..self.count
    }

    /// Appends an instance. Returns its index.
    fn push_one(&mut self, instance: &Instance) -> u32 {
        self.bytes.extend_from_slice(bytes_of(instance));
        self.count += 1;
        self.count - 1
    }
}

/// The ball's outline and three great circles, their far halves fainter.
fn arcball(mark: &ArcballMark, view: &View, mut push: impl FnMut(Stroke)) {
    let colour = look::PALETTE.arcball;
    let from_eye = mark.centre_in_world - Vec3::from(view.world_from_eye.translation);
    let distance = from_eye.length();
    let mut circle = |centre: Vec3, u: Vec3, v: Vec3, is_outline: bool| {
        let at = |piece: u16| {
            let (sin, cos) = (TAU * f32::from(piece % CIRCLE_PIECES) / f32::from(CIRCLE_PIECES)).sin_cos();
            centre + u * cos + v * sin
        };
        for piece in 0..CIRCLE_PIECES {
            let (from_in_world, to_in_world) = (at(piece), at(piece + 1));
            let outwards = (from_in_world + to_in_world) * 0.5 - mark.centre_in_world;
            // 1 towards the eye, 0 away from it, with a smooth transition at the rim.
            let facing = (0.5 - 2.5 * outwards.dot(from_eye) / (mark.radius * distance)).clamp(0.0, 1.0);
            let (opacity, width_px) = if is_outline { (0.75, 1.6) } else { (0.14 + 0.5 * facing, 1.2) };
            push(Stroke { from_in_world, to_in_world, colour: colour.extend(opacity).to_array(), width_px });
        }
    };
    let r = mark.radius;
    for (u, v) in [(Vec3::X, Vec3::Y), (Vec3::Y, Vec3::Z), (Vec3::Z, Vec3::X)] {
        circle(mark.centre_in_world, u * r, v * r, false);
    }
    if distance > r {
        // Seen from a point, the ball's outline is a smaller circle nearer to the eye.
        let towards_eye = -from_eye / distance;
        let (along, rim) = (r * r / distance, r * (1.0 - (r / distance).powi(2)).sqrt());
        let (u, v) = towards_eye.any_orthonormal_pair();
        circle(mark.centre_in_world + towards_eye * along, u * rim, v * rim, true);
    }
}
