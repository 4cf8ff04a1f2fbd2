//! Keyframes: the list, the pose at a key time, and the file format.

mod animation;
mod easing;
mod file;
mod list;
mod other_blends;
mod retiming;
mod sample;
mod timing;

pub use animation::Animation;
pub use easing::{Curve, Easing, Ends};
pub use file::{
    KeyframeFile, KeyframeFileError, KeyframesJson, KeyframesText, LARGEST_FILE_BYTES, file_bytes_at_most,
    keyframes_from_json, keyframes_to_json,
};
pub use list::{DURATION_RANGE, Keyframe, KeyframeIndex, KeyframeList};
pub use other_blends::Blend;
pub use retiming::{Retimed, Retiming, StretchEnd};
pub use sample::{PlayRange, SampleError};
pub use timing::{Timing, to_f64, whole};

/// The allowed milliseconds between keyframes, both ends included.
pub const MS_BETWEEN_KEYFRAMES_RANGE: std::ops::RangeInclusive<u32> = 100..=10_000;

/// The default milliseconds between keyframes.
pub const DEFAULT_MS_BETWEEN_KEYFRAMES: u32 = 2000;
