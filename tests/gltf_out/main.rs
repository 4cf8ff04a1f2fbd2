//! Scenes and animations as glTF: read back by a player of its own, and compared with what the program plays.

mod meshes;
mod player;

use glam::{DMat4, DVec3, Quat, Vec3};
use inbetween::export::FrameTime;
use inbetween::gltf::json;
use inbetween::interchange::gltf_out::{Curves, Export, Report, Tolerance};
use inbetween::interpolation::Interpolation;
use inbetween::keyframe::{Animation, Easing, Keyframe, KeyframeList, PlayRange, keyframes_from_json};
use inbetween::pose::{Pose, RbtIndex};
use inbetween::rbt::Rbt;
use inbetween::scene::{
    BUILT_IN_ANIMATIONS, NodeKind, SceneGraph, built_in_scene, built_in_scene_names, scene_from_json,
};
use serde_json::{Value, json};

use player::{Blend, Player};

/// What single precision adds to an error, in degrees and in units.
const SLACK: (f64, f64) = (2e-4, 4e-6);
/// Blender makes one key of two that are closer than 1/100 of its 24 frames a second.
const BLENDER_MERGES: f64 = 0.01 / 24.0;

fn known(name: &str, scene: &SceneGraph) -> Animation {
    let known = BUILT_IN_ANIMATIONS.iter().find(|known| known.name == name).unwrap();
    Animation::of(keyframes_from_json(known.text.as_bytes(), scene).unwrap(), None)
}

fn strip(value: &mut Value) {
    match value {
        Value::Object(fields) => {
            fields.remove("extras");
            fields.values_mut().for_each(strip);
        }
        Value::Array(items) => items.iter_mut().for_each(strip),
        _ => {}
    }
}

/// The file without what programs may drop.
fn without_extras(file: &[u8]) -> Player {
    let container = inbetween::gltf::Container::of(file).unwrap();
    let mut root: Value = serde_json::from_slice(container.json).unwrap();
    strip(&mut root);
    Player::new(serde_json::from_value(root).unwrap(), container.binary.unwrap_or_default())
}

/// The largest angle in degrees between the axes of two matrices, and the distance of their origins.
fn off(a: DMat4, b: DMat4) -> (f64, f64) {
    let axis = |matrix: DMat4, axis| matrix.col(axis).truncate().normalize();
    let angle = (0..3).map(|at| 2.0 * (0.5 * axis(a, at).distance(axis(b, at))).min(1.0).asin()).fold(0.0, f64::max);
    (angle.to_degrees(), a.w_axis.distance(b.w_axis))
}

/// The largest errors of a file at many times. `jumps` are times around which it may be anything.
fn worst(player: &Player, scene: &SceneGraph, animation: Option<&Animation>, jumps: &[f64]) -> (f64, f64) {
    let range = animation.map(|animation| PlayRange::new(&animation.keyframes).unwrap());
    let end = animation.zip(range.as_ref()).map_or(0.0, |(animation, range)| {
        FrameTime::at_key_time(range.last_key_time() as f64, animation.ms_between_keyframes, range.timing()).ms / 1000.0
    });
    let last = end.max(scene.last_second().unwrap_or(0.0));
    let written: Vec<usize> = (0..scene.nodes().len()).filter(|&node| is_written(player, scene, node)).collect();
    let mut worst = (0.0_f64, 0.0_f64);
    for step in 0..=389 {
        let seconds = last * f64::from(step) / 389.0;
        if jumps.iter().any(|jump| (seconds - jump).abs() < 1.1e-3) {
            continue;
        }
        let pose = animation.zip(range.as_ref()).map_or_else(
            || scene.rest_pose().clone(),
            |(animation, range)| {
                let elapsed = num_rational::BigRational::from_float(
                    seconds.min(end) * 1000.0 / f64::from(animation.ms_between_keyframes),
                );
                let key_time = range.timing().key_time_at(&elapsed.unwrap());
                range.pose_at(key_time, animation.interpolation).unwrap()
            },
        );
        let played = scene.world_from_nodes(&pose, seconds);
        for blend in [Blend::Slerp, Blend::Components] {
            for (shown, &node) in player.world(seconds, blend).into_iter().zip(&written) {
                let played = glam::Mat4::from(played[node].get()).as_dmat4();
                let (turned, moved) = off(shown, played);
                worst = (worst.0.max(turned), worst.1.max(moved));
            }
        }
    }
    worst
}

fn is_written(player: &Player, scene: &SceneGraph, node: usize) -> bool {
    !matches!(scene.nodes()[node].kind, NodeKind::Shape(_)) || player.root.nodes.len() == scene.nodes().len()
}

#[track_caller]
fn assert_within(found: (f64, f64), tolerance: Tolerance) {
    let bound = (tolerance.degrees + SLACK.0, tolerance.units + SLACK.1);
    assert!(found.0 <= bound.0 && found.1 <= bound.1, "{found:?}, and at most {bound:?}");
}

fn exported(export: Export<'_>) -> (Vec<u8>, Report) {
    let (file, report) = export.glb();
    assert_eq!(file, export.glb().0, "the same export makes the same bytes");
    (file, report)
}

#[test]
fn every_scene_and_animation_plays_within_the_tolerance() {
    for known_animation in BUILT_IN_ANIMATIONS {
        let scene = built_in_scene(known_animation.scene).unwrap();
        let animation = known(known_animation.name, &scene);
        let export = Export { animation: Some((&animation, known_animation.name)), ..Export::of(&scene) };
        let (file, report) = export.glb();
        let exactness = report.exactness.clone().unwrap();
        assert!(exactness.is_within(), "{}: {exactness:?}", known_animation.name);
        let found = worst(&without_extras(&file), &scene, Some(&animation), &[]);
        assert_within(found, export.tolerance);
        let said = Tolerance { degrees: exactness.turned.off * 1.1, units: exactness.moved.off * 1.1 };
        assert_within(found, said);
    }
}

#[test]
fn coarse_cubic_and_frames_are_as_exact_as_they_say() {
    let scene = built_in_scene("two-robots").unwrap();
    let animation = known("walk", &scene);
    let export = Export { animation: Some((&animation, "walk")), has_meshes: false, ..Export::of(&scene) };
    let fine = export.glb().1;
    let tolerance = Tolerance { degrees: 1.0, units: 0.1 };
    let (file, coarse) = exported(Export { tolerance, ..export });
    assert_within(worst(&Player::of(&file), &scene, Some(&animation), &[]), tolerance);
    assert!(coarse.keys * 4 < fine.keys, "{} and {}", coarse.keys, fine.keys);
    let (file, cubic) = exported(Export { curves: Curves::Cubic, ..export });
    assert_within(worst(&Player::of(&file), &scene, Some(&animation), &[]), export.tolerance);
    assert!(cubic.keys * 10 < fine.keys, "{} and {}", cubic.keys, fine.keys);
    let (file, frames) = exported(Export { frames_per_second: Some(30), ..export });
    let player = Player::of(&file);
    let exactness = frames.exactness.unwrap();
    let said = Tolerance { degrees: exactness.turned.off * 1.1, units: exactness.moved.off * 1.1 };
    let found = worst(&player, &scene, Some(&animation), &[]);
    assert_within(found, said);
    assert!(found.0 > 0.1, "30 frames a second are coarse: {found:?}");
    let head = (0..player.root.nodes.len()).find(|&node| player.names(node) == "robot1/head").unwrap();
    let times = player.times(head, "rotation");
    assert_eq!(times.len(), 121, "a key for each frame, the last one at the end");
    assert!(times.iter().enumerate().all(|(frame, time)| (time - frame as f64 / 30.0).abs() < 1e-6));
}

/// A chain of two nodes with a shape, of which the second is 2 units away.
fn chain() -> SceneGraph {
    let text = r##"{"format": "inbetween.scene", "version": 3, "name": "chain", "eyes": ["eye"], "vertical_fov_degrees": 50, "nodes": [
        {"name": "eye", "translation": [0, 1, 8]},
        {"name": "a", "reach": [0, 1, 0], "stands": true, "limits": {"hinge": {"axis": [1, 0, 0], "degrees": [-90, 10]}}, "children": [
            {"name": "stretch", "in_paths": false, "control": {"scale": [[0, [1, 2, 1]]]}, "children": [
                {"name": "b", "translation": [2, 0, 0], "children": [
                    {"name": "tip", "shape": {"cone": {"radius": 0.5, "height": 1}}, "colour": "#102030", "translation": [0, 1, 0], "scale": [1, 1, 0.5]},
                    {"name": "same", "shape": {"cone": {"radius": 0.5, "height": 1}}, "colour": "#102030"}]}]}]},
        {"name": "wheel", "control": {"translation": [[-1, [0, 0, 0]], [3, [4, 0, 0]]],
            "rotation": [[0.5, {"euler_degrees": [0, 0, 0]}], [2, {"euler_degrees": [170, 20, 0]}]]}, "children": [
            {"name": "rim", "shape": {"sphere": {"radius": 1}}, "colour_keys": [[0, "#ff0000"], [1, "#00ff00"]]}]}]}"##;
    scene_from_json(text).unwrap_or_else(|problem| panic!("{problem:?}"))
}

fn turning(easings: &[Easing], durations: &[f64], interpolation: Interpolation) -> Animation {
    let keyframe = |index: usize| {
        let turn = |by: f32| Quat::from_axis_angle(Vec3::new(1.0, by, -0.5).normalize(), 0.8 * by * index as f32);
        let eye = Rbt::new(Vec3::new(0.0, 1.0, 8.0), Quat::IDENTITY);
        let a = Rbt::new(Vec3::new(index as f32, 0.0, 0.0), turn(1.0));
        let b = Rbt::new(Vec3::new(2.0, 0.0, 0.0), turn(-1.3));
        Keyframe {
            easing: easings[index % easings.len()],
            duration: durations[index % durations.len()],
            ..Keyframe::new(Pose::new(vec![eye, a, b]))
        }
    };
    Animation { keyframes: KeyframeList::new((0..7).map(keyframe).collect()), interpolation, ms_between_keyframes: 500 }
}

/// The shortest time between two keys of a channel, in seconds.
fn shortest_step(player: &Player) -> f64 {
    let channels = (0..player.root.nodes.len())
        .flat_map(|node| ["translation", "rotation", "scale"].map(|property| player.times(node, property)));
    let steps = channels.flat_map(|times| times.windows(2).map(|pair| pair[1] - pair[0]).collect::<Vec<f64>>());
    steps.fold(f64::INFINITY, f64::min)
}

/// A violent motion, as it is at the end of `elastic` in a tenth of a second.
#[test]
fn keys_are_never_so_near_that_blender_makes_one_of_them() {
    let scene = chain();
    let easings = ["bounce-out", "elastic-out", "elastic-in-out"].map(|name| Easing::from_name(name).unwrap());
    let mut animation = turning(&easings, &[1.0, 0.4, 2.5], Interpolation::CatmullRom);
    animation.ms_between_keyframes = 40;
    for frames_per_second in [None, Some(1000), Some(37)] {
        let export = Export { animation: Some((&animation, "a")), frames_per_second, ..Export::of(&scene) };
        let shortest = shortest_step(&Player::of(&exported(export).0));
        assert!(shortest > BLENDER_MERGES, "{frames_per_second:?}: {shortest}");
    }
}

#[test]
fn a_jump_of_timed_keys_takes_the_shortest_step() {
    let text = r#"{"format": "inbetween.scene", "version": 3, "name": "steps", "eyes": ["eye"], "vertical_fov_degrees": 50, "nodes": [
        {"name": "eye"}, {"name": "steps", "control": {"translation":
            [[0, [0, 0, 0]], [0.999999, [0, 0, 0]], [1, [1, 0, 0]], [1.9999999, [1, 0, 0]], [2, [2, 0, 0]]]}}]}"#;
    let scene = scene_from_json(text).unwrap();
    let (file, report) = exported(Export::of(&scene));
    assert!(report.exactness.is_some_and(|exactness| exactness.is_within()), "a jump is not measured");
    let player = Player::of(&file);
    let node = player.root.nodes.iter().position(|node| node.name.as_deref() == Some("steps")).unwrap();
    let times = player.times(node, "translation");
    assert_eq!([times[0], times[2], times[4]], [0.0, 1.0, 2.0]);
    assert!(shortest_step(&player) > BLENDER_MERGES && times[2] - times[1] < 1e-3, "{times:?}");
    assert_eq!(player.pose(1.5, Blend::Slerp)[node].0, DVec3::X);
}

#[test]
fn easings_durations_scales_and_timed_keys_are_in_the_motion() {
    let scene = chain();
    let all: Vec<Easing> = Easing::all().collect();
    for interpolation in Interpolation::ALL {
        for easings in all.chunks(4) {
            let animation = turning(easings, &[1.0, 0.4, 2.5], interpolation);
            // Where an interval begins or ends: some easings jump there.
            let range = PlayRange::new(&animation.keyframes).unwrap();
            let jumps: Vec<f64> = (0..=range.last_key_time())
                .map(|key_time| FrameTime::at_key_time(key_time as f64, 500, range.timing()).ms / 1000.0)
                .collect();
            for curves in [Curves::Linear, Curves::Cubic] {
                let tolerance = Tolerance { degrees: 0.05, units: 0.002 };
                let export = Export { animation: Some((&animation, "a")), curves, tolerance, ..Export::of(&scene) };
                let (file, report) = export.glb();
                assert!(report.exactness.as_ref().unwrap().is_within(), "{easings:?} {curves:?} {report:?}");
                let player = without_extras(&file);
                assert_within(worst(&player, &scene, Some(&animation), &jumps), tolerance);
                assert!(shortest_step(&player) > BLENDER_MERGES, "{easings:?} {curves:?}: {}", shortest_step(&player));
            }
        }
    }
}

#[test]
fn keyframes_are_keys_with_their_poses_and_what_rests_has_no_channel() {
    let scene = chain();
    let animation = turning(&[Easing::Linear, Easing::Hold], &[1.0], Interpolation::CatmullRom);
    let (file, report) = exported(Export { animation: Some((&animation, "spin")), ..Export::of(&scene) });
    let player = Player::of(&file);
    let node = |name: &str| player.root.nodes.iter().position(|node| node.name.as_deref() == Some(name)).unwrap();
    assert!(player.times(node("eye"), "rotation").is_empty() && player.times(node("eye"), "translation").is_empty());
    assert!(player.times(node("b"), "translation").is_empty(), "it stays where the node has it");
    assert!(player.times(node("stretch"), "scale").is_empty(), "a scale with one key is the node's own");
    for (played, seconds) in [0.0, 0.5, 1.0, 1.5, 2.0].into_iter().enumerate() {
        for (rbt, name) in [(1, "a"), (2, "b")] {
            let expected = animation.keyframes.as_slice()[played + 1].pose.get(RbtIndex::new(rbt)).rotation;
            let found = Quat::from_vec4(player.key(node(name), "rotation", seconds).unwrap().as_vec4());
            assert!(found == expected || found == -expected, "{name} at {seconds}: {found} and {expected}");
        }
    }
    // The easing of keyframe 1 is `hold`: nothing moves until just before keyframe 2.
    let held: Vec<f64> = player.times(node("a"), "rotation").iter().copied().filter(|time| *time <= 0.5).collect();
    assert_eq!(held.len(), 3, "{held:?}");
    assert!(0.5 - held[1] <= 1.0 / 1024.0, "{held:?}");
    // A jump does not swing beyond its end, with tangents either.
    for curves in [Curves::Linear, Curves::Cubic] {
        let export = Export { animation: Some((&animation, "spin")), curves, ..Export::of(&scene) };
        let player = Player::of(&exported(export).0);
        for before in [1e-7, 1e-4, 2.5e-4] {
            let [held, jumping, next] = [0.4, 0.5 - before, 0.5].map(|at| player.pose(at, Blend::Slerp)[node("a")].1);
            let (whole, part) = (held.angle_between(next), jumping.angle_between(next));
            assert!(part <= whole * (before * 2304.0).powf(0.5) + 1e-6, "{curves:?} {before}: {part} of {whole}");
        }
    }
    // Keys before 0 s are cut off there, and later ones go on.
    assert_eq!(player.times(node("wheel"), "translation"), [0.0, 3.0]);
    assert_eq!(player.pose(0.0, Blend::Slerp)[node("wheel")].0, DVec3::X);
    assert_eq!(player.root.animations[0].name.as_deref(), Some("spin"));
    assert_eq!(report.colours_left_out, ["wheel/rim"]);
    assert_eq!(report.nodes, scene.nodes().len());
}

#[test]
fn names_paths_and_kinds_come_with_the_nodes() {
    let scene = chain();
    let animation = turning(&[Easing::Linear, Easing::Hold], &[1.0, 0.5], Interpolation::CatmullRom);
    let player = Player::of(&exported(Export { animation: Some((&animation, "spin")), ..Export::of(&scene) }).0);
    let own = |extras: &Option<Value>| extras.as_ref().unwrap()["inbetween"].clone();
    for (written, node) in player.root.nodes.iter().zip(scene.nodes()) {
        assert_eq!((written.name.as_deref(), &own(&written.extras)["path"]), (Some(&*node.name), &json!(node.path)));
    }
    let of =
        |name: &str| own(&player.root.nodes.iter().find(|node| node.name.as_deref() == Some(name)).unwrap().extras);
    assert_eq!(
        of("a"),
        json!({"path": "a", "kind": "rbt", "reach": [0, 1, 0], "stands": true,
            "limits": {"hinge": {"axis": [1, 0, 0], "degrees": [-90, 10]}}})
    );
    assert_eq!(of("stretch"), json!({"path": "a/stretch", "kind": "control", "in_paths": false}));
    assert_eq!(
        of("tip"),
        json!({"path": "a/b/tip", "kind": "shape", "shape": {"cone": {"radius": 0.5, "height": 1}}, "colour": "#102030"})
    );
    let of_scene = own(&player.root.scenes[0].extras);
    assert_eq!(of_scene, json!({"name": "chain", "eyes": ["eye"], "vertical_fov_degrees": 50.0}));
    let pace = own(&player.root.animations[0].extras);
    assert_eq!(pace["durations"], json!([0.5, 1.0, 0.5, 1.0]));
    assert_eq!(pace["easings"], json!(["hold", "linear", "hold", "linear"]));
    assert_eq!((&pace["interpolation"], &pace["ms_between_keyframes"]), (&json!("catmull-rom"), &json!(500)));
    let eye = &player.root.nodes[0];
    let camera = player.root.cameras[eye.camera.unwrap()].perspective.clone().unwrap();
    assert!((camera.yfov.to_degrees() - 50.0).abs() < 1e-4);
    let mesh = |name: &str| player.root.nodes.iter().find(|node| node.name.as_deref() == Some(name)).unwrap().mesh;
    assert_eq!(mesh("tip"), mesh("same"), "equal shapes share a mesh");
    assert_ne!(mesh("tip"), mesh("rim"));
}

#[test]
fn scenes_without_keyframes_and_without_meshes() {
    for name in built_in_scene_names() {
        let scene = built_in_scene(name).unwrap();
        let (file, report) = exported(Export::of(&scene));
        let player = without_extras(&file);
        assert_eq!(player.root.nodes.len(), scene.nodes().len());
        assert_eq!(report.exactness.is_some(), scene.is_timed(), "{name}");
        assert_within(worst(&player, &scene, None, &[]), Tolerance::default());
        let (file, report) = exported(Export { has_meshes: false, ..Export::of(&scene) });
        let root = Player::of(&file).root;
        assert!(root.meshes.is_empty() && root.materials.is_empty());
        assert_eq!(root.nodes.len() + report.shapes_left_out, scene.nodes().len());
        let text = Export::of(&scene).gltf().0;
        let root: json::Root = serde_json::from_str(&text).unwrap();
        assert!(root.buffers[0].uri.as_ref().unwrap().starts_with("data:application/octet-stream;base64,"));
    }
}

#[test]
fn a_bound_that_single_precision_cannot_meet_is_said() {
    let scene = chain();
    let animation = turning(&[Easing::Linear], &[1.0], Interpolation::CatmullRom);
    let tolerance = Tolerance { degrees: 1e-9, units: 1e-12 };
    let (_, report) =
        Export { animation: Some((&animation, "a")), curves: Curves::Cubic, tolerance, ..Export::of(&scene) }.glb();
    assert!(!report.exactness.as_ref().unwrap().is_within());
    let warnings: Vec<String> = report.warnings().iter().map(ToString::to_string).collect();
    assert_eq!(warnings[0], "no keys were found that stay within 0.000000001 degrees and 0.000000000001 units");
}
