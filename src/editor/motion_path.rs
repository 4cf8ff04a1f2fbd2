//! The motion path: where the chosen node stands in each keyframe, as dots that can be taken and moved in the view.

use glam::{Affine3A, Vec2, Vec3};

use super::Editor;
use crate::camera::Camera;
use crate::keyframe::KeyframeIndex;
use crate::pose::RbtIndex;

/// A dot of the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathDot {
    /// The keyframe that it stands for.
    pub keyframe: KeyframeIndex,
    /// The node whose path it is.
    pub rbt: RbtIndex,
    /// Its centre, in world space.
    pub centre_in_world: Vec3,
}

impl Editor {
    /// The node whose path is shown: the chosen one, of several the primary, unless it is the eye, whose path would end at itself.
    #[must_use]
    pub fn path_node(&self) -> Option<RbtIndex> {
        self.session.chosen.primary().filter(|&chosen| self.session.shows_motion_path && Some(chosen) != self.eye())
    }

    /// The dot of a keyframe, where there is a path and the keyframe is in the list.
    #[must_use]
    pub fn path_dot(&self, keyframe: KeyframeIndex) -> Option<PathDot> {
        let rbt = self.path_node().filter(|_| self.document.keyframes.len() > 1)?;
        let pose = &self.document.keyframes.get(keyframe)?.pose;
        let node = self.scene().rbt_node(rbt);
        let centre_in_world = self.scene().world_from_node(pose, self.seconds(), node).translation.into();
        Some(PathDot { keyframe, rbt, centre_in_world })
    }

    /// The dot that a press at a pixel takes, `reach_px` around it: the nearest to the pixel. None while something plays. The current
    /// keyframe's dot is left to the arcball where that is around it.
    #[must_use]
    pub fn path_dot_at(&self, camera: &Camera, at_px: Vec2, reach_px: f32) -> Option<PathDot> {
        if self.is_playing() {
            return None;
        }
        self.path_node()?;
        let current = self.document.keyframes.current();
        let arcball = self.manipulation(camera).arcball.filter(|_| self.session.shows_arcball);
        (0..self.document.keyframes.len())
            .filter_map(|index| {
                let dot = self.path_dot(KeyframeIndex::new(index))?;
                let (seen_px, _) = camera.project(dot.centre_in_world)?;
                let distance = seen_px.distance(at_px);
                let is_under_arcball = Some(dot.keyframe) == current
                    && arcball.is_some_and(|ball| ball.centre_px.distance(seen_px) < ball.radius_px);
                (distance <= reach_px && !is_under_arcball).then_some((distance, dot))
            })
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, dot)| dot)
    }

    /// Where a node goes in a keyframe, in its parent's space, when its dot is moved by `by_px` pixels (y down) in the plane through it
    /// that is parallel to the view. `None` where the dot is behind the eye, or its parent has no inverse.
    #[must_use]
    pub fn path_dot_moved(&self, camera: &Camera, dot: PathDot, by_px: Vec2) -> Option<Vec3> {
        let pose = &self.document.keyframes.get(dot.keyframe)?.pose;
        let (seen_px, depth) = camera.project(dot.centre_in_world)?;
        let ray = camera.ray_through(seen_px + by_px);
        let to_in_world = ray.origin_in_world + ray.direction_in_world * depth;
        let world_from_parent: Affine3A = self.scene().world_from_parent(pose, self.seconds(), dot.rbt);
        let translation = world_from_parent.inverse().transform_point3(to_in_world);
        translation.is_finite().then_some(translation)
    }
}
