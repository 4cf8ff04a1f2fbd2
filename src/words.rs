//! Messages as data, and the languages they are displayed in.
//!
//! `assets/words/en.txt` has every message with its id; the build script makes [`texts`] of it, a constant for each message without
//! arguments and a function for each that has some. Another language is one more file there. Code that reports something returns a
//! [`Message`] or a [`Phrase`]; the code that displays it chooses the language.

mod catalogue;
mod file;
mod language;
mod list;
mod message;
#[cfg(test)]
mod tests;

pub use catalogue::Catalogue;
pub use language::Language;
pub use list::{all_of, one_of};
pub(crate) use message::display_by_message;
pub use message::{Argument, Message, Phrase, Severity, quoted};

/// Every message: made of `assets/words/en.txt`.
pub mod texts {
    use super::{Argument, Message, Phrase};

    include!(concat!(env!("OUT_DIR"), "/texts.rs"));
}
