//! A picture of each thing that a glTF file can hold, made by hand.

use std::f32::consts::FRAC_1_SQRT_2;

use glam::Vec2;
use inbetween::camera::Camera;
use inbetween::film::{Cell, Grid, contact_sheet};
use inbetween::flip::compare;
use inbetween::interchange::gltf_in::Options;
use inbetween::keyframe::PlayRange;
use inbetween::pose::Pose;
use inbetween::render::{Gpu, Image, Offscreen, Renderer};
use inbetween::scene::SceneGraph;
use inbetween::view::frame_of_scene;
use num_rational::BigRational;
use serde_json::json;

use super::golden::check_golden;
use super::importing::{Imported, good, import, options, refused};
use super::make::{Channel, Model, skinned};

/// Draws small pictures.
struct Studio {
    gpu: Gpu,
    renderer: Renderer,
    offscreen: Offscreen,
}

impl Studio {
    const SIZE: [u32; 2] = [128, 96];

    fn new() -> Self {
        let gpu = Gpu::headless().expect("a GPU adapter");
        let renderer = Renderer::new(&gpu, Offscreen::FORMAT, 4);
        let offscreen = Offscreen::new(&gpu, Self::SIZE[0], Self::SIZE[1]).expect("a target");
        Self { gpu, renderer, offscreen }
    }

    fn draw(&mut self, scene: &SceneGraph, pose: &Pose, seconds: f64) -> Image {
        let [width, height] = Self::SIZE;
        let camera = Camera {
            world_from_eye: scene.world_from_rbt(pose, seconds, scene.eyes()[0]),
            vertical_fov: scene.vertical_fov(),
            size_px: Vec2::new(width as f32, height as f32),
        };
        let frame = frame_of_scene(scene, pose, seconds, &camera, None);
        self.offscreen.render(&self.gpu, &mut self.renderer, &frame).expect("a picture")
    }
}

fn cell(number: f64, picture: Image) -> Cell {
    Cell { picture, caption: vec![number.to_string()] }
}

/// A corner of three arms, of which each axis and each mirror is told by its looks.
fn corner(model: &mut Model) -> usize {
    let positions = [0.0, 0.0, 0.0, 1.2, 0.0, 0.0, 0.0, 0.8, 0.0, 0.0, 0.0, 0.5];
    let positions = model.floats("VEC3", &positions);
    let indices = model.shorts("SCALAR", &[0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]);
    let primitive = json!({ "attributes": { "POSITION": positions }, "indices": indices });
    model.push("meshes", json!({ "name": "corner", "primitives": [primitive] }))
}

/// A tower of two blocks, of which a skin bends the upper by 60 degrees.
fn skin() -> Model {
    let mut model = skinned([1.0, 0.0, 0.0, 0.0]);
    model.json["nodes"][2]["rotation"] = json!([0, 0, -0.5, 0.866_025_4]);
    model
}

/// A block of which two corners are pulled up to a roof by sparse elements.
fn sparse() -> Model {
    let mut model = Model::new();
    let mesh = model.block("roof", [1.0, 1.0, 1.0]);
    let heights: Vec<u8> =
        [[0.5_f32, 1.3, 0.5], [-0.5, 1.3, 0.5]].as_flattened().iter().flat_map(|at| at.to_le_bytes()).collect();
    // Elements are replaced in rising order: corner 6 is at -x, corner 7 at +x.
    let values: Vec<u8> = [&heights[12..], &heights[..12]].concat();
    let (places, values) = (model.view(&[6, 7]), model.view(&values));
    let places = json!({ "bufferView": places, "componentType": 5121 });
    model.json["accessors"][0]["sparse"] = json!({ "count": 2, "indices": places, "values": { "bufferView": values } });
    model.root(json!({ "name": "roof", "mesh": mesh, "rotation": [0, 0.258_819, 0, 0.965_925_8] }));
    model
}

/// A block turned by 45 degrees below a node that is twice as wide as high, which makes it a rhombus.
fn scaled() -> Model {
    let mut model = Model::new();
    let mesh = model.block("block", [0.7, 0.7, 0.7]);
    let turned =
        model.push("nodes", json!({ "name": "turned", "mesh": mesh, "rotation": [0, 0, 0.382_683_4, 0.923_879_5] }));
    model.root(json!({ "name": "wide", "scale": [2, 1, 1], "children": [turned] }));
    model
}

/// A corner and its mirror.
fn mirrored() -> Model {
    let mut model = Model::new();
    let mesh = corner(&mut model);
    model.root(json!({ "name": "right", "mesh": mesh, "translation": [0.2, 0, 0] }));
    model.root(json!({ "name": "left", "mesh": mesh, "translation": [-0.2, 0, 0], "scale": [-1, 1, 1] }));
    model
}

/// A corner turned by 90 degrees about z and twice as large, by a matrix.
fn matrix() -> Model {
    let mut model = Model::new();
    let mesh = corner(&mut model);
    model.root(json!({ "name": "matrix", "mesh": mesh, "matrix": [0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1] }));
    model
}

/// A block of a matrix whose axes are not at right angles.
fn skewed() -> Model {
    let mut model = Model::new();
    let mesh = model.block("block", [1.0, 1.0, 1.0]);
    model.root(json!({ "name": "skewed", "mesh": mesh, "matrix": [1, 0, 0, 0, 0.7, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] }));
    model
}

/// Four blocks whose names are one, one again, one with a slash, and none.
fn names() -> Model {
    let mut model = Model::new();
    let mesh = model.block("block", [0.5, 0.5, 0.5]);
    for (place, name) in [Some("x"), Some("x"), Some("p/q"), None].into_iter().enumerate() {
        let at = [0.8 * place as f32, 0.3 * place as f32, 0.0];
        let mut node = json!({ "mesh": mesh, "translation": at });
        if let Some(name) = name {
            node["name"] = json!(name);
        }
        model.root(node);
    }
    model
}

/// A scene with a corner, and one with a block.
fn scenes() -> Model {
    let mut model = Model::new();
    let (corner, block) = (corner(&mut model), model.block("block", [1.0, 1.0, 1.0]));
    model.root(json!({ "name": "corner", "mesh": corner }));
    let block = model.push("nodes", json!({ "name": "block", "mesh": block }));
    model.push("scenes", json!({ "nodes": [block] }));
    model
}

#[test]
fn every_feature_of_a_model_looks_as_it_did() {
    let mut studio = Studio::new();
    let second = Options { gltf_scene: Some(1), ..options() };
    let features = [
        good(&skin()),
        good(&sparse()),
        good(&scaled()),
        good(&mirrored()),
        good(&matrix()),
        good(&skewed()),
        good(&names()),
        good(&scenes()),
        import(&scenes(), &second).expect("it is good"),
    ];
    let drawn = features.iter().map(|made| studio.draw(&made.scene, made.scene.rest_pose(), 0.0));
    let cells: Vec<Cell> = (0..).zip(drawn).map(|(number, picture)| cell(f64::from(number), picture)).collect();
    check_golden("model-features", &contact_sheet(Grid { columns: 3, rows: 3 }, &cells));
}

#[test]
fn a_cycle_has_no_picture() {
    let mut model = scaled();
    model.json["nodes"][0]["children"] = json!([1]);
    refused(&model, "/nodes/0: is below itself");
}

/// A post at which a bar hangs, moved by one channel.
fn moved(path: &str, times: &[f32], values: &[f32], interpolation: &str) -> Model {
    let mut model = Model::new();
    let (post, bar) = (model.block("post", [0.2, 2.0, 0.2]), model.block("bar", [1.0, 0.3, 0.3]));
    model.root(json!({ "name": "post", "mesh": post, "translation": [-0.8, 0, 0] }));
    let bar = model.root(json!({ "name": "bar", "mesh": bar }));
    let channel: Channel<'_> = (bar, path, times, values, interpolation);
    model.animation("all", &[channel]);
    model
}

/// The bar turned by a quarter, in integers of 16 bits.
fn integers() -> Model {
    let mut model = moved("rotation", &[0.0, 1.0], &[0.0; 8], "LINEAR");
    let part = |number: f32| (number * 32_767.0).round() as u16;
    let values = [0, 0, 0, part(1.0), 0, 0, part(FRAC_1_SQRT_2), part(FRAC_1_SQRT_2)];
    let values = model.shorts("VEC4", &values);
    model.json["accessors"][values]["componentType"] = json!(5122);
    model.json["accessors"][values]["normalized"] = json!(true);
    model.json["animations"][0]["samplers"][0]["output"] = json!(values);
    model
}

/// The tower, bent by an animation.
fn moving_skin() -> Model {
    let mut model = skinned([1.0, 0.0, 0.0, 0.0]);
    let turns = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -FRAC_1_SQRT_2, FRAC_1_SQRT_2];
    model.animation("bend", &[(2, "rotation", &[0.0, 1.0], &turns, "LINEAR")]);
    model
}

/// The pose of keyframes at a time in seconds.
fn played(made: &Imported, seconds: f64) -> Pose {
    let Some(animation) = &made.animation else { return made.scene.rest_pose().clone() };
    let timing = animation.keyframes.timing().expect("it plays");
    let units = BigRational::from_float(seconds * 1000.0 / f64::from(animation.ms_between_keyframes));
    let key_time = timing.key_time_at(&units.expect("it is finite"));
    PlayRange::new(&animation.keyframes)
        .expect("it plays")
        .pose_at(key_time, animation.interpolation)
        .expect("in range")
}

#[test]
fn every_kind_of_motion_looks_as_it_did() {
    let half = FRAC_1_SQRT_2;
    let up = [[0.0, -0.8, 0.0], [0.0, 0.8, 0.0]];
    // Leaves upwards, swings beyond the end and comes back.
    let spline = [[0.0; 3], up[0], [0.0, 2.0, 0.0], [0.0, -2.0, 0.0], up[1], [0.0; 3]];
    let features = [
        ("LINEAR", moved("translation", &[0.0, 1.0], up.as_flattened(), "LINEAR"), [0.1, 0.6]),
        ("TURN", moved("rotation", &[0.0, 1.0], &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, half, half], "LINEAR"), [0.0, 0.5]),
        ("INTEGERS", integers(), [0.0, 0.5]),
        ("STEP", moved("translation", &[0.0, 0.5], up.as_flattened(), "STEP"), [0.49, 0.5]),
        ("CUBICSPLINE", moved("translation", &[0.0, 1.0], spline.as_flattened(), "CUBICSPLINE"), [0.1, 0.75]),
        ("SCALE", moved("scale", &[0.0, 1.0], &[1.0, 1.0, 1.0, 0.2, 5.0, 1.0], "LINEAR"), [0.0, 1.0]),
        ("SKIN", moving_skin(), [0.25, 1.0]),
    ];
    let mut studio = Studio::new();
    let timed = Options { is_timed: true, ..options() };
    let mut cells = Vec::new();
    for (kind, model, moments) in &features {
        let ways = [good(model), import(model, &timed).expect("it is good")];
        let mut pictures = Vec::new();
        for made in &ways {
            for &seconds in moments {
                let picture = studio.draw(&made.scene, &played(made, seconds), seconds);
                pictures.push(picture.clone());
                cells.push(cell(seconds, picture));
            }
        }
        // Keyframes and timed keys show the same, up to what keyframes may be off, and the two moments differ.
        let apart = |a: usize, b: usize| compare(&pictures[a], &pictures[b]).expect("one size").scores().mean;
        assert!(apart(0, 2).max(apart(1, 3)) < 0.05 * apart(0, 1), "{kind}");
    }
    check_golden("model-motions", &contact_sheet(Grid { columns: 4, rows: features.len() as u32 }, &cells));
}
