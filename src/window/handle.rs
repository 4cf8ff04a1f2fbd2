//! Dragging a handle of the chosen node, by a button or after a key that begins a turn or a move. Pixels are physical, from the 3D view's
//! top left.

use glam::Vec2;

use crate::camera::Camera;
use crate::editor::gizmo::{Gizmo, Handle, Steps, Track};
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
