//! The strict reader of keyframe files: it defines the format and reports every error.

use std::collections::HashMap;
use std::sync::Arc;

use glam::{Quat, Vec3};
use serde::de::{SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::problems::{KeyframeFileError, Problems};
use super::{FORMAT, KeyframeFile, VERSIONS, too_large};
use crate::decode;
use crate::interpolation::Interpolation;
use crate::keyframe::MS_BETWEEN_KEYFRAMES_RANGE;
use crate::keyframe::easing::Easing;
use crate::keyframe::list::{DURATION_RANGE, Keyframe};
use crate::pose::Pose;
use crate::rbt::Rbt;
use crate::rotation_rules::Mending;
use crate::scene::SceneGraph;

/// The JSON object of a keyframe file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FileText {
    pub format: String,
    pub version: u64,
    #[serde(rename = "scene")]
    _scene: String,
    interpolation: Option<String>,
    ms_between_keyframes: Option<f64>,
    pub nodes: Vec<String>,
    keyframes: Vec<KeyframeText>,
}

/// The fields that identify the kind and the version of a file, also if the rest is not valid.
#[derive(Deserialize)]
struct HeaderText {
    format: String,
    version: u64,
}

/// The JSON object of a keyframe.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct KeyframeText {
    name: Option<String>,
    duration: Option<f64>,
    easing: Option<String>,
    pose: PoseText,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RbtText {
    translation: [f32; 3],
    rotation: [f32; 4],
}

/// A pose in the file's order, in its final storage: no data of the size of the file is held twice.
struct PoseText(Arc<[Rbt]>);

impl<'de> Deserialize<'de> for PoseText {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct PoseVisitor;

        impl<'de> Visitor<'de> for PoseVisitor {
            type Value = PoseText;

            fn expecting(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                formatter.write_str("decode.kind.pose")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut entries: A) -> Result<PoseText, A::Error> {
                let mut pose = Vec::new();
                while let Some(RbtText { translation, rotation }) = entries.next_element()? {
                    pose.push(Rbt::new(Vec3::from(translation), Quat::from_array(rotation)));
                }
                Ok(PoseText(pose.into()))
            }
        }

        deserializer.deserialize_seq(PoseVisitor)
    }
}

/// Reads a keyframe file for a scene.
///
/// # Errors
/// All errors with their locations, in file order; never empty.
pub fn read(bytes: &[u8], scene: &SceneGraph) -> Result<KeyframeFile, Vec<KeyframeFileError>> {
    let text: FileText = match decode::json(bytes) {
        Ok(text) => text,
        Err(error) => {
            let header: Option<HeaderText> = serde_json::from_slice(bytes).ok();
            if let Some(problem) = header.and_then(|header| header_problem(&header.format, header.version)) {
                return Err(vec![problem]);
            }
            let too_large = too_large::numbers_too_large(bytes);
            return Err(if too_large.is_empty() { vec![KeyframeFileError::Json(error)] } else { too_large });
        }
    };
    if let Some(problem) = header_problem(&text.format, text.version) {
        return Err(vec![problem]);
    }
    let mut problems = Problems::default();
    let Head { interpolation, ms_between_keyframes, index_in_file } = head_of(&text, scene, &mut problems);
    let keyframes: Vec<Keyframe> = text
        .keyframes
        .into_iter()
        .enumerate()
        .filter_map(|(keyframe, text_of_keyframe)| {
            let extras = extras_of(&text_of_keyframe, keyframe, text.version, &mut problems);
            let PoseText(mut pose) = text_of_keyframe.pose;
            if pose.len() != text.nodes.len() {
                let (found, expected) = (pose.len(), text.nodes.len());
                problems.push(KeyframeFileError::PoseLength { keyframe, found, expected });
                return None;
            }
            for (rbt, path) in Arc::get_mut(&mut pose)?.iter_mut().zip(&text.nodes) {
                if let Some(problem) = mend(rbt, keyframe, path) {
                    problems.push(problem);
                }
            }
            Some(Keyframe { pose: in_scene_order(pose, index_in_file.as_deref()?), ..extras })
        })
        .collect();
    problems.into_result(KeyframeFile { interpolation, ms_between_keyframes, keyframes })
}

/// The fields of a file besides its keyframes.
pub struct Head {
    pub interpolation: Option<Interpolation>,
    pub ms_between_keyframes: Option<u32>,
    /// For each RBT node of the scene, its index in `nodes`; `None` if they do not match.
    pub index_in_file: Option<Vec<usize>>,
}

/// The fields of a file besides its keyframes. Errors are added to `problems`.
pub fn head_of(text: &FileText, scene: &SceneGraph, problems: &mut Problems) -> Head {
    let interpolation = text.interpolation.as_ref().and_then(|name| {
        let known = Interpolation::from_name(name);
        if known.is_none() {
            problems.push(KeyframeFileError::Interpolation { found: name.clone() });
        }
        known
    });
    let ms_between_keyframes = text.ms_between_keyframes.and_then(|found| {
        let whole = MS_BETWEEN_KEYFRAMES_RANGE.clone().find(|&ms| f64::from(ms) == found);
        if whole.is_none() {
            problems.push(KeyframeFileError::MsBetweenKeyframes { found });
        }
        whole
    });
    Head { interpolation, ms_between_keyframes, index_in_file: match_nodes(&text.nodes, scene, problems) }
}

/// A keyframe's name, duration and easing, with no pose yet. Errors are added to `problems`.
pub fn extras_of(text: &KeyframeText, keyframe: usize, version: u64, problems: &mut Problems) -> Keyframe {
    let mut extras = Keyframe::new(Pose::new(Vec::new()));
    let given =
        [("name", text.name.is_some()), ("duration", text.duration.is_some()), ("easing", text.easing.is_some())];
    if let Some((field, _)) = given.into_iter().find(|&(_, is_given)| is_given && version < 2) {
        problems.push(KeyframeFileError::NeedsVersion2 { keyframe, field });
    }
    extras.name = text.name.as_deref().filter(|name| !name.is_empty()).map(Arc::from);
    if let Some(found) = text.duration {
        if DURATION_RANGE.contains(&found) {
            extras.duration = found;
        } else {
            problems.push(KeyframeFileError::Duration { keyframe, found });
        }
    }
    if let Some(found) = &text.easing {
        match Easing::from_name(found) {
            Some(easing) => extras.easing = easing,
            None => problems.push(KeyframeFileError::Easing { keyframe, found: found.clone() }),
        }
    }
    extras
}

/// The error for another kind of file or an unknown version.
pub fn header_problem(format: &str, version: u64) -> Option<KeyframeFileError> {
    if format != FORMAT {
        Some(KeyframeFileError::Format { found: format.to_owned() })
    } else if !VERSIONS.contains(&version) {
        Some(KeyframeFileError::Version { found: version })
    } else {
        None
    }
}

/// For each RBT node of the scene, its index in `nodes`; `None` if they do not match.
fn match_nodes(nodes: &[String], scene: &SceneGraph, problems: &mut Problems) -> Option<Vec<usize>> {
    let mut index_of: HashMap<&str, usize> = HashMap::with_capacity(nodes.len());
    let problems_before = problems.count();
    for (index, path) in nodes.iter().enumerate() {
        if index_of.insert(path, index).is_some() {
            problems.push(KeyframeFileError::DuplicateNode { path: path.clone() });
        } else if scene.find_rbt(path).is_none() {
            problems.push(KeyframeFileError::ExtraNode { path: path.clone(), scene: scene.name().to_owned() });
        }
    }
    let indices: Vec<usize> = scene
        .rbt_paths()
        .filter_map(|path| {
            let index = index_of.get(path).copied();
            if index.is_none() {
                problems.push(KeyframeFileError::MissingNode { path: path.to_owned(), scene: scene.name().to_owned() });
            }
            index
        })
        .collect();
    (problems.count() == problems_before).then_some(indices)
}

fn in_scene_order(pose: Arc<[Rbt]>, index_in_file: &[usize]) -> Pose {
    if index_in_file.iter().enumerate().all(|(index, &in_file)| index == in_file) {
        Pose::from_slice(&pose)
    } else {
        Pose::new(index_in_file.iter().map(|&index| pose[index]).collect())
    }
}

/// Normalises a rotation that is slightly off unit length; returns the error for one that is far off, and for a translation out of bounds.
pub fn mend(rbt: &mut Rbt, keyframe: usize, path: &str) -> Option<KeyframeFileError> {
    if !rbt.is_in_bounds() {
        return Some(KeyframeFileError::TooFar { keyframe, path: path.to_owned() });
    }
    if !rbt.rotation.is_finite() {
        return Some(KeyframeFileError::NotFinite { keyframe, path: path.to_owned() });
    }
    let exact = rbt.rotation.as_dquat();
    match Mending::of_length(exact.length()) {
        Mending::Keep => {}
        Mending::Normalise => rbt.rotation = exact.normalize().as_quat(),
        Mending::Refuse => {
            #[expect(clippy::cast_possible_truncation, reason = "it is for a message")]
            let length = exact.length() as f32;
            return Some(KeyframeFileError::NotUnit { keyframe, path: path.to_owned(), length });
        }
    }
    None
}
