//! Feedback: a page for each student to hand back, with nothing of others, as HTML and as Markdown.

use std::collections::HashSet;
use std::fmt::Write as _;
use std::{iter, slice};

use super::super::cells::number;
use super::super::item::Evidence;
use super::super::marks::Marks;
use super::super::rows::rows;
use super::super::rubric::Rubric;
use super::sheet::Sheet;
use super::{MistakeFilm, Points, ShownMistake, mistakes, mistakes_shown, page, student, title};
use crate::diagnosis::{Fact, Mistake};
use crate::markup::markdown_escaped;

/// The longest file name, without ending, in bytes.
const LONGEST_NAME: usize = 120;

/// The feedback of one submission.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Feedback {
    /// The name of its files, without ending: the student's number in the course system, or else the submission's name made safe. No two
    /// are the same, also where capitals do not count.
    pub name: String,
    /// The page, with pictures. It needs no other file.
    pub html: String,
    /// The same as text, without pictures.
    pub markdown: String,
}

/// The feedback of all submissions, in their order.
#[must_use]
pub fn feedback(all: &[Marks], rubric: &Rubric, films: &[Option<MistakeFilm>]) -> Vec<Feedback> {
    let found = mistakes_shown(all);
    let mut names = HashSet::new();
    let of = |(index, marks): (usize, &Marks)| {
        let name = apart(&safe(marks.id.as_deref().unwrap_or(&marks.name)), &mut names);
        let own: Vec<(usize, &ShownMistake)> =
            found.iter().enumerate().filter(|(_, shown)| shown.shown_by.contains(&index)).collect();
        // A film of another student's keyframes is none of this student's business.
        let film = |number: usize, shown: &ShownMistake| {
            let film = films.get(number).and_then(Option::as_ref);
            film.filter(|film| film.is_of_reference || shown.shown_by.first() == Some(&index))
        };
        let with_films = own.iter().map(|(number, shown)| (shown.mistake, film(*number, shown)));
        let html = html(marks, Points::Shown, with_films, rubric);
        let own: Vec<&ShownMistake> = own.into_iter().map(|(_, shown)| shown).collect();
        Feedback { name, html, markdown: markdown(marks, &own, title(rubric)) }
    };
    all.iter().enumerate().map(of).collect()
}

/// The page of a submission that anybody may see: what was looked at and why, and pictures. `films` are those of the mistakes that it
/// shows, in the order of [`mistakes_shown`]. [`super::super::make_public`] takes the names out of the marks before.
#[must_use]
pub fn public_page(marks: &Marks, points: Points, rubric: &Rubric, films: &[Option<MistakeFilm>]) -> String {
    let found = mistakes_shown(slice::from_ref(marks));
    let films = films.iter().map(Option::as_ref).chain(iter::repeat(None));
    html(marks, points, found.iter().map(|shown| shown.mistake).zip(films), rubric)
}

/// The page of one submission, with the mistakes that it shows and their films.
fn html<'a>(
    marks: &'a Marks,
    points: Points,
    mistakes: impl Iterator<Item = (&'a Mistake, Option<&'a MistakeFilm>)>,
    rubric: &Rubric,
) -> String {
    let mut sheet = Sheet::default();
    let content = student::content(marks, points, &mut sheet);
    let mut body = format!("<section>{content}</section>\n");
    for (mistake, film) in mistakes {
        body.push_str(&mistakes::opening(mistake, None, film.map(|film| &film.picture), &mut sheet));
        body.push_str("</dl></section>\n");
    }
    page(title(rubric), &body, &sheet, None)
}

fn markdown(marks: &Marks, shown: &[&ShownMistake], title: &str) -> String {
    let mut text = format!(
        "# {}\n\n## {}: {} of {}\n\n",
        markdown_escaped(title),
        markdown_escaped(&marks.name),
        number(marks.points()),
        number(marks.out_of())
    );
    if let Some(student) = student::student(marks) {
        let _ = writeln!(text, "{}\n", markdown_escaped(&student));
    }
    text.push_str("| item | points | rests on | reason |\n|---|---:|---|---|\n");
    for row in rows(&marks.items) {
        let _ = writeln!(
            text,
            "| {} | {} of {} | {} | {} |",
            markdown_escaped(&row.title()),
            number(row.points),
            number(row.out_of),
            row.evidence.map_or("", Evidence::id),
            markdown_escaped(row.reason)
        );
    }
    let notes: Vec<String> =
        student::notes(marks).map(|note| format!("* {}\n", markdown_escaped(&note.text))).collect();
    if !notes.is_empty() {
        let _ = write!(text, "\n{}", notes.concat());
    }
    for ShownMistake { mistake, .. } in shown {
        let _ = write!(text, "\n### {}\n\n{}\n\n", mistake.name, markdown_escaped(mistake.what));
        for Fact { title, text: fact, is_code } in mistake.facts() {
            let fact = if is_code { format!("`{fact}`") } else { markdown_escaped(fact) };
            let _ = writeln!(text, "* {title}: {fact}");
        }
    }
    text
}

/// A name of a file on every system: letters, digits and few signs.
fn safe(name: &str) -> String {
    let plain = name.chars().map(|c| if c.is_alphanumeric() || ".-_ ".contains(c) { c } else { '_' });
    let mut plain: String = plain.collect();
    plain.truncate(plain.floor_char_boundary(LONGEST_NAME));
    let plain = plain.trim_matches(['.', ' ']);
    // Windows keeps these names, with any ending, for devices.
    let stem = plain.split('.').next().unwrap_or_default().trim_end().to_ascii_uppercase();
    let is_numbered = |device: &str| {
        stem.strip_prefix(device).is_some_and(|number| number.len() == 1 && number.bytes().all(|b| b.is_ascii_digit()))
    };
    let is_device = ["CON", "PRN", "AUX", "NUL"].contains(&stem.as_str()) || is_numbered("COM") || is_numbered("LPT");
    if plain.is_empty() || is_device { format!("_{plain}") } else { plain.to_owned() }
}

/// The name, or with a number where it is taken.
fn apart(name: &str, taken: &mut HashSet<String>) -> String {
    let numbered = (2..).map(|number: usize| format!("{name}-{number}"));
    let mut names = std::iter::once(name.to_owned()).chain(numbered);
    names.find(|name| taken.insert(name.to_lowercase())).expect("numbers do not end")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files_are_safe_and_apart() {
        for (name, expected) in [
            ("ada", "ada"),
            ("../a:b", "_a_b"),
            ("김 민수.zip", "김 민수.zip"),
            ("con.json", "_con.json"),
            ("com1", "_com1"),
            ("common", "common"),
            ("..", "_"),
            ("", "_"),
        ] {
            assert_eq!(safe(name), expected, "{name:?}");
        }
        assert!(safe(&"가".repeat(100)).len() <= LONGEST_NAME);
        let mut taken = HashSet::new();
        let names = ["a", "A", "a-2", "b"].map(|name| apart(name, &mut taken));
        assert_eq!(names, ["a", "A-2", "a-2-2", "b"]);
    }
}
