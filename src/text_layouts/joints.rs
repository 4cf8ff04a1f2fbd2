//! Matches rows of a keyframe to nodes: students built the joints of a robot in different orders.
//!
//! The match uses the signs of the offsets in keyframe 0, and that children follow their parents. Nodes right under the root (the sky
//! camera, the ground, the robots) can have any position, so they keep the scene's order, and so do their blocks of rows.

use glam::Vec3;

use super::Options;
use super::error::{TextError, TextProblem, quoted};
use super::plan::Plan;
use super::report::Certainty;
use crate::pose::RbtIndex;
use crate::scene::SceneGraph;
use crate::text::without_byte_order_mark;
use crate::words::{self, Argument, texts};

/// Coordinates below 10 % of an offset's largest coordinate count as 0.
const ZERO_FRACTION: f32 = 0.1;
/// Robots with more joints than this are not searched.
const MOST_JOINTS: usize = 128;
/// The limit of the search, in tried rows.
const MOST_TRIES: usize = 5_000;

/// The node of each row of a keyframe, from a user's list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct JointList {
    nodes: Vec<Option<RbtIndex>>,
}

impl JointList {
    /// Reads a list with one line for each row of a keyframe: a path, or `-` for an unused row. Blank lines and comments after `#` are
    /// skipped.
    ///
    /// # Errors
    /// A path that is not in the scene or occurs twice, and missing nodes of the scene.
    pub fn from_text(bytes: &[u8], scene: &SceneGraph) -> Result<Self, TextError> {
        let error = |at, found: Argument, expected: Argument| {
            TextError::new(bytes, at, TextProblem::Unexpected { found, expected })
        };
        let mut nodes = Vec::new();
        let mut is_named = vec![false; scene.rbt_count()];
        let mut at = bytes.len() - without_byte_order_mark(bytes).len();
        for line in bytes[at..].split(|&byte| byte == b'\n') {
            let path = line.split(|&byte| byte == b'#').next().unwrap_or_default().trim_ascii();
            let node = std::str::from_utf8(path).ok().and_then(|path| scene.find_rbt(path));
            match node {
                _ if path.is_empty() => {}
                None if path == b"-" => nodes.push(None),
                None => return Err(error(at, quoted(path).into(), texts::TEXT_EXPECTED_PATH.into())),
                Some(node) => {
                    if std::mem::replace(&mut is_named[node.get()], true) {
                        return Err(error(
                            at,
                            texts::text_found_again(quoted(path)).into(),
                            texts::TEXT_EXPECTED_PATH_ONCE.into(),
                        ));
                    }
                    nodes.push(Some(node));
                }
            }
            at += line.len() + 1;
        }
        if let Some(missing) = is_named.iter().position(|is_named| !is_named) {
            let path = scene.rbt_path(RbtIndex::new(missing));
            let expected = texts::text_expected_in_list(words::quoted(path)).into();
            return Err(error(bytes.len(), texts::TEXT_FOUND_END_OF_LIST.into(), expected));
        }
        Ok(Self { nodes })
    }

    /// The number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.nodes.len()
    }
}

/// For each row of a keyframe, the index of its node in the scene; `None` for unused rows. `offsets` are the translations of keyframe 0;
/// empty without keyframes. Inferences are added to the plan.
pub(super) fn match_joints(
    offsets: &[Vec3],
    scene: &SceneGraph,
    options: &Options,
    plan: &mut Plan,
) -> Vec<Option<RbtIndex>> {
    let own = scene.rbt_count();
    if plan.nodes > own {
        plan.find(
            Certainty::Note,
            format!("nodes: {} more than the scene has: {}", plan.nodes - own, rest_named(own, plan.nodes)),
        );
    }
    if let Some(joints) = &options.joints {
        plan.find(Certainty::Sure, "joints: as the list says");
        return joints.nodes.iter().copied().chain(std::iter::repeat(None)).take(plan.nodes).collect();
    }
    let mut node_of_row: Vec<Option<RbtIndex>> =
        (0..plan.nodes).map(|row| (row < own).then_some(RbtIndex::new(row))).collect();
    if offsets.len() < own {
        return node_of_row;
    }
    let robots = robots(scene);
    let found: Vec<Found> = robots.iter().map(|robot| robot.find(offsets)).collect();
    let mut differs = 0.0_f32;
    let mut said: Vec<(Vec<&str>, Certainty, String)> = Vec::new();
    for (robot, found_here) in robots.iter().zip(&found) {
        let mut say = |certainty: Certainty, text: String| match said.iter_mut().find(|(_, _, other)| *other == text) {
            Some((names, ..)) => names.push(robot.name),
            None => said.push((vec![robot.name], certainty, text)),
        };
        let order = match found_here {
            Found::Same => {
                say(Certainty::Sure, "in the scene's order, as the offsets of keyframe 0 show".to_owned());
                None
            }
            Found::Order(order) => {
                say(Certainty::Sure, format!("matched by the offsets of keyframe 0: {}", robot.names(order)));
                Some(order.clone())
            }
            Found::ByOrder(order) => {
                say(
                    Certainty::Likely,
                    format!("matched by the signs of keyframe 0's offsets alone: {}", robot.names(order)),
                );
                Some(order.clone())
            }
            Found::Nothing => {
                let like = robots.iter().zip(&found).find_map(|(other, found)| match found {
                    Found::Order(order) | Found::ByOrder(order) if other.is_like(robot) => Some((other, order)),
                    _ => None,
                });
                let why = "the offsets of keyframe 0 match no order";
                say(
                    Certainty::Warning,
                    match like {
                        Some((other, _)) => {
                            format!("{why}: taken as those of {}; --joints FILE decides otherwise", other.name)
                        }
                        None => format!("{why}: taken in the scene's order; --joints FILE decides otherwise"),
                    },
                );
                like.map(|(_, order)| order.clone())
            }
        };
        for row in 0..robot.wanted.len() {
            let node = order.as_ref().map_or(row, |order| order[row]);
            node_of_row[robot.first + row] = Some(RbtIndex::new(robot.first + node));
            if !matches!(found_here, Found::Nothing) {
                differs = differs.max((offsets[robot.first + row].length() - robot.wanted[node].length()).abs());
            }
        }
    }
    for (names, certainty, text) in said {
        plan.find(certainty, format!("joints of {}: {text}", names.join(", ")));
    }
    if differs > 1e-3 {
        plan.find(
            Certainty::Note,
            format!(
                "offsets differ from the scene's by up to {} in length, and stay as the file has them",
                (differs * 1e4).round() / 1e4
            ),
        );
    }
    node_of_row
}

/// The nodes of the course's later assignments.
fn rest_named(own: usize, nodes: usize) -> String {
    let (first, second) = (own, own + 1);
    let used = format!("the first {own} are used, not {first} and {second}");
    match nodes - own {
        2 => format!("{used} (two lights)"),
        3 => format!("{used} (two lights) and {} (a mesh or a bunny)", own + 2),
        4 => format!("{used} (two lights), {} and {} (a mesh and a bunny)", own + 2, own + 3),
        more => format!("the first {own} are used, not {first} and the {} after it", texts::count_nodes(more - 1)),
    }
}

/// How the offsets of keyframe 0 match a robot.
enum Found {
    /// They match in the scene's order.
    Same,
    /// They match in another order, in which children follow their parents. For each row, the joint.
    Order(Vec<usize>),
    /// They match by sign alone. Joints with equal signs are in the order of their parents.
    ByOrder(Vec<usize>),
    /// They match in no order.
    Nothing,
}

/// The joints below a node that is right under the root.
struct Robot<'a> {
    name: &'a str,
    scene: &'a SceneGraph,
    /// The index of the first joint in a pose.
    first: usize,
    /// The rest offsets in the parent's space.
    wanted: Vec<Vec3>,
    /// Each joint's parent among the joints; `None` for the robot itself.
    parents: Vec<Option<usize>>,
}

/// All nodes right under the root that have joints.
fn robots(scene: &SceneGraph) -> Vec<Robot<'_>> {
    let parent = |rbt: RbtIndex| {
        let parent = scene.node(scene.rbt_node(rbt)).parent?;
        scene.carrying_rbt(parent)
    };
    let mut robots: Vec<Robot<'_>> = Vec::new();
    for rbt in scene.rbt_indices() {
        let Some(parent) = parent(rbt) else {
            robots.push(Robot {
                name: scene.rbt_path(rbt),
                scene,
                first: rbt.get() + 1,
                wanted: vec![],
                parents: vec![],
            });
            continue;
        };
        if let Some(robot) = robots.last_mut() {
            robot.wanted.push(scene.rest_pose().get(rbt).translation);
            robot.parents.push(parent.get().checked_sub(robot.first));
        }
    }
    robots.retain(|robot| !robot.wanted.is_empty());
    robots
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

impl Robot<'_> {
    fn is_like(&self, other: &Self) -> bool {
        self.parents == other.parents && self.wanted == other.wanted
    }

    fn names(&self, order: &[usize]) -> String {
        let names = order.iter().map(|&joint| {
            let path = self.scene.rbt_path(RbtIndex::new(self.first + joint));
            path.rsplit('/').next().unwrap_or(path)
        });
        names.collect::<Vec<_>>().join(", ")
    }

    fn find(&self, offsets: &[Vec3]) -> Found {
        let found: Vec<[i8; 3]> =
            offsets[self.first..self.first + self.wanted.len()].iter().copied().map(signs).collect();
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
