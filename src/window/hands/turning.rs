//! Handles of the chosen node under the pointer, dragged by a button or after a key that begins a turn or a move.

use egui::CursorIcon;
use glam::Vec2;

use super::{Desk, Hands};
use crate::camera::Camera;
use crate::editor::gizmo::{DragKey, Handle, HandleKind, Steps};
use crate::editor::keymap::{Key, KeyPress};
use crate::editor::{Command, Editor, GestureCommand};
use crate::window::handle::{HandleDrag, REACH};

impl Hands {
    /// The handle that a press of the left button at a pixel would take.
    pub(super) fn handle_at(&self, desk: &dyn Desk, at_px: Vec2) -> Option<Handle> {
        let (editor, view) = (desk.editor(), desk.view()?);
        let is_busy =
            self.passes_handles(editor) || self.pointer.is_held() || self.space.is_held() || editor.is_dragging();
        if is_busy || !desk.is_over_scene(at_px) {
            return None;
        }
        editor.handle_at(&view.camera(editor), view.inside(at_px), REACH * view.pixels_per_point)
    }

    /// A drag begins at a pixel of the view, where a button was pressed: of the handle there, if there is one.
    pub(super) fn begin_drag(&mut self, desk: &mut dyn Desk, camera: &Camera, from_px: Vec2) {
        self.handle_drag = HandleDrag::begin(desk.editor(), camera, from_px);
        let begin = self.pressed_handle.take().map_or(GestureCommand::Begin, GestureCommand::Grab);
        desk.apply(Command::Gesture(begin));
    }

    /// What is held follows the pointer. Says whether something is held.
    pub(super) fn pull_to(&mut self, desk: &mut dyn Desk) -> bool {
        let (Some(held), Some(view)) = (desk.editor().held(), desk.view()) else { return false };
        if self.handle_drag.is_none() {
            // A menu began it.
            self.hold(desk);
        }
        let snap = self.modifiers.shift_key().then(|| desk.editor().session().snap);
        let steps = Steps { snap, is_fine: self.modifiers.control_key() };
        if let Some(drag) = &mut self.handle_drag {
            let pull = drag.move_to(held, view.inside(self.pointer_px), steps);
            desk.apply(pull);
        }
        true
    }

    /// Whether a turn or move is on that a key began: the pointer moves it with no button held.
    pub(super) fn is_held_by_keyboard(&self, editor: &Editor) -> bool {
        editor.held().is_some() && !self.pointer.is_held()
    }

    /// Handles a key while a drag is on: axes, numbers and Enter belong to it, and but Escape no other does anything. `is_in_panel` says
    /// whether a button is held over a panel, whose drag knows no keys. Says whether a drag is on.
    pub fn key_in_drag(&mut self, desk: &mut dyn Desk, press: KeyPress, is_in_panel: bool) -> bool {
        let editor = desk.editor();
        let is_in_scene = editor.is_dragging()
            && self.path_drag.is_none()
            && (editor.held().is_some() || self.pointer.dragging(false).is_some());
        let is_in_panel = is_in_panel && editor.is_dragging();
        if press.typed == Some(Key::Escape) || !is_in_scene && !is_in_panel {
            return false;
        }
        if let Some(key) = DragKey::of(press).filter(|_| is_in_scene) {
            desk.apply(key.command());
            if key != DragKey::End {
                // What is locked now follows the pointer from where the drag began.
                self.pull_to(desk);
            }
            desk.request_redraw();
        }
        true
    }

    /// A key has led to a command: a turn or move that it has begun follows the pointer from where that is.
    pub fn began_by_keyboard(&mut self, desk: &dyn Desk, command: &Command) {
        if matches!(command, Command::Gesture(GestureCommand::Grab(_))) {
            self.hold(desk);
        }
    }

    fn hold(&mut self, desk: &dyn Desk) {
        let Some(view) = desk.view() else { return };
        self.handle_drag = HandleDrag::begin(desk.editor(), &view.camera(desk.editor()), view.inside(self.pointer_px));
    }

    /// The pointer's shape for handles.
    pub(super) fn handle_cursor(&self, editor: &Editor) -> Option<CursorIcon> {
        if let Some(held) = editor.held() {
            let turns = held.kind == HandleKind::Turn;
            return Some(if turns { CursorIcon::Grabbing } else { CursorIcon::Move });
        }
        self.hovered_handle.map(|_| CursorIcon::Grab)
    }
}
