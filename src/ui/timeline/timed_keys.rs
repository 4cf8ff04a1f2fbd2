//! Clicks and drags in the rows of timed keys.

use egui::{CursorIcon, Key, Modifiers, PointerButton, Pos2, Rect, Response, Ui, pos2};

use super::drag::{Mode, mode_of};
use super::hit::Target;
use super::timed_key_menu::Menu;
use super::timed_key_view::{KeyHit, KeyView};
use crate::editor::{Command, Edit, GestureCommand, KeyAt, SceneEdit, SelectionCommand, ViewCommand};

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
        let under = pressed_at.or(at).filter(|_| response.hovered() || response.is_pointer_button_down_on());
        let hit = under.and_then(|under| view.at(under));
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
            commands.push(Command::Selection(SelectionCommand::TimedKeys(keys.clone())));
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
            commands.push(Command::Selection(SelectionCommand::TimedKeys(std::mem::take(before))));
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
                        commands.push(Command::Selection(SelectionCommand::TimedKeys(keys)));
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
            commands.push(Command::Selection(SelectionCommand::TimedKeys(Vec::new())));
        }
        return;
    };
    let keys = combined(selected, view.keys_at(hit.row, seconds), mode);
    commands.push(Command::Selection(SelectionCommand::TimedKeys(keys)));
    if mode == Mode::Replace && seconds >= 0.0 && !view.editor.is_playing() {
        commands.push(Command::View(ViewCommand::ScrubSeconds(seconds)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Channel;

    #[test]
    fn selections_combine() {
        let key = |seconds| KeyAt::new("a", Channel::Scale, seconds);
        let (before, taken) = ([key(0.0), key(1.0)], vec![key(1.0), key(2.0)]);
        assert_eq!(combined(&before, taken.clone(), Mode::Replace), taken);
        assert_eq!(combined(&before, taken.clone(), Mode::Toggle), [key(0.0), key(2.0)]);
        assert_eq!(combined(&before, taken, Mode::Add).len(), 4, "the editor drops what stands twice");
    }
}
