//! What values a scene may hold, with the node's path for the messages about those that it may not.

use glam::{Quat, Vec3};

use super::file::SceneError;
use crate::rotation_rules::Mending;

const LARGEST_COORDINATE: f32 = 1e6;

/// A node's path.
#[derive(Clone, Copy)]
pub struct Place<'a> {
    /// The path.
    pub path: &'a str,
}

impl Place<'_> {
    /// A value that is out of its range.
    pub fn error(self, field: &'static str, found: String, expected: &'static str) -> SceneError {
        SceneError::Value { path: self.path.to_owned(), field, found, expected }
    }

    /// A position that can be drawn.
    pub fn coordinates(self, field: &'static str, value: Vec3) -> Result<Vec3, SceneError> {
        if value.abs().max_element() <= LARGEST_COORDINATE {
            Ok(value)
        } else {
            Err(self.error(field, format!("{value}"), "coordinates between -1e6 and 1e6"))
        }
    }

    /// A unit quaternion.
    pub fn rotation(self, rotation: Quat) -> Result<Quat, SceneError> {
        match Mending::of_length(rotation.length().into()) {
            Mending::Keep => Ok(rotation),
            Mending::Normalise => Ok(rotation.normalize()),
            Mending::Refuse => {
                let found = format!("of length {}", rotation.length());
                Err(self.error("rotation", found, "a unit quaternion [x, y, z, w]"))
            }
        }
    }

    /// A scale that leaves something to be seen.
    pub fn scale(self, scale: Vec3) -> Result<Vec3, SceneError> {
        if scale.min_element() > 0.0 && scale.max_element() <= LARGEST_COORDINATE {
            Ok(scale)
        } else {
            Err(self.error("scale", format!("{scale}"), "numbers above 0, at most 1e6"))
        }
    }

    /// A length of a shape.
    pub fn length(self, field: &'static str, value: f32) -> Result<f32, SceneError> {
        if value > 0.0 && value <= LARGEST_COORDINATE {
            Ok(value)
        } else {
            Err(self.error(field, value.to_string(), "a number above 0, at most 1e6"))
        }
    }
}
