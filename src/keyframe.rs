//! Keyframes: the list that hotkeys manage, the pose at a key time, and the file.

mod compare;
mod file;
mod list;
mod sample;

pub use compare::Blend;
pub use file::{
    KeyframeFile, KeyframeFileError, KeyframesJson, LARGEST_FILE_BYTES, keyframes_from_json, keyframes_to_json,
};
pub use list::{Keyframe, KeyframeIndex, KeyframeList};
pub use sample::{PlayRange, SampleError};

/// Milliseconds between keyframes that can be chosen, both ends included.
pub const MS_BETWEEN_KEYFRAMES_RANGE: std::ops::RangeInclusive<u32> = 100..=10_000;

/// Milliseconds between keyframes where nothing else is said.
pub const DEFAULT_MS_BETWEEN_KEYFRAMES: u32 = 2000;
