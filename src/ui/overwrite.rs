//! The question before a file is replaced that holds something that the user may not know of.

use std::path::PathBuf;

use egui::{Align, Layout, RichText, ScrollArea, Ui};

use super::UiOutput;
use super::dialogs::default_button;
use super::theme::{Tokens, dialog_width};
use super::words::Words;
use crate::words::{Message, texts};

/// The question's width in points.
const WIDTH: f32 = 520.0;
/// The height in points in which differences scroll.
const DIFFERENCES_HEIGHT: f32 = 220.0;

/// Why the user is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OverwriteReason {
    /// Another program has made the file since the start.
    Appeared,
    /// Another program has changed the file since it was read or written.
    Changed,
    /// The list is empty, and the file has so many keyframes.
    HoldsKeyframes(usize),
}

/// What the user is asked.
#[derive(Clone, Debug, PartialEq)]
pub struct OverwriteQuestion {
    /// The file.
    pub path: PathBuf,
    /// Why it is asked.
    pub reason: OverwriteReason,
    /// What differs between the file and the window; `None` until somebody wants to know.
    pub differences: Option<Vec<Message>>,
}

/// What the user answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OverwriteAnswer {
    /// Replace the file, and keep what it holds beside it.
    Overwrite,
    /// Write to another file.
    SaveAs,
    /// Read the file, and write nothing.
    Reload,
    /// Say what differs; the question stays.
    Compare,
}

/// Shows the question. Says whether it is over.
pub(super) fn show(ui: &mut Ui, question: &OverwriteQuestion, output: &mut UiOutput) -> bool {
    ui.set_width(dialog_width(ui, WIDTH));
    let words = Words::of(ui);
    let name = question.path.file_name().unwrap_or(question.path.as_os_str()).to_string_lossy().into_owned();
    ui.heading(words.message(match question.reason {
        OverwriteReason::Appeared => texts::overwrite_appeared(&name),
        OverwriteReason::Changed => texts::overwrite_changed(&name),
        OverwriteReason::HoldsKeyframes(count) => {
            texts::overwrite_holds_keyframes(&name, texts::count_keyframes(count))
        }
    }));
    ui.add_space(8.0);
    ui.label(RichText::new(question.path.display().to_string()).small().color(Tokens::of(ui).dim));
    ui.add_space(8.0);
    match &question.differences {
        None => drop(ui.label(words.say(texts::OVERWRITE_EXPLAINED))),
        Some(differences) => {
            ScrollArea::vertical().max_height(DIFFERENCES_HEIGHT).show(ui, |ui| {
                for difference in differences {
                    ui.label(words.message(difference.clone()));
                }
            });
        }
    }
    ui.add_space(16.0);
    let mut is_cancelled = false;
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        let mut answer = |ui: &mut Ui, label: &str, is_primary: bool, answer: OverwriteAnswer| {
            // Enter chooses what loses nothing.
            if if is_primary { default_button(ui, label, true) } else { ui.button(label).clicked() } {
                output.overwrite = Some(answer);
            }
        };
        answer(ui, words.say(texts::OVERWRITE_SAVE_AS), true, OverwriteAnswer::SaveAs);
        answer(ui, words.say(texts::OVERWRITE_OVERWRITE), false, OverwriteAnswer::Overwrite);
        answer(ui, words.say(texts::CHANGED_RELOAD), false, OverwriteAnswer::Reload);
        if question.differences.is_none() {
            answer(ui, words.say(texts::CHANGED_COMPARE), false, OverwriteAnswer::Compare);
        }
        is_cancelled = ui.button(words.say(texts::CANCEL)).clicked();
    });
    is_cancelled || output.overwrite.is_some_and(|answer| answer != OverwriteAnswer::Compare)
}
