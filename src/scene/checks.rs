//! Checks of the values in a scene. Errors name the node's path.

use glam::{Quat, Vec3};

use super::file::SceneError;
use crate::rotation_rules::Mending;
use crate::words::{Argument, Phrase, texts};

const LARGEST_COORDINATE: f32 = 1e6;

/// Checks the values of one node.
#[derive(Clone, Copy)]
pub struct NodeChecks<'a> {
    /// The node's path, for error messages.
    pub path: &'a str,
}

impl NodeChecks<'_> {
    /// The error for a value out of its range.
    pub fn error(self, field: &'static str, found: impl Into<Argument>, expected: Phrase) -> SceneError {
        SceneError::Value { path: self.path.to_owned(), field, found: found.into(), expected }
    }

    /// Coordinates in scene units, each at most 1e6 in absolute value.
    pub fn coordinates(self, field: &'static str, value: Vec3) -> Result<Vec3, SceneError> {
        if value.abs().max_element() <= LARGEST_COORDINATE {
            Ok(value)
        } else {
            Err(self.error(field, format!("{value}"), texts::SCENE_EXPECTED_COORDINATES))
        }
    }

    /// A unit quaternion, normalised if it is slightly off unit length.
    pub fn rotation(self, rotation: Quat) -> Result<Quat, SceneError> {
        match Mending::of_length(rotation.length().into()) {
            Mending::Keep => Ok(rotation),
            Mending::Normalise => Ok(rotation.normalize()),
            Mending::Refuse => {
                let found = texts::scene_found_length(rotation.length());
                Err(self.error("rotation", found, texts::SCENE_EXPECTED_ROTATION))
            }
        }
    }

    /// A scale: each component above 0 and at most 1e6.
    pub fn scale(self, scale: Vec3) -> Result<Vec3, SceneError> {
        if scale.min_element() > 0.0 && scale.max_element() <= LARGEST_COORDINATE {
            Ok(scale)
        } else {
            Err(self.error("scale", format!("{scale}"), texts::SCENE_EXPECTED_SCALE))
        }
    }

    /// A length of a shape in scene units: above 0 and at most 1e6.
    pub fn length(self, field: &'static str, value: f32) -> Result<f32, SceneError> {
        if value > 0.0 && value <= LARGEST_COORDINATE {
            Ok(value)
        } else {
            Err(self.error(field, value.to_string(), texts::SCENE_EXPECTED_LENGTH))
        }
    }
}
