//! Movements of the pointer and its buttons.

use glam::Vec2;
use winit::event::{ElementState, MouseButton};

use super::{Desk, Hands, part_at};
use crate::editor::{CLICK_REACH, Command, GestureCommand, ViewCommand};
use crate::keyframe::KeyframeIndex;
use crate::scene::Part;
use crate::window::motion_path::{PathDrag, REACH};
use crate::window::now;
use crate::window::pointer::{Action, Button, Click, Drag};

impl Hands {
    /// The pointer moved. Says whether anything that is drawn may change.
    pub fn moved(&mut self, desk: &mut dyn Desk, at_px: Vec2) -> bool {
        let was_over_scene = desk.is_over_scene(self.pointer_px);
        self.pointer_px = at_px;
        if let Some(mut drag) = self.path_drag {
            if let Some(view) = desk.view() {
                let camera = view.camera(desk.editor());
                for command in drag.move_to(desk.editor(), &camera, view.inside(at_px)) {
                    desk.apply(command);
                }
                self.path_drag = Some(drag);
            }
            return true;
        }
        if self.move_limb(desk, at_px) {
            return true;
        }
        let dot = self.dot_at(desk, at_px);
        let dot_before = std::mem::replace(&mut self.hovered_dot, dot);
        let is_over_other_limb = self.look_for_limbs(desk, at_px);
        let handle = self.handle_at(desk, at_px).filter(|_| dot.is_none());
        let handle_before = std::mem::replace(&mut self.hovered_handle, handle);
        let is_held = self.pointer.is_held() || desk.editor().held().is_some();
        if self.is_held_by_keyboard(desk.editor()) {
            self.pull_to(desk);
        } else if !desk.editor().is_dragging() {
            self.handle_drag = None;
        }
        let Some(view) = desk.view() else { return false };
        for action in self.pointer.move_to(view.inside(at_px), self.space.is_held()) {
            self.act(desk, action);
        }
        let hovered = self.hovered(desk);
        let hovered_before = std::mem::replace(&mut self.hovered_part, hovered);
        let is_over_other = is_over_other_limb
            || dot_before != self.hovered_dot
            || handle_before != self.hovered_handle
            || hovered_before != hovered;
        is_over_other || is_held || !was_over_scene || !desk.is_over_scene(at_px)
    }

    /// A button goes down or up.
    pub fn button(&mut self, desk: &mut dyn Desk, state: ElementState, button: MouseButton) {
        let button = match button {
            MouseButton::Left => Button::Left,
            MouseButton::Middle => Button::Middle,
            MouseButton::Right => Button::Right,
            _ => return,
        };
        if button == Button::Left && state == ElementState::Released && self.path_drag.is_some() {
            self.let_go_of_dot(desk);
            self.hovered_dot = self.dot_at(desk, self.pointer_px);
            desk.request_redraw();
            return;
        }
        if button == Button::Left && state == ElementState::Released {
            self.pressed_handle = None;
        }
        if state == ElementState::Pressed && self.is_held_by_keyboard(desk.editor()) {
            end_by_button(desk, button);
            return;
        }
        if button == Button::Left && state == ElementState::Pressed {
            self.pressed_handle = self.handle_at(desk, self.pointer_px);
            self.path_drag = self.path_drag_at(desk, self.pointer_px);
            self.hovered_dot = self.path_drag.map(|drag| drag.dot().keyframe);
        }
        // A handle comes before the ball at a limb's end.
        let is_on_handle = self.pressed_handle.is_some() && button == Button::Left;
        if self.path_drag.is_some() || !is_on_handle && self.limb_button(desk, state, button) {
            return;
        }
        let action = match state {
            ElementState::Pressed if desk.is_over_scene(self.pointer_px) => {
                let press = self.press_at(desk, self.pointer_px);
                desk.view().and_then(|view| self.pointer.press(button, view.inside(self.pointer_px), press))
            }
            ElementState::Pressed => None,
            ElementState::Released => self.pointer.release(button, now()),
        };
        if let Some(action) = action {
            self.act(desk, action);
        }
    }

    /// Lets go of everything, as when the window loses the focus. Drags count.
    pub fn let_go(&mut self, desk: &mut dyn Desk) {
        self.space.release();
        self.let_go_of_drags(desk);
    }

    /// Ends what the buttons drag, which counts. It is no click.
    pub(super) fn let_go_of_drags(&mut self, desk: &mut dyn Desk) {
        self.let_go_of_dot(desk);
        self.let_go_of_limb(desk);
        if let Some(action) = self.pointer.let_go() {
            self.act(desk, action);
        }
    }

    pub(super) fn act(&mut self, desk: &mut dyn Desk, action: Action) {
        let Some(view) = desk.view() else { return };
        let camera = view.camera(desk.editor());
        match action {
            Action::Pick(at_px) => {
                let rbt = part_at(desk, at_px + view.min_px, CLICK_REACH).and_then(Part::rbt);
                desk.apply(Command::View(ViewCommand::Choose(rbt)));
            }
            Action::Click(click, at_px) => {
                let reach_px = CLICK_REACH * view.pixels_per_point;
                let choose = |rbt| Command::View(ViewCommand::Choose(rbt));
                let command = match click {
                    Click::Choose(rbt) => choose(Some(rbt)),
                    Click::Also(rbt) => Command::View(ViewCommand::ChooseAlso(rbt)),
                    Click::GoOn => choose(desk.editor().part_behind(&camera, at_px, reach_px)),
                    Click::SelectKeys(node) => desk.editor().selecting_keys_of(node),
                    Click::ChooseNone => choose(None),
                };
                desk.apply(command);
            }
            Action::Move { drag: drag @ (Drag::Orbit | Drag::Pan), from_px, to_px } => {
                self.space.drag();
                let eye = desk.editor().session().work_eye;
                let by_px = to_px - from_px;
                let eye = if drag == Drag::Orbit { eye.orbited(by_px, &camera) } else { eye.panned(by_px, &camera) };
                desk.apply(Command::View(ViewCommand::SetWorkEye(eye)));
            }
            Action::Begin { chosen, from_px } => {
                self.space.drag();
                if let Some(rbt) = chosen.filter(|rbt| !desk.editor().session().chosen.contains(rbt)) {
                    desk.apply(Command::View(ViewCommand::Choose(Some(rbt))));
                }
                self.begin_drag(desk, &camera, from_px);
            }
            // A drag that was refused or cancelled does not continue.
            Action::Move { .. } | Action::Commit if !desk.editor().is_dragging() => {}
            Action::Move { .. } if self.pull_to(desk) => {}
            Action::Move { drag: Drag::Pose(kind), from_px, to_px } => {
                let motion = desk.editor().manipulation(&camera).motion(kind, from_px, to_px);
                desk.apply(Command::Gesture(GestureCommand::Move(motion)));
            }
            Action::Commit => desk.apply(Command::Gesture(GestureCommand::Commit)),
        }
        desk.request_redraw();
    }

    /// What a press at a pixel would do with the dots of the motion path.
    fn path_drag_at(&self, desk: &dyn Desk, at_px: Vec2) -> Option<PathDrag> {
        let (editor, view) = (desk.editor(), desk.view()?);
        let is_busy = self.passes_handles(editor) || self.pointer.is_held() || self.space.is_held();
        if is_busy || !desk.is_over_scene(at_px) {
            return None;
        }
        PathDrag::at(editor, &view.camera(editor), view.inside(at_px), REACH * view.pixels_per_point)
    }

    fn dot_at(&self, desk: &dyn Desk, at_px: Vec2) -> Option<KeyframeIndex> {
        self.path_drag_at(desk, at_px).map(|drag| drag.dot().keyframe)
    }

    /// Ends the drag of a dot, which counts.
    fn let_go_of_dot(&mut self, desk: &mut dyn Desk) {
        if let Some(command) = self.path_drag.take().and_then(|drag| drag.release(desk.editor())) {
            desk.apply(command);
        }
    }
}

/// A button goes down while a turn or move is on that a key began: the left one ends it, the right one takes it back.
fn end_by_button(desk: &mut dyn Desk, button: Button) {
    match button {
        Button::Left => desk.apply(Command::Gesture(GestureCommand::Commit)),
        Button::Right => desk.apply(Command::Cancel),
        Button::Middle => {}
    }
    desk.request_redraw();
}
