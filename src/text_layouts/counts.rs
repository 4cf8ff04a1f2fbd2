//! The numbers of nodes that a keyframe may have.

use super::Options;
use super::joints::{self, JointList};
use crate::scene::SceneGraph;
use crate::words::{self, Argument};

/// The number of nodes of the scene to which the course's later assignments add some.
const COURSE_NODES: usize = 22;
/// The numbers of nodes in those assignments.
const LATER_COURSE_NODES: [usize; 3] = [24, 25, 26];

/// The possible numbers of nodes per keyframe.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Counts {
    /// That of the scene or of the list of joints, then those of later assignments.
    likely: Vec<usize>,
    /// That of a scene whose robots have no heads. The offsets must confirm it.
    without_heads: Option<usize>,
}

impl Counts {
    /// Those of a scene, or of a list of joints.
    pub(super) fn new(scene: &SceneGraph, options: &Options) -> Self {
        let own = options.joints.as_ref().map_or(scene.rbt_count(), JointList::rows);
        let is_course = scene.rbt_count() == COURSE_NODES;
        let mut likely = vec![own];
        likely.extend(LATER_COURSE_NODES.into_iter().filter(|&later| is_course && later > own));
        let heads = joints::heads(scene).len();
        Self { likely, without_heads: (heads > 0 && options.joints.is_none()).then(|| own - heads) }
    }

    /// The scene's own number, or that of the list of joints.
    pub(super) fn own(&self) -> usize {
        self.likely[0]
    }

    /// Whether keyframes may have so many nodes.
    pub(super) fn accept(&self, nodes: usize) -> bool {
        self.all().any(|count| count == nodes)
    }

    /// Whether a number must be confirmed by the offsets.
    pub(super) fn needs_offsets(&self, nodes: usize) -> bool {
        self.without_heads == Some(nodes) && !self.likely.contains(&nodes)
    }

    /// All numbers, the most likely first.
    pub(super) fn all(&self) -> impl Iterator<Item = usize> + '_ {
        self.likely.iter().copied().chain(self.without_heads)
    }

    /// The likely numbers in words: `22, 24, 25 or 26`.
    pub(super) fn in_words(&self) -> Argument {
        words::one_of(&self.likely.iter().map(ToString::to_string).collect::<Vec<_>>())
    }
}
