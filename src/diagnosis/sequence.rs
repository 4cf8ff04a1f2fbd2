//! The keyframes to play, and which of them are shown at a key time.

use glam::{DQuat, DVec3};
use thiserror::Error;

use super::rules::Timing;
use crate::keyframe::Keyframe;
use crate::pose::RbtIndex;

/// Key times within this of a whole number are equal to it: they are printed with six decimals.
pub(super) const WHOLE: f64 = 1e-6;

/// The fewest keyframes that can be played.
const FEWEST: usize = 4;

/// There are not enough keyframes to play.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("{found} keyframes cannot be played: the first and the last only steer, so at least 4 are needed")]
pub struct TooFewKeyframes {
    /// The number of keyframes.
    pub found: usize,
}

/// One node's transform in its parent's space.
#[derive(Clone, Copy, Debug)]
pub(super) struct Transform {
    pub translation: DVec3,
    pub rotation: DQuat,
}

/// The keyframes to play, at least 4, in double precision, their rotations of unit length with the stored signs.
#[derive(Clone, Debug)]
pub struct Sequence {
    keyframes: Vec<Vec<Transform>>,
}

impl Sequence {
    /// The keyframes of a list.
    ///
    /// # Errors
    /// [`TooFewKeyframes`]
    pub fn new(keyframes: &[Keyframe]) -> Result<Self, TooFewKeyframes> {
        if keyframes.len() < FEWEST {
            return Err(TooFewKeyframes { found: keyframes.len() });
        }
        let pose = |keyframe: &Keyframe| {
            let rbts = keyframe.pose.iter();
            rbts.map(|rbt| Transform {
                translation: rbt.translation.as_dvec3(),
                rotation: rbt.rotation.as_dquat().normalize(),
            })
            .collect()
        };
        Ok(Self { keyframes: keyframes.iter().map(pose).collect() })
    }

    /// The key time of the last played keyframe: n − 1.
    #[must_use]
    pub fn last_key_time(&self) -> f64 {
        (self.keyframes.len() - 3) as f64
    }

    /// The number of RBT nodes.
    pub(super) fn nodes(&self) -> usize {
        self.keyframes[0].len()
    }

    /// The number of keyframes.
    pub(super) fn keyframes(&self) -> usize {
        self.keyframes.len()
    }

    /// A sequence of one node alone, after a change of its transforms by the index of the keyframe.
    pub(super) fn of_node(&self, node: RbtIndex, change: impl Fn(usize, &mut Transform)) -> Self {
        let changed = |(index, pose): (usize, &Vec<Transform>)| {
            let mut transform = pose[node.get()];
            change(index, &mut transform);
            vec![transform]
        };
        Self { keyframes: self.keyframes.iter().enumerate().map(changed).collect() }
    }

    /// One node of a keyframe. The index is clamped to the list.
    pub(super) fn at(&self, index: isize, node: RbtIndex) -> &Transform {
        let last = self.keyframes.len() as isize - 1;
        &self.keyframes[index.clamp(0, last) as usize][node.get()]
    }

    /// What a program may show at a key time. One that does not show its end stays at the key time `last_before_end`.
    ///
    /// At a whole key time that may be the end of one interval, the start of the next or the keyframe itself: a mistake can make them
    /// differ. After the end a program shows its last pose.
    pub(super) fn moments(
        &self,
        timing: &Timing,
        key_time: f64,
        last_before_end: f64,
        is_spline: bool,
    ) -> impl Iterator<Item = Moment> + use<> {
        let is_late = !timing.shows_end && key_time > self.last_key_time() - WHOLE;
        let key_time = if is_late { last_before_end } else { key_time };
        let first = timing.first_keyframe as f64;
        // A program that plays one end of the list plays the other end too.
        let last = (self.keyframes.len() - if timing.first_keyframe == 1 { 2 } else { 1 }) as f64;
        let position = (key_time * timing.pace + first).clamp(first, last);
        let whole = position.round();
        let between = |start: f64| Moment::Between { start: start as isize, alpha: position - start };
        let moments = if (position - whole).abs() < WHOLE {
            // A spline that starts at the end has no keyframe after it; a linear blend needs none.
            let follows = !(whole > last - WHOLE && is_spline);
            [
                Some(Moment::Keyframe(whole as isize)),
                follows.then(|| between(whole)),
                (whole > first).then(|| between(whole - 1.0)),
            ]
        } else {
            [Some(between(position.floor())), None, None]
        };
        moments.into_iter().flatten()
    }
}

/// What is shown: a keyframe, or a blend.
#[derive(Clone, Copy, Debug)]
pub(super) enum Moment {
    /// The keyframe of an index.
    Keyframe(isize),
    /// Between the keyframe of the index `start` and the next.
    Between {
        /// The index; the keyframes about it are clamped to the list.
        start: isize,
        /// The fraction, from 0 to 1.
        alpha: f64,
    },
}
