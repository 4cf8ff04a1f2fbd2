//! Mutants of small models: whatever bytes there are, the reader says a sentence or makes a scene that can be written and read.

use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind};

use inbetween::gltf::glb;
use inbetween::interchange::gltf_in::{Options, imported};
use inbetween::interchange::reduce::{Choice, reduced};
use inbetween::interpolation::Interpolation;
use inbetween::model::MeshLibrary;
use inbetween::rbt::Rbt;
use inbetween::scene::{scene_from_json, scene_to_json};
use inbetween::words::{Message, texts};
use serde_json::{Value, json};

use super::make::{Channel, Model, png, skinned};
use super::random_numbers::Random;

/// How many there are; more by `INBETWEEN_MUTANTS`.
const MUTANTS: usize = 20_000;

/// Models with all that a file can hold.
fn originals() -> Vec<Model> {
    let mut moving = Model::new();
    let mesh = moving.block("block", [1.0, 2.0, 3.0]);
    let inner = json!({ "name": "inner", "mesh": mesh, "scale": [-1, 2, 1], "translation": [1, 0, 0], "camera": 0 });
    let inner = moving.push("nodes", inner);
    let leaf = json!({ "mesh": mesh, "matrix": [1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, -1, 0, 5, 1, 0, 1] });
    let leaf = moving.push("nodes", leaf);
    let outer = moving.root(json!({ "name": "a/b", "children": [inner, leaf], "rotation": [0, 0.6, 0, 0.8] }));
    moving.push("cameras", json!({ "type": "perspective", "perspective": { "yfov": 0.8, "znear": 0.1 } }));
    moving.push("scenes", json!({ "name": "second", "nodes": [outer] }));
    let cubic = [[0.0_f32; 3], [0.0; 3], [0.0, 8.0, 0.0], [0.0, -8.0, 0.0], [2.0, 0.0, 0.0], [0.0; 3]];
    let channels: [Channel<'_>; 4] = [
        (outer, "rotation", &[0.0, 0.5, 1.0], &[0.0, 0.0, 0.0, 1.0, 0.0, 0.6, 0.0, 0.8, 0.0, 0.0, 1.0, 0.0], "LINEAR"),
        (outer, "translation", &[0.0, 1.0], cubic.as_flattened(), "CUBICSPLINE"),
        (inner, "translation", &[0.25, 0.75], &[1.0, 0.0, 0.0, 2.0, 0.0, 0.0], "STEP"),
        (outer, "scale", &[0.0, 2.0], &[1.0, 1.0, 1.0, 2.0, 2.0, 2.0], "LINEAR"),
    ];
    moving.animation("all", &channels);
    let mut textured = skinned([0.5, 0.5, 0.0, 0.0]);
    let picture = textured.view(&png([[9, 200, 30, 255]; 4]));
    let coordinates = textured.floats("VEC2", &[0.25; 32]);
    textured.push("images", json!({ "bufferView": picture, "mimeType": "image/png" }));
    textured.push("samplers", json!({ "wrapS": 33071 }));
    textured.push("textures", json!({ "source": 0, "sampler": 0 }));
    let transform = json!({ "KHR_texture_transform": { "offset": [0.5, 0], "rotation": 1 } });
    let texture = json!({ "index": 0, "texCoord": 0, "extensions": transform });
    let surface = json!({ "baseColorFactor": [1, 0.5, 0, 1], "baseColorTexture": texture, "metallicFactor": 0.5 });
    textured.push("materials", json!({ "pbrMetallicRoughness": surface, "alphaMode": "MASK", "doubleSided": true }));
    let primitive = &mut textured.json["meshes"][0]["primitives"][0];
    primitive["material"] = json!(0);
    primitive["attributes"]["TEXCOORD_0"] = json!(coordinates);
    let mut sparse = Model::new();
    let mesh = sparse.block("sparse", [1.0, 1.0, 1.0]);
    let (indices, values) = (sparse.view(&[1, 0, 6, 0]), sparse.view(&[0, 0, 128, 63].repeat(6)));
    let places = json!({ "bufferView": indices, "componentType": 5123 });
    let replaced = json!({ "count": 2, "indices": places, "values": { "bufferView": values } });
    sparse.json["accessors"][0]["sparse"] = replaced;
    sparse.json["meshes"][mesh]["primitives"][0]["mode"] = json!(5);
    let own =
        json!({ "path": "hub/ball", "kind": "shape", "shape": { "sphere": { "radius": 1 } }, "colour": "#ff0000" });
    let ball = sparse.push("nodes", json!({ "mesh": mesh, "extras": { "inbetween": own } }));
    let hub = json!({ "path": "hub", "kind": "control", "in_paths": false });
    let hub = sparse.root(json!({ "children": [ball], "extras": { "inbetween": hub } }));
    sparse.root(json!({ "mesh": mesh, "camera": 0, "extras": { "inbetween": { "path": "eye", "kind": "rbt", "reach": [0, 1, 0], "stands": true } } }));
    sparse.push("cameras", json!({ "type": "perspective", "perspective": { "yfov": 0.8, "znear": 0.1 } }));
    sparse.json["scenes"][0]["extras"] =
        json!({ "inbetween": { "name": "s", "eyes": ["eye"], "vertical_fov_degrees": 50 } });
    sparse.animation("own", &[(hub, "rotation", &[0.0, 1.0], &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0], "LINEAR")]);
    let pace = json!({ "interpolation": "catmull-rom", "ms_between_keyframes": 500, "durations": [1, 1] });
    sparse.json["animations"][0]["extras"] = json!({ "inbetween": pace });
    vec![moving, textured, sparse]
}

/// A value of a tree, by a walk of random turns.
fn somewhere<'a>(value: &'a mut Value, random: &mut Random) -> &'a mut Value {
    let count = match value {
        Value::Object(fields) => fields.len(),
        Value::Array(items) => items.len(),
        _ => 0,
    };
    if count == 0 || random.below(12) == 0 {
        return value;
    }
    let at = random.below(count);
    let below = match value {
        Value::Object(fields) => fields.values_mut().nth(at),
        Value::Array(items) => items.get_mut(at),
        _ => None,
    };
    somewhere(below.expect("it was counted"), random)
}

fn mutant(originals: &[Model], random: &mut Random) -> Vec<u8> {
    let mut model = originals[random.below(originals.len())].clone();
    for _ in 0..=random.below(3) {
        match random.below(8) {
            0 if !model.bytes.is_empty() => {
                let at = random.below(model.bytes.len());
                model.bytes[at] ^= 1 << random.below(8);
            }
            1 if model.bytes.len() >= 4 => {
                let at = random.below(model.bytes.len() / 4) * 4;
                let number = [f32::NAN, f32::INFINITY, f32::MAX, f32::MIN_POSITIVE, -1.0, 1e30][random.below(6)];
                model.bytes[at..at + 4].copy_from_slice(&number.to_le_bytes());
            }
            2 => {
                let keep = random.below(model.bytes.len() + 1);
                model.bytes.truncate(keep);
            }
            3 => {
                let donor = somewhere(&mut originals[random.below(originals.len())].json.clone(), random).clone();
                *somewhere(&mut model.json, random) = donor;
            }
            4 => {
                let value = somewhere(&mut model.json, random);
                if let Value::Array(items) = value
                    && !items.is_empty()
                {
                    let item = items[random.below(items.len())].clone();
                    if random.below(2) == 0 {
                        items.push(item);
                    } else {
                        items.swap_remove(random.below(items.len()));
                    }
                } else if let Value::Object(fields) = value
                    && let Some(name) = fields.keys().nth(random.below(fields.len().max(1))).cloned()
                {
                    fields.remove(&name);
                }
            }
            _ => {
                let value = somewhere(&mut model.json, random);
                *value = match random.below(14) {
                    0 => json!(0),
                    1 => json!(1),
                    2 => json!(-1),
                    3 => json!(2),
                    4 => json!(3),
                    5 => json!(0.5),
                    6 => json!(1e30),
                    7 => json!(u64::MAX),
                    8 => json!(1_000_000),
                    9 => json!("x/y"),
                    10 => json!([]),
                    11 => json!({}),
                    12 => json!([0, 0, 0]),
                    _ => Value::Null,
                };
            }
        }
    }
    let mut file = if !model.json.is_object() {
        glb(&model.json.to_string(), &model.bytes)
    } else if random.below(3) == 0 {
        model.text()
    } else {
        model.json["buffers"] = json!([{ "byteLength": model.bytes.len() }]);
        glb(&model.json.to_string(), &model.bytes)
    };
    if random.below(4) == 0 {
        for _ in 0..=random.below(3) {
            let at = random.below(file.len());
            file[at] = [0, 255, b'0', b'9', b'"', b'[', b'}', b',', b'-', b'e'][random.below(10)];
        }
    }
    file
}

/// Reads a file as far as it goes; says whether it is good.
fn read(file: &[u8], seed: u64) -> bool {
    let options = Options { name: "m".to_owned(), is_timed: seed.is_multiple_of(3), ..Options::default() };
    let mut no_files = |_: &str| Err(Message::from(texts::GLTF_FILE_ALONE));
    let library = MeshLibrary::from_glb(file);
    assert!(library.is_ok() || !library.unwrap_err().to_string().is_empty());
    match imported(file, &mut no_files, &options) {
        Err(problem) => {
            assert!(!problem.to_string().is_empty());
            false
        }
        Ok(made) => {
            let again = scene_from_json(&scene_to_json(&made.scene)).expect("what is written is read");
            assert_eq!(again, made.scene);
            if let Some(moving) = made.moving {
                let few = reduced(&moving.samples, Choice::Within(made.tolerance), Interpolation::Linear);
                assert!(
                    few.animation.keyframes.as_slice().iter().all(|keyframe| keyframe.pose.iter().all(Rbt::is_finite))
                );
            }
            true
        }
    }
}

#[test]
fn no_mutant_breaks_the_reader() {
    let count = std::env::var("INBETWEEN_MUTANTS").ok().and_then(|count| count.parse().ok()).unwrap_or(MUTANTS);
    let originals = originals();
    for (number, model) in originals.iter().enumerate() {
        let made = imported(&model.glb(), &mut |_| panic!("no file is named"), &Options::default());
        assert!(made.is_ok(), "the original {number}: {}", made.unwrap_err());
        assert!(read(&model.glb(), 0) && read(&model.text(), 1), "the original {number} is good");
    }
    let threads = 2;
    let found: Vec<(usize, BTreeSet<String>)> = std::thread::scope(|scope| {
        let work = |thread: usize| {
            let originals = originals.clone();
            move || {
                let (mut good, mut broken) = (0, BTreeSet::new());
                for seed in (thread..count).step_by(threads) {
                    let file = mutant(&originals, &mut Random(seed as u64 * 0x1_0001 + 7));
                    match catch_unwind(AssertUnwindSafe(|| read(&file, seed as u64))) {
                        Ok(is_good) => good += usize::from(is_good),
                        Err(_) => drop(broken.insert(seed.to_string())),
                    }
                }
                (good, broken)
            }
        };
        let threads: Vec<_> = (0..threads).map(|thread| scope.spawn(work(thread))).collect();
        threads.into_iter().map(|thread| thread.join().expect("panics are caught")).collect()
    });
    let good: usize = found.iter().map(|(good, _)| good).sum();
    let broken: Vec<&String> = found.iter().flat_map(|(_, broken)| broken).take(20).collect();
    assert!(broken.is_empty(), "mutants {broken:?} panic");
    assert!(good > count / 20 && good < count, "{good} of {count} mutants are good: they are to be of both kinds");
}
