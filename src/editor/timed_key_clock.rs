//! The clock of the timed keys. It is independent of keyframe playback.

use super::apply::CommandResult;
use super::{CommandError, Editor};
use crate::clock::TICKS_PER_SECOND;
use crate::scene::LATEST_SECONDS;
use crate::words::{Message, texts};

/// Ticks since the start of the program, or since the clock was set.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TimedKeyClock {
    /// What it was set to, in seconds; at least 0.
    pub(super) from: f64,
    pub(super) ticks: u64,
    pub(super) is_held: bool,
    /// Whether it is held only because of a scrub. Playback then releases it.
    pub(super) is_scrubbed: bool,
}

impl TimedKeyClock {
    #[expect(clippy::cast_precision_loss, reason = "no program runs for 2^52 ticks")]
    fn seconds(self) -> f64 {
        self.from + self.ticks as f64 / f64::from(TICKS_PER_SECOND)
    }
}

impl Editor {
    /// The time at which timed keys are sampled, in seconds from 0. A scene without timed keys stays at 0.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        self.timed_key_clock.seconds()
    }

    /// Whether the clock of the timed keys is held.
    #[must_use]
    pub const fn holds_timed_keys(&self) -> bool {
        self.timed_key_clock.is_held
    }

    /// Whether the picture changes with time, so that the host must deliver ticks: playback runs, or timed keys remain.
    #[must_use]
    pub fn wants_ticks(&self) -> bool {
        self.is_playing() || self.moves_by_itself()
    }

    fn moves_by_itself(&self) -> bool {
        !self.timed_key_clock.is_held && self.document.scene.last_second().is_some_and(|last| self.seconds() < last)
    }

    /// Takes in ticks of the animation clock. Says whether the picture may have changed.
    pub fn tick(&mut self, ticks: u64) -> bool {
        let moved_by_itself = self.moves_by_itself() && ticks > 0;
        if self.document.scene.is_timed() && !self.timed_key_clock.is_held {
            self.timed_key_clock.ticks = self.timed_key_clock.ticks.saturating_add(ticks);
        }
        self.tick_playback(ticks) || moved_by_itself
    }

    pub(super) fn restart_timed_keys(&mut self) -> Message {
        let is_held = self.timed_key_clock.is_held && !self.timed_key_clock.is_scrubbed;
        self.timed_key_clock = TimedKeyClock { is_held, ..TimedKeyClock::default() };
        texts::VIEW_TIMED_KEYS_RESTARTED.into()
    }

    pub(super) fn hold_timed_keys(&mut self) -> Message {
        self.timed_key_clock.is_held = !self.timed_key_clock.is_held;
        self.timed_key_clock.is_scrubbed = false;
        let seconds = format!("{:.2}", self.seconds());
        if self.timed_key_clock.is_held {
            texts::view_timed_keys_held(seconds)
        } else {
            texts::view_timed_keys_go_on(seconds)
        }
    }

    /// Shows a time and holds it until playback starts or the clock is released. During playback the clock runs on from that time.
    pub(super) fn scrub_timed_keys(&mut self, seconds: f64) -> CommandResult {
        if !seconds.is_finite() {
            return Err(CommandError::NotAValue { what: texts::VALUE_TIME });
        }
        if seconds.abs() > LATEST_SECONDS {
            return Err(CommandError::TooLate);
        }
        let clock = self.timed_key_clock;
        let is_scrubbed = !self.is_playing() && (clock.is_scrubbed || !clock.is_held);
        let is_held = clock.is_held || is_scrubbed;
        self.timed_key_clock = TimedKeyClock { from: seconds.max(0.0), ticks: 0, is_held, is_scrubbed };
        Ok(None)
    }

    /// Playback starts, `seconds` after the first played keyframe. A clock that is held by a scrub follows it.
    pub(super) fn end_scrub_of_timed_keys(&mut self, seconds: f64) {
        if self.timed_key_clock.is_scrubbed {
            self.timed_key_clock = TimedKeyClock { from: seconds.max(0.0), ..TimedKeyClock::default() };
        }
    }
}
