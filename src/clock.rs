//! The fixed-rate animation clock: whole ticks out of wall time, exactly.
//!
//! Time comes in as [`Duration`]s, from whoever reads a clock; none is read here. What is left over between ticks is kept in whole
//! sixtieths of a nanosecond, never as a float, so any split of the same wall time gives the same ticks: an hour is 216,000.

use std::time::Duration;

/// The rate of the animation clock.
pub const TICKS_PER_SECOND: u32 = 60;

const NANOSECONDS_PER_SECOND: u128 = 1_000_000_000;

/// Cuts wall time into ticks of exactly 1/60 s.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct AnimationClock {
    /// Time since the last whole tick, in 1/60 ns: below 10⁹.
    leftover_sixtieth_ns: u128,
}

impl AnimationClock {
    /// A clock at a whole tick.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes in elapsed wall time and says how many ticks it completed.
    #[must_use]
    pub fn advance(&mut self, elapsed: Duration) -> u64 {
        let total = self.leftover_sixtieth_ns + elapsed.as_nanos() * u128::from(TICKS_PER_SECOND);
        self.leftover_sixtieth_ns = total % NANOSECONDS_PER_SECOND;
        u64::try_from(total / NANOSECONDS_PER_SECOND).unwrap_or(u64::MAX)
    }

    /// Like [`Self::advance`], but time beyond `longest` is dropped: a window that was stalled or asleep does not fast-forward.
    #[must_use]
    pub fn advance_at_most(&mut self, elapsed: Duration, longest: Duration) -> u64 {
        self.advance(elapsed.min(longest))
    }

    /// Wall time until the next tick, rounded up to a nanosecond; never zero.
    #[must_use]
    pub fn until_next_tick(&self) -> Duration {
        let missing = (NANOSECONDS_PER_SECOND - self.leftover_sixtieth_ns).div_ceil(u128::from(TICKS_PER_SECOND));
        Duration::from_nanos(u64::try_from(missing).unwrap_or(u64::MAX))
    }

    /// Forgets the leftover, so that the next tick comes a whole period from now.
    pub fn restart(&mut self) {
        self.leftover_sixtieth_ns = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn an_hour_is_216_000_ticks_at_once() {
        assert_eq!(AnimationClock::new().advance(Duration::from_hours(1)), 216_000);
    }

    #[test]
    fn an_hour_in_milliseconds_too() {
        let mut clock = AnimationClock::new();
        let ticks: u64 = (0..3_600_000).map(|_| clock.advance(Duration::from_millis(1))).sum();
        assert_eq!(ticks, 216_000);
    }

    #[test]
    fn a_stall_is_cut_short() {
        let mut clock = AnimationClock::new();
        assert_eq!(clock.advance_at_most(Duration::from_mins(1), Duration::from_millis(250)), 15);
    }

    #[test]
    fn waiting_until_the_next_tick_reaches_it() {
        let mut clock = AnimationClock::new();
        assert_eq!(clock.advance(Duration::from_nanos(12_345_678)), 0);
        assert_eq!(clock.advance(clock.until_next_tick()), 1);
    }

    proptest! {
        #[test]
        fn any_split_gives_the_same_ticks(parts in prop::collection::vec(0u64..200_000_000, 1..200)) {
            let mut clock = AnimationClock::new();
            let ticks: u64 = parts.iter().map(|&ns| clock.advance(Duration::from_nanos(ns))).sum();
            let whole = AnimationClock::new().advance(Duration::from_nanos(parts.iter().sum()));
            prop_assert_eq!(ticks, whole);
        }
    }
}
