//! Which node the pointer is at.

use glam::Vec2;

use super::{Editor, Eye};
use crate::camera::Camera;
use crate::pose::RbtIndex;

/// How far from a part a click may miss it, in points.
pub const CLICK_REACH: f32 = 8.0;
/// Rings of rays around a pixel that meets no part, nearest first, and rays on each.
const RINGS: u8 = 4;
const RAYS_ON_RING: u8 = 12;

impl Editor {
    /// The node whose part is nearest to a pixel, at most `reach_px` away: what a click there chooses. The ground is no part.
    #[must_use]
    pub fn part_near(&self, camera: &Camera, at_px: Vec2, reach_px: f32) -> Option<RbtIndex> {
        let picker = self.scene().picker(&self.displayed_pose(), self.seconds(), self.eye());
        let rings = (1..=RINGS).flat_map(|ring| {
            let radius = reach_px * f32::from(ring) / f32::from(RINGS);
            (0..RAYS_ON_RING).map(move |ray| {
                let angle = std::f32::consts::TAU * f32::from(ray) / f32::from(RAYS_ON_RING);
                Vec2::from_angle(angle) * radius
            })
        });
        std::iter::once(Vec2::ZERO).chain(rings).find_map(|by| picker.nearest(camera.ray_through(at_px + by))?.rbt)
    }

    /// The node after the primary one, among those whose parts lie behind each other at a pixel, and the nearest after the farthest.
    /// What Ctrl+click chooses.
    #[must_use]
    pub fn part_behind(&self, camera: &Camera, at_px: Vec2, reach_px: f32) -> Option<RbtIndex> {
        let picker = self.scene().picker(&self.displayed_pose(), self.seconds(), self.eye());
        let behind = picker.nodes_along(camera.ray_through(at_px));
        let place = behind.iter().position(|&rbt| Some(rbt) == self.session().chosen.primary());
        match place {
            Some(place) => Some(behind[(place + 1) % behind.len()]),
            None => behind.first().copied().or_else(|| self.part_near(camera, at_px, reach_px)),
        }
    }

    /// Whether a pixel is inside of the arcball of the chosen nodes, while that shows.
    #[must_use]
    pub fn is_in_arcball(&self, camera: &Camera, at_px: Vec2) -> bool {
        let session = self.session();
        let shows = session.shows_arcball && !session.chosen.is_empty() && !self.is_playing();
        let arcball = shows.then(|| self.manipulation(camera).arcball).flatten();
        arcball.is_some_and(|ball| ball.centre_px.distance(at_px) < ball.radius_px)
    }

    /// Whether one looks from the work eye.
    #[must_use]
    pub fn is_work_eye(&self) -> bool {
        self.session().eye == Eye::Work
    }
}
