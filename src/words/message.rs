//! A message as data: its id and its arguments.

use std::fmt;
use std::path;

use super::catalogue::Catalogue;
use super::texts::IDS;

/// The severity of a message.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Severity {
    /// Something was done.
    #[default]
    Information,
    /// Something outside was done that one waits for: a file was read or written.
    Outcome,
    /// Something was refused or failed.
    Error,
}

/// A message that has no arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Phrase(pub(super) u16);

impl Phrase {
    /// The phrase with this id, such as `command.keyframe-new`; `None` where there is none or its text has arguments.
    #[must_use]
    pub fn of_id(id: &str) -> Option<Self> {
        let index = IDS.binary_search(&id).ok()?;
        let phrase = Self(u16::try_from(index).ok()?);
        Catalogue::english().words_of(phrase.0).map(|_| phrase)
    }

    /// Its text in English.
    #[must_use]
    pub fn english(self) -> &'static str {
        Catalogue::english().phrase(self)
    }
}

/// What stands in a message's text in place of a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Argument {
    /// Text that is the same in every language: a path, a key, a measured number.
    Text(String),
    /// How many there are of something.
    Count(u64),
    /// Another message, which is said in the language of the whole.
    Message(Message),
}

/// A message: an id of `assets/words/en.txt`, and its arguments.
///
/// [`super::texts`] has a constant or a function for each id, so that no message lacks an argument. It is displayed in English.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Message {
    pub(super) index: u16,
    pub(super) arguments: Vec<(&'static str, Argument)>,
    severity: Severity,
}

impl Message {
    /// A message by the index of its id in [`IDS`]. Only what the build script makes calls this.
    pub(super) fn new(index: u16, arguments: Vec<(&'static str, Argument)>) -> Self {
        Self { index, arguments, severity: Severity::Information }
    }

    /// The same with another severity.
    #[must_use]
    pub fn with_severity(self, severity: Severity) -> Self {
        Self { severity, ..self }
    }

    /// Its severity.
    #[must_use]
    pub const fn severity(&self) -> Severity {
        self.severity
    }

    /// Its id, such as `keyframe.created`.
    #[must_use]
    pub fn id(&self) -> &'static str {
        IDS[usize::from(self.index)]
    }

    /// One of its arguments.
    #[must_use]
    pub fn argument(&self, name: &str) -> Option<&Argument> {
        self.arguments.iter().find(|(own, _)| *own == name).map(|(_, argument)| argument)
    }
}

impl From<Phrase> for Message {
    fn from(phrase: Phrase) -> Self {
        Self::new(phrase.0, Vec::new())
    }
}

impl fmt::Display for Message {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&Catalogue::english().say(self))
    }
}

impl fmt::Display for Phrase {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.english())
    }
}

impl From<Message> for Argument {
    fn from(message: Message) -> Self {
        Self::Message(message)
    }
}

impl From<Phrase> for Argument {
    fn from(phrase: Phrase) -> Self {
        Self::Message(phrase.into())
    }
}

impl From<usize> for Argument {
    fn from(count: usize) -> Self {
        Self::Count(count as u64)
    }
}

/// Text as it is displayed.
macro_rules! displayed {
    ($($kind:ty),+) => { $(
        impl From<$kind> for Argument {
            fn from(value: $kind) -> Self {
                Self::Text(value.to_string())
            }
        }
    )+ };
}
displayed!(&str, &String, path::Display<'_>, u8, u16, u32, u64, i32, i64);

/// Numbers of this size and more are displayed with an exponent: nobody counts hundreds of zeros.
const WITH_EXPONENT: f64 = 1e16;

impl From<f64> for Argument {
    fn from(number: f64) -> Self {
        let is_long = number.is_finite() && number.abs() >= WITH_EXPONENT;
        Self::Text(if is_long { format!("{number:e}") } else { number.to_string() })
    }
}

impl From<f32> for Argument {
    fn from(number: f32) -> Self {
        let is_long = number.is_finite() && f64::from(number.abs()) >= WITH_EXPONENT;
        Self::Text(if is_long { format!("{number:e}") } else { number.to_string() })
    }
}

impl From<String> for Argument {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

/// Text in double quotes, with what would end or break it escaped.
#[must_use]
pub fn quoted(text: &str) -> String {
    format!("{text:?}")
}

/// Displays errors as their messages in English, so that each English sentence stands in `assets/words/en.txt` alone.
macro_rules! display_by_message {
    ($($error:ty),+ $(,)?) => { $(
        impl std::fmt::Display for $error {
            fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                std::fmt::Display::fmt(&self.message(), formatter)
            }
        }
    )+ };
}
pub(crate) use display_by_message;
