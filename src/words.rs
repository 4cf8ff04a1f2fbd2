//! What the program says, apart from how: messages as data, and the languages that say them.
//!
//! `assets/words/en.txt` has every message with its id; the build script makes [`texts`] of it, a constant for each message without
//! arguments and a function for each that has some. Another language is one more file there. Whoever says something gives a [`Message`]
//! or a [`Phrase`]; only what shows it puts it into words. This room knows nothing of what the messages are about.

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
