//! Edits that mean a node whatever its place: reset, mirror, copy and paste of poses.

use super::apply::CommandResult;
use super::{CommandError, Editor, NodeEdit, NodePart};
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;
use crate::words::texts;

impl Editor {
    /// Whether there is a pose to paste.
    #[must_use]
    pub const fn has_copied_pose(&self) -> bool {
        self.clipboard.pose.is_some()
    }

    pub(super) fn edit_nodes(&mut self, edit: NodeEdit, node: Option<RbtIndex>) -> CommandResult {
        let nodes = self.meant(node)?;
        match edit {
            NodeEdit::Reset(part) => self.reset_nodes(&nodes, part),
            NodeEdit::Mirror => self.mirror_nodes(&nodes),
            NodeEdit::Paste { is_mirrored } => self.paste_pose(&nodes, is_mirrored),
        }
    }

    /// The nodes that a command means: this one, or the chosen ones; never none.
    pub(super) fn meant(&self, node: Option<RbtIndex>) -> Result<Vec<RbtIndex>, CommandError> {
        match node {
            Some(rbt) if rbt.get() >= self.document.scene.rbt_count() => {
                Err(CommandError::NotInScene { what: texts::VALUE_NODE })
            }
            Some(rbt) => Ok(vec![rbt]),
            None if self.session.chosen.is_empty() => Err(self.nothing_chosen()),
            None => Ok(self.session.chosen.to_vec()),
        }
    }

    fn path(&self, rbt: RbtIndex) -> &str {
        self.document.scene.rbt_path(rbt)
    }

    fn no_other_side(&self, rbt: RbtIndex) -> CommandError {
        CommandError::NoOtherSide { path: self.path(rbt).to_owned() }
    }

    /// The node and all RBT nodes below it.
    pub(super) fn with_all_below(&self, rbt: RbtIndex) -> impl Iterator<Item = RbtIndex> {
        let scene = &self.document.scene;
        let below = scene.subtree(scene.rbt_node(rbt));
        (rbt.get()..scene.rbt_count())
            .map(RbtIndex::new)
            .take_while(move |&node| below.contains(&scene.rbt_node(node).get()))
    }

    fn reset_nodes(&mut self, nodes: &[RbtIndex], part: NodePart) -> CommandResult {
        let pose = self.edited_pose();
        let at_rest = |&rbt: &RbtIndex| {
            let (from, rest) = (pose.get(rbt), self.document.scene.rest_pose().get(rbt));
            let placed = match part {
                NodePart::Both => rest,
                NodePart::Translation => Rbt { translation: rest.translation, ..from },
                NodePart::Rotation => Rbt { rotation: rest.rotation, ..from },
            };
            (rbt, placed)
        };
        let placed = nodes.iter().map(at_rest).collect();
        self.change_nodes(placed, texts::ACT_RETURN_OF_NODES_TO_REST, None)?;
        Ok(Some(match *nodes {
            [rbt] => texts::pose_node_at_rest(self.path(rbt)),
            _ => texts::pose_nodes_at_rest(nodes.len()),
        }))
    }

    fn mirror_nodes(&mut self, nodes: &[RbtIndex]) -> CommandResult {
        let pose = self.edited_pose();
        let counterparts = self.document.scene.counterparts();
        if let Some(&alone) = nodes.iter().find(|rbt| counterparts[rbt.get()].is_none()) {
            return Err(self.no_other_side(alone));
        }
        let mut meant: Vec<RbtIndex> = nodes.iter().flat_map(|&rbt| self.with_all_below(rbt)).collect();
        meant.sort_unstable();
        meant.dedup();
        let placed: Vec<(RbtIndex, Rbt)> = meant
            .iter()
            .filter_map(|&rbt| Some((rbt, counterparts[rbt.get()]?)))
            .map(|(rbt, other)| (other, self.document.scene.mirrored_place(&pose, rbt, other)))
            .collect();
        let alone = meant.len() - placed.len();
        self.change_nodes(placed, texts::ACT_MIRRORING_OF_A_POSE, None)?;
        Ok(Some(match *nodes {
            [rbt] if alone > 0 => texts::pose_mirrored_but(self.path(rbt), texts::count_nodes(alone)),
            [rbt] => match counterparts[rbt.get()].filter(|&other| other != rbt) {
                Some(other) => texts::pose_mirrored_to(self.path(rbt), self.path(other)),
                None => texts::pose_mirrored(self.path(rbt)),
            },
            _ => texts::pose_mirrored_several(nodes.len()),
        }))
    }

    pub(super) fn copy_pose(&mut self, node: Option<RbtIndex>) -> CommandResult {
        let meant = self.meant(node)?;
        let primary = meant[meant.len() - 1];
        self.clipboard.pose = Some((primary, self.displayed_pose().in_bounds()));
        Ok(Some(texts::pose_copied(self.path(primary))))
    }

    fn paste_pose(&mut self, nodes: &[RbtIndex], is_mirrored: bool) -> CommandResult {
        let (copied, pose) = self.clipboard.pose.clone().ok_or(CommandError::NoPoseCopied)?;
        let (source, pose, counterparts) = if is_mirrored {
            let counterparts = self.document.scene.counterparts();
            let other = counterparts[copied.get()].ok_or_else(|| self.no_other_side(copied))?;
            (other, self.mirrored_pose(&pose, &counterparts), counterparts)
        } else {
            (copied, pose, Vec::new())
        };
        let live = self.edited_pose();
        let mut placed = Vec::new();
        for &target in nodes {
            let pairs = self.pairs_below(source, target).or_else(|error| {
                // The copied side itself is chosen: its other side is meant.
                let other = counterparts.get(target.get()).copied().flatten().ok_or_else(|| error.clone())?;
                self.pairs_below(source, other).map_err(|_| error)
            })?;
            placed.extend(pairs.into_iter().map(|(from, to)| {
                let mut place = pose.get(from);
                if from == source && source != to {
                    place.translation = live.get(to).translation;
                }
                (to, place)
            }));
        }
        self.change_nodes(placed, texts::ACT_PASTING_OF_A_POSE, None)?;
        let copied = self.path(copied);
        Ok(Some(match *nodes {
            [target] if is_mirrored => texts::pose_pasted_mirrored(copied, self.path(target)),
            [target] => texts::pose_pasted(copied, self.path(target)),
            _ => texts::pose_pasted_several(copied, nodes.len()),
        }))
    }

    fn mirrored_pose(&self, pose: &Pose, counterparts: &[Option<RbtIndex>]) -> Pose {
        let mut mirrored = pose.clone();
        for (rbt, other) in self.document.scene.rbt_indices().zip(counterparts) {
            if let Some(other) = *other {
                mirrored.set(other, self.document.scene.mirrored_place(pose, rbt, other));
            }
        }
        mirrored
    }

    /// Pairs of a node and a target, each with all below it, matched by their paths.
    fn pairs_below(&self, source: RbtIndex, target: RbtIndex) -> Result<Vec<(RbtIndex, RbtIndex)>, CommandError> {
        let (source_path, target_path) = (self.path(source), self.path(target));
        let pair = |rbt| {
            let below = &self.path(rbt)[source_path.len()..];
            let found = self.document.scene.find_rbt(&format!("{target_path}{below}"));
            let missing = || CommandError::OtherNodes {
                path: below.trim_start_matches('/').to_owned(),
                chosen: target_path.to_owned(),
            };
            Ok((rbt, found.ok_or_else(missing)?))
        };
        self.with_all_below(source).map(pair).collect()
    }
}
