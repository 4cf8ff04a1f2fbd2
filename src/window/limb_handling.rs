//! The balls at limbs' ends over the scene: which of them show and light up, and what presses, movements and the wheel do with them.

use egui::CursorIcon;
use glam::Vec2;
use winit::event::ElementState;

use super::limb_drag::{LimbDrag, REACH};
use super::now;
use super::pointer::Button;
use super::shell::Shell;
use crate::editor::LimbBall;
use crate::pose::RbtIndex;
use crate::words::{Message, texts};

/// What the pointer has to do with limbs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limbs {
    /// The ball that is held.
    pub drag: Option<LimbDrag>,
    /// Whether a second button is held with it, so that it goes along the view.
    pub has_second_button: bool,
    /// The last node of the limb whose ball the pointer is over.
    pub hovered: Option<RbtIndex>,
    /// The topmost node of what the pointer is over: a robot, whose balls show.
    pub robot: Option<RbtIndex>,
}

impl Shell {
    /// The pointer's shape where it has to do with a ball.
    pub(super) fn limb_cursor(&self) -> Option<CursorIcon> {
        if self.limbs.drag.is_some() {
            return Some(CursorIcon::Grabbing);
        }
        self.limbs.hovered.map(|_| CursorIcon::Grab)
    }

    /// The ball under the pointer, or the one that is held, where it is displayed now.
    pub(super) fn lit_ball(&self) -> Option<LimbBall> {
        let last = self.limbs.drag.map(|drag| drag.ball().last).or(self.limbs.hovered)?;
        self.editor.limb_ball(last)
    }

    /// The robot whose balls show besides those of the chosen nodes.
    pub(super) fn robot_with_balls(&self) -> Option<RbtIndex> {
        self.lit_ball().map(|ball| ball.last).or(self.limbs.robot)
    }

    /// What stands beside the pointer over a ball that is not held.
    pub(super) fn name_of_lit_ball(&self) -> Option<Message> {
        let ball = self.lit_ball().filter(|_| self.limbs.drag.is_none())?;
        Some(texts::reach_ball(self.editor.scene().rbt_path(ball.last)))
    }

    /// What a press at a pixel of the window takes hold of.
    fn limb_drag_at(&self, at_px: Vec2) -> Option<LimbDrag> {
        let stage = self.stage.as_ref()?;
        if self.passes_handles() || self.pointer.is_held() || self.hovered_dot.is_some() || !self.is_over_scene(at_px) {
            return None;
        }
        let camera = self.editor.camera(stage.view.size_px);
        LimbDrag::at(&self.editor, &camera, self.in_view(at_px), REACH * stage.context.pixels_per_point())
    }

    /// The pointer moved to a pixel of the window. Says whether a ball is held, to which the movement then belongs.
    pub(super) fn move_limb(&mut self, at_px: Vec2) -> bool {
        let (Some(mut drag), Some(stage)) = (self.limbs.drag, &self.stage) else { return false };
        let camera = self.editor.camera(stage.view.size_px);
        let is_along_view = self.limbs.has_second_button || self.space.is_held();
        let commands = drag.move_to(&self.editor, &camera, self.in_view(at_px), is_along_view);
        if drag.has_begun() {
            // The press of the space bar belongs to the drag.
            self.space.drag();
        }
        for command in commands {
            self.apply(command);
        }
        self.limbs.drag = Some(drag);
        true
    }

    /// Looks what is under the pointer at a pixel of the window. Says whether anything else is.
    pub(super) fn look_for_limbs(&mut self, at_px: Vec2) -> bool {
        let before = self.limbs;
        self.limbs.hovered = self.limb_drag_at(at_px).map(|drag| drag.ball().last);
        self.limbs.robot = self.node_under_pixel(at_px).map(|rbt| self.editor.scene().topmost(rbt));
        self.limbs != before
    }

    fn node_under_pixel(&self, at_px: Vec2) -> Option<RbtIndex> {
        let stage = self.stage.as_ref()?;
        if self.editor.is_playing() || self.pointer.is_held() || !self.is_over_scene(at_px) {
            return None;
        }
        let camera = self.editor.camera(stage.view.size_px);
        self.editor.part_near(&camera, self.in_view(at_px), REACH * stage.context.pixels_per_point())
    }

    /// A button goes down or up. Says whether that belongs to a ball.
    pub(super) fn limb_button(&mut self, state: ElementState, button: Button) -> bool {
        match (state, button) {
            (ElementState::Pressed, Button::Left) => {
                self.limbs.drag = self.limb_drag_at(self.pointer_px);
            }
            (ElementState::Released, Button::Left) if self.limbs.drag.is_some() => {
                let is_click = self.limbs.drag.is_some_and(|drag| !drag.has_begun());
                self.let_go_of_limb();
                self.look_for_limbs(self.pointer_px);
                self.request_redraw();
                if is_click {
                    self.click();
                }
                return true;
            }
            (state, _) => self.limbs.has_second_button = state == ElementState::Pressed && self.limbs.drag.is_some(),
        }
        self.limbs.drag.is_some()
    }

    /// A press and a release of the left button where the pointer is: what lies under the ball.
    fn click(&mut self) {
        let press = self.press_at(self.pointer_px);
        let pressed = self.pointer.press(Button::Left, self.in_view(self.pointer_px), press);
        let released = self.pointer.release(Button::Left, now());
        for action in pressed.into_iter().chain(released) {
            self.act(action);
        }
    }

    /// Ends the drag of a ball, which counts.
    pub(super) fn let_go_of_limb(&mut self) {
        self.limbs.has_second_button = false;
        if let Some(command) = self.limbs.drag.take().and_then(|drag| drag.release(&self.editor)) {
            self.apply(command);
        }
    }

    /// The wheel turns by so many notches. Says whether a ball is held, to which they then belong.
    pub(super) fn wheel_limb(&mut self, notches: f32) -> bool {
        let Some(mut drag) = self.limbs.drag else { return false };
        for command in drag.wheel(&self.editor, notches) {
            self.apply(command);
        }
        self.limbs.drag = Some(drag);
        self.request_redraw();
        true
    }
}
