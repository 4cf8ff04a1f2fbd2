//! Matches rows of a keyframe to nodes: students built the joints of a robot in different orders, with lights and meshes before or after.
//!
//! The match uses the signs of the offsets in keyframe 0, and that children follow their parents. Nodes right under the root (the sky
//! camera, the ground, the robots) can have any position, so they keep the scene's order, and so do their blocks of rows.

mod fit;
mod list;
mod robot;

use glam::Vec3;

use super::Options;
use super::plan::Plan;
use super::report::Certainty;
use crate::pose::RbtIndex;
use crate::scene::SceneGraph;
use crate::text::listed;
use crate::words::texts;
use robot::{Found, Robot};

pub(super) use fit::{Fit, fit};
pub use list::JointList;
pub(super) use robot::heads;

/// For each row of a keyframe, the index of its node in the scene; `None` for unused rows. `offsets` are the translations of keyframe 0;
/// empty without keyframes. Inferences are added to the plan.
pub(super) fn match_joints(
    offsets: &[Vec3],
    scene: &SceneGraph,
    options: &Options,
    plan: &mut Plan,
) -> Vec<Option<RbtIndex>> {
    if let Some(joints) = &options.joints {
        let node_of_row = joints.node_of_row(plan.nodes);
        let unused = unused_rows(&node_of_row);
        if !unused.is_empty() {
            plan.find(Certainty::Note, format!("nodes: {} not used, as the list says", are_rows(&unused)));
        }
        plan.find(Certainty::Sure, "joints: as the list says");
        return node_of_row;
    }
    if offsets.is_empty() {
        let own = scene.rbt_count();
        return (0..plan.nodes).map(|row| (row < own).then_some(RbtIndex::new(row))).collect();
    }
    let fit = fit(offsets, scene).unwrap_or_else(|| fit::in_order(offsets, scene));
    let node_of_row = fit.node_of_row(plan.nodes);
    fit.say_rows(&node_of_row, scene, plan);
    fit.say_joints(offsets, plan);
    node_of_row
}

/// The rows that are no node of the scene.
fn unused_rows(node_of_row: &[Option<RbtIndex>]) -> Vec<usize> {
    node_of_row.iter().enumerate().filter(|(_, node)| node.is_none()).map(|(row, _)| row).collect()
}

/// Rows as the beginning of a sentence: `row 3 is`, `rows 2 and 3 are`.
fn are_rows(rows: &[usize]) -> String {
    let names: Vec<String> = rows.iter().map(ToString::to_string).collect();
    let (noun, verb) = if rows.len() == 1 { ("row", "is") } else { ("rows", "are") };
    format!("{noun} {} {verb}", listed(&names, "and"))
}

impl Fit<'_> {
    /// The joint of each row after a robot's own.
    fn order(&self, index: usize) -> Option<&Vec<usize>> {
        match &self.found[index] {
            Found::Same => None,
            Found::Order(order) | Found::ByOrder(order) => Some(order),
            Found::Nothing => self.like(index).map(|(_, order)| order),
        }
    }

    /// Another robot with the same joints, whose order is known.
    fn like(&self, index: usize) -> Option<(&Robot<'_>, &Vec<usize>)> {
        self.robots.iter().zip(&self.found).find_map(|(other, found)| match found {
            Found::Order(order) | Found::ByOrder(order) if other.is_like(&self.robots[index]) => Some((other, order)),
            _ => None,
        })
    }

    fn node_of_row(&self, rows: usize) -> Vec<Option<RbtIndex>> {
        let mut node_of_row = vec![None; rows];
        for (index, (robot, &row)) in self.robots.iter().zip(&self.rows).enumerate() {
            node_of_row[row] = Some(robot.root);
            for place in 0..robot.joints.len() {
                let joint = self.order(index).map_or(place, |order| order[place]);
                node_of_row[row + 1 + place] = Some(robot.joints[joint]);
            }
        }
        node_of_row
    }

    /// Says which rows are no nodes of the scene, and which nodes have no row.
    fn say_rows(&self, node_of_row: &[Option<RbtIndex>], scene: &SceneGraph, plan: &mut Plan) {
        let unused = unused_rows(node_of_row);
        let own = scene.rbt_count();
        if !self.without_row.is_empty() {
            let paths: Vec<&str> = self.without_row.iter().map(|&node| scene.rbt_path(node)).collect();
            let paths = listed(&paths, "and");
            plan.find(Certainty::Note, format!("nodes: there are no rows of {paths}, which keep the rest pose"));
        }
        let Some(&first) = unused.first() else { return };
        let more = format!("nodes: {} more than the scene has", unused.len());
        if !self.is_confirmed {
            plan.find(
                Certainty::Warning,
                format!("{more}, and the offsets of keyframe 0 do not show which: taken as the last"),
            );
        } else if first == own && self.without_row.is_empty() {
            plan.find(Certainty::Note, format!("{more}: {}", rest_named(own, plan.nodes)));
        } else {
            let rows = are_rows(&unused);
            plan.find(
                Certainty::Note,
                format!("{more}: {rows} not used (lights, for example); the offsets of keyframe 0 show the others"),
            );
        }
    }

    /// Says how the joints of each robot were found, and how their offsets differ from the scene's.
    fn say_joints(&self, offsets: &[Vec3], plan: &mut Plan) {
        let mut differs = 0.0_f32;
        let mut said: Vec<(Vec<&str>, Certainty, String)> = Vec::new();
        for (index, (robot, &row)) in self.robots.iter().zip(&self.rows).enumerate() {
            if robot.joints.is_empty() {
                continue;
            }
            let (certainty, text) = self.how(index);
            match said.iter_mut().find(|(_, _, other)| *other == text) {
                Some((names, ..)) => names.push(robot.name()),
                None => said.push((vec![robot.name()], certainty, text)),
            }
            if !matches!(self.found[index], Found::Nothing) {
                for (place, offset) in offsets[row + 1..].iter().take(robot.joints.len()).enumerate() {
                    let joint = self.order(index).map_or(place, |order| order[place]);
                    differs = differs.max((offset.length() - robot.wanted[joint].length()).abs());
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
    }

    fn how(&self, index: usize) -> (Certainty, String) {
        let robot = &self.robots[index];
        match (&self.found[index], self.like(index)) {
            (Found::Same, _) => (Certainty::Sure, "in the scene's order, as the offsets of keyframe 0 show".to_owned()),
            (Found::Order(order), _) => {
                (Certainty::Sure, format!("matched by the offsets of keyframe 0: {}", robot.names(order)))
            }
            (Found::ByOrder(order), _) => (
                Certainty::Likely,
                format!("matched by the signs of keyframe 0's offsets alone: {}", robot.names(order)),
            ),
            (Found::Nothing, like) => {
                let taken = like
                    .map_or("in the scene's order".to_owned(), |(other, _)| format!("as those of {}", other.name()));
                let why = "the offsets of keyframe 0 match no order";
                (Certainty::Warning, format!("{why}: taken {taken}; --joints FILE decides otherwise"))
            }
        }
    }
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
