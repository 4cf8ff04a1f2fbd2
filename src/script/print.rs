//! A command as a line that reads back to it.

use super::parse::{Action, parse};
use crate::editor::Command;
use crate::editor::commands::{self, Arguments};
use crate::scene::SceneGraph;

/// The script line of a command for a scene as it is before the command.
///
/// What is returned reads back to an equal command, to the bits of its numbers. Every command that changes the document or the session
/// has a line, except one that the editor refuses whatever happens: a number is not finite, or the scene has no such node. A file's
/// path that is not Unicode has none, and neither have exports and those commands of the window that have parameters.
///
/// # Examples
/// ```
/// use inbetween::editor::{Command, Edit};
/// use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
/// use inbetween::script;
///
/// let scene = built_in_scene(DEFAULT_SCENE).unwrap();
/// let command = Command::Edit(Edit::SetMsBetweenKeyframes(700));
/// assert_eq!(script::print(&command, &scene).as_deref(), Some("ms 700"));
/// ```
#[must_use]
pub fn print(command: &Command, scene: &SceneGraph) -> Option<String> {
    let row = commands::row_of(command);
    let written = row.lines.iter().filter_map(|line| line.write(command, scene));
    let listed = row.bindings.iter().filter(|binding| binding.command == *command);
    let done = listed.map(|binding| format!("do {}", binding.id));
    written
        .chain(done)
        .flat_map(|text| [format!("clamped {text}"), text].into_iter().rev())
        .find(|text| reads_as(text, command, scene))
}

/// As [`print`], checked against the command's own lines alone: for a journal, which must not make commands slower. A test compares the
/// two.
#[must_use]
pub fn print_swiftly(command: &Command, scene: &SceneGraph) -> Option<String> {
    let row = commands::row_of(command);
    let swift = row.lines.iter().find_map(|line| {
        let text = line.write(command, scene)?;
        // A number sign may begin a comment, and other blanks may be lost: the slow way decides.
        let is_plain = text.bytes().all(|byte| byte != b'#' && byte != b'"' && (byte >= 0x20));
        let rest = text.strip_prefix(line.name)?.trim_start();
        let words: Vec<&str> = rest.split_whitespace().collect();
        let read = line.read(&Arguments { scene, text: rest, words: &words, allows_out_of_range: false });
        (is_plain && rest.trim_end().len() == rest.len() && read.ok()?.as_ref() == Some(command)).then_some(text)
    });
    swift.or_else(|| print(command, scene))
}

fn reads_as(text: &str, command: &Command, scene: &SceneGraph) -> bool {
    let lines = parse(text.as_bytes(), scene).unwrap_or_default();
    matches!(lines.as_slice(), [line] if line.action == Action::Apply(command.clone()))
}
