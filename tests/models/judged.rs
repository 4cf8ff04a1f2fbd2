//! The models that `.ci/judges` imports and exports again.

use std::path::Path;

use serde_json::json;

use super::importing::{import_file, options};
use super::make::Model;

/// Times of keys, unevenly apart.
const TIMES: [f32; 5] = [0.0, 0.7, 1.5, 3.0, 4.5];

/// Rotations about an axis at [`TIMES`], by angles whose sines and cosines are the same on every machine.
fn turns(axis: [f32; 3]) -> Vec<f32> {
    let halves = [(0.0, 1.0), (0.28, 0.96), (-0.28, 0.96), (0.6, 0.8), (0.0, 1.0)];
    halves.iter().flat_map(|(sine, cosine)| [axis[0] * sine, axis[1] * sine, axis[2] * sine, *cosine]).collect()
}

/// Says the bounds of the positions of all meshes, without which readers warn.
fn with_bounds(mut model: Model) -> Model {
    let meshes = model.json["meshes"].as_array().expect("there are some").clone();
    for primitive in meshes.iter().filter_map(|mesh| mesh["primitives"].as_array()).flatten() {
        let positions = primitive["attributes"]["POSITION"].as_u64().expect("it has some") as usize;
        let accessor = &model.json["accessors"][positions];
        let view = accessor["bufferView"].as_u64().expect("it is in one") as usize;
        let offset = model.json["bufferViews"][view]["byteOffset"].as_u64().expect("it says so") as usize;
        let accessor = &mut model.json["accessors"][positions];
        let count = accessor["count"].as_u64().expect("it says so") as usize;
        let numbers: Vec<f32> = model.bytes[offset..offset + 12 * count]
            .as_chunks::<4>()
            .0
            .iter()
            .map(|bytes| f32::from_le_bytes(*bytes))
            .collect();
        let bound = |most: fn(f32, f32) -> f32| {
            [0, 1, 2].map(|axis| numbers.iter().copied().skip(axis).step_by(3).reduce(most).expect("there are some"))
        };
        accessor["min"] = json!(bound(f32::min));
        accessor["max"] = json!(bound(f32::max));
    }
    model
}

/// A model of boxes: scales of all kinds, two mirrors, a matrix, a spline, and a scale that moves.
fn crane() -> Model {
    let mut model = Model::new();
    let block = model.block("block", [0.5, 1.0, 0.4]);
    model.root(json!({ "name": "base", "mesh": block, "scale": [1.5, 1.5, 1.5], "children": [1] }));
    model.push("nodes", json!({ "name": "mast", "mesh": block, "translation": [0, 0.5, 0], "scale": [1, 1.4, 0.5], "children": [2, 3] }));
    model.push("nodes", json!({ "name": "boom", "mesh": block, "scale": [-1, 1, 0.8], "children": [4] }));
    // Not a skewed one: three.js decomposes matrices.
    let matrix = [0.3, 0.4, 0.0, 0.0, -0.4, 0.3, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, -0.5, 0.25, 0.0, 1.0];
    model.push("nodes", json!({ "name": "weight", "mesh": block, "matrix": matrix }));
    model.push("nodes", json!({ "name": "hook", "mesh": block, "translation": [0, 0.75, 0.1] }));
    let flat: Vec<f32> = (0..15).map(|place| [0.0, 0.5, 0.25, 0.75, 0.125][place * 7 % 5]).collect();
    // Before, value and after of each key.
    let wave: Vec<f32> = turns([0.0, 0.6, 0.8])
        .chunks(4)
        .flat_map(|value| [&[0.0, 0.1, -0.1, 0.0], value, &[0.0, 0.1, -0.1, 0.0]].concat())
        .collect();
    let sizes: Vec<f32> = (0..5).flat_map(|key| [1.0, 0.5 + 0.25 * (key % 3) as f32, 1.0]).collect();
    model.animation(
        "lift",
        &[
            (0, "rotation", &TIMES, &turns([0.0, 1.0, 0.0]), "LINEAR"),
            (1, "rotation", &TIMES, &turns([1.0, 0.0, 0.0]), "LINEAR"),
            (2, "rotation", &TIMES, &turns([0.6, 0.0, 0.8]), "LINEAR"),
            (2, "translation", &TIMES, &flat, "LINEAR"),
            (4, "rotation", &TIMES, &wave, "CUBICSPLINE"),
            (4, "scale", &TIMES, &sizes, "LINEAR"),
        ],
    );
    model
}

/// A tube that a skin of three joints bends, of which two are scaled. Its own node has a place, which counts for nothing.
fn tube() -> Model {
    const LEVELS: u16 = 9;
    let mut model = Model::new();
    let (mut positions, mut joints, mut weights, mut indices) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for level in 0..LEVELS {
        let height = f32::from(level) * 0.25;
        let (joint, part) = ((level / 4).min(1), f32::from(level % 4) * 0.25);
        let part = if level == LEVELS - 1 { 1.0 } else { part };
        for corner in 0..4_u16 {
            positions.extend([if corner % 3 == 0 { -0.2 } else { 0.2 }, height, if corner < 2 { -0.2 } else { 0.2 }]);
            joints.extend([joint, joint + 1, 0, 0]);
            weights.extend([1.0 - part, part, 0.0, 0.0]);
            let (one, next) = (level * 4 + corner, level * 4 + (corner + 1) % 4);
            if level < LEVELS - 1 {
                indices.extend([one, one + 4, next, next, one + 4, next + 4]);
            }
        }
    }
    let attributes = json!({
        "POSITION": model.floats("VEC3", &positions),
        "JOINTS_0": model.shorts("VEC4", &joints),
        "WEIGHTS_0": model.floats("VEC4", &weights),
    });
    let indices = model.shorts("SCALAR", &indices);
    model.push("meshes", json!({ "name": "tube", "primitives": [{ "attributes": attributes, "indices": indices }] }));
    let mut matrices = [0.0; 48];
    for joint in 0..3 {
        for diagonal in [0, 5, 10, 15] {
            matrices[16 * joint + diagonal] = 1.0;
        }
        matrices[16 * joint + 13] = -(joint as f32);
    }
    let matrices = model.floats("MAT4", &matrices);
    model.root(json!({ "name": "figure", "translation": [0.5, 0, 0.25], "children": [1, 4] }));
    model.push("nodes", json!({ "name": "lower", "scale": [1.25, 1, 1], "children": [2] }));
    model.push("nodes", json!({ "name": "middle", "translation": [0, 1, 0], "children": [3] }));
    model.push("nodes", json!({ "name": "upper", "translation": [0, 1, 0], "scale": [0.75, 0.5, 0.75] }));
    model.push(
        "nodes",
        json!({ "name": "tube", "mesh": 0, "skin": 0, "translation": [7, 7, 7], "rotation": [0, 0.6, 0, 0.8] }),
    );
    model.push("skins", json!({ "joints": [1, 2, 3], "inverseBindMatrices": matrices }));
    let steps: Vec<f32> = (0..5).flat_map(|key| [0.5, 0.125 * (key % 2) as f32, 0.25]).collect();
    model.animation(
        "bend",
        &[
            (0, "translation", &TIMES, &steps, "LINEAR"),
            (1, "rotation", &TIMES, &turns([1.0, 0.0, 0.0]), "LINEAR"),
            (2, "rotation", &TIMES, &turns([0.0, 0.6, 0.8]), "LINEAR"),
            (3, "rotation", &TIMES, &turns([0.0, 0.0, 1.0]), "LINEAR"),
        ],
    );
    model
}

#[test]
fn the_models_of_the_judges_are_as_they_are_made_here_and_are_imported() {
    for (name, model) in [("crane", with_bounds(crane())), ("tube", with_bounds(tube()))] {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/data/models/{name}.gltf"));
        let text = model.text();
        if std::env::var_os("UPDATE_GOLDENS").is_some() {
            std::fs::write(&file, &text).unwrap();
        }
        assert!(std::fs::read(&file).unwrap() == text, "{name} is another; UPDATE_GOLDENS=1 writes it");
        assert!(import_file(&text, &options()).unwrap().animation.is_some());
    }
}
