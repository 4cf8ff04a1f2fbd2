//! Which program this is: its version and licences, and where more is said.

use egui::{Align, Layout, RichText, Ui};

use super::dialogs::default_button;
use super::theme::Tokens;
use super::words::Words;
use crate::editor::{Command, WindowCommand};
use crate::words::texts;

/// Shows it. Says whether it is over.
pub(super) fn show(ui: &mut Ui, commands: &mut Vec<Command>) -> bool {
    let words = Words::of(ui);
    let dim = Tokens::of(ui).dim;
    ui.heading(format!("{} {}", words.say(texts::WINDOW_OF_INBETWEEN), env!("CARGO_PKG_VERSION")));
    ui.add_space(4.0);
    ui.label(words.say(texts::ABOUT_WHAT));
    ui.add_space(8.0);
    ui.label(words.message(texts::about_licence(env!("CARGO_PKG_LICENSE"))));
    ui.label(RichText::new(words.say(texts::ABOUT_FONTS)).small().color(dim));
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
