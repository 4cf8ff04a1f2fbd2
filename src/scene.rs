//! The scene: a graph of RBT nodes and shape nodes, its file, and the scenes that are built in.
//!
//! Topology, shapes and the rest pose live here and do not change while animating; where things are is a [`crate::pose::Pose`].

mod built_in;
mod file;
mod graph;
mod pick;
mod shape;
mod walk;

pub use built_in::{DEFAULT_SCENE, built_in_scene, built_in_scene_names};
pub use file::{SceneError, scene_from_json};
pub use graph::{Node, NodeId, NodeKind, SceneBuilder, SceneGraph};
pub use pick::{Pick, Ray};
pub use shape::{Colour, MeshKind, PlacedShape, Shape};
