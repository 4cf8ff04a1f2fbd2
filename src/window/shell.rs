//! The winit event handler. `Shell` owns the editor, the panels and the window.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use egui_winit::accesskit_winit;
use glam::Vec2;
use web_time::Instant;
use winit::application::ApplicationHandler;
use winit::dpi::PhysicalPosition;
use winit::event::WindowEvent;
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoopProxy};
use winit::window::{Window, WindowId};

use super::easing::Easing;
use super::export::Export;
use super::hands::Hands;
use super::hotkeys::KeyInput;
use super::inset::Inset;
use super::keeper::Keeper;
use super::meter::{Meter, Work};
use super::outside::Outside;
#[cfg(target_arch = "wasm32")]
use super::page;
use super::screenshot::Screenshot;
use super::settings_file::SettingsFile;
use super::stage::{Lit, WindowSurface};
use super::{ForTests, UserEvent, WindowError, desktop, display, ending, now, place};
use crate::clock::AnimationClock;
use crate::editor::{Command, Editor, Eye, FileCommand, Severity, ViewCommand};
use crate::files;
use crate::journal::Ending;
use crate::pose::Pose;
use crate::render::{Gpu, GpuError};
use crate::script::Restore;
use crate::ui::{Panels, PathPurpose};
use crate::words::texts;

/// The longest time that one tick call may catch up. After a longer stall, playback continues from where it stopped.
const LONGEST_STALL: Duration = Duration::from_millis(250);
/// The program's state while the event loop runs.
pub struct Shell {
    pub(super) editor: Editor,
    pub(super) ui: Panels,
    pub(super) stage: Option<WindowSurface>,
    pub(super) proxy: EventLoopProxy<UserEvent>,
    pub(super) is_choosing_path: bool,
    pub(super) is_quitting: bool,
    /// What is done once unsaved work is saved or discarded; `None`: the end.
    pub(super) leaving: Option<Command>,
    at_start: Vec<Command>,
    /// Whether what was asked for at the start was done.
    is_begun: bool,
    /// Whether the window was asked for.
    is_opening: bool,
    pub(super) settings_file: SettingsFile,
    pub(super) keeper: Keeper,
    pub(super) outside: Outside,
    pub(super) export: Option<Export>,
    /// The picture's way to where the work eye is.
    pub(super) easing: Option<Easing>,
    /// When the picture of the recorded camera is made anew.
    pub(super) inset: Inset,
    pub(super) hands: Hands,
    clock: AnimationClock,
    /// Time of the last `tick`; `None` while the editor needs no ticks.
    last_tick: Option<Instant>,
    /// When the panels want to be shown again.
    show_again: Option<Instant>,
    /// When the next picture of a keyframe is made, unless something happens before.
    pub(super) thumbnail_due: Option<Instant>,
    /// Whose picture of a keyframe is being drawn.
    pub(super) thumbnail_of: Option<Pose>,
    /// Screenshots that are being drawn.
    pub(super) screenshots: Vec<Screenshot>,
    /// When the picture at rest gets its next sub-frame.
    pub(super) rest_due: Option<Instant>,
    pub(super) meter: Meter,
    title: String,
    error: Option<WindowError>,
}

impl Shell {
    /// A shell without a window yet.
    pub fn new(mut editor: Editor, at_start: Vec<Command>, proxy: EventLoopProxy<UserEvent>, tests: ForTests) -> Self {
        let (settings_file, problem) = SettingsFile::read();
        let mut ui = Panels::new();
        ui.put_own_poses(crate::files::poses::own());
        let errors = ui.adopt(&settings_file.settings).into_iter().map(|error| error.message());
        editor.set_keymap(ui.keymap().clone());
        editor.set_handles(settings_file.settings.gizmo_axes, settings_file.settings.snap);
        for message in problem.into_iter().chain(errors) {
            editor.say(message.with_severity(Severity::Error));
        }
        let mut keeper = Keeper::new(settings_file.settings.journal, &editor, tests);
        if let Some(problem) = keeper.take_problem() {
            editor.say(problem);
        }
        ui.recovery = keeper.offer();
        let outside = Outside::new(files::known_at_start(&editor));
        Self {
            editor,
            ui,
            stage: None,
            proxy,
            is_choosing_path: false,
            is_quitting: false,
            leaving: None,
            at_start,
            is_begun: false,
            is_opening: false,
            settings_file,
            keeper,
            outside,
            export: None,
            easing: None,
            inset: Inset::default(),
            hands: Hands::default(),
            clock: AnimationClock::new(),
            last_tick: None,
            show_again: None,
            thumbnail_due: None,
            thumbnail_of: None,
            screenshots: Vec::new(),
            rest_due: None,
            meter: Meter::default(),
            title: String::new(),
            error: None,
        }
    }

    /// The error that closed the window or kept it from opening, if one did.
    pub const fn take_error(&mut self) -> Option<WindowError> {
        self.error.take()
    }

    /// Says from now on where the journal is.
    pub fn keep_whereabouts(&mut self, whereabouts: ending::Whereabouts) {
        self.keeper.keep_whereabouts(whereabouts);
    }

    /// Ends the journal; where something is not saved and nobody wanted to lose it, it is there.
    pub fn end_journal(&mut self, ending: Ending) -> Option<PathBuf> {
        self.keeper.end(&self.editor, ending)
    }

    fn open(&mut self, event_loop: &ActiveEventLoop) {
        self.title = title(&self.editor);
        let attributes = place::attributes(event_loop, self.settings_file.settings.window.as_ref());
        let window = event_loop.create_window(attributes);
        match window {
            Ok(window) => self.open_device(event_loop, Arc::new(window), None),
            Err(error) => {
                let variables = display::variables();
                self.give_up(event_loop, WindowError::NoDisplay { reason: error.to_string(), variables });
            }
        }
    }

    fn give_up(&mut self, event_loop: &ActiveEventLoop, error: WindowError) {
        self.error = Some(error);
        event_loop.exit();
    }

    /// Opens a device for the window, and goes on by [`Self::device_opened`].
    #[cfg(not(target_arch = "wasm32"))]
    fn open_device(
        &mut self,
        event_loop: &ActiveEventLoop,
        window: Arc<Window>,
        reader: Option<accesskit_winit::Adapter>,
    ) {
        let opened = if reader.is_some() && self.keeper.loses_device() {
            Err(GpuError::NoAdapter)
        } else {
            Gpu::for_window(&event_loop.owned_display_handle(), &window)
        };
        self.device_opened(event_loop, window, opened, reader);
    }

    /// The same; the device comes by [`UserEvent::DeviceOpened`].
    #[cfg(target_arch = "wasm32")]
    fn open_device(&mut self, _: &ActiveEventLoop, window: Arc<Window>, reader: Option<accesskit_winit::Adapter>) {
        page::open_device(window, reader, self.proxy.clone());
    }

    /// Puts the scene and the panels on a device, at first or again.
    pub(super) fn device_opened(
        &mut self,
        event_loop: &ActiveEventLoop,
        window: Arc<Window>,
        opened: Result<(Gpu, wgpu::Surface<'static>), GpuError>,
        reader: Option<accesskit_winit::Adapter>,
    ) {
        let opened = opened.map_err(WindowError::from);
        match opened.and_then(|device| WindowSurface::new(event_loop, window, device, &self.proxy, reader)) {
            Ok(stage) => {
                self.ui.facts = stage.facts();
                // Set the title after the window is visible, so that tools that search by title find a visible window.
                stage.window.set_title(&self.title);
                stage.window.request_redraw();
                self.stage = Some(stage);
                desktop::ask_theme(self.proxy.clone());
                if !std::mem::replace(&mut self.is_begun, true) {
                    self.begin_at_first(event_loop);
                }
            }
            Err(error) => self.give_up(event_loop, error),
        }
    }

    /// Does what was asked for at the start.
    fn begin_at_first(&mut self, event_loop: &ActiveEventLoop) {
        ending::watch_display(event_loop, self.keeper.whereabouts().clone());
        self.look_as_at_first();
        for command in std::mem::take(&mut self.at_start) {
            self.apply(command);
        }
        if self.editor.undo_label().is_some() {
            self.keeper.restored(&Restore::Ground);
            self.editor.begin_history();
        }
    }

    /// Looks from the work eye, unless the settings say that windows begin with the scene's first eye.
    pub(super) fn look_as_at_first(&mut self) {
        if !self.settings_file.settings.recorded_eye {
            self.apply(Command::View(ViewCommand::SetEye(Eye::Work)));
        }
    }

    /// Recreates all GPU objects after a device loss, in the same window.
    #[cfg(not(target_arch = "wasm32"))]
    fn reopen(&mut self, event_loop: &ActiveEventLoop) {
        if let Some((window, reader)) = self.lose_device() {
            self.open_device(event_loop, window, reader);
        }
    }

    /// Drops all that was on a device which is gone. What is left is the window, and what a screen reader reads of it; `None` if there was
    /// no device.
    pub(super) fn lose_device(&mut self) -> Option<(Arc<Window>, Option<accesskit_winit::Adapter>)> {
        self.by_hand(|hands, shell| hands.let_go(shell));
        let mut lost = self.stage.take()?;
        self.inset = Inset::default();
        self.ui.forget_textures();
        let reader = lost.input.accesskit.take();
        let window = Arc::clone(&lost.window);
        drop(lost);
        // Those under way are gone with the device: each is said to have failed.
        self.take_screenshots();
        self.thumbnail_of = None;
        Some((window, reader))
    }

    /// Shows the panels, applies their commands, and draws the scene after the commands, so a drag appears in the same picture.
    fn redraw(&mut self) {
        let cursor = self.hands.cursor(self);
        let hovered = self.hands.hovered(self);
        self.ui.pointed = self.hands.name_of_lit(&self.editor, hovered);
        self.ui.drawn_eye = self.drawn_eye();
        let Some(stage) = &mut self.stage else { return };
        let start = now();
        let Some(mut laid_out) = stage.lay_out(&mut self.ui, &self.editor, cursor) else { return };
        self.meter.add(Work::Ui, start, now());
        let commands = std::mem::take(&mut laid_out.output.commands);
        let answer = laid_out.output.quit_answer.take();
        let recovery = laid_out.output.recovery.take();
        let (change, overwrite) = (laid_out.output.change.take(), laid_out.output.overwrite.take());
        let panels = std::mem::take(&mut laid_out.output.panels);
        let is_answered = answer.is_some() || recovery.is_some() || change.is_some() || overwrite.is_some();
        let again = !commands.is_empty() || is_answered || laid_out.again_after.is_zero();
        self.show_again = now().checked_add(laid_out.again_after).filter(|_| !laid_out.again_after.is_zero());
        for command in commands {
            self.apply(command);
        }
        if let Some(answer) = recovery {
            self.recovery_answered(answer);
        }
        if let Some(answer) = change {
            self.change_answered(answer);
        }
        if let Some(answer) = overwrite {
            self.overwrite_answered(answer);
        }
        if self.keeper.loses_device() {
            let _ = self.proxy.send_event(UserEvent::DeviceLost);
        }
        assert!(!self.keeper.panics_in_drawing(), "a test asked for this panic in drawing");
        let eye = self.drawn_eye();
        let hands = &self.hands;
        let dot = hands.hovered_dot.and_then(|keyframe| self.editor.path_dot(keyframe));
        let lit = Lit {
            part: hovered,
            dot,
            handle: hands.hovered_handle,
            ball: hands.lit_ball(&self.editor),
            robot: hands.robot_with_balls(&self.editor),
        };
        for (panel, size) in panels {
            if self.settings_file.settings.resized(panel, size) {
                self.keep_settings();
            }
        }
        if let Some(answer) = answer {
            self.quit_answered(answer);
        }
        if let Some(stage) = &mut self.stage {
            stage.paint(&self.editor, eye, lit, laid_out, &mut self.meter);
            self.keeper.drawn();
            if again || eye.is_some() {
                stage.window.request_redraw();
            }
        }
        let statistics = self.meter.picture(now());
        if let (Some(shown), Some(statistics)) = (&mut self.ui.statistics, statistics) {
            *shown = statistics;
        }
        self.plan_thumbnail();
        self.plan_inset();
        self.plan_rest();
        self.read_wanted_folder();
    }

    fn accessibility(&mut self, event: accesskit_winit::WindowEvent) {
        let Some(stage) = &mut self.stage else { return };
        match event {
            accesskit_winit::WindowEvent::InitialTreeRequested => stage.context.enable_accesskit(),
            accesskit_winit::WindowEvent::ActionRequested(request) => stage.input.on_accesskit_action_request(request),
            accesskit_winit::WindowEvent::AccessibilityDeactivated => stage.context.disable_accesskit(),
        }
    }

    pub(super) fn request_redraw(&self) {
        if let Some(stage) = &self.stage {
            stage.window.request_redraw();
        }
    }

    /// Gives the editor the ticks that passed, and says when the next one is due.
    fn tick(&mut self, at: Instant) -> Option<Instant> {
        if !self.editor.wants_ticks() {
            self.last_tick = None;
            return None;
        }
        match self.last_tick.replace(at) {
            None => self.clock.restart(),
            Some(last) => {
                let ticks = self.clock.advance_at_most(at.duration_since(last), LONGEST_STALL);
                self.meter.ticks(ticks);
                if self.editor.tick(ticks) {
                    self.request_redraw();
                }
                self.keeper.ticked(&self.editor, ticks);
                self.meter.add(Work::Evaluation, at, now());
            }
        }
        Some(at + self.clock.until_next_tick())
    }

    /// Handles every window event except `RedrawRequested`.
    fn take_in(&mut self, event: WindowEvent) {
        // What is held is known also while there is no device.
        if let WindowEvent::ModifiersChanged(modifiers) = &event {
            self.hands.modifiers = modifiers.state();
        }
        let Some(stage) = &mut self.stage else { return };
        let mut shows = stage.input.on_window_event(&stage.window, &event).repaint;
        stage.clipboard.fill_in(&mut stage.input, self.ui.has_keyboard(&stage.context));
        match event {
            WindowEvent::CloseRequested => self.apply(Command::File(FileCommand::Quit)),
            WindowEvent::Resized(_) | WindowEvent::ScaleFactorChanged { .. } => {
                stage.outdate();
                shows = true;
            }
            WindowEvent::DroppedFile(path) => {
                if let Some(command) = PathPurpose::Open.command(path) {
                    self.apply(command);
                }
            }
            WindowEvent::Touch(touch) => self.touch(&touch),
            WindowEvent::PinchGesture { delta, .. } => self.by_hand(|hands, shell| hands.pinch(shell, delta)),
            WindowEvent::KeyboardInput { event, is_synthetic, .. } => {
                self.key(&KeyInput::new(&event, is_synthetic, self.hands.modifiers));
            }
            WindowEvent::CursorMoved { position, .. } => {
                let at_px = pixel(position);
                let changes = self.by_hand(|hands, shell| hands.moved(shell, at_px));
                if !changes && let Some(stage) = &mut self.stage {
                    // The panels need not hear of movements over the scene, which change nothing of theirs.
                    stage.input.egui_input_mut().events.pop_if(|event| matches!(event, egui::Event::PointerMoved(_)));
                }
                shows = changes;
            }
            WindowEvent::MouseInput { state, button, .. } => {
                self.by_hand(|hands, shell| hands.button(shell, state, button));
            }
            WindowEvent::MouseWheel { delta, .. } => self.by_hand(|hands, shell| hands.wheel(shell, delta)),
            // What the desktop prefers may have been changed meanwhile, and files as well.
            WindowEvent::Focused(true) => {
                desktop::ask_theme(self.proxy.clone());
                self.look_outside();
            }
            WindowEvent::Focused(false) => self.by_hand(|hands, shell| hands.let_go(shell)),
            _ => {}
        }
        if shows {
            self.request_redraw();
        }
    }

    /// Keeps where the window is for the next one.
    fn keep_place(&mut self) {
        let Some(stage) = &self.stage else { return };
        let settings = &mut self.settings_file.settings;
        let place = place::of_window(&stage.window, settings.window.as_ref());
        if place.is_some() && place != settings.window {
            settings.window = place;
            // Nobody is left to be told where that fails.
            let _ = self.settings_file.write();
        }
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

/// A place in the window.
#[expect(clippy::cast_possible_truncation, reason = "windows are small")]
pub(super) const fn pixel(at: PhysicalPosition<f64>) -> Vec2 {
    Vec2::new(at.x as f32, at.y as f32)
}

fn title(editor: &Editor) -> String {
    let mark = if editor.has_unsaved_changes() { "*" } else { "" };
    format!("{mark}{} • Inbetween", editor.keyframe_file().display())
}

impl ApplicationHandler<UserEvent> for Shell {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.stage.is_none() && self.error.is_none() && !std::mem::replace(&mut self.is_opening, true) {
            self.open(event_loop);
        }
        self.request_redraw();
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, event: UserEvent) {
        match event {
            UserEvent::PathChosen { purpose, proposed, path, took } => {
                self.path_chosen(purpose, &proposed, path, took);
            }
            UserEvent::ExportAt { done, count } => self.export_at(done, count),
            UserEvent::ExportEnded(end) => self.export_ended(end),
            UserEvent::NoFileManager(folder) => {
                let said = texts::no_file_manager(folder.display().to_string());
                self.editor.say(said.with_severity(Severity::Error));
            }
            UserEvent::DesktopTheme(theme) => {
                if let Some(stage) = &self.stage {
                    stage.context.options_mut(|options| options.fallback_theme = theme);
                }
            }
            #[cfg(not(target_arch = "wasm32"))]
            UserEvent::DeviceLost => self.reopen(event_loop),
            #[cfg(target_arch = "wasm32")]
            UserEvent::DeviceLost => page::device_lost(self),
            #[cfg(target_arch = "wasm32")]
            UserEvent::DeviceBack => page::device_back(self),
            #[cfg(target_arch = "wasm32")]
            UserEvent::DeviceOpened => page::device_opened(self, event_loop),
            #[cfg(target_arch = "wasm32")]
            UserEvent::FileCame(path) => page::file_came(self, path),
            #[cfg(target_arch = "wasm32")]
            UserEvent::Pasted(text) => page::pasted(self, text),
            UserEvent::Signal(signal) => {
                self.error = Some(WindowError::Signalled { signal });
                event_loop.exit();
            }
            UserEvent::Accessibility(event) => self.accessibility(event),
        }
        self.request_redraw();
    }

    fn window_event(&mut self, _event_loop: &ActiveEventLoop, _window: WindowId, event: WindowEvent) {
        if matches!(event, WindowEvent::RedrawRequested) {
            self.redraw();
            return;
        }
        let start = now();
        self.take_in(event);
        self.meter.add(Work::Input, start, now());
    }

    fn exiting(&mut self, _event_loop: &ActiveEventLoop) {
        self.keep_place();
        // Cancel a running export, so that no incomplete file remains.
        if let Some(export) = self.export.take() {
            export.end();
        }
        // The window must go before the connection that it was made on.
        self.stage = None;
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        let at = now();
        let next_tick = self.tick(at);
        let next_look = self.look_outside_when_due(at);
        if self.show_again.is_some_and(|due| due <= at) {
            self.show_again = None;
            self.request_redraw();
        }
        self.make_thumbnail(at);
        self.take_screenshots();
        self.make_inset(at);
        self.make_sub_frame(at);
        self.update_title();
        #[cfg(target_arch = "wasm32")]
        {
            self.step_export();
            page::hand_on(self);
        }
        if self.is_quitting && self.screenshots.is_empty() {
            event_loop.exit();
        }
        let screenshots = self.next_screenshot_look();
        let due =
            [next_tick, next_look, self.show_again, self.thumbnail_due, self.inset.due, self.rest_due, screenshots];
        let due = due.into_iter().flatten().min();
        event_loop.set_control_flow(due.map_or(ControlFlow::Wait, ControlFlow::WaitUntil));
    }
}
