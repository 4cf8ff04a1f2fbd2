//! Questions that wait for an answer: a path, and what to do with unsaved work.

use std::path::{Path, PathBuf};

use egui::{Align, Frame, Id, Key, Layout, Margin, Modal, RichText, TextEdit, Ui};

use super::theme::{CORNER, Tokens};
use super::{PathPurpose, QuitAnswer, UiOutput};
use crate::editor::{Command, Editor, FileCommand};

/// The question at hand.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Dialog {
    /// Which file?
    Path {
        /// What for.
        purpose: PathPurpose,
        /// What is in the field.
        typed: String,
        /// Whether the field still has to be given the keyboard.
        is_new: bool,
    },
    /// What about unsaved work?
    Quit,
}

impl Dialog {
    /// Asks for a path, and proposes one.
    pub fn for_path(purpose: PathPurpose, proposed: &Path) -> Self {
        Self::Path { purpose, typed: proposed.to_string_lossy().into_owned(), is_new: true }
    }
}

/// Shows the question, if there is one.
pub fn show(ui: &Ui, dialog: &mut Option<Dialog>, editor: &Editor, output: &mut UiOutput) {
    let Some(question) = dialog else { return };
    let escape = ui.input(|input| input.key_pressed(Key::Escape));
    let frame = Frame::popup(ui.style()).inner_margin(Margin::same(16)).corner_radius(2 * CORNER);
    let modal = Modal::new(Id::unique("dialog")).backdrop_color(Tokens::of(ui).shade).frame(frame);
    let is_answered = modal
        .show(ui.ctx(), |ui| {
            ui.set_width(400.0);
            match question {
                Dialog::Path { purpose, typed, is_new } => path(ui, *purpose, typed, is_new, output),
                Dialog::Quit => quit(ui, editor, output),
            }
        })
        .inner;
    if is_answered || escape {
        *dialog = None;
    }
}

fn path(ui: &mut Ui, purpose: PathPurpose, typed: &mut String, is_new: &mut bool, output: &mut UiOutput) -> bool {
    let (heading, verb) = match purpose {
        PathPurpose::Open => ("Open a keyframe file", "Open"),
        PathPurpose::SaveAs => ("Save the keyframes as", "Save"),
    };
    ui.heading(heading);
    ui.add_space(8.0);
    ui.label(RichText::new("Path of the file").small().color(Tokens::of(ui).dim));
    let field = ui.add(TextEdit::singleline(typed).desired_width(f32::INFINITY).hint_text("animation.json"));
    if std::mem::take(is_new) {
        field.request_focus();
    }
    let is_typed = !typed.trim().is_empty();
    let entered = is_typed && field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
    ui.add_space(16.0);
    let mut is_confirmed = false;
    let mut is_cancelled = false;
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        is_confirmed = ui.add_enabled(is_typed, primary(ui, verb)).clicked();
        is_cancelled = ui.button("Cancel").clicked();
    });
    if entered || is_confirmed {
        let path = PathBuf::from(typed.trim());
        output.commands.push(Command::File(match purpose {
            PathPurpose::Open => FileCommand::Open(path),
            PathPurpose::SaveAs => FileCommand::SaveAs(path),
        }));
    }
    entered || is_confirmed || is_cancelled
}

fn quit(ui: &mut Ui, editor: &Editor, output: &mut UiOutput) -> bool {
    let (changes, posing) = (editor.has_unsaved_changes(), editor.has_unsaved_posing());
    ui.heading(if changes { "Save the changes before quitting?" } else { "Quit without keeping the pose?" });
    ui.add_space(8.0);
    if changes {
        ui.label(format!("{} does not hold all of your keyframes and settings.", editor.path().display()));
    }
    if posing {
        ui.label("The robots stand in a pose that no keyframe holds.");
    }
    ui.add_space(16.0);
    let mut is_cancelled = false;
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        let mut answer = |ui: &mut Ui, label: &str, is_primary: bool, answer: QuitAnswer| {
            let button = if is_primary { primary(ui, label) } else { egui::Button::new(label) };
            let response = ui.add(button);
            // Return answers what is proposed, and Tab goes on from there.
            if is_primary && ui.memory(|memory| memory.focused().is_none()) {
                response.request_focus();
            }
            if response.clicked() {
                output.quit_answer = Some(answer);
            }
        };
        let can_keep = posing && !editor.is_playing();
        if can_keep {
            answer(ui, "Keep pose and save", true, QuitAnswer::KeepPoseAndSave);
        }
        if changes {
            answer(ui, "Save", !can_keep, QuitAnswer::Save);
        }
        answer(ui, "Discard", false, QuitAnswer::Discard);
        is_cancelled = ui.button("Cancel").clicked();
    });
    output.quit_answer.is_some() || is_cancelled
}

/// The button that is meant to be pressed.
fn primary(ui: &Ui, label: &str) -> egui::Button<'static> {
    let tokens = Tokens::of(ui);
    egui::Button::new(label.to_owned()).fill(tokens.accent_fill).stroke(egui::Stroke::new(1.0, tokens.accent))
}
