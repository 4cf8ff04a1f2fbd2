//! Commands that pose a node whatever its place: reset, mirror, copy and paste, poses with names.

use std::sync::Arc;

use super::line::{ArgumentError, Arguments, Ending, Line};
use super::row::{Binding, Changes, Group, Menu, Row};
use super::values::{name_text, quoted, rbt_path_text, read_quoted};
use crate::editor::{ClipboardCommand, Command, Edit, Editor, FileCommand, NodeEdit, NodePart};
use crate::pose::RbtIndex;
use crate::pose_file::{PoseFile, shipped_pose};
use crate::scene::SceneGraph;
use crate::words::texts;

fn binding(id: &'static str, command: Command, keys: &[&str]) -> Binding {
    Binding::new(Group::View, id, command).menu(Menu::Edit).section(6).hotkeys(keys)
}

const fn of_chosen(edit: NodeEdit) -> Command {
    Command::Edit(Edit::Nodes(edit, None))
}

/// Whether a command has nodes to act on.
fn has_nodes(editor: &Editor, command: &Command) -> bool {
    let is_named = matches!(
        command,
        Command::Edit(Edit::Nodes(_, Some(_))) | Command::Clipboard(ClipboardCommand::CopyPose(Some(_)))
    );
    is_named || !editor.session.chosen.is_empty()
}

/// The node whose path the text is; `Some(None)` for no text.
pub(super) fn node(arguments: &Arguments<'_>, path: &str) -> Result<Option<RbtIndex>, ArgumentError> {
    if path.is_empty() { Ok(None) } else { arguments.rbt(path).map(Some) }
}

/// A path, or nothing for the chosen nodes. A path that is one of the words that may stand before it needs quotes.
pub(super) fn node_text(node: Option<RbtIndex>, scene: &SceneGraph, words: &[&str]) -> Option<String> {
    let Some(rbt) = node else { return Some(String::new()) };
    let path = rbt_path_text(rbt, scene)?;
    let is_word = path.split(' ').next().is_some_and(|first| words.contains(&first));
    Some(if is_word { serde_json::Value::from(scene.rbt_path(rbt)).to_string() } else { path })
}

fn joined(word: &str, node: &str) -> String {
    [word, node].iter().filter(|part| !part.is_empty()).copied().collect::<Vec<_>>().join(" ")
}

const PARTS: [(NodePart, &str); 3] =
    [(NodePart::Both, ""), (NodePart::Translation, "translation"), (NodePart::Rotation, "rotation")];
const MIRRORED: &str = "mirrored";

pub(super) fn rows() -> Vec<Row> {
    [vec![copy(), paste(), mirror(), reset()], named()].concat()
}

fn copy() -> Row {
    let copied = |node| Command::Clipboard(ClipboardCommand::CopyPose(node));
    Row::of(Changes::Session, "pose-copy", |command| {
        matches!(command, Command::Clipboard(ClipboardCommand::CopyPose(_)))
    })
    .binding(binding("pose-copy", copied(None), &["Ctrl+Shift+C"]))
    .can(has_nodes)
    .line(
        Line::new(
            "copy-pose [PATH]",
            "copies what is on screen of a node and all below it; without a path, of the chosen node",
            |arguments| Ok(Some(Command::Clipboard(ClipboardCommand::CopyPose(node(arguments, arguments.text)?)))),
            |command, scene| {
                let Command::Clipboard(ClipboardCommand::CopyPose(node)) = command else { return None };
                node_text(*node, scene, &[])
            },
        )
        .ending(Ending::NodePath),
    )
}

fn paste() -> Row {
    let pasted = |is_mirrored| of_chosen(NodeEdit::Paste { is_mirrored });
    Row::of(Changes::Document, "pose-paste", |command| {
        matches!(command, Command::Edit(Edit::Nodes(NodeEdit::Paste { .. }, _)))
    })
    .refused(texts::ACT_MOVE_A_NODE)
    .binding(binding("pose-paste", pasted(false), &["Ctrl+Shift+V"]))
    .binding(binding("pose-paste-mirrored", pasted(true), &["Ctrl+Shift+M"]))
    .can(|editor, command| editor.has_copied_pose() && has_nodes(editor, command))
    .line(
        Line::new(
            "paste-pose [mirrored] [PATH]",
            "gives the copied pose, or its mirror image, to a node, of the other robot, say; without a path, to each chosen node",
            |arguments| {
                let rest = arguments.text.strip_prefix(MIRRORED).filter(|rest| rest.is_empty() || rest.starts_with(' '));
                let path = rest.map_or(arguments.text, str::trim_start);
                let edit = NodeEdit::Paste { is_mirrored: rest.is_some() };
                Ok(Some(Command::Edit(Edit::Nodes(edit, node(arguments, path)?))))
            },
            |command, scene| {
                let Command::Edit(Edit::Nodes(NodeEdit::Paste { is_mirrored }, node)) = command else { return None };
                Some(joined(if *is_mirrored { MIRRORED } else { "" }, &node_text(*node, scene, &[MIRRORED])?))
            },
        )
        .ending(Ending::NodePath),
    )
}

fn mirror() -> Row {
    Row::of(Changes::Document, "pose-mirror", |command| {
        matches!(command, Command::Edit(Edit::Nodes(NodeEdit::Mirror, _)))
    })
    .refused(texts::ACT_MOVE_A_NODE)
    .binding(binding("pose-mirror", of_chosen(NodeEdit::Mirror), &["Ctrl+M"]))
    .can(has_nodes)
    .line(
        Line::new(
            "mirror [PATH]",
            "gives the other side the mirror image of a node and all below it; a node in the middle swaps its sides; without a path, of the chosen nodes",
            |arguments| Ok(Some(Command::Edit(Edit::Nodes(NodeEdit::Mirror, node(arguments, arguments.text)?)))),
            |command, scene| {
                let Command::Edit(Edit::Nodes(NodeEdit::Mirror, node)) = command else { return None };
                node_text(*node, scene, &[])
            },
        )
        .ending(Ending::NodePath),
    )
}

fn reset() -> Row {
    let part = |id, part, keys: &[&str]| binding(id, of_chosen(NodeEdit::Reset(part)), keys);
    Row::of(Changes::Document, "node-reset", |command| {
        matches!(command, Command::Edit(Edit::Nodes(NodeEdit::Reset(_), _)))
    })
    .refused(texts::ACT_MOVE_A_NODE)
    .binding(part("node-reset", NodePart::Both, &[]))
    .binding(part("node-reset-rotation", NodePart::Rotation, &["Alt+R"]))
    .binding(part("node-reset-translation", NodePart::Translation, &["Alt+G"]))
    .can(has_nodes)
    .line(
        Line::new(
            "reset-node [translation|rotation] [PATH]",
            "returns a node to rest, and nothing below it; without a path, the chosen nodes",
            |arguments| {
                let (word, rest) = arguments.text.split_once(' ').unwrap_or((arguments.text, ""));
                let named = PARTS.into_iter().find(|(_, name)| !name.is_empty() && *name == word);
                let (part, path) =
                    named.map_or((NodePart::Both, arguments.text), |(part, _)| (part, rest.trim_start()));
                Ok(Some(Command::Edit(Edit::Nodes(NodeEdit::Reset(part), node(arguments, path)?))))
            },
            |command, scene| {
                let Command::Edit(Edit::Nodes(NodeEdit::Reset(part), node)) = command else { return None };
                let (_, word) = PARTS.into_iter().find(|(other, _)| other == part)?;
                Some(joined(word, &node_text(*node, scene, &[PARTS[1].1, PARTS[2].1])?))
            },
        )
        .ending(Ending::NodePath),
    )
}

/// Poses with names. Two commands share the line `pose`.
fn named() -> Vec<Row> {
    let line = Line::new(
        "pose apply|save NAME|FILE",
        "gives a pose to the chosen nodes, or saves that of the chosen node or of the scene; a text with `/` or ending in `.json` is a file, any other a name",
        |arguments| {
            let Some(([word], name)) = arguments.then_text() else { return Ok(None) };
            let name = read_quoted(name).unwrap_or_else(|| name.to_owned());
            Ok(match word {
                "apply" => Some(match shipped_pose(&name) {
                    Some(shipped) => Command::Edit(Edit::Pose(Arc::new(shipped.clone()))),
                    None => Command::File(FileCommand::ApplyPose(name)),
                }),
                "save" => Some(Command::File(FileCommand::SavePose(name))),
                _ => None,
            })
        },
        |command, _| match command {
            Command::File(FileCommand::ApplyPose(name)) if shipped_pose(name).is_none() && !name.is_empty() => {
                Some(format!("apply {}", name_text(name)))
            }
            Command::File(FileCommand::SavePose(name)) if !name.is_empty() => Some(format!("save {}", name_text(name))),
            Command::Edit(Edit::Pose(pose)) if shipped_pose(&pose.name) == Some(&**pose) => {
                Some(format!("apply {}", name_text(&pose.name)))
            }
            _ => None,
        },
    )
    .ending(Ending::Name);
    vec![
        Row::of(Changes::Files, "pose-apply", |command| matches!(command, Command::File(FileCommand::ApplyPose(_))))
            .refused(texts::ACT_MOVE_A_NODE)
            .line(line.clone()),
        Row::of(Changes::Files, "pose-save", |command| matches!(command, Command::File(FileCommand::SavePose(_))))
            .line(line.clone()),
        Row::of(Changes::Document, "pose-give", |command| matches!(command, Command::Edit(Edit::Pose(_))))
            .refused(texts::ACT_MOVE_A_NODE)
            .line(line)
            .line(
                Line::new(
                    "pose-of JSON",
                    "gives the pose that the text of a pose's file in double quotes holds to the chosen nodes",
                    |arguments| {
                        let Some(text) = read_quoted(arguments.text) else { return Ok(None) };
                        let pose = PoseFile::from_json(text.as_bytes());
                        Ok(pose.ok().map(|pose| Command::Edit(Edit::Pose(Arc::new(pose)))))
                    },
                    |command, _| {
                        let Command::Edit(Edit::Pose(pose)) = command else { return None };
                        Some(quoted(&pose.to_json()))
                    },
                )
                .ending(Ending::Name),
            ),
    ]
}
