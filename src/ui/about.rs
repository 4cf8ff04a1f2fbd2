//! Which program this is: its version, what a report of a fault says, its licences and those of what it is made of, and where more is
//! said.

use egui::{Align, Layout, RichText, ScrollArea, Ui, vec2};

use super::dialogs::default_button;
use super::icons::was_pressed;
use super::theme::{Tokens, dialog_width};
use super::words::Words;
use crate::editor::{Command, WindowCommand};
use crate::notices;
use crate::words::texts;

/// Width of the dialog, in points.
const WIDTH: f32 = 400.0;
/// Width and height of the notices, which have lines of up to 80 characters, in points.
const NOTICES: [f32; 2] = [620.0, 320.0];

/// The dialog.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct About {
    shows_notices: bool,
}

impl About {
    /// Shows it. Says whether it is over.
    pub(super) fn show(&mut self, ui: &mut Ui, facts: &str, commands: &mut Vec<Command>) -> bool {
        let words = Words::of(ui);
        let dim = Tokens::of(ui).dim;
        ui.set_width(dialog_width(ui, if self.shows_notices { NOTICES[0] } else { WIDTH }));
        ui.heading(format!("{} {}", words.say(texts::WINDOW_OF_INBETWEEN), env!("CARGO_PKG_VERSION")));
        ui.add_space(4.0);
        ui.label(words.say(texts::ABOUT_WHAT));
        ui.add_space(8.0);
        ui.label(words.message(texts::about_licence(env!("CARGO_PKG_LICENSE"))));
        ui.label(RichText::new(words.say(texts::ABOUT_FONTS)).small().color(dim));
        let label = if self.shows_notices { texts::ABOUT_HIDE_NOTICES } else { texts::ABOUT_SHOW_NOTICES };
        if ui.link(words.say(label)).clicked() {
            self.shows_notices ^= true;
        }
        if self.shows_notices {
            show_notices(ui);
        } else if !facts.is_empty() {
            ui.add_space(8.0);
            ui.label(RichText::new(facts.trim_end()).small().monospace());
            if was_pressed(&ui.button(words.say(texts::ABOUT_COPY))) {
                ui.ctx().copy_text(facts.to_owned());
            }
        }
        ui.add_space(16.0);
        let mut is_over = false;
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            is_over = default_button(ui, words.say(texts::CLOSE), true);
            if ui.link(words.say(texts::OPEN_THE_MANUAL)).clicked() {
                commands.push(Command::Window(WindowCommand::ShowManual));
                is_over = true;
            }
        });
        is_over
    }
}

fn show_notices(ui: &mut Ui) {
    let lines = notices::lines();
    let height = ui.text_style_height(&egui::TextStyle::Small);
    let [width, seen] = NOTICES;
    let width = dialog_width(ui, width);
    ui.allocate_ui(vec2(width, seen), |ui| {
        let area = ScrollArea::both().auto_shrink(false).max_height(seen);
        area.show_rows(ui, height, lines.len(), |ui, rows| {
            for line in &lines[rows] {
                ui.label(RichText::new(*line).small().monospace());
            }
        });
    });
}
