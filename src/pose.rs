//! A pose: one `parent_from_node` for each RBT node of a scene. The live state, a keyframe and a sample are all poses.

use std::sync::Arc;

use crate::rbt::Rbt;

/// Which RBT node of a scene, by its place in a pre-order walk; issued by [`crate::scene::SceneGraph`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RbtIndex(usize);

impl RbtIndex {
    /// The node in that place; `place` must be below the number of RBT nodes of the scene it is used with.
    #[must_use]
    pub const fn new(place: usize) -> Self {
        Self(place)
    }

    /// Its place in poses and files, from 0.
    #[must_use]
    pub const fn get(self) -> usize {
        self.0
    }
}

/// `parent_from_node` of every RBT node, in the scene's order. Cloning shares; a change copies where it is shared.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    parent_from_node: Arc<[Rbt]>,
}

impl Pose {
    /// A pose of these transforms.
    #[must_use]
    pub fn new(parent_from_node: Vec<Rbt>) -> Self {
        Self { parent_from_node: parent_from_node.into() }
    }

    /// A pose in storage that may be shared.
    #[must_use]
    pub const fn from_shared(parent_from_node: Arc<[Rbt]>) -> Self {
        Self { parent_from_node }
    }

    /// How many RBT nodes it has.
    #[must_use]
    pub fn len(&self) -> usize {
        self.parent_from_node.len()
    }

    /// Whether it has none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.parent_from_node.is_empty()
    }

    /// All transforms, in the scene's order.
    #[must_use]
    pub fn as_slice(&self) -> &[Rbt] {
        &self.parent_from_node
    }

    /// One node's `parent_from_node`.
    #[must_use]
    pub fn get(&self, rbt: RbtIndex) -> Rbt {
        self.parent_from_node[rbt.0]
    }

    /// Changes one node's `parent_from_node`; poses that shared with this one keep theirs.
    pub fn set(&mut self, rbt: RbtIndex, parent_from_node: Rbt) {
        Arc::make_mut(&mut self.parent_from_node)[rbt.0] = parent_from_node;
    }

    /// Whether the two share their storage, which makes them equal at no cost.
    #[must_use]
    pub fn shares_with(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.parent_from_node, &other.parent_from_node)
    }

    /// A number that poses have in common which share their storage, and no others while both are held.
    #[must_use]
    pub fn identity(&self) -> usize {
        self.parent_from_node.as_ptr().addr()
    }

    /// Whether another pose shares the storage.
    #[must_use]
    pub fn is_held_elsewhere(&self) -> bool {
        Arc::strong_count(&self.parent_from_node) > 1
    }

    /// Whether two poses are the same, at no cost where they share.
    #[must_use]
    pub fn same_as(&self, other: &Self) -> bool {
        self.shares_with(other) || self == other
    }
}
