//! Handles keyboard and mouse events: hotkeys, drags, clicks.

use egui::{CursorIcon, Order};
use glam::Vec2;
use winit::dpi::PhysicalPosition;
use winit::event::{ElementState, MouseButton};

use super::hotkeys::KeyInput;
use super::motion_path::{PathDrag, REACH};
use super::now;
use super::pointer::{Action, Button, Click, Drag, Held, Press, Target};
use super::shell::Shell;
use crate::editor::keymap::{Key, binding_for};
use crate::editor::{CLICK_REACH, Command, DragKind, GestureCommand, ViewCommand};
use crate::keyframe::KeyframeIndex;
use crate::pose::RbtIndex;
use crate::words::{Message, texts};

impl Shell {
    /// The pointer's shape over the scene: what a drag does, or that a click chooses.
    pub(super) fn cursor(&self) -> Option<CursorIcon> {
        if self.path_drag.is_some() {
            return Some(CursorIcon::Grabbing);
        }
        if self.hovered_dot.is_some() {
            return Some(CursorIcon::Grab);
        }
        if let Some(cursor) = self.handle_cursor().or_else(|| self.limb_cursor()) {
            return Some(cursor);
        }
        match self.pointer.dragging(self.space.is_held()) {
            Some(Drag::Orbit) => Some(CursorIcon::Grabbing),
            Some(Drag::Pan) => Some(CursorIcon::AllScroll),
            Some(Drag::Pose(_)) if !self.editor.is_dragging() => Some(CursorIcon::NotAllowed),
            Some(Drag::Pose(DragKind::Rotate)) => Some(CursorIcon::Grabbing),
            Some(Drag::Pose(DragKind::Translate)) => Some(CursorIcon::Move),
            Some(Drag::Pose(DragKind::Dolly)) => Some(CursorIcon::ResizeVertical),
            None => (self.editor.session().is_picking && self.is_over_scene(self.pointer_px))
                .then_some(CursorIcon::Crosshair),
        }
    }

    /// The node that a click would choose.
    pub(super) fn hovered(&self) -> Option<RbtIndex> {
        let stage = self.stage.as_ref()?;
        let is_over_handle = self.hovered_dot.is_some() || self.hovered_handle.is_some() || self.lit_ball().is_some();
        if self.pointer.is_held() || self.path_drag.is_some() || is_over_handle || !self.is_over_scene(self.pointer_px)
        {
            return None;
        }
        let camera = self.editor.camera(stage.view.size_px);
        self.editor.part_near(&camera, self.in_view(self.pointer_px), CLICK_REACH * stage.context.pixels_per_point())
    }

    /// Whether a press passes dots and balls, which lie over parts.
    pub(super) fn passes_handles(&self) -> bool {
        self.editor.session().is_picking || self.modifiers.control_key() || self.modifiers.alt_key()
    }

    /// The name of what lights up under the pointer.
    pub(super) fn name_of_lit(&self, part: Option<RbtIndex>) -> Option<Message> {
        let name = || Some(texts::foreign(self.editor.scene().rbt_path(part?)));
        self.name_of_lit_ball().or_else(name)
    }

    /// What a press at a pixel of the window meets, and what it depends on.
    pub(super) fn press_at(&self, at_px: Vec2) -> Press {
        let held = Held {
            ctrl: self.modifiers.control_key(),
            shift: self.modifiers.shift_key(),
            alt: self.modifiers.alt_key(),
            space: self.space.is_held(),
        };
        let mut target = Target::Nothing;
        if let Some(stage) = &self.stage {
            let camera = self.editor.camera(stage.view.size_px);
            let at_px = self.in_view(at_px);
            let part = self.editor.part_near(&camera, at_px, CLICK_REACH * stage.context.pixels_per_point());
            target = match part {
                _ if self.pressed_handle.is_some() => Target::Handle,
                Some(rbt) => Target::Part(rbt),
                None if self.editor.is_in_arcball(&camera, at_px) => Target::Arcball,
                None => Target::Nothing,
            };
        }
        Press { target, held, picks: self.editor.session().is_picking, by_work_eye: self.editor.is_work_eye() }
    }

    pub(super) fn key(&mut self, input: &KeyInput) {
        let Some(stage) = &self.stage else { return };
        let Some(press) = input.press() else { return };
        // A field takes every key; a button that was reached with Tab takes the space bar.
        let is_typing = self.ui.has_keyboard(&stage.context);
        let is_focused = is_typing || stage.context.egui_wants_keyboard_input();
        if input.is_space() {
            if input.is_pressed {
                self.space.press(is_focused);
                return;
            }
            if !self.space.release() {
                return;
            }
        } else if !input.is_pressed || is_typing {
            return;
        }
        if press.typed == Some(Key::Escape) && self.ui.takes_escape(&stage.context) {
            return;
        }
        let is_arrow = matches!(press.typed, Some(Key::Left | Key::Right | Key::Up | Key::Down));
        let is_for_panel = is_arrow && self.ui.takes_arrows(&stage.context);
        if self.key_in_drag(press) || is_for_panel {
            return;
        }
        if let Some(command) = binding_for(self.ui.keymap().bindings(), press).map(|binding| binding.command.clone()) {
            self.apply(command.clone());
            self.began_by_keyboard(&command);
            self.request_redraw();
        }
    }

    /// Whether what happens at a pixel of the window is the scene's.
    pub(super) fn is_over_scene(&self, at_px: Vec2) -> bool {
        let Some(stage) = &self.stage else { return false };
        let at = at_px / stage.context.pixels_per_point();
        let layer = stage.context.layer_id_at(egui::pos2(at.x, at.y));
        !self.ui.has_dialog()
            && stage.view.contains(at_px)
            && layer.is_none_or(|layer| layer.order == Order::Background)
    }

    pub(super) fn in_view(&self, at_px: Vec2) -> Vec2 {
        at_px - self.stage.as_ref().map_or(Vec2::ZERO, |stage| stage.view.min_px)
    }

    /// The pointer moved. Says whether anything that is drawn may change.
    pub(super) fn moved(&mut self, position: PhysicalPosition<f64>) -> bool {
        #[expect(clippy::cast_possible_truncation, reason = "windows are small")]
        let at_px = Vec2::new(position.x as f32, position.y as f32);
        let was_over_scene = self.is_over_scene(self.pointer_px);
        self.pointer_px = at_px;
        if let Some(mut drag) = self.path_drag {
            if let Some(stage) = &self.stage {
                let camera = self.editor.camera(stage.view.size_px);
                for command in drag.move_to(&self.editor, &camera, self.in_view(at_px)) {
                    self.apply(command);
                }
                self.path_drag = Some(drag);
            }
            return true;
        }
        if self.move_limb(at_px) {
            return true;
        }
        let dot = self.dot_at(at_px);
        let dot_before = std::mem::replace(&mut self.hovered_dot, dot);
        let is_over_other_limb = self.look_for_limbs(at_px);
        let handle = self.handle_at(at_px).filter(|_| dot.is_none());
        let handle_before = std::mem::replace(&mut self.hovered_handle, handle);
        let is_held = self.pointer.is_held() || self.editor.held().is_some();
        if self.is_held_by_keyboard() {
            self.pull_to(self.in_view(at_px));
        } else if !self.editor.is_dragging() {
            self.handle_drag = None;
        }
        for action in self.pointer.move_to(self.in_view(at_px), self.space.is_held()) {
            self.act(action);
        }
        let hovered = self.hovered();
        let hovered_before = std::mem::replace(&mut self.hovered_part, hovered);
        let is_over_other = is_over_other_limb
            || dot_before != self.hovered_dot
            || handle_before != self.hovered_handle
            || hovered_before != hovered;
        is_over_other || is_held || !was_over_scene || !self.is_over_scene(at_px)
    }

    /// What a press at a pixel of the window would do with the dots of the motion path.
    fn path_drag_at(&self, at_px: Vec2) -> Option<PathDrag> {
        let stage = self.stage.as_ref()?;
        if self.passes_handles() || self.pointer.is_held() || self.space.is_held() || !self.is_over_scene(at_px) {
            return None;
        }
        let camera = self.editor.camera(stage.view.size_px);
        PathDrag::at(&self.editor, &camera, self.in_view(at_px), REACH * stage.context.pixels_per_point())
    }

    fn dot_at(&self, at_px: Vec2) -> Option<KeyframeIndex> {
        self.path_drag_at(at_px).map(|drag| drag.dot().keyframe)
    }

    /// Ends the drag of a dot, which counts.
    pub(super) fn let_go_of_dot(&mut self) {
        if let Some(command) = self.path_drag.take().and_then(|drag| drag.release(&self.editor)) {
            self.apply(command);
        }
    }

    pub(super) fn button(&mut self, state: ElementState, button: MouseButton) {
        let button = match button {
            MouseButton::Left => Button::Left,
            MouseButton::Middle => Button::Middle,
            MouseButton::Right => Button::Right,
            _ => return,
        };
        if button == Button::Left && state == ElementState::Released && self.path_drag.is_some() {
            self.let_go_of_dot();
            self.hovered_dot = self.dot_at(self.pointer_px);
            self.request_redraw();
            return;
        }
        if button == Button::Left && state == ElementState::Released {
            self.pressed_handle = None;
        }
        if state == ElementState::Pressed && self.is_held_by_keyboard() {
            self.end_by_button(button);
            return;
        }
        if button == Button::Left && state == ElementState::Pressed {
            self.pressed_handle = self.handle_at(self.pointer_px);
            self.path_drag = self.path_drag_at(self.pointer_px);
            self.hovered_dot = self.path_drag.map(|drag| drag.dot().keyframe);
        }
        // A handle comes before the ball at a limb's end.
        let is_on_handle = self.pressed_handle.is_some() && button == Button::Left;
        if self.path_drag.is_some() || !is_on_handle && self.limb_button(state, button) {
            return;
        }
        let action = match state {
            ElementState::Pressed if self.is_over_scene(self.pointer_px) => {
                let press = self.press_at(self.pointer_px);
                self.pointer.press(button, self.in_view(self.pointer_px), press)
            }
            ElementState::Pressed => None,
            ElementState::Released => self.pointer.release(button, now()),
        };
        if let Some(action) = action {
            self.act(action);
        }
    }

    pub(super) fn act(&mut self, action: Action) {
        let Some(stage) = &self.stage else { return };
        let camera = self.editor.camera(stage.view.size_px);
        let reach_px = CLICK_REACH * stage.context.pixels_per_point();
        match action {
            Action::Pick(at_px) => {
                let rbt = self.editor.part_near(&camera, at_px, reach_px);
                self.apply(Command::View(ViewCommand::Choose(rbt)));
            }
            Action::Click(click, at_px) => {
                let command = match click {
                    Click::Choose(rbt) => ViewCommand::Choose(Some(rbt)),
                    Click::Also(rbt) => ViewCommand::ChooseAlso(rbt),
                    Click::GoOn => ViewCommand::Choose(self.editor.part_behind(&camera, at_px, reach_px)),
                    Click::ChooseNone => ViewCommand::Choose(None),
                };
                self.apply(Command::View(command));
            }
            Action::Move { drag: drag @ (Drag::Orbit | Drag::Pan), from_px, to_px } => {
                self.space.drag();
                let eye = self.editor.session().work_eye;
                let by_px = to_px - from_px;
                let eye = if drag == Drag::Orbit { eye.orbited(by_px, &camera) } else { eye.panned(by_px, &camera) };
                self.apply(Command::View(ViewCommand::SetWorkEye(eye)));
            }
            Action::Begin { chosen, from_px } => {
                self.space.drag();
                if let Some(rbt) = chosen.filter(|rbt| !self.editor.session().chosen.contains(rbt)) {
                    self.apply(Command::View(ViewCommand::Choose(Some(rbt))));
                }
                self.begin_drag(&camera, from_px);
            }
            // A drag that was refused or cancelled does not continue.
            Action::Move { .. } | Action::Commit if !self.editor.is_dragging() => {}
            Action::Move { to_px, .. } if self.pull_to(to_px) => {}
            Action::Move { drag: Drag::Pose(kind), from_px, to_px } => {
                let motion = self.editor.manipulation(&camera).motion(kind, from_px, to_px);
                self.apply(Command::Gesture(GestureCommand::Move(motion)));
            }
            Action::Commit => self.apply(Command::Gesture(GestureCommand::Commit)),
        }
        self.request_redraw();
    }
}
