//! The known mistakes: a row each, in two files by age.
//!
//! A row is all that the program knows about a mistake: its name, how it is played, and what people are told about it. `diagnose`, the
//! help, the report of `grade` and the manual's page are made of the rows.

mod first;
mod later;

use std::fmt::Write as _;

use super::rules::{LINEAR, Rules, SPLINE};

/// A change of the rules of right playback.
type Change = fn(&mut Rules);

/// All that is known about a mistake, or about right playback.
#[derive(Debug)]
pub struct Mistake {
    /// The name in kebab-case, such as `lerp-for-slerp`.
    pub name: &'static str,
    /// What the program does: a sentence.
    pub what: &'static str,
    /// What to change; empty for right playback.
    pub change: &'static str,
    /// The formula as the program has it; empty for right playback.
    pub wrong: &'static str,
    /// The right formula.
    pub right: &'static str,
    /// What it looks like: a sentence or two.
    pub looks: &'static str,
    /// The line of code to look for.
    pub line: &'static str,
    /// Which keyframes reveal it; empty for right playback.
    pub revealed_by: &'static str,
    /// The ways to make it in linear playback, as changes of right playback; often none or one.
    linear: &'static [Change],
    /// The ways to make it in Catmull-Rom playback.
    spline: &'static [Change],
}

impl PartialEq for Mistake {
    /// Names are unique.
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

/// Something that people are told about a mistake.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fact {
    /// What it is about.
    pub title: &'static str,
    /// A sentence or two, or a line of code or of a formula.
    pub text: &'static str,
    /// Whether it is such a line.
    pub is_code: bool,
}

/// A mistake with its place in the order of answers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Entry {
    /// Its place in the catalogue, from 0.
    pub rank: usize,
    /// The mistake.
    pub mistake: &'static Mistake,
}

/// One way to make a mistake.
#[derive(Clone, Copy, Debug)]
pub(super) struct Form {
    /// The mistake.
    pub entry: Entry,
    /// Whether it is made in Catmull-Rom playback.
    pub is_spline: bool,
    change: Change,
}

impl Form {
    /// The rules of a program that makes this mistake alone.
    pub fn rules(&self) -> Rules {
        let mut rules = if self.is_spline { SPLINE } else { LINEAR };
        (self.change)(&mut rules);
        rules
    }

    /// The rules of a program that makes both mistakes; `None` if they exclude each other.
    pub fn with(&self, other: &Self) -> Option<Rules> {
        let (one, two) = (self.rules(), other.rules());
        let (mut both, mut swapped) = (one, two);
        (other.change)(&mut both);
        (self.change)(&mut swapped);
        (self.is_spline == other.is_spline && both == swapped && both != one && both != two).then_some(both)
    }
}

impl Mistake {
    /// Whether this is right playback.
    #[must_use]
    pub fn is_right(&self) -> bool {
        self.change.is_empty()
    }

    /// What people are told about it after [`Mistake::what`], in the order in which it is told; for right playback, nothing.
    #[must_use]
    pub fn facts(&self) -> Vec<Fact> {
        if self.is_right() {
            return Vec::new();
        }
        let words = |title, text| Fact { title, text, is_code: false };
        let code = |title, text| Fact { title, text, is_code: true };
        vec![
            words("In", self.playback()),
            code("Wrong", self.wrong),
            code("Right", self.right),
            words("What it looks like", self.looks),
            code("The line to look for", self.line),
            words("What to change", self.change),
            words("Keyframes that reveal it", self.revealed_by),
        ]
    }

    fn playback(&self) -> &'static str {
        match (self.linear.is_empty(), self.spline.is_empty()) {
            (false, false) => "Linear and Catmull-Rom playback.",
            (false, true) => "Linear playback.",
            _ => "Catmull-Rom playback.",
        }
    }
}

/// Every mistake after the two right results. Of answers that explain samples equally well, the earlier is named first.
pub fn mistakes() -> impl Iterator<Item = &'static Mistake> {
    first::ROWS.iter().chain(&later::ROWS)
}

/// Whether a mistake of this place is among those that were known first.
pub(super) const fn is_old(rank: usize) -> bool {
    rank < first::ROWS.len()
}

/// Every way to make every mistake.
pub(super) fn forms() -> impl Iterator<Item = Form> {
    mistakes().enumerate().flat_map(|(rank, mistake)| {
        let entry = Entry { rank, mistake };
        let form = move |is_spline| move |change: &Change| Form { entry, is_spline, change: *change };
        mistake.linear.iter().map(form(false)).chain(mistake.spline.iter().map(form(true)))
    })
}

/// The manual's sections, one a mistake, as Markdown.
#[must_use]
pub fn markdown() -> String {
    let mut text = String::new();
    for mistake in mistakes().filter(|mistake| !mistake.is_right()) {
        let _ = write!(text, "\n## {}\n\n{}\n\n", mistake.name, mistake.what);
        for Fact { title, text: fact, is_code } in mistake.facts() {
            let mark = if is_code { "`" } else { "" };
            let _ = writeln!(text, "* {title}: {mark}{fact}{mark}");
        }
    }
    text.push('\n');
    text
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::diagnosis::CORRECT;

    #[test]
    fn every_row_is_whole_and_plays_in_its_own_way() {
        assert_eq!(mistakes().next().map(|mistake| mistake.name), Some(CORRECT));
        let names: BTreeSet<_> = mistakes().map(|mistake| mistake.name).collect();
        assert_eq!(names.len(), mistakes().count());
        for mistake in mistakes().skip(2) {
            let Mistake { what, change, wrong, right, looks, line, revealed_by, .. } = mistake;
            for text in [what, change, wrong, right, looks, line, revealed_by] {
                assert!(!text.is_empty(), "{}", mistake.name);
            }
        }
        let forms: Vec<Form> = forms().collect();
        for (index, form) in forms.iter().enumerate() {
            let same = forms[..index].iter().find(|other| other.rules() == form.rules());
            assert!(same.is_none(), "{} plays as {:?}", form.entry.mistake.name, same.map(|s| s.entry.mistake.name));
        }
    }
}
