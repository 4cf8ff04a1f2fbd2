//! The document: exactly what undo restores.

use crate::interpolation::Interpolation;
use crate::keyframe::{DEFAULT_MS_BETWEEN_KEYFRAMES, KeyframeList};
use crate::pose::Pose;

/// The live pose, the keyframe list, and how it is played. Cloning shares the poses and the list.
#[derive(Clone, Debug, PartialEq)]
pub struct Document {
    /// The pose in the scene: what is shown while nothing plays, and what `n` and `u` capture.
    pub live_pose: Pose,
    /// The keyframes and the current one.
    pub keyframes: KeyframeList,
    /// The interpolation in force.
    pub interpolation: Interpolation,
    /// Wall time from one keyframe to the next, in milliseconds: 100 to 10,000.
    pub ms_between_keyframes: u32,
}

impl Document {
    /// No keyframes, and this pose in the scene.
    #[must_use]
    pub fn new(live_pose: Pose) -> Self {
        Self {
            live_pose,
            keyframes: KeyframeList::default(),
            interpolation: Interpolation::default(),
            ms_between_keyframes: DEFAULT_MS_BETWEEN_KEYFRAMES,
        }
    }

    /// Whether two documents are the same, fast where they share.
    #[must_use]
    pub fn same_as(&self, other: &Self) -> bool {
        self.live_pose.same_as(&other.live_pose)
            && self.keyframes.current() == other.keyframes.current()
            && self.same_file_as(other)
    }

    /// Whether saving either would give the same file.
    #[must_use]
    pub fn same_file_as(&self, other: &Self) -> bool {
        self.interpolation == other.interpolation
            && self.ms_between_keyframes == other.ms_between_keyframes
            && self.keyframes.same_keyframes(&other.keyframes)
    }

    /// Whether the pose in the scene is one that no keyframe holds: neither the current one, nor, with none, the rest pose.
    #[must_use]
    pub fn has_unsaved_posing(&self, rest_pose: &Pose) -> bool {
        let kept = self.keyframes.current_keyframe().map_or(rest_pose, |keyframe| &keyframe.pose);
        !self.live_pose.same_as(kept)
    }
}
