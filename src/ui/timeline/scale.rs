//! Conversion between playing time and screen position. Times count units of the ms between keyframes from the first played keyframe.

/// The largest zoom, in points a unit.
pub const MOST_POINTS: f64 = 4000.0;
/// Fewer points a unit than this and an untouched timeline scrolls instead of shrinking.
const LEAST_AT_FIRST: f64 = 44.0;
/// More points a unit than this and an untouched timeline leaves room at its right.
const MOST_AT_FIRST: f64 = 168.0;
/// Room beside the first and the last keyframe, in points.
pub const MARGIN: f64 = 24.0;

/// The visible part of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VisibleTime {
    /// The time at the left edge.
    pub start: f64,
    /// Points for one unit of time.
    pub points_per_unit: f64,
}

impl VisibleTime {
    /// All of `first..=last`, with a margin at both sides.
    #[must_use]
    pub fn fitting(first: f64, last: f64, width: f32) -> Self {
        let room = (f64::from(width) - 2.0 * MARGIN).max(1.0);
        let points_per_unit = (room / (last - first).max(1e-9)).min(MOST_POINTS);
        Self { start: first - MARGIN / points_per_unit, points_per_unit }
    }

    /// The view of a timeline that was never zoomed: a readable scale, from the beginning.
    #[must_use]
    pub fn at_first(first: f64, last: f64, width: f32) -> Self {
        let fitting = Self::fitting(first, last, width);
        let points_per_unit = fitting.points_per_unit.clamp(LEAST_AT_FIRST, MOST_AT_FIRST);
        Self { start: first - MARGIN / points_per_unit, points_per_unit }
    }

    /// Zoomed by a factor, so that what is `from_left` points from the left edge stays there.
    #[must_use]
    pub fn zoomed(self, factor: f64, from_left: f32, least_points: f64) -> Self {
        let points_per_unit = (self.points_per_unit * factor).clamp(least_points.min(MOST_POINTS), MOST_POINTS);
        let at = self.start + f64::from(from_left) / self.points_per_unit;
        Self { start: at - f64::from(from_left) / points_per_unit, points_per_unit }
    }

    /// Moved so that what is seen goes `by` points to the right.
    #[must_use]
    pub fn panned(self, by: f32) -> Self {
        Self { start: self.start - f64::from(by) / self.points_per_unit, ..self }
    }

    /// Kept so that something of `first..=last` stays in sight.
    #[must_use]
    pub fn kept_near(self, first: f64, last: f64, width: f32) -> Self {
        let seen = f64::from(width) / self.points_per_unit;
        let margin = MARGIN / self.points_per_unit;
        // Where all of it fits it may stand anywhere in the half that is left over.
        let least = (first - margin).min(last + margin - seen).min(first - seen / 2.0);
        let most = (last + margin - seen).max(last - seen / 2.0).max(first - margin);
        Self { start: self.start.clamp(least, most), ..self }
    }

    /// Moved as little as brings a time into sight, with a little room beside it.
    #[must_use]
    pub fn showing(self, time: f64, width: f32) -> Self {
        let seen = f64::from(width) / self.points_per_unit;
        let edge = (MARGIN / 2.0 / self.points_per_unit).min(seen / 4.0);
        if (self.start + edge..=self.start + seen - edge).contains(&time) {
            return self;
        }
        let room = (2.0 * MARGIN / self.points_per_unit).min(seen / 4.0);
        let start = self.start.clamp(time + room - seen, time - room);
        Self { start, ..self }
    }

    /// Turned like a page where a time has left the sight.
    #[must_use]
    pub fn paged(self, time: f64, width: f32) -> Self {
        let seen = f64::from(width) / self.points_per_unit;
        if (self.start..=self.start + seen).contains(&time) { self } else { Self { start: time - seen * 0.1, ..self } }
    }
}

/// A view put on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// The left edge, in points.
    pub left: f32,
    /// The right edge, in points.
    pub right: f32,
    /// What is in sight.
    pub view: VisibleTime,
}

impl Scale {
    /// Where a time stands.
    #[must_use]
    pub fn x_of(&self, time: f64) -> f32 {
        let from_left = (time - self.view.start) * self.view.points_per_unit;
        #[expect(clippy::cast_possible_truncation, reason = "it is for points on a screen")]
        let from_left = from_left.clamp(-1e6, 1e6) as f32;
        self.left + from_left
    }

    /// The time at a horizontal position, in points.
    #[must_use]
    pub fn time_at(&self, x: f32) -> f64 {
        self.view.start + f64::from(x - self.left) / self.view.points_per_unit
    }

    /// A length of time for a distance.
    #[must_use]
    pub fn units(&self, points: f32) -> f64 {
        f64::from(points) / self.view.points_per_unit
    }

    /// The times in sight, and `beyond` points at both sides.
    #[must_use]
    pub fn in_sight(&self, beyond: f32) -> std::ops::RangeInclusive<f64> {
        self.time_at(self.left - beyond)..=self.time_at(self.right + beyond)
    }
}

/// The marks of the ruler: seconds from one labelled mark to the next, and into how many parts that is divided.
#[must_use]
pub fn marks(points_per_second: f64, least_points: f64) -> (f64, u32) {
    let least = least_points / points_per_second.max(1e-9);
    let power = 10_f64.powf(least.log10().floor());
    for (factor, parts) in [(1.0, 5), (2.0, 4), (5.0, 5)] {
        if factor * power >= least * (1.0 - 1e-9) {
            return (factor * power, parts);
        }
    }
    (10.0 * power, 5)
}

/// Seconds as a label, with as many decimals as marks this far apart need.
#[must_use]
pub fn seconds_text(seconds: f64, step: f64) -> String {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is between 0 and 6")]
    let decimals = (-step.log10().floor()).clamp(0.0, 6.0) as usize;
    format!("{seconds:.decimals$} s")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scale() -> Scale {
        Scale { left: 100.0, right: 900.0, view: VisibleTime { start: -1.0, points_per_unit: 80.0 } }
    }

    #[test]
    fn places_and_times_answer_each_other() {
        let scale = scale();
        assert_eq!(scale.x_of(-1.0), 100.0);
        assert_eq!(scale.x_of(0.0), 180.0);
        for time in [-3.0, 0.0, 0.123, 7.5] {
            assert!((scale.time_at(scale.x_of(time)) - time).abs() < 1e-5);
        }
    }

    #[test]
    fn zooming_keeps_what_is_under_the_pointer() {
        let mut scale = scale();
        let before = scale.time_at(430.0);
        for factor in [1.25, 0.3, 8.0, 1e9, 1e-9] {
            scale.view = scale.view.zoomed(factor, 330.0, 0.01);
            assert!((scale.time_at(430.0) - before).abs() < 1e-4, "after a zoom by {factor}");
            assert!((0.01..=MOST_POINTS).contains(&scale.view.points_per_unit));
        }
    }

    #[test]
    fn all_that_is_fitted_is_in_sight() {
        for (first, last) in [(-1.0, 4.0), (-1.0, 9998.0), (2.0, 2.0)] {
            let scale = Scale { left: 0.0, right: 800.0, view: VisibleTime::fitting(first, last, 800.0) };
            assert!((scale.x_of(first) - 24.0).abs() < 0.1);
            assert!(scale.x_of(last) <= 776.1);
        }
    }

    #[test]
    fn panning_ends_where_nothing_is_left_to_see() {
        let view = VisibleTime { start: 0.0, points_per_unit: 100.0 };
        let far = view.panned(-1e7).kept_near(-1.0, 4.0, 800.0);
        let scale = Scale { left: 0.0, right: 800.0, view: far };
        assert!((0.0..=800.0).contains(&scale.x_of(4.0)), "{far:?}");
        let far = view.panned(1e7).kept_near(-1.0, 4.0, 800.0);
        let scale = Scale { left: 0.0, right: 800.0, view: far };
        assert!((0.0..=800.0).contains(&scale.x_of(-1.0)), "{far:?}");
    }

    #[test]
    fn a_time_is_brought_into_sight() {
        let view = VisibleTime { start: 0.0, points_per_unit: 100.0 };
        assert_eq!(view.showing(4.0, 800.0), view);
        let shown = view.showing(40.0, 800.0);
        assert!(shown.start < 40.0 && shown.start + 8.0 > 40.0);
        assert_eq!(view.paged(4.0, 800.0), view);
        assert!((view.paged(8.1, 800.0).start - 7.3).abs() < 1e-9);
    }

    #[test]
    fn marks_are_round_and_far_enough_apart() {
        for points_per_second in [0.01, 0.3, 7.0, 50.0, 84.0, 2000.0] {
            let (step, _) = marks(points_per_second, 64.0);
            assert!(step * points_per_second >= 63.9 && step * points_per_second < 170.0);
        }
        assert_eq!(marks(64.0, 64.0), (1.0, 5));
        assert_eq!(seconds_text(1.5, 0.5), "1.5 s");
        assert_eq!(seconds_text(20.0, 10.0), "20 s");
    }
}
