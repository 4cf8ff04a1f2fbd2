//! The shell: what it does on each event.

use std::sync::Arc;
use std::time::{Duration, Instant};

use egui::{CursorIcon, Order};
use glam::Vec2;
use winit::application::ApplicationHandler;
use winit::dpi::{LogicalSize, PhysicalPosition};
use winit::event::{ElementState, MouseButton, MouseScrollDelta, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoopProxy};
use winit::keyboard::ModifiersState;
use winit::window::{Window, WindowId};

use super::keys::{KeyInput, SpaceBar};
use super::pointer::{Action, Button, Pointer};
use super::stage::Stage;
use super::{Happening, WindowError, now};
use crate::clock::AnimationClock;
use crate::editor::keymap::{Binding, Key, binding_for, bindings};
use crate::editor::{Command, DragKind, Edit, Editor, FileCommand, GestureCommand, ViewCommand};
use crate::pose::RbtIndex;
use crate::ui::Ui;

/// A window that stood still for longer goes on from there: it does not catch up.
const LONGEST_STALL: Duration = Duration::from_millis(250);
/// Pixels of a touchpad's scrolling that are as much as one notch of a wheel.
const PIXELS_PER_NOTCH: f64 = 50.0;
/// The window's size at first, in points.
const SIZE: LogicalSize<f64> = LogicalSize::new(1280.0, 800.0);
/// The smallest size at which the panels leave room for the scene, in points.
const SMALLEST: LogicalSize<f64> = LogicalSize::new(720.0, 480.0);

/// All that lives as long as the window.
pub struct Shell {
    pub(super) editor: Editor,
    pub(super) ui: Ui,
    pub(super) stage: Option<Stage>,
    pub(super) proxy: EventLoopProxy<Happening>,
    pub(super) is_choosing_path: bool,
    pub(super) is_quitting: bool,
    at_start: Vec<Command>,
    bindings: Vec<Binding>,
    modifiers: ModifiersState,
    space: SpaceBar,
    pointer: Pointer,
    /// Where the pointer is, in the window's pixels.
    pointer_px: Vec2,
    clock: AnimationClock,
    /// When the clock last took in time; `None` while nothing plays.
    last_tick: Option<Instant>,
    /// When the panels want to be shown again.
    show_again: Option<Instant>,
    title: String,
    error: Option<WindowError>,
}

impl Shell {
    /// A shell without a window yet.
    pub fn new(editor: Editor, at_start: Vec<Command>, proxy: EventLoopProxy<Happening>) -> Self {
        Self {
            editor,
            ui: Ui::new(),
            stage: None,
            proxy,
            is_choosing_path: false,
            is_quitting: false,
            at_start,
            bindings: bindings(),
            modifiers: ModifiersState::empty(),
            space: SpaceBar::default(),
            pointer: Pointer::default(),
            pointer_px: Vec2::ZERO,
            clock: AnimationClock::new(),
            last_tick: None,
            show_again: None,
            title: String::new(),
            error: None,
        }
    }

    /// Why the window closed, where no user did it.
    pub const fn take_error(&mut self) -> Option<WindowError> {
        self.error.take()
    }

    fn open(&mut self, event_loop: &ActiveEventLoop) {
        self.title = title(&self.editor);
        let attributes =
            Window::default_attributes().with_title(&self.title).with_inner_size(SIZE).with_min_inner_size(SMALLEST);
        let stage = match event_loop.create_window(attributes) {
            Ok(window) => Stage::new(event_loop, Arc::new(window), &self.proxy),
            Err(error) => Err(WindowError::NoDisplay { reason: error.to_string() }),
        };
        match stage {
            Ok(stage) => self.stage = Some(stage),
            Err(error) => {
                self.error = Some(error);
                event_loop.exit();
            }
        }
        for command in std::mem::take(&mut self.at_start) {
            self.apply(command);
        }
    }

    /// Makes everything on the device again, in the same window.
    fn reopen(&mut self, event_loop: &ActiveEventLoop) {
        let Some(lost) = self.stage.take() else { return };
        let window = Arc::clone(&lost.window);
        drop(lost);
        match Stage::new(event_loop, window, &self.proxy) {
            Ok(stage) => {
                stage.window.request_redraw();
                self.stage = Some(stage);
            }
            Err(error) => {
                self.error = Some(error);
                event_loop.exit();
            }
        }
    }

    /// Shows the panels, does what they ask for, and draws the scene as it is then: a drag is seen in the same picture.
    fn redraw(&mut self) {
        let cursor = self.cursor();
        let hovered = self.hovered();
        let Some(stage) = &mut self.stage else { return };
        let Some(mut laid_out) = stage.lay_out(&mut self.ui, &self.editor, cursor) else { return };
        let commands = std::mem::take(&mut laid_out.output.commands);
        let answer = laid_out.output.quit_answer.take();
        let again = !commands.is_empty() || answer.is_some() || laid_out.again_after.is_zero();
        self.show_again = now().checked_add(laid_out.again_after).filter(|_| !laid_out.again_after.is_zero());
        for command in commands {
            self.apply(command);
        }
        if let Some(answer) = answer {
            self.quit_answered(answer);
        }
        if let Some(stage) = &mut self.stage {
            stage.paint(&self.editor, hovered, laid_out);
            if again {
                stage.window.request_redraw();
            }
        }
    }

    /// The pointer's shape over the scene: what a drag does, or that a click chooses.
    fn cursor(&self) -> Option<CursorIcon> {
        match self.pointer.dragging(self.space.is_held()) {
            Some(_) if !self.editor.is_dragging() => Some(CursorIcon::NotAllowed),
            Some(DragKind::Rotate) => Some(CursorIcon::Grabbing),
            Some(DragKind::Translate) => Some(CursorIcon::Move),
            Some(DragKind::Dolly) => Some(CursorIcon::ResizeVertical),
            None => (self.editor.session().is_picking && self.is_over_scene(self.pointer_px))
                .then_some(CursorIcon::Crosshair),
        }
    }

    /// The node that a click would choose, while a click chooses.
    fn hovered(&self) -> Option<RbtIndex> {
        let stage = self.stage.as_ref()?;
        if !self.picks() || self.pointer.is_held() || !self.is_over_scene(self.pointer_px) {
            return None;
        }
        let camera = self.editor.camera(stage.view.size_px);
        self.editor.node_under(camera.ray_through(self.in_view(self.pointer_px)))
    }

    /// Whether a left click in the scene chooses.
    fn picks(&self) -> bool {
        self.editor.session().is_picking || self.modifiers.control_key()
    }

    fn request_redraw(&self) {
        if let Some(stage) = &self.stage {
            stage.window.request_redraw();
        }
    }

    fn key(&mut self, input: &KeyInput) {
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
        if let Some(command) = binding_for(&self.bindings, press).map(|binding| binding.command.clone()) {
            self.apply(command);
            self.request_redraw();
        }
    }

    /// Whether what happens at a pixel of the window is the scene's.
    fn is_over_scene(&self, at_px: Vec2) -> bool {
        let Some(stage) = &self.stage else { return false };
        let at = at_px / stage.context.pixels_per_point();
        let layer = stage.context.layer_id_at(egui::pos2(at.x, at.y));
        !self.ui.has_dialog()
            && stage.view.contains(at_px)
            && layer.is_none_or(|layer| layer.order == Order::Background)
    }

    fn in_view(&self, at_px: Vec2) -> Vec2 {
        at_px - self.stage.as_ref().map_or(Vec2::ZERO, |stage| stage.view.min_px)
    }

    /// The pointer moved. Says whether anything that is drawn may change.
    fn moved(&mut self, position: PhysicalPosition<f64>) -> bool {
        #[expect(clippy::cast_possible_truncation, reason = "windows are small")]
        let at_px = Vec2::new(position.x as f32, position.y as f32);
        let was_over_scene = self.is_over_scene(self.pointer_px);
        self.pointer_px = at_px;
        let is_held = self.pointer.is_held();
        for action in self.pointer.move_to(self.in_view(at_px), self.space.is_held()) {
            self.act(action);
        }
        is_held || self.picks() || !was_over_scene || !self.is_over_scene(at_px)
    }

    fn button(&mut self, state: ElementState, button: MouseButton) {
        let button = match button {
            MouseButton::Left => Button::Left,
            MouseButton::Middle => Button::Middle,
            MouseButton::Right => Button::Right,
            _ => return,
        };
        let action = match state {
            ElementState::Pressed if self.is_over_scene(self.pointer_px) => {
                let picks = self.picks();
                self.pointer.press(button, self.in_view(self.pointer_px), picks)
            }
            ElementState::Pressed => None,
            ElementState::Released => self.pointer.release(button),
        };
        if let Some(action) = action {
            self.act(action);
        }
    }

    fn act(&mut self, action: Action) {
        let Some(stage) = &self.stage else { return };
        let camera = self.editor.camera(stage.view.size_px);
        match action {
            Action::Pick(at_px) => {
                let rbt = self.editor.node_under(camera.ray_through(at_px));
                self.apply(Command::View(ViewCommand::Choose(rbt)));
            }
            Action::Begin => {
                self.space.drag();
                self.apply(Command::Gesture(GestureCommand::Begin));
            }
            // Nothing goes on that was refused or taken back.
            Action::Move { .. } | Action::Commit if !self.editor.is_dragging() => {}
            Action::Move { kind, from_px, to_px } => {
                let motion = self.editor.manipulation(&camera).motion(kind, from_px, to_px);
                self.apply(Command::Gesture(GestureCommand::Move(motion)));
            }
            Action::Commit => self.apply(Command::Gesture(GestureCommand::Commit)),
        }
        self.request_redraw();
    }

    fn wheel(&mut self, delta: MouseScrollDelta) {
        let Some(stage) = &self.stage else { return };
        if !self.is_over_scene(self.pointer_px) {
            return;
        }
        #[expect(clippy::cast_possible_truncation, reason = "scrolling is small")]
        let notches = match delta {
            MouseScrollDelta::LineDelta(_, lines) => lines,
            MouseScrollDelta::PixelDelta(pixels) => (pixels.y / PIXELS_PER_NOTCH) as f32,
        };
        if notches != 0.0 {
            let camera = self.editor.camera(stage.view.size_px);
            let motion = self.editor.manipulation(&camera).wheel(notches);
            self.apply(Command::Edit(Edit::Wheel(motion)));
            self.request_redraw();
        }
    }

    /// Gives the editor the ticks that passed, and says when the next one is due.
    fn tick(&mut self, at: Instant) -> Option<Instant> {
        if !self.editor.is_playing() {
            self.last_tick = None;
            return None;
        }
        match self.last_tick.replace(at) {
            None => self.clock.restart(),
            Some(last) => {
                let ticks = self.clock.advance_at_most(at.duration_since(last), LONGEST_STALL);
                if self.editor.tick(ticks) {
                    self.request_redraw();
                }
            }
        }
        Some(at + self.clock.until_next_tick())
    }

    fn update_title(&mut self) {
        let title = title(&self.editor);
        if title != self.title
            && let Some(stage) = &self.stage
        {
            stage.window.set_title(&title);
            self.title = title;
        }
    }
}

fn title(editor: &Editor) -> String {
    let mark = if editor.has_unsaved_changes() { "*" } else { "" };
    format!("{mark}{} • Inbetween", editor.path().display())
}

impl ApplicationHandler<Happening> for Shell {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.stage.is_none() && self.error.is_none() {
            self.open(event_loop);
        }
        self.request_redraw();
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, happening: Happening) {
        match happening {
            Happening::PathChosen { purpose, path, took } => self.path_chosen(purpose, path, took),
            Happening::DeviceLost => self.reopen(event_loop),
        }
        self.request_redraw();
    }

    fn window_event(&mut self, _event_loop: &ActiveEventLoop, _window: WindowId, event: WindowEvent) {
        if matches!(event, WindowEvent::RedrawRequested) {
            self.redraw();
            return;
        }
        let Some(stage) = &mut self.stage else { return };
        let mut shows = stage.input.on_window_event(&stage.window, &event).repaint;
        match event {
            WindowEvent::CloseRequested => self.apply(Command::File(FileCommand::Quit)),
            WindowEvent::Resized(_) | WindowEvent::ScaleFactorChanged { .. } => {
                stage.is_outdated();
                shows = true;
            }
            WindowEvent::DroppedFile(path) => self.apply(Command::File(FileCommand::Open(path))),
            WindowEvent::ModifiersChanged(modifiers) => {
                // With Ctrl a click chooses, and the node that it would choose is outlined.
                shows |= self.modifiers.control_key() != modifiers.state().control_key();
                self.modifiers = modifiers.state();
            }
            WindowEvent::KeyboardInput { event, is_synthetic, .. } => {
                self.key(&KeyInput::new(&event, is_synthetic, self.modifiers));
            }
            WindowEvent::CursorMoved { position, .. } => {
                let changes = self.moved(position);
                if !changes && let Some(stage) = &mut self.stage {
                    // The panels need not hear of movements over the scene, which change nothing of theirs.
                    stage.input.egui_input_mut().events.pop_if(|event| matches!(event, egui::Event::PointerMoved(_)));
                }
                shows = changes;
            }
            WindowEvent::MouseInput { state, button, .. } => self.button(state, button),
            WindowEvent::MouseWheel { delta, .. } => self.wheel(delta),
            WindowEvent::Focused(false) => {
                self.space.release();
                if let Some(action) = self.pointer.let_go() {
                    self.act(action);
                }
            }
            _ => {}
        }
        if shows {
            self.request_redraw();
        }
    }

    fn exiting(&mut self, _event_loop: &ActiveEventLoop) {
        // The window must go before the connection that it was made on.
        self.stage = None;
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        let at = now();
        let next_tick = self.tick(at);
        if self.show_again.is_some_and(|due| due <= at) {
            self.show_again = None;
            self.request_redraw();
        }
        self.update_title();
        if self.is_quitting {
            event_loop.exit();
        }
        let due = [next_tick, self.show_again].into_iter().flatten().min();
        event_loop.set_control_flow(due.map_or(ControlFlow::Wait, ControlFlow::WaitUntil));
    }
}
