//! Picking: the nearest shape that a ray meets.

use glam::Vec3;

use super::graph::{NodeId, NodeKind, SceneGraph};
use super::shape::Shape;
use crate::pose::{Pose, RbtIndex};

/// A half line in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// The start point, in world space.
    pub origin_in_world: Vec3,
    /// The direction, in world space; any length except zero.
    pub direction_in_world: Vec3,
}

/// The nearest hit of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pick {
    /// The shape's node.
    pub shape: NodeId,
    /// The RBT node that carries it; `None` for a plane, which is ground, and for a shape with no RBT node above it.
    pub rbt: Option<RbtIndex>,
    /// How far along the ray, in lengths of its direction; above 0.
    pub distance: f32,
}

impl SceneGraph {
    /// The nearest shape that `ray` meets under `pose`, `seconds` into the keys at their own times, in front of the ray's origin.
    ///
    /// Rounded edges of boxes are treated as sharp. A ray from inside a shape passes through it.
    #[must_use]
    pub fn pick(&self, pose: &Pose, seconds: f64, ray: Ray) -> Option<Pick> {
        let world_from_node = self.world_from_nodes(pose, seconds);
        let mut nearest: Option<Pick> = None;
        for (id, node) in self.nodes_with_ids() {
            let NodeKind::Shape(placed) = &node.kind else { continue };
            let shape_from_world = world_from_node[id.get()].get().inverse();
            let origin = shape_from_world.transform_point3(ray.origin_in_world);
            let direction = shape_from_world.transform_vector3(ray.direction_in_world);
            let Some(distance) = placed.shape.enter(origin, direction) else { continue };
            if nearest.is_none_or(|pick| distance < pick.distance) {
                let is_ground = matches!(placed.shape, Shape::Plane(_));
                nearest = Some(Pick { shape: id, rbt: self.carrying_rbt(id).filter(|_| !is_ground), distance });
            }
        }
        nearest
    }
}
