//! Diagnosis: which known mistake explains what a student's own program showed.
//!
//! The samples of that program are compared with the right result and with the result of each known mistake. Everything is computed
//! in double precision and without the formulas of [`crate::interpolation`], so that each can be tested against the other. Pure functions: text and
//! keyframes in, names and residuals out. This module does not know files, the editor or the command line.
//!
//! A mistake *explains* the samples if every row agrees with it, number by number, within [`Tolerances`]: half a unit of the decimals
//! that are printed, or what single precision leaves. No mean over rows can hide a row that is off. Rotations are compared as printed, not
//! renormalised; of q and −q the nearer counts everywhere, for both are the same rotation. Where no single mistake explains the samples,
//! every pair that can be made together is tried.
//!
//! The *residual* orders what does not explain them: a root mean square over the rows. A row contributes the squared distance of
//! translations (scene units) plus the squared distance of quaternions. If the sample or the prediction is not finite, that part's
//! distance is 0 if both are not finite, otherwise [`DISTANCE_OF_NO_NUMBER`].

mod catalogue;
mod choices;
mod compare;
mod judge;
mod motion;
mod reveals;
mod rules;
mod samples;
mod sequence;

pub use catalogue::{Fact, Mistake, markdown, mistakes};
pub use compare::right_rotations;
pub use reveals::{ChangeKind, Hidden, Judged, KeyframeChange, change_that_reveals, revealing};
pub use samples::{
    LARGEST_SAMPLES_BYTES, Printed, Row, SampleRows, Samples, SamplesError, Tolerances, samples_from_csv,
};
pub use sequence::{Sequence, TooFewKeyframes};

use catalogue::{Form, forms, is_old};
use compare::Comparison;
use judge::{Agreement, Judge};
use rules::Rules;

use crate::interpolation::Interpolation;

/// Residuals that differ by no more than this are equal.
pub const EQUAL_RESIDUALS: f64 = 1e-9;

/// The distance between a number and NaN, in scene units or quaternion components. Larger than any distance of two rotations.
pub const DISTANCE_OF_NO_NUMBER: f64 = 10.0;

/// The name of the right result, by lerp and slerp.
pub const CORRECT: &str = "correct";

/// The name of the right result, by Catmull-Rom splines.
pub const CORRECT_CATMULL_ROM: &str = "correct-catmull-rom";

/// The name of playback that never shows its last pose.
pub const LAST_SAMPLE_MISSING: &str = "last-sample-missing";

/// The names of all candidates in the catalogue's order: the two right results, then the mistakes.
pub fn names() -> impl Iterator<Item = &'static str> {
    mistakes().map(|mistake| mistake.name)
}

/// How well right playback, a mistake or two mistakes at once explain the samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// The name in kebab-case, such as `lerp-for-slerp`. Two are joined by ` + `, in the catalogue's order, but [`LAST_SAMPLE_MISSING`]
    /// last.
    pub name: String,
    /// The residual, finite, at least 0.
    pub residual: f64,
    /// Whether every row agrees.
    pub explains: bool,
    /// What it consists of: one mistake, or two.
    pub mistakes: Vec<&'static Mistake>,
    /// The angle in degrees below which turns are left out, as the samples show it.
    pub frozen_below_degrees: Option<f64>,
    rules: Rules,
    place: Place,
}

/// The place among answers that explain equally well: one mistake before two, whatever rounding decides before what needs it, known long
/// before known later.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Place {
    mistakes: usize,
    needs_rounding: bool,
    later_ones: usize,
    ranks: [usize; 2],
}

impl Candidate {
    /// The interpolation in which it is made.
    #[must_use]
    pub fn interpolation(&self) -> Interpolation {
        if self.rules.moves.spline.is_some() { Interpolation::CatmullRom } else { Interpolation::Linear }
    }

    /// Whether it shows the right result.
    #[must_use]
    pub fn is_right(&self) -> bool {
        self.mistakes.iter().all(|mistake| mistake.is_right())
    }

    fn new(forms: &[Form], rules: Rules, agreement: Option<Agreement>) -> Self {
        let entries = || forms.iter().map(|form| form.entry);
        let names: Vec<&str> = entries().map(|entry| entry.mistake.name).collect();
        let mut ranks = [0; 2];
        for (rank, entry) in ranks.iter_mut().zip(entries()) {
            *rank = entry.rank;
        }
        Self {
            name: names.join(" + "),
            residual: 0.0,
            explains: true,
            mistakes: entries().map(|entry| entry.mistake).collect(),
            frozen_below_degrees: agreement
                .and_then(|agreement| agreement.threshold)
                .map(|half_angle| 2.0 * half_angle.to_degrees()),
            rules,
            place: Place {
                mistakes: forms.len(),
                needs_rounding: agreement.is_some_and(|agreement| !agreement.is_exact),
                later_ones: entries().filter(|entry| !is_old(entry.rank)).count(),
                ranks,
            },
        }
    }

    /// Whether it is the other but for the end, which is missing in the samples.
    fn differs_only_at_end(&self, other: &Self) -> bool {
        let mut rules = self.rules;
        rules.timing.shows_end = other.rules.timing.shows_end;
        rules == other.rules
    }
}

/// Which candidates a diagnosis lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Listing {
    /// Those that explain the samples; if none does, right playback. This is much quicker.
    Explanations,
    /// Every one.
    All,
}

/// Right playback and the mistakes with their residuals, best first.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnosis {
    /// Those that explain the samples, in the order of answers; then the others by residual. Never empty. Pairs are listed only if they
    /// explain the samples.
    pub candidates: Vec<Candidate>,
    /// How many of them are equally good: all that explain the samples; or, if none does, those with the least residual. At least 1.
    pub equals: usize,
    /// How many rows there were.
    pub rows: usize,
    /// How far before the end the samples end, in key time; `None` if they reach it.
    pub ends_before: Option<f64>,
    /// The work: how many transforms were computed.
    pub computed: usize,
}

impl Diagnosis {
    /// The candidate that explains the samples best.
    #[must_use]
    pub fn best(&self) -> &Candidate {
        &self.candidates[0]
    }

    /// The others that explain them as well.
    #[must_use]
    pub fn also(&self) -> &[Candidate] {
        &self.candidates[1..self.equals]
    }

    /// The candidates that explain the samples less well, best first.
    #[must_use]
    pub fn runners_up(&self) -> &[Candidate] {
        &self.candidates[self.equals..]
    }

    /// Whether the best candidate explains the samples: every row agrees with it.
    #[must_use]
    pub fn is_explained(&self) -> bool {
        self.best().explains
    }

    /// Those of [`Self::also`] that can be told from the best by more samples of the same keyframes, then those that cannot.
    #[must_use]
    pub fn also_by_cause(&self, sequence: &Sequence, samples: &Samples) -> [Vec<&Candidate>; 2] {
        let comparison = Comparison::new(sequence, samples);
        let best = self.best();
        let others = self.also().iter().filter(|other| !other.differs_only_at_end(best));
        let (too_few, same) = others.partition(|other| {
            let threshold = best.frozen_below_degrees.map(|degrees| degrees.to_radians() / 2.0);
            comparison.differ(&best.rules, threshold, &other.rules)
        });
        [too_few, same]
    }
}

/// Compares samples with right playback, every mistake and, where none explains them, every pair of mistakes.
///
/// Every row's node must exist in the sequence; [`samples_from_csv`] checks that.
#[must_use]
pub fn diagnose(sequence: &Sequence, samples: &Samples, listing: Listing) -> Diagnosis {
    let mut judge = Judge::new(sequence, samples);
    let forms: Vec<Form> = forms().collect();
    let end = sequence.last_key_time();
    let ends_before =
        (!samples.reaches(end)).then(|| samples.rows.iter().map(|row| end - row.key_time).fold(end, f64::min));
    let mut explaining = singles(&mut judge, &forms);
    if explaining.is_empty() {
        explaining = pairs(&mut judge, &forms);
    } else if ends_before.is_some() {
        put_missing_end_first(&mut explaining, &forms);
    }
    let equals = explaining.len();
    let mut candidates = explaining;
    if listing == Listing::All {
        candidates.extend(others(&mut judge, &forms, &candidates));
    } else if equals == 0 {
        let right: Vec<Form> = forms.into_iter().filter(|form| form.entry.mistake.is_right()).collect();
        candidates = others(&mut judge, &right, &[]);
    }
    let least = candidates[0].residual;
    let nearest = candidates.iter().take_while(|candidate| candidate.residual <= least + EQUAL_RESIDUALS).count();
    let equals = if equals == 0 { nearest } else { equals };
    Diagnosis { candidates, equals, rows: samples.rows.len(), ends_before, computed: judge.computed() }
}

/// What a program shows that makes a mistake, in an interpolation if it can be made there, and the interpolation; `None` without such a
/// mistake. 12 moments an interval.
#[must_use]
pub fn played(sequence: &Sequence, name: &str, interpolation: Interpolation) -> Option<(Interpolation, Vec<Row>)> {
    const MOMENTS: usize = 12;
    let is_spline = interpolation == Interpolation::CatmullRom;
    let of_name = || forms().filter(|form| form.entry.mistake.name == name);
    let form = of_name().find(|form| form.is_spline == is_spline).or_else(|| of_name().next())?;
    let moments = (0..=sequence.last_key_time() as usize * MOMENTS).map(|moment| moment as f64 / MOMENTS as f64);
    let rows = compare::rows(sequence, &form.rules(), moments);
    let interpolation = if form.is_spline { Interpolation::CatmullRom } else { Interpolation::Linear };
    Some((interpolation, rows))
}

/// Right playback and the mistakes that explain the samples alone, in the order of answers.
fn singles(judge: &mut Judge, forms: &[Form]) -> Vec<Candidate> {
    let mut found: Vec<Candidate> = Vec::new();
    for form in forms {
        let rules = form.rules();
        if let Some(agreement) = judge.agreement(&rules) {
            let residual = judge.residual(&rules, Some(agreement));
            keep(&mut found, Candidate { residual, ..Candidate::new(&[*form], rules, Some(agreement)) });
        }
    }
    found.sort_by_key(|candidate| candidate.place);
    found
}

/// Adds a candidate. Of those of one name, the one with the better place stays.
fn keep(found: &mut Vec<Candidate>, candidate: Candidate) {
    match found.iter_mut().find(|known| known.name == candidate.name) {
        Some(known) if candidate.place < known.place => *known = candidate,
        Some(_) => {}
        None => found.push(candidate),
    }
}

/// The pairs of mistakes that explain the samples together, in the order of answers.
fn pairs(judge: &mut Judge, forms: &[Form]) -> Vec<Candidate> {
    let mut found: Vec<Candidate> = Vec::new();
    let wrong = || forms.iter().filter(|form| !form.entry.mistake.is_right());
    for (index, one) in wrong().enumerate() {
        for other in wrong().skip(index + 1) {
            let Some(rules) = one.with(other) else { continue };
            let Some(agreement) = judge.agreement(&rules) else { continue };
            let is_end = one.entry.mistake.name == LAST_SAMPLE_MISSING;
            let both = if is_end { [*other, *one] } else { [*one, *other] };
            let residual = judge.residual(&rules, Some(agreement));
            keep(&mut found, Candidate { residual, ..Candidate::new(&both, rules, Some(agreement)) });
        }
    }
    found.sort_by_key(|candidate| candidate.place);
    found
}

/// Samples that end early show that the end is missing: right playback to there is that mistake, and another mistake is a pair with it.
fn put_missing_end_first(explaining: &mut Vec<Candidate>, forms: &[Form]) {
    if let Some(index) = explaining.iter().position(|candidate| candidate.name == LAST_SAMPLE_MISSING) {
        explaining[..=index].rotate_right(1);
        return;
    }
    let best = &explaining[0];
    let form = |name: &str, is_spline| {
        forms.iter().find(|form| form.entry.mistake.name == name && form.is_spline == is_spline)
    };
    let is_spline = best.rules.moves.spline.is_some();
    if let (Some(one), Some(end)) = (form(best.mistakes[0].name, is_spline), form(LAST_SAMPLE_MISSING, is_spline)) {
        let mut rules = best.rules;
        rules.timing.shows_end = false;
        let pair = Candidate {
            residual: best.residual,
            frozen_below_degrees: best.frozen_below_degrees,
            ..Candidate::new(&[*one, *end], rules, None)
        };
        explaining.insert(0, pair);
    }
}

/// Right playback and the mistakes that do not explain the samples, by residual. Those of equal residual stand in the catalogue's order.
fn others(judge: &mut Judge, forms: &[Form], explaining: &[Candidate]) -> Vec<Candidate> {
    judge.be_strict();
    judge.prepare(&forms.iter().map(Form::rules).collect::<Vec<_>>());
    let mut found: Vec<Candidate> = Vec::new();
    for form in forms {
        let rules = form.rules();
        let of_form = Candidate {
            residual: judge.residual(&rules, None),
            explains: false,
            ..Candidate::new(&[*form], rules, None)
        };
        match found.last_mut().filter(|last| last.name == of_form.name) {
            Some(last) if of_form.residual < last.residual => *last = of_form,
            Some(_) => {}
            None => found.push(of_form),
        }
    }
    found.retain(|candidate| explaining.iter().all(|known| known.name != candidate.name));
    // Candidates within EQUAL_RESIDUALS of the smallest residual form a group.
    let mut sorted = Vec::with_capacity(found.len());
    while let Some(least) = found.iter().map(|candidate| candidate.residual).min_by(f64::total_cmp) {
        let (group, rest) = found.into_iter().partition(|candidate| candidate.residual <= least + EQUAL_RESIDUALS);
        found = rest;
        sorted.extend::<Vec<_>>(group);
    }
    sorted
}
