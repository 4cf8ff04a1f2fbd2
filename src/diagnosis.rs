//! Diagnosis: which known mistake explains what a student's own program showed.
//!
//! The samples of that program are compared with the right result and with the result of each known mistake. Everything is computed
//! in double precision and without [`crate::interpolation`], so that each can be tested against the other. Pure functions: text and
//! keyframes in, names and residuals out. This module does not know files, the editor or the command line.
//!
//! The *residual* of a candidate is a root mean square over the rows. A row contributes the squared distance of translations (scene
//! units) plus the squared distance of quaternions as printed: not renormalised, the nearer of q and −q. If the sample or the
//! prediction is not finite, that part's distance is 0 if both are not finite, otherwise [`DISTANCE_OF_NO_NUMBER`].

mod model;
mod play;
mod samples;

pub use model::Advice;
pub use play::{Sequence, TooFewKeyframes};
pub use samples::{LARGEST_SAMPLES_BYTES, Row, SampleRows, Samples, SamplesError, samples_from_csv};

use model::{MODELS, Model};

/// Residuals that differ by no more than this explain the samples equally well.
pub const EQUAL_RESIDUALS: f64 = 1e-9;

/// A residual up to this explains the samples: three decimals, as some programs print them, leave about a thousandth.
pub const EXPLAINED_RESIDUAL: f64 = 5e-3;

/// The distance between a number and NaN, in scene units or quaternion components. Larger than any distance of two rotations.
pub const DISTANCE_OF_NO_NUMBER: f64 = 10.0;

/// The name of the right result, by lerp and slerp.
pub const CORRECT: &str = "correct";

/// The name of the right result, by Catmull-Rom splines.
pub const CORRECT_CATMULL_ROM: &str = "correct-catmull-rom";

/// The name of playback that never shows its last pose.
pub const LAST_SAMPLE_MISSING: &str = "last-sample-missing";

/// The names of all candidates in the table's order: the two right results, then the mistakes.
pub fn names() -> impl Iterator<Item = &'static str> {
    MODELS.iter().map(|model| model.name)
}

/// How well one candidate explains the samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// The name in kebab-case, such as `lerp-for-slerp`.
    pub name: &'static str,
    /// The residual, finite, at least 0.
    pub residual: f64,
    model: &'static Model,
}

impl Candidate {
    /// The explanation for people.
    #[must_use]
    pub const fn advice(&self) -> Advice {
        self.model.advice
    }

    /// Whether it plays another range of keyframes than it should: it begins at another keyframe, or leaves out the end.
    #[must_use]
    pub fn is_about_range(&self) -> bool {
        self.model.is_about_range()
    }
}

/// Every candidate with its residual, best first.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnosis {
    /// Best first; never empty.
    pub candidates: Vec<Candidate>,
    /// How many of them explain the samples equally well, at least 1.
    pub equals: usize,
    /// How many rows there were.
    pub rows: usize,
}

impl Diagnosis {
    /// The candidate that explains the samples best.
    #[must_use]
    pub fn best(&self) -> Candidate {
        self.candidates[0]
    }

    /// The others that explain them as well, to within [`EQUAL_RESIDUALS`].
    #[must_use]
    pub fn also(&self) -> &[Candidate] {
        &self.candidates[1..self.equals]
    }

    /// The candidates that explain the samples less well, best first.
    #[must_use]
    pub fn runners_up(&self) -> &[Candidate] {
        &self.candidates[self.equals..]
    }

    /// Whether the best candidate explains the samples: its residual is at most [`EXPLAINED_RESIDUAL`].
    #[must_use]
    pub fn is_explained(&self) -> bool {
        self.best().residual <= EXPLAINED_RESIDUAL
    }

    /// Whether the samples show the right result, in one interpolation or the other.
    #[must_use]
    pub fn is_correct(&self) -> bool {
        self.is_explained() && [CORRECT, CORRECT_CATMULL_ROM].contains(&self.best().name)
    }
}

/// Compares samples with every candidate. `integer-tick` takes part only if the samples have milliseconds.
///
/// Every row's node must exist in the sequence; [`samples_from_csv`] checks that.
#[must_use]
pub fn diagnose(sequence: &Sequence, samples: &Samples) -> Diagnosis {
    let mut rest: Vec<(usize, Candidate)> = MODELS
        .iter()
        .filter(|model| samples.has_ms || !model.needs_ms)
        .map(|model| Candidate { name: model.name, residual: residual(sequence, samples, model), model })
        .enumerate()
        .collect();
    let mut candidates: Vec<Candidate> = Vec::with_capacity(rest.len());
    let mut equals = 0;
    // Candidates within EQUAL_RESIDUALS of the smallest residual form a group. Groups come by residual, candidates of a group in the
    // table's order.
    while let Some(least) = rest.iter().map(|(_, candidate)| candidate.residual).min_by(f64::total_cmp) {
        let (mut group, others): (Vec<_>, Vec<_>) =
            rest.into_iter().partition(|(_, candidate)| candidate.residual <= least + EQUAL_RESIDUALS);
        rest = others;
        group.sort_by_key(|(index, _)| *index);
        if candidates.is_empty() {
            equals = group.len();
        }
        candidates.extend(group.into_iter().map(|(_, candidate)| candidate));
    }
    let mut diagnosis = Diagnosis { candidates, equals, rows: samples.rows.len() };
    if diagnosis.is_correct()
        && !samples.reaches(sequence.last_key_time())
        && let Some(index) = diagnosis.candidates[..equals].iter().position(|c| c.name == LAST_SAMPLE_MISSING)
    {
        diagnosis.candidates[..=index].rotate_right(1);
    }
    diagnosis
}

/// The residual of a model: that of the best of its forms.
fn residual(sequence: &Sequence, samples: &Samples, model: &Model) -> f64 {
    let forms = model.forms.iter().filter(|form| samples.has_no_number || !form.is_lenient());
    let last_before_end = samples.last_before(sequence.last_key_time());
    let squares = |form| -> f64 {
        samples.rows.iter().map(|row| play::distance_squared(sequence, last_before_end, row, form)).sum()
    };
    let least = forms.map(squares).min_by(f64::total_cmp).expect("every model has a strict form");
    (least / samples.rows.len() as f64).sqrt()
}
