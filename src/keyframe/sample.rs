//! Sampling: the pose at a key time.
//!
//! `key_time` counts played keyframes: with N keyframes in the list, N ≥ 4, n = N − 2 are played, and key time 0 is keyframe 1 of the
//! list. The first and the last keyframe of the list only steer the spline.

use thiserror::Error;

use super::list::{KeyframeIndex, KeyframeList};
use super::timing::Timing;
use crate::blend::{self, Curves};
use crate::interpolation::{ControlPoints, Interpolation, bezier_rbt, linear_rbt};
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;
use crate::words::{Message, display_by_message, texts};

/// Why there is no pose at a key time.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SampleError {
    /// The list is too short.
    TooFewKeyframes {
        /// The number of keyframes.
        keyframes: usize,
    },
    /// The key time is before the first or after the last played keyframe, or NaN.
    OutOfRange {
        /// The requested key time.
        key_time: f64,
        /// The last valid key time.
        last_key_time: usize,
    },
}

display_by_message!(SampleError);

impl SampleError {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::TooFewKeyframes { keyframes } => texts::keyframes_too_few(texts::count_keyframes(*keyframes)),
            Self::OutOfRange { key_time, last_key_time } => texts::keyframes_out_of_range(*key_time, *last_key_time),
        }
    }
}

/// A list that is long enough to play. Gives poses at key times.
///
/// ```
/// use glam::Vec3;
/// use inbetween::interpolation::Interpolation;
/// use inbetween::keyframe::{Keyframe, KeyframeList, PlayRange};
/// use inbetween::pose::{Pose, RbtIndex};
/// use inbetween::rbt::Rbt;
///
/// let at_x = |x: f32| Keyframe::new(Pose::new(vec![Rbt::from_translation(Vec3::X * x)]));
/// let list = KeyframeList::new([0.0, 1.0, 3.0, 4.0].map(at_x).to_vec());
/// let range = PlayRange::new(&list)?;
/// // Key time 0 is keyframe 1: the first and the last only steer.
/// let half_way = range.pose_at(0.5, Interpolation::Linear)?;
/// assert_eq!(half_way.get(RbtIndex::new(0)).translation, Vec3::X * 2.0);
/// # Ok::<(), inbetween::keyframe::SampleError>(())
/// ```
#[derive(Clone, Debug)]
pub struct PlayRange<'a> {
    keyframes: &'a KeyframeList,
    timing: &'a Timing,
}

impl<'a> PlayRange<'a> {
    /// The played part of a list.
    ///
    /// # Errors
    /// [`SampleError::TooFewKeyframes`] below 4 keyframes.
    pub fn new(keyframes: &'a KeyframeList) -> Result<Self, SampleError> {
        match keyframes.timing() {
            Some(timing) => Ok(Self { keyframes, timing }),
            None => Err(SampleError::TooFewKeyframes { keyframes: keyframes.len() }),
        }
    }

    /// When each played keyframe is reached.
    #[must_use]
    pub const fn timing(&self) -> &'a Timing {
        self.timing
    }

    /// The key time of the last played keyframe: n − 1, at least 1.
    #[must_use]
    pub fn last_key_time(&self) -> usize {
        self.keyframes.len() - 3
    }

    /// The keyframe of the list where playback ends: N − 2.
    #[must_use]
    pub fn last_keyframe(&self) -> KeyframeIndex {
        KeyframeIndex::new(self.keyframes.len() - 2)
    }

    /// Checks that there is a pose at a key time, without computing it.
    ///
    /// # Errors
    /// [`SampleError::OutOfRange`] outside of [0, n − 1].
    pub fn check(&self, key_time: f64) -> Result<(), SampleError> {
        let last_key_time = self.last_key_time();
        #[expect(clippy::cast_precision_loss, reason = "no list has 2^52 keyframes")]
        if (0.0..=last_key_time as f64).contains(&key_time) {
            Ok(())
        } else {
            Err(SampleError::OutOfRange { key_time, last_key_time })
        }
    }

    /// The pose at a key time in [0, n − 1], within 3e-7 radians of [`crate::interpolation::linear_rbt`] and 5e-7 of
    /// [`crate::interpolation::bezier_rbt`] in exact arithmetic (on old processors 3.5e-7: [`crate::blend`]); at whole key times the
    /// keyframe itself, to the bit.
    ///
    /// # Errors
    /// [`SampleError::OutOfRange`] outside of that range.
    pub fn pose_at(&self, key_time: f64, interpolation: Interpolation) -> Result<Pose, SampleError> {
        let mut pose = Pose::identity(0);
        self.pose_into(key_time, interpolation, &mut pose)?;
        Ok(pose)
    }

    /// Like [`PlayRange::pose_at`], but reuses the storage of `into` if nothing shares it.
    ///
    /// # Errors
    /// [`SampleError::OutOfRange`]; `into` is then unchanged.
    pub fn pose_into(&self, key_time: f64, interpolation: Interpolation, into: &mut Pose) -> Result<(), SampleError> {
        self.check(key_time)?;
        let (start, alpha) = self.interval_at(key_time);
        self.blend(start, alpha, interpolation, into);
        Ok(())
    }

    /// The keyframe of the list where the interval around a key time begins, and the eased fraction of the interval. The key time is
    /// clamped to the range.
    #[must_use]
    pub fn interval_at(&self, key_time: f64) -> (KeyframeIndex, f32) {
        #[expect(clippy::cast_precision_loss, reason = "no list has 2^52 keyframes")]
        let key_time = key_time.clamp(0.0, self.last_key_time() as f64);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it lies in the list")]
        let start = key_time.floor() as usize + 1;
        #[expect(clippy::cast_possible_truncation, reason = "the fraction of a key time needs no more than f32")]
        let alpha = self.keyframes.as_slice()[start].easing.value(key_time.fract()) as f32;
        (KeyframeIndex::new(start), alpha)
    }

    /// One node's `parent_from_node` at a key time, which is clamped to [0, n − 1].
    #[must_use]
    pub fn node_at(&self, key_time: f64, interpolation: Interpolation, rbt: RbtIndex) -> Rbt {
        let (start, alpha) = self.interval_at(key_time);
        if alpha == 0.0 {
            return self.keyframes.as_slice()[start.get()].pose.get(rbt);
        }
        self.rbt_at(start, alpha, interpolation, rbt)
    }

    /// The two ends of an interval for one node. `start` may be the last played keyframe.
    pub(super) fn ends(&self, start: KeyframeIndex, rbt: RbtIndex) -> (Rbt, Rbt) {
        let (list, start) = (self.keyframes.as_slice(), start.get());
        (list[start].pose.get(rbt), list[start + 1].pose.get(rbt))
    }

    /// How long the interval that begins at keyframe `start` of the list lasts, in units of the time between keyframes.
    pub(super) fn duration(&self, start: KeyframeIndex) -> f64 {
        self.keyframes.as_slice()[start.get()].duration
    }

    /// One node's `parent_from_node` at the fraction `alpha` of the played interval that begins at keyframe `start` of the list,
    /// 1 ≤ start ≤ N − 2.
    #[must_use]
    pub fn rbt_at(&self, start: KeyframeIndex, alpha: f32, interpolation: Interpolation, rbt: RbtIndex) -> Rbt {
        let (from, to) = self.ends(start, rbt);
        if alpha == 0.0 {
            return from;
        }
        match interpolation {
            Interpolation::Linear => linear_rbt(from, to, alpha),
            Interpolation::CatmullRom => {
                let ControlPoints { after_start, before_end } = self.keyframes.control_points(start);
                let inner = ControlPoints { after_start: after_start.get(rbt), before_end: before_end.get(rbt) };
                bezier_rbt(from, inner, to, alpha)
            }
        }
    }

    /// Makes `into` the pose at the fraction `alpha` of the interval that begins at keyframe `start` of the list.
    fn blend(&self, start: KeyframeIndex, alpha: f32, interpolation: Interpolation, into: &mut Pose) {
        let list = self.keyframes.as_slice();
        let from = &list[start.get()].pose;
        if alpha == 0.0 {
            into.clone_from(from);
            return;
        }
        let to = &list[start.get() + 1].pose;
        if alpha == 1.0 {
            into.clone_from(to);
            return;
        }
        let (level, weights) = (blend::widest(), blend::Weights::at(alpha));
        into.fill(from.len(), |blocks| match interpolation {
            Interpolation::Linear => blend::linear(level, &weights, from.blocks(), to.blocks(), blocks),
            Interpolation::CatmullRom => {
                let ControlPoints { after_start, before_end } = self.keyframes.control_points(start);
                let curves = Curves {
                    start: from.blocks(),
                    after_start: after_start.blocks(),
                    before_end: before_end.blocks(),
                    end: to.blocks(),
                };
                blend::bezier(level, &weights, curves, blocks);
            }
        });
    }
}
