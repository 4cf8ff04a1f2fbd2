//! Which scene and which animation of a model are opened.

use std::path::PathBuf;

use egui::{Button, ScrollArea, Ui};

use super::words::Words;
use crate::editor::{Beginning, Command, ModelChoice, WindowCommand};
use crate::interchange::gltf_in::Contents;
use crate::words::texts;

/// The question: first for the scene, then for the animation, each if there are several.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelQuestion {
    path: PathBuf,
    contents: Contents,
    choice: ModelChoice,
}

impl ModelQuestion {
    /// A question of which nothing is answered.
    pub fn new(path: PathBuf, contents: Contents) -> Self {
        Self { path, contents, choice: ModelChoice::default() }
    }

    /// Shows it. Says whether it is over.
    pub fn show(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) -> bool {
        let words = Words::of(ui);
        let Self { path, contents, choice } = self;
        let Contents { scenes, own_scene, animations } = &*contents;
        let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let asks_scene = scenes.len() > 1 && choice.scene.is_none();
        let (heading, explanation, names) = if asks_scene {
            (texts::WHICH_SCENE, texts::scenes_of_model(file, scenes.len(), *own_scene), scenes)
        } else {
            (texts::WHICH_ANIMATION, texts::animations_of_model(file, animations.len()), animations)
        };
        ui.heading(words.say(heading));
        ui.add_space(4.0);
        ui.label(words.message(explanation));
        ui.add_space(8.0);
        let chosen = chosen(ui, names);
        ui.add_space(12.0);
        let is_cancelled = ui.button(words.say(texts::CANCEL)).clicked();
        if asks_scene {
            choice.scene = chosen;
        } else {
            choice.animation = chosen;
        }
        let is_answered = chosen.is_some() && (!asks_scene || animations.len() <= 1);
        if is_answered {
            let beginning = Beginning::Model { path: path.clone(), choice: Some(*choice) };
            commands.push(Command::Window(WindowCommand::Begin(beginning)));
        }
        is_answered || is_cancelled
    }
}

/// A button for each of a list, with its number and its name. The one that is clicked.
fn chosen(ui: &mut Ui, names: &[Option<String>]) -> Option<usize> {
    let mut chosen = None;
    ScrollArea::vertical().max_height(280.0).show(ui, |ui| {
        for (number, name) in names.iter().enumerate() {
            let label = name.as_ref().map_or_else(|| number.to_string(), |name| format!("{number}  {name}"));
            if ui.add_sized([ui.available_width(), 0.0], Button::new(label)).clicked() {
                chosen = Some(number);
            }
        }
    });
    chosen
}
