use serde_json::{Value, json};

use crate::sandbox::{HEAD, Sandbox, keyframe_file};

fn pair(change: impl FnOnce(&mut Value)) -> Sandbox {
    let sandbox = Sandbox::new();
    let mut file = keyframe_file(6);
    sandbox.write("a.json", file.to_string());
    change(&mut file);
    sandbox.write("b.json", file.to_string());
    sandbox
}

#[test]
fn equal_animations_are_within() {
    let sandbox = pair(|_| {});
    let outcome = sandbox.run(&["diff", "a.json", "b.json"]).succeeds();
    assert!(outcome.contains("robot1/head") && outcome.contains("Within the tolerances"), "{outcome}");
    let found: Value = serde_json::from_str(&sandbox.run(&["diff", "a.json", "b.json", "--json"]).succeeds()).unwrap();
    assert_eq!((&found["within_tolerance"], &found["first_exceeded"]), (&json!(true), &Value::Null));
    assert_eq!(found["nodes"].as_array().unwrap().len(), 22);
    assert_eq!(found["frames"], 361);
}

#[test]
fn the_largest_the_mean_and_where_it_begins() {
    let sandbox = pair(|file| {
        let half = (0.25_f64).sin();
        // Half a radian about x, and one unit up, at keyframe 3: key time 2.
        file["keyframes"][3]["pose"][HEAD]["rotation"] = json!([half, 0, 0, 0.25_f64.cos()]);
        file["keyframes"][3]["pose"][HEAD]["translation"][2] = json!(1);
    });
    let arguments = ["diff", "a.json", "b.json", "--json", "--fps", "2", "--tolerance-translation", "0.6"];
    let outcome = sandbox.run(&arguments);
    assert_eq!(outcome.status, 1, "{}", outcome.stderr);
    let found: Value = serde_json::from_str(&outcome.stdout).unwrap();
    let head = &found["nodes"][HEAD];
    let number = |value: &Value| value.as_f64().unwrap();
    assert!((number(&head["translation"]["largest"]) - 1.0).abs() < 1e-6);
    assert_eq!(head["translation"]["largest_at"], 2.0);
    assert_eq!(head["translation"]["exceeds_at"], 1.75);
    assert!((number(&head["rotation"]["largest"]) - 0.5_f64.to_degrees()).abs() < 1e-3);
    assert_eq!(head["rotation"]["exceeds_at"], 1.25);
    // 0, ¼, ½, ¾, 1, ¾, ½, ¼, 0 in the middle of 13 frames.
    let mean = ((2.0 * (0.0625 + 0.25 + 0.5625) + 1.0) / 13.0_f64).sqrt();
    assert!((number(&head["translation"]["rms"]) - mean).abs() < 1e-6);
    assert_eq!(found["first_exceeded"], json!({"key_time": 1.25, "node": "robot1/head", "part": "rotation"}));
    let table = sandbox.run(&["diff", "a.json", "b.json"]);
    assert_eq!((table.status, table.stderr.as_str()), (1, ""));
    assert!(table.stdout.contains("Beyond the tolerances"), "{}", table.stdout);
    let loose = ["diff", "a.json", "b.json", "--tolerance-translation", "2", "--tolerance-rotation", "30"];
    sandbox.run(&loose).succeeds();
}

#[test]
fn interpolation_is_the_files_or_the_arguments() {
    let sandbox = pair(|file| file["interpolation"] = json!("catmull-rom"));
    // Along a straight line at an even pace the two are the same.
    sandbox.run(&["diff", "a.json", "b.json"]).succeeds();
    let sandbox = pair(|file| {
        file["interpolation"] = json!("catmull-rom");
        file["keyframes"][0]["pose"][HEAD]["translation"][0] = json!(5);
    });
    assert_eq!(sandbox.run(&["diff", "a.json", "b.json"]).status, 1);
    sandbox.run(&["diff", "a.json", "b.json", "--interpolation", "linear"]).succeeds();
}

#[test]
fn another_length_is_beyond() {
    let sandbox = pair(|file| file["ms_between_keyframes"] = json!(1000));
    let outcome = sandbox.run(&["diff", "a.json", "b.json"]);
    assert_eq!(outcome.status, 1);
    assert!(outcome.stdout.contains("they play for different times, 6000 ms and 3000 ms"), "{}", outcome.stdout);
}

#[test]
fn trouble_is_status_2() {
    let sandbox = pair(|file| file["keyframes"] = json!([]));
    for (arguments, sentence) in [
        (&["diff", "a.json", "none.json"][..], "none.json: there is no such file or folder"),
        (&["diff", "a.json", "b.json"], "b.json: 0 keyframes cannot be played"),
        (&["diff", "a.json"], "required"),
        (&["diff", "a.json", "a.json", "--tolerance-rotation", "-1"], "-1"),
        (&["diff", "a.json", "a.json", "--scene", "none"], "none: neither a built-in scene"),
    ] {
        let outcome = sandbox.run(arguments);
        assert_eq!((outcome.status, outcome.stdout.as_str()), (2, ""), "{}", outcome.stderr);
        assert!(outcome.stderr.contains(sentence), "{}", outcome.stderr);
    }
}
