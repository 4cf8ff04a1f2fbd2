//! `report.html`: one page that needs no other file.

mod alike;
mod class;
mod feedback;
mod mistakes;
mod sheet;
mod student;
mod table;

use std::fmt::Write as _;

pub use feedback::{Feedback, feedback, public_page};
pub use mistakes::{ShownMistake, shown as mistakes_shown};
pub use student::Points;

use self::sheet::Sheet;
use super::film::MistakeFilm;
use super::gather::PassedOver;
use super::marks::Marks;
use super::rubric::Rubric;
use crate::markup::{escaped, policy_hash};

/// What tells pages of `grade` from those of students. It stands near the beginning.
pub const GENERATOR: &str = "<meta name=\"generator\" content=\"inbetween grade\">";

const STYLE: &str = include_str!("../../assets/grading/report.css");
const SCRIPT: &str = include_str!("../../assets/grading/report.js");

/// The report: the class with its numbers and a row for each submission; each submission with its points, reasons and pictures; then the
/// known mistakes that they show. `films` are those of the mistakes in the order of [`mistakes_shown`]; none where none are wanted.
#[must_use]
pub fn html(marks: &[Marks], passed_over: &[PassedOver], rubric: &Rubric, films: &[Option<MistakeFilm>]) -> String {
    let found = mistakes_shown(marks);
    let mut sheet = Sheet::default();
    let mut text = class::summary(marks, rubric);
    if let Some(warning) = rubric.revealed.warning() {
        let _ = writeln!(text, "<p class=\"note\">{}</p>", escaped(&warning));
    }
    text.push_str(&table::of_class(marks));
    text.push_str(&class::hints(marks, &found, passed_over, rubric));
    for index in 0..marks.len() {
        text.push_str(&student::section(marks, index, &mut sheet));
    }
    if !found.is_empty() {
        text.push_str(&mistakes::sections(marks, &found, films, &mut sheet));
    }
    page(title(rubric), &text, &sheet, Some(SCRIPT))
}

/// The title of pages.
fn title(rubric: &Rubric) -> &str {
    if rubric.title.is_empty() { "Grades" } else { &rubric.title }
}

/// A page that loads nothing and runs no script but its own. The pictures come last, so that the text is shown before they are read.
fn page(title: &str, body: &str, sheet: &Sheet<'_>, script: Option<&str>) -> String {
    let policy = script.map_or_else(String::new, |script| format!("; script-src {}", policy_hash(script)));
    let script = script.map_or_else(String::new, |script| format!("<script>{script}</script>\n"));
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'{policy}\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n{GENERATOR}\n<meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style></head><body>\n\
         <h1 id=\"top\">{title}</h1>\n{body}{script}{}</body></html>\n",
        sheet.style(),
        title = escaped(title)
    )
}
