//! Commands of control nodes and of their timed keys. A node's path stands last in a line, since it may hold blanks.

use std::sync::Arc;

use super::line::{ArgumentError, Arguments, Ending, Line};
use super::row::{Changes, Row};
use super::values::{double, node_text, number_text, numbers_text, quoted_prefix, token_text, tokens, word_and_rest};
use crate::editor::{Command, Edit, KeyAt, SceneEdit, SelectionCommand, ViewCommand};
use crate::scene::{Channel, KeyValue};
use crate::words::texts;

type Parsed<T> = Result<T, ArgumentError>;

fn edit(edit: SceneEdit) -> Command {
    Command::Edit(Edit::Scene(edit))
}

const fn edit_of(command: &Command) -> Option<&SceneEdit> {
    match command {
        Command::Edit(Edit::Scene(edit)) => Some(edit),
        _ => None,
    }
}

fn edit_with(id: &'static str, owns: fn(&Command) -> bool) -> Row {
    Row::of(Changes::Document, id, owns).refused(texts::ACT_EDIT_THE_SCENE)
}

pub(super) fn rows() -> Vec<Row> {
    [controls(), keys(), many_keys()].concat()
}

fn controls() -> Vec<Row> {
    vec![
        edit_with("put-control", |command| matches!(edit_of(command), Some(SceneEdit::PutControlAbove(_)))).line(
            Line::new(
                "put-control PATH",
                "puts a control node above a node: its keys stand at their own times",
                |arguments| Ok(named(arguments)?.map(|path| edit(SceneEdit::PutControlAbove(path)))),
                |command, _| {
                    let Some(SceneEdit::PutControlAbove(path)) = edit_of(command) else { return None };
                    Some(node_text(path))
                },
            )
            .ending(Ending::NodePath),
        ),
        edit_with("remove-control", |command| matches!(edit_of(command), Some(SceneEdit::RemoveControl(_)))).line(
            Line::new(
                "remove-control PATH",
                "removes a control node; what is below it stays",
                |arguments| Ok(named(arguments)?.map(|path| edit(SceneEdit::RemoveControl(path)))),
                |command, _| {
                    let Some(SceneEdit::RemoveControl(path)) = edit_of(command) else { return None };
                    Some(node_text(path))
                },
            )
            .ending(Ending::NodePath),
        ),
        edit_with("rename-control", |command| matches!(edit_of(command), Some(SceneEdit::RenameControl(..)))).line(
            Line::new(
                "rename-control NAME PATH",
                "gives a control node another name, which stands in double quotes if it holds blanks",
                |arguments| {
                    let Some((name, path)) = name_and_rest(arguments.text) else { return Ok(None) };
                    Ok(Some(edit(SceneEdit::RenameControl(arguments.node(path)?, name))))
                },
                |command, _| {
                    let Some(SceneEdit::RenameControl(path, name)) = edit_of(command) else { return None };
                    Some(format!("{} {}", token_text(name), node_text(path)))
                },
            )
            .ending(Ending::NodePath),
        ),
    ]
}

/// A word, bare or in double quotes, and the text after it.
fn name_and_rest(text: &str) -> Option<(String, &str)> {
    let quoted = quoted_prefix(text).filter(|(length, _)| text[*length..].starts_with(char::is_whitespace));
    let (name, rest) = match quoted {
        Some((length, name)) => (name, text[length..].trim_start()),
        None => word_and_rest(text).map(|(name, rest)| (name.to_owned(), rest))?,
    };
    (!rest.is_empty()).then_some((name, rest))
}

fn keys() -> Vec<Row> {
    vec![
        edit_with("add-key", |command| matches!(edit_of(command), Some(SceneEdit::AddKeys(_))))
            .line(
                Line::new(
                    "add-key CHANNEL SECONDS PATH",
                    "a key with what is shown then: `translation`, `rotation` or `scale` of a control node, `colour` of a shape",
                    |arguments| Ok(key(arguments)?.map(|key| edit(SceneEdit::AddKeys(vec![key])))),
                    |command, _| {
                        let Some(SceneEdit::AddKeys(keys)) = edit_of(command) else { return None };
                        only_key_text(keys)
                    },
                )
                .ending(Ending::NodePath),
            )
            .line(many(
                "add-keys CHANNEL SECONDS PATH…|none",
                "keys as above, of many at once; a path with blanks stands in double quotes",
                |arguments| Ok(key_list(arguments)?.map(|keys| edit(SceneEdit::AddKeys(keys)))),
                |command, _| {
                    let Some(SceneEdit::AddKeys(keys)) = edit_of(command) else { return None };
                    Some(key_list_text(keys))
                },
            )),
        edit_with("set-key", |command| matches!(edit_of(command), Some(SceneEdit::SetKey { .. })))
            .continuous()
            .line(
                Line::new(
                    "set-key CHANNEL SECONDS VALUE PATH",
                    "what a key holds: `x,y,z`; `yaw,pitch,roll` or `x,y,z,w`; `2` or `x,y,z`; `rrggbb`",
                    |arguments| {
                        let Some(([channel_word, at, value_word], path)) = arguments.then_text() else {
                            return Ok(None);
                        };
                        let node = arguments.node(path)?;
                        let value = value(channel(channel_word)?, value_word)?;
                        Ok(Some(edit(SceneEdit::SetKey { value, node, seconds: seconds(at)? })))
                    },
                    |command, _| {
                        let Some(SceneEdit::SetKey { node, seconds, value }) = edit_of(command) else { return None };
                        let channel = value.channel().name();
                        Some(format!("{channel} {} {} {}", number_text(seconds), value_text(*value), node_text(node)))
                    },
                )
                .ending(Ending::NodePath)
                .angles(|arguments| match *arguments.words {
                    [channel, _, angles, ..] if channel == Channel::Rotation.name() => euler_angles(angles),
                    _ => Vec::new(),
                }),
            ),
    ]
}

fn many_keys() -> Vec<Row> {
    vec![
        edit_with("move-key", |command| matches!(edit_of(command), Some(SceneEdit::MoveKeys { .. })))
            .continuous()
            .line(
                Line::new(
                    "move-key CHANNEL FROM TO PATH",
                    "moves a key to another time, in seconds",
                    |arguments| {
                        let Some(([channel_word, from, to], path)) = arguments.then_text() else { return Ok(None) };
                        let node = arguments.node(path)?;
                        let from = seconds(from)?;
                        let keys = vec![KeyAt::new(&node, channel(channel_word)?, from)];
                        Ok(Some(edit(SceneEdit::MoveKeys { by: seconds(to)? - from, keys })))
                    },
                    // A difference of times may not be representable as two times, so write the difference itself.
                    |_, _| None,
                )
                .ending(Ending::NodePath),
            )
            .line(many(
                "move-keys SECONDS CHANNEL SECONDS PATH…|none",
                "moves keys by so many seconds",
                |arguments| {
                    let Some((by, keys)) = word_and_rest(arguments.text) else { return Ok(None) };
                    let by = seconds(by)?;
                    Ok(key_list(&Arguments { text: keys, ..*arguments })?
                        .map(|keys| edit(SceneEdit::MoveKeys { keys, by })))
                },
                |command, _| {
                    let Some(SceneEdit::MoveKeys { keys, by }) = edit_of(command) else { return None };
                    Some(format!("{} {}", number_text(by), key_list_text(keys)))
                },
            )),
        edit_with("delete-key", |command| matches!(edit_of(command), Some(SceneEdit::DeleteKeys(_))))
            .line(
                Line::new(
                    "delete-key CHANNEL SECONDS PATH",
                    "deletes a key",
                    |arguments| Ok(key(arguments)?.map(|key| edit(SceneEdit::DeleteKeys(vec![key])))),
                    |command, _| {
                        let Some(SceneEdit::DeleteKeys(keys)) = edit_of(command) else { return None };
                        only_key_text(keys)
                    },
                )
                .ending(Ending::NodePath),
            )
            .line(many(
                "delete-keys CHANNEL SECONDS PATH…|none",
                "deletes many keys at once",
                |arguments| Ok(key_list(arguments)?.map(|keys| edit(SceneEdit::DeleteKeys(keys)))),
                |command, _| {
                    let Some(SceneEdit::DeleteKeys(keys)) = edit_of(command) else { return None };
                    Some(key_list_text(keys))
                },
            )),
        Row::of(Changes::Session, "select-keys", |command| {
            matches!(command, Command::Selection(SelectionCommand::TimedKeys(_)))
        })
        .line(many(
            "select-keys CHANNEL SECONDS PATH…|none",
            "selects keys, and no keyframes",
            |arguments| Ok(key_list(arguments)?.map(|keys| Command::Selection(SelectionCommand::TimedKeys(keys)))),
            |command, _| {
                let Command::Selection(SelectionCommand::TimedKeys(keys)) = command else { return None };
                Some(key_list_text(keys))
            },
        )),
        Row::of(Changes::Session, "seconds", |command| matches!(command, Command::View(ViewCommand::ScrubSeconds(_))))
            .line(Line::new(
                "seconds SECONDS",
                "shows the keys at their own times at so many seconds, and holds them there",
                |arguments| {
                    let &[at] = arguments.words else { return Ok(None) };
                    Ok(Some(Command::View(ViewCommand::ScrubSeconds(seconds(at)?))))
                },
                |command, _| {
                    let Command::View(ViewCommand::ScrubSeconds(seconds)) = command else { return None };
                    Some(number_text(seconds))
                },
            )),
    ]
}

/// A line of many keys, whose paths are words in double quotes where they hold blanks.
fn many(usage: &'static str, does: &'static str, read: super::line::Read, write: super::line::Write) -> Line {
    Line::new(usage, does, read, write).ending(Ending::QuotedWords)
}

/// The path that is all of what stands there.
fn named(arguments: &Arguments<'_>) -> Parsed<Option<Arc<str>>> {
    arguments.then_text::<0>().map(|(_, path)| arguments.node(path)).transpose()
}

/// The key that a channel, a time and a path name.
fn key(arguments: &Arguments<'_>) -> Parsed<Option<KeyAt>> {
    let Some(([channel_word, at], path)) = arguments.then_text() else { return Ok(None) };
    let node = arguments.node(path)?;
    Ok(Some(KeyAt::new(&node, channel(channel_word)?, seconds(at)?)))
}

fn only_key_text(keys: &[KeyAt]) -> Option<String> {
    let [KeyAt { track, seconds }] = keys else { return None };
    Some(format!("{} {} {}", track.channel.name(), number_text(seconds), node_text(&track.node)))
}

fn key_list(arguments: &Arguments<'_>) -> Parsed<Option<Vec<KeyAt>>> {
    let (words, _) = tokens(arguments.text);
    if words == ["none"] {
        return Ok(Some(Vec::new()));
    }
    let (keys, rest) = words.as_chunks::<3>();
    if keys.is_empty() || !rest.is_empty() {
        return Ok(None);
    }
    let key = |[channel_word, at, path]: &[String; 3]| {
        // A word stands for what it says: quotes in it are of the path itself.
        let node = arguments.scene.find(path).map(|_| path.as_str());
        let node = node.ok_or_else(|| arguments.missing(path))?;
        Ok(KeyAt::new(node, channel(channel_word)?, seconds(at)?))
    };
    keys.iter().map(key).collect::<Parsed<Vec<_>>>().map(Some)
}

fn key_list_text(keys: &[KeyAt]) -> String {
    if keys.is_empty() {
        return "none".to_owned();
    }
    let key = |KeyAt { track, seconds }: &KeyAt| {
        format!("{} {} {}", track.channel.name(), number_text(seconds), token_text(&track.node))
    };
    keys.iter().map(key).collect::<Vec<_>>().join(" ")
}

fn channel(word: &str) -> Parsed<Channel> {
    Channel::from_name(word).ok_or_else(|| ArgumentError::Channel { word: word.to_owned() })
}

/// A time in seconds: `1.5`, or `1.5s`.
fn seconds(word: &str) -> Parsed<f64> {
    double(word.strip_suffix('s').unwrap_or(word)).map_err(|_| ArgumentError::Number { word: word.to_owned() })
}

/// The value of a key: numbers with commas between them, or six hexadecimal digits.
fn value(channel: Channel, word: &str) -> Parsed<KeyValue> {
    channel.parse(word).ok_or_else(|| ArgumentError::Value {
        word: word.to_owned(),
        channel: channel.name(),
        expected: channel.expected(),
    })
}

/// Yaw, pitch and roll in degrees; nothing for a quaternion.
fn euler_angles(word: &str) -> Vec<f64> {
    let angles: Vec<f64> = word.split(',').filter_map(|angle| angle.parse().ok()).collect();
    if angles.len() == 3 { angles } else { Vec::new() }
}

fn value_text(value: KeyValue) -> String {
    match value {
        KeyValue::Translation(vector) | KeyValue::Scale(vector) => numbers_text(&vector.to_array(), ","),
        KeyValue::Rotation(rotation) => numbers_text(&rotation.to_array(), ","),
        KeyValue::Colour(colour) => colour.to_hex().trim_start_matches('#').to_owned(),
    }
}
