//! The chosen nodes.

use std::ops::Deref;

use crate::pose::RbtIndex;

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
