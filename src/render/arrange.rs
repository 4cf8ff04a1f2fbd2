//! Culling and sorting of items: those that may be visible, nearest first, so that hidden fragments are not shaded.
//!
//! Items come in the scene's pre-order, so those of a subtree are adjacent. Runs of items share a bounding box: a run that is completely
//! outside or completely inside the view costs one test.

use std::sync::Arc;

use glam::{Affine3A, Vec3};

use crate::frame::{DrawItem, Frame, ItemMesh, are_same_meshes};
use crate::model::TriangleMesh;
use crate::render::bounds::{Bounds, Sight, ViewSides};
use crate::render::detail::Detail;
use crate::render::mesh::MESHES;

/// The number of items that share a bounding box.
const RUN: usize = 32;

/// How items are culled and sorted. Culling does not change the bytes of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Arrangement {
    /// All items, in the frame's order and in full detail: the reference for the others.
    AsGiven,
    /// All items, nearest first, with level of detail.
    Sorted,
    /// Items that may be visible, nearest first, with level of detail.
    #[default]
    SortedAndCut,
}

/// The items of a frame in the order in which they go to the GPU. Reused from frame to frame.
#[derive(Debug, Default)]
pub struct Arranged {
    items: Vec<DrawItem>,
    /// The items' bounding boxes, in the frame's order.
    pub bounds: Vec<Bounds>,
    runs: Vec<Bounds>,
    /// For each mesh, indices in the frame of items that may be visible and are not hidden: those without an outline, then those with one.
    pub seen: [[Vec<u32>; 2]; MESHES],
    /// The same for each mesh of triangles of the frame.
    pub seen_triangles: Vec<[Vec<u32>; 2]>,
    meshes: Vec<Arc<TriangleMesh>>,
    world_from_bind: Vec<Affine3A>,
    distance_keys: Vec<u32>,
}

impl Arranged {
    /// Arranges a frame. Returns whether any item differs from the last frame's.
    pub fn take(&mut self, frame: &Frame, detail: Detail, arrangement: Arrangement) -> bool {
        let has_moved = frame.items != self.items
            || frame.world_from_bind != self.world_from_bind
            || !are_same_meshes(&frame.meshes, &self.meshes);
        if has_moved {
            self.meshes.clone_from(&frame.meshes);
            self.world_from_bind.clone_from(&frame.world_from_bind);
            self.items.clone_from(&frame.items);
            self.bounds.clear();
            self.bounds.extend(frame.items.iter().map(Bounds::of));
            self.runs.clear();
            self.runs.extend(self.bounds.chunks(RUN).map(Bounds::around));
        }
        self.seen.as_flattened_mut().iter_mut().for_each(Vec::clear);
        self.seen_triangles.iter_mut().flatten().for_each(Vec::clear);
        self.seen_triangles.resize_with(frame.meshes.len(), Default::default);
        let sides = ViewSides::of(&frame.view, detail.widest_error());
        for ((run, items), first) in self.runs.iter().zip(frame.items.chunks(RUN)).zip((0_u32..).step_by(RUN)) {
            let of_run = match arrangement {
                Arrangement::SortedAndCut => sides.sight(run),
                Arrangement::AsGiven | Arrangement::Sorted => Sight::Whole,
            };
            for (item, index) in items.iter().zip(first..) {
                let may_be_seen = match of_run {
                    Sight::Whole => true,
                    Sight::None => false,
                    Sight::Partial => sides.may_see(&self.bounds[index as usize], Vec3::ZERO),
                };
                if may_be_seen && !item.is_hidden {
                    let by_outline = match item.mesh {
                        ItemMesh::Unit(kind) => &mut self.seen[detail.mesh(item, kind)],
                        ItemMesh::Triangles { mesh } | ItemMesh::Skin { mesh, .. } => {
                            &mut self.seen_triangles[mesh as usize]
                        }
                    };
                    by_outline[usize::from(item.outlined)].push(index);
                }
            }
        }
        if arrangement != Arrangement::AsGiven {
            self.sort(Vec3::from(frame.view.world_from_eye.translation));
        }
        has_moved
    }

    /// Nearest first; equally near items stay in the frame's order.
    fn sort(&mut self, eye_in_world: Vec3) {
        self.distance_keys.clear();
        // Squared distances are not negative, so their bits sort like the numbers.
        let key = |bounds: &Bounds| bounds.centre_in_world.distance_squared(eye_in_world).to_bits();
        self.distance_keys.extend(self.bounds.iter().map(key));
        let seen = self.seen.as_flattened_mut().iter_mut();
        for indices in seen.chain(self.seen_triangles.iter_mut().flatten()) {
            indices.sort_unstable_by_key(|&index| (self.distance_keys[index as usize], index));
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::{Mat4, Quat};

    use super::*;
    use crate::frame::View;
    use crate::scene::MeshKind;

    fn frame(vertical_fov: f32, items: Vec<DrawItem>) -> Frame {
        let view = View {
            eye_from_world: Affine3A::IDENTITY,
            world_from_eye: Affine3A::IDENTITY,
            clip_from_eye: Mat4::IDENTITY,
            vertical_fov,
            aspect: 4.0 / 3.0,
        };
        Frame { items, ..Frame::empty(view) }
    }

    fn ball(world_from_shape: Affine3A) -> DrawItem {
        DrawItem {
            mesh: MeshKind::Sphere.into(),
            world_from_shape,
            half_extents: Vec3::splat(0.2),
            rounding: 0.2,
            colour: Vec3::ONE,
            outlined: false,
            is_hidden: false,
            roughness: 0.6,
            metalness: 0.0,
            node: 0,
        }
    }

    fn count_seen(frame: &Frame, detail: Detail) -> usize {
        let mut arranged = Arranged::default();
        arranged.take(frame, detail, Arrangement::SortedAndCut);
        arranged.seen.as_flattened().iter().map(Vec::len).sum()
    }

    #[test]
    fn what_a_coarse_mesh_may_reach_into_the_view_with_is_not_cut() {
        const DISTANCE: f32 = 40.0;
        let slope = 4.0 / 3.0 * 0.5_f32.tan();
        // Along the view's left side, and into the view across it.
        let along = Vec3::new(-slope, 0.0, -1.0).normalize();
        let inwards = Vec3::new(1.0, 0.0, -slope).normalize();
        let turned = Quat::from_rotation_arc(Vec3::X, inwards);
        let seen_at = |outside: f32| {
            let centre = along * DISTANCE - inwards * (outside + Bounds::of(&ball(Affine3A::IDENTITY)).reach(Vec3::X));
            let frame = frame(1.0, vec![ball(Affine3A::from_rotation_translation(turned, centre))]);
            let detail = Detail::of_picture(&frame.view, 480, 1.0);
            count_seen(&frame, detail)
        };
        let error = Detail::of_picture(&frame(1.0, Vec::new()).view, 480, 1.0).widest_error() * DISTANCE;
        assert_eq!([-0.5, 0.5, 2.0].map(|errors| seen_at(errors * error)), [1, 1, 0]);
    }

    #[test]
    fn the_widest_view_sees_what_is_before_it() {
        for (vertical_fov, height_px) in [(3.1, 480), (3.0, 12), (0.8, 1), (0.8, 3)] {
            let items = vec![ball(Affine3A::from_translation(Vec3::NEG_Z)), ball(Affine3A::from_translation(Vec3::Z))];
            let frame = frame(vertical_fov, items);
            let detail = Detail::of_picture(&frame.view, height_px, 1.0);
            assert_eq!(count_seen(&frame, detail), 1, "{vertical_fov} radians, {height_px} pixels");
        }
        // Far to both sides.
        let items = [-40.0, 40.0].map(|x| ball(Affine3A::from_translation(Vec3::new(x, 0.0, -1.0)))).to_vec();
        let frame = frame(3.1, items);
        assert_eq!(count_seen(&frame, Detail::of_picture(&frame.view, 480, 1.0)), 2);
    }
}
