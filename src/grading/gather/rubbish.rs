//! Entries of a class that are no student's.

use super::super::names::{ending, is_hidden};
use super::super::place::Entry;
use super::super::report::GENERATOR;
use crate::storage::EntryKind;

/// How many bytes of a file tell what it is.
const START_BYTES: u64 = 4096;

/// What `grade` writes into a folder, with all forms of results.
const RESULTS: [&str; 6] = ["grades.csv", "grades.json", "report.html", "canvas.csv", "moodle.csv", "junit.xml"];

/// Folders of results that `grade` writes beside them.
const FOLDERS_OF_RESULTS: [&str; 2] = ["gradescope", "classroom50"];

/// Files of what `grade` keeps: results for the next run, a shard.
const KEPT: [&str; 2] = ["grades.cache", "shard.json"];

/// Why an entry is no submission, if it is none; `has_results` tells that results of `grade` stand beside it.
pub fn reason(entry: &Entry, has_results: bool) -> Option<String> {
    if is_hidden(&entry.name) {
        return Some("a hidden or system file".to_owned());
    }
    match entry.kind {
        EntryKind::Link => return Some("a link, which is not followed".to_owned()),
        EntryKind::Other => return Some("neither a file nor a folder".to_owned()),
        EntryKind::Folder if has_results_of_grade(entry) => return Some("results of grade".to_owned()),
        EntryKind::Folder if has_results && FOLDERS_OF_RESULTS.contains(&entry.name.as_str()) => {
            return Some("results of grade".to_owned());
        }
        EntryKind::Folder => return None,
        EntryKind::File => {}
    }
    if has_results && RESULTS.contains(&entry.name.as_str()) {
        return Some("results of grade".to_owned());
    }
    match ending(&entry.name).as_str() {
        "xlsx" | "xls" | "xlsm" | "ods" | "numbers" => Some("a spreadsheet".to_owned()),
        "csv" | "tsv" if is_list_of_students(entry) => Some("a list of students or grades".to_owned()),
        "json" | "toml" if start(entry).contains("inbetween.rubric") => Some("a rubric".to_owned()),
        "toml" if start(entry).contains("inbetween.overrides") => Some("a teacher's overrides".to_owned()),
        _ => None,
    }
}

/// Whether an entry is the table `grades.json` that `grade` writes.
pub fn are_grades(entry: &Entry) -> bool {
    entry.kind == EntryKind::File && entry.name == "grades.json" && start(entry).contains("\"inbetween.grades\"")
}

fn has_results_of_grade(entry: &Entry) -> bool {
    let Ok((entries, _)) = entry.place.list(1000) else { return false };
    entries.iter().any(|entry| entry.name == "report.html") && entries.iter().any(are_grades)
        || entries.iter().any(|entry| KEPT.contains(&entry.name.as_str()))
        || is_feedback(&entries)
}

/// Whether a folder holds pages to hand back, and nothing else.
fn is_feedback(entries: &[Entry]) -> bool {
    let has_ending = |entry: &&Entry, wanted: &str| ending(&entry.name) == wanted;
    let mut shown = entries.iter().filter(|entry| !is_hidden(&entry.name));
    let mut pages = entries.iter().filter(|entry| has_ending(entry, "html"));
    shown.all(|entry| has_ending(&entry, "html") || has_ending(&entry, "md"))
        && pages.next().is_some_and(|page| start(page).contains(GENERATOR))
}

/// The first line of a table of students: a header with names, and none of a table of keyframes or samples.
fn is_list_of_students(entry: &Entry) -> bool {
    let start = start(entry).to_lowercase();
    let header = start.lines().find(|line| !line.trim().is_empty()).unwrap_or_default();
    let names = ["student", "name", "email", "grade", "submission", "section", "score", "points"];
    let is_of_keyframes = ["frame_num", "rbt_ind", "key_time"].iter().any(|name| header.contains(name));
    !is_of_keyframes && names.iter().any(|name| header.contains(name))
}

fn start(entry: &Entry) -> String {
    let bytes = entry.place.start(START_BYTES).unwrap_or_default();
    String::from_utf8_lossy(&bytes).into_owned()
}
