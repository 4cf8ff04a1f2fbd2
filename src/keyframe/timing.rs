//! Playing time: the exact durations of the intervals between keyframes.
//!
//! Elapsed time is counted in units of the ms between keyframes, from the first played keyframe. `key_time` counts keyframes. The two are
//! equal if every interval lasts one unit.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{FromPrimitive as _, One as _, ToPrimitive as _, Zero as _};

use super::list::Keyframe;

/// When each played keyframe is reached.
#[derive(Clone, Debug, PartialEq)]
pub struct Timing {
    intervals: usize,
    /// The elapsed time at each played keyframe except the first; `None` if every interval lasts one unit.
    ends: Option<Vec<BigRational>>,
}

impl Timing {
    /// The timing of a list of at least 4 keyframes; shorter ones have none.
    #[must_use]
    pub fn of(keyframes: &[Keyframe]) -> Option<Self> {
        let intervals = keyframes.len().checked_sub(3).filter(|&intervals| intervals > 0)?;
        let played = &keyframes[1..=intervals];
        if played.iter().all(|keyframe| keyframe.duration == 1.0) {
            return Some(Self { intervals, ends: None });
        }
        let ends = played
            .iter()
            .scan(BigRational::zero(), |elapsed, keyframe| {
                *elapsed += BigRational::from_f64(keyframe.duration).expect("durations are finite");
                Some(elapsed.clone())
            })
            .collect();
        Some(Self { intervals, ends: Some(ends) })
    }

    /// The elapsed time at which the last played keyframe is reached.
    #[must_use]
    pub fn total(&self) -> BigRational {
        match &self.ends {
            None => whole(self.intervals),
            Some(ends) => ends.last().cloned().unwrap_or_else(BigRational::zero),
        }
    }

    /// The elapsed time at a played keyframe, counted from 0; at most the total.
    #[must_use]
    pub fn at_keyframe(&self, played: usize) -> BigRational {
        match (&self.ends, played.min(self.intervals)) {
            (_, 0) => BigRational::zero(),
            (None, played) => whole(played),
            (Some(ends), played) => ends[played - 1].clone(),
        }
    }

    /// The key time at an elapsed time, rounded once and clamped to the range.
    #[must_use]
    pub fn key_time_at(&self, elapsed: &BigRational) -> f64 {
        let elapsed = elapsed.clamp(&BigRational::zero(), &self.total()).clone();
        let Some(ends) = &self.ends else { return to_f64(&elapsed) };
        let interval = ends.partition_point(|end| *end <= elapsed);
        if interval == self.intervals {
            return to_f64(&whole(interval));
        }
        let start = self.at_keyframe(interval);
        let fraction = (elapsed - &start) / (&ends[interval] - start);
        to_f64(&(whole(interval) + fraction))
    }

    /// The exact elapsed time at a key time, clamped to the range. NaN counts as 0.
    #[must_use]
    pub fn elapsed_at(&self, key_time: f64) -> BigRational {
        let key_time = BigRational::from_f64(key_time).unwrap_or_else(BigRational::zero);
        let key_time = key_time.clamp(BigRational::zero(), whole(self.intervals));
        let interval = key_time.to_integer().to_usize().unwrap_or(0);
        if self.ends.is_none() || interval >= self.intervals {
            return if self.ends.is_none() { key_time } else { self.total() };
        }
        let (start, end) = (self.at_keyframe(interval), self.at_keyframe(interval + 1));
        let fraction = key_time - whole(interval);
        &start + fraction * (end - &start)
    }
}

/// A whole number as an exact fraction.
#[must_use]
pub fn whole(number: usize) -> BigRational {
    BigRational::new(BigInt::from(number), BigInt::one())
}

/// The double nearest to a fraction.
#[must_use]
pub fn to_f64(exact: &BigRational) -> f64 {
    exact.to_f64().unwrap_or(f64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::Pose;

    fn timing(durations: &[f64]) -> Timing {
        let keyframe = |&duration: &f64| Keyframe { duration, ..Keyframe::new(Pose::new(Vec::new())) };
        Timing::of(&durations.iter().map(keyframe).collect::<Vec<_>>()).unwrap()
    }

    #[test]
    fn where_all_last_one_unit_key_time_is_elapsed_time() {
        let timing = timing(&[1.0; 6]);
        assert_eq!(to_f64(&timing.total()), 3.0);
        for key_time in [0.0, 0.1, 1.85, 3.0] {
            assert_eq!(to_f64(&timing.elapsed_at(key_time)), key_time);
            assert_eq!(timing.key_time_at(&BigRational::from_f64(key_time).unwrap()), key_time);
        }
    }

    #[test]
    fn longer_intervals_take_longer() {
        let timing = timing(&[9.0, 2.0, 0.5, 1.0, 7.0, 3.0]);
        assert_eq!(to_f64(&timing.total()), 3.5);
        for (elapsed, key_time) in [(0.0, 0.0), (1.0, 0.5), (2.0, 1.0), (2.25, 1.5), (2.5, 2.0), (3.0, 2.5), (3.5, 3.0)]
        {
            assert_eq!(timing.key_time_at(&BigRational::from_f64(elapsed).unwrap()), key_time, "after {elapsed}");
            assert_eq!(to_f64(&timing.elapsed_at(key_time)), elapsed, "at {key_time}");
        }
    }
}
