//! The files to start from: a rubric, a reference, a hotkey script, and a README that says what to do next.

use glam::Quat;

use crate::keyframe::{Keyframe, KeyframeList, keyframes_from_json, keyframes_to_json};
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;
use crate::scene::{DEFAULT_SCENE, NodeKind, SceneGraph, built_in_scene};

const REFERENCE: &str = include_str!("../../assets/grading/reference.json");

/// The files by their names. The reference moves the nodes of the scene; `scene_argument` is how the README names the scene, where it is
/// not the usual one.
#[must_use]
pub fn example(scene: &SceneGraph, scene_argument: Option<&str>) -> [(&'static str, String); 4] {
    let usual = built_in_scene(DEFAULT_SCENE).expect("it is built in");
    let reference = if scene.has_rbts_of(&usual) { REFERENCE.to_owned() } else { reference_for(scene, &usual) };
    let readme = include_str!("../../assets/grading/README.md");
    let argument = match scene_argument {
        Some(name) if name.contains(char::is_whitespace) => format!(" --scene \"{name}\""),
        Some(name) => format!(" --scene {name}"),
        None => String::new(),
    };
    [
        ("rubric.toml", include_str!("../../assets/grading/rubric.toml").to_owned()),
        ("reference.json", reference),
        ("hotkeys.txt", include_str!("../../assets/grading/hotkeys.txt").to_owned()),
        ("README.md", readme.replace("inbetween grade", &format!("inbetween{argument} grade"))),
    ]
}

/// A reference for another scene: its nodes move as those do that move in the usual reference, in turn. Eyes and flat grounds stay, where
/// there is anything else.
fn reference_for(scene: &SceneGraph, usual: &SceneGraph) -> String {
    let file = keyframes_from_json(REFERENCE.as_bytes(), usual).expect("a test reads it");
    let (list, interpolation, ms_between_keyframes) = file.into_parts();
    let keyframes = list.as_slice();
    let is_moved =
        |rbt: &RbtIndex| keyframes.iter().any(|keyframe| keyframe.pose.get(*rbt) != usual.rest_pose().get(*rbt));
    let moved: Vec<RbtIndex> = usual.rbt_indices().filter(is_moved).collect();
    let is_body = |rbt: &RbtIndex| {
        let mut nodes = scene.nodes()[scene.subtree(scene.rbt_node(*rbt))].iter();
        nodes.any(|node| matches!(&node.kind, NodeKind::Shape(placed) if !placed.shape.is_ground()))
    };
    let mut nodes: Vec<RbtIndex> = scene.rbt_indices().filter(is_body).collect();
    if nodes.is_empty() {
        nodes = scene.rbt_indices().collect();
    }
    let keyframe = |from: &Keyframe| {
        let mut rbts = scene.rest_pose().to_vec();
        for (node, like) in nodes.iter().zip(moved.iter().cycle()) {
            let (rest, now) = (usual.rest_pose().get(*like), from.pose.get(*like));
            let rbt = &mut rbts[node.get()];
            let turn: Quat = rest.rotation.conjugate() * now.rotation;
            *rbt = Rbt {
                translation: rbt.translation + (now.translation - rest.translation),
                rotation: rbt.rotation * turn,
            };
        }
        from.with_pose(Pose::new(rbts))
    };
    let list = KeyframeList::new(keyframes.iter().map(keyframe).collect());
    keyframes_to_json(scene, &list, interpolation, ms_between_keyframes)
}
