//! The help over the dimmed window: hotkeys by group and what the mouse does, with a field that searches in it. Hotkeys work meanwhile.

use egui::{
    Align, Align2, Area, Color32, Frame, Id, Layout, Margin, Order, Rect, RichText, Role, ScrollArea, Sense, Stroke,
    TextEdit, Ui, WidgetInfo, pos2, vec2,
};

use super::binding_of;
use super::gestures::{GESTURES, Place};
use super::icons::was_pressed;
use super::theme::{CORNER, GRID, ROW, Tokens, number_font};
use super::words::Words;
use crate::editor::keymap::{Binding, Chord, Group};
use crate::editor::{Command, ViewCommand};
use crate::words::{Argument, texts};

/// The least and the largest width of a column of keys and sentences, in points.
const COLUMN: [f32; 2] = [312.0, 396.0];
/// The most columns side by side.
const MOST_COLUMNS: usize = 3;
/// Room between two of those, in points.
const GAP: f32 = 16.0;
/// Height of a line, in points.
const LINE: f32 = 19.0;
/// Room around the help in the window, in points.
const AROUND: f32 = 16.0;
/// The part of a column that keys may take before what they do.
const MOST_KEYS: f32 = 0.42;

/// What is searched for.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Help {
    typed: String,
}

/// A heading and what stands under it: keys or gestures, and what they do.
struct Section {
    heading: &'static str,
    rows: Vec<(Vec<String>, &'static str)>,
}

impl Help {
    /// Shows the help. A click on its button or beside it asks to hide it.
    pub fn show(&mut self, ui: &Ui, bindings: &[Binding], commands: &mut Vec<Command>) {
        let tokens = Tokens::of(ui);
        let window = ui.ctx().content_rect();
        let behind = Area::new(Id::unique("behind the help")).order(Order::Middle).fixed_pos(window.min);
        let is_left = behind.show(ui.ctx(), |ui| {
            ui.painter().rect_filled(window, 0.0, tokens.shade);
            ui.interact(window, Id::unique("beside the help"), Sense::CLICK).clicked()
        });
        if is_left.inner {
            commands.push(Command::View(ViewCommand::ToggleHelp));
        }
        Area::new(Id::unique("help"))
            .order(Order::Middle)
            .pivot(Align2::CENTER_CENTER)
            .fixed_pos(window.center())
            .constrain_to(window)
            .show(ui.ctx(), |ui| {
                Frame::new()
                    .fill(tokens.panel)
                    .stroke(Stroke::new(1.0, tokens.line))
                    .corner_radius(2 * CORNER)
                    .inner_margin(Margin::same(16))
                    .show(ui, |ui| {
                        let room = window.size() - vec2(2.0, 2.0) * (AROUND + 17.0);
                        self.contents(ui, bindings, room, commands);
                    });
            });
    }

    fn contents(&mut self, ui: &mut Ui, bindings: &[Binding], room: egui::Vec2, commands: &mut Vec<Command>) {
        let count = (1..MOST_COLUMNS).take_while(|&count| columns_width(count + 1, COLUMN[0]) <= room.x).count() + 1;
        let column = ((room.x + GAP) / points(count) - GAP).min(COLUMN[1]);
        let width = columns_width(count, column);
        ui.set_width(width);
        self.bar(ui, bindings, commands);
        ui.add_space(2.0 * GRID);
        let words = Words::of(ui);
        let sections = sections(bindings, &self.typed, words);
        if sections.is_empty() {
            ui.label(RichText::new(words.message(texts::no_command_named(&self.typed))).color(Tokens::of(ui).dim));
        }
        let height = (room.y - ROW - 4.0 * GRID).max(4.0 * LINE);
        ui.spacing_mut().scroll = egui::style::ScrollStyle::thin();
        let scrolled = ScrollArea::vertical().max_height(height).min_scrolled_height(height).auto_shrink([false, true]);
        scrolled.show(ui, |ui| {
            ui.spacing_mut().item_spacing = vec2(GAP, 2.0);
            ui.horizontal_top(|ui| {
                for part in in_columns(sections, count) {
                    ui.vertical(|ui| {
                        ui.set_width(column);
                        let keys = keys_width(ui, &part, column * MOST_KEYS);
                        for section in part {
                            show_section(ui, &section, keys, column);
                        }
                    });
                }
            });
        });
    }

    /// The heading, the field, and how to leave.
    fn bar(&mut self, ui: &mut Ui, bindings: &[Binding], commands: &mut Vec<Command>) {
        let words = Words::of(ui);
        ui.horizontal(|ui| {
            ui.heading(words.say(texts::HELP));
            ui.add_space(2.0 * GRID);
            let hint = words.say(texts::SEARCH_THE_HELP);
            let field = ui.add(TextEdit::singleline(&mut self.typed).desired_width(160.0).hint_text(hint));
            field.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, hint));
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                if was_pressed(&ui.button(words.say(texts::CLOSE))) {
                    commands.push(Command::View(ViewCommand::ToggleHelp));
                }
                let help = binding_of(bindings, &Command::View(ViewCommand::ToggleHelp)).map(Binding::menu_key);
                let keys = words.message(texts::key_or_escape(help.unwrap_or_default()));
                ui.label(RichText::new(keys).small().color(Tokens::of(ui).dim));
            });
        });
    }
}

fn columns_width(count: usize, column: f32) -> f32 {
    points(count) * (column + GAP) - GAP
}

#[expect(clippy::cast_precision_loss, reason = "these are counts of rows and columns")]
const fn points(count: usize) -> f32 {
    count as f32
}

/// What matches the search, by groups and places.
fn sections(bindings: &[Binding], typed: &str, words: Words) -> Vec<Section> {
    let typed = typed.trim().to_lowercase();
    let fits = |text: &str| text.to_lowercase().contains(&typed);
    let groups = Group::ALL.into_iter().map(|group| {
        // What has no key stands in the menus and in the list of commands.
        let rows = bindings.iter().filter(|binding| binding.group == group && !binding.chords.is_empty());
        let rows = rows.filter(|binding| {
            let also = binding.synonyms().map_or("", |also| words.say(also));
            let labels = binding.chords.iter().any(|chord| fits(&chord.label()));
            labels || fits(words.say(binding.title())) || fits(words.say(binding.explanation())) || fits(also)
        });
        let row =
            |binding: &Binding| (binding.chords.iter().map(Chord::label).collect(), words.say(binding.explanation()));
        Section { heading: words.say(group.heading()), rows: rows.map(row).collect() }
    });
    let places = Place::ALL.into_iter().map(|place| {
        let rows = GESTURES.iter().filter(|gesture| gesture.place == place);
        let rows = rows.map(|gesture| (words.say(gesture.how), words.say(gesture.does)));
        let rows = rows.filter(|(how, does)| fits(how) || fits(does));
        let rows = rows.map(|(how, does)| (vec![how.to_owned()], does)).collect();
        Section { heading: words.say(place.heading()), rows }
    });
    groups.chain(places).filter(|section| !section.rows.is_empty()).collect()
}

/// The sections in their order, in columns that are about equally long.
fn in_columns(sections: Vec<Section>, count: usize) -> Vec<Vec<Section>> {
    let lines = |section: &Section| section.rows.len() + 2;
    let all: usize = sections.iter().map(lines).sum();
    let mut columns: Vec<Vec<Section>> = (0..count).map(|_| Vec::new()).collect();
    let mut before = 0;
    for section in sections {
        let middle = before + lines(&section) / 2;
        before += lines(&section);
        columns[(middle * count / all.max(1)).min(count - 1)].push(section);
    }
    columns
}

/// Room for the keys of some sections, in points: for the widest of them that is not wider than `most`. What is wider has a line of its
/// own.
fn keys_width(ui: &Ui, sections: &[Section], most: f32) -> f32 {
    let rows = sections.iter().flat_map(|section| &section.rows);
    let widths = rows.map(|(keys, _)| caps_width(ui, keys) + GRID);
    widths.filter(|width| *width <= most).fold(0.0, f32::max)
}

/// The width of a row's keys, with a gap after each, in points.
fn caps_width(ui: &Ui, keys: &[String]) -> f32 {
    keys.iter().map(|key| cap_width(ui, key) + GRID).sum()
}

fn cap_width(ui: &Ui, key: &str) -> f32 {
    let galley = ui.painter().layout_no_wrap(key.to_owned(), number_font(), Color32::PLACEHOLDER);
    galley.size().x.max(6.0) + 10.0
}

fn show_section(ui: &mut Ui, section: &Section, keys: f32, column: f32) {
    ui.label(RichText::new(section.heading).strong().color(Tokens::of(ui).accent_text));
    ui.add_space(2.0);
    for (labels, meaning) in &section.rows {
        row(ui, labels, meaning, keys, column);
    }
    ui.add_space(12.0);
}

fn row(ui: &mut Ui, keys: &[String], meaning: &str, keys_width: f32, column: f32) {
    let tokens = Tokens::of(ui);
    let above = if caps_width(ui, keys) + GRID > keys_width { LINE } else { 0.0 };
    let font = egui::FontId::proportional(12.0);
    let galley = ui.painter().layout(meaning.to_owned(), font, tokens.text, (column - keys_width).max(60.0));
    let (rect, response) = ui.allocate_exact_size(vec2(column, above + galley.size().y.max(LINE)), Sense::hover());
    let either = keys.iter().map(Argument::from).reduce(|one, other| texts::key_or_key(one, other).into());
    let label = Words::of(ui).message(texts::key_does(either.unwrap_or_else(|| "".into()), meaning));
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &label));
    let mut left = rect.left();
    for key in keys {
        let galley = ui.painter().layout_no_wrap(key.clone(), number_font(), tokens.text);
        let cap = Rect::from_min_size(pos2(left, rect.top() + 1.0), vec2(cap_width(ui, key), LINE - 2.0));
        ui.painter().rect(cap, 3.0, tokens.raised, Stroke::new(1.0, tokens.line), egui::StrokeKind::Inside);
        ui.painter().galley(cap.center() - galley.size() / 2.0, galley, Color32::PLACEHOLDER);
        left = cap.right() + GRID;
    }
    // The first line stands on the keys' line.
    let first = galley.rows.first().map_or(LINE, |row| row.height());
    let top = rect.top() + above + ((LINE - first) / 2.0).max(0.0);
    ui.painter().galley(pos2(rect.left() + keys_width, top), galley, tokens.text);
}
