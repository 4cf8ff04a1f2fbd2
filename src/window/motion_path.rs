//! Dragging a dot of the motion path over the scene: from presses and movements to commands. Pixels are physical, from the 3D view's
//! top left.

use glam::Vec2;

use crate::camera::Camera;
use crate::editor::{Command, Edit, Editor, GestureCommand, PathDot, TimelineEdit};

/// How near a press must be to a dot's middle, in points.
pub const REACH: f32 = 8.0;

/// A dot that is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathDrag {
    dot: PathDot,
    from_px: Vec2,
    has_begun: bool,
}

impl PathDrag {
    /// Takes the dot at a pixel, if there is one within `reach_px`.
    #[must_use]
    pub fn at(editor: &Editor, camera: &Camera, at_px: Vec2, reach_px: f32) -> Option<Self> {
        let dot = editor.path_dot_at(camera, at_px, reach_px)?;
        Some(Self { dot, from_px: at_px, has_begun: false })
    }

    /// The dot that is held.
    #[must_use]
    pub const fn dot(&self) -> PathDot {
        self.dot
    }

    /// The pointer is at a pixel now: what that asks for. A drag that was taken back asks for nothing more.
    pub fn move_to(&mut self, editor: &Editor, camera: &Camera, at_px: Vec2) -> Vec<Command> {
        let mut commands = Vec::new();
        if at_px == self.from_px && !self.has_begun || self.has_begun && !editor.is_dragging() {
            return commands;
        }
        let Some(translation) = editor.path_dot_moved(camera, self.dot, at_px - self.from_px) else { return commands };
        if !std::mem::replace(&mut self.has_begun, true) {
            commands.push(Command::Gesture(GestureCommand::Begin));
        }
        let edit = TimelineEdit::SetTranslationInKeyframe(self.dot.keyframe, self.dot.rbt, translation);
        commands.push(Command::Edit(Edit::Timeline(edit)));
        commands
    }

    /// The button is up: what that asks for.
    #[must_use]
    pub fn release(self, editor: &Editor) -> Option<Command> {
        (self.has_begun && editor.is_dragging()).then_some(Command::Gesture(GestureCommand::Commit))
    }
}
