//! `world_from_node` of every node from a pose: one forward loop over compact data.

use glam::Affine3A;

use super::graph::{Node, NodeKind};
use crate::blend::{self, AlignedAffine, MatrixBlock};
use crate::pose::{LANES, Pose};

/// Blocks of RBT nodes whose matrices are computed in one batch. Small enough for the first-level cache; large enough that the stores have
/// completed before the loads.
const BATCH: usize = 8;
/// The parent index of nodes right under the root.
const NO_PARENT: u32 = u32::MAX;

/// The data of each node that the walk needs, in arena order.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Walk {
    /// The parents' indices.
    parents: Vec<u32>,
    runs: Vec<Run>,
    /// `parent_from_shape` of every shape.
    fixed: Vec<Affine3A>,
}

/// Consecutive nodes of one kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Run {
    /// A number of RBT nodes, which take the next transforms of the pose.
    Rbts(usize),
    /// A number of shapes, which take the next of the fixed placements.
    Shapes(usize),
    /// A control node: its keys.
    Keys,
}

impl Walk {
    /// The walk through these nodes. Parents must come first.
    pub fn through<'a>(nodes: impl IntoIterator<Item = &'a Node>) -> Self {
        let mut walk = Self::default();
        for node in nodes {
            walk.parents.push(node.parent.map_or(NO_PARENT, |parent| parent.get() as u32));
            match (&node.kind, walk.runs.last_mut()) {
                (NodeKind::Rbt(_), Some(Run::Rbts(count))) => *count += 1,
                (NodeKind::Rbt(_), _) => walk.runs.push(Run::Rbts(1)),
                (NodeKind::Shape(placed), last) => {
                    walk.fixed.push(placed.parent_from_shape());
                    match last {
                        Some(Run::Shapes(count)) => *count += 1,
                        _ => walk.runs.push(Run::Shapes(1)),
                    }
                }
                (NodeKind::Control(_), _) => walk.runs.push(Run::Keys),
            }
        }
        walk
    }

    /// Sets `into` to the `world_from_node` of every node. `keys_of` returns `parent_from_node` of the control node with an index.
    pub fn world_from_nodes(&self, pose: &Pose, keys_of: impl Fn(usize) -> Affine3A, into: &mut Vec<AlignedAffine>) {
        let level = blend::widest();
        let mut batches = pose.blocks().chunks(BATCH);
        let mut matrices = [MatrixBlock::default(); BATCH];
        // Indices into the batch of matrices. The batch is empty at first.
        let (mut next, mut end) = (0, 0);
        let mut fixed = self.fixed.iter();
        into.resize(self.parents.len(), AlignedAffine::IDENTITY);
        let mut node_index = 0;
        for run in &self.runs {
            match *run {
                Run::Rbts(mut left) => {
                    while left > 0 {
                        if next == end {
                            let batch = batches.next().unwrap_or_default();
                            blend::matrices(level, batch, &mut matrices);
                            (next, end) = (0, BATCH * LANES);
                        }
                        let count = left.min(end - next);
                        let parents = &self.parents[node_index..node_index + count];
                        blend::compose(level, &matrices, next, parents, into, node_index);
                        next += count;
                        node_index += count;
                        left -= count;
                    }
                }
                Run::Shapes(count) => {
                    for parent_from_shape in fixed.by_ref().take(count) {
                        into[node_index] = (self.world_from_parent(node_index, into) * *parent_from_shape).into();
                        node_index += 1;
                    }
                }
                Run::Keys => {
                    into[node_index] = (self.world_from_parent(node_index, into) * keys_of(node_index)).into();
                    node_index += 1;
                }
            }
        }
    }

    fn world_from_parent(&self, node_index: usize, world_from_node: &[AlignedAffine]) -> Affine3A {
        world_from_node.get(self.parents[node_index] as usize).map_or(Affine3A::IDENTITY, AlignedAffine::get)
    }
}

#[cfg(test)]
mod tests {
    use glam::{Quat, Vec3};

    use super::AlignedAffine;
    use crate::pose::Pose;
    use crate::rbt::Rbt;
    use crate::scene::{SceneBuilder, SceneGraph, built_in_scene};

    /// A tree of `count` RBT nodes with three children each.
    fn tree(count: usize) -> SceneGraph {
        fn below(builder: &mut SceneBuilder, index: usize, count: usize) {
            if index < count {
                builder.open_rbt(&format!("n{index}"), Rbt::IDENTITY).unwrap();
                (1..=3).for_each(|child| below(builder, 3 * index + child, count));
                builder.close();
            }
        }
        let mut builder = SceneBuilder::new();
        below(&mut builder, 0, count);
        builder.finish("tree", &["n0".to_owned()], 1.0).unwrap()
    }

    fn spread(count: usize) -> Pose {
        let rbt = |node: usize| {
            let phase = 0.37 * node as f32;
            let axis = Vec3::new(phase.sin(), (1.3 * phase).cos(), (0.7 * phase).sin() + 0.1).normalize();
            Rbt::new(axis * 3.0, Quat::from_axis_angle(axis, phase))
        };
        Pose::new((0..count).map(rbt).collect())
    }

    #[test]
    fn the_walk_is_what_the_simple_loop_says() {
        let built_in = ["two-robots", "cylinder", "orbits"].map(|name| built_in_scene(name).unwrap());
        for scene in [1, 15, 16, 17, 22, 128, 129, 10_007].map(tree).into_iter().chain(built_in) {
            let pose = spread(scene.rbt_count());
            for seconds in [0.0, 1.3] {
                let simple = scene.world_from_nodes_with(seconds, |rbt| pose.get(rbt).to_affine());
                let walked = scene.world_from_nodes(&pose, seconds);
                assert_eq!(walked.len(), simple.len());
                for (walked, simple) in walked.iter().map(AlignedAffine::get).zip(&simple) {
                    assert!(walked.abs_diff_eq(*simple, 4e-5), "{walked} is not {simple}");
                }
            }
        }
    }
}
