//! The status line: where we are, the last message, how fast the window is where that is wanted, and how large the scene is.

use egui::{Align, Label, Layout, RichText, Ui};

use super::statistics::Statistics;
use super::theme::Tokens;
use super::words::Words;
use crate::editor::{Editor, Severity};

/// Shows the line.
pub fn show(ui: &mut Ui, editor: &Editor, statistics: Option<&Statistics>) {
    let tokens = Tokens::of(ui);
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        let words = Words::of(ui);
        let nodes = words.fill("{} nodes", &[&editor.scene().rbt_count().to_string()]);
        ui.label(RichText::new(nodes).small().color(tokens.dim));
        ui.add_space(8.0);
        if let Some(statistics) = statistics {
            ui.label(RichText::new(statistics.sentence(words)).small().color(tokens.dim));
            ui.add_space(8.0);
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let place = words.message(&editor.where_we_are());
            let message = editor.message();
            let text = words.message(&message.text);
            let said = text.strip_prefix(&place).map_or(text.as_str(), |rest| rest.trim_start_matches([':', '.', ' ']));
            ui.label(RichText::new(&place).small().color(tokens.dim));
            if !said.is_empty() {
                let colour = match message.severity {
                    Severity::Information | Severity::Outcome => tokens.text,
                    Severity::Error => tokens.error,
                };
                ui.label(RichText::new("·").small().color(tokens.dim));
                ui.add(Label::new(RichText::new(said).size(12.0).color(colour)).truncate());
            }
        });
    });
}
