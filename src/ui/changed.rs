//! The bar above the view that says that another program has changed a file, and offers to read it again.

use std::path::PathBuf;

use egui::Ui;

use super::bar;
use crate::words::texts;

/// A file that another program has changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChangeOffer {
    /// The file's name.
    pub file: String,
    /// Its path.
    pub path: PathBuf,
    /// Whether reading it again replaces what is not saved.
    pub replaces_unsaved: bool,
}

/// What the user answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChangeAnswer {
    /// Read the file again.
    Reload,
    /// Say what differs.
    Compare,
    /// Go on without.
    Later,
}

/// Shows the bar; it stays until it is answered.
pub(super) fn show(ui: &mut Ui, offer: &ChangeOffer) -> Option<ChangeAnswer> {
    let said = if offer.replaces_unsaved {
        texts::changed_offer_unsaved(&offer.file)
    } else {
        texts::changed_offer(&offer.file)
    };
    let answers = [
        (texts::CHANGED_RELOAD, ChangeAnswer::Reload),
        (texts::CHANGED_COMPARE, ChangeAnswer::Compare),
        (texts::CHANGED_LATER, ChangeAnswer::Later),
    ];
    bar::show(ui, "changed", said, offer.path.display().to_string(), &answers)
}
