//! Who made a submission, as course systems tell students apart.

use super::gather::System;
use super::marks::Marks;

/// A student as course systems know one. What is not known is empty.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Person {
    /// The name.
    pub name: String,
    /// Canvas's `ID`.
    pub canvas_id: String,
    /// Canvas's `SIS User ID`.
    pub sis_user_id: String,
    /// Canvas's `SIS Login ID`.
    pub sis_login_id: String,
    /// The number in Moodle's `Identifier`, another for each assignment.
    pub participant: String,
    /// The number that the school gives, Moodle's `ID number`.
    pub id_number: String,
    /// The address for mails.
    pub email: String,
    /// The section or group.
    pub section: String,
}

impl Person {
    /// All that tells the student apart but the name, where it is known.
    pub fn ids(&self) -> impl Iterator<Item = &str> {
        let ids =
            [&self.canvas_id, &self.sis_user_id, &self.sis_login_id, &self.participant, &self.id_number, &self.email];
        ids.into_iter().map(String::as_str).filter(|id| !id.is_empty())
    }

    /// Whose the submission is: the students of the list, or else as far as the names of its files say.
    #[must_use]
    pub fn all_of(marks: &Marks) -> Vec<Self> {
        let exported = Self::exported(marks);
        if marks.people.is_empty() {
            return vec![exported];
        }
        let mut people = marks.people.clone();
        if let [person] = &mut people[..] {
            // A list of another system lacks the numbers of the one that the submissions are from.
            for (known, exported) in
                [(&mut person.canvas_id, exported.canvas_id), (&mut person.participant, exported.participant)]
            {
                if known.is_empty() {
                    *known = exported;
                }
            }
        }
        people
    }

    fn exported(marks: &Marks) -> Self {
        let id = marks.id.clone().unwrap_or_default();
        let person = Self { name: marks.student.clone().unwrap_or_else(|| marks.name.clone()), ..Self::default() };
        match marks.system {
            Some(System::Canvas) => Self { canvas_id: id, ..person },
            Some(System::Moodle) => Self { participant: id, ..person },
            // Gradescope has the number only where the school's list had it.
            Some(System::Gradescope) if id.contains('@') => Self { email: id, ..person },
            Some(System::Gradescope) => Self { sis_user_id: id.clone(), id_number: id, ..person },
            None => person,
        }
    }
}
