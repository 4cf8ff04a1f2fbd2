//! The script's text: bytes to lines that can be run.

mod forms;
mod problem;
mod scene_lines;
mod values;

use std::time::Duration;

pub use forms::markdown;
use forms::{Rest, form_of};
pub use problem::{LineProblem, ScriptError};

use crate::editor::keymap::{Binding, bindings};
use crate::editor::{Command, FileCommand};
use crate::pose::RbtIndex;
use crate::scene::SceneGraph;

/// A line that does something.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Its number, from 1.
    pub number: usize,
    /// Its text without comment and outer blanks.
    pub text: String,
    /// What it does.
    pub action: Action,
}

/// What a line does.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Asks this of the editor.
    Apply(Command),
    /// Lets so much time pass for the animation clock.
    Wait(Duration),
}

impl Line {
    /// Whether it needs a renderer.
    #[must_use]
    pub fn takes_screenshot(&self) -> bool {
        matches!(self.action, Action::Apply(Command::File(FileCommand::Screenshot(_))))
    }
}

/// Reads a whole script for a scene. A byte order mark is passed over; blank lines and comments give nothing.
///
/// # Errors
/// Every line that cannot be understood, in order; never empty.
pub fn parse(bytes: &[u8], scene: &SceneGraph) -> Result<Vec<Line>, Vec<ScriptError>> {
    let mut parser = Parser { scene: scene.clone(), bindings: bindings() };
    let mut lines = Vec::new();
    let mut problems = Vec::new();
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    for (number, bytes) in (1..).zip(bytes.split(|&byte| byte == b'\n')) {
        match std::str::from_utf8(bytes).map_err(|_| LineProblem::NotUtf8).and_then(|text| parser.line(text)) {
            Ok(None) => {}
            Ok(Some((text, action))) => lines.push(Line { number, text: text.to_owned(), action }),
            Err(problem) => problems.push(ScriptError { number, problem }),
        }
    }
    if problems.is_empty() { Ok(lines) } else { Err(problems) }
}

/// What reading a line needs to know.
pub struct Parser {
    /// The scene as it is after the lines so far.
    scene: SceneGraph,
    bindings: Vec<Binding>,
}

impl Parser {
    /// The line's text without its comment, and what it does; nothing where nothing is left.
    fn line<'t>(&mut self, line: &'t str) -> Result<Option<(&'t str, Action)>, LineProblem> {
        let text = self.path_with_number_signs(line).or_else(|| quoted_name(line));
        let text = text.unwrap_or_else(|| line.split('#').next().unwrap_or_default().trim());
        if text.is_empty() {
            return Ok(None);
        }
        self.action(text).map(|action| Some((text, action)))
    }

    /// A path may hold what elsewhere starts a comment: the longest reading that names a node counts.
    fn path_with_number_signs<'t>(&self, line: &'t str) -> Option<&'t str> {
        let line = line.trim();
        let form = form_of(line.split_whitespace().next()?).filter(|form| form.ends_with_path)?;
        let ends = line.match_indices('#').map(|(end, _)| end).skip(1).chain([line.len()]);
        let readings: Vec<&str> = ends.map(|end| line[..end].trim_end()).filter(|text| text.contains('#')).collect();
        readings.into_iter().rev().find(|text| {
            let rest = text.strip_prefix(form.name).unwrap_or_default().trim_start();
            let words: Vec<&str> = rest.split_whitespace().collect();
            matches!((form.read)(self, Rest { text: rest, words: &words }), Ok(Some(_)))
        })
    }

    fn action(&mut self, text: &str) -> Result<Action, LineProblem> {
        let (name, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
        let rest = rest.trim_start();
        let form = form_of(name).ok_or_else(|| LineProblem::Unknown { word: name.to_owned() })?;
        let words: Vec<&str> = rest.split_whitespace().collect();
        let action = (form.read)(self, Rest { text: rest, words: &words })?;
        let action = action.ok_or_else(|| LineProblem::Usage { usage: form.usage, found: text.to_owned() })?;
        self.follow(&action);
        Ok(action)
    }

    fn rbt(&self, path: &str) -> Result<RbtIndex, LineProblem> {
        let missing = || LineProblem::Node { path: path.to_owned(), scene: self.scene.name().to_owned() };
        self.scene.find_rbt(path).ok_or_else(missing)
    }
}

/// The part of a line that renames a keyframe up to the end of the quoted name, after which only a comment stands.
fn quoted_name(line: &str) -> Option<&str> {
    let line = line.trim();
    let at = line.strip_prefix("rename").filter(|rest| rest.starts_with(char::is_whitespace)).and(line.find('"'))?;
    let mut texts = serde_json::Deserializer::from_str(&line[at..]).into_iter::<String>();
    texts.next()?.ok()?;
    let (text, rest) = line.split_at(at + texts.byte_offset());
    let rest = rest.trim_start();
    (rest.is_empty() || rest.starts_with('#')).then_some(text)
}

#[cfg(test)]
mod tests;
