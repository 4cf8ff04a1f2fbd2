//! Keys at their own times: the cylinder's world matrix against one worked out by hand, and the clock that drives them.

mod common;

use std::path::PathBuf;
use std::sync::Arc;

use common::press;
use glam::{DAffine3, DQuat, DVec3, Vec3};
use inbetween::editor::Editor;
use inbetween::scene::{NodeKind, SceneGraph, built_in_scene, scene_from_json};

fn editor_of(scene: &str) -> Editor {
    Editor::new(Arc::new(built_in_scene(scene).unwrap()), PathBuf::from("animation.json"))
}

/// Turns by `degrees` about one axis.
fn turn(axis: DVec3, degrees: f64) -> DQuat {
    DQuat::from_axis_angle(axis, degrees.to_radians())
}

#[track_caller]
fn check_cylinder(seconds: f64, translation: [f64; 3], rotations: &[DQuat], scale: f64) {
    let scene = built_in_scene("cylinder").unwrap();
    let found = scene.world_from_node(scene.rest_pose(), seconds, scene.find("cylinder/cylinder").unwrap());
    let error = |rotation: &DQuat| {
        let expected =
            DAffine3::from_scale_rotation_translation(DVec3::splat(scale), *rotation, DVec3::from(translation));
        let found = found.to_cols_array();
        expected.to_cols_array().iter().zip(found).map(|(a, b)| (a - f64::from(b)).abs()).fold(0.0, f64::max)
    };
    assert!(rotations.iter().any(|rotation| error(rotation) < 1e-5), "at {seconds} s: {found:?}");
}

/// At 2 s: yaw 180, pitch 45, roll 90. As one rotation that is (x, y, z, w) below: qz(180) = (0, 0, 1, 0), qy(45) = (0, s, 0, c),
/// qx(90) = (h, 0, 0, h), with s = sin 22.5°, c = cos 22.5°, h = √½; their product is h (−s, c, c, s).
fn at_two_seconds() -> DQuat {
    let (s, c) = 22.5_f64.to_radians().sin_cos();
    let h = 0.5_f64.sqrt();
    DQuat::from_xyzw(-s * h, c * h, c * h, s * h)
}

/// At 3 s: yaw 180 and roll 180 are together half a turn about y.
fn at_three_seconds() -> DQuat {
    DQuat::from_xyzw(0.0, 1.0, 0.0, 0.0)
}

/// The fraction `alpha` of the way from one rotation to another, by the angle between them and the axis of the difference.
fn part_way(from: DQuat, to: DQuat, alpha: f64) -> DQuat {
    let difference = to * from.inverse();
    let difference = if difference.w < 0.0 { -difference } else { difference };
    let angle = 2.0 * difference.w.clamp(-1.0, 1.0).acos();
    let axis = DVec3::new(difference.x, difference.y, difference.z).normalize();
    DQuat::from_axis_angle(axis, angle * alpha) * from
}

#[test]
fn the_cylinder_is_where_it_is_worked_out_to_be() {
    check_cylinder(0.0, [0.0; 3], &[DQuat::IDENTITY], 1.0);
    check_cylinder(1.0, [0.5, 0.5, 0.0], &[part_way(DQuat::IDENTITY, at_two_seconds(), 0.5)], 0.75);
    check_cylinder(1.5, [0.75, 0.75, 0.0], &[part_way(DQuat::IDENTITY, at_two_seconds(), 0.75)], 0.625);
    check_cylinder(2.0, [1.0, 1.0, 0.0], &[at_two_seconds()], 0.5);
    check_cylinder(2.5, [0.75, 0.75, 0.0], &[part_way(at_two_seconds(), at_three_seconds(), 0.5)], 0.625);
    check_cylinder(3.5, [0.25, 0.25, 0.0], &[turn(DVec3::Y, 90.0), turn(DVec3::Y, -90.0)], 0.875);
    check_cylinder(4.0, [0.0; 3], &[DQuat::IDENTITY], 1.0);
    check_cylinder(9.0, [0.0; 3], &[DQuat::IDENTITY], 1.0);
}

#[test]
fn the_clock_runs_in_ticks_can_be_held_and_starts_again() {
    let mut editor = editor_of("cylinder");
    assert!(editor.wants_ticks() && editor.tick(90));
    assert_eq!(editor.seconds(), 1.5);
    press(&mut editor, "shift+home");
    assert!(!editor.wants_ticks() && !editor.tick(60));
    assert_eq!(editor.seconds(), 1.5);
    press(&mut editor, "shift+home");
    editor.tick(30);
    assert_eq!(editor.seconds(), 2.0);
    press(&mut editor, "home");
    assert_eq!(editor.seconds(), 0.0);
    editor.tick(240);
    assert!(!editor.wants_ticks(), "after the last key nothing moves");
}

#[test]
fn with_no_keys_the_clock_stands() {
    let mut editor = editor_of("two-robots");
    assert!(!editor.wants_ticks() && !editor.tick(60));
    assert_eq!(editor.seconds(), 0.0);
}

#[test]
fn the_keyframe_list_and_the_keys_are_independent() {
    let mut editor = editor_of("orbits");
    let planet = editor.scene().find_rbt("orrery/year2/planet2").expect("an RBT node below a control node");
    let pose_before = editor.displayed_pose();
    let before = editor.scene().world_from_rbt(&pose_before, editor.seconds(), planet).translation;
    editor.tick(300);
    assert_eq!(editor.displayed_pose(), pose_before);
    let after = editor.scene().world_from_rbt(&pose_before, editor.seconds(), planet).translation;
    assert!(before.distance(after) > 0.5);
}

#[test]
fn colours_are_keyed_in_linear_light() {
    let scene = scene(r##""shape": {"sphere": {"radius": 1}}, "colour_keys": [[0, "#000000"], [2, "#ffffff"]]"##);
    let NodeKind::Shape(placed) = &scene.node(scene.find("it").unwrap()).kind else { panic!() };
    assert_eq!(placed.colour_at(1.0), Vec3::splat(0.5));
    assert_eq!(placed.colour_at(7.0), Vec3::ONE);
}

fn text(node: &str) -> String {
    format!(
        r#"{{"format": "inbetween.scene", "version": 1, "name": "test", "eyes": ["sky"],
            "nodes": [{{"name": "sky"}}, {{"name": "it", {node}}}]}}"#
    )
}

fn scene(node: &str) -> SceneGraph {
    scene_from_json(&text(node)).unwrap()
}

#[track_caller]
fn refused(node: &str, words: &str) {
    let error = scene_from_json(&text(node)).unwrap_err().to_string();
    assert!(error.contains(words), "{error}");
}

#[test]
fn bad_keys_in_a_scene_file_are_refused_with_their_place() {
    refused(r#""control": {"translation": []}"#, "node \"it\": control.translation: there are no keys");
    refused(r#""control": {"scale": [[1, 2], [1, 3]]}"#, "node \"it\": control.scale: two keys are at 1 s");
    refused(r#""control": {"scale": [[1, 0]]}"#, "node \"it\": scale is");
    refused(r#""control": {"rotation": [[0, [1, 1, 1, 1]]]}"#, "node \"it\": rotation is of length 2");
    refused(r#""control": {"spin": []}"#, "unknown field \"spin\", expected translation, rotation or scale");
    refused(r#""control": {}, "shape": {"sphere": {"radius": 1}}"#, "cannot stand beside a shape");
    refused(
        r#""shape": {"sphere": {"radius": 1}}, "colour_keys": [[0, "red"]]"#,
        "found the text \"red\", expected a colour: \"#rrggbb\"",
    );
}
