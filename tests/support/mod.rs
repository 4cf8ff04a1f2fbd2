//! Frames made by hand for tests and benchmarks: the sky camera's view, and the sample scene's shapes at rest.
#![allow(dead_code, missing_docs, reason = "each test uses a part")]

use glam::camera::rh::proj::directx::perspective_infinite_reverse;
use glam::{Affine3A, Quat, Vec3};
use inbetween::colour::Colour;
use inbetween::frame::{DrawItem, Frame, View};
use inbetween::model::DEFAULT_ROUGHNESS;
use inbetween::scene::Shape;
use inbetween::scene::shapes::{Capsule, Cone, Cylinder, Plane, RoundedBox, Sphere};
use serde_json::Value;

/// A camera that looks along its own −Z, with a vertical field of view of 60 degrees.
pub fn view(world_from_eye: Affine3A, aspect: f32) -> View {
    let vertical_fov = 60.0_f32.to_radians();
    View {
        eye_from_world: world_from_eye.inverse(),
        world_from_eye,
        clip_from_eye: perspective_infinite_reverse(vertical_fov, aspect, 0.05),
        vertical_fov,
        aspect,
    }
}

/// The sky camera at rest, in a picture of 640x480.
pub fn sky_view() -> View {
    view(Affine3A::from_translation(Vec3::new(0.0, 0.25, 4.0)), 640.0 / 480.0)
}

/// A frame with nothing but these items.
pub fn frame(items: Vec<DrawItem>) -> Frame {
    Frame { items, ..Frame::empty(sky_view()) }
}

/// A shape as an item.
pub fn item(shape: Shape, colour: &str, world_from_shape: Affine3A) -> DrawItem {
    DrawItem {
        mesh: shape.mesh().expect("a unit mesh").into(),
        world_from_shape,
        half_extents: shape.half_extents(),
        rounding: shape.rounding(),
        colour: Colour::from_hex(colour).expect("a colour").to_linear(),
        roughness: DEFAULT_ROUGHNESS,
        metalness: 0.0,
        node: 0,
        outlined: false,
        is_hidden: false,
    }
}

/// The ground of the sample scene.
pub fn ground() -> DrawItem {
    item(Shape::Plane(Plane { size: [400.0, 400.0] }), "#7d8791", Affine3A::from_translation(Vec3::new(0.0, -2.0, 0.0)))
}

/// Every shape of the sample scene at rest, with the path of the node that carries it.
pub fn sample_items() -> Vec<(String, DrawItem)> {
    posed_items(&|_| Quat::IDENTITY)
}

/// Every shape of the sample scene, its nodes turned.
pub fn posed_items(turn: &dyn Fn(&str) -> Quat) -> Vec<(String, DrawItem)> {
    let scene: Value = serde_json::from_str(include_str!("../../assets/scenes/two-robots.json")).expect("JSON");
    let mut items = Vec::new();
    for node in scene["nodes"].as_array().expect("nodes") {
        walk(node, "", Affine3A::IDENTITY, turn, &mut items);
    }
    items
}

fn numbers<const N: usize>(value: &Value, otherwise: [f32; N]) -> [f32; N] {
    let mut numbers = otherwise;
    if let Some(array) = value.as_array() {
        for (number, value) in numbers.iter_mut().zip(array) {
            *number = value.as_f64().expect("a number") as f32;
        }
    }
    numbers
}

fn walk(
    node: &Value,
    above: &str,
    world_from_parent: Affine3A,
    turn: &dyn Fn(&str) -> Quat,
    items: &mut Vec<(String, DrawItem)>,
) {
    let name = node["name"].as_str().expect("a name");
    let path = if above.is_empty() { name.to_owned() } else { format!("{above}/{name}") };
    let translation = Vec3::from(numbers(&node["translation"], [0.0; 3]));
    let rotation = Quat::from_array(numbers(&node["rotation"], [0.0, 0.0, 0.0, 1.0])).normalize();
    let scale = Vec3::from(numbers(&node["scale"], [1.0; 3]));
    let placed = Affine3A::from_scale_rotation_translation(scale, rotation, translation);
    if let Some(object) = node.get("shape") {
        let number = |of: &Value, field: &str| of[field].as_f64().expect("a number") as f32;
        let (kind, of) = object.as_object().and_then(|object| object.iter().next()).expect("a shape");
        let shape = match kind.as_str() {
            "box" => Shape::Box(RoundedBox { size: numbers(&of["size"], [1.0; 3]).into(), bevel: number(of, "bevel") }),
            "sphere" => Shape::Sphere(Sphere { radius: number(of, "radius") }),
            "cylinder" => Shape::Cylinder(Cylinder { radius: number(of, "radius"), height: number(of, "height") }),
            "cone" => Shape::Cone(Cone { radius: number(of, "radius"), height: number(of, "height") }),
            "capsule" => Shape::Capsule(Capsule { radius: number(of, "radius"), height: number(of, "height") }),
            _ => Shape::Plane(Plane { size: numbers(&of["size"], [1.0; 2]) }),
        };
        items.push((
            above.to_owned(),
            item(shape, node["colour"].as_str().expect("a colour"), world_from_parent * placed),
        ));
    } else {
        let world_from_node = world_from_parent * placed * Affine3A::from_quat(turn(&path));
        for child in node["children"].as_array().into_iter().flatten() {
            walk(child, &path, world_from_node, turn, items);
        }
    }
}
