//! Graded items and their verdicts.

use super::requirements::Requirement;
use crate::interpolation::Interpolation;

/// One thing that a rubric gives points for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ItemKind {
    /// Whether the keyframes can be read.
    Readable,
    /// Whether the number of keyframes equals the reference's.
    KeyframeCount,
    /// Whether the keyframe with this index equals the reference's.
    Keyframe(usize),
    /// Whether playback equals the reference's.
    Playback(Interpolation),
    /// Whether playback has the right range.
    RangeAndEnd,
    /// Whether the hotkey script leads to the right states.
    Script,
    /// Whether a requirement is met that needs no reference.
    Requirement(Requirement),
}

impl ItemKind {
    /// The name in tables for programs, as in the rubric; keyframes have their index: `keyframe 3`.
    #[must_use]
    pub fn id(self) -> String {
        match self {
            Self::Readable => "readable".to_owned(),
            Self::KeyframeCount => "keyframe_count".to_owned(),
            Self::Keyframe(index) => format!("keyframe {index}"),
            Self::Playback(Interpolation::Linear) => "linear_playback".to_owned(),
            Self::Playback(Interpolation::CatmullRom) => "catmull_rom_playback".to_owned(),
            Self::RangeAndEnd => "range_and_end".to_owned(),
            Self::Script => "script".to_owned(),
            Self::Requirement(requirement) => requirement.id().to_owned(),
        }
    }

    /// The displayed name.
    #[must_use]
    pub fn title(self) -> String {
        match self {
            Self::Playback(Interpolation::CatmullRom) => "Catmull-Rom playback".to_owned(),
            Self::Requirement(Requirement::UsesCatmullRom) => "uses Catmull-Rom".to_owned(),
            other => other.id().replace('_', " "),
        }
    }
}

/// What a verdict on playback or on a script rests on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evidence {
    /// Samples that were handed in: what the student's program showed.
    Samples,
    /// A trace that was handed in.
    Trace,
    /// A script that was handed in and run.
    Script,
    /// What this program makes of the submitted keyframes. It says nothing about the student's program.
    Assumed,
}

impl Evidence {
    /// All.
    const ALL: [Self; 4] = [Self::Samples, Self::Trace, Self::Script, Self::Assumed];

    /// The one of a name in tables.
    #[must_use]
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|evidence| evidence.id() == id)
    }

    /// The name in tables.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Samples => "samples",
            Self::Trace => "trace",
            Self::Script => "script",
            Self::Assumed => "assumed",
        }
    }
}

/// The verdict on an item, with its reason.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// The share of the points, 0 to 1.
    pub share: f64,
    /// The reason, in sentences.
    pub reason: String,
    /// What it rests on; `None` where nothing was looked at, and for items that are about keyframes alone.
    pub evidence: Option<Evidence>,
}

impl Verdict {
    /// A share of the points, from 0 to 1.
    pub fn share(share: f64, reason: impl Into<String>) -> Self {
        Self { share, reason: reason.into(), evidence: None }
    }

    /// The requirement is met.
    pub fn met(reason: impl Into<String>) -> Self {
        Self::share(1.0, reason)
    }

    /// The requirement is not met, or cannot be checked.
    pub fn unmet(reason: impl Into<String>) -> Self {
        Self::share(0.0, reason)
    }

    /// The same verdict, with what it rests on.
    #[must_use]
    pub fn by(self, evidence: Evidence) -> Self {
        Self { evidence: Some(evidence), ..self }
    }

    /// Whether the requirement is met in full.
    #[must_use]
    pub fn is_met(&self) -> bool {
        self.share >= 1.0
    }
}

/// A graded item.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// What it is.
    pub kind: ItemKind,
    /// The points given.
    pub points: f64,
    /// The maximum of points.
    pub out_of: f64,
    /// Why: sentences.
    pub reason: String,
    /// What the verdict rests on.
    pub evidence: Option<Evidence>,
    /// Whether a teacher gave the points, and no verdict.
    pub is_by_hand: bool,
}

impl Item {
    /// An item that gets the share of the points that the verdict gives.
    #[must_use]
    pub fn new(kind: ItemKind, out_of: f64, verdict: Verdict) -> Self {
        let Verdict { share, mut reason, evidence } = verdict;
        // Sentences of reading a file end without a full stop, since they may be quoted.
        if !reason.is_empty() && !reason.ends_with(['.', '!', '?']) {
            reason.push('.');
        }
        Self { kind, points: out_of * share, out_of, reason, evidence, is_by_hand: false }
    }

    /// Whether points are missing.
    #[must_use]
    pub fn has_lost(&self) -> bool {
        self.points < self.out_of
    }
}
