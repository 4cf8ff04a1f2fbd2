//! Cylinders.

use glam::{Vec3, Vec3Swizzles as _};
use serde::Deserialize;

use super::Solid;
use super::ray::enter_cylinder;
use crate::scene::checks::NodeChecks;
use crate::scene::file::SceneError;
use crate::scene::shape::MeshKind;
use crate::scene::write::number;

/// A cylinder along Y.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cylinder {
    /// Radius in scene units.
    pub radius: f32,
    /// Full height in scene units.
    pub height: f32,
}

impl Solid for Cylinder {
    fn name(&self) -> &'static str {
        "cylinder"
    }

    fn mesh(&self) -> Option<MeshKind> {
        Some(MeshKind::Cylinder)
    }

    fn check(&self, checks: NodeChecks<'_>) -> Result<(), SceneError> {
        checks.length("radius", self.radius)?;
        checks.length("height", self.height)?;
        Ok(())
    }

    fn half_extents(&self) -> Vec3 {
        Vec3::new(self.radius, self.height * 0.5, self.radius)
    }

    fn reach(&self, direction: Vec3) -> f32 {
        self.height * 0.5 * direction.y.abs() + self.radius * direction.xz().length()
    }

    fn enter(&self, origin: Vec3, direction: Vec3) -> Option<f32> {
        enter_cylinder(origin, direction, self.radius, self.height * 0.5)
    }

    fn fields(&self) -> Vec<(&'static str, String)> {
        vec![("radius", number(self.radius)), ("height", number(self.height))]
    }
}
