//! Feet that stand stay in place.
//!
//! The ends of the legs go their way, and the legs reach for them. The hips go down where a leg would be too short.

use glam::{DVec3, Vec3Swizzles as _};

use super::map::{Foot, Pairs};
use super::motion::{Frame, Motion, move_by, world};
use super::way::{FootWay, runs, spread};
use crate::interchange::reduce::{Samples, Watched};
use crate::keyframe::{Animation, PlayRange, to_f64, whole};
use crate::pose::Pose;
use crate::rbt::Rbt;

/// The most that a leg reaches, in parts of its length: one that is quite straight trembles.
const LONGEST: f64 = 0.9995;
/// The most by which hips go down, in parts of the leg's length.
const DEEPEST: f64 = 0.3;
/// How long before and after a need the hips go down, in seconds.
const EASE: f64 = 0.15;
/// An end that is farther from its place, in parts of the leg's length, is out of reach.
const SHORT: f64 = 0.01;

/// How a foot stands while an animation plays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standing {
    /// How often it stands: stretches of time in which its end is within 2 % of the leg's length of its lowest height.
    pub stances: usize,
    /// The farthest that it moves along the ground within one of them, in parts of the leg's length.
    pub slide: f64,
}

/// Below this height over the lowest, in parts of the leg's length, a foot counts as standing.
const STANDS_BELOW: f64 = 0.02;

/// Measures how a foot stands, 240 times a second.
#[must_use]
pub fn standing(animation: &Animation, foot: &Watched, leg: f64) -> Standing {
    const RATE: usize = 240;
    let Ok(range) = PlayRange::new(&animation.keyframes) else { return Standing { stances: 0, slide: 0.0 } };
    let ms = animation.ms_between_keyframes as usize;
    let steps = to_f64(&(range.timing().total() * whole(ms * RATE) / whole(1000))).ceil();
    let mut places: Vec<DVec3> = Vec::new();
    let mut step = 0_usize;
    #[expect(clippy::cast_precision_loss, reason = "no animation has 2^52 steps")]
    while step as f64 <= steps {
        let elapsed = whole(step) * whole(1000) / whole(ms * RATE);
        let key_time = range.timing().key_time_at(&elapsed);
        let (start, alpha) = range.interval_at(key_time);
        let chain = foot.chain.iter().rev().map(|&(above, rbt)| {
            above
                * if alpha == 0.0 {
                    range.node_at(key_time, animation.interpolation, rbt)
                } else {
                    range.rbt_at(start, alpha, animation.interpolation, rbt)
                }
        });
        places.push(chain.fold(foot.point, |point, link: Rbt| link.transform_point(point)).as_dvec3());
        step += 1;
    }
    let lowest = places.iter().map(|place| place.y).fold(f64::INFINITY, f64::min);
    let runs = runs(places.iter().map(|place| place.y <= lowest + STANDS_BELOW * leg));
    let slide = runs.iter().map(|&(from, to)| spread(&places[from..=to])).fold(0.0, f64::max);
    Standing { stances: runs.len(), slide: slide / leg }
}

/// When feet are planted, and how often one is out of reach.
pub(super) struct Plants {
    /// For each foot and sample whether it is planted.
    pub planted: Vec<Vec<bool>>,
    /// In how many samples a foot is out of reach.
    pub short: usize,
}

/// The motion with its feet put down.
pub(super) fn stood(motion: &Motion<'_>, pairs: &Pairs) -> (Samples, Plants) {
    let ways: Vec<FootWay> = pairs
        .feet
        .iter()
        .enumerate()
        .map(|(index, foot)| FootWay::of(&motion.ends[index], &motion.seconds, motion.grounds[index], foot.length))
        .collect();
    let drops = drops(motion, pairs, &ways);
    let frame = Frame::of(motion.target);
    let mut samples: Option<Samples> = None;
    let mut short = 0;
    for (index, &seconds) in motion.seconds.iter().enumerate() {
        let mut pose = motion.poses[index].clone();
        move_by(motion.target, &mut pose, motion.top, DVec3::Y * -drops[index]);
        let before = pose.clone();
        let mut is_short = false;
        for (foot, way) in pairs.feet.iter().zip(&ways) {
            let wanted = motion.rotations[index][foot.lower.get()];
            let Ok(limb) = motion.target.limb(&before, &before, 0.0, foot.lower) else { continue };
            let reached = limb.standing(way.ends[index], wanted);
            is_short |= reached.end_in_world().distance(way.ends[index]) > SHORT * foot.length;
            for (rbt, rotation) in reached.rotations() {
                pose.set(rbt, Rbt { rotation, ..pose.get(rbt) });
            }
        }
        short += usize::from(is_short);
        // What a leg carries is turned in the world as before.
        let mapped_below = |rbt| {
            let is_below = pairs.feet.iter().any(|foot| motion.target.is_above(foot.lower, rbt));
            (is_below && pairs.nodes.iter().any(|pair| pair.onto == rbt)).then(|| motion.rotations[index][rbt.get()])
        };
        let (pose, _) = frame.posed(&pose, mapped_below);
        push(&mut samples, seconds, pose);
    }
    let samples = samples.unwrap_or_else(|| Samples::starting_with(motion.target.rest_pose().clone()));
    (samples, Plants { planted: ways.into_iter().map(|way| way.planted).collect(), short })
}

fn push(samples: &mut Option<Samples>, seconds: f64, pose: Pose) {
    match samples {
        None => *samples = Some(Samples::starting_with(pose)),
        // The times are those of samples already.
        Some(samples) => drop(samples.push(seconds, pose)),
    }
}

/// By how much the hips go down in each sample, so that all legs reach.
fn drops(motion: &Motion<'_>, pairs: &Pairs, ways: &[FootWay]) -> Vec<f64> {
    let need = |(index, pose): (usize, &Pose)| {
        let world = world(motion.target, pose);
        let of_foot = |(foot, way): (&Foot, &FootWay)| {
            let (joint, end) = (world[foot.upper.get()].translation, way.ends[index]);
            let most = LONGEST * foot.length;
            let along = joint.xz().distance(end.xz()).min(most);
            let height = (most * most - along * along).sqrt();
            (joint.y - end.y - height).clamp(0.0, DEEPEST * foot.length)
        };
        pairs.feet.iter().zip(ways).map(of_foot).fold(0.0, f64::max)
    };
    let needs: Vec<f64> = motion.poses.iter().enumerate().map(need).collect();
    if needs.iter().all(|&need| need == 0.0) {
        return needs;
    }
    let around = |values: &[f64], merge: &dyn Fn(&[f64]) -> f64| -> Vec<f64> {
        let seconds = &motion.seconds;
        let window = |at: f64| {
            let start = seconds.partition_point(|&other| other < at - EASE);
            let end = seconds.partition_point(|&other| other <= at + EASE);
            merge(&values[start..end])
        };
        seconds.iter().map(|&at| window(at)).collect()
    };
    let largest = around(&needs, &|values| values.iter().copied().fold(0.0, f64::max));
    #[expect(clippy::cast_precision_loss, reason = "a window has few samples")]
    let mean = around(&largest, &|values| values.iter().sum::<f64>() / values.len() as f64);
    // Rounding at the ends of windows must not leave a leg too short.
    mean.iter().zip(&needs).map(|(&mean, &need)| mean.max(need)).collect()
}
