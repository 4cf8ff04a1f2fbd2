//! Reaching with limbs, turning them about the line to their end, and feet that stay in place while the body moves.

use glam::Vec3;

use super::apply::CommandResult;
use super::{CommandError, Editor};
use crate::pose::{Pose, RbtIndex};
use crate::rbt::{Rbt, are_coordinates};
use crate::scene::{LimbError, PosedLimb};
use crate::words::{Phrase, texts};

/// An end that is farther from its target, in scene units, is said to be short of it.
const SHORT: f64 = 1e-3;

impl Editor {
    /// The limb that ends with a node, as it stands in the pose that edits change. During a drag the plane of its bend is that of the
    /// drag's beginning.
    fn limb(&self, last: RbtIndex) -> Result<PosedLimb, CommandError> {
        if last.get() >= self.document.scene.rbt_count() {
            return Err(CommandError::NotInScene { what: texts::VALUE_NODE });
        }
        let pose = self.edited_pose();
        let from = self.pose_before_drag().unwrap_or_else(|| pose.clone());
        self.document.scene.limb(&from, &pose, self.seconds(), last).map_err(|error| {
            let path = self.document.scene.rbt_path(last).to_owned();
            match error {
                LimbError::NoEnd => CommandError::NoLimb { path },
                LimbError::Squeezed => CommandError::SqueezedLimb { path },
            }
        })
    }

    pub(super) fn reach(&mut self, last: RbtIndex, target_in_world: Vec3) -> CommandResult {
        let limb = self.limb(last)?;
        self.reach_with(&limb, target_in_world)
    }

    pub(super) fn reach_by(&mut self, last: RbtIndex, by_in_world: Vec3) -> CommandResult {
        let limb = self.limb(last)?;
        self.reach_with(&limb, limb.end_in_world().as_vec3() + by_in_world)
    }

    fn reach_with(&mut self, limb: &PosedLimb, target_in_world: Vec3) -> CommandResult {
        if target_in_world.is_nan() {
            return Err(CommandError::NotAValue { what: texts::VALUE_POSITION });
        }
        if !are_coordinates(target_in_world) {
            return Err(CommandError::TooFar);
        }
        let target = target_in_world.as_dvec3();
        let reached = limb.reaching(target);
        self.turn_limb(&reached, texts::ACT_REACH)?;
        let short = reached.end_in_world().distance(target);
        let path = self.document.scene.rbt_path(limb.nodes().last);
        // A drag says nothing while it goes on.
        let is_said = short > SHORT && self.gesture.is_none();
        Ok(is_said.then(|| texts::reach_short(path, format!("{short:.3}"))))
    }

    pub(super) fn turn_pole(&mut self, last: RbtIndex, degrees: f64) -> CommandResult {
        if !degrees.is_finite() {
            return Err(CommandError::NotAValue { what: texts::VALUE_ROTATION });
        }
        let limb = self.limb(last)?;
        let path = || self.document.scene.rbt_path(last).to_owned();
        let turned = limb.swivelled(degrees.to_radians()).ok_or_else(|| CommandError::NoPole { path: path() })?;
        self.turn_limb(&turned, texts::ACT_TURN_A_LIMB)
    }

    fn turn_limb(&mut self, limb: &PosedLimb, label: Phrase) -> CommandResult {
        let pose = self.edited_pose();
        let placed = limb.rotations().map(|(rbt, rotation)| (rbt, Rbt { rotation, ..pose.get(rbt) })).collect();
        self.change_nodes(placed, label, None)
    }

    /// Where the user keeps feet: turns the limbs below the moved nodes whose ends stand on something, so that these are where they were
    /// before the edit or the drag, turned as little as the limb allows. The result depends on the pose before and on the other nodes
    /// alone, not on the way there. Limbs that are moved themselves, and those that cannot reach, go along.
    pub(super) fn keep_feet(&self, pose: &mut Pose, moved: &[RbtIndex]) {
        if !self.session.keeps_feet {
            return;
        }
        let from = &self.pose_before_drag().unwrap_or_else(|| self.edited_pose());
        let scene = &self.document.scene;
        let seconds = self.seconds();
        // Of the chosen nodes some are only carried along, and count as moved too: a journal has a place for each of them.
        let chosen = &self.session.chosen;
        let with_chosen = if moved.iter().any(|rbt| chosen.contains(rbt)) { &chosen[..] } else { &[] };
        for last in scene.limb_ends().filter(|&rbt| scene.node(scene.rbt_node(rbt)).joint.stands) {
            let nodes = scene.limb_nodes(last);
            let own = || nodes.upper.into_iter().chain([last]);
            let root = nodes.upper.unwrap_or(last);
            let is_carried = moved.iter().any(|&moved| scene.is_above(moved, root));
            if !is_carried || own().any(|rbt| moved.contains(&rbt) || with_chosen.contains(&rbt)) {
                continue;
            }
            for rbt in own() {
                pose.set(rbt, from.get(rbt));
            }
            let (Ok(stood), Ok(limb)) = (scene.limb(from, from, seconds, last), scene.limb(from, pose, seconds, last))
            else {
                continue;
            };
            if limb.is_carried_as(&stood) {
                continue;
            }
            for (rbt, rotation) in limb.standing(stood.end_in_world(), stood.world_from_last()).rotations() {
                pose.set(rbt, Rbt { rotation, ..pose.get(rbt) });
            }
        }
    }
}
