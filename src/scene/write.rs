//! The scene file: a [`SceneGraph`] to JSON text, which reads back to the same scene. The manual documents the format.

use glam::{Quat, Vec3, Vec4};

use super::channel::{Channel, Holder, scale_json};
use super::file::{FORMAT, VERSION_OF_FINISHES, VERSION_OF_MESHES};
use super::graph::{Node, NodeId, NodeKind, SceneGraph};
use super::joint::{Joint, VERSION_OF_JOINTS, push_joint};
use super::lighting::{SceneLighting, VERSION_OF_LIGHTING};
use super::meshes::MEDIA_TYPE;
use super::shape::{Finish, PlacedShape, Shape};
use super::tracks::Tracks;
use crate::colour::Colour;
use crate::gltf::data_uri;
use crate::json::{push_f32, push_f32s, push_f64, push_quoted, push_strings, quoted};
use crate::timed::Track;

/// The text of a scene's file, with all of the scene: meshes stand in it as a data URI. The same scene gives the same bytes. The version
/// is the least that can express the scene.
#[must_use]
pub fn scene_to_json(scene: &SceneGraph) -> String {
    written(scene, scene.meshes().map(|meshes| data_uri(MEDIA_TYPE, &meshes.glb)))
}

/// The text of a scene's file whose meshes, if it has any, are in the file `meshes` beside it.
#[must_use]
pub fn scene_to_json_beside(scene: &SceneGraph, meshes: &str) -> String {
    written(scene, scene.meshes().map(|_| meshes.to_owned()))
}

fn written(scene: &SceneGraph, meshes: Option<String>) -> String {
    let of_meshes = if meshes.is_some() { VERSION_OF_MESHES } else { 1 };
    let lighting = lighting_to_json(scene);
    let of_lighting = if lighting.is_some() { VERSION_OF_LIGHTING } else { 1 };
    let of_nodes = scene.nodes().iter().map(|node| version_of(node)).max().unwrap_or(1);
    let version = of_nodes.max(of_meshes).max(of_lighting);
    let eyes: Vec<String> = scene.eyes().iter().map(|&eye| quoted(scene.rbt_path(eye))).collect();
    let mut text = format!(
        "{{\n  \"format\": \"{FORMAT}\",\n  \"version\": {version},\n  \"name\": {},\n  \"eyes\": [{}],\n",
        quoted(scene.name()),
        eyes.join(", "),
    );
    text.push_str("  \"vertical_fov_degrees\": ");
    push_f32(&mut text, scene.vertical_fov_degrees());
    if let Some(lighting) = lighting {
        text.push_str(",\n  \"lighting\": ");
        text.push_str(&lighting);
    }
    if let Some(meshes) = meshes {
        text.push_str(",\n  \"meshes\": ");
        push_quoted(&mut text, &meshes);
    }
    text.push_str(",\n  \"nodes\": ");
    push_nodes(&mut text, scene);
    text.push_str("\n}\n");
    text
}

/// The least version that can express a node.
fn version_of(node: &Node) -> u32 {
    match &node.kind {
        _ if node.joint != Joint::default() => VERSION_OF_JOINTS,
        NodeKind::Shape(placed) if placed.finish != Finish::default() => VERSION_OF_FINISHES,
        _ if !node.is_in_paths => 2,
        _ => 1,
    }
}

fn push_line(text: &mut String, depth: usize) {
    text.push('\n');
    text.extend(std::iter::repeat_n("  ", depth));
}

/// Writes all nodes, each with a list of those below it.
fn push_nodes(text: &mut String, scene: &SceneGraph) {
    text.push('[');
    // The nodes whose lists are open.
    let mut open: Vec<NodeId> = Vec::new();
    let mut is_first = true;
    for (id, node) in scene.nodes_with_ids() {
        while open.last().is_some_and(|&above| scene.subtree(above).end <= id.get()) {
            open.pop();
            close(text, open.len());
            is_first = false;
        }
        if !is_first {
            text.push(',');
        }
        let (depth, has_children) = (depth_at(open.len()), scene.subtree(id).len() > 1);
        push_line(text, depth);
        push_fields(text, &fields(scene, node, depth), depth, has_children);
        if has_children {
            open.push(id);
        }
        is_first = has_children;
    }
    for level in (0..open.len()).rev() {
        close(text, level);
    }
    push_line(text, 1);
    text.push(']');
}

/// The indentation of nodes with so many nodes above them.
const fn depth_at(level: usize) -> usize {
    2 + 2 * level
}

/// Ends the list of what is below a node, and the node.
fn close(text: &mut String, level: usize) {
    let depth = depth_at(level);
    push_line(text, depth + 1);
    text.push(']');
    push_line(text, depth);
    text.push('}');
}

/// The fields of a node besides its children.
fn fields(scene: &SceneGraph, node: &Node, depth: usize) -> Vec<String> {
    let mut fields = vec![format!("\"name\": {}", quoted(&node.name))];
    match &node.kind {
        NodeKind::Rbt(rbt) => {
            let rest = scene.rest_pose().get(*rbt);
            push_transform(&mut fields, rest.translation, rest.rotation);
            push_joint(&mut fields, &node.joint);
        }
        NodeKind::Shape(placed) => push_shape(&mut fields, scene, placed, depth + 1),
        NodeKind::Control(tracks) => {
            fields.push(format!("\"control\": {}", control(tracks, depth + 1)));
            push_in_paths(&mut fields, node);
        }
    }
    fields
}

fn push_in_paths(fields: &mut Vec<String>, node: &Node) {
    if !node.is_in_paths {
        fields.push("\"in_paths\": false".to_owned());
    }
}

fn push_surface(fields: &mut Vec<String>, placed: &PlacedShape) {
    if placed.colour != Colour::DEFAULT {
        fields.push(format!("\"colour\": \"{}\"", placed.colour.to_hex()));
    }
    for (name, value) in [("roughness", placed.finish.roughness), ("metalness", placed.finish.metalness)] {
        fields.extend(value.map(|value| format!("\"{name}\": {}", number(value))));
    }
}

/// Writes a node, up to the beginning of the list of its children if it has any.
fn push_fields(text: &mut String, fields: &[String], depth: usize, has_children: bool) {
    if !has_children && fields.iter().all(|field| !field.contains('\n')) {
        text.push_str("{ ");
        text.push_str(&fields.join(", "));
        text.push_str(" }");
        return;
    }
    text.push('{');
    for (index, field) in fields.iter().enumerate() {
        if index > 0 {
            text.push(',');
        }
        push_line(text, depth + 1);
        text.push_str(field);
    }
    if has_children {
        text.push(',');
        push_line(text, depth + 1);
        text.push_str("\"children\": [");
    } else {
        push_line(text, depth);
        text.push('}');
    }
}

/// Numbers as a JSON array.
pub(super) fn numbers(numbers: &[f32]) -> String {
    let mut text = String::new();
    push_f32s(&mut text, numbers);
    text
}

/// Translation and rotation, unless they are the identity.
fn push_transform(fields: &mut Vec<String>, translation: Vec3, rotation: Quat) {
    if translation != Vec3::ZERO {
        fields.push(format!("\"translation\": {}", numbers(&translation.to_array())));
    }
    if rotation != Quat::IDENTITY {
        fields.push(format!("\"rotation\": {}", numbers(&rotation.to_array())));
    }
}

fn push_shape(fields: &mut Vec<String>, scene: &SceneGraph, placed: &PlacedShape, depth: usize) {
    fields.push(format!("\"shape\": {}", shape(scene, &placed.shape)));
    let placement = placed.placement();
    push_transform(fields, placement.translation, placement.rotation);
    if placement.scale != Vec3::ONE {
        fields.push(format!("\"scale\": {}", scale_json(placement.scale)));
    }
    push_surface(fields, placed);
    for &channel in Channel::of(Holder::Shape) {
        if let Some(track) = placed.tracks().get(channel) {
            fields.push(format!("\"{}\": {}", channel.field(), key_list(track, channel, depth)));
        }
    }
}

fn shape(scene: &SceneGraph, shape: &Shape) -> String {
    let solid = shape.solid();
    let mut fields: Vec<String> = solid.fields().iter().map(|(name, value)| format!("\"{name}\": {value}")).collect();
    if let Shape::Mesh(mesh) = shape
        && !mesh.joints().is_empty()
    {
        let mut joints = String::from("\"joints\": ");
        push_strings(&mut joints, mesh.joints().iter().map(|&joint| scene.node(joint).path.as_str()));
        fields.push(joints);
    }
    format!("{{ \"{}\": {{ {} }} }}", solid.name(), fields.join(", "))
}

/// A number as JSON.
pub(super) fn number(number: f32) -> String {
    let mut text = String::new();
    push_f32(&mut text, number);
    text
}

fn control(tracks: &Tracks, depth: usize) -> String {
    let lists = Channel::of(Holder::Control)
        .iter()
        .filter_map(|&channel| tracks.get(channel).map(|track| (channel.name(), key_list(track, channel, depth + 1))));
    let mut text = String::from("{");
    for (index, (name, list)) in lists.enumerate() {
        if index > 0 {
            text.push(',');
        }
        push_line(&mut text, depth + 1);
        text.push('"');
        text.push_str(name);
        text.push_str("\": ");
        text.push_str(&list);
    }
    if text.len() > 1 {
        push_line(&mut text, depth);
    }
    text.push('}');
    text
}

/// The keys of a channel, one per line: `[seconds, value]`.
fn key_list(track: &Track<Vec4>, channel: Channel, depth: usize) -> String {
    let mut text = String::from("[");
    for (index, (seconds, key)) in track.keys().enumerate() {
        if index > 0 {
            text.push(',');
        }
        push_line(&mut text, depth + 1);
        text.push('[');
        push_f64(&mut text, seconds);
        text.push_str(", ");
        text.push_str(&channel.json(key));
        text.push(']');
    }
    push_line(&mut text, depth);
    text.push(']');
    text
}

/// What a scene file says of its lighting, as JSON; `None` of the day, of which it says nothing.
#[must_use]
pub fn lighting_to_json(scene: &SceneGraph) -> Option<String> {
    (*scene.lighting() != SceneLighting::default()).then(|| scene.lighting().json())
}

/// What a scene file says of a node besides its name, its transform and its keys, as a JSON object: the end and the limits of a joint; the
/// kind, the dimensions and the surface of a shape; whether a control node is part of paths.
#[must_use]
pub fn node_properties_to_json(scene: &SceneGraph, node: &Node) -> String {
    let mut fields = Vec::new();
    push_joint(&mut fields, &node.joint);
    if let NodeKind::Shape(placed) = &node.kind {
        fields.push(format!("\"shape\": {}", shape(scene, &placed.shape)));
        push_surface(&mut fields, placed);
    }
    push_in_paths(&mut fields, node);
    format!("{{ {} }}", fields.join(", "))
}
