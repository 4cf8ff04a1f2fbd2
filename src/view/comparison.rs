//! Comparisons: ghosts of the poses that other blends give, and of the animation of another file, with numbers for legends.

use std::sync::LazyLock;

use glam::Vec3;

use super::ghosts::{GhostLook, OPACITY, nodes_below, push_ghosts};
use crate::animation_diff::{Played, distances};
use crate::colour::Colour;
use crate::editor::Editor;
use crate::frame::Frame;
use crate::keyframe::{Blend, PlayRange};
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;
use crate::scene::NodeKind;

/// The colours of other blends, in the order of [`Blend::others`].
pub const BLEND_COLOURS: [Colour; Blend::OTHERS] = [Colour::BLUE, Colour::GREEN, Colour::RED];

/// The same as linear-light tints, computed once.
static TINTS: LazyLock<[Vec3; Blend::OTHERS]> = LazyLock::new(|| BLEND_COLOURS.map(Colour::to_linear));
static OTHER_FILE: LazyLock<Vec3> = LazyLock::new(|| Colour::OTHER_FILE.to_linear());

/// The largest difference of a pose from the displayed one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseDifference {
    /// The largest angle between rotations, in degrees.
    pub degrees: f64,
    /// The node that it is of.
    pub turned: RbtIndex,
    /// The largest distance of translations, in scene units.
    pub units: f64,
    /// The node that it is of.
    pub moved: RbtIndex,
}

/// Adds ghosts of the poses that the compared blends give where a sample is shown: of the chosen robot, or of all.
pub(super) fn add_comparison(frame: &mut Frame, editor: &Editor) {
    let compared = &editor.session().compared_blends;
    if compared.is_empty() {
        return;
    }
    let Some(key_time) = editor.key_time() else { return };
    let Ok(range) = PlayRange::new(&editor.document().keyframes) else { return };
    let scene = editor.scene();
    let robots: Vec<_> = editor.session().chosen.iter().map(|&chosen| outermost_rbt(editor, chosen)).collect();
    let blends = Blend::others(editor.document().interpolation).into_iter().zip(*TINTS);
    for (blend, tint) in blends.filter(|(blend, _)| compared.contains(blend)) {
        let world_from_node =
            scene.world_from_nodes_with(editor.seconds(), |rbt| range.blended_at(key_time, blend, rbt));
        let look = GhostLook { tint: Some(tint), opacity: OPACITY, moment: None, nodes: nodes_below(scene, &robots) };
        push_ghosts(frame, scene, &look, |node| world_from_node[node]);
    }
}

/// How far a blend turns a node away from what plays: the chosen node, or the one that it turns furthest. In degrees; `None` where no
/// sample is shown.
#[must_use]
pub fn blend_off(editor: &Editor, blend: Blend) -> Option<(f64, RbtIndex)> {
    let key_time = editor.key_time()?;
    let range = PlayRange::new(&editor.document().keyframes).ok()?;
    let off = |rbt: RbtIndex| {
        let played = range.node_at(key_time, editor.document().interpolation, rbt);
        let blended = Rbt::new(Vec3::ZERO, range.rotation_at(key_time, blend, rbt).as_quat());
        (distances(Rbt { translation: Vec3::ZERO, ..played }, blended).1, rbt)
    };
    match editor.session().chosen.primary() {
        Some(chosen) => Some(off(chosen)),
        None => editor.scene().rbt_indices().map(off).max_by(|a, b| a.0.total_cmp(&b.0)),
    }
}

/// The pose of the animation of another file at the playhead's time; the last one after its end.
fn compared_pose(editor: &Editor) -> Option<Pose> {
    let animation = &editor.compared()?.animation;
    let range = PlayRange::new(&animation.keyframes).ok()?;
    let played = Played {
        range: &range,
        interpolation: animation.interpolation,
        ms_between_keyframes: animation.ms_between_keyframes,
    };
    played.pose_at(&editor.playhead_ms()).ok()
}

/// Adds ghosts of the animation of another file.
pub(super) fn add_compared(frame: &mut Frame, editor: &Editor) {
    let Some(pose) = compared_pose(editor) else { return };
    let scene = editor.scene();
    let world_from_node = scene.world_from_nodes(&pose, editor.seconds());
    let look = GhostLook { tint: Some(*OTHER_FILE), opacity: OPACITY, moment: None, nodes: nodes_below(scene, &[]) };
    push_ghosts(frame, scene, &look, |node| world_from_node[node].get());
}

/// The largest differences between the displayed pose and that of the other file, as `inbetween diff` has them. The first eye, which only
/// looks, is left out.
#[must_use]
pub fn compared_off(editor: &Editor) -> Option<PoseDifference> {
    let (other, shown) = (compared_pose(editor)?, editor.displayed_pose());
    let sky = editor.scene().eyes().first().copied();
    let rbts = || editor.scene().rbt_indices().filter(|&rbt| Some(rbt) != sky);
    let off = |rbt: RbtIndex| distances(shown.get(rbt), other.get(rbt));
    let largest = |of: fn((f64, f64)) -> f64| {
        rbts().map(|rbt| (of(off(rbt)), rbt)).reduce(|most, next| if next.0 > most.0 { next } else { most })
    };
    let (degrees, turned) = largest(|(_, degrees)| degrees)?;
    let (units, moved) = largest(|(units, _)| units)?;
    Some(PoseDifference { degrees, turned, units, moved })
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
