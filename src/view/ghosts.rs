//! Ghosts: the neighbouring keyframes, translucent over the scene. The window and films show the same.

use std::sync::LazyLock;

use glam::Vec3;

use crate::colour::Colour;
use crate::frame::{DrawItem, Frame, Ghost, MOST_GHOSTS};
use crate::keyframe::{KeyframeIndex, KeyframeList};
use crate::scene::SceneGraph;

/// Opacity of the nearest ghost.
pub(super) const OPACITY: f32 = 0.38;
/// A shape has no ghost if its matrix differs from the displayed one by less than this. Samples of a node that does not move differ from
/// its keyframes by rounding.
const SAME_PLACE: f32 = 1e-5;

/// Linear-light tints of earlier keyframes (warm) and later ones (cool), computed once.
static TINTS: LazyLock<[Vec3; 2]> = LazyLock::new(|| [Colour::EARLIER, Colour::LATER].map(Colour::to_linear));

/// The keyframes around a picture.
#[derive(Clone, Copy, Debug)]
pub struct Neighbours<'a> {
    /// The whole list, including the first and the last keyframe, which are not played but can be edited.
    pub keyframes: &'a KeyframeList,
    /// Indices in the list from which earlier ghosts count down and later ones up: both are the displayed keyframe, or, between two
    /// keyframes, the later and the earlier one.
    pub from: [usize; 2],
    /// Ghosts on each side, at most [`MOST_GHOSTS`].
    pub count: u8,
}

/// Adds the neighbouring keyframes as ghosts. The n-th on each side has 1/n of the opacity of the nearest. Planes and shapes that have not
/// moved have no ghost. `scene` and `seconds` must be those of the frame.
pub fn add_ghosts(frame: &mut Frame, scene: &SceneGraph, seconds: f64, neighbours: Neighbours<'_>) {
    let Neighbours { keyframes, from: [before, after], count } = neighbours;
    let Frame { items, ghosts, .. } = frame;
    for away in (1..=count.min(MOST_GHOSTS)).rev() {
        let steps = usize::from(away);
        for (index, tint) in [before.checked_sub(steps), after.checked_add(steps)].into_iter().zip(*TINTS) {
            let Some(keyframe) = index.and_then(|index| keyframes.get(KeyframeIndex::new(index))) else { continue };
            let world_from_node = scene.world_from_nodes(&keyframe.pose, seconds);
            ghosts.extend(items.iter().filter_map(|item| {
                let world_from_shape = world_from_node[item.node as usize].get();
                let is_seen = !item.is_ground() && !world_from_shape.abs_diff_eq(item.world_from_shape, SAME_PLACE);
                let item = DrawItem { world_from_shape, colour: tint, outlined: false, ..*item };
                is_seen.then_some(Ghost { item, opacity: OPACITY / f32::from(away) })
            }));
        }
    }
}
