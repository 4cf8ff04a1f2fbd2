//! The menu bar: its items are the bindings of the table of commands. At its right, the file and whether it has unsaved changes.

use egui::accesskit::HasPopup;
use egui::text::LayoutJob;
use egui::{
    Align, Button, Key, Label, Layout, MenuBar, Modifiers, Popup, Response, RichText, ScrollArea, Sense, Stroke,
    TextFormat, Ui, vec2,
};

use super::PanelInput;
use super::choices::{Choice, Topic, choices};
use super::icons::{self, Icon, was_pressed};
use super::theme::{GRID, MENU_BAR, ROW, Tokens, text_font};
use super::words::Words;
use crate::editor::commands::{Binding, Menu, Submenu, WindowState};
use crate::editor::{Command, Editor, Eye, FileCommand, PlaybackCommand, ViewCommand, WindowCommand};
use crate::words::texts;

/// The name of a menu.
fn name_of(menu: Menu, words: Words) -> &'static str {
    words.say(match menu {
        Menu::File => texts::FILE,
        Menu::Edit => texts::EDIT,
        Menu::View => texts::VIEW,
        Menu::Animation => texts::ANIMATION,
        Menu::Help => texts::HELP,
    })
}

/// The letter that opens a menu with Alt: the first of its English name, in every language.
const fn letter_of(menu: Menu) -> (char, Key) {
    match menu {
        Menu::File => ('F', Key::F),
        Menu::Edit => ('E', Key::E),
        Menu::View => ('V', Key::V),
        Menu::Animation => ('A', Key::A),
        Menu::Help => ('H', Key::H),
    }
}

/// The name of a menu, with its letter underlined while Alt is held. A name without the letter has it in brackets.
fn title(ui: &Ui, menu: Menu) -> LayoutJob {
    let (letter, _) = letter_of(menu);
    let mut name = name_of(menu, Words::of(ui)).to_owned();
    if !name.contains(letter) {
        name = format!("{name}({letter})");
    }
    let at = name.find(letter).unwrap_or(0);
    let colour = Tokens::of(ui).text;
    let plain = TextFormat::simple(text_font(), colour);
    let width = if ui.input(|input| input.modifiers.alt) { 1.0 } else { 0.0 };
    let underlined = TextFormat { underline: Stroke::new(width, colour), ..plain.clone() };
    let mut job = LayoutJob::default();
    job.append(&name[..at], 0.0, plain.clone());
    job.append(&name[at..=at], 0.0, underlined);
    job.append(&name[at + 1..], 0.0, plain);
    job
}

/// The menu that the keyboard asks for: Alt with its letter, or F10 for the first. A hotkey with the same keys comes first.
fn asked_for(ui: &Ui, shown: PanelInput<'_>) -> Option<Menu> {
    let is_hotkey = |label: &str| {
        let bindings = shown.keymap.bindings().iter();
        bindings.flat_map(|binding| &binding.chords).any(|chord| chord.label() == label)
    };
    let pressed = |modifiers, key| ui.input_mut(|input| input.consume_key(modifiers, key));
    if !is_hotkey("F10") && pressed(Modifiers::NONE, Key::F10) {
        return Some(Menu::ALL[0]);
    }
    Menu::ALL.into_iter().find(|&menu| {
        let (letter, key) = letter_of(menu);
        !is_hotkey(&format!("Alt+{letter}")) && pressed(Modifiers::ALT, key)
    })
}

/// Room at both sides of an item, in points; at the left a tick stands in it.
const INSET: f32 = 20.0;

/// Shows the bar.
pub fn show(ui: &mut Ui, shown: PanelInput<'_>, window: WindowState, commands: &mut Vec<Command>) {
    let asked_for = asked_for(ui, shown);
    MenuBar::new().ui(ui, |ui| {
        for menu in Menu::ALL {
            let shown_menu = ui.menu_button(title(ui, menu), |ui| {
                scrolled(ui, |ui| items_of(ui, menu, shown, window, commands));
            });
            let button = shown_menu.response;
            let is_open = shown_menu.inner.is_some();
            if asked_for == Some(menu) {
                Popup::open_id(ui.ctx(), Popup::default_response_id(&button));
                button.request_focus();
            }
            super::tree::ring(ui, button.rect, &button);
            ui.ctx().accesskit_node_builder(button.id, |node| {
                node.set_has_popup(HasPopup::Menu);
                node.set_expanded(is_open);
            });
        }
        file_name(ui, shown);
    });
}

/// A menu that is higher than the window below the menu bar scrolls.
fn scrolled(ui: &mut Ui, items: impl FnOnce(&mut Ui)) {
    let height = ui.ctx().content_rect().height() - MENU_BAR - 6.0 * GRID;
    ScrollArea::vertical().max_height(height).min_scrolled_height(height).show(ui, items);
}

fn items_of(ui: &mut Ui, menu: Menu, shown: PanelInput<'_>, window: WindowState, commands: &mut Vec<Command>) {
    ui.set_min_width(240.0);
    ui.spacing_mut().button_padding.x = INSET;
    ui.spacing_mut().item_spacing.y = 0.0;
    let items = shown.keymap.bindings().iter();
    let mut items: Vec<&Binding> = items.filter(|binding| binding.menu == menu).collect();
    items.sort_by_key(|binding| binding.section);
    let mut section = items.first().map_or(0, |binding| binding.section);
    let mut within = None;
    for &binding in &items {
        if binding.section > section {
            ui.separator();
        }
        section = binding.section;
        if let Some(folded) = binding.submenu {
            if within.replace(folded) != Some(folded) {
                of_submenu(ui, folded, &items, shown, window, commands);
            }
            continue;
        }
        item(ui, shown.editor, binding, window, commands);
        if binding.command == Command::File(FileCommand::ChooseOpen) {
            recent(ui, shown, commands);
            let all = choices(shown.editor, shown.settings, Words::of(ui));
            submenu(ui, Topic::Example, shown, &all, commands);
        }
    }
    more_items(ui, menu, shown, commands);
}

fn item(ui: &mut Ui, editor: &Editor, binding: &Binding, window: WindowState, commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    let label = match (&binding.command, editor.undo_label(), editor.redo_label()) {
        (Command::Undo, Some(step), _) => words.message(texts::undo_step(words.say(step))),
        (Command::Redo, _, Some(step)) => words.message(texts::redo_step(words.say(step))),
        (Command::Playback(PlaybackCommand::PlayOrStop), ..) if editor.is_playing() => {
            words.say(texts::STOP).to_owned()
        }
        (Command::Playback(PlaybackCommand::PlayOrStop), ..) => words.say(texts::PLAY).to_owned(),
        (Command::Playback(PlaybackCommand::PauseOrResume), ..) if editor.is_paused() => {
            words.say(texts::GO_ON).to_owned()
        }
        (Command::Playback(PlaybackCommand::PauseOrResume), ..) => words.say(texts::PAUSE).to_owned(),
        _ => words.say(binding.title()).to_owned(),
    };
    let button =
        Button::new(label).shortcut_text(RichText::new(binding.menu_key()).monospace()).min_size(vec2(0.0, ROW));
    let response = ui.add_enabled(editor.can(&binding.command), button);
    tick(ui, &response, (binding.is_on)(editor, window));
    let response = response.on_hover_text(words.say(binding.explanation()));
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
fn submenu(ui: &mut Ui, topic: Topic, shown: PanelInput<'_>, all: &[Choice], commands: &mut Vec<Command>) {
    ui.menu_button(topic.name(Words::of(ui)), |ui| {
        ui.set_min_width(160.0);
        ui.spacing_mut().button_padding.x = INSET;
        ui.spacing_mut().item_spacing.y = 0.0;
        for one in all.iter().filter(|one| one.topic == topic) {
            choice(ui, shown.editor, one, &one.label, commands);
        }
    });
}

/// A menu in a menu, of the table's items and what the table has no rows for.
fn of_submenu(
    ui: &mut Ui,
    submenu: Submenu,
    items: &[&Binding],
    shown: PanelInput<'_>,
    window: WindowState,
    commands: &mut Vec<Command>,
) {
    let words = Words::of(ui);
    ui.menu_button(words.say(submenu.title()), |ui| {
        ui.set_min_width(220.0);
        ui.spacing_mut().button_padding.x = INSET;
        ui.spacing_mut().item_spacing.y = 0.0;
        for binding in items.iter().filter(|binding| binding.submenu == Some(submenu)) {
            item(ui, shown.editor, binding, window, commands);
        }
        if submenu == Submenu::Look {
            ui.separator();
            let all = choices(shown.editor, shown.settings, words);
            for one in all.iter().filter(|one| one.topic == Topic::Eye) {
                let label = match &one.command {
                    Command::View(ViewCommand::SetEye(Eye::Work)) => {
                        words.say(texts::LOOK_FROM_THE_WORK_EYE).to_owned()
                    }
                    _ => words.message(texts::look_from_eye(&one.label)),
                };
                choice(ui, shown.editor, one, &label, commands);
            }
        }
    });
}

fn recent(ui: &mut Ui, shown: PanelInput<'_>, commands: &mut Vec<Command>) {
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
            if was_pressed(&ui.add(Button::new(words.say(texts::FORGET_THEM)).min_size(vec2(0.0, ROW)))) {
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
fn more_items(ui: &mut Ui, menu: Menu, shown: PanelInput<'_>, commands: &mut Vec<Command>) {
    let words = Words::of(ui);
    let all = choices(shown.editor, shown.settings, words);
    match menu {
        Menu::View => {
            for topic in [Topic::SnapTurns, Topic::SnapMoves, Topic::Scale, Topic::Theme, Topic::Language] {
                submenu(ui, topic, shown, &all, commands);
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

fn file_name(ui: &mut Ui, shown: PanelInput<'_>) {
    let tokens = Tokens::of(ui);
    let words = Words::of(ui);
    let editor = shown.editor;
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        ui.add_space(8.0);
        let is_unsaved = editor.has_unsaved_changes();
        if is_unsaved {
            let (rect, response) = ui.allocate_exact_size(vec2(8.0, 8.0), Sense::hover());
            ui.painter().circle_filled(rect.center(), 3.0, tokens.accent);
            response.on_hover_text(words.say(texts::UNSAVED_CHANGES));
        }
        let name = editor
            .keyframe_file()
            .file_name()
            .map_or_else(|| editor.keyframe_file().to_string_lossy(), |name| name.to_string_lossy());
        let path = editor.keyframe_file().display().to_string();
        let tip = if is_unsaved {
            let key = super::key_of(shown.keymap, &Command::File(FileCommand::Write));
            words.message(texts::not_all_saved(&path, &key))
        } else {
            path
        };
        ui.add(Label::new(RichText::new(name).color(tokens.dim)).truncate().sense(Sense::hover())).on_hover_text(tip);
    });
}
