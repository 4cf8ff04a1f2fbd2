//! `result.json` as Classroom 50 reads it from an autograder: `classroom50/result/v1`.

use serde_json::{Value, json};

use super::folders::folder_names;
use super::{Format, Given, ResultFile, json_text};
use crate::grading::item::Item;
use crate::grading::marks::Marks;
use crate::grading::rubric::Rubric;
use crate::words::{Message, texts};

/// Variables that have to be set, with their fields.
const REQUIRED: [(&str, &str); 5] = [
    ("CLASSROOM", "classroom"),
    ("ASSIGNMENT", "assignment"),
    ("SUBMISSION_TAG", "submission"),
    ("COMMIT_URL", "commit"),
    ("RELEASE_URL", "release"),
];

pub const FORMAT: Format = Format {
    name: "classroom50",
    about: "classroom50/NAME/result.json for Classroom 50, in whole points, with the fields that its runner sets as variables",
    variables: &[
        "CLASSROOM",
        "ASSIGNMENT",
        "SUBMISSION_TAG",
        "COMMIT_URL",
        "RELEASE_URL",
        "REVIEW_URL",
        "OWNER",
        "USERNAME",
        "ASSIGNMENT_TYPE",
        "MODE",
        "GITHUB_ACTOR",
        "GITHUB_ACTOR_ID",
    ],
    problem,
    files,
};

fn problem(given: &Given) -> Option<Message> {
    let missing = REQUIRED.iter().map(|(variable, _)| *variable).find(|variable| given.variable(variable).is_none());
    let missing = missing.or_else(|| owner(given).is_none().then_some("OWNER"));
    if let Some(variable) = missing {
        return Some(texts::grade_no_variable(variable));
    }
    let tag = given.variable("SUBMISSION_TAG").unwrap_or_default();
    date(tag).is_none().then(|| texts::grade_bad_tag(tag))
}

fn owner(given: &Given) -> Option<&str> {
    given.variable("OWNER").or_else(|| given.variable("USERNAME"))
}

/// The moment of a submission from its tag: of `submit/2026-06-01T14-32-05Z-a1b2c3d`, `2026-06-01T14:32:05Z`.
fn date(tag: &str) -> Option<String> {
    let stamp = tag.strip_prefix("submit/")?.get(..20)?;
    let has_form = stamp.bytes().zip("0000-00-00T00-00-00Z".bytes()).all(|(found, form)| match form {
        b'0' => found.is_ascii_digit(),
        sign => found == sign,
    });
    let number = |at: usize| stamp.get(at..at + 2).and_then(|digits| digits.parse::<u32>().ok());
    let is_time = has_form && number(11)? < 24 && number(14)? < 60 && number(17)? < 60;
    is_time.then(|| format!("{}T{}", &stamp[..10], stamp[11..].replace('-', ":")))
}

fn files(marks: &[Marks], _: &Rubric, given: &Given) -> Vec<ResultFile> {
    let names = folder_names(marks);
    let file = |(marks, name): (&Marks, String)| ResultFile {
        path: format!("classroom50/{name}/result.json"),
        text: json_text(&result(marks, given)),
    };
    marks.iter().zip(names).map(file).collect()
}

fn result(marks: &Marks, given: &Given) -> Value {
    let test = |item: &Item| {
        json!({
            "test-name": item.kind.title(), "passed": !item.has_lost(),
            "score": whole(item.points), "max-score": whole(item.out_of), "message": item.reason,
        })
    };
    let text = |variable: &str| given.variable(variable).unwrap_or_default();
    let is_group = given.variable("ASSIGNMENT_TYPE").or_else(|| given.variable("MODE")) == Some("group");
    let mut result = json!({
        "schema": "classroom50/result/v1",
        "assignment_type": if is_group { "group" } else { "individual" },
        "owner": owner(given).unwrap_or_default(),
        "review": given.variable("REVIEW_URL").unwrap_or(text("COMMIT_URL")),
        "datetime": date(text("SUBMISSION_TAG")).unwrap_or_default(),
        "score": whole(marks.points()), "max-score": whole(marks.out_of()),
        "tests": marks.items.iter().map(test).collect::<Vec<_>>(),
    });
    for (variable, field) in REQUIRED {
        result[field] = text(variable).into();
    }
    if let Some(actor) = given.variable("GITHUB_ACTOR") {
        let id = given.variable("GITHUB_ACTOR_ID").and_then(|id| id.parse::<u64>().ok());
        result["submitted_by"] = json!({"username": actor, "id": id});
    }
    result
}

/// Classroom 50 knows whole points only.
fn whole(points: f64) -> u64 {
    points.round() as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tag_says_when() {
        for (tag, expected) in [
            ("submit/2026-06-01T14-32-05Z-a1b2c3d", Some("2026-06-01T14:32:05Z")),
            ("submit/2026-06-01T14-32-05Z", Some("2026-06-01T14:32:05Z")),
            ("submit/2026-06-01T24-32-05Z-a", None),
            ("submit/2026-06-01T14:32:05Z-a", None),
            ("submit/2026", None),
            ("2026-06-01T14-32-05Z-a", None),
            ("submit/", None),
            ("submit/가가가가가가가", None),
        ] {
            assert_eq!(date(tag).as_deref(), expected, "{tag}");
        }
    }
}
