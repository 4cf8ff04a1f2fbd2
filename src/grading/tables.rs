//! The results as tables for programs: `grades.csv` and `grades.json`.

use serde_json::{Value, json};

use super::cells::{UTF8_MARK, number, row};
use super::finding::Finding;
use super::gather::PassedOver;
use super::hash::Hashed;
use super::item::{Evidence, Item, ItemKind};
use super::marks::Marks;
use super::rows::rows;
use super::rubric::Rubric;

/// The columns after those of items.
const LAST_COLUMNS: [&str; 8] =
    ["keyframe_file", "reasons", "notes", "section", "missing", "days_late", "late_points", "comment"];

/// A row for each submission, a column for each item; the keyframes have one column together, or with `is_wide` one each. It begins with
/// the mark of UTF-8, and no cell is a formula.
#[must_use]
pub fn csv(marks: &[Marks], is_wide: bool) -> String {
    let first = ["submission", "student", "id", "late", "points", "out_of", "evidence", "diagnosis"];
    let mut header: Vec<String> = first.map(str::to_owned).into();
    // Every submission has the same items.
    header.extend(marks.iter().take(1).flat_map(|marks| columns(&marks.items, is_wide)).map(|(name, _)| name));
    header.extend(LAST_COLUMNS.map(str::to_owned));
    let mut text = String::from(UTF8_MARK);
    text.push_str(&row(&header));
    for marks in marks {
        let late = if marks.is_late { "late" } else { "" };
        let mut cells = vec![
            marks.name.clone(),
            marks.student.clone().unwrap_or_default(),
            marks.id.clone().unwrap_or_default(),
            late.to_owned(),
            number(marks.points()),
            number(marks.out_of()),
            if marks.is_missing { String::new() } else { marks.evidence() },
            diagnoses(marks).join("; "),
        ];
        cells.extend(columns(&marks.items, is_wide).into_iter().map(|(_, points)| number(points)));
        cells.push(marks.keyframe_file.clone().unwrap_or_default());
        cells.push(lost_reasons(marks));
        cells.push(marks.notes.iter().map(|note| note.text.as_str()).collect::<Vec<_>>().join(" "));
        cells.push(marks.section().unwrap_or_default());
        cells.push(if marks.is_missing { "missing".to_owned() } else { String::new() });
        cells.push(marks.days_late.map(|days| days.to_string()).unwrap_or_default());
        cells.push(if marks.late_points > 0.0 { number(marks.late_points) } else { String::new() });
        cells.push(marks.comment.clone().unwrap_or_default());
        text.push_str(&row(&cells));
    }
    text
}

/// The columns of items with their points.
fn columns(items: &[Item], is_wide: bool) -> Vec<(String, f64)> {
    let mut columns: Vec<(String, f64)> = Vec::new();
    for item in items {
        let is_shared = !is_wide && matches!(item.kind, ItemKind::Keyframe(_));
        let name = if is_shared { "each_keyframe".to_owned() } else { item.kind.id() };
        match columns.last_mut() {
            Some((last, points)) if *last == name => *points += item.points,
            _ => columns.push((name, item.points)),
        }
    }
    columns
}

/// Why points were lost: sentences, each with its items.
pub fn lost_reasons(marks: &Marks) -> String {
    let rows = rows(&marks.items);
    let lost = rows.iter().filter(|row| row.has_lost);
    lost.map(|row| format!("{}: {}", row.ids(), row.reason)).collect::<Vec<_>>().join(" ")
}

/// What each file of samples shows: the name of what explains it, `not explained` or `unreadable`.
pub fn diagnoses(marks: &Marks) -> Vec<String> {
    let show = |diagnosis: &Result<Finding, String>| match diagnosis {
        Ok(diagnosis) if diagnosis.is_explained() => diagnosis.best().name.clone(),
        Ok(_) => "not explained".to_owned(),
        Err(_) => "unreadable".to_owned(),
    };
    marks.samples.iter().map(|samples| show(&samples.diagnosis)).collect()
}

/// The results as JSON; `assets/grading/grades.schema.json` says how.
#[must_use]
pub fn json(marks: &[Marks], passed_over: &[PassedOver], rubric: &Rubric) -> String {
    let hashed = |file: &Hashed| json!({"name": file.name, "sha256": file.sha256});
    let hashes = |files: &[Hashed]| files.iter().map(hashed).collect::<Vec<_>>();
    let submission = |marks: &Marks| {
        let items: Vec<Value> = marks
            .items
            .iter()
            .map(|item| {
                let evidence = item.evidence.map(Evidence::id);
                json!({"item": item.kind.id(), "points": item.points, "out_of": item.out_of, "evidence": evidence, "reason": item.reason, "by_hand": item.is_by_hand})
            })
            .collect();
        let samples: Vec<Value> = marks
            .samples
            .iter()
            .map(|samples| match &samples.diagnosis {
                Ok(diagnosis) => json!({
                    "file": samples.file, "playback": samples.interpolation.name(), "explained": diagnosis.is_explained(),
                    "best": diagnosis.best().name, "residual": diagnosis.best().residual,
                    "also": diagnosis.also().iter().map(|candidate| candidate.name.as_str()).collect::<Vec<_>>(), "problem": null,
                }),
                Err(problem) => json!({
                    "file": samples.file, "playback": samples.interpolation.name(), "explained": false,
                    "best": null, "residual": null, "also": [], "problem": problem,
                }),
            })
            .collect();
        json!({
            "name": marks.name, "student": marks.student, "id": marks.id, "late": marks.is_late, "points": marks.points(), "out_of": marks.out_of(), "keyframe_file": marks.keyframe_file,
            "items": items, "samples": samples, "notes": marks.notes.iter().map(|note| &note.text).collect::<Vec<_>>(), "files": hashes(&marks.files),
            "section": marks.section(), "missing": marks.is_missing, "days_late": marks.days_late, "late_points": marks.late_points,
            "comment": marks.comment,
        })
    };
    let passed = |passed: &PassedOver| json!({"name": passed.name, "reason": passed.reason});
    let value = json!({
        "format": "inbetween.grades", "version": 2, "title": rubric.title,
        "program": {"name": env!("CARGO_PKG_NAME"), "version": env!("CARGO_PKG_VERSION")},
        "rubric": hashes(&rubric.hashes().collect::<Vec<_>>()),
        "submissions": marks.iter().map(submission).collect::<Vec<_>>(),
        "not_revealed": rubric.revealed.not_revealed(),
        "passed_over": passed_over.iter().map(passed).collect::<Vec<_>>(),
    });
    let mut text = serde_json::to_string_pretty(&value).expect("values have keys that are text");
    text.push('\n');
    text
}
