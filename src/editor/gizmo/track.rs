//! From a pointer's way over the view to a pull of a handle.

use glam::{DVec2, Vec2, Vec3};

use super::{Gizmo, Handle, HandleKind, Pull, SnapSteps};

/// Rings that are seen from their edge, by this cosine or less, turn by the way along them, not by the angle around the centre.
const EDGE_ON: f32 = 0.25;
/// Arrows that point along the line of sight, by this squared sine or less, move by the way up or down.
const ALONG_SIGHT: f32 = 0.02;
/// The part of the pointer's way that counts in a fine drag.
const FINE: f64 = 0.1;
/// Amounts beyond this come from a pointer near a vanishing point, and are left out.
const LARGEST: f64 = 1e6;

/// How a drag goes on: which modifiers are held.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Steps {
    /// The steps to which it snaps.
    pub snap: Option<SnapSteps>,
    /// Whether the pointer's way counts a tenth, and the steps as well.
    pub is_fine: bool,
}

/// A handle that follows the pointer. Its gizmo is that of the drag's beginning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Track {
    gizmo: Gizmo,
    handle: Handle,
    at_px: Vec2,
    /// How far the pointer has pulled, before snapping: degrees or units, along the handle's directions.
    amounts: DVec2,
}

impl Track {
    /// A handle that is taken at a pixel.
    #[must_use]
    pub const fn new(gizmo: Gizmo, handle: Handle, at_px: Vec2) -> Self {
        Self { gizmo, handle, at_px, amounts: DVec2::ZERO }
    }

    /// The handle.
    #[must_use]
    pub const fn handle(&self) -> Handle {
        self.handle
    }

    /// The pointer is at a pixel: the pull since the handle was taken.
    pub fn move_to(&mut self, at_px: Vec2, steps: Steps) -> Pull {
        let from_px = std::mem::replace(&mut self.at_px, at_px);
        if let Some(by) = self.between(from_px, at_px).filter(|by| by.is_finite() && by.abs().max_element() < LARGEST) {
            self.amounts += if steps.is_fine { by * FINE } else { by };
        } else {
            // The pointer is where the handle cannot follow; the way goes on where it can again.
            self.at_px = from_px;
        }
        self.handle.pulled(self.snapped(steps).to_array())
    }

    fn snapped(&self, steps: Steps) -> DVec2 {
        let Some(snap) = steps.snap else { return self.amounts };
        let step = if self.handle.kind == HandleKind::Turn { snap.degrees } else { snap.units };
        let step = if steps.is_fine { step * FINE } else { step };
        (self.amounts / step).round() * step
    }

    fn between(&self, from_px: Vec2, to_px: Vec2) -> Option<DVec2> {
        match self.handle.kind {
            HandleKind::Turn => self.turn(from_px, to_px).map(|degrees| DVec2::new(degrees, 0.0)),
            HandleKind::Move => {
                let axis = self.gizmo.unit_in_world(self.handle.axes, self.handle.axis);
                Some(DVec2::new(self.along(axis, to_px)? - self.along(axis, from_px)?, 0.0))
            }
            HandleKind::Plane => Some(self.in_plane(to_px)? - self.in_plane(from_px)?),
        }
    }

    /// By how many degrees a ring turns: the angle around the centre in its plane, or the way along a ring that is seen from its edge.
    fn turn(&self, from_px: Vec2, to_px: Vec2) -> Option<f64> {
        let [first, second, normal] = self.gizmo.ring_axes(self.handle)?;
        if normal.z.abs() < EDGE_ON {
            let along = normal.cross(Vec3::Z).truncate().try_normalize()?;
            let by_px = Vec2::new(to_px.x - from_px.x, from_px.y - to_px.y);
            return Some(f64::from(by_px.dot(along) / self.gizmo.radius_px).to_degrees());
        }
        let columns = glam::DMat2::from_cols(first.truncate().as_dvec2(), second.truncate().as_dvec2());
        let in_plane = columns.inverse();
        let angle = |at_px: Vec2| {
            let from_centre = (at_px - self.gizmo.centre_px).as_dvec2();
            let at = in_plane * DVec2::new(from_centre.x, -from_centre.y);
            // At the very centre there is no angle.
            (at.length_squared() > 1.0).then(|| at.y.atan2(at.x).to_degrees())
        };
        let by = angle(to_px)? - angle(from_px)?;
        Some(by - 360.0 * (by / 360.0).round())
    }

    /// How many units of an axis through the centre the ray through a pixel is away, where the two are nearest.
    fn along(&self, axis: Vec3, at_px: Vec2) -> Option<f64> {
        let gizmo = &self.gizmo;
        let to_centre = (gizmo.centre_in_world - gizmo.camera.world_from_eye.translation).as_dvec3();
        let axis = axis.as_dvec3();
        let sight = to_centre.normalize();
        if sight.cross(axis).length_squared() < f64::from(ALONG_SIGHT) * axis.length_squared() {
            let units = f64::from((at_px.y - gizmo.centre_px.y) * gizmo.units_per_pixel());
            return Some(-units * sight.dot(axis).signum() / axis.length());
        }
        let ray = gizmo.camera.ray_through(at_px).direction_in_world.as_dvec3();
        let across = ray.cross(axis);
        let square = across.length_squared();
        // From the eye: `ray * depth` is nearest to `to_centre + axis * units`.
        let depth = to_centre.cross(axis).dot(across) / square;
        let units = to_centre.cross(ray).dot(across) / square;
        (depth > 0.0).then_some(units)
    }

    /// How many units along its two axes the point of the handle's plane under a pixel is from the centre.
    fn in_plane(&self, at_px: Vec2) -> Option<DVec2> {
        let gizmo = &self.gizmo;
        let [first, second] = *self.handle.directions() else { return None };
        let unit = |axis| gizmo.unit_in_world(self.handle.axes, axis).as_dvec3();
        let (first, second) = (unit(first), unit(second));
        let normal = first.cross(second);
        let to_centre = (gizmo.centre_in_world - gizmo.camera.world_from_eye.translation).as_dvec3();
        let ray = gizmo.camera.ray_through(at_px).direction_in_world.as_dvec3();
        let depth = to_centre.dot(normal) / ray.dot(normal);
        if !depth.is_finite() || depth <= 0.0 {
            return None;
        }
        let from_centre = ray * depth - to_centre;
        let square = normal.length_squared();
        Some(DVec2::new(from_centre.cross(second).dot(normal), first.cross(from_centre).dot(normal)) / square)
    }
}
