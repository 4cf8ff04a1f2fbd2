//! The steering keyframes of an animation that this program exported. A file has no poses of them: they are told from the curves of the
//! intervals beside them.
//!
//! Of such an interval three of the four points of its Bézier curve are known; the fourth is moved until the curve goes through the keys
//! that the file has there. Steering keyframes are on a fine grid, so that the keyframes of a file that is exported again are the same.

use std::f32::consts::PI;

use glam::{Quat, Vec3};

use super::pace::Pace;
use crate::interpolation::{
    ControlPoints, TangentDivisors, bezier_rotation, bezier_translation, conditionally_negated, power,
    rbt_control_points,
};
use crate::keyframe::Keyframe;
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;

/// How often points of curves are moved. Each round is what is left of the last one, times a small part.
const ROUNDS: usize = 40;
/// A key says nothing of a point whose share of the curve is smaller there.
const LEAST_SHARE: f32 = 0.05;
/// The grid of steering keyframes, in radians and in parts of the distance from the origin, at least of 1 unit.
const GRID: f32 = 1e-5;

/// A motion, node by node.
pub(super) trait Moved {
    /// The transform of a node at a time in seconds.
    fn node_at(&self, rbt: RbtIndex, seconds: f64) -> Rbt;

    /// The times of the keys of a node's translation, and of its rotation.
    fn keys(&self, rbt: RbtIndex) -> [&[f64]; 2];

    /// The pose at a time in seconds.
    fn pose_at(&self, seconds: f64) -> Pose;
}

/// Which points of an interval's curve are not known: the one after its start, the one before its end.
#[derive(Clone, Copy)]
struct Unknown {
    after_start: bool,
    before_end: bool,
}

/// Replaces the first and the last keyframe by ones that lead to the motion. `times`: those of the played keyframes, in seconds.
pub(super) fn steer(keyframes: &mut [Keyframe], pace: &Pace, times: &[f64], moved: &impl Moved) {
    let last = times.len() - 2;
    let mut intervals = vec![(0, Unknown { after_start: true, before_end: last == 0 })];
    if last > 0 {
        intervals.push((last, Unknown { after_start: false, before_end: true }));
    }
    for (interval, unknown) in intervals {
        let of_curve = &keyframes[interval..interval + 4];
        let durations = [0, 1, 2].map(|at| of_curve[at].duration);
        let divisors = TangentDivisors::of(durations);
        let poses = [0, 1, 2, 3].map(|at| of_curve[at].pose.clone());
        let mut steering = [poses[0].clone(), poses[3].clone()];
        for node in 0..poses[0].len() {
            let rbt = RbtIndex::new(node);
            let c = [0, 1, 2, 3].map(|at| poses[at].get(rbt));
            let samples = Samples { pace, times, interval, moved, rbt };
            let inner = fitted(c, divisors, unknown, &samples);
            let [before, after] = steering_of(c, inner, divisors);
            steering[0].set(rbt, before);
            steering[1].set(rbt, after);
        }
        let [before, after] = steering.map(|pose| pose.in_bounds());
        if unknown.after_start {
            keyframes[interval].pose = before;
        }
        if unknown.before_end {
            keyframes[interval + 3].pose = after;
        }
    }
}

/// What the file says of a node within an interval.
struct Samples<'a, M> {
    pace: &'a Pace,
    times: &'a [f64],
    interval: usize,
    moved: &'a M,
    rbt: RbtIndex,
}

impl<M: Moved> Samples<'_, M> {
    /// Eased fractions of the interval with the transforms there: at keys of a property, or if there are none, in the middle.
    fn at(&self, property: usize) -> Vec<(f32, Rbt)> {
        let (start, end) = (self.times[self.interval], self.times[self.interval + 1]);
        let easing = self.pace.easing(self.interval);
        let eased = |seconds: f64| easing.value((seconds - start) / (end - start)) as f32;
        let is_of_use = |alpha: f32| alpha * (1.0 - alpha) > 0.0 && share(alpha).max(share(1.0 - alpha)) >= LEAST_SHARE;
        let keys = self.moved.keys(self.rbt)[property];
        let within = keys.iter().copied().filter(|&key| key > start && key < end);
        let mut at: Vec<(f64, f32)> =
            within.map(|key| (key, eased(key))).filter(|&(_, alpha)| is_of_use(alpha)).collect();
        if at.is_empty() {
            let parts = (1..32).map(|part| start + (end - start) * f64::from(part) / 32.0);
            let off = |alpha: f32| (alpha - 0.5).abs();
            let parts = parts.map(|seconds| (seconds, eased(seconds)));
            at.extend(parts.min_by(|a, b| off(a.1).total_cmp(&off(b.1))).filter(|&(_, alpha)| is_of_use(alpha)));
        }
        at.into_iter().map(|(seconds, alpha)| (alpha, self.moved.node_at(self.rbt, seconds))).collect()
    }
}

/// The share of the point after the start in a cubic Bézier curve.
fn share(alpha: f32) -> f32 {
    3.0 * alpha * (1.0 - alpha) * (1.0 - alpha)
}

/// The inner points of a curve that goes through samples; the known ones are those of the four transforms.
fn fitted<M: Moved>(
    c: [Rbt; 4],
    divisors: TangentDivisors,
    unknown: Unknown,
    samples: &Samples<'_, M>,
) -> ControlPoints<Rbt> {
    let inner = rbt_control_points(c, divisors);
    let translations: Vec<(f32, Vec3)> =
        samples.at(0).into_iter().map(|(alpha, rbt)| (alpha, rbt.translation)).collect();
    let rotations: Vec<(f32, Quat)> = samples.at(1).into_iter().map(|(alpha, rbt)| (alpha, rbt.rotation)).collect();
    let translation = solved(
        ControlPoints { after_start: inner.after_start.translation, before_end: inner.before_end.translation },
        unknown,
        &translations,
        |inner, alpha| bezier_translation(c[1].translation, inner, c[2].translation, alpha),
        |wanted, played| wanted - played,
        |point, by| point + by,
    );
    let rotation = solved(
        ControlPoints { after_start: inner.after_start.rotation, before_end: inner.before_end.rotation },
        unknown,
        &rotations,
        |inner, alpha| bezier_rotation(c[1].rotation, inner, c[2].rotation, alpha),
        |wanted, played| conditionally_negated(wanted * played.conjugate()).to_scaled_axis(),
        |point, by| (Quat::from_scaled_axis(by) * point).normalize(),
    );
    ControlPoints {
        after_start: Rbt::new(translation.after_start, rotation.after_start),
        before_end: Rbt::new(translation.before_end, rotation.before_end),
    }
}

/// Moves the unknown points by what is missing at the samples, each weighted by the point's share there: least squares, in rounds.
fn solved<V: Copy>(
    mut inner: ControlPoints<V>,
    unknown: Unknown,
    samples: &[(f32, V)],
    played: impl Fn(ControlPoints<V>, f32) -> V,
    missing: impl Fn(V, V) -> Vec3,
    moved: impl Fn(V, Vec3) -> V,
) -> ControlPoints<V> {
    for _ in 0..ROUNDS {
        for is_start in [true, false] {
            if if is_start { !unknown.after_start } else { !unknown.before_end } {
                continue;
            }
            let (mut total, mut weight) = (Vec3::ZERO, 0.0);
            for &(alpha, wanted) in samples {
                let share = share(if is_start { alpha } else { 1.0 - alpha });
                total += missing(wanted, played(inner, alpha)) * share;
                weight += share * share;
            }
            if weight >= LEAST_SHARE * LEAST_SHARE {
                let point = if is_start { &mut inner.after_start } else { &mut inner.before_end };
                *point = moved(*point, total / weight);
            }
        }
    }
    inner
}

/// The transforms before and after a curve whose inner points are these: the reverse of [`rbt_control_points`], on the grid.
fn steering_of([_, c1, c2, _]: [Rbt; 4], inner: ControlPoints<Rbt>, divisors: TangentDivisors) -> [Rbt; 2] {
    let ControlPoints { after_start: d, before_end: e } = inner;
    // The whole rotation between both neighbours of a keyframe is a multiple of the part that its control point turns.
    let whole = |part: Quat, times: f32| power(conditionally_negated(part), times);
    let before = whole(d.rotation * c1.rotation.conjugate(), divisors.start).conjugate();
    let after = whole(e.rotation * c2.rotation.conjugate(), -divisors.end);
    [
        Rbt::new(
            on_grid(c2.translation, -(d.translation - c1.translation) * divisors.start),
            turned_on_grid(before, c2.rotation),
        ),
        Rbt::new(
            on_grid(c1.translation, (c2.translation - e.translation) * divisors.end),
            turned_on_grid(after, c1.rotation),
        ),
    ]
}

fn on_grid(from: Vec3, by: Vec3) -> Vec3 {
    let grid = GRID * from.abs().max_element().max(1.0).log2().ceil().exp2();
    from + (by / grid).round() * grid
}

fn turned_on_grid(by: Quat, from: Quat) -> Quat {
    let turn = (conditionally_negated(by).to_scaled_axis() / GRID).round() * GRID;
    (Quat::from_scaled_axis(turn.clamp_length_max(PI)) * from).normalize()
}

#[cfg(test)]
mod tests;
