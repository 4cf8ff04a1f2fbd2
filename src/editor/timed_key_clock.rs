//! The clock of the timed keys. It is independent of keyframe playback.

use super::apply::CommandResult;
use super::{CommandError, Editor, PlayMode};
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

/// What the buttons of the transport play.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Transport {
    /// The keyframes.
    Keyframes,
    /// The timed keys, because there are too few keyframes to play.
    TimedKeys,
}

impl Editor {
    /// What the buttons of the transport play.
    #[must_use]
    pub fn transport(&self) -> Transport {
        let has_keyframes = self.document.keyframes.timing().is_some();
        if !has_keyframes && self.document.scene.is_timed() { Transport::TimedKeys } else { Transport::Keyframes }
    }

    /// Whether the clock of the timed keys runs and moves something.
    #[must_use]
    pub fn timed_keys_run(&self) -> bool {
        self.moves_by_itself()
    }

    /// The time of the timed key after the one that is shown, or before it, in seconds.
    #[must_use]
    pub fn timed_key_beside(&self, is_after: bool) -> Option<f64> {
        let (scene, now) = (&self.document.scene, self.seconds());
        let tracks = scene.nodes_with_ids().flat_map(|(id, _)| scene.channels(id).iter().map(move |&it| (id, it)));
        let times = tracks.flat_map(|(id, channel)| scene.key_seconds(id, channel).iter().copied());
        let times = times.filter(|&at| at >= 0.0);
        if is_after {
            times.filter(|&at| at > now).min_by(f64::total_cmp)
        } else {
            times.filter(|&at| at < now).max_by(f64::total_cmp)
        }
    }

    /// The time at which timed keys are sampled, in seconds from 0. A scene without timed keys stays at 0.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        let seconds = self.timed_key_clock.seconds();
        match (self.timed_key_mode, self.document.scene.last_second().filter(|&last| last > 0.0)) {
            (PlayMode::Once, _) | (_, None) => seconds,
            (PlayMode::Loop, Some(last)) => seconds % last,
            (PlayMode::PingPong, Some(last)) => {
                let run = seconds % (2.0 * last);
                if run > last { 2.0 * last - run } else { run }
            }
        }
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
        let is_loop = self.timed_key_mode != PlayMode::Once;
        let has_more = |last: f64| if is_loop { last > 0.0 } else { self.seconds() < last };
        !self.timed_key_clock.is_held && self.document.scene.last_second().is_some_and(has_more)
    }

    /// Timed keys are played in the session's mode while the transport plays them, else once.
    pub(super) fn fit_timed_key_mode(&mut self) {
        let mode = match self.transport() {
            Transport::TimedKeys => self.session.play_mode,
            Transport::Keyframes => PlayMode::Once,
        };
        if mode == self.timed_key_mode {
            return;
        }
        if self.timed_key_mode != PlayMode::Once {
            // The time that is shown stays, however often it went around.
            self.timed_key_clock = TimedKeyClock { from: self.seconds(), ticks: 0, ..self.timed_key_clock };
        }
        self.timed_key_mode = mode;
    }

    /// Plays the timed keys from their start, or stops there.
    pub(super) fn play_timed_keys(&mut self) -> CommandResult {
        if !self.document.scene.is_timed() {
            return Err(CommandError::NoTimedKeys);
        }
        if self.timed_keys_run() {
            self.timed_key_clock = TimedKeyClock { is_held: true, is_scrubbed: true, ..TimedKeyClock::default() };
            return Ok(Some(texts::VIEW_TIMED_KEYS_STOPPED.into()));
        }
        self.timed_key_clock = TimedKeyClock::default();
        Ok(Some(texts::VIEW_TIMED_KEYS_RESTARTED.into()))
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
