//! Lines that stand in journals: they put an editor in a state without reading a file.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde_json::{Map, Value};

use super::problem::LineProblem;
use crate::editor::commands::tokens;
use crate::editor::{Editor, Snapshot};
use crate::scene::{SceneGraph, built_in_scene, built_in_scene_names, scene_from_json, scene_to_json};

/// What a line of a journal restores.
#[derive(Clone, Debug, PartialEq)]
pub enum Restore {
    /// A new editor of a scene, which has no keyframes.
    Scene {
        /// The scene.
        scene: Arc<SceneGraph>,
        /// Its file, where it has one.
        path: Option<PathBuf>,
    },
    /// Which file the keyframes are written to.
    KeyframeFile(PathBuf),
    /// An import of this text, as if it had been read from a file.
    Imported {
        /// The file that it was read from.
        path: PathBuf,
        /// What the file held.
        bytes: Arc<[u8]>,
    },
    /// A scene of this text, as if it had been read from a file again.
    ImportedScene {
        /// The file that it was read from.
        path: PathBuf,
        /// What the file held.
        bytes: Arc<[u8]>,
    },
    /// A document and what is kept beside it; there is nothing to undo.
    Snapshot(Box<Snapshot>),
    /// The document that undo or redo led to, where the journal does not hold the steps that do.
    Document(Box<Snapshot>),
    /// What is now is the ground of undo.
    Ground,
}

/// The first words of these lines.
const NAMES: [&str; 7] = ["scene", "keyframe-file", "imported", "imported-scene", "snapshot", "document", "ground"];

/// Whether a line's first word is one of these.
pub(super) fn is_restore(name: &str) -> bool {
    NAMES.contains(&name)
}

/// Where the line's words end and a comment may begin, in bytes.
pub(super) fn end(line: &str) -> usize {
    tokens(line).1
}

/// What a line means, without its comment; `None`: it is not written like this.
pub(super) fn read(text: &str) -> Result<Option<Restore>, LineProblem> {
    let (words, _) = tokens(text);
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    Ok(match *words {
        ["scene", scene] => Some(Restore::Scene { scene: read_scene(scene)?, path: None }),
        ["scene", scene, path] => Some(Restore::Scene { scene: read_scene(scene)?, path: Some(path.into()) }),
        ["keyframe-file", path] => Some(Restore::KeyframeFile(path.into())),
        [name @ ("imported" | "imported-scene"), path, held] => Some(imported(name, path, held.as_bytes().into())),
        [name @ ("imported" | "imported-scene"), path, "hex", digits] => {
            bytes_of_hex(digits).map(|bytes| imported(name, path, bytes.into()))
        }
        ["document", text] => read_snapshot(text)?.map(|snapshot| Restore::Document(Box::new(snapshot))),
        ["ground"] => Some(Restore::Ground),
        ["snapshot", text] => read_snapshot(text)?.map(|snapshot| Restore::Snapshot(Box::new(snapshot))),
        _ => None,
    })
}

fn imported(name: &str, path: &str, bytes: Arc<[u8]>) -> Restore {
    let path = path.into();
    if name == "imported" { Restore::Imported { path, bytes } } else { Restore::ImportedScene { path, bytes } }
}

fn read_scene(text: &str) -> Result<Arc<SceneGraph>, LineProblem> {
    if let Some(scene) = built_in_scene(text) {
        return Ok(Arc::new(scene));
    }
    scene_from_json(text).map(Arc::new).map_err(|error| LineProblem::Scene { reason: error.to_string() })
}

impl Restore {
    /// The line; `None` where a path is not Unicode.
    #[must_use]
    pub fn line(&self) -> Option<String> {
        Some(match self {
            Self::Scene { scene, path: None } => format!("scene {}", scene_word(scene)),
            Self::Scene { scene, path: Some(path) } => {
                format!("scene {} {}", scene_word(scene), quoted(path.to_str()?))
            }
            Self::KeyframeFile(path) => format!("keyframe-file {}", quoted(path.to_str()?)),
            Self::Imported { path, bytes } => imported_line(false, path, bytes)?,
            Self::ImportedScene { path, bytes } => imported_line(true, path, bytes)?,
            Self::Document(snapshot) => format!("document {}", quoted(&snapshot_text(snapshot)?)),
            Self::Ground => "ground".to_owned(),
            Self::Snapshot(snapshot) => format!("snapshot {}", quoted(&snapshot_text(snapshot)?)),
        })
    }

    /// Does what the line says.
    pub fn apply(&self, editor: &mut Editor) {
        match self {
            Self::Scene { scene, path } => {
                let new = Editor::new(Arc::clone(scene), editor.keyframe_file().to_owned());
                *editor = match path {
                    Some(path) => new.with_scene_path(path.clone()),
                    None => new,
                };
            }
            Self::KeyframeFile(path) => editor.set_path(path.clone()),
            Self::Imported { path, bytes } => {
                // What is wrong with it is the editor's message, as it was when the file was read.
                let _ = editor.keyframes_read(path, Ok(bytes.to_vec()));
            }
            Self::ImportedScene { path, bytes } => {
                let _ = editor.scene_read(path, Ok(bytes.to_vec()));
            }
            Self::Document(snapshot) => editor.jump_to(snapshot),
            Self::Ground => editor.begin_history(),
            Self::Snapshot(snapshot) => *editor = Editor::of_snapshot(snapshot),
        }
    }
}

/// The line of an import, of keyframes or of a scene; `None` where the path is not Unicode.
#[must_use]
pub fn imported_line(is_scene: bool, path: &Path, bytes: &[u8]) -> Option<String> {
    let name = if is_scene { "imported-scene" } else { "imported" };
    let path = quoted(path.to_str()?);
    if let Ok(text) = std::str::from_utf8(bytes) {
        return Some(format!("{name} {path} {}", quoted(text)));
    }
    let mut line = format!("{name} {path} hex ");
    for byte in bytes {
        let _ = write!(line, "{byte:02x}");
    }
    Some(line)
}

fn bytes_of_hex(digits: &str) -> Option<Vec<u8>> {
    let pairs = digits.as_bytes().chunks(2);
    pairs.map(|pair| u8::from_str_radix(std::str::from_utf8(pair).ok()?, 16).ok().filter(|_| pair.len() == 2)).collect()
}

/// The scene's name where it is built in, otherwise its text.
fn scene_word(scene: &SceneGraph) -> String {
    let is_this = |name: &&str| built_in_scene(name).as_ref() == Some(scene);
    match built_in_scene_names().find(is_this) {
        Some(name) => name.to_owned(),
        None => quoted(&scene_to_json(scene)),
    }
}

fn quoted(text: &str) -> String {
    Value::from(text).to_string()
}

fn snapshot_text(snapshot: &Snapshot) -> Option<String> {
    let path = |path: &Path| path.to_str().map(Value::from);
    let mut object = Map::new();
    object.insert("path".into(), path(&snapshot.path)?);
    if let Some(scene_path) = &snapshot.scene_path {
        object.insert("scene_path".into(), path(scene_path)?);
    }
    object.insert("scene".into(), scene_to_json(&snapshot.scene).into());
    object.insert("keyframes".into(), snapshot.keyframes.clone().into());
    object.insert("current".into(), snapshot.current.into());
    object.insert("pose".into(), pose_value(&snapshot.pose));
    object.insert("has_unsaved_keyframes".into(), snapshot.has_unsaved_keyframes.into());
    object.insert("saved_scene".into(), snapshot.saved_scene.as_deref().map(scene_to_json).into());
    object.insert("is_file_known".into(), snapshot.is_file_known.into());
    object.insert("copied".into(), snapshot.copied.clone().into());
    if let Some((node, pose)) = &snapshot.copied_pose {
        object.insert("copied_node".into(), (*node).into());
        object.insert("copied_pose".into(), pose_value(pose));
    }
    object.insert("seconds".into(), snapshot.seconds.0.into());
    object.insert("ticks".into(), snapshot.seconds.1.into());
    object.insert("holds_seconds".into(), snapshot.holds_seconds.into());
    object.insert("is_scrubbed_in_seconds".into(), snapshot.is_scrubbed_in_seconds.into());
    Some(Value::from(object).to_string())
}

fn pose_value(pose: &[[f32; 7]]) -> Value {
    pose.iter().map(|numbers| Value::from(numbers.to_vec())).collect()
}

fn read_snapshot(text: &str) -> Result<Option<Snapshot>, LineProblem> {
    let Ok(object) = serde_json::from_str::<Value>(text) else { return Ok(None) };
    let string = |name: &str| object.get(name).and_then(Value::as_str);
    let index = |name: &str| usize::try_from(object.get(name)?.as_u64()?).ok();
    let flag = |name: &str| object.get(name).and_then(Value::as_bool).unwrap_or_default();
    let (Some(path), Some(scene), Some(keyframes)) = (string("path"), string("scene"), string("keyframes")) else {
        return Ok(None);
    };
    let snapshot = Snapshot {
        path: path.into(),
        scene_path: string("scene_path").map(PathBuf::from),
        scene: read_scene(scene)?,
        keyframes: keyframes.to_owned(),
        current: index("current"),
        pose: object.get("pose").and_then(pose).unwrap_or_default(),
        has_unsaved_keyframes: flag("has_unsaved_keyframes"),
        saved_scene: string("saved_scene").map(read_scene).transpose()?,
        is_file_known: flag("is_file_known"),
        copied: string("copied").map(str::to_owned),
        copied_pose: index("copied_node").zip(object.get("copied_pose").and_then(pose)),
        seconds: (
            object.get("seconds").and_then(Value::as_f64).unwrap_or_default(),
            object.get("ticks").and_then(Value::as_u64).unwrap_or_default(),
        ),
        holds_seconds: flag("holds_seconds"),
        is_scrubbed_in_seconds: flag("is_scrubbed_in_seconds"),
    };
    Ok(snapshot.is_whole().then_some(snapshot))
}

fn pose(value: &Value) -> Option<Vec<[f32; 7]>> {
    #[expect(clippy::cast_possible_truncation, reason = "each is an f32 that was widened")]
    let numbers = |rbt: &Value| {
        let numbers: Option<Vec<f32>> = rbt.as_array()?.iter().map(|number| Some(number.as_f64()? as f32)).collect();
        <[f32; 7]>::try_from(numbers?).ok()
    };
    value.as_array()?.iter().map(numbers).collect()
}
