//! The results as tables for programs: `grades.csv` and `grades.json`.

use serde_json::{Value, json};

use super::gather::PassedOver;
use super::item::Evidence;
use super::marks::Marks;
use super::rows::rows;
use super::rubric::Rubric;

/// A row for each submission, a column for each item. Safe to open in a spreadsheet: no cell is a formula.
///
/// Not written by the `csv` crate, which would leave blanks, semicolons and apostrophes unquoted: in some locales spreadsheets split
/// cells at semicolons.
#[must_use]
pub fn csv(marks: &[Marks]) -> String {
    let first = ["submission", "student", "id", "late", "points", "out_of", "evidence", "diagnosis"];
    let mut header: Vec<String> = first.map(str::to_owned).into();
    // Every submission has the same items.
    header.extend(marks.iter().take(1).flat_map(|marks| &marks.items).map(|item| item.kind.id()));
    header.extend(["keyframe_file", "reasons", "notes"].map(str::to_owned));
    let mut text = row(&header);
    for marks in marks {
        let late = if marks.is_late { "late" } else { "" };
        let mut cells = vec![
            marks.name.clone(),
            marks.student.clone().unwrap_or_default(),
            marks.id.clone().unwrap_or_default(),
            late.to_owned(),
            number(marks.points()),
            number(marks.out_of()),
            marks.evidence(),
            diagnoses(marks).join("; "),
        ];
        cells.extend(marks.items.iter().map(|item| number(item.points)));
        let rows = rows(&marks.items);
        let lost = rows.iter().filter(|row| row.has_lost);
        let reasons: Vec<String> = lost.map(|row| format!("{}: {}", row.ids(), row.reason)).collect();
        cells.push(marks.keyframe_file.clone().unwrap_or_default());
        cells.push(reasons.join(" "));
        cells.push(marks.notes.iter().map(|note| note.text.as_str()).collect::<Vec<_>>().join(" "));
        text.push_str(&row(&cells));
    }
    text
}

/// What each file of samples shows: the name of what explains it, `not explained` or `unreadable`.
pub fn diagnoses(marks: &Marks) -> Vec<String> {
    let show = |diagnosis: &Result<crate::diagnosis::Diagnosis, String>| match diagnosis {
        Ok(diagnosis) if diagnosis.is_explained() => diagnosis.best().name.clone(),
        Ok(_) => "not explained".to_owned(),
        Err(_) => "unreadable".to_owned(),
    };
    marks.samples.iter().map(|samples| show(&samples.diagnosis)).collect()
}

/// A number with at most four decimals, without trailing zeros.
pub fn number(number: f64) -> String {
    let text = format!("{number:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn row(cells: &[String]) -> String {
    let mut line = cells.iter().map(|text| cell(text)).collect::<Vec<_>>().join(",");
    line.push_str("\r\n");
    line
}

/// A cell that no spreadsheet takes for a formula: a text that begins like one gets an apostrophe before it. Line ends and other control
/// characters become blanks.
fn cell(text: &str) -> String {
    let begins_formula = text.trim_start().starts_with(['=', '+', '-', '@']) || text.starts_with(['\t', '\r', '\n']);
    let plain: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    let plain = if begins_formula { format!("'{plain}") } else { plain };
    if plain.contains([',', '"', ';', ' ', '\'']) { format!("\"{}\"", plain.replace('"', "\"\"")) } else { plain }
}

/// The results as JSON; `assets/grading/grades.schema.json` says how.
#[must_use]
pub fn json(marks: &[Marks], passed_over: &[PassedOver], rubric: &Rubric) -> String {
    let submission = |marks: &Marks| {
        let items: Vec<Value> = marks
            .items
            .iter()
            .map(|item| {
                let evidence = item.evidence.map(Evidence::id);
                json!({"item": item.kind.id(), "points": item.points, "out_of": item.out_of, "evidence": evidence, "reason": item.reason})
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
            "items": items, "samples": samples, "notes": marks.notes.iter().map(|note| &note.text).collect::<Vec<_>>(),
        })
    };
    let passed = |passed: &PassedOver| json!({"name": passed.name, "reason": passed.reason});
    let value = json!({
        "format": "inbetween.grades", "version": 1, "title": rubric.title,
        "submissions": marks.iter().map(submission).collect::<Vec<_>>(),
        "not_revealed": rubric.revealed.not_revealed(),
        "passed_over": passed_over.iter().map(passed).collect::<Vec<_>>(),
    });
    let mut text = serde_json::to_string_pretty(&value).expect("values have keys that are text");
    text.push('\n');
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_cell_is_a_formula() {
        for (text, expected) in [
            ("=1+1", "'=1+1"),
            ("@x", "'@x"),
            ("+1", "'+1"),
            ("-1", "'-1"),
            ("\t=1", "' =1"),
            ("\r=1", "' =1"),
            ("  =1", "'  =1"),
        ] {
            assert_eq!(cell(text), format!("\"{expected}\""), "{text:?}");
        }
        assert_eq!(cell("a\nb,\"c\""), "\"a b,\"\"c\"\"\"");
        assert_eq!(cell("plain"), "plain");
    }

    #[test]
    fn numbers_have_no_needless_zeros() {
        assert_eq!([0.0, 0.5, 10.0, 1.0 / 3.0].map(number), ["0", "0.5", "10", "0.3333"]);
    }
}
