//! The balls at limbs' ends over the scene: which of them show and light up, and what presses, movements and the wheel do with them.

use egui::CursorIcon;
use glam::Vec2;
use winit::event::ElementState;

use super::{Desk, Hands, part_at};
use crate::editor::{Editor, LimbBall};
use crate::pose::RbtIndex;
use crate::window::limb_drag::{LimbDrag, REACH};
use crate::window::now;
use crate::window::pointer::Button;
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

impl Hands {
    /// The pointer's shape where it has to do with a ball.
    pub(super) fn limb_cursor(&self) -> Option<CursorIcon> {
        if self.limbs.drag.is_some() {
            return Some(CursorIcon::Grabbing);
        }
        self.limbs.hovered.map(|_| CursorIcon::Grab)
    }

    /// The ball under the pointer, or the one that is held, where it is displayed now.
    #[must_use]
    pub fn lit_ball(&self, editor: &Editor) -> Option<LimbBall> {
        let last = self.limbs.drag.map(|drag| drag.ball().last).or(self.limbs.hovered)?;
        editor.limb_ball(last)
    }

    /// A node of the robot whose balls show besides those of the chosen nodes.
    #[must_use]
    pub fn robot_with_balls(&self, editor: &Editor) -> Option<RbtIndex> {
        self.lit_ball(editor).map(|ball| ball.last).or(self.limbs.robot)
    }

    /// What stands beside the pointer over a ball that is not held.
    pub(super) fn name_of_lit_ball(&self, editor: &Editor) -> Option<Message> {
        let ball = self.lit_ball(editor).filter(|_| self.limbs.drag.is_none())?;
        Some(texts::reach_ball(editor.scene().rbt_path(ball.last)))
    }

    /// What a press at a pixel takes hold of.
    fn limb_drag_at(&self, desk: &dyn Desk, at_px: Vec2) -> Option<LimbDrag> {
        let (editor, view) = (desk.editor(), desk.view()?);
        let is_busy = self.passes_handles(editor) || self.pointer.is_held() || self.hovered_dot.is_some();
        if is_busy || !desk.is_over_scene(at_px) {
            return None;
        }
        LimbDrag::at(editor, &view.camera(editor), view.inside(at_px), REACH * view.pixels_per_point)
    }

    /// The pointer moved to a pixel. Says whether a ball is held, to which the movement then belongs.
    pub(super) fn move_limb(&mut self, desk: &mut dyn Desk, at_px: Vec2) -> bool {
        let (Some(mut drag), Some(view)) = (self.limbs.drag, desk.view()) else { return false };
        let camera = view.camera(desk.editor());
        let is_along_view = self.limbs.has_second_button || self.space.is_held();
        let commands = drag.move_to(desk.editor(), &camera, view.inside(at_px), is_along_view);
        if drag.has_begun() {
            // The press of the space bar belongs to the drag.
            self.space.drag();
        }
        for command in commands {
            desk.apply(command);
        }
        self.limbs.drag = Some(drag);
        true
    }

    /// Looks what is under the pointer at a pixel. Says whether anything else is.
    pub(super) fn look_for_limbs(&mut self, desk: &dyn Desk, at_px: Vec2) -> bool {
        let before = self.limbs;
        self.limbs.hovered = self.limb_drag_at(desk, at_px).map(|drag| drag.ball().last);
        self.limbs.robot = self.node_under(desk, at_px).map(|rbt| desk.editor().scene().topmost(rbt));
        self.limbs != before
    }

    fn node_under(&self, desk: &dyn Desk, at_px: Vec2) -> Option<RbtIndex> {
        if desk.editor().is_playing() || self.pointer.is_held() || !desk.is_over_scene(at_px) {
            return None;
        }
        part_at(desk, at_px, REACH)?.rbt()
    }

    /// A button goes down or up. Says whether that belongs to a ball.
    pub(super) fn limb_button(&mut self, desk: &mut dyn Desk, state: ElementState, button: Button) -> bool {
        match (state, button) {
            (ElementState::Pressed, Button::Left) => {
                self.limbs.drag = self.limb_drag_at(desk, self.pointer_px);
            }
            (ElementState::Released, Button::Left) if self.limbs.drag.is_some() => {
                let is_click = self.limbs.drag.is_some_and(|drag| !drag.has_begun());
                self.let_go_of_limb(desk);
                self.look_for_limbs(desk, self.pointer_px);
                desk.request_redraw();
                if is_click {
                    self.click(desk);
                }
                return true;
            }
            (state, _) => self.limbs.has_second_button = state == ElementState::Pressed && self.limbs.drag.is_some(),
        }
        self.limbs.drag.is_some()
    }

    /// A press and a release of the left button where the pointer is: what lies under the ball.
    fn click(&mut self, desk: &mut dyn Desk) {
        let Some(view) = desk.view() else { return };
        let press = self.press_at(desk, self.pointer_px);
        let pressed = self.pointer.press(Button::Left, view.inside(self.pointer_px), press);
        let released = self.pointer.release(Button::Left, now());
        for action in pressed.into_iter().chain(released) {
            self.act(desk, action);
        }
    }

    /// Ends the drag of a ball, which counts.
    pub(super) fn let_go_of_limb(&mut self, desk: &mut dyn Desk) {
        self.limbs.has_second_button = false;
        if let Some(command) = self.limbs.drag.take().and_then(|drag| drag.release(desk.editor())) {
            desk.apply(command);
        }
    }

    /// The wheel turns by so many notches. Says whether a ball is held, to which they then belong.
    pub(super) fn wheel_limb(&mut self, desk: &mut dyn Desk, notches: f32) -> bool {
        let Some(mut drag) = self.limbs.drag else { return false };
        for command in drag.wheel(desk.editor(), notches) {
            desk.apply(command);
        }
        self.limbs.drag = Some(drag);
        desk.request_redraw();
        true
    }
}
