//! What is taken off for lateness.

use serde::Deserialize;

use super::cells::number;
use super::marks::Marks;
use super::note::Note;
use crate::text::counted;

/// What a rubric takes off for lateness.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Late {
    /// Days that cost nothing.
    pub free_days: u32,
    /// The percentage of the points that each further day costs.
    pub percent_a_day: f64,
}

impl Default for Late {
    fn default() -> Self {
        Self { free_days: 0, percent_a_day: 10.0 }
    }
}

impl Late {
    /// The first invalid number, as a sentence.
    pub(super) fn problem(&self) -> Option<String> {
        let Self { free_days, percent_a_day } = *self;
        if free_days > 365 {
            return Some(format!("late.free_days is {free_days}, expected a whole number from 0 to 365"));
        }
        let is_percentage = (0.0..=100.0).contains(&percent_a_day);
        (!is_percentage).then(|| format!("late.percent_a_day is {percent_a_day}, expected 0 to 100"))
    }

    /// Takes the points off, with a note. Where nothing tells how late a submission is, it is one day.
    pub fn apply(&self, marks: &mut [Marks]) {
        for marks in marks.iter_mut().filter(|marks| marks.is_late && !marks.is_missing) {
            let days = marks.days_late.unwrap_or(1);
            let percent = (f64::from(days.saturating_sub(self.free_days)) * self.percent_a_day).min(100.0);
            let free = if self.free_days > 0 {
                format!(", {} free", counted(self.free_days as usize, "day"))
            } else {
                String::new()
            };
            marks.late_points = marks.earned() * percent / 100.0;
            let sentence =
                format!("{} late{free}: {} % of the points are lost.", counted(days as usize, "day"), number(percent));
            marks.notes.insert(
                0,
                if marks.days_late.is_some() {
                    Note::quiet(sentence)
                } else {
                    Note::to_look_at(format!(
                        "{sentence} The course system says only that it is late, so one day is assumed."
                    ))
                },
            );
        }
    }
}

/// Whole days from a lateness as Gradescope writes it, hours, minutes and seconds: `26:03:12` is 2. `None` if it is no such text.
pub fn days_of(lateness: &str) -> Option<u32> {
    let parts: Vec<u32> = lateness.split(':').map(|part| part.parse().ok()).collect::<Option<_>>()?;
    let [hours, minutes, seconds] = parts[..] else { return None };
    let is_over = minutes > 0 || seconds > 0 || hours % 24 > 0;
    Some(hours / 24 + u32::from(is_over))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_day_that_has_begun_is_a_day() {
        let of = |text: &str| days_of(text);
        assert_eq!(["00:00:01", "24:00:00", "24:00:01", "26:03:12", "72:00:00"].map(of), [1, 1, 2, 2, 3].map(Some));
        assert_eq!(["", "true", "1", "1:2", "a:b:c", "1:2:3:4", "-1:00:00"].map(of), [None; 7]);
    }
}
