//! The bar above the view that offers what was not saved when a program ended. It takes no keyboard focus of its own.

use std::path::PathBuf;

use egui::Ui;

use super::bar;
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
    let commands = texts::journal_count(offer.commands);
    let said = texts::journal_offer(&offer.file, commands, when(offer.seconds));
    let answers = [
        (texts::JOURNAL_RESTORE, RecoveryAnswer::Restore),
        (texts::JOURNAL_LATER, RecoveryAnswer::Later),
        (texts::JOURNAL_DISCARD, RecoveryAnswer::Discard),
    ];
    bar::show(ui, "recovery", said, offer.path.display().to_string(), &answers)
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
