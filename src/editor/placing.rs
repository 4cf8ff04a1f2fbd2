//! Edits that place nodes of the live pose: by values, by turns and moves of the chosen nodes.

use glam::Vec3;

use super::apply::CommandResult;
use super::history::Run;
use super::{CommandError, Editor, Pivot};
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;
use crate::rotation_rules::{Mending, rotation_about_axis, unit};
use crate::words::{Phrase, texts};

/// The transform as a document can hold it: in bounds, with a rotation that files keep bit for bit.
pub(super) fn placeable(placed: Rbt) -> Result<Rbt, CommandError> {
    if placed.translation.is_nan() || !placed.rotation.is_finite() {
        return Err(CommandError::NotAValue { what: texts::VALUE_POSITION });
    }
    if !placed.is_in_bounds() {
        return Err(CommandError::TooFar);
    }
    match Mending::of_length(placed.rotation.as_dquat().length()) {
        Mending::Keep => Ok(placed),
        Mending::Normalise => Ok(placed.renormalized()),
        Mending::Refuse => Err(CommandError::NotAValue { what: texts::VALUE_ROTATION }),
    }
}

/// What undo calls a turn of so many nodes.
pub(super) const fn turn_label(count: usize) -> Phrase {
    if count > 1 { texts::ACT_TURN_NODES } else { texts::ACT_TURN_A_NODE }
}

/// What undo calls a move of so many nodes.
pub(super) const fn move_label(count: usize) -> Phrase {
    if count > 1 { texts::ACT_MOVE_NODES } else { texts::ACT_MOVE_A_NODE }
}

impl Editor {
    /// The nodes that a drag moves: the chosen ones, or the eye; none for the work eye.
    pub(super) fn dragged_nodes(&self) -> Vec<RbtIndex> {
        if self.session.chosen.is_empty() { self.eye().into_iter().collect() } else { self.session.chosen.to_vec() }
    }

    /// The dragged nodes without those that hang below another one of them, which carries them along.
    pub(super) fn topmost_dragged(&self) -> Vec<RbtIndex> {
        let dragged = self.dragged_nodes();
        let scene = &self.document.scene;
        let mut in_order = dragged.clone();
        in_order.sort_unstable();
        let mut carried_until = 0;
        // Nodes below another one come right after it in the scene's order.
        in_order.retain(|&rbt| {
            let below = scene.subtree(scene.rbt_node(rbt));
            let is_topmost = below.start >= carried_until;
            carried_until = carried_until.max(below.end);
            is_topmost
        });
        dragged.into_iter().filter(|rbt| in_order.binary_search(rbt).is_ok()).collect()
    }

    /// The dragged nodes that a turn turns: each about its own origin, or the topmost ones about the common centre.
    pub(super) fn turned_nodes(&self) -> Vec<RbtIndex> {
        match self.session.pivot {
            Pivot::Own => self.dragged_nodes(),
            Pivot::Common => self.topmost_dragged(),
        }
    }

    /// The point in world space that turns of several nodes go about: the mean of the topmost ones' origins. `None` where each node turns
    /// about its own origin, which for a node alone is the same.
    pub(super) fn common_centre(&self, pose: &Pose) -> Option<Vec3> {
        let topmost = self.topmost_dragged();
        if self.session.pivot == Pivot::Own || topmost.len() < 2 {
            return None;
        }
        let origin =
            |&rbt: &RbtIndex| self.document.scene.world_from_rbt(pose, self.seconds(), rbt).translation.as_dvec3();
        #[expect(clippy::cast_precision_loss, reason = "scenes are small")]
        let count = topmost.len() as f64;
        Some((topmost.iter().map(origin).sum::<glam::DVec3>() / count).as_vec3())
    }

    pub(super) fn rotate_chosen(&mut self, axis_in_node: Vec3, radians: f64) -> CommandResult {
        let primary = self.session.chosen.primary().ok_or_else(|| self.nothing_chosen())?;
        let turn = unit(rotation_about_axis(axis_in_node, radians))
            .ok_or(CommandError::NotAValue { what: texts::VALUE_ROTATION })?;
        let pose = self.edited_pose();
        let nodes = self.turned_nodes();
        let placed = match self.common_centre(&pose) {
            None => {
                let turned = |&rbt: &RbtIndex| {
                    let from = pose.get(rbt);
                    (rbt, Rbt { rotation: from.rotation * turn, ..from }.renormalized())
                };
                nodes.iter().map(turned).collect()
            }
            Some(centre) => {
                let axes = self.document.scene.world_from_rbt(&pose, self.seconds(), primary).rotation;
                let world_from_auxiliary = Rbt::new(centre, axes);
                let turned =
                    |&rbt: &RbtIndex| (rbt, self.moved_by(&pose, rbt, Rbt::from_rotation(turn), world_from_auxiliary));
                nodes.iter().map(turned).collect()
            }
        };
        self.change_nodes(placed, turn_label(nodes.len()), None)
    }

    pub(super) fn translate_chosen(&mut self, by: Vec3) -> CommandResult {
        if self.session.chosen.is_empty() {
            return Err(self.nothing_chosen());
        }
        let pose = self.edited_pose();
        let moved = |rbt| {
            let from = pose.get(rbt);
            (rbt, Rbt { translation: from.translation + by, ..from })
        };
        let placed: Vec<_> = self.topmost_dragged().into_iter().map(moved).collect();
        let label = move_label(placed.len());
        self.change_nodes(placed, label, None)
    }

    /// A node after a motion with respect to an auxiliary frame: a new `parent_from_node`.
    pub(super) fn moved_by(&self, pose: &Pose, rbt: RbtIndex, motion: Rbt, world_from_auxiliary: Rbt) -> Rbt {
        let world_from_parent = Rbt::from_affine(&self.document.scene.world_from_parent(pose, self.seconds(), rbt));
        pose.get(rbt).moved(motion, world_from_parent.inverse() * world_from_auxiliary)
    }

    pub(super) fn change_node(
        &mut self,
        rbt: RbtIndex,
        change: impl FnOnce(Rbt) -> Rbt,
        label: Phrase,
    ) -> CommandResult {
        if rbt.get() >= self.document.scene.rbt_count() {
            return Err(CommandError::NotInScene { what: texts::VALUE_NODE });
        }
        let placed = change(self.edited_pose().get(rbt));
        self.change_nodes(vec![(rbt, placed)], label, None)
    }

    /// Gives nodes new places, in their parents' spaces, as one step of undo. Feet that are kept stay where they are.
    pub(super) fn change_nodes(
        &mut self,
        placed: Vec<(RbtIndex, Rbt)>,
        label: Phrase,
        run: Option<Run>,
    ) -> CommandResult {
        let mut pose = self.edited_pose();
        for &(rbt, placed) in &placed {
            pose.set(rbt, placeable(placed)?);
        }
        let nodes: Vec<RbtIndex> = placed.iter().map(|(rbt, _)| *rbt).collect();
        self.keep_feet(&mut pose, &nodes);
        self.end_scrub();
        self.record(label, run, |document| document.live_pose = pose)?;
        Ok(None)
    }
}
