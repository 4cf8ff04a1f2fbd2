//! What was found in a file of samples, as results say it: without the samples themselves, so that it can be kept.

use super::samples::SampleDiagnosis;
use super::shown::ShownPoses;
use crate::diagnosis::{Candidate, Diagnosis, Mistake};
use crate::interpolation::Interpolation;

/// What a file of samples shows.
#[derive(Clone, Debug, PartialEq)]
pub struct SampleFinding {
    /// The file.
    pub file: String,
    /// Which playback they are of.
    pub interpolation: Interpolation,
    /// The explanation, or why there is none.
    pub diagnosis: Result<Finding, String>,
    /// The poses that pictures are of. They are not kept: pictures are.
    pub shown: Option<ShownPoses>,
}

impl From<SampleDiagnosis> for SampleFinding {
    fn from(samples: SampleDiagnosis) -> Self {
        let SampleDiagnosis { file, interpolation, diagnosis, shown, .. } = samples;
        Self { file, interpolation, diagnosis: diagnosis.as_ref().map(Finding::of).map_err(Clone::clone), shown }
    }
}

/// The answers of a diagnosis.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    pub(super) is_explained: bool,
    /// The best, then those that are as good; never empty.
    pub(super) answers: Vec<Answer>,
}

/// One answer: right playback, a mistake or two.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The names of its mistakes, joined by ` + `.
    pub name: String,
    /// The residual, finite, at least 0.
    pub residual: f64,
    /// What it consists of.
    pub mistakes: Vec<&'static Mistake>,
    /// The interpolation in which it is made.
    pub interpolation: Interpolation,
}

impl Answer {
    fn of(candidate: &Candidate) -> Self {
        let Candidate { name, residual, mistakes, .. } = candidate;
        let (name, mistakes) = (name.clone(), mistakes.clone());
        Self { name, residual: *residual, mistakes, interpolation: candidate.interpolation() }
    }

    /// Whether it is right playback.
    #[must_use]
    pub fn is_right(&self) -> bool {
        self.mistakes.iter().all(|mistake| mistake.is_right())
    }
}

impl Finding {
    fn of(diagnosis: &Diagnosis) -> Self {
        let all = std::iter::once(diagnosis.best()).chain(diagnosis.also());
        Self { is_explained: diagnosis.is_explained(), answers: all.map(Answer::of).collect() }
    }

    /// The answer that explains the samples best.
    #[must_use]
    pub fn best(&self) -> &Answer {
        &self.answers[0]
    }

    /// The others that explain them as well.
    #[must_use]
    pub fn also(&self) -> &[Answer] {
        &self.answers[1..]
    }

    /// Whether the best answer explains the samples.
    #[must_use]
    pub const fn is_explained(&self) -> bool {
        self.is_explained
    }
}
