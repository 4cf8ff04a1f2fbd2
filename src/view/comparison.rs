//! The comparison of interpolations: ghosts of the chosen robot, posed by other blends.

use std::sync::LazyLock;

use glam::Vec3;

use super::ghosts::OPACITY;
use super::scene::draw_item;
use crate::colour::Colour;
use crate::editor::Editor;
use crate::frame::{Frame, Ghost};
use crate::keyframe::{Blend, PlayRange};
use crate::pose::RbtIndex;
use crate::scene::NodeKind;

/// Linear-light tints in the order of [`Blend::others`], computed once.
static TINTS: LazyLock<[Vec3; Blend::OTHERS]> =
    LazyLock::new(|| [Colour::BLUE, Colour::GREEN, Colour::RED].map(Colour::to_linear));

/// While playing, adds ghosts of the chosen robot, posed by other blends.
pub(super) fn add_comparison(frame: &mut Frame, editor: &Editor) {
    if !editor.is_playing() {
        return;
    }
    let (Some(chosen), Some(key_time)) = (editor.session().chosen.primary(), editor.key_time()) else { return };
    let Ok(range) = PlayRange::new(&editor.document().keyframes) else { return };
    let scene = editor.scene();
    let robot = outermost_rbt(editor, chosen);
    for (blend, tint) in Blend::others(editor.document().interpolation).into_iter().zip(*TINTS) {
        let world_from_node =
            scene.world_from_nodes_with(editor.seconds(), |rbt| range.blended_at(key_time, blend, rbt));
        for node in scene.subtree(scene.rbt_node(robot)) {
            let NodeKind::Shape(placed) = &scene.nodes()[node].kind else { continue };
            let mut item = draw_item(placed, world_from_node[node], editor.seconds(), node);
            item.colour = tint;
            frame.ghosts.push(Ghost { item, opacity: OPACITY });
        }
    }
}

/// The topmost RBT node above a node, such as the robot that an arm belongs to.
fn outermost_rbt(editor: &Editor, rbt: RbtIndex) -> RbtIndex {
    let scene = editor.scene();
    let mut outermost = rbt;
    let mut next = scene.node(scene.rbt_node(rbt)).parent;
    while let Some(above) = next {
        if let NodeKind::Rbt(rbt) = scene.node(above).kind {
            outermost = rbt;
        }
        next = scene.node(above).parent;
    }
    outermost
}
