//! Picking: the nearest shape that a ray meets.

use glam::{Affine3A, Vec3};

use super::graph::{NodeId, NodeKind, SceneGraph};
use super::shape::Shape;
use super::shapes::StandingSkin;
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
    /// The RBT node that carries it, or, of a skin, the joint that moves it most where the ray meets it; `None` for a plane, which is ground,
    /// and for what has no RBT node above it.
    pub rbt: Option<RbtIndex>,
    /// Whether the shape is a plane.
    pub is_ground: bool,
    /// How far along the ray, in lengths of its direction; above 0.
    pub distance: f32,
}

/// What a click takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// A node that poses record: it is chosen.
    Rbt(RbtIndex),
    /// A node that only keys at their own times move or colour: its keys are selected.
    Keyed(NodeId),
}

impl Part {
    /// The node that poses record.
    #[must_use]
    pub const fn rbt(self) -> Option<RbtIndex> {
        match self {
            Self::Rbt(rbt) => Some(rbt),
            Self::Keyed(_) => None,
        }
    }
}

/// The scene as it stands, for the rays of one look at it.
pub struct Picker<'a> {
    scene: &'a SceneGraph,
    /// Shapes, and how their rays are taken.
    shapes: Vec<(NodeId, Seen)>,
}

/// How rays meet a shape.
enum Seen {
    /// In its own space.
    Rigid {
        /// World space to the shape's.
        shape_from_world: Affine3A,
    },
    /// In world space, as its joints stand.
    Skin(StandingSkin),
}

impl Picker<'_> {
    /// The shapes that a ray meets in front of its origin, in the scene's order.
    ///
    /// Rounded edges of boxes are treated as sharp. A ray from inside a shape passes through it.
    fn hits(&self, ray: Ray) -> impl Iterator<Item = Pick> {
        self.shapes.iter().filter_map(move |(shape, seen)| {
            let shape = *shape;
            let NodeKind::Shape(placed) = &self.scene.node(shape).kind else { return None };
            let Ray { origin_in_world, direction_in_world } = ray;
            let is_ground = placed.shape.is_ground();
            let (distance, moved_by) = match (seen, &placed.shape) {
                (Seen::Skin(skin), Shape::Mesh(mesh)) => mesh.enter_skin(skin, origin_in_world, direction_in_world)?,
                (Seen::Rigid { shape_from_world }, of_shape) => {
                    let origin = shape_from_world.transform_point3(origin_in_world);
                    (of_shape.enter(origin, shape_from_world.transform_vector3(direction_in_world))?, shape)
                }
                (Seen::Skin(_), _) => return None,
            };
            let rbt = self.scene.carrying_rbt(moved_by).filter(|_| !is_ground);
            Some(Pick { shape, rbt, is_ground, distance })
        })
    }

    /// The nearest shape that a ray meets.
    #[must_use]
    pub fn nearest(&self, ray: Ray) -> Option<Pick> {
        self.hits(ray).min_by(|a, b| a.distance.total_cmp(&b.distance))
    }

    /// The nodes whose shapes a ray meets, nearest first, each once.
    #[must_use]
    pub fn nodes_along(&self, ray: Ray) -> Vec<RbtIndex> {
        let mut hits: Vec<Pick> = self.hits(ray).collect();
        hits.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        let mut nodes = Vec::new();
        for rbt in hits.into_iter().filter_map(|hit| hit.rbt) {
            if !nodes.contains(&rbt) {
                nodes.push(rbt);
            }
        }
        nodes
    }
}

impl SceneGraph {
    /// What rays meet under `pose`, `seconds` into the timed keys. The shapes of the node `from`, which is looked from, are not seen.
    #[must_use]
    pub fn picker(&self, pose: &Pose, seconds: f64, from: Option<RbtIndex>) -> Picker<'_> {
        let world_from_node = self.world_from_nodes(pose, seconds);
        let shapes = self.nodes_with_ids().filter_map(|(id, node)| {
            let is_seen = matches!(node.kind, NodeKind::Shape(_)) && (from.is_none() || self.carrying_rbt(id) != from);
            is_seen.then(|| {
                let seen = match self.skin(id) {
                    Some(skin) => {
                        let world_from_bind = skin.world_from_bind(|joint| world_from_node[joint.get()].get());
                        Seen::Skin(skin.standing(world_from_bind.collect()))
                    }
                    None => Seen::Rigid { shape_from_world: world_from_node[id.get()].get().inverse() },
                };
                (id, seen)
            })
        });
        Picker { scene: self, shapes: shapes.collect() }
    }

    /// The nearest shape that `ray` meets under `pose`, `seconds` into the timed keys, in front of the ray's origin.
    #[must_use]
    pub fn pick(&self, pose: &Pose, seconds: f64, ray: Ray) -> Option<Pick> {
        self.picker(pose, seconds, None).nearest(ray)
    }
}
