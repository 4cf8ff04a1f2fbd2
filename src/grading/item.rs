//! What is graded, and what came of it.

use crate::interpolation::Interpolation;

/// One thing that a rubric gives points for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ItemKind {
    /// The keyframes can be read.
    Readable,
    /// There are as many keyframes as in the reference.
    KeyframeCount,
    /// The keyframe of this index is the reference's.
    Keyframe(usize),
    /// It plays as the reference.
    Playback(Interpolation),
    /// It begins and ends where it should.
    RangeAndEnd,
    /// The hotkey script does what it should.
    Script,
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
        }
    }

    /// The name for people.
    #[must_use]
    pub fn title(self) -> String {
        match self {
            Self::Playback(Interpolation::CatmullRom) => "Catmull-Rom playback".to_owned(),
            other => other.id().replace('_', " "),
        }
    }
}

/// Whether something is as it should be, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Verdict {
    /// Whether it is.
    pub is_met: bool,
    /// Why, or why not: sentences.
    pub reason: String,
}

impl Verdict {
    /// It is as it should be.
    pub fn met(reason: impl Into<String>) -> Self {
        Self { is_met: true, reason: reason.into() }
    }

    /// It is not, or that cannot be told.
    pub fn unmet(reason: impl Into<String>) -> Self {
        Self { is_met: false, reason: reason.into() }
    }
}

/// One thing that was graded.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// What it is.
    pub kind: ItemKind,
    /// The points that it got.
    pub points: f64,
    /// The points that it could get.
    pub out_of: f64,
    /// Why: sentences.
    pub reason: String,
}

impl Item {
    /// An item that gets all points or none.
    #[must_use]
    pub fn new(kind: ItemKind, out_of: f64, verdict: Verdict) -> Self {
        Self { kind, points: if verdict.is_met { out_of } else { 0.0 }, out_of, reason: verdict.reason }
    }

    /// Whether points are missing.
    #[must_use]
    pub fn has_lost(&self) -> bool {
        self.points < self.out_of
    }
}
