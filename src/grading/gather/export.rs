//! Names of submissions as course systems export them.

use serde::{Deserialize, Serialize};

use super::gradescope::Metadata;

/// The course system.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize, Serialize)]
pub enum System {
    /// `name_LATE_100_2000_file.txt`, all in one folder.
    Canvas,
    /// `Name_100_assignsubmission_file_`, a folder or put before the file's name.
    Moodle,
    /// `submission_100`, a folder; who it is stands in `submission_metadata.yml`.
    Gradescope,
}

/// What a name says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Student {
    /// The system.
    pub system: System,
    /// The student's name as the system writes it; of a group, all.
    pub name: String,
    /// The student's number in the system.
    pub id: String,
    /// Whether it came late.
    pub is_late: bool,
    /// How many days late, where the system says it.
    pub days_late: Option<u32>,
    /// The file's own name, where the student is put before it.
    pub file: Option<String>,
}

/// Reads the name of an entry; `None` if it is none of an export.
pub fn student_of(name: &str, metadata: Option<&Metadata>) -> Option<Student> {
    let of_gradescope = || metadata?.student(name);
    moodle(name).or_else(|| canvas(name)).or_else(of_gradescope)
}

fn is_number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

fn canvas(name: &str) -> Option<Student> {
    let parts: Vec<&str> = name.split('_').collect();
    // The student's name may have signs of its own, and so may the file's: the first two numbers that follow each other count.
    // Small ones are not the system's: `lab_6_1_ann.txt` is another's than `lab_6_2_bob.txt`.
    let is_of = |at: usize, digits: usize| is_number(parts[at]) && parts[at].len() >= digits;
    let first = (1..parts.len().saturating_sub(2)).find(|&at| is_of(at, 2) && is_of(at + 1, 3))?;
    let is_late = first > 1 && parts[first - 1] == "LATE";
    let student = parts[..first - usize::from(is_late)].join("_");
    let file = parts[first + 2..].join("_");
    if student.is_empty() || file.is_empty() {
        return None;
    }
    Some(Student {
        system: System::Canvas,
        name: student,
        id: parts[first].to_owned(),
        is_late,
        days_late: None,
        file: Some(file),
    })
}

fn moodle(name: &str) -> Option<Student> {
    let (student, rest) = name.split_once("_assignsubmission_")?;
    let (student, id) = student.rsplit_once('_')?;
    if student.is_empty() || !is_number(id) {
        return None;
    }
    let (_, file) = rest.split_once('_').unwrap_or((rest, ""));
    let file = (!file.is_empty()).then(|| file.to_owned());
    Some(Student {
        system: System::Moodle,
        name: student.to_owned(),
        id: id.to_owned(),
        is_late: false,
        days_late: None,
        file,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_exports() {
        let read = |name: &str| {
            let Student { system, name, id, is_late, file, .. } = student_of(name, None)?;
            Some((system, name, id, is_late, file.unwrap_or_default()))
        };
        let student = |system, name: &str, id: &str, is_late, file: &str| {
            Some((system, name.to_owned(), id.to_owned(), is_late, file.to_owned()))
        };
        for (name, expected) in [
            ("smithemma_100000_9000000_asst6.zip", student(System::Canvas, "smithemma", "100000", false, "asst6.zip")),
            ("김민지_LATE_12_345_my_anim-1.txt", student(System::Canvas, "김민지", "12", true, "my_anim-1.txt")),
            ("de_la_cruz_LATE_10_200_3_4.txt", student(System::Canvas, "de_la_cruz", "10", true, "3_4.txt")),
            ("Anna 김_102035_assignsubmission_file_", student(System::Moodle, "Anna 김", "102035", false, "")),
            ("Anna 김_102035_assignsubmission_file", student(System::Moodle, "Anna 김", "102035", false, "")),
            (
                "Bo_Li_7_assignsubmission_file_key_frames.txt",
                student(System::Moodle, "Bo_Li", "7", false, "key_frames.txt"),
            ),
            ("Bo Li_7_assignsubmission_onlinetext_", student(System::Moodle, "Bo Li", "7", false, "")),
            ("animation.txt", None),
            ("hw_6_final.txt", None),
            ("_100_2000_a.txt", None),
            ("a_100_2000_", None),
            ("lab_6_1_ann.txt", None),
            ("submission_12", None),
            ("_assignsubmission_file_", None),
        ] {
            assert_eq!(read(name), expected, "{name}");
        }
    }
}
