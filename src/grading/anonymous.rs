//! Results without names: a number stands for each student in everything that is written.

use serde_json::{Map, Value, json};
use sha2::{Digest as _, Sha256};

use super::gather::PassedOver;
use super::marks::Marks;

/// The shortest part of a name that is looked for in texts, in bytes: one syllable of Hangul.
const SHORTEST_PART: usize = 3;

/// Words of names of folders and archives that results say anyway.
const ORDINARY: [&str; 28] = [
    "all",
    "and",
    "animation",
    "assignment",
    "catmull",
    "csv",
    "file",
    "files",
    "final",
    "frames",
    "homework",
    "json",
    "keyframe",
    "keyframes",
    "linear",
    "new",
    "project",
    "rom",
    "sample",
    "samples",
    "script",
    "spline",
    "submission",
    "the",
    "trace",
    "txt",
    "with",
    "zip",
];

/// Replaces names and numbers of students by numbers from 1, and sorts by these; entries that were passed over become numbers too. The
/// order of the numbers says nothing of the names: it is that of hashes. Texts lose the name of the submission, the student's names and
/// number; other names in them, as of a file inside a submission, stay.
///
/// The key is JSON: for each number the submission, student and id.
pub fn make_anonymous(all: &mut [Marks], passed_over: &mut [PassedOver]) -> String {
    all.sort_by_cached_key(|marks| Sha256::digest(&marks.name));
    let digits = all.len().to_string().len();
    let mut key = Map::new();
    for (index, marks) in all.iter_mut().enumerate() {
        let number = format!("{:0digits$}", index + 1);
        let who = json!({"submission": marks.name, "student": marks.student, "id": marks.id});
        key.insert(number.clone(), who);
        hide(marks, &number);
    }
    for (index, passed) in passed_over.iter_mut().enumerate() {
        passed.name = format!("entry {}", index + 1);
    }
    let mut text = serde_json::to_string_pretty(&Value::Object(key)).expect("keys are text");
    text.push('\n');
    text
}

/// What the submission is called where its name is hidden.
const NAMELESS: &str = "The submission";

/// Takes out of marks what tells whose they are, so that anybody may see them: names, the names of files, lateness, a teacher's comment,
/// and the notes, which are for who grades.
pub fn make_public(marks: &mut Marks) {
    marks.notes.clear();
    marks.comment = None;
    (marks.is_late, marks.days_late, marks.late_points) = (false, None, 0.0);
    hide(marks, NAMELESS);
    let known = marks.files.iter().map(|file| &file.name).chain(&marks.keyframe_file);
    let mut files: Vec<String> = known.chain(marks.samples.iter().map(|samples| &samples.file)).cloned().collect();
    files.sort();
    files.dedup();
    let mut parts = Vec::new();
    for (index, path) in files.iter().enumerate() {
        let name = format!("file {}", index + 1);
        let (_, last) = path.rsplit_once('/').unwrap_or(("", path));
        parts.extend([(path.clone(), name.clone()), (last.to_owned(), name)]);
    }
    // A file that is called `linear` tells nothing, and its name is a word of sentences.
    parts.retain(|(part, _)| part.len() >= SHORTEST_PART && !ORDINARY.contains(&&*part.to_lowercase()));
    parts.sort_by_key(|(part, _)| std::cmp::Reverse(part.len()));
    change_texts(marks, |text| parts.iter().for_each(|(part, name)| *text = replaced(text, part, name)));
}

fn hide(marks: &mut Marks, number: &str) {
    let stem = marks.name.split('.').next().unwrap_or_default();
    let mut parts = vec![marks.name.clone(), stem.to_owned()];
    if let Some(student) = &marks.student {
        parts.push(student.clone());
        parts.extend(words(student));
    }
    parts.extend(marks.id.clone());
    for person in &marks.people {
        parts.push(person.name.clone());
        parts.extend(words(&person.name));
        parts.extend(person.ids().map(str::to_owned));
    }
    parts.retain(|part| part.len() >= SHORTEST_PART);
    // A name before its parts.
    parts.sort_by_key(|part| std::cmp::Reverse(part.len()));
    parts.dedup();
    change_texts(marks, |text| parts.iter().for_each(|part| *text = replaced(text, part, number)));
    number.clone_into(&mut marks.name);
    (marks.student, marks.id) = (None, None);
    // The section alone tells who a student is in a small course.
    marks.people.clear();
}

/// Changes all texts of marks that may hold names.
fn change_texts(marks: &mut Marks, hide: impl Fn(&mut String)) {
    let hide = &hide;
    marks.keyframe_file.iter_mut().for_each(hide);
    marks.items.iter_mut().for_each(|item| hide(&mut item.reason));
    marks.notes.iter_mut().for_each(|note| hide(&mut note.text));
    for samples in &mut marks.samples {
        hide(&mut samples.file);
        if let Err(problem) = &mut samples.diagnosis {
            hide(problem);
        }
    }
    marks.unread.iter_mut().for_each(hide);
    marks.comment.iter_mut().for_each(hide);
    marks.files.iter_mut().for_each(|file| hide(&mut file.name));
    for picture in marks.pictures.iter_mut().flatten() {
        hide(&mut picture.caption);
        hide(&mut picture.alt);
    }
}

/// The words of a name, as far as they may be of a person.
fn words(name: &str) -> impl Iterator<Item = String> {
    let words = name.split(|c: char| !c.is_alphanumeric());
    words.filter(|word| !ORDINARY.contains(&&*word.to_lowercase())).map(str::to_owned)
}

/// A text in which a part is replaced where it stands as a word of its own, in capitals as in small letters.
fn replaced(text: &str, part: &str, by: &str) -> String {
    let mut hidden = String::with_capacity(text.len());
    let mut rest = text;
    let mut before: Option<char> = None;
    while let Some(c) = rest.chars().next() {
        let is_alone = |end: usize| {
            let is_inside = |c: Option<char>| c.is_some_and(char::is_alphanumeric);
            !is_inside(before) && !is_inside(rest[end..].chars().next())
        };
        if let Some(end) = beginning(rest, part).filter(|end| is_alone(*end)) {
            hidden.push_str(by);
            before = rest[..end].chars().next_back();
            rest = &rest[end..];
        } else {
            hidden.push(c);
            before = Some(c);
            rest = &rest[c.len_utf8()..];
        }
    }
    hidden
}

/// Where the part ends with which a text begins, if it does.
fn beginning(text: &str, part: &str) -> Option<usize> {
    let mut letters = text.chars();
    for wanted in part.chars() {
        let c = letters.next()?;
        if c != wanted && !c.to_lowercase().eq(wanted.to_lowercase()) {
            return None;
        }
    }
    Some(text.len() - letters.as_str().len())
}

#[cfg(test)]
mod tests {
    use super::replaced;

    #[test]
    fn words_are_replaced_and_no_parts_of_words() {
        for (text, expected) in [
            ("Ann/anim.json of ann_old", "7/anim.json of 7_old"),
            ("planning, Anne, ANN.", "planning, Anne, 7."),
            ("", ""),
            ("ann", "7"),
        ] {
            assert_eq!(replaced(text, "Ann", "7"), expected);
        }
        assert_eq!(replaced("김민수_과제.txt, 민수", "김민수", "12"), "12_과제.txt, 민수");
    }
}
