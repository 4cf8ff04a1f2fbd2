//! The turning of all mapped nodes, and the hips' way: everything but feet that stand.

use glam::{DAffine3, DQuat, DVec3};

use super::Source;
use super::map::{Foot, Pair, Pairs};
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;
use crate::scene::SceneGraph;

/// A bone that is shorter has no direction, in scene units.
const SHORTEST_BONE: f64 = 1e-6;

/// The target's poses before its feet are put down.
pub(super) struct Motion<'a> {
    pub target: &'a SceneGraph,
    pub seconds: Vec<f64>,
    pub poses: Vec<Pose>,
    /// For each pose the rotation in the world of each RBT node.
    pub rotations: Vec<Vec<DQuat>>,
    /// For each foot and each pose where its end would be, with the ground at 0.
    pub ends: Vec<Vec<DVec3>>,
    /// The height of each foot's end at rest: its ground.
    pub grounds: Vec<f64>,
    /// How much larger the target is.
    pub factor: f64,
    /// The topmost mapped node, which moves.
    pub top: RbtIndex,
}

/// How a mapped node follows.
struct Follower {
    pair: Pair,
    /// The inverse of the source's rotation in the world at rest.
    from_rest: DQuat,
    /// The target's rotation in the world at rest, its bone turned to where the source's bone points.
    aligned: DQuat,
}

impl<'a> Motion<'a> {
    pub fn of(source: Source<'_>, target: &'a SceneGraph, pairs: &Pairs) -> Self {
        let turn = DQuat::from_rotation_y(pairs.turn);
        let followers = followers(source.scene, target, pairs, turn);
        let legs = |length: fn(&Foot) -> f64| pairs.feet.iter().map(length).sum::<f64>();
        let factor = if pairs.feet.is_empty() {
            size(target, pairs.nodes.iter().map(|pair| pair.onto))
                / size(source.scene, pairs.nodes.iter().map(|pair| pair.from))
        } else {
            legs(|foot| foot.length) / legs(|foot| foot.from_length)
        };
        let factor = if factor.is_finite() && factor > 0.0 { factor } else { 1.0 };
        let way = Way::of(source, target, pairs, factor, turn);
        let mut motion = Self {
            target,
            seconds: source.samples.seconds().to_vec(),
            poses: Vec::new(),
            rotations: Vec::new(),
            ends: vec![Vec::new(); pairs.feet.len()],
            grounds: way.grounds.clone(),
            factor,
            top: pairs.nodes[0].onto,
        };
        let frame = Frame::of(target);
        for pose in source.samples.poses() {
            let world = world(source.scene, pose);
            let wanted = |rbt: RbtIndex| {
                let follower = followers.iter().find(|follower| follower.pair.onto == rbt)?;
                let now = rotation(&world[follower.pair.from.get()]) * follower.from_rest;
                Some((turn * now * turn.conjugate() * follower.aligned).normalize())
            };
            let (mut posed, rotations) = frame.posed(target.rest_pose(), wanted);
            let hips = way.hips(&world);
            let own = hips_of(&self::world(target, &posed), pairs.feet.iter().map(|foot| foot.upper), motion.top);
            move_by(target, &mut posed, motion.top, hips - own);
            let placed = self::world(target, &posed);
            for (index, foot) in pairs.feet.iter().enumerate() {
                // The end is as far from its own hip joint as the source's is.
                let leg = place(&world, foot.from_end) - world[foot.from_upper.get()].translation;
                let upper = placed[foot.upper.get()].translation;
                let mut end = upper + factor * (turn * leg);
                end.y = factor * (place(&world, foot.from_end).y - way.levels[index]);
                motion.ends[index].push(end);
            }
            motion.poses.push(posed);
            motion.rotations.push(rotations);
        }
        motion
    }
}

/// `world_from_node` of all RBT nodes.
pub(super) fn world(scene: &SceneGraph, pose: &Pose) -> Vec<DAffine3> {
    let all = scene.world_from_nodes_with(0.0, |rbt| pose.get(rbt).to_affine());
    scene.rbt_indices().map(|rbt| all[scene.rbt_node(rbt).get()].as_daffine3()).collect()
}

fn rotation(world_from_node: &DAffine3) -> DQuat {
    world_from_node.to_scale_rotation_translation().1.normalize()
}

fn place(world: &[DAffine3], (rbt, point): (RbtIndex, glam::Vec3)) -> DVec3 {
    world[rbt.get()].transform_point3(point.as_dvec3())
}

/// The middle of hip joints, or the place of a node where there are none.
fn hips_of(world: &[DAffine3], uppers: impl ExactSizeIterator<Item = RbtIndex>, otherwise: RbtIndex) -> DVec3 {
    #[expect(clippy::cast_precision_loss, reason = "there are a few legs")]
    let count = uppers.len() as f64;
    if count == 0.0 {
        return world[otherwise.get()].translation;
    }
    uppers.map(|rbt| world[rbt.get()].translation).sum::<DVec3>() / count
}

/// Moves a node in world space.
pub(super) fn move_by(scene: &SceneGraph, pose: &mut Pose, rbt: RbtIndex, by_in_world: DVec3) {
    let parent = scene.world_from_parent(pose, 0.0, rbt).as_daffine3();
    let by = parent.inverse().transform_vector3(by_in_world).as_vec3();
    let now = pose.get(rbt);
    pose.set(rbt, Rbt { translation: now.translation + by, ..now });
}

/// The extent of nodes at rest.
fn size(scene: &SceneGraph, nodes: impl Iterator<Item = RbtIndex>) -> f64 {
    let rest = world(scene, scene.rest_pose());
    let start = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (low, high) = nodes
        .map(|rbt| rest[rbt.get()].translation)
        .fold(start, |(low, high), point| (low.min(point), high.max(point)));
    (high - low).max_element()
}

fn followers(source: &SceneGraph, target: &SceneGraph, pairs: &Pairs, turn: DQuat) -> Vec<Follower> {
    let (from_rest, rest) = (world(source, source.rest_pose()), world(target, target.rest_pose()));
    let follower = |&pair: &Pair| {
        let bones = bones(source, target, pairs, pair, [&rest, &from_rest]);
        let align = bones.map_or(DQuat::IDENTITY, |(own, other)| DQuat::from_rotation_arc(own, turn * other));
        let from = rotation(&from_rest[pair.from.get()]).conjugate();
        Follower { pair, from_rest: from, aligned: align * rotation(&rest[pair.onto.get()]) }
    };
    pairs.nodes.iter().map(follower).collect()
}

/// Where the bones of a mapped node point at rest, its own and that of the source: to the only mapped node below, or to the end of a
/// limb. `None` where there is no such bone.
fn bones(
    source: &SceneGraph,
    target: &SceneGraph,
    pairs: &Pairs,
    pair: Pair,
    [rest, from_rest]: [&[DAffine3]; 2],
) -> Option<(DVec3, DVec3)> {
    let direction = |to: DVec3, from: DVec3| (to - from).try_normalize().filter(|_| to.distance(from) > SHORTEST_BONE);
    let is_next = |below: &&Pair| {
        let mut above = std::iter::successors(target.limb_nodes(below.onto).upper, |&rbt| target.limb_nodes(rbt).upper);
        above.find(|&rbt| pairs.nodes.iter().any(|pair| pair.onto == rbt)) == Some(pair.onto)
    };
    let (own, other) = (rest[pair.onto.get()].translation, from_rest[pair.from.get()].translation);
    let mut next = pairs.nodes.iter().filter(is_next);
    let (own_tip, other_tip) = match (next.next(), next.next()) {
        (Some(next), None) => (rest[next.onto.get()].translation, from_rest[next.from.get()].translation),
        (None, _) => {
            let end = target.node(target.rbt_node(pair.onto)).joint.reach?;
            let foot = pairs.feet.iter().find(|foot| foot.lower == pair.onto);
            let other_tip = foot.map(|foot| place(from_rest, foot.from_end));
            (place(rest, (pair.onto, end)), other_tip.or_else(|| tip(source, pair.from, from_rest))?)
        }
        _ => return None,
    };
    Some((direction(own_tip, own)?, direction(other_tip, other)?))
}

/// Where the bone of a node of the source ends: at the end of its limb, or at the first node below that is not at the same place.
fn tip(source: &SceneGraph, rbt: RbtIndex, world: &[DAffine3]) -> Option<DVec3> {
    let own = world[rbt.get()].translation;
    if let Some(end) = source.node(source.rbt_node(rbt)).joint.reach {
        return Some(place(world, (rbt, end)));
    }
    let below = source.rbt_indices().skip(rbt.get() + 1).take_while(|&below| source.is_above(rbt, below));
    below.map(|below| world[below.get()].translation).find(|tip| tip.distance(own) > SHORTEST_BONE)
}

/// The rotations that stand between RBT nodes: those of control nodes, and those above all.
pub(super) struct Frame<'a> {
    target: &'a SceneGraph,
    /// For each RBT node the RBT node above it, and the rotation from its parent's space to that node's.
    above: Vec<(Option<RbtIndex>, DQuat)>,
}

impl<'a> Frame<'a> {
    pub fn of(target: &'a SceneGraph) -> Self {
        let rest = world(target, target.rest_pose());
        let above = target.rbt_indices().map(|rbt| {
            let upper = target.limb_nodes(rbt).upper;
            let parent = rotation(&target.world_from_parent(target.rest_pose(), 0.0, rbt).as_daffine3());
            (upper, upper.map_or(parent, |upper| rotation(&rest[upper.get()]).conjugate() * parent))
        });
        Self { target, above: above.collect() }
    }

    /// A pose in which nodes have rotations in the world, and others those of `pose` in their parent's space; and all rotations in the
    /// world.
    pub fn posed(&self, pose: &Pose, wanted: impl Fn(RbtIndex) -> Option<DQuat>) -> (Pose, Vec<DQuat>) {
        let mut world: Vec<DQuat> = Vec::with_capacity(pose.len());
        let mut rbts = Vec::with_capacity(pose.len());
        for (rbt, own) in self.target.rbt_indices().zip(pose.iter()) {
            let (upper, between) = self.above[rbt.get()];
            let parent = upper.map_or(between, |upper| world[upper.get()] * between);
            let (rotation, in_world) = match wanted(rbt) {
                Some(wanted) => ((parent.conjugate() * wanted).normalize().as_quat().normalize(), wanted),
                None => (own.rotation, parent * own.rotation.as_dquat()),
            };
            rbts.push(Rbt { rotation, ..own });
            world.push(in_world);
        }
        (Pose::new(rbts), world)
    }
}

/// Where the target's hips go.
struct Way {
    factor: f64,
    turn: DQuat,
    uppers: Vec<RbtIndex>,
    otherwise: RbtIndex,
    /// The source's hips in the first sample, and the target's at rest.
    start: DVec3,
    own_start: DVec3,
    /// For each foot the height of the source's end when it stands.
    levels: Vec<f64>,
    /// For each foot the height of the target's end at rest.
    grounds: Vec<f64>,
}

impl Way {
    fn of(source: Source<'_>, target: &SceneGraph, pairs: &Pairs, factor: f64, turn: DQuat) -> Self {
        let rest = world(target, target.rest_pose());
        let first = world(source.scene, &source.samples.poses()[0]);
        let uppers: Vec<RbtIndex> = pairs.feet.iter().map(|foot| foot.from_upper).collect();
        let otherwise = pairs.nodes[0].from;
        let mut heights: Vec<Vec<f64>> = vec![Vec::with_capacity(source.samples.len()); pairs.feet.len()];
        for pose in source.samples.poses() {
            let world = world(source.scene, pose);
            for (heights, foot) in heights.iter_mut().zip(&pairs.feet) {
                heights.push(place(&world, foot.from_end).y);
            }
        }
        let level = |heights: &mut Vec<f64>| {
            heights.sort_by(f64::total_cmp);
            heights[heights.len() / 20]
        };
        Self {
            factor,
            turn,
            start: hips_of(&first, uppers.iter().copied(), otherwise),
            own_start: hips_of(&rest, pairs.feet.iter().map(|foot| foot.upper), pairs.nodes[0].onto),
            levels: heights.iter_mut().map(level).collect(),
            grounds: pairs.feet.iter().map(|foot| place(&rest, (foot.lower, foot.end)).y).collect(),
            uppers,
            otherwise,
        }
    }

    fn hips(&self, world: &[DAffine3]) -> DVec3 {
        let hips = hips_of(world, self.uppers.iter().copied(), self.otherwise);
        let mut own = self.own_start + self.factor * (self.turn * (hips - self.start));
        if !self.levels.is_empty() {
            // Above the ground on which the feet stand.
            let mean = |heights: &[f64]| heights.iter().sum::<f64>() / self.levels.len() as f64;
            own.y = mean(&self.grounds) + self.factor * (hips.y - mean(&self.levels));
        }
        own
    }
}
