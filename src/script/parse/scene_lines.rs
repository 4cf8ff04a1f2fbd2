//! Lines about control nodes, keys at their own times and the scene's file. A node's path stands last, since it may hold blanks.

use std::path::PathBuf;
use std::sync::Arc;

use super::forms::{Form, Rest, form, with_path};
use super::{Action, LineProblem, Parser};
use crate::colour::Colour;
use crate::editor::{Command, Edit, FileCommand, KeyAt, SceneEdit, ViewCommand};
use crate::scene::{Channel, KeyValue};

type Parsed<T> = Result<T, LineProblem>;

/// All of them, in the README's order.
#[rustfmt::skip]
pub static FORMS: &[Form] = &[
    with_path("put-control", "put-control PATH", "puts a control node above a node: its keys stand at their own times", |parser, rest| {
        named(parser, rest).map(|path| path.map(|path| edit(SceneEdit::PutControlAbove(path))))
    }),
    with_path("remove-control", "remove-control PATH", "removes a control node; what is below it stays", |parser, rest| {
        named(parser, rest).map(|path| path.map(|path| edit(SceneEdit::RemoveControl(path))))
    }),
    with_path("rename-control", "rename-control NAME PATH", "gives a control node another name", |parser, rest| {
        let Some(([name], path)) = then_path(parser, rest)? else { return Ok(None) };
        Ok(Some(edit(SceneEdit::RenameControl(path, name.to_owned()))))
    }),
    with_path("add-key", "add-key CHANNEL SECONDS PATH", "a key with what is shown then: `translation`, `rotation` or `scale` of a control node, `colour` of a shape", |parser, rest| {
        Ok(key(parser, rest)?.map(|key| edit(SceneEdit::AddKeys(vec![key]))))
    }),
    with_path("set-key", "set-key CHANNEL SECONDS VALUE PATH", "what a key holds: `x,y,z`; `yaw,pitch,roll` or `x,y,z,w`; `2` or `x,y,z`; `rrggbb`", |parser, rest| {
        let Some(([channel_word, at, value_word], node)) = then_path(parser, rest)? else { return Ok(None) };
        let value = value(channel(channel_word)?, value_word)?;
        Ok(Some(edit(SceneEdit::SetKey { value, node, seconds: seconds(at)? })))
    }),
    with_path("move-key", "move-key CHANNEL FROM TO PATH", "moves a key to another time, in seconds", |parser, rest| {
        let Some(([channel_word, from, to], path)) = then_path(parser, rest)? else { return Ok(None) };
        let from = seconds(from)?;
        let keys = vec![KeyAt::new(&path, channel(channel_word)?, from)];
        Ok(Some(edit(SceneEdit::MoveKeys { by: seconds(to)? - from, keys })))
    }),
    with_path("delete-key", "delete-key CHANNEL SECONDS PATH", "deletes a key", |parser, rest| {
        Ok(key(parser, rest)?.map(|key| edit(SceneEdit::DeleteKeys(vec![key]))))
    }),
    form("seconds", "seconds SECONDS", "shows the keys at their own times at so many seconds, and holds them there", |_, rest| {
        let &[at] = rest.words else { return Ok(None) };
        Ok(Some(Action::Apply(Command::View(ViewCommand::ScrubSeconds(seconds(at)?)))))
    }),
    form("save-scene", "save-scene FILE", "writes the scene with its control nodes and keys", |_, rest| {
        let file = FileCommand::SaveSceneAs(PathBuf::from(rest.text));
        Ok((!rest.words.is_empty()).then_some(Action::Apply(Command::File(file))))
    }),
];

fn edit(edit: SceneEdit) -> Action {
    Action::Apply(Command::Edit(Edit::Scene(edit)))
}

/// The path that is all of what stands there.
fn named(parser: &Parser, rest: Rest<'_>) -> Parsed<Option<Arc<str>>> {
    Ok(then_path::<0>(parser, rest)?.map(|(_, path)| path))
}

/// The key that a channel, a time and a path name.
fn key(parser: &Parser, rest: Rest<'_>) -> Parsed<Option<KeyAt>> {
    let Some(([channel_word, at], path)) = then_path(parser, rest)? else { return Ok(None) };
    Ok(Some(KeyAt::new(&path, channel(channel_word)?, seconds(at)?)))
}

/// So many words, and the path after them, of any node of the scene.
fn then_path<'a, const N: usize>(parser: &Parser, rest: Rest<'a>) -> Parsed<Option<([&'a str; N], Arc<str>)>> {
    let mut words = [""; N];
    let mut text = rest.text;
    for place in &mut words {
        let Some((word, after)) = text.split_once(char::is_whitespace) else { return Ok(None) };
        (*place, text) = (word, after.trim_start());
    }
    if text.is_empty() {
        return Ok(None);
    }
    let unknown = || LineProblem::Node { path: text.to_owned(), scene: parser.scene.name().to_owned() };
    parser.scene.find(text).ok_or_else(unknown)?;
    Ok(Some((words, text.into())))
}

fn channel(word: &str) -> Parsed<Channel> {
    Channel::from_name(word).ok_or_else(|| LineProblem::Channel { word: word.to_owned() })
}

impl Parser {
    /// From here on the lines speak of the scene as an action leaves it. What cannot be is a message when the line runs.
    pub(super) fn follow(&mut self, action: &Action) {
        let Action::Apply(Command::Edit(Edit::Scene(edit))) = action else { return };
        let changed = match edit {
            SceneEdit::PutControlAbove(path) => self.scene.find(path).map(|id| self.scene.with_control_above(id).0),
            SceneEdit::RemoveControl(path) => self.scene.find(path).and_then(|id| self.scene.without_control(id).ok()),
            SceneEdit::RenameControl(path, name) => {
                self.scene.find(path).and_then(|id| self.scene.with_control_renamed(id, name).ok())
            }
            _ => None,
        };
        if let Some(scene) = changed {
            self.scene = scene;
        }
    }
}

/// A time in seconds: `1.5`, or `1.5s`.
fn seconds(word: &str) -> Parsed<f64> {
    let seconds = word.strip_suffix('s').unwrap_or(word).parse().ok().filter(|seconds: &f64| seconds.is_finite());
    seconds.ok_or_else(|| LineProblem::Number { word: word.to_owned() })
}

/// The value of a key.
fn value(channel: Channel, word: &str) -> Parsed<KeyValue> {
    let wrong = || LineProblem::Value { word: word.to_owned(), channel: channel.name(), expected: channel.expected() };
    channel.parse(word).ok_or_else(wrong)
}
