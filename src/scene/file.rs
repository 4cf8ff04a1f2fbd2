//! The scene file: JSON text to a [`SceneGraph`]. The manual documents the format.

use glam::{Quat, Vec3};
use serde::Deserialize;
use thiserror::Error;

use super::builder::SceneBuilder;
use super::graph::SceneGraph;
use super::place::Place;
use super::shape::{Colour, PlacedShape, Placement, Shape};
use crate::rbt::Rbt;
use crate::timed::{Interpolate, KeyError, Keyframes, TransformKeyframes, rotation_from_euler_degrees};

pub(super) const FORMAT: &str = "inbetween.scene";
/// What a file says, and what one says that has a control node which paths do not name.
const VERSIONS: std::ops::RangeInclusive<u32> = 1..=2;

/// Why a text is not a scene.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SceneError {
    /// The text is not JSON of the right shape; the message ends with line and column.
    #[error("{message}")]
    Json {
        /// What is wrong, with line and column.
        message: String,
    },
    /// `format` names something else.
    #[error("format is {found:?}, expected \"inbetween.scene\"")]
    Format {
        /// What the file says.
        found: String,
    },
    /// `version` is not one that this program reads.
    #[error("version is {found}, and this program reads versions 1 and 2")]
    Version {
        /// What the file says.
        found: u32,
    },
    /// A node's name is empty or contains `/`.
    #[error("node name {name:?} under {parent}: a name is at least one character and has no \"/\"")]
    NodeName {
        /// The name.
        name: String,
        /// The path of the node above it.
        parent: String,
    },
    /// Two nodes have one path.
    #[error("node {path:?} stands twice: names are unique under one parent")]
    DuplicatePath {
        /// The path.
        path: String,
    },
    /// A value is out of its range.
    #[error("node {path:?}: {field} is {found}, expected {expected}")]
    Value {
        /// The node's path.
        path: String,
        /// Which field.
        field: &'static str,
        /// What the file says.
        found: String,
        /// What is allowed.
        expected: &'static str,
    },
    /// A field stands where it has no meaning.
    #[error("node {path:?}: {field} {reason}")]
    Misplaced {
        /// The node's path.
        path: String,
        /// Which field.
        field: &'static str,
        /// Why it cannot stand there.
        reason: &'static str,
    },
    /// What is asked of a control node is asked of another.
    #[error("node {path:?} is not a control node")]
    NotControl {
        /// The node's path.
        path: String,
    },
    /// Keys at their own times cannot be made of what stands there.
    #[error("node {path:?}: {field}: {error}")]
    Keys {
        /// The node's path.
        path: String,
        /// Which field.
        field: &'static str,
        /// What is wrong with the keys.
        error: KeyError,
    },
    /// An eye is not an RBT node of the scene.
    #[error("eye {path:?} is not the path of an RBT node")]
    Eye {
        /// The path.
        path: String,
    },
    /// There is nothing to look from.
    #[error("eyes is empty: a scene needs at least one RBT node to look from")]
    NoEyes,
    /// The field of view cannot be drawn.
    #[error("vertical_fov_degrees is {degrees}, expected more than 0 and less than 180")]
    FieldOfView {
        /// What the file says, in degrees.
        degrees: f32,
    },
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
    control: Option<ControlText>,
    in_paths: Option<bool>,
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
#[serde(untagged, expecting = "a rotation: [x, y, z, w], or { \"euler_degrees\": [yaw, pitch, roll] }")]
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
#[serde(untagged, expecting = "a scale: one number, or [x, y, z]")]
enum ScaleText {
    Uniform(f32),
    PerAxis([f32; 3]),
}

#[derive(Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
enum ShapeText {
    Box {
        size: [f32; 3],
        #[serde(default)]
        bevel: f32,
    },
    Sphere {
        radius: f32,
    },
    Cylinder {
        radius: f32,
        height: f32,
    },
    Cone {
        radius: f32,
        height: f32,
    },
    Capsule {
        radius: f32,
        height: f32,
    },
    Plane {
        size: [f32; 2],
    },
}

#[derive(Clone, Copy, Deserialize)]
#[serde(try_from = "String")]
struct ColourText(Colour);

impl TryFrom<String> for ColourText {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        Colour::from_hex(&text).map(Self).ok_or_else(|| format!("colour {text:?}, expected \"#rrggbb\""))
    }
}

/// Reads a scene.
///
/// # Errors
/// One [`SceneError`] with the line and column, or the path of the node.
pub fn scene_from_json(text: &str) -> Result<SceneGraph, SceneError> {
    let text: SceneText =
        serde_json::from_str(text).map_err(|error| SceneError::Json { message: crate::json::sentence(&error) })?;
    if text.format != FORMAT {
        return Err(SceneError::Format { found: text.format });
    }
    if !VERSIONS.contains(&text.version) {
        return Err(SceneError::Version { found: text.version });
    }
    let mut builder = SceneBuilder::new();
    for node in &text.nodes {
        add(&mut builder, node, "", text.version)?;
    }
    builder.finish(&text.name, &text.eyes, text.vertical_fov_degrees)
}

/// `parent_path`: what the paths of the nodes under the same one begin with.
fn add(builder: &mut SceneBuilder, node: &NodeText, parent_path: &str, version: u32) -> Result<(), SceneError> {
    let path = if parent_path.is_empty() { node.name.clone() } else { format!("{parent_path}/{}", node.name) };
    let place = Place { path: &path };
    let translation = place.coordinates("translation", Vec3::from(node.translation))?;
    let rotation = rotation(place, node.rotation)?;
    let misplaced = |field, reason| Err(SceneError::Misplaced { path: path.clone(), field, reason });
    if node.in_paths.is_some() && version < 2 {
        return misplaced("in_paths", "needs version 2, and the file says version 1");
    }
    if node.in_paths == Some(false) && node.control.is_none() {
        return misplaced("in_paths", "is false, which is for control nodes only");
    }
    if let Some(shape) = &node.shape {
        if !node.children.is_empty() {
            return misplaced("children", "cannot stand under a shape");
        }
        if node.control.is_some() {
            return misplaced("control", "cannot stand beside a shape: put the shape under the control node");
        }
        let placement = Placement { translation, rotation, scale: scale(place, node.scale)? };
        let colour = node.colour.map_or(Colour::DEFAULT, |colour| colour.0);
        let colour_keys = node
            .colour_keys
            .as_ref()
            .map(|texts| keys(place, "colour_keys", texts, |colour| Ok(colour.0.to_linear())))
            .transpose()?;
        let placed = PlacedShape::new(self::shape(place, shape)?, colour, colour_keys, placement);
        builder.shape(&node.name, placed)?;
        return Ok(());
    }
    if node.scale.is_some() {
        return misplaced("scale", "has no place in a rigid body transform: put it on the shapes");
    }
    if node.colour.is_some() || node.colour_keys.is_some() {
        return misplaced("colour", "belongs to a shape");
    }
    if let Some(control) = &node.control {
        if node.translation != [0.0; 3] || node.rotation.is_some() {
            return misplaced("control", "has keys for the translation and the rotation: give them there");
        }
        builder.open_control(&node.name, self::control(place, control)?, node.in_paths.unwrap_or(true))?;
    } else {
        builder.open_rbt(&node.name, Rbt::new(translation, rotation))?;
    }
    let path_above = if node.in_paths == Some(false) { parent_path } else { &path };
    for child in &node.children {
        add(builder, child, path_above, version)?;
    }
    builder.close();
    Ok(())
}

/// Keys from their texts; what is wrong with one is said with its time.
fn keys<T: Copy, V: Interpolate>(
    place: Place<'_>,
    field: &'static str,
    texts: &[(f64, T)],
    value: impl Fn(T) -> Result<V, SceneError>,
) -> Result<Keyframes<V>, SceneError> {
    let pairs = texts.iter().map(|&(seconds, text)| Ok((seconds, value(text)?))).collect::<Result<Vec<_>, _>>()?;
    Keyframes::new(pairs).map_err(|error| SceneError::Keys { path: place.path.to_owned(), field, error })
}

fn control(place: Place<'_>, control: &ControlText) -> Result<TransformKeyframes, SceneError> {
    let ControlText { translation, rotation, scale } = control;
    let mut keys = TransformKeyframes::default();
    if let Some(texts) = translation {
        keys.translation = Some(self::keys(place, "control.translation", texts, |value| {
            place.coordinates("control.translation", Vec3::from(value))
        })?);
    }
    if let Some(texts) = rotation {
        keys.rotation = Some(self::keys(place, "control.rotation", texts, |value| self::rotation(place, Some(value)))?);
    }
    if let Some(texts) = scale {
        keys.scale = Some(self::keys(place, "control.scale", texts, |value| self::scale(place, Some(value)))?);
    }
    Ok(keys)
}

fn rotation(place: Place<'_>, value: Option<RotationText>) -> Result<Quat, SceneError> {
    let rotation = match value {
        None => Quat::IDENTITY,
        Some(RotationText::Quaternion(components)) => Quat::from_array(components),
        Some(RotationText::Euler(EulerText { euler_degrees })) => {
            rotation_from_euler_degrees(euler_degrees).normalize()
        }
    };
    place.rotation(rotation)
}

fn scale(place: Place<'_>, value: Option<ScaleText>) -> Result<Vec3, SceneError> {
    place.scale(match value {
        None => Vec3::ONE,
        Some(ScaleText::Uniform(scale)) => Vec3::splat(scale),
        Some(ScaleText::PerAxis(scale)) => Vec3::from(scale),
    })
}

fn shape(place: Place<'_>, shape: &ShapeText) -> Result<Shape, SceneError> {
    Ok(match *shape {
        ShapeText::Box { size, bevel } => {
            let size = Vec3::new(
                place.length("size", size[0])?,
                place.length("size", size[1])?,
                place.length("size", size[2])?,
            );
            if !(bevel >= 0.0 && bevel <= size.min_element() * 0.5) {
                return Err(place.error("bevel", bevel.to_string(), "0 to half the smallest extent"));
            }
            Shape::Box { size, bevel }
        }
        ShapeText::Sphere { radius } => Shape::Sphere { radius: place.length("radius", radius)? },
        ShapeText::Cylinder { radius, height } => {
            Shape::Cylinder { radius: place.length("radius", radius)?, height: place.length("height", height)? }
        }
        ShapeText::Cone { radius, height } => {
            Shape::Cone { radius: place.length("radius", radius)?, height: place.length("height", height)? }
        }
        ShapeText::Capsule { radius, height } => {
            let radius = place.length("radius", radius)?;
            if height < 2.0 * radius {
                return Err(place.error("height", height.to_string(), "at least twice the radius, caps included"));
            }
            Shape::Capsule { radius, height: place.length("height", height)? }
        }
        ShapeText::Plane { size: [x, z] } => {
            Shape::Plane { size: [place.length("size", x)?, place.length("size", z)?] }
        }
    })
}
