//! Building a scene: nodes one by one, in pre-order.

use std::collections::HashMap;
use std::sync::Arc;

use super::file::SceneError;
use super::graph::{Common, Node, NodeId, NodeKind, SceneGraph};
use super::joint::Joint;
use super::lighting::SceneLighting;
use super::shape::{PlacedShape, Shape};
use super::shapes::MeshShape;
use super::tracks::Tracks;
use super::walk::Walk;
use crate::model::MeshLibrary;
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
    lighting: SceneLighting,
    meshes: Option<Arc<MeshLibrary>>,
    /// Shapes of meshes by name, so that shapes of one mesh share what is computed of it.
    mesh_shapes: HashMap<String, MeshShape>,
    /// The paths of joints, which may come after the shapes that they move.
    joints: Vec<(NodeId, Vec<String>)>,
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

    /// The lighting of the scene; without it, that of the day.
    pub const fn lighting(&mut self, lighting: SceneLighting) {
        self.lighting = lighting;
    }

    /// The meshes of the scene. Shapes of meshes must be of these.
    pub fn meshes(&mut self, meshes: Arc<MeshLibrary>) {
        self.meshes = Some(meshes);
    }

    /// A shape of the scene's mesh with a name; `path` is that of its node, for errors. What moves its skin is [given](Self::joints) once
    /// the shape is added.
    ///
    /// # Errors
    /// When no mesh has the name.
    pub fn mesh_shape(&mut self, path: &str, name: &str) -> Result<Shape, SceneError> {
        if let Some(shape) = self.mesh_shapes.get(name) {
            return Ok(Shape::Mesh(shape.clone()));
        }
        let mesh = self.meshes.as_ref().and_then(|meshes| meshes.find(name));
        let mesh = mesh.ok_or_else(|| SceneError::Mesh { path: path.to_owned(), name: name.to_owned() })?;
        let shape = MeshShape::new(Arc::clone(mesh));
        self.mesh_shapes.insert(name.to_owned(), shape.clone());
        Ok(Shape::Mesh(shape))
    }

    /// Names the nodes that move the skin of a mesh by their paths, in the order of the skin's joints. They may be added later.
    pub fn joints(&mut self, shape: NodeId, paths: Vec<String>) {
        self.joints.push((shape, paths));
    }

    /// Sets the nodes that move the skin of a mesh.
    pub(super) fn set_joints(&mut self, shape: NodeId, joints: Arc<[NodeId]>) {
        if let NodeKind::Shape(placed) = &mut self.nodes[shape.get()].kind
            && let Shape::Mesh(mesh) = &placed.shape
        {
            placed.shape = Shape::Mesh(mesh.with_joints(joints));
        }
    }

    /// Sets the joints that were named by paths, and checks those of all shapes.
    fn find_joints(&mut self) -> Result<(), SceneError> {
        for (shape, paths) in std::mem::take(&mut self.joints) {
            let is_joint = |id: &&NodeId| !matches!(self.nodes[id.get()].kind, NodeKind::Shape(_));
            let find = |joint: &String| {
                self.by_path.get(joint).filter(is_joint).copied().ok_or_else(|| SceneError::SkinJoint {
                    path: self.nodes[shape.get()].path.clone(),
                    joint: joint.clone(),
                })
            };
            let joints = paths.iter().map(find).collect::<Result<Vec<NodeId>, _>>()?;
            self.set_joints(shape, joints.into());
        }
        for node in &self.nodes {
            if let NodeKind::Shape(placed) = &node.kind
                && let Shape::Mesh(mesh) = &placed.shape
            {
                let expected = mesh.mesh().skin.as_ref().map_or(0, |skin| skin.joint_from_shape.len());
                let found = mesh.joints().len();
                if found != expected {
                    return Err(SceneError::SkinJoints { path: node.path.clone(), found, expected });
                }
            }
        }
        Ok(())
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
    /// If there is no RBT node, no eye, an eye that is not an RBT node, a field of view out of range, scales that multiply to too much, or a
    /// skin without its joints.
    pub fn finish(
        mut self,
        name: &str,
        eye_paths: &[String],
        vertical_fov_degrees: f32,
    ) -> Result<SceneGraph, SceneError> {
        self.find_joints()?;
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
            lighting: self.lighting,
            meshes: self.meshes,
        };
        SceneGraph::of_parts(self.nodes.into_iter().map(Arc::new).collect(), Arc::new(common))
    }
}
