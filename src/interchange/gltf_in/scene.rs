//! The scene of a node tree, as the JSON of a scene file, which the scene's own reader checks.

use std::collections::HashSet;
use std::fmt::Display;

use glam::{DAffine3, DQuat, DVec3};
use serde_json::{Map, Value, json};

use super::bones;
use super::motion::{Distance, Motion, timed_keys};
use super::own::Kind;
use super::shapes::MeshPart;
use super::sight::Sight;
use super::tree::{LEAST_SCALE, TreeNode, Trs};
use crate::colour::Colour;
use crate::gltf::{Curve, unique_name};
use crate::model::TriangleMesh;

/// How far timed keys may be from splines.
#[derive(Clone, Copy, Debug)]
pub(super) struct Allowed {
    pub radians: f64,
    pub units: f64,
}

/// All that a scene is made of.
pub(super) struct Parts<'a> {
    pub tree: &'a [TreeNode],
    pub motion: &'a Motion,
    /// By node of the tree.
    pub shapes: &'a [Vec<MeshPart>],
    pub meshes: &'a [TriangleMesh],
    /// By node of the tree: whether it is moved by timed keys instead of poses.
    pub is_timed: &'a [bool],
    /// By node of the tree: whether it is drawn as bones.
    pub is_bone: &'a [bool],
    /// By node of the tree: whether it moves vertices.
    pub is_joint: &'a [bool],
    /// By node of the tree: whether it has a camera.
    pub is_eye: &'a [bool],
    /// The time that becomes 0 s.
    pub start: f64,
    pub allowed: Allowed,
    pub sight: &'a Sight,
}

/// Names of nodes that the file does not have, by node of the tree.
pub(super) struct Names {
    /// Of shapes.
    shapes: Vec<Vec<String>>,
    /// Of the control node with the scale, where there is one.
    scale: Vec<Option<String>>,
    /// Of the eye below a node that timed keys move.
    eye: Vec<Option<String>>,
    bones: Vec<Vec<String>>,
}

impl Parts<'_> {
    /// Whether a node needs a control node for its scale.
    fn has_scale(&self, node: usize) -> bool {
        let is_scaled = self.motion.nodes[node].scale.is_some() || self.tree[node].rest.scale != DVec3::ONE;
        let has_something =
            !self.tree[node].children.is_empty() || !self.shapes[node].is_empty() || self.is_joint[node];
        is_scaled && has_something && !self.is_timed[node]
    }

    /// Names that no sibling has.
    pub fn names(&self) -> Names {
        let mut names = Names { shapes: Vec::new(), scale: Vec::new(), eye: Vec::new(), bones: Vec::new() };
        for (at, node) in self.tree.iter().enumerate() {
            let mut taken: HashSet<String> = node.children.iter().map(|&child| self.tree[child].name.clone()).collect();
            let mut free = |name: &str| unique_name(name, "mesh", &mut taken);
            names.shapes.push(self.shapes[at].iter().map(|part| free(&part.name)).collect());
            let bones = if self.is_bone[at] { node.children.len().max(1) } else { 0 };
            names.bones.push((0..bones).map(|_| free("bone")).collect());
            names.scale.push(self.has_scale(at).then(|| free("scale")));
            names.eye.push((self.is_eye[at] && self.is_timed[at]).then(|| free("eye")));
        }
        names
    }

    /// The path of the node whose world matrix is that of a node of the file, scale included.
    fn joint_path(&self, names: &Names, node: usize) -> String {
        let path = &self.tree[node].path;
        names.scale[node].as_ref().map_or_else(|| path.clone(), |scale| format!("{path}/{scale}"))
    }

    /// The paths of the eyes that the file has.
    pub fn eyes(&self, names: &Names) -> Vec<String> {
        let eyes = (0..self.tree.len()).filter(|&node| self.is_eye[node]);
        eyes.map(|node| {
            let path = &self.tree[node].path;
            names.eye[node].as_ref().map_or_else(|| path.clone(), |eye| format!("{path}/{eye}"))
        })
        .collect()
    }

    /// The nodes of the scene.
    pub fn nodes(&self, names: &Names) -> Vec<Value> {
        // From the last to the first, so that each finds those below it made.
        let mut made: Vec<Option<Value>> = vec![None; self.tree.len()];
        for node in (0..self.tree.len()).rev() {
            let below = self.tree[node].children.iter().filter_map(|&child| made[child].take()).collect();
            made[node] = Some(self.node(names, node, below));
        }
        let roots: Vec<Value> = made.into_iter().flatten().collect();
        self.sight.around(roots)
    }

    fn node(&self, names: &Names, at: usize, below: Vec<Value>) -> Value {
        let TreeNode { name, rest, own, .. } = &self.tree[at];
        if own.kind == Kind::Shape {
            return self.own_shape(names, at);
        }
        let mut children: Vec<Value> =
            self.shapes[at].iter().zip(&names.shapes[at]).map(|(part, name)| self.shape(names, part, name)).collect();
        if self.is_bone[at] {
            let ends = self.tree[at].children.iter().map(|&child| self.tree[child].rest.translation);
            children.extend(bones::of(ends, &names.bones[at], self.sight.size));
        }
        children.extend(below);
        if self.is_timed[at] {
            children.extend(names.eye[at].as_ref().map(|eye| json!({ "name": eye })));
            let mut node = json!({ "name": name, "control": self.control(at) });
            if !self.tree[at].is_in_paths() {
                node["in_paths"] = json!(false);
            }
            return with_children(node, children);
        }
        if let Some(scale) = &names.scale[at] {
            let keys = self.scale_keys(at);
            let control = json!({ "name": scale, "control": { "scale": keys }, "in_paths": false });
            children = vec![with_children(control, children)];
        }
        let mut node =
            json!({ "name": name, "translation": vector(rest.translation), "rotation": rotation(rest.rotation) });
        own.fields.iter().for_each(|(field, value)| node[field] = value.clone());
        with_children(node, children)
    }

    /// A node that was a shape before it was exported.
    fn own_shape(&self, names: &Names, at: usize) -> Value {
        let TreeNode { name, rest, own, .. } = &self.tree[at];
        let part = self.shapes[at].first();
        let mut node = match part {
            Some(part) => self.shape(names, part, name),
            None => json!({ "name": name, "shape": own.fields["shape"] }),
        };
        let middle = part.map_or(DVec3::ZERO, |part| part.centre.as_dvec3());
        node["translation"] = vector(rest.to_affine().transform_point3(middle));
        node["rotation"] = rotation(rest.rotation);
        if rest.scale != DVec3::ONE {
            node["scale"] = vector(rest.scale);
        }
        for field in ["colour", "roughness", "metalness"] {
            own.fields.get(field).into_iter().for_each(|value| node[field] = value.clone());
        }
        node
    }

    fn shape(&self, names: &Names, part: &MeshPart, name: &str) -> Value {
        let mut mesh = json!({ "name": self.meshes[part.mesh].name });
        if !part.joints.is_empty() {
            let joints: Vec<String> = part.joints.iter().map(|&joint| self.joint_path(names, joint)).collect();
            mesh["joints"] = json!(joints);
        }
        let colour = Colour::nearest_to_linear(part.colour).to_hex();
        json!({ "name": name, "shape": { "mesh": mesh }, "colour": colour, "translation": part.centre.to_array() })
    }

    /// The timed keys of a node that has no pose.
    fn control(&self, at: usize) -> Value {
        let Trs { translation, rotation: turned, scale } = self.tree[at].rest;
        let moved = &self.motion.nodes[at];
        let mut keys = Map::new();
        let translations = self.keys(moved.translation.as_ref(), translation, self.allowed.units, vector);
        keys.insert("translation".to_owned(), translations);
        if moved.rotation.is_some() || turned != DQuat::IDENTITY {
            let rotations = self.keys(moved.rotation.as_ref(), turned, self.allowed.radians, rotation);
            keys.insert("rotation".to_owned(), rotations);
        }
        if moved.scale.is_some() || scale != DVec3::ONE {
            keys.insert("scale".to_owned(), self.scale_keys(at));
        }
        Value::Object(keys)
    }

    fn scale_keys(&self, at: usize) -> Value {
        let scale = |scale: DVec3| vector(scale.max(DVec3::splat(LEAST_SCALE)));
        self.keys(self.motion.nodes[at].scale.as_ref(), self.tree[at].rest.scale, 1e-3, scale)
    }

    fn keys<V: Distance>(&self, curve: Option<&Curve<V>>, rest: V, allowed: f64, write: impl Fn(V) -> Value) -> Value {
        let keys = curve.map_or_else(|| vec![(self.start, rest)], |curve| timed_keys(curve, allowed));
        keys.into_iter().map(|(seconds, value)| json!([seconds - self.start, write(value)])).collect()
    }
}

/// The text of a scene file.
pub(super) fn scene_text(
    name: &str,
    eyes: &[String],
    fov_degrees: f32,
    lighting: Option<Value>,
    meshes: &str,
    nodes: Vec<Value>,
) -> impl Display {
    let mut scene = json!({
        "format": "inbetween.scene",
        "version": 3,
        "name": name,
        "eyes": eyes,
        "vertical_fov_degrees": fov_degrees,
        "nodes": nodes,
    });
    if let Some(lighting) = lighting {
        scene["lighting"] = lighting;
    }
    if !meshes.is_empty() {
        scene["meshes"] = json!(meshes);
    }
    scene
}

pub(super) fn with_children(mut node: Value, children: Vec<Value>) -> Value {
    if !children.is_empty() {
        node["children"] = Value::Array(children);
    }
    node
}

pub(super) fn vector(vector: DVec3) -> Value {
    json!(vector.as_vec3().to_array())
}

pub(super) fn rotation(rotation: DQuat) -> Value {
    json!(rotation.as_quat().to_array())
}

/// `world_from_node` of each node of a tree at rest.
pub(super) fn world_from_nodes(tree: &[TreeNode]) -> Vec<DAffine3> {
    let mut world: Vec<DAffine3> = Vec::with_capacity(tree.len());
    for node in tree {
        let above = node.parent.map_or(DAffine3::IDENTITY, |parent| world[parent]);
        world.push(above * node.rest.to_affine());
    }
    world
}
