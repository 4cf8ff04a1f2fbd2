//! The list of students: whose each submission is, and who handed nothing in.

mod table;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::marks::Marks;
use super::names::{composed, id_key};
use super::person::Person;
use super::rubric::Rubric;
use crate::files::{self, FileError};
use crate::words::texts;

/// The largest list in bytes: 16 MiB.
const LARGEST_BYTES: u64 = 16 << 20;

/// The students of a course, in the order of the list.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Roster {
    people: Vec<Person>,
}

/// What does not go together.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Matched {
    /// The names of submissions whose student is not on the list, or not for sure.
    pub unknown: Vec<String>,
    /// Students with more than one submission, and the names of these.
    pub repeated: Vec<(String, Vec<String>)>,
}

/// Students by what tells them apart; `None` for what several have.
type Index = BTreeMap<String, Option<usize>>;

fn index(entries: impl Iterator<Item = (String, usize)>) -> Index {
    let mut index = Index::new();
    for (key, person) in entries.filter(|(key, _)| !key.is_empty()) {
        index.entry(key).and_modify(|known| *known = known.filter(|known| *known == person)).or_insert(Some(person));
    }
    index
}

/// A name as it is compared: composed, in small letters, without signs, its parts in order. `Kim, Ann` is `ann kim`.
fn name_key(name: &str) -> String {
    let name = composed(name).to_lowercase();
    let mut parts: Vec<&str> = name.split(|c: char| !c.is_alphanumeric()).filter(|part| !part.is_empty()).collect();
    parts.sort_unstable();
    parts.join(" ")
}

impl Roster {
    /// Reads a list of students: Canvas's gradebook, Moodle's participants or worksheet, Gradescope's roster, or `name,id,section`.
    ///
    /// # Errors
    /// [`FileError`]: it cannot be read, or it is no list of students.
    pub fn load(path: &Path) -> Result<Self, FileError> {
        let bytes = files::read(path, LARGEST_BYTES)?;
        Self::parse(&bytes).map_err(|problem| FileError::new(path.display(), problem))
    }

    fn parse(bytes: &[u8]) -> Result<Self, String> {
        let people = table::people(&table::decoded(bytes))?;
        if people.is_empty() {
            return Err(texts::GRADE_ROSTER_EMPTY.to_string());
        }
        Ok(Self { people })
    }

    /// Says of each submission whose it is: by number, or else by name. Then adds marks for everyone who handed nothing in.
    pub fn apply(&self, marks: &mut Vec<Marks>, rubric: &Rubric) -> Matched {
        let people = || self.people.iter().enumerate();
        let by_id = index(people().flat_map(|(at, person)| person.ids().map(move |id| (id_key(id), at))));
        let by_name = index(people().map(|(at, person)| (name_key(&person.name), at)));
        let one = |text: &str| {
            let by = |index: &Index, key: String| index.get(&key).copied().flatten();
            by(&by_id, id_key(text)).or_else(|| by(&by_name, name_key(text)))
        };
        let all = |text: &str| {
            // A group's names and numbers stand with commas between them, and so may a name's parts.
            let whole = one(text).map(|at| vec![at]);
            whole.or_else(|| text.split(", ").map(one).collect::<Option<Vec<usize>>>())
        };
        let mut matched = Matched::default();
        let mut handed_in: BTreeMap<usize, Vec<String>> = BTreeMap::new();
        for marks in marks.iter_mut() {
            let texts = [marks.id.as_deref(), marks.student.as_deref(), Some(marks.name.as_str())];
            let Some(found) = texts.into_iter().flatten().find_map(all) else {
                matched.unknown.push(marks.name.clone());
                continue;
            };
            for at in &found {
                handed_in.entry(*at).or_default().push(marks.name.clone());
            }
            marks.people = found.iter().map(|at| self.people[*at].clone()).collect();
        }
        let mut taken: BTreeSet<String> = marks.iter().map(|marks| marks.name.clone()).collect();
        for (at, person) in people().filter(|(at, _)| !handed_in.contains_key(at)) {
            let name = if person.name.is_empty() { person.ids().next().unwrap_or_default() } else { &person.name };
            let numbered = (at + 1..).map(|number| format!("{name} #{number}"));
            let free = std::iter::once(name.to_owned()).chain(numbered).find(|name| taken.insert(name.clone()));
            marks.push(Marks::missing(free.unwrap_or_default(), person, rubric));
        }
        let repeated = handed_in.into_iter().filter(|(_, names)| names.len() > 1);
        matched.repeated = repeated.map(|(at, names)| (self.people[at].name.clone(), names)).collect();
        matched
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(text: &str) -> Vec<String> {
        let show = |person: &Person| {
            let ids: Vec<&str> = person.ids().collect();
            format!("{}: {} in {}", person.name, ids.join(" "), person.section)
        };
        Roster::parse(text.as_bytes()).expect("it is right").people.iter().map(show).collect()
    }

    #[test]
    fn lists_of_course_systems_are_read() {
        let canvas = "\u{feff}Student,ID,SIS User ID,SIS Login ID,Section,A (1)\r\n\
            \x20   Points Possible,,,,,10\r\n\"Kim, Ann\",100,S-1,akim,\"A, 1\",\r\nLee \"\"Bob,101,S-2,,B,\r\n\"Student, Test\",9,,x,A,\r\n";
        assert_eq!(names(canvas), ["Kim, Ann: 100 S-1 akim in A, 1", "Lee \"\"Bob: 101 S-2 in B"]);
        let moodle = "First name,Last name,ID number,Email address,Groups\nAnn,Kim,007,a@b.c,G1\n";
        assert_eq!(names(moodle), ["Ann Kim: 007 a@b.c in G1"]);
        let worksheet = "Identifier,Full name,Email address,Status,Grade\nParticipant 77,Ann Kim,a@b.c,,\n";
        assert_eq!(names(worksheet), ["Ann Kim: 77 a@b.c in "]);
        let gradescope = "First Name,Last Name,SID,Email,Sections\nAnn,Kim,00420,a@b.c,L1\n";
        assert_eq!(names(gradescope), ["Ann Kim: 00420 a@b.c in L1"]);
        assert_eq!(
            names("name;id;section\n\n\"Kim; Ann\nB\";7;\"a \"\"b\"\"\"\n;8;\n"),
            ["Kim; Ann\nB: 7 in a \"b\"", ": 8 in "]
        );
        assert_eq!(names("이름\t학번\t분반\n김민지\t2026-1\t1\n"), ["김민지: 2026-1 in 1"]);
        for wrong in ["", "\n", "points,grade\n1,2\n", "name,id\n", "name,id\n,\n", "name,id\n\"Kim,7\n"] {
            let problem = Roster::parse(wrong.as_bytes()).expect_err(wrong);
            assert!(!problem.is_empty() && !problem.contains('\n'), "{problem}");
        }
    }

    #[test]
    fn names_are_compared_without_case_order_and_signs() {
        for (one, other) in [
            ("Kim, Ann", "ann KIM"),
            ("Zoe\u{308} Lefe\u{300}vre", "LEFÈVRE Zoë"),
            ("Quinn O'Neil", "o neil_quinn"),
            ("\u{1100}\u{1161}\u{11bc} 호동", "강 호동"),
        ] {
            assert_eq!(name_key(one), name_key(other));
        }
        assert_ne!(name_key("Ann Kim"), name_key("Ann Kima"));
    }
}
