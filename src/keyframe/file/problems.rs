//! The errors in keyframe files.

use thiserror::Error;

use crate::decode::DecodeError;
use crate::interpolation::Interpolation;
use crate::words::{Message, display_by_message, quoted, texts};

/// Every number of a file can be wrong. After this many errors the rest are only counted.
const MOST_PROBLEMS: usize = 100;

/// One error in a keyframe file, with its location.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum KeyframeFileError {
    /// Not JSON of the right shape.
    Json(DecodeError),
    /// `format` names something else.
    Format {
        /// The value in the file.
        found: String,
    },
    /// `version` is not one that this program reads.
    Version {
        /// The value in the file.
        found: u64,
    },
    /// `interpolation` is unknown.
    Interpolation {
        /// The value in the file.
        found: String,
    },
    /// `ms_between_keyframes` is out of range.
    MsBetweenKeyframes {
        /// The value in the file.
        found: f64,
    },
    /// The scene has no such RBT node.
    ExtraNode {
        /// The node's path.
        path: String,
        /// The scene's name.
        scene: String,
    },
    /// An RBT node of the scene is not in `nodes`.
    MissingNode {
        /// The node's path.
        path: String,
        /// The scene's name.
        scene: String,
    },
    /// A path occurs twice in `nodes`.
    DuplicateNode {
        /// The node's path.
        path: String,
    },
    /// A pose and `nodes` have different lengths.
    PoseLength {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The number of entries in the pose.
        found: usize,
        /// The number of entries in `nodes`.
        expected: usize,
    },
    /// A coordinate is out of bounds: [`crate::rbt::LARGEST_COORDINATE`].
    TooFar {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The node's path.
        path: String,
    },
    /// A number of a rotation is beyond single precision.
    NotFinite {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The node's path.
        path: String,
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
        /// The field's name.
        field: &'static str,
    },
    /// A keyframe's duration is out of range.
    Duration {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The value in the file.
        found: f64,
    },
    /// A keyframe's easing is unknown.
    Easing {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The value in the file.
        found: String,
    },
    /// Further errors, which are only counted.
    More {
        /// The number of further errors.
        more: usize,
    },
}

display_by_message!(KeyframeFileError);

impl KeyframeFileError {
    /// The error as a message with its location.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::Json(error) => error.message(),
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
            Self::TooFar { keyframe, path } => {
                texts::keyframes_too_far(*keyframe, quoted(path), texts::SCENE_EXPECTED_COORDINATES)
            }
            Self::NotFinite { keyframe, path } => texts::keyframes_not_finite(*keyframe, quoted(path)),
            Self::NotUnit { keyframe, path, length } => texts::keyframes_not_unit(*keyframe, quoted(path), *length),
            Self::NeedsVersion2 { keyframe, field } => texts::keyframes_needs_version_2(*keyframe, *field),
            Self::Duration { keyframe, found } => texts::keyframes_duration(*keyframe, *found),
            Self::Easing { keyframe, found } => texts::keyframes_easing(*keyframe, quoted(found)),
            Self::More { more } => texts::keyframes_more_problems(*more),
        }
    }
}

/// The errors found so far. The first ones are kept, the rest are counted.
#[derive(Default)]
pub struct Problems {
    said: Vec<KeyframeFileError>,
    more: usize,
}

impl Problems {
    /// Adds an error.
    pub fn push(&mut self, problem: KeyframeFileError) {
        if self.said.len() < MOST_PROBLEMS {
            self.said.push(problem);
        } else {
            self.more += 1;
        }
    }

    /// The number of errors.
    pub fn count(&self) -> usize {
        self.said.len() + self.more
    }

    /// The value if there are no errors.
    pub fn into_result<T>(mut self, value: T) -> Result<T, Vec<KeyframeFileError>> {
        if self.more > 0 {
            self.said.push(KeyframeFileError::More { more: self.more });
        }
        if self.said.is_empty() { Ok(value) } else { Err(self.said) }
    }
}
