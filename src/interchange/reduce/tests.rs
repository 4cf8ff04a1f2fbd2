//! Dense animations with known shapes, reduced and played again.

use glam::Quat;

use super::*;
use crate::keyframe::to_f64;

const CLOSE: Tolerance = Tolerance { degrees: 0.5, units: 1e-3 };

/// A walk of `nodes` nodes: each turns and moves at a pace of its own.
fn dance(seconds: f64, fps: f64, nodes: usize) -> Samples {
    let rbt = |node: usize, at: f64| {
        let phase = at * (1.0 + 0.1 * node as f64);
        let rotation = Quat::from_rotation_x(phase.sin() as f32) * Quat::from_rotation_y((0.7 * phase).cos() as f32);
        Rbt::new(Vec3::new((0.3 * phase).sin() as f32, 0.0, at as f32), rotation)
    };
    Samples::of(seconds, fps, |at| Pose::new((0..nodes).map(|node| rbt(node, at)).collect())).unwrap()
}

/// How far the animation is from the samples, by the play range that everything else plays by.
fn played_off(samples: &Samples, animation: &Animation) -> Tolerance {
    let range = PlayRange::new(&animation.keyframes).unwrap();
    let unit = f64::from(animation.ms_between_keyframes) / 1000.0;
    let mut worst = Tolerance { degrees: 0.0, units: 0.0 };
    for (seconds, pose) in samples.seconds().iter().zip(samples.poses()) {
        let elapsed = num_rational::BigRational::from_float(seconds / unit).unwrap();
        let played = range.pose_at(range.timing().key_time_at(&elapsed), animation.interpolation).unwrap();
        for (played, sample) in played.iter().zip(pose.iter()) {
            worst = worst.max(Tolerance::between(played, sample));
        }
    }
    worst
}

#[test]
fn few_keyframes_stay_within_the_tolerance() {
    let samples = dance(10.0, 120.0, 7);
    let mut counts = Vec::new();
    for interpolation in Interpolation::ALL {
        let reduced = reduced(&samples, Choice::Within(CLOSE), interpolation);
        let off = played_off(&samples, &reduced.animation);
        assert!(off.degrees <= 0.501 && off.units <= 1.002e-3, "{interpolation:?}: {off:?}");
        assert!((off.degrees - reduced.worst.degrees).abs() < 1e-3, "{off:?} is not {:?}", reduced.worst);
        assert!(reduced.worst.degrees > 0.05, "nothing is left out: {:?}", reduced.worst);
        let timing = reduced.animation.keyframes.timing().unwrap();
        assert!((to_f64(&timing.total()) - 10.0).abs() < 1e-6, "durations are seconds");
        assert_eq!((reduced.animation.interpolation, reduced.samples), (interpolation, 1201));
        counts.push(reduced.animation.keyframes.len());
    }
    assert!(counts[1] < counts[0] && counts[0] < 400, "{counts:?}");
}

#[test]
fn straight_motion_needs_two_keyframes_and_two_to_steer() {
    let samples = Samples::of(2.0, 50.0, |at| {
        Pose::new(vec![Rbt::new(Vec3::X * at as f32, Quat::from_rotation_z(0.25 * at as f32))])
    })
    .unwrap();
    let Reduced { animation, .. } = reduced(&samples, Choice::Within(CLOSE), Interpolation::Linear);
    let keyframes = animation.keyframes.as_slice();
    assert_eq!((keyframes.len(), animation.ms_between_keyframes), (4, 2000));
    assert!(!keyframes.iter().any(Keyframe::has_extras), "one step of 2 s needs no durations");
    let at = |index: usize| keyframes[index].pose.get(RbtIndex::new(0));
    assert_eq!((at(0).translation, at(3).translation), (Vec3::X * -2.0, Vec3::X * 4.0));
    assert!(Tolerance::between(at(3), Rbt::new(Vec3::X * 4.0, Quat::from_rotation_z(1.0))).degrees < 1e-4);
}

#[test]
fn a_jump_keeps_both_of_its_ends() {
    let mut samples = Samples::starting_with(Pose::identity(1));
    let high = Pose::new(vec![Rbt::from_translation(Vec3::Y)]);
    for (seconds, pose) in [(1.0, Pose::identity(1)), (1.0002, high.clone()), (3.0, high)] {
        samples.push(seconds, pose).unwrap();
    }
    let reduced = reduced(&samples, Choice::Within(CLOSE), Interpolation::Linear);
    let durations: Vec<f64> = reduced.animation.keyframes.as_slice().iter().map(|keyframe| keyframe.duration).collect();
    assert_eq!(reduced.animation.ms_between_keyframes, 100);
    assert_eq!(durations, [10.0, 10.0, 0.002, 19.998, 19.998, 1.0]);
}

#[test]
fn every_frame_is_kept_at_a_rate() {
    let samples = dance(1.0, 120.0, 3);
    let ten = reduced(&samples, Choice::Every(10.0), Interpolation::Linear);
    assert_eq!((ten.animation.keyframes.len(), ten.animation.ms_between_keyframes), (13, 100));
    assert!(!ten.animation.keyframes.as_slice().iter().any(Keyframe::has_extras));
    let thirty = reduced(&samples, Choice::Every(30.0), Interpolation::CatmullRom);
    assert_eq!((thirty.animation.keyframes.len(), thirty.animation.ms_between_keyframes), (33, 1000));
    assert!(thirty.worst.degrees < ten.worst.degrees);
    // 0.7 s at 2 a second: 0, 0.5 and the end.
    let rest = reduced(&dance(0.7, 100.0, 1), Choice::Every(2.0), Interpolation::Linear);
    assert_eq!(rest.animation.keyframes.len(), 5);
}

#[test]
fn one_sample_is_held_and_long_gaps_are_filled() {
    let one = Samples::starting_with(Pose::identity(2));
    for choice in [Choice::Within(CLOSE), Choice::Every(30.0)] {
        for interpolation in Interpolation::ALL {
            let reduced = reduced(&one, choice, interpolation);
            assert_eq!(reduced.animation.keyframes.len(), 4);
            assert_eq!(reduced.worst, Tolerance { degrees: 0.0, units: 0.0 });
        }
    }
    let mut samples = Samples::starting_with(Pose::identity(1));
    let at_x = |x: f32| Pose::new(vec![Rbt::from_translation(Vec3::X * x)]);
    samples.push(1050.0, at_x(2.0)).unwrap();
    // Too near to the sample before it, which it replaces.
    samples.push(1_050.000_01, at_x(3.0)).unwrap();
    assert_eq!(samples.pose_at(2000.0), at_x(3.0));
    assert_eq!(samples.at_least_every(0.5).len(), 2102);
    assert_eq!(samples.at_least_every(1e9).len(), samples.len());
    let reduced = reduced(&samples, Choice::Within(CLOSE), Interpolation::Linear);
    assert_eq!(samples.pose_at(525.0), at_x(1.0));
    let timing = reduced.animation.keyframes.timing().unwrap();
    assert!(
        (to_f64(&timing.total()) * f64::from(reduced.animation.ms_between_keyframes) / 1000.0 - 1050.0).abs() < 1e-6
    );
    assert_eq!(samples.push(1e6, Pose::identity(1)), Err(TooLong { seconds: 1e6 }));
}

#[test]
fn a_long_capture_of_many_nodes_is_reduced() {
    let reduced = reduced(&dance(25.0, 120.0, 60), Choice::Within(CLOSE), Interpolation::Linear);
    assert_eq!(reduced.samples, 3001);
    assert!(reduced.animation.keyframes.len() < 2000);
}
