//! The bar above the view that offers what was not saved when a program ended. It takes no keyboard focus of its own.

use std::path::PathBuf;

use egui::{Align, Button, Frame, Label, Layout, Margin, Panel, RichText, Ui};

use super::icons::was_pressed;
use super::theme::Tokens;
use super::words::Words;
use crate::words::{Message, texts};

/// What can be got back.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RecoveryOffer {
    /// The keyframe file's name.
    pub file: String,
    /// Its path.
    pub path: PathBuf,
    /// How many commands were done.
    pub commands: usize,
    /// How long ago they began, in seconds.
    pub seconds: u64,
}

/// What the user answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RecoveryAnswer {
    /// Get it back.
    Restore,
    /// Ask at the next start.
    Later,
    /// It is not wanted.
    Discard,
}

/// Shows the bar; it stays until it is answered.
pub(super) fn show(ui: &mut Ui, offer: &RecoveryOffer) -> Option<RecoveryAnswer> {
    let tokens = Tokens::of(ui);
    let words = Words::of(ui);
    let frame = Frame::new().fill(tokens.panel).inner_margin(Margin::symmetric(12, 6));
    let bar = Panel::top("recovery").frame(frame).show(ui, |ui| {
        let mut answer = None;
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            for (text, meant) in [
                (texts::JOURNAL_DISCARD, RecoveryAnswer::Discard),
                (texts::JOURNAL_LATER, RecoveryAnswer::Later),
                (texts::JOURNAL_RESTORE, RecoveryAnswer::Restore),
            ] {
                if was_pressed(&ui.add(Button::new(words.say(text)))) {
                    answer = Some(meant);
                }
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let commands = texts::journal_count(offer.commands);
                let said = texts::journal_offer(&offer.file, commands, when(offer.seconds));
                let label = Label::new(RichText::new(words.message(said)).color(tokens.text)).truncate();
                ui.add(label).on_hover_text(offer.path.display().to_string());
            });
        });
        answer
    });
    bar.inner
}

/// How long ago that is, in the largest unit of which one has passed.
fn when(seconds: u64) -> Message {
    let whole = |unit: u64| usize::try_from(seconds / unit).unwrap_or(usize::MAX);
    match seconds {
        0..60 => texts::JOURNAL_NOW.into(),
        60..3_600 => texts::journal_minutes(whole(60)),
        3_600..86_400 => texts::journal_hours(whole(3_600)),
        _ => texts::journal_days(whole(86_400)),
    }
}
