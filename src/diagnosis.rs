//! Diagnosis: which known mistake explains what a student's own program showed.
//!
//! The samples of that program are compared with the right result and with what each known mistake would show, all in double
//! precision and apart from [`crate::interpolation`], so that the two can be held against each other. Pure functions: text and
//! keyframes in, names and residuals out; this module knows nothing of files, of the editor or of the command line.
//!
//! The *residual* of a candidate is the root mean square, over the rows, of the distance of translations (scene units) and of
//! quaternions as printed: for each row the square of the one plus the square of the other, the nearer of q and −q, nothing
//! renormalised. Where the sample or the prediction is no finite number, the distance of that part is 0 if both are so, and
//! [`DISTANCE_OF_NO_NUMBER`] otherwise.

mod advice;
mod model;
mod play;
mod samples;

pub use advice::{Advice, advice};
pub use play::{Sequence, TooFewKeyframes};
pub use samples::{LARGEST_SAMPLES_BYTES, Row, SampleRows, Samples, SamplesError, samples_from_csv};

use model::{MODELS, Model, Rules};

/// Residuals that differ by no more than this explain the samples equally well.
pub const EQUAL_RESIDUALS: f64 = 1e-9;

/// A residual up to this explains the samples: three decimals, as some programs print them, leave about a thousandth.
pub const EXPLAINED_RESIDUAL: f64 = 5e-3;

/// The distance of a number from what is none, in scene units or quaternion components: farther than rotations can be.
pub const DISTANCE_OF_NO_NUMBER: f64 = 10.0;

/// The name of the right result, by lerp and slerp.
pub const CORRECT: &str = "correct";

/// The name of the right result, by Catmull-Rom splines.
pub const CORRECT_CATMULL_ROM: &str = "correct-catmull-rom";

/// The name of playback that ends before its last pose.
pub const LAST_SAMPLE_MISSING: &str = "last-sample-missing";

/// Whether a candidate plays another part of the keyframes than it should: it begins with another one, or leaves out the end.
#[must_use]
pub fn is_about_range(name: &str) -> bool {
    MODELS.iter().any(|model| model.name == name && model.forms.iter().all(Rules::changes_range))
}

/// How well one candidate explains the samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// Its name.
    pub name: &'static str,
    /// Its residual, finite, at least 0.
    pub residual: f64,
}

/// Every candidate, and which of them explains the samples.
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

    /// Those that do not, nearest first.
    #[must_use]
    pub fn runners_up(&self) -> &[Candidate] {
        &self.candidates[self.equals..]
    }

    /// Whether the best one does explain the samples, and is not only the nearest of what does not.
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

/// Compares samples with every candidate. `integer-tick` is one only where the samples carry milliseconds.
///
/// Every row's node must be one of the sequence's, which [`samples_from_csv`] sees to.
#[must_use]
pub fn diagnose(sequence: &Sequence, samples: &Samples) -> Diagnosis {
    let mut rest: Vec<(usize, Candidate)> = MODELS
        .iter()
        .filter(|model| samples.has_ms || !model.needs_ms)
        .map(|model| Candidate { name: model.name, residual: residual(sequence, samples, model) })
        .enumerate()
        .collect();
    let mut candidates: Vec<Candidate> = Vec::with_capacity(rest.len());
    let mut equals = 0;
    // Equals are a group from its least on: in the table's order within, one group after the other.
    while let Some(least) = rest.iter().map(|(_, candidate)| candidate.residual).min_by(f64::total_cmp) {
        let (mut group, others): (Vec<_>, Vec<_>) =
            rest.into_iter().partition(|(_, candidate)| candidate.residual <= least + EQUAL_RESIDUALS);
        rest = others;
        group.sort_by_key(|(place, _)| *place);
        if candidates.is_empty() {
            equals = group.len();
        }
        candidates.extend(group.into_iter().map(|(_, candidate)| candidate));
    }
    let mut diagnosis = Diagnosis { candidates, equals, rows: samples.rows.len() };
    if diagnosis.is_correct()
        && !samples.reaches(sequence.last_key_time())
        && let Some(place) = diagnosis.candidates[..equals].iter().position(|c| c.name == LAST_SAMPLE_MISSING)
    {
        diagnosis.candidates[..=place].rotate_right(1);
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
