//! Still keyframes reveal next to nothing, and each advice is followed.

use std::collections::BTreeSet;

use glam::{Quat, Vec3};

use super::*;
use crate::diagnosis::names;
use crate::keyframe::Keyframe;
use crate::pose::Pose;
use crate::rbt::Rbt;

const BOTH: [Interpolation; 2] = [Interpolation::Linear, Interpolation::CatmullRom];

/// Six keyframes of three nodes in which nothing moves.
fn still() -> Vec<Keyframe> {
    vec![Keyframe::new(Pose::identity(3)); 6]
}

fn key_times() -> Vec<f64> {
    (0..=30).map(|frame| f64::from(frame) / 10.0).collect()
}

fn judged<'a>(sequence: &'a Sequence, key_times: &'a [f64]) -> Judged<'a> {
    Judged { sequence, playbacks: &BOTH, key_times, units: 0.001, degrees: 0.1 }
}

/// The keyframes after a change, as an editor would make it.
fn edited(mut keyframes: Vec<Keyframe>, change: &KeyframeChange) -> Vec<Keyframe> {
    for (index, keyframe) in keyframes.iter_mut().enumerate() {
        if !(change.first..=change.last).contains(&index) {
            continue;
        }
        let mut pose = keyframe.pose.clone();
        let mut rbt = pose.get(change.node);
        let kind = change.kind;
        match kind {
            ChangeKind::OppositeSign => rbt.rotation = -rbt.rotation,
            ChangeKind::Turn(name, degrees) | ChangeKind::TurnAndOppositeSign(name, degrees) => {
                let axis = [Vec3::X, Vec3::Y, Vec3::Z][(name as usize) - ('x' as usize)];
                rbt.rotation *= Quat::from_axis_angle(axis, f32::from(degrees).to_radians());
                if kind == ChangeKind::TurnAndOppositeSign(name, degrees) {
                    rbt.rotation = -rbt.rotation;
                }
            }
            ChangeKind::TurnAboutTwoAxes(degrees) => {
                let axis = if index == change.first { Vec3::X } else { Vec3::Y };
                rbt.rotation *= Quat::from_axis_angle(axis, f32::from(degrees).to_radians());
            }
            ChangeKind::TurnAndMove(degrees) => {
                rbt.rotation *= Quat::from_rotation_x(f32::from(degrees).to_radians());
                rbt.translation.x += 1.0;
            }
            ChangeKind::Move(tenths) => rbt.translation.x += f32::from(tenths) / 10.0,
        }
        pose.set(change.node, rbt);
        *keyframe = keyframe.with_pose(pose);
    }
    keyframes
}

#[test]
fn every_advice_reveals_its_mistake() {
    let times = key_times();
    let sequence = Sequence::new(&still()).unwrap();
    let (revealed, hidden) = revealing(&judged(&sequence, &times));
    let revealed: Vec<&str> = revealed.iter().map(|mistake| mistake.name).collect();
    assert_eq!(revealed, ["nan-when-equal", "quaternion-order-swapped"]);
    assert_eq!(hidden.len(), names().count() - 4);
    for hidden in &hidden {
        let name = hidden.mistake.name;
        let change = change_that_reveals(&judged(&sequence, &times), hidden);
        let change = change.unwrap_or_else(|| panic!("{name} needs a change"));
        let better = Sequence::new(&edited(still(), &change)).unwrap();
        let (revealed, _) = revealing(&judged(&better, &times));
        assert!(revealed.contains(&hidden.mistake), "{name}: {change:?}");
    }
}

#[test]
fn a_sign_is_all_that_some_mistakes_need() {
    let turning = |signs: [f32; 6]| {
        let keyframes = still().into_iter().zip(signs).enumerate().map(|(index, (keyframe, sign))| {
            let mut pose = keyframe.pose.clone();
            let rotation = Quat::from_rotation_z(0.7 * index as f32) * sign;
            pose.set(RbtIndex::new(1), Rbt { rotation, ..pose.get(RbtIndex::new(1)) });
            keyframe.with_pose(pose)
        });
        Sequence::new(&keyframes.collect::<Vec<_>>()).unwrap()
    };
    let times = key_times();
    let names = |hidden: Vec<Hidden>| hidden.iter().map(|hidden| hidden.mistake.name).collect::<BTreeSet<_>>();
    let same = turning([1.0; 6]);
    let (_, hidden) = revealing(&judged(&same, &times));
    let by_sign = hidden.iter().find(|hidden| hidden.mistake.name == "no-conditional-negation").unwrap();
    assert_eq!(by_sign.playbacks, BOTH);
    let change = change_that_reveals(&judged(&same, &times), by_sign).unwrap();
    assert_eq!((change.kind, change.node), (ChangeKind::OppositeSign, RbtIndex::new(1)));
    let hidden_of_same = names(hidden);
    let hidden_of_other = names(revealing(&judged(&turning([1.0, 1.0, -1.0, 1.0, 1.0, 1.0]), &times)).1);
    let found: Vec<&&str> = hidden_of_same.difference(&hidden_of_other).collect();
    // Blends that take the signs as they are show it too.
    let of_signs = ["no-conditional-negation", "no-conditional-negation-in-control-points", "only-w-negated"];
    assert_eq!(found, [&"lerp-for-slerp", &of_signs[0], &of_signs[1], &of_signs[2], &"slerp-angle-from-cross-product"]);
}

#[test]
fn tolerances_decide() {
    let mut keyframes = still();
    let mut pose = keyframes[2].pose.clone();
    pose.set(RbtIndex::new(0), Rbt { translation: Vec3::X * 0.01, ..Rbt::IDENTITY });
    keyframes[2] = keyframes[2].with_pose(pose);
    let (sequence, times) = (Sequence::new(&keyframes).unwrap(), key_times());
    let names = |units: f64| {
        let judged = Judged { units, ..judged(&sequence, &times) };
        revealing(&judged).0.iter().map(|mistake| mistake.name).collect::<Vec<_>>()
    };
    assert!(names(0.001).contains(&"translation-weights-swapped"));
    assert!(!names(0.01).contains(&"translation-weights-swapped"));
}
