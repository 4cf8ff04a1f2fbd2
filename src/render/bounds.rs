//! Bounding boxes, the view's side planes, and rectangles in pixels.

use std::f32::consts::FRAC_PI_2;

use glam::Vec3;

use crate::frame::{DrawItem, ItemMesh, View};
use crate::render::mesh::Level;

/// An item's box in world space: its centre and three half edges.
#[derive(Clone, Copy, Debug)]
pub struct Bounds {
    /// The centre, in world space.
    pub centre_in_world: Vec3,
    /// The vectors from the centre to three faces, in world space.
    pub half_edges_in_world: [Vec3; 3],
}

impl Bounds {
    /// The box around an item, and around its finest mesh; around all places that the joints of a skin can bring it to.
    pub fn of(item: &DrawItem) -> Self {
        let axes = item.world_from_shape.matrix3;
        let (half_extents, rounding) = match item.mesh {
            ItemMesh::Unit(kind) => Level::finest(kind).fitted(item.half_extents, item.rounding),
            ItemMesh::Triangles { .. } | ItemMesh::Skin { .. } => (item.half_extents, 0.0),
        };
        let half = half_extents.max(Vec3::splat(rounding));
        Self {
            centre_in_world: item.world_from_shape.translation.into(),
            half_edges_in_world: [
                (axes.x_axis * half.x).into(),
                (axes.y_axis * half.y).into(),
                (axes.z_axis * half.z).into(),
            ],
        }
    }

    /// An axis-aligned box around at least one box.
    pub fn around(boxes: &[Self]) -> Self {
        let (mut least, mut most) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for bounds in boxes {
            let half: Vec3 = bounds.half_edges_in_world.iter().map(|edge| edge.abs()).sum();
            least = least.min(bounds.centre_in_world - half);
            most = most.max(bounds.centre_in_world + half);
        }
        // A small margin against rounding.
        let half = (most - least) * 0.5 * 1.0001 + 1e-5;
        Self {
            centre_in_world: (least + most) * 0.5,
            half_edges_in_world: [Vec3::X * half.x, Vec3::Y * half.y, Vec3::Z * half.z],
        }
    }

    /// Half the box's extent along a direction, in lengths of the direction.
    pub fn reach(&self, direction: Vec3) -> f32 {
        self.half_edges_in_world.iter().map(|edge| edge.dot(direction).abs()).sum()
    }

    fn corners_in_world(&self) -> impl Iterator<Item = Vec3> + '_ {
        let [a, b, c] = self.half_edges_in_world;
        (0..8).map(move |corner: u8| {
            let sign = |bit: u8| if corner >> bit & 1 == 1 { 1.0 } else { -1.0 };
            self.centre_in_world + a * sign(0) + b * sign(1) + c * sign(2)
        })
    }
}

/// The view's side planes: anything on the positive side of all five planes may be visible.
#[derive(Clone, Copy, Debug)]
pub struct ViewSides {
    /// The point where all planes meet, in world space.
    pub eye_in_world: Vec3,
    normals_in_world: [Vec3; 5],
}

impl ViewSides {
    /// The sides of a view, each moved outwards by `wider` radians.
    pub fn of(view: &View, wider: f32) -> Self {
        let up = (view.vertical_fov * 0.5).tan();
        // Items behind the eye are never visible.
        let [up, right] = [up, up * view.aspect].map(|slope| (slope.atan() + wider).min(FRAC_PI_2).sin_cos());
        let normals_in_eye = [
            Vec3::new(right.1, 0.0, -right.0),
            Vec3::new(-right.1, 0.0, -right.0),
            Vec3::new(0.0, up.1, -up.0),
            Vec3::new(0.0, -up.1, -up.0),
            Vec3::NEG_Z,
        ];
        Self {
            eye_in_world: view.world_from_eye.translation.into(),
            normals_in_world: normals_in_eye.map(|normal| view.world_from_eye.transform_vector3(normal)),
        }
    }

    /// Whether a box, moved along `sweep_in_world`, may be visible anywhere on the way.
    pub fn may_see(&self, bounds: &Bounds, sweep_in_world: Vec3) -> bool {
        let from_eye = bounds.centre_in_world - self.eye_in_world;
        self.normals_in_world.iter().all(|&normal| {
            let distance = normal.dot(from_eye).max(normal.dot(from_eye + sweep_in_world));
            distance >= -bounds.reach(normal)
        })
    }
}

/// The visibility of a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sight {
    /// Outside the view.
    None,
    /// Perhaps partly inside the view.
    Partial,
    /// Inside the view.
    Whole,
}

impl ViewSides {
    /// The visibility of a box.
    pub fn sight(&self, bounds: &Bounds) -> Sight {
        let from_eye = bounds.centre_in_world - self.eye_in_world;
        let mut sight = Sight::Whole;
        for &normal in &self.normals_in_world {
            let (distance, reach) = (normal.dot(from_eye), bounds.reach(normal));
            if distance < -reach {
                return Sight::None;
            }
            if distance < reach {
                sight = Sight::Partial;
            }
        }
        sight
    }
}

/// The rectangle (x, y, width, height in pixels) around boxes in a picture, grown by `margin_px`. The whole picture if a box reaches behind
/// the eye; `None` if no box is in the picture.
pub fn rectangle_px(
    view: &View,
    boxes: impl Iterator<Item = Bounds>,
    size_px: [u32; 2],
    margin_px: f32,
) -> Option<[u32; 4]> {
    let clip_from_world = view.clip_from_eye * glam::Mat4::from(view.eye_from_world);
    let size = glam::Vec2::new(size_px[0] as f32, size_px[1] as f32);
    let (mut least, mut most) = (glam::Vec2::INFINITY, glam::Vec2::NEG_INFINITY);
    for bounds in boxes {
        for corner in bounds.corners_in_world() {
            let [x, y, _, w] = (clip_from_world * corner.extend(1.0)).to_array();
            if w < 1e-3 {
                return Some([0, 0, size_px[0], size_px[1]]);
            }
            let at_px = glam::Vec2::new(0.5 + 0.5 * x / w, 0.5 - 0.5 * y / w) * size;
            least = least.min(at_px);
            most = most.max(at_px);
        }
    }
    let least = (least - margin_px).floor().clamp(glam::Vec2::ZERO, size);
    let most = (most + margin_px).ceil().clamp(glam::Vec2::ZERO, size);
    let extent = most - least;
    (extent.x >= 1.0 && extent.y >= 1.0).then_some([least.x as u32, least.y as u32, extent.x as u32, extent.y as u32])
}

#[cfg(test)]
mod tests {
    use glam::Affine3A;

    use super::*;
    use crate::scene::Shape;
    use crate::scene::shapes::{Capsule, Cone, Cylinder, Plane, RoundedBox, Sphere};
    use crate::unit_mesh::triangle_mesh;

    #[test]
    fn an_items_box_holds_its_finest_mesh() {
        let shapes = [
            Shape::Box(RoundedBox { size: Vec3::new(1.0, 2.0, 0.5), bevel: 0.1 }),
            Shape::Sphere(Sphere { radius: 0.7 }),
            Shape::Cylinder(Cylinder { radius: 0.4, height: 1.5 }),
            Shape::Cone(Cone { radius: 0.5, height: 1.2 }),
            Shape::Capsule(Capsule { radius: 0.3, height: 1.4 }),
            Shape::Plane(Plane { size: [4.0, 6.0] }),
        ];
        for shape in shapes {
            let kind = shape.mesh().expect("all of these have a unit mesh");
            let item = DrawItem {
                mesh: kind.into(),
                world_from_shape: Affine3A::IDENTITY,
                half_extents: shape.half_extents(),
                rounding: shape.rounding(),
                colour: Vec3::ONE,
                outlined: false,
                is_hidden: false,
                roughness: 0.6,
                metalness: 0.0,
                node: 0,
            };
            let [x, y, z] = Bounds::of(&item).half_edges_in_world;
            let half = Vec3::new(x.x, y.y, z.z);
            for position in triangle_mesh(&shape, String::new()).positions {
                assert!(position.abs().cmple(half + 1e-6).all(), "{kind:?}: {position} outside {half}");
            }
        }
    }
}
