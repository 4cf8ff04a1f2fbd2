//! What samples show, judged by what they should show.

use std::collections::BTreeSet;

use super::coverage::Coverage;
use super::judgement::Judgement;
use super::off::{Fault, Off, Printed};
use super::range::Ends;
use super::right::{Right, SAME_TIME};
use super::rubric::Rubric;
use crate::diagnosis::{Row, Samples};
use crate::interpolation::Interpolation;
use crate::pose::RbtIndex;
use crate::scene::SceneGraph;
use crate::text::counted;

/// The fewest decimals with which playback can be judged.
const FEWEST_DECIMALS: usize = 2;

/// The verdict on the samples of one playback.
#[derive(Clone, Debug, PartialEq)]
pub struct ShownPlayback {
    /// Its frames; or why they cannot be judged, a clause.
    pub judgement: Result<Judgement, String>,
    /// Whether there are enough.
    pub coverage: Coverage,
    /// Where they begin and end.
    pub ends: Ends,
    /// Whether they were judged by the submission's own keyframes.
    pub is_own: bool,
}

impl ShownPlayback {
    /// Judges samples as those of an interpolation.
    #[must_use]
    pub fn of(samples: &Samples, right: &Right<'_>, interpolation: Interpolation, rubric: &Rubric) -> Self {
        let nodes = right.list.as_slice()[0].pose.len();
        let asked = rubric.samples_per_interval;
        let judgement = match coarseness(samples, right, rubric) {
            Some(problem) => Err(problem),
            None => Ok(judged(samples, right, interpolation, rubric)),
        };
        Self {
            judgement,
            coverage: Coverage::of(samples, nodes, right.range.last_key_time(), asked),
            ends: Ends::of(samples, right, interpolation, &rubric.credit),
            is_own: right.is_own,
        }
    }

    /// The share of the points for playback.
    #[must_use]
    pub fn share(&self, rubric: &Rubric) -> f64 {
        self.judgement.as_ref().map_or(0.0, |judgement| judgement.share(&rubric.credit) * self.coverage.share)
    }

    /// Whether every frame that is there is within the tolerances.
    #[must_use]
    pub fn is_right(&self) -> bool {
        self.judgement.as_ref().is_ok_and(Judgement::is_right)
    }

    /// Whether it fits better than the same samples do as another interpolation.
    #[must_use]
    pub fn fits_better_than(&self, other: &Self) -> bool {
        match (&self.judgement, &other.judgement) {
            (Ok(one), Ok(other)) => one.fits_better_than(other),
            _ => false,
        }
    }

    /// Sentences for the reason, without the file's name before them.
    #[must_use]
    pub fn reason(&self, scene: &SceneGraph, rubric: &Rubric) -> String {
        let own = if self.is_own { " of its own keyframes' playback" } else { "" };
        let mut reason = match &self.judgement {
            Ok(judgement) => format!("{}{own}.", judgement.clause(scene, &rubric.credit)),
            Err(problem) => format!("{problem}."),
        };
        if let (Ok(_), Some(sentence)) = (&self.judgement, self.coverage.sentence(scene)) {
            reason.push(' ');
            reason.push_str(&sentence);
        }
        reason
    }
}

fn judged(samples: &Samples, right: &Right<'_>, interpolation: Interpolation, rubric: &Rubric) -> Judgement {
    let end = right.end();
    let rounding = samples.printed.rounding();
    let is_within = |row: &&Row| row.key_time <= end + row.key_time_error.max(SAME_TIME);
    // What is shown after the end is an error of the range.
    let mut rows: Vec<&Row> = samples.rows.iter().filter(is_within).collect();
    rows.sort_by(|a, b| a.key_time.total_cmp(&b.key_time));
    // Where no number of samples is asked, a node may still not be left out.
    let missing: Vec<RbtIndex> = if rubric.samples_per_interval == 0 { never_shown(&rows, right) } else { Vec::new() };
    let mut judgement = Judgement::default();
    let mut frame = None;
    for row in rows {
        let (key_time, credit) = (row.key_time, &rubric.credit);
        if frame != Some(key_time) {
            frame = Some(key_time);
            for node in &missing {
                judgement.take(key_time, *node, Off::faulty(Fault::Missing), credit);
            }
        }
        judgement.take(
            key_time,
            row.node,
            right.off(Printed { row, rounding: &rounding }, interpolation, credit),
            credit,
        );
    }
    judgement.closed()
}

fn never_shown(rows: &[&Row], right: &Right<'_>) -> Vec<RbtIndex> {
    let shown: BTreeSet<usize> = rows.iter().map(|row| row.node.get()).collect();
    let nodes = right.list.as_slice()[0].pose.len();
    (0..nodes).filter(|node| !shown.contains(node)).map(RbtIndex::new).collect()
}

/// Why the numbers are too coarse to judge what moves, if they are: a clause.
fn coarseness(samples: &Samples, right: &Right<'_>, rubric: &Rubric) -> Option<String> {
    let most = |decimals: &[usize]| decimals.iter().copied().max().unwrap_or(0);
    let [moves, turns] = right.moves(rubric.tolerances);
    let printed = samples.printed;
    let groups = [("translations", moves, most(&printed.translation)), ("rotations", turns, most(&printed.rotation))];
    let coarse = groups.into_iter().find(|(_, changes, decimals)| *changes && *decimals < FEWEST_DECIMALS);
    if let Some((what, _, decimals)) = coarse {
        return Some(format!(
            "{what} are printed with {}, and at least {FEWEST_DECIMALS} are needed to judge playback",
            counted(decimals, "decimal")
        ));
    }
    let coarsest = samples.rows.iter().map(|row| row.key_time_error).fold(0.0, f64::max);
    (coarsest > 0.5 * 0.1_f64.powi(FEWEST_DECIMALS as i32) * 1.01).then(|| {
        format!(
            "key times are printed with fewer than {FEWEST_DECIMALS} decimals, so that it is not known what they show"
        )
    })
}
