//! What the report says of one submission.

use std::fmt::Write as _;

use super::super::cells::number;
use super::super::item::Evidence;
use super::super::marks::Marks;
use super::super::note::Note;
use super::super::rows::rows;
use super::mistakes;
use super::sheet::Sheet;
use crate::markup::escaped;

/// What the course system says of the student, where it says more than the submission's name.
pub fn student(marks: &Marks) -> Option<String> {
    let id = marks.id.as_ref().map(|id| format!("id {id}"));
    let late = marks.is_late.then(|| "late".to_owned());
    if id.is_none() && late.is_none() {
        return None;
    }
    let parts: Vec<String> = [marks.student.clone(), id, late].into_iter().flatten().collect();
    Some(parts.join(", "))
}

/// Whether points are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Points {
    /// Points, and where some are missing.
    Shown,
    /// Only what was looked at, and why.
    Hidden,
}

/// The section of the submission of an index among all: points with reasons, notes, pictures, and links to its neighbours.
pub fn section<'a>(all: &'a [Marks], index: usize, sheet: &mut Sheet<'a>) -> String {
    let open = format!("<section class=\"student\" id=\"s{index}\">");
    format!("{open}{}{}</section>\n", content(&all[index], Points::Shown, sheet), neighbours(all, index))
}

/// What is said of one submission, and nothing of others.
pub fn content<'a>(marks: &'a Marks, points: Points, sheet: &mut Sheet<'a>) -> String {
    let of_all = match points {
        Points::Shown => format!("<span>{} / {}</span> ", number(marks.points()), number(marks.out_of())),
        Points::Hidden => String::new(),
    };
    let mut text = format!("<h2>{of_all}{}</h2>\n", escaped(&marks.name));
    if let Some(student) = student(marks) {
        let _ = writeln!(text, "<p class=\"sum\">{}</p>", escaped(&student));
    }
    for note in notes(marks) {
        let class = if note.wants_a_look { "note" } else { "quiet" };
        let _ = writeln!(text, "<p class=\"{class}\">{}</p>", escaped(&note.text));
    }
    text.push_str("<table class=\"items\">\n");
    for row in rows(&marks.items) {
        let class = if row.has_lost { "lost" } else { "full" };
        let points = match points {
            Points::Shown => {
                format!("<td class=\"n {class}\">{} / {}</td>", number(row.points), number(row.out_of))
            }
            Points::Hidden => String::new(),
        };
        let _ = writeln!(
            text,
            "<tr><td>{}</td>{points}<td class=\"by\">{}</td><td>{}</td></tr>",
            escaped(&row.title()),
            row.evidence.map_or("", Evidence::id),
            escaped(row.reason)
        );
    }
    text.push_str("</table>\n");
    for samples in &marks.samples {
        let also: Vec<&str> = mistakes::also(samples).map(|candidate| candidate.name.as_str()).collect();
        if !also.is_empty() {
            let file = escaped(&samples.file);
            let _ = writeln!(text, "<p class=\"quiet\">{file} agrees as well with: {}.</p>", also.join(", "));
        }
    }
    let mut links: Vec<String> = Vec::new();
    for mistake in marks.samples.iter().flat_map(mistakes::named) {
        let link = mistakes::link(mistake);
        if !links.contains(&link) {
            links.push(link);
        }
    }
    if !links.is_empty() {
        let _ = writeln!(text, "<p class=\"quiet\">What it is and how to mend it: {}.</p>", links.join(", "));
    }
    let pictures = marks.pictures.as_deref().unwrap_or_default();
    if !pictures.is_empty() {
        text.push_str("<div class=\"pictures\">\n");
        for picture in pictures {
            if picture.starts_row {
                text.push_str("</div><div class=\"pictures\">\n");
            }
            text.push_str(&sheet.figure(picture));
        }
        text.push_str("</div>\n");
    }
    text
}

/// The notes, but those that repeat an item's reason.
pub fn notes(marks: &Marks) -> impl Iterator<Item = &Note> {
    marks.notes.iter().filter(|note| marks.items.iter().all(|item| item.reason != note.text))
}

/// Links to the submissions before and after one, and to the overview.
fn neighbours(all: &[Marks], index: usize) -> String {
    let link = |sign: [&str; 2], index: usize| {
        let name = all.get(index).map(|marks| escaped(&marks.name))?;
        Some(format!("<a href=\"#s{index}\">{}{name}{}</a>", sign[0], sign[1]))
    };
    let before = index.checked_sub(1).and_then(|before| link(["← ", ""], before));
    let after = link(["", " →"], index + 1);
    let top = "<a href=\"#top\">↑ overview</a>".to_owned();
    let links: Vec<String> = [before, Some(top), after].into_iter().flatten().collect();
    format!("<nav>{}</nav>\n", links.join(" "))
}
