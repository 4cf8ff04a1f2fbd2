//! A teacher's own points, comments and late days: a file that is read and never written, so that it holds over all runs.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;

use super::item::ItemKind;
use super::marks::Marks;
use super::names::{composed, id_key};
use super::note::Note;
use super::person::Person;
use super::rubric::Rubric;
use crate::decode;
use crate::files::FileError;
use crate::words::{Message, texts};

/// The name of the file that is read where none is named: it stands beside the rubric.
pub const USUAL_NAME: &str = "overrides.toml";

/// The largest file in bytes: 16 MiB.
pub const LARGEST_BYTES: u64 = 16 << 20;

/// What all keyframes get together, as in the table.
const ALL_KEYFRAMES: &str = "each_keyframe";

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct OverridesText {
    format: String,
    version: u64,
    #[serde(default)]
    students: BTreeMap<String, Override>,
}

/// What the teacher says of one student.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct Override {
    points: BTreeMap<String, f64>,
    comment: Option<String>,
    late_days: Option<u32>,
}

/// What a teacher says of students, by their numbers or the names of their rows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overrides {
    /// The file's bytes.
    pub source: Vec<u8>,
    students: BTreeMap<String, Override>,
}

impl Overrides {
    /// Reads the bytes of a file of overrides, which `path` names in errors.
    ///
    /// # Errors
    /// [`FileError`]: they are no overrides, or name an item without points, more points than there are, or days where the rubric
    /// charges none.
    pub fn read(path: &Path, bytes: &[u8], rubric: &Rubric) -> Result<Self, FileError> {
        let text: OverridesText = decode::toml(bytes).map_err(|error| FileError::new(path.display(), error))?;
        let problem = text.problem(rubric);
        problem.map_or(Ok(Self { source: bytes.to_vec(), students: text.students }), |problem| {
            Err(FileError::new(path.display(), problem))
        })
    }

    /// Changes the marks of the students that are named. The result names those whom nobody matches.
    pub fn apply(&self, marks: &mut [Marks]) -> Vec<String> {
        let mut unmatched = Vec::new();
        for (student, own) in &self.students {
            let mut is_matched = false;
            for marks in marks.iter_mut().filter(|marks| is_of(student, marks)) {
                own.apply(marks);
                is_matched = true;
            }
            if !is_matched {
                unmatched.push(student.clone());
            }
        }
        unmatched
    }
}

/// Whether a number or a row's name is that of marks.
fn is_of(student: &str, marks: &Marks) -> bool {
    let ids = marks.people.iter().flat_map(Person::ids).chain(marks.id.as_deref());
    composed(student) == composed(&marks.name) || ids.into_iter().any(|id| id_key(id) == id_key(student))
}

impl OverridesText {
    fn problem(&self, rubric: &Rubric) -> Option<Message> {
        if self.format != "inbetween.overrides" || self.version != 1 {
            return Some(texts::grade_overrides_form(&self.format, self.version));
        }
        let most = |name: &str| -> Option<f64> {
            let items = rubric.items().filter(|(kind, _)| is_named(*kind, name));
            items.map(|(_, out_of)| out_of).reduce(|sum, out_of| sum + out_of)
        };
        for (student, own) in &self.students {
            for (item, points) in &own.points {
                match most(item) {
                    None => return Some(texts::grade_overrides_item(student, item)),
                    Some(most) if !(0.0..=most).contains(points) => {
                        return Some(texts::grade_overrides_points(student, item, *points, most));
                    }
                    Some(_) => {}
                }
            }
            if own.late_days.is_some() && rubric.late.is_none() {
                return Some(texts::grade_overrides_late(student));
            }
        }
        None
    }
}

fn is_named(kind: ItemKind, name: &str) -> bool {
    kind.id() == name || (name == ALL_KEYFRAMES && matches!(kind, ItemKind::Keyframe(_)))
}

impl Override {
    fn apply(&self, marks: &mut Marks) {
        // All keyframes come before single ones, which say more.
        let all = self.points.iter().filter(|(name, _)| *name == ALL_KEYFRAMES);
        let single = self.points.iter().filter(|(name, _)| *name != ALL_KEYFRAMES);
        for (name, points) in all.chain(single) {
            let items = || marks.items.iter().filter(|item| is_named(item.kind, name));
            let out_of: f64 = items().map(|item| item.out_of).sum();
            for item in marks.items.iter_mut().filter(|item| is_named(item.kind, name)) {
                item.points = points * item.out_of / out_of;
                if !item.is_by_hand {
                    item.reason = format!("Given by hand. {}", item.reason);
                }
                item.is_by_hand = true;
            }
        }
        if let Some(comment) = &self.comment {
            marks.notes.insert(0, Note::quiet(comment));
            marks.comment = Some(comment.clone());
        }
        if let Some(days) = self.late_days {
            marks.is_late = days > 0;
            marks.days_late = Some(days);
        }
    }
}
