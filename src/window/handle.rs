//! Dragging a handle of the chosen node, by a button or after a key that begins a turn or a move. Pixels are physical, from the 3D view's
//! top left.

use glam::Vec2;

use super::pointer::Button;
use super::shell::Shell;
use crate::camera::Camera;
use crate::editor::gizmo::{DragKey, Gizmo, Handle, HandleKind, Steps, Track};
use crate::editor::keymap::{Key, KeyPress};
use crate::editor::{Command, Editor, GestureCommand};

/// How near a press must be to a handle's middle line, in points: handles are 12 points wide to the pointer.
pub const REACH: f32 = 6.0;

/// A drag whose handle, or the one that a key locks, follows the pointer from where the drag began.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HandleDrag {
    gizmo: Gizmo,
    from_px: Vec2,
    track: Option<Track>,
}

impl HandleDrag {
    /// A drag that begins at a pixel, with the nodes still where they are; `None` where there is no node to have handles.
    #[must_use]
    pub fn begin(editor: &Editor, camera: &Camera, from_px: Vec2) -> Option<Self> {
        Some(Self { gizmo: editor.gizmo(camera)?, from_px, track: None })
    }

    /// The pointer is at a pixel now. A handle that is held since the last time is taken where the drag began.
    pub fn move_to(&mut self, held: Handle, at_px: Vec2, steps: Steps) -> Command {
        let mut track = self
            .track
            .filter(|track| track.handle() == held)
            .unwrap_or_else(|| Track::new(self.gizmo, held, self.from_px));
        let pull = track.move_to(at_px, steps);
        self.track = Some(track);
        Command::Gesture(GestureCommand::Pull(pull))
    }
}

impl Shell {
    /// The handle that a press of the left button at a pixel of the window would take.
    pub(super) fn handle_at(&self, at_px: Vec2) -> Option<Handle> {
        let stage = self.stage.as_ref()?;
        let is_busy =
            self.passes_handles() || self.pointer.is_held() || self.space.is_held() || self.editor.is_dragging();
        if is_busy || !self.is_over_scene(at_px) {
            return None;
        }
        let camera = self.editor.camera(stage.view.size_px);
        self.editor.handle_at(&camera, self.in_view(at_px), REACH * stage.context.pixels_per_point())
    }

    /// A drag begins where the pointer was pressed: of the handle there, if there is one.
    pub(super) fn begin_drag(&mut self, camera: &Camera, from_px: Vec2) {
        self.handle_drag = HandleDrag::begin(&self.editor, camera, from_px);
        let begin = self.pressed_handle.take().map_or(GestureCommand::Begin, GestureCommand::Grab);
        self.apply(Command::Gesture(begin));
    }

    /// The pointer is at a pixel of the view: what is held follows. Says whether something is held.
    pub(super) fn pull_to(&mut self, at_px: Vec2) -> bool {
        let Some(held) = self.editor.held() else { return false };
        if self.handle_drag.is_none() {
            // A menu began it.
            self.hold_from(at_px);
        }
        let snap = self.modifiers.shift_key().then(|| self.editor.session().snap);
        let steps = Steps { snap, is_fine: self.modifiers.control_key() };
        if let Some(drag) = &mut self.handle_drag {
            let pull = drag.move_to(held, at_px, steps);
            self.apply(pull);
        }
        true
    }

    /// Whether a turn or move is on that a key began: the pointer moves it with no button held.
    pub(super) fn is_held_by_keyboard(&self) -> bool {
        self.editor.held().is_some() && !self.pointer.is_held()
    }

    /// A button goes down while a turn or move is on that a key began: the left one ends it, the right one takes it back.
    pub(super) fn end_by_button(&mut self, button: Button) {
        match button {
            Button::Left => self.apply(Command::Gesture(GestureCommand::Commit)),
            Button::Right => self.apply(Command::Cancel),
            Button::Middle => {}
        }
        self.request_redraw();
    }

    /// Handles a key while a drag is on: axes, numbers and Enter belong to it, and but Escape no other does anything. Says whether one is on.
    pub(super) fn key_in_drag(&mut self, press: KeyPress) -> bool {
        let is_in_scene = self.editor.is_dragging()
            && self.path_drag.is_none()
            && (self.editor.held().is_some() || self.pointer.dragging(false).is_some());
        let is_in_panel = self.editor.is_dragging()
            && self.stage.as_ref().is_some_and(|stage| stage.context.input(|input| input.pointer.any_down()));
        if press.typed == Some(Key::Escape) || !is_in_scene && !is_in_panel {
            return false;
        }
        if let Some(key) = DragKey::of(press).filter(|_| is_in_scene) {
            self.apply(key.command());
            if key != DragKey::End {
                // What is locked now follows the pointer from where the drag began.
                self.pull_to(self.in_view(self.pointer_px));
            }
            self.request_redraw();
        }
        true
    }

    /// A turn or move that a key has begun follows the pointer from where it is.
    pub(super) fn began_by_keyboard(&mut self, command: &Command) {
        if matches!(command, Command::Gesture(GestureCommand::Grab(_))) {
            self.hold_from(self.in_view(self.pointer_px));
        }
    }

    fn hold_from(&mut self, at_px: Vec2) {
        let Some(stage) = &self.stage else { return };
        let camera = self.editor.camera(stage.view.size_px);
        self.handle_drag = HandleDrag::begin(&self.editor, &camera, at_px);
    }

    /// The pointer's shape for handles.
    pub(super) fn handle_cursor(&self) -> Option<egui::CursorIcon> {
        if let Some(held) = self.editor.held() {
            let turns = held.kind == HandleKind::Turn;
            return Some(if turns { egui::CursorIcon::Grabbing } else { egui::CursorIcon::Move });
        }
        self.hovered_handle.map(|_| egui::CursorIcon::Grab)
    }
}
