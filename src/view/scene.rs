//! Makes the [`Frame`] of a scene, a pose and a camera.

use glam::Affine3A;

use crate::camera::Camera;
use crate::frame::{DrawItem, Frame, View};
use crate::pose::{Pose, RbtIndex};
use crate::scene::{NodeKind, PlacedShape, SceneGraph};

/// The picture of a scene in a pose, `seconds` into the timed keys, looked at from the node `from`: of its own shapes only the shadow
/// shows. `None`: from no node.
#[must_use]
pub fn frame_of_scene(scene: &SceneGraph, pose: &Pose, seconds: f64, camera: &Camera, from: Option<RbtIndex>) -> Frame {
    let world_from_node = scene.world_from_nodes(pose, seconds);
    let items = scene
        .nodes_with_ids()
        .filter_map(|(id, node)| {
            let NodeKind::Shape(placed) = &node.kind else { return None };
            let item = draw_item(placed, world_from_node[id.get()].get(), seconds, id.get());
            Some(DrawItem { is_hidden: from.is_some() && scene.carrying_rbt(id) == from, ..item })
        })
        .collect();
    Frame { view: View::new(camera), items, ghosts: Vec::new(), lines: Vec::new(), dots: Vec::new(), arcball: None }
}

/// Outlines the shapes of nodes, such as the chosen ones. `scene` must be the frame's.
pub fn outline(frame: &mut Frame, scene: &SceneGraph, nodes: &[RbtIndex]) {
    if nodes.is_empty() {
        return;
    }
    for item in &mut frame.items {
        let carrying = scene.id_at(item.node as usize).and_then(|id| scene.carrying_rbt(id));
        item.outlined |= carrying.is_some_and(|rbt| nodes.contains(&rbt));
    }
}

pub(super) fn draw_item(placed: &PlacedShape, world_from_shape: Affine3A, seconds: f64, node: usize) -> DrawItem {
    DrawItem {
        mesh: placed.shape.mesh(),
        world_from_shape,
        half_extents: placed.shape.half_extents(),
        rounding: placed.shape.rounding(),
        colour: placed.colour_at(seconds),
        node: u32::try_from(node).expect("a scene has fewer than 2^32 nodes"),
        outlined: false,
        is_hidden: false,
    }
}
