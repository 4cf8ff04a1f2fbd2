//! Balls.

use glam::Vec3;
use serde::Deserialize;

use super::Solid;
use super::ray::enter_sphere;
use crate::scene::checks::NodeChecks;
use crate::scene::file::SceneError;
use crate::scene::shape::MeshKind;
use crate::scene::write::number;

/// A ball.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sphere {
    /// Radius in scene units.
    pub radius: f32,
}

impl Solid for Sphere {
    fn name(&self) -> &'static str {
        "sphere"
    }

    fn mesh(&self) -> Option<MeshKind> {
        Some(MeshKind::Sphere)
    }

    fn check(&self, checks: NodeChecks<'_>) -> Result<(), SceneError> {
        checks.length("radius", self.radius).map(|_| ())
    }

    fn half_extents(&self) -> Vec3 {
        Vec3::splat(self.radius)
    }

    fn rounding(&self) -> f32 {
        self.radius
    }

    fn reach(&self, direction: Vec3) -> f32 {
        self.radius * direction.length()
    }

    fn enter(&self, origin: Vec3, direction: Vec3) -> Option<f32> {
        enter_sphere(origin, direction, Vec3::ZERO, self.radius)
    }

    fn fields(&self) -> Vec<(&'static str, String)> {
        vec![("radius", number(self.radius))]
    }
}
