//! Scales and matrices of nodes.

use glam::{Quat, Vec3};
use inbetween::scene::Channel;
use serde_json::json;

use super::importing::{Imported, good, import, in_world, keys, named, paths, refused, rest, turned};
use super::make::Model;

#[test]
fn a_scale_is_a_control_node_that_is_not_in_paths() {
    let mut model = Model::new();
    let child =
        model.push("nodes", json!({ "name": "child", "translation": [1, 0, 0], "rotation": turned(Vec3::Z, 45.0) }));
    model.root(json!({ "name": "top", "translation": [0, 1, 0], "scale": [2, 1, 3], "children": [child] }));
    let scene = good(&model).scene;
    assert_eq!(paths(&scene), ["top", "top/scale", "top/child"]);
    assert_eq!(in_world(&scene, "top/child", Vec3::ZERO), Vec3::new(2.0, 1.0, 0.0));
    let half = std::f32::consts::FRAC_1_SQRT_2;
    assert!(in_world(&scene, "top/child", Vec3::X).distance(Vec3::new(2.0 + 2.0 * half, 1.0 + half, 0.0)) < 1e-5);
}

#[test]
fn a_matrix_is_taken_apart_unless_its_axes_are_skewed() {
    let mut model = Model::new();
    let child = model.push("nodes", json!({ "name": "child" }));
    // A quarter turn about y, scaled by 2, moved by 5.
    let matrix = [0, 0, -2, 0, 0, 2, 0, 0, 2, 0, 0, 0, 5, 0, 0, 1];
    model.root(json!({ "name": "top", "matrix": matrix, "children": [child] }));
    let scene = good(&model).scene;
    let top = rest(&scene, "top");
    assert_eq!(top.translation, Vec3::new(5.0, 0.0, 0.0));
    assert!((top.rotation * Vec3::X).distance(Vec3::NEG_Z) < 1e-6);
    assert!(in_world(&scene, "top/child", Vec3::X).distance(Vec3::new(5.0, 0.0, -2.0)) < 1e-5);
    model.json["nodes"][1]["matrix"] = json!([1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
    refused(
        &model,
        "/nodes/1: the matrix of “top” has axes that are not at right angles, and other nodes are below it: no rotation and scale can \
         say that. Apply the transforms in the program that made the file",
    );
}

#[test]
fn mirrors_keep_every_place_in_the_world() {
    for scale in [[-1.0, 1.0, 1.0], [1.0, -2.0, -1.0], [-1.0, -1.0, -2.0], [-1.0, 1.0, -1.0]] {
        let mut model = Model::new();
        let leaf = model.push("nodes", json!({ "name": "leaf", "translation": [1, 2, 3], "scale": [1, 1, -1] }));
        let middle = json!({
            "name": "middle", "translation": [3, 1, 2], "rotation": turned(Vec3::new(0.6, 0.0, 0.8), 50.0), "children": [leaf],
        });
        let middle = model.push("nodes", middle);
        let top = json!({
            "name": "top", "translation": [1, 0, 0], "rotation": turned(Vec3::Y, 30.0), "scale": scale, "children": [middle],
        });
        model.root(top);
        let scene = good(&model).scene;
        let (scale, turn) = (Vec3::from(scale), Quat::from_array(turned(Vec3::Y, 30.0)));
        let inner = Quat::from_array(turned(Vec3::new(0.6, 0.0, 0.8), 50.0));
        let middle = Vec3::X + turn * (scale * Vec3::new(3.0, 1.0, 2.0));
        let leaf = Vec3::X + turn * (scale * (Vec3::new(3.0, 1.0, 2.0) + inner * Vec3::new(1.0, 2.0, 3.0)));
        assert!(in_world(&scene, "top/middle", Vec3::ZERO).distance(middle) < 1e-4, "{scale}");
        assert!(in_world(&scene, "top/middle/leaf", Vec3::ZERO).distance(leaf) < 1e-4, "{scale}");
    }
}

#[test]
fn an_animated_scale_is_timed_keys() {
    let mut model = Model::new();
    let child = model.push("nodes", json!({ "name": "child", "translation": [1, 0, 0] }));
    let top = model.root(json!({ "name": "top", "children": [child] }));
    model.animation(
        "grow",
        &[
            (top, "scale", &[1.0, 3.0], &[1.0, 1.0, 1.0, 3.0, 2.0, 1.0], "LINEAR"),
            (child, "scale", &[1.0, 3.0], &[2.0, 2.0, 2.0, 2.0, 2.0, 2.0], "LINEAR"),
            (child, "translation", &[1.0, 3.0], &[1.0, 0.0, 0.0, 2.0, 0.0, 0.0], "LINEAR"),
        ],
    );
    let Imported { scene, animation, report } = good(&model);
    assert!(animation.is_some());
    assert_eq!(keys(&scene, "top/scale", Channel::Scale), [(0.0, [1.0, 1.0, 1.0, 0.0]), (2.0, [3.0, 2.0, 1.0, 0.0])]);
    let sentence = "the scale of “top” moves: it becomes timed keys, which play in seconds and not with the keyframes";
    assert_eq!(report.iter().filter(|line| line.contains("scale")).count(), 1);
    assert!(report.iter().any(|line| *line == sentence));
    model.animation("mirror", &[(top, "scale", &[0.0, 1.0], &[1.0, 1.0, 1.0, -1.0, 1.0, 1.0], "LINEAR")]);
    assert_eq!(
        import(&model, &named("mirror")).unwrap_err(),
        "/animations/1/channels/0: the scale of “top” turns its sign in the animation, and a scene's scales are above 0",
    );
}

#[test]
fn a_model_of_another_size_is_scaled_by_a_power_of_ten() {
    let mut model = Model::new();
    let head = model.push("nodes", json!({ "name": "head", "translation": [0, 180, 0] }));
    model.root(json!({ "name": "hips", "translation": [0, 10, 0], "children": [head] }));
    let Imported { scene, report, .. } = good(&model);
    assert_eq!(scene.rbt_paths().collect::<Vec<_>>(), ["sky", "ground", "hips", "hips/head"]);
    assert!(in_world(&scene, "hips/head", Vec3::ZERO).distance(Vec3::new(0.0, 1.9, 0.0)) < 1e-5);
    assert_eq!(report[1], "the model is 180.00 units large: a control node above it scales it by 0.01");
    assert!((in_world(&scene, "ground/plane", Vec3::ZERO).y - 0.1).abs() < 1e-5);
}

/// A chain of so many nodes of one scale, each at the origin, and what is made of it.
fn chain(length: usize, scale: [f32; 3]) -> Imported {
    let mut model = Model::new();
    let mut below = model.push("nodes", json!({ "name": "end", "translation": [1, 0, 0] }));
    for number in 1..length {
        below = model.push("nodes", json!({ "name": format!("n{number}"), "scale": scale, "children": [below] }));
    }
    model.root(json!({ "name": "n0", "scale": scale, "children": [below] }));
    good(&model)
}

#[test]
fn a_scale_that_is_rounding_away_from_1_is_1() {
    let one = chain(2, [1.000_000_1, 0.999_998, 1.0]);
    assert_eq!(paths(&one.scene), ["n0", "n0/n1", "n0/n1/end"]);
    assert_eq!(one.report.len(), 1, "rounding is not worth a sentence: {:?}", one.report);
    // What adds up is said.
    let many = chain(50, [1.000_009; 3]);
    assert!(!paths(&many.scene).iter().any(|path| path.contains("scale")));
    let sentence = "scales within 0.00001 of 1 are taken as 1; together they move no point by more than 0.000447 units";
    assert_eq!(many.report[1], sentence);
    // A scale of which one factor is more than rounding stays what it is.
    let other = chain(1, [1.000_02, 1.000_001, 1.0]);
    assert_eq!(paths(&other.scene), ["n0", "n0/scale", "n0/end"]);
    assert_eq!(keys(&other.scene, "n0/scale", Channel::Scale), [(0.0, [1.000_02, 1.000_001, 1.0, 0.0])]);
}

#[test]
fn an_animated_scale_that_stays_within_rounding_is_1() {
    let mut model = Model::new();
    let child = model.push("nodes", json!({ "name": "child", "translation": [1, 0, 0] }));
    let top = model.root(json!({ "name": "top", "scale": [2, 2, 2], "children": [child] }));
    model.animation("all", &[(top, "scale", &[0.0, 1.0], &[1.0, 1.000_001, 1.0, 1.0, 1.0, 0.999_999], "LINEAR")]);
    let Imported { scene, report, .. } = good(&model);
    assert_eq!((paths(&scene), report.len()), (vec!["top", "top/child"], 1));
}
