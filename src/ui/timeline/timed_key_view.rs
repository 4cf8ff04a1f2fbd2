//! Positions of timed keys on the timeline, and hit tests for them.

use std::sync::Arc;

use egui::Pos2;

use super::drag::SNAP;
use super::hit::{RADIUS, Target};
use super::rows::{Row, has_key_rows};
use crate::editor::{Command, Editor, KeyAt, TrackPath, ViewCommand};

/// What is at a point of a row of keys.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KeyHit {
    /// Which row.
    pub row: usize,
    /// The time of the key there, in seconds; `None` beside all of them.
    pub key: Option<f64>,
}

/// What the rows of keys need to know.
#[derive(Clone, Copy)]
pub struct KeyView<'a> {
    /// All state.
    pub editor: &'a Editor,
    /// Where everything is.
    pub target: &'a Target<'a>,
    /// All rows.
    pub rows: &'a [Row],
}

/// How long one unit of the timeline lasts, in seconds.
fn seconds_per_unit(editor: &Editor) -> f64 {
    f64::from(editor.document().ms_between_keyframes) / 1000.0
}

/// A time as people write it: as round as can be without leaving the point of the screen that it is for, to milliseconds at least.
fn tidy(seconds: f64, seconds_per_point: f64) -> f64 {
    let step = 10_f64.powf(seconds_per_point.max(1e-9).log10().floor()).clamp(0.001, 1.0);
    let parts = (1.0 / step).round();
    (seconds * parts).round() / parts + 0.0
}

/// The time of the clock of the keys, to the millisecond: where keys are added "at the playhead".
pub(super) fn playhead(editor: &Editor) -> f64 {
    (editor.seconds() * 1000.0).round() / 1000.0
}

/// The first and the last key of a scene, in units of the timeline.
pub(super) fn ends(editor: &Editor) -> Option<(f64, f64)> {
    let scene = editor.scene();
    if !has_key_rows(scene) {
        return None;
    }
    let (mut first, mut last) = (0.0_f64, 0.0_f64);
    for (id, _) in scene.nodes_with_ids() {
        for &channel in scene.channels(id) {
            if let [from, .., to] | [from @ to] = scene.key_seconds(id, channel) {
                (first, last) = (first.min(*from), last.max(*to));
            }
        }
    }
    let unit = seconds_per_unit(editor);
    Some((first / unit, last / unit))
}

/// The first and the last of the selected keys, in units of the timeline.
pub(super) fn ends_of_selection(editor: &Editor) -> Option<(f64, f64)> {
    let unit = seconds_per_unit(editor);
    let times = editor.session().selected_keys.iter().map(|key| key.seconds / unit);
    times.fold(None, |ends, at| {
        ends.map_or(Some((at, at)), |(first, last): (f64, f64)| Some((first.min(at), last.max(at))))
    })
}

/// What brings the clock of the keys under the pointer on the ruler, unless it is there.
pub(super) fn scrubbing(target: &Target<'_>, editor: &Editor, x: f32) -> Option<Command> {
    let view = KeyView { editor, target, rows: &[] };
    let seconds = view.tidy_at(x).max(0.0);
    let is_there = editor.holds_timed_keys() && (editor.seconds() - seconds).abs() < 1e-9;
    (has_key_rows(editor.scene()) && !is_there).then_some(Command::View(ViewCommand::ScrubSeconds(seconds)))
}

impl KeyView<'_> {
    /// Where a time stands.
    pub fn x_of(&self, seconds: f64) -> f32 {
        self.target.scale.x_of(seconds / seconds_per_unit(self.editor))
    }

    /// How many seconds a distance in points is.
    pub fn seconds(&self, points: f32) -> f64 {
        self.target.scale.units(points) * seconds_per_unit(self.editor)
    }

    /// The time at a horizontal position, in points.
    pub fn seconds_at(&self, x: f32) -> f64 {
        self.target.scale.time_at(x) * seconds_per_unit(self.editor)
    }

    /// The same as people write it.
    pub fn tidy_at(&self, x: f32) -> f64 {
        tidy(self.seconds_at(x), self.seconds(1.0))
    }

    /// The channels whose keys stand in a row.
    pub fn tracks(&self, row: usize) -> Vec<TrackPath> {
        let scene = self.editor.scene();
        let row = &self.rows[row];
        let node: Arc<str> = scene.node(row.node).path.as_str().into();
        row.channels(scene).iter().map(|&channel| TrackPath { node: Arc::clone(&node), channel }).collect()
    }

    /// The times of all keys of a row in seconds, a list for each channel.
    pub fn times(&self, row: usize) -> impl Iterator<Item = &[f64]> {
        let (scene, row) = (self.editor.scene(), &self.rows[row]);
        row.channels(scene).iter().map(|&channel| scene.key_seconds(row.node, channel))
    }

    /// The keys of a row that stand at just this time.
    pub fn keys_at(&self, row: usize, seconds: f64) -> Vec<KeyAt> {
        let tracks = self.tracks(row).into_iter().zip(self.times(row));
        tracks.filter(|(_, times)| times.contains(&seconds)).map(|(track, _)| KeyAt { track, seconds }).collect()
    }

    /// The keys of some rows in a stretch of time.
    pub fn keys_within(&self, rows: std::ops::Range<usize>, from: f64, to: f64) -> Vec<KeyAt> {
        let mut keys = Vec::new();
        for row in rows.filter(|&row| self.rows[row].has_keys()) {
            for (track, times) in self.tracks(row).into_iter().zip(self.times(row)) {
                let within = times.iter().filter(|&&at| (from..=to).contains(&at));
                keys.extend(within.map(|&seconds| KeyAt { track: track.clone(), seconds }));
            }
        }
        keys
    }

    /// What is at a point, if that is in a row of keys.
    pub fn at(&self, at: Pos2) -> Option<KeyHit> {
        if !self.target.layout.nodes.contains(at) {
            return None;
        }
        let row = self.target.node_row_at(at.y).filter(|&row| self.rows[row].has_keys())?;
        let under = self.seconds_at(at.x);
        let nearest = self.times(row).filter_map(|times| nearest(times, under));
        let key = nearest.min_by(|a, b| (a - under).abs().total_cmp(&(b - under).abs()));
        let is_over = |key: &f64| (self.x_of(*key) - at.x).abs() <= RADIUS + 1.5;
        Some(KeyHit { row, key: key.filter(is_over) })
    }

    /// A time under a dragged key: near to another key, a keyframe or the playhead it is just there.
    pub fn snapped(&self, seconds: f64, moving: &[KeyAt], is_free: bool) -> f64 {
        let round = tidy(seconds, self.seconds(1.0));
        if is_free {
            return round;
        }
        let columns = self.target.columns;
        let unit = seconds_per_unit(self.editor);
        let keyframe = columns.nearest(seconds / unit).map(|index| columns.time(index) * unit);
        let mut candidates: Vec<f64> = keyframe.into_iter().chain([0.0, playhead(self.editor)]).collect();
        for row in (0..self.rows.len()).filter(|&row| self.rows[row].has_keys()) {
            for (track, times) in self.tracks(row).into_iter().zip(self.times(row)) {
                let stays = |at: f64| !moving.iter().any(|key| key.track == track && key.seconds == at);
                candidates.extend(nearest(times, seconds).filter(|&at| stays(at)));
            }
        }
        let near = candidates.into_iter().filter(|at| (at - seconds).abs() <= self.seconds(SNAP));
        near.min_by(|a, b| (a - seconds).abs().total_cmp(&(b - seconds).abs())).unwrap_or(round)
    }
}

/// The time nearest to one.
fn nearest(times: &[f64], seconds: f64) -> Option<f64> {
    let after = times.partition_point(|&at| at <= seconds);
    let beside = [after.checked_sub(1), Some(after)].into_iter().flatten().filter_map(|index| times.get(index));
    beside.copied().min_by(|a, b| (a - seconds).abs().total_cmp(&(b - seconds).abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_as_round_as_the_screen_allows() {
        assert_eq!(tidy(1.234_567, 0.012), 1.23);
        assert_eq!(tidy(1.234_567, 0.000_01), 1.235);
        assert_eq!(tidy(1.234_567, 0.3), 1.2);
        assert_eq!(tidy(1.6, 40.0), 2.0);
        assert_eq!(tidy(-0.000_1, 0.01).to_bits(), 0.0_f64.to_bits(), "no zero has a sign");
    }

    #[test]
    fn the_nearest_key_is_found() {
        let times = [0.0, 1.0, 4.0];
        assert_eq!(
            [-3.0, 0.4, 0.6, 2.4, 2.6, 9.0].map(|at| nearest(&times, at).unwrap()),
            [0.0, 0.0, 1.0, 1.0, 4.0, 4.0]
        );
        assert_eq!(nearest(&[], 1.0), None);
    }
}
