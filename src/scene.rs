//! The scene: a graph of RBT nodes, control nodes and shape nodes, its file, and the built-in scenes.
//!
//! A scene has topology, shapes, the rest pose and the timed keys. The current transforms of RBT nodes are in a [`crate::pose::Pose`].

mod builder;
mod built_in;
mod channel;
mod checks;
mod edit;
mod file;
mod graph;
mod joint;
mod keys;
mod lighting;
mod limbs;
mod meshes;
mod mirror;
mod pick;
mod shape;
pub mod shapes;
mod size;
mod tracks;
mod walk;
mod write;

pub use builder::{MOST_LEVELS, SceneBuilder};
pub use built_in::{BUILT_IN_ANIMATIONS, BuiltInAnimation, DEFAULT_SCENE, built_in_scene, built_in_scene_names};
pub use channel::{Channel, KeyValue};
pub use checks::LARGEST_SCALE;
pub use file::{SceneError, scene_from_bytes, scene_from_json, scene_with_meshes};
pub use graph::{Node, NodeId, NodeKind, SceneGraph};
pub use joint::{Hinge, Joint};
pub use keys::{LATEST_SECONDS, moved_seconds};
pub use lighting::SceneLighting;
pub use limbs::{LimbError, LimbNodes, PosedLimb};
pub use meshes::{LARGEST_MESHES_BYTES, MeshesError, MeshesFile, SceneFiles, with_meshes_within};
pub use pick::{Part, Pick, Picker, Ray};
pub use shape::{Finish, MeshKind, PlacedShape, Placement, Shape};
pub use size::LARGEST_SCENE_BYTES;
pub use tracks::Tracks;
pub use write::{lighting_to_json, node_properties_to_json, scene_to_json, scene_to_json_beside};
