//! What values a scene may hold, with the node's path for the messages about those that it may not.

use glam::{Quat, Vec3};

use super::file::SceneError;
use crate::rotation_rules::Mending;
use crate::words::{Argument, Phrase, texts};

const LARGEST_COORDINATE: f32 = 1e6;

/// A node's path.
#[derive(Clone, Copy)]
pub struct NodeChecks<'a> {
    /// The path.
    pub path: &'a str,
}

impl NodeChecks<'_> {
    /// A value that is out of its range.
    pub fn error(self, field: &'static str, found: impl Into<Argument>, expected: Phrase) -> SceneError {
        SceneError::Value { path: self.path.to_owned(), field, found: found.into(), expected }
    }

    /// A position that can be drawn.
    pub fn coordinates(self, field: &'static str, value: Vec3) -> Result<Vec3, SceneError> {
        if value.abs().max_element() <= LARGEST_COORDINATE {
            Ok(value)
        } else {
            Err(self.error(field, format!("{value}"), texts::SCENE_EXPECTED_COORDINATES))
        }
    }

    /// A unit quaternion.
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

    /// A scale that leaves something to be seen.
    pub fn scale(self, scale: Vec3) -> Result<Vec3, SceneError> {
        if scale.min_element() > 0.0 && scale.max_element() <= LARGEST_COORDINATE {
            Ok(scale)
        } else {
            Err(self.error("scale", format!("{scale}"), texts::SCENE_EXPECTED_SCALE))
        }
    }

    /// A length of a shape.
    pub fn length(self, field: &'static str, value: f32) -> Result<f32, SceneError> {
        if value > 0.0 && value <= LARGEST_COORDINATE {
            Ok(value)
        } else {
            Err(self.error(field, value.to_string(), texts::SCENE_EXPECTED_LENGTH))
        }
    }
}
