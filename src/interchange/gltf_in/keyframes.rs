//! The motion of the RBT nodes of a tree.

use serde_json::{Map, Value};

use super::motion::{Motion, NodeMotion};
use super::pace::Pace;
use super::steering::Moved;
use super::tree::TreeNode;
use crate::interchange::reduce::{Samples, Tolerance};
use crate::keyframe::Animation;
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;
use crate::scene::SceneGraph;
use crate::words::{Message, texts};

/// The most transforms of all samples of an animation.
const MOST_TRANSFORMS: usize = 1 << 23;

/// An animation of a scene.
#[derive(Clone, Copy)]
pub(super) struct Played<'a> {
    pub tree: &'a [TreeNode],
    pub motion: &'a Motion,
    /// By node of the tree: whether timed keys move it instead.
    pub is_timed: &'a [bool],
    /// The time in the file that becomes 0 s.
    pub start: f64,
    pub scene: &'a SceneGraph,
    /// How far keyframes may be from it.
    pub tolerance: Tolerance,
}

/// The motion of a model.
#[derive(Clone, Debug)]
pub struct Moving {
    /// Poses between which every node moves straight, or nearly.
    pub samples: Samples,
    /// The keyframes that the file was made of, and what is to be said of them, if this program made it and its motion is still theirs.
    pub kept: Option<(Animation, Message)>,
}

/// The RBT nodes that move.
struct Moves<'a> {
    played: Played<'a>,
    /// Nodes of the tree, and the same in the scene.
    moved: Vec<(usize, RbtIndex)>,
    /// By RBT node: the moved node of the tree.
    of_rbts: Vec<Option<usize>>,
}

impl Moves<'_> {
    fn tree_node_at(&self, node: usize, seconds: f64) -> Rbt {
        let at = self.played.motion.at(self.played.tree, node, seconds);
        Rbt::new(at.translation.as_vec3(), at.rotation.as_quat())
    }
}

impl Moved for Moves<'_> {
    fn node_at(&self, rbt: RbtIndex, seconds: f64) -> Rbt {
        let rest = || self.played.scene.rest_pose().get(rbt);
        self.of_rbts[rbt.get()].map_or_else(rest, |node| self.tree_node_at(node, seconds))
    }

    fn keys(&self, rbt: RbtIndex) -> [&[f64]; 2] {
        let Some(node) = self.of_rbts[rbt.get()] else { return [&[]; 2] };
        let NodeMotion { translation, rotation, .. } = &self.played.motion.nodes[node];
        [
            translation.as_ref().map_or(&[], |curve| &curve.seconds),
            rotation.as_ref().map_or(&[], |curve| &curve.seconds),
        ]
    }

    fn pose_at(&self, seconds: f64) -> Pose {
        let mut pose = self.played.scene.rest_pose().clone();
        for &(node, rbt) in &self.moved {
            pose.set(rbt, self.tree_node_at(node, seconds));
        }
        pose.in_bounds()
    }
}

impl Played<'_> {
    /// The motion of RBT nodes; `None` if none moves. `pace`: what the file says of the keyframes that it was made of. `report` gets what
    /// was simplified.
    pub fn moving(
        &self,
        pace: Option<&Map<String, Value>>,
        report: &mut Vec<Message>,
    ) -> Result<Option<Moving>, Message> {
        let Self { tree, motion, is_timed, start, scene, tolerance } = *self;
        let is_moved = |node: &usize| motion.nodes[*node].is_rigid() && !is_timed[*node];
        let with_rbt = |node: usize| scene.find_rbt(&tree[node].path).map(|rbt| (node, rbt));
        let moved: Vec<(usize, RbtIndex)> = (0..tree.len()).filter(is_moved).filter_map(with_rbt).collect();
        if moved.is_empty() {
            return Ok(None);
        }
        let times = motion.times(moved.iter().map(|&(node, _)| node));
        let most = MOST_TRANSFORMS / scene.rbt_count();
        if times.len() > most {
            return Err(texts::gltf_in_too_many_samples(times.len(), most));
        }
        let mut of_rbts = vec![None; scene.rbt_count()];
        for &(node, rbt) in &moved {
            of_rbts[rbt.get()] = Some(node);
        }
        let moves = Moves { played: *self, moved, of_rbts };
        let end = times.last().copied().unwrap_or(start);
        let pace = pace.and_then(|pace| Pace::of(pace, end)).filter(|pace| pace.times().len() <= most);
        let kept = pace.and_then(|pace| pace.animation(&times, tolerance, &moves)).map(|(animation, worst)| {
            let count = texts::count_keyframes(animation.keyframes.len());
            let (degrees, units) = (format!("{:.3}", worst.degrees), format!("{:.5}", worst.units));
            (animation, texts::gltf_in_pace(count, degrees, units))
        });
        let mut samples = Samples::starting_with(moves.pose_at(start));
        for seconds in times.into_iter().filter(|&seconds| seconds > start) {
            samples.push(seconds - start, moves.pose_at(seconds)).map_err(|error| error.message())?;
        }
        if start != 0.0 {
            report.push(texts::gltf_in_starts(format!("{start:.3}")));
        }
        Ok(Some(Moving { samples, kept }))
    }
}
