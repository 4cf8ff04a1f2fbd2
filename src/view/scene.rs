//! Makes the [`Frame`] of a scene, a pose and a camera.

use std::collections::HashMap;
use std::sync::Arc;

use glam::{Affine3A, Vec3};

use crate::blend::AlignedAffine;
use crate::camera::Camera;
use crate::frame::{DrawItem, Frame, ItemMesh, View};
use crate::model::TriangleMesh;
use crate::pose::{Pose, RbtIndex};
use crate::scene::shapes::MeshShape;
use crate::scene::{MeshKind, NodeId, NodeKind, Part, PlacedShape, SceneGraph, Shape};

/// The picture of a scene in a pose, `seconds` into the timed keys, looked at from the node `from`: of its own shapes only the shadow
/// shows. `None`: from no node.
#[must_use]
pub fn frame_of_scene(scene: &SceneGraph, pose: &Pose, seconds: f64, camera: &Camera, from: Option<RbtIndex>) -> Frame {
    frame_of_nodes(scene, &scene.world_from_nodes(pose, seconds), seconds, camera, from)
}

/// Like [`frame_of_scene`], with all nodes where `world_from_node` puts them: by any affine, in arena order.
#[must_use]
pub fn frame_of_nodes(
    scene: &SceneGraph,
    world_from_node: &[AlignedAffine],
    seconds: f64,
    camera: &Camera,
    from: Option<RbtIndex>,
) -> Frame {
    let mut frame = Frame { lighting: scene.lighting().lighting(), ..Frame::empty(View::new(camera)) };
    // The place of each mesh in the frame, by its address.
    let mut places: HashMap<*const TriangleMesh, u32> = HashMap::new();
    for (id, node) in scene.nodes_with_ids() {
        let NodeKind::Shape(placed) = &node.kind else { continue };
        let mut item = draw_item(placed, world_from_node[id.get()].get(), seconds, id.get());
        if let Shape::Mesh(shape) = &placed.shape {
            let mesh = *places.entry(Arc::as_ptr(shape.mesh())).or_insert_with(|| {
                frame.meshes.push(Arc::clone(shape.mesh()));
                frame.meshes.len() as u32 - 1
            });
            item.mesh = ItemMesh::Triangles { mesh };
            if !shape.joints().is_empty() {
                place_skin(&mut frame, &mut item, mesh, shape, |joint| world_from_node[joint.get()].get());
            }
        }
        frame.items.push(DrawItem { is_hidden: from.is_some() && scene.carrying_rbt(id) == from, ..item });
    }
    frame
}

/// Makes an item the skin of a mesh whose joints stand as `world_from_node` says.
pub(super) fn place_skin(
    frame: &mut Frame,
    item: &mut DrawItem,
    mesh: u32,
    shape: &MeshShape,
    world_from_node: impl Fn(NodeId) -> Affine3A,
) {
    let first_joint = frame.world_from_bind.len();
    frame.world_from_bind.extend(shape.world_from_bind(world_from_node));
    let [least, most] = shape.reach_of_skin(&frame.world_from_bind[first_joint..]);
    item.mesh = ItemMesh::Skin { mesh, first_joint: first_joint as u32 };
    item.world_from_shape = Affine3A::from_translation((least + most) * 0.5);
    item.half_extents = (most - least) * 0.5;
}

/// Outlines the shapes of nodes, such as the chosen ones. `scene` must be the frame's.
pub(super) fn outline(frame: &mut Frame, scene: &SceneGraph, nodes: &[RbtIndex]) {
    if nodes.is_empty() {
        return;
    }
    for item in &mut frame.items {
        item.outlined |= nodes.iter().any(|&rbt| is_moved(scene, item, rbt));
    }
}

/// How far the colours of what a click takes go towards white.
const LIGHTER: f32 = 0.15;

/// Lights the shapes that a click would take. `scene` must be the frame's.
pub fn light(frame: &mut Frame, scene: &SceneGraph, part: Part) {
    let is_lit = |item: &DrawItem| match part {
        Part::Rbt(rbt) => is_moved(scene, item, rbt),
        Part::Keyed(node) => scene.subtree(node).contains(&(item.node as usize)),
    };
    for item in frame.items.iter_mut().filter(|item| is_lit(item)) {
        item.colour = item.colour.lerp(Vec3::ONE, LIGHTER);
    }
}

/// Whether a node carries an item, or moves its skin.
fn is_moved(scene: &SceneGraph, item: &DrawItem, rbt: RbtIndex) -> bool {
    let Some(id) = scene.id_at(item.node as usize) else { return false };
    let is_carried = |id| scene.carrying_rbt(id) == Some(rbt);
    let moves_skin = || scene.skin(id).is_some_and(|shape| shape.joints().iter().any(|&joint| is_carried(joint)));
    is_carried(id) || moves_skin()
}

pub(super) fn draw_item(placed: &PlacedShape, world_from_shape: Affine3A, seconds: f64, node: usize) -> DrawItem {
    DrawItem {
        // Meshes of triangles have a place in a frame only.
        mesh: ItemMesh::Unit(placed.shape.mesh().unwrap_or(MeshKind::Box)),
        world_from_shape,
        half_extents: placed.shape.half_extents(),
        rounding: placed.shape.rounding(),
        colour: placed.colour_at(seconds),
        roughness: placed.roughness(),
        metalness: placed.metalness(),
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
        let is_of_head = |item: &DrawItem| is_moved(&scene, item, head);
        assert!(frame.items.iter().any(is_of_head));
        for (item, before) in frame.items.iter().zip(&before.items) {
            assert!(!item.outlined);
            assert_eq!(item.colour.min_element() > before.colour.min_element(), is_of_head(item));
        }
    }
}
