//! Intervals in which a node turns by nearly 180 degrees: rounding decides the direction of the turn.

use std::ops::Range;

use glam::Quat;

use crate::keyframe::{Easing, Keyframe};
use crate::pose::RbtIndex;

/// The least angle in degrees at which the direction of a turn counts as ambiguous.
pub const AMBIGUOUS_DEGREES: f32 = 170.0;
/// cos([`AMBIGUOUS_DEGREES`] / 2): quaternions with a smaller absolute dot product are at least that far apart. A test checks the value.
const HALF_COSINE: f32 = 0.087_155_74;

/// The angle from one rotation to another in degrees, the short way: exact for small angles too.
pub fn degrees_between(from: Quat, to: Quat) -> f32 {
    let turn = from.conjugate() * to;
    (2.0 * turn.xyz().length().atan2(turn.w.abs())).to_degrees()
}

/// Whether an interval is interpolated: it is in the played range and its easing is not `hold`.
fn blends(keyframes: &[Keyframe], index: usize) -> bool {
    index > 0 && index + 2 < keyframes.len() && keyframes[index].easing != Easing::Hold
}

/// Whether one of these nodes turns by nearly half a turn in the interval that begins at a keyframe.
pub fn has_half_turn(keyframes: &[Keyframe], index: usize, rbts: Range<usize>) -> bool {
    blends(keyframes, index) && !keyframes[index].pose.shares_with(&keyframes[index + 1].pose) && {
        let (from, to) = (&keyframes[index].pose, &keyframes[index + 1].pose);
        let turns = |rbt| from.get(rbt).rotation.dot(to.get(rbt).rotation).abs() < HALF_COSINE;
        rbts.map(RbtIndex::new).any(turns)
    }
}

/// Those nodes, and by how many degrees they turn.
pub fn nodes(keyframes: &[Keyframe], index: usize, rbts: impl Iterator<Item = RbtIndex>) -> Vec<(RbtIndex, f32)> {
    if !blends(keyframes, index) {
        return Vec::new();
    }
    let rotation = |index: usize, rbt| keyframes[index].pose.get(rbt).rotation;
    rbts.map(|rbt| (rbt, degrees_between(rotation(index, rbt), rotation(index + 1, rbt))))
        .filter(|&(_, degrees)| degrees > AMBIGUOUS_DEGREES)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::Pose;
    use crate::rbt::Rbt;

    #[test]
    fn angles_are_the_short_way() {
        let turned = Quat::from_rotation_x(3.0);
        assert!((degrees_between(Quat::IDENTITY, turned) - 3.0_f32.to_degrees()).abs() < 1e-3);
        assert!((degrees_between(Quat::IDENTITY, -turned) - 3.0_f32.to_degrees()).abs() < 1e-3);
    }

    fn list(degrees: &[f32]) -> Vec<Keyframe> {
        let turned = |&degrees: &f32| Rbt::from_rotation(Quat::from_rotation_y(degrees.to_radians()));
        degrees.iter().map(|degrees| Keyframe::new(Pose::new(vec![Rbt::IDENTITY, turned(degrees)]))).collect()
    }

    #[test]
    fn nearly_half_a_turn_is_found_and_nothing_else() {
        assert!((HALF_COSINE - (AMBIGUOUS_DEGREES / 2.0).to_radians().cos()).abs() < 1e-7);
        for (turn, expected) in [(169.5, false), (170.5, true), (180.0, true), (189.5, true), (190.5, false)] {
            let keyframes = list(&[0.0, 0.0, turn, turn, turn]);
            assert_eq!(has_half_turn(&keyframes, 1, 0..2), expected, "{turn}°");
            assert!(!has_half_turn(&keyframes, 1, 0..1), "the other node stands still");
            let found = nodes(&keyframes, 1, (0..2).map(RbtIndex::new));
            assert_eq!(found.len(), usize::from(expected), "{turn}°");
        }
    }

    #[test]
    fn what_only_steers_or_holds_turns_nowhere() {
        let mut keyframes = list(&[0.0, 180.0, 0.0, 0.0, 180.0]);
        assert_eq!((0..5).filter(|&index| has_half_turn(&keyframes, index, 0..2)).collect::<Vec<_>>(), [1]);
        keyframes[1].easing = Easing::Hold;
        assert!(!has_half_turn(&keyframes, 1, 0..2));
    }
}
