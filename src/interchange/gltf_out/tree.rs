//! The nodes of a scene, with meshes, skins, materials and the camera.

use std::collections::HashMap;

use glam::{Quat, Vec3};
use serde_json::{Map, Value, json};

use super::{Export, Report};
use crate::camera;
use crate::gltf::{Writer, json as gltf};
use crate::model::Material;
use crate::scene::{
    Channel, Node, NodeKind, PlacedShape, SceneGraph, Shape, lighting_to_json, node_properties_to_json,
};
use crate::unit_mesh::triangle_mesh;

/// The key of our own properties among those of other programs.
pub const OWN: &str = "inbetween";

/// Writes all nodes and the scene; returns the index in the file of each node of the scene, `None` of those that are left out.
pub fn write(writer: &mut Writer, export: Export<'_>, report: &mut Report) -> Vec<Option<gltf::Index>> {
    let scene = export.scene;
    let eyes: Vec<usize> = scene.eyes().iter().map(|&eye| scene.rbt_node(eye).get()).collect();
    writer.root.cameras.push(gltf::Camera {
        kind: "perspective".to_owned(),
        perspective: Some(gltf::Perspective {
            yfov: scene.vertical_fov(),
            znear: camera::NEAR,
            ..gltf::Perspective::default()
        }),
        ..gltf::Camera::default()
    });
    let mut meshes = Meshes::default();
    let mut indices: Vec<Option<gltf::Index>> = Vec::with_capacity(scene.nodes().len());
    let mut roots = Vec::new();
    for (id, node) in scene.nodes_with_ids() {
        let mut written = gltf::Node { name: Some(node.name.clone()), ..gltf::Node::default() };
        let kind = match &node.kind {
            NodeKind::Rbt(rbt) => {
                let rest = scene.rest_pose().get(*rbt);
                place(&mut written, rest.translation, rest.rotation, Vec3::ONE);
                written.camera = eyes.contains(&id.get()).then_some(0);
                "rbt"
            }
            NodeKind::Control(tracks) => {
                // Where it stands at 0 s.
                let numbers = |channel| tracks.get(channel).map(|track| track.value_at(0.0));
                let translation = numbers(Channel::Translation).map_or(Vec3::ZERO, glam::Vec4::truncate);
                let rotation = numbers(Channel::Rotation).map_or(Quat::IDENTITY, Quat::from_vec4);
                let scale = numbers(Channel::Scale).map_or(Vec3::ONE, glam::Vec4::truncate);
                place(&mut written, translation, rotation, scale);
                "control"
            }
            NodeKind::Shape(_) if !export.has_meshes => {
                report.shapes_left_out += 1;
                indices.push(None);
                continue;
            }
            NodeKind::Shape(placed) => {
                // The joints alone place a skin, so it has no place of its own.
                if scene.skin(id).is_none() {
                    let placement = placed.placement();
                    place(&mut written, placement.translation, placement.rotation, placement.scale);
                }
                written.mesh = Some(meshes.index(writer, placed));
                if placed.tracks().get(Channel::Colour).is_some() {
                    report.colours_left_out.push(node.path.clone());
                }
                "shape"
            }
        };
        written.extras = Some(extras(scene, node, kind));
        let index = writer.root.nodes.len();
        writer.root.nodes.push(written);
        indices.push(Some(index));
        match node.parent.filter(|_| scene.skin(id).is_none()).and_then(|parent| indices[parent.get()]) {
            Some(parent) => writer.root.nodes[parent].children.push(index),
            None => roots.push(index),
        }
    }
    skins(writer, scene, &indices, &mut roots);
    let paths: Vec<&str> = scene.eyes().iter().map(|&eye| scene.rbt_path(eye)).collect();
    let mut own = json!({ "name": scene.name(), "eyes": paths, "vertical_fov_degrees": scene.vertical_fov_degrees() });
    if let Some(lighting) = lighting_to_json(scene) {
        own["lighting"] = serde_json::from_str(&lighting).expect("scene files are JSON");
    }
    writer.root.scenes.push(gltf::Scene {
        name: Some(scene.name().to_owned()),
        nodes: roots,
        extras: Some(json!({ OWN: own })),
    });
    writer.root.scene = Some(0);
    report.nodes = writer.root.nodes.len();
    indices
}

/// Gives the nodes of skinned meshes their skins. The joints of a skin must have a node above them all that is in the file: where a scene
/// has several nodes at its root, one more goes above them.
fn skins(writer: &mut Writer, scene: &SceneGraph, indices: &[Option<gltf::Index>], roots: &mut Vec<gltf::Index>) {
    let mut is_apart = false;
    let mut skinned = Vec::new();
    for (id, node) in scene.nodes_with_ids() {
        let (Some(index), Some(mesh)) = (indices[id.get()], scene.skin(id)) else { continue };
        let Some(skin) = &mesh.mesh().skin else { continue };
        let joints: Vec<gltf::Index> = mesh.joints().iter().filter_map(|joint| indices[joint.get()]).collect();
        let root_of = |joint| {
            std::iter::successors(Some(joint), |&at| scene.node(at).parent).last().expect("the joint itself is one")
        };
        is_apart |= mesh.joints().iter().any(|&joint| root_of(joint) != root_of(mesh.joints()[0]));
        skinned.push(index);
        let skin = writer.skin(skin, joints);
        writer.root.skins[skin].name = Some(node.name.clone());
        writer.root.nodes[index].skin = Some(skin);
    }
    if is_apart {
        let (of_skins, others) = std::mem::take(roots).into_iter().partition(|root| skinned.contains(root));
        *roots = of_skins;
        roots.push(writer.root.nodes.len());
        let extras = Some(json!({ OWN: { "kind": "root" } }));
        writer.root.nodes.push(gltf::Node { children: others, extras, ..gltf::Node::default() });
    }
}

fn place(node: &mut gltf::Node, translation: Vec3, rotation: Quat, scale: Vec3) {
    node.translation = (translation != Vec3::ZERO).then_some(translation.to_array());
    node.rotation = (rotation != Quat::IDENTITY).then_some(rotation.to_array());
    node.scale = (scale != Vec3::ONE).then_some(scale.to_array());
}

fn extras(scene: &SceneGraph, node: &Node, kind: &str) -> Value {
    let properties: Map<String, Value> =
        serde_json::from_str(&node_properties_to_json(scene, node)).expect("scene files are JSON");
    let mut own = Map::from_iter([("path".to_owned(), json!(node.path)), ("kind".to_owned(), json!(kind))]);
    own.extend(properties);
    json!({ OWN: own })
}

/// The meshes so far.
#[derive(Default)]
struct Meshes {
    /// By the shape and its surface as text.
    by_shape: HashMap<String, gltf::Index>,
    /// How many there are of each kind.
    kinds: HashMap<&'static str, usize>,
}

impl Meshes {
    /// The mesh of a shape with its surface: a new one, or the one that an equal shape has.
    fn index(&mut self, writer: &mut Writer, placed: &PlacedShape) -> gltf::Index {
        let colour = placed.colour_at(0.0);
        let key = match &placed.shape {
            Shape::Mesh(mesh) => format!("mesh {:?} {colour:?} {:?}", mesh.mesh().name, placed.finish),
            shape => format!("{shape:?} {colour:?} {:?}", placed.finish),
        };
        if let Some(&mesh) = self.by_shape.get(&key) {
            return mesh;
        }
        let (roughness, metallic) = (placed.roughness(), placed.metalness());
        let mesh = if let Shape::Mesh(mesh) = &placed.shape {
            let material = writer.material(&Material { metallic, roughness, ..mesh.mesh().material.clone() }, colour);
            writer.mesh(mesh.mesh(), material)
        } else {
            let kind = placed.shape.kind_name();
            let number = self.kinds.entry(kind).or_default();
            *number += 1;
            let material = writer.material(&Material { metallic, roughness, ..Material::default() }, colour);
            writer.mesh(&triangle_mesh(&placed.shape, format!("{kind} {number}")), material)
        };
        self.by_shape.insert(key, mesh);
        mesh
    }
}
