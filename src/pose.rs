//! A pose: one `parent_from_node` for each RBT node of a scene. The live state, a keyframe and a sample are all poses.

mod block;

use std::sync::Arc;

use crate::rbt::{LARGEST_COORDINATE, Rbt};

pub use block::{LANES, RbtBlock};

/// The index of an RBT node in a scene's pre-order walk of its RBT nodes; issued by [`crate::scene::SceneGraph`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RbtIndex(usize);

impl RbtIndex {
    /// The node with this index. It must be below the number of RBT nodes of the scene it is used with.
    #[must_use]
    pub const fn new(index: usize) -> Self {
        Self(index)
    }

    /// The index in poses and files, from 0.
    #[must_use]
    pub const fn get(self) -> usize {
        self.0
    }
}

/// `parent_from_node` of every RBT node, in the scene's order. Clones share storage; a change copies shared storage first.
///
/// The transforms lie in blocks of [`LANES`], as [`crate::blend`] takes them.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    blocks: Arc<[RbtBlock]>,
    len: usize,
}

impl Pose {
    /// A pose of these transforms, in the scene's order.
    #[must_use]
    pub fn new(parent_from_node: Vec<Rbt>) -> Self {
        Self::from_slice(&parent_from_node)
    }

    /// A pose of a copy of these transforms.
    #[must_use]
    pub fn from_slice(rbts: &[Rbt]) -> Self {
        let block = |rbts: &[Rbt]| {
            let mut block = RbtBlock::IDENTITY;
            for (lane, &rbt) in rbts.iter().enumerate() {
                block.set(lane, rbt);
            }
            block
        };
        Self { blocks: rbts.chunks(LANES).map(block).collect(), len: rbts.len() }
    }

    /// A pose of `len` identity transforms.
    #[must_use]
    pub fn identity(len: usize) -> Self {
        Self { blocks: (0..len.div_ceil(LANES)).map(|_| RbtBlock::IDENTITY).collect(), len }
    }

    /// How many RBT nodes it has.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.len
    }

    /// Whether it has none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// All transforms, in the scene's order.
    #[must_use]
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Rbt> + '_ {
        (0..self.len).map(|index| self.get(RbtIndex(index)))
    }

    /// All transforms, in the scene's order, as a new list.
    #[must_use]
    pub fn to_vec(&self) -> Vec<Rbt> {
        self.iter().collect()
    }

    /// The transforms in blocks. The last block is filled up with the identity.
    #[must_use]
    pub fn blocks(&self) -> &[RbtBlock] {
        &self.blocks
    }

    /// Makes this a pose of `len` nodes whose blocks are all written by `write`. Reuses the storage if nothing shares it.
    pub(crate) fn fill(&mut self, len: usize, write: impl FnOnce(&mut [RbtBlock])) {
        if self.len != len || Arc::get_mut(&mut self.blocks).is_none() {
            *self = Self::identity(len);
        }
        let blocks = Arc::get_mut(&mut self.blocks).expect("it was made anew if it was shared");
        write(blocks);
        if let Some(last) = blocks.last_mut() {
            for lane in (len - 1) % LANES + 1..LANES {
                last.set(lane, Rbt::IDENTITY);
            }
        }
    }

    /// One node's `parent_from_node`.
    #[must_use]
    pub fn get(&self, rbt: RbtIndex) -> Rbt {
        assert!(rbt.0 < self.len, "RBT node {} of a pose of {}", rbt.0, self.len);
        self.blocks[rbt.0 / LANES].get(rbt.0 % LANES)
    }

    /// Changes one node's `parent_from_node`. Poses that share storage with this one do not change.
    pub fn set(&mut self, rbt: RbtIndex, parent_from_node: Rbt) {
        assert!(rbt.0 < self.len, "RBT node {} of a pose of {}", rbt.0, self.len);
        Arc::make_mut(&mut self.blocks)[rbt.0 / LANES].set(rbt.0 % LANES, parent_from_node);
    }

    /// The same pose with each coordinate moved into ±[`LARGEST_COORDINATE`]. Shares storage if all are there. For samples, which splines
    /// can lead further, before a document takes them.
    #[must_use]
    pub fn in_bounds(&self) -> Self {
        let mut bounded = self.clone();
        let is_in = |block: &RbtBlock| block.translation.as_flattened().iter().all(|x| x.abs() <= LARGEST_COORDINATE);
        if !self.blocks.iter().all(is_in) {
            for block in Arc::make_mut(&mut bounded.blocks) {
                for x in block.translation.as_flattened_mut() {
                    *x = x.clamp(-LARGEST_COORDINATE, LARGEST_COORDINATE);
                }
            }
        }
        bounded
    }

    /// Whether the two poses share storage. If so they are equal; the check takes constant time.
    #[must_use]
    pub fn shares_with(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.blocks, &other.blocks)
    }

    /// The address of the storage: equal for poses that share it, different for others that exist at the same time.
    #[must_use]
    pub fn storage(&self) -> usize {
        self.blocks.as_ptr().addr()
    }

    /// Whether another pose shares the storage.
    #[must_use]
    pub fn is_held_elsewhere(&self) -> bool {
        Arc::strong_count(&self.blocks) > 1
    }

    /// Whether two poses are equal. Constant time if they share storage.
    #[must_use]
    pub fn same_as(&self, other: &Self) -> bool {
        self.shares_with(other) || self == other
    }
}
