//! Finds keys that keep every node within a bound in the world.
//!
//! Errors add up along a chain of nodes, and a turn moves what is far away. So each channel gets a share of the bound, the errors are
//! measured, and the shares are changed until the worst node of each chain is just within.

use std::f64::consts::PI;

use super::keyed::{Keyed, Reader};
use super::keys::{self, Curves};
use super::measure::{Off, Tree};
use super::motion::{Motion, Property};
use crate::parallel::map_in_order;

/// Rounds of measuring that may make fewer keys, and the most rounds to meet the bound.
const ROUNDS: usize = 6;
const MOST_ROUNDS: usize = 20;
/// So many rounds without a tenth less of the worst error say that single precision allows no less.
const IDLE_ROUNDS: usize = 4;
/// The part of the bound that a round aims at.
const AIM: f64 = 0.95;
/// Times between two neighbouring ends of spans, while keys are sought; at the end four times as many.
const TIMES_OF_SPAN: usize = 32;
/// The most times of a round.
const MOST_TIMES: usize = 16_384;

/// How exact an animation is, in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// In degrees.
    pub degrees: f64,
    /// In scene units.
    pub units: f64,
}

impl Default for Tolerance {
    fn default() -> Self {
        Self { degrees: 0.01, units: 1e-4 }
    }
}

impl Tolerance {
    /// An error as a part of the bound.
    fn part(self, off: Off) -> f64 {
        (off.turned.0 / self.degrees.to_radians()).max(off.moved.0 / self.units)
    }
}

/// Keys, and what every node is off with them.
pub struct Fitted {
    /// A channel for each motion.
    pub keyed: Vec<Keyed>,
    /// For each node the worst.
    pub off: Vec<Off>,
}

/// What an animation is read by.
fn readers(curves: Curves) -> &'static [Reader] {
    match curves {
        Curves::Linear => &[Reader::Exact, Reader::ByComponents],
        Curves::Cubic => &[Reader::Exact],
    }
}

/// A key for each frame, and how far that is off.
pub fn each_frame(tree: &Tree, motions: &[Motion], frames_per_second: u32, curves: Curves) -> Fitted {
    let keyed = map_in_order(motions, |motion| keys::each_frame(motion, frames_per_second, curves));
    let off = tree.measured(motions, &keyed, readers(curves), &times(motions, 4 * TIMES_OF_SPAN));
    Fitted { keyed, off }
}

/// As few keys as stay within the bound, if single precision can.
pub fn within(tree: &Tree, motions: &[Motion], tolerance: Tolerance, curves: Curves) -> Fitted {
    let mut shares = shares(tree, motions, tolerance);
    let (few, many) = (times(motions, TIMES_OF_SPAN), times(motions, 4 * TIMES_OF_SPAN));
    let mut best: Option<Fitted> = None;
    let (mut least, mut idle) = (f64::INFINITY, 0);
    let mut round = 0;
    loop {
        round += 1;
        let jobs: Vec<(&Motion, f64)> = motions.iter().zip(shares.iter().copied()).collect();
        let keyed = map_in_order(&jobs, |(motion, share)| keys::within(motion, *share, curves));
        let count = |keyed: &[Keyed]| keyed.iter().map(|channel| channel.seconds.len()).sum::<usize>();
        let is_fewer = best.as_ref().is_none_or(|best| count(&keyed) < count(&best.keyed));
        let mut off = tree.measured(motions, &keyed, readers(curves), &few);
        let is_within = |off: &[Off]| off.iter().all(|&off| tolerance.part(off) <= 1.0);
        if is_within(&off) && is_fewer {
            off = tree.measured(motions, &keyed, readers(curves), &many);
            if is_within(&off) {
                best = Some(Fitted { keyed: keyed.clone(), off: off.clone() });
            }
        }
        let worst = off.iter().map(|&off| tolerance.part(off)).fold(0.0, f64::max);
        idle = if worst < 0.9 * least { 0 } else { idle + 1 };
        least = least.min(worst);
        let is_last = round == MOST_ROUNDS || (best.is_none() && idle == IDLE_ROUNDS);
        if (round >= ROUNDS && best.is_some()) || is_last {
            return best.unwrap_or_else(|| {
                let off = tree.measured(motions, &keyed, readers(curves), &many);
                Fitted { keyed, off }
            });
        }
        let worst_below = worst_below(tree, &off, tolerance);
        for (motion, share) in motions.iter().zip(&mut shares) {
            *share *= (AIM / worst_below[motion.node]).clamp(0.4, 2.0);
        }
    }
}

/// For each node the worst part of the bound of all nodes from it down.
fn worst_below(tree: &Tree, off: &[Off], tolerance: Tolerance) -> Vec<f64> {
    let mut worst: Vec<f64> = off.iter().map(|&off| tolerance.part(off)).collect();
    for (node, parent) in tree.parents().iter().enumerate().rev() {
        if let Some(parent) = *parent {
            worst[parent] = worst[parent].max(worst[node]);
        }
    }
    worst
}

/// For each motion what it may be off to begin with: equal parts of the bound along the longest chain through it, and less for a turn that
/// moves what is far away.
fn shares(tree: &Tree, motions: &[Motion], tolerance: Tolerance) -> Vec<f64> {
    let nodes = tree.parents().len();
    let mut own = vec![0.0_f64; nodes];
    for motion in motions.iter().filter(|motion| !motion.is_constant() && motion.property == Property::Rotation) {
        own[motion.node] += 1.0;
    }
    let (mut above, mut below) = (own.clone(), own.clone());
    for (node, parent) in tree.parents().iter().enumerate() {
        if let Some(parent) = *parent {
            above[node] += above[parent];
        }
    }
    // How far away anything below is, in scene units.
    let moments = times(motions, 1);
    let mut reach = vec![0.0_f64; nodes];
    for seconds in moments.iter().step_by(moments.len().div_ceil(64).max(1)) {
        let places = tree.places(motions, *seconds);
        for node in 0..nodes {
            let mut up = tree.parents()[node];
            while let Some(ancestor) = up {
                reach[ancestor] = reach[ancestor].max(places[node].distance(places[ancestor]));
                up = tree.parents()[ancestor];
            }
        }
    }
    for (node, parent) in tree.parents().iter().enumerate().rev() {
        if let Some(parent) = *parent {
            below[parent] = below[parent].max(own[parent] + below[node]);
        }
    }
    let share = |motion: &Motion| {
        let chain = (above[motion.node] + below[motion.node] - own[motion.node]).max(1.0);
        match motion.property {
            Property::Rotation => {
                let by_reach = tolerance.units / reach[motion.node].max(1e-9);
                tolerance.degrees.to_radians().min(by_reach).min(PI) / chain
            }
            Property::Translation => tolerance.units / (chain + 1.0),
            Property::Scale => tolerance.units / reach[motion.node].max(1e-9) / chain,
        }
    };
    motions.iter().map(share).collect()
}

/// Times to measure at: so many between any two neighbouring ends of spans, but not in jumps.
fn times(motions: &[Motion], of_span: usize) -> Vec<f64> {
    let moving = || motions.iter().filter(|motion| !motion.is_constant());
    let mut ends: Vec<f64> = moving().flat_map(|motion| &motion.spans).flat_map(|span| span.seconds).collect();
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    let mut jumps: Vec<[f64; 2]> = moving().flat_map(Motion::jumps).collect();
    jumps.sort_by(|a, b| a[0].total_cmp(&b[0]));
    jumps.dedup();
    // All are short, so one that begins before another ends before it, or as good as that.
    let is_in_jump = |seconds: f64| {
        let begun = jumps.partition_point(|jump| jump[0] <= seconds);
        jumps[..begun].last().is_some_and(|jump| seconds <= jump[1])
    };
    let most = MOST_TIMES * of_span / TIMES_OF_SPAN;
    let of_span = of_span.min(most / ends.len().max(1)).max(2);
    let inner = |pair: &[f64]| {
        let (start, length) = (pair[0], pair[1] - pair[0]);
        // Not in the middle of equal parts, where errors that are symmetric would vanish together.
        (0..of_span).map(move |part| start + length * (part as f64 + 0.618) / of_span as f64).collect::<Vec<f64>>()
    };
    ends.windows(2).flat_map(inner).filter(|&seconds| !is_in_jump(seconds)).collect()
}
