//! What can be wrong with a keyframe file.

use thiserror::Error;

use crate::interpolation::Interpolation;

/// A file can be wrong in each of its numbers: after so many problems the rest are only counted.
const MOST_PROBLEMS: usize = 100;

/// One thing that is wrong with a keyframe file: a sentence with its place.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum KeyframeFileError {
    /// Not JSON of the right shape; the message ends with line and column.
    #[error("{message}")]
    Json {
        /// What is wrong, with line and column.
        message: String,
    },
    /// `format` names something else.
    #[error("format is {found:?}, expected \"inbetween.keyframes\"")]
    Format {
        /// What the file says.
        found: String,
    },
    /// `version` is not one that this program reads.
    #[error("version is {found}, and this program reads versions 1 and 2")]
    Version {
        /// What the file says.
        found: u64,
    },
    /// `interpolation` is unknown.
    #[error("interpolation is {found:?}, expected {}", Interpolation::names_quoted())]
    Interpolation {
        /// What the file says.
        found: String,
    },
    /// `ms_between_keyframes` is out of range.
    #[error("ms_between_keyframes is {found}, expected a whole number from 100 to 10000")]
    MsBetweenKeyframes {
        /// What the file says.
        found: f64,
    },
    /// The scene has no such RBT node.
    #[error("node {path:?} is not in the scene {scene:?}")]
    ExtraNode {
        /// The path.
        path: String,
        /// The scene's name.
        scene: String,
    },
    /// An RBT node of the scene is not in `nodes`.
    #[error("node {path:?} of the scene {scene:?} is missing in nodes")]
    MissingNode {
        /// The path.
        path: String,
        /// The scene's name.
        scene: String,
    },
    /// A path stands twice.
    #[error("node {path:?} stands twice in nodes")]
    DuplicateNode {
        /// The path.
        path: String,
    },
    /// A pose and `nodes` are not of one length.
    #[error("keyframe {keyframe}: pose has {found} entries, expected {expected}, one for each of nodes")]
    PoseLength {
        /// The keyframe, from 0.
        keyframe: usize,
        /// How many entries there are.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// A number cannot be held.
    #[error("keyframe {keyframe}, node {path:?}: {field} is not finite")]
    NotFinite {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The node's path.
        path: String,
        /// `translation` or `rotation`.
        field: &'static str,
    },
    /// A rotation is not a unit quaternion.
    #[error("keyframe {keyframe}, node {path:?}: rotation has length {length}, expected 1")]
    NotUnit {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The node's path.
        path: String,
        /// The rotation's length.
        length: f32,
    },
    /// A field of version 2 in a file of version 1.
    #[error("keyframe {keyframe}: {field} needs version 2, and the file says version 1")]
    NeedsVersion2 {
        /// The keyframe, from 0.
        keyframe: usize,
        /// Which field.
        field: &'static str,
    },
    /// A keyframe's interval is of no length that can play.
    #[error("keyframe {keyframe}: duration is {found}, expected a number from 0.001 to 1000")]
    Duration {
        /// The keyframe, from 0.
        keyframe: usize,
        /// What the file says.
        found: f64,
    },
    /// A keyframe's easing is unknown.
    #[error(
        "keyframe {keyframe}: easing is {found:?}, expected linear, hold, or sine, quad, cubic, back, bounce or elastic with -in, -out or -in-out"
    )]
    Easing {
        /// The keyframe, from 0.
        keyframe: usize,
        /// What the file says.
        found: String,
    },
    /// More is wrong than is worth saying.
    #[error("and {more} more problems")]
    More {
        /// How many more.
        more: usize,
    },
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
