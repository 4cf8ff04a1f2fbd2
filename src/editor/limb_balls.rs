//! Balls at the ends of limbs: what a press in the view takes hold of, and where a drag leads it.

use glam::{Vec2, Vec3};

use super::Editor;
use crate::camera::Camera;
use crate::pose::RbtIndex;

/// The end of a limb, which can be dragged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LimbBall {
    /// The limb's last node.
    pub last: RbtIndex,
    /// The end in world space.
    pub end_in_world: Vec3,
}

impl Editor {
    /// The ball of a limb as it is displayed; `None` if the scene names no end of it.
    #[must_use]
    pub fn limb_ball(&self, last: RbtIndex) -> Option<LimbBall> {
        let scene = self.scene();
        if last.get() >= scene.rbt_count() {
            return None;
        }
        let node = scene.rbt_node(last);
        let end = scene.node(node).joint.reach?;
        let world_from_last = scene.world_from_node(&self.displayed_pose(), self.seconds(), node);
        Some(LimbBall { last, end_in_world: world_from_last.transform_point3(end) })
    }

    /// The balls to show: those of the robots of the chosen nodes and of the node under the pointer. None while something plays.
    #[must_use]
    pub fn limb_balls(&self, hovered: Option<RbtIndex>) -> Vec<LimbBall> {
        let nodes = self.session.chosen.iter().copied().chain(hovered);
        let shown: Vec<RbtIndex> = nodes.map(|rbt| self.scene().topmost(rbt)).collect();
        let is_shown = |last: &RbtIndex| !self.is_playing() && shown.contains(&self.scene().topmost(*last));
        self.scene().limb_ends().filter(is_shown).filter_map(|last| self.limb_ball(last)).collect()
    }

    /// The ball that a press at a pixel takes, `reach_px` around it: the nearest to the pixel, whether it is shown or not. None while
    /// something plays.
    #[must_use]
    pub fn limb_ball_at(&self, camera: &Camera, at_px: Vec2, reach_px: f32) -> Option<LimbBall> {
        if self.is_playing() {
            return None;
        }
        let balls = self.scene().limb_ends().filter_map(|last| {
            let ball = self.limb_ball(last)?;
            let (seen_px, depth) = camera.project(ball.end_in_world)?;
            let distance = seen_px.distance(at_px);
            (distance <= reach_px).then_some((distance, depth, ball))
        });
        // Of two in one place the nearer to the eye.
        balls.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))).map(|(_, _, ball)| ball)
    }
}

/// A point after a drag by so many pixels (y down), in world space: in the plane through it that is parallel to the view, or along the
/// view, down towards the eye. `None` if the point is behind the eye.
#[must_use]
pub fn dragged_point(camera: &Camera, point_in_world: Vec3, by_px: Vec2, is_along_view: bool) -> Option<Vec3> {
    let (_, depth) = camera.project(point_in_world)?;
    let units_per_pixel = camera.units_per_pixel_at_unit_depth() * depth;
    let by_in_eye = if is_along_view { Vec3::new(0.0, 0.0, by_px.y) } else { Vec3::new(by_px.x, -by_px.y, 0.0) };
    Some(point_in_world + camera.world_from_eye.transform_vector(by_in_eye * units_per_pixel))
}
