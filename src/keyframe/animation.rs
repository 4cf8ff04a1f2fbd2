//! An animation: keyframes and how they play.

use super::KeyframeList;
use crate::interpolation::Interpolation;

/// Keyframes with what it takes to play them.
#[derive(Clone, Debug)]
pub struct Animation {
    /// The keyframes.
    pub keyframes: KeyframeList,
    /// How to interpolate between them.
    pub interpolation: Interpolation,
    /// Milliseconds from one to the next.
    pub ms_between_keyframes: u32,
}
