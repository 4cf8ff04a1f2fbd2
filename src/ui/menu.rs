//! The menu bar: its items are rows of the table of bindings. At its right, the file and whether it has unsaved changes.

use egui::{Align, Button, Label, Layout, MenuBar, Response, RichText, Sense, Ui, vec2};

use super::Shown;
use super::choices::{Choice, Topic, choices};
use super::icons::{self, Icon, was_pressed};
use super::theme::{ROW, Tokens};
use super::words::Words;
use crate::editor::keymap::{Binding, Group};
use crate::editor::{Command, Editor, FileCommand, PlaybackCommand, ViewCommand, WindowCommand};

/// The menus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Menu {
    File,
    Edit,
    View,
    Animation,
    Help,
}

impl Menu {
    const ALL: [Self; 5] = [Self::File, Self::Edit, Self::View, Self::Animation, Self::Help];

    fn name(self, words: Words) -> &'static str {
        match self {
            Self::File => words.say("File"),
            Self::Edit => words.say("Edit"),
            Self::View => words.say("View"),
            Self::Animation => words.say("Animation"),
            Self::Help => words.say("Help"),
        }
    }
}

/// What the window shows that the editor does not know of.
#[derive(Clone, Copy, Debug)]
pub struct On {
    /// All that was said.
    pub messages: bool,
    /// How fast the window is.
    pub statistics: bool,
}

/// Room at both sides of an item, in points; at the left a tick stands in it.
const INSET: f32 = 20.0;

/// The menu that shows a row.
fn menu_of(binding: &Binding) -> Menu {
    match (&binding.command, binding.group) {
        (Command::Undo | Command::Redo | Command::Cancel, _) | (_, Group::Keyframes | Group::Timeline) => Menu::Edit,
        (Command::View(ViewCommand::ToggleHelp), _) => Menu::Help,
        (Command::Window(WindowCommand::ShowCommands | WindowCommand::ShowKeys | WindowCommand::ShowManual), _) => {
            Menu::Help
        }
        (_, Group::Playing) => Menu::Animation,
        (_, Group::View | Group::Window) => Menu::View,
        (_, Group::File) => Menu::File,
    }
}

/// The place of a row in its menu, smaller first; between different places stands a line.
fn order(command: &Command) -> u8 {
    match command {
        Command::Undo | Command::Redo | Command::File(FileCommand::ChooseOpen) => 0,
        Command::File(FileCommand::Screenshot(_)) | Command::Window(WindowCommand::ShowExport) => 7,
        Command::Window(_) => 8,
        Command::Cancel | Command::File(FileCommand::Quit) => 9,
        _ => 5,
    }
}

/// Shows the bar.
pub fn show(ui: &mut Ui, shown: Shown<'_>, on: On, commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    MenuBar::new().ui(ui, |ui| {
        for menu in Menu::ALL {
            ui.menu_button(menu.name(words), |ui| {
                ui.set_min_width(240.0);
                ui.spacing_mut().button_padding.x = INSET;
                ui.spacing_mut().item_spacing.y = 0.0;
                let rows = shown.keymap.bindings().iter();
                let mut rows: Vec<&Binding> = rows.filter(|binding| menu_of(binding) == menu).collect();
                rows.sort_by_key(|binding| order(&binding.command));
                let mut last_order = rows.first().map_or(0, |binding| order(&binding.command));
                for binding in rows {
                    let own_order = order(&binding.command);
                    if own_order > last_order {
                        ui.separator();
                    }
                    last_order = own_order;
                    item(ui, shown.editor, binding, on, commands);
                    if binding.command == Command::File(FileCommand::ChooseOpen) {
                        recent(ui, shown, commands);
                    }
                }
                more_items(ui, menu, shown, commands);
            });
        }
        file_name(ui, shown);
    });
}

fn item(ui: &mut Ui, editor: &Editor, binding: &Binding, on: On, commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    let label = match (&binding.command, editor.undo_label(), editor.redo_label()) {
        (Command::Undo, Some(step), _) => words.fill("Undo {}", &[words.say(step)]),
        (Command::Redo, _, Some(step)) => words.fill("Redo {}", &[words.say(step)]),
        (Command::Playback(PlaybackCommand::PlayOrStop), ..) if editor.is_playing() => words.say("Stop").to_owned(),
        (Command::Playback(PlaybackCommand::PlayOrStop), ..) => words.say("Play").to_owned(),
        (Command::Playback(PlaybackCommand::PauseOrResume), ..) if editor.is_paused() => words.say("Go on").to_owned(),
        (Command::Playback(PlaybackCommand::PauseOrResume), ..) => words.say("Pause").to_owned(),
        _ => words.say(binding.name).to_owned(),
    };
    let session = editor.session();
    let is_on = match binding.command {
        Command::View(ViewCommand::ToggleArcball) => session.shows_arcball,
        Command::View(ViewCommand::TogglePath) => session.shows_path,
        Command::View(ViewCommand::ToggleComparison) => session.compares,
        Command::View(ViewCommand::ToggleHelp) => session.shows_help,
        Command::View(ViewCommand::TogglePanels) => session.shows_panels,
        Command::View(ViewCommand::StartPicking) => session.is_picking,
        Command::Window(WindowCommand::ToggleMessages) => on.messages,
        Command::Window(WindowCommand::ToggleStatistics) => on.statistics,
        _ => false,
    };
    let button =
        Button::new(label).shortcut_text(RichText::new(binding.menu_key()).monospace()).min_size(vec2(0.0, ROW));
    let response = ui.add_enabled(editor.can(&binding.command), button);
    tick(ui, &response, is_on);
    let response = response.on_hover_text(words.say(binding.help));
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

fn choice(ui: &mut Ui, editor: &Editor, choice: &Choice, label: &str, commands: &mut Vec<Command>) {
    let button = Button::new(label).min_size(vec2(0.0, ROW));
    let response = ui.add_enabled(editor.can(&choice.command), button);
    tick(ui, &response, choice.is_on);
    if was_pressed(&response) {
        commands.push(choice.command.clone());
        ui.close();
    }
}

/// A menu in a menu, of all choices of a topic.
fn submenu(ui: &mut Ui, topic: Topic, shown: Shown<'_>, all: &[Choice], commands: &mut Vec<Command>) {
    ui.menu_button(topic.name(Words::of(ui)), |ui| {
        ui.set_min_width(160.0);
        ui.spacing_mut().button_padding.x = INSET;
        ui.spacing_mut().item_spacing.y = 0.0;
        for one in all.iter().filter(|one| one.topic == topic) {
            choice(ui, shown.editor, one, &one.label, commands);
        }
    });
}

fn recent(ui: &mut Ui, shown: Shown<'_>, commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    let has_some = !shown.settings.recent.is_empty();
    ui.add_enabled_ui(has_some, |ui| {
        ui.menu_button(Topic::Recent.name(words), |ui| {
            ui.set_min_width(240.0);
            ui.spacing_mut().button_padding.x = INSET;
            ui.spacing_mut().item_spacing.y = 0.0;
            let all = choices(shown.editor, shown.settings, words);
            for one in all.iter().filter(|one| one.topic == Topic::Recent) {
                choice(ui, shown.editor, one, &short(&one.label), commands);
            }
            ui.separator();
            if was_pressed(&ui.add(Button::new(words.say("Forget them")).min_size(vec2(0.0, ROW)))) {
                commands.push(Command::Window(WindowCommand::ForgetRecent));
                ui.close();
            }
        });
    });
}

/// A path's end, which tells most, where all of it is too long for a menu.
fn short(path: &str) -> String {
    const MOST: usize = 60;
    match path.chars().count().checked_sub(MOST) {
        None | Some(0) => path.to_owned(),
        Some(surplus) => format!("…{}", path.chars().skip(surplus).collect::<String>()),
    }
}

/// What the table has no rows for.
fn more_items(ui: &mut Ui, menu: Menu, shown: Shown<'_>, commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    let all = choices(shown.editor, shown.settings, words);
    match menu {
        Menu::View => {
            for topic in [Topic::Scale, Topic::Theme, Topic::Language] {
                submenu(ui, topic, shown, &all, commands);
            }
            ui.separator();
            for one in all.iter().filter(|one| one.topic == Topic::Eye) {
                choice(ui, shown.editor, one, &words.fill("Look from {}", &[&one.label]), commands);
            }
        }
        Menu::Animation => {
            ui.separator();
            for one in all.iter().filter(|one| one.topic == Topic::Interpolation) {
                choice(ui, shown.editor, one, &one.label, commands);
            }
        }
        Menu::File | Menu::Edit | Menu::Help => {}
    }
}

fn file_name(ui: &mut Ui, shown: Shown<'_>) {
    let tokens = Tokens::of(ui);
    let words = Words::of(ui);
    let editor = shown.editor;
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        ui.add_space(8.0);
        let is_unsaved = editor.has_unsaved_changes();
        if is_unsaved {
            let (rect, response) = ui.allocate_exact_size(vec2(8.0, 8.0), Sense::hover());
            ui.painter().circle_filled(rect.center(), 3.0, tokens.accent);
            response.on_hover_text(words.say("Unsaved changes"));
        }
        let name =
            editor.path().file_name().map_or_else(|| editor.path().to_string_lossy(), |name| name.to_string_lossy());
        let path = editor.path().display().to_string();
        let tip = if is_unsaved {
            let key = super::key_of(shown.keymap, &Command::File(FileCommand::Write));
            words.fill("{}: not all is saved. {} writes it.", &[&path, &key])
        } else {
            path
        };
        ui.add(Label::new(RichText::new(name).color(tokens.dim)).truncate().sense(Sense::hover())).on_hover_text(tip);
    });
}
