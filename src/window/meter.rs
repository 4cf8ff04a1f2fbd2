//! Measures where the time of a picture goes, as means over half a second.

use std::time::Duration;

use web_time::Instant;

use crate::ui::Statistics;

/// The time over which means are taken.
const SPAN: Duration = Duration::from_millis(500);

/// The kinds of work that are measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work {
    /// Events are taken in.
    Input,
    /// Poses are evaluated.
    Evaluation,
    /// The scene is placed in the world.
    Frame,
    /// Panels are laid out.
    Ui,
    /// The picture is drawn and handed to the display.
    Drawing,
}

const WORKS: usize = Work::Drawing as usize + 1;

/// A longer pause between pictures ends a measurement.
const PAUSE: Duration = Duration::from_millis(250);

/// Adds up.
#[derive(Clone, Debug, Default)]
pub struct Meter {
    since: Option<Instant>,
    last: Option<Instant>,
    pictures: u32,
    ticks: u64,
    spent: [Duration; WORKS],
}

impl Meter {
    /// Some work was done from one moment to another.
    pub fn add(&mut self, work: Work, from: Instant, to: Instant) {
        self.spent[work as usize] += to.duration_since(from);
    }

    /// Counts ticks of the animation clock.
    pub const fn ticks(&mut self, ticks: u64) {
        self.ticks += ticks;
    }

    /// A picture was shown. Every half second the means since come back, and a new sum begins; a pause between pictures belongs to
    /// none.
    pub fn picture(&mut self, at: Instant) -> Option<Statistics> {
        let is_pause = self.last.is_none_or(|last| at.duration_since(last) > PAUSE);
        let Some(since) = self.since.filter(|_| !is_pause) else {
            *self = Self::since(at);
            return None;
        };
        self.last = Some(at);
        self.pictures += 1;
        let span = at.duration_since(since);
        if span < SPAN {
            return None;
        }
        let seconds = span.as_secs_f64();
        let ms = |work: Work| 1e3 * self.spent[work as usize].as_secs_f64() / f64::from(self.pictures);
        #[expect(clippy::cast_precision_loss, reason = "half a second has few ticks")]
        let ticks = self.ticks as f64;
        let statistics = Statistics {
            pictures: f64::from(self.pictures) / seconds,
            ticks: ticks / seconds,
            input_ms: ms(Work::Input),
            evaluation_ms: ms(Work::Evaluation),
            frame_ms: ms(Work::Frame),
            ui_ms: ms(Work::Ui),
            drawing_ms: ms(Work::Drawing),
        };
        *self = Self::since(at);
        Some(statistics)
    }

    fn since(at: Instant) -> Self {
        Self { since: Some(at), last: Some(at), ..Self::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_are_of_half_a_second() {
        let start = crate::window::now();
        let at = |ms: u64| start + Duration::from_millis(ms);
        let mut meter = Meter::default();
        meter.add(Work::Ui, at(0), at(400));
        assert_eq!(meter.picture(at(500)), None, "what was before the first picture does not count");
        for picture in 1..=24 {
            meter.add(Work::Ui, at(0), at(5));
            meter.add(Work::Drawing, at(0), at(10));
            meter.ticks(1);
            assert_eq!(meter.picture(at(500 + 20 * picture)), None);
        }
        meter.ticks(6);
        let all = meter.picture(at(1000)).expect("half a second is over");
        let expected = Statistics { pictures: 50.0, ticks: 60.0, ui_ms: 4.8, drawing_ms: 9.6, ..Statistics::default() };
        assert_eq!(all, expected);
        assert_eq!(meter.picture(at(1020)), None);
    }

    #[test]
    fn a_pause_belongs_to_no_mean() {
        let start = crate::window::now();
        let at = |ms: u64| start + Duration::from_millis(ms);
        let mut meter = Meter::default();
        meter.picture(at(0));
        meter.add(Work::Input, at(0), at(4000));
        for picture in 0..5 {
            assert_eq!(meter.picture(at(5000 + 100 * picture)), None);
        }
        let all = meter.picture(at(5500)).expect("half a second is over");
        assert_eq!(all, Statistics { pictures: 10.0, ..Statistics::default() });
    }
}
