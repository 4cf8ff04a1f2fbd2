//! Graded items and their verdicts.

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

    /// The displayed name.
    #[must_use]
    pub fn title(self) -> String {
        match self {
            Self::Playback(Interpolation::CatmullRom) => "Catmull-Rom playback".to_owned(),
            other => other.id().replace('_', " "),
        }
    }
}

/// The verdict on an item, with its reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Verdict {
    /// Whether the requirement is met.
    pub is_met: bool,
    /// The reason, in sentences.
    pub reason: String,
}

impl Verdict {
    /// The requirement is met.
    pub fn met(reason: impl Into<String>) -> Self {
        Self { is_met: true, reason: reason.into() }
    }

    /// The requirement is not met, or cannot be checked.
    pub fn unmet(reason: impl Into<String>) -> Self {
        Self { is_met: false, reason: reason.into() }
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
