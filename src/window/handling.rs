//! Leads keyboard and mouse events to the panels, to hotkeys, and to the [`Hands`] over the scene.

use egui::{Event, Order, Pos2};
use glam::Vec2;
use winit::event::{Touch, TouchPhase};

use super::hands::{Desk, Hands, View};
use super::hotkeys::KeyInput;
use super::now;
use super::shell::{Shell, pixel};
use crate::editor::keymap::{Key, binding_for};
use crate::editor::{Command, Editor};

/// A place in points that is in no window.
const FAR_AWAY: Pos2 = Pos2::new(-10_000.0, -10_000.0);

impl Desk for Shell {
    fn editor(&self) -> &Editor {
        &self.editor
    }

    fn apply(&mut self, command: Command) {
        Self::apply(self, command);
    }

    fn view(&self) -> Option<View> {
        let stage = self.stage.as_ref()?;
        let pixels_per_point = stage.context.pixels_per_point();
        Some(View { min_px: stage.view.min_px, size_px: stage.view.size_px, pixels_per_point })
    }

    fn is_over_scene(&self, at_px: Vec2) -> bool {
        let Some(stage) = &self.stage else { return false };
        let at = at_px / stage.context.pixels_per_point();
        let layer = stage.context.layer_id_at(egui::pos2(at.x, at.y));
        !self.ui.has_dialog()
            && stage.view.contains(at_px)
            && layer.is_none_or(|layer| layer.order == Order::Background)
    }

    fn request_redraw(&self) {
        Self::request_redraw(self);
    }
}

impl Shell {
    /// Lets the hands do something.
    pub(super) fn by_hand<R>(&mut self, act: impl FnOnce(&mut Hands, &mut Self) -> R) -> R {
        let mut hands = std::mem::take(&mut self.hands);
        let done = act(&mut hands, self);
        self.hands = hands;
        done
    }

    /// A finger comes down, moves or goes up.
    pub(super) fn touch(&mut self, touch: &Touch) {
        let Some(stage) = &self.stage else { return };
        // A long touch opens a menu: the finger is no longer the scene's.
        let is_in_menu = touch.phase == TouchPhase::Moved && egui::Popup::is_any_open(&stage.context);
        let phase = if is_in_menu { TouchPhase::Cancelled } else { touch.phase };
        let at_px = pixel(touch.location);
        self.by_hand(|hands, shell| hands.touch(shell, phase, touch.id, at_px, now()));
        if let Some(stage) = self.stage.as_mut().filter(|_| self.hands.has_two_fingers()) {
            // What moves far away and back is no long touch, however still it is.
            let events = &mut stage.input.egui_input_mut().events;
            let before = events.iter().rev().find_map(|event| match event {
                Event::PointerMoved(at) => Some(*at),
                _ => None,
            });
            let back = before.or_else(|| stage.context.pointer_latest_pos());
            events.extend([FAR_AWAY].into_iter().chain(back).map(Event::PointerMoved));
        }
    }

    pub(super) fn key(&mut self, input: &KeyInput) {
        let Some(stage) = &self.stage else { return };
        let Some(press) = input.press() else { return };
        // A field takes every key; a button that was reached with Tab takes the space bar.
        let is_typing = self.ui.has_keyboard(&stage.context);
        let is_focused = is_typing || stage.context.egui_wants_keyboard_input();
        if input.is_space() {
            if input.is_pressed {
                self.hands.space.press(is_focused);
                return;
            }
            if !self.hands.space.release() {
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
        let is_pressed = stage.context.input(|input| input.pointer.any_down());
        if self.by_hand(|hands, shell| hands.key_in_drag(shell, press, is_pressed)) || is_for_panel {
            return;
        }
        if let Some(command) = binding_for(self.ui.keymap().bindings(), press).map(|binding| binding.command.clone()) {
            self.apply(command.clone());
            self.by_hand(|hands, shell| hands.began_by_keyboard(shell, &command));
            self.request_redraw();
        }
    }
}
