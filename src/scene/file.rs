//! The scene file: JSON text to a [`SceneGraph`]. The manual documents the format.

use std::fmt;
use std::sync::Arc;

use glam::{Quat, Vec3, Vec4};
use serde::de::{self, Unexpected, Visitor};
use serde::{Deserialize, Deserializer};
use thiserror::Error;

use super::LARGEST_SCALE;
use super::builder::{MOST_LEVELS, SceneBuilder};
use super::channel::Channel;
use super::checks::NodeChecks;
use super::graph::SceneGraph;
use super::joint::{JointText, LimitsText};
use super::keys::keys_error;
use super::lighting::LightingText;
use super::meshes::{MeshesError, meshes_of};
use super::shape::{Finish, PlacedShape, Placement, ShapeText};
use super::tracks::Tracks;
use crate::colour::Colour;
use crate::decode::{self, DecodeError};
use crate::model::ModelFormat;
use crate::rbt::Rbt;
use crate::rotation_rules::rotation_from_euler_degrees;
use crate::text::str_without_byte_order_mark;
use crate::timed::KeyError;
use crate::words::{Argument, Message, Phrase, display_by_message, quoted, texts};

pub(super) const FORMAT: &str = "inbetween.scene";
/// The versions that are read. Version 2 has control nodes whose names are not part of paths, version 3 has limbs that reach, meshes,
/// finishes and a lighting.
const VERSIONS: std::ops::RangeInclusive<u32> = 1..=VERSION_OF_MESHES;
/// The first version of scene files with meshes.
pub(super) const VERSION_OF_MESHES: u32 = 3;
/// The first version of scene files with roughness and metalness.
pub(super) const VERSION_OF_FINISHES: u32 = 3;

/// Why a text is not a valid scene.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SceneError {
    /// The bytes are not UTF-8.
    NotText {
        /// The number of the first bad byte.
        at: usize,
    },
    /// It is a model or a motion of another program.
    OtherProgram,
    /// The text is not JSON of the right shape.
    Json(DecodeError),
    /// `format` names something else.
    Format {
        /// The value in the file.
        found: String,
    },
    /// `version` is not one that this program reads.
    Version {
        /// The value in the file.
        found: u32,
    },
    /// A node's name is empty or contains `/`.
    NodeName {
        /// The name in the file.
        name: String,
        /// The path of the node above it.
        parent: String,
    },
    /// Two nodes have one path.
    DuplicatePath {
        /// The node's path.
        path: String,
    },
    /// A node is deeper than [`super::MOST_LEVELS`].
    TooDeep {
        /// The node's path.
        path: String,
    },
    /// The scales of a control node and of those above it multiply to more than [`super::LARGEST_SCALE`].
    TooLarge {
        /// The control node's path.
        path: String,
        /// The product.
        scale: f64,
    },
    /// A value is out of its range.
    Value {
        /// The node's path.
        path: String,
        /// The field's name in the file.
        field: &'static str,
        /// The value in the file.
        found: Argument,
        /// The allowed values, as a phrase.
        expected: Phrase,
    },
    /// A field is not allowed in this node.
    Misplaced {
        /// The node's path.
        path: String,
        /// The field's name in the file.
        field: &'static str,
        /// Why it is not allowed.
        reason: Phrase,
    },
    /// An operation on control nodes was asked of a node of another kind.
    NotControl {
        /// The node's path.
        path: String,
    },
    /// The keys of a channel do not make a track.
    Keys {
        /// The node's path.
        path: String,
        /// The field's name in the file.
        field: &'static str,
        /// The error in the keys.
        error: KeyError,
    },
    /// An eye is not an RBT node of the scene.
    Eye {
        /// The node's path.
        path: String,
    },
    /// The scene names no eye.
    NoEyes,
    /// The meshes of the scene cannot be read.
    Meshes(MeshesError),
    /// No mesh of the scene has the name.
    Mesh {
        /// The node's path.
        path: String,
        /// The name in the file.
        name: String,
    },
    /// A joint of a skin is neither an RBT node nor a control node.
    SkinJoint {
        /// The path of the mesh's node.
        path: String,
        /// The joint's path in the file.
        joint: String,
    },
    /// A node has not as many joints as the skin of its mesh.
    SkinJoints {
        /// The node's path.
        path: String,
        /// How many joints the node has.
        found: usize,
        /// How many joints the skin has; a mesh without one has none.
        expected: usize,
    },
    /// A control node cannot be removed because it moves a skin.
    MovesSkin {
        /// The control node's path.
        path: String,
        /// The path of the mesh's node.
        skin: String,
    },
    /// The file says an older version, which has no lighting.
    LightingVersion,
    /// A value of the lighting is out of its range.
    Lighting {
        /// The field in the file.
        field: &'static str,
        /// The value in the file.
        found: Argument,
        /// The allowed values, as a phrase.
        expected: Phrase,
    },
    /// The field of view is out of range.
    FieldOfView {
        /// The value in the file, in degrees.
        degrees: f32,
    },
}

display_by_message!(SceneError);

impl SceneError {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::NotText { at } => texts::scene_not_text(*at),
            Self::OtherProgram => texts::MODEL_NOT_HERE.into(),
            Self::Json(error) => error.message(),
            Self::Format { found } => texts::scene_format(quoted(found)),
            Self::Version { found } => texts::scene_version(*found),
            Self::NodeName { name, parent } => texts::scene_node_name(quoted(name), parent),
            Self::DuplicatePath { path } => texts::scene_duplicate_path(quoted(path)),
            Self::TooDeep { path } => texts::scene_too_deep(short(path), MOST_LEVELS),
            Self::TooLarge { path, scale } => {
                texts::scene_too_large(quoted(path), format!("{scale:e}"), format!("{LARGEST_SCALE:e}"))
            }
            Self::Value { path, field, found, expected } => {
                texts::scene_value(quoted(path), *field, found.clone(), *expected)
            }
            Self::Misplaced { path, field, reason } => texts::scene_misplaced(quoted(path), *field, *reason),
            Self::NotControl { path } => texts::scene_not_control(quoted(path)),
            Self::Keys { path, field, error } => texts::scene_keys(quoted(path), *field, error.message()),
            Self::Eye { path } => texts::scene_eye(quoted(path)),
            Self::NoEyes => texts::SCENE_NO_EYES.into(),
            Self::Meshes(error) => error.message(),
            Self::Mesh { path, name } => texts::scene_no_mesh(quoted(path), quoted(name)),
            Self::SkinJoint { path, joint } => texts::scene_skin_joint(quoted(path), quoted(joint)),
            Self::SkinJoints { path, found, expected } => texts::scene_skin_joints(quoted(path), *found, *expected),
            Self::MovesSkin { path, skin } => texts::scene_moves_skin(quoted(path), quoted(skin)),
            Self::LightingVersion => texts::SCENE_LIGHTING_NEEDS_VERSION_3.into(),
            Self::Lighting { field, found, expected } => texts::scene_lighting(*field, found.clone(), *expected),
            Self::FieldOfView { degrees } => texts::scene_field_of_view(*degrees),
        }
    }
}

/// The end of a path that is too long for a sentence.
fn short(path: &str) -> String {
    let start = path.char_indices().rev().nth(59).map_or(0, |(start, _)| start);
    quoted(&if start == 0 { path.to_owned() } else { format!("…{}", &path[start..]) })
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SceneText {
    format: String,
    version: u32,
    name: String,
    eyes: Vec<String>,
    #[serde(default = "default_fov_degrees")]
    vertical_fov_degrees: f32,
    lighting: Option<LightingText>,
    meshes: Option<String>,
    nodes: Vec<NodeText>,
}

fn default_fov_degrees() -> f32 {
    60.0
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct NodeText {
    name: String,
    #[serde(default)]
    translation: [f32; 3],
    rotation: Option<RotationText>,
    scale: Option<ScaleText>,
    shape: Option<ShapeText>,
    colour: Option<ColourText>,
    colour_keys: Option<Vec<(f64, ColourText)>>,
    roughness: Option<f32>,
    metalness: Option<f32>,
    control: Option<ControlText>,
    in_paths: Option<bool>,
    reach: Option<[f32; 3]>,
    stands: Option<bool>,
    limits: Option<LimitsText>,
    #[serde(default)]
    children: Vec<NodeText>,
}

/// Keys of a control node, each a list of `[seconds, value]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ControlText {
    translation: Option<Vec<(f64, [f32; 3])>>,
    rotation: Option<Vec<(f64, RotationText)>>,
    scale: Option<Vec<(f64, ScaleText)>>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(untagged, expecting = "decode.kind.rotation")]
enum RotationText {
    Quaternion([f32; 4]),
    Euler(EulerText),
}

#[derive(Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
struct EulerText {
    euler_degrees: [f32; 3],
}

#[derive(Clone, Copy, Deserialize)]
#[serde(untagged, expecting = "decode.kind.scale")]
enum ScaleText {
    Uniform(f32),
    PerAxis([f32; 3]),
}

#[derive(Clone, Copy)]
pub(super) struct ColourText(pub Colour);

impl<'de> Deserialize<'de> for ColourText {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct ColourVisitor;

        impl Visitor<'_> for ColourVisitor {
            type Value = ColourText;

            fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
                formatter.write_str("decode.kind.colour")
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<ColourText, E> {
                let colour = Colour::from_hex(text).map(ColourText);
                colour.ok_or_else(|| E::invalid_value(Unexpected::Str(text), &self))
            }
        }

        deserializer.deserialize_str(ColourVisitor)
    }
}

/// Reads a scene file that holds all of the scene. A byte order mark is skipped.
///
/// # Errors
/// As [`scene_from_json`]; or the bytes are not UTF-8.
pub fn scene_from_bytes(bytes: &[u8]) -> Result<SceneGraph, SceneError> {
    scene_with_meshes(bytes, |_| Err(texts::SCENE_MESHES_APART.into()))
}

/// Reads a scene file. A byte order mark is skipped. `read_meshes` reads the file with this name beside it, if the scene has its meshes
/// there.
///
/// # Errors
/// As [`scene_from_json`]; or the bytes are not UTF-8.
pub fn scene_with_meshes(
    bytes: &[u8],
    read_meshes: impl FnOnce(&str) -> Result<Vec<u8>, Message> + Send,
) -> Result<SceneGraph, SceneError> {
    let or_of_other_program =
        |error: SceneError| if ModelFormat::of(bytes).is_some() { SceneError::OtherProgram } else { error };
    let text = std::str::from_utf8(bytes)
        .map_err(|error| or_of_other_program(SceneError::NotText { at: error.valid_up_to() }))?;
    let text = str_without_byte_order_mark(text).as_bytes();
    decode::nested_json(text, MOST_NESTING, |read: SceneText| built(&read, read_meshes))
        .map_err(|error| or_of_other_program(SceneError::Json(error)))?
}

/// Reads a scene whose text holds all of it.
///
/// # Errors
/// One [`SceneError`] with the line and column, or the path of the node.
pub fn scene_from_json(text: &str) -> Result<SceneGraph, SceneError> {
    scene_from_bytes(text.as_bytes())
}

/// The nesting of brackets in a file of [`MOST_LEVELS`] levels of nodes: two a level, and those around and within nodes.
const MOST_NESTING: usize = 2 * MOST_LEVELS + 8;

fn built(
    text: &SceneText,
    read_meshes: impl FnOnce(&str) -> Result<Vec<u8>, Message>,
) -> Result<SceneGraph, SceneError> {
    if text.format != FORMAT {
        return Err(SceneError::Format { found: text.format.clone() });
    }
    if !VERSIONS.contains(&text.version) {
        return Err(SceneError::Version { found: text.version });
    }
    let mut builder = SceneBuilder::new();
    if let Some(lighting) = &text.lighting {
        builder.lighting(lighting.lighting(text.version)?);
    }
    if let Some(meshes) = &text.meshes {
        if text.version < VERSION_OF_MESHES {
            return Err(SceneError::Meshes(MeshesError::Version));
        }
        builder.meshes(Arc::new(meshes_of(meshes, read_meshes).map_err(SceneError::Meshes)?));
    }
    for node in &text.nodes {
        add(&mut builder, node, "", text.version)?;
    }
    builder.finish(&text.name, &text.eyes, text.vertical_fov_degrees)
}

/// `parent_path`: the common prefix of the paths of all siblings.
fn add(builder: &mut SceneBuilder, node: &NodeText, parent_path: &str, version: u32) -> Result<(), SceneError> {
    let path = if parent_path.is_empty() { node.name.clone() } else { format!("{parent_path}/{}", node.name) };
    let checks = NodeChecks { path: &path };
    let translation = checks.coordinates("translation", Vec3::from(node.translation))?;
    let rotation = rotation(checks, node.rotation)?;
    let misplaced = |field, reason| Err(SceneError::Misplaced { path: path.clone(), field, reason });
    if node.in_paths.is_some() && version < 2 {
        return misplaced("in_paths", texts::SCENE_IN_PATHS_NEEDS_VERSION_2);
    }
    if node.in_paths == Some(false) && node.control.is_none() {
        return misplaced("in_paths", texts::SCENE_IN_PATHS_OF_CONTROL);
    }
    let finish = finish(checks, node, version)?;
    let joint = JointText { reach: node.reach, stands: node.stands, limits: node.limits };
    let joint = joint.joint(checks, node.shape.is_none() && node.control.is_none(), version)?;
    if let Some(shape) = &node.shape {
        if !node.children.is_empty() {
            return misplaced("children", texts::SCENE_CHILDREN_OF_SHAPE);
        }
        if node.control.is_some() {
            return misplaced("control", texts::SCENE_CONTROL_BESIDE_SHAPE);
        }
        let placement = Placement { translation, rotation, scale: scale(checks, node.scale)? };
        let colour = node.colour.map_or(Colour::DEFAULT, |colour| colour.0);
        let mut tracks = Tracks::default();
        set(&mut tracks, Channel::Colour, checks, node.colour_keys.as_ref(), |colour| {
            Ok(colour.0.to_linear().extend(0.0))
        })?;
        let (shape, joints) = match shape {
            ShapeText::Solid(shape) => (shape.clone(), None),
            ShapeText::Mesh(mesh) => (builder.mesh_shape(&path, &mesh.name)?, Some(&mesh.joints)),
        };
        shape.solid().check(checks)?;
        let id = builder.shape(&node.name, PlacedShape::new(shape, colour, tracks, placement).with_finish(finish))?;
        if let Some(joints) = joints {
            builder.joints(id, joints.clone());
        }
        return Ok(());
    }
    for (field, is_there) in [("roughness", finish.roughness.is_some()), ("metalness", finish.metalness.is_some())] {
        if is_there {
            return misplaced(field, texts::SCENE_COLOUR_OF_RBT);
        }
    }
    if node.scale.is_some() {
        return misplaced("scale", texts::SCENE_SCALE_OF_RBT);
    }
    if node.colour.is_some() || node.colour_keys.is_some() {
        return misplaced("colour", texts::SCENE_COLOUR_OF_RBT);
    }
    if let Some(control) = &node.control {
        if node.translation != [0.0; 3] || node.rotation.is_some() {
            return misplaced("control", texts::SCENE_CONTROL_HAS_KEYS);
        }
        builder.open_control(&node.name, self::control(checks, control)?, node.in_paths.unwrap_or(true))?;
    } else {
        builder.open_rbt(&node.name, Rbt::new(translation, rotation))?;
        builder.joint(joint);
    }
    let path_above = if node.in_paths == Some(false) { parent_path } else { &path };
    for child in &node.children {
        add(builder, child, path_above, version)?;
    }
    builder.close();
    Ok(())
}

/// What a node says of its surface, checked.
fn finish(checks: NodeChecks<'_>, node: &NodeText, version: u32) -> Result<Finish, SceneError> {
    let within = |field, value: Option<f32>| match value {
        Some(_) if version < VERSION_OF_FINISHES => {
            let reason = texts::SCENE_FIELD_NEEDS_VERSION_3;
            Err(SceneError::Misplaced { path: checks.path.to_owned(), field, reason })
        }
        Some(found) if !(0.0..=1.0).contains(&found) => Err(checks.error(field, found, texts::SCENE_EXPECTED_PART)),
        // Zero has no sign.
        value => Ok(value.map(|value| value + 0.0)),
    };
    Ok(Finish { roughness: within("roughness", node.roughness)?, metalness: within("metalness", node.metalness)? })
}

/// Sets the keys of a channel from a list, if the file has one. Errors name the key's time.
fn set<T: Copy>(
    tracks: &mut Tracks,
    channel: Channel,
    checks: NodeChecks<'_>,
    texts: Option<&Vec<(f64, T)>>,
    numbers: impl Fn(T) -> Result<Vec4, SceneError>,
) -> Result<(), SceneError> {
    let Some(texts) = texts else { return Ok(()) };
    let pairs = texts.iter().map(|&(seconds, text)| Ok((seconds, numbers(text)?))).collect::<Result<Vec<_>, _>>()?;
    tracks.set(channel, pairs).map_err(|error| keys_error(checks, channel, error))
}

fn control(checks: NodeChecks<'_>, control: &ControlText) -> Result<Tracks, SceneError> {
    let ControlText { translation, rotation, scale } = control;
    let mut tracks = Tracks::default();
    set(&mut tracks, Channel::Translation, checks, translation.as_ref(), |value| {
        Ok(checks.coordinates("control.translation", Vec3::from(value))?.extend(0.0))
    })?;
    set(&mut tracks, Channel::Rotation, checks, rotation.as_ref(), |value| {
        self::rotation(checks, Some(value)).map(Vec4::from)
    })?;
    set(
        &mut tracks,
        Channel::Scale,
        checks,
        scale.as_ref(),
        |value| Ok(self::scale(checks, Some(value))?.extend(0.0)),
    )?;
    Ok(tracks)
}

fn rotation(checks: NodeChecks<'_>, value: Option<RotationText>) -> Result<Quat, SceneError> {
    let rotation = match value {
        None => Quat::IDENTITY,
        Some(RotationText::Quaternion(components)) => Quat::from_array(components),
        Some(RotationText::Euler(EulerText { euler_degrees })) => {
            rotation_from_euler_degrees(euler_degrees).normalize()
        }
    };
    checks.rotation(rotation)
}

fn scale(checks: NodeChecks<'_>, value: Option<ScaleText>) -> Result<Vec3, SceneError> {
    checks.scale(match value {
        None => Vec3::ONE,
        Some(ScaleText::Uniform(scale)) => Vec3::splat(scale),
        Some(ScaleText::PerAxis(scale)) => Vec3::from(scale),
    })
}
