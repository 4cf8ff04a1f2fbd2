//! The scene file: a [`SceneGraph`] to JSON text, which reads back to the same scene. The manual documents the format.

use glam::{Quat, Vec3, Vec4};

use super::channel::{Channel, Holder, scale_json};
use super::file::FORMAT;
use super::graph::{NodeId, NodeKind, SceneGraph};
use super::shape::{PlacedShape, Shape};
use super::tracks::Tracks;
use crate::colour::Colour;
use crate::json::{push_f32, push_f32s, push_f64};
use crate::timed::Track;

/// The text of a scene's file. The same scene gives the same bytes. Version 1 is written if it can express the scene.
#[must_use]
pub fn scene_to_json(scene: &SceneGraph) -> String {
    let version = if scene.nodes().iter().all(|node| node.is_in_paths) { 1 } else { 2 };
    let eyes: Vec<String> = scene.eyes().iter().map(|&eye| quoted(scene.rbt_path(eye))).collect();
    let mut text = format!(
        "{{\n  \"format\": \"{FORMAT}\",\n  \"version\": {version},\n  \"name\": {},\n  \"eyes\": [{}],\n",
        quoted(scene.name()),
        eyes.join(", "),
    );
    text.push_str("  \"vertical_fov_degrees\": ");
    push_f32(&mut text, scene.vertical_fov_degrees());
    text.push_str(",\n  \"nodes\": ");
    push_siblings(&mut text, scene, 0..scene.nodes().len(), 1);
    text.push_str("\n}\n");
    text
}

fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

fn push_line(text: &mut String, depth: usize) {
    text.push('\n');
    text.extend(std::iter::repeat_n("  ", depth));
}

/// Writes the siblings in a range of arena indices, with all nodes below them.
fn push_siblings(text: &mut String, scene: &SceneGraph, indices: std::ops::Range<usize>, depth: usize) {
    text.push('[');
    let mut next = indices.start;
    let ids: Vec<NodeId> = scene.nodes_with_ids().map(|(id, _)| id).skip(next).take(indices.len()).collect();
    while next < indices.end {
        let id = ids[next - indices.start];
        push_line(text, depth + 1);
        push_node(text, scene, id, depth + 1);
        next = scene.subtree(id).end;
        if next < indices.end {
            text.push(',');
        }
    }
    push_line(text, depth);
    text.push(']');
}

fn push_node(text: &mut String, scene: &SceneGraph, id: NodeId, depth: usize) {
    let node = scene.node(id);
    let below = id.get() + 1..scene.subtree(id).end;
    let mut fields = vec![format!("\"name\": {}", quoted(&node.name))];
    match &node.kind {
        NodeKind::Rbt(rbt) => {
            let rest = scene.rest_pose().get(*rbt);
            push_transform(&mut fields, rest.translation, rest.rotation);
        }
        NodeKind::Shape(placed) => push_shape(&mut fields, placed, depth + 1),
        NodeKind::Control(tracks) => {
            fields.push(format!("\"control\": {}", control(tracks, depth + 1)));
            if !node.is_in_paths {
                fields.push("\"in_paths\": false".to_owned());
            }
        }
    }
    let is_short = below.is_empty() && fields.iter().all(|field| !field.contains('\n'));
    if is_short {
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
    if !below.is_empty() {
        text.push(',');
        push_line(text, depth + 1);
        text.push_str("\"children\": ");
        push_siblings(text, scene, below, depth + 1);
    }
    push_line(text, depth);
    text.push('}');
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

fn push_shape(fields: &mut Vec<String>, placed: &PlacedShape, depth: usize) {
    fields.push(format!("\"shape\": {}", shape(&placed.shape)));
    let placement = placed.placement();
    push_transform(fields, placement.translation, placement.rotation);
    if placement.scale != Vec3::ONE {
        fields.push(format!("\"scale\": {}", scale_json(placement.scale)));
    }
    if placed.colour != Colour::DEFAULT {
        fields.push(format!("\"colour\": \"{}\"", placed.colour.to_hex()));
    }
    for &channel in Channel::of(Holder::Shape) {
        if let Some(track) = placed.tracks().get(channel) {
            fields.push(format!("\"{}\": {}", channel.field(), key_list(track, channel, depth)));
        }
    }
}

fn shape(shape: &Shape) -> String {
    let solid = shape.solid();
    let fields: Vec<String> = solid.fields().iter().map(|(name, value)| format!("\"{name}\": {value}")).collect();
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
