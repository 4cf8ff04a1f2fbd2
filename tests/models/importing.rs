//! glTF files as scenes and animations.

use glam::{Quat, Vec3};
use inbetween::interchange::gltf_in::{self, AnimationChoice, Options, contents, imported};
use inbetween::interchange::reduce::{Choice, reduced};
use inbetween::interpolation::Interpolation;
use inbetween::keyframe::{Animation, PlayRange};
use inbetween::model::ModelFormat;
use inbetween::rbt::Rbt;
use inbetween::scene::{Channel, NodeKind, SceneGraph, scene_to_json};
use inbetween::words::Message;
use serde_json::json;

use super::make::Model;

pub fn no_files(uri: &str) -> Result<Vec<u8>, Message> {
    panic!("no file is named: {uri}")
}

/// What is made of a file, with the keyframes that the command line writes if nothing else is asked for.
#[derive(Debug)]
pub struct Imported {
    pub scene: SceneGraph,
    pub animation: Option<Animation>,
    pub report: Vec<String>,
}

pub fn import(model: &Model, options: &Options) -> Result<Imported, String> {
    import_file(&model.glb(), options)
}

pub fn import_file(file: &[u8], options: &Options) -> Result<Imported, String> {
    let read = imported(file, &mut no_files, options).map_err(|error| error.to_string())?;
    let gltf_in::Imported { scene, moving, tolerance, mut report, mut others } = read;
    report.append(&mut others);
    let animation = moving.map(|moving| match moving.kept {
        Some((animation, _)) => animation,
        None => reduced(&moving.samples, Choice::Within(tolerance), Interpolation::Linear).animation,
    });
    Ok(Imported { scene, animation, report: report.iter().map(ToString::to_string).collect() })
}

pub fn options() -> Options {
    Options { name: "model".to_owned(), ..Options::default() }
}

/// Options for an animation of a name.
pub fn named(animation: &str) -> Options {
    Options { animation: Some(AnimationChoice::Words(animation.to_owned())), ..options() }
}

fn timed() -> Options {
    Options { is_timed: true, ..options() }
}

#[track_caller]
pub fn good(model: &Model) -> Imported {
    import(model, &options()).unwrap()
}

#[track_caller]
pub fn refused(model: &Model, sentence: &str) {
    assert_eq!(import(model, &options()).expect_err(sentence), sentence);
}

#[test]
fn a_file_of_another_program_is_told_by_its_content() {
    let model = Model::new();
    for bytes in [&*model.glb(), &model.text(), b"\xef\xbb\xbf {\"asset\": {}}"] {
        assert_eq!(ModelFormat::of(bytes), Some(ModelFormat::Gltf));
    }
    for bytes in [&b"\xef\xbb\xbf hierarchy\n"[..], b"HIERARCHY \"asset\""] {
        assert_eq!(ModelFormat::of(bytes), Some(ModelFormat::Bvh));
    }
    for bytes in ["{\"format\": \"inbetween.scene\", \"nodes\": [{\"name\": \"asset\"}]}", "HIER", ""] {
        assert_eq!(ModelFormat::of(bytes.as_bytes()), None, "{bytes}");
    }
}

/// The paths of all nodes but those that are put around a model.
pub fn paths(scene: &SceneGraph) -> Vec<&str> {
    let all = scene.nodes().iter().map(|node| node.path.as_str());
    all.filter(|path| !["sky", "ground", "ground/plane"].contains(path) && !path.contains("bone")).collect()
}

pub fn rest(scene: &SceneGraph, path: &str) -> Rbt {
    scene.rest_pose().get(scene.find_rbt(path).expect(path))
}

/// Where a point of a node is in the world at rest.
pub fn in_world(scene: &SceneGraph, path: &str, point: Vec3) -> Vec3 {
    let node = scene.find(path).expect(path).get();
    let world = &scene.world_from_nodes(scene.rest_pose(), 0.0)[node];
    world.get().transform_point3(point)
}

/// A rotation about an axis by degrees.
pub fn turned(axis: Vec3, degrees: f32) -> [f32; 4] {
    Quat::from_axis_angle(axis, degrees.to_radians()).to_array()
}

#[test]
fn a_node_is_an_rbt_node_with_its_name() {
    let mut model = Model::new();
    let hand = model.push("nodes", json!({ "translation": [0, 1, 0], "rotation": turned(Vec3::X, 90.0) }));
    let others: Vec<usize> =
        ["x", "x", "p/q", "한.글:1"].iter().map(|name| model.push("nodes", json!({ "name": name }))).collect();
    model.root(json!({ "name": "arm", "children": [hand, others[0], others[1], others[2], others[3]] }));
    let Imported { scene, animation, report } = good(&model);
    assert_eq!(paths(&scene), ["arm", "arm/node_0", "arm/x", "arm/x_2", "arm/p_q", "arm/한.글:1"]);
    let hand = rest(&scene, "arm/node_0");
    assert_eq!(hand.translation, Vec3::Y);
    assert!((hand.rotation * Vec3::Y).distance(Vec3::Z) < 1e-6);
    assert!(animation.is_none());
    assert_eq!(report[0], "6 nodes, 0 meshes, 0 triangles, 0 skins");
    // It reads back, is written again as the same bytes, and an eye sees it.
    assert_eq!(scene.rbt_path(scene.eyes()[0]), "sky");
    let text = scene_to_json(&scene);
    assert_eq!(inbetween::scene::scene_from_json(&text).unwrap(), scene);
}

#[test]
fn trees_that_are_none_are_refused_with_their_place() {
    let tree = |nodes: serde_json::Value, roots: &[usize]| {
        let mut model = Model::new();
        model.json["nodes"] = nodes;
        model.json["scenes"] = json!([{ "nodes": roots }]);
        model
    };
    refused(&tree(json!([{ "children": [1] }, { "children": [0] }]), &[0]), "/nodes/0: is below itself");
    refused(&tree(json!([{}, { "children": [1] }]), &[0]), "/nodes/1: is below itself");
    let two = json!([{ "children": [2] }, { "children": [2] }, {}]);
    refused(&tree(two, &[0]), "/nodes/2: is below /nodes/0 and below /nodes/1");
    refused(&tree(json!([{ "children": [1, 1] }, {}]), &[0]), "/nodes/1: is below /nodes/0 and below /nodes/0");
    refused(&tree(json!([{ "children": [7] }]), &[0]), "/nodes/0: names /nodes/7, which the file does not have");
    refused(&tree(json!([{}]), &[3]), "/scenes/0: names /nodes/3, which the file does not have");
    refused(&tree(json!([{}]), &[0, 0]), "/scenes/0: /nodes/0 is in the list twice");
    let deep = (0..300).map(|node| if node < 299 { json!({ "children": [node + 1] }) } else { json!({}) }).collect();
    refused(&tree(deep, &[0]), "/nodes/256: is below 256 others, and a scene has at most 256 levels");
    refused(&tree(json!([{ "rotation": [0, 0, 0, 0] }]), &[0]), "/nodes/0: rotation 0 is no rotation: its length is 0");
}

#[test]
fn a_scene_is_chosen_by_its_number() {
    let mut model = Model::new();
    model.root(json!({ "name": "a" }));
    let b = model.push("nodes", json!({ "name": "b" }));
    model.push("scenes", json!({ "name": "second", "nodes": [b] }));
    let of = |model: &Model, gltf_scene| import(model, &Options { gltf_scene, ..options() });
    let first = of(&model, None).unwrap();
    assert_eq!(paths(&first.scene), ["a"]);
    assert!(first.report.iter().any(|line| *line == "other scenes, for --gltf-scene: 1 \"second\""));
    assert_eq!(paths(&of(&model, Some(1)).unwrap().scene), ["b"]);
    assert_eq!(of(&model, Some(2)).unwrap_err(), "there is no scene 2: the file has 2, counted from 0");
    model.json["scene"] = json!(1);
    assert_eq!(paths(&of(&model, None).unwrap().scene), ["b"]);
    model.json["scenes"] = json!([]);
    model.json["scene"] = json!(null);
    assert_eq!(paths(&of(&model, None).unwrap().scene), ["a", "b"]);
}

#[test]
fn cameras_are_eyes() {
    let mut model = Model::new();
    model.root(json!({ "name": "first", "translation": [0, 1, 4], "camera": 0 }));
    model.root(json!({ "name": "second", "camera": 1 }));
    model.root(json!({ "name": "third", "camera": 2 }));
    model.push("cameras", json!({ "type": "perspective", "perspective": { "yfov": 0.872_664_6, "znear": 0.1 } }));
    model.push("cameras", json!({ "type": "perspective", "perspective": { "yfov": 1.0, "znear": 0.1 } }));
    model.push("cameras", json!({ "type": "orthographic", "orthographic": {} }));
    let Imported { scene, report, .. } = good(&model);
    let eyes: Vec<&str> = scene.eyes().iter().map(|&eye| scene.rbt_path(eye)).collect();
    assert_eq!((eyes.as_slice(), scene.vertical_fov_degrees()), (["first", "second"].as_slice(), 50.0));
    assert!(report.contains(&"the camera of “third” has no perspective, and is left out".to_owned()), "{report:?}");
    let other =
        "the camera of “second” has another field of view than the first, and gets that of the first".to_owned();
    assert!(report.contains(&other), "{report:?}");
}

/// A file whose node `arm` turns by two thirds of a turn in two seconds, and whose node `hand` jumps.
fn moving() -> Model {
    let mut model = Model::new();
    let hand = model.push("nodes", json!({ "name": "hand", "translation": [0, 1, 0] }));
    let arm = model.root(json!({ "name": "arm", "children": [hand] }));
    let turns: Vec<f32> = [0.0, 120.0, 240.0].into_iter().flat_map(|degrees| turned(Vec3::Z, degrees)).collect();
    model.animation(
        "wave",
        &[
            (arm, "rotation", &[1.0, 2.0, 3.0], &turns, "LINEAR"),
            (hand, "translation", &[1.0, 2.5], &[0.0, 1.0, 0.0, 0.0, 2.0, 0.0], "STEP"),
        ],
    );
    model.animation("still", &[(arm, "rotation", &[0.0], &[0.0, 0.0, 0.0, 1.0], "LINEAR")]);
    model
}

/// Where a node is in its parent's space at a time in seconds of keyframes.
fn played(imported: &Imported, path: &str, seconds: f64) -> Rbt {
    let animation = imported.animation.as_ref().expect("it is animated");
    let range = PlayRange::new(&animation.keyframes).expect("it plays");
    let keyframes = animation.keyframes.as_slice();
    let unit = f64::from(animation.ms_between_keyframes) / 1000.0;
    let (mut at, mut elapsed) = (1, 0.0);
    while at + 2 < keyframes.len() - 1 && elapsed + keyframes[at].duration * unit <= seconds {
        elapsed += keyframes[at].duration * unit;
        at += 1;
    }
    let key_time = (at - 1) as f64 + (seconds - elapsed) / (keyframes[at].duration * unit);
    let rbt = imported.scene.find_rbt(path).expect(path);
    range.node_at(key_time.min(range.last_key_time() as f64), animation.interpolation, rbt)
}

#[test]
fn an_animation_becomes_few_keyframes() {
    let imported = good(&moving());
    let animation = imported.animation.as_ref().expect("it is animated");
    assert_eq!(animation.interpolation, Interpolation::Linear);
    // Both ends, two around the jump, and the two that steer; the arm's middle is on the way.
    assert_eq!(animation.keyframes.len(), 6);
    for (seconds, degrees, height) in
        [(0.0, 0.0, 1.0), (0.5, 60.0, 1.0), (1.25, 150.0, 1.0), (1.75, 210.0, 2.0), (2.0, 240.0, 2.0)]
    {
        let (arm, hand) = (played(&imported, "arm", seconds), played(&imported, "arm/hand", seconds));
        let expected = Quat::from_array(turned(Vec3::Z, degrees));
        assert!(arm.rotation.dot(expected).abs() > 1.0 - 1e-6, "{seconds}: {}", arm.rotation);
        assert!((hand.translation.y - height).abs() < 1e-5, "{seconds}: {}", hand.translation);
    }
    let report = &imported.report;
    assert!(report.contains(&"other animations, for --animation: 1 \"still\"".to_owned()), "{report:?}");
    assert!(report.contains(&"the animation begins at 1.000 s, which becomes 0 s".to_owned()), "{report:?}");
}

#[test]
fn an_animation_is_chosen_by_name_or_number() {
    let of = |animation: &str| import(&moving(), &named(animation));
    for still in ["still", "1"] {
        assert_eq!(of(still).unwrap().animation.expect("it is animated").keyframes.len(), 4);
    }
    assert_eq!(of("wave").unwrap().animation.unwrap().keyframes.len(), 6);
    assert_eq!(of("run").unwrap_err(), "there is no animation \"run\": the file has 0 \"wave\" and 1 \"still\"");
    // A name can be a number.
    let mut model = moving();
    model.json["animations"][0]["name"] = json!("1");
    let count = |options| import(&model, &options).unwrap().animation.unwrap().keyframes.len();
    let number = |number| Options { animation: Some(AnimationChoice::Number(number)), ..options() };
    assert_eq!([count(named("1")), count(number(0)), count(number(1))], [6, 6, 4]);
    let missing = import(&model, &number(2)).unwrap_err();
    assert_eq!(missing, "there is no animation 2: the file has 0 \"1\" and 1 \"still\"");
}

#[test]
fn a_file_says_what_it_has_to_choose_from() {
    let mut model = moving();
    let none = contents(&Model::new().glb()).unwrap();
    assert!(!none.has_choice() && none.scenes.is_empty() && none.animations.is_empty());
    model.push("scenes", json!({ "name": "second" }));
    model.json["scene"] = json!(1);
    model.json["animations"][1]["name"] = json!(null);
    let all = contents(&model.text()).unwrap();
    assert_eq!(all.scenes, [None, Some("second".to_owned())]);
    assert_eq!((all.own_scene, all.animations.as_slice()), (1, [Some("wave".to_owned()), None].as_slice()));
    assert!(all.has_choice() && contents(b"{").is_err());
}

/// The keys of a channel of a control node.
pub fn keys(scene: &SceneGraph, path: &str, channel: Channel) -> Vec<(f64, [f32; 4])> {
    let NodeKind::Control(tracks) = &scene.node(scene.find(path).expect(path)).kind else {
        panic!("{path} is no control node")
    };
    tracks
        .get(channel)
        .map(|track| track.keys().map(|(at, value)| (at, value.to_array())).collect())
        .unwrap_or_default()
}

#[test]
fn timed_keys_have_the_times_of_the_file() {
    let Imported { scene, animation, .. } = import(&moving(), &timed()).unwrap();
    assert!(animation.is_none());
    let arm: Vec<f64> = keys(&scene, "arm", Channel::Rotation).iter().map(|(at, _)| *at).collect();
    assert_eq!(arm, [1.0, 2.0, 3.0]);
    let hand = keys(&scene, "arm/hand", Channel::Translation);
    assert_eq!(hand.len(), 3);
    assert_eq!((hand[0].0, hand[2].0, hand[1].1[1], hand[2].1[1]), (1.0, 2.5, 1.0, 2.0));
    assert!((hand[1].0 - 2.499_999).abs() < 1e-9, "the value before the jump holds until just before it");
    assert_eq!(scene.rbt_paths().collect::<Vec<_>>(), ["sky", "ground"]);
}

#[test]
fn splines_are_near_their_timed_keys_and_keyframes() {
    let mut model = Model::new();
    let node = model.root(json!({ "name": "ball" }));
    let values = [[0.0; 3], [0.0; 3], [0.0, 8.0, 0.0], [0.0, -8.0, 0.0], [2.0, 0.0, 0.0], [0.0; 3]];
    model.animation("jump", &[(node, "translation", &[0.0, 1.0], values.as_flattened(), "CUBICSPLINE")]);
    let height = |at: f64| (8.0 * (at - 2.0 * at * at + at * at * at) + 8.0 * (at * at - at * at * at)) as f32;
    let timed = import(&model, &timed()).unwrap().scene;
    let NodeKind::Control(tracks) = &timed.node(timed.find("ball").unwrap()).kind else { panic!("it is timed") };
    let keyframes = good(&model);
    for part in 0..=40 {
        let at = f64::from(part) / 40.0;
        let off = tracks.parent_from_node(at).translation.y - height(at);
        assert!(off.abs() < 3e-4, "{at}: {off}");
        let off = played(&keyframes, "ball", at).translation.y - height(at);
        assert!(off.abs() < 2.5e-3, "{at}: {off}");
    }
    assert!(keyframes.animation.expect("it is animated").keyframes.len() < 70);
}

#[test]
fn what_is_left_out_is_named() {
    let mut model = Model::new();
    let node = model.root(json!({ "name": "a" }));
    model.animation("all", &[(node, "translation", &[0.0, 1.0], &[0.0; 6], "LINEAR")]);
    let channels = &mut model.json["animations"][0]["channels"];
    for target in [
        json!({ "node": node, "path": "weights" }),
        json!({ "path": "pointer" }),
        json!({ "node": node, "path": "colour" }),
    ] {
        channels.as_array_mut().unwrap().push(json!({ "sampler": 0, "target": target }));
    }
    model.json["extensionsUsed"] = json!(["KHR_lights_punctual", "KHR_materials_unlit", "KHR_animation_pointer"]);
    let report = good(&model).report;
    for sentence in [
        "the morph targets of “a” are left out, and so is their animation",
        "/animations/0/channels/2: what it moves is named by an extension; left out",
        "/animations/0/channels/3: a channel of colour is left out",
        "extensions that are not shown: KHR_lights_punctual and KHR_animation_pointer",
    ] {
        assert!(report.iter().any(|line| line == sentence), "{sentence}: {report:?}");
    }
}
