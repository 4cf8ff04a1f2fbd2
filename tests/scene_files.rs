//! Scene files: what is written reads back to the same scene and the same bytes, and keyframe files fit scenes with more control nodes.

use glam::{Quat, Vec3};
use inbetween::colour::Colour;
use inbetween::interpolation::Interpolation;
use inbetween::keyframe::{keyframes_from_json, keyframes_to_json};
use inbetween::lighting::BuiltInLighting;
use inbetween::model::DEFAULT_ROUGHNESS;
use inbetween::scene::{
    Channel, KeyValue, NodeKind, SceneError, SceneGraph, built_in_scene, built_in_scene_names, scene_from_json,
    scene_to_json,
};
use proptest::prelude::*;

/// Written, read and written again: the same scene, the same bytes.
#[track_caller]
fn check_round_trip(scene: &SceneGraph) -> String {
    let text = scene_to_json(scene);
    let again = scene_from_json(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    assert!(again == *scene, "another scene:\n{text}");
    assert_eq!(scene_to_json(&again), text);
    text
}

fn two_robots() -> SceneGraph {
    built_in_scene("two-robots").unwrap()
}

#[test]
fn the_built_in_scenes_come_back() {
    for name in built_in_scene_names() {
        let text = check_round_trip(&built_in_scene(name).unwrap());
        let version = if name == "two-robots" { 3 } else { 1 };
        assert!(
            text.contains(&format!("\"version\": {version},")),
            "{name}: its version is the least that says it all"
        );
    }
}

#[test]
fn everything_that_a_file_can_say_comes_back() {
    let text = r##"{"format": "inbetween.scene", "version": 3, "name": "a \"b\"", "eyes": ["sky", "x/y"],
        "vertical_fov_degrees": 37.3, "nodes": [
        {"name": "sky", "rotation": {"euler_degrees": [10, 20, 30]}},
        {"name": "x", "translation": [-0, 0.1, 1e-7], "rotation": [0.1, 0.7, 0.1, 0.7], "reach": [0, -0.1, 1e-7], "stands": true,
         "limits": {"hinge": {"axis": [0, -2, 0.1], "degrees": [-7.5, 150]}}, "children": [
            {"name": "empty", "control": {}},
            {"name": "free", "control": {"scale": [[-2.5, 1], [0.1, [1, 2, 3]]], "rotation": [[0.3, [0.6, 0, 0, 0.8]]]},
             "in_paths": false, "children": [{"name": "y", "limits": {"hinge": {"axis": [1, 0, 0], "degrees": [0, 0]}}, "children": [
                {"name": "a", "shape": {"box": {"size": [1, 2, 3], "bevel": 0.25}}, "scale": 2},
                {"name": "b", "shape": {"plane": {"size": [4, 5]}}, "scale": [1, 1, 2], "colour": "#010203", "roughness": 0.25},
                {"name": "c", "shape": {"capsule": {"radius": 1, "height": 2}}, "rotation": {"euler_degrees": [0, 45, 0]},
                 "colour_keys": [[0.1, "#fedcba"], [1e5, "#000000"]], "roughness": 0, "metalness": -0.0},
                {"name": "d", "shape": {"cone": {"radius": 1, "height": 2}}, "translation": [0, 1, 0], "metalness": 1}]}]},
            {"name": "e", "shape": {"sphere": {"radius": 0.5}}}]}]}"##;
    let scene = scene_from_json(text).unwrap();
    let written = check_round_trip(&scene);
    assert!(written.contains("\"version\": 3,") && written.contains("\"in_paths\": false"));
    for (shape, roughness, metalness) in [("b", 0.25, 0.0), ("c", 0.0, 0.0), ("d", DEFAULT_ROUGHNESS, 1.0)] {
        let NodeKind::Shape(placed) = &scene.node(scene.find(&format!("x/y/{shape}")).unwrap()).kind else { panic!() };
        assert_eq!((placed.roughness(), placed.metalness()), (roughness, metalness), "{shape}");
    }
    assert_eq!(scene.rbt_paths().collect::<Vec<_>>(), ["sky", "x", "x/y"], "a path does not name what is not in paths");
    assert!(scene.find("x/free").is_some() && scene.find("x/free/y").is_none());
}

#[test]
fn a_new_control_node_moves_nothing_and_keyframe_files_still_fit() {
    let scene = two_robots();
    let file = std::fs::read("assets/animations/walk.json").unwrap();
    let before = keyframes_from_json(&file, &scene).unwrap();
    for path in ["sky", "robot1", "robot1/head", "robot2/left_hip/left_knee"] {
        let (with, control) = scene.with_control_above(scene.find(path).unwrap()).unwrap();
        check_round_trip(&with);
        assert!(with.rbt_paths().eq(scene.rbt_paths()));
        let after = keyframes_from_json(&file, &with).unwrap();
        assert_eq!(after, before);
        let list = after.into_parts().0;
        let bytes = |scene| keyframes_to_json(scene, &list, Interpolation::Linear, 500);
        assert_eq!(bytes(&with), bytes(&scene));
        let pose = &list.as_slice()[2].pose;
        for rbt in scene.rbt_indices() {
            assert_eq!(with.world_from_rbt(pose, 0.7, rbt), scene.world_from_rbt(pose, 0.7, rbt));
        }
        let id = with.find(&control).unwrap();
        assert_eq!(with.node(with.find(path).unwrap()).parent, Some(id));
        assert!(with.without_control(id).unwrap() == scene, "and without it all is as it was");
    }
}

#[test]
fn control_nodes_stand_above_shapes_and_control_nodes_and_have_names_of_their_own() {
    let scene = two_robots();
    let shape = scene
        .nodes()
        .iter()
        .find(|node| node.path.starts_with("robot1/") && scene.channels(scene.find(&node.path).unwrap()).len() == 1);
    let shape = scene.find(&shape.unwrap().path).unwrap();
    let (scene, over_shape) = scene.with_control_above(shape).unwrap();
    assert_eq!(scene.channels(scene.find(&over_shape).unwrap()).len(), 3);
    let robot = scene.find("robot1").unwrap();
    let (scene, first) = scene.with_control_above(robot).unwrap();
    let (scene, second) = scene.with_control_above(scene.find("robot1").unwrap()).unwrap();
    assert_eq!((first.as_str(), second.as_str()), ("robot1_control", "robot1_control2"));
    let (scene, third) = scene.with_control_above(scene.find(&first).unwrap()).unwrap();
    assert_eq!(third, "robot1_control_control");
    check_round_trip(&scene);
    let renamed = scene.with_control_renamed(scene.find(&first).unwrap(), "spin").unwrap();
    assert!(renamed.find("spin").is_some() && renamed.find("robot1/head").is_some());
    let taken = renamed.with_control_renamed(renamed.find("spin").unwrap(), "robot2");
    assert_eq!(taken.unwrap_err(), SceneError::DuplicatePath { path: "robot2".to_owned() });
    let refused = renamed.with_control_renamed(renamed.find("spin").unwrap(), "a/b").unwrap_err().to_string();
    assert!(refused.contains("a name is at least one character and has no \"/\""), "{refused}");
    let robot = renamed.without_control(renamed.find("robot2").unwrap()).unwrap_err().to_string();
    assert_eq!(robot, "node \"robot2\" is not a control node");
}

#[test]
fn a_control_node_that_paths_name_can_go_where_the_paths_stay_unique() {
    let orbits = built_in_scene("orbits").unwrap();
    let year = orbits.find("orrery/year2").unwrap();
    let without = orbits.without_control(year).unwrap();
    check_round_trip(&without);
    assert!(without.find("orrery/planet2").is_some() && !without.has_rbts_of(&orbits));
    assert_eq!(without.eyes(), orbits.eyes());
    let text = r#"{"format": "inbetween.scene", "version": 1, "name": "n", "eyes": ["sky"], "nodes": [{"name": "sky"},
        {"name": "c", "control": {}, "children": [{"name": "sky"}]}]}"#;
    let scene = scene_from_json(text).unwrap();
    let refused = scene.without_control(scene.find("c").unwrap()).unwrap_err();
    assert_eq!(refused, SceneError::DuplicatePath { path: "sky".to_owned() });
}

#[test]
fn what_no_file_could_hold_is_refused() {
    let (scene, path) = two_robots().with_control_above(two_robots().find("robot1").unwrap()).unwrap();
    let id = scene.find(&path).unwrap();
    for (seconds, value, words) in [
        (f64::NAN, KeyValue::Scale(Vec3::ONE), "at NaN s, expected a time"),
        (1e9, KeyValue::Scale(Vec3::ONE), "at 1000000000 s"),
        (0.0, KeyValue::Scale(Vec3::new(1.0, 0.0, 1.0)), "scale is [1, 0, 1], expected numbers above 0"),
        (0.0, KeyValue::Translation(Vec3::splat(f32::NAN)), "translation is"),
        (0.0, KeyValue::Rotation(Quat::from_xyzw(1.0, 1.0, 1.0, 1.0)), "rotation is of length 2"),
        (0.0, KeyValue::Colour(Colour::DEFAULT), "colour_keys are for shapes only"),
    ] {
        let refused = scene.with_key(id, seconds, value).unwrap_err().to_string();
        assert!(refused.contains(words), "{refused}");
    }
    let robot = scene.find("robot1").unwrap();
    let refused = scene.with_key(robot, 0.0, KeyValue::Scale(Vec3::ONE)).unwrap_err().to_string();
    assert_eq!(refused, "node \"robot1\": control.scale are for control nodes only: put one above it");
    let keyed = scene.with_key(id, 1.0, KeyValue::Scale(Vec3::ONE)).unwrap();
    assert!(keyed.with_keys_moved(id, Channel::Scale, &[1.0], 1e7).is_err());
}

#[test]
fn in_paths_is_for_control_nodes_of_version_2() {
    let text = |version: u32, node: &str| {
        format!(
            r#"{{"format": "inbetween.scene", "version": {version}, "name": "n", "eyes": ["sky"],
                "nodes": [{{"name": "sky"}}, {{"name": "x", {node}}}]}}"#
        )
    };
    let refused = |text: String| scene_from_json(&text).unwrap_err().to_string();
    let control = r#""control": {}, "in_paths": false"#;
    assert!(refused(text(1, control)).contains("in_paths needs version 2, and the file says version 1"));
    assert!(refused(text(2, r#""in_paths": false"#)).contains("in_paths is false, which is for control nodes only"));
    assert!(refused(text(4, control)).contains("version is 4, and this program reads versions 1 to 3"));
    let scene = scene_from_json(&text(3, control)).unwrap();
    assert!(scene_to_json(&scene).contains("\"version\": 2,"), "version 2 says it all");
}

#[test]
fn joints_and_finishes_are_for_their_nodes_of_version_3() {
    let scene = |version: u32, node: &str| {
        scene_from_json(&format!(
            r#"{{"format": "inbetween.scene", "version": {version}, "name": "n", "eyes": ["sky"],
                "nodes": [{{"name": "sky"}}, {{"name": "x", {node}}}]}}"#
        ))
    };
    let hinge = |hinge: &str| format!(r#""limits": {{"hinge": {{{hinge}}}}}"#);
    let all =
        format!(r#""reach": [1, 2, 3], "stands": true, {}"#, hinge(r#""axis": [0, -2, 0], "degrees": [-10, 150]"#));
    let read = scene(3, &all).unwrap();
    let joint = read.node(read.find("x").unwrap()).joint;
    assert_eq!(joint.reach, Some(Vec3::new(1.0, 2.0, 3.0)));
    let kept = joint.hinge.unwrap();
    assert!(joint.stands && kept.unit_axis().y == -1.0 && kept.range()[0] == f64::to_radians(-10.0));
    let (above, _) = read.with_control_above(read.find("x").unwrap()).unwrap();
    assert_eq!(above.node(above.find("x").unwrap()).joint, joint, "it stays with its node");
    for (version, node, words) in [
        (2, all.as_str(), "node \"x\": reach needs version 3, and the file says an older one"),
        (1, &hinge(r#""axis": [0, 1, 0], "degrees": [0, 1]"#), "node \"x\": limits needs version 3"),
        (3, r#""control": {}, "reach": [0, 0, 0]"#, "node \"x\": reach belongs to an RBT node"),
        (3, r#""shape": {"sphere": {"radius": 1}}, "stands": true"#, "node \"x\": stands belongs to an RBT node"),
        (3, r#""stands": false"#, "node \"x\": stands says how the end of a limb stands: give its end with reach"),
        (3, r#""reach": [0, 2e6, 0]"#, "node \"x\": reach is [0, 2000000, 0], expected coordinates between"),
        (3, &hinge(r#""axis": [0, 0, 0], "degrees": [0, 1]"#), "limits.hinge.axis is [0, 0, 0], expected a direction"),
        (3, &hinge(r#""axis": [1, 0, 0], "degrees": [1, 0]"#), "limits.hinge.degrees is [1, 0], expected two angles"),
        (
            3,
            &hinge(r#""axis": [1, 0, 0], "degrees": [0, 181]"#),
            "limits.hinge.degrees is [0, 181], expected two angles",
        ),
        (3, &hinge(r#""axis": [1, 0, 0]"#), "degrees is missing"),
        (3, r#""limits": {}"#, "hinge is missing"),
        (3, r#""limits": {"cone": 1}"#, "unknown field \"cone\""),
        (3, r#""reach": [0, 1]"#, "line 2"),
        (3, r#""roughness": 0.5"#, "node \"x\": roughness belongs to a shape"),
        (3, r#""shape": {"sphere": {"radius": 1}}, "roughness": 1.5"#, "roughness is 1.5, expected 0 to 1"),
        (3, r#""shape": {"sphere": {"radius": 1}}, "metalness": -0.1"#, "metalness is -0.1, expected 0 to 1"),
        (2, r#""shape": {"sphere": {"radius": 1}}, "metalness": 1"#, "node \"x\": metalness needs version 3"),
    ] {
        let refused = scene(version, node).unwrap_err().to_string();
        assert!(refused.contains(words), "{node}: {refused}");
    }
}

/// A scene with this lighting.
fn lit(version: u32, lighting: &str) -> Result<SceneGraph, SceneError> {
    scene_from_json(&format!(
        r#"{{"format": "inbetween.scene", "version": {version}, "name": "n", "eyes": ["sky"], "lighting": {lighting},
            "nodes": [{{"name": "sky"}}]}}"#
    ))
}

#[test]
fn a_lighting_comes_back_and_changes_what_it_says() {
    let evening = BuiltInLighting::Evening.lighting();
    let scene = lit(3, r#""evening""#).unwrap();
    assert_eq!(scene.lighting().lighting(), evening);
    assert!(check_round_trip(&scene).contains("\"version\": 3,\n  \"name\": \"n\",\n  \"eyes\": [\"sky\"],\n  \"vertical_fov_degrees\": 60,\n  \"lighting\": \"evening\",\n"));
    let day = lit(3, r#"{"sun": {}, "sky": {}}"#).unwrap();
    assert!(check_round_trip(&day).contains("\"version\": 1,"), "the day needs no words");
    assert_eq!(lit(3, r#""day""#).unwrap(), day);
    let own = lit(
        3,
        r##"{"of": "evening", "sun": {"direction": [-3, 4, 0], "brightness": 0.5, "degrees": 2.5}, "sky": {"ground": "#404040"}}"##,
    )
    .unwrap();
    check_round_trip(&own);
    let light = own.lighting().lighting();
    assert!((light.towards_sun_in_world - Vec3::new(-0.6, 0.8, 0.0)).length() < 1e-6);
    assert!((light.sun - evening.sun * 0.5).length() < 1e-6);
    assert_eq!((light.sun_degrees, light.horizon, light.sky), (2.5, evening.horizon, evening.sky));
    assert_eq!(light.ground, Colour::from_hex("#404040").unwrap().to_linear());
    for short in ["[0, 1e-30, 0]", "[1e6, 1e6, -1e6]"] {
        let scene = lit(3, &format!(r#"{{"sun": {{"direction": {short}}}}}"#)).unwrap();
        assert!(scene.lighting().lighting().towards_sun_in_world.is_normalized(), "{short}");
    }
    let full =
        r##"{"sun": {"colour": "#ffffff", "brightness": 0}, "sky": {"horizon": "#102030", "zenith": "#000000"}}"##;
    let full = lit(3, full).unwrap();
    check_round_trip(&full);
    assert_eq!(full.lighting().lighting().sun, Vec3::ZERO);
    let (above, _) = full.with_control_above(full.find("sky").unwrap()).unwrap();
    assert_eq!(above.lighting(), full.lighting(), "it stays when nodes change");
}

#[test]
fn a_lighting_that_cannot_be_is_refused_with_its_place() {
    for (version, lighting, words) in [
        (2, r#""evening""#, "lighting needs version 3, and the file says an older one"),
        (3, r#""noon""#, "lighting is \"noon\", expected day, evening or studio"),
        (3, r#"{"of": "noon"}"#, "lighting.of is \"noon\", expected day, evening or studio"),
        (3, r#"{"sun": {"direction": [0, 0, 0]}}"#, "lighting.sun.direction is [0, 0, 0], expected a direction"),
        (3, r#"{"sun": {"direction": [1, -0.1, 0]}}"#, "lighting.sun.direction is [1, -0.1, 0], expected a direction"),
        (3, r#"{"sun": {"direction": [0, 2e6, 0]}}"#, "lighting.sun.direction is [0, 2000000, 0]"),
        (3, r#"{"sun": {"brightness": -1}}"#, "lighting.sun.brightness is -1, expected 0 to 10"),
        (3, r#"{"sun": {"degrees": 91}}"#, "lighting.sun.degrees is 91, expected 0 to 90"),
        (3, r#"{"sky": {"zenith": "blue"}}"#, "expected a colour"),
        (3, r#"{"moon": {}}"#, "unknown field \"moon\""),
        (3, "3", "expected a lighting: \"day\""),
    ] {
        let refused = lit(version, lighting).unwrap_err().to_string();
        assert!(refused.contains(words), "{lighting}: {refused}");
    }
}

proptest! {
    #[test]
    fn keys_of_any_value_come_back(
        times in prop::collection::vec(-1e5f64..1e5, 1..8), x in prop::num::f32::NORMAL, angle in -10.0f32..10.0,
        scale in 1e-6f32..1e6, colour in any::<[u8; 3]>(),
    ) {
        let (mut scene, path) = two_robots().with_control_above(two_robots().find("robot1").unwrap()).unwrap();
        let id = scene.find(&path).unwrap();
        let shape = scene.nodes_with_ids().find(|(id, _)| scene.channels(*id) == [Channel::Colour]).unwrap().0;
        for seconds in times {
            let translation = KeyValue::Translation(Vec3::new(x % 1e6, 0.1, -0.0));
            let axis = Vec3::new(angle, 1.0, scale).normalize();
            for value in [translation, KeyValue::Rotation(Quat::from_axis_angle(axis, angle)), KeyValue::Scale(Vec3::new(scale, 1.0, 2.0))] {
                scene = scene.with_key(id, seconds, value).unwrap();
            }
            scene = scene.with_key(shape, seconds, KeyValue::Colour(Colour::from_bytes(colour))).unwrap();
        }
        let text = scene_to_json(&scene);
        prop_assert!(!text.contains("-0,") && !text.contains("-0]"));
        let again = scene_from_json(&text).unwrap();
        prop_assert!(again == scene);
        prop_assert_eq!(scene_to_json(&again), text);
    }
}
