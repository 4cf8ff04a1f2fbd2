//! Matches rows to the joints of a robot, by the signs of offsets and because children follow their parents.

use glam::Vec3;

use crate::pose::RbtIndex;
use crate::scene::SceneGraph;

/// Coordinates below 10 % of an offset's largest coordinate count as 0.
const ZERO_FRACTION: f32 = 0.1;
/// Robots with more joints than this are not searched.
const MOST_JOINTS: usize = 128;
/// The limit of the search, in tried rows.
const MOST_TRIES: usize = 5_000;

/// How the offsets of keyframe 0 match a robot.
#[derive(Clone, Debug)]
pub(super) enum Found {
    /// They match in the scene's order.
    Same,
    /// They match in another order, in which children follow their parents. For each row, the joint.
    Order(Vec<usize>),
    /// They match by sign alone. Joints with equal signs are in the order of their parents.
    ByOrder(Vec<usize>),
    /// They match in no order.
    Nothing,
}

impl Found {
    /// How much is guessed.
    pub(super) fn rank(&self) -> usize {
        match self {
            Self::Same => 0,
            Self::Order(_) => 1,
            Self::ByOrder(_) => 2,
            Self::Nothing => 3,
        }
    }
}

/// The joints below a node that is right under the root.
pub(super) struct Robot<'a> {
    /// The node itself.
    pub(super) root: RbtIndex,
    scene: &'a SceneGraph,
    /// The joints that have rows.
    pub(super) joints: Vec<RbtIndex>,
    /// The rest offsets in the parent's space.
    pub(super) wanted: Vec<Vec3>,
    /// Each joint's parent among the joints; `None` for the robot itself.
    parents: Vec<Option<usize>>,
}

/// All nodes right under the root, each with its joints but those left out, which have no children.
pub(super) fn robots<'a>(scene: &'a SceneGraph, left_out: &[RbtIndex]) -> Vec<Robot<'a>> {
    let mut robots: Vec<Robot<'_>> = Vec::new();
    for rbt in scene.rbt_indices() {
        let parent = scene.node(scene.rbt_node(rbt)).parent.and_then(|parent| scene.carrying_rbt(parent));
        match (parent, robots.last_mut()) {
            (Some(parent), Some(robot)) => {
                if !left_out.contains(&rbt) {
                    robot.parents.push(robot.joints.iter().position(|&joint| joint == parent));
                    robot.joints.push(rbt);
                    robot.wanted.push(scene.rest_pose().get(rbt).translation);
                }
            }
            _ => robots.push(Robot { root: rbt, scene, joints: vec![], wanted: vec![], parents: vec![] }),
        }
    }
    robots
}

/// The heads of robots: joints of that name that have no children.
pub(in crate::text_layouts) fn heads(scene: &SceneGraph) -> Vec<RbtIndex> {
    let paths: Vec<&str> = scene.rbt_paths().collect();
    let is_head = |path: &str| {
        let name = path.rsplit_once('/').map(|(_, name)| name.to_lowercase());
        let is_parent = |other: &&str| other.strip_prefix(path).is_some_and(|rest| rest.starts_with('/'));
        name.as_deref() == Some("head") && !paths.iter().any(is_parent)
    };
    scene.rbt_indices().filter(|rbt| is_head(paths[rbt.get()])).collect()
}

/// The signs of an offset; 0 for coordinates that are small compared with the largest.
fn signs(offset: Vec3) -> [i8; 3] {
    let zero = offset.abs().max_element() * ZERO_FRACTION;
    offset.to_array().map(|coordinate| {
        if coordinate > zero {
            1
        } else if coordinate < -zero {
            -1
        } else {
            0
        }
    })
}

impl<'a> Robot<'a> {
    /// Its path.
    pub(super) fn name(&self) -> &'a str {
        self.scene.rbt_path(self.root)
    }

    pub(super) fn is_like(&self, other: &Self) -> bool {
        self.parents == other.parents && self.wanted == other.wanted
    }

    /// The names of its joints in the order of rows.
    pub(super) fn names(&self, order: &[usize]) -> String {
        let names = order.iter().map(|&joint| {
            let path = self.scene.rbt_path(self.joints[joint]);
            path.rsplit('/').next().unwrap_or(path)
        });
        names.collect::<Vec<_>>().join(", ")
    }

    /// How the offsets of the rows after the robot's own match its joints.
    pub(super) fn find(&self, offsets: &[Vec3]) -> Found {
        let found: Vec<[i8; 3]> = offsets[..self.wanted.len()].iter().copied().map(signs).collect();
        let wanted: Vec<[i8; 3]> = self.wanted.iter().copied().map(signs).collect();
        if found == wanted {
            return Found::Same;
        }
        if found.len() > MOST_JOINTS {
            return Found::Nothing;
        }
        let mut walk = OrderSearch { robot: self, found: &found, wanted: &wanted, order: Vec::new(), tries: 0 };
        if walk.go_on(&mut vec![None]) {
            return Found::Order(walk.order);
        }
        self.by_signs(&found, &wanted).map_or(Found::Nothing, Found::ByOrder)
    }

    /// Assigns joints to rows by their signs. Joints with equal signs are in the order of their parents' rows.
    fn by_signs(&self, found: &[[i8; 3]], wanted: &[[i8; 3]]) -> Option<Vec<usize>> {
        let mut row_of: Vec<Option<usize>> = vec![None; wanted.len()];
        let depth = |joint: usize| std::iter::successors(Some(joint), |&joint| self.parents[joint]).count();
        let mut joints: Vec<usize> = (0..wanted.len()).collect();
        joints.sort_by_key(|&joint| depth(joint));
        let mut is_taken = vec![false; found.len()];
        while let Some(&next) = joints.first() {
            let mut alike: Vec<usize> = joints.iter().copied().filter(|&joint| wanted[joint] == wanted[next]).collect();
            joints.retain(|&joint| wanted[joint] != wanted[next]);
            alike.sort_by_key(|&joint| self.parents[joint].and_then(|parent| row_of[parent]));
            for joint in alike {
                let row = (0..found.len()).find(|&row| !is_taken[row] && found[row] == wanted[joint])?;
                is_taken[row] = true;
                row_of[joint] = Some(row);
            }
        }
        let mut order = vec![0; found.len()];
        for (joint, row) in row_of.iter().enumerate() {
            order[(*row)?] = joint;
        }
        Some(order)
    }
}

/// Searches for an order in which the rows are a pre-order walk of the robot.
struct OrderSearch<'a> {
    robot: &'a Robot<'a>,
    found: &'a [[i8; 3]],
    wanted: &'a [[i8; 3]],
    order: Vec<usize>,
    tries: usize,
}

impl OrderSearch<'_> {
    /// Finds joints for the remaining rows. `above` are the ancestors of the current row; `None` is the robot itself.
    fn go_on(&mut self, above: &mut Vec<Option<usize>>) -> bool {
        let row = self.order.len();
        if row == self.found.len() {
            return true;
        }
        self.tries += 1;
        if self.tries > MOST_TRIES {
            return false;
        }
        let is_left =
            |walk: &Self, joint: &usize, parent| walk.robot.parents[*joint] == parent && !walk.order.contains(joint);
        let kept = above.clone();
        while let Some(&parent) = above.last() {
            let left: Vec<usize> = (0..self.found.len()).filter(|joint| is_left(self, joint, parent)).collect();
            if left.is_empty() {
                above.pop();
                continue;
            }
            for joint in left {
                if self.wanted[joint] == self.found[row] {
                    self.order.push(joint);
                    above.push(Some(joint));
                    if self.go_on(above) {
                        return true;
                    }
                    self.order.pop();
                    above.pop();
                }
            }
            break;
        }
        *above = kept;
        false
    }
}
