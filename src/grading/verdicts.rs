//! Verdicts on the items of a rubric.

mod keyframes;
mod playback;
mod script;

pub use keyframes::ComparedKeyframes;

use super::item::{ItemKind, Verdict};
use super::parsed::Parsed;
use super::requirements::Work;
use super::rubric::Rubric;
use super::samples::SampleDiagnosis;
use crate::keyframe::KeyframeList;
use crate::scene::SceneGraph;

/// The most frames at which playback is compared.
const MOST_FRAMES: usize = 20_000;

const UNREADABLE: &str = "The keyframes cannot be read.";
const NO_REFERENCE: &str = "The rubric has no reference.";

/// Everything that verdicts depend on.
pub struct Marker<'a> {
    /// The rubric.
    pub rubric: &'a Rubric,
    /// The scene.
    pub scene: &'a SceneGraph,
    /// The submission.
    pub parsed: &'a Parsed,
    /// Its keyframes beside the reference's.
    pub keyframes: &'a ComparedKeyframes<'a>,
    /// What its samples show.
    pub samples: &'a [SampleDiagnosis],
    /// Whether playback is judged by the submission's own keyframes, which lost points.
    pub follows_through: bool,
}

impl Marker<'_> {
    /// The verdict on one item.
    pub fn verdict(&self, kind: ItemKind) -> Verdict {
        match kind {
            ItemKind::Readable => self.readable(),
            ItemKind::KeyframeCount => self.keyframes.count(),
            ItemKind::Keyframe(index) => self.keyframes.keyframe(index),
            ItemKind::Playback(interpolation) => self.playback(interpolation),
            ItemKind::RangeAndEnd => self.range_and_end(),
            ItemKind::Script => self.script(),
            ItemKind::Requirement(requirement) => {
                let Self { rubric, scene, parsed, samples, .. } = *self;
                Work { rubric, scene, parsed, samples }.verdict(requirement)
            }
        }
    }

    fn list(&self) -> Option<&KeyframeList> {
        self.parsed.keyframes.as_ref().ok().map(|read| &read.list)
    }

    fn readable(&self) -> Verdict {
        match &self.parsed.keyframes {
            Ok(read) => Verdict::met(format!("{} holds {} keyframes.", read.file, read.list.len())),
            Err(problem) => Verdict::unmet(problem),
        }
    }
}
