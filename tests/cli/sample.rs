use serde_json::{Value, json};

use crate::sandbox::{HEAD, Sandbox, keyframe_file};

const TWO_NODES: &str = r#"{"format": "inbetween.scene", "version": 1, "name": "two", "eyes": ["a"],
    "nodes": [{"name": "a"}, {"name": "b"}]}"#;

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

#[test]
fn samples_match_values_of_fifty_digit_arithmetic() {
    let golden: Value = serde_json::from_str(include_str!("../data/interpolation.json")).unwrap();
    let sandbox = Sandbox::new();
    sandbox.write("two.json", TWO_NODES);
    let file = json!({"format": "inbetween.keyframes", "version": 1, "scene": "two", "nodes": ["a", "b"],
        "keyframes": golden["playback"]["keyframes"]});
    sandbox.write("a.json", file.to_string());
    let cases = golden["playback"]["cases"].as_array().unwrap();
    assert!(cases.len() >= 14);
    for case in cases {
        let key_time = case["key_time"].to_string();
        let interpolation = case["interpolation"].as_str().unwrap();
        let arguments =
            ["sample", "a.json", "--scene", "two.json", "--at", &key_time, "--interpolation", interpolation];
        let sampled: Value = serde_json::from_str(&sandbox.run(&arguments).succeeds()).unwrap();
        for (found, expected) in
            sampled["frames"][0]["pose"].as_array().unwrap().iter().zip(case["expect"].as_array().unwrap())
        {
            let [found_rotation, rotation] = [found, expected].map(|rbt| numbers(&rbt["rotation"]));
            let opposite: Vec<f64> = rotation.iter().map(|number| -number).collect();
            let off = distance(&found_rotation, &rotation).min(distance(&found_rotation, &opposite));
            assert!(off < 1e-5, "{interpolation} at {key_time}: {found_rotation:?}, expected {rotation:?}");
            let [found, expected] = [found, expected].map(|rbt| numbers(&rbt["translation"]));
            assert!(distance(&found, &expected) < 1e-5, "{interpolation} at {key_time}: {found:?}, {expected:?}");
        }
    }
}

#[test]
fn without_a_file_it_is_the_rest_pose() {
    let sampled: Value = serde_json::from_str(&Sandbox::new().run(&["sample"]).succeeds()).unwrap();
    assert_eq!(sampled["nodes"].as_array().unwrap().len(), 22);
    assert_eq!(sampled["frames"].as_array().unwrap().len(), 1);
    assert_eq!(sampled["frames"][0]["key_time"], json!(0.0));
    assert_eq!(sampled["frames"][0]["ms"], json!(0.0));
    assert_eq!(numbers(&sampled["frames"][0]["pose"][0]["translation"]), [0.0, 0.25, 4.0]);
    assert_eq!(numbers(&sampled["frames"][0]["pose"][0]["rotation"]), [0.0, 0.0, 0.0, 1.0]);
}

#[test]
fn frames_come_in_the_order_asked() {
    let sandbox = Sandbox::new();
    sandbox.write("a.json", keyframe_file(6).to_string());
    let sampled: Value =
        serde_json::from_str(&sandbox.run(&["sample", "a.json", "--at", "3,0.5,0,0.5"]).succeeds()).unwrap();
    let frames: Vec<(f64, f64, f64)> = sampled["frames"]
        .as_array()
        .unwrap()
        .iter()
        .map(|frame| {
            let x = frame["pose"][HEAD]["translation"][0].as_f64().unwrap();
            (frame["key_time"].as_f64().unwrap(), frame["ms"].as_f64().unwrap(), x)
        })
        .collect();
    assert_eq!(frames, [(3.0, 6000.0, 4.0), (0.5, 1000.0, 1.5), (0.0, 0.0, 1.0), (0.5, 1000.0, 1.5)]);
    let one: Value = serde_json::from_str(&sandbox.run(&["sample", "a.json"]).succeeds()).unwrap();
    assert_eq!(one["frames"].as_array().unwrap().len(), 1);
    assert_eq!(one["frames"][0]["key_time"], json!(0.0));
}

#[test]
fn times_always_have_a_decimal_point() {
    let sandbox = Sandbox::new();
    sandbox.write("a.json", keyframe_file(4).to_string());
    let text = sandbox.run(&["sample", "a.json", "--at", "-0,1"]).succeeds();
    assert!(text.contains(
        "{\"key_time\": 0.0, \"ms\": 0.0, \"pose\": [{\"translation\": [0, 0.25, 4], \"rotation\": [0, 0, 0, 1]}, "
    ));
    assert!(text.contains("{\"key_time\": 1.0, \"ms\": 2000.0, "));
}

#[test]
fn frames_a_second_end_with_the_end() {
    let sandbox = Sandbox::new();
    let mut file = keyframe_file(5);
    file["ms_between_keyframes"] = json!(130);
    sandbox.write("a.json", file.to_string());
    let sampled: Value = serde_json::from_str(&sandbox.run(&["sample", "a.json", "--fps", "30"]).succeeds()).unwrap();
    let frames = sampled["frames"].as_array().unwrap();
    let ms: Vec<f64> = frames.iter().map(|frame| frame["ms"].as_f64().unwrap()).collect();
    let expected = [0.0, 1000.0, 2000.0, 3000.0, 4000.0, 5000.0, 6000.0, 7000.0].map(|ms| ms / 30.0);
    assert_eq!(ms, [&expected[..], &[260.0]].concat());
    assert_eq!(frames[1]["key_time"].as_f64(), Some(1000.0 / 3900.0));
    assert_eq!(frames[8]["key_time"].as_f64(), Some(2.0));
    assert_eq!(frames[8]["pose"][HEAD]["translation"][0].as_f64(), Some(3.0));
}

#[test]
fn csv_has_a_row_for_each_node_of_each_frame() {
    let sandbox = Sandbox::new();
    sandbox.write("a.json", keyframe_file(4).to_string());
    let csv = sandbox.run(&["sample", "a.json", "--at", "0.25,1", "--format", "csv"]).succeeds();
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines.len(), 1 + 2 * 22);
    assert_eq!(lines[0], "key_time,rbt_ind,tx,ty,tz,rw,rx,ry,rz");
    assert_eq!(lines[1], "0.25,0,0,0.25,4,1,0,0,0");
    assert_eq!(lines[1 + HEAD], "0.25,11,1.25,0.75,0,1,0,0,0");
    assert_eq!(lines[1 + 22 + HEAD], "1.0,11,2,0.75,0,1,0,0,0");
}

#[test]
fn what_cannot_be_sampled_is_bad_input() {
    let sandbox = Sandbox::new();
    sandbox.write("a.json", keyframe_file(6).to_string());
    sandbox.write("short.json", keyframe_file(3).to_string());
    for (key_time, printed) in [("-0.5", "-0.5"), ("3.0001", "3.0001"), ("inf", "inf"), ("nan", "NaN")] {
        sandbox
            .run(&["sample", "a.json", "--at", key_time])
            .refuses(&format!("a.json: key time {printed} is outside 0 to 3"));
    }
    sandbox
        .run(&["sample", "a.json", "--at", "0,-1,4"])
        .refuses("a.json: key time -1 is outside 0 to 3\na.json: key time 4 is outside 0 to 3");
    for arguments in [&["sample", "short.json"][..], &["sample", "short.json", "--fps", "1"]] {
        sandbox.run(arguments).refuses(
            "short.json: 3 keyframes cannot be played: the first and the last only steer, so at least 4 are needed",
        );
    }
    sandbox.run(&["sample", "none.json"]).refuses("none.json: there is no such file or folder");
}
