//! The help over the scene: every binding by its group, and what the mouse does.

use egui::{Align2, Area, Color32, Frame, Margin, Order, Rect, RichText, ScrollArea, Sense, Stroke, Ui, vec2};

use super::icons::was_pressed;
use super::theme::{CORNER, Tokens, number_font};
use crate::editor::keymap::{Binding, Group};
use crate::editor::{Command, ViewCommand};

/// What the mouse does over the scene, as (gesture, meaning).
pub const MOUSE: [(&str, &str); 7] = [
    ("Left drag", "Turn, by the arcball"),
    ("Right drag", "Move in the view's plane"),
    ("Middle drag", "Move along the view"),
    ("Left+right drag", "Move along the view"),
    ("Space+left drag", "Move along the view"),
    ("Wheel", "Move along the view"),
    ("Ctrl+click", "Choose the node to move; the ground chooses none"),
];

/// Width of the column of keys, in points.
const KEYS: f32 = 164.0;
/// Width of the column of sentences, in points.
const SENTENCES: f32 = 288.0;

/// Width of a column of both, in points.
const COLUMN: f32 = KEYS + 4.0 + SENTENCES;
/// Room between two of those, in points.
const GAP: f32 = 20.0;
/// Height of a line, in points.
const LINE: f32 = 19.0;

/// Shows the help; a click on its cross asks to hide it.
pub fn show(ui: &Ui, viewport: Rect, bindings: &[Binding], commands: &mut Vec<Command>) {
    let tokens = Tokens::of(ui);
    Area::new(egui::Id::unique("help"))
        .order(Order::Middle)
        .pivot(Align2::CENTER_CENTER)
        .fixed_pos(viewport.center())
        .constrain_to(viewport)
        .show(ui.ctx(), |ui| {
            Frame::new()
                .fill(tokens.panel)
                .stroke(Stroke::new(1.0, tokens.line))
                .corner_radius(2 * CORNER)
                .inner_margin(Margin::same(16))
                .show(ui, |ui| {
                    let room = viewport.size() - vec2(48.0, 64.0);
                    ScrollArea::both()
                        .min_scrolled_width(room.x)
                        .min_scrolled_height(room.y)
                        .show(ui, |ui| contents(ui, bindings, room.x >= 2.0 * COLUMN + GAP, commands));
                });
        });
}

fn contents(ui: &mut Ui, bindings: &[Binding], is_wide: bool, commands: &mut Vec<Command>) {
    ui.spacing_mut().item_spacing = vec2(GAP, 2.0);
    ui.spacing_mut().interact_size.y = LINE;
    let left = |ui: &mut Ui| {
        group(ui, bindings, Group::Keyframes);
        group(ui, bindings, Group::Playing);
        heading(ui, "Mouse over the scene");
        for (gesture, meaning) in MOUSE {
            row(ui, &[gesture.to_owned()], meaning);
        }
    };
    let mut right = |ui: &mut Ui| {
        group(ui, bindings, Group::Timeline);
        group(ui, bindings, Group::View);
        group(ui, bindings, Group::File);
        ui.add_space(16.0);
        ui.allocate_ui_with_layout(vec2(COLUMN, 24.0), egui::Layout::right_to_left(egui::Align::Center), |ui| {
            if was_pressed(&ui.button("Close")) {
                commands.push(Command::View(ViewCommand::ToggleHelp));
            }
            ui.label(RichText::new("h or Esc").small().color(Tokens::of(ui).dim));
        });
    };
    if is_wide {
        ui.horizontal_top(|ui| {
            ui.vertical(left);
            ui.vertical(&mut right);
        });
    } else {
        left(ui);
        ui.add_space(12.0);
        right(ui);
    }
}

fn group(ui: &mut Ui, bindings: &[Binding], group: Group) {
    heading(ui, group.heading());
    for binding in bindings.iter().filter(|binding| binding.group == group) {
        let keys: Vec<String> = binding.chords.iter().map(crate::editor::keymap::Chord::label).collect();
        row(ui, &keys, binding.help);
    }
    ui.add_space(12.0);
}

fn heading(ui: &mut Ui, text: &str) {
    ui.label(RichText::new(text).strong().color(Tokens::of(ui).accent));
    ui.add_space(2.0);
}

fn row(ui: &mut Ui, keys: &[String], meaning: &str) {
    let tokens = Tokens::of(ui);
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let (rect, _) = ui.allocate_exact_size(vec2(KEYS, LINE), Sense::hover());
        let mut left = rect.left();
        for key in keys {
            let galley = ui.painter().layout_no_wrap(key.clone(), number_font(), tokens.text);
            let cap =
                Rect::from_min_size(egui::pos2(left, rect.top() + 1.0), vec2(galley.size().x.max(6.0) + 10.0, 17.0));
            ui.painter().rect(cap, 3.0, tokens.raised, Stroke::new(1.0, tokens.line), egui::StrokeKind::Inside);
            ui.painter().galley(cap.center() - galley.size() / 2.0, galley, Color32::PLACEHOLDER);
            left = cap.right() + 4.0;
        }
        let galley = ui.painter().layout(meaning.to_owned(), egui::FontId::proportional(12.0), tokens.text, SENTENCES);
        let height = galley.size().y.max(LINE);
        let (rect, response) = ui.allocate_exact_size(vec2(SENTENCES, height), Sense::hover());
        let label = format!("{}: {meaning}", keys.join(" or "));
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, &label));
        ui.painter().galley(rect.left_top() + vec2(0.0, (height - galley.size().y) / 2.0), galley, tokens.text);
    });
}
