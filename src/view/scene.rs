//! Makes the [`Frame`] of a scene, a pose and a camera.

use glam::Affine3A;

use crate::camera::Camera;
use crate::frame::{DrawItem, Frame, View};
use crate::pose::{Pose, RbtIndex};
use crate::scene::{NodeKind, PlacedShape, SceneGraph};

/// The picture of a scene in a pose, `seconds` into the timed keys, with the shapes of `chosen` outlined.
#[must_use]
pub fn frame_of_scene(
    scene: &SceneGraph,
    pose: &Pose,
    seconds: f64,
    camera: &Camera,
    chosen: Option<RbtIndex>,
) -> Frame {
    let world_from_node = scene.world_from_nodes(pose, seconds);
    let items = scene
        .nodes_with_ids()
        .filter_map(|(id, node)| {
            let NodeKind::Shape(placed) = &node.kind else { return None };
            let outlined = chosen.is_some() && scene.carrying_rbt(id) == chosen;
            Some(draw_item(placed, world_from_node[id.get()].get(), seconds, id.get(), outlined))
        })
        .collect();
    Frame { view: View::new(camera), items, ghosts: Vec::new(), lines: Vec::new(), dots: Vec::new(), arcball: None }
}

/// Also outlines the shapes of a node, such as the one under the pointer. `scene` must be the frame's.
pub fn outline(frame: &mut Frame, scene: &SceneGraph, rbt: RbtIndex) {
    for item in &mut frame.items {
        item.outlined |= scene.id_at(item.node as usize).and_then(|id| scene.carrying_rbt(id)) == Some(rbt);
    }
}

pub(super) fn draw_item(
    placed: &PlacedShape,
    world_from_shape: Affine3A,
    seconds: f64,
    node: usize,
    outlined: bool,
) -> DrawItem {
    DrawItem {
        mesh: placed.shape.mesh(),
        world_from_shape,
        half_extents: placed.shape.half_extents(),
        rounding: placed.shape.rounding(),
        colour: placed.colour_at(seconds),
        node: u32::try_from(node).expect("a scene has fewer than 2^32 nodes"),
        outlined,
    }
}
