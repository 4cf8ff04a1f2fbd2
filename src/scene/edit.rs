//! Scenes with a control node added, removed or renamed. Poses stay valid: the RBT nodes and their order do not change.

use std::sync::Arc;

use super::builder::SceneBuilder;
use super::file::SceneError;
use super::graph::{Node, NodeId, NodeKind, SceneGraph};
use super::shape::Shape;
use super::tracks::Tracks;

/// The change of one node.
enum Change<'a> {
    PutAbove { name: &'a str },
    Remove,
    Rename { name: &'a str },
}

impl SceneGraph {
    /// The scene with a new control node above a node, and the new node's path. It has no keys, so nothing moves. The paths of the nodes
    /// below do not contain its name, so keyframe files remain valid.
    ///
    /// # Errors
    /// [`SceneError::TooDeep`] if a node would be deeper than [`super::MOST_LEVELS`].
    pub fn with_control_above(&self, id: NodeId) -> Result<(Self, String), SceneError> {
        let node = self.node(id);
        let stem = format!("{}_control", node.name);
        let above = node.path.strip_suffix(node.name.as_str()).unwrap_or_default();
        let name = std::iter::once(stem.clone())
            .chain((2..).map(|count: u32| format!("{stem}{count}")))
            .find(|name| self.find(&format!("{above}{name}")).is_none())
            .expect("the numbers do not end");
        let path = format!("{above}{name}");
        // The name is new, and all others stay as they are.
        Ok((self.changed(id, &Change::PutAbove { name: &name })?, path))
    }

    /// The scene without a control node. Its children move up to its parent, in its position.
    ///
    /// # Errors
    /// [`SceneError`] if the node is not a control node, moves a skin, or two nodes would have one path.
    pub fn without_control(&self, id: NodeId) -> Result<Self, SceneError> {
        self.check_control(id)?;
        self.changed(id, &Change::Remove)
    }

    /// The scene with another name for a control node.
    ///
    /// # Errors
    /// [`SceneError`] if the node is not a control node, the name is not valid, or two nodes would have one path.
    pub fn with_control_renamed(&self, id: NodeId, name: &str) -> Result<Self, SceneError> {
        self.check_control(id)?;
        self.changed(id, &Change::Rename { name })
    }

    fn check_control(&self, id: NodeId) -> Result<(), SceneError> {
        let node = self.node(id);
        match node.kind {
            NodeKind::Control(_) => Ok(()),
            NodeKind::Rbt(_) | NodeKind::Shape(_) => Err(SceneError::NotControl { path: node.path.clone() }),
        }
    }

    /// Rebuilds all nodes with one changed. The eyes stay the same nodes.
    fn changed(&self, changed: NodeId, change: &Change<'_>) -> Result<Self, SceneError> {
        let mut builder = SceneBuilder::new();
        builder.lighting(*self.lighting());
        if let Some(meshes) = self.meshes() {
            builder.meshes(Arc::clone(meshes));
        }
        // Where a node stands afterwards.
        let moved = |id: NodeId| match change {
            Change::PutAbove { .. } if id >= changed => NodeId::from_index(id.get() + 1),
            Change::Remove if id > changed => NodeId::from_index(id.get() - 1),
            _ => id,
        };
        // For each open node, the index of the first node that is not below it.
        let mut ends: Vec<usize> = Vec::new();
        for (id, node) in self.nodes_with_ids() {
            while ends.last().is_some_and(|&end| end <= id.get()) {
                ends.pop();
                builder.close();
            }
            let mut name = node.name.as_str();
            if id == changed {
                match *change {
                    Change::Remove => continue,
                    Change::Rename { name: new } => name = new,
                    Change::PutAbove { name: new } => {
                        builder.open_control(new, Tracks::default(), false)?;
                        ends.push(self.subtree(id).end);
                    }
                }
            }
            if let NodeKind::Shape(placed) = &node.kind
                && let Shape::Mesh(mesh) = &placed.shape
            {
                if matches!(change, Change::Remove) && mesh.joints().contains(&changed) {
                    let path = self.node(changed).path.clone();
                    return Err(SceneError::MovesSkin { path, skin: node.path.clone() });
                }
                let shape = builder.shape(name, placed.clone())?;
                builder.set_joints(shape, mesh.joints().iter().copied().map(moved).collect());
                continue;
            }
            if self.add_to(&mut builder, name, node)? {
                ends.push(self.subtree(id).end);
            }
        }
        Ok(builder.finish_with(self.name(), self.eyes().to_vec(), self.vertical_fov_degrees()))
    }

    /// Adds a node and returns whether it was opened.
    fn add_to(&self, builder: &mut SceneBuilder, name: &str, node: &Node) -> Result<bool, SceneError> {
        match &node.kind {
            NodeKind::Rbt(rbt) => {
                builder.open_rbt(name, self.rest_pose().get(*rbt))?;
                builder.joint(node.joint);
            }
            NodeKind::Control(tracks) => {
                builder.open_control(name, tracks.clone(), node.is_in_paths)?;
            }
            NodeKind::Shape(placed) => {
                builder.shape(name, placed.clone())?;
                return Ok(false);
            }
        }
        Ok(true)
    }
}
