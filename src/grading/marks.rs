//! The marks of a submission: points with reasons, and the diagnosis of its samples.

use super::cache::Key;
use super::finding::SampleFinding;
use super::gather::System;
use super::hash::Hashed;
use super::item::{Evidence, Item, ItemKind, Verdict};
use super::note::Note;
use super::parsed::Parsed;
use super::person::Person;
use super::rubric::Rubric;
use super::samples::{note_of_too_many, sample_diagnoses};
use super::studio::ReportPicture;
use super::submission::Submission;
use super::verdicts::{ComparedKeyframes, Marker};
use crate::keyframe::KeyframeList;
use crate::scene::SceneGraph;
use crate::text::counted;

/// What verdicts on playback rest on. What says more of the student's program is greater.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum PlaybackEvidence {
    /// Nothing: there are no samples, and the rubric asks for some.
    None,
    /// How this program plays the submitted keyframes.
    Assumed,
    /// Samples of what the student's program showed.
    Samples,
}

/// How many submissions showed their playback: `12 of 15 submissions: playback shown by samples; 3 assumed`. `None` if playback is not graded.
#[must_use]
pub fn evidence_counts(marks: &[Marks]) -> Option<String> {
    let handed_in = || marks.iter().filter(|marks| !marks.is_missing);
    let found: Vec<PlaybackEvidence> = handed_in().filter_map(Marks::playback_evidence).collect();
    if found.is_empty() {
        return None;
    }
    let count = |evidence| found.iter().filter(|one| **one == evidence).count();
    let shown = count(PlaybackEvidence::Samples);
    let mut parts =
        vec![format!("{shown} of {}: playback shown by samples", counted(handed_in().count(), "submission"))];
    for (evidence, what) in [(PlaybackEvidence::Assumed, "assumed"), (PlaybackEvidence::None, "not shown")] {
        let count = count(evidence);
        if count > 0 {
            parts.push(format!("{count} {what}"));
        }
    }
    Some(parts.join("; "))
}

/// All marks of a submission.
#[derive(Clone, Debug, Default)]
pub struct Marks {
    /// The submission's name.
    pub name: String,
    /// The student's name, where it is known.
    pub student: Option<String>,
    /// The student's number in the course system, where it is known.
    pub id: Option<String>,
    /// The students of the list whose it is; none without a list.
    pub people: Vec<Person>,
    /// Whether nothing was handed in: a student of the list without a submission.
    pub is_missing: bool,
    /// The course system that it is exported from.
    pub system: Option<System>,
    /// Whether the course system says that it came late.
    pub is_late: bool,
    /// How many days late, where that is known: days that have begun.
    pub days_late: Option<u32>,
    /// The points that lateness costs.
    pub late_points: f64,
    /// What a teacher says of it.
    pub comment: Option<String>,
    /// What was graded, in the rubric's order.
    pub items: Vec<Item>,
    /// What each sample file that is read shows.
    pub samples: Vec<SampleFinding>,
    /// The file that its keyframes are from, or the script that made them.
    pub keyframe_file: Option<String>,
    /// Why no keyframes could be read.
    pub unread: Option<String>,
    /// Its keyframes, where they can be read.
    pub keyframes: Option<KeyframeList>,
    /// Notes for the report.
    pub notes: Vec<Note>,
    /// The files of the submission that were read, by name.
    pub files: Vec<Hashed>,
    /// Its pictures; `None` before they are drawn.
    pub pictures: Option<Vec<ReportPicture>>,
    /// The key under which marks and pictures are kept; empty where nothing was handed in.
    pub key: Key,
}

impl Marks {
    /// Marks a submission by a rubric.
    #[must_use]
    pub fn of(submission: &Submission, parsed: &Parsed, rubric: &Rubric, scene: &SceneGraph) -> Self {
        let mut notes: Vec<Note> = parsed.problem.iter().map(Note::to_look_at).collect();
        match &parsed.keyframes {
            Ok(read) => notes.extend(read.inferred.clone()),
            // If reading is not graded, the read error becomes a note. A submission that cannot be opened has its own note.
            Err(problem) if rubric.points.readable == 0.0 && notes.is_empty() => notes.push(Note::to_look_at(problem)),
            Err(_) => {}
        }
        notes.extend(note_of_too_many(parsed));
        notes.extend(parsed.notes.iter().cloned());
        let list = parsed.keyframes.as_ref().ok().map(|read| &read.list);
        let keyframes = ComparedKeyframes::new(list, rubric, scene);
        let follows_through = rubric.credit.follow_through && keyframes.have_lost();
        let samples = sample_diagnoses(parsed, rubric, follows_through);
        let marker = Marker { rubric, scene, parsed, keyframes: &keyframes, samples: &samples, follows_through };
        let items = rubric.items().map(|(kind, out_of)| Item::new(kind, out_of, marker.verdict(kind))).collect();
        let read = parsed.keyframes.as_ref().ok();
        let keyframe_file = read.map(|read| read.file.clone());
        Self {
            items,
            samples: samples.into_iter().map(SampleFinding::from).collect(),
            keyframe_file,
            unread: parsed.problem.clone().or_else(|| parsed.keyframes.as_ref().err().cloned()),
            keyframes: read.map(|read| read.list.clone()),
            notes,
            ..Self::unmarked(submission)
        }
    }

    /// What is known of a submission before it is marked.
    pub(super) fn unmarked(submission: &Submission) -> Self {
        Self {
            name: submission.name.clone(),
            student: submission.student.clone(),
            id: submission.id.clone(),
            system: submission.system,
            is_late: submission.is_late,
            days_late: submission.days_late,
            ..Self::default()
        }
    }

    /// The marks of a student who handed nothing in, under a name of their own.
    #[must_use]
    pub fn missing(name: String, person: &Person, rubric: &Rubric) -> Self {
        let verdict = || Verdict::unmet("Nothing was handed in.");
        Self {
            name,
            student: Some(person.name.clone()).filter(|name| !name.is_empty()),
            id: person.ids().next().map(str::to_owned),
            people: vec![person.clone()],
            is_missing: true,
            items: rubric.items().map(|(kind, out_of)| Item::new(kind, out_of, verdict())).collect(),
            ..Self::default()
        }
    }

    /// The sections of its students on the list, each once.
    #[must_use]
    pub fn section(&self) -> Option<String> {
        let mut sections: Vec<&str> = self.people.iter().map(|person| person.section.as_str()).collect();
        sections.retain(|section| !section.is_empty());
        sections.dedup();
        (!sections.is_empty()).then(|| sections.join(", "))
    }

    /// The points of all items, without what lateness costs.
    #[must_use]
    pub fn earned(&self) -> f64 {
        self.items.iter().map(|item| item.points).sum()
    }

    /// The points: those of all items, less what lateness costs.
    #[must_use]
    pub fn points(&self) -> f64 {
        self.earned() - self.late_points
    }

    /// The points that could be had.
    #[must_use]
    pub fn out_of(&self) -> f64 {
        self.items.iter().map(|item| item.out_of).sum()
    }

    /// What the verdicts on playback rest on, in one word: what was handed in if any of them rests on it. `None` if playback is not graded.
    #[must_use]
    pub fn playback_evidence(&self) -> Option<PlaybackEvidence> {
        let is_playback = |item: &&Item| matches!(item.kind, ItemKind::Playback(_) | ItemKind::RangeAndEnd);
        let of_items = self.items.iter().filter(is_playback).map(|item| match item.evidence {
            Some(Evidence::Samples) => PlaybackEvidence::Samples,
            Some(_) => PlaybackEvidence::Assumed,
            None => PlaybackEvidence::None,
        });
        of_items.max()
    }

    /// What the verdict on the script rests on. `None` if no script is graded or nothing could be looked at.
    #[must_use]
    pub fn script_evidence(&self) -> Option<Evidence> {
        self.item(ItemKind::Script)?.evidence
    }

    /// What the verdicts rest on, in words: `playback by samples, script assumed`.
    #[must_use]
    pub fn evidence(&self) -> String {
        let playback = self.playback_evidence().map(|evidence| match evidence {
            PlaybackEvidence::Samples => "playback by samples",
            PlaybackEvidence::Assumed => "playback assumed",
            PlaybackEvidence::None => "playback not shown",
        });
        let script = self.script_evidence().map(|evidence| match evidence {
            Evidence::Trace => "script by trace",
            Evidence::Script => "own script run",
            Evidence::Samples | Evidence::Assumed => "script assumed",
        });
        playback.into_iter().chain(script).collect::<Vec<_>>().join(", ")
    }

    /// The item of a kind, where it is graded.
    #[must_use]
    pub fn item(&self, kind: ItemKind) -> Option<&Item> {
        self.items.iter().find(|item| item.kind == kind)
    }
}
