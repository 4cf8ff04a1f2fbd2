//! The marks of a submission: points with reasons, and the diagnosis of its samples.

use super::item::{Item, ItemKind};
use super::parsed::Parsed;
use super::rubric::Rubric;
use super::samples::{SampleDiagnosis, note_of_too_many, sample_diagnoses};
use super::submission::Submission;
use super::verdicts::Marker;
use crate::keyframe::KeyframeList;
use crate::scene::SceneGraph;

/// All marks of a submission.
#[derive(Clone, Debug)]
pub struct Marks {
    /// The submission's name.
    pub name: String,
    /// The student's name, where it is known.
    pub student: Option<String>,
    /// The student's number in the course system, where it is known.
    pub id: Option<String>,
    /// Whether the course system says that it came late.
    pub is_late: bool,
    /// What was graded, in the rubric's order.
    pub items: Vec<Item>,
    /// One diagnosis for each sample file that is read.
    pub samples: Vec<SampleDiagnosis>,
    /// The file that its keyframes are from, or the script that made them.
    pub keyframe_file: Option<String>,
    /// Its keyframes, where they can be read.
    pub keyframes: Option<KeyframeList>,
    /// Notes for the report.
    pub notes: Vec<String>,
}

impl Marks {
    /// Marks a submission by a rubric.
    #[must_use]
    pub fn of(submission: &Submission, parsed: &Parsed, rubric: &Rubric, scene: &SceneGraph) -> Self {
        let mut notes: Vec<String> = parsed.problem.iter().cloned().collect();
        match &parsed.keyframes {
            Ok(read) => notes.extend(read.inferred.clone()),
            // If reading is not graded, the read error becomes a note. A submission that cannot be opened has its own note.
            Err(problem) if rubric.points.readable == 0.0 && notes.is_empty() => notes.push(problem.clone()),
            Err(_) => {}
        }
        notes.extend(note_of_too_many(parsed));
        notes.extend(parsed.notes.iter().cloned());
        let samples = sample_diagnoses(parsed, rubric);
        let marker = Marker { rubric, scene, parsed, samples: &samples };
        let items = rubric.items().map(|(kind, out_of)| Item::new(kind, out_of, marker.verdict(kind))).collect();
        let read = parsed.keyframes.as_ref().ok();
        let keyframe_file = read.map(|read| read.file.clone());
        Self {
            name: submission.name.clone(),
            student: submission.student.clone(),
            id: submission.id.clone(),
            is_late: submission.is_late,
            items,
            samples,
            keyframe_file,
            keyframes: read.map(|read| read.list.clone()),
            notes,
        }
    }

    /// The points of all items.
    #[must_use]
    pub fn points(&self) -> f64 {
        self.items.iter().map(|item| item.points).sum()
    }

    /// The points that could be had.
    #[must_use]
    pub fn out_of(&self) -> f64 {
        self.items.iter().map(|item| item.out_of).sum()
    }

    /// The item of a kind, where it is graded.
    #[must_use]
    pub fn item(&self, kind: ItemKind) -> Option<&Item> {
        self.items.iter().find(|item| item.kind == kind)
    }
}
