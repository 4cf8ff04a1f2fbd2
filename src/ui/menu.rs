//! The menu bar: its items are rows of the table of bindings. At its right, the file and whether it has unsaved changes.

use egui::{Align, Button, Label, Layout, MenuBar, Response, RichText, Sense, ThemePreference, Ui, vec2};

use super::icons::{self, Icon, was_pressed};
use super::theme::Tokens;
use crate::editor::keymap::{Binding, Group};
use crate::editor::{Command, Edit, Editor, FileCommand, PlaybackCommand, ViewCommand};
use crate::interpolation::Interpolation;

/// The menus, and which rows each takes.
const MENUS: [&str; 5] = ["File", "Edit", "View", "Animation", "Help"];

/// Room at both sides of an item, in points; at the left a tick stands in it.
const INSET: f32 = 20.0;

/// The menu that shows a row.
fn menu_of(binding: &Binding) -> &'static str {
    match (&binding.command, binding.group) {
        (Command::Undo | Command::Redo | Command::Cancel, _) | (_, Group::Keyframes) => "Edit",
        (Command::View(ViewCommand::ToggleHelp), _) => "Help",
        (_, Group::Playing) => "Animation",
        (_, Group::View) => "View",
        (_, Group::Timeline) => "Edit",
        (_, Group::File) => "File",
    }
}

/// The place of a row in its menu, smaller first, and whether a line stands above it.
fn order(command: &Command) -> u8 {
    match command {
        Command::Undo | Command::File(FileCommand::ChooseOpen) => 0,
        Command::Redo => 1,
        Command::File(FileCommand::Screenshot(_)) => 7,
        Command::Cancel | Command::File(FileCommand::Quit) => 9,
        _ => 5,
    }
}

/// Shows the bar.
pub fn show(ui: &mut Ui, editor: &Editor, bindings: &[Binding], commands: &mut Vec<Command>) {
    MenuBar::new().ui(ui, |ui| {
        for menu in MENUS {
            ui.menu_button(menu, |ui| {
                ui.set_min_width(240.0);
                ui.spacing_mut().button_padding.x = INSET;
                ui.spacing_mut().item_spacing.y = 0.0;
                let mut rows: Vec<&Binding> = bindings.iter().filter(|binding| menu_of(binding) == menu).collect();
                rows.sort_by_key(|binding| order(&binding.command));
                let mut last_order = rows.first().map_or(0, |binding| order(&binding.command));
                for binding in rows {
                    let own_order = order(&binding.command);
                    if own_order > last_order && own_order != 1 {
                        ui.separator();
                    }
                    last_order = own_order;
                    item(ui, editor, binding, commands);
                }
                more_items(ui, menu, editor, commands);
            });
        }
        file_name(ui, editor);
    });
}

fn item(ui: &mut Ui, editor: &Editor, binding: &Binding, commands: &mut Vec<Command>) {
    let label = match (&binding.command, editor.undo_label(), editor.redo_label()) {
        (Command::Undo, Some(step), _) => format!("Undo {step}"),
        (Command::Redo, _, Some(step)) => format!("Redo {step}"),
        (Command::Playback(PlaybackCommand::PlayOrStop), ..) if editor.is_playing() => "Stop".to_owned(),
        (Command::Playback(PlaybackCommand::PlayOrStop), ..) => "Play".to_owned(),
        (Command::Playback(PlaybackCommand::PauseOrResume), ..) if editor.is_paused() => "Go on".to_owned(),
        (Command::Playback(PlaybackCommand::PauseOrResume), ..) => "Pause".to_owned(),
        _ => binding.name.to_owned(),
    };
    let session = editor.session();
    let is_on = match binding.command {
        Command::View(ViewCommand::ToggleArcball) => session.shows_arcball,
        Command::View(ViewCommand::ToggleHelp) => session.shows_help,
        Command::View(ViewCommand::TogglePanels) => session.shows_panels,
        Command::View(ViewCommand::StartPicking) => session.is_picking,
        _ => false,
    };
    let button = Button::new(label)
        .shortcut_text(RichText::new(binding.menu_key()).monospace())
        .min_size(vec2(0.0, super::theme::ROW));
    let response = ui.add_enabled(editor.can(&binding.command), button);
    tick(ui, &response, is_on);
    let response = response.on_hover_text(binding.help);
    if was_pressed(&response) {
        commands.push(binding.command.clone());
        ui.close();
    }
}

/// Marks an item that is on.
fn tick(ui: &Ui, item: &Response, is_on: bool) {
    if is_on {
        let centre = item.rect.left_center() + vec2(INSET / 2.0, 0.0);
        icons::paint(ui.painter(), Icon::Tick, centre, Tokens::of(ui).accent);
    }
}

/// What the table has no keys for.
fn more_items(ui: &mut Ui, menu: &str, editor: &Editor, commands: &mut Vec<Command>) {
    let choice = |ui: &mut Ui, is_on: bool, label: &str| {
        let response = ui.add(Button::new(label).min_size(vec2(0.0, super::theme::ROW)));
        tick(ui, &response, is_on);
        let pressed = was_pressed(&response);
        if pressed {
            ui.close();
        }
        pressed
    };
    match menu {
        "View" => {
            ui.separator();
            for (place, &rbt) in editor.scene().eyes().iter().enumerate() {
                let label = format!("Look from {}", editor.scene().rbt_path(rbt));
                if choice(ui, place == editor.session().eye, &label) {
                    commands.push(Command::View(ViewCommand::SetEye(place)));
                }
            }
            ui.separator();
            let theme = ui.options(|options| options.theme_preference);
            for (preference, label) in [
                (ThemePreference::System, "Colours of the system"),
                (ThemePreference::Dark, "Dark colours"),
                (ThemePreference::Light, "Light colours"),
            ] {
                if choice(ui, theme == preference, label) {
                    ui.set_theme(preference);
                }
            }
        }
        "Animation" => {
            ui.separator();
            for interpolation in Interpolation::ALL {
                if choice(ui, editor.document().interpolation == interpolation, interpolation.label()) {
                    commands.push(Command::Edit(Edit::SetInterpolation(interpolation)));
                }
            }
        }
        _ => {}
    }
}

fn file_name(ui: &mut Ui, editor: &Editor) {
    let tokens = Tokens::of(ui);
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        ui.add_space(8.0);
        let is_unsaved = editor.has_unsaved_changes();
        if is_unsaved {
            let (rect, response) = ui.allocate_exact_size(vec2(8.0, 8.0), Sense::hover());
            ui.painter().circle_filled(rect.center(), 3.0, tokens.accent);
            response.on_hover_text("Unsaved changes");
        }
        let name =
            editor.path().file_name().map_or_else(|| editor.path().to_string_lossy(), |name| name.to_string_lossy());
        let tip = if is_unsaved {
            format!("{}: not all is saved. w writes it.", editor.path().display())
        } else {
            editor.path().display().to_string()
        };
        ui.add(Label::new(RichText::new(name).color(tokens.dim)).truncate().sense(Sense::hover())).on_hover_text(tip);
    });
}
