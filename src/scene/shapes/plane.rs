//! Flat grounds.

use glam::Vec3;
use serde::Deserialize;

use super::Solid;
use crate::scene::checks::NodeChecks;
use crate::scene::file::SceneError;
use crate::scene::shape::MeshKind;
use crate::scene::write::numbers;

/// A flat square in the plane y = 0, seen from above; it carries the grid that fades with distance.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Plane {
    /// Full extents along x and z.
    pub size: [f32; 2],
}

impl Solid for Plane {
    fn name(&self) -> &'static str {
        "plane"
    }

    fn mesh(&self) -> Option<MeshKind> {
        Some(MeshKind::Plane)
    }

    fn check(&self, checks: NodeChecks<'_>) -> Result<(), SceneError> {
        for extent in self.size {
            checks.length("size", extent)?;
        }
        Ok(())
    }

    fn half_extents(&self) -> Vec3 {
        Vec3::new(self.size[0] * 0.5, 0.0, self.size[1] * 0.5)
    }

    fn reach(&self, direction: Vec3) -> f32 {
        self.half_extents().dot(direction.abs())
    }

    fn enter(&self, origin: Vec3, direction: Vec3) -> Option<f32> {
        let [x, z] = self.size;
        let distance = -origin.y / direction.y;
        let hit = origin + direction * distance;
        (distance > 0.0 && distance.is_finite() && hit.x.abs() <= x * 0.5 && hit.z.abs() <= z * 0.5).then_some(distance)
    }

    fn fields(&self) -> Vec<(&'static str, String)> {
        vec![("size", numbers(&self.size))]
    }
}
