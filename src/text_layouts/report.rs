//! What was inferred of a text, and how sure that is.

use std::fmt;

use crate::words::Message;

/// How sure a finding is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Certainty {
    /// The text says it, or nothing else is possible.
    Sure,
    /// It fits, and something else could be meant.
    Likely,
    /// Nothing tells: look whether it is right.
    Warning,
    /// Worth knowing.
    Note,
}

impl Certainty {
    /// The word with which a finding begins.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Sure => "sure",
            Self::Likely => "likely",
            Self::Warning => "warning",
            Self::Note => "note",
        }
    }
}

/// One thing that was inferred.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// How sure it is.
    pub certainty: Certainty,
    /// What it is: the part of a sentence after the certainty.
    pub text: String,
}

/// A short report: what was read in one line, and a line for each thing that was inferred.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// What was read, as in `6 keyframes of 22 nodes, layout header, translation first`.
    pub summary: Message,
    /// What was inferred, in the order in which it was.
    pub findings: Vec<Finding>,
}

impl Report {
    pub(super) fn new(summary: Message) -> Self {
        Self { summary, findings: Vec::new() }
    }

    pub(super) fn add(&mut self, certainty: Certainty, text: impl Into<String>) {
        self.findings.push(Finding { certainty, text: text.into() });
    }

    /// Whether anything should be looked at.
    #[must_use]
    pub fn has_warnings(&self) -> bool {
        self.findings.iter().any(|finding| finding.certainty == Certainty::Warning)
    }
}

impl fmt::Display for Report {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}", self.summary)?;
        for Finding { certainty, text } in &self.findings {
            write!(formatter, "\n{}: {text}", certainty.word())?;
        }
        Ok(())
    }
}
