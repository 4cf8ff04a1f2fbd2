//! Which nodes of a tree are legs, arms and head, told by the rest pose.
//!
//! Names differ from program to program, and some of them name sides as the viewer sees them. So positions decide: legs end lowest on
//! both sides, arms end farthest to the sides, and the head is the highest of the rest. Names say the side only where positions do not.

use glam::Vec3;

use crate::pose::RbtIndex;
use crate::rbt::Rbt;
use crate::scene::{Joint, SceneGraph};

/// Parts of the figure's size that count as nothing.
const NOTHING: f32 = 2e-3;
/// How far from the middle a tip has to be, in parts of the figure's size, to be on a side.
const ASIDE: f32 = 0.02;
/// Two bones are a limb if no other two together are longer by a quarter; the last such two count. A collarbone can be as long as a
/// forearm.
const LONG_ENOUGH: f32 = 0.8;

/// A leg or an arm: the nodes from the trunk down.
#[derive(Clone, Debug, PartialEq)]
pub struct Extremity {
    /// The nodes above the upper one, from the trunk.
    pub before: Vec<RbtIndex>,
    /// The node that carries the upper arm or the thigh.
    pub upper: RbtIndex,
    /// The node that carries the forearm or the shin.
    pub lower: RbtIndex,
    /// Where that ends, in the lower node's space.
    pub end_in_lower: Vec3,
    /// The nodes below, of which the first is at that end.
    pub after: Vec<RbtIndex>,
}

/// A figure with two legs. Of two sides the first is that to the left of someone who looks along `forward`.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// The topmost node.
    pub top: RbtIndex,
    /// The node that carries both legs.
    pub hips: RbtIndex,
    /// The legs.
    pub legs: [Extremity; 2],
    /// The node that carries both arms, and the arms.
    pub arms: Option<(RbtIndex, [Extremity; 2])>,
    /// The last node of the head.
    pub head: Option<RbtIndex>,
    /// Where it looks at rest: along x or z, of unit length.
    pub forward: Vec3,
}

/// A tree at rest, and where its branches end.
struct Tree<'a> {
    scene: &'a SceneGraph,
    /// `world_from_node` of all RBT nodes.
    rest: Vec<Rbt>,
    tips: Vec<Tip>,
    /// The middle of the figure, and its size.
    origin: Vec3,
    size: f32,
}

#[derive(Clone, Copy)]
struct Tip {
    leaf: RbtIndex,
    position: Vec3,
}

impl Figure {
    /// The first figure of a scene.
    #[must_use]
    pub fn of(scene: &SceneGraph) -> Option<Self> {
        let tops = scene.rbt_indices().filter(|&rbt| scene.topmost(rbt) == rbt);
        tops.into_iter().find_map(|top| Self::below(scene, top))
    }

    /// The figure that a node and those below it make.
    #[must_use]
    pub fn below(scene: &SceneGraph, top: RbtIndex) -> Option<Self> {
        let tree = Tree::of(scene, top)?;
        [Vec3::X, Vec3::Z].into_iter().find_map(|across| tree.figure(top, across))
    }

    /// All limbs.
    pub fn limbs(&self) -> impl Iterator<Item = &Extremity> {
        self.legs.iter().chain(self.arms.iter().flat_map(|(_, arms)| arms))
    }
}

impl<'a> Tree<'a> {
    fn of(scene: &'a SceneGraph, top: RbtIndex) -> Option<Self> {
        let rest: Vec<Rbt> = scene.rbt_indices().map(|rbt| scene.world_from_rbt(scene.rest_pose(), 0.0, rbt)).collect();
        let nodes = || scene.rbt_indices().filter(|&rbt| rbt == top || scene.is_above(top, rbt));
        let mut is_leaf = vec![true; rest.len()];
        for parent in nodes().filter_map(|rbt| scene.limb_nodes(rbt).upper) {
            is_leaf[parent.get()] = false;
        }
        let tips: Vec<Tip> = nodes()
            .filter(|rbt| is_leaf[rbt.get()])
            .map(|leaf| {
                let end = scene.limb_end(leaf, 0.0).unwrap_or(Vec3::ZERO);
                Tip { leaf, position: rest[leaf.get()].transform_point(end) }
            })
            .collect();
        let points = || nodes().map(|rbt| rest[rbt.get()].translation).chain(tips.iter().map(|tip| tip.position));
        let low = points().reduce(Vec3::min)?;
        let high = points().reduce(Vec3::max)?;
        let origin = rest[top.get()].translation;
        Some(Self { scene, size: (high - low).max_element(), rest, tips, origin })
    }

    /// 1 on the side to which `across` points, -1 on the other, 0 in the middle.
    fn side(&self, tip: &Tip, across: Vec3) -> f32 {
        let aside = (tip.position - self.origin).dot(across);
        if aside.abs() > ASIDE * self.size {
            return aside.signum();
        }
        let path = self.scene.rbt_path(tip.leaf).to_lowercase();
        let has = |words: [&str; 2]| words.iter().any(|word| path.contains(word));
        match (has(["left", "왼"]), has(["right", "오른"])) {
            (true, false) => 1.0,
            (false, true) => -1.0,
            _ => 0.0,
        }
    }

    /// The path from the top down to a node, both included.
    fn path(&self, rbt: RbtIndex) -> Vec<RbtIndex> {
        let above = |&rbt: &RbtIndex| self.scene.limb_nodes(rbt).upper;
        let mut path: Vec<RbtIndex> = std::iter::successors(Some(rbt), above).collect();
        path.reverse();
        path
    }

    /// The last node that two leaves have in common, and the paths below it.
    fn fork(&self, leaves: [RbtIndex; 2]) -> Option<(RbtIndex, [Vec<RbtIndex>; 2])> {
        let [a, b] = leaves.map(|leaf| self.path(leaf));
        let common = a.iter().zip(&b).take_while(|(a, b)| a == b).count();
        let fork = *a.get(common.checked_sub(1)?)?;
        Some((fork, [a[common..].to_vec(), b[common..].to_vec()]))
    }

    fn figure(&self, top: RbtIndex, across: Vec3) -> Option<Figure> {
        let best = |side: f32, excluded: &[RbtIndex], score: &dyn Fn(&Tip) -> f32| {
            let is_open =
                |tip: &&Tip| self.side(tip, across) == side && !excluded.iter().any(|&node| self.is_in(node, tip.leaf));
            self.tips.iter().filter(is_open).max_by(|a, b| score(a).total_cmp(&score(b))).copied()
        };
        let low = |tip: &Tip| -tip.position.y;
        let (left, right) = (best(1.0, &[], &low)?, best(-1.0, &[], &low)?);
        let (hips, paths) = self.fork([left.leaf, right.leaf])?;
        let hips_height = self.rest[hips.get()].translation.y;
        if [left, right].iter().any(|tip| tip.position.y > hips_height - 0.1 * self.size) {
            return None;
        }
        let mut taken: Vec<RbtIndex> = paths.iter().filter_map(|path| path.first().copied()).collect();
        let [left_path, right_path] = &paths;
        let legs = [self.extremity(left_path, left.position)?, self.extremity(right_path, right.position)?];
        let far = |tip: &Tip| (tip.position - self.origin).dot(across).abs();
        let arms = best(1.0, &taken, &far).zip(best(-1.0, &taken, &far)).and_then(|(left, right)| {
            let (chest, [left_path, right_path]) = self.fork([left.leaf, right.leaf])?;
            let arms = [self.extremity(&left_path, left.position)?, self.extremity(&right_path, right.position)?];
            taken.extend(left_path.first().into_iter().chain(right_path.first()));
            Some((chest, arms))
        });
        let is_free = |tip: &&Tip| !taken.iter().any(|&node| self.is_in(node, tip.leaf));
        let highest = self.tips.iter().filter(is_free).max_by(|a, b| a.position.y.total_cmp(&b.position.y));
        let head = highest.filter(|tip| tip.position.y > hips_height).map(|tip| tip.leaf).filter(|&leaf| leaf != hips);
        let mut figure = Figure { top, hips, legs, arms, head, forward: across.cross(Vec3::Y) };
        // Toes point forward.
        let toes: f32 = [left, right]
            .iter()
            .zip(&figure.legs)
            .map(|(tip, leg)| {
                let ankle = self.rest[leg.lower.get()].transform_point(leg.end_in_lower);
                (tip.position - ankle).dot(figure.forward)
            })
            .sum();
        if toes < -ASIDE * self.size {
            figure.forward = -figure.forward;
            figure.legs.reverse();
            if let Some((_, arms)) = &mut figure.arms {
                arms.reverse();
            }
        }
        Some(figure)
    }

    fn is_in(&self, above: RbtIndex, rbt: RbtIndex) -> bool {
        above == rbt || self.scene.is_above(above, rbt)
    }

    /// The limb along a path of nodes that ends at a tip: its two long bones.
    fn extremity(&self, path: &[RbtIndex], tip: Vec3) -> Option<Extremity> {
        let place = |index: usize| path.get(index).map_or(tip, |rbt| self.rest[rbt.get()].translation);
        // Bones by the node that carries them: of several nodes at one place that is the last.
        let bones: Vec<(usize, f32)> = (0..path.len())
            .map(|index| (index, place(index).distance(place(index + 1))))
            .filter(|&(_, length)| length > NOTHING * self.size)
            .collect();
        let sum = |pair: &[(usize, f32)]| pair[0].1 + pair[1].1;
        let longest = bones.windows(2).map(sum).reduce(f32::max)?;
        let pair = bones.windows(2).rev().find(|pair| sum(pair) >= LONG_ENOUGH * longest)?;
        let (upper, lower) = (pair[0].0, pair[1].0);
        Some(Extremity {
            before: path[..upper].to_vec(),
            upper: path[upper],
            lower: path[lower],
            end_in_lower: self.rest[path[lower].get()].inverse().transform_point(place(lower + 1)),
            after: path[lower + 1..].to_vec(),
        })
    }
}

/// What reaching knows of each RBT node of a scene with a figure: where its limbs end, and that its legs stand.
#[must_use]
pub fn joints_of(scene: &SceneGraph, figure: &Figure) -> Vec<Joint> {
    let mut joints = vec![Joint::default(); scene.rbt_count()];
    for (index, limb) in figure.limbs().enumerate() {
        joints[limb.lower.get()] = Joint { reach: Some(limb.end_in_lower), stands: index < 2, hinge: None };
    }
    joints
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{DEFAULT_SCENE, built_in_scene};

    #[test]
    fn the_parts_of_a_robot_are_told_by_position() {
        let scene = built_in_scene(DEFAULT_SCENE).unwrap();
        let figure = Figure::of(&scene).unwrap();
        let path = |rbt: RbtIndex| scene.rbt_path(rbt).trim_start_matches("robot1");
        assert_eq!((path(figure.top), path(figure.hips), path(figure.head.unwrap())), ("", "", "/head"));
        let (chest, arms) = figure.arms.as_ref().unwrap();
        assert_eq!(path(*chest), "");
        // They face +z, so that their left is at +x; their names are those of the viewer.
        assert_eq!(figure.forward, Vec3::Z);
        let legs = figure.legs.each_ref().map(|leg| (path(leg.upper), path(leg.lower), leg.end_in_lower.to_array()));
        assert_eq!(legs[0], ("/right_hip", "/right_hip/right_knee", [0.0, -1.25, 0.0]));
        assert_eq!(legs[1], ("/left_hip", "/left_hip/left_knee", [0.0, -1.25, 0.0]));
        assert_eq!(path(arms[0].lower), "/right_shoulder/right_elbow");
        assert!(figure.limbs().all(|limb| limb.before.is_empty() && limb.after.is_empty()));
        assert_eq!(Figure::below(&scene, scene.find_rbt("ground").unwrap()), None);
        assert_eq!(Figure::of(&built_in_scene("orbits").unwrap()), None);
    }
}
