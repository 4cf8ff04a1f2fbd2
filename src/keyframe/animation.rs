//! An animation: keyframes and how they play.

use super::KeyframeList;
use crate::interpolation::Interpolation;

/// Keyframes with the settings that play them.
#[derive(Clone, Debug, PartialEq)]
pub struct Animation {
    /// The keyframes.
    pub keyframes: KeyframeList,
    /// The interpolation between keyframes.
    pub interpolation: Interpolation,
    /// Milliseconds from one to the next.
    pub ms_between_keyframes: u32,
}
