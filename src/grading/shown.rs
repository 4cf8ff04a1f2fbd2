//! Poses from a student's samples for the report's pictures: evenly spread ones, and those with the largest errors.

use std::collections::BTreeMap;

use glam::Quat;

use crate::animation_diff::{Tolerances, distances};
use crate::diagnosis::{Row, Samples};
use crate::interpolation::Interpolation;
use crate::keyframe::{KeyframeList, PlayRange};
use crate::pose::Pose;
use crate::rbt::Rbt;

/// The frames of an animated picture.
pub const FRAMES: usize = 11;
/// The number of moments that are shown beside the reference.
pub const MOMENTS: usize = 2;
/// NaN and infinity count as this many tolerances.
const NOT_FINITE: f64 = 1e6;

/// A pose that was shown. It may hold NaN, and rotations that are not of unit length.
#[derive(Clone, Debug, PartialEq)]
pub struct ShownPose {
    /// The key time at which it was shown.
    pub key_time: f64,
    /// The pose; a node without a sample has its right transform.
    pub pose: Pose,
    /// What should have been shown.
    pub right: Pose,
}

/// The poses of samples that pictures are of.
#[derive(Clone, Debug, PartialEq)]
pub struct ShownPoses {
    /// At most [`FRAMES`], in order of time.
    pub frames: Vec<ShownPose>,
    /// The moments with the largest errors, in order of time; none where all is right.
    pub moments: Vec<ShownPose>,
}

/// Chooses poses of samples: evenly spread ones, and those with the largest errors. `right` are the keyframes whose playback is right;
/// `None` where they cannot be played.
pub fn thinned(
    samples: &Samples,
    interpolation: Interpolation,
    right: &KeyframeList,
    tolerances: Tolerances,
) -> Option<ShownPoses> {
    let shown = Shown::new(&samples.rows, PlayRange::new(right).ok()?, interpolation, tolerances);
    let count = shown.moments.len();
    let frames = count.min(FRAMES);
    let frames = (0..frames).filter_map(|frame| shown.pose(frame * (count - 1) / (frames - 1).max(1))).collect();
    let moments = farthest(&shown.off()?).into_iter().filter_map(|index| shown.pose(index)).collect();
    Some(ShownPoses { frames, moments })
}

/// The poses of at most `most` moments in a row about the one with the largest error. `None` where nothing is off.
pub fn about_the_farthest(
    rows: &[Row],
    range: PlayRange<'_>,
    interpolation: Interpolation,
    tolerances: Tolerances,
    most: usize,
) -> Option<Vec<ShownPose>> {
    let shown = Shown::new(rows, range, interpolation, tolerances);
    let off = shown.off()?;
    let farthest = (0..off.len()).max_by(|a, b| off[*a].total_cmp(&off[*b])).filter(|index| off[*index] > 1.0)?;
    let first = farthest.saturating_sub(most / 2).min(off.len().saturating_sub(most));
    (first..off.len().min(first + most)).map(|index| shown.pose(index)).collect()
}

/// Rows by time, beside what should have been shown.
struct Shown<'a> {
    moments: Vec<(f64, Vec<&'a Row>)>,
    range: PlayRange<'a>,
    interpolation: Interpolation,
    tolerances: Tolerances,
}

impl<'a> Shown<'a> {
    fn new(rows: &'a [Row], range: PlayRange<'a>, interpolation: Interpolation, tolerances: Tolerances) -> Self {
        // Key times are finite and not negative, so their bits order them as their values would.
        let mut by_time: BTreeMap<u64, Vec<&Row>> = BTreeMap::new();
        for row in rows {
            by_time.entry(row.key_time.to_bits()).or_default().push(row);
        }
        let moments = by_time.into_iter().map(|(bits, rows)| (f64::from_bits(bits), rows)).collect();
        Self { moments, range, interpolation, tolerances }
    }

    fn right_at(&self, key_time: f64) -> Option<Pose> {
        let last = self.range.last_key_time() as f64;
        self.range.pose_at(key_time.clamp(0.0, last), self.interpolation).ok()
    }

    /// For each moment, the sum of its errors in tolerances.
    fn off(&self) -> Option<Vec<f64>> {
        let of_moment = |(key_time, rows): &(f64, Vec<&Row>)| {
            let right = self.right_at(*key_time)?;
            let off = |row: &&Row| {
                let shown = rbt(row);
                let (translation, degrees) = distances(shown, right.get(row.node));
                // A rotation that is not of unit length scales what it turns.
                let length = f64::from((shown.rotation.length() - 1.0).abs());
                let off = self.tolerances.weight(translation + length, degrees);
                if off.is_finite() { off.min(NOT_FINITE) } else { NOT_FINITE }
            };
            Some(rows.iter().map(off).sum())
        };
        self.moments.iter().map(of_moment).collect()
    }

    fn pose(&self, index: usize) -> Option<ShownPose> {
        let (key_time, rows) = &self.moments[index];
        let right = self.right_at(*key_time)?;
        let mut pose = right.clone();
        for row in rows {
            pose.set(row.node, rbt(row));
        }
        Some(ShownPose { key_time: *key_time, pose, right })
    }
}

fn rbt(row: &Row) -> Rbt {
    let [w, x, y, z] = row.rotation_wxyz.map(|part| part as f32);
    Rbt { translation: row.translation.as_vec3(), rotation: Quat::from_xyzw(x, y, z, w) }
}

/// The indices of the frames with the largest errors, in order of time: the worst, and the worst of those at least a tenth of all frames
/// away from it. Frames with an error of at most 1 are right and never chosen.
pub fn farthest(off_by_frame: &[f64]) -> Vec<usize> {
    let apart = (off_by_frame.len() / 10).max(1);
    let mut found: Vec<usize> = Vec::new();
    while found.len() < MOMENTS {
        let is_free =
            |index: &usize| found.iter().all(|other| index.abs_diff(*other) >= apart) && off_by_frame[*index] > 1.0;
        let farthest =
            (0..off_by_frame.len()).filter(is_free).max_by(|a, b| off_by_frame[*a].total_cmp(&off_by_frame[*b]));
        let Some(index) = farthest else { break };
        found.push(index);
    }
    found.sort_unstable();
    found
}

#[cfg(test)]
mod tests {
    use super::farthest;

    #[test]
    fn moments_are_apart_and_only_where_something_is_off() {
        assert_eq!(farthest(&[0.0; 20]), [0; 0]);
        let mut off = [0.5; 40];
        off[10..13].copy_from_slice(&[5.0, 9.0, 8.0]);
        off[30] = 2.0;
        assert_eq!(farthest(&off), [11, 30]);
    }
}
