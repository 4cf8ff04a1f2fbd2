//! The inferences about a text, and their certainty.

use std::fmt;

use serde_json::{Value, json};

use crate::words::Message;

/// The certainty of a finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Certainty {
    /// The text says it, or nothing else is possible.
    Sure,
    /// It fits, but another reading is possible.
    Likely,
    /// It is a guess that a person should check.
    Warning,
    /// A note.
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

/// One inference.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// Its certainty.
    pub certainty: Certainty,
    /// The part of the sentence after the certainty.
    pub text: String,
}

/// A short report: a summary line, and a line for each inference.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// The summary, such as `6 keyframes of 22 nodes, layout header, translation first`.
    pub summary: Message,
    /// The inferences in the order in which they were made.
    pub findings: Vec<Finding>,
}

impl Report {
    pub(super) fn new(summary: Message) -> Self {
        Self { summary, findings: Vec::new() }
    }

    pub(super) fn add(&mut self, certainty: Certainty, text: impl Into<String>) {
        self.findings.push(Finding { certainty, text: text.into() });
    }

    /// Whether no other reading of the text is possible.
    #[must_use]
    pub fn is_sure(&self) -> bool {
        let is_sure = |finding: &Finding| matches!(finding.certainty, Certainty::Sure | Certainty::Note);
        self.findings.iter().all(is_sure)
    }

    /// The report for programs: an object with the summary and a list of findings.
    #[must_use]
    pub fn json(&self) -> Value {
        let finding = |Finding { certainty, text }: &Finding| json!({"certainty": certainty.word(), "text": text});
        let findings: Vec<Value> = self.findings.iter().map(finding).collect();
        json!({"summary": self.summary.to_string(), "findings": findings})
    }

    /// The findings that a person should check, one sentence each.
    pub fn warnings(&self) -> impl Iterator<Item = &str> {
        let is_warning = |finding: &&Finding| finding.certainty == Certainty::Warning;
        self.findings.iter().filter(is_warning).map(|finding| finding.text.as_str())
    }

    /// Whether a person should check any finding.
    #[must_use]
    pub fn has_warnings(&self) -> bool {
        self.warnings().next().is_some()
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
