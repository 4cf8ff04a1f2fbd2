//! How far one row is from what given rules show at its key time.
//!
//! If correct programs may differ, or rounding decides, the value nearest to the sample is used: at half a turn either direction; at a
//! whole key time the end of one interval, the start of the next or the keyframe itself (a mistake can make them differ).

use glam::{DQuat, DVec3};

use super::DISTANCE_OF_NO_NUMBER;
use super::choices::Choices;
use super::motion::{Threshold, Turning, translation};
use super::rules::{Freezes, LINEAR, Moves, Rules, SPLINE, Timing, Turns};
use super::samples::{Row, Samples, Tolerances};
use super::sequence::{Moment, Sequence};
use crate::interpolation::Interpolation;
use crate::pose::RbtIndex;

/// Upper bound of a squared distance, so that residuals are finite.
const LARGEST_SQUARE: f64 = 1e60;

/// How far a row is from what is shown.
#[derive(Clone, Copy, Debug)]
pub(super) struct Off {
    /// The squared distance, at most [`LARGEST_SQUARE`].
    pub squared: f64,
    /// Whether it is within the tolerances.
    pub agrees: bool,
    /// How many transforms were computed to find out.
    pub computed: usize,
}

impl Off {
    const FAR: Self = Self { squared: LARGEST_SQUARE, agrees: false, computed: 0 };

    /// The nearer of two.
    fn or(self, other: Self) -> Self {
        Self {
            squared: self.squared.min(other.squared),
            agrees: self.agrees || other.agrees,
            computed: self.computed + other.computed,
        }
    }
}

/// What rows are compared with.
#[derive(Clone, Copy)]
pub(super) struct Comparison<'a> {
    /// The keyframes.
    pub sequence: &'a Sequence,
    /// How far a row may be off.
    pub tolerances: Tolerances,
    /// The last key time at which a program is shown that does not show its end.
    pub last_before_end: f64,
    /// Whether rounding decides in more than half turns.
    pub is_lenient: bool,
}

impl<'a> Comparison<'a> {
    /// A comparison with samples.
    pub fn new(sequence: &'a Sequence, samples: &Samples) -> Self {
        let last_before_end = samples.last_before(sequence.last_key_time());
        Self { sequence, tolerances: samples.printed.tolerances(), last_before_end, is_lenient: false }
    }

    /// The distance of a row's translation.
    pub fn move_off(&self, row: &Row, timing: Timing, moves: Moves) -> Off {
        let moments = self.sequence.moments(&timing, row.key_time, self.last_before_end, moves.spline.is_some());
        let off = |moment| match moment {
            Moment::Keyframe(index) => {
                self.move_off_from(row, self.sequence.at(index, row.node).translation, DVec3::ZERO)
            }
            Moment::Between { start, alpha } => {
                let corners = [-1, 0, 1, 2].map(|offset| self.sequence.at(start + offset, row.node).translation);
                let shown = translation(corners, alpha, &moves);
                let near = |alpha| (translation(corners, alpha, &moves) - shown).abs();
                let error = row.searched();
                let spread = if error > 0.0 { near(alpha - error).max(near(alpha + error)) } else { DVec3::ZERO };
                self.move_off_from(row, shown, spread)
            }
        };
        moments.map(off).reduce(Off::or).unwrap_or(Off::FAR)
    }

    /// The distance of a row's translation from what is shown, which may be `spread` away in each component.
    fn move_off_from(&self, row: &Row, shown: DVec3, spread: DVec3) -> Off {
        match (row.translation.is_finite(), shown.is_finite()) {
            (true, true) => Off {
                squared: row.translation.distance_squared(shown).min(LARGEST_SQUARE),
                agrees: (row.translation - shown).abs().cmple(DVec3::from(self.tolerances.translation) + spread).all(),
                computed: 1,
            },
            (is_number, is_shown) => no_number(is_number == is_shown),
        }
    }

    /// The distance of a row's rotation. If turns are left out, it is below the usual threshold.
    pub fn turn_off(&self, row: &Row, timing: Timing, turns: &Turns) -> Off {
        self.turn_off_at(row, timing, turns, &mut Threshold::known(None))
    }

    /// The distance of a row's rotation, where turns below a threshold may be left out.
    pub fn turn_off_at(&self, row: &Row, timing: Timing, turns: &Turns, threshold: &mut Threshold) -> Off {
        let moments = self.sequence.moments(&timing, row.key_time, self.last_before_end, turns.spline.is_some());
        let mut nearest = Off::FAR;
        for moment in moments {
            match moment {
                Moment::Keyframe(index) => {
                    let rotation = read(self.sequence.at(index, row.node).rotation, turns);
                    nearest = nearest.or(self.turn_off_from(row, rotation, turns, None));
                }
                Moment::Between { start, alpha } => {
                    let corners =
                        [-1, 0, 1, 2].map(|offset| read(self.sequence.at(start + offset, row.node).rotation, turns));
                    let mut turning = Turning {
                        rules: turns,
                        is_lenient: self.is_lenient && turns.rounding_decides(),
                        choices: Choices::default(),
                        threshold: *threshold,
                    };
                    loop {
                        let shown = turning.rotation(corners, alpha);
                        nearest = nearest.or(self.turn_off_from(row, shown, turns, None));
                        let searched = row.searched();
                        if !nearest.agrees && searched > 0.0 {
                            let near = [-searched, searched].map(|error| {
                                let mut turning = Turning { choices: Choices::default(), ..turning };
                                turning.rotation(corners, alpha + error)
                            });
                            nearest = nearest.or(self.turn_off_from(row, shown, turns, Some(near)));
                        }
                        if (nearest.agrees && turns.freezes == Freezes::Nowhere) || !turning.choices.next() {
                            break;
                        }
                    }
                    threshold.next = threshold.next.min(turning.threshold.next);
                }
            }
        }
        nearest
    }

    /// The distance of a row's rotation from what is shown. Of q and −q the nearer counts: programs may print either.
    fn turn_off_from(&self, row: &Row, shown: DQuat, turns: &Turns, near: Option<[DQuat; 2]>) -> Off {
        let printed = reordered(shown, turns.printed);
        let near = near.map(|near| near.map(|near| reordered(near, turns.printed)));
        let is_number = |rotation: &[f64; 4]| rotation.iter().all(|component| component.is_finite());
        match (is_number(&row.rotation_wxyz), is_number(&printed)) {
            (true, true) => {
                let from = |sign: f64| {
                    let mut off = Off { squared: 0.0, agrees: true, computed: 0 };
                    for (component, tolerance) in self.tolerances.rotation.into_iter().enumerate() {
                        let far = row.rotation_wxyz[component] - sign * printed[component];
                        let spread = near.map_or(0.0, |near| {
                            let [before, after] = near.map(|near| (near[component] - printed[component]).abs());
                            before.max(after)
                        });
                        off.squared += far * far;
                        off.agrees &= far.abs() <= tolerance + spread;
                    }
                    off.squared = off.squared.min(LARGEST_SQUARE);
                    off
                };
                Off { computed: 1, ..from(1.0).or(from(-1.0)) }
            }
            (is_number, is_shown) => no_number(is_number == is_shown),
        }
    }

    /// What rules show of a node, as samples would.
    pub fn row(&self, rules: &Rules, threshold: Option<f64>, key_time: f64, node: RbtIndex) -> Option<Row> {
        let is_spline = rules.moves.spline.is_some();
        let moment = self.sequence.moments(&rules.timing, key_time, self.last_before_end, is_spline).next()?;
        let (translation, rotation) = match moment {
            Moment::Keyframe(index) => {
                let at = self.sequence.at(index, node);
                (at.translation, read(at.rotation, &rules.turns))
            }
            Moment::Between { start, alpha } => {
                let corners = [-1, 0, 1, 2].map(|offset| self.sequence.at(start + offset, node));
                let mut turning = Turning {
                    rules: &rules.turns,
                    is_lenient: false,
                    choices: Choices::default(),
                    threshold: Threshold::known(threshold),
                };
                let rotations = corners.map(|corner| read(corner.rotation, &rules.turns));
                let translations = corners.map(|corner| corner.translation);
                (translation(translations, alpha, &rules.moves), turning.rotation(rotations, alpha))
            }
        };
        let rotation_wxyz = reordered(rotation, rules.turns.printed);
        Some(Row { key_time, key_time_error: 0.0, node, translation, rotation_wxyz })
    }

    /// Whether two rules show different things within some interval, beyond the tolerances. Below `threshold` the first leave turns out.
    pub fn differ(&self, one: &Rules, threshold: Option<f64>, other: &Rules) -> bool {
        /// Moments in an interval.
        const MOMENTS: usize = 8;
        let moments = self.sequence.last_key_time() as usize * MOMENTS;
        let mut places = (0..moments).flat_map(|moment| (0..self.sequence.nodes()).map(move |node| (moment, node)));
        places.any(|(moment, node)| {
            let key_time = (moment as f64 + 0.5) / MOMENTS as f64;
            let row = self.row(one, threshold, key_time, RbtIndex::new(node));
            row.is_some_and(|row| {
                let turns = self.turn_off(&row, other.timing, &other.turns);
                !turns.agrees || !self.move_off(&row, other.timing, other.moves).agrees
            })
        })
    }
}

/// What rules show of every node at key times.
pub(super) fn rows(sequence: &Sequence, rules: &Rules, key_times: impl Iterator<Item = f64> + Clone) -> Vec<Row> {
    let end = sequence.last_key_time();
    let last_before_end = key_times.clone().filter(|key_time| *key_time < end).fold(0.0, f64::max);
    let exact = Tolerances { translation: [0.0; 3], rotation: [0.0; 4] };
    let comparison = Comparison { sequence, tolerances: exact, last_before_end, is_lenient: false };
    let nodes = |key_time| (0..sequence.nodes()).map(move |node| (key_time, RbtIndex::new(node)));
    let places = key_times.flat_map(nodes);
    places.filter_map(|(key_time, node)| comparison.row(rules, None, key_time, node)).collect()
}

/// Every rotation that right playback may show of a node at the fraction `alpha` of the interval that begins at keyframe `start` of the
/// list: a half turn may go either way. Intervals count as equally long.
#[must_use]
pub fn right_rotations(
    sequence: &Sequence,
    (start, alpha): (usize, f64),
    node: RbtIndex,
    interpolation: Interpolation,
) -> Vec<DQuat> {
    let rules = match interpolation {
        Interpolation::Linear => LINEAR,
        Interpolation::CatmullRom => SPLINE,
    };
    let corners = [-1, 0, 1, 2].map(|offset| sequence.at(start as isize + offset, node).rotation);
    let threshold = Threshold::known(None);
    let mut turning = Turning { rules: &rules.turns, is_lenient: false, choices: Choices::default(), threshold };
    let mut found = Vec::new();
    loop {
        found.push(turning.rotation(corners, alpha));
        if !turning.choices.next() {
            return found;
        }
    }
}

fn no_number(agrees: bool) -> Off {
    Off { squared: if agrees { 0.0 } else { DISTANCE_OF_NO_NUMBER.powi(2) }, agrees, computed: 1 }
}

/// A rotation of the keyframe file as a program reads it.
fn read(rotation: DQuat, turns: &Turns) -> DQuat {
    let [w, x, y, z] = reordered(rotation, turns.read);
    DQuat::from_xyzw(x, y, z, w)
}

/// Reorders components: entry i is component `order[i]` of w, x, y, z.
fn reordered(rotation: DQuat, order: [usize; 4]) -> [f64; 4] {
    let [x, y, z, w] = rotation.to_array();
    order.map(|component| [w, x, y, z][component])
}
