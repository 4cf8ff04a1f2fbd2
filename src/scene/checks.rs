//! Checks of the values in a scene. Errors name the node's path.

use glam::{Quat, Vec3};

use super::file::SceneError;
use super::graph::{NodeKind, SceneGraph};
use crate::rbt::{LARGEST_COORDINATE, are_coordinates};
use crate::rotation_rules::Mending;
use crate::words::{Argument, Phrase, texts};

/// The largest product of the scales of control nodes above each other. With the bound of coordinates and of levels it keeps all of a
/// scene within single precision, in world space too.
pub const LARGEST_SCALE: f64 = 1e12;

impl SceneGraph {
    /// Checks that scales of control nodes above each other do not multiply to more than [`LARGEST_SCALE`]. A scale below 1 counts as 1, so
    /// that no removal of a node can break the bound.
    pub(super) fn check_scales(&self) -> Result<(), SceneError> {
        let mut world_from_node: Vec<f64> = Vec::with_capacity(self.nodes().len());
        for node in self.nodes() {
            let world_from_parent = node.parent.map_or(1.0, |parent| world_from_node[parent.get()]);
            let own = match &node.kind {
                NodeKind::Control(tracks) => tracks.largest_scale().max(1.0),
                NodeKind::Rbt(_) | NodeKind::Shape(_) => 1.0,
            };
            let scale = world_from_parent * own;
            if scale > LARGEST_SCALE {
                return Err(SceneError::TooLarge { path: node.path.clone(), scale });
            }
            world_from_node.push(scale);
        }
        Ok(())
    }
}

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
        if are_coordinates(value) {
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
