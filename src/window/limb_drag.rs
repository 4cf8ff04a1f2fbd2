//! Dragging the ball at a limb's end over the scene: from presses and movements to commands. Pixels are physical, from the 3D view's
//! top left.

use glam::{Vec2, Vec3};

use crate::camera::Camera;
use crate::editor::{Command, Edit, Editor, GestureCommand, LimbBall, dragged_point};

/// How near a press must be to a ball's middle, in points.
pub const REACH: f32 = 9.0;
/// The turn of the limb about the line to its end for one notch of the wheel, in degrees.
const DEGREES_PER_NOTCH: f64 = 5.0;

/// A ball that is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LimbDrag {
    ball: LimbBall,
    at_px: Vec2,
    /// Where the pointer has led the end, which may be out of reach.
    target_in_world: Vec3,
    has_begun: bool,
}

impl LimbDrag {
    /// Takes the ball at a pixel, if there is one within `reach_px`.
    #[must_use]
    pub fn at(editor: &Editor, camera: &Camera, at_px: Vec2, reach_px: f32) -> Option<Self> {
        let ball = editor.limb_ball_at(camera, at_px, reach_px)?;
        Some(Self { ball, at_px, target_in_world: ball.end_in_world, has_begun: false })
    }

    /// The ball that is held, as it was when it was taken.
    #[must_use]
    pub const fn ball(&self) -> LimbBall {
        self.ball
    }

    /// Whether the pointer moved: if not, the press was a click.
    #[must_use]
    pub const fn has_begun(&self) -> bool {
        self.has_begun
    }

    /// The pointer is at a pixel now: what that asks for. A drag that was taken back asks for nothing more.
    pub fn move_to(&mut self, editor: &Editor, camera: &Camera, at_px: Vec2, is_along_view: bool) -> Vec<Command> {
        let by_px = at_px - std::mem::replace(&mut self.at_px, at_px);
        if by_px == Vec2::ZERO || self.is_over(editor) {
            return Vec::new();
        }
        let Some(target) = dragged_point(camera, self.target_in_world, by_px, is_along_view) else { return Vec::new() };
        self.target_in_world = target;
        self.with_beginning(Command::Edit(Edit::Reach(self.ball.last, target)))
    }

    /// The wheel turns while the ball is held: the limb turns about the line to its end.
    pub fn wheel(&mut self, editor: &Editor, notches: f32) -> Vec<Command> {
        if self.is_over(editor) {
            return Vec::new();
        }
        self.with_beginning(Command::Edit(Edit::TurnPole(self.ball.last, f64::from(notches) * DEGREES_PER_NOTCH)))
    }

    /// The button is up: what that asks for.
    #[must_use]
    pub fn release(self, editor: &Editor) -> Option<Command> {
        (self.has_begun && editor.is_dragging()).then_some(Command::Gesture(GestureCommand::Commit))
    }

    const fn is_over(&self, editor: &Editor) -> bool {
        self.has_begun && !editor.is_dragging()
    }

    fn with_beginning(&mut self, command: Command) -> Vec<Command> {
        let begins = !std::mem::replace(&mut self.has_begun, true);
        begins.then_some(Command::Gesture(GestureCommand::Begin)).into_iter().chain([command]).collect()
    }
}
