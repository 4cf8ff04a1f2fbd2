//! The times of keyframes, and the range that is in sight. Lookups use binary search, so their cost hardly depends on the list's length.

use std::ops::{Range, RangeInclusive};

use crate::keyframe::{Keyframe, KeyframeList};

/// The times of a list's keyframes, in units of the ms between keyframes from the first played keyframe.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Columns {
    list: KeyframeList,
    times: Vec<f64>,
    /// The times of the first and the last timed key.
    keys: Option<(f64, f64)>,
}

impl Columns {
    /// Takes in a list. Costs nothing where it holds the same keyframes as before. Says whether it is another list altogether, as after an
    /// import: its ends are not in the old one.
    pub fn update(&mut self, list: &KeyframeList) -> bool {
        if self.times.len() == list.len() && self.list.same_keyframes(list) {
            return false;
        }
        let old = self.list.as_slice();
        let is_old = |keyframe: &Keyframe| old.iter().any(|other| other.pose.shares_with(&keyframe.pose));
        let is_replaced = ![list.as_slice().first(), list.as_slice().last()].into_iter().flatten().any(is_old);
        self.list = list.clone();
        self.times.clear();
        let keyframes = list.as_slice();
        let mut time = -keyframes.first().map_or(0.0, |keyframe| keyframe.duration);
        for keyframe in keyframes {
            self.times.push(time);
            // The first played keyframe is where times are counted from, to the bit.
            time = if self.times.len() == 1 { 0.0 } else { time + keyframe.duration };
        }
        is_replaced && !list.is_empty()
    }

    /// Sets the times of the first and the last timed key.
    pub const fn set_keys(&mut self, keys: Option<(f64, f64)>) {
        self.keys = keys;
    }

    /// The keyframes themselves.
    #[must_use]
    pub fn keyframes(&self) -> &[Keyframe] {
        self.list.as_slice()
    }

    /// How many keyframes there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.times.len()
    }

    /// When a keyframe of the list is reached.
    #[must_use]
    pub fn time(&self, index: usize) -> f64 {
        self.times.get(index).copied().unwrap_or_default()
    }

    /// When the keyframe after one is reached; for the last one, when it is itself.
    #[must_use]
    pub fn time_after(&self, index: usize) -> f64 {
        self.times.get(index + 1).copied().unwrap_or_else(|| self.time(index))
    }

    /// The first and the last time of keyframes; of an empty list those of all else.
    #[must_use]
    pub fn ends(&self) -> (f64, f64) {
        match (self.times.first(), self.times.last()) {
            (Some(&first), Some(&last)) => (first, last),
            _ => self.all(),
        }
    }

    /// The first and the last time of anything; of nothing a unit.
    #[must_use]
    pub fn all(&self) -> (f64, f64) {
        let of_keyframes = self.times.first().copied().zip(self.times.last().copied());
        match (of_keyframes, self.keys) {
            (Some((first, last)), Some((first_key, last_key))) => (first.min(first_key), last.max(last_key)),
            (Some(ends), None) => ends,
            (None, Some((first, last))) => (first.min(0.0), last.max(first.min(0.0) + 1.0)),
            (None, None) => (0.0, 1.0),
        }
    }

    /// When a key time is reached.
    #[must_use]
    pub fn time_of_key(&self, key_time: f64) -> f64 {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "floats saturate")]
        let index = (key_time.max(0.0).floor() as usize + 1).min(self.len().saturating_sub(1));
        let from = self.time(index);
        let to = self.times.get(index + 1).copied().unwrap_or(from);
        from + (to - from) * key_time.fract()
    }

    /// The key time that is shown at a time, kept within what can be played.
    #[must_use]
    pub fn key_at(&self, time: f64) -> f64 {
        let Some(last) = self.len().checked_sub(2).filter(|&last| last > 1) else { return 0.0 };
        let time = time.clamp(self.time(1), self.time(last));
        let index = self.insertion(time).clamp(2, last) - 1;
        let (from, to) = (self.time(index), self.time(index + 1));
        let fraction = if to > from { ((time - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 };
        #[expect(clippy::cast_precision_loss, reason = "no list has 2^52 keyframes")]
        let before = (index - 1) as f64;
        before + fraction
    }

    /// The keyframes of a stretch of time.
    #[must_use]
    pub fn within(&self, times: &RangeInclusive<f64>) -> Range<usize> {
        let start = self.times.partition_point(|time| time < times.start());
        let end = self.times.partition_point(|time| time <= times.end());
        start..end.max(start)
    }

    /// The index at which a keyframe with this time would be inserted.
    #[must_use]
    pub fn insertion(&self, time: f64) -> usize {
        self.times.partition_point(|&own| own <= time)
    }

    /// The keyframe that is reached nearest to a time.
    #[must_use]
    pub fn nearest(&self, time: f64) -> Option<usize> {
        let after = self.insertion(time);
        let distance = |index: &usize| (self.time(*index) - time).abs();
        [after.checked_sub(1), (after < self.len()).then_some(after)]
            .into_iter()
            .flatten()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }

    /// The keyframes of a time range, grouped by steps of length `step`. The number of groups is bounded by the number of
    /// steps, not by the length of the list.
    pub fn groups(&self, times: RangeInclusive<f64>, step: f64) -> impl Iterator<Item = Range<usize>> + '_ {
        let within = self.within(&times);
        let mut next = within.start;
        std::iter::from_fn(move || {
            if next >= within.end {
                return None;
            }
            let start = next;
            let bucket_end = ((self.times[start] / step).floor() + 1.0) * step;
            let rest = &self.times[start + 1..within.end];
            // Usually a group has one keyframe. Check that before searching.
            let together = match rest.first() {
                Some(&time) if time < bucket_end => rest.partition_point(|&time| time < bucket_end),
                _ => 0,
            };
            next = start + 1 + together;
            Some(start..next)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keyframe::{Timing, to_f64};
    use crate::pose::Pose;

    fn columns(durations: &[f64]) -> (Columns, KeyframeList) {
        let keyframe = |&duration: &f64| Keyframe { duration, ..Keyframe::new(Pose::new(Vec::new())) };
        let list = KeyframeList::new(durations.iter().map(keyframe).collect());
        let mut columns = Columns::default();
        columns.update(&list);
        (columns, list)
    }

    #[test]
    fn times_are_those_of_playing() {
        let (columns, list) = columns(&[3.0, 2.0, 0.5, 1.25, 7.0, 1.0]);
        assert_eq!(columns.time(0), -3.0);
        let timing = Timing::of(list.as_slice()).unwrap();
        for played in 0..4 {
            assert_eq!(columns.time(played + 1), to_f64(&timing.at_keyframe(played)));
        }
        for key_time in [0.0, 0.5, 1.0, 1.75, 2.999, 3.0] {
            assert!((columns.time_of_key(key_time) - to_f64(&timing.elapsed_at(key_time))).abs() < 1e-12);
            assert!((columns.key_at(columns.time_of_key(key_time)) - key_time).abs() < 1e-12, "{key_time}");
        }
        assert_eq!((columns.key_at(-2.0), columns.key_at(99.0)), (0.0, 3.0));
    }

    #[test]
    fn only_what_is_in_sight_is_found() {
        let (columns, _) = columns(&vec![1.0; 10_000]);
        assert_eq!(columns.within(&(99.5..=103.0)), 101..105);
        assert_eq!(columns.within(&(-9.0..=-2.0)), 0..0);
        assert_eq!(columns.nearest(41.4), Some(42));
        assert_eq!(columns.nearest(1e9), Some(9999));
        assert_eq!(columns.insertion(0.5), 2);
    }

    #[test]
    fn groups_hold_every_keyframe_once() {
        let (columns, _) = columns(&[1.0; 1000]);
        for step in [0.1, 1.0, 2.5, 60.0] {
            let groups: Vec<_> = columns.groups(-1.0..=998.0, step).collect();
            assert!(groups.len() as f64 <= (1000.0 / step).ceil() + 1.0);
            let all: Vec<usize> = groups.into_iter().flatten().collect();
            assert_eq!(all, (0..1000).collect::<Vec<_>>(), "steps of {step}");
        }
    }

    #[test]
    fn short_lists_have_times_too() {
        for count in 0..4 {
            let (columns, _) = columns(&vec![1.0; count]);
            assert_eq!(columns.len(), count);
            assert_eq!(columns.key_at(0.5), 0.0);
        }
    }
}
