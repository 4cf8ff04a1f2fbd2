//! Steering keyframes of curves that are known.

use serde_json::{Value, json};

use super::*;
use crate::interpolation::Interpolation;
use crate::keyframe::{Easing, KeyframeIndex, KeyframeList, PlayRange};

/// What a file says of an animation with keyframes at whole seconds, which is read by the formulas of the player.
struct Course {
    keyframes: KeyframeList,
    easing: Easing,
    times: Vec<f64>,
    /// The times of all channels.
    keys: Vec<f64>,
}

impl Course {
    /// With so many keys in each interval besides those at its ends.
    fn of(keyframes: Vec<Keyframe>, easing: Easing, keys: u32) -> Self {
        let mut times = vec![0.0];
        for keyframe in &keyframes[1..keyframes.len() - 2] {
            times.push(times[times.len() - 1] + keyframe.duration);
        }
        let within = |pair: &[f64]| {
            let (start, length) = (pair[0], pair[1] - pair[0]);
            (0..=keys).map(move |key| start + length * f64::from(key) / f64::from(keys + 1)).collect::<Vec<f64>>()
        };
        let keys = times.windows(2).flat_map(within).collect();
        Self { keyframes: KeyframeList::new(keyframes), easing, times, keys }
    }

    fn pace(&self) -> Pace {
        let durations: Vec<f64> = self.times.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let easings = vec![self.easing.name(); durations.len()];
        let own = json!({
            "interpolation": "catmull-rom", "ms_between_keyframes": 1000, "durations": durations, "easings": easings,
        });
        let Value::Object(own) = own else { unreachable!("it is one") };
        Pace::of(&own, self.times[self.times.len() - 1]).expect("it is a pace")
    }

    /// The keyframes, of which the first and the last are told from the curve. Before, they are as the nearest played one.
    fn steered(&self) -> Vec<Keyframe> {
        let mut keyframes = self.keyframes.as_slice().to_vec();
        let last = keyframes.len() - 1;
        keyframes[0].pose = keyframes[1].pose.clone();
        keyframes[last].pose = keyframes[last - 1].pose.clone();
        steer(&mut keyframes, &self.pace(), &self.times, self);
        keyframes
    }
}

impl Moved for Course {
    fn node_at(&self, rbt: RbtIndex, seconds: f64) -> Rbt {
        let interval = self.times.partition_point(|&time| time <= seconds).clamp(1, self.times.len() - 1) - 1;
        let (start, end) = (self.times[interval], self.times[interval + 1]);
        let alpha = self.easing.value((seconds - start) / (end - start)) as f32;
        let range = PlayRange::new(&self.keyframes).expect("it plays");
        range.rbt_at(KeyframeIndex::new(interval + 1), alpha, Interpolation::CatmullRom, rbt)
    }

    fn keys(&self, _: RbtIndex) -> [&[f64]; 2] {
        [&self.keys; 2]
    }

    fn pose_at(&self, seconds: f64) -> Pose {
        let nodes = self.keyframes.as_slice()[0].pose.len();
        Pose::new((0..nodes).map(|node| self.node_at(RbtIndex::new(node), seconds)).collect())
    }
}

fn turn(axis: [f32; 3], degrees: f32) -> Quat {
    Quat::from_axis_angle(Vec3::from(axis).normalize(), degrees.to_radians())
}

/// Keyframes of a node that turns and moves unevenly, and of one that rests, with these durations.
fn wandering(durations: &[f64]) -> Vec<Keyframe> {
    let keyframe = |(at, &duration): (usize, &f64)| {
        let part = at as f32;
        let moved = Rbt::new(
            Vec3::new(part * 1.5 - 3.0, (part * 2.1).sin() * 2.0, 40.0 + (part * 1.3).cos()),
            turn([1.0, part.sin(), 0.4], 35.0 * part + 20.0 * (part * 1.7).sin()),
        );
        let rests = Rbt::new(Vec3::new(0.1, -2.0, 3.0), turn([0.2, 0.3, 0.4], 100.0));
        Keyframe { duration, ..Keyframe::new(Pose::new(vec![moved, rests])) }
    };
    durations.iter().enumerate().map(keyframe).collect()
}

/// The angle in degrees, and the distance.
fn apart(a: Rbt, b: Rbt) -> (f32, f32) {
    let chord = (a.rotation - b.rotation).length().min((a.rotation + b.rotation).length());
    (4.0 * (chord / 2.0).asin().to_degrees(), a.translation.distance(b.translation))
}

#[track_caller]
fn assert_near(found: &Pose, expected: &Pose, degrees: f32, units: f32) {
    for (found, expected) in found.iter().zip(expected.iter()) {
        let off = apart(found, expected);
        assert!(off.0 <= degrees && off.1 <= units, "{off:?}: {found:?} and {expected:?}");
    }
}

#[test]
fn a_curve_gives_back_the_keyframes_that_steer_it() {
    let easings = ["linear", "sine-in-out", "back-out", "bounce-in"].map(|name| Easing::from_name(name).unwrap());
    for durations in [&[1.0; 6][..], &[1.0, 0.5, 2.0, 1.0, 3.0, 1.0], &[1.0, 2.0, 0.25, 1.0, 1.0]] {
        for easing in easings {
            let course = Course::of(wandering(durations), easing, 12);
            let (found, expected) = (course.steered(), course.keyframes.as_slice());
            let last = expected.len() - 1;
            for end in [0, last] {
                assert_near(&found[end].pose, &expected[end].pose, 0.02, 1e-3);
            }
            assert_eq!(found[1..last], expected[1..last], "what is played is not touched");
        }
    }
}

#[test]
fn of_one_interval_both_ends_are_told() {
    let course = Course::of(wandering(&[1.0; 4]), Easing::Linear, 40);
    let (found, expected) = (course.steered(), course.keyframes.as_slice());
    // One point makes up for a part of the other: only the curve is exact.
    let again =
        Course { keyframes: KeyframeList::new(found.clone()), ..Course::of(wandering(&[1.0; 4]), Easing::Linear, 40) };
    for at in 0..=50 {
        let seconds = f64::from(at) / 50.0;
        assert_near(&again.pose_at(seconds), &course.pose_at(seconds), 0.01, 1e-4);
    }
    for end in [0, 3] {
        assert_near(&found[end].pose, &expected[end].pose, 1.0, 0.05);
    }
}

#[test]
fn keyframes_that_were_told_are_told_again_to_the_bit() {
    for easing in [Easing::Linear, Easing::from_name("cubic-in").unwrap()] {
        let first = Course::of(wandering(&[1.0, 0.5, 2.0, 1.0, 3.0, 1.0]), easing, 9).steered();
        let second = Course::of(first.clone(), easing, 9).steered();
        assert_eq!(second, first, "{}", easing.name());
    }
}

#[test]
fn steering_keyframes_are_on_the_grid() {
    let by = Vec3::new(0.123_456_78, -1.0, 7.654_321);
    let near = on_grid(Vec3::new(0.5, 0.0, -1.0), by) - Vec3::new(0.5, 0.0, -1.0);
    assert!((near - by).abs().max_element() <= GRID, "{near}");
    // The origin is 300 units away, so single precision is coarse there: the grid is too.
    let far = on_grid(Vec3::splat(300.0), by) - Vec3::splat(300.0);
    assert!((far - by).abs().max_element() <= 512.0 * GRID, "{far}");
    let turned = turned_on_grid(turn([0.0, 1.0, 0.0], 30.0), Quat::IDENTITY).to_scaled_axis() / GRID;
    assert!((turned - turned.round()).abs().max_element() < 0.05, "{turned}");
}

#[test]
fn what_says_nothing_leaves_what_was_guessed() {
    // `hold` shows nothing of its curve.
    let course = Course::of(wandering(&[1.0; 6]), Easing::Hold, 12);
    let (found, expected) = (course.steered(), course.keyframes.as_slice());
    assert_near(&found[0].pose, &expected[1].pose, 0.01, 1e-3);
    assert_near(&found[5].pose, &expected[4].pose, 0.01, 1e-3);
    // Without keys within the intervals the middle is read.
    let course = Course::of(wandering(&[1.0; 6]), Easing::Linear, 0);
    assert_near(&course.steered()[0].pose, &course.keyframes.as_slice()[0].pose, 0.02, 1e-3);
}

#[test]
fn wide_turns_and_standing_still_have_steering_keyframes_too() {
    let keyframe = |degrees: f32| Keyframe::new(Pose::new(vec![Rbt::new(Vec3::ZERO, turn([0.0, 0.0, 1.0], degrees))]));
    // Half a turn goes either way, so its curve may not be found again; then the import says that the motion is another.
    for (course, is_found) in [
        ([0.0; 5], true),
        ([0.0, 90.0, 0.0, 90.0, 0.0], true),
        ([10.0, 10.0, 150.0, 150.0, 10.0], true),
        ([10.0, 10.0, 190.0, 190.0, 10.0], false),
        ([0.0, 180.0, 0.0, 180.0, 0.0], false),
    ] {
        let course = Course::of(course.map(keyframe).to_vec(), Easing::Linear, 7);
        let found = course.steered();
        for end in [0, 4] {
            let Rbt { translation, rotation } = found[end].pose.get(RbtIndex::new(0));
            assert!(translation == Vec3::ZERO && (rotation.length() - 1.0).abs() < 1e-5, "{rotation}");
        }
        let again = Course::of(found, Easing::Linear, 7);
        for part in (1..20).filter(|_| is_found) {
            let seconds = 0.1 * f64::from(part);
            assert_near(&again.pose_at(seconds), &course.pose_at(seconds), 0.05, 0.0);
        }
    }
}
