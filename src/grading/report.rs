//! `report.html`: one self-contained page.

mod html;
mod mistakes;
mod student;

use std::fmt::Write as _;

pub use mistakes::{ShownMistake, shown as mistakes_shown};

use super::cells::number;
use super::gather::PassedOver;
use super::marks::Marks;
use super::rubric::Rubric;
use super::studio::ReportPicture;
use super::tables::diagnoses;
use crate::markup::escaped;

const STYLE: &str = include_str!("../../assets/grading/report.css");

/// The pictures of a report; none where none are wanted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReportPictures {
    /// Of each submission.
    pub of_submissions: Vec<Vec<ReportPicture>>,
    /// The film of each known mistake, in the order of [`mistakes_shown`].
    pub of_mistakes: Vec<Option<ReportPicture>>,
}

/// The report: an overview with a row for each submission; each submission with its points, reasons and pictures; then the known mistakes
/// that they show.
#[must_use]
pub fn html(marks: &[Marks], passed_over: &[PassedOver], rubric: &Rubric, pictures: &ReportPictures) -> String {
    let title = if rubric.title.is_empty() { "Grades" } else { &rubric.title };
    let mut text = format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<title>{0}</title>\n<style>\n{STYLE}</style></head><body>\n\
         <h1 id=\"top\">{0}</h1>\n",
        escaped(title)
    );
    if let Some(warning) = rubric.revealed.warning() {
        let _ = writeln!(text, "<p class=\"note\">{}</p>", escaped(&warning));
    }
    let found = mistakes_shown(marks);
    text.push_str(&overview(marks, &found, passed_over));
    for index in 0..marks.len() {
        let pictures = pictures.of_submissions.get(index).map_or(&[][..], Vec::as_slice);
        text.push_str(&student::section(marks, index, pictures));
    }
    if !found.is_empty() {
        text.push_str(&mistakes::sections(marks, &found, &pictures.of_mistakes));
    }
    text.push_str("</body></html>\n");
    text
}

/// A row for each submission.
fn overview(all: &[Marks], found: &[ShownMistake], passed_over: &[PassedOver]) -> String {
    let mean = all.iter().map(Marks::points).sum::<f64>() / (all.len().max(1)) as f64;
    let out_of = all.first().map_or(0.0, Marks::out_of);
    let has_students = all.iter().any(|marks| student::student(marks).is_some());
    let mut text = format!(
        "<p class=\"sum\">{} submissions, {} points on average out of {}.</p>\n",
        all.len(),
        number((mean * 100.0).round() / 100.0),
        number(out_of)
    );
    if !found.is_empty() {
        text.push_str(&mistakes::list(found));
    }
    let _ = writeln!(
        text,
        "<section><table class=\"overview\">\
         <thead><tr><th>submission</th>{}<th>points</th><th class=\"share\"></th><th>evidence</th><th>samples show</th></tr></thead>",
        if has_students { "<th>student</th>" } else { "" }
    );
    for (index, marks) in all.iter().enumerate() {
        let of_student = escaped(&student::student(marks).unwrap_or_default());
        let of_student = if has_students { format!("<td>{of_student}</td>") } else { String::new() };
        let mut shown = diagnoses(marks);
        shown.dedup();
        let share = if marks.out_of() > 0.0 { 100.0 * marks.points() / marks.out_of() } else { 0.0 };
        let _ = writeln!(
            text,
            "<tr><td><a href=\"#s{index}\">{}</a></td>{of_student}<td class=\"n\">{} / {}</td>\
             <td class=\"share\"><span class=\"bar\"><i style=\"width:{share:.0}%\"></i></span></td><td>{}</td><td>{}</td></tr>",
            escaped(&marks.name),
            number(marks.points()),
            number(marks.out_of()),
            escaped(&marks.evidence()),
            escaped(&shown.join(", "))
        );
    }
    text.push_str("</table>\n");
    if !passed_over.is_empty() {
        let passed = passed_over.iter().map(|passed| format!("{} ({})", passed.name, passed.reason));
        let passed = passed.collect::<Vec<_>>().join(", ");
        let _ = writeln!(text, "<p class=\"sum\">Passed over: {}.</p>", escaped(&passed));
    }
    text.push_str("</section>\n");
    text
}
