//! The rows of the timeline: the unfolded part of the node tree, and the channels of nodes that have timed keys.

use std::collections::HashSet;
use std::ops::Range;

use crate::pose::{Pose, RbtIndex};
use crate::scene::{Channel, Node, NodeId, NodeKind, SceneGraph};

/// What a row is of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Subject {
    /// An RBT node: its diamonds are keyframes.
    Rbt {
        /// The node.
        rbt: RbtIndex,
        /// The RBT nodes that its diamonds stand for: its own, and where it is folded all below it.
        rbts: Range<usize>,
    },
    /// A control node: its diamonds are the keys of all its channels.
    Control,
    /// A shape: its diamonds are the keys of its colour.
    Shape,
    /// A channel of the control node above.
    Channel(Channel),
}

/// One row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// The node.
    pub node: NodeId,
    /// What the row is of.
    pub subject: Subject,
    /// How far it is indented.
    pub depth: usize,
    /// Whether it can be folded.
    pub has_children: bool,
    /// Whether it is not.
    pub is_unfolded: bool,
}

impl Row {
    /// The channels whose keys its diamonds are; empty where they are keyframes.
    #[must_use]
    pub fn channels(&self, scene: &SceneGraph) -> &'static [Channel] {
        match self.subject {
            Subject::Rbt { .. } => &[],
            Subject::Control | Subject::Shape => scene.channels(self.node),
            Subject::Channel(channel) => {
                let own = scene.channels(self.node).iter().position(|&own| own == channel);
                own.map_or(&[], |own| &scene.channels(self.node)[own..=own])
            }
        }
    }

    /// Whether its diamonds are timed keys.
    #[must_use]
    pub const fn has_keys(&self) -> bool {
        !matches!(self.subject, Subject::Rbt { .. })
    }
}

/// Which rows there are. RBT nodes are folded at first, control nodes are not.
#[derive(Clone, Debug, Default)]
pub struct Rows {
    /// The paths of those that are not as at first.
    toggled: HashSet<String>,
}

impl Rows {
    /// Folds a node, or unfolds it.
    pub fn toggle(&mut self, path: &str) {
        if !self.toggled.remove(path) {
            self.toggled.insert(path.to_owned());
        }
    }

    /// All rows, from the top.
    #[must_use]
    pub fn of(&self, scene: &SceneGraph) -> Vec<Row> {
        let mut rows = Vec::new();
        let mut folded_until = 0;
        for (id, node) in scene.nodes_with_ids() {
            if id.get() < folded_until || !has_row(scene, node) {
                continue;
            }
            let is_control = matches!(node.kind, NodeKind::Control(_));
            let is_unfolded = is_control != self.toggled.contains(&node.path);
            let below = scene.subtree(id);
            let nodes = &scene.nodes()[below.clone()];
            let subject = match node.kind {
                NodeKind::Control(_) => Subject::Control,
                NodeKind::Shape(_) => Subject::Shape,
                NodeKind::Rbt(rbt) => {
                    let all = nodes.iter().filter(|node| matches!(node.kind, NodeKind::Rbt(_))).count();
                    Subject::Rbt { rbt, rbts: rbt.get()..rbt.get() + if is_unfolded { 1 } else { all } }
                }
            };
            let row = |subject, depth, has_children| Row { node: id, subject, depth, has_children, is_unfolded };
            let has_children = is_control || nodes[1..].iter().any(|node| has_row(scene, node));
            rows.push(row(subject, node.depth, has_children));
            if !is_unfolded {
                folded_until = below.end;
            } else if is_control {
                let channels = scene.channels(id).iter();
                rows.extend(channels.map(|&channel| row(Subject::Channel(channel), node.depth + 1, false)));
            }
        }
        rows
    }
}

/// Shapes have one where their colour has keys, or where they hang on a control node.
fn has_row(scene: &SceneGraph, node: &Node) -> bool {
    match &node.kind {
        NodeKind::Rbt(_) | NodeKind::Control(_) => true,
        NodeKind::Shape(placed) => {
            let hangs_on = node.parent.map(|parent| &scene.node(parent).kind);
            placed.tracks().get(Channel::Colour).is_some() || matches!(hangs_on, Some(NodeKind::Control(_)))
        }
    }
}

/// Whether a scene has rows of timed keys.
#[must_use]
pub fn has_key_rows(scene: &SceneGraph) -> bool {
    scene.nodes().iter().any(|node| !matches!(node.kind, NodeKind::Rbt(_)) && has_row(scene, node))
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

    fn rbts(row: &Row) -> Range<usize> {
        match &row.subject {
            Subject::Rbt { rbts, .. } => rbts.clone(),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn at_first_only_the_roots_are_shown() {
        let scene = built_in_scene(DEFAULT_SCENE).unwrap();
        let mut rows = Rows::default();
        let at_first = rows.of(&scene);
        assert!(at_first.iter().all(|row| row.depth == 0 && !row.is_unfolded));
        assert_eq!(at_first.iter().map(|row| rbts(row).len()).sum::<usize>(), scene.rbt_count());
        let robot = scene.find_rbt("robot1").unwrap();
        rows.toggle("robot1");
        let unfolded = rows.of(&scene);
        assert!(unfolded.len() > at_first.len());
        let row = unfolded.iter().find(|row| rbts(row).start == robot.get()).unwrap();
        assert_eq!(rbts(row), robot.get()..robot.get() + 1);
        rows.toggle("robot1");
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
        let rbts = rbts(robot);
        pose.set(RbtIndex::new(rbts.end - 1), Rbt::IDENTITY);
        assert!(differs(&pose, &before, &rbts));
        assert!(!differs(&pose, &before, &(rbts.start..rbts.start + 1)));
    }

    #[test]
    fn control_nodes_show_their_channels_and_what_stands_below_them() {
        let scene = built_in_scene(DEFAULT_SCENE).unwrap();
        assert!(!has_key_rows(&scene));
        let (scene, path) = scene.with_control_above(scene.find("robot1").unwrap()).unwrap();
        assert!(has_key_rows(&scene));
        let mut rows = Rows::default();
        let names = |rows: &Rows| -> Vec<(String, usize)> {
            let name = |row: &Row| match row.subject {
                Subject::Channel(channel) => channel.name().to_owned(),
                _ => scene.node(row.node).path.clone(),
            };
            rows.of(&scene).iter().map(|row| (name(row), row.depth)).collect()
        };
        let expected = [
            ("sky", 0),
            ("ground", 0),
            ("robot1_control", 0),
            ("translation", 1),
            ("rotation", 1),
            ("scale", 1),
            ("robot1", 1),
            ("robot2", 0),
        ];
        assert_eq!(names(&rows), expected.map(|(name, depth)| (name.to_owned(), depth)));
        rows.toggle(&path);
        assert_eq!(names(&rows).len(), 4);
    }
}
