//! Converts the keys of Python programs, such as `translate_keys = {0: vec(0, 0, 0), 2: vec(1, 1, 0)}`, to a scene file with a control
//! node. A program is parsed, never run.

mod calls;
mod depth;
mod dictionary;
mod evaluate;
mod fault;
mod functions;
mod groups;
mod keys;
mod looks;
mod names;
mod program;
mod scene;
mod scopes;
mod walk;

use super::error::{TextError, TextProblem};
use super::report::{Certainty, Report};
use super::{GroupChoice, Options};
use crate::words::{Argument, Message, texts};
use groups::Group;
pub(super) use looks::is_python;
use program::Program;

/// The most groups that a sentence lists.
const MOST_LISTED: usize = 20;

/// The text of a scene file whose control node has the keys of a Python text. `at` is the byte offset of the text's start.
///
/// # Errors
/// The first error, with its location; a list of the groups of keys if there are several and none is chosen.
pub(super) fn scene_from_keys(bytes: &[u8], at: usize, options: &Options) -> Result<(String, Report), TextError> {
    let program = Program::new(bytes, at);
    let groups = program.groups()?;
    let chosen = chosen(&groups, options.group, &program)?;
    let keys = groups[chosen].keys.as_ref().map_err(|fault| program.error(fault))?;
    let mut report = Report::new(texts::file_keys_summary(
        texts::count_translations(keys.translations.len()),
        texts::count_rotations(keys.rotations.len()),
        texts::count_scales(keys.scales.len()),
    ));
    report.add(Certainty::Sure, "layout: Python dictionaries of keys; times in seconds");
    report.add(Certainty::Note, found(&groups, chosen, options, &program));
    for (number, group) in (1..).zip(&groups) {
        if let Err(fault) = &group.keys {
            let error = program.error(fault);
            report.add(Certainty::Warning, format!("group {number} is left out: {error}"));
        }
    }
    if keys.met.quaternions {
        report.add(
            Certainty::Likely,
            "quaternion(x, y, z, w): the components in this order, as the course's module has it",
        );
    }
    if keys.has_four_numbers {
        report.add(Certainty::Likely, "four numbers as a rotation: w, x, y and z, as the course's module stores them");
    }
    if keys.met.euler_angles {
        report.add(
            Certainty::Sure,
            "quaternion_from_euler(yaw, pitch, roll): degrees about z, y and x, as in scene files",
        );
    }
    if keys.hides {
        report.add(Certainty::Note, "a scale of 0 is written as 1e-6, which is too small to be seen");
    }
    report.add(Certainty::Note, "the scene has a box to be moved, a ground and a camera of its own");
    Ok((scene::scene_text(keys), report))
}

/// The index of the group to read.
fn chosen(groups: &[Group], choice: GroupChoice, program: &Program<'_>) -> Result<usize, TextError> {
    let Some(first) = groups.first() else { return Err(program.error_at(0, TextProblem::NoKeys)) };
    let mut whole = (0..groups.len()).filter(|&index| groups[index].keys.is_ok());
    match (choice, whole.next(), whole.next()) {
        (GroupChoice::Number(group), ..) if (1..=groups.len()).contains(&group) => Ok(group - 1),
        (GroupChoice::Number(group), ..) => {
            Err(program.error_at(first.at, TextProblem::NoGroup { group, list: list(groups, program) }))
        }
        // If none can be read, the first says why.
        (_, None, _) => Ok(0),
        (_, Some(only), None) | (GroupChoice::First, Some(only), _) => Ok(only),
        (GroupChoice::Only, Some(_), Some(_)) => {
            let problem = TextProblem::Groups { count: groups.len(), list: list(groups, program) };
            Err(program.error_at(first.at, problem))
        }
    }
}

/// The groups with their numbers, lines and names.
fn list(groups: &[Group], program: &Program<'_>) -> Message {
    let one = |(index, group): (usize, &Group)| {
        let (number, line) = (index + 1, program.line(group.at));
        let name = match group.path.as_str() {
            "" => Argument::from(texts::TEXT_GROUP_WITHOUT_NAME),
            path => path.into(),
        };
        if group.keys.is_ok() {
            texts::text_group(number, line, name)
        } else {
            texts::text_group_refused(number, line, name)
        }
    };
    let listed = groups.iter().take(MOST_LISTED).enumerate().map(one).reduce(texts::text_group_after);
    let listed = listed.unwrap_or_else(|| texts::TEXT_GROUP_WITHOUT_NAME.into());
    match groups.len().saturating_sub(MOST_LISTED) {
        0 => listed,
        more => texts::text_group_more(listed, more),
    }
}

/// The sentence about the groups that were found.
fn found(groups: &[Group], chosen: usize, options: &Options, program: &Program<'_>) -> String {
    let line = program.line(groups[chosen].at);
    let place = match options.file_name.as_str() {
        "" => String::new(),
        name => format!(" in {name}"),
    };
    match groups.len() {
        1 => format!("line {line}: one group of keys was found{place}"),
        count => format!("line {line}: group {} of {count} groups of keys that were found{place}", chosen + 1),
    }
}
