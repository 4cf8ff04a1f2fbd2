//! Limbs of a scene: which nodes reach with which end, and how they stand under a pose.

use glam::{Affine3A, DAffine3, DMat3, DQuat, DVec3, Quat, Vec3};

use super::graph::{NodeId, NodeKind, SceneGraph};
use crate::limb::{Limb, Stance, angle_towards};
use crate::pose::{Pose, RbtIndex};

/// How far the axes of a space may be from equally long and square, in parts of their length.
const EVEN: f64 = 1e-4;

/// Why a node cannot reach.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimbError {
    /// The node has neither `reach` nor a shape.
    NoEnd,
    /// A control node scales differently along its axes, so that a limb below it changes its length when it turns.
    Squeezed,
}

/// The nodes that a limb turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LimbNodes {
    /// The RBT node above the last one; `None` if there is none, and the last node turns alone.
    pub upper: Option<RbtIndex>,
    /// The last node, which carries the end.
    pub last: RbtIndex,
}

/// A limb under a pose.
#[derive(Clone, Copy, Debug)]
pub struct PosedLimb {
    nodes: LimbNodes,
    form: Form,
    /// From the space that carries the root joint, with that joint at its origin, to world space.
    world_from_base: DAffine3,
    /// The rotation of the same.
    world_from_base_rotation: DQuat,
}

#[derive(Clone, Copy, Debug)]
enum Form {
    /// A bone that turns freely about the root joint, and another one below it; without that the limb's lower bone has no length.
    Ball { limb: Limb, stance: Stance, lower: Option<Lower> },
    /// One bone that turns about its hinge: its end at an angle of 0, axis and range, the rotation at an angle of 0, and the angle.
    Hinged { end: DVec3, axis: DVec3, range: [f64; 2], at_zero: DQuat, angle: f64 },
}

/// The lower node of two: its rotation is about the axis by the hinge's angle, after that at an angle of 0.
#[derive(Clone, Copy, Debug)]
struct Lower {
    axis_in_parent: DVec3,
    at_zero: DQuat,
    /// The rotation from its parent's space to the upper node's: control nodes may stand between them.
    upper_from_parent: DQuat,
}

impl Lower {
    fn rotation(&self, angle: f64) -> DQuat {
        DQuat::from_axis_angle(self.axis_in_parent, angle) * self.at_zero
    }
}

/// The rotation of a linear map that scales all axes alike, and the scale.
fn even(linear: DMat3) -> Result<(DQuat, f64), LimbError> {
    let scale = linear.determinant().cbrt();
    let unit = linear * scale.recip();
    let product = unit.transpose() * unit;
    if scale > 0.0 && scale.is_finite() && product.abs_diff_eq(DMat3::IDENTITY, EVEN) {
        Ok((DQuat::from_mat3(&unit).normalize(), scale))
    } else {
        Err(LimbError::Squeezed)
    }
}

/// The angle in radians, from -π to π, of a rotation's part about a unit axis.
fn twist(rotation: DQuat, axis: DVec3) -> f64 {
    let (sine, cosine) = (rotation.xyz().dot(axis), rotation.w);
    // The other sign is the same rotation.
    let (sine, cosine) = if cosine < 0.0 { (-sine, -cosine) } else { (sine, cosine) };
    if sine == 0.0 && cosine == 0.0 { 0.0 } else { 2.0 * sine.atan2(cosine) }
}

impl SceneGraph {
    /// The nodes of the limb that ends with a node.
    #[must_use]
    pub fn limb_nodes(&self, last: RbtIndex) -> LimbNodes {
        let above = self.node(self.rbt_node(last)).parent;
        LimbNodes { upper: above.and_then(|above| self.carrying_rbt(above)), last }
    }

    /// The RBT nodes with an end that the scene names.
    pub fn limb_ends(&self) -> impl Iterator<Item = RbtIndex> {
        self.rbt_indices().filter(|&rbt| self.node(self.rbt_node(rbt)).joint.reach.is_some())
    }

    /// Whether a node is above another one.
    #[must_use]
    pub fn is_above(&self, above: RbtIndex, below: RbtIndex) -> bool {
        above != below && self.subtree(self.rbt_node(above)).contains(&self.rbt_node(below).get())
    }

    /// The topmost RBT node above a node, or the node itself: a robot of its parts.
    #[must_use]
    pub fn topmost(&self, rbt: RbtIndex) -> RbtIndex {
        std::iter::successors(Some(rbt), |&rbt| self.limb_nodes(rbt).upper).last().unwrap_or(rbt)
    }

    /// The end of the limb that a node ends, in the node's space: as the scene names it, or the farthest point of its last shape.
    #[must_use]
    pub fn limb_end(&self, last: RbtIndex, seconds: f64) -> Option<Vec3> {
        let node = self.rbt_node(last);
        self.node(node).joint.reach.or_else(|| self.far_end(node, seconds))
    }

    /// The farthest point of the last shape that a node carries, from the node's origin towards the shape's middle, in the node's space.
    fn far_end(&self, node: NodeId, seconds: f64) -> Option<Vec3> {
        let (shape, placed) = self.subtree(node).rev().find_map(|index| {
            let id = self.id_at(index)?;
            let NodeKind::Shape(placed) = &self.node(id).kind else { return None };
            let carrying = self.carrying_rbt(id).map(|rbt| self.rbt_node(rbt));
            (carrying == Some(node)).then_some((id, placed))
        })?;
        let node_from_shape = self.transform(Some(node), Some(shape), seconds, |_| Affine3A::IDENTITY);
        let middle = node_from_shape.translation.as_vec3();
        let direction = middle
            .try_normalize()
            .unwrap_or_else(|| (node_from_shape.matrix3 * DVec3::Y).as_vec3().try_normalize().unwrap_or(Vec3::Y));
        let direction_in_shape = (node_from_shape.matrix3.transpose() * direction.as_dvec3()).as_vec3();
        Some(middle + direction * placed.shape.reach(direction_in_shape))
    }

    /// The transform from a node's space to that of a node above it, in double precision; `None`: world space.
    fn transform(
        &self,
        target: Option<NodeId>,
        node: Option<NodeId>,
        seconds: f64,
        parent_from_rbt: impl Fn(RbtIndex) -> Affine3A,
    ) -> DAffine3 {
        let mut target_from_node = DAffine3::IDENTITY;
        let mut next = node;
        while next != target
            && let Some(id) = next
        {
            let node = self.node(id);
            target_from_node = node.parent_from_node(seconds, &parent_from_rbt).as_daffine3() * target_from_node;
            next = node.parent;
        }
        target_from_node
    }

    /// The limb that ends with a node, as it stands under a pose.
    ///
    /// `from`: the pose before the limb began to reach. What a hinge does not turn, and the plane and side to which a joint without
    /// limits is bent, are taken from it, so that a drag through the straight limb does not lose them.
    ///
    /// # Errors
    /// [`LimbError`]
    pub fn limb(&self, from: &Pose, pose: &Pose, seconds: f64, last: RbtIndex) -> Result<PosedLimb, LimbError> {
        let parent_from_rbt = |rbt: RbtIndex| pose.get(rbt).to_affine();
        let nodes = self.limb_nodes(last);
        let last_node = self.node(self.rbt_node(last));
        let end = self.limb_end(last, seconds).ok_or(LimbError::NoEnd)?.as_dvec3();
        let root = self.rbt_node(nodes.upper.unwrap_or(last));
        let world_from_parent = self.transform(None, self.node(root).parent, seconds, parent_from_rbt);
        let root_joint = pose.get(nodes.upper.unwrap_or(last)).translation.as_dvec3();
        let world_from_base = world_from_parent * DAffine3::from_translation(root_joint);
        let (world_from_base_rotation, _) = even(world_from_base.matrix3)?;
        let rotation = |pose: &Pose, rbt| pose.get(rbt).rotation.as_dquat().normalize();
        let rest = rotation(self.rest_pose(), last);
        let now = rotation(pose, last);
        let hinge = last_node.joint.hinge.map(|hinge| {
            let axis = hinge.unit_axis();
            let before = rest.conjugate() * rotation(from, last);
            let at_zero = rest * DQuat::from_axis_angle(axis, -twist(before, axis)) * before;
            (rest * axis, at_zero, hinge.range())
        });
        let angle = |axis, at_zero: DQuat| twist(now * at_zero.conjugate(), axis);
        let Some(upper) = nodes.upper else {
            let form = match hinge {
                None => {
                    let limb = Limb { upper: end, lower: DVec3::ZERO, axis: DVec3::X, range: [0.0; 2] };
                    Form::Ball { limb, stance: Stance { root: now, angle: 0.0 }, lower: None }
                }
                Some((axis, at_zero, range)) => {
                    Form::Hinged { end: at_zero * end, axis, range, at_zero, angle: angle(axis, at_zero) }
                }
            };
            return Ok(PosedLimb { nodes, form, world_from_base, world_from_base_rotation });
        };
        let upper_node = self.rbt_node(upper);
        let upper_from_parent = self.transform(Some(upper_node), last_node.parent, seconds, parent_from_rbt);
        let (turn, scale) = even(upper_from_parent.matrix3)?;
        let bone = upper_from_parent.transform_point3(pose.get(last).translation.as_dvec3());
        let lower_bone = |rotation: DQuat| turn * (rotation * end) * scale;
        let (limb, axis_in_parent, at_zero) = if let Some((axis, at_zero, range)) = hinge {
            (Limb { upper: bone, lower: lower_bone(at_zero), axis: turn * axis, range }, axis, at_zero)
        } else {
            let at_zero = rotation(from, last);
            let at_rest = bone.cross(lower_bone(rest)).try_normalize().unwrap_or(DVec3::X);
            let limb = Limb::free(bone, lower_bone(at_zero), at_rest);
            (limb, turn.conjugate() * limb.axis, at_zero)
        };
        let stance = Stance { root: rotation(pose, upper), angle: angle(axis_in_parent, at_zero) };
        let lower = Some(Lower { axis_in_parent, at_zero, upper_from_parent: turn });
        Ok(PosedLimb { nodes, form: Form::Ball { limb, stance, lower }, world_from_base, world_from_base_rotation })
    }
}

impl PosedLimb {
    /// The nodes that it turns.
    #[must_use]
    pub const fn nodes(&self) -> LimbNodes {
        self.nodes
    }

    /// Whether what carries it is where it is for another one.
    #[must_use]
    pub fn is_carried_as(&self, other: &Self) -> bool {
        self.world_from_base == other.world_from_base
    }

    fn end_in_base(&self) -> DVec3 {
        match self.form {
            Form::Ball { limb, stance, .. } => limb.end(stance),
            Form::Hinged { end, axis, angle, .. } => DQuat::from_axis_angle(axis, angle) * end,
        }
    }

    /// Where its end is, in world space.
    #[must_use]
    pub fn end_in_world(&self) -> DVec3 {
        self.world_from_base.transform_point3(self.end_in_base())
    }

    /// The rotation of the last node in world space.
    #[must_use]
    pub fn world_from_last(&self) -> DQuat {
        let in_base = match self.form {
            Form::Ball { stance, lower: None, .. } => stance.root,
            Form::Ball { stance, lower: Some(lower), .. } => {
                stance.root * lower.upper_from_parent * lower.rotation(stance.angle)
            }
            Form::Hinged { axis, at_zero, angle, .. } => DQuat::from_axis_angle(axis, angle) * at_zero,
        };
        self.world_from_base_rotation * in_base
    }

    /// It with its end as near to a point in world space as bones and limits allow.
    #[must_use]
    pub fn reaching(mut self, target_in_world: DVec3) -> Self {
        let target = self.world_from_base.inverse().transform_point3(target_in_world);
        match &mut self.form {
            Form::Ball { limb, stance, .. } => *stance = limb.reach(*stance, target),
            Form::Hinged { end, axis, range, angle, .. } => {
                *angle = angle_towards(*axis, *end, *range, *angle, target);
            }
        }
        self
    }

    /// It turned by radians about the line from its root joint to its end, right-handed along it. `None` if the two are one point, or a
    /// single bone has a hinge.
    #[must_use]
    pub fn swivelled(mut self, radians: f64) -> Option<Self> {
        let Form::Ball { limb, stance, .. } = &mut self.form else { return None };
        *stance = limb.swivelled(*stance, radians)?;
        Some(self)
    }

    /// It with its end at a point in world space and its last node turned as little from a rotation in world space as that allows.
    #[must_use]
    pub fn standing(self, end_in_world: DVec3, world_from_last: DQuat) -> Self {
        let mut reaching = self.reaching(end_in_world);
        let wanted = self.world_from_base_rotation.conjugate() * world_from_last;
        if let Form::Ball { limb, stance, lower } = &mut reaching.form {
            let last_in_upper = lower.map_or(DQuat::IDENTITY, |lower| lower.upper_from_parent * lower.at_zero);
            *stance = limb.facing(*stance, last_in_upper, wanted);
        }
        reaching
    }

    /// The rotations of its nodes in their parents' spaces.
    pub fn rotations(&self) -> impl Iterator<Item = (RbtIndex, Quat)> {
        let LimbNodes { upper, last } = self.nodes;
        let (upper, turn) = match self.form {
            Form::Ball { stance, lower: None, .. } => (None, stance.root),
            Form::Ball { stance, lower: Some(lower), .. } => {
                (upper.zip(Some(stance.root)), lower.rotation(stance.angle))
            }
            Form::Hinged { axis, at_zero, angle, .. } => (None, DQuat::from_axis_angle(axis, angle) * at_zero),
        };
        upper.into_iter().chain([(last, turn)]).map(|(rbt, turn)| (rbt, turn.normalize().as_quat().normalize()))
    }
}
