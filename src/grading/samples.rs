//! Diagnosis of a submission's samples.

use super::parsed::{MOST_SAMPLES, Parsed, ParsedFile};
use super::rubric::Rubric;
use super::shown::{ShownPoses, thinned};
use crate::diagnosis::{Diagnosis, EQUAL_RESIDUALS, Listing, SampleRows, Sequence, diagnose};
use crate::interpolation::Interpolation;

/// The diagnosis of one file of samples.
#[derive(Clone, Debug, PartialEq)]
pub struct SampleDiagnosis {
    /// The file.
    pub file: String,
    /// Which playback they are of.
    pub interpolation: Interpolation,
    /// The explanation, or why there is none.
    pub diagnosis: Result<Diagnosis, String>,
    /// The poses that pictures are of.
    pub shown: Option<ShownPoses>,
}

/// Diagnoses the samples of a submission.
pub fn sample_diagnoses(parsed: &Parsed, rubric: &Rubric) -> Vec<SampleDiagnosis> {
    // A program may have played its own keyframes or the reference's: try both.
    let own = parsed.keyframes.as_ref().ok();
    let own_sequence = own.and_then(|own| Some((Sequence::new(own.list.as_slice()).ok()?, own.ms_between_keyframes)));
    let reference = rubric.reference.as_ref();
    let right = reference.map(|right| (&right.list, right.ms_between_keyframes));
    let right = right.or_else(|| own.map(|own| (&own.list, own.ms_between_keyframes)));
    let reference =
        reference.and_then(|right| Some((Sequence::new(right.list.as_slice()).ok()?, right.ms_between_keyframes)));
    let sequences: Vec<(Sequence, u32)> = own_sequence.into_iter().chain(reference).collect();
    let one = |ParsedFile { name, content }: &ParsedFile<SampleRows>| {
        let interpolation =
            playback_named(name).unwrap_or_else(|| own.map_or_else(Interpolation::default, |own| own.interpolation));
        let diagnosis = content.as_ref().map_err(Clone::clone).and_then(|rows| nearest(rows, &sequences));
        let shown = match (content, &diagnosis, right) {
            (Ok(rows), Ok(_), Some((list, ms))) => thinned(&rows.samples(ms), interpolation, list, rubric.tolerances),
            _ => None,
        };
        SampleDiagnosis { file: name.clone(), interpolation, diagnosis, shown }
    };
    parsed.samples.iter().map(one).collect()
}

/// A note if there are more files of samples than are read.
pub fn note_of_too_many(parsed: &Parsed) -> Option<String> {
    let count = parsed.samples_count;
    (count > MOST_SAMPLES).then(|| format!("{count} files of samples, and only the first {MOST_SAMPLES} are looked at"))
}

/// The interpolation that a file's name suggests.
fn playback_named(name: &str) -> Option<Interpolation> {
    let name = name.to_ascii_lowercase();
    if name.contains("catmull") || name.contains("spline") {
        Some(Interpolation::CatmullRom)
    } else {
        name.contains("linear").then_some(Interpolation::Linear)
    }
}

/// The diagnosis against the sequence of keyframes that explains the samples best; the first of those that do equally well.
fn nearest(rows: &SampleRows, sequences: &[(Sequence, u32)]) -> Result<Diagnosis, String> {
    let diagnoses =
        sequences.iter().map(|(sequence, ms)| diagnose(sequence, &rows.samples(*ms), Listing::Explanations));
    let nearer = |one: Diagnosis, other: Diagnosis| {
        let (is_explained, is_other_explained) = (one.is_explained(), other.is_explained());
        let is_nearer = other.best().residual < one.best().residual - EQUAL_RESIDUALS;
        if (is_other_explained && !is_explained) || (is_other_explained == is_explained && is_nearer) {
            other
        } else {
            one
        }
    };
    diagnoses.reduce(nearer).ok_or_else(|| "there are no keyframes to compare with".to_owned())
}
