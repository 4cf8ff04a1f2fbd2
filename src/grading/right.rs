//! The playback that samples should show.

use glam::{DQuat, DVec3};

use super::off::{Off, Printed};
use super::rubric::{Credit, Rubric};
use crate::animation_diff::{Tolerances, distances};
use crate::diagnosis::{Sequence, right_rotations};
use crate::interpolation::Interpolation;
use crate::keyframe::{KeyframeList, PlayRange};
use crate::pose::RbtIndex;
use crate::rbt::Rbt;

/// Key times this near are the same: they are printed with six decimals. At a whole key time, what is right just before it is right too.
pub const SAME_TIME: f64 = 1.5e-6;

/// Keyframes whose playback is right.
#[derive(Clone, Debug)]
pub struct Right<'a> {
    /// The keyframes.
    pub list: &'a KeyframeList,
    /// The played part of them.
    pub range: PlayRange<'a>,
    /// The same, for diagnoses.
    pub sequence: Sequence,
    /// Milliseconds between them.
    pub ms_between_keyframes: u32,
    /// Whether they are the submission's own, and not the reference.
    pub is_own: bool,
}

impl<'a> Right<'a> {
    /// The rubric's reference.
    pub fn reference(rubric: &'a Rubric) -> Option<Self> {
        let reference = rubric.reference.as_ref()?;
        Self::new(&reference.list, reference.ms_between_keyframes, false).ok()
    }

    /// Keyframes of a submission.
    ///
    /// # Errors
    /// They are too few to play: a sentence.
    pub fn own(list: &'a KeyframeList, ms_between_keyframes: u32) -> Result<Self, String> {
        Self::new(list, ms_between_keyframes, true)
    }

    fn new(list: &'a KeyframeList, ms_between_keyframes: u32, is_own: bool) -> Result<Self, String> {
        let range = PlayRange::new(list).map_err(|error| error.to_string())?;
        let sequence = Sequence::new(list.as_slice()).map_err(|error| error.to_string())?;
        Ok(Self { list, range, sequence, ms_between_keyframes, is_own })
    }

    /// Whether the same is shown at each key time, and in each millisecond.
    pub fn plays_like(&self, other: &Self) -> bool {
        let poses = |right: &Self| right.list.as_slice().iter().map(|keyframe| keyframe.pose.clone());
        self.ms_between_keyframes == other.ms_between_keyframes && poses(self).eq(poses(other))
    }

    /// The last key time.
    pub fn end(&self) -> f64 {
        self.range.last_key_time() as f64
    }

    /// How far a printed sample is off. Its key time may be off by its rounding; of the ways that a half turn may go, the nearest counts.
    pub fn off(&self, printed: Printed<'_>, interpolation: Interpolation, credit: &Credit) -> Off {
        let (row, end) = (printed.row, self.end());
        let at = |time: f64| self.range.node_at(time, interpolation, row.node);
        let exact = printed.off(&[doubles(at(row.key_time.min(end)))]);
        let is_within = |off: &Off| off.parts_within(credit) == [true; 2];
        if is_within(&exact) || exact.fault.is_some() {
            return exact;
        }
        let error = row.key_time_error.max(SAME_TIME);
        let times = [-error, 0.0, error].map(|error| (row.key_time + error).clamp(0.0, end));
        let way = times.map(|time| doubles(at(time)));
        let near = exact.nearer(printed.off(&way));
        if is_within(&near) {
            return near;
        }
        let turns = times.map(|time| self.turns(time, interpolation, row.node));
        if turns.iter().all(|turns| turns.len() == 1) {
            return near;
        }
        let ways = (0..turns.iter().map(Vec::len).max().unwrap_or(0)).map(|way_index| {
            let turn = |time: usize| turns[time].get(way_index).copied().unwrap_or(way[time].1);
            printed.off(&[0, 1, 2].map(|time| (way[time].0, turn(time))))
        });
        ways.fold(near, Off::nearer)
    }

    /// How far a printed sample is from a keyframe.
    pub fn off_keyframe(&self, printed: Printed<'_>, keyframe: usize) -> Off {
        printed.off(&[doubles(self.list.as_slice()[keyframe].pose.get(printed.row.node))])
    }

    /// Every rotation that a node may have at a key time.
    fn turns(&self, key_time: f64, interpolation: Interpolation, node: RbtIndex) -> Vec<DQuat> {
        let (start, alpha) = self.range.interval_at(key_time);
        right_rotations(&self.sequence, (start.get(), f64::from(alpha)), node, interpolation)
    }

    /// Whether any translation changes beyond the tolerances from one played keyframe to the next, and whether any rotation does.
    pub fn moves(&self, tolerances: Tolerances) -> [bool; 2] {
        let played = &self.list.as_slice()[1..self.list.len() - 1];
        let mut moves = [false; 2];
        for pair in played.windows(2) {
            for (from, to) in pair[0].pose.iter().zip(pair[1].pose.iter()) {
                let (units, degrees) = distances(from, to);
                moves[0] |= units > tolerances.translation;
                moves[1] |= degrees > tolerances.rotation_degrees;
            }
        }
        moves
    }
}

fn doubles(rbt: Rbt) -> (DVec3, DQuat) {
    (rbt.translation.as_dvec3(), rbt.rotation.as_dquat().normalize())
}
