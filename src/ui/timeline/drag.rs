//! Drags and clicks on the timeline.

use egui::{CursorIcon, Modifiers, PointerButton, Pos2, Rect, Response, Ui};

use super::Timeline;
use super::hit::{Hit, Target};
use super::retime::{Moving, Retime};
use crate::editor::{Command, Edit, Editor, GestureCommand, PlaybackCommand, SelectionCommand, TimelineEdit};
use crate::keyframe::{KeyframeIndex, StretchEnd};

/// The distance in points within which a dragged interval snaps to one unit.
pub(super) const SNAP: f32 = 4.0;

/// A drag that goes on.
#[derive(Clone, Debug, PartialEq)]
pub enum Drag {
    /// The playhead follows the pointer.
    Scrub,
    /// Selects the keyframes inside a box. Combined with the earlier selection by `mode`.
    Box { from_time: f64, from_y: f32, before: Vec<KeyframeIndex>, mode: Mode },
    /// Moves the selected keyframes in time, or an end of them, or past a neighbour in the list.
    Move(Box<Moving>),
    /// Changes the length of the interval that begins at a keyframe.
    Retime(Retime),
    /// Moves the beginning of what plays, or its end.
    PlayRange { is_start: bool, before: Option<(usize, usize)> },
    /// Pans the view.
    Pan,
}

/// How keyframes are added to a selection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// They replace it.
    Replace,
    /// They are added.
    Add,
    /// Selected ones are deselected, and the other way round.
    Toggle,
}

/// Combines keyframes with the earlier selection. `before`, `taken` and the result are sorted.
#[must_use]
pub fn combined(before: &[KeyframeIndex], taken: std::ops::Range<usize>, mode: Mode) -> Vec<KeyframeIndex> {
    let is_taken = |keyframe_index: &KeyframeIndex| taken.contains(&keyframe_index.get());
    let mut selected: Vec<KeyframeIndex> = match mode {
        Mode::Replace => Vec::new(),
        Mode::Add | Mode::Toggle => before.iter().filter(|keyframe_index| !is_taken(keyframe_index)).copied().collect(),
    };
    let keeps = |keyframe_index: &KeyframeIndex| mode != Mode::Toggle || before.binary_search(keyframe_index).is_err();
    selected.extend(taken.clone().map(KeyframeIndex::new).filter(keeps));
    selected.sort_unstable();
    selected
}

/// Whether inserting these keyframes before `to` changes the order of the list.
#[must_use]
pub fn moves_anything(indices: &[usize], to: usize) -> bool {
    let (Some(&first), Some(&last)) = (indices.first(), indices.last()) else { return false };
    let is_one_run = last - first + 1 == indices.len();
    !(is_one_run && (first..=last + 1).contains(&to))
}

pub(super) const fn mode_of(modifiers: Modifiers) -> Mode {
    if modifiers.command || modifiers.ctrl {
        Mode::Toggle
    } else if modifiers.shift {
        Mode::Add
    } else {
        Mode::Replace
    }
}

impl Timeline {
    /// Takes in what the pointer does over ruler and tracks.
    pub(super) fn pointer(
        &mut self,
        ui: &Ui,
        response: &Response,
        target: &Target<'_>,
        editor: &Editor,
        commands: &mut Vec<Command>,
    ) {
        let modifiers = ui.input(|input| input.modifiers);
        let pressed_at = ui.input(|input| input.pointer.press_origin());
        let at = ui.input(|input| input.pointer.latest_pos());
        self.hovered = at.filter(|_| response.hovered() && self.drag.is_none()).map(|at| target.at(at));
        if self.drag.is_some() && ui.input(|input| input.key_pressed(egui::Key::Escape)) {
            self.abort(commands);
            return;
        }
        self.begin(ui, response, target, editor, pressed_at.zip(Some(modifiers)), commands);
        if let (Some(at), true) = (at, self.drag.is_some()) {
            self.follow(ui, target, editor, at, modifiers, commands);
        }
        let is_over = !ui.input(|input| input.pointer.any_down());
        if is_over && self.drag.is_some() {
            self.finish(commands);
        } else if response.clicked()
            && let Some(at) = response.interact_pointer_pos()
        {
            if let Hit::Diamond(index) = target.at(at)
                && response.double_clicked()
                && !editor.is_playing()
            {
                self.start_renaming(editor, Some(KeyframeIndex::new(index)));
            } else {
                self.click(target, editor, at, modifiers, commands);
            }
        }
        self.cursor(ui, response);
    }

    fn abort(&mut self, commands: &mut Vec<Command>) {
        match self.drag.take() {
            Some(Drag::Retime(_)) => commands.push(Command::Gesture(GestureCommand::Abort)),
            Some(Drag::Move(moving)) => {
                self.shift_view(moving.view_before);
                commands.push(Command::Gesture(GestureCommand::Abort));
            }
            Some(Drag::Box { before, .. }) => commands.push(Command::Selection(SelectionCommand::Keyframes(before))),
            Some(Drag::PlayRange { before, .. }) => commands.push(Command::Playback(PlaybackCommand::SetRange(before))),
            _ => {}
        }
    }

    fn begin(
        &mut self,
        ui: &Ui,
        response: &Response,
        target: &Target<'_>,
        editor: &Editor,
        pressed: Option<(Pos2, Modifiers)>,
        commands: &mut Vec<Command>,
    ) {
        let Some((at, modifiers)) = pressed else { return };
        if response.drag_started_by(PointerButton::Middle) {
            self.drag = Some(Drag::Pan);
            return;
        }
        let presses = response.is_pointer_button_down_on() && ui.input(|input| input.pointer.primary_pressed());
        let hit = target.at(at);
        if presses && self.drag.is_none() {
            // The playhead follows at once. Other drags start after the pointer has moved too far for a click.
            match hit {
                Hit::Ruler => self.drag = Some(Drag::Scrub),
                Hit::RangeStart | Hit::RangeEnd => {
                    let before = editor.session().play_range;
                    self.drag = Some(Drag::PlayRange { is_start: hit == Hit::RangeStart, before });
                }
                Hit::Diamond(_) | Hit::StretchEdge(_) | Hit::Grip(_) | Hit::HalfTurnWarning(_) | Hit::Empty => {}
            }
        }
        if !response.drag_started_by(PointerButton::Primary) || self.drag.is_some() {
            return;
        }
        let selected = &editor.session().selected;
        match hit {
            Hit::Ruler | Hit::RangeStart | Hit::RangeEnd => {}
            Hit::Empty | Hit::HalfTurnWarning(_) => {
                let mode = mode_of(modifiers);
                let from_time = target.scale.time_at(at.x);
                self.drag = Some(Drag::Box { from_time, from_y: at.y, before: selected.clone(), mode });
            }
            Hit::Diamond(_) | Hit::Grip(_) | Hit::StretchEdge(_) if editor.is_playing() => {}
            Hit::Diamond(index) => {
                let keyframe_index = KeyframeIndex::new(index);
                let mut indices = editor.edited_keyframes();
                if selected.binary_search(&keyframe_index).is_err() {
                    commands.push(Command::Selection(SelectionCommand::Keyframes(vec![keyframe_index])));
                    indices = vec![index];
                }
                commands.push(Command::Gesture(GestureCommand::Begin));
                self.drag = Some(Drag::Move(Box::new(Moving::new(target, index, None, indices, at.x))));
            }
            Hit::StretchEdge(end) => {
                let Some((first, last)) = target.stretch else { return };
                let grabbed = if end == StretchEnd::Start { first } else { last };
                commands.push(Command::Gesture(GestureCommand::Begin));
                let moving = Moving::new(target, grabbed, Some(end), editor.edited_keyframes(), at.x);
                self.drag = Some(Drag::Move(Box::new(moving)));
            }
            Hit::Grip(index) => {
                let duration = |index: usize| {
                    editor.document().keyframes.get(KeyframeIndex::new(index)).map(|keyframe| keyframe.duration)
                };
                let Some(own) = duration(index) else { return };
                let next = duration(index + 1);
                commands.push(Command::Gesture(GestureCommand::Begin));
                self.drag = Some(Drag::Retime(Retime::new(index, at.x, own, next)));
            }
        }
    }

    fn follow(
        &mut self,
        ui: &Ui,
        target: &Target<'_>,
        editor: &Editor,
        at: Pos2,
        modifiers: Modifiers,
        commands: &mut Vec<Command>,
    ) {
        match &mut self.drag {
            None => {}
            Some(Drag::Move(moving)) => {
                let ms_between_keyframes = editor.document().ms_between_keyframes;
                if let Some(retiming) = moving.follow(target, ms_between_keyframes, at.x, modifiers) {
                    commands.push(Command::Edit(Edit::Timeline(TimelineEdit::RetimeKeyframes(retiming))));
                }
                let view = moving.view(ms_between_keyframes);
                self.shift_view(view);
            }
            Some(Drag::Pan) => {
                let by = ui.input(|input| input.pointer.delta());
                self.pan(by.x, target);
                self.scroll = (self.scroll - by.y).max(0.0);
            }
            Some(Drag::Scrub) => {
                if let Some(command) = scrubbing(target, editor, at.x, modifiers.shift) {
                    commands.push(command);
                }
                commands.extend(super::timed_key_view::scrubbing(target, editor, at.x));
            }
            Some(Drag::PlayRange { is_start, .. }) => {
                if let Some(command) = move_range_end(target, at.x, *is_start) {
                    commands.push(command);
                }
            }
            Some(Drag::Box { from_time, before, mode, .. }) => {
                let to_time = target.scale.time_at(at.x);
                let taken = target.columns.within(&(from_time.min(to_time)..=from_time.max(to_time)));
                let selected = combined(before, taken, *mode);
                if selected != editor.session().selected {
                    commands.push(Command::Selection(SelectionCommand::Keyframes(selected)));
                }
            }
            Some(Drag::Retime(retime)) => {
                retime.follow(target, at.x, modifiers.shift, commands);
            }
        }
    }

    fn finish(&mut self, commands: &mut Vec<Command>) {
        match self.drag.take() {
            Some(Drag::Retime(_)) => commands.push(Command::Gesture(GestureCommand::Commit)),
            Some(Drag::Move(moving)) => commands.push(match moving.place {
                Some(to) => Command::Edit(Edit::Timeline(TimelineEdit::MoveKeyframes(to))),
                None => Command::Gesture(GestureCommand::Commit),
            }),
            _ => {}
        }
    }

    fn click(
        &mut self,
        target: &Target<'_>,
        editor: &Editor,
        at: Pos2,
        modifiers: Modifiers,
        commands: &mut Vec<Command>,
    ) {
        match target.at(at) {
            Hit::Diamond(index) => self.pick(index, editor, modifiers, commands),
            Hit::Empty | Hit::HalfTurnWarning(_)
                if !editor.session().selected.is_empty() && mode_of(modifiers) == Mode::Replace =>
            {
                commands.push(Command::Selection(SelectionCommand::Keyframes(Vec::new())));
            }
            _ => {}
        }
    }

    /// Handles a click on a keyframe. Plain click: select only it and show it. Shift: extend the selection to it. Ctrl: toggle it.
    pub(super) fn pick(&mut self, index: usize, editor: &Editor, modifiers: Modifiers, commands: &mut Vec<Command>) {
        let keyframe_index = KeyframeIndex::new(index);
        let selected = &editor.session().selected;
        let select = |selected| Command::Selection(SelectionCommand::Keyframes(selected));
        match mode_of(modifiers) {
            Mode::Replace => {
                self.anchor = Some(index);
                commands.push(select(vec![keyframe_index]));
                if editor.is_playing() {
                    #[expect(clippy::cast_precision_loss, reason = "no list has 2^52 keyframes")]
                    let key_time = index as f64 - 1.0;
                    commands.push(Command::Playback(PlaybackCommand::Scrub(key_time)));
                } else {
                    commands.push(Command::Edit(Edit::GoTo(keyframe_index)));
                }
            }
            Mode::Toggle => {
                self.anchor = Some(index);
                // While nothing is selected, edits apply to the current keyframe. Keep that.
                let current = editor.document().keyframes.current();
                let before: Vec<_> = match (selected.is_empty(), current) {
                    (true, Some(current)) if current != keyframe_index => vec![current],
                    _ => selected.clone(),
                };
                commands.push(select(combined(&before, index..index + 1, Mode::Toggle)));
            }
            Mode::Add => {
                let current = || editor.document().keyframes.current().map(KeyframeIndex::get);
                let anchor = self.anchor.or_else(current).unwrap_or(index);
                let range = anchor.min(index)..anchor.max(index) + 1;
                commands.push(select(combined(selected, range, Mode::Add)));
            }
        }
    }

    fn cursor(&self, ui: &Ui, response: &Response) {
        let icon = match (&self.drag, self.hovered) {
            (Some(Drag::Scrub), _) | (None, Some(Hit::Ruler)) => CursorIcon::ResizeColumn,
            (Some(Drag::Move(moving)), _) if moving.end.is_some() => CursorIcon::ResizeHorizontal,
            (Some(Drag::Move(_) | Drag::Pan), _) => CursorIcon::Grabbing,
            (Some(Drag::Retime(_) | Drag::PlayRange { .. }), _)
            | (None, Some(Hit::Grip(_) | Hit::StretchEdge(_) | Hit::RangeStart | Hit::RangeEnd)) => {
                CursorIcon::ResizeHorizontal
            }
            (Some(Drag::Box { .. }), _) => CursorIcon::Crosshair,
            (None, Some(Hit::Diamond(_))) => CursorIcon::Grab,
            (None, Some(Hit::Empty | Hit::HalfTurnWarning(_)) | None) => CursorIcon::Default,
        };
        if self.drag.is_some() || response.hovered() {
            ui.ctx().set_cursor_icon(icon);
        }
    }

    /// The rectangle that a drag surrounds.
    pub(super) fn box_at(&self, target: &Target<'_>, at: Pos2) -> Option<Rect> {
        let Some(Drag::Box { from_time, from_y, .. }) = &self.drag else { return None };
        let corner = egui::pos2(target.scale.x_of(*from_time), *from_y);
        Some(Rect::from_two_pos(corner, at).intersect(target.layout.tracks))
    }
}

/// The command that moves the playhead to the pointer, unless it is there.
fn scrubbing(target: &Target<'_>, editor: &Editor, x: f32, to_keyframes: bool) -> Option<Command> {
    let time = target.scale.time_at(x);
    if target.range.is_none() {
        let keyframe_index = KeyframeIndex::new(target.columns.nearest(time)?);
        let is_there = editor.document().keyframes.current() == Some(keyframe_index);
        return (!is_there).then_some(Command::Edit(Edit::GoTo(keyframe_index)));
    }
    let key_time = target.columns.key_at(time);
    let key_time = if to_keyframes { key_time.round() } else { key_time };
    let is_there = editor.key_time().is_some_and(|shown| (shown - key_time).abs() < 1e-9);
    (!is_there).then_some(Command::Playback(PlaybackCommand::Scrub(key_time)))
}

/// The command that moves an end of the played range to the keyframe under the pointer, unless it is there.
fn move_range_end(target: &Target<'_>, x: f32, is_start: bool) -> Option<Command> {
    let (first, last) = target.range?;
    let most = target.columns.len().checked_sub(2)?;
    let index = target.columns.nearest(target.scale.time_at(x))?;
    let range = if is_start { (index.clamp(1, last - 1), last) } else { (first, index.clamp(first + 1, most)) };
    let range_or_all = (range != (1, most)).then_some(range);
    (range != (first, last)).then_some(Command::Playback(PlaybackCommand::SetRange(range_or_all)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn indices(indices: &[usize]) -> Vec<KeyframeIndex> {
        indices.iter().copied().map(KeyframeIndex::new).collect()
    }

    #[test]
    fn selections_combine() {
        let before = indices(&[1, 4, 7]);
        for (mode, expected) in
            [(Mode::Replace, &[3, 4, 5][..]), (Mode::Add, &[1, 3, 4, 5, 7]), (Mode::Toggle, &[1, 3, 5, 7])]
        {
            assert_eq!(combined(&before, 3..6, mode), indices(expected), "{mode:?}");
        }
    }

    #[test]
    fn a_move_to_where_they_are_is_none() {
        for to in 2..=4 {
            assert!(!moves_anything(&[2, 3], to));
        }
        assert!(moves_anything(&[2, 3], 1) && moves_anything(&[2, 3], 5));
        assert!(moves_anything(&[2, 4], 3), "it closes the gap");
        assert!(!moves_anything(&[], 3));
    }
}
