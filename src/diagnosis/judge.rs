//! How far samples are from what given rules show: the residual, and whether every row agrees.
//!
//! Translations and rotations are judged apart and remembered, so that a pair of mistakes of which one concerns translations and the other
//! rotations costs nothing. Rows at which right playback disagrees come first: what they do not agree with is rejected at once.

use super::compare::{Comparison, Off};
use super::motion::Threshold;
use super::rules::{Freezes, LINEAR, Moves, Rules, SPLINE, Timing, Turns};
use super::samples::{Row, Samples};
use super::sequence::Sequence;
use crate::parallel::map_in_order;

/// Half the angle of the largest turn that counts as small, in radians: 40 degrees.
const LARGEST_SMALL_TURN: f64 = 0.35;

/// How rules agree with every row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Agreement {
    /// Half the angle in radians below which turns are left out, if any are.
    pub threshold: Option<f64>,
    /// Whether every row agrees without rounding deciding about special cases.
    pub is_exact: bool,
}

/// The samples, with what was found out about them.
pub(super) struct Judge<'a> {
    samples: &'a Samples,
    comparison: Comparison<'a>,
    right_agrees: bool,
    /// The rows in the order in which translations are judged, and rotations.
    orders: [Vec<usize>; 2],
    moves: Vec<((Timing, Moves), bool)>,
    turns: Vec<((Timing, Turns), Option<Agreement>)>,
    sums_of_moves: Vec<((Timing, Moves), f64)>,
    sums_of_turns: Vec<((Timing, Turns), f64)>,
}

impl<'a> Judge<'a> {
    pub fn new(sequence: &'a Sequence, samples: &'a Samples) -> Self {
        let mut judge = Self {
            samples,
            comparison: Comparison::new(sequence, samples),
            right_agrees: true,
            orders: [Vec::new(), Vec::new()],
            moves: Vec::new(),
            turns: Vec::new(),
            sums_of_moves: Vec::new(),
            sums_of_turns: Vec::new(),
        };
        let [linear, spline] = [LINEAR, SPLINE].map(|right| judge.offs(&right));
        let sum = |offs: &[[Off; 2]]| offs.iter().flatten().map(|off| off.squared).sum::<f64>();
        let agrees = |offs: &[[Off; 2]]| offs.iter().flatten().all(|off| off.agrees);
        judge.right_agrees = agrees(&linear) || agrees(&spline);
        judge.comparison.is_lenient = !judge.right_agrees;
        let nearest = if sum(&linear) <= sum(&spline) { &linear } else { &spline };
        judge.orders = [0, 1].map(|part| order(nearest, part));
        judge
    }

    /// The distances of every row from right playback: of translation, of rotation.
    fn offs(&self, right: &Rules) -> Vec<[Off; 2]> {
        let rows = self.samples.rows.iter();
        rows.map(|row| {
            [
                self.comparison.move_off(row, right.timing, right.moves),
                self.comparison.turn_off(row, right.timing, &right.turns),
            ]
        })
        .collect()
    }

    /// Whether every row agrees with the rules, beyond what right playback explains.
    ///
    /// Where right playback explains the samples, a mistake agrees only if it shows the same whatever rounding decides.
    pub fn agreement(&mut self, rules: &Rules) -> Option<Agreement> {
        if !self.moves_agree((rules.timing, rules.moves)) {
            return None;
        }
        let key = (rules.timing, rules.turns);
        if let Some((_, known)) = self.turns.iter().find(|(known, _)| *known == key) {
            return *known;
        }
        let found = self.turns_agree(rules.timing, &rules.turns);
        self.turns.push((key, found));
        found
    }

    fn moves_agree(&mut self, key: (Timing, Moves)) -> bool {
        if let Some((_, known)) = self.moves.iter().find(|(known, _)| *known == key) {
            return *known;
        }
        let mut rows = self.orders[0].iter().map(|index| &self.samples.rows[*index]);
        let found = rows.all(|row| self.comparison.move_off(row, key.0, key.1).agrees);
        self.moves.push((key, found));
        found
    }

    fn turns_agree(&self, timing: Timing, turns: &Turns) -> Option<Agreement> {
        let mut rows = self.orders[1].iter().map(|index| &self.samples.rows[*index]);
        if turns.freezes == Freezes::Nowhere {
            let agree = |comparison: Comparison| rows.clone().all(|row| comparison.turn_off(row, timing, turns).agrees);
            return agree(self.comparison).then(|| {
                let is_lenient = self.comparison.is_lenient && turns.rounding_decides();
                let is_exact = !is_lenient || agree(Comparison { is_lenient: false, ..self.comparison });
                Agreement { threshold: None, is_exact }
            });
        }
        if self.right_agrees {
            // Any threshold is possible that no turn is below: the usual one tells.
            let agrees = rows.all(|row| self.comparison.turn_off(row, timing, turns).agrees);
            return agrees.then_some(Agreement { threshold: None, is_exact: true });
        }
        // The thresholds with which every row so far agrees, as spans: above the first number, up to the second.
        let mut feasible = vec![(0.0, LARGEST_SMALL_TURN)];
        for row in rows {
            let lowest = feasible.first()?.0;
            let of_row = self.thresholds(row, timing, turns, lowest);
            let both = |(low, high): (f64, f64)| {
                of_row.iter().map(move |span| (low.max(span.0), high.min(span.1))).filter(|span| span.0 < span.1)
            };
            feasible = feasible.iter().copied().flat_map(both).collect();
        }
        let (low, high) = *feasible.first()?;
        Some(Agreement { threshold: Some(f64::midpoint(low, high)), is_exact: true })
    }

    /// The thresholds above `lowest` with which a row agrees.
    fn thresholds(&self, row: &Row, timing: Timing, turns: &Turns, lowest: f64) -> Vec<(f64, f64)> {
        let mut spans = Vec::new();
        let mut low = lowest;
        while low < LARGEST_SMALL_TURN {
            // The result is the same for every threshold above `low` and up to the next half angle that is met.
            let mut threshold = Threshold::at(low.next_up());
            let off = self.comparison.turn_off_at(row, timing, turns, &mut threshold);
            let high = threshold.next.min(LARGEST_SMALL_TURN).max(low.next_up());
            if off.agrees {
                spans.push((low, high));
            }
            low = high;
        }
        spans
    }

    /// From now on a special case of exact numbers is met only where it is met exactly. For residuals of what does not explain the samples.
    pub fn be_strict(&mut self) {
        self.comparison.is_lenient = false;
    }

    /// Computes at once, on all cores, what the residuals of these rules need of rotations.
    pub fn prepare(&mut self, all: &[Rules]) {
        let mut keys: Vec<(Timing, Turns)> = Vec::new();
        for key in all.iter().map(|rules| (rules.timing, rules.turns)) {
            if !keys.contains(&key) && self.sums_of_turns.iter().all(|(known, _)| *known != key) {
                keys.push(key);
            }
        }
        let sums = map_in_order(&keys, |key| self.sum_of_turns(*key, None));
        self.sums_of_turns.extend(keys.into_iter().zip(sums));
    }

    /// The sum of the squared distances of rotations.
    fn sum_of_turns(&self, (timing, turns): (Timing, Turns), agreement: Option<Agreement>) -> f64 {
        let threshold = Threshold::known(agreement.and_then(|agreement| agreement.threshold));
        let of_row = |row| self.comparison.turn_off_at(row, timing, &turns, &mut threshold.clone()).squared;
        self.samples.rows.iter().map(of_row).sum()
    }

    /// The root mean square over the rows of the distance from the rules.
    pub fn residual(&mut self, rules: &Rules, agreement: Option<Agreement>) -> f64 {
        let key = (rules.timing, rules.moves);
        let known = self.sums_of_moves.iter().find(|(known, _)| *known == key).map(|(_, sum)| *sum);
        let moves = known.unwrap_or_else(|| {
            let sum = self.samples.rows.iter().map(|row| self.comparison.move_off(row, key.0, key.1).squared).sum();
            self.sums_of_moves.push((key, sum));
            sum
        });
        let key = (rules.timing, rules.turns);
        let known = self.sums_of_turns.iter().find(|(known, _)| *known == key).map(|(_, sum)| *sum);
        let turns = known.unwrap_or_else(|| {
            let sum = self.sum_of_turns(key, agreement);
            self.sums_of_turns.push((key, sum));
            sum
        });
        ((moves + turns) / self.samples.rows.len() as f64).sqrt()
    }
}

/// The rows at which a part of right playback disagrees, then the others, both in leaps over nodes and key times.
fn order(offs: &[[Off; 2]], part: usize) -> Vec<usize> {
    let count = offs.len();
    let is_coprime = |step: &usize| {
        let (mut a, mut b) = (*step, count);
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a == 1
    };
    let golden = (count as f64 * 0.618) as usize;
    let step = (golden.max(1)..).find(is_coprime).unwrap_or(1);
    let leaps: Vec<usize> = (0..count).map(|index| index * step % count).collect();
    let (agreeing, disagreeing): (Vec<_>, Vec<_>) = leaps.into_iter().partition(|index| offs[*index][part].agrees);
    disagreeing.into_iter().chain(agreeing).collect()
}
