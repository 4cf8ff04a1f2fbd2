//! Interpolation against values computed in 50-digit arithmetic, and its properties over random rotations.

use glam::{Quat, Vec3};
use inbetween::interpolation::{
    ControlPoints, Interpolation, TangentDivisors, bezier_rotation, bezier_translation, nlerp, power,
    rotation_control_points, slerp, translation_control_points,
};
use inbetween::keyframe::{Keyframe, KeyframeList, PlayRange};
use inbetween::pose::{Pose, RbtIndex};
use inbetween::rbt::Rbt;
use proptest::prelude::*;
use serde_json::Value;

const TOLERANCE: f32 = 1e-5;

fn golden() -> Value {
    serde_json::from_str(include_str!("data/interpolation.json")).expect("the golden file is JSON")
}

fn numbers<const N: usize>(value: &Value) -> [f32; N] {
    std::array::from_fn(|place| value[place].as_f64().expect("a number") as f32)
}

fn quat(value: &Value) -> Quat {
    Quat::from_array(numbers(value))
}

/// The distance of two rotations, the nearer of both signs.
fn distance(a: Quat, b: Quat) -> f32 {
    (a - b).length().min((a + b).length())
}

#[test]
fn slerp_meets_the_golden_values() {
    let golden = golden();
    let cases = golden["slerp"].as_array().expect("cases");
    assert!(cases.len() > 100);
    for case in cases {
        let alpha = case["alpha"].as_f64().unwrap() as f32;
        let found = slerp(quat(&case["from"]), quat(&case["to"]), alpha);
        assert!(distance(found, quat(&case["expect"])) < TOLERANCE, "{case}: {found}");
    }
}

#[test]
fn catmull_rom_meets_the_golden_values() {
    let golden = golden();
    let cases = golden["catmull_rom"].as_array().expect("cases");
    assert!(cases.len() > 100);
    for case in cases {
        let alpha = case["alpha"].as_f64().unwrap() as f32;
        let rotations: [Quat; 4] = std::array::from_fn(|place| quat(&case["rotations"][place]));
        let rotation = bezier_rotation(
            rotations[1],
            rotation_control_points(rotations, TangentDivisors::UNIFORM),
            rotations[2],
            alpha,
        );
        assert!(distance(rotation, quat(&case["expect_rotation"])) < TOLERANCE, "{case}: {rotation}");
        let translations: [Vec3; 4] = std::array::from_fn(|place| Vec3::from(numbers(&case["translations"][place])));
        let translation = bezier_translation(
            translations[1],
            translation_control_points(translations, TangentDivisors::UNIFORM),
            translations[2],
            alpha,
        );
        let expected = Vec3::from(numbers(&case["expect_translation"]));
        assert!(translation.distance(expected) < TOLERANCE, "{case}: {translation}");
    }
}

#[test]
fn playback_meets_the_golden_values() {
    let golden = golden();
    let rbt = |value: &Value| Rbt::new(Vec3::from(numbers(&value["translation"])), quat(&value["rotation"]));
    let pose = |value: &Value| Pose::new(value.as_array().unwrap().iter().map(rbt).collect());
    let keyframes = golden["playback"]["keyframes"].as_array().unwrap();
    let list = KeyframeList::new(keyframes.iter().map(|keyframe| Keyframe::new(pose(&keyframe["pose"]))).collect());
    let range = PlayRange::new(&list).unwrap();
    for case in golden["playback"]["cases"].as_array().unwrap() {
        let interpolation = Interpolation::from_name(case["interpolation"].as_str().unwrap()).unwrap();
        let found = range.pose_at(case["key_time"].as_f64().unwrap(), interpolation).unwrap();
        for (found, expected) in found.iter().zip(pose(&case["expect"]).iter()) {
            assert!(distance(found.rotation, expected.rotation) < TOLERANCE, "{case}: {found:?}");
            assert!(found.translation.distance(expected.translation) < TOLERANCE, "{case}: {found:?}");
        }
    }
}

fn any_rotation() -> impl Strategy<Value = Quat> {
    prop::array::uniform4(-1.0f32..1.0)
        .prop_filter("a rotation needs a direction", |q| q.iter().map(|c| c * c).sum::<f32>() > 0.01)
        .prop_map(|q| Quat::from_array(q).normalize())
}

fn any_point() -> impl Strategy<Value = Vec3> {
    prop::array::uniform3(-5.0f32..5.0).prop_map(Vec3::from)
}

fn is_nearly_half_a_turn(from: Quat, to: Quat) -> bool {
    from.dot(to).abs() < 1e-3
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn slerp_is_unit_passes_through_its_ends_and_takes_the_short_way(
        from in any_rotation(), to in any_rotation(), alpha in 0.0f32..=1.0,
    ) {
        let between = slerp(from, to, alpha);
        prop_assert!((between.length() - 1.0).abs() < 1e-6);
        prop_assert!(distance(slerp(from, to, 0.0), from) < 1e-6);
        prop_assert!(distance(slerp(from, to, 1.0), to) < 1e-6);
        let whole = from.dot(to).abs().min(1.0).acos();
        let part = from.dot(between).abs().min(1.0).acos();
        prop_assert!((part - alpha * whole).abs() < 2e-3, "{part} of {whole} at {alpha}");
    }

    #[test]
    fn the_sign_of_a_rotation_has_no_effect(
        c in prop::array::uniform4(any_rotation()), signs in prop::array::uniform4(any::<bool>()), alpha in 0.0f32..=1.0,
    ) {
        let pairs = [(c[2], c[0]), (c[3], c[1]), (c[1], c[2])];
        prop_assume!(!pairs.iter().any(|&(a, b)| is_nearly_half_a_turn(a, b)));
        let turned: [Quat; 4] = std::array::from_fn(|place| if signs[place] { -c[place] } else { c[place] });
        prop_assert!(distance(slerp(c[1], c[2], alpha), slerp(turned[1], turned[2], alpha)) < 1e-5);
        let (inner, inner_turned) = (rotation_control_points(c, TangentDivisors::UNIFORM), rotation_control_points(turned, TangentDivisors::UNIFORM));
        prop_assert!(distance(inner.after_start, inner_turned.after_start) < 1e-5);
        prop_assert!(distance(inner.before_end, inner_turned.before_end) < 1e-5);
    }

    #[test]
    fn splines_are_unit_and_pass_through_their_keyframes(
        c in prop::array::uniform4(any_rotation()), p in prop::array::uniform4(any_point()), alpha in 0.0f32..=1.0,
    ) {
        let inner = rotation_control_points(c, TangentDivisors::UNIFORM);
        prop_assert!((bezier_rotation(c[1], inner, c[2], alpha).length() - 1.0).abs() < 1e-6);
        prop_assert!(distance(bezier_rotation(c[1], inner, c[2], 0.0), c[1]) < 1e-5);
        prop_assert!(distance(bezier_rotation(c[1], inner, c[2], 1.0), c[2]) < 1e-5);
        let inner = translation_control_points(p, TangentDivisors::UNIFORM);
        prop_assert!(bezier_translation(p[1], inner, p[2], 0.0).distance(p[1]) < 1e-5);
        prop_assert!(bezier_translation(p[1], inner, p[2], 1.0).distance(p[2]) < 1e-5);
    }

    /// Speed before and after a keyframe, by the control points on its two sides: a Bézier curve leaves its end with three times the
    /// step to the inner point.
    #[test]
    fn splines_keep_their_speed_across_a_keyframe(
        c in prop::array::uniform5(any_rotation()), p in prop::array::uniform5(any_point()),
    ) {
        prop_assume!(!is_nearly_half_a_turn(c[3], c[1]));
        let before: ControlPoints<Quat> = rotation_control_points([c[0], c[1], c[2], c[3]], TangentDivisors::UNIFORM);
        let after = rotation_control_points([c[1], c[2], c[3], c[4]], TangentDivisors::UNIFORM);
        let (arriving, leaving) = (c[2] * before.before_end.conjugate(), after.after_start * c[2].conjugate());
        prop_assert!(distance(arriving, leaving) < 1e-5, "{arriving} and {leaving}");
        let before = translation_control_points([p[0], p[1], p[2], p[3]], TangentDivisors::UNIFORM);
        let after = translation_control_points([p[1], p[2], p[3], p[4]], TangentDivisors::UNIFORM);
        prop_assert!((p[2] - before.before_end).distance(after.after_start - p[2]) < 1e-5);
    }

    /// The same by differences of samples, for neighbours that are not far apart (a finite step measures nothing on a wild spline).
    #[test]
    fn sampled_motion_has_no_kink(
        turns in prop::array::uniform5((any_point(), 0.05f32..1.2)), p in prop::array::uniform5(any_point()),
    ) {
        let mut rotation = Quat::IDENTITY;
        let poses = turns.iter().zip(p).map(|((axis, angle), point)| {
            rotation = (Quat::from_axis_angle(axis.try_normalize().unwrap_or(Vec3::X), *angle) * rotation).normalize();
            Keyframe::new(Pose::new(vec![Rbt::new(point, rotation)]))
        });
        let list = KeyframeList::new(poses.collect());
        let range = PlayRange::new(&list).unwrap();
        let at = |key_time: f64| range.pose_at(key_time, Interpolation::CatmullRom).unwrap().get(RbtIndex::new(0));
        let step = 1.0 / 256.0;
        let (before, middle, after) = (at(1.0 - step), at(1.0), at(1.0 + step));
        let arriving = (middle.translation - before.translation) / step as f32;
        let leaving = (after.translation - middle.translation) / step as f32;
        prop_assert!(arriving.distance(leaving) < 1.0, "{arriving} and {leaving}");
        let arriving = (middle.rotation * before.rotation.conjugate()).to_scaled_axis() / step as f32;
        let leaving = (after.rotation * middle.rotation.conjugate()).to_scaled_axis() / step as f32;
        prop_assert!(arriving.distance(leaving) < 0.3, "{arriving} and {leaving}");
    }

    #[test]
    fn nlerp_takes_the_same_path(from in any_rotation(), to in any_rotation()) {
        prop_assume!(!is_nearly_half_a_turn(from, to));
        prop_assert!(distance(nlerp(from, to, 0.5), slerp(from, to, 0.5)) < 1e-4);
    }
}

#[test]
fn odd_inputs_give_unit_results() {
    let half_turn = Quat::from_xyzw(1.0, 0.0, 0.0, 0.0);
    let hair = Quat::from_rotation_y(1e-20);
    let tiny = Quat::from_rotation_y(1e-6);
    for from in [Quat::IDENTITY, -Quat::IDENTITY, half_turn, hair, tiny] {
        for to in [Quat::IDENTITY, -Quat::IDENTITY, half_turn, -half_turn, hair, tiny] {
            for alpha in [0.0, 0.25, 0.5, 1.0] {
                for found in [
                    slerp(from, to, alpha),
                    bezier_rotation(
                        from,
                        rotation_control_points([from, from, to, to], TangentDivisors::UNIFORM),
                        to,
                        alpha,
                    ),
                    bezier_rotation(
                        from,
                        rotation_control_points([to, from, to, from], TangentDivisors::UNIFORM),
                        to,
                        alpha,
                    ),
                ] {
                    assert!((found.length() - 1.0).abs() < 1e-6, "{from} to {to} at {alpha}: {found}");
                }
            }
        }
    }
    assert_eq!(power(Quat::IDENTITY, 0.3), Quat::IDENTITY);
}
