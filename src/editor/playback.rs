//! Where playback is, in exact arithmetic, out of ticks. It never writes the document.
//!
//! Elapsed time counts units of the ms between keyframes from the first played keyframe ([`Timing`]); while every interval lasts one
//! unit it is the key time.

use num_bigint::BigInt;
use num_rational::BigRational;

use crate::clock::TICKS_PER_SECOND;
use crate::keyframe::{KeyframeIndex, Timing};

/// What happens at the end of the played range.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum PlayMode {
    /// Playing ends.
    #[default]
    Once,
    /// It begins again.
    Loop,
    /// It runs backwards, and forwards again.
    PingPong,
}

impl PlayMode {
    /// Every mode, in the order in which the button goes through them.
    pub const ALL: [Self; 3] = [Self::Once, Self::Loop, Self::PingPong];

    /// The one after this, around the end.
    #[must_use]
    pub const fn next(self) -> Self {
        match self {
            Self::Once => Self::Loop,
            Self::Loop => Self::PingPong,
            Self::PingPong => Self::Once,
        }
    }

    /// Its name for people and scripts.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Once => "once",
            Self::Loop => "loop",
            Self::PingPong => "ping-pong",
        }
    }
}

/// How fast time passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pace {
    /// Wall time from one keyframe to the next, for an interval of one unit.
    pub ms_between_keyframes: u32,
    /// Speed on top of that, in percent; above 0.
    pub speed_percent: u32,
}

impl Pace {
    /// The elapsed time of a number of ticks: k · (1000/60) / ms at 100 %.
    #[must_use]
    pub fn elapsed(self, ticks: impl Into<BigInt>) -> BigRational {
        BigRational::new(
            BigInt::from(1000) * ticks.into() * BigInt::from(self.speed_percent),
            BigInt::from(TICKS_PER_SECOND) * BigInt::from(self.ms_between_keyframes) * BigInt::from(100),
        )
    }
}

/// The part of the list that plays.
#[derive(Clone, Debug, PartialEq)]
pub struct Span {
    /// The elapsed time where it begins.
    pub start: BigRational,
    /// The elapsed time where it ends; after the start.
    pub end: BigRational,
    /// The keyframe of the list where it ends.
    pub last_keyframe: KeyframeIndex,
    /// What happens there.
    pub mode: PlayMode,
}

/// A playback position, reached by whole ticks.
#[derive(Clone, Debug, PartialEq)]
pub struct Position {
    span: Span,
    /// How far it had run from the start of the span when the pace last changed.
    run_at_change: BigRational,
    ticks_since_change: u64,
    pace: Pace,
}

impl Position {
    /// A position in a span, clamped to it.
    #[must_use]
    pub fn new(span: Span, elapsed: &BigRational, pace: Pace) -> Self {
        let run_at_change = elapsed.clamp(&span.start, &span.end) - &span.start;
        Self { span, run_at_change, ticks_since_change: 0, pace }
    }

    /// How far it has run from the start of the span, around its ends and all.
    fn run(&self) -> BigRational {
        &self.run_at_change + self.pace.elapsed(self.ticks_since_change)
    }

    /// The elapsed time that is shown.
    #[must_use]
    pub fn elapsed(&self) -> BigRational {
        let length = &self.span.end - &self.span.start;
        let run = self.run();
        let within = match self.span.mode {
            PlayMode::Once => run.min(length),
            PlayMode::Loop => &run - (&run / &length).floor() * length,
            PlayMode::PingPong => {
                let there_and_back = &length + &length;
                let run = &run - (&run / &there_and_back).floor() * &there_and_back;
                if run > length { there_and_back - run } else { run }
            }
        };
        &self.span.start + within
    }

    /// Goes on by whole ticks.
    pub const fn advance(&mut self, ticks: u64) {
        self.ticks_since_change = self.ticks_since_change.saturating_add(ticks);
    }

    /// Continues at another pace from the current position.
    pub fn set_pace(&mut self, pace: Pace) {
        if pace != self.pace {
            self.run_at_change = self.run();
            self.ticks_since_change = 0;
            self.pace = pace;
        }
    }

    /// Goes on in another span, from the same elapsed time where it has that.
    #[must_use]
    pub fn in_span(&self, span: Span) -> Self {
        Self::new(span, &self.elapsed(), self.pace)
    }

    /// The keyframe of the list where playing ends, if that is reached: the first tick at or past the end, exactly.
    #[must_use]
    pub fn ended_at(&self) -> Option<KeyframeIndex> {
        let has_ended = self.span.mode == PlayMode::Once && self.run() >= &self.span.end - &self.span.start;
        has_ended.then_some(self.span.last_keyframe)
    }

    /// The keyframe of the list where the span ends.
    #[must_use]
    pub const fn last_keyframe(&self) -> KeyframeIndex {
        self.span.last_keyframe
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
    /// The sample at a scrubbed elapsed time is shown.
    Scrubbed(BigRational),
}

impl Playback {
    /// The elapsed time that plays, is paused at, or was scrubbed to.
    #[must_use]
    pub fn elapsed(&self) -> Option<BigRational> {
        match self {
            Self::Stopped => None,
            Self::Playing(position) | Self::Paused(position) => Some(position.elapsed()),
            Self::Scrubbed(elapsed) => Some(elapsed.clone()),
        }
    }
}

/// The span of a whole timing, or of the part between two keyframes of the list, kept within what plays.
#[must_use]
pub fn span(timing: &Timing, keyframes: usize, range: Option<(usize, usize)>, mode: PlayMode) -> Span {
    let end = keyframes - 2;
    let (first, last) = range
        .map(|(first, last)| (first.clamp(1, end), last.clamp(1, end)))
        .filter(|(first, last)| first < last)
        .unwrap_or((1, end));
    Span {
        start: timing.at_keyframe(first - 1),
        end: timing.at_keyframe(last - 1),
        last_keyframe: KeyframeIndex::new(last),
        mode,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keyframe::{to_f64, whole};

    fn pace(ms_between_keyframes: u32) -> Pace {
        Pace { ms_between_keyframes, speed_percent: 100 }
    }

    fn position(ms: u32, length: usize, mode: PlayMode) -> Position {
        let span = Span { start: whole(0), end: whole(length), last_keyframe: KeyframeIndex::new(length + 1), mode };
        Position::new(span, &whole(0), pace(ms))
    }

    #[track_caller]
    fn check_end(ms: u32, length: usize, expected_ticks: u64) {
        let mut position = position(ms, length, PlayMode::Once);
        let mut ticks = 0;
        while position.ended_at().is_none() {
            position.advance(1);
            ticks += 1;
        }
        assert_eq!(ticks, expected_ticks);
    }

    #[test]
    fn the_end_is_the_first_tick_at_or_past_it() {
        check_end(2000, 1, 120);
        check_end(100, 3, 18);
        check_end(700, 1, 42);
        check_end(9900, 3, 1782);
        check_end(110, 1, 7);
    }

    #[test]
    fn another_pace_goes_on_without_a_jump() {
        let mut position = position(2000, 1, PlayMode::Once);
        position.advance(33);
        let before = position.elapsed();
        position.set_pace(pace(300));
        assert_eq!(position.elapsed(), before);
        position.set_pace(pace(2000));
        position.advance(87);
        assert!(position.ended_at().is_some(), "33 and 87 ticks at 2000 ms are one interval, exactly");
    }

    #[test]
    fn elapsed_times_are_the_nearest_doubles() {
        let mut position = position(2000, 1, PlayMode::Once);
        position.advance(1);
        assert_eq!(to_f64(&position.elapsed()), 50.0 / 6000.0);
    }

    #[test]
    fn loops_begin_again_and_ping_pong_runs_back() {
        let mut looping = position(1000, 2, PlayMode::Loop);
        let mut ping_pong = position(1000, 2, PlayMode::PingPong);
        for (seconds, in_loop, in_ping_pong) in
            [(1, 1.0, 1.0), (2, 0.0, 2.0), (3, 1.0, 1.0), (4, 0.0, 0.0), (5, 1.0, 1.0)]
        {
            looping.advance(60);
            ping_pong.advance(60);
            assert_eq!(to_f64(&looping.elapsed()), in_loop, "loop after {seconds} s");
            assert_eq!(to_f64(&ping_pong.elapsed()), in_ping_pong, "ping-pong after {seconds} s");
            assert!(looping.ended_at().is_none() && ping_pong.ended_at().is_none());
        }
    }

    #[test]
    fn half_the_speed_takes_twice_the_ticks() {
        let pace = Pace { ms_between_keyframes: 1000, speed_percent: 50 };
        assert_eq!(pace.elapsed(120_u64), whole(1));
    }
}
