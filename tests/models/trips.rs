//! Exports of this program, read back.

use inbetween::interchange::gltf_out::Export;
use inbetween::keyframe::{Animation, PlayRange, keyframes_from_json};
use inbetween::model::DEFAULT_ROUGHNESS;
use inbetween::pose::RbtIndex;
use inbetween::scene::{
    BUILT_IN_ANIMATIONS, NodeKind, SceneGraph, built_in_scene, built_in_scene_names, scene_from_json, scene_to_json,
};
use serde_json::Value;

use super::importing::{Imported, good, import_file, options};
use super::make::skinned;

/// An exported file as text, which can be changed.
fn exported(scene: &SceneGraph, animation: Option<&Animation>) -> String {
    Export { animation: animation.map(|animation| (animation, "motion")), ..Export::of(scene) }.gltf().0
}

#[track_caller]
fn back(text: &str) -> Imported {
    import_file(text.as_bytes(), &options()).unwrap()
}

fn built_in(name: &str) -> (SceneGraph, Animation) {
    let animation = BUILT_IN_ANIMATIONS.iter().find(|animation| animation.name == name).expect(name);
    let scene = built_in_scene(animation.scene).expect("it is built in");
    let file = keyframes_from_json(animation.text.as_bytes(), &scene).expect("it is good");
    let (keyframes, interpolation, ms_between_keyframes) = file.into_parts();
    let animation = Animation { keyframes, interpolation, ms_between_keyframes };
    (scene, animation)
}

/// How far two animations are apart in their parents' spaces, in degrees and units, each over its whole length.
fn apart(a: (&SceneGraph, &Animation), b: (&SceneGraph, &Animation)) -> (f32, f32) {
    let mut worst = (0.0_f32, 0.0_f32);
    for part in 0..=400 {
        let fraction = f64::from(part) / 400.0;
        let pose = |(scene, animation): (&SceneGraph, &Animation)| {
            let range = PlayRange::new(&animation.keyframes).expect("it plays");
            let timing = inbetween::keyframe::Timing::of(animation.keyframes.as_slice()).expect("it plays");
            let elapsed = timing.total() * num_rational::BigRational::from_float(fraction).expect("it is finite");
            let key_time = timing.key_time_at(&elapsed);
            let rbts: Vec<(String, inbetween::rbt::Rbt)> = (0..scene.rbt_count())
                .map(RbtIndex::new)
                .map(|rbt| (scene.rbt_path(rbt).to_owned(), range.node_at(key_time, animation.interpolation, rbt)))
                .collect();
            rbts
        };
        let b = pose(b);
        for (path, one) in pose(a) {
            let Some((_, other)) = b.iter().find(|(other, _)| *other == path) else { continue };
            let degrees = 2.0 * (one.rotation - other.rotation).length().min((one.rotation + other.rotation).length());
            worst.0 = worst.0.max(degrees.to_degrees());
            worst.1 = worst.1.max(one.translation.distance(other.translation));
        }
    }
    worst
}

#[test]
fn a_scene_comes_back_as_it_was() {
    for name in built_in_scene_names() {
        let scene = built_in_scene(name).expect("it is built in");
        let Imported { scene: once, .. } = back(&exported(&scene, None));
        let paths = |scene: &SceneGraph| scene.nodes().iter().map(|node| node.path.clone()).collect::<Vec<_>>();
        assert_eq!(paths(&once), paths(&scene), "{name}");
        assert_eq!(once.rest_pose(), scene.rest_pose(), "{name}");
        assert_eq!(
            (once.eyes(), once.name(), once.vertical_fov_degrees()),
            (scene.eyes(), scene.name(), scene.vertical_fov_degrees())
        );
        for (one, other) in once.nodes().iter().zip(scene.nodes()) {
            assert_eq!((one.joint, one.is_in_paths), (other.joint, other.is_in_paths), "{}", one.path);
            if let (NodeKind::Shape(one), NodeKind::Shape(other)) = (&one.kind, &other.kind) {
                assert_eq!((&one.shape, one.colour, one.placement()), (&other.shape, other.colour, other.placement()));
            }
        }
        let twice = back(&exported(&once, None)).scene;
        assert_eq!(scene_to_json(&twice), scene_to_json(&once), "{name}: a second trip changes nothing");
    }
}

#[test]
fn lights_and_surfaces_come_back_and_other_programs_see_the_surfaces() {
    let text = r##"{"format": "inbetween.scene", "version": 3, "name": "lit", "eyes": ["sky"],
        "lighting": {"of": "evening", "sun": {"direction": [-3, 4, 0], "degrees": 2.5}, "sky": {"ground": "#404040"}},
        "nodes": [{"name": "sky"}, {"name": "x", "children": [
            {"name": "plain", "shape": {"sphere": {"radius": 1}}},
            {"name": "gold", "shape": {"sphere": {"radius": 1}}, "roughness": 0.25, "metalness": 1}]}]}"##;
    let scene = scene_from_json(text).unwrap();
    let exported = exported(&scene, None);
    assert_eq!(scene_to_json(&back(&exported).scene), scene_to_json(&scene));
    let file: Value = serde_json::from_str(&exported).unwrap();
    let surfaces: Vec<_> = file["materials"]
        .as_array()
        .unwrap()
        .iter()
        .map(|material| {
            let surface = &material["pbrMetallicRoughness"];
            ["roughnessFactor", "metallicFactor"].map(|factor| surface[factor].as_f64().unwrap() as f32)
        })
        .collect();
    assert_eq!(surfaces, [[DEFAULT_ROUGHNESS, 0.0], [0.25, 1.0]]);
}

#[test]
fn an_animation_comes_back_with_its_keyframes() {
    for name in ["walk", "wave"] {
        let (scene, animation) = built_in(name);
        let text = exported(&scene, Some(&animation));
        let once = back(&text);
        let played = once.animation.as_ref().expect("it is animated");
        assert_eq!(
            (played.interpolation, played.ms_between_keyframes),
            (animation.interpolation, animation.ms_between_keyframes)
        );
        let (ours, theirs) = (animation.keyframes.as_slice(), played.keyframes.as_slice());
        assert_eq!(ours.len(), theirs.len());
        for (ours, theirs) in ours.iter().zip(theirs).skip(1).take(ours.len() - 2) {
            assert_eq!((ours.duration, ours.easing, &ours.name), (theirs.duration, theirs.easing, &theirs.name));
        }
        let off = apart((&scene, &animation), (&once.scene, played));
        assert!(off.0 < 0.02 && off.1 < 2e-4, "{name}: {off:?}");
        // What is in the file besides the poses is only the pace.
        let mut without: Value = serde_json::from_str(&text).unwrap();
        take_extras(&mut without);
        let bare = back(&without.to_string());
        let off = apart((&scene, &animation), (&bare.scene, bare.animation.as_ref().expect("it is animated")));
        assert!(off.0 < 0.6 && off.1 < 0.01, "{name} without extras: {off:?}");
    }
}

#[test]
fn timed_keys_that_go_on_longer_than_the_keyframes_change_nothing() {
    let (scene, animation) = built_in("orbits-tour");
    let seconds = f64::from(animation.ms_between_keyframes) / 1000.0 * (animation.keyframes.len() - 3) as f64;
    assert!(scene.last_second().is_some_and(|last| last > 2.0 * seconds), "its planets go around for longer");
    let once = back(&exported(&scene, Some(&animation)));
    let played = once.animation.as_ref().expect("it is animated");
    assert_eq!(played.keyframes.len(), animation.keyframes.len());
    let off = apart((&scene, &animation), (&once.scene, played));
    assert!(off.0 < 0.02 && off.1 < 2e-4, "{off:?}");
    let twice = back(&exported(&once.scene, Some(played)));
    assert_eq!(twice.animation.expect("it is animated").keyframes, played.keyframes);
}

#[test]
fn a_scale_that_is_1_but_for_rounding_makes_no_node() {
    for (scale, has_node) in [([1.000_000_2, 0.999_999_4, 1.0], false), ([1.001, 1.0, 1.0], true)] {
        let mut model = skinned([0.5, 0.5, 0.0, 0.0]);
        model.json["nodes"][1]["scale"] = serde_json::json!(scale);
        // A scale that moves by less than that is the same.
        let scales = [scale, scale].concat();
        model.animation("still", &[(1, "scale", &[0.0, 1.0], &scales, "LINEAR")]);
        let scene = good(&model).scene;
        let has_control = scene.nodes().iter().any(|node| matches!(node.kind, NodeKind::Control(_)));
        assert_eq!(has_control, has_node, "{scale:?}");
    }
}

/// Takes all extras out of a file.
fn take_extras(value: &mut Value) {
    match value {
        Value::Object(fields) => {
            fields.remove("extras");
            fields.values_mut().for_each(take_extras);
        }
        Value::Array(items) => items.iter_mut().for_each(take_extras),
        _ => {}
    }
}

#[test]
fn a_motion_that_was_changed_since_is_not_kept() {
    let (scene, animation) = built_in("wave");
    let mut file: Value = serde_json::from_str(&exported(&scene, Some(&animation))).unwrap();
    let pace = &mut file["animations"][0]["extras"]["inbetween"];
    pace["interpolation"] = "linear".into();
    let made = back(&file.to_string());
    let played = made.animation.expect("it is animated");
    assert!(played.keyframes.len() != animation.keyframes.len(), "a straight course is not what the file moves");
}

#[test]
fn meshes_and_skins_make_a_second_trip_unchanged() {
    let mut model = skinned([0.5, 0.5, 0.0, 0.0]);
    let block = model.block("block", [1.0, 2.0, 3.0]);
    model.root(json_node(block));
    let first = good(&model).scene;
    let once = back(&exported(&first, None)).scene;
    let twice = back(&exported(&once, None)).scene;
    let mut paths = [&first, &once].map(|scene| scene.nodes().iter().map(|node| node.path.clone()).collect::<Vec<_>>());
    paths[0].sort();
    paths[1].sort();
    assert_eq!(paths[0], paths[1]);
    assert_eq!(once.meshes().map(|meshes| meshes.meshes.len()), Some(2));
    assert_eq!(scene_to_json(&twice), scene_to_json(&once));
}

fn json_node(mesh: usize) -> Value {
    serde_json::json!({ "name": "box", "mesh": mesh, "translation": [2, 0, 0], "scale": [1, 2, 1] })
}

#[test]
fn a_file_of_ours_that_another_program_added_to_keeps_the_addition() {
    let scene = built_in_scene("two-robots").expect("it is built in");
    let mut file: Value = serde_json::from_str(&exported(&scene, None)).unwrap();
    let nodes = file["nodes"].as_array_mut().unwrap();
    nodes.push(serde_json::json!({ "name": "hat", "translation": [0, 1, 0] }));
    let added = nodes.len() - 1;
    let head = nodes.iter().position(|node| node["extras"]["inbetween"]["path"] == "robot1/head").unwrap();
    nodes[head]["children"].as_array_mut().unwrap().push(added.into());
    assert!(back(&file.to_string()).scene.find_rbt("robot1/head/hat").is_some());
}
