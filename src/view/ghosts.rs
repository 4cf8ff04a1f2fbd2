//! Ghosts: the neighbouring keyframes, translucent over the scene. The window and films show the same.

use std::sync::LazyLock;

use glam::Vec3;

use crate::colour::Colour;
use crate::frame::{DrawItem, Frame, Ghost, MOST_GHOSTS};
use crate::keyframe::{KeyframeIndex, KeyframeList};
use crate::scene::SceneGraph;

/// Opacity of the nearest ghost.
pub(super) const OPACITY: f32 = 0.38;
/// Shapes whose matrices differ by less than this stand as they are displayed, and have no ghost: a sample of a node that does not move
/// differs from its keyframes by rounding.
const SAME_PLACE: f32 = 1e-5;

/// Linear-light tints of earlier keyframes (warm) and later ones (cool), worked out once.
static TINTS: LazyLock<[Vec3; 2]> = LazyLock::new(|| [Colour::EARLIER, Colour::LATER].map(Colour::to_linear));

/// The keyframes around a picture.
#[derive(Clone, Copy, Debug)]
pub struct Neighbours<'a> {
    /// The list, its first and last keyframe included: they steer the motion, and are edited.
    pub keyframes: &'a KeyframeList,
    /// Indices in the list from which earlier ghosts count down and later ones up: both are the keyframe displayed; between two keyframes
    /// they are the later and the earlier of the two.
    pub from: [usize; 2],
    /// Ghosts on each side, at most [`MOST_GHOSTS`].
    pub count: u8,
}

/// Adds the neighbouring keyframes as ghosts, the farther the fainter: the n-th on each side has an n-th of the nearest one's opacity.
/// Shapes that stand as they are displayed have none, nor have planes. `scene` and `seconds` are those that the frame was made of.
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
