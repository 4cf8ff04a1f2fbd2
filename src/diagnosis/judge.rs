//! How far samples are from what given rules show: the residual, and whether every row agrees.
//!
//! Translations and rotations are judged apart and remembered, so that a pair of mistakes of which one concerns translations and the other
//! rotations costs nothing. Rows at which right playback disagrees come first: what they do not agree with is rejected at once.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::compare::{Comparison, Off};
use super::motion::Threshold;
use super::rules::{Freezes, LINEAR, Moves, Rules, SPLINE, Timing, Turns};
use super::samples::{Row, Samples};
use super::sequence::Sequence;
use crate::parallel::map_in_order;

/// Half the angle of the largest turn that counts as small, in radians: 40 degrees.
const LARGEST_SMALL_TURN: f64 = 0.35;

/// By so many rows the interpolation is chosen to which the samples are nearer.
const COMPARED_FIRST: usize = 500;

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
    /// How many transforms were computed so far.
    computed: AtomicUsize,
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
            computed: AtomicUsize::new(0),
            orders: [Vec::new(), Vec::new()],
            moves: Vec::new(),
            turns: Vec::new(),
            sums_of_moves: Vec::new(),
            sums_of_turns: Vec::new(),
        };
        let leaps = leaps(samples.rows.len());
        let sum = |rules: &Rules| {
            leaps.iter().take(COMPARED_FIRST).map(|index| judge.squared_off(*index, rules)).sum::<f64>()
        };
        let [nearest, other] = if sum(&LINEAR) <= sum(&SPLINE) { [LINEAR, SPLINE] } else { [SPLINE, LINEAR] };
        let offs = judge.offs(&nearest);
        let agrees = |part: usize| offs.iter().all(|off| off[part].agrees);
        let [moves_agree, turns_agree] = [0, 1].map(agrees);
        judge.orders = [0, 1].map(|part| order(&leaps, &offs, part));
        let sums = [0, 1].map(|part| offs.iter().map(|off| off[part].squared).sum::<f64>());
        judge.moves.push(((nearest.timing, nearest.moves), moves_agree));
        judge.sums_of_moves.push(((nearest.timing, nearest.moves), sums[0]));
        let agreement = turns_agree.then_some(Agreement { threshold: None, is_exact: true });
        judge.turns.push(((nearest.timing, nearest.turns), agreement));
        judge.sums_of_turns.push(((nearest.timing, nearest.turns), sums[1]));
        judge.right_agrees = (moves_agree && turns_agree) || judge.agreement(&other).is_some();
        judge.comparison.is_lenient = !judge.right_agrees;
        judge
    }

    fn squared_off(&self, index: usize, rules: &Rules) -> f64 {
        self.off(&self.samples.rows[index], rules).map(|off| off.squared).iter().sum()
    }

    /// How many transforms were computed so far: what the work is.
    pub fn computed(&self) -> usize {
        self.computed.load(Ordering::Relaxed)
    }

    fn counted(&self, off: Off) -> Off {
        self.computed.fetch_add(off.computed, Ordering::Relaxed);
        off
    }

    /// The distances of every row from right playback.
    fn offs(&self, right: &Rules) -> Vec<[Off; 2]> {
        self.samples.rows.iter().map(|row| self.off(row, right)).collect()
    }

    /// The distances of a row: of translation, of rotation.
    fn off(&self, row: &Row, rules: &Rules) -> [Off; 2] {
        let moves = self.comparison.move_off(row, rules.timing, rules.moves);
        [moves, self.comparison.turn_off(row, rules.timing, &rules.turns)].map(|off| self.counted(off))
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
        let sum = self.sum_if_all_agree(0, |row| self.comparison.move_off(row, key.0, key.1));
        self.sums_of_moves.extend(sum.map(|sum| (key, sum)));
        self.moves.push((key, sum.is_some()));
        sum.is_some()
    }

    /// The sum of the squared distances of all rows; `None` if one does not agree. Rows are judged in the order of a part.
    fn sum_if_all_agree(&self, part: usize, off: impl Fn(&Row) -> Off) -> Option<f64> {
        let mut squared = vec![0.0; self.samples.rows.len()];
        for index in &self.orders[part] {
            let off = self.counted(off(&self.samples.rows[*index]));
            if !off.agrees {
                return None;
            }
            squared[*index] = off.squared;
        }
        Some(squared.iter().sum())
    }

    fn turns_agree(&mut self, timing: Timing, turns: &Turns) -> Option<Agreement> {
        if turns.freezes == Freezes::Nowhere {
            let agree =
                |comparison: Comparison| self.sum_if_all_agree(1, |row| comparison.turn_off(row, timing, turns));
            let sum = agree(self.comparison)?;
            let is_lenient = self.comparison.is_lenient && turns.rounding_decides();
            let is_exact = !is_lenient || agree(Comparison { is_lenient: false, ..self.comparison }).is_some();
            self.sums_of_turns.push(((timing, *turns), sum));
            return Some(Agreement { threshold: None, is_exact });
        }
        let mut rows = self.orders[1].iter().map(|index| &self.samples.rows[*index]);
        if self.right_agrees {
            // Any threshold is possible that no turn is below: the usual one tells.
            let agrees = rows.all(|row| self.counted(self.comparison.turn_off(row, timing, turns)).agrees);
            return agrees.then_some(Agreement { threshold: None, is_exact: true });
        }
        // The thresholds with which every row so far agrees, as spans: above the first number, up to the second.
        let mut feasible = vec![(0.0, LARGEST_SMALL_TURN)];
        for row in rows {
            let within = (feasible.first()?.0, feasible.last()?.1);
            let of_row = self.thresholds(row, timing, turns, within);
            let both = |(low, high): (f64, f64)| {
                of_row.iter().map(move |span| (low.max(span.0), high.min(span.1))).filter(|span| span.0 < span.1)
            };
            feasible = feasible.iter().copied().flat_map(both).collect();
        }
        let (low, high) = *feasible.first()?;
        Some(Agreement { threshold: Some(f64::midpoint(low, high)), is_exact: true })
    }

    /// The thresholds above the first number, up to the second, with which a row agrees.
    fn thresholds(&self, row: &Row, timing: Timing, turns: &Turns, within: (f64, f64)) -> Vec<(f64, f64)> {
        let mut spans = Vec::new();
        let (mut low, highest) = within;
        while low < highest {
            // The result is the same for every threshold above `low` and up to the next half angle that is met.
            let mut threshold = Threshold::at(low.next_up());
            let off = self.counted(self.comparison.turn_off_at(row, timing, turns, &mut threshold));
            let high = threshold.next.min(highest).max(low.next_up());
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
        let of_row = |row| {
            let off = self.comparison.turn_off_at(row, timing, &turns, &mut threshold.clone());
            self.counted(off).squared
        };
        self.samples.rows.iter().map(of_row).sum()
    }

    /// The root mean square over the rows of the distance from the rules.
    pub fn residual(&mut self, rules: &Rules, agreement: Option<Agreement>) -> f64 {
        let key = (rules.timing, rules.moves);
        let known = self.sums_of_moves.iter().find(|(known, _)| *known == key).map(|(_, sum)| *sum);
        let moves = known.unwrap_or_else(|| {
            let of_row = |row| self.counted(self.comparison.move_off(row, key.0, key.1)).squared;
            let sum = self.samples.rows.iter().map(of_row).sum();
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

/// So many indices, in leaps over nodes and key times.
fn leaps(count: usize) -> Vec<usize> {
    let is_coprime = |step: &usize| {
        let (mut a, mut b) = (*step, count);
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a == 1
    };
    let golden = (count as f64 * 0.618) as usize;
    let step = (golden.max(1)..).find(is_coprime).unwrap_or(1);
    (0..count).map(|index| index * step % count).collect()
}

/// The rows at which a part of right playback disagrees, then the others, both in leaps.
fn order(leaps: &[usize], offs: &[[Off; 2]], part: usize) -> Vec<usize> {
    let (agreeing, disagreeing): (Vec<_>, Vec<_>) = leaps.iter().partition(|index| offs[**index][part].agrees);
    disagreeing.into_iter().chain(agreeing).collect()
}
