//! The clock of keys at their own times, apart from the keyframe list.

use super::apply::Outcome;
use super::{CommandError, Editor};
use crate::clock::TICKS_PER_SECOND;
use crate::words::{Message, texts};

/// Ticks since the start of the program, or since the clock was set.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SecondsClock {
    /// What it was set to, in seconds; at least 0.
    pub(super) from: f64,
    pub(super) ticks: u64,
    pub(super) is_held: bool,
    /// Whether it is held since somebody scrubbed: until something plays.
    pub(super) is_scrubbed: bool,
}

impl SecondsClock {
    #[expect(clippy::cast_precision_loss, reason = "no program runs for 2^52 ticks")]
    fn seconds(self) -> f64 {
        self.from + self.ticks as f64 / f64::from(TICKS_PER_SECOND)
    }
}

impl Editor {
    /// How far the keys at their own times are, in seconds; 0 in a scene that has none.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        self.seconds_clock.seconds()
    }

    /// Whether the clock of the keys at their own times is held.
    #[must_use]
    pub const fn holds_seconds(&self) -> bool {
        self.seconds_clock.is_held
    }

    /// Whether something moves with time, so that ticks are wanted: something plays, or keys at their own times are not over.
    #[must_use]
    pub fn wants_ticks(&self) -> bool {
        self.is_playing() || self.moves_by_itself()
    }

    fn moves_by_itself(&self) -> bool {
        !self.seconds_clock.is_held && self.document.scene.last_second().is_some_and(|last| self.seconds() < last)
    }

    /// Takes in ticks of the animation clock. Says whether the picture may have changed.
    pub fn tick(&mut self, ticks: u64) -> bool {
        let moved_by_itself = self.moves_by_itself() && ticks > 0;
        if self.document.scene.is_timed() && !self.seconds_clock.is_held {
            self.seconds_clock.ticks += ticks;
        }
        self.tick_playback(ticks) || moved_by_itself
    }

    pub(super) fn restart_seconds(&mut self) -> Message {
        let is_held = self.seconds_clock.is_held && !self.seconds_clock.is_scrubbed;
        self.seconds_clock = SecondsClock { is_held, ..SecondsClock::default() };
        texts::VIEW_TIMED_KEYS_RESTARTED.into()
    }

    pub(super) fn hold_seconds(&mut self) -> Message {
        self.seconds_clock.is_held = !self.seconds_clock.is_held;
        self.seconds_clock.is_scrubbed = false;
        let seconds = format!("{:.2}", self.seconds());
        if self.seconds_clock.is_held {
            texts::view_timed_keys_held(seconds)
        } else {
            texts::view_timed_keys_go_on(seconds)
        }
    }

    /// Shows a time and holds it, until something plays or the clock is told to go on; while something plays it goes on from there.
    pub(super) fn scrub_seconds(&mut self, seconds: f64) -> Outcome {
        if !seconds.is_finite() {
            return Err(CommandError::NotAValue { what: texts::VALUE_TIME });
        }
        let clock = self.seconds_clock;
        let is_scrubbed = !self.is_playing() && (clock.is_scrubbed || !clock.is_held);
        let is_held = clock.is_held || is_scrubbed;
        self.seconds_clock = SecondsClock { from: seconds.max(0.0), ticks: 0, is_held, is_scrubbed };
        Ok(None)
    }

    /// Playing begins at so many seconds after the first played keyframe: what was scrubbed to goes on with it.
    pub(super) fn end_scrub_of_seconds(&mut self, seconds: f64) {
        if self.seconds_clock.is_scrubbed {
            self.seconds_clock = SecondsClock { from: seconds.max(0.0), ..SecondsClock::default() };
        }
    }
}
