//! Pictures of imported models.

use glam::Vec2;
use inbetween::camera::Camera;
use inbetween::interchange::gltf_in::Options;
use inbetween::render::{Gpu, Image, Offscreen, Renderer};
use inbetween::scene::SceneGraph;
use inbetween::view::frame_of_scene;
use serde_json::json;

use super::golden::check_golden;
use super::importing::{good, import, options};
use super::make::{Model, png, skinned};

fn draw(scene: &SceneGraph, seconds: f64) -> Image {
    let gpu = Gpu::headless().expect("a GPU adapter");
    let mut renderer = Renderer::new(&gpu, Offscreen::FORMAT, 4);
    let mut offscreen = Offscreen::new(&gpu, 320, 240).expect("a target");
    let pose = scene.rest_pose();
    let camera = Camera {
        world_from_eye: scene.world_from_rbt(pose, seconds, scene.eyes()[0]),
        vertical_fov: scene.vertical_fov(),
        size_px: Vec2::new(320.0, 240.0),
    };
    let frame = frame_of_scene(scene, pose, seconds, &camera, None);
    offscreen.render(&gpu, &mut renderer, &frame).expect("a picture")
}

/// A model of everything that is seen: a picture, colours of corners, a mirror, a scale below a turn, a skewed matrix, a bent skin.
fn all() -> Model {
    let mut model = skinned([1.0, 0.0, 0.0, 0.0]);
    model.json["nodes"][1]["translation"] = json!([-1.8, 0, 0]);
    model.json["nodes"][2]["rotation"] = json!([0, 0, -0.5, 0.866_025_4]);
    let materials = [[1.0, 0.5, 0.1], [0.2, 0.6, 0.3], [0.3, 0.4, 0.9], [1.0, 1.0, 1.0]];
    for colour in materials {
        let surface = json!({ "baseColorFactor": [colour[0], colour[1], colour[2], 1], "metallicFactor": 0, "roughnessFactor": 0.7 });
        model.push("materials", json!({ "pbrMetallicRoughness": surface }));
    }
    let blue = [[200, 40, 30, 255], [240, 240, 240, 255], [240, 240, 240, 255], [30, 60, 200, 255]];
    let view = model.view(&png(blue));
    model.push("images", json!({ "bufferView": view }));
    model.push("samplers", json!({ "magFilter": 9728 }));
    model.push("textures", json!({ "source": 0, "sampler": 0 }));
    model.json["materials"][3]["pbrMetallicRoughness"]["baseColorTexture"] = json!({ "index": 0 });
    model.json["meshes"][0]["primitives"][0]["material"] = json!(0);
    let block = model.block("block", [0.5, 0.9, 0.4]);
    model.json["meshes"][block]["primitives"][0]["material"] = json!(1);
    let wedge = {
        let positions = [0.0, 0.0, 0.0, 0.8, 0.0, 0.0, 0.0, 0.9, 0.0, 0.0, 0.0, 0.5];
        let positions = model.floats("VEC3", &positions);
        let colours = model.floats("VEC3", &[1.0, 1.0, 1.0, 1.0, 0.2, 0.2, 0.2, 1.0, 0.2, 0.2, 0.2, 1.0]);
        let indices = model.shorts("SCALAR", &[0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]);
        let attributes = json!({ "POSITION": positions, "COLOR_0": colours });
        model.push(
            "meshes",
            json!({ "name": "wedge", "primitives": [{ "attributes": attributes, "indices": indices }] }),
        )
    };
    let picture = {
        let positions = model.floats("VEC3", &[-0.4, 0.0, 0.0, 0.4, 0.0, 0.0, 0.4, 0.8, 0.0, -0.4, 0.8, 0.0]);
        let coordinates = model.floats("VEC2", &[0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
        let attributes = json!({ "POSITION": positions, "TEXCOORD_0": coordinates });
        let fan = json!({ "attributes": attributes, "mode": 6, "material": 3 });
        model.push("meshes", json!({ "name": "picture", "primitives": [fan] }))
    };
    model.root(json!({ "name": "right", "mesh": wedge, "translation": [-0.6, 0, 0.3] }));
    model.root(json!({ "name": "left", "mesh": wedge, "translation": [-0.7, 0, 0.3], "scale": [-1, 1, 1] }));
    let small =
        model.push("nodes", json!({ "name": "small", "mesh": block, "rotation": [0, 0, 0.382_683_4, 0.923_879_5] }));
    model.root(json!({ "name": "flat", "translation": [0.9, 0.5, 0], "scale": [1.6, 0.8, 1], "children": [small] }));
    let matrix = [1.0, 0.0, 0.0, 0.0, 0.5, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.8, 0.45, 0.0, 1.0];
    model.root(json!({ "name": "skewed", "mesh": block, "matrix": matrix }));
    model.root(json!({ "name": "picture", "mesh": picture, "translation": [0.3, 0.9, 0], "rotation": [0, 0.173_648_2, 0, 0.984_807_8] }));
    model
}

#[test]
fn a_model_looks_as_it_did() {
    check_golden("model", &draw(&good(&all()).scene, 0.0));
}

#[test]
fn a_model_of_timed_keys_looks_as_it_did() {
    let mut model = all();
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let turned = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, half, half];
    model.animation(
        "bend",
        &[
            (2, "rotation", &[0.0, 2.0], &turned, "LINEAR"),
            (3, "translation", &[0.0, 2.0], &[-0.6, 0.0, 0.3, -0.6, 1.0, 0.3], "LINEAR"),
        ],
    );
    let timed = Options { is_timed: true, ..options() };
    check_golden("model-timed", &draw(&import(&model, &timed).expect("it is good").scene, 1.0));
}
