//! The keyframe file: reading and writing its JSON text.
//!
//! [`fast`] reads the usual form of a file on all cores and gives up on anything else. [`strict`] then reads the file and reports every
//! error.

mod cursor;
mod fast;
mod problems;
mod size;
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
pub use size::file_bytes_at_most;
pub use write::{KeyframesJson, KeyframesText, keyframes_to_json};

/// The largest keyframe file that is read: 1 GiB.
pub const LARGEST_FILE_BYTES: u64 = 1 << 30;

const FORMAT: &str = "inbetween.keyframes";
/// The versions that are read. Version 2 adds names, durations and easings.
const VERSIONS: std::ops::RangeInclusive<u64> = 1..=2;

/// The content of a keyframe file. `None` for optional fields that are missing.
#[derive(Clone, Debug, PartialEq)]
pub struct KeyframeFile {
    /// The interpolation to play with.
    pub interpolation: Option<Interpolation>,
    /// The milliseconds between keyframes to play with.
    pub ms_between_keyframes: Option<u32>,
    /// The keyframes, their poses in the scene's order.
    pub keyframes: Vec<Keyframe>,
}

impl KeyframeFile {
    /// The list, the interpolation and the milliseconds between keyframes, with defaults for missing fields.
    #[must_use]
    pub fn into_parts(self) -> (KeyframeList, Interpolation, u32) {
        (
            KeyframeList::new(self.keyframes),
            self.interpolation.unwrap_or_default(),
            self.ms_between_keyframes.unwrap_or(DEFAULT_MS_BETWEEN_KEYFRAMES),
        )
    }
}

/// Reads a keyframe file for a scene. A byte order mark is skipped.
///
/// # Errors
/// All errors with their locations, in file order; never empty.
pub fn keyframes_from_json(bytes: &[u8], scene: &SceneGraph) -> Result<KeyframeFile, Vec<KeyframeFileError>> {
    let bytes = without_byte_order_mark(bytes);
    fast::read(bytes, scene).map_or_else(|| strict::read(bytes, scene), Ok)
}
