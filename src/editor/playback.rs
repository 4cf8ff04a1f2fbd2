//! Where playback is: a key time in exact arithmetic, out of ticks. It never writes the document.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive as _, Zero as _};

use crate::clock::TICKS_PER_SECOND;

/// A key time reached by whole ticks.
#[derive(Clone, Debug, PartialEq)]
pub struct Position {
    /// The key time when the milliseconds between keyframes last changed.
    key_time_at_change: BigRational,
    ticks_since_change: u64,
    ms_between_keyframes: u32,
}

impl Position {
    /// Key time 0.
    #[must_use]
    pub fn start(ms_between_keyframes: u32) -> Self {
        Self { key_time_at_change: BigRational::zero(), ticks_since_change: 0, ms_between_keyframes }
    }

    /// The key time, exactly: tick k from the start is at k · (1000/60) / ms.
    #[must_use]
    fn exact_key_time(&self) -> BigRational {
        let ms = BigRational::new(
            BigInt::from(1000) * BigInt::from(self.ticks_since_change),
            BigInt::from(TICKS_PER_SECOND) * BigInt::from(self.ms_between_keyframes),
        );
        &self.key_time_at_change + ms
    }

    /// The key time, rounded to the nearest double.
    #[must_use]
    pub fn key_time(&self) -> f64 {
        self.exact_key_time().to_f64().unwrap_or(f64::MAX)
    }

    /// Goes on by whole ticks.
    pub const fn advance(&mut self, ticks: u64) {
        self.ticks_since_change = self.ticks_since_change.saturating_add(ticks);
    }

    /// Goes on at another pace from the key time reached.
    pub fn set_ms_between_keyframes(&mut self, ms_between_keyframes: u32) {
        if ms_between_keyframes != self.ms_between_keyframes {
            self.key_time_at_change = self.exact_key_time();
            self.ticks_since_change = 0;
            self.ms_between_keyframes = ms_between_keyframes;
        }
    }

    /// Whether the key time is at or past `last_key_time`, exactly.
    #[must_use]
    pub fn has_reached(&self, last_key_time: usize) -> bool {
        self.exact_key_time() >= BigRational::from_integer(BigInt::from(last_key_time))
    }
}

/// Whether something plays.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Playback {
    /// The live pose is shown.
    #[default]
    Stopped,
    /// The sample at a position is shown.
    Playing(Position),
    /// The sample at a position was frozen into the scene; playing can go on from there.
    Paused(Position),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn ticks_to_reach(ms: u32, last_key_time: usize) -> u64 {
        let mut position = Position::start(ms);
        let mut ticks = 0;
        while !position.has_reached(last_key_time) {
            position.advance(1);
            ticks += 1;
        }
        ticks
    }

    #[test]
    fn the_end_is_the_first_tick_at_or_past_it() {
        assert_eq!(ticks_to_reach(2000, 1), 120);
        assert_eq!(ticks_to_reach(100, 3), 18);
        assert_eq!(ticks_to_reach(700, 1), 42);
        assert_eq!(ticks_to_reach(9900, 3), 1782);
        assert_eq!(ticks_to_reach(110, 1), 7);
    }

    #[test]
    fn another_pace_goes_on_without_a_jump() {
        let mut position = Position::start(2000);
        position.advance(33);
        let before = position.key_time();
        position.set_ms_between_keyframes(300);
        assert!((position.key_time() - before).abs() < 1e-15);
        position.set_ms_between_keyframes(2000);
        position.advance(87);
        assert!(position.has_reached(1), "33 and 87 ticks at 2000 ms are one interval, exactly");
    }

    #[test]
    fn key_times_are_the_nearest_doubles() {
        let mut position = Position::start(2000);
        position.advance(1);
        assert_eq!(position.key_time(), 50.0 / 6000.0);
    }
}
