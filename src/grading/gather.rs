//! Finding the submissions of a class: which entries are students', whose they are, and what is passed over.
//!
//! ```text
//! arguments ─► entries of a class ─┬─ rubbish ─► passed over
//!                                  └─ export (names of Canvas, Moodle, Gradescope) ─► submissions, merged by student ─► named apart
//! ```

mod export;
mod gradescope;
mod rubbish;
mod yaml;

use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

pub use self::export::System;
use self::export::{Student, student_of};
use self::gradescope::Metadata;
use super::archive::{Keep, Unread};
use super::names::{PreferredNames, composed, is_hidden, kind_not_read};
use super::place::{Entry, Place};
use super::submission::Submission;
use crate::files::FileError;
use crate::storage::{self, EntryKind};

/// The most submissions at a time.
const MOST_SUBMISSIONS: usize = 20_000;
/// The largest submission on standard input: 128 MiB.
const LARGEST_STANDARD_INPUT_BYTES: u64 = 128 << 20;
/// The largest file of a class's tar that is kept in memory: 16 MiB, and 128 MiB for an archive in it.
const LARGEST_KEPT_BYTES: (u64, u64) = (16 << 20, 128 << 20);
/// The most bytes of a class's tar that are kept in memory: 1 GiB.
const MOST_KEPT_BYTES: u64 = 1 << 30;
/// How many wrappings of a class, a folder that holds nothing but one folder, are entered.
const MOST_WRAPPINGS: usize = 4;

/// What the arguments of `grade` are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Naming {
    /// One folder or archive is a class; each of several arguments is a student's.
    Guessed,
    /// Each argument is a class.
    Classes,
    /// Each argument is one submission.
    One,
}

/// An entry of a class that is no submission.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
pub struct PassedOver {
    /// Its name.
    pub name: String,
    /// Why: a sentence's end.
    pub reason: String,
}

/// The submissions in the order of the arguments, entries of a folder by name, and what is none.
#[derive(Clone, Debug, Default)]
pub struct Found {
    /// The submissions; no two have the same name.
    pub submissions: Vec<Submission>,
    /// What was passed over.
    pub passed_over: Vec<PassedOver>,
}

impl Found {
    fn pass_over(&mut self, name: impl Into<String>, reason: impl Into<String>) {
        self.passed_over.push(PassedOver { name: name.into(), reason: reason.into() });
    }
}

/// Finds the submissions.
///
/// # Errors
/// [`FileError`]: something that is named is not there or cannot be opened, there are no submissions, or there are too many.
pub fn find(arguments: &[PathBuf], naming: Naming, preferred: &PreferredNames) -> Result<Found, FileError> {
    let mut found = Found::default();
    let mut named: Vec<&PathBuf> = Vec::new();
    let mut known = HashSet::new();
    for path in arguments {
        if storage::is_standard(path) {
            found.submissions.push(standard_input(path)?);
            continue;
        }
        storage::kind(path).map_err(|error| FileError::storage(path.display(), error))?;
        if known.insert(storage::resolved(path)) {
            named.push(path);
        }
    }
    match (naming, named.as_slice()) {
        (Naming::One, _) => {
            let one = |path: &&PathBuf| Row::of_its_own(argument(path, true));
            let rows = named.iter().map(one).collect();
            add(rows, &mut found);
        }
        (Naming::Classes, _) => {
            for path in &named {
                add_class(path, preferred, &mut found)?;
            }
        }
        (Naming::Guessed, []) => {}
        (Naming::Guessed, [path]) if student_of(&argument(path, true).name, None).is_none() => {
            add_class(path, preferred, &mut found)?;
        }
        (Naming::Guessed, [path]) => add_entries(vec![argument(path, true)], preferred, &mut found),
        (Naming::Guessed, _) => {
            let entries = named.iter().map(|path| argument(path, false)).collect();
            add_entries(entries, preferred, &mut found);
        }
    }
    if found.submissions.len() > MOST_SUBMISSIONS {
        return Err(FileError::new("submissions", format!("more than {MOST_SUBMISSIONS}")));
    }
    if found.submissions.is_empty() {
        let passed = found.passed_over.iter().map(|passed| format!("{} ({})", passed.name, passed.reason));
        let passed: Vec<String> = passed.collect();
        let passed = if passed.is_empty() {
            String::new()
        } else {
            format!("; passed over: {}", super::submission::shortly(&passed))
        };
        let named = named.iter().map(|path| path.display().to_string()).collect::<Vec<_>>().join(", ");
        return Err(FileError::new(named, format!("there are no submissions{passed}")));
    }
    name_apart(&mut found.submissions);
    Ok(found)
}

/// A submission that comes in by standard input: a file or an archive of one student.
fn standard_input(path: &Path) -> Result<Submission, FileError> {
    let name = storage::input_name(path);
    let bytes = storage::read(path, LARGEST_STANDARD_INPUT_BYTES).map_err(|error| FileError::storage(&name, error))?;
    Ok(Submission::in_memory(&name, bytes))
}

/// An argument as an entry. A link that stands alone is followed: the user means what it leads to.
fn argument(path: &Path, follows: bool) -> Entry {
    let kind = match storage::kind(path) {
        Ok(EntryKind::Link) if follows && storage::is_folder(path) => EntryKind::Folder,
        Ok(EntryKind::Link) if follows => EntryKind::File,
        Ok(kind) => kind,
        Err(_) => EntryKind::Other,
    };
    let name = storage::resolved(path).file_name().map(|name| name.to_string_lossy().into_owned());
    let name = name.unwrap_or_else(|| path.display().to_string());
    Entry { name, kind, place: Place::Disk(path.to_owned()) }
}

/// Adds the entries of a class: a folder or an archive. A file that is neither is one submission.
fn add_class(path: &Path, preferred: &PreferredNames, found: &mut Found) -> Result<(), FileError> {
    let entry = argument(path, true);
    let bad = |problem: String| FileError::new(path.display(), problem);
    let class = if entry.kind == EntryKind::Folder {
        entry.place.clone()
    } else {
        let largest = |name: &str| {
            let is_wanted = (kind_not_read(name).is_none() || preferred.fit(name)) && !name.split('/').any(is_hidden);
            let (file, archive) = LARGEST_KEPT_BYTES;
            let endings = ["zip", "gz", "tgz", "tar"];
            is_wanted.then(|| if endings.contains(&super::names::ending(name).as_str()) { archive } else { file })
        };
        let keep = Keep { largest: &largest, most: MOST_KEPT_BYTES, through: u64::MAX };
        match entry.place.archive(&entry.name, &keep) {
            Ok(Some(archive)) => Place::Packed(archive, String::new()),
            Ok(None) => {
                add(vec![Row::of_its_own(entry)], found);
                return Ok(());
            }
            Err(Unread::Large) => return Err(bad("it is too large".to_owned())),
            Err(Unread::Problem(problem)) => return Err(bad(problem)),
        }
    };
    let (entries, count) = entered(&class, &entry.name).map_err(bad)?;
    if count > entries.len() {
        return Err(bad(format!("more than {MOST_SUBMISSIONS} submissions")));
    }
    add_entries(entries, preferred, found);
    Ok(())
}

/// The entries of a class; of a folder that holds nothing but one folder of students, those of that one.
fn entered(class: &Place, name: &str) -> Result<(Vec<Entry>, usize), String> {
    let mut name = name.to_owned();
    let mut listed = class.list(MOST_SUBMISSIONS)?;
    for _ in 0..MOST_WRAPPINGS {
        let mut shown = listed.0.iter().filter(|entry| !is_hidden(&entry.name));
        let (Some(only), None) = (shown.next(), shown.next()) else { break };
        if only.kind != EntryKind::Folder || student_of(&only.name, None).is_some() {
            break;
        }
        let inner = only.place.list(MOST_SUBMISSIONS)?;
        if !is_class(&only.name, &name, &inner.0, &only.place) {
            break;
        }
        name.clone_from(&only.name);
        listed = inner;
    }
    Ok(listed)
}

/// Whether the only folder of a class, of which these are the entries, holds the students and is not the only student's own.
fn is_class(name: &str, outer: &str, entries: &[Entry], place: &Place) -> bool {
    let shown: Vec<&Entry> = entries.iter().filter(|entry| !is_hidden(&entry.name)).collect();
    let is_export = shown.iter().any(|entry| gradescope::is_metadata(entry) || student_of(&entry.name, None).is_some());
    let is_archive = |entry: &Entry| ["zip", "gz", "tgz", "tar"].contains(&super::names::ending(&entry.name).as_str());
    let are_students =
        shown.len() > 1 && shown.iter().all(|entry| entry.kind == EntryKind::Folder || is_archive(entry));
    // `class.zip` with a folder `class`.
    let is_wrapping = matches!(place, Place::Packed(..)) && outer.split('.').next() == Some(name);
    is_export || are_students || (is_wrapping && !shown.is_empty())
}

/// A submission to be, with what tells it apart.
struct Row {
    submission: Submission,
    /// Rows of one student in one folder are one.
    key: Option<(Vec<String>, System, String, String)>,
}

impl Row {
    /// A submission whose name says nothing of a course system.
    fn of_its_own(entry: Entry) -> Self {
        let student = own_name(&entry);
        let submission = Submission {
            name: entry.name.clone(),
            student,
            id: None,
            system: None,
            is_late: false,
            days_late: None,
            roots: vec![entry],
        };
        Self { submission, key: None }
    }

    fn of_student(entry: Entry, student: Student) -> Self {
        let name = entry.name.clone();
        let Student { system, name: student, id, is_late, days_late, file } = student;
        let key = (entry.place.folders(), system, composed(&student).into_owned(), id.clone());
        let entry = Entry { name: file.unwrap_or(entry.name), ..entry };
        let student = Some(composed(&student).into_owned());
        let submission =
            Submission { name, student, id: Some(id), system: Some(system), is_late, days_late, roots: vec![entry] };
        Self { submission, key: Some(key) }
    }
}

/// The student that an entry outside of an export is named after: of a folder its name, of an archive its name without the ending.
fn own_name(entry: &Entry) -> Option<String> {
    let name = composed(&entry.name).into_owned();
    if entry.kind == EntryKind::Folder {
        return Some(name);
    }
    let endings = [".tar.gz", ".tgz", ".tar", ".zip", ".gz", ".rar", ".7z"];
    let lower = name.to_lowercase();
    let ending = endings.iter().find(|ending| lower.ends_with(**ending) && lower.len() > ending.len())?;
    name.get(..name.len() - ending.len()).map(str::to_owned)
}

/// Adds rows, those of one student as one.
fn add(rows: Vec<Row>, found: &mut Found) {
    let mut known = BTreeMap::new();
    for Row { submission, key } in rows {
        let Some(key) = key else {
            found.submissions.push(submission);
            continue;
        };
        let next = found.submissions.len();
        let index = *known.entry(key).or_insert(next);
        if index == next {
            found.submissions.push(submission);
        } else {
            let first = &mut found.submissions[index];
            first.is_late |= submission.is_late;
            first.days_late = first.days_late.max(submission.days_late);
            first.roots.extend(submission.roots);
        }
    }
}

/// Adds the entries of one class or several folders as submissions.
fn add_entries(entries: Vec<Entry>, preferred: &PreferredNames, found: &mut Found) {
    let mut metadata: BTreeMap<Vec<String>, Metadata> = BTreeMap::new();
    for entry in entries.iter().filter(|entry| gradescope::is_metadata(entry)) {
        match Metadata::read(&entry.place) {
            Ok(read) => {
                metadata.insert(entry.place.folders(), read);
            }
            Err(problem) => found.pass_over(&entry.name, format!("it cannot be read: {problem}")),
        }
    }
    let has_results = entries.iter().any(rubbish::are_grades);
    let mut rows = Vec::new();
    for entry in entries {
        if gradescope::is_metadata(&entry) {
            if metadata.contains_key(&entry.place.folders()) {
                found.pass_over(&entry.name, "Gradescope's list of submissions");
            }
            continue;
        }
        if !preferred.fit(&entry.name)
            && let Some(reason) = rubbish::reason(&entry, has_results)
        {
            found.pass_over(&entry.name, reason);
            continue;
        }
        rows.push(match student_of(&entry.name, metadata.get(&entry.place.folders())) {
            Some(student) => Row::of_student(entry, student),
            None => Row::of_its_own(entry),
        });
    }
    add(rows, found);
}

/// Puts as many folders before equal names as it takes to tell them apart.
fn name_apart(submissions: &mut [Submission]) {
    let names: Vec<String> = submissions.iter().map(|submission| submission.name.clone()).collect();
    let mut count: BTreeMap<&str, usize> = BTreeMap::new();
    for name in &names {
        *count.entry(name).or_default() += 1;
    }
    let shared: HashSet<&str> = count.into_iter().filter(|(_, count)| *count > 1).map(|(name, _)| name).collect();
    let mut equal: Vec<usize> = (0..names.len()).filter(|&index| shared.contains(names[index].as_str())).collect();
    let folders: BTreeMap<usize, Vec<String>> =
        equal.iter().map(|&index| (index, submissions[index].roots[0].place.folders())).collect();
    for depth in 0.. {
        let mut is_at_an_end = true;
        for &index in &equal {
            if let Some(folder) = folders[&index].get(depth).filter(|folder| !folder.is_empty()) {
                submissions[index].name = format!("{folder}/{}", submissions[index].name);
                is_at_an_end = false;
            }
        }
        let mut taken: BTreeMap<String, usize> = BTreeMap::new();
        for submission in submissions.iter() {
            *taken.entry(submission.name.clone()).or_default() += 1;
        }
        equal.retain(|&index| taken[&submissions[index].name] > 1);
        if equal.is_empty() {
            return;
        }
        if is_at_an_end {
            break;
        }
    }
    // Names that the system cannot show may look alike.
    for (number, &index) in (1..).zip(&equal) {
        submissions[index].name = format!("{} #{number}", submissions[index].name);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn submission(path: &str) -> Submission {
        let entry = Entry {
            name: super::super::names::file_name(path).to_owned(),
            kind: EntryKind::File,
            place: Place::Disk(PathBuf::from(path)),
        };
        Row::of_its_own(entry).submission
    }

    #[test]
    fn equal_names_get_as_many_folders_as_it_takes() {
        let paths = ["/a/alice/one/k.txt", "/a/bob/one/k.txt", "/a/carol/two/k.txt", "/a/dave/other.txt"];
        let mut submissions: Vec<Submission> = paths.map(submission).into();
        name_apart(&mut submissions);
        let names: Vec<&str> = submissions.iter().map(|submission| submission.name.as_str()).collect();
        assert_eq!(names, ["alice/one/k.txt", "bob/one/k.txt", "two/k.txt", "other.txt"]);
        let mut alike = vec![submission("/a/k.txt"), submission("/a/k.txt")];
        name_apart(&mut alike);
        assert_eq!([&*alike[0].name, &*alike[1].name], ["a/k.txt #1", "a/k.txt #2"]);
    }
}
