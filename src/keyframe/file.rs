//! The keyframe file: JSON text to a list and back, to the byte.

mod too_large;

use std::collections::HashMap;
use std::fmt::{self, Write as _};
use std::sync::Arc;

use glam::{Quat, Vec3};
use serde::de::{SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};
use thiserror::Error;

use super::easing::Easing;
use super::list::{DURATION_RANGE, Keyframe, KeyframeList};
use super::{DEFAULT_MS_BETWEEN_KEYFRAMES, MS_BETWEEN_KEYFRAMES_RANGE};
use crate::interpolation::Interpolation;
use crate::json::push_rbt;
use crate::pose::Pose;
use crate::rbt::Rbt;
use crate::scene::SceneGraph;

/// The largest keyframe file that is read: 1 GiB.
pub const LARGEST_FILE_BYTES: u64 = 1 << 30;

const FORMAT: &str = "inbetween.keyframes";
/// What a file says whose keyframes are poses and nothing else, and what one says that has names, durations or easings.
const VERSIONS: std::ops::RangeInclusive<u64> = 1..=2;
/// Rotations this near to unit length are kept bit for bit.
const UNIT_TOLERANCE: f64 = 1e-6;
/// Rotations this near to unit length are normalised; beyond, they are errors.
const NORMALISED_TOLERANCE: f64 = 0.01;
/// A file can be wrong in each of its numbers: after so many problems the rest are only counted.
const MOST_PROBLEMS: usize = 100;

/// What a keyframe file holds. `None` where it does not say.
#[derive(Clone, Debug, PartialEq)]
pub struct KeyframeFile {
    /// The interpolation to put in force.
    pub interpolation: Option<Interpolation>,
    /// The milliseconds between keyframes to put in force.
    pub ms_between_keyframes: Option<u32>,
    /// The keyframes, their poses in the scene's order.
    pub keyframes: Vec<Keyframe>,
}

impl KeyframeFile {
    /// The list, the interpolation and the milliseconds between keyframes, with defaults where the file does not say.
    #[must_use]
    pub fn into_parts(self) -> (KeyframeList, Interpolation, u32) {
        (
            KeyframeList::new(self.keyframes),
            self.interpolation.unwrap_or_default(),
            self.ms_between_keyframes.unwrap_or(DEFAULT_MS_BETWEEN_KEYFRAMES),
        )
    }
}

/// One thing that is wrong with a keyframe file: a sentence with its place.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum KeyframeFileError {
    /// Not JSON of the right shape; the message ends with line and column.
    #[error("{message}")]
    Json {
        /// What is wrong, with line and column.
        message: String,
    },
    /// `format` names something else.
    #[error("format is {found:?}, expected \"inbetween.keyframes\"")]
    Format {
        /// What the file says.
        found: String,
    },
    /// `version` is not one that this program reads.
    #[error("version is {found}, and this program reads versions 1 and 2")]
    Version {
        /// What the file says.
        found: u64,
    },
    /// `interpolation` is unknown.
    #[error("interpolation is {found:?}, expected \"linear\" or \"catmull-rom\"")]
    Interpolation {
        /// What the file says.
        found: String,
    },
    /// `ms_between_keyframes` is out of range.
    #[error("ms_between_keyframes is {found}, expected a whole number from 100 to 10000")]
    MsBetweenKeyframes {
        /// What the file says.
        found: f64,
    },
    /// The scene has no such RBT node.
    #[error("node {path:?} is not in the scene {scene:?}")]
    ExtraNode {
        /// The path.
        path: String,
        /// The scene's name.
        scene: String,
    },
    /// An RBT node of the scene is not in `nodes`.
    #[error("node {path:?} of the scene {scene:?} is missing in nodes")]
    MissingNode {
        /// The path.
        path: String,
        /// The scene's name.
        scene: String,
    },
    /// A path stands twice.
    #[error("node {path:?} stands twice in nodes")]
    DuplicateNode {
        /// The path.
        path: String,
    },
    /// A pose and `nodes` are not of one length.
    #[error("keyframe {keyframe}: pose has {found} entries, expected {expected}, one for each of nodes")]
    PoseLength {
        /// The keyframe, from 0.
        keyframe: usize,
        /// How many entries there are.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// A number cannot be held.
    #[error("keyframe {keyframe}, node {path:?}: {field} is not finite")]
    NotFinite {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The node's path.
        path: String,
        /// `translation` or `rotation`.
        field: &'static str,
    },
    /// A rotation is not a unit quaternion.
    #[error("keyframe {keyframe}, node {path:?}: rotation has length {length}, expected 1")]
    NotUnit {
        /// The keyframe, from 0.
        keyframe: usize,
        /// The node's path.
        path: String,
        /// The rotation's length.
        length: f32,
    },
    /// A field of version 2 in a file of version 1.
    #[error("keyframe {keyframe}: {field} needs version 2, and the file says version 1")]
    NeedsVersion2 {
        /// The keyframe, from 0.
        keyframe: usize,
        /// Which field.
        field: &'static str,
    },
    /// A keyframe's interval is of no length that can play.
    #[error("keyframe {keyframe}: duration is {found}, expected a number from 0.001 to 1000")]
    Duration {
        /// The keyframe, from 0.
        keyframe: usize,
        /// What the file says.
        found: f64,
    },
    /// A keyframe's easing is unknown.
    #[error(
        "keyframe {keyframe}: easing is {found:?}, expected linear, hold, or sine, quad, cubic, back, bounce or elastic with -in, -out or -in-out"
    )]
    Easing {
        /// The keyframe, from 0.
        keyframe: usize,
        /// What the file says.
        found: String,
    },
    /// More is wrong than is worth saying.
    #[error("and {more} more problems")]
    More {
        /// How many more.
        more: usize,
    },
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FileText {
    format: String,
    version: u64,
    #[serde(rename = "scene")]
    _scene: String,
    interpolation: Option<String>,
    ms_between_keyframes: Option<f64>,
    nodes: Vec<String>,
    keyframes: Vec<KeyframeText>,
}

/// What tells another kind of file, or a later version of this one, from a broken file.
#[derive(Deserialize)]
struct HeaderText {
    format: String,
    version: u64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct KeyframeText {
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

/// A pose in the file's order, in its final storage: nothing of the size of the file is held twice.
struct PoseText(Arc<[Rbt]>);

impl<'de> Deserialize<'de> for PoseText {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct PoseVisitor;

        impl<'de> Visitor<'de> for PoseVisitor {
            type Value = PoseText;

            fn expecting(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                formatter.write_str("an array of translations and rotations")
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

/// Reads a keyframe file for a scene. A byte order mark is passed over.
///
/// # Errors
/// Everything that is wrong, each with its place, in the file's order: never empty.
pub fn keyframes_from_json(bytes: &[u8], scene: &SceneGraph) -> Result<KeyframeFile, Vec<KeyframeFileError>> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let text: FileText = match serde_json::from_slice(bytes) {
        Ok(text) => text,
        Err(error) => {
            let header: Option<HeaderText> = serde_json::from_slice(bytes).ok();
            if let Some(problem) = header.and_then(|header| header_problem(&header.format, header.version)) {
                return Err(vec![problem]);
            }
            let too_large = too_large::numbers_too_large(bytes);
            return Err(if too_large.is_empty() {
                vec![KeyframeFileError::Json { message: crate::json::sentence(&error) }]
            } else {
                too_large
            });
        }
    };
    if let Some(problem) = header_problem(&text.format, text.version) {
        return Err(vec![problem]);
    }
    let mut problems = Problems::default();
    let interpolation = text.interpolation.and_then(|name| {
        let known = Interpolation::from_name(&name);
        if known.is_none() {
            problems.push(KeyframeFileError::Interpolation { found: name });
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
    let place_in_file = match_nodes(&text.nodes, scene, &mut problems);
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
                if let Some(problem) = mend_rotation(rbt, keyframe, path) {
                    problems.push(problem);
                }
            }
            Some(Keyframe { pose: in_scene_order(pose, place_in_file.as_deref()?), ..extras })
        })
        .collect();
    problems.into_result(KeyframeFile { interpolation, ms_between_keyframes, keyframes })
}

/// The problems found so far, the first of them in words and the rest as a number.
#[derive(Default)]
struct Problems {
    said: Vec<KeyframeFileError>,
    more: usize,
}

impl Problems {
    fn push(&mut self, problem: KeyframeFileError) {
        if self.said.len() < MOST_PROBLEMS {
            self.said.push(problem);
        } else {
            self.more += 1;
        }
    }

    fn into_result<T>(mut self, value: T) -> Result<T, Vec<KeyframeFileError>> {
        if self.more > 0 {
            self.said.push(KeyframeFileError::More { more: self.more });
        }
        if self.said.is_empty() { Ok(value) } else { Err(self.said) }
    }
}

/// A keyframe's name, duration and easing, with no pose yet; what is wrong with them goes to the problems.
fn extras_of(text: &KeyframeText, keyframe: usize, version: u64, problems: &mut Problems) -> Keyframe {
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

fn header_problem(format: &str, version: u64) -> Option<KeyframeFileError> {
    if format != FORMAT {
        Some(KeyframeFileError::Format { found: format.to_owned() })
    } else if !VERSIONS.contains(&version) {
        Some(KeyframeFileError::Version { found: version })
    } else {
        None
    }
}

/// For each RBT node of the scene, its place in `nodes`; `None` where they do not match.
fn match_nodes(nodes: &[String], scene: &SceneGraph, problems: &mut Problems) -> Option<Vec<usize>> {
    let mut place_of: HashMap<&str, usize> = HashMap::with_capacity(nodes.len());
    let problems_before = problems.said.len();
    for (place, path) in nodes.iter().enumerate() {
        if place_of.insert(path, place).is_some() {
            problems.push(KeyframeFileError::DuplicateNode { path: path.clone() });
        } else if scene.find_rbt(path).is_none() {
            problems.push(KeyframeFileError::ExtraNode { path: path.clone(), scene: scene.name().to_owned() });
        }
    }
    let places: Vec<usize> = scene
        .rbt_paths()
        .filter_map(|path| {
            let place = place_of.get(path).copied();
            if place.is_none() {
                problems.push(KeyframeFileError::MissingNode { path: path.to_owned(), scene: scene.name().to_owned() });
            }
            place
        })
        .collect();
    (problems.said.len() == problems_before).then_some(places)
}

fn in_scene_order(pose: Arc<[Rbt]>, place_in_file: &[usize]) -> Pose {
    if place_in_file.iter().enumerate().all(|(place, &in_file)| place == in_file) {
        Pose::from_slice(&pose)
    } else {
        Pose::new(place_in_file.iter().map(|&place| pose[place]).collect())
    }
}

/// Normalises a rotation that is a little off; says what is wrong with one that is far off.
fn mend_rotation(rbt: &mut Rbt, keyframe: usize, path: &str) -> Option<KeyframeFileError> {
    let not_finite = |field| Some(KeyframeFileError::NotFinite { keyframe, path: path.to_owned(), field });
    if !rbt.translation.is_finite() {
        return not_finite("translation");
    }
    if !rbt.rotation.is_finite() {
        return not_finite("rotation");
    }
    let exact = rbt.rotation.as_dquat();
    let off_unit = (exact.length() - 1.0).abs();
    if off_unit > NORMALISED_TOLERANCE {
        #[expect(clippy::cast_possible_truncation, reason = "it is for a message")]
        let length = exact.length() as f32;
        return Some(KeyframeFileError::NotUnit { keyframe, path: path.to_owned(), length });
    }
    if off_unit > UNIT_TOLERANCE {
        rbt.rotation = exact.normalize().as_quat();
    }
    None
}

/// The text of a keyframe file: the same bytes for the same keyframes, one line for each node of each pose.
#[must_use]
pub fn keyframes_to_json(
    scene: &SceneGraph,
    keyframes: &KeyframeList,
    interpolation: Interpolation,
    ms_between_keyframes: u32,
) -> String {
    KeyframesJson { scene, keyframes, interpolation, ms_between_keyframes }.to_string()
}

/// A keyframe file: what it displays is the text, made as it is written.
#[derive(Clone, Copy, Debug)]
pub struct KeyframesJson<'a> {
    /// The scene whose nodes the poses are of.
    pub scene: &'a SceneGraph,
    /// The keyframes.
    pub keyframes: &'a KeyframeList,
    /// The interpolation in force.
    pub interpolation: Interpolation,
    /// The milliseconds between keyframes in force.
    pub ms_between_keyframes: u32,
}

impl fmt::Display for KeyframesJson<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let has_extras = self.keyframes.as_slice().iter().any(Keyframe::has_extras);
        let version = if has_extras { VERSIONS.end() } else { VERSIONS.start() };
        let quoted = |name: &str| serde_json::Value::from(name).to_string();
        write!(
            out,
            "{{\n  \"format\": \"{FORMAT}\",\n  \"version\": {version},\n  \"scene\": {},\n  \"interpolation\": \"{}\",\n  \
             \"ms_between_keyframes\": {},\n  \"nodes\": [",
            quoted(self.scene.name()),
            self.interpolation.name(),
            self.ms_between_keyframes,
        )?;
        for (place, path) in self.scene.rbt_paths().enumerate() {
            write!(out, "{}    {}", if place == 0 { "\n" } else { ",\n" }, quoted(path))?;
        }
        out.write_str("\n  ],\n  \"keyframes\": [")?;
        let mut line = String::new();
        for (place, keyframe) in self.keyframes.as_slice().iter().enumerate() {
            line.clear();
            line.push_str(if place == 0 { "\n    { " } else { ",\n    { " });
            push_extras(&mut line, keyframe);
            line.push_str("\"pose\": [");
            out.write_str(&line)?;
            for (entry, rbt) in keyframe.pose.iter().enumerate() {
                line.clear();
                line.push_str(if entry == 0 { "\n      " } else { ",\n      " });
                push_rbt(&mut line, &rbt);
                out.write_str(&line)?;
            }
            out.write_str("\n    ] }")?;
        }
        out.write_str(if self.keyframes.is_empty() { "]\n}\n" } else { "\n  ]\n}\n" })
    }
}

/// Appends what a keyframe has beside its pose, nothing where it has nothing.
fn push_extras(text: &mut String, keyframe: &Keyframe) {
    if let Some(name) = &keyframe.name {
        let _ = write!(text, "\"name\": {}, ", serde_json::Value::from(&**name));
    }
    if keyframe.duration != 1.0 {
        let duration = format!("{:?}", keyframe.duration);
        let _ = write!(text, "\"duration\": {}, ", duration.strip_suffix(".0").unwrap_or(&duration));
    }
    if keyframe.easing != Easing::Linear {
        let _ = write!(text, "\"easing\": \"{}\", ", keyframe.easing.name());
    }
}
