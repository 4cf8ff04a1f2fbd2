//! The keyframe file: JSON text to a list and back, to the byte.
//!
//! [`strict`] reads any file and says everything that is wrong with one; [`fast`] reads what usually stands in one, on all cores, and
//! leaves the rest to it.

mod cursor;
mod fast;
mod problems;
mod strict;
#[cfg(test)]
mod tests;
mod too_large;
mod write;

use super::DEFAULT_MS_BETWEEN_KEYFRAMES;
use super::list::{Keyframe, KeyframeList};
use crate::interpolation::Interpolation;
use crate::scene::SceneGraph;
use crate::text::without_byte_order_mark;

pub use problems::KeyframeFileError;
pub use write::{KeyframesJson, KeyframesText, keyframes_to_json};

/// The largest keyframe file that is read: 1 GiB.
pub const LARGEST_FILE_BYTES: u64 = 1 << 30;

const FORMAT: &str = "inbetween.keyframes";
/// What a file says whose keyframes are poses and nothing else, and what one says that has names, durations or easings.
const VERSIONS: std::ops::RangeInclusive<u64> = 1..=2;

/// What a keyframe file holds. `None` where it does not say.
#[derive(Clone, Debug, PartialEq)]
pub struct KeyframeFile {
    /// The interpolation to put in force.
    pub interpolation: Option<Interpolation>,
    /// The milliseconds between keyframes to put in force.
    pub ms_between_keyframes: Option<u32>,
    /// The keyframes, their poses in the scene's order.
    pub keyframes: Vec<Keyframe>,
}

impl KeyframeFile {
    /// The list, the interpolation and the milliseconds between keyframes, with defaults where the file does not say.
    #[must_use]
    pub fn into_parts(self) -> (KeyframeList, Interpolation, u32) {
        (
            KeyframeList::new(self.keyframes),
            self.interpolation.unwrap_or_default(),
            self.ms_between_keyframes.unwrap_or(DEFAULT_MS_BETWEEN_KEYFRAMES),
        )
    }
}

/// Reads a keyframe file for a scene. A byte order mark is passed over.
///
/// # Errors
/// Everything that is wrong, each with its place, in the file's order: never empty.
pub fn keyframes_from_json(bytes: &[u8], scene: &SceneGraph) -> Result<KeyframeFile, Vec<KeyframeFileError>> {
    let bytes = without_byte_order_mark(bytes);
    fast::read(bytes, scene).map_or_else(|| strict::read(bytes, scene), Ok)
}
