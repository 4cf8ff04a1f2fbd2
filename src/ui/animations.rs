//! Which of a model's animations is opened.

use std::path::PathBuf;

use egui::{ScrollArea, Ui};

use super::words::Words;
use crate::editor::{Beginning, Command, WindowCommand};
use crate::words::texts;

/// The question.
#[derive(Clone, Debug, PartialEq)]
pub struct AnimationQuestion {
    /// The model's file.
    pub path: PathBuf,
    /// The names of its animations.
    pub animations: Vec<String>,
}

/// Shows it. Says whether it is over.
pub(super) fn show(ui: &mut Ui, question: &AnimationQuestion, commands: &mut Vec<Command>) -> bool {
    let words = Words::of(ui);
    ui.heading(words.say(texts::WHICH_ANIMATION));
    ui.add_space(4.0);
    let name = question.path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    ui.label(words.message(texts::animations_of_model(name, question.animations.len())));
    ui.add_space(8.0);
    let mut chosen = None;
    ScrollArea::vertical().max_height(280.0).show(ui, |ui| {
        for (index, name) in question.animations.iter().enumerate() {
            let button = ui.add_sized([ui.available_width(), 0.0], egui::Button::new(format!("{index}  {name}")));
            if button.clicked() {
                chosen = Some(index);
            }
        }
    });
    ui.add_space(12.0);
    let is_cancelled = ui.button(words.say(texts::CANCEL)).clicked();
    if let Some(animation) = chosen {
        let beginning = Beginning::Model { path: question.path.clone(), animation: Some(animation) };
        commands.push(Command::Window(WindowCommand::Begin(beginning)));
    }
    chosen.is_some() || is_cancelled
}
