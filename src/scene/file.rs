//! The scene file: JSON text to a [`SceneGraph`]. The README documents the format.

use glam::{Affine3A, Quat, Vec3};
use serde::Deserialize;
use thiserror::Error;

use super::graph::{SceneBuilder, SceneGraph};
use super::shape::{Colour, PlacedShape, Shape};
use crate::rbt::Rbt;
use crate::timed::{Interpolate, KeyError, Keyframes, TransformKeyframes, rotation_from_euler_degrees};

const FORMAT: &str = "inbetween.scene";
const VERSION: u32 = 1;
const LARGEST_COORDINATE: f32 = 1e6;

/// Why a text is not a scene.
#[derive(Debug, Error, PartialEq)]
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
    #[error("version is {found}, and this program reads version 1")]
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
    if text.version != VERSION {
        return Err(SceneError::Version { found: text.version });
    }
    let mut builder = SceneBuilder::new();
    for node in &text.nodes {
        add(&mut builder, node, "")?;
    }
    builder.finish(&text.name, &text.eyes, text.vertical_fov_degrees.to_radians())
}

fn add(builder: &mut SceneBuilder, node: &NodeText, parent_path: &str) -> Result<(), SceneError> {
    let path = if parent_path.is_empty() { node.name.clone() } else { format!("{parent_path}/{}", node.name) };
    let place = Place { path: &path };
    let translation = place.coordinates("translation", Vec3::from(node.translation))?;
    let rotation = place.rotation(node.rotation)?;
    let misplaced = |field, reason| Err(SceneError::Misplaced { path: path.clone(), field, reason });
    if let Some(shape) = &node.shape {
        if !node.children.is_empty() {
            return misplaced("children", "cannot stand under a shape");
        }
        if node.control.is_some() {
            return misplaced("control", "cannot stand beside a shape: put the shape under the control node");
        }
        let scale = place.scale(node.scale)?;
        builder.shape(
            &node.name,
            PlacedShape {
                shape: place.shape(shape)?,
                colour: node.colour.map_or(Colour(Vec3::splat(0.7)), |colour| colour.0),
                colour_keys: node
                    .colour_keys
                    .as_ref()
                    .map(|keys| place.keys("colour_keys", keys, |colour| Ok(colour.0.to_linear())))
                    .transpose()?,
                parent_from_shape: Affine3A::from_scale_rotation_translation(scale, rotation, translation),
            },
        )?;
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
        builder.open_control(&node.name, place.control(control)?)?;
    } else {
        builder.open_rbt(&node.name, Rbt::new(translation, rotation))?;
    }
    for child in &node.children {
        add(builder, child, &path)?;
    }
    builder.close();
    Ok(())
}

/// A node's path, for the messages about its values.
struct Place<'a> {
    path: &'a str,
}

impl Place<'_> {
    fn error(&self, field: &'static str, found: String, expected: &'static str) -> SceneError {
        SceneError::Value { path: self.path.to_owned(), field, found, expected }
    }

    fn coordinates(&self, field: &'static str, value: Vec3) -> Result<Vec3, SceneError> {
        if value.abs().max_element() <= LARGEST_COORDINATE {
            Ok(value)
        } else {
            Err(self.error(field, format!("{value}"), "coordinates between -1e6 and 1e6"))
        }
    }

    /// Keys from their texts; what is wrong with one is said with its time.
    fn keys<T: Copy, V: Interpolate>(
        &self,
        field: &'static str,
        texts: &[(f64, T)],
        value: impl Fn(T) -> Result<V, SceneError>,
    ) -> Result<Keyframes<V>, SceneError> {
        let pairs = texts.iter().map(|&(seconds, text)| Ok((seconds, value(text)?))).collect::<Result<Vec<_>, _>>()?;
        Keyframes::new(pairs).map_err(|error| SceneError::Keys { path: self.path.to_owned(), field, error })
    }

    fn control(&self, control: &ControlText) -> Result<TransformKeyframes, SceneError> {
        let ControlText { translation, rotation, scale } = control;
        let mut keys = TransformKeyframes::identity();
        if let Some(texts) = translation {
            keys.translation = self.keys("control.translation", texts, |value| {
                self.coordinates("control.translation", Vec3::from(value))
            })?;
        }
        if let Some(texts) = rotation {
            keys.rotation = self.keys("control.rotation", texts, |value| self.rotation(Some(value)))?;
        }
        if let Some(texts) = scale {
            keys.scale = self.keys("control.scale", texts, |value| self.scale(Some(value)))?;
        }
        Ok(keys)
    }

    fn rotation(&self, value: Option<RotationText>) -> Result<Quat, SceneError> {
        let rotation = match value {
            None => Quat::IDENTITY,
            Some(RotationText::Quaternion(components)) => Quat::from_array(components),
            Some(RotationText::Euler(EulerText { euler_degrees })) => rotation_from_euler_degrees(euler_degrees),
        };
        if (rotation.length() - 1.0).abs() <= 0.01 {
            Ok(rotation.normalize())
        } else {
            Err(self.error("rotation", format!("of length {}", rotation.length()), "a unit quaternion [x, y, z, w]"))
        }
    }

    fn scale(&self, value: Option<ScaleText>) -> Result<Vec3, SceneError> {
        let scale = match value {
            None => Vec3::ONE,
            Some(ScaleText::Uniform(scale)) => Vec3::splat(scale),
            Some(ScaleText::PerAxis(scale)) => Vec3::from(scale),
        };
        if scale.min_element() > 0.0 && scale.max_element() <= LARGEST_COORDINATE {
            Ok(scale)
        } else {
            Err(self.error("scale", format!("{scale}"), "numbers above 0, at most 1e6"))
        }
    }

    fn length(&self, field: &'static str, value: f32) -> Result<f32, SceneError> {
        if value > 0.0 && value <= LARGEST_COORDINATE {
            Ok(value)
        } else {
            Err(self.error(field, value.to_string(), "a number above 0, at most 1e6"))
        }
    }

    fn shape(&self, shape: &ShapeText) -> Result<Shape, SceneError> {
        Ok(match *shape {
            ShapeText::Box { size, bevel } => {
                let size = Vec3::new(
                    self.length("size", size[0])?,
                    self.length("size", size[1])?,
                    self.length("size", size[2])?,
                );
                if !(bevel >= 0.0 && bevel <= size.min_element() * 0.5) {
                    return Err(self.error("bevel", bevel.to_string(), "0 to half the smallest extent"));
                }
                Shape::Box { size, bevel }
            }
            ShapeText::Sphere { radius } => Shape::Sphere { radius: self.length("radius", radius)? },
            ShapeText::Cylinder { radius, height } => {
                Shape::Cylinder { radius: self.length("radius", radius)?, height: self.length("height", height)? }
            }
            ShapeText::Cone { radius, height } => {
                Shape::Cone { radius: self.length("radius", radius)?, height: self.length("height", height)? }
            }
            ShapeText::Capsule { radius, height } => {
                let radius = self.length("radius", radius)?;
                if height < 2.0 * radius {
                    return Err(self.error("height", height.to_string(), "at least twice the radius, caps included"));
                }
                Shape::Capsule { radius, height: self.length("height", height)? }
            }
            ShapeText::Plane { size: [x, z] } => {
                Shape::Plane { size: [self.length("size", x)?, self.length("size", z)?] }
            }
        })
    }
}
