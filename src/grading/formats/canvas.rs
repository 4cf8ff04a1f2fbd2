//! A table that Canvas's gradebook imports.

use super::{Format, Given, ResultFile};
use crate::grading::cells::{UTF8_MARK, number, row};
use crate::grading::marks::Marks;
use crate::grading::person::Person;
use crate::grading::rubric::Rubric;
use crate::words::texts;

pub const FORMAT: Format = Format {
    name: "canvas",
    about: "canvas.csv for the import of Canvas's gradebook",
    variables: &[],
    problem: |given| given.assignment.is_none().then(|| texts::GRADE_NO_ASSIGNMENT.into()),
    files,
};

/// A row for each student. Canvas takes one by the id, the SIS id or the name.
fn files(marks: &[Marks], _: &Rubric, given: &Given) -> Vec<ResultFile> {
    let mut text = String::from(UTF8_MARK);
    let assignment = given.assignment.as_deref().unwrap_or_default();
    text.push_str(&row(&["Student", "ID", "SIS User ID", "SIS Login ID", "Section", assignment]));
    // Canvas's own exports have this row, and its import reads it.
    let out_of = number(marks.first().map_or(0.0, Marks::out_of));
    text.push_str(&row(&["Points Possible", "", "", "", "", &out_of]));
    let rows = marks.iter().flat_map(|marks| Person::all_of(marks).into_iter().map(move |who| (marks, who)));
    for (marks, who) in rows {
        let points = number(marks.points());
        text.push_str(&row(&[who.name, who.canvas_id, who.sis_user_id, who.sis_login_id, who.section, points]));
    }
    vec![ResultFile { path: "canvas.csv".to_owned(), text }]
}
