//! `submission_metadata.yml`, in which Gradescope says whose each folder `submission_100` is.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::super::archive::Unread;
use super::super::late;
use super::super::place::{Entry, Place};
use super::export::{Student, System};
use super::yaml::{self, Yaml};
use crate::storage::EntryKind;

/// The largest such file: 64 MiB. It holds all results of automatic tests.
const LARGEST_BYTES: u64 = 64 << 20;

/// Whether an entry is that file, by its name.
pub fn is_metadata(entry: &Entry) -> bool {
    entry.kind == EntryKind::File
        && matches!(entry.name.as_str(), "submission_metadata.yml" | "submission_metadata.yaml")
}

/// Who made each submission.
#[derive(Clone, Debug, Default)]
pub struct Metadata(BTreeMap<String, Student>);

/// The value of a key, which Ruby writes with a colon before it. Of repeated keys the last counts.
fn field<'y>(yaml: &'y Yaml, key: &str) -> Option<&'y Yaml> {
    let is_key = |found: &Yaml| text(found).is_some_and(|found| found.strip_prefix(':').unwrap_or(found) == key);
    yaml.mapping()?.iter().rev().find(|(found, _)| is_key(found)).map(|(_, value)| &**value)
}

/// A value as it is written: numbers with their zeros.
fn text(yaml: &Yaml) -> Option<&str> {
    match yaml {
        Yaml::Scalar(text) => Some(text),
        Yaml::Sequence(_) | Yaml::Mapping(_) => None,
    }
}

impl Metadata {
    /// Reads the file.
    ///
    /// # Errors
    /// Why it cannot be read: a sentence.
    pub fn read(place: &Place) -> Result<Self, String> {
        let bytes = place.read(LARGEST_BYTES).map_err(|unread| match unread {
            Unread::Large => format!("it is larger than {} MiB", LARGEST_BYTES >> 20),
            Unread::Problem(problem) => problem,
        })?;
        Self::parse(&String::from_utf8_lossy(&bytes))
    }

    fn parse(source: &str) -> Result<Self, String> {
        let document = yaml::first_document(source)?;
        let submissions = document.as_deref().and_then(Yaml::mapping);
        let submissions = submissions.ok_or_else(|| "it holds no submissions".to_owned())?;
        let student = |(name, yaml): &(Arc<Yaml>, Arc<Yaml>)| Some((text(name)?.to_owned(), Self::student_in(yaml)?));
        Ok(Self(submissions.iter().filter_map(student).collect()))
    }

    fn student_in(yaml: &Yaml) -> Option<Student> {
        let submitters = field(yaml, "submitters")?.sequence()?;
        let all = |key: &str| {
            let found = submitters.iter().filter_map(|submitter| text(field(submitter, key)?));
            found.filter(|text| !["", "~", "null"].contains(text)).collect::<Vec<_>>().join(", ")
        };
        let (name, id) = (all("name"), all("sid"));
        let late = field(yaml, "late").or_else(|| field(yaml, "lateness")).and_then(text).unwrap_or_default();
        let is_late = !["", "false", "~", "null", "0", "0.0", "00:00:00"].contains(&late);
        let id = if id.is_empty() { all("email") } else { id };
        Some(Student { system: System::Gradescope, name, id, is_late, days_late: late::days_of(late), file: None })
    }

    /// Who made the submission in the folder, file or archive of a name.
    pub fn student(&self, name: &str) -> Option<Student> {
        let stem = name.strip_suffix(".zip").unwrap_or(name);
        let known = self.0.get(name).or_else(|| self.0.get(stem));
        known.cloned().filter(|student| !student.name.is_empty() || !student.id.is_empty())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EXPORTED: &str = "---
submission_101:
  :submitters:
  - :name: 'Kim, \"Minji\"'
    :sid: '00420'
    :email: minji@school.edu
  :created_at: 2026-10-01 12:00:00.000000000 Z
  :score: 1.0
  :status: processed
  :results: {\"a\": 1, \"a\": 2}
submission_102:
  :submitters:
  - :name: Zoë Ng
    :sid: 00421
  - :name: Ada
    :sid:
  :history: []
submission_103:
  :submitters: []
";

    #[test]
    fn who_made_what() {
        let metadata = Metadata::parse(EXPORTED).expect("it is right");
        let of = |name: &str| metadata.student(name).map(|student| (student.name, student.id));
        assert_eq!(of("submission_101"), Some(("Kim, \"Minji\"".to_owned(), "00420".to_owned())));
        assert_eq!(of("submission_102"), Some(("Zoë Ng, Ada".to_owned(), "00421".to_owned())));
        assert_eq!(of("submission_102.zip").map(|(name, _)| name), Some("Zoë Ng, Ada".to_owned()));
        assert_eq!((of("submission_103"), of("submission_9")), (None, None));
        let shared = "submission_1: &1\n  :submitters:\n  - :name: Ann\nsubmission_2: *1\n";
        let shared = Metadata::parse(shared).expect("it is right");
        assert_eq!(shared.student("submission_2").map(|student| student.name), Some("Ann".to_owned()));
        for broken in ["", "- a\n", "a: [", "\t"] {
            assert!(Metadata::parse(broken).is_err(), "{broken:?}");
        }
    }
}
