//! Lines about control nodes, keys at their own times and the scene's file. A node's path stands last, since it may hold blanks.

use std::path::PathBuf;
use std::sync::Arc;

use glam::{Quat, Vec3};

use super::{Action, LineProblem, Parser};
use crate::editor::{Command, Edit, FileCommand, KeyAt, SceneEdit, ViewCommand};
use crate::scene::{Channel, Colour, KeyValue, NodeId};
use crate::timed::rotation_from_euler_degrees;

type Parsed<T> = Result<T, LineProblem>;

/// The first word of a text, and what is behind it.
fn word(text: &str) -> (&str, &str) {
    let (word, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    (word, rest.trim_start())
}

impl Parser {
    /// What a line does, if it is one of these. From then on the lines speak of the scene as it leaves it.
    pub(super) fn scene_line(&mut self, name: &str, rest: &str, text: &str) -> Option<Parsed<Action>> {
        let usage = match name {
            "put-control" => "put-control PATH",
            "remove-control" => "remove-control PATH",
            "rename-control" => "rename-control NAME PATH",
            "add-key" => "add-key CHANNEL SECONDS PATH",
            "set-key" => "set-key CHANNEL SECONDS VALUE PATH",
            "move-key" => "move-key CHANNEL FROM TO PATH",
            "delete-key" => "delete-key CHANNEL SECONDS PATH",
            "seconds" => "seconds SECONDS",
            "save-scene" => "save-scene FILE",
            _ => return None,
        };
        let words = usage.split(' ').count() - 1;
        if rest.split_whitespace().count() < words || (name == "seconds" && rest.contains(char::is_whitespace)) {
            return Some(Err(LineProblem::Usage { usage, found: text.to_owned() }));
        }
        Some(self.command(name, rest).map(Action::Apply))
    }

    fn command(&mut self, name: &str, rest: &str) -> Parsed<Command> {
        let edit = match name {
            "seconds" => return Ok(Command::View(ViewCommand::ScrubSeconds(seconds(rest)?))),
            "save-scene" => return Ok(Command::File(FileCommand::SaveSceneAs(PathBuf::from(rest)))),
            "put-control" => {
                let (id, path) = self.node(rest)?;
                self.scene = self.scene.with_control_above(id).0;
                SceneEdit::PutControlAbove(path)
            }
            "remove-control" => {
                let (id, path) = self.node(rest)?;
                // What cannot be is a message when the line runs.
                self.scene = self.scene.without_control(id).unwrap_or_else(|_| self.scene.clone());
                SceneEdit::RemoveControl(path)
            }
            "rename-control" => {
                let (name, path) = word(rest);
                let (id, path) = self.node(path)?;
                self.scene = self.scene.with_control_renamed(id, name).unwrap_or_else(|_| self.scene.clone());
                SceneEdit::RenameControl(path, name.to_owned())
            }
            _ => self.key_edit(name, rest)?,
        };
        Ok(Command::Edit(Edit::Scene(edit)))
    }

    fn key_edit(&self, name: &str, rest: &str) -> Parsed<SceneEdit> {
        let (channel_word, rest) = word(rest);
        let channel =
            Channel::from_name(channel_word).ok_or_else(|| LineProblem::Channel { word: channel_word.to_owned() })?;
        let (at, rest) = word(rest);
        let at = seconds(at)?;
        let key = |path: &str| Ok(KeyAt::new(&self.node(path)?.1, channel, at));
        Ok(match name {
            "add-key" => SceneEdit::AddKeys(vec![key(rest)?]),
            "delete-key" => SceneEdit::DeleteKeys(vec![key(rest)?]),
            "move-key" => {
                let (to, path) = word(rest);
                SceneEdit::MoveKeys { by: seconds(to)? - at, keys: vec![key(path)?] }
            }
            _ => {
                let (value_word, path) = word(rest);
                SceneEdit::SetKey { value: value(channel, value_word)?, node: self.node(path)?.1, seconds: at }
            }
        })
    }

    fn node(&self, path: &str) -> Parsed<(NodeId, Arc<str>)> {
        let unknown = || LineProblem::Node { path: path.to_owned(), scene: self.scene.name().to_owned() };
        Ok((self.scene.find(path).ok_or_else(unknown)?, path.into()))
    }
}

/// A time in seconds: `1.5`, or `1.5s`.
fn seconds(word: &str) -> Parsed<f64> {
    let seconds = word.strip_suffix('s').unwrap_or(word).parse().ok().filter(|seconds: &f64| seconds.is_finite());
    seconds.ok_or_else(|| LineProblem::Number { word: word.to_owned() })
}

/// The value of a key: numbers with commas between them, or six hexadecimal digits.
fn value(channel: Channel, word: &str) -> Parsed<KeyValue> {
    let numbers: Option<Vec<f32>> = word.split(',').map(|number| number.parse().ok()).collect();
    let numbers = numbers.unwrap_or_default();
    let value = match (channel, numbers.as_slice()) {
        (Channel::Translation, &[x, y, z]) => Some(KeyValue::Translation(Vec3::new(x, y, z))),
        (Channel::Rotation, &[yaw, pitch, roll]) => {
            Some(KeyValue::Rotation(rotation_from_euler_degrees([yaw, pitch, roll]).normalize()))
        }
        (Channel::Rotation, &[x, y, z, w]) => Some(KeyValue::Rotation(Quat::from_xyzw(x, y, z, w))),
        (Channel::Scale, &[scale]) => Some(KeyValue::Scale(Vec3::splat(scale))),
        (Channel::Scale, &[x, y, z]) => Some(KeyValue::Scale(Vec3::new(x, y, z))),
        (Channel::Colour, _) => Colour::from_hex(&format!("#{word}")).map(KeyValue::Colour),
        _ => None,
    };
    let expected = match channel {
        Channel::Translation => "x,y,z",
        Channel::Rotation => "yaw,pitch,roll in degrees, or a unit quaternion x,y,z,w",
        Channel::Scale => "one number, or x,y,z",
        Channel::Colour => "rrggbb",
    };
    value.ok_or_else(|| LineProblem::Value { word: word.to_owned(), channel: channel.name(), expected })
}
