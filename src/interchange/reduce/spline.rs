//! Keyframes of Catmull-Rom splines: added where the curve is off, then left out where it stays near without them.

use super::{LONGEST_STEP, SHORTEST_STEP, Track, Tracks};
use crate::interpolation::{ControlPoints, TangentDivisors, bezier_rbt, rbt_control_points};
use crate::rbt::Rbt;

/// The samples that become keyframes.
pub(super) fn keys(tracks: &Tracks<'_>) -> Vec<usize> {
    let last = tracks.seconds.len() - 1;
    if last == 0 {
        return vec![0];
    }
    let mut keys = vec![0, last];
    // An interval's curve changes with the keyframes beside it: all are tried again until nothing is added.
    loop {
        let added: Vec<usize> =
            (0..keys.len() - 1).filter_map(|interval| worst_sample(tracks, &keys, interval)).collect();
        if added.is_empty() {
            break;
        }
        keys.extend(added);
        keys.sort_unstable();
    }
    leave_out(tracks, &mut keys);
    keys
}

/// Leaves out each keyframe without which the curves around it stay near the samples.
fn leave_out(tracks: &Tracks<'_>, keys: &mut Vec<usize>) {
    let mut index = 1;
    while index + 1 < keys.len() {
        let key = keys.remove(index);
        let changed = index.saturating_sub(2)..(index + 2).min(keys.len() - 1);
        if changed.into_iter().any(|interval| worst_sample(tracks, keys, interval).is_some()) {
            keys.insert(index, key);
            index += 1;
        }
    }
}

/// A sample of an interval near the one that is farthest from the curve, if that is beyond the tolerance; the middle one of an interval that is too
/// long. `None` where the interval is good, or has no samples within.
fn worst_sample(tracks: &Tracks<'_>, keys: &[usize], interval: usize) -> Option<usize> {
    let (from, to) = (keys[interval], keys[interval + 1]);
    if to == from + 1 {
        return None;
    }
    if tracks.seconds[to] - tracks.seconds[from] > LONGEST_STEP {
        return Some(usize::midpoint(from, to));
    }
    let curves: Vec<Curve> = tracks.nodes.iter().map(|track| Curve::of(tracks, track, keys, interval)).collect();
    let mut worst = (1.0, None);
    for sample in from + 1..to {
        let alpha = tracks.alpha(from, to, sample);
        let of_track = |(curve, track): (&Curve, &Track)| tracks.excess(curve.at(alpha), track.rbts[sample]);
        let nodes = curves.iter().zip(&tracks.nodes).map(of_track);
        let points = tracks.points.iter().map(|points| points.excess(sample, |track| curves[track].at(alpha)));
        let excess = nodes.chain(points).fold(0.0, f32::max);
        if excess > worst.0 {
            worst = (excess, Some(sample));
        }
    }
    // Not near an end, so that each pass at least makes the interval shorter by a quarter.
    let quarter = (to - from) / 4;
    worst.1.map(|sample: usize| sample.clamp(from + quarter.max(1), to - quarter.max(1)))
}

/// The curve of one node in one interval.
struct Curve {
    start: Rbt,
    inner: ControlPoints<Rbt>,
    end: Rbt,
}

impl Curve {
    fn of(tracks: &Tracks<'_>, track: &Track, keys: &[usize], interval: usize) -> Self {
        let at = |place: usize| track.rbts[keys[place]];
        let length = |place: usize| (tracks.seconds[keys[place + 1]] - tracks.seconds[keys[place]]).max(SHORTEST_STEP);
        let (start, end) = (at(interval), at(interval + 1));
        let own = length(interval);
        // Beyond the ends lie the steering keyframes.
        let (before, length_before) = match interval.checked_sub(1) {
            Some(before) => (at(before), length(before)),
            None => (super::beyond_rbt(end, start), own),
        };
        let (after, length_after) = if interval + 2 < keys.len() {
            (at(interval + 2), length(interval + 1))
        } else {
            (super::beyond_rbt(start, end), own)
        };
        let divisors = TangentDivisors::of([length_before, own, length_after]);
        Self { start, inner: rbt_control_points([before, start, end, after], divisors), end }
    }

    fn at(&self, alpha: f32) -> Rbt {
        bezier_rbt(self.start, self.inner, self.end, alpha)
    }
}
