//! What stands around scene and timeline, driven by pointer and keyboard with no window: the division of the window, menus, lists,
//! dialogs, the help, the first steps; and that each item of a menu is its command.

mod access;
mod dialogs;
mod files;
mod help;
mod items;
mod layout;
mod palette;
mod paths;
mod tour;

use std::path::PathBuf;
use std::sync::Arc;

use egui::{Key, Modifiers, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use inbetween::editor::{Command, Edit, Editor, Effect};
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use inbetween::settings::Settings;
use inbetween::ui::{Panels, UiOutput, theme};

/// The panels of an editor. Commands reach the editor, and those of the window the panels.
pub(crate) struct App {
    pub(crate) editor: Editor,
    pub(crate) ui: Panels,
    pub(crate) settings: Settings,
    pub(crate) commands: Vec<Command>,
    pub(crate) effects: Vec<Effect>,
    pub(crate) output: UiOutput,
    pub(crate) viewport: egui::Rect,
    is_dressed: bool,
}

impl App {
    pub(crate) fn new(editor: Editor) -> Self {
        Self {
            editor,
            ui: Panels::new(),
            settings: Settings::default(),
            commands: Vec::new(),
            effects: Vec::new(),
            output: UiOutput::default(),
            viewport: egui::Rect::NOTHING,
            is_dressed: false,
        }
    }

    pub(crate) fn apply(&mut self, command: Command) {
        match self.editor.apply(command) {
            Ok(Some(Effect::Window(command))) => drop(self.ui.perform(&command, &mut self.settings).unwrap()),
            Ok(effect) => self.effects.extend(effect),
            Err(_) => {}
        }
    }
}

/// An editor of a built-in scene with some keyframes.
pub(crate) fn editor_of(scene: &str, keyframes: usize) -> Editor {
    let scene = built_in_scene(scene).expect("it is built in");
    let mut editor = Editor::new(Arc::new(scene), PathBuf::from("folder/wave.json"));
    for _ in 0..keyframes {
        editor.apply(Command::Edit(Edit::CreateKeyframe)).unwrap();
    }
    editor
}

pub(crate) fn editor(keyframes: usize) -> Editor {
    editor_of(DEFAULT_SCENE, keyframes)
}

pub(crate) fn harness_of(app: App, size: Vec2) -> Harness<'static, App> {
    let mut harness = Harness::builder().with_size(size).with_max_steps(60).with_step_dt(1.0 / 60.0).build_ui_state(
        |ui, app: &mut App| {
            if !std::mem::replace(&mut app.is_dressed, true) {
                theme::install(ui.ctx());
            }
            let output = app.ui.show(ui, &app.editor);
            app.viewport = output.viewport;
            for command in output.commands.clone() {
                app.apply(command.clone());
                app.commands.push(command);
            }
            app.output.go_on(output);
        },
        app,
    );
    harness.run();
    harness
}

pub(crate) fn harness(editor: Editor) -> Harness<'static, App> {
    harness_of(App::new(editor), vec2(1280.0, 800.0))
}

pub(crate) fn click(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by_label(label).click();
    harness.run();
}

pub(crate) fn press(harness: &mut Harness<'_, App>, key: Key) {
    harness.key_press(key);
    harness.run();
}

pub(crate) fn type_text(harness: &mut Harness<'_, App>, text: &str) {
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.event(egui::Event::Text(text.to_owned()));
    harness.run();
}

pub(crate) fn does(harness: &mut Harness<'_, App>, command: Command) {
    harness.state_mut().apply(command);
    harness.run();
}

/// Drags by the pointer, in points.
pub(crate) fn drag(harness: &mut Harness<'_, App>, from: egui::Pos2, to: egui::Pos2) {
    harness.hover_at(from);
    harness.run();
    harness.drag_at(from);
    harness.run();
    harness.hover_at(from.lerp(to, 0.5));
    harness.run();
    harness.hover_at(to);
    harness.run();
    harness.drop_at(to);
    harness.run();
}
