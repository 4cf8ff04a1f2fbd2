//! Versions of lists and scenes, and the sentences about them.

use glam::Vec3;

use super::*;
use crate::keyframe::Keyframe;
use crate::pose::RbtIndex;
use crate::rbt::Rbt;
use crate::scene::{DEFAULT_SCENE, built_in_scene};

fn scene() -> SceneGraph {
    built_in_scene(DEFAULT_SCENE).expect("it is built in")
}

/// So many keyframes at rest; in those of `moved`, a node is so far from there.
fn list(count: usize, moved: &[(usize, f32)]) -> KeyframeList {
    let scene = scene();
    let keyframe = |index: usize| {
        let mut pose = scene.rest_pose().clone();
        for (_, by) in moved.iter().filter(|(at, _)| *at == index) {
            let rest = pose.get(RbtIndex::new(2));
            pose.set(RbtIndex::new(2), Rbt { translation: rest.translation + Vec3::X * *by, ..rest });
        }
        Keyframe::new(pose)
    };
    KeyframeList::new((0..count).map(keyframe).collect())
}

#[track_caller]
fn check(theirs: (&KeyframeList, Interpolation, u32), ours: (&KeyframeList, Interpolation, u32), expected: &[&str]) {
    let version =
        |(keyframes, interpolation, ms_between_keyframes)| Version { keyframes, interpolation, ms_between_keyframes };
    let said = keyframe_differences(&scene(), version(theirs), version(ours));
    let said: Vec<String> = said.iter().map(ToString::to_string).collect();
    assert_eq!(said, expected);
}

const LINEAR: Interpolation = Interpolation::Linear;

#[test]
fn versions_that_are_the_same_say_so() {
    let list = list(3, &[]);
    check(
        (&list, LINEAR, 2000),
        (&list, LINEAR, 2000),
        &["Both have 3 keyframes.", "Nothing differs but the way in which it is written."],
    );
}

#[test]
fn counts_timing_and_the_keyframe_that_differs_most_are_named() {
    check(
        (&list(2, &[(0, 0.25), (1, 0.5)]), Interpolation::CatmullRom, 500),
        (&list(3, &[]), LINEAR, 2000),
        &[
            "The file has 2 keyframes; here are 3 keyframes.",
            "Interpolation: Catmull-Rom in the file, Linear here.",
            "The file has 500 ms between keyframes; here are 2000 ms.",
            "These keyframes differ: 0, 1.",
            "Most of all differs robot1 in keyframe 1: by 0.5 units and 0 degrees.",
        ],
    );
}

#[test]
fn what_plays_is_compared_as_it_plays() {
    check(
        (&list(6, &[(2, 1.0)]), LINEAR, 1000),
        (&list(6, &[]), LINEAR, 1000),
        &[
            "Both have 6 keyframes.",
            "These keyframes differ: 2.",
            "Most of all differs robot1 in keyframe 2: by 1 units and 0 degrees.",
            "While they play, robot1 is apart by up to 1 units and 0 degrees, at key time 1.",
        ],
    );
}

#[test]
fn a_long_list_is_cut() {
    let moved: Vec<(usize, f32)> = (0..12).map(|index| (index, 1.0)).collect();
    let (theirs, ours) = (list(12, &moved), list(12, &[]));
    let said = keyframes(&scene(), &theirs, &ours);
    assert_eq!(said[0].to_string(), "These keyframes differ: 0, 1, 2, 3, 4, 5, 6, 7 and 4 more.");
}

#[test]
fn scenes_are_compared_node_by_node() {
    let ours = scene();
    let said = |theirs: &SceneGraph| scene_differences(theirs, &ours)[0].to_string();
    assert_eq!(said(&ours.clone()), "Nothing differs but the way in which it is written.");
    let (with_control, _) = ours.with_control_above(ours.rbt_node(RbtIndex::new(2))).unwrap();
    assert_eq!(said(&with_control), "Nodes only in the file: robot1_control.");
    assert_eq!(scene_differences(&ours, &with_control)[0].to_string(), "Nodes only here: robot1_control.");
}
