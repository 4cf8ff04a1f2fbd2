//! Boxes with rounded edges.

use glam::Vec3;
use serde::{Deserialize, Deserializer};

use super::Solid;
use super::ray::{entering, within_slab};
use crate::scene::checks::NodeChecks;
use crate::scene::file::SceneError;
use crate::scene::shape::MeshKind;
use crate::scene::write::{number, numbers};
use crate::words::texts;

/// A box with rounded edges.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RoundedBox {
    /// Full extents along x, y and z.
    #[serde(deserialize_with = "three_numbers")]
    pub size: Vec3,
    /// Radius of the rounded edges, at most half the smallest extent.
    #[serde(default)]
    pub bevel: f32,
}

impl Solid for RoundedBox {
    fn name(&self) -> &'static str {
        "box"
    }

    fn mesh(&self) -> Option<MeshKind> {
        Some(MeshKind::Box)
    }

    fn check(&self, checks: NodeChecks<'_>) -> Result<(), SceneError> {
        for extent in self.size.to_array() {
            checks.length("size", extent)?;
        }
        if !(self.bevel >= 0.0 && self.bevel <= self.size.min_element() * 0.5) {
            return Err(checks.error("bevel", self.bevel.to_string(), texts::SCENE_EXPECTED_BEVEL));
        }
        Ok(())
    }

    fn half_extents(&self) -> Vec3 {
        self.size * 0.5
    }

    fn rounding(&self) -> f32 {
        self.bevel
    }

    fn reach(&self, direction: Vec3) -> f32 {
        (self.size * 0.5 - self.bevel).dot(direction.abs()) + self.bevel * direction.length()
    }

    fn enter(&self, origin: Vec3, direction: Vec3) -> Option<f32> {
        let half = self.size * 0.5;
        let (mut enter, mut leave) = (f32::NEG_INFINITY, f32::INFINITY);
        for axis in 0..3 {
            let (low, high) = within_slab(origin[axis], direction[axis], half[axis])?;
            enter = enter.max(low);
            leave = leave.min(high);
        }
        entering(enter, leave)
    }

    fn fields(&self) -> Vec<(&'static str, String)> {
        vec![("size", numbers(&self.size.to_array())), ("bevel", number(self.bevel))]
    }
}

fn three_numbers<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec3, D::Error> {
    <[f32; 3]>::deserialize(deserializer).map(Vec3::from)
}
