//! The chosen nodes, and what they turn about.

use std::ops::Deref;

use crate::pose::RbtIndex;

/// What several chosen nodes turn about. A node alone turns about its own origin.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pivot {
    /// Each about its own origin; of a chain each node, so that it curls.
    #[default]
    Own,
    /// All about the mean of their origins, as if they were one body. What hangs below a chosen node is only carried along.
    Common,
}

impl Pivot {
    /// Both, with their names in scripts.
    pub const NAMES: [(Self, &'static str); 2] = [(Self::Own, "own"), (Self::Common, "common")];
}

/// The nodes that drags, `rotate` and `translate` move, in the order in which they were chosen, each once. It derefs to a slice.
///
/// The last one is the primary: numbers, arcball, motion path and graphs show it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Choice {
    nodes: Vec<RbtIndex>,
}

impl Choice {
    /// The node that was chosen last; `None` if none is chosen: drags move the eye.
    #[must_use]
    pub fn primary(&self) -> Option<RbtIndex> {
        self.nodes.last().copied()
    }

    /// Adds a node as the primary, or takes it out if it is chosen. Then the one that was chosen before it is the primary.
    pub(super) fn toggle(&mut self, rbt: RbtIndex) {
        if let Some(place) = self.nodes.iter().position(|&chosen| chosen == rbt) {
            self.nodes.remove(place);
        } else {
            self.nodes.push(rbt);
        }
    }
}

impl From<Option<RbtIndex>> for Choice {
    fn from(rbt: Option<RbtIndex>) -> Self {
        Self { nodes: rbt.into_iter().collect() }
    }
}

impl Deref for Choice {
    type Target = [RbtIndex];

    fn deref(&self) -> &[RbtIndex] {
        &self.nodes
    }
}
