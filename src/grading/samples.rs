//! A submission's files of samples: which playback each is of, how it is judged, and its diagnosis.

use super::note::Note;
use super::parsed::{MOST_SAMPLES, Parsed, ParsedFile};
use super::right::Right;
use super::rubric::Rubric;
use super::shown::{ShownPoses, thinned};
use super::shown_playback::ShownPlayback;
use crate::diagnosis::{Diagnosis, EQUAL_RESIDUALS, Listing, SampleRows, diagnose};
use crate::interpolation::Interpolation;

/// One file of samples.
#[derive(Clone, Debug, PartialEq)]
pub struct SampleDiagnosis {
    /// The file.
    pub file: String,
    /// Which playback they are of.
    pub interpolation: Interpolation,
    /// The verdict by the rubric's tolerances, or why there is none.
    pub(super) playback: Result<ShownPlayback, String>,
    /// The explanation, or why there is none. It earns and costs no points.
    pub diagnosis: Result<Diagnosis, String>,
    /// Whether the explanation is of the submission's own keyframes, and not of the reference.
    pub explains_own: bool,
    /// The poses that pictures are of.
    pub shown: Option<ShownPoses>,
}

/// What samples are compared with: the reference, and the submission's own keyframes, where each can be played.
pub struct Rights<'a> {
    reference: Option<Right<'a>>,
    own: Result<Right<'a>, String>,
    /// Whether the submission's own keyframes are right too.
    own_counts: bool,
}

impl<'a> Rights<'a> {
    /// `follows_through` says whether playback is judged by the submission's own keyframes too. It is where there is no reference.
    pub fn new(parsed: &'a Parsed, rubric: &'a Rubric, follows_through: bool) -> Self {
        let reference = Right::reference(rubric);
        let own = match &parsed.keyframes {
            Ok(own) => {
                // A text holds no pace.
                let of_reference = reference.as_ref().map(|reference| reference.ms_between_keyframes);
                let ms = own.held.1.or(of_reference).unwrap_or(own.ms_between_keyframes);
                Right::own(&own.list, ms)
            }
            Err(_) => Err("there are no keyframes to compare with".to_owned()),
        };
        Self { own_counts: follows_through || reference.is_none(), reference, own }
    }

    /// Those by which points are given, the reference first.
    ///
    /// # Errors
    /// There are none: a sentence.
    fn of_points(&self) -> Result<Vec<&Right<'a>>, String> {
        let own = self.own.as_ref().ok().filter(|_| self.own_counts);
        let found: Vec<&Right<'a>> = self.reference.iter().chain(own).collect();
        match &self.own {
            Err(problem) if found.is_empty() => Err(problem.clone()),
            _ => Ok(found),
        }
    }

    /// Those by which samples are explained: a program may have played its own keyframes or the reference's. Where these are the same, once.
    fn of_explanations(&self) -> impl Iterator<Item = &Right<'a>> {
        let own = self.own.as_ref().ok();
        own.into_iter()
            .chain(self.reference.iter().filter(move |reference| own.is_none_or(|own| !own.plays_like(reference))))
    }
}

/// Judges and diagnoses the samples of a submission.
pub fn sample_diagnoses(parsed: &Parsed, rubric: &Rubric, follows_through: bool) -> Vec<SampleDiagnosis> {
    let rights = Rights::new(parsed, rubric, follows_through);
    let usual = parsed.keyframes.as_ref().map_or_else(|_| Interpolation::default(), |own| own.interpolation);
    let one = |ParsedFile { name, content }: &ParsedFile<SampleRows>| {
        let named = playback_named(name);
        let rows = content.as_ref().map_err(Clone::clone);
        let (diagnosis, explains_own) = match rows.clone().and_then(|rows| nearest(rows, &rights)) {
            Ok((diagnosis, is_own)) => (Ok(diagnosis), is_own),
            Err(problem) => (Err(problem), false),
        };
        // Samples that fit neither playback may still show a known mistake of one.
        let explained = diagnosis.as_ref().ok().filter(|diagnosis| diagnosis.is_explained());
        let usual = explained.map_or(usual, |diagnosis| diagnosis.best().interpolation());
        let judged = rows.clone().and_then(|rows| judged(rows, named, usual, &rights, rubric));
        let (interpolation, playback) = match judged {
            Ok((interpolation, playback)) => (interpolation, Ok(playback)),
            Err(problem) => (named.unwrap_or(usual), Err(problem)),
        };
        let shown = match (rows, rights.of_points()) {
            (Ok(rows), Ok(rights)) => rights.first().and_then(|right| {
                let samples = rows.samples(right.ms_between_keyframes);
                thinned(&samples, interpolation, right.list, rubric.tolerances)
            }),
            _ => None,
        };
        SampleDiagnosis { file: name.clone(), interpolation, playback, diagnosis, explains_own, shown }
    };
    parsed.samples.iter().map(one).collect()
}

/// A note if there are more files of samples than are read.
pub fn note_of_too_many(parsed: &Parsed) -> Option<Note> {
    let count = parsed.samples_count;
    let text = || format!("{count} files of samples, and only the first {MOST_SAMPLES} are looked at");
    (count > MOST_SAMPLES).then(|| Note::to_look_at(text()))
}

/// The interpolation that a file's own name suggests; `None` if it suggests none, or both. What is called nonlinear is not linear.
fn playback_named(path: &str) -> Option<Interpolation> {
    let name = path.rsplit('/').next().unwrap_or(path).to_ascii_lowercase();
    let affirmed = ["", "-", "_", " "].iter().fold(name.clone(), |name, sign| {
        name.replace(&format!("non{sign}linear"), "").replace(&format!("not{sign}linear"), "")
    });
    match (affirmed.contains("linear"), name.contains("catmull") || name.contains("spline")) {
        (true, false) => Some(Interpolation::Linear),
        (false, true) => Some(Interpolation::CatmullRom),
        _ => None,
    }
}

/// The verdict on samples: by the keyframes that earn most, and as the playback that is named or, without a name, that they fit clearly
/// better; otherwise as the usual one.
fn judged(
    rows: &SampleRows,
    named: Option<Interpolation>,
    usual: Interpolation,
    rights: &Rights<'_>,
    rubric: &Rubric,
) -> Result<(Interpolation, ShownPlayback), String> {
    let mut best: Option<(Interpolation, ShownPlayback)> = None;
    for right in rights.of_points()? {
        let samples = rows.samples(right.ms_between_keyframes);
        let judge = |interpolation| ShownPlayback::of(&samples, right, interpolation, rubric);
        let candidates = named.map_or_else(|| vec![usual, usual.next()], |named| vec![named]);
        let of_right = candidates
            .into_iter()
            .map(|interpolation| (interpolation, judge(interpolation)))
            .reduce(|one, other| if other.1.fits_better_than(&one.1) { other } else { one });
        let is_better = |found: &(Interpolation, ShownPlayback)| {
            let rank = |found: &(Interpolation, ShownPlayback)| (found.1.share(rubric), found.1.ends.share);
            best.as_ref().is_none_or(|best| rank(found) > rank(best))
        };
        best = of_right.filter(is_better).or(best);
    }
    best.ok_or_else(|| "there are no keyframes to compare with".to_owned())
}

/// The diagnosis against the keyframes that explain the samples best, and whether these are the submission's own; the first of those that
/// do equally well.
fn nearest(rows: &SampleRows, rights: &Rights<'_>) -> Result<(Diagnosis, bool), String> {
    let diagnoses = rights.of_explanations().map(|right| {
        let samples = rows.samples(right.ms_between_keyframes);
        (diagnose(&right.sequence, &samples, Listing::Explanations), right.is_own)
    });
    let nearer = |one: (Diagnosis, bool), other: (Diagnosis, bool)| {
        let (is_explained, is_other_explained) = (one.0.is_explained(), other.0.is_explained());
        let is_nearer = other.0.best().residual < one.0.best().residual - EQUAL_RESIDUALS;
        if (is_other_explained && !is_explained) || (is_other_explained == is_explained && is_nearer) {
            other
        } else {
            one
        }
    };
    diagnoses.reduce(nearer).ok_or_else(|| "there are no keyframes to compare with".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_suggest_a_playback() {
        for name in ["nonlinear.csv", "non-linear.csv", "not_linear.csv", "samples.csv", "linear-and-catmull.csv"] {
            assert_eq!(playback_named(name), None, "{name}");
        }
        for name in ["a/Linear.csv", "mylinear2.csv", "walkLinear.csv"] {
            assert_eq!(playback_named(name), Some(Interpolation::Linear), "{name}");
        }
        for name in ["CatmullRom.csv", "nonlinear-catmull-rom.csv", "spline.csv"] {
            assert_eq!(playback_named(name), Some(Interpolation::CatmullRom), "{name}");
        }
    }
}
