//! The scene graph: an arena of nodes in pre-order, so that parents come before their children and a subtree is a range.

use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

use glam::{Affine3A, Vec3};

use super::joint::Joint;
use super::lighting::SceneLighting;
use super::shape::{PlacedShape, Shape};
use super::shapes::MeshShape;
use super::tracks::Tracks;
use super::walk::Walk;
use crate::blend::AlignedAffine;
use crate::model::MeshLibrary;
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;

/// The index of a node in the pre-order walk of a scene; issued by the [`SceneGraph`] it belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct NodeId(u32);

impl NodeId {
    /// The index in the arena, from 0.
    #[must_use]
    pub const fn get(self) -> usize {
        self.0 as usize
    }

    pub(super) fn from_index(index: usize) -> Self {
        Self(u32::try_from(index).expect("a scene has fewer than 2^32 nodes"))
    }
}

/// The kind of a node, with its data.
#[derive(Clone, Debug, PartialEq)]
pub enum NodeKind {
    /// A rigid body transform that poses record.
    Rbt(RbtIndex),
    /// Geometry; it has no children.
    Shape(PlacedShape),
    /// An affine that is animated by its timed keys in elapsed seconds. Poses do not record it.
    Control(Tracks),
}

/// A node with its data.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// Its own name.
    pub name: String,
    /// The names from the root down to it, joined by `/`, without those of control nodes that are not part of paths; unique in the scene.
    pub path: String,
    /// Whether the paths of the nodes below contain its name. False only for control nodes.
    pub is_in_paths: bool,
    /// The node above it; `None` right under the root.
    pub parent: Option<NodeId>,
    /// Its kind, with its data.
    pub kind: NodeKind,
    /// What reaching knows of it; nothing but for RBT nodes.
    pub joint: Joint,
    /// The number of ancestors: 0 for a node right under the root.
    pub depth: usize,
    pub(super) subtree_end: NodeId,
}

impl Node {
    /// `parent_from_node`: from a shape's placement, a control node's keys, or, for an RBT node, from `parent_from_rbt`.
    pub(super) fn parent_from_node(&self, seconds: f64, parent_from_rbt: impl Fn(RbtIndex) -> Affine3A) -> Affine3A {
        match &self.kind {
            NodeKind::Rbt(rbt) => parent_from_rbt(*rbt),
            NodeKind::Shape(placed) => placed.parent_from_shape(),
            NodeKind::Control(tracks) => tracks.parent_from_node(seconds),
        }
    }

    /// The time of its last timed key in seconds; `None` without keys.
    fn last_second(&self) -> Option<f64> {
        match &self.kind {
            NodeKind::Rbt(_) => None,
            NodeKind::Shape(placed) => placed.tracks().last_second(),
            NodeKind::Control(tracks) => tracks.last_second(),
        }
    }
}

/// Nodes, shapes and the rest pose. Immutable: a change makes a new scene that shares all unchanged parts.
///
/// ```
/// use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
///
/// let scene = built_in_scene(DEFAULT_SCENE).expect("it is built in");
/// let head = scene.find_rbt("robot1/head").expect("the scene has it");
/// let world_from_head = scene.world_from_rbt(scene.rest_pose(), 0.0, head);
/// assert_eq!(world_from_head.translation.to_array(), [-2.0, 1.75, 0.0]);
/// ```
#[derive(Clone, Debug)]
pub struct SceneGraph {
    nodes: Vec<Arc<Node>>,
    common: Arc<Common>,
    last_second: Option<f64>,
}

/// The data of a scene besides its nodes. It is shared by scenes that differ only in timed keys.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Common {
    pub(super) name: String,
    pub(super) rbt_nodes: Vec<NodeId>,
    pub(super) by_path: HashMap<String, NodeId>,
    pub(super) rest: Pose,
    pub(super) walk: Walk,
    pub(super) eyes: Vec<RbtIndex>,
    pub(super) vertical_fov_degrees: f32,
    pub(super) lighting: SceneLighting,
    pub(super) meshes: Option<Arc<MeshLibrary>>,
}

impl PartialEq for SceneGraph {
    /// Fast if the two share storage.
    fn eq(&self, other: &Self) -> bool {
        let same = |(a, b): (&Arc<Node>, &Arc<Node>)| Arc::ptr_eq(a, b) || a == b;
        (Arc::ptr_eq(&self.common, &other.common) || self.common == other.common)
            && self.nodes.len() == other.nodes.len()
            && self.nodes.iter().zip(&other.nodes).all(same)
    }
}

impl SceneGraph {
    /// The scene's name, as keyframe files carry it.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.common.name
    }

    /// The meshes that its shapes are of; `None` for a scene without any.
    #[must_use]
    pub fn meshes(&self) -> Option<&Arc<MeshLibrary>> {
        self.common.meshes.as_ref()
    }

    /// Its lighting.
    #[must_use]
    pub fn lighting(&self) -> &SceneLighting {
        &self.common.lighting
    }

    /// The same scene in another light.
    #[must_use]
    pub fn with_lighting(&self, lighting: SceneLighting) -> Self {
        let common = Common { lighting, ..(*self.common).clone() };
        Self { common: Arc::new(common), ..self.clone() }
    }

    /// The same scene with another name.
    #[must_use]
    pub fn renamed(&self, name: &str) -> Self {
        let common = Common { name: name.to_owned(), ..(*self.common).clone() };
        Self { common: Arc::new(common), ..self.clone() }
    }

    /// Every node, parents before children.
    #[must_use]
    pub fn nodes(&self) -> &[Arc<Node>] {
        &self.nodes
    }

    /// Every node with its id, parents before children.
    pub fn nodes_with_ids(&self) -> impl Iterator<Item = (NodeId, &Node)> {
        self.nodes.iter().enumerate().map(|(index, node)| (NodeId::from_index(index), &**node))
    }

    /// Whether poses and keyframe files are interchangeable between the two scenes: the same RBT nodes with the same paths.
    #[must_use]
    pub fn has_rbts_of(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.common, &other.common) || self.rbt_paths().eq(other.rbt_paths())
    }

    /// This scene with one node replaced. The new node has the same name, kind and parent; only its keys differ.
    pub(super) fn with_kind(&self, id: NodeId, kind: NodeKind) -> Self {
        let mut nodes = self.nodes.clone();
        nodes[id.get()] = Arc::new(Node { kind, ..(*self.nodes[id.get()]).clone() });
        Self::of_parts(nodes, Arc::clone(&self.common))
    }

    pub(super) fn of_parts(nodes: Vec<Arc<Node>>, common: Arc<Common>) -> Self {
        let last_second = nodes.iter().filter_map(|node| node.last_second()).reduce(f64::max);
        Self { nodes, common, last_second }
    }

    /// A node with its data.
    #[must_use]
    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.get()]
    }

    /// The node and all below it, as a range of arena indices.
    #[must_use]
    pub fn subtree(&self, id: NodeId) -> Range<usize> {
        id.get()..self.nodes[id.get()].subtree_end.get()
    }

    /// How many RBT nodes there are: the length of every pose.
    #[must_use]
    pub fn rbt_count(&self) -> usize {
        self.common.rbt_nodes.len()
    }

    /// The RBT nodes, in the order of poses and files.
    pub fn rbt_indices(&self) -> impl Iterator<Item = RbtIndex> + use<> {
        (0..self.common.rbt_nodes.len()).map(RbtIndex::new)
    }

    /// The id of an RBT node.
    #[must_use]
    pub fn rbt_node(&self, rbt: RbtIndex) -> NodeId {
        self.common.rbt_nodes[rbt.get()]
    }

    /// The path of an RBT node.
    #[must_use]
    pub fn rbt_path(&self, rbt: RbtIndex) -> &str {
        &self.node(self.rbt_node(rbt)).path
    }

    /// The paths of all RBT nodes, in the order of poses and files.
    pub fn rbt_paths(&self) -> impl Iterator<Item = &str> {
        self.common.rbt_nodes.iter().map(|&id| self.node(id).path.as_str())
    }

    /// The node with this path.
    #[must_use]
    pub fn find(&self, path: &str) -> Option<NodeId> {
        self.common.by_path.get(path).copied()
    }

    /// The RBT node with this path; `None` if there is none or it is of another kind.
    #[must_use]
    pub fn find_rbt(&self, path: &str) -> Option<RbtIndex> {
        match self.node(self.find(path)?).kind {
            NodeKind::Rbt(rbt) => Some(rbt),
            NodeKind::Shape(_) | NodeKind::Control(_) => None,
        }
    }

    /// The pose that the scene was built with.
    #[must_use]
    pub fn rest_pose(&self) -> &Pose {
        &self.common.rest
    }

    /// The RBT nodes that the camera can be attached to, in the order in which the hotkey goes through them; never empty. The first is the
    /// sky camera.
    #[must_use]
    pub fn eyes(&self) -> &[RbtIndex] {
        &self.common.eyes
    }

    /// Vertical field of view of every eye, in radians.
    #[must_use]
    pub fn vertical_fov(&self) -> f32 {
        self.common.vertical_fov_degrees.to_radians()
    }

    /// The same in degrees, as scene files have it.
    #[must_use]
    pub fn vertical_fov_degrees(&self) -> f32 {
        self.common.vertical_fov_degrees
    }

    /// Whether any node has timed keys.
    #[must_use]
    pub fn is_timed(&self) -> bool {
        self.last_second.is_some()
    }

    /// The time of the last timed key of all nodes, in seconds; nothing moves after it. `None` without timed keys.
    #[must_use]
    pub fn last_second(&self) -> Option<f64> {
        self.last_second
    }

    /// `world_from_node` of every node under `pose`, `seconds` into the timed keys, in arena order.
    #[must_use]
    pub fn world_from_nodes(&self, pose: &Pose, seconds: f64) -> Vec<AlignedAffine> {
        let mut world_from_node = Vec::new();
        self.world_from_nodes_into(pose, seconds, &mut world_from_node);
        world_from_node
    }

    /// Like [`SceneGraph::world_from_nodes`], but reuses the storage of `into`.
    pub fn world_from_nodes_into(&self, pose: &Pose, seconds: f64, into: &mut Vec<AlignedAffine>) {
        debug_assert_eq!(pose.len(), self.rbt_count(), "a pose of another scene");
        let keys_of = |index: usize| match &self.nodes[index].kind {
            NodeKind::Control(tracks) => tracks.parent_from_node(seconds),
            NodeKind::Rbt(_) | NodeKind::Shape(_) => Affine3A::IDENTITY,
        };
        self.common.walk.world_from_nodes(pose, keys_of, into);
    }

    /// The id of a node by its index in the pre-order walk; `None` past the last.
    #[must_use]
    pub fn id_at(&self, index: usize) -> Option<NodeId> {
        (index < self.nodes.len()).then(|| NodeId::from_index(index))
    }

    /// `world_from_node` of every node, with `parent_from_rbt` for the RBT nodes: one forward loop, because parents come first.
    #[must_use]
    pub fn world_from_nodes_with(&self, seconds: f64, parent_from_rbt: impl Fn(RbtIndex) -> Affine3A) -> Vec<Affine3A> {
        let mut world_from_node: Vec<Affine3A> = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            let parent_from_node = node.parent_from_node(seconds, &parent_from_rbt);
            world_from_node.push(match node.parent {
                Some(parent) => world_from_node[parent.get()] * parent_from_node,
                None => parent_from_node,
            });
        }
        world_from_node
    }

    /// `world_from_node` of one node under `pose`, `seconds` into the timed keys.
    #[must_use]
    pub fn world_from_node(&self, pose: &Pose, seconds: f64, id: NodeId) -> Affine3A {
        self.world_from_node_with(seconds, id, |rbt| pose.get(rbt).to_affine())
    }

    /// `world_from_node` of one node, with `parent_from_rbt` for the RBT nodes. It is called only for the node and those above it.
    #[must_use]
    pub fn world_from_node_with(
        &self,
        seconds: f64,
        id: NodeId,
        parent_from_rbt: impl Fn(RbtIndex) -> Affine3A,
    ) -> Affine3A {
        let mut world_from_node = Affine3A::IDENTITY;
        let mut next = Some(id);
        while let Some(id) = next {
            let node = self.node(id);
            world_from_node = node.parent_from_node(seconds, &parent_from_rbt) * world_from_node;
            next = node.parent;
        }
        world_from_node
    }

    /// The rigid part of `world_from_node` of an RBT node.
    #[must_use]
    pub fn world_from_rbt(&self, pose: &Pose, seconds: f64, rbt: RbtIndex) -> Rbt {
        Rbt::from_affine(&self.world_from_node(pose, seconds, self.rbt_node(rbt)))
    }

    /// `world_from_parent` of an RBT node: the identity right under the root.
    #[must_use]
    pub fn world_from_parent(&self, pose: &Pose, seconds: f64, rbt: RbtIndex) -> Affine3A {
        match self.node(self.rbt_node(rbt)).parent {
            Some(parent) => self.world_from_node(pose, seconds, parent),
            None => Affine3A::IDENTITY,
        }
    }

    /// The mesh of a shape node that joints move; `None` for any other node.
    #[must_use]
    pub fn skin(&self, id: NodeId) -> Option<&MeshShape> {
        match &self.node(id).kind {
            NodeKind::Shape(PlacedShape { shape: Shape::Mesh(mesh), .. }) if !mesh.joints().is_empty() => Some(mesh),
            _ => None,
        }
    }

    /// The box around a shape in world space where nodes stand as `world_from_node` says: its placement, and half its extents.
    #[must_use]
    pub fn box_of(
        &self,
        id: NodeId,
        placed: &PlacedShape,
        world_from_node: impl Fn(NodeId) -> Affine3A,
    ) -> (Affine3A, Vec3) {
        let Some(skin) = self.skin(id) else { return (world_from_node(id), placed.shape.half_extents()) };
        let [least, most] = skin.reach_of_skin(&skin.world_from_bind(world_from_node).collect::<Vec<_>>());
        (Affine3A::from_translation((least + most) * 0.5), (most - least) * 0.5)
    }

    /// The RBT node that carries a node: itself, or the nearest one above it.
    #[must_use]
    pub fn carrying_rbt(&self, id: NodeId) -> Option<RbtIndex> {
        let mut next = Some(id);
        while let Some(id) = next {
            let node = self.node(id);
            if let NodeKind::Rbt(rbt) = node.kind {
                return Some(rbt);
            }
            next = node.parent;
        }
        None
    }
}
