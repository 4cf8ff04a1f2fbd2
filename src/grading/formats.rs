//! Results in the forms that course systems and services read: one row of [`FORMATS`] each.

mod canvas;
mod classroom50;
mod folders;
mod gradescope;
mod junit;
mod moodle;

use std::collections::BTreeMap;

use super::marks::Marks;
use super::rubric::Rubric;
use crate::words::Message;

/// A form of results.
pub struct Format {
    /// How `grade --to` names it.
    pub name: &'static str,
    /// What is written and who reads it.
    pub about: &'static str,
    /// The variables of the environment that it holds, where they are set.
    pub variables: &'static [&'static str],
    /// What is missing of what it needs beside the marks.
    pub problem: fn(&Given) -> Option<Message>,
    /// The files.
    pub files: fn(&[Marks], &Rubric, &Given) -> Vec<ResultFile>,
}

impl std::fmt::Debug for Format {
    fn fmt(&self, formatter: &mut std::fmt::Formatter) -> std::fmt::Result {
        formatter.write_str(self.name)
    }
}

/// All forms.
pub const FORMATS: [&Format; 5] =
    [&canvas::FORMAT, &moodle::FORMAT, &gradescope::FORMAT, &classroom50::FORMAT, &junit::FORMAT];

/// The form of a name.
#[must_use]
pub fn format_named(name: &str) -> Option<&'static Format> {
    FORMATS.into_iter().find(|format| format.name == name)
}

/// What forms need beside the marks.
#[derive(Clone, Debug, Default)]
pub struct Given {
    /// How the course system calls the assignment.
    pub assignment: Option<String>,
    /// The variables of the environment that the forms name, and that are set and not empty.
    pub environment: BTreeMap<&'static str, String>,
}

impl Given {
    fn variable(&self, name: &str) -> Option<&str> {
        self.environment.get(name).map(String::as_str)
    }
}

/// A file of results.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ResultFile {
    /// Its path in the folder of results, with `/`.
    pub path: String,
    /// What it holds.
    pub text: String,
}

/// Points with at most four decimals: sums of shares have rounding errors that nobody wants to read.
fn rounded(points: f64) -> f64 {
    (points * 1e4).round() / 1e4
}

/// A JSON value as a file.
fn json_text(value: &serde_json::Value) -> String {
    format!("{value:#}\n")
}
