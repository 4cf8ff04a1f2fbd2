//! Ghosts: the neighbouring keyframes, translucent over the scene. The window and films show the same.

use std::ops::Range;
use std::sync::LazyLock;

use glam::{Affine3A, Vec3};

use crate::colour::Colour;
use crate::frame::{DrawItem, Frame, Ghost, MOST_GHOSTS};
use crate::keyframe::{KeyframeIndex, KeyframeList};
use crate::pose::RbtIndex;
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
    /// The nodes that have ghosts, with all below them; empty: all nodes.
    pub only: &'a [RbtIndex],
}

/// The nodes whose shapes have ghosts, and how those look.
pub(super) struct GhostLook {
    /// The tint, in linear light.
    pub tint: Vec3,
    /// The opacity, 0 to 1.
    pub opacity: f32,
    /// Indices of the nodes.
    pub nodes: Vec<Range<usize>>,
}

/// Adds a ghost of each shape of the frame that stands elsewhere by `world_from_node`. Planes have none.
pub(super) fn push_ghosts(frame: &mut Frame, look: &GhostLook, world_from_node: impl Fn(usize) -> Affine3A) {
    let Frame { items, ghosts, .. } = frame;
    ghosts.extend(items.iter().filter_map(|item| {
        let node = item.node as usize;
        if item.is_ground() || !look.nodes.iter().any(|nodes| nodes.contains(&node)) {
            return None;
        }
        let world_from_shape = world_from_node(node);
        let is_elsewhere = !world_from_shape.abs_diff_eq(item.world_from_shape, SAME_PLACE);
        let item = DrawItem { world_from_shape, colour: look.tint, outlined: false, is_hidden: false, ..*item };
        is_elsewhere.then_some(Ghost { item, opacity: look.opacity })
    }));
}

/// The nodes of the trees below some of a scene; with none of them all nodes.
pub(super) fn nodes_below(scene: &SceneGraph, rbts: &[RbtIndex]) -> Vec<Range<usize>> {
    if rbts.is_empty() {
        return std::iter::once(0..scene.nodes().len()).collect();
    }
    rbts.iter().map(|&rbt| scene.subtree(scene.rbt_node(rbt))).collect()
}

/// Adds the neighbouring keyframes as ghosts. The n-th on each side has 1/n of the opacity of the nearest. Planes and shapes that have not
/// moved have no ghost. `scene` and `seconds` must be those of the frame.
pub fn add_ghosts(frame: &mut Frame, scene: &SceneGraph, seconds: f64, neighbours: Neighbours<'_>) {
    let Neighbours { keyframes, from: [before, after], count, only } = neighbours;
    for away in (1..=count.min(MOST_GHOSTS)).rev() {
        let steps = usize::from(away);
        for (index, tint) in [before.checked_sub(steps), after.checked_add(steps)].into_iter().zip(*TINTS) {
            let Some(keyframe) = index.and_then(|index| keyframes.get(KeyframeIndex::new(index))) else { continue };
            let world_from_node = scene.world_from_nodes(&keyframe.pose, seconds);
            let look = GhostLook { tint, opacity: OPACITY / f32::from(away), nodes: nodes_below(scene, only) };
            push_ghosts(frame, &look, |node| world_from_node[node].get());
        }
    }
}
