//! The rows of the timeline: the tree of RBT nodes as far as it is unfolded.

use std::collections::HashSet;
use std::ops::Range;

use crate::pose::{Pose, RbtIndex};
use crate::scene::{NodeKind, SceneGraph};

/// One row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// Its node.
    pub rbt: RbtIndex,
    /// How many RBT nodes stand above it.
    pub depth: usize,
    /// Whether RBT nodes stand below it.
    pub has_children: bool,
    /// Whether those are shown.
    pub is_unfolded: bool,
    /// The RBT nodes that its diamonds stand for: its own, and where it is folded all below it.
    pub rbts: Range<usize>,
}

/// Which rows there are.
#[derive(Clone, Debug, Default)]
pub struct Rows {
    unfolded: HashSet<RbtIndex>,
}

impl Rows {
    /// Folds a node, or unfolds it.
    pub fn toggle(&mut self, rbt: RbtIndex) {
        if !self.unfolded.remove(&rbt) {
            self.unfolded.insert(rbt);
        }
    }

    /// All rows, from the top.
    #[must_use]
    pub fn of(&self, scene: &SceneGraph) -> Vec<Row> {
        let mut rows = Vec::new();
        let mut folded_until = 0;
        for rbt in scene.rbt_indices() {
            let id = scene.rbt_node(rbt);
            if id.get() < folded_until {
                continue;
            }
            let below = scene.subtree(id);
            let count =
                scene.nodes()[below.clone()].iter().filter(|node| matches!(node.kind, NodeKind::Rbt(_))).count();
            let has_children = count > 1;
            let is_unfolded = self.unfolded.contains(&rbt);
            if !is_unfolded {
                folded_until = below.end;
            }
            let stands_for = if is_unfolded { 1 } else { count };
            rows.push(Row {
                rbt,
                depth: depth(scene, rbt),
                has_children,
                is_unfolded,
                rbts: rbt.get()..rbt.get() + stands_for,
            });
        }
        rows
    }
}

/// How many RBT nodes stand above one.
fn depth(scene: &SceneGraph, rbt: RbtIndex) -> usize {
    std::iter::successors(scene.node(scene.rbt_node(rbt)).parent, |&above| scene.node(above).parent)
        .filter(|&above| matches!(scene.node(above).kind, NodeKind::Rbt(_)))
        .count()
}

/// Whether any of these nodes stands in one pose as it does not in the one before.
#[must_use]
pub fn differs(pose: &Pose, before: &Pose, rbts: &Range<usize>) -> bool {
    !pose.shares_with(before) && rbts.clone().map(RbtIndex::new).any(|rbt| pose.get(rbt) != before.get(rbt))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rbt::Rbt;
    use crate::scene::{DEFAULT_SCENE, built_in_scene};

    #[test]
    fn at_first_only_the_roots_are_shown() {
        let scene = built_in_scene(DEFAULT_SCENE).unwrap();
        let mut rows = Rows::default();
        let at_first = rows.of(&scene);
        assert!(at_first.iter().all(|row| row.depth == 0 && !row.is_unfolded));
        assert_eq!(at_first.iter().map(|row| row.rbts.len()).sum::<usize>(), scene.rbt_count());
        let robot = scene.find_rbt("robot1").unwrap();
        rows.toggle(robot);
        let unfolded = rows.of(&scene);
        assert!(unfolded.len() > at_first.len());
        let row = unfolded.iter().find(|row| row.rbt == robot).unwrap();
        assert_eq!(row.rbts, robot.get()..robot.get() + 1);
        rows.toggle(robot);
        assert_eq!(rows.of(&scene), at_first);
    }

    #[test]
    fn a_folded_row_speaks_for_what_is_below_it() {
        let scene = built_in_scene(DEFAULT_SCENE).unwrap();
        let before = scene.rest_pose().clone();
        let mut pose = before.clone();
        assert!(!differs(&pose, &before, &(0..scene.rbt_count())));
        let rows = Rows::default().of(&scene);
        let robot = rows.iter().find(|row| row.has_children).unwrap();
        pose.set(RbtIndex::new(robot.rbts.end - 1), Rbt::IDENTITY);
        assert!(differs(&pose, &before, &robot.rbts));
        assert!(!differs(&pose, &before, &(robot.rbts.start..robot.rbts.start + 1)));
    }
}
