//! The scene file: a [`SceneGraph`] to JSON text, which reads back to the same scene. The manual documents the format.

use glam::{Quat, Vec3};

use super::file::FORMAT;
use super::graph::{NodeId, NodeKind, SceneGraph};
use super::shape::{Colour, PlacedShape, Shape};
use crate::json::{push_f32, push_f32s, push_f64};
use crate::timed::{Keyframes, TransformKeyframes};

/// The text of a scene's file. The same scene gives the same bytes; version 1 where that can say it all.
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

/// The nodes of a range of the arena that stand side by side, with all below them.
fn push_siblings(text: &mut String, scene: &SceneGraph, places: std::ops::Range<usize>, depth: usize) {
    text.push('[');
    let mut next = places.start;
    let ids: Vec<NodeId> = scene.nodes_with_ids().map(|(id, _)| id).skip(next).take(places.len()).collect();
    while next < places.end {
        let id = ids[next - places.start];
        push_line(text, depth + 1);
        push_node(text, scene, id, depth + 1);
        next = scene.subtree(id).end;
        if next < places.end {
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
            push_place(&mut fields, rest.translation, rest.rotation);
        }
        NodeKind::Shape(placed) => push_shape(&mut fields, placed, depth + 1),
        NodeKind::Control(keys) => {
            fields.push(format!("\"control\": {}", control(keys, depth + 1)));
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
    for (place, field) in fields.iter().enumerate() {
        if place > 0 {
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

fn numbers(numbers: &[f32]) -> String {
    let mut text = String::new();
    push_f32s(&mut text, numbers);
    text
}

/// Translation and rotation, where they say anything.
fn push_place(fields: &mut Vec<String>, translation: Vec3, rotation: Quat) {
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
    push_place(fields, placement.translation, placement.rotation);
    if placement.scale != Vec3::ONE {
        fields.push(format!("\"scale\": {}", scale(placement.scale)));
    }
    if placed.colour != Colour::DEFAULT {
        fields.push(format!("\"colour\": \"{}\"", placed.colour.to_hex()));
    }
    if let Some(keys) = &placed.colour_keys {
        let hex = |linear| format!("\"{}\"", Colour::nearest_to_linear(linear).to_hex());
        fields.push(format!("\"colour_keys\": {}", key_list(keys, hex, depth)));
    }
}

fn shape(shape: &Shape) -> String {
    let fields: Vec<(&str, String)> = match *shape {
        Shape::Box { size, bevel } => {
            vec![("size", numbers(&size.to_array())), ("bevel", number(bevel))]
        }
        Shape::Sphere { radius } => vec![("radius", number(radius))],
        Shape::Cylinder { radius, height } | Shape::Cone { radius, height } | Shape::Capsule { radius, height } => {
            vec![("radius", number(radius)), ("height", number(height))]
        }
        Shape::Plane { size } => vec![("size", numbers(&size))],
    };
    let kind = match shape {
        Shape::Box { .. } => "box",
        Shape::Sphere { .. } => "sphere",
        Shape::Cylinder { .. } => "cylinder",
        Shape::Cone { .. } => "cone",
        Shape::Capsule { .. } => "capsule",
        Shape::Plane { .. } => "plane",
    };
    let fields: Vec<String> = fields.iter().map(|(name, value)| format!("\"{name}\": {value}")).collect();
    format!("{{ \"{kind}\": {{ {} }} }}", fields.join(", "))
}

fn number(number: f32) -> String {
    let mut text = String::new();
    push_f32(&mut text, number);
    text
}

/// One number where all axes are alike.
fn scale(scale: Vec3) -> String {
    if scale == Vec3::splat(scale.x) { number(scale.x) } else { numbers(&scale.to_array()) }
}

fn control(keys: &TransformKeyframes, depth: usize) -> String {
    let vector = |value: Vec3| numbers(&value.to_array());
    let channels = [
        keys.translation.as_ref().map(|keys| ("translation", key_list(keys, vector, depth + 1))),
        keys.rotation
            .as_ref()
            .map(|keys| ("rotation", key_list(keys, |value: Quat| numbers(&value.to_array()), depth + 1))),
        keys.scale.as_ref().map(|keys| ("scale", key_list(keys, scale, depth + 1))),
    ];
    let mut text = String::from("{");
    for (place, (name, list)) in channels.into_iter().flatten().enumerate() {
        if place > 0 {
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

/// Keys, one a line: `[seconds, value]`.
fn key_list<V: Copy + crate::timed::Interpolate>(
    keys: &Keyframes<V>,
    value: impl Fn(V) -> String,
    depth: usize,
) -> String {
    let mut text = String::from("[");
    for (place, (seconds, key)) in keys.keys().enumerate() {
        if place > 0 {
            text.push(',');
        }
        push_line(&mut text, depth + 1);
        text.push('[');
        push_f64(&mut text, seconds);
        text.push_str(", ");
        text.push_str(&value(key));
        text.push(']');
    }
    push_line(&mut text, depth);
    text.push(']');
    text
}
