//! Edges of shapes, drawn over once more where a picture has one sample a pixel.
//!
//! A line one pixel wide lies outside each edge of a silhouette. It has the shape's colour, full at the edge and none a pixel away. This is
//! discontinuity edge overdraw (Sander, Hoppe, Snyder and Gortler, 2001). It costs as much as there are edges, and no pass over the picture.

use bytemuck::{Pod, Zeroable, bytes_of};
use glam::{Affine3A, Vec3, Vec3A};

use crate::frame::View;
use crate::render::bounds::Bounds;
use crate::render::contact::Contact;
use crate::render::instances::{Finish, Instance};
use crate::unit_mesh::{Edge, edges, geometry};

/// The shapes that have smooth edges: the largest in the picture. More would be so small that one sees none of it.
pub const MOST_SHAPES: usize = 1024;

/// An edge, or a shade on the ground: the layout of their buffer. One pipeline draws both, since a software driver needs milliseconds
/// for each pipeline.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct EdgeLine {
    /// The shape is on the left from here to `to_in_world`, as the eye sees it.
    from_in_world: Vec3,
    to_in_world: Vec3,
    /// Unit normals of the shape, in world space.
    from_normal: Vec3,
    to_normal: Vec3,
    colour: Vec3,
    finish: Finish,
}

impl From<Contact> for EdgeLine {
    fn from(contact: Contact) -> Self {
        Self {
            from_in_world: contact.centre_in_world,
            to_in_world: contact.across_in_world,
            from_normal: contact.deep_in_world,
            to_normal: Vec3::X * contact.reach,
            colour: Vec3::ZERO,
            finish: Finish::of_shade(contact.opacity),
        }
    }
}

/// Finds edges. It keeps its memory from shape to shape.
#[derive(Debug, Default)]
pub struct Edges {
    places: Vec<Vec3A>,
    faces_eye: Vec<bool>,
}

/// The shapes that have smooth edges, farthest first, so that near edges blend with what is behind them: indices of `bounds` among `seen`,
/// each with the level of its mesh.
pub fn order(view: &View, bounds: &[Bounds], seen: impl Iterator<Item = (usize, u32)>) -> Vec<(usize, u32)> {
    let eye = Vec3::from(view.world_from_eye.translation);
    let squared = |index: u32| bounds[index as usize].centre_in_world.distance_squared(eye);
    // Not negative, so their bits sort like the numbers.
    let mut keyed: Vec<_> = seen.map(|(level, index)| (squared(index).to_bits(), index, level)).collect();
    if keyed.len() > MOST_SHAPES {
        let size = |&(squared, index, _): &(u32, u32, usize)| {
            let radius: f32 = bounds[index as usize].half_edges_in_world.iter().map(|edge| edge.length_squared()).sum();
            (std::cmp::Reverse((radius / f32::from_bits(squared).max(1e-12)).to_bits()), index)
        };
        keyed.select_nth_unstable_by_key(MOST_SHAPES, size);
        keyed.truncate(MOST_SHAPES);
    }
    keyed.sort_unstable_by_key(|&(squared, index, _)| (std::cmp::Reverse(squared), index));
    keyed.into_iter().map(|(_, index, level)| (level, index)).collect()
}

impl Edges {
    /// Appends the edges of an instance of the unit mesh of a level that the eye sees: its silhouette, and if `is_opaque` the sharp edges
    /// between two faces, which would be twice as dark where one sees through. Returns their number.
    pub fn append(
        &mut self,
        instance: &Instance,
        level: usize,
        is_opaque: bool,
        eye_in_world: Vec3A,
        bytes: &mut Vec<u8>,
    ) -> u32 {
        let before = bytes.len();
        let range = &geometry().ranges[level];
        let edges = edges(level);
        let vertices = &geometry().vertices[range.first_vertex as usize..];
        let indices = &geometry().indices[range.indices.start as usize..range.indices.end as usize];
        let count = usize::from(indices.iter().copied().max().map_or(0, |last| last + 1));
        let (scale, rounding) = (Vec3A::from(instance.half_extents) - instance.rounding, instance.rounding);
        self.places.clear();
        self.places.extend(
            vertices[..count]
                .iter()
                .map(|vertex| Vec3A::from(vertex.core) * scale + Vec3A::from(vertex.normal) * rounding),
        );
        let world_from_shape = instance.world_from_shape();
        let eye = world_from_shape.inverse().transform_point3a(eye_in_world);
        self.faces_eye.clear();
        self.faces_eye.extend(indices.chunks_exact(3).map(|corners| {
            let [a, b, c] = [corners[0], corners[1], corners[2]].map(|corner| self.places[usize::from(corner)]);
            (b - a).cross(c - a).dot(eye - a) > 0.0
        }));
        let turn = cofactors(&world_from_shape);
        for Edge { triangles, vertices: ends, is_sharp } in edges {
            let face = match triangles.map(|triangle| self.faces_eye[usize::from(triangle)]) {
                [true, false] => 0,
                [false, true] => 1,
                // The face that one sees less of is drawn over.
                [true, true] if *is_sharp && is_opaque => {
                    let facing = ends.map(|[from, _]| {
                        let place = self.places[usize::from(from)];
                        Vec3A::from(vertices[usize::from(from)].normal).dot(eye - place)
                    });
                    usize::from(facing[1] > facing[0])
                }
                _ => continue,
            };
            let [from, to] = ends[face].map(usize::from);
            let place = |index: usize| Vec3::from(world_from_shape.transform_point3a(self.places[index]));
            let normal = |index: usize| Vec3::from((turn * Vec3A::from(vertices[index].normal)).normalize_or_zero());
            let line = EdgeLine {
                from_in_world: place(from),
                to_in_world: place(to),
                from_normal: normal(from),
                to_normal: normal(to),
                colour: instance.colour,
                finish: instance.finish,
            };
            bytes.extend_from_slice(bytes_of(&line));
        }
        ((bytes.len() - before) / size_of::<EdgeLine>()) as u32
    }
}

/// What transforms normals for any affine that does not mirror.
fn cofactors(affine: &Affine3A) -> glam::Mat3A {
    let [x, y, z] = [affine.matrix3.x_axis, affine.matrix3.y_axis, affine.matrix3.z_axis];
    glam::Mat3A::from_cols(y.cross(z), z.cross(x), x.cross(y))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::frame::DrawItem;
    use crate::lighting::Lighting;
    use crate::scene::MeshKind;
    use crate::unit_mesh::{LEVELS, LEVELS_OF_KIND};

    fn lines(kind: MeshKind, half_extents: Vec3, rounding: f32, eye: Vec3A) -> Vec<EdgeLine> {
        let item = DrawItem {
            mesh: kind.into(),
            world_from_shape: Affine3A::IDENTITY,
            half_extents,
            rounding,
            colour: Vec3::ONE,
            node: 0,
            outlined: false,
            is_hidden: false,
            roughness: 0.7,
            metalness: 0.0,
        };
        let level = if rounding > 0.0 { LEVELS_OF_KIND[kind as usize].0 } else { LEVELS_OF_KIND[kind as usize].1 };
        let mut bytes = Vec::new();
        let count = Edges::default().append(
            &Instance::of_unit(&item, LEVELS[level], &Lighting::default(), None),
            level,
            true,
            eye,
            &mut bytes,
        );
        let lines: Vec<EdgeLine> =
            bytes.chunks_exact(size_of::<EdgeLine>()).map(bytemuck::pod_read_unaligned).collect();
        assert_eq!(lines.len(), count as usize);
        lines
    }

    /// The silhouette of a ball is a circle: its lines are one closed loop, which the eye sees at the angle whose sine is radius by distance.
    #[test]
    fn the_silhouette_of_a_ball_is_one_loop_around_it() {
        let eye = Vec3A::new(0.0, 0.0, 4.0);
        let lines = lines(MeshKind::Sphere, Vec3::ONE, 1.0, eye);
        for line in &lines {
            let next = lines.iter().filter(|next| next.from_in_world.distance(line.to_in_world) < 1e-5).count();
            assert_eq!(next, 1);
            let seen = (Vec3A::from(line.from_in_world) - eye).angle_between(-eye).sin();
            assert!((seen - 0.25).abs() < 0.02, "{seen}");
            // The ball is on the left.
            let along = line.to_in_world - line.from_in_world;
            assert!(along.cross(Vec3::from(eye) - line.from_in_world).dot(line.from_in_world) > 0.0);
        }
        assert!(lines.len() > 20, "{}", lines.len());
    }

    /// An eye before a corner sees three faces of a sharp box: six edges are the silhouette, and three lie between two of the faces.
    #[test]
    fn a_sharp_box_before_a_corner_has_nine_edges() {
        let lines = lines(MeshKind::Box, Vec3::ONE, 0.0, Vec3A::splat(5.0));
        let touches = |line: &&EdgeLine| [line.from_in_world, line.to_in_world].contains(&Vec3::ONE);
        assert_eq!((lines.len(), lines.iter().filter(touches).count()), (9, 3));
    }

    #[test]
    fn the_largest_shapes_are_taken_and_drawn_farthest_first() {
        let view = View {
            eye_from_world: Affine3A::IDENTITY,
            world_from_eye: Affine3A::IDENTITY,
            clip_from_eye: glam::Mat4::IDENTITY,
            vertical_fov: 1.0,
            aspect: 1.0,
        };
        // Equal boxes, each farther than the one before.
        let bounds: Vec<Bounds> = (0..2000_u16)
            .map(|index| Bounds {
                centre_in_world: Vec3::NEG_Z * f32::from(index + 1),
                half_edges_in_world: [Vec3::X, Vec3::Y, Vec3::Z],
            })
            .collect();
        let taken = order(&view, &bounds, (0..2000).map(|index| (0, index)));
        let nearest: Vec<_> = (0..MOST_SHAPES as u32).rev().map(|index| (0, index)).collect();
        assert!(taken == nearest);
    }
}
