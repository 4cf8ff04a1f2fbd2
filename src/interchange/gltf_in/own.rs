//! What this program's own exports say in `extras.inbetween`: paths, kinds, dimensions of shapes, the pace. Never poses and keys.

use serde_json::{Map, Value};

use crate::gltf::json::{Extras, Index, Node, Root};

fn own(extras: &Extras) -> Option<&Map<String, Value>> {
    extras.as_ref()?.get("inbetween")?.as_object()
}

/// What a node was in the scene that was exported.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Kind {
    /// A node that poses record; what every node of another program's file becomes.
    #[default]
    Rbt,
    /// A node of timed keys.
    Control {
        /// Whether its name is part of the paths of the nodes below it.
        is_in_paths: bool,
    },
    /// A shape.
    Shape,
    /// None: it is above all others because joints of one skin need a node above them.
    Root,
}

/// What a file says of a node besides its transform.
#[derive(Clone, Debug, Default)]
pub(super) struct OwnNode {
    /// What it was.
    pub kind: Kind,
    /// The path that it had.
    pub path: Option<String>,
    /// Fields of a scene file: those of joints, or those of a shape.
    pub fields: Map<String, Value>,
}

impl OwnNode {
    /// What the file says of a node. `is_moved`: whether an animation or a skin needs it.
    pub fn of(node: &Node, is_moved: bool) -> Self {
        let Some(own) = own(&node.extras) else { return Self::default() };
        let kind = match own.get("kind").and_then(Value::as_str) {
            Some("control") => Kind::Control { is_in_paths: own.get("in_paths") != Some(&Value::Bool(false)) },
            Some("root") if is_identity(node) && !is_moved => Kind::Root,
            // What other programs have put below a shape would be lost, and so would a motion that they have given it.
            Some("shape") if own.contains_key("shape") && is_leaf(node) && !is_moved => Kind::Shape,
            _ => Kind::Rbt,
        };
        let names: &[&str] = match kind {
            Kind::Rbt => &["reach", "stands", "limits"],
            Kind::Control { .. } | Kind::Root => &[],
            Kind::Shape => &["shape", "colour", "roughness", "metalness"],
        };
        let fields = names.iter().filter_map(|name| Some(((*name).to_owned(), own.get(*name)?.clone()))).collect();
        let path = own.get("path").and_then(Value::as_str).map(str::to_owned);
        Self { kind, path, fields }
    }

    /// The name that it had.
    pub fn name(&self) -> Option<&str> {
        self.path.as_deref()?.rsplit('/').next().filter(|name| !name.is_empty())
    }

    /// The path of the node that it was below.
    pub fn path_above(&self) -> Option<&str> {
        Some(self.path.as_deref()?.rsplit_once('/')?.0)
    }

    /// Whether it is a shape that needs no mesh of the file: a box, a ball and the like.
    pub fn is_solid(&self) -> bool {
        self.kind == Kind::Shape && self.mesh_name().is_none()
    }

    /// The name of the mesh of a shape that has one.
    pub fn mesh_name(&self) -> Option<&str> {
        self.fields.get("shape")?.get("mesh")?.get("name")?.as_str()
    }
}

/// Whether a node can be a shape: nothing is below it, and it is no eye.
fn is_leaf(node: &Node) -> bool {
    node.children.is_empty() && node.camera.is_none()
}

/// Whether a node has no transform, and nothing but nodes below it.
fn is_identity(node: &Node) -> bool {
    let has_transform =
        node.matrix.is_some() || node.translation.is_some() || node.rotation.is_some() || node.scale.is_some();
    !has_transform && node.mesh.is_none() && node.camera.is_none()
}

/// What a file says of its scene.
#[derive(Clone, Debug)]
pub(super) struct OwnScene {
    pub name: Option<String>,
    pub eyes: Vec<String>,
    pub fov_degrees: Option<f32>,
    /// The field of a scene file.
    pub lighting: Option<Value>,
}

impl OwnScene {
    /// What the file says of a scene; `None` of a scene that this program did not write.
    pub fn of(root: &Root, scene: Option<Index>) -> Option<Self> {
        let own = own(&root.scenes.get(scene?)?.extras)?;
        let eyes = own.get("eyes").and_then(Value::as_array).map(Vec::as_slice).unwrap_or_default();
        Some(Self {
            lighting: own.get("lighting").cloned(),
            name: own.get("name").and_then(Value::as_str).map(str::to_owned),
            eyes: eyes.iter().filter_map(|eye| Some(eye.as_str()?.to_owned())).collect(),
            fov_degrees: own.get("vertical_fov_degrees").and_then(Value::as_f64).map(|degrees| degrees as f32),
        })
    }
}

/// The pace of an animation, as its file has it.
pub(super) fn pace(root: &Root, animation: Index) -> Option<&Map<String, Value>> {
    own(&root.animations.get(animation)?.extras)
}
