//! Moving keyframes in time, in whole milliseconds: the durations of the intervals around them change.

use super::list::DURATION_RANGE;

/// An end of the stretch of keyframes that a retiming is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StretchEnd {
    /// Its first keyframe.
    Start,
    /// Its last keyframe.
    End,
}

/// How keyframes are moved in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Retiming {
    /// By how many milliseconds; below 0: to an earlier time. Less where an interval would leave [`DURATION_RANGE`].
    pub by_ms: i32,
    /// `None` moves all of them alike. An end moves alone; what lies between the ends moves in proportion.
    pub end: Option<StretchEnd>,
    /// Whether what follows moves along; with the start of a stretch, what comes before.
    pub ripples: bool,
}

/// The intervals' durations after a retiming.
#[derive(Clone, Debug, PartialEq)]
pub struct Retimed {
    /// The duration of each keyframe's interval, in units of the ms between keyframes.
    pub durations: Vec<f64>,
    /// By how many milliseconds the keyframes were moved.
    pub by_ms: i32,
    /// By how many milliseconds keyframe 1 was moved, from which times are counted.
    pub origin_ms: f64,
}

/// Milliseconds are taken as whole if they are this near to a whole number: durations are stored as quotients.
const WHOLE_MS: f64 = 1e-6;

impl Retiming {
    /// Retimes the keyframes at `indices`, which are in order. `durations` are those of all intervals, in units of
    /// `ms_between_keyframes`.
    #[must_use]
    pub fn of(self, durations: &[f64], ms_between_keyframes: u32, indices: &[usize]) -> Retimed {
        let unit = f64::from(ms_between_keyframes);
        let lengths: Vec<f64> = durations.iter().map(|duration| whole_if_near(duration * unit)).collect();
        // Bounds in whole milliseconds: what is moved by whole milliseconds then moves by whole ones at its bounds too.
        let (shortest, longest) =
            ((DURATION_RANGE.start() * unit).ceil().max(1.0), (DURATION_RANGE.end() * unit).floor());
        let (by, moved) = match (self.end, indices) {
            (Some(end), [first, .., last]) => self.stretched(&lengths, (*first, *last), end, (shortest, longest)),
            _ => self.moved(&lengths, indices, (shortest, longest)),
        };
        let mut durations = durations.to_vec();
        for index in 0..durations.len().saturating_sub(1) {
            let change = moved[index + 1] - moved[index];
            if change != 0.0 {
                let length = whole_if_near(lengths[index] + change);
                durations[index] = (length / unit).clamp(*DURATION_RANGE.start(), *DURATION_RANGE.end());
            }
        }
        let origin_ms = moved.get(1).copied().unwrap_or_default();
        #[expect(clippy::cast_possible_truncation, reason = "it is no more than was asked for")]
        let by_ms = by as i32;
        Retimed { durations, by_ms, origin_ms }
    }

    /// How far each keyframe moves if all at `indices` move alike.
    fn moved(self, lengths: &[f64], indices: &[usize], range: (f64, f64)) -> (f64, Vec<f64>) {
        let mut is_moved = vec![false; lengths.len()];
        for &index in indices {
            is_moved[index] = true;
        }
        if let Some(&first) = indices.first().filter(|_| self.ripples) {
            is_moved[first..].fill(true);
        }
        let mut by = f64::from(self.by_ms);
        for (ends, length) in is_moved.windows(2).zip(lengths) {
            by = match ends {
                [false, true] => kept(by, *length, range),
                [true, false] => -kept(-by, *length, range),
                _ => by,
            };
        }
        let moved = is_moved.into_iter().map(|is_moved| if is_moved { by } else { 0.0 }).collect();
        (by, moved)
    }

    /// How far each keyframe moves if one end of a stretch moves.
    fn stretched(
        self,
        lengths: &[f64],
        (first, last): (usize, usize),
        end: StretchEnd,
        range: (f64, f64),
    ) -> (f64, Vec<f64>) {
        let (shortest, _) = range;
        let asked = f64::from(self.by_ms);
        let span: f64 = lengths[first..last].iter().sum();
        #[expect(clippy::cast_precision_loss, reason = "no list has 2^52 keyframes")]
        let least = (last - first) as f64 * shortest;
        // Outwards is longer, whichever end moves.
        let outwards = if end == StretchEnd::End { 1.0 } else { -1.0 };
        let mut longer = (asked * outwards).max((least - span).ceil().min(0.0));
        let outer = match end {
            StretchEnd::Start => first.checked_sub(1),
            StretchEnd::End => (last + 1 < lengths.len()).then_some(last),
        };
        if let Some(outer) = outer.filter(|_| !self.ripples) {
            longer = -kept(-longer, lengths[outer], range);
        }
        let by = longer * outwards;
        let factor = if span > 0.0 { (span + longer) / span } else { 1.0 };
        // Times within the stretch are counted from the end that stays, outwards.
        let mut moved = vec![0.0; lengths.len()];
        let mut before = 0.0;
        let mut after = 0.0_f64;
        let inner: Vec<usize> = match end {
            StretchEnd::End => (first + 1..=last).collect(),
            StretchEnd::Start => (first..last).rev().collect(),
        };
        let count = inner.len();
        for (place, &index) in inner.iter().enumerate() {
            before += lengths[if end == StretchEnd::End { index - 1 } else { index }];
            #[expect(clippy::cast_precision_loss, reason = "no list has 2^52 keyframes")]
            let room_ahead = (count - 1 - place) as f64 * shortest;
            let most = (span + longer - room_ahead).max(after + shortest);
            after = if place + 1 == count {
                span + longer
            } else {
                (before * factor).round().clamp(after + shortest, most)
            };
            moved[index] = (after - before) * outwards;
        }
        if self.ripples {
            match end {
                StretchEnd::Start => moved[..first].fill(by),
                StretchEnd::End => moved[last + 1..].fill(by),
            }
        }
        (by, moved)
    }
}

/// The change of an interval's length that leaves it in the range, in whole milliseconds like the change that is asked for.
fn kept(change: f64, length: f64, (shortest, longest): (f64, f64)) -> f64 {
    let least = (shortest - length).ceil().min(0.0);
    let most = (longest - length).floor().max(0.0);
    change.clamp(least, most)
}

fn whole_if_near(ms: f64) -> f64 {
    if (ms - ms.round()).abs() < WHOLE_MS { ms.round() } else { ms }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(indices: &[usize], retiming: Retiming, expected_ms: &[i32], by_ms: i32) {
        let durations = [1.0, 1.0, 0.5, 2.0, 1.0, 1.0];
        let retimed = retiming.of(&durations, 1000, indices);
        let expected: Vec<f64> = expected_ms.iter().map(|&ms| f64::from(ms) / 1000.0).collect();
        assert_eq!((retimed.durations, retimed.by_ms), (expected, by_ms), "{retiming:?} of {indices:?}");
    }

    const fn by(by_ms: i32) -> Retiming {
        Retiming { by_ms, end: None, ripples: false }
    }

    #[test]
    fn the_interval_after_gives_what_the_one_before_takes() {
        check(&[2], by(117), &[1000, 1117, 383, 2000, 1000, 1000], 117);
        check(&[2, 3], by(117), &[1000, 1117, 500, 1883, 1000, 1000], 117);
        check(&[2, 4], by(-17), &[1000, 983, 517, 1983, 1017, 1000], -17);
        check(&[0], by(-250), &[1250, 1000, 500, 2000, 1000, 1000], -250);
        check(&[5], by(250), &[1000, 1000, 500, 2000, 1250, 1000], 250);
        check(&[], by(250), &[1000, 1000, 500, 2000, 1000, 1000], 250);
    }

    #[test]
    fn neighbours_are_not_reached() {
        check(&[2], by(9000), &[1000, 1499, 1, 2000, 1000, 1000], 499);
        check(&[2], by(-9000), &[1000, 1, 1499, 2000, 1000, 1000], -999);
        check(&[2, 3], by(i32::MIN), &[1000, 1, 500, 2999, 1000, 1000], -999);
    }

    #[test]
    fn what_follows_moves_along() {
        check(&[2], Retiming { ripples: true, ..by(117) }, &[1000, 1117, 500, 2000, 1000, 1000], 117);
        check(&[0], Retiming { ripples: true, ..by(117) }, &[1000, 1000, 500, 2000, 1000, 1000], 117);
    }

    #[test]
    fn ends_of_a_stretch_scale_what_is_between() {
        let end = |by_ms, end, ripples| Retiming { by_ms, end: Some(end), ripples };
        check(&[1, 2, 3], end(750, StretchEnd::End, false), &[1000, 1500, 750, 1250, 1000, 1000], 750);
        check(&[1, 2, 3], end(750, StretchEnd::End, true), &[1000, 1500, 750, 2000, 1000, 1000], 750);
        check(&[1, 2, 3], end(-750, StretchEnd::Start, false), &[250, 1500, 750, 2000, 1000, 1000], -750);
        check(&[1, 2, 3], end(-750, StretchEnd::Start, true), &[1000, 1500, 750, 2000, 1000, 1000], -750);
        check(&[1, 3], end(1, StretchEnd::End, false), &[1000, 1001, 500, 1999, 1000, 1000], 1);
        check(&[1, 2, 3], end(-9000, StretchEnd::End, false), &[1000, 1, 1, 3498, 1000, 1000], -1498);
        check(&[3, 4, 5], end(9000, StretchEnd::Start, false), &[1000, 1000, 3498, 1, 1, 1000], 2998);
    }

    #[test]
    fn times_are_counted_from_keyframe_1() {
        assert_eq!(by(30).of(&[1.0; 4], 1000, &[1]).origin_ms, 30.0);
        assert_eq!(by(30).of(&[1.0; 4], 1000, &[2]).origin_ms, 0.0);
    }

    #[test]
    fn intervals_that_are_no_whole_milliseconds_stay_as_long_in_sum() {
        let retimed = by(7).of(&[1.0, 1.0 / 3.0, 1.0 / 7.0, 1.0], 100, &[2]);
        assert!((retimed.durations[1] + retimed.durations[2] - 1.0 / 3.0 - 1.0 / 7.0).abs() < 1e-12);
        assert!((retimed.durations[1] * 100.0 - 100.0 / 3.0 - 7.0).abs() < 1e-9);
    }
}
