//! What is drawn over a scene for whoever animates it: the path of the chosen node, and how it would move otherwise.

use glam::Vec3;

use super::build::draw_item;
use super::{Dot, Frame, Ghost, Line};
use crate::editor::{Editor, PathDot};
use crate::keyframe::{Blend, KeyframeIndex, PlayRange};
use crate::pose::RbtIndex;
use crate::scene::{Colour, NodeKind};

/// Pieces of the path between two keyframes, where the list is not too long for it.
const PIECES_PER_INTERVAL: usize = 32;
/// Pieces of the path in all.
const MOST_PIECES: usize = 4096;
/// Width of the path in pixels.
const PATH_WIDTH_PX: f32 = 2.0;
const DOT_PX: f32 = 8.0;
const CURRENT_DOT_PX: f32 = 11.0;
const MARK_PX: f32 = 21.0;
const GHOST_OPACITY: f32 = 0.38;

const PATH: &str = "#f6f1e4";
const CURRENT: &str = "#f2a33a";
const OTHER_INTERPOLATION: &str = "#5aa9e6";
const NLERP: &str = "#63c08a";
const MATRICES: &str = "#e5645a";
const EARLIER: &str = "#e08a4b";
const LATER: &str = "#4ba3d9";

fn linear(hex: &str) -> Vec3 {
    Colour::from_hex(hex).expect("the overlay colours are of the form #rrggbb").to_linear()
}

/// Adds the path that the chosen node takes through its keyframes: a line with a dot at each, the pieces that only steer fainter.
/// The eye has no path: it would end at itself.
pub(super) fn add_path(frame: &mut Frame, editor: &Editor) {
    let Some(chosen) = editor.path_node() else { return };
    let document = editor.document();
    let keyframes = &document.keyframes;
    let count = keyframes.len();
    if count < 2 {
        return;
    }
    let scene = editor.scene();
    let node = scene.rbt_node(chosen);
    let at_keyframe = |place: usize| {
        let pose = &keyframes.as_slice()[place].pose;
        scene.world_from_node(pose, editor.seconds(), node).translation.into()
    };
    let played = PlayRange::new(keyframes).ok();
    let pieces = (MOST_PIECES / count).clamp(1, PIECES_PER_INTERVAL);
    let colour = linear(PATH);
    let mut line = |from_in_world: Vec3, to_in_world: Vec3, opacity: f32| {
        frame.lines.push(Line { from_in_world, to_in_world, colour: colour.extend(opacity), width_px: PATH_WIDTH_PX });
    };
    for start in 0..count - 1 {
        let is_played = start > 0 && start + 2 < count;
        match played.as_ref().filter(|_| is_played) {
            None => line(at_keyframe(start), at_keyframe(start + 1), 0.3),
            Some(range) => {
                let mut from = at_keyframe(start);
                for piece in 1..=pieces {
                    #[expect(clippy::cast_precision_loss, reason = "there are few pieces")]
                    let alpha = piece as f32 / pieces as f32;
                    let to: Vec3 = scene
                        .world_from_node_with(editor.seconds(), node, |rbt| {
                            range.rbt_at(start, alpha, document.interpolation, rbt).to_affine()
                        })
                        .translation
                        .into();
                    line(from, to, 0.85);
                    from = to;
                }
            }
        }
    }
    for place in 0..count {
        let is_current = keyframes.current() == Some(KeyframeIndex::new(place));
        let steers = played.is_some() && (place == 0 || place + 1 == count);
        let colour = if is_current { linear(CURRENT) } else { colour };
        frame.dots.push(Dot {
            centre_in_world: at_keyframe(place),
            colour: colour.extend(if steers && !is_current { 0.5 } else { 1.0 }),
            diameter_px: if is_current { CURRENT_DOT_PX } else { DOT_PX },
        });
    }
}

/// Adds a mark around a dot of the path: what a press would take, or what is held.
pub(super) fn add_mark(frame: &mut Frame, dot: PathDot) {
    let mark = |opacity: f32, diameter_px: f32| Dot {
        centre_in_world: dot.centre_in_world,
        colour: linear(CURRENT).extend(opacity),
        diameter_px,
    };
    frame.dots.extend([mark(0.4, MARK_PX), mark(1.0, CURRENT_DOT_PX)]);
}

/// Adds the poses of the neighbouring keyframes as ghosts: earlier ones warm, later ones cool, farther ones fainter. Nodes that stand
/// as they do on screen have none.
pub(super) fn add_ghosts(frame: &mut Frame, editor: &Editor) {
    let Some(current) = editor.document().keyframes.current().filter(|_| !editor.is_playing()) else { return };
    let scene = editor.scene();
    let shown = scene.world_from_nodes(&editor.displayed_pose(), editor.seconds());
    for away in (1..=usize::from(editor.session().ghosts)).rev() {
        let neighbours = [(current.get().checked_sub(away), EARLIER), (current.get().checked_add(away), LATER)];
        for (place, tint) in neighbours {
            let Some(keyframe) = place.and_then(|place| editor.document().keyframes.as_slice().get(place)) else {
                continue;
            };
            let world_from_node = scene.world_from_nodes(&keyframe.pose, editor.seconds());
            for (id, node) in scene.nodes_with_ids() {
                let NodeKind::Shape(placed) = &node.kind else { continue };
                if world_from_node[id.get()] == shown[id.get()] {
                    continue;
                }
                let mut item = draw_item(placed, world_from_node[id.get()].get(), editor.seconds(), id.get(), false);
                item.colour = linear(tint);
                #[expect(clippy::cast_precision_loss, reason = "there are at most 3")]
                let opacity = GHOST_OPACITY / away as f32;
                frame.ghosts.push(Ghost { item, opacity });
            }
        }
    }
}

/// Adds ghosts of the chosen robot as the interpolations that are not in force would have it, while playing.
pub(super) fn add_comparison(frame: &mut Frame, editor: &Editor) {
    if !editor.is_playing() {
        return;
    }
    let (Some(chosen), Some(key_time)) = (editor.session().chosen, editor.key_time()) else { return };
    let Ok(range) = PlayRange::new(&editor.document().keyframes) else { return };
    let scene = editor.scene();
    let robot = outermost_rbt(editor, chosen);
    let tints: [_; Blend::OTHERS] = [OTHER_INTERPOLATION, NLERP, MATRICES].map(linear);
    for (blend, tint) in Blend::others(editor.document().interpolation).into_iter().zip(tints) {
        let world_from_node =
            scene.world_from_nodes_with(editor.seconds(), |rbt| range.blended_at(key_time, blend, rbt));
        for place in scene.subtree(scene.rbt_node(robot)) {
            let NodeKind::Shape(placed) = &scene.nodes()[place].kind else { continue };
            let mut item = draw_item(placed, world_from_node[place], editor.seconds(), place, false);
            item.colour = tint;
            frame.ghosts.push(Ghost { item, opacity: GHOST_OPACITY });
        }
    }
}

/// The RBT node nearest to the root of those above a node: the robot that an arm belongs to.
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
