//! Building a scene: nodes one by one, in pre-order.

use std::collections::HashMap;
use std::sync::Arc;

use super::file::SceneError;
use super::graph::{Common, Node, NodeId, NodeKind, SceneGraph};
use super::joint::Joint;
use super::shape::PlacedShape;
use super::tracks::Tracks;
use super::walk::Walk;
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;

/// The most levels of nodes. The only bound of its kind: files and edits share it, and code that goes through a scene may be recursive.
pub const MOST_LEVELS: usize = 256;

/// Builds a [`SceneGraph`] node by node, in pre-order.
#[derive(Debug, Default)]
pub struct SceneBuilder {
    nodes: Vec<Node>,
    rbt_nodes: Vec<NodeId>,
    rest: Vec<Rbt>,
    by_path: HashMap<String, NodeId>,
    open: Vec<NodeId>,
}

impl SceneBuilder {
    /// A builder with no nodes.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds an RBT node under the innermost open one and opens it, so that the nodes added next are below it until [`Self::close`].
    ///
    /// # Errors
    /// When the name is empty, contains `/`, or is used twice under one parent, or the node is deeper than [`MOST_LEVELS`].
    pub fn open_rbt(&mut self, name: &str, rest_parent_from_node: Rbt) -> Result<NodeId, SceneError> {
        let rbt = RbtIndex::new(self.rbt_nodes.len());
        let id = self.push(name, NodeKind::Rbt(rbt))?;
        self.rbt_nodes.push(id);
        self.rest.push(rest_parent_from_node);
        self.open.push(id);
        Ok(id)
    }

    /// Says how the innermost open node, an RBT node, reaches.
    pub fn joint(&mut self, joint: Joint) {
        if let Some(&id) = self.open.last() {
            self.nodes[id.get()].joint = joint;
        }
    }

    /// Adds a control node under the innermost open node and opens it, so that the nodes added next are below it until [`Self::close`].
    /// `is_in_paths`: whether the paths of the nodes below contain its name.
    ///
    /// # Errors
    /// When the name is empty, contains `/`, or is used twice under one parent, or the node is deeper than [`MOST_LEVELS`].
    pub fn open_control(&mut self, name: &str, tracks: Tracks, is_in_paths: bool) -> Result<NodeId, SceneError> {
        let id = self.push(name, NodeKind::Control(tracks))?;
        self.nodes[id.get()].is_in_paths = is_in_paths;
        self.open.push(id);
        Ok(id)
    }

    /// Adds a shape under the innermost open node.
    ///
    /// # Errors
    /// When the name is empty, contains `/`, or is used twice under one parent, or the node is deeper than [`MOST_LEVELS`].
    pub fn shape(&mut self, name: &str, placed: PlacedShape) -> Result<NodeId, SceneError> {
        self.push(name, NodeKind::Shape(placed))
    }

    /// Closes the innermost open node.
    pub fn close(&mut self) {
        if let Some(id) = self.open.pop() {
            let end = NodeId::from_index(self.nodes.len());
            self.nodes[id.get()].subtree_end = end;
        }
    }

    fn push(&mut self, name: &str, kind: NodeKind) -> Result<NodeId, SceneError> {
        let parent = self.open.last().copied();
        let named_above =
            std::iter::successors(parent, |id| self.nodes[id.get()].parent).find(|id| self.nodes[id.get()].is_in_paths);
        let parent_path = named_above.map(|id| self.nodes[id.get()].path.as_str());
        if name.is_empty() || name.contains('/') {
            return Err(SceneError::NodeName {
                name: name.to_owned(),
                parent: parent_path.unwrap_or("the root").to_owned(),
            });
        }
        let path = parent_path.map_or_else(|| name.to_owned(), |above| format!("{above}/{name}"));
        if self.open.len() >= MOST_LEVELS {
            return Err(SceneError::TooDeep { path });
        }
        let id = NodeId::from_index(self.nodes.len());
        if self.by_path.insert(path.clone(), id).is_some() {
            return Err(SceneError::DuplicatePath { path });
        }
        self.nodes.push(Node {
            name: name.to_owned(),
            path,
            is_in_paths: true,
            parent,
            kind,
            joint: Joint::default(),
            depth: self.open.len(),
            subtree_end: NodeId::from_index(id.get() + 1),
        });
        Ok(id)
    }

    /// The finished scene.
    ///
    /// `eye_paths` are the paths of the RBT nodes that are eyes; `vertical_fov_degrees` is above 0 and below 180.
    ///
    /// # Errors
    /// If there is no RBT node, no eye, an eye that is not an RBT node, a field of view out of range, or scales that multiply to too much.
    pub fn finish(self, name: &str, eye_paths: &[String], vertical_fov_degrees: f32) -> Result<SceneGraph, SceneError> {
        let rbt_of = |path: &String| match self.nodes[self.by_path.get(path)?.get()].kind {
            NodeKind::Rbt(rbt) => Some(rbt),
            NodeKind::Shape(_) | NodeKind::Control(_) => None,
        };
        let eyes: Result<Vec<RbtIndex>, SceneError> =
            eye_paths.iter().map(|path| rbt_of(path).ok_or_else(|| SceneError::Eye { path: path.clone() })).collect();
        let vertical_fov = vertical_fov_degrees.to_radians();
        if !(vertical_fov > 0.0 && vertical_fov < std::f32::consts::PI) {
            return Err(SceneError::FieldOfView { degrees: vertical_fov_degrees });
        }
        let eyes = eyes?;
        if eyes.is_empty() {
            return Err(SceneError::NoEyes);
        }
        let scene = self.finish_with(name, eyes, vertical_fov_degrees);
        scene.check_scales()?;
        Ok(scene)
    }

    /// Like [`Self::finish`], for values that are known to be valid.
    pub(super) fn finish_with(mut self, name: &str, eyes: Vec<RbtIndex>, vertical_fov_degrees: f32) -> SceneGraph {
        while !self.open.is_empty() {
            self.close();
        }
        let common = Common {
            name: name.to_owned(),
            rbt_nodes: self.rbt_nodes,
            by_path: self.by_path,
            rest: Pose::new(self.rest),
            walk: Walk::through(&self.nodes),
            eyes,
            vertical_fov_degrees,
        };
        SceneGraph::of_parts(self.nodes.into_iter().map(Arc::new).collect(), Arc::new(common))
    }
}
