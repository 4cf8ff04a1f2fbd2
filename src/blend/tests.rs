//! The SIMD blends compared with the simple functions.

use glam::{DQuat, Quat, Vec3};
use proptest::prelude::*;

use super::*;
use crate::interpolation::{ControlPoints, bezier_rbt, linear_rbt};
use crate::pose::{LANES, Pose};
use crate::rbt::Rbt;

/// Counts around the borders of blocks, and many.
const COUNTS: [usize; 7] = [0, 1, 15, 16, 17, 22, 10_007];

/// Every set of instructions that this machine has.
fn levels() -> Vec<Level> {
    let widest = widest();
    let mut all = vec![widest];
    #[cfg(target_arch = "x86_64")]
    {
        all.extend(widest.as_avx2().map(Level::Avx2));
        all.extend(widest.as_sse4_2().map(Level::Sse4_2));
        all.extend(widest.as_sse2().map(Level::Sse2));
    }
    all
}

/// The largest error of rotations in radians; larger without fused multiplication and addition.
fn bound(level: Level) -> f64 {
    #[cfg(target_arch = "x86_64")]
    if matches!(level, Level::Sse2(_) | Level::Sse4_2(_)) {
        return 3.5e-7;
    }
    let _ = level;
    3e-7
}

fn any_rbt() -> impl Strategy<Value = Rbt> {
    (prop::array::uniform3(-10.0f32..10.0), prop::array::uniform4(-1.0f32..1.0))
        .prop_filter("a rotation needs a direction", |(_, q)| q.iter().map(|c| c * c).sum::<f32>() > 0.01)
        // Normalised in f32, so that the measured error is the blend's own.
        .prop_map(|(t, q)| Rbt::new(Vec3::from(t), Quat::from_array(q).as_dquat().normalize().as_quat()))
}

/// A second transform for a first: any, equal, negated, half a turn away, or close to half a turn.
fn partner(from: Rbt) -> impl Strategy<Value = Rbt> {
    let near = from.rotation;
    prop_oneof![
        4 => any_rbt(),
        1 => Just(from),
        1 => Just(Rbt::new(from.translation, -near)),
        1 => Just(Rbt::new(-from.translation, Quat::from_xyzw(near.w, -near.z, near.y, -near.x))),
        2 => any_rbt().prop_map(move |other| Rbt::new(other.translation, (near + other.rotation * 1e-4).as_dquat().normalize().as_quat())),
    ]
}

/// `slerp` in f64, of the nearer signs.
fn slerp_f64(from: Quat, to: Quat, alpha: f32) -> DQuat {
    slerp_of(from.as_dquat().normalize(), to.as_dquat().normalize(), alpha)
}

/// The angle of the rotation between two, in radians.
fn angle(a: DQuat, b: DQuat) -> f64 {
    let b = if a.dot(b) < 0.0 { -b } else { b };
    4.0 * (a - b).length().atan2((a + b).length())
}

fn is_half_a_turn(from: Quat, to: Quat) -> bool {
    from.dot(to).abs() < 1e-6
}

fn blend_linear(level: Level, alpha: f32, from: &Pose, to: &Pose) -> Pose {
    let mut into = Pose::identity(0);
    into.fill(from.len(), |blocks| linear(level, &Weights::at(alpha), from.blocks(), to.blocks(), blocks));
    into
}

proptest! {
    #[test]
    fn linear_is_lerp_and_slerp(
        pairs in prop::collection::vec(any_rbt().prop_flat_map(|from| (Just(from), partner(from))), 0..40),
        alpha in 0.0f32..=1.0,
    ) {
        let (from, to): (Vec<_>, Vec<_>) = pairs.iter().copied().unzip();
        for level in levels() {
            let blended = blend_linear(level, alpha, &Pose::from_slice(&from), &Pose::from_slice(&to));
            for ((from, to), blended) in pairs.iter().zip(blended.iter()) {
                let simple = linear_rbt(*from, *to, alpha);
                prop_assert!(blended.translation.distance(simple.translation) < 4e-6);
                let rotation = blended.rotation.as_dquat();
                prop_assert!((rotation.length() - 1.0).abs() < 3e-7, "{} is not unit", blended.rotation);
                if !is_half_a_turn(from.rotation, to.rotation) {
                    let off = angle(rotation, slerp_f64(from.rotation, to.rotation, alpha));
                    prop_assert!(off < bound(level), "{off} rad off at {alpha} with {level:?}: {from:?} {to:?}");
                    prop_assert!(angle(rotation, simple.rotation.as_dquat()) < 1e-6);
                }
            }
        }
    }

    #[test]
    fn bezier_is_de_casteljau(
        curves in prop::collection::vec(any_rbt().prop_flat_map(|a| (Just(a), partner(a), partner(a), partner(a))), 0..40),
        alpha in 0.0f32..=1.0,
    ) {
        let poses = [0, 1, 2, 3].map(|index| {
            Pose::new(curves.iter().map(|&(a, b, c, d)| [a, b, c, d][index]).collect::<Vec<_>>())
        });
        let [start, after_start, before_end, end] = poses.each_ref().map(Pose::blocks);
        for level in levels() {
            let mut blended = Pose::identity(0);
            let all = Curves { start, after_start, before_end, end };
            blended.fill(curves.len(), |blocks| bezier(level, &Weights::at(alpha), all, blocks));
            for (&(start, after_start, before_end, end), blended) in curves.iter().zip(blended.iter()) {
                let simple = bezier_rbt(start, ControlPoints { after_start, before_end }, end, alpha);
                prop_assert!(blended.translation.distance(simple.translation) < 1e-5);
                prop_assert!((blended.rotation.as_dquat().length() - 1.0).abs() < 3e-7);
                let [a, b, c, d] = [start, after_start, before_end, end].map(|rbt| rbt.rotation);
                let quarter = |p: DQuat, q: DQuat| p.dot(q).abs() < 1e-3;
                let step = |p: Quat, q: Quat| slerp_f64(p, q, alpha);
                let (ab, bc, cd) = (step(a, b), step(b, c), step(c, d));
                let (abc, bcd) = (slerp_of(ab, bc, alpha), slerp_of(bc, cd, alpha));
                // If one of the six blends is close to half a turn, rounding decides its direction.
                let is_half_turn = [(a, b), (b, c), (c, d)].iter().any(|&(p, q)| quarter(p.as_dquat(), q.as_dquat()))
                    || quarter(ab, bc) || quarter(bc, cd) || quarter(abc, bcd);
                if !is_half_turn {
                    let off = angle(blended.rotation.as_dquat(), slerp_of(abc, bcd, alpha));
                    prop_assert!(off < 5e-7, "{off} rad off at {alpha} with {level:?}");
                }
            }
        }
    }
}

/// The same of unit quaternions in f64.
fn slerp_of(from: DQuat, to: DQuat, alpha: f32) -> DQuat {
    let to = if from.dot(to) < 0.0 { -to } else { to };
    let theta = 2.0 * (from - to).length().atan2((from + to).length());
    if theta == 0.0 {
        return from;
    }
    let alpha = f64::from(alpha);
    (from * ((1.0 - alpha) * theta).sin() + to * (alpha * theta).sin()) * theta.sin().recip()
}

fn spread(count: usize, phase: f32) -> Pose {
    let rbt = |node: usize| {
        let phase = phase + 0.37 * node as f32;
        let axis = Vec3::new(phase.sin(), (1.3 * phase).cos(), (0.7 * phase).sin() + 0.1).normalize();
        Rbt::new(axis * 3.0, Quat::from_axis_angle(axis, phase))
    };
    Pose::new((0..count).map(rbt).collect::<Vec<_>>())
}

#[test]
fn any_number_of_nodes_is_blended_and_what_fills_the_last_block_stays_the_identity() {
    for count in COUNTS {
        let (from, to) = (spread(count, 0.0), spread(count, 2.0));
        let blended = blend_linear(widest(), 0.3, &from, &to);
        assert_eq!(blended.len(), count);
        for ((from, to), blended) in from.iter().zip(to.iter()).zip(blended.iter()) {
            let simple = linear_rbt(from, to, 0.3);
            assert!(blended.translation.distance(simple.translation) < 4e-6);
            assert!(angle(blended.rotation.as_dquat(), simple.rotation.as_dquat()) < 1e-6);
        }
        if count % LANES != 0 {
            let last = blended.blocks().last().unwrap();
            for lane in count % LANES..LANES {
                assert_eq!(last.get(lane), Rbt::IDENTITY);
            }
        }
    }
}

#[test]
fn what_is_equal_stays_as_it_is() {
    let pose = spread(50, 1.0);
    for alpha in [0.1, 0.25, 0.5, 0.9] {
        let blended = blend_linear(widest(), alpha, &pose, &pose);
        for (before, after) in pose.iter().zip(blended.iter()) {
            assert_eq!(before.translation, after.translation);
            assert!(angle(before.rotation.as_dquat(), after.rotation.as_dquat()) < 3e-7);
        }
    }
}

#[test]
#[cfg(target_arch = "x86_64")]
fn processors_with_fused_operations_agree_to_the_bit() {
    let (from, to) = (spread(100, 0.0), spread(100, 2.0));
    if let Some(avx2) = widest().as_avx2() {
        assert_eq!(blend_linear(widest(), 0.37, &from, &to), blend_linear(Level::Avx2(avx2), 0.37, &from, &to));
    }
}

#[test]
fn nodes_are_placed_below_their_parents_to_the_bit_as_by_the_simple_product() {
    for (level, count) in levels().into_iter().flat_map(|level| COUNTS.map(|count| (level, count))) {
        let pose = spread(count, 0.5);
        let mut parent_from_nodes = vec![MatrixBlock::default(); pose.blocks().len()];
        matrices(level, pose.blocks(), &mut parent_from_nodes);
        // Below no parent: the matrices themselves.
        let mut alone = vec![AlignedAffine::IDENTITY; count];
        compose(level, &parent_from_nodes, 0, &vec![u32::MAX; count], &mut alone, 0);
        for (rbt, alone) in pose.iter().zip(&alone) {
            assert!(alone.get().abs_diff_eq(rbt.to_affine(), 1e-6), "{level:?}: {alone:?} is not {rbt:?}");
        }
        // Parents are earlier nodes, some near and some far. The nodes are composed in two calls.
        let parents: Vec<u32> =
            (0..count as u32).map(|index| if index % 7 == 0 { u32::MAX } else { index / 3 }).collect();
        let mut placed = vec![AlignedAffine::IDENTITY; count];
        let (early, late) = parents.split_at(count / 3);
        compose(level, &parent_from_nodes, 0, early, &mut placed, 0);
        compose(level, &parent_from_nodes, early.len(), late, &mut placed, early.len());
        for (index, parent) in parents.iter().enumerate() {
            let simple = match placed.get(*parent as usize) {
                Some(above) => above.get() * alone[index].get(),
                None => alone[index].get(),
            };
            assert_eq!(placed[index].get(), simple, "{level:?}: node {index} of {count}");
            assert_eq!(AlignedAffine::from(simple), placed[index]);
        }
    }
}
