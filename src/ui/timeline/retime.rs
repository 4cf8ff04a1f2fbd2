//! Drags that change when keyframes come: of diamonds, of the edges of what is selected, and of intervals' handles.

use egui::Modifiers;

use super::columns::Columns;
use super::drag::{SNAP, moves_anything};
use super::hit::Target;
use super::scale::VisibleTime;
use crate::clock::TICKS_PER_SECOND;
use crate::editor::{Command, Edit, TimelineEdit};
use crate::keyframe::{DURATION_RANGE, KeyframeIndex, Retimed, Retiming, StretchEnd};

/// The shortest interval that a drag of a handle makes: its durations are rounded to hundredths.
const SHORTEST_DRAGGED: f64 = *DURATION_RANGE.start() * 10.0;

/// A drag of selected keyframes. It is counted from where it began, so that passing something leaves no trace.
#[derive(Clone, Debug, PartialEq)]
pub struct Moving {
    /// The keyframe under the pointer.
    pub grabbed: usize,
    /// The edge of what is selected that is dragged; `None`: the keyframes themselves.
    pub end: Option<StretchEnd>,
    /// The dragged keyframes, in order.
    pub indices: Vec<usize>,
    /// The keyframes as they were.
    pub before: Columns,
    /// What was in sight.
    pub view_before: VisibleTime,
    from_x: f32,
    /// What was asked for last.
    asked: Retiming,
    /// By how many milliseconds the keyframes have moved.
    pub by_ms: i32,
    origin_ms: f64,
    /// The place in the list that they move to instead; `None` while they stay between their neighbours.
    pub place: Option<usize>,
}

impl Moving {
    /// A drag that begins at a horizontal position.
    #[must_use]
    pub fn new(target: &Target<'_>, grabbed: usize, end: Option<StretchEnd>, indices: Vec<usize>, from_x: f32) -> Self {
        Self {
            grabbed,
            end,
            indices,
            before: target.columns.clone(),
            view_before: target.scale.view,
            from_x,
            asked: Retiming { by_ms: 0, end, ripples: false },
            by_ms: 0,
            origin_ms: 0.0,
            place: None,
        }
    }

    /// Whether what follows moves along.
    #[must_use]
    pub const fn ripples(&self) -> bool {
        self.asked.ripples
    }

    /// The time of the dragged keyframe when the pointer is at a horizontal position, in units of the ms between keyframes.
    #[must_use]
    pub fn time(&self, x: f32) -> f64 {
        self.before.time(self.grabbed) + f64::from(x - self.from_x) / self.view_before.points_per_unit
    }

    /// Takes in where the pointer is. Returns the edit that this asks for, if it is a new one.
    pub fn follow(&mut self, target: &Target<'_>, ms: u32, x: f32, modifiers: Modifiers) -> Option<Retiming> {
        let time = self.time(x);
        self.place = self.place_at(time).filter(|_| self.end.is_none() && !modifiers.shift);
        let is_free = modifiers.command || modifiers.ctrl;
        let by_ms = if self.place.is_some() { 0 } else { self.snapped(time, ms, target, is_free) };
        let retiming = Retiming { by_ms, end: self.end, ripples: modifiers.shift };
        let durations: Vec<f64> = self.before.keyframes().iter().map(|keyframe| keyframe.duration).collect();
        let Retimed { by_ms, origin_ms, .. } = retiming.of(&durations, ms, &self.indices);
        (self.by_ms, self.origin_ms) = (by_ms, origin_ms);
        let is_new = retiming != self.asked;
        self.asked = retiming;
        is_new.then_some(retiming)
    }

    /// The keyframes between which a drag changes the interval, the one that stays first: the neighbour of what moves, or the other end
    /// of a stretch.
    #[must_use]
    pub fn anchored(&self) -> Option<(usize, usize)> {
        let is_dragged = |index: &usize| self.indices.binary_search(index).is_ok();
        let (first, last) = (*self.indices.first()?, *self.indices.last()?);
        Some(match self.end {
            Some(StretchEnd::Start) => (last, first),
            Some(StretchEnd::End) => (first, last),
            None => {
                if let Some(before) = (0..self.grabbed).rev().find(|index| !is_dragged(index)) {
                    return Some((before, before + 1));
                }
                let after = (self.grabbed..self.before.len()).find(|index| !is_dragged(index))?;
                (after, after - 1)
            }
        })
    }

    /// The place in the list for a time that is past a neighbour.
    fn place_at(&self, time: f64) -> Option<usize> {
        let is_dragged = |index: &usize| self.indices.binary_search(index).is_ok();
        let before = (0..self.grabbed).rev().find(|index| !is_dragged(index));
        let after = (self.grabbed + 1..self.before.len()).find(|index| !is_dragged(index));
        let is_past = before.is_some_and(|index| time < self.before.time(index))
            || after.is_some_and(|index| time > self.before.time(index));
        let place = self.before.insertion(time);
        (is_past && moves_anything(&self.indices, place)).then_some(place)
    }

    /// By how many milliseconds the keyframe moves to a time: near a tenth of a step it is the tenth, else a tick of the clock.
    fn snapped(&self, time: f64, ms: u32, target: &Target<'_>, is_free: bool) -> i32 {
        let unit = f64::from(ms);
        let from = self.before.time(self.grabbed);
        let moved = time - from;
        let tenth = self.anchored().map_or(moved, |(fixed, moving)| {
            let interval = self.before.time(moving) - self.before.time(fixed);
            ((interval + moved) * 10.0).round() / 10.0 - interval
        });
        let by = if is_free {
            moved * unit
        } else if (tenth - moved).abs() <= target.scale.units(SNAP) {
            tenth * unit
        } else {
            let tick_ms = 1000.0 / f64::from(TICKS_PER_SECOND);
            (time * unit / tick_ms).round() * tick_ms - from * unit
        };
        #[expect(clippy::cast_possible_truncation, reason = "floats saturate")]
        let by = by.round() as i32;
        by
    }

    /// What is in sight now. Times are counted from keyframe 1, so where that moves all others would move on the screen instead.
    #[must_use]
    pub fn view(&self, ms: u32) -> VisibleTime {
        VisibleTime { start: self.view_before.start - self.origin_ms / f64::from(ms), ..self.view_before }
    }
}

/// A drag of an interval's end by its handle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Retime {
    /// The keyframe where the interval begins.
    pub index: usize,
    /// Where the drag began.
    from_x: f32,
    /// The interval's duration at the start of the drag.
    duration_before: f64,
    /// The duration of the next interval at the start of the drag, if there is one.
    next_duration_before: Option<f64>,
    /// The duration that the drag set last.
    pub last_duration: f64,
    /// Whether the drag last changed the next interval too, so that later keyframes stay in place.
    pub last_ripple_free: bool,
}

impl Retime {
    /// The interval's length after the pointer moved by this many units.
    #[must_use]
    pub fn duration(&self, moved: f64, snap: f64) -> f64 {
        // Interval 0 is drawn to the left of its grip, so a move to the left lengthens it.
        let moved = if self.index == 0 { -moved } else { moved };
        let duration = self.duration_before + moved;
        let rounded = if (duration - 1.0).abs() <= snap { 1.0 } else { (duration * 100.0).round() / 100.0 };
        rounded.clamp(SHORTEST_DRAGGED, *DURATION_RANGE.end())
    }

    /// A drag of the handle of the interval at `index` that begins at a horizontal position. `next` is the next interval's duration.
    #[must_use]
    pub const fn new(index: usize, from_x: f32, own: f64, next: Option<f64>) -> Self {
        Self {
            index,
            from_x,
            duration_before: own,
            next_duration_before: next,
            last_duration: own,
            last_ripple_free: false,
        }
    }

    /// Takes in where the pointer is. With `gives` the next interval gives what this one takes.
    pub fn follow(&mut self, target: &Target<'_>, x: f32, gives: bool, commands: &mut Vec<Command>) {
        let duration = self.duration(target.scale.units(x - self.from_x), target.scale.units(SNAP));
        let ripple_free = gives && self.next_duration_before.is_some();
        if (duration, ripple_free) == (self.last_duration, self.last_ripple_free) {
            return;
        }
        self.last_duration = duration;
        let was_ripple_free = std::mem::replace(&mut self.last_ripple_free, ripple_free);
        let mut set = |index: usize, duration: f64, ripple_free: bool| {
            let keyframe = KeyframeIndex::new(index);
            let edit = TimelineEdit::SetDuration { keyframe, duration, ripple_free };
            commands.push(Command::Edit(Edit::Timeline(edit)));
        };
        if was_ripple_free != ripple_free {
            // Restore the neighbour's duration first; a ripple-free change then starts from it.
            set(self.index, self.duration_before, false);
            if let Some(neighbour) = self.next_duration_before {
                set(self.index + 1, neighbour, false);
            }
        }
        set(self.index, duration, ripple_free);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_round_and_one_unit_attracts() {
        let retime = |index| Retime::new(index, 0.0, 1.5, None);
        assert_eq!(retime(2).duration(0.123_4, 0.05), 1.62);
        assert_eq!(retime(2).duration(-0.48, 0.05), 1.0);
        assert_eq!(retime(2).duration(-9.0, 0.05), 0.01);
        assert_eq!(retime(0).duration(-0.25, 0.05), 1.75, "the first interval grows to the left");
    }
}
