//! Modal dialogs: a path, unsaved work, the command list, hotkeys, export.

use egui::{Align, Align2, Frame, Id, Key, Layout, Margin, Modal, Ui, vec2};

use super::about::About;
use super::export::ExportDialog;
use super::hotkeys::{DialogState, HotkeysDialog};
use super::model_question::ModelQuestion;
use super::overwrite::{self, OverwriteQuestion};
use super::palette::Palette;
use super::path_dialog::PathDialog;
use super::theme::{CORNER, Tokens, dialog_width};
use super::words::Words;
use super::{PanelInput, QuitAnswer, UiOutput};
use crate::words::texts;

/// The dialog that is open.
#[derive(Clone, Debug, PartialEq)]
pub enum Dialog {
    /// Which file?
    Path(Box<PathDialog>),
    /// What about unsaved work?
    Unsaved {
        /// Whether the program ends afterwards; if not, it goes on with another document.
        is_quitting: bool,
    },
    /// Which program is this?
    About(About),
    /// Is a file to be replaced?
    Overwrite(OverwriteQuestion),
    /// Which command?
    Commands(Palette),
    /// Which keys?
    Hotkeys(HotkeysDialog),
    /// What of a model?
    Model(ModelQuestion),
    /// Which film?
    Export(Box<ExportDialog>),
}

/// Shows the question, if there is one.
pub fn show(ui: &Ui, dialog: &mut Option<Dialog>, shown: PanelInput<'_>, output: &mut UiOutput) {
    let Some(question) = dialog else { return };
    let escape = ui.input(|input| input.key_pressed(Key::Escape));
    let is_list = matches!(question, Dialog::Commands(_));
    let margin = Margin::same(if is_list { 8 } else { 16 });
    let frame = Frame::popup(ui.style()).inner_margin(margin).corner_radius(2 * CORNER);
    // Each has a place and a size of its own.
    let id = Id::unique(match question {
        Dialog::Commands(_) => "commands",
        Dialog::Export(_) => "export",
        Dialog::Overwrite(_) => "overwrite",
        Dialog::Path(_) => "path",
        Dialog::Unsaved { .. } => "unsaved",
        Dialog::Hotkeys(_) => "hotkeys",
        Dialog::About(_) => "about",
        Dialog::Model(_) => "model",
    });
    let mut modal = Modal::new(id).backdrop_color(Tokens::of(ui).shade).frame(frame);
    if matches!(question, Dialog::Commands(_) | Dialog::Hotkeys(_)) {
        // From a place of their own, so that they do not move while their height changes.
        modal = modal.area(Modal::default_area(id).anchor(Align2::CENTER_TOP, vec2(0.0, 64.0)));
    }
    let response = modal.show(ui.ctx(), |ui| match question {
        Dialog::Path(path) => outcome(path.show(ui, shown.settings, output)),
        Dialog::Unsaved { is_quitting } => at_width(ui, |ui| unsaved(ui, *is_quitting, shown, output)),
        Dialog::About(about) => outcome(about.show(ui, shown.facts, &mut output.commands)),
        Dialog::Model(question) => at_width(ui, |ui| question.show(ui, &mut output.commands)),
        Dialog::Overwrite(question) => outcome(overwrite::show(ui, question, output)),
        Dialog::Commands(palette) => outcome(palette.show(ui, shown, &mut output.commands)),
        Dialog::Hotkeys(keys) => keys.show(ui, shown, &mut output.commands),
        Dialog::Export(export) => outcome(export.show(ui, shown, shown.is_exporting, &mut output.commands)),
    });
    let is_left = match question {
        // These lose nothing where one clicks beside them.
        Dialog::Commands(_) | Dialog::Hotkeys(_) | Dialog::About(_) | Dialog::Model(_) => {
            response.backdrop_response.clicked()
        }
        Dialog::Path(_) | Dialog::Unsaved { .. } | Dialog::Overwrite(_) | Dialog::Export(_) => false,
    };
    if response.inner == DialogState::IsOver || is_left || (escape && response.inner != DialogState::TookEscape) {
        *dialog = match dialog.take() {
            Some(Dialog::Path(path)) => path.after(),
            _ => None,
        };
    }
}

const fn outcome(is_over: bool) -> DialogState {
    if is_over { DialogState::IsOver } else { DialogState::Stays }
}

fn at_width(ui: &mut Ui, contents: impl FnOnce(&mut Ui) -> bool) -> DialogState {
    ui.set_width(dialog_width(ui, 400.0));
    outcome(contents(ui))
}

fn unsaved(ui: &mut Ui, is_quitting: bool, shown: PanelInput<'_>, output: &mut UiOutput) -> bool {
    let editor = shown.editor;
    let (changes, posing) = (editor.has_unsaved_changes(), editor.has_unsaved_posing());
    let words = Words::of(ui);
    ui.heading(words.say(match (is_quitting, changes, posing) {
        (true, true, _) => texts::SAVE_THE_CHANGES_BEFORE_QUITTING,
        (true, false, true) => texts::QUIT_WITHOUT_KEEPING_THE_POSE,
        (true, false, false) => texts::QUIT_BEFORE_THE_EXPORT_IS_DONE,
        (false, true, _) => texts::SAVE_THE_CHANGES_BEFORE_GOING_ON,
        (false, false, _) => texts::GO_ON_WITHOUT_KEEPING_THE_POSE,
    }));
    ui.add_space(8.0);
    if editor.has_unsaved_keyframes() {
        let path = editor.keyframe_file().display().to_string();
        ui.label(words.message(texts::keyframes_not_saved(&path)));
    }
    if editor.has_unsaved_scene() {
        ui.label(match editor.scene_path() {
            Some(path) => words.message(texts::scene_not_saved(path.display().to_string())),
            None => words.say(texts::THE_SCENES_CONTROL_NODES_AND_KEYS_ARE).to_owned(),
        });
    }
    if posing {
        ui.label(words.say(texts::THE_SCENE_STANDS_IN_A_POSE_THAT));
    }
    if shown.is_exporting && is_quitting {
        ui.label(words.say(texts::AN_EXPORT_IS_UNDER_WAY_NOTHING_OF));
    }
    ui.add_space(16.0);
    let mut is_cancelled = false;
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        let mut answer = |ui: &mut Ui, label: &str, is_primary: bool, answer: QuitAnswer| {
            if if is_primary { default_button(ui, label, true) } else { ui.button(label).clicked() } {
                output.quit_answer = Some(answer);
            }
        };
        let can_keep = posing && !editor.is_playing();
        if can_keep {
            answer(ui, words.say(texts::KEEP_POSE_AND_SAVE), true, QuitAnswer::KeepPoseAndSave);
        }
        if changes {
            answer(ui, words.say(texts::SAVE), !can_keep, QuitAnswer::Save);
        }
        answer(ui, words.say(texts::DISCARD), false, QuitAnswer::Discard);
        is_cancelled = ui.button(words.say(texts::CANCEL)).clicked();
    });
    output.quit_answer.is_some() || is_cancelled
}

/// The button that is meant to be pressed. Says whether it was: by a click, or by Enter anywhere in the dialog but on another button.
/// It stands after all fields, which give the keyboard back at Enter. Where nothing else has the keyboard it has it, so that Tab goes on
/// from there.
pub fn default_button(ui: &mut Ui, label: &str, is_enabled: bool) -> bool {
    let tokens = Tokens::of(ui);
    let stroke = egui::Stroke::new(1.0, tokens.accent);
    let button = egui::Button::new(label.to_owned()).fill(tokens.accent_fill).stroke(stroke);
    let response = ui.add_enabled(is_enabled, button);
    let is_free = is_enabled && ui.memory(|memory| memory.focused().is_none());
    if is_free {
        response.request_focus();
    }
    response.clicked() || (is_free && ui.input(|input| input.key_pressed(Key::Enter)))
}
