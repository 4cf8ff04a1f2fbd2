//! The motion of the RBT nodes of a tree.

use serde_json::{Map, Value};

use super::motion::Motion;
use super::pace::Pace;
use super::tree::TreeNode;
use crate::interchange::reduce::{Samples, Tolerance};
use crate::keyframe::Animation;
use crate::pose::RbtIndex;
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
        let times = motion.times();
        let most = MOST_TRANSFORMS / scene.rbt_count();
        if times.len() > most {
            return Err(texts::gltf_in_too_many_samples(times.len(), most));
        }
        let pose_at = |seconds: f64| {
            let mut pose = scene.rest_pose().clone();
            for &(node, rbt) in &moved {
                let at = motion.at(tree, node, seconds);
                pose.set(rbt, Rbt::new(at.translation.as_vec3(), at.rotation.as_quat()));
            }
            pose.in_bounds()
        };
        let pace = pace.and_then(|pace| Pace::of(pace, motion.span[1])).filter(|pace| pace.times().len() <= most);
        let kept = pace.and_then(|pace| pace.animation(&times, tolerance, pose_at)).map(|(animation, worst)| {
            let count = texts::count_keyframes(animation.keyframes.len());
            let (degrees, units) = (format!("{:.3}", worst.degrees), format!("{:.5}", worst.units));
            (animation, texts::gltf_in_pace(count, degrees, units))
        });
        let mut samples = Samples::starting_with(pose_at(start));
        for seconds in times.into_iter().filter(|&seconds| seconds > start) {
            samples.push(seconds - start, pose_at(seconds)).map_err(|error| error.message())?;
        }
        if start != 0.0 {
            report.push(texts::gltf_in_starts(format!("{start:.3}")));
        }
        Ok(Some(Moving { samples, kept }))
    }
}
