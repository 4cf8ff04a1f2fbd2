//! Makes the [`Frame`] of a scene, a pose and a camera.

use glam::{Affine3A, Vec3};

use crate::camera::Camera;
use crate::frame::{DrawItem, Frame, View};
use crate::pose::{Pose, RbtIndex};
use crate::scene::{NodeKind, Part, PlacedShape, SceneGraph};

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
pub(super) fn outline(frame: &mut Frame, scene: &SceneGraph, nodes: &[RbtIndex]) {
    if nodes.is_empty() {
        return;
    }
    for item in &mut frame.items {
        item.outlined |= carrying(scene, item).is_some_and(|rbt| nodes.contains(&rbt));
    }
}

/// How far the colours of what a click takes go towards white.
const LIGHTER: f32 = 0.15;

/// Lights the shapes that a click would take. `scene` must be the frame's.
pub fn light(frame: &mut Frame, scene: &SceneGraph, part: Part) {
    let is_lit = |item: &DrawItem| match part {
        Part::Rbt(rbt) => carrying(scene, item) == Some(rbt),
        Part::Keyed(node) => scene.subtree(node).contains(&(item.node as usize)),
    };
    for item in frame.items.iter_mut().filter(|item| is_lit(item)) {
        item.colour = item.colour.lerp(Vec3::ONE, LIGHTER);
    }
}

fn carrying(scene: &SceneGraph, item: &DrawItem) -> Option<RbtIndex> {
    scene.id_at(item.node as usize).and_then(|id| scene.carrying_rbt(id))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rbt::Rbt;
    use crate::scene::{DEFAULT_SCENE, built_in_scene};

    #[test]
    fn what_a_click_takes_is_lighter_and_has_no_outline() {
        let scene = built_in_scene(DEFAULT_SCENE).unwrap();
        let size_px = glam::Vec2::new(64.0, 48.0);
        let camera = Camera { world_from_eye: Rbt::IDENTITY, vertical_fov: scene.vertical_fov(), size_px };
        let before = frame_of_scene(&scene, scene.rest_pose(), 0.0, &camera, None);
        let mut frame = before.clone();
        let head = scene.find_rbt("robot1/head").unwrap();
        light(&mut frame, &scene, Part::Rbt(head));
        let is_of_head = |item: &DrawItem| carrying(&scene, item) == Some(head);
        assert!(frame.items.iter().any(is_of_head));
        for (item, before) in frame.items.iter().zip(&before.items) {
            assert!(!item.outlined);
            assert_eq!(item.colour.min_element() > before.colour.min_element(), is_of_head(item));
        }
    }
}
