//! What `verify` found, for programs: JSON and JUnit.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use crate::flip::Scores;
use crate::json::{push_quoted, push_strings};
use crate::junit::{Case, Outcome, Suite};
use crate::references::{PAGE_NAME, Row, Verdict};

/// An object: the pictures, a line each, and what is said of all.
pub fn json(rows: &[Row<'_>], unused: &[PathBuf], actual: &Path) -> String {
    let mut text = String::from("{\"pictures\": [");
    for (index, row) in rows.iter().enumerate() {
        text.push_str(if index == 0 { "\n{\"name\": " } else { ",\n{\"name\": " });
        push_quoted(&mut text, &row.shot.name);
        let _ = write!(text, ", \"result\": \"{}\"", row.verdict.word());
        if let Some(Scores { score, mean, largest }) = row.verdict.scores() {
            let _ = write!(text, ", \"score\": {score:?}, \"mean\": {mean:?}, \"largest\": {largest:?}");
        }
        let _ = write!(text, ", \"tolerance\": {:?}", row.shot.tolerance);
        for (name, value) in [("reference", &row.shot.reference), ("actual", &row.shot.drawn_name())] {
            let _ = write!(text, ", \"{name}\": ");
            push_quoted(&mut text, value);
        }
        text.push_str(", \"message\": ");
        push_quoted(&mut text, &row.verdict.to_string());
        text.push('}');
    }
    let good = rows.iter().filter(|row| row.verdict.is_good()).count();
    let _ = write!(text, "\n], \"good\": {good}, \"bad\": {}, \"unused\": ", rows.len() - good);
    let unused: Vec<String> = unused.iter().map(|path| path.display().to_string()).collect();
    push_strings(&mut text, unused.iter().map(String::as_str));
    text.push_str(", \"page\": ");
    push_quoted(&mut text, &actual.join(PAGE_NAME).display().to_string());
    text.push_str("}\n");
    text
}

/// The pictures as a JUnit suite.
pub fn suite(rows: &[Row<'_>], folder: &Path, actual: &Path) -> Suite {
    let class_name = folder.display().to_string();
    let case = |row: &Row<'_>| {
        let (shot, verdict) = (row.shot, &row.verdict);
        let mut properties = Vec::new();
        if let Some(Scores { score, mean, largest }) = verdict.scores() {
            let numbers = [("score", score), ("mean", mean), ("largest", largest), ("tolerance", shot.tolerance)];
            properties.extend(numbers.map(|(name, number)| (name.to_owned(), number.to_string())));
        }
        let drawn = actual.join(shot.drawn_name()).display().to_string();
        let outcome = match verdict {
            Verdict::Undrawn(reason) => Outcome::Errored(reason.clone()),
            verdict if verdict.is_good() => Outcome::Passed,
            verdict => Outcome::Failed(format!("{verdict}\n{drawn}")),
        };
        let file = Some(folder.join(&shot.reference).display().to_string());
        Case { name: shot.name.clone(), class_name: class_name.clone(), file, outcome, properties }
    };
    Suite { name: "inbetween verify".to_owned(), cases: rows.iter().map(case).collect() }
}
