//! Few keyframes that play as a dense animation does: samples in, an [`Animation`] out.
//!
//! The keyframes are some of the samples. Linear interpolation takes the longest steps that stay within the tolerance at every sample
//! between. Catmull-Rom splines depend on the keyframes around, so there keyframes are added where the curve is off.

mod samples;
mod spline;
#[cfg(test)]
mod tests;
mod watched;

use glam::Vec3;

use crate::interpolation::{Interpolation, conditionally_negated, linear_rbt};
use crate::keyframe::{Animation, Keyframe, KeyframeIndex, KeyframeList, MS_BETWEEN_KEYFRAMES_RANGE, PlayRange};
use crate::pose::{Pose, RbtIndex};
use crate::rbt::{LARGEST_COORDINATE, Rbt};
use crate::words::{Message, texts};

use watched::Points;

pub use samples::{LONGEST_SECONDS, Samples, TooLong};
pub use watched::Watched;

/// How far a node may be from a sample, in its parent's space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// The angle between the rotations, in degrees.
    pub degrees: f64,
    /// The distance between the translations, in scene units.
    pub units: f64,
}

impl Tolerance {
    /// The usual one for a model of a size in scene units: 0.5 degree, and a thousandth of the size.
    #[must_use]
    pub fn for_size(size: f64) -> Self {
        Self { degrees: 0.5, units: 1e-3 * size }
    }

    /// The larger of each.
    fn max(self, other: Self) -> Self {
        Self { degrees: self.degrees.max(other.degrees), units: self.units.max(other.units) }
    }

    /// How far two transforms are apart.
    pub(super) fn between(a: Rbt, b: Rbt) -> Self {
        let (qa, qb) = (a.rotation.as_dquat(), b.rotation.as_dquat());
        let chord = (qa - qb).length().min((qa + qb).length());
        let radians = 4.0 * (chord / 2.0).min(1.0).asin();
        let units = a.translation.as_dvec3().distance(b.translation.as_dvec3());
        Self { degrees: radians.to_degrees(), units }
    }
}

/// Which keyframes are made of samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Choice {
    /// As few as stay within a tolerance at every sample.
    Within(Tolerance),
    /// So many a second, and the last sample; above 0.
    Every(f64),
}

/// An animation made of samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Reduced {
    /// The keyframes, with a steering one at each end.
    pub animation: Animation,
    /// How far it is from the samples, at worst.
    pub worst: Tolerance,
    /// How many samples there were.
    pub samples: usize,
    /// From the first sample to the last, in seconds.
    pub seconds: f64,
}

impl Reduced {
    /// What was made of what, and how exact it is, as a sentence.
    #[must_use]
    pub fn message(&self) -> Message {
        texts::reduced_keyframes(
            texts::count_keyframes(self.animation.keyframes.len()),
            texts::count_samples(self.samples),
            format!("{:.3}", self.seconds),
            self.animation.interpolation.name(),
            format!("{:.3}", self.worst.degrees),
            format!("{:.5}", self.worst.units),
        )
    }
}

/// The shortest step between keyframes, in seconds: [`DURATION_RANGE`](crate::keyframe::DURATION_RANGE) allows it at [`SHORT_MS`].
const SHORTEST_STEP: f64 = 1e-4;
/// The longest one.
const LONGEST_STEP: f64 = 100.0;
/// The milliseconds between keyframes: durations are then seconds.
const USUAL_MS: u32 = 1000;
/// The milliseconds between keyframes where some step is shorter than a millisecond.
const SHORT_MS: u32 = 100;

/// Keyframes that play as the samples do.
#[must_use]
pub fn reduced(samples: &Samples, choice: Choice, interpolation: Interpolation) -> Reduced {
    reduced_watching(samples, choice, interpolation, &[])
}

/// The same, where points of nodes have to stay near their places in the world too. [`Choice::Every`] does not look at them.
#[must_use]
pub fn reduced_watching(
    samples: &Samples,
    choice: Choice,
    interpolation: Interpolation,
    watched: &[Watched],
) -> Reduced {
    let even;
    let (source, keys) = match choice {
        Choice::Every(fps) => {
            even = samples.every(fps);
            (&even, (0..even.len()).collect())
        }
        Choice::Within(tolerance) => {
            let tracks = Tracks::of(samples, tolerance, watched);
            let keys = match interpolation {
                Interpolation::Linear => tracks.longest_steps(),
                Interpolation::CatmullRom => spline::keys(&tracks),
            };
            (samples, keys)
        }
    };
    let animation = animation(source, &keys, interpolation);
    let worst = worst(samples, &animation);
    Reduced { animation, worst, samples: samples.len(), seconds: samples.duration() }
}

/// The samples of one node that moves.
struct Track {
    rbts: Vec<Rbt>,
}

/// The samples of all nodes that move.
struct Tracks<'a> {
    seconds: &'a [f64],
    nodes: Vec<Track>,
    points: Vec<Points<'a>>,
    /// The square of the largest distance of two quaternions.
    chord_squared: f32,
    /// The square of the largest distance of two translations.
    units_squared: f32,
}

impl<'a> Tracks<'a> {
    fn of(samples: &'a Samples, tolerance: Tolerance, watched: &'a [Watched]) -> Self {
        let poses = samples.poses();
        let track = |rbt| Track { rbts: poses.iter().map(|pose| pose.get(rbt)).collect() };
        let moves = |track: &Track| track.rbts.iter().any(|rbt| *rbt != track.rbts[0]);
        let mut place = vec![None; poses[0].len()];
        let mut tracks = Vec::new();
        for (node, place) in place.iter_mut().enumerate() {
            let track = track(RbtIndex::new(node));
            if moves(&track) {
                *place = Some(tracks.len());
                tracks.push(track);
            }
        }
        #[expect(clippy::cast_possible_truncation, reason = "poses are f32")]
        let chord = (2.0 * (tolerance.degrees.to_radians() / 4.0).sin()) as f32;
        #[expect(clippy::cast_possible_truncation, reason = "poses are f32")]
        let units = tolerance.units as f32;
        let points = watched.iter().map(|watched| Points::of(watched, samples, &place)).collect();
        let (chord_squared, units_squared) = (chord * chord, units * units);
        Self { seconds: samples.seconds(), nodes: tracks, points, chord_squared, units_squared }
    }

    /// Whether two transforms are within the tolerance.
    fn is_near(&self, a: Rbt, b: Rbt) -> bool {
        self.excess(a, b) <= 1.0
    }

    /// How far two transforms are apart, in parts of the tolerance: above 1 beyond it. The number is a square.
    fn excess(&self, a: Rbt, b: Rbt) -> f32 {
        let chord = (a.rotation - b.rotation).length_squared().min((a.rotation + b.rotation).length_squared());
        let units = a.translation.distance_squared(b.translation);
        let part = |square: f32, most: f32| if square == 0.0 { 0.0 } else { square / most };
        part(chord, self.chord_squared).max(part(units, self.units_squared))
    }

    /// The fraction of a step at which a sample lies.
    fn alpha(&self, from: usize, to: usize, sample: usize) -> f32 {
        let [start, end, at] = [from, to, sample].map(|index| self.seconds[index]);
        #[expect(clippy::cast_possible_truncation, reason = "the interpolation takes f32")]
        let alpha = ((at - start) / (end - start)) as f32;
        alpha
    }

    /// Whether one step, linearly interpolated, is near all samples within it. `first` is the track that is tried first: where a longer
    /// step failed, this one does too as a rule.
    fn is_straight(&self, from: usize, to: usize, first: &mut usize) -> bool {
        let is_near = |track: &Track| {
            let (start, end) = (track.rbts[from], track.rbts[to]);
            (from + 1..to).all(|sample| {
                let played = linear_rbt(start, end, self.alpha(from, to, sample));
                self.is_near(played, track.rbts[sample])
            })
        };
        let order = (*first..self.nodes.len()).chain(0..(*first).min(self.nodes.len()));
        let off = order.into_iter().find(|&track| !is_near(&self.nodes[track]));
        *first = off.unwrap_or(*first);
        let played = |sample| {
            move |track: usize| {
                let rbts = &self.nodes[track].rbts;
                linear_rbt(rbts[from], rbts[to], self.alpha(from, to, sample))
            }
        };
        let is_there = |points: &Points<'_>| (from + 1..to).all(|sample| points.excess(sample, played(sample)) <= 1.0);
        off.is_none() && self.points.iter().all(is_there)
    }

    /// The samples that become keyframes: from each the longest step that is found by doubling and halving.
    fn longest_steps(&self) -> Vec<usize> {
        let last = self.seconds.len() - 1;
        let mut keys = vec![0];
        let mut first = 0;
        let mut from = 0;
        while from < last {
            let longest = self.seconds.partition_point(|&seconds| seconds <= self.seconds[from] + LONGEST_STEP) - 1;
            // The step to `good` is near all samples, the step to `bad` is not.
            let mut good = from + 1;
            let mut step = 2;
            let mut bad = loop {
                let to = (from + step).min(longest);
                if to <= good {
                    break good + 1;
                }
                if !self.is_straight(from, to, &mut first) {
                    break to;
                }
                good = to;
                step *= 2;
            };
            while bad - good > 1 {
                let middle = usize::midpoint(good, bad);
                if self.is_straight(from, middle, &mut first) {
                    good = middle;
                } else {
                    bad = middle;
                }
            }
            keys.push(good);
            from = good;
        }
        keys
    }
}

/// An animation of some of the samples, with steering keyframes that go on as the ends do.
fn animation(samples: &Samples, keys: &[usize], interpolation: Interpolation) -> Animation {
    let (seconds, poses) = (samples.seconds(), samples.poses());
    // Rounded, so that files have short numbers, and before the differences, so that the rounding does not add up.
    let rounded = |number: f64| (number * 1e9).round() / 1e9;
    let mut steps: Vec<f64> =
        keys.windows(2).map(|pair| rounded(rounded(seconds[pair[1]]) - rounded(seconds[pair[0]]))).collect();
    let mut poses: Vec<Pose> = keys.iter().map(|&key| poses[key].clone()).collect();
    if poses.len() == 1 {
        // One sample is a pose that is held.
        poses.push(poses[0].clone());
        steps.push(f64::from(USUAL_MS) / 1000.0);
    }
    let last = poses.len() - 1;
    let before = beyond(&poses[1], &poses[0]);
    let after = beyond(&poses[last - 1], &poses[last]);
    let (ms_between_keyframes, unit) = pace(&steps);
    let duration = |step: f64| rounded(step / unit);
    let (first_step, last_step) = (duration(steps[0]), duration(steps[last - 1]));
    let durations = steps.iter().map(|&step| duration(step)).chain([last_step, 1.0]);
    let keyframe = |pose, duration| Keyframe { duration, ..Keyframe::new(pose) };
    let mut keyframes = vec![keyframe(before, first_step)];
    keyframes.extend(poses.into_iter().chain([after]).zip(durations).map(|(pose, duration)| keyframe(pose, duration)));
    Animation { keyframes: KeyframeList::new(keyframes), interpolation, ms_between_keyframes }
}

/// The milliseconds between keyframes for steps in seconds, and the seconds of one unit of a duration. Equal steps of whole
/// milliseconds need no durations.
fn pace(steps: &[f64]) -> (u32, f64) {
    let ms = steps[0] * 1000.0;
    let is_even = steps.iter().all(|&step| step == steps[0]) && (ms - ms.round()).abs() < 1e-6;
    let (shortest, longest) = (*MS_BETWEEN_KEYFRAMES_RANGE.start(), *MS_BETWEEN_KEYFRAMES_RANGE.end());
    if is_even && (f64::from(shortest)..=f64::from(longest)).contains(&ms.round()) {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it lies in the range")]
        let even = ms.round() as u32;
        return (even, steps[0]);
    }
    let is_short = steps.iter().any(|&step| step < 1e-3);
    let ms = if is_short { SHORT_MS } else { USUAL_MS };
    (ms, f64::from(ms) / 1000.0)
}

/// The pose that follows `to` after a step like that from `from`.
pub(super) fn beyond(from: &Pose, to: &Pose) -> Pose {
    Pose::new(from.iter().zip(to.iter()).map(|(from, to)| beyond_rbt(from, to)).collect())
}

/// The same of one node. A rotation by more than a quarter turn stays: twice that turn would go the other way.
fn beyond_rbt(from: Rbt, to: Rbt) -> Rbt {
    let most = Vec3::splat(LARGEST_COORDINATE);
    let translation = (2.0 * to.translation - from.translation).clamp(-most, most);
    let turn = conditionally_negated(to.rotation * from.rotation.conjugate());
    let is_small = turn.w > std::f32::consts::FRAC_1_SQRT_2;
    let rotation = if is_small { (turn * to.rotation).normalize() } else { to.rotation };
    Rbt::new(translation, rotation)
}

/// How far an animation is from samples as the program plays it, at worst.
fn worst(samples: &Samples, animation: &Animation) -> Tolerance {
    let nothing = Tolerance { degrees: 0.0, units: 0.0 };
    let Ok(range) = PlayRange::new(&animation.keyframes) else { return nothing };
    let keyframes = animation.keyframes.as_slice();
    let unit = f64::from(animation.ms_between_keyframes) / 1000.0;
    let (mut interval, mut start) = (1, 0.0);
    let mut worst = nothing;
    for (&seconds, pose) in samples.seconds().iter().zip(samples.poses()) {
        let mut length = keyframes[interval].duration * unit;
        // The last interval holds its end.
        while seconds > start + length && interval + 3 < keyframes.len() {
            start += length;
            interval += 1;
            length = keyframes[interval].duration * unit;
        }
        #[expect(clippy::cast_possible_truncation, reason = "the interpolation takes f32")]
        let alpha = ((seconds - start) / length).min(1.0) as f32;
        for (node, sample) in pose.iter().enumerate() {
            let played =
                range.rbt_at(KeyframeIndex::new(interval), alpha, animation.interpolation, RbtIndex::new(node));
            worst = worst.max(Tolerance::between(played, sample));
        }
    }
    worst
}
