//! What is written can be read, whatever a script does: coordinates, levels of nodes, times, and imports of other lists.

use serde_json::{Value, json};

use crate::sandbox::{HEAD, Sandbox, keyframe_file};

/// The messages of a script's lines.
fn messages(trace: &[Value]) -> Vec<&str> {
    trace.iter().map(|line| line["message"].as_str().unwrap()).collect()
}

#[test]
fn a_script_that_goes_too_far_leaves_a_file_that_can_be_read() {
    let sandbox = Sandbox::new();
    let coordinates = ["3.4e38", "-3.4e38", "1e6", "-1e6", "1e6", "-1e6"];
    let mut script: String = coordinates.map(|x| format!("set-translation {x} 0 0 robot1\nkey n\n")).concat();
    // Half way through an interval, where a spline is beyond its keyframes.
    script += "interpolation catmull-rom\nduration 0 1000\nduration 2 1000\nkey y\nwait 1000s\nkey shift+p\nkey n\nkey w\nkey i\n";
    sandbox.write("script.txt", script);
    let run = sandbox.run(&["script", "script.txt", "--keyframes", "k.json", "--trace"]).succeeds();
    let trace: Vec<Value> = run.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let said = messages(&trace);
    assert_eq!(said[0], "That is too far away: coordinates are between -1e6 and 1e6. Nothing was changed.");
    assert!(said.last().unwrap().starts_with("Imported 7 keyframes"), "{said:?}");
    assert!(sandbox.run(&["check", "k.json"]).succeeds().contains("7 keyframes"));
    let samples = sandbox.run(&["sample", "k.json", "--fps", "1", "--space", "world"]).succeeds();
    assert!(serde_json::from_str::<Value>(&samples).is_ok() && !samples.contains("inf") && !samples.contains("NaN"));
}

#[test]
fn a_keyframe_that_is_too_far_is_refused_with_its_place() {
    let sandbox = Sandbox::new();
    let mut file = keyframe_file(4);
    file["keyframes"][1]["pose"][HEAD]["translation"] = json!([0, 1e6, 0]);
    sandbox.write("a.json", file.to_string());
    sandbox.run(&["check", "a.json"]).succeeds();
    let far = "translation is too far away, expected coordinates between -1e6 and 1e6";
    for beyond in [json!(1.000_000_1e6), json!(-1e7), json!(3.4e38), json!(1e39)] {
        file["keyframes"][1]["pose"][HEAD]["translation"] = json!([0, beyond, 0]);
        sandbox.write("a.json", file.to_string());
        for command in ["check", "sample"] {
            sandbox.run(&[command, "a.json"]).refuses(&format!("a.json: keyframe 1, node \"robot1/head\": {far}"));
        }
    }
    let row = "2e6 0 0 1 0 0 0\n";
    sandbox.write("a.txt", ["2 22\n".to_owned(), "0 0 0 1 0 0 0\n".repeat(22), row.repeat(22)].concat());
    sandbox
        .run(&["convert", "a.txt", "-o", "b.json"])
        .refuses("a.txt: line 24 column 1: keyframe 1, row 0: the translation is too far away, expected coordinates between -1e6 and 1e6");
}

#[test]
fn a_deep_scene_that_is_saved_can_be_read() {
    let sandbox = Sandbox::new();
    sandbox.write("deep.txt", "put-control robot1\n".repeat(58) + "save-scene deep.json\n");
    sandbox.run(&["script", "deep.txt"]).succeeds();
    sandbox.run(&["nodes", "--scene", "deep.json"]).succeeds();
    assert!(sandbox.read("deep.json").contains("\"robot1_control58\""));
    sandbox.write("deeper.txt", "put-control robot1\n".repeat(300) + "save-scene deeper.json\n");
    let outcome = sandbox.run(&["script", "deeper.txt", "--trace"]).succeeds();
    assert!(outcome.contains("a scene has at most 256 levels of nodes"));
    sandbox.run(&["nodes", "--scene", "deeper.json"]).succeeds();
}

#[test]
fn scales_above_each_other_stay_within_single_precision() {
    let sandbox = Sandbox::new();
    let mut script = "put-control robot1\n".repeat(3);
    script += &["", "2", "3"].map(|number| format!("set-key scale 0 1e6 robot1_control{number}\n")).concat();
    script += "save-scene large.json\n";
    let trace = sandbox.trace(&script);
    let said = messages(&trace);
    assert_eq!(said[3..5], ["", ""]);
    assert!(said[5].contains("multiply to 1e18, expected at most 1e12"), "{}", said[5]);
    let world = sandbox.run(&["sample", "--space", "world", "--scene", "large.json"]).succeeds();
    assert!(serde_json::from_str::<Value>(&world).is_ok() && !world.contains("inf"), "{world}");
    let text = sandbox.read("large.json");
    sandbox.write("other.json", text.replacen("\"control\": {}", "\"control\": {\"scale\": [[0, 1e6]]}", 1));
    let refused = sandbox.run(&["nodes", "--scene", "other.json"]);
    assert_eq!(refused.status, 1, "{}", refused.stderr);
    assert!(refused.stderr.contains("multiply to 1e18"), "{}", refused.stderr);
}

#[test]
fn a_typed_full_turn_is_said_to_be_none() {
    let sandbox = Sandbox::new();
    let note = "360 degrees is the same rotation as 0, and playing goes the short way. For a full turn set keys at 120 and 240 degrees as well.";
    let trace = sandbox.trace(
        "put-control robot1\nadd-key rotation 0 robot1_control\nadd-key rotation 2 robot1_control\n\
         set-key rotation 2 360,0,0 robot1_control\nselect robot1/head\nkey n\nrotate y 360\nkey n\nrotate y 90\n\
         rotate y -200\ndrag begin\ndrag turn x 540\ndrag end\nset-key rotation 2 0,0,0,1 robot1_control\n",
    );
    let said = messages(&trace);
    assert_eq!((said[3], said[6], said[8], said[13]), (note, note, "", ""));
    assert!(said[9].starts_with("-200 degrees is the same rotation as 160,"), "{}", said[9]);
    assert!(said[11].starts_with("540 degrees is the same rotation as 180,"), "{}", said[11]);
    // What is refused is not explained.
    let refused = sandbox.trace("rotate y 360\n");
    assert!(messages(&refused)[0].starts_with("No node is chosen"), "{refused:?}");
}

#[test]
fn an_import_drops_what_points_into_the_list_that_it_replaced() {
    let sandbox = Sandbox::new();
    sandbox.write("three.json", keyframe_file(3).to_string());
    let edits = ["copy", "cut", "paste", "duplicate", "move 0", "easing sine-in", "delete", "reverse"];
    for edit in edits {
        let script = format!("{}select-keyframes 4-5\ncopy\nkey i\n{edit}\n", "key n\n".repeat(6));
        sandbox.write("script.txt", script);
        sandbox.run(&["script", "script.txt", "--keyframes", "three.json"]).succeeds();
        // What was pasted stays selected.
        sandbox.write("script.txt", format!("key n\nkey ctrl+c\nkey w\npaste\nkey i\n{edit}\n"));
        sandbox.run(&["script", "script.txt", "--keyframes", "own.json"]).succeeds();
        std::fs::remove_file(sandbox.path("own.json")).unwrap();
    }
    let script = format!("{}select-keyframes 4-5\ncopy\nkey i\npaste\n", "key n\n".repeat(6));
    sandbox.write("script.txt", script);
    let outcome = sandbox.run(&["script", "script.txt", "--keyframes", "three.json", "--trace"]).succeeds();
    assert!(outcome.lines().last().unwrap().contains("2 keyframes pasted: now at 1."), "{outcome}");
}

#[test]
fn times_without_bound_are_refused_with_their_range() {
    let sandbox = Sandbox::new();
    sandbox.write("a.json", keyframe_file(5).to_string());
    for (at, said) in [("1e300", "1e300"), ("-1e300", "-1e300"), ("inf", "inf"), ("nan", "NaN"), ("1e17", "1e17")] {
        let at = format!("--at={at}");
        sandbox.run(&["sample", "a.json", &at]).refuses(&format!("a.json: key time {said} is outside 0 to 2"));
    }
    for seconds in ["1e300", "-1e300", "1000001", "inf", "nan"] {
        let argument = format!("--seconds={seconds}");
        let outcome = sandbox.run(&["sample", "a.json", "--space", "world", &argument]);
        assert!(outcome.stderr.contains("is not a number of seconds from -1e6 to 1e6"), "{}", outcome.stderr);
        outcome.misuses();
    }
    for tolerance in ["--translation-tolerance=1e300", "--rotation-tolerance=-1"] {
        sandbox.run(&["diff", "a.json", "a.json", tolerance]).misuses();
    }
    let trace = sandbox.trace("seconds 1e300\nwait 1000s\nwait 18446744073709551615t\nwait 18446744073709551615t\n");
    assert_eq!(messages(&trace)[0], "Timed keys are shown at times between -1e6 and 1e6 seconds. Nothing was changed.");
}
