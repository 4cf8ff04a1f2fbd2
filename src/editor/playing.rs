//! Playing, pausing, scrubbing.

use num_rational::BigRational;
use num_traits::Zero as _;

use super::apply::CommandResult;
use super::playback::{Pace, PlayMode, Playback, Position, Span, span};
use super::{Command, CommandError, Edit, Editor, PlaybackCommand};
use crate::keyframe::{KeyframeIndex, PlayRange, Timing, to_f64};
use crate::pose::Pose;
use crate::words::texts;

/// Speeds that can be chosen, in percent.
pub const SPEED_PERCENT_RANGE: std::ops::RangeInclusive<u32> = 10..=1000;

impl Editor {
    pub(super) fn play(&mut self, command: PlaybackCommand) -> CommandResult {
        self.commit_gesture();
        match command {
            PlaybackCommand::PlayOrStop => self.play_or_stop(),
            PlaybackCommand::PlayFromPlayhead => self.play_from_playhead(),
            PlaybackCommand::PauseOrResume => self.pause_or_resume(),
            PlaybackCommand::Scrub(key_time) => self.scrub(key_time),
            PlaybackCommand::Step(ticks) => self.step_ticks(ticks),
            PlaybackCommand::SetMode(mode) => {
                self.session.play_mode = mode;
                self.refit_playing();
                let said = match mode {
                    PlayMode::Once => texts::PLAYING_MODE_ONCE,
                    PlayMode::Loop => texts::PLAYING_MODE_LOOP,
                    PlayMode::PingPong => texts::PLAYING_MODE_PING_PONG,
                };
                Ok(Some(said.into()))
            }
            PlaybackCommand::NextMode => self.play(PlaybackCommand::SetMode(self.session.play_mode.next())),
            PlaybackCommand::SetRange(range) => self.set_range(range),
            PlaybackCommand::SetSpeedPercent(percent) => {
                self.session.speed_percent = percent.clamp(*SPEED_PERCENT_RANGE.start(), *SPEED_PERCENT_RANGE.end());
                self.refit_pace();
                Ok(Some(texts::playing_speed(self.session.speed_percent)))
            }
        }
    }

    /// The key time of the playhead: what plays, is paused at or was scrubbed to; otherwise the current keyframe's, within the range.
    #[must_use]
    pub fn playhead(&self) -> Option<f64> {
        let timing = self.document.keyframes.timing()?;
        match self.playback.elapsed() {
            Some(elapsed) => Some(timing.key_time_at(&elapsed)),
            None => Some(timing.key_time_at(&self.elapsed_at_current(timing))),
        }
    }

    /// Whether the sample at a scrubbed key time is shown.
    #[must_use]
    pub const fn is_scrubbed(&self) -> bool {
        matches!(self.playback, Playback::Scrubbed(_))
    }

    pub(super) fn elapsed_at_current(&self, timing: &Timing) -> BigRational {
        let current = self.document.keyframes.current().map_or(0, KeyframeIndex::get);
        timing.at_keyframe(current.saturating_sub(1))
    }

    pub(super) fn pace(&self) -> Pace {
        Pace { ms_between_keyframes: self.document.ms_between_keyframes, speed_percent: self.session.speed_percent }
    }

    /// Applies the current pace to a running playback.
    pub(super) fn refit_pace(&mut self) {
        let pace = self.pace();
        if let Playback::Playing(position) = &mut self.playback {
            position.set_pace(pace);
        }
    }

    /// Applies the current range and mode to a running playback.
    fn refit_playing(&mut self) {
        if let (Playback::Playing(position), Ok(span)) = (&self.playback, self.span()) {
            self.playback = Playback::Playing(position.in_span(span));
        }
    }

    fn span(&self) -> Result<Span, CommandError> {
        let timing = self.document.keyframes.timing().ok_or_else(|| self.too_few_to_play())?;
        Ok(span(timing, self.document.keyframes.len(), self.session.play_range, self.session.play_mode))
    }

    fn play_or_stop(&mut self) -> CommandResult {
        if self.is_playing() {
            self.end_playback();
            return Ok(Some(texts::playing_stopped(self.position_message())));
        }
        self.start_at(&BigRational::zero())?;
        Ok(Some(texts::playing_begins(self.document.keyframes.len() - 2)))
    }

    fn play_from_playhead(&mut self) -> CommandResult {
        if self.is_playing() {
            return self.play_or_stop();
        }
        let timing = self.document.keyframes.timing().ok_or_else(|| self.too_few_to_play())?;
        let elapsed = self.playback.elapsed().unwrap_or_else(|| self.elapsed_at_current(timing));
        let span = self.span()?;
        self.start_at(if elapsed < span.end { &elapsed } else { &span.start })?;
        Ok(Some(texts::PLAYING_BEGINS_AT_PLAYHEAD.into()))
    }

    fn start_at(&mut self, elapsed: &BigRational) -> Result<(), CommandError> {
        let position = Position::new(self.span()?, elapsed, self.pace());
        self.playback = Playback::Playing(position);
        self.end_scrub_of_timed_keys(to_f64(elapsed) * f64::from(self.document.ms_between_keyframes) / 1000.0);
        Ok(())
    }

    fn pause_or_resume(&mut self) -> CommandResult {
        match &self.playback {
            Playback::Playing(position) => {
                let paused = Playback::Paused(position.clone());
                let pose = self.displayed_pose().in_bounds();
                self.playback = paused;
                let discards = self.document.has_unsaved_posing(self.document.scene.rest_pose());
                let before = self.document.clone();
                self.document.live_pose = pose;
                if discards {
                    self.history.record(before, &self.document, texts::ACT_PAUSE, None);
                }
                let create = self.key_of(&Command::Edit(Edit::CreateKeyframe));
                let update = self.key_of(&Command::Edit(Edit::UpdateCurrent));
                let resume = self.key_of(&Command::Playback(PlaybackCommand::PauseOrResume));
                Ok(Some(texts::playing_paused(create, update, resume)))
            }
            Playback::Paused(position) => {
                let mut position = position.in_span(self.span()?);
                position.set_pace(self.pace());
                self.playback = Playback::Playing(position);
                Ok(Some(texts::PLAYING_GOES_ON.into()))
            }
            Playback::Stopped | Playback::Scrubbed(_) => {
                Err(CommandError::NothingPlaying { play: self.key_of(&Command::Playback(PlaybackCommand::PlayOrStop)) })
            }
        }
    }

    fn scrub(&mut self, key_time: f64) -> CommandResult {
        let timing = self.document.keyframes.timing().ok_or_else(|| self.too_few_to_play())?;
        if !key_time.is_finite() {
            return Err(CommandError::NotAValue { what: texts::VALUE_KEY_TIME });
        }
        let elapsed = timing.elapsed_at(key_time);
        if self.is_playing() {
            self.start_at(&elapsed)?;
        } else {
            self.playback = Playback::Scrubbed(elapsed);
        }
        Ok(None)
    }

    fn step_ticks(&mut self, ticks: i32) -> CommandResult {
        let timing = self.document.keyframes.timing().ok_or_else(|| self.too_few_to_play())?;
        let from = self.playback.elapsed().unwrap_or_else(|| self.elapsed_at_current(timing));
        let elapsed = (from + self.pace().elapsed(ticks)).clamp(BigRational::zero(), timing.total());
        let key_time = timing.key_time_at(&elapsed);
        self.playback = Playback::Scrubbed(elapsed);
        Ok(Some(texts::playing_key_time(format!("{key_time:.3}"))))
    }

    fn set_range(&mut self, range: Option<(usize, usize)>) -> CommandResult {
        let count = self.document.keyframes.len();
        if let Some((first, last)) = range
            && !(1 <= first && first < last && last + 1 < count)
        {
            return Err(CommandError::NoSuchRange { first, last });
        }
        self.session.play_range = range;
        self.refit_playing();
        Ok(Some(match range {
            Some((first, last)) => texts::playing_range(first, last),
            None => texts::PLAYING_WHOLE_RANGE.into(),
        }))
    }

    /// Ends the playback at the last keyframe that it plays, which becomes current and is copied to the scene.
    pub(super) fn end_playback(&mut self) {
        if let Playback::Playing(position) = std::mem::take(&mut self.playback) {
            self.show_keyframe(texts::ACT_PLAYING, position.last_keyframe());
        }
    }

    /// Leaves a scrubbed key time and says what pose was shown there, within the bounds of documents.
    pub(super) fn end_scrub(&mut self) -> Option<Pose> {
        if !self.is_scrubbed() {
            return None;
        }
        let pose = self.displayed_pose().in_bounds();
        self.playback = Playback::Stopped;
        Some(pose)
    }

    /// The sample at the playhead while playing or scrubbed.
    pub(super) fn sampled_pose(&self) -> Option<Pose> {
        if !matches!(self.playback, Playback::Playing(_) | Playback::Scrubbed(_)) {
            return None;
        }
        let range = PlayRange::new(&self.document.keyframes).ok()?;
        range.pose_at(self.playhead()?, self.document.interpolation).ok()
    }

    /// The pose that an edit of the scene starts from: the displayed pose while nothing plays.
    pub(super) fn edited_pose(&self) -> Pose {
        if self.is_scrubbed() { self.displayed_pose().in_bounds() } else { self.document.live_pose.clone() }
    }

    /// Takes in ticks for what plays. Says whether the picture may have changed.
    pub(super) fn tick_playback(&mut self, ticks: u64) -> bool {
        let Playback::Playing(position) = &mut self.playback else { return false };
        position.advance(ticks);
        if position.ended_at().is_some() {
            self.end_playback();
            self.say(texts::PLAYING_ENDED);
        }
        ticks > 0
    }

    /// What is played or paused at, in keyframes, rounded to a double; `None` while the list is too short to play.
    #[must_use]
    pub fn key_time(&self) -> Option<f64> {
        let elapsed = self.playback.elapsed()?;
        Some(self.document.keyframes.timing()?.key_time_at(&elapsed))
    }
}
