//! Which items are drawn, and in which order: those that may be seen, the nearest first, so that what they hide is not shaded.
//!
//! Items come in the scene's pre-order, so that those of a subtree follow each other. Runs of them share a bounding box: a run that is
//! out of sight, or whole in sight, costs one test.

use glam::Vec3;

use crate::frame::{DrawItem, Frame};
use crate::render::bounds::{Bounds, Sight, ViewSides};
use crate::render::detail::Detail;
use crate::render::mesh::MESHES;

/// Items that share a bounding box.
const RUN: usize = 32;

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
    /// Takes in a frame; says whether an item is another than in the last one.
    pub fn take(&mut self, frame: &Frame, detail: Detail, arrangement: Arrangement) -> bool {
        let has_moved = frame.items != self.items;
        if has_moved {
            self.items.clone_from(&frame.items);
            self.bounds.clear();
            self.bounds.extend(frame.items.iter().map(Bounds::of));
            self.runs.clear();
            self.runs.extend(self.bounds.chunks(RUN).map(Bounds::around));
        }
        self.seen.as_flattened_mut().iter_mut().for_each(Vec::clear);
        let sides = ViewSides::of(&frame.view, detail.widest_error());
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
                    self.seen[detail.mesh(item)][usize::from(item.outlined)].push(place);
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
