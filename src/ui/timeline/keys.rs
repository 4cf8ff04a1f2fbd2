//! The rows of keys at their own times: where their diamonds stand, and what clicks and drags on them do.

use std::sync::Arc;

use egui::{CursorIcon, Key, Modifiers, PointerButton, Pos2, Rect, Response, Ui, pos2};

use super::drag::{Mode, SNAP, mode_of};
use super::hit::{RADIUS, Target};
use super::key_menu::Menu;
use super::rows::{Row, has_key_rows};
use crate::editor::{Command, Edit, Editor, GestureCommand, KeyAt, SceneEdit, Track, ViewCommand};

/// What is at a point of a row of keys.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KeyHit {
    /// Which row.
    pub row: usize,
    /// The time of the key there, in seconds; `None` beside all of them.
    pub key: Option<f64>,
}

/// A drag that goes on.
#[derive(Clone, Debug, PartialEq)]
enum KeyDrag {
    /// Moves keys in time.
    Move { keys: Vec<KeyAt>, grabbed: f64, from_x: f32, asked: f64, before: Vec<KeyAt> },
    /// Selects what it surrounds.
    Box { from_seconds: f64, from_y: f32, before: Vec<KeyAt>, mode: Mode },
}

/// What goes on in the rows of keys.
#[derive(Clone, Debug, Default)]
pub struct Keys {
    drag: Option<KeyDrag>,
    pub(super) hovered: Option<KeyHit>,
    pub(super) menu: Option<Menu>,
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
    let is_there = editor.holds_seconds() && (editor.seconds() - seconds).abs() < 1e-9;
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

    /// The time that stands at a place.
    pub fn seconds_at(&self, x: f32) -> f64 {
        self.target.scale.time_at(x) * seconds_per_unit(self.editor)
    }

    /// The same as people write it.
    pub fn tidy_at(&self, x: f32) -> f64 {
        tidy(self.seconds_at(x), self.seconds(1.0))
    }

    /// The channels whose keys stand in a row.
    pub fn tracks(&self, row: usize) -> Vec<Track> {
        let scene = self.editor.scene();
        let row = &self.rows[row];
        let node: Arc<str> = scene.node(row.node).path.as_str().into();
        row.channels(scene).iter().map(|&channel| Track { node: Arc::clone(&node), channel }).collect()
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
    fn keys_within(&self, rows: std::ops::Range<usize>, from: f64, to: f64) -> Vec<KeyAt> {
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
    fn at(&self, at: Pos2) -> Option<KeyHit> {
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
    fn snapped(&self, seconds: f64, moving: &[KeyAt], is_free: bool) -> f64 {
        let round = tidy(seconds, self.seconds(1.0));
        if is_free {
            return round;
        }
        let columns = self.target.columns;
        let unit = seconds_per_unit(self.editor);
        let keyframe = columns.nearest(seconds / unit).map(|place| columns.time(place) * unit);
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
    let beside = [after.checked_sub(1), Some(after)].into_iter().flatten().filter_map(|place| times.get(place));
    beside.copied().min_by(|a, b| (a - seconds).abs().total_cmp(&(b - seconds).abs()))
}

/// What a selection becomes.
pub(super) fn combined(before: &[KeyAt], taken: Vec<KeyAt>, mode: Mode) -> Vec<KeyAt> {
    let mut keys: Vec<KeyAt> = match mode {
        Mode::Replace => Vec::new(),
        Mode::Add => before.to_vec(),
        Mode::Toggle => before.iter().filter(|key| !taken.contains(key)).cloned().collect(),
    };
    let is_new = |key: &KeyAt| mode != Mode::Toggle || !before.contains(key);
    keys.extend(taken.into_iter().filter(is_new));
    keys
}

pub(super) const fn scene(edit: SceneEdit) -> Command {
    Command::Edit(Edit::Scene(edit))
}

impl Keys {
    /// Whether a drag goes on.
    pub const fn is_dragging(&self) -> bool {
        self.drag.is_some()
    }

    /// Takes in what the pointer does. Says whether it is busy here, so that nothing else takes part.
    pub fn pointer(&mut self, ui: &Ui, response: &Response, view: &KeyView<'_>, commands: &mut Vec<Command>) -> bool {
        let (modifiers, at, pressed_at) =
            ui.input(|input| (input.modifiers, input.pointer.latest_pos(), input.pointer.press_origin()));
        if self.drag.is_some() {
            self.hovered = None;
            self.go_on(ui, view, at, modifiers, commands);
            return true;
        }
        let place = pressed_at.or(at).filter(|_| response.hovered() || response.is_pointer_button_down_on());
        let hit = place.and_then(|place| view.at(place));
        self.hovered = hit;
        let (Some(hit), false) = (hit, ui.input(|input| input.pointer.middle_down())) else {
            self.hovered = None;
            return false;
        };
        if response.drag_started_by(PointerButton::Primary)
            && let Some(from) = pressed_at
        {
            self.begin(view, hit, from, modifiers, commands);
        } else if response.double_clicked() && hit.key.is_none() {
            if let Some(at) = at {
                add(view, hit.row, view.snapped(view.seconds_at(at.x), &[], modifiers.shift), commands);
            }
        } else if response.clicked() {
            pick(view, hit, modifiers, commands);
        }
        ui.ctx().set_cursor_icon(if hit.key.is_some() { CursorIcon::Grab } else { CursorIcon::Default });
        true
    }

    fn begin(
        &mut self,
        view: &KeyView<'_>,
        hit: KeyHit,
        from: Pos2,
        modifiers: Modifiers,
        commands: &mut Vec<Command>,
    ) {
        let before = view.editor.session().selected_keys.clone();
        let Some(grabbed) = hit.key else {
            let from_seconds = view.seconds_at(from.x);
            self.drag = Some(KeyDrag::Box { from_seconds, from_y: from.y, before, mode: mode_of(modifiers) });
            return;
        };
        if view.editor.is_playing() {
            return;
        }
        let under = view.keys_at(hit.row, grabbed);
        let keys = if under.iter().all(|key| before.contains(key)) { before.clone() } else { under };
        if keys != before {
            commands.push(Command::View(ViewCommand::SelectKeys(keys.clone())));
        }
        commands.push(Command::Gesture(GestureCommand::Begin));
        self.drag = Some(KeyDrag::Move { keys, grabbed, from_x: from.x, asked: 0.0, before });
    }

    fn go_on(
        &mut self,
        ui: &Ui,
        view: &KeyView<'_>,
        at: Option<Pos2>,
        modifiers: Modifiers,
        commands: &mut Vec<Command>,
    ) {
        let Some(drag) = &mut self.drag else { return };
        if ui.input(|input| input.key_pressed(Key::Escape)) {
            let is_move = matches!(drag, KeyDrag::Move { .. });
            if is_move {
                commands.push(Command::Gesture(GestureCommand::Abort));
            }
            let (KeyDrag::Move { before, .. } | KeyDrag::Box { before, .. }) = drag;
            commands.push(Command::View(ViewCommand::SelectKeys(std::mem::take(before))));
            self.drag = None;
            return;
        }
        match drag {
            KeyDrag::Move { keys, grabbed, from_x, asked, .. } => {
                ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
                if let Some(at) = at {
                    let moved = *grabbed + view.seconds(at.x - *from_x);
                    let now: Vec<KeyAt> = view.editor.session().selected_keys.clone();
                    let by = view.snapped(moved, &now, modifiers.shift) - *grabbed;
                    if by.to_bits() != asked.to_bits() {
                        *asked = by;
                        commands.push(scene(SceneEdit::MoveKeys { keys: keys.clone(), by }));
                    }
                }
            }
            KeyDrag::Box { from_seconds, from_y, before, mode } => {
                ui.ctx().set_cursor_icon(CursorIcon::Crosshair);
                if let Some(at) = at {
                    let to = view.seconds_at(at.x);
                    let rows = rows_between(view.target, *from_y, at.y);
                    let taken = view.keys_within(rows, from_seconds.min(to), from_seconds.max(to));
                    let keys = combined(before, taken, *mode);
                    let selected = &view.editor.session().selected_keys;
                    if keys.len() != selected.len() || !keys.iter().all(|key| selected.contains(key)) {
                        commands.push(Command::View(ViewCommand::SelectKeys(keys)));
                    }
                }
            }
        }
        if !ui.input(|input| input.pointer.any_down()) && matches!(self.drag.take(), Some(KeyDrag::Move { .. })) {
            commands.push(Command::Gesture(GestureCommand::Commit));
        }
    }

    /// The rectangle that a drag surrounds.
    pub(super) fn surrounded(&self, view: &KeyView<'_>, at: Pos2) -> Option<Rect> {
        let Some(KeyDrag::Box { from_seconds, from_y, .. }) = &self.drag else { return None };
        Some(Rect::from_two_pos(pos2(view.x_of(*from_seconds), *from_y), at).intersect(view.target.layout.nodes))
    }

    /// The time that a dragged key has now, in seconds, and by how many it moved.
    pub(super) fn dragged(&self) -> Option<(f64, f64)> {
        match &self.drag {
            Some(KeyDrag::Move { grabbed, asked, .. }) => Some((grabbed + asked, *asked)),
            _ => None,
        }
    }
}

/// The rows of a stretch of heights.
fn rows_between(target: &Target<'_>, from: f32, to: f32) -> std::ops::Range<usize> {
    let nodes = target.layout.nodes;
    let row = |y: f32| target.node_row_at(y.clamp(nodes.top() + 0.5, nodes.bottom() - 0.5));
    let (top, bottom) = (row(from.min(to)), row(from.max(to)));
    top.unwrap_or(target.rows)..bottom.map_or(target.rows, |row| row + 1)
}

/// Adds keys at a time to the channels of a row that have some, or to all where none has.
pub(super) fn add(view: &KeyView<'_>, row: usize, seconds: f64, commands: &mut Vec<Command>) {
    if view.editor.is_playing() {
        return;
    }
    let has_some = view.times(row).any(|times| !times.is_empty());
    let tracks = view.tracks(row).into_iter().zip(view.times(row));
    let keys = tracks.filter(|(_, times)| !has_some || !times.is_empty()).map(|(track, _)| KeyAt { track, seconds });
    commands.push(scene(SceneEdit::AddKeys(keys.collect())));
}

/// Takes in a click: on a key it selects, and alone it shows that time too; beside all it selects none.
pub(super) fn pick(view: &KeyView<'_>, hit: KeyHit, modifiers: Modifiers, commands: &mut Vec<Command>) {
    let selected = &view.editor.session().selected_keys;
    let mode = mode_of(modifiers);
    let Some(seconds) = hit.key else {
        if mode == Mode::Replace && !selected.is_empty() {
            commands.push(Command::View(ViewCommand::SelectKeys(Vec::new())));
        }
        return;
    };
    let keys = combined(selected, view.keys_at(hit.row, seconds), mode);
    commands.push(Command::View(ViewCommand::SelectKeys(keys)));
    if mode == Mode::Replace && seconds >= 0.0 && !view.editor.is_playing() {
        commands.push(Command::View(ViewCommand::ScrubSeconds(seconds)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Channel;

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

    #[test]
    fn selections_combine() {
        let key = |seconds| KeyAt::new("a", Channel::Scale, seconds);
        let (before, taken) = ([key(0.0), key(1.0)], vec![key(1.0), key(2.0)]);
        assert_eq!(combined(&before, taken.clone(), Mode::Replace), taken);
        assert_eq!(combined(&before, taken.clone(), Mode::Toggle), [key(0.0), key(2.0)]);
        assert_eq!(combined(&before, taken, Mode::Add).len(), 4, "the editor drops what stands twice");
    }
}
