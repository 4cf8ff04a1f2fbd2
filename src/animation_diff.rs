//! The difference of two animations of one scene while they play, node by node.
//!
//! Both are sampled at the same times, each with its own timing. An animation that has ended holds its last pose. Pure functions.

mod versions;

use glam::DQuat;
use num_rational::BigRational;
use num_traits::ToPrimitive as _;

use crate::interpolation::Interpolation;
use crate::keyframe::{PlayRange, SampleError, whole};
use crate::pose::Pose;
use crate::rbt::Rbt;

pub use versions::{Version, keyframe_differences, scene_differences};

/// One side of a comparison: an animation with its timing.
#[derive(Clone, Copy, Debug)]
pub struct Played<'a> {
    /// The played part of the list.
    pub range: &'a PlayRange<'a>,
    /// The interpolation.
    pub interpolation: Interpolation,
    /// Milliseconds between keyframes.
    pub ms_between_keyframes: u32,
}

impl Played<'_> {
    /// The key time at a time in milliseconds from the start; at most the last key time.
    #[must_use]
    pub fn key_time_at(&self, ms: &BigRational) -> f64 {
        self.range.timing().key_time_at(&(ms / whole(self.ms_between_keyframes as usize)))
    }

    /// The playing time, in milliseconds.
    #[must_use]
    pub fn length_ms(&self) -> BigRational {
        self.range.timing().total() * whole(self.ms_between_keyframes as usize)
    }

    /// The pose at a time in milliseconds from the start.
    ///
    /// # Errors
    /// [`SampleError`], as [`PlayRange::pose_at`].
    pub fn pose_at(&self, ms: &BigRational) -> Result<Pose, SampleError> {
        self.range.pose_at(self.key_time_at(ms), self.interpolation)
    }
}

/// The tolerances of a comparison.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerances {
    /// Distance of translations, in scene units.
    pub translation: f64,
    /// Angle between rotations, in degrees.
    pub rotation_degrees: f64,
}

impl Default for Tolerances {
    fn default() -> Self {
        Self { translation: 1e-3, rotation_degrees: 0.1 }
    }
}

impl Tolerances {
    /// A difference in units of the tolerances: that of translations and that of rotations, added.
    #[must_use]
    pub fn weight(&self, units: f64, degrees: f64) -> f64 {
        units / self.translation.max(1e-9) + degrees / self.rotation_degrees.max(1e-9)
    }
}

/// The difference of one node's translation (scene units) or rotation (degrees) over all frames.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deviation {
    /// The largest difference.
    pub largest: f64,
    /// The first animation's key time at which it is largest.
    pub largest_at: f64,
    /// The root mean square over the frames.
    pub rms: f64,
    /// The first animation's key time at which it first exceeds the tolerance, if it does.
    pub exceeds_at: Option<f64>,
}

/// The difference of one node.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NodeDifference {
    /// Of its translation, in scene units.
    pub translation: Deviation,
    /// Of its rotation, in degrees.
    pub rotation: Deviation,
}

/// The difference of two animations.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Each RBT node, in the scene's order.
    pub nodes: Vec<NodeDifference>,
    /// For each frame, the sum over all nodes of translation and rotation differences, each divided by its tolerance.
    pub off_by_frame: Vec<f64>,
}

impl Difference {
    /// Whether no difference exceeds its tolerance.
    #[must_use]
    pub fn is_within(&self) -> bool {
        self.nodes.iter().all(|node| node.translation.exceeds_at.is_none() && node.rotation.exceeds_at.is_none())
    }
}

/// The distance of two translations in scene units, and the angle between two rotations in degrees, from 0 to 180.
#[must_use]
pub fn distances(a: Rbt, b: Rbt) -> (f64, f64) {
    let turn: DQuat = a.rotation.as_dquat() * b.rotation.as_dquat().conjugate();
    let angle = 2.0 * turn.xyz().length().atan2(turn.w.abs());
    (a.translation.as_dvec3().distance(b.translation.as_dvec3()), angle.to_degrees())
}

/// The times at which two animations are compared, in milliseconds from the start: frame k at k · 1000/fps while that is before the end,
/// and the end. `None` if more than `most_frames` frames are before the end.
#[must_use]
pub fn frame_times_ms(length_ms: &BigRational, fps: u32, most_frames: usize) -> Option<Vec<BigRational>> {
    let period = whole(1000) / whole(fps as usize);
    let before_end = (length_ms / &period).ceil().to_integer().to_usize().filter(|&frames| frames <= most_frames)?;
    let mut times: Vec<BigRational> = (0..before_end).map(|frame| whole(frame) * &period).collect();
    times.push(length_ms.clone());
    Some(times)
}

/// Compares two animations at times in milliseconds from the start, at least one.
///
/// # Errors
/// [`SampleError`], as [`PlayRange::pose_at`].
pub fn compare(
    a: Played<'_>,
    b: Played<'_>,
    times_ms: &[BigRational],
    tolerances: Tolerances,
) -> Result<Difference, SampleError> {
    let mut nodes: Vec<NodeDifference> = Vec::new();
    let mut off_by_frame = Vec::with_capacity(times_ms.len());
    for ms in times_ms {
        let (pose_a, pose_b) = (a.pose_at(ms)?, b.pose_at(ms)?);
        nodes.resize(pose_a.len(), NodeDifference::default());
        let key_time = a.key_time_at(ms);
        let mut off = 0.0;
        for (node, (rbt_a, rbt_b)) in nodes.iter_mut().zip(pose_a.iter().zip(pose_b.iter())) {
            let (translation, rotation) = distances(rbt_a, rbt_b);
            node.translation.take(key_time, translation, tolerances.translation);
            node.rotation.take(key_time, rotation, tolerances.rotation_degrees);
            off += tolerances.weight(translation, rotation);
        }
        off_by_frame.push(off);
    }
    for node in &mut nodes {
        for deviation in [&mut node.translation, &mut node.rotation] {
            deviation.rms = (deviation.rms / times_ms.len() as f64).sqrt();
        }
    }
    Ok(Difference { nodes, off_by_frame })
}

impl Deviation {
    /// Adds a frame. `rms` is the sum of squares until all frames are added.
    fn take(&mut self, key_time: f64, off: f64, tolerance: f64) {
        self.rms += off * off;
        if off > self.largest {
            self.largest = off;
            self.largest_at = key_time;
        }
        if off > tolerance && self.exceeds_at.is_none() {
            self.exceeds_at = Some(key_time);
        }
    }
}
