//! `results.json` as Gradescope reads it from an autograder.

use serde_json::{Value, json};

use super::folders::folder_names;
use super::{Format, Given, ResultFile, json_text, rounded};
use crate::grading::item::{Item, ItemKind};
use crate::grading::marks::Marks;
use crate::grading::rubric::Rubric;

pub const FORMAT: Format = Format {
    name: "gradescope",
    about: "gradescope/NAME/results.json for a Gradescope autograder",
    variables: &[],
    problem: |_| None,
    files,
};

fn files(marks: &[Marks], _: &Rubric, _: &Given) -> Vec<ResultFile> {
    let names = folder_names(marks);
    let file = |(marks, name): (&Marks, String)| ResultFile {
        path: format!("gradescope/{name}/results.json"),
        text: json_text(&results(marks)),
    };
    marks.iter().zip(names).map(file).collect()
}

/// Every submission has the same tests, so that Gradescope's table of the class has a column each.
fn results(marks: &Marks) -> Value {
    let numbers = numbers(&marks.items);
    let test = |(item, number): (&Item, String)| {
        json!({
            "score": rounded(item.points), "max_score": rounded(item.out_of),
            "status": if item.has_lost() { "failed" } else { "passed" },
            "name": item.kind.title(), "number": number,
            "output": item.reason, "output_format": "text", "visibility": "visible",
        })
    };
    let notes: Vec<&str> = marks.notes.iter().map(|note| note.text.as_str()).collect();
    json!({
        "score": rounded(marks.points()), "output": notes.join("\n"), "output_format": "text", "visibility": "visible",
        "tests": marks.items.iter().zip(numbers).map(test).collect::<Vec<_>>(),
    })
}

/// `1`, `2`, and for keyframes `3.1`, `3.2`.
fn numbers(items: &[Item]) -> Vec<String> {
    let mut number = 0;
    let mut is_among_keyframes = false;
    let mut next = |item: &Item| {
        let keyframe = if let ItemKind::Keyframe(index) = item.kind { Some(index) } else { None };
        number += usize::from(!(is_among_keyframes && keyframe.is_some()));
        is_among_keyframes = keyframe.is_some();
        keyframe.map_or_else(|| number.to_string(), |index| format!("{number}.{}", index + 1))
    };
    items.iter().map(&mut next).collect()
}
