//! Timed keys: values at any time in seconds, interpolated between neighbours.
//!
//! Timed keys drive parts of a scene independently of the keyframe list. Time is elapsed seconds on the animation clock.

use std::sync::Arc;

use glam::{Quat, Vec3};
use thiserror::Error;

use crate::interpolation::{lerp, slerp};
use crate::words::{Message, display_by_message, texts};

/// Why pairs of time and value do not make a track.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum KeyError {
    /// The list of pairs is empty.
    NoKeys,
    /// A time is infinite or NaN.
    TimeNotFinite {
        /// The time in seconds.
        seconds: f64,
    },
    /// Two keys have the same time.
    TwoAtOneTime {
        /// The time in seconds.
        seconds: f64,
    },
}

display_by_message!(KeyError);

impl KeyError {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::NoKeys => texts::TIMED_NO_KEYS.into(),
            Self::TimeNotFinite { seconds } => texts::timed_not_finite(*seconds),
            Self::TwoAtOneTime { seconds } => texts::timed_two_at_one_time(*seconds),
        }
    }
}

/// A value with a default interpolation.
pub trait Interpolate: Copy {
    /// The value at the fraction `alpha` from `from` (0) to `to` (1).
    #[must_use]
    fn interpolate(from: Self, to: Self, alpha: f64) -> Self;
}

impl Interpolate for f64 {
    fn interpolate(from: Self, to: Self, alpha: f64) -> Self {
        from * (1.0 - alpha) + to * alpha
    }
}

impl Interpolate for f32 {
    #[expect(clippy::cast_possible_truncation, reason = "the result is of the precision of its ends")]
    fn interpolate(from: Self, to: Self, alpha: f64) -> Self {
        f64::interpolate(from.into(), to.into(), alpha) as Self
    }
}

impl Interpolate for Vec3 {
    #[expect(clippy::cast_possible_truncation, reason = "a fraction needs no more than f32")]
    fn interpolate(from: Self, to: Self, alpha: f64) -> Self {
        lerp(from, to, alpha as f32)
    }
}

impl Interpolate for Quat {
    /// Spherical, the short way ([`slerp`]).
    #[expect(clippy::cast_possible_truncation, reason = "a fraction needs no more than f32")]
    fn interpolate(from: Self, to: Self, alpha: f64) -> Self {
        slerp(from, to, alpha as f32)
    }
}

/// The timed keys of one value, sorted by time; never empty. Clones share storage.
#[derive(Clone, Debug)]
pub struct Track<V> {
    seconds: Arc<[f64]>,
    values: Arc<[V]>,
    interpolate: fn(V, V, f64) -> V,
}

impl<V: Interpolate> Track<V> {
    /// Keys from (seconds, value) pairs in any order, with the default interpolation of the type.
    ///
    /// # Errors
    /// [`KeyError`] for no pairs, a time that is not finite, or two at one time.
    pub fn new(pairs: impl IntoIterator<Item = (f64, V)>) -> Result<Self, KeyError> {
        Self::with_interpolation(pairs, V::interpolate)
    }
}

impl<V: Copy> Track<V> {
    /// Keys from (seconds, value) pairs in any order; `interpolate` gets two neighbours and the fraction between them, 0 to 1.
    ///
    /// # Errors
    /// [`KeyError`] for no pairs, a time that is not finite, or two at one time.
    pub fn with_interpolation(
        pairs: impl IntoIterator<Item = (f64, V)>,
        interpolate: fn(V, V, f64) -> V,
    ) -> Result<Self, KeyError> {
        let mut pairs: Vec<(f64, V)> = pairs.into_iter().collect();
        if let Some(&(seconds, _)) = pairs.iter().find(|(seconds, _)| !seconds.is_finite()) {
            return Err(KeyError::TimeNotFinite { seconds });
        }
        pairs.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        if let Some(twice) = pairs.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err(KeyError::TwoAtOneTime { seconds: twice[0].0 });
        }
        if pairs.is_empty() {
            return Err(KeyError::NoKeys);
        }
        let (seconds, values): (Vec<f64>, Vec<V>) = pairs.into_iter().unzip();
        Ok(Self { seconds: seconds.into(), values: values.into(), interpolate })
    }

    /// The value at a time: interpolated between its neighbours; the first before the first key, the last after the last.
    #[must_use]
    pub fn value_at(&self, seconds: f64) -> V {
        let after = self.seconds.partition_point(|&key| key <= seconds);
        let Some(before) = after.checked_sub(1) else { return self.values[0] };
        if after == self.seconds.len() {
            return self.values[before];
        }
        let (from, to) = (self.seconds[before], self.seconds[after]);
        (self.interpolate)(self.values[before], self.values[after], (seconds - from) / (to - from))
    }

    /// The time of the last key, in seconds: nothing changes from then on.
    #[must_use]
    pub fn last_second(&self) -> f64 {
        self.seconds.last().copied().unwrap_or(f64::NEG_INFINITY)
    }

    /// All keys, in the order of their times.
    pub fn keys(&self) -> impl Iterator<Item = (f64, V)> + '_ {
        self.seconds.iter().copied().zip(self.values.iter().copied())
    }

    /// The times of all keys in seconds, ascending.
    #[must_use]
    pub fn seconds(&self) -> &[f64] {
        &self.seconds
    }

    /// The value of the key at exactly this time in seconds, if there is one.
    #[must_use]
    pub fn key_at(&self, seconds: f64) -> Option<V> {
        self.seconds.iter().position(|&key| key == seconds).map(|index| self.values[index])
    }

    /// These keys and one more. It replaces a key at the same time.
    ///
    /// # Errors
    /// [`KeyError::TimeNotFinite`]
    pub fn with_key(&self, seconds: f64, value: V) -> Result<Self, KeyError> {
        let others = self.keys().filter(|&(key, _)| key != seconds);
        Self::with_interpolation(others.chain([(seconds, value)]), self.interpolate)
    }

    /// The keys except those at these times; `None` if none is left.
    #[must_use]
    pub fn without(&self, times: &[f64]) -> Option<Self> {
        let left = self.keys().filter(|(key, _)| !times.contains(key));
        Self::with_interpolation(left, self.interpolate).ok()
    }

    /// The keys, with those at `times` moved to the times that `moved` returns. A moved key replaces a key that was there.
    ///
    /// # Errors
    /// [`KeyError::TimeNotFinite`]; [`KeyError::TwoAtOneTime`] if two keys are moved to one time.
    pub fn moved(&self, times: &[f64], moved: impl Fn(f64) -> f64) -> Result<Self, KeyError> {
        let (moving, staying): (Vec<_>, Vec<_>) = self.keys().partition(|(key, _)| times.contains(key));
        let moving: Vec<(f64, V)> = moving.into_iter().map(|(key, value)| (moved(key), value)).collect();
        let staying = staying.into_iter().filter(|(key, _)| moving.iter().all(|(to, _)| to != key));
        Self::with_interpolation(staying.chain(moving.iter().copied()), self.interpolate)
    }

    /// How many keys there are; at least one.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "there is always a key")]
    pub fn len(&self) -> usize {
        self.values.len()
    }
}

impl<V: PartialEq> PartialEq for Track<V> {
    fn eq(&self, other: &Self) -> bool {
        self.seconds == other.seconds && self.values == other.values
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn numbers_and_vectors_are_interpolated_linearly() {
        let numbers = Track::new([(6.0, 20.0), (0.0, 1.0), (3.0, 7.0)]).unwrap();
        assert_eq!(numbers.value_at(1.5), 4.0);
        let vectors = Track::new([(0.0, Vec3::X), (3.0, Vec3::Y), (6.0, Vec3::Z)]).unwrap();
        assert_eq!(vectors.value_at(1.5), Vec3::new(0.5, 0.5, 0.0));
    }

    #[test]
    fn outside_the_keys_the_nearest_counts() {
        let numbers = Track::new([(1.0, 10.0), (2.0, 20.0)]).unwrap();
        for (seconds, expected) in
            [(-5.0, 10.0), (0.999, 10.0), (1.0, 10.0), (2.0, 20.0), (7.0, 20.0), (f64::INFINITY, 20.0)]
        {
            assert_eq!(numbers.value_at(seconds), expected, "at {seconds}");
        }
    }

    #[test]
    fn bad_keys_are_refused() {
        assert_eq!(Track::<f64>::new([]), Err(KeyError::NoKeys));
        assert_eq!(Track::new([(f64::INFINITY, 1.0)]), Err(KeyError::TimeNotFinite { seconds: f64::INFINITY }));
        assert!(Track::new([(f64::NAN, 1.0)]).is_err());
        assert_eq!(Track::new([(2.0, 1.0), (1.0, 0.0), (2.0, 3.0)]), Err(KeyError::TwoAtOneTime { seconds: 2.0 }));
        assert_eq!(Track::new([(0.0, 1.0), (-0.0, 0.0)]), Err(KeyError::TwoAtOneTime { seconds: -0.0 }));
    }

    #[test]
    fn keys_are_added_moved_and_taken_away() {
        let keys = Track::new([(0.0, 1.0), (1.0, 2.0), (2.0, 3.0)]).unwrap();
        let pairs = |keys: &Track<f64>| keys.keys().collect::<Vec<_>>();
        assert_eq!(pairs(&keys.with_key(1.5, 9.0).unwrap()), [(0.0, 1.0), (1.0, 2.0), (1.5, 9.0), (2.0, 3.0)]);
        assert_eq!(pairs(&keys.with_key(1.0, 9.0).unwrap()), [(0.0, 1.0), (1.0, 9.0), (2.0, 3.0)]);
        assert!(keys.with_key(f64::NAN, 9.0).is_err());
        assert_eq!(
            pairs(&keys.moved(&[0.0, 1.0], |at| at + 1.0).unwrap()),
            [(1.0, 1.0), (2.0, 2.0)],
            "the last gave way"
        );
        assert_eq!(pairs(&keys.moved(&[0.0], |at| at + 5.0).unwrap()), [(1.0, 2.0), (2.0, 3.0), (5.0, 1.0)]);
        assert_eq!(keys.moved(&[0.0, 1.0], |at| at + 1e300), Err(KeyError::TwoAtOneTime { seconds: 1e300 }));
        assert_eq!(pairs(&keys.without(&[0.0, 7.0]).unwrap()), [(1.0, 2.0), (2.0, 3.0)]);
        assert!(keys.without(&[0.0, 1.0, 2.0]).is_none());
        assert_eq!((keys.key_at(1.0), keys.key_at(1.25)), (Some(2.0), None));
    }

    #[test]
    fn any_function_can_interpolate() {
        let hold = Track::with_interpolation([(0.0, 'a'), (1.0, 'b')], |from, _, _| from).unwrap();
        assert_eq!((hold.value_at(0.99), hold.value_at(1.0)), ('a', 'b'));
    }

    proptest! {
        #[test]
        fn the_order_of_pairs_does_not_matter_and_keys_are_met(
            times in prop::collection::hash_set(-1000i32..1000, 1..30), at in -1100.0f64..1100.0,
        ) {
            let pairs: Vec<(f64, f64)> = times.iter().map(|&time| (f64::from(time), f64::from(time * time))).collect();
            let reversed = Track::new(pairs.iter().rev().copied()).unwrap();
            let keys = Track::new(pairs.iter().copied()).unwrap();
            prop_assert_eq!(keys.value_at(at), reversed.value_at(at));
            for (seconds, value) in pairs {
                prop_assert_eq!(keys.value_at(seconds), value);
            }
        }
    }
}
