//! A table that Moodle imports: as an assignment's offline grading worksheet, or into the gradebook.

use super::{Format, Given, ResultFile};
use crate::grading::cells::{UTF8_MARK, number, row};
use crate::grading::marks::Marks;
use crate::grading::person::Person;
use crate::grading::rubric::Rubric;
use crate::grading::tables::lost_reasons;
use crate::markup::escaped;

pub const FORMAT: Format = Format {
    name: "moodle",
    about: "moodle.csv, grades with feedback, for Moodle's offline grading worksheet or the import of its gradebook",
    variables: &[],
    problem: |_| None,
    files,
};

/// The names of the worksheet's columns, in English.
const COLUMNS: [&str; 8] = [
    "Identifier",
    "Full name",
    "ID number",
    "Email address",
    "Grade",
    "Maximum Grade",
    "Last modified (grade)",
    "Feedback comments",
];

/// A row for each student, with grade and feedback: Moodle loses grades if they are imported apart.
fn files(marks: &[Marks], _: &Rubric, _: &Given) -> Vec<ResultFile> {
    let mut text = String::from(UTF8_MARK);
    text.push_str(&row(&COLUMNS));
    let rows = marks.iter().flat_map(|marks| Person::all_of(marks).into_iter().map(move |who| (marks, who)));
    for (marks, who) in rows {
        let identifier =
            if who.participant.is_empty() { String::new() } else { format!("Participant {}", who.participant) };
        let (points, out_of) = (number(marks.points()), number(marks.out_of()));
        // Feedback is HTML in Moodle.
        let feedback = escaped(&feedback(marks));
        // What Moodle writes where there is no grade yet.
        let modified = "-".to_owned();
        text.push_str(&row(&[identifier, who.name, who.id_number, who.email, points, out_of, modified, feedback]));
    }
    vec![ResultFile { path: "moodle.csv".to_owned(), text }]
}

/// The points, the teacher's comment, what lateness costs, and the reasons for points that were lost: sentences.
fn feedback(marks: &Marks) -> String {
    let mut parts = vec![format!("{} of {} points.", number(marks.points()), number(marks.out_of()))];
    parts.extend(marks.comment.clone());
    if marks.late_points > 0.0 {
        parts.push(format!("Lateness costs {} points.", number(marks.late_points)));
    }
    parts.push(lost_reasons(marks));
    parts.retain(|part| !part.is_empty());
    parts.join(" ")
}
