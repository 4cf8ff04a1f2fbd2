//! The help overlay: hotkeys by group, and mouse gestures.

use egui::{Align2, Area, Color32, Frame, Margin, Order, Rect, RichText, ScrollArea, Sense, Stroke, Ui, vec2};

use super::binding_of;
use super::icons::was_pressed;
use super::theme::{CORNER, Tokens, number_font};
use super::words::Words;
use crate::editor::keymap::{Binding, Chord, Group};
use crate::editor::{Command, ViewCommand};
use crate::words::{Argument, texts};

/// What the mouse does over the scene, as (gesture, meaning).
fn mouse(words: Words) -> [(&'static str, &'static str); 7] {
    [
        (words.say(texts::LEFT_DRAG), words.say(texts::TURN_BY_THE_ARCBALL)),
        (words.say(texts::RIGHT_DRAG), words.say(texts::MOVE_IN_THE_VIEWS_PLANE)),
        (words.say(texts::MIDDLE_DRAG), words.say(texts::MOVE_ALONG_THE_VIEW)),
        (words.say(texts::LEFT_RIGHT_DRAG), words.say(texts::MOVE_ALONG_THE_VIEW)),
        (words.say(texts::SPACE_LEFT_DRAG), words.say(texts::MOVE_ALONG_THE_VIEW)),
        (words.say(texts::WHEEL), words.say(texts::MOVE_ALONG_THE_VIEW)),
        (words.say(texts::CTRL_CLICK), words.say(texts::CHOOSE_THE_NODE_TO_MOVE_THE_GROUND)),
    ]
}

/// Width of a column of keys and sentences, in points.
const COLUMN: f32 = 396.0;
/// Room between two of those, in points.
const GAP: f32 = 16.0;
/// Height of a line, in points.
const LINE: f32 = 19.0;

/// Shows the help; a click on its cross asks to hide it.
pub fn show(ui: &Ui, bindings: &[Binding], commands: &mut Vec<Command>) {
    let tokens = Tokens::of(ui);
    // Three columns need more than the 3D view.
    let window = ui.ctx().content_rect();
    Area::new(egui::Id::unique("help"))
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
                    let room = window.size() - vec2(44.0, 64.0);
                    ScrollArea::both()
                        .min_scrolled_width(room.x)
                        .min_scrolled_height(room.y)
                        .show(ui, |ui| contents(ui, bindings, room.x, commands));
                });
        });
}

fn contents(ui: &mut Ui, bindings: &[Binding], room: f32, commands: &mut Vec<Command>) {
    ui.spacing_mut().item_spacing = vec2(GAP, 2.0);
    ui.spacing_mut().interact_size.y = LINE;
    let groups = |ui: &mut Ui, groups: &[Group]| {
        let width = keys_width(bindings, groups);
        for &one in groups {
            group(ui, bindings, one, width);
        }
    };
    let first = |ui: &mut Ui| groups(ui, &[Group::Keyframes, Group::Playing]);
    let second = |ui: &mut Ui| groups(ui, &[Group::Timeline, Group::View]);
    let mut third = |ui: &mut Ui| {
        groups(ui, &[Group::File, Group::Window]);
        mouse_group(ui, keys_width(bindings, &[Group::File, Group::Window]).max(124.0));
        close(ui, bindings, commands);
    };
    if room >= 3.0 * COLUMN + 2.0 * GAP {
        ui.horizontal_top(|ui| {
            ui.vertical(first);
            ui.vertical(second);
            ui.vertical(&mut third);
        });
    } else if room >= 2.0 * COLUMN + GAP {
        ui.horizontal_top(|ui| {
            ui.vertical(|ui| {
                first(ui);
                second(ui);
            });
            ui.vertical(&mut third);
        });
    } else {
        first(ui);
        second(ui);
        third(ui);
    }
}

/// Room for the keys of some groups, in points.
fn keys_width(bindings: &[Binding], groups: &[Group]) -> f32 {
    let width = |chord: &Chord| 7.0 * points(chord.label().len()) + 14.0;
    let rows = bindings.iter().filter(|binding| groups.contains(&binding.group));
    let widest = rows.map(|binding| binding.chords.iter().map(width).sum::<f32>()).fold(0.0, f32::max);
    widest.clamp(100.0, COLUMN / 2.0)
}

#[expect(clippy::cast_precision_loss, reason = "labels are short")]
const fn points(letters: usize) -> f32 {
    letters as f32
}

fn mouse_group(ui: &mut Ui, width: f32) {
    let words = Words::of(ui);
    heading(ui, words.say(texts::MOUSE_OVER_THE_SCENE));
    for (gesture, meaning) in mouse(words) {
        row(ui, &[gesture.to_owned()], meaning, width);
    }
}

fn close(ui: &mut Ui, bindings: &[Binding], commands: &mut Vec<Command>) {
    let help = binding_of(bindings, &Command::View(ViewCommand::ToggleHelp)).map(Binding::menu_key);
    let keys = Words::of(ui).message(texts::key_or_escape(help.unwrap_or_default()));
    ui.add_space(16.0);
    ui.allocate_ui_with_layout(vec2(COLUMN, 24.0), egui::Layout::right_to_left(egui::Align::Center), |ui| {
        if was_pressed(&ui.button(Words::of(ui).say(texts::CLOSE))) {
            commands.push(Command::View(ViewCommand::ToggleHelp));
        }
        ui.label(RichText::new(keys).small().color(Tokens::of(ui).dim));
    });
}

fn group(ui: &mut Ui, bindings: &[Binding], group: Group, width: f32) {
    let words = Words::of(ui);
    heading(ui, words.say(group.heading()));
    // What has no key stands in the menus and in the list of commands.
    for binding in bindings.iter().filter(|binding| binding.group == group && !binding.chords.is_empty()) {
        let keys: Vec<String> = binding.chords.iter().map(Chord::label).collect();
        row(ui, &keys, words.say(binding.explanation()), width);
    }
    ui.add_space(12.0);
}

fn heading(ui: &mut Ui, text: &str) {
    ui.label(RichText::new(text).strong().color(Tokens::of(ui).accent));
    ui.add_space(2.0);
}

fn row(ui: &mut Ui, keys: &[String], meaning: &str, width: f32) {
    let sentences = COLUMN - 4.0 - width;
    let tokens = Tokens::of(ui);
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let (rect, _) = ui.allocate_exact_size(vec2(width, LINE), Sense::hover());
        let mut left = rect.left();
        for key in keys {
            let galley = ui.painter().layout_no_wrap(key.clone(), number_font(), tokens.text);
            let cap =
                Rect::from_min_size(egui::pos2(left, rect.top() + 1.0), vec2(galley.size().x.max(6.0) + 10.0, 17.0));
            ui.painter().rect(cap, 3.0, tokens.raised, Stroke::new(1.0, tokens.line), egui::StrokeKind::Inside);
            ui.painter().galley(cap.center() - galley.size() / 2.0, galley, Color32::PLACEHOLDER);
            left = cap.right() + 4.0;
        }
        let galley = ui.painter().layout(meaning.to_owned(), egui::FontId::proportional(12.0), tokens.text, sentences);
        let height = galley.size().y.max(LINE);
        let (rect, response) = ui.allocate_exact_size(vec2(sentences, height), Sense::hover());
        let either = keys.iter().map(Argument::from).reduce(|one, other| texts::key_or_key(one, other).into());
        let label = Words::of(ui).message(texts::key_does(either.unwrap_or_else(|| "".into()), meaning));
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, &label));
        ui.painter().galley(rect.left_top() + vec2(0.0, (height - galley.size().y) / 2.0), galley, tokens.text);
    });
}
