//! Capsules.

use glam::Vec3;
use serde::Deserialize;

use super::Solid;
use super::ray::{enter_cylinder, enter_sphere};
use crate::scene::checks::NodeChecks;
use crate::scene::file::SceneError;
use crate::scene::shape::MeshKind;
use crate::scene::write::number;
use crate::words::texts;

/// A cylinder along Y with a half ball at each end.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Capsule {
    /// Radius in scene units.
    pub radius: f32,
    /// Full height, both caps included; at least twice the radius.
    pub height: f32,
}

impl Solid for Capsule {
    fn name(&self) -> &'static str {
        "capsule"
    }

    fn mesh(&self) -> Option<MeshKind> {
        Some(MeshKind::Capsule)
    }

    fn check(&self, checks: NodeChecks<'_>) -> Result<(), SceneError> {
        checks.length("radius", self.radius)?;
        if self.height < 2.0 * self.radius {
            return Err(checks.error("height", self.height.to_string(), texts::SCENE_EXPECTED_HEIGHT));
        }
        checks.length("height", self.height).map(|_| ())
    }

    fn half_extents(&self) -> Vec3 {
        Vec3::new(self.radius, self.height * 0.5, self.radius)
    }

    fn rounding(&self) -> f32 {
        self.radius
    }

    fn reach(&self, direction: Vec3) -> f32 {
        (self.height * 0.5 - self.radius) * direction.y.abs() + self.radius * direction.length()
    }

    fn enter(&self, origin: Vec3, direction: Vec3) -> Option<f32> {
        let half = self.height * 0.5 - self.radius;
        let ball = |y: f32| enter_sphere(origin, direction, Vec3::Y * y, self.radius);
        let parts = [enter_cylinder(origin, direction, self.radius, half), ball(half), ball(-half)];
        parts.into_iter().flatten().min_by(f32::total_cmp)
    }

    fn fields(&self) -> Vec<(&'static str, String)> {
        vec![("radius", number(self.radius)), ("height", number(self.height))]
    }
}
