//! Ghosts: the neighbouring keyframes, translucent over the scene. The window and films show the same.

use std::ops::Range;
use std::sync::LazyLock;

use glam::{Affine3A, Vec3};

use super::scene::place_skin;
use crate::blend::AlignedAffine;
use crate::colour::Colour;
use crate::frame::{DrawItem, Frame, Ghost, ItemMesh, MOST_GHOSTS};
use crate::keyframe::{KeyframeIndex, KeyframeList};
use crate::pose::RbtIndex;
use crate::scene::{NodeId, SceneGraph};

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
    /// The tint, in linear light; `None`: the shapes' own colours.
    pub tint: Option<Vec3>,
    /// The opacity, 0 to 1.
    pub opacity: f32,
    /// The moment of a strobe, by its number.
    pub moment: Option<u32>,
    /// Indices of the nodes.
    pub nodes: Vec<Range<usize>>,
}

/// Adds a ghost of each shape of the frame that stands elsewhere by `world_from_node`. Planes have none. `scene` must be the frame's.
pub(super) fn push_ghosts(
    frame: &mut Frame,
    scene: &SceneGraph,
    look: &GhostLook,
    world_from_node: impl Fn(usize) -> Affine3A,
) {
    for index in 0..frame.items.len() {
        let item = frame.items[index];
        let node = item.node as usize;
        let mut ghost =
            DrawItem { colour: look.tint.unwrap_or(item.colour), outlined: false, is_hidden: false, ..item };
        let is_elsewhere = match item.mesh {
            _ if item.is_ground() => false,
            ItemMesh::Skin { mesh, first_joint } => {
                let Some(shape) = scene.id_at(node).and_then(|id| scene.skin(id)) else { continue };
                let is_wanted = |node: usize| look.nodes.iter().any(|nodes| nodes.contains(&node));
                let at = |joint: NodeId| world_from_node(joint.get());
                let before = frame.joints_of(mesh, first_joint);
                let is_elsewhere =
                    shape.world_from_bind(at).zip(before).any(|(new, before)| !new.abs_diff_eq(*before, SAME_PLACE));
                let is_seen =
                    is_elsewhere && (is_wanted(node) || shape.joints().iter().any(|joint| is_wanted(joint.get())));
                if is_seen {
                    place_skin(frame, &mut ghost, mesh, shape, at);
                }
                is_seen
            }
            ItemMesh::Unit(_) | ItemMesh::Triangles { .. } => {
                look.nodes.iter().any(|nodes| nodes.contains(&node)) && {
                    ghost.world_from_shape = world_from_node(node);
                    !ghost.world_from_shape.abs_diff_eq(item.world_from_shape, SAME_PLACE)
                }
            }
        };
        if is_elsewhere {
            frame.ghosts.push(Ghost { item: ghost, opacity: look.opacity, moment: look.moment });
        }
    }
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
            let opacity = OPACITY / f32::from(away);
            let look = GhostLook { tint: Some(tint), opacity, moment: None, nodes: nodes_below(scene, only) };
            push_ghosts(frame, scene, &look, |node| world_from_node[node].get());
        }
    }
}

/// Opacity of the earliest and of the last pose that a strobe shows beside the displayed one.
const STROBE_OPACITIES: [f32; 2] = [0.2, 0.75];

/// Adds earlier moments, of each where the nodes were, in the shapes' own colours: the later, the less translucent. `scene` must be the
/// frame's.
pub fn add_strobe(frame: &mut Frame, scene: &SceneGraph, earlier: &[Vec<AlignedAffine>]) {
    let [first, last] = STROBE_OPACITIES;
    for (moment, world_from_node) in (0..).zip(earlier) {
        let opacity = first + (last - first) * moment as f32 / (earlier.len() - 1).max(1) as f32;
        let look = GhostLook { tint: None, opacity, moment: Some(moment), nodes: nodes_below(scene, &[]) };
        push_ghosts(frame, scene, &look, |node| world_from_node[node].get());
    }
}

/// Adds a ghost of the nodes where something that is compared puts them, in its colour. `scene` must be the frame's.
pub fn add_compared_nodes(frame: &mut Frame, scene: &SceneGraph, world_from_node: &[AlignedAffine], colour: Colour) {
    let look =
        GhostLook { tint: Some(colour.to_linear()), opacity: OPACITY, moment: None, nodes: nodes_below(scene, &[]) };
    push_ghosts(frame, scene, &look, |node| world_from_node[node].get());
}
