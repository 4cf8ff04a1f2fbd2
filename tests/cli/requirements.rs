//! Requirements of rubrics that need no reference: each met, not met, and at its bound.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use serde_json::{Value, json};

use crate::grade::{follows, item};
use crate::sandbox::Sandbox;

const RUBRIC: &str = r#"
format = "inbetween.rubric"
version = 1

[points]
minimum_keyframes = 1
minimum_nodes_moved = 2
uses_catmull_rom = 3
above_ground = 4
no_jumps = 5
script_runs = 6

[requirements]
minimum_keyframes = 7
minimum_nodes_moved = 5
"#;

fn reference() -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/grading/reference.json");
    let mut reference: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    reference["interpolation"] = json!("catmull-rom");
    reference
}

fn node(file: &Value, path: &str) -> usize {
    file["nodes"].as_array().unwrap().iter().position(|node| node == path).unwrap()
}

fn graded(sandbox: &Sandbox, arguments: &[&str]) -> BTreeMap<String, Value> {
    let arguments: Vec<&str> = arguments.iter().copied().chain(["-o", "out", "--no-images"]).collect();
    sandbox.run(&arguments).succeeds();
    let grades = sandbox.json("out/grades.json");
    let schema: Value = serde_json::from_str(include_str!("../../assets/grading/grades.schema.json")).unwrap();
    follows(&grades, &schema, "grades");
    let submissions = grades["submissions"].as_array().unwrap();
    submissions.iter().map(|graded| (graded["name"].as_str().unwrap().to_owned(), graded.clone())).collect()
}

#[track_caller]
fn is(graded: &Value, name: &str, points: f64, reason: &str) {
    let item = item(graded, name);
    assert_eq!((item["points"].as_f64(), item["reason"].as_str()), (Some(points), Some(reason)), "{name}");
}

#[test]
fn each_requirement_is_met_or_not() {
    let sandbox = Sandbox::new();
    sandbox.write("rubric.toml", RUBRIC);
    let good = reference();
    sandbox.write("all/good/keys.json", good.to_string());
    sandbox.write("all/good/script.txt", "key i\nkey y\nwait 1s\n");

    let mut few = good.clone();
    few["keyframes"].as_array_mut().unwrap().pop();
    few["interpolation"] = json!("linear");
    let still = few["keyframes"][1].clone();
    few["keyframes"].as_array_mut().unwrap().iter_mut().for_each(|keyframe| *keyframe = still.clone());
    few["keyframes"][3]["pose"][2]["translation"] = json!([-2, 1.3, 0]);
    sandbox.write("all/few/keys.json", few.to_string());
    sandbox.write("all/few/script.txt", "key i\nkey n\nselect robot9\n");

    let mut low = good.clone();
    let robot1 = node(&low, "robot1");
    low["keyframes"][3]["pose"][robot1]["translation"] = json!([-2, 0.5, 0]);
    low["version"] = json!(2);
    low["keyframes"][2]["easing"] = json!("hold");
    low["keyframes"][1]["name"] = json!("first");
    sandbox.write("all/low/keys.json", low.to_string());
    sandbox.write("all/low/script.txt", "key i\nkey >\nkey d\nkey d\nkey d\nkey d\nkey d\nkey d\nkey d\nkey d\n");
    sandbox.write("all/none/notes.txt", "nothing");

    let all = graded(&sandbox, &["grade", "rubric.toml", "all"]);
    let good = &all["good"];
    assert_eq!((&good["points"], &good["out_of"]), (&json!(21.0), &json!(21.0)), "{good}");
    is(good, "minimum_keyframes", 1.0, "7 keyframes.");
    let moved = "11 nodes move: robot1, robot1/right_shoulder, robot1/right_shoulder/right_elbow, robot1/left_shoulder and 7 more.";
    is(good, "minimum_nodes_moved", 2.0, moved);
    is(good, "uses_catmull_rom", 3.0, "keys.json is played by Catmull-Rom splines.");
    is(good, "script_runs", 6.0, "script.txt: 3 commands run.");
    let (ground, jumps) = (item(good, "above_ground"), item(good, "no_jumps"));
    assert!(
        ground["reason"].as_str().unwrap().starts_with("Nothing is below y = -2.05. The lowest is robot"),
        "{ground}"
    );
    assert!(jumps["reason"].as_str().unwrap().starts_with("Nothing jumps: "), "{jumps}");

    let few = &all["few"];
    is(few, "minimum_keyframes", 0.0, "6 keyframes, expected at least 7.");
    is(few, "minimum_nodes_moved", 0.0, "1 node moves: robot1. Expected at least 5.");
    is(few, "uses_catmull_rom", 0.0, "keys.json is played by linear interpolation.");
    let refused = item(few, "script_runs");
    assert_eq!(refused["points"], 0.0);
    assert!(refused["reason"].as_str().unwrap().starts_with("script.txt: line 3"), "{refused}");

    let low = &all["low"];
    let sunk = item(low, "above_ground")["reason"].as_str().unwrap();
    assert!(sunk.starts_with("robot1/"), "{sunk}");
    assert!(
        sunk.contains("/foot reaches y = -2.5") && sunk.contains(" below -2.05; something is below it from key time "),
        "{sunk}"
    );
    let jump = item(low, "no_jumps")["reason"].as_str().unwrap();
    assert!(jump.contains(" in 1/60 s at key time 1.983; at most 0.5 units and 30 degrees are allowed."), "{jump}");
    let refused = item(low, "script_runs")["reason"].as_str().unwrap();
    assert_eq!(refused, "script.txt: line 10 (key d): The list is empty: there is no keyframe to delete.");

    let none = &all["none"];
    assert_eq!(none["points"], 0.0);
    is(none, "no_jumps", 0.0, "The keyframes cannot be read.");
    is(none, "script_runs", 0.0, "No script was handed in.");
}

#[test]
fn a_text_shows_splines_by_what_stands_beside_it() {
    let sandbox = Sandbox::new();
    sandbox.write("rubric.toml", RUBRIC.replace("[requirements]\nminimum_keyframes = 7\nminimum_nodes_moved = 5", ""));
    sandbox.write("keys.json", reference().to_string());
    for name in ["alone", "script", "linear", "samples", "trace"] {
        std::fs::create_dir_all(sandbox.path(&format!("all/{name}"))).unwrap();
        sandbox.run(&["convert", "keys.json", "--to", "header", "-o", &format!("all/{name}/animation.txt")]).succeeds();
    }
    let playing = "key i\ninterpolation catmull-rom\nkey y\nwait 300ms\n";
    sandbox.write("all/script/script.txt", playing);
    sandbox.write("all/linear/script.txt", playing.replace("interpolation catmull-rom", "interpolation linear"));
    sandbox.write("playing.txt", playing);
    let trace = sandbox.run(&["script", "playing.txt", "--keyframes", "keys.json", "--trace"]).succeeds();
    sandbox.write("all/trace/trace.jsonl", trace);
    let samples = ["sample", "keys.json", "--fps", "8", "--format", "csv", "--interpolation", "catmull-rom"];
    let samples = sandbox.run(&samples).succeeds();
    sandbox.write("all/samples/shown.csv", samples);
    let all = graded(&sandbox, &["grade", "rubric.toml", "all"]);
    let nothing = "animation.txt does not say how it is played, as no text can, and neither samples, a trace nor a script show \
                   Catmull-Rom splines.";
    is(&all["alone"], "uses_catmull_rom", 0.0, nothing);
    is(&all["linear"], "uses_catmull_rom", 0.0, nothing);
    is(&all["script"], "uses_catmull_rom", 3.0, "script.txt uses Catmull-Rom splines.");
    is(&all["trace"], "uses_catmull_rom", 3.0, "trace.jsonl uses Catmull-Rom splines.");
    is(&all["samples"], "uses_catmull_rom", 3.0, "shown.csv shows playback by Catmull-Rom splines.");
}

/// A scene with an eye, a ground, and a node `a` with one shape; the node's placement is the animation's.
fn scene_of(shape: &str) -> String {
    format!(
        r##"{{"format": "inbetween.scene", "version": 1, "name": "one", "eyes": ["sky"], "vertical_fov_degrees": 60, "nodes": [
        {{"name": "sky", "translation": [0, 0, 4], "children": [{{"name": "cloud", "shape": {{"sphere": {{"radius": 9}}}}, "colour": "#ffffff"}}]}},
        {{"name": "ground", "children": [
            {{"name": "plane", "shape": {{"plane": {{"size": [9, 9]}}}}, "colour": "#ffffff", "translation": [0, -5, 0]}},
            {{"name": "rock", "shape": {{"sphere": {{"radius": 9}}}}, "colour": "#ffffff"}}]}},
        {{"name": "a", "children": [{{"name": "shape", "shape": {shape}, "colour": "#ffffff"}}]}}]}}"##
    )
}

/// Keyframes of that scene: the node's translations and rotations.
fn keys_of(ms: u32, poses: &[([f64; 3], [f64; 4])]) -> String {
    let keyframes: Vec<Value> = poses
        .iter()
        .map(|(translation, rotation)| {
            let still = json!({"translation": [0, 0, 0], "rotation": [0, 0, 0, 1]});
            json!({"pose": [still, still, {"translation": translation, "rotation": rotation}]})
        })
        .collect();
    json!({"format": "inbetween.keyframes", "version": 1, "scene": "one", "interpolation": "linear", "ms_between_keyframes": ms,
        "nodes": ["sky", "ground", "a"], "keyframes": keyframes})
    .to_string()
}

#[test]
fn the_bounds_of_each_shape_are_exact() {
    let sandbox = Sandbox::new();
    sandbox.write(
        "rubric.toml",
        "format = \"inbetween.rubric\"\nversion = 1\npoints.above_ground = 1\nrequirements.lowest_y = -3\n",
    );
    let eighth = (std::f64::consts::PI / 8.0).sin_cos();
    let tilted = [0.0, 0.0, eighth.0, eighth.1];
    let upright = [0.0, 0.0, 0.0, 1.0];
    let lying = [0.0, 0.0, 0.5_f64.sqrt(), 0.5_f64.sqrt()];
    let over = [1.0, 0.0, 0.0, 0.0];
    let root = 2.0_f64.sqrt();
    for (shape, rotation, below) in [
        (r#"{"sphere": {"radius": 1.5}}"#, tilted, 1.5),
        (r#"{"box": {"size": [2, 2, 2]}}"#, tilted, root),
        (r#"{"box": {"size": [2, 2, 2], "bevel": 0.5}}"#, tilted, 0.5 * root + 0.5),
        (r#"{"cylinder": {"radius": 1, "height": 4}}"#, tilted, 1.5 * root),
        (r#"{"capsule": {"radius": 0.5, "height": 3}}"#, lying, 0.5),
        (r#"{"capsule": {"radius": 0.5, "height": 3}}"#, tilted, 0.5 * root + 0.5),
        (r#"{"cone": {"radius": 1, "height": 3}}"#, upright, 1.5),
        (r#"{"cone": {"radius": 1, "height": 3}}"#, over, 1.5),
        (r#"{"cone": {"radius": 1, "height": 3}}"#, lying, 1.0),
        (r#"{"plane": {"size": [2, 2]}}"#, upright, -100.0),
    ] {
        sandbox.write("one.json", scene_of(shape));
        // The second of the played keyframes is the lowest.
        let keys = |y: f64| keys_of(1000, &[0.0, 0.0, y, 0.0, 0.0].map(|y| ([0.0, y, 0.0], rotation)));
        sandbox.write("all/in.json", keys(below - 3.0 + 0.001));
        sandbox.write("all/out.json", keys(below - 3.0 - 0.001));
        let all = graded(&sandbox, &["--scene", "one.json", "grade", "rubric.toml", "all"]);
        assert_eq!(all["in.json"]["points"], 1.0, "{shape}: {}", all["in.json"]["items"]);
        if below > 0.0 {
            let reason = "a/shape reaches y = -3.001 at key time 1.000, 0.001 below -3; something is below it from key time 1.000 on.";
            is(&all["out.json"], "above_ground", 0.0, reason);
        } else {
            is(&all["out.json"], "above_ground", 1.0, "Nothing can be below the ground.");
        }
    }
}

#[test]
fn steps_are_measured_in_world_space_and_real_time() {
    let sandbox = Sandbox::new();
    sandbox.write("one.json", scene_of(r#"{"sphere": {"radius": 1}}"#));
    let rubric = "format = \"inbetween.rubric\"\nversion = 1\npoints.no_jumps = 1\n";
    sandbox.write("rubric.toml", rubric);
    let still = [0.0, 0.0, 0.0, 1.0];
    let moved = |ms: u32, x: f64| keys_of(ms, &[0.0, 0.0, x, x, x].map(|x| ([x, 0.0, 0.0], still)));
    let turned = |duration: f64| {
        let (sine, cosine) = 85.0_f64.to_radians().sin_cos();
        let turn = [0.0, 0.0, sine, cosine];
        let keys = keys_of(100, &[still, still, turn, turn, turn].map(|rotation| ([0.0; 3], rotation)));
        let mut keys: Value = serde_json::from_str(&keys).unwrap();
        keys["version"] = json!(2);
        keys["keyframes"][1]["duration"] = json!(duration);
        keys.to_string()
    };
    sandbox.write("all/at.json", moved(1000, 30.0));
    sandbox.write("all/over.json", moved(1000, 30.1));
    sandbox.write("all/slow.json", moved(2000, 60.0));
    sandbox.write("all/turn.json", turned(1.0));
    sandbox.write("all/spin.json", turned(0.9));
    // The same way in a part of the time.
    let mut hurried: Value = serde_json::from_str(&moved(1000, 30.0)).unwrap();
    hurried["version"] = json!(2);
    hurried["keyframes"][1]["duration"] = json!(0.5);
    sandbox.write("all/hurried.json", hurried.to_string());
    let all = graded(&sandbox, &["--scene", "one.json", "grade", "rubric.toml", "all"]);
    for name in ["at.json", "slow.json", "turn.json"] {
        assert_eq!(all[name]["points"], 1.0, "{name}: {}", all[name]["items"]);
    }
    for (name, step) in [
        ("over.json", "a moves 0.502 units and turns 0.00 degrees in 1/60 s at key time "),
        ("hurried.json", "a moves 1.000 units and turns 0.00 degrees in 1/60 s at key time "),
        ("spin.json", "a moves 0.000 units and turns 31.48 degrees in 1/60 s at key time "),
    ] {
        let reason = item(&all[name], "no_jumps")["reason"].as_str().unwrap();
        assert!(reason.starts_with(step), "{name}: {reason}");
        assert!(reason.ends_with("; at most 0.5 units and 30 degrees are allowed."), "{name}: {reason}");
    }
    sandbox.write(
        "rubric.toml",
        format!("{rubric}requirements.largest_step = 1\nrequirements.largest_step_degrees = 32\n"),
    );
    let all = graded(&sandbox, &["--scene", "one.json", "grade", "rubric.toml", "all"]);
    assert!(all.values().all(|graded| graded["points"] == 1.0));
}

#[test]
fn a_long_animation_is_looked_at_in_part() {
    let sandbox = Sandbox::new();
    sandbox.write("one.json", scene_of(r#"{"sphere": {"radius": 1}}"#));
    sandbox.write(
        "rubric.toml",
        "format = \"inbetween.rubric\"\nversion = 1\npoints.no_jumps = 1\npoints.above_ground = 1\nrequirements.lowest_y = -1\n",
    );
    let poses: Vec<_> = (0..40).map(|index| ([f64::from(index) * 10.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0])).collect();
    let mut long: Value = serde_json::from_str(&keys_of(10_000, &poses)).unwrap();
    long["version"] = json!(2);
    for keyframe in long["keyframes"].as_array_mut().unwrap() {
        keyframe["duration"] = json!(1000);
    }
    sandbox.write("all/long.json", long.to_string());
    long["keyframes"][20]["easing"] = json!("hold");
    sandbox.write("all/jump.json", long.to_string());
    let all = graded(&sandbox, &["--scene", "one.json", "grade", "rubric.toml", "all"]);
    let mut reasons = String::new();
    for name in ["no_jumps", "above_ground"] {
        let _ = writeln!(reasons, "{}", item(&all["long.json"], name)["reason"].as_str().unwrap());
    }
    assert_eq!(all["long.json"]["points"], 2.0, "{reasons}");
    assert_eq!(reasons.matches(" moments that were looked at").count(), 2, "{reasons}");
    // What is sudden is at a keyframe.
    let jump = item(&all["jump.json"], "no_jumps")["reason"].as_str().unwrap();
    assert!(jump.starts_with("a moves 10.000 units and turns 0.00 degrees in 1/60 s at key time 20.000"), "{jump}");
}

#[test]
fn bad_requirements_are_refused() {
    let sandbox = Sandbox::new();
    sandbox.write("keys.json", reference().to_string());
    for (more, sentence) in [
        ("points.no_jumps = -1", "points.no_jumps is -1, expected 0 to 1000000"),
        (
            "points.no_jumps = 1\nrequirements.minimum_keyframes = 3",
            "requirements.minimum_keyframes is there, but points.minimum_keyframes gives no points",
        ),
        (
            "points.minimum_keyframes = 1\nrequirements.minimum_keyframes = 0",
            "requirements.minimum_keyframes is 0, expected a whole number from 1 to 2000",
        ),
        (
            "points.above_ground = 1\nrequirements.lowest_y = inf",
            "requirements.lowest_y is inf, expected -1000000 to 1000000",
        ),
        (
            "points.minimum_nodes_moved = 1\nrequirements.minimum_nodes_moved = 23",
            "requirements.minimum_nodes_moved is 23, and the scene has 22 nodes that keyframes move",
        ),
    ] {
        sandbox.write("rubric.toml", format!("format = \"inbetween.rubric\"\nversion = 1\n{more}\n"));
        sandbox
            .run(&["grade", "rubric.toml", "keys.json", "-o", "out", "--no-images"])
            .refuses(&format!("rubric.toml: {sentence}"));
    }
}
