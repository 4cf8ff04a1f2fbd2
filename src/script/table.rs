//! Tables of all script lines, for the help and the manual.

use std::fmt::Write as _;

use crate::editor::commands;

/// Lines that are no commands of the editor: first word, usage and description.
pub(super) const OWN_LINES: [(&str, &str, &str); 11] = [
    ("key", "key K", "a hotkey: the character itself, or a name such as `space`, `home`, `ctrl+d`"),
    (
        "do",
        "do NAME",
        "a command by its id or its English name in the list of commands (Ctrl+Shift+P), as in `do keyframes-reverse` or `do Reverse keyframes`",
    ),
    (
        "clamped",
        "clamped LINE",
        "`duration`, `ghosts`, `ms`, `speed` or `step` with a number out of its range, which is kept within it",
    ),
    ("wait", "wait TIME", "so much time for the animation clock: `500ms`, `2s`; `37t` is 37 ticks of 1/60 s"),
    (
        "scene",
        "scene NAME|\"JSON\" [\"PATH\"]",
        "in journals: starts anew with a scene, a built-in one or the text of a scene file",
    ),
    ("keyframe-file", "keyframe-file \"PATH\"", "in journals: names the keyframe file, without reading it"),
    (
        "imported",
        "imported \"PATH\" \"TEXT\"",
        "in journals: imports this text as if it stood in the file; `hex` and digits in its place for what is not UTF-8",
    ),
    (
        "imported-scene",
        "imported-scene \"PATH\" \"TEXT\"",
        "in journals: reads the scene again from this text; `hex` and digits as for `imported`",
    ),
    ("snapshot", "snapshot \"JSON\"", "in journals: a document and what is kept beside it, without steps of undo"),
    (
        "document",
        "document \"JSON\"",
        "in journals: the document that undo or redo led to, by a step from before the snapshot",
    ),
    ("ground", "ground", "in journals: what came before is not undone"),
];

/// First word, usage and description of every line; those of commands come first.
fn lines() -> impl Iterator<Item = (&'static str, &'static str, &'static str)> {
    commands::lines().map(|line| (line.name, line.usage, line.does)).chain(OWN_LINES)
}

/// Whether a script line may begin with this word.
#[must_use]
pub fn is_first_word(word: &str) -> bool {
    lines().any(|(name, ..)| name == word)
}

/// Every first word.
pub(super) fn names() -> impl Iterator<Item = &'static str> {
    lines().map(|(name, ..)| name)
}

/// The lines as a table in Markdown, for the manual.
#[must_use]
pub fn markdown() -> String {
    let mut text = String::from("| line | does |\n|---|---|\n");
    for (_, usage, does) in lines() {
        let _ = writeln!(text, "| `{}` | {does} |", usage.replace('|', "\\|"));
    }
    text
}

/// The lines as plain text, for the help of the command line.
#[must_use]
pub fn help() -> String {
    let mut text = String::new();
    for (_, usage, does) in lines() {
        let _ = writeln!(text, "  {usage}\n      {does}");
    }
    text
}
