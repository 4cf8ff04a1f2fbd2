//! The document: exactly what undo restores.

use std::sync::Arc;

use super::CommandError;
use crate::interpolation::Interpolation;
use crate::keyframe::{Animation, DEFAULT_MS_BETWEEN_KEYFRAMES, KeyframeList, LARGEST_FILE_BYTES, file_bytes_at_most};
use crate::pose::Pose;
use crate::scene::{LARGEST_SCENE_BYTES, SceneGraph};

/// The scene with its keys, the live pose, the keyframe list, and how it is played. Cloning shares the scene, the poses and the list.
#[derive(Clone, Debug, PartialEq)]
pub struct Document {
    /// The scene. Edits change its control nodes and timed keys, never its RBT nodes.
    pub scene: Arc<SceneGraph>,
    /// The pose in the scene: what is shown while nothing plays, and what `n` and `u` capture.
    pub live_pose: Pose,
    /// The keyframes and the current one.
    pub keyframes: KeyframeList,
    /// The current interpolation.
    pub interpolation: Interpolation,
    /// Wall time from one keyframe to the next, in milliseconds: 100 to 10,000.
    pub ms_between_keyframes: u32,
}

impl Document {
    /// A scene at rest, with no keyframes.
    #[must_use]
    pub fn new(scene: Arc<SceneGraph>) -> Self {
        Self {
            live_pose: scene.rest_pose().clone(),
            scene,
            keyframes: KeyframeList::default(),
            interpolation: Interpolation::default(),
            ms_between_keyframes: DEFAULT_MS_BETWEEN_KEYFRAMES,
        }
    }

    /// Takes in an animation, and shows its first keyframe.
    pub fn install(&mut self, animation: Animation) {
        let Animation { keyframes, interpolation, ms_between_keyframes } = animation;
        (self.interpolation, self.ms_between_keyframes) = (interpolation, ms_between_keyframes);
        self.install_list(keyframes);
    }

    /// Replaces the list and copies its current keyframe to the live pose.
    pub(super) fn install_list(&mut self, keyframes: KeyframeList) {
        self.keyframes = keyframes;
        if let Some(keyframe) = self.keyframes.current_keyframe() {
            self.live_pose = keyframe.pose.clone();
        }
    }

    /// Whether two documents are the same, fast where they share.
    #[must_use]
    pub fn same_as(&self, other: &Self) -> bool {
        self.same_scene_as(other)
            && self.live_pose.same_as(&other.live_pose)
            && self.keyframes.current() == other.keyframes.current()
            && self.same_file_as(other)
    }

    /// Whether saving the scene of either would give the same file.
    #[must_use]
    pub fn same_scene_as(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.scene, &other.scene) || self.scene == other.scene
    }

    /// Whether saving the keyframes of either would give the same file.
    #[must_use]
    pub fn same_file_as(&self, other: &Self) -> bool {
        self.interpolation == other.interpolation
            && self.ms_between_keyframes == other.ms_between_keyframes
            && self.keyframes.same_keyframes(&other.keyframes)
            && (Arc::ptr_eq(&self.scene, &other.scene) || self.scene.has_rbts_of(&other.scene))
    }

    /// Why this cannot follow another document: a file of it could be larger than files that are read. What makes a file smaller is
    /// possible even so. Takes no time for what both share.
    pub(super) fn too_large_after(&self, before: &Self) -> Option<CommandError> {
        let is_too_large = |[before, after]: [u64; 2], limit| after > limit && after >= before;
        let keyframes = |document: &Self| file_bytes_at_most(&document.scene, &document.keyframes);
        let scene = |document: &Self| document.scene.file_bytes_at_most();
        if !self.keyframes.shares_with(&before.keyframes)
            && is_too_large([keyframes(before), keyframes(self)], LARGEST_FILE_BYTES)
        {
            Some(CommandError::KeyframesTooLarge { limit: LARGEST_FILE_BYTES })
        } else if !Arc::ptr_eq(&self.scene, &before.scene)
            && is_too_large([scene(before), scene(self)], LARGEST_SCENE_BYTES)
        {
            Some(CommandError::SceneTooLarge { limit: LARGEST_SCENE_BYTES })
        } else {
            None
        }
    }

    /// Whether the pose in the scene is one that no keyframe holds: neither the current one, nor, with none, the rest pose.
    #[must_use]
    pub fn has_unsaved_posing(&self, rest_pose: &Pose) -> bool {
        let kept = self.keyframes.current_keyframe().map_or(rest_pose, |keyframe| &keyframe.pose);
        !self.live_pose.same_as(kept)
    }
}
