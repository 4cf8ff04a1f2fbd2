//! The way of a foot's end: places where it stands, and how it goes from one to the next.

use glam::{DVec2, DVec3, Vec3Swizzles as _};

/// Heights of a foot's end, in parts of the leg's length: below the first it is on the ground, below the second it is low.
const ON_GROUND: f64 = 0.01;
const LOW: f64 = 0.035;
/// A low foot that goes no farther than this, in parts of the leg's length, stands all the time. Another one stands while it is slow,
/// and is lifted where it is not.
const STANDS: f64 = 0.3;
/// The speed of a slow foot, in leg lengths a second.
const SLOW: f64 = 0.3;
/// The time around a sample in which its speed is measured, in seconds.
const AROUND: f64 = 0.04;
/// Shorter stretches, in seconds, are no stances.
const SHORTEST_STANCE: f64 = 0.1;
/// The shortest time in which a foot is lifted, carried and put down, in seconds.
const SHORTEST_STEP: f64 = 0.24;

/// The way of a foot's end.
pub(super) struct FootWay {
    /// For each sample whether the foot stands.
    pub planted: Vec<bool>,
    /// In world space.
    pub ends: Vec<DVec3>,
}

/// A stretch of samples in which a foot stands.
#[derive(Clone, Copy)]
struct Stance {
    from: usize,
    to: usize,
    place: DVec2,
}

impl FootWay {
    /// `natural`: where the end would be, with the ground at 0. `ground`: the height of the ground.
    pub fn of(natural: &[DVec3], seconds: &[f64], ground: f64, leg: f64) -> Self {
        let way = Natural { places: natural, seconds, leg };
        let stances = way.stances();
        let mut planted = vec![false; natural.len()];
        for stance in &stances {
            planted[stance.from..=stance.to].fill(true);
        }
        let ends = (0..natural.len())
            .map(|index| {
                let (place, height) = way.at(&stances, index);
                DVec3::new(place.x, ground + height, place.y)
            })
            .collect();
        Self { planted, ends }
    }
}

/// The largest distance between two places along the ground, at least: the diagonal of their box.
pub(super) fn spread(places: &[DVec3]) -> f64 {
    let along = || places.iter().map(|place| place.xz());
    let low = along().reduce(DVec2::min).unwrap_or_default();
    let high = along().reduce(DVec2::max).unwrap_or_default();
    (high - low).length()
}

/// The stretches in which something is so: first and last index.
pub(super) fn runs(is_so: impl IntoIterator<Item = bool>) -> Vec<(usize, usize)> {
    let mut runs: Vec<(usize, usize)> = Vec::new();
    for (index, _) in is_so.into_iter().enumerate().filter(|(_, is_so)| *is_so) {
        match runs.last_mut() {
            Some((_, last)) if *last + 1 == index => *last = index,
            _ => runs.push((index, index)),
        }
    }
    runs
}

/// From 0 to 1 with no speed at both ends.
fn smooth(part: f64) -> f64 {
    let part = part.clamp(0.0, 1.0);
    part * part * (3.0 - 2.0 * part)
}

/// Where the end would be.
struct Natural<'a> {
    places: &'a [DVec3],
    seconds: &'a [f64],
    leg: f64,
}

impl Natural<'_> {
    fn is_low(&self, index: usize) -> bool {
        self.places[index].y < LOW * self.leg
    }

    fn time(&self, from: usize, to: usize) -> f64 {
        self.seconds[to] - self.seconds[from]
    }

    fn stances(&self) -> Vec<Stance> {
        let mut stances = Vec::new();
        for (from, to) in runs((0..self.places.len()).map(|index| self.is_low(index))) {
            let stretches = if spread(&self.places[from..=to]) <= STANDS * self.leg {
                vec![(from, to)]
            } else {
                self.slow_stretches(from, to)
            };
            let stance = |(from, to)| Stance { from, to, place: self.middle(from, to) };
            stances.extend(stretches.into_iter().map(stance));
        }
        stances
    }

    /// The parts of a low stretch in which the foot is slow, with time for a step between them.
    fn slow_stretches(&self, from: usize, to: usize) -> Vec<(usize, usize)> {
        let is_slow = |index: usize| {
            let at = self.seconds[index];
            let before = self.seconds.partition_point(|&other| other < at - AROUND).max(from);
            let after = (self.seconds.partition_point(|&other| other <= at + AROUND) - 1).min(to);
            let way = self.places[before].xz().distance(self.places[after].xz());
            way <= SLOW * self.leg * self.time(before, after)
        };
        let mut stretches: Vec<(usize, usize)> = runs((from..=to).map(is_slow))
            .into_iter()
            .map(|(first, last)| (from + first, from + last))
            .filter(|&(first, last)| self.time(first, last) >= SHORTEST_STANCE)
            .collect();
        for index in 1..stretches.len() {
            // Both stances give time in turn.
            let (mut left, mut right) = (stretches[index - 1], stretches[index]);
            while self.time(left.1, right.0) < SHORTEST_STEP && (left.1 > left.0 || right.0 < right.1) {
                left.1 -= usize::from(left.1 > left.0);
                right.0 += usize::from(right.0 < right.1);
            }
            (stretches[index - 1], stretches[index]) = (left, right);
        }
        stretches
    }

    /// The place along the ground with as many places on either side, along each axis.
    fn middle(&self, from: usize, to: usize) -> DVec2 {
        let median = |axis: usize| {
            let mut values: Vec<f64> = self.places[from..=to].iter().map(|place| place[axis]).collect();
            values.sort_by(f64::total_cmp);
            values[values.len() / 2]
        };
        DVec2::new(median(0), median(2))
    }

    /// The place along the ground, and the height over it.
    fn at(&self, stances: &[Stance], index: usize) -> (DVec2, f64) {
        let natural = self.places[index];
        let (on_ground, low) = (ON_GROUND * self.leg, LOW * self.leg);
        let next = stances.partition_point(|stance| stance.to < index);
        let after = stances.get(next);
        if let Some(stance) = after.filter(|stance| stance.from <= index) {
            // On the ground while the foot is nearly there.
            let height = ((natural.y - on_ground) / (low - on_ground)).clamp(0.0, 1.0) * low;
            return (stance.place, height);
        }
        let before = next.checked_sub(1).map(|last| &stances[last]);
        let offset = |stance: &Stance, at: usize| stance.place - self.places[at].xz();
        let moved = match (before, after) {
            (Some(before), Some(after)) => {
                let part = self.time(before.to, index) / self.time(before.to, after.from);
                offset(before, before.to).lerp(offset(after, after.from), smooth(part))
            }
            (Some(before), None) => offset(before, before.to),
            (None, Some(after)) => offset(after, after.from),
            (None, None) => DVec2::ZERO,
        };
        let mut place = natural.xz() + moved;
        let mut lift = 1.0;
        // A foot that is dragged is lifted before it moves, and put down after it.
        let step = match (before, after) {
            (Some(before), Some(after)) => self.time(before.to, after.from) / 4.0,
            _ => f64::INFINITY,
        }
        .min(SHORTEST_STEP / 3.0);
        let ends = [
            before.filter(|stance| self.is_low(stance.to + 1)).map(|stance| (stance, self.time(stance.to, index))),
            after.filter(|stance| self.is_low(stance.from - 1)).map(|stance| (stance, self.time(index, stance.from))),
        ];
        for (stance, time) in ends.into_iter().flatten() {
            lift = f64::min(lift, smooth(time / step));
            place = stance.place.lerp(place, smooth(time / step - 1.0));
        }
        // A foot that never stands has no ground over which it could be lifted.
        (place, if stances.is_empty() { natural.y } else { natural.y.max(lift * low) })
    }
}
