//! Which items are drawn, in which order and in what detail: those that may be seen, the nearest first, so that what they hide is not
//! shaded, and rounded edges of boxes only where they are pixels wide.
//!
//! Items come in the scene's pre-order, so that those of a subtree follow each other. Runs of them share a bounding box: a run that is
//! out of sight, or whole in sight, costs one test.

use glam::Vec3;

use crate::frame::{DrawItem, Frame};
use crate::render::bounds::{Bounds, Sight, ViewSides};
use crate::render::mesh::{CHAMFERED_BOX, MESHES, SHARP_BOX};
use crate::scene::MeshKind;

/// Items that share a bounding box.
const RUN: usize = 32;

/// Edges of a box that are rounded by less than so many pixels are cut off straight.
const CHAMFERED_BELOW_PX: f32 = 1.2;
/// Those that are rounded by less than so many are sharp.
const SHARP_BELOW_PX: f32 = 0.5;

/// How items are drawn. The picture is the same to the byte with and without the cut.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Arrangement {
    /// All of them, in the frame's order and in full detail: what the others are measured against.
    AsGiven,
    /// All of them, the nearest first, in the detail that their pixels show.
    Sorted,
    /// Those that may be seen, the nearest first.
    #[default]
    SortedAndCut,
}

/// What tells how many pixels something is wide.
#[derive(Clone, Copy, Debug)]
struct Detail {
    eye_in_world: Vec3,
    /// Of what is at distance 1, for each unit of length.
    pixels: f32,
}

impl Detail {
    fn of(frame: &Frame, height_px: u32) -> Self {
        let view = &frame.view;
        let pixels = 0.5 * height_px as f32 / (0.5 * view.vertical_fov).tan();
        Self { eye_in_world: view.world_from_eye.translation.into(), pixels }
    }

    /// The mesh that shows an item as well as its pixels can.
    fn mesh(self, item: &DrawItem) -> usize {
        if item.mesh != MeshKind::Box {
            return item.mesh as usize;
        }
        let axes = item.world_from_shape.matrix3;
        let scale = axes.x_axis.length().max(axes.y_axis.length()).max(axes.z_axis.length());
        // Its nearest corner counts.
        let distance = Vec3::from(item.world_from_shape.translation).distance(self.eye_in_world);
        let nearest = (distance - scale * item.half_extents.length()).max(0.0);
        let rounding_px = self.pixels * scale * item.rounding;
        if rounding_px < SHARP_BELOW_PX * nearest {
            SHARP_BOX
        } else if rounding_px < CHAMFERED_BELOW_PX * nearest {
            CHAMFERED_BOX
        } else {
            item.mesh as usize
        }
    }
}

/// The items of a frame in the order in which they go to the GPU. Kept from frame to frame.
#[derive(Debug, Default)]
pub struct Arranged {
    items: Vec<DrawItem>,
    /// The items' boxes.
    pub bounds: Vec<Bounds>,
    runs: Vec<Bounds>,
    /// Places in the frame of what may be seen: for each mesh what is not outlined, then what is.
    pub seen: [[Vec<u32>; 2]; MESHES],
    keys: Vec<u32>,
}

impl Arranged {
    /// Takes in a frame of a picture so many pixels high; says whether an item is another than in the last one.
    pub fn take(&mut self, frame: &Frame, height_px: u32, arrangement: Arrangement) -> bool {
        let has_moved = frame.items != self.items;
        if has_moved {
            self.items.clone_from(&frame.items);
            self.bounds.clear();
            self.bounds.extend(frame.items.iter().map(Bounds::of));
            self.runs.clear();
            self.runs.extend(self.bounds.chunks(RUN).map(Bounds::around));
        }
        self.seen.as_flattened_mut().iter_mut().for_each(Vec::clear);
        let sides = ViewSides::of(&frame.view);
        let detail = (arrangement != Arrangement::AsGiven).then(|| Detail::of(frame, height_px));
        for ((run, items), places) in self.runs.iter().zip(frame.items.chunks(RUN)).zip((0_u32..).step_by(RUN)) {
            let of_run = match arrangement {
                Arrangement::SortedAndCut => sides.sight(run),
                Arrangement::AsGiven | Arrangement::Sorted => Sight::Whole,
            };
            for (item, place) in items.iter().zip(places..) {
                let may_be_seen = match of_run {
                    Sight::Whole => true,
                    Sight::None => false,
                    Sight::Partial => sides.may_see(&self.bounds[place as usize], Vec3::ZERO),
                };
                if may_be_seen {
                    let mesh = detail.map_or(item.mesh as usize, |detail| detail.mesh(item));
                    self.seen[mesh][usize::from(item.outlined)].push(place);
                }
            }
        }
        if arrangement != Arrangement::AsGiven {
            self.sort(Vec3::from(frame.view.world_from_eye.translation));
        }
        has_moved
    }

    /// The nearest first; of equally near ones the frame's order.
    fn sort(&mut self, eye_in_world: Vec3) {
        self.keys.clear();
        // Squares of distances are not negative, and the bits of such numbers are in their order.
        let key = |bounds: &Bounds| bounds.centre_in_world.distance_squared(eye_in_world).to_bits();
        self.keys.extend(self.bounds.iter().map(key));
        for places in self.seen.as_flattened_mut() {
            places.sort_unstable_by_key(|&place| (self.keys[place as usize], place));
        }
    }
}
