//! The status line: where we are, the last message, how fast the window is where that is wanted, and how large the scene is.

use egui::{Align, Label, Layout, RichText, Ui};

use super::statistics::Statistics;
use super::theme::Tokens;
use super::words::Words;
use crate::editor::{Editor, Severity};
use crate::words::{Argument, texts};

/// Shows the line.
pub fn show(ui: &mut Ui, editor: &Editor, statistics: Option<&Statistics>) {
    let tokens = Tokens::of(ui);
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        let words = Words::of(ui);
        let nodes = words.message(texts::count_nodes(editor.scene().rbt_count()));
        ui.label(RichText::new(nodes).small().color(tokens.dim));
        ui.add_space(8.0);
        if let Some(statistics) = statistics {
            ui.label(RichText::new(statistics.sentence(words)).small().color(tokens.dim));
            ui.add_space(8.0);
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let position = editor.position_message();
            ui.label(RichText::new(words.message(&position)).small().color(tokens.dim));
            let session = editor.session();
            let selected = session.selected.len().max(session.selected_keys.len());
            let is_current = session.selected.first().copied() == editor.document().keyframes.current();
            if selected > 1 || (session.selected.len() == 1 && !is_current) {
                let text = format!("·  {}", words.message(texts::count_selected(selected)));
                ui.label(RichText::new(text).small().color(tokens.selected));
            }
            if let Some(message) = editor.status() {
                // A message that begins with the position need not say it again.
                let said = match (message.argument("position"), message.argument("rest")) {
                    (Some(Argument::Message(at)), Some(Argument::Message(rest))) if *at == position => rest,
                    _ => message,
                };
                let colour = match message.severity() {
                    Severity::Information | Severity::Outcome => tokens.text,
                    Severity::Error => tokens.error,
                };
                ui.label(RichText::new("·").small().color(tokens.dim));
                ui.add(Label::new(RichText::new(words.message(said)).size(12.0).color(colour)).truncate());
            }
        });
    });
}
