//! Cones.

use glam::{Vec3, Vec3Swizzles as _};
use serde::Deserialize;

use super::Solid;
use crate::scene::checks::NodeChecks;
use crate::scene::file::SceneError;
use crate::scene::shape::MeshKind;
use crate::scene::write::number;

/// A cone along Y: its apex at y = +height/2, its base at y = −height/2.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cone {
    /// Radius of the base.
    pub radius: f32,
    /// Full height in scene units.
    pub height: f32,
}

impl Solid for Cone {
    fn name(&self) -> &'static str {
        "cone"
    }

    fn mesh(&self) -> Option<MeshKind> {
        Some(MeshKind::Cone)
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
        let half = self.height * 0.5;
        (half * direction.y).max(self.radius * direction.xz().length() - half * direction.y)
    }

    fn enter(&self, origin: Vec3, direction: Vec3) -> Option<f32> {
        let Self { radius, height } = *self;
        let slope = radius / height;
        let below_apex = height * 0.5 - origin.y;
        let (a, half_b, c) = (
            direction.xz().length_squared() - (slope * direction.y).powi(2),
            origin.xz().dot(direction.xz()) + slope * slope * below_apex * direction.y,
            origin.xz().length_squared() - (slope * below_apex).powi(2),
        );
        let within = |distance: f32| {
            let hit = origin + direction * distance;
            (distance > 0.0 && hit.y.abs() <= height * 0.5 + 1e-6 * height).then_some(distance)
        };
        let discriminant = half_b * half_b - a * c;
        let side = if a == 0.0 || discriminant < 0.0 {
            [None, None]
        } else {
            let root = discriminant.sqrt();
            [within((-half_b - root) / a), within((-half_b + root) / a)]
        };
        let to_base = (-height * 0.5 - origin.y) / direction.y;
        let on_base = origin + direction * to_base;
        let base = (to_base > 0.0 && to_base.is_finite() && on_base.xz().length() <= radius).then_some(to_base);
        let is_inside = origin.y.abs() < height * 0.5 && c < 0.0;
        if is_inside {
            return None;
        }
        side.into_iter().chain([base]).flatten().min_by(f32::total_cmp)
    }

    fn fields(&self) -> Vec<(&'static str, String)> {
        vec![("radius", number(self.radius)), ("height", number(self.height))]
    }
}
