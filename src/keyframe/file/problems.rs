//! What can be wrong with a keyframe file.

use thiserror::Error;

use crate::interpolation::Interpolation;
use crate::words::{Message, display_by_message, quoted, texts};

/// A file can be wrong in each of its numbers: after so many problems the rest are only counted.
const MOST_PROBLEMS: usize = 100;

/// One thing that is wrong with a keyframe file: a sentence with its place.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum KeyframeFileError {
    /// Not JSON of the right shape; the message ends with line and column.
    Json {
        /// What is wrong, with line and column.
        message: String,
    },
    /// `format` names something else.
    Format {
        /// What the file says.
        found: String,
    },
    /// `version` is not one that this program reads.
    Version {
        /// What the file says.
        found: u64,
    },
    /// `interpolation` is unknown.
    Interpolation {
        /// What the file says.
        found: String,
    },
    /// `ms_between_keyframes` is out of range.
    MsBetweenKeyframes {
        /// What the file says.
        found: f64,
    },
    /// The scene has no such RBT node.
    ExtraNode {
        /// The path.
        path: String,
        /// The scene's name.
        scene: String,
    },
    /// An RBT node of the scene is not in `nodes`.
    MissingNode {
        /// The path.
        path: String,
        /// The scene's name.
        scene: String,
    },
    /// A path stands twice.
    DuplicateNode {
        /// The path.
        path: String,
    },
    /// A pose and `nodes` are not of one length.
    PoseLength {
        /// The keyframe, from 0.
        keyframe: usize,
        /// How many entries there are.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// A number cannot be held.
    NotFinite {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The node's path.
        path: String,
        /// `translation` or `rotation`.
        field: &'static str,
    },
    /// A rotation is not a unit quaternion.
    NotUnit {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The node's path.
        path: String,
        /// The rotation's length.
        length: f32,
    },
    /// A field of version 2 in a file of version 1.
    NeedsVersion2 {
        /// The keyframe, from 0.
        keyframe: usize,
        /// Which field.
        field: &'static str,
    },
    /// A keyframe's interval is of no length that can play.
    Duration {
        /// The keyframe, from 0.
        keyframe: usize,
        /// What the file says.
        found: f64,
    },
    /// A keyframe's easing is unknown.
    Easing {
        /// The keyframe, from 0.
        keyframe: usize,
        /// What the file says.
        found: String,
    },
    /// More is wrong than is worth saying.
    More {
        /// How many more.
        more: usize,
    },
}

display_by_message!(KeyframeFileError);

impl KeyframeFileError {
    /// What is wrong, as a message with its place.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::Json { message } => texts::foreign(message),
            Self::Format { found } => texts::keyframes_format(quoted(found)),
            Self::Version { found } => texts::keyframes_version(*found),
            Self::Interpolation { found } => {
                texts::keyframes_interpolation(quoted(found), Interpolation::names_quoted())
            }
            Self::MsBetweenKeyframes { found } => texts::keyframes_ms(*found),
            Self::ExtraNode { path, scene } => texts::keyframes_extra_node(quoted(path), quoted(scene)),
            Self::MissingNode { path, scene } => texts::keyframes_missing_node(quoted(path), quoted(scene)),
            Self::DuplicateNode { path } => texts::keyframes_duplicate_node(quoted(path)),
            Self::PoseLength { keyframe, found, expected } => {
                texts::keyframes_pose_length(*keyframe, *found, *expected)
            }
            Self::NotFinite { keyframe, path, field } => texts::keyframes_not_finite(*keyframe, quoted(path), *field),
            Self::NotUnit { keyframe, path, length } => texts::keyframes_not_unit(*keyframe, quoted(path), *length),
            Self::NeedsVersion2 { keyframe, field } => texts::keyframes_needs_version_2(*keyframe, *field),
            Self::Duration { keyframe, found } => texts::keyframes_duration(*keyframe, *found),
            Self::Easing { keyframe, found } => texts::keyframes_easing(*keyframe, quoted(found)),
            Self::More { more } => texts::keyframes_more_problems(*more),
        }
    }
}

/// The problems found so far, the first of them in words and the rest as a number.
#[derive(Default)]
pub struct Problems {
    said: Vec<KeyframeFileError>,
    more: usize,
}

impl Problems {
    /// Adds one.
    pub fn push(&mut self, problem: KeyframeFileError) {
        if self.said.len() < MOST_PROBLEMS {
            self.said.push(problem);
        } else {
            self.more += 1;
        }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.said.len() + self.more
    }

    /// The value where nothing is wrong.
    pub fn into_result<T>(mut self, value: T) -> Result<T, Vec<KeyframeFileError>> {
        if self.more > 0 {
            self.said.push(KeyframeFileError::More { more: self.more });
        }
        if self.said.is_empty() { Ok(value) } else { Err(self.said) }
    }
}
