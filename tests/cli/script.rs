use serde_json::{Value, json};

use crate::sandbox::{HEAD, Sandbox, keyframe_file};

/// Runs lines after a file of so many keyframes was imported; checks keyframes, current and the head's x after the last.
#[track_caller]
fn check(keyframes: usize, before: &str, keys: &str, count: usize, current: Option<usize>, head_x: f64) -> String {
    let sandbox = Sandbox::new();
    sandbox.write("animation.json", keyframe_file(keyframes).to_string());
    let import = if keyframes > 0 { "key i\n" } else { "" };
    let lines = |words: &str| {
        let lines: Vec<String> = words.split_whitespace().map(|word| format!("key {word}\n")).collect();
        lines.concat()
    };
    let trace = sandbox.trace(&format!("{import}select robot1/head\n{}{}", lines(before), lines(keys)));
    let last = trace.last().unwrap();
    assert_eq!((&last["keyframes"], &last["current"]), (&json!(count), &json!(current)), "{last}");
    let x = sandbox.json("state.json")["pose"][HEAD]["translation"][0].as_f64().unwrap();
    assert!((x - head_x).abs() < 1e-6, "the head is at {x}, expected {head_x}");
    last["message"].as_str().unwrap().to_owned()
}

#[test]
fn keys_of_the_list() {
    for display in ["space", "c"] {
        check(3, "> r", display, 3, Some(1), 1.0);
        check(0, "", display, 0, None, 0.0);
    }
    check(3, "> r", "u", 3, Some(1), 0.0);
    check(3, "> r u >", "<", 3, Some(1), 0.0);
    check(0, "", "u", 1, Some(0), 0.0);
    check(0, "", "n", 1, Some(0), 0.0);
    check(3, "> r", "n", 4, Some(2), 0.0);
    check(3, "> r n", ">", 4, Some(3), 2.0);
    check(3, "> r n <", "<", 4, Some(0), 0.0);
    check(3, "", ">", 3, Some(1), 1.0);
    check(3, "> >", ">", 3, Some(2), 2.0);
    check(3, "", "<", 3, Some(0), 0.0);
    check(0, "", "> <", 0, None, 0.0);
    check(3, "", ".", 3, Some(1), 1.0);
    check(3, ">", ",", 3, Some(0), 0.0);
    check(3, "", "d", 2, Some(0), 1.0);
    check(3, "> >", "d", 2, Some(1), 1.0);
    check(3, ">", "d", 2, Some(0), 0.0);
    check(1, "", "d", 0, None, 0.0);
    check(0, "", "d", 0, None, 0.0);
    check(3, "> >", "i", 3, Some(0), 0.0);
    check(3, "> >", "r", 3, Some(2), 0.0);
    check(3, "> d", "ctrl+z", 3, Some(1), 1.0);
    check(3, "> d ctrl+z", "ctrl+shift+z", 2, Some(0), 0.0);
    check(3, "> d ctrl+z", "ctrl+y", 2, Some(0), 0.0);
    check(3, "> D", "CTRL+Z", 3, Some(1), 1.0);
}

#[test]
fn the_end_of_the_list_changes_nothing_at_all() {
    check(3, "> > r", ">", 3, Some(2), 0.0);
    check(3, "r", "<", 3, Some(0), 0.0);
}

#[test]
fn what_there_is_nothing_to_do_for_says_so() {
    for (keys, sentence) in [
        ("space", "No keyframe is defined yet. Press n to create one."),
        ("d", "The list is empty: there is no keyframe to delete."),
        ("y", "Fewer than 4 keyframes: nothing to play yet. Press n to add one."),
        ("shift+p", "Nothing is playing. Press y to play."),
        ("ctrl+z", "There is nothing to undo."),
        ("ctrl+y", "There is nothing to redo."),
    ] {
        assert_eq!(check(0, "", keys, 0, None, 0.0), sentence);
    }
}

#[test]
fn pace_stays_within_its_bounds() {
    let sandbox = Sandbox::new();
    let ms = |script: String| sandbox.trace(&script).last().unwrap()["ms_between_keyframes"].clone();
    assert_eq!(ms("key +\n".into()), json!(1900));
    assert_eq!(ms("key =\n".into()), json!(1900));
    assert_eq!(ms("key -\n".into()), json!(2100));
    assert_eq!(ms("key +\n".repeat(25)), json!(100));
    assert_eq!(ms("key -\n".repeat(90)), json!(10000));
    assert_eq!(ms("key +\n".repeat(5) + "undo\n"), json!(2000));
}

#[test]
fn keys_of_the_view_are_done_without_a_word_or_with_one() {
    let trace = Sandbox::new().trace("key v\nkey v\nkey v\nkey m\nkey p\nkey escape\nkey h\nkey a\nkey F11\nkey t\n");
    let messages: Vec<&str> = trace.iter().map(|line| line["message"].as_str().unwrap()).collect();
    assert_eq!(messages[..3], ["Looking from robot1.", "Looking from robot2.", "Looking from sky."]);
    assert!(messages[3..6].iter().all(|message| !message.is_empty()), "{messages:?}");
    assert_eq!(messages[6..8], ["", ""]);
    assert_eq!(trace[9]["interpolation"], json!("catmull-rom"));
}

#[test]
fn keys_belong_to_a_turn_or_move_that_a_key_has_begun() {
    let begun = "select robot1\nkey n\nkey ctrl+g\nkey x\nkey -\nkey 1\nkey 5\nkey backspace\n";
    let trace = Sandbox::new().trace(&format!("{begun}key n\nkey y\nkey t\nkey enter\nkey u\nkey t\n"));
    // Letters other than x, y and z do nothing, and y locks an axis.
    assert!(trace[8..12].iter().all(|line| line["keyframes"] == json!(1) && line["message"] == json!("")), "{trace:?}");
    assert_eq!((&trace[8]["playing"], &trace[11]["interpolation"]), (&json!(false), &json!("linear")));
    assert_eq!(trace[13]["interpolation"], json!("catmull-rom"));
    let trace = Sandbox::new().trace(&format!("{begun}key escape\nkey 4\ndrag begin\nkey x\nkey n\n"));
    let messages: Vec<&str> = trace[8..].iter().map(|line| line["message"].as_str().unwrap()).collect();
    let nothing_on = "There is no drag to go on with.";
    assert_eq!(messages[..4], ["Drag taken back.", nothing_on, "", nothing_on]);
    assert_eq!(trace[12]["keyframes"], json!(2));
}

#[test]
fn what_is_typed_leads_where_it_says() {
    let sandbox = Sandbox::new();
    let script = "select robot1\nkey ctrl+g\nkey x\nkey 1\nkey .\nkey 5\nkey enter\nkey n\nkey w\n";
    sandbox.write("s.txt", script);
    sandbox.run(&["script", "s.txt", "--keyframes", "walk.json"]).succeeds();
    let file: Value = serde_json::from_str(&sandbox.read("walk.json")).unwrap();
    let translation = file["keyframes"][0]["pose"][2]["translation"].as_array().unwrap();
    let numbers: Vec<f64> = translation.iter().filter_map(Value::as_f64).collect();
    assert_eq!(numbers, [-0.5, 1.0, 0.0]);
}

#[test]
fn a_trace_line_has_exactly_these_keys_in_this_order() {
    let sandbox = Sandbox::new();
    sandbox.write("s.txt", "# nothing\n\n  select robot1   # the first\nkey n\n");
    let stdout = sandbox.run(&["script", "s.txt", "--trace"]).succeeds();
    assert_eq!(
        stdout,
        "{\"line\": 3, \"command\": \"select robot1\", \"message\": \"Chosen: robot1.\", \"keyframes\": 0, \"current\": null, \
         \"playing\": false, \"key_time\": null, \"ms_between_keyframes\": 2000, \"interpolation\": \"linear\"}\n\
         {\"line\": 4, \"command\": \"key n\", \"message\": \"Keyframe 0 (0 to 0): created the first keyframe.\", \
         \"keyframes\": 1, \"current\": 0, \"playing\": false, \"key_time\": null, \"ms_between_keyframes\": 2000, \
         \"interpolation\": \"linear\"}\n"
    );
    assert_eq!(sandbox.run(&["script", "s.txt"]).succeeds(), "");
    assert_eq!(sandbox.names(), ["s.txt"]);
}

#[test]
fn the_state_at_the_end() {
    let sandbox = Sandbox::new();
    sandbox.write("s.txt", "key n\nselect robot1/right_shoulder\nrotate z 90\ntranslate 0 0.5 0\nundo\nundo\nredo\n");
    sandbox.run(&["script", "s.txt", "--state", "state.json"]).succeeds();
    let state = sandbox.json("state.json");
    let mut keys: Vec<&str> = state.as_object().unwrap().keys().map(String::as_str).collect();
    keys.sort_unstable();
    assert_eq!(
        keys,
        ["current", "interpolation", "key_time", "keyframes", "ms_between_keyframes", "nodes", "playing", "pose"]
    );
    assert_eq!(state["nodes"][3], json!("robot1/right_shoulder"));
    assert_eq!(state["pose"][3]["translation"], json!([0.5, 0.75, 0]));
    let rotation: Vec<f64> =
        state["pose"][3]["rotation"].as_array().unwrap().iter().map(|n| n.as_f64().unwrap()).collect();
    let half = std::f64::consts::FRAC_1_SQRT_2;
    assert!(rotation.iter().zip([0.0, 0.0, half, half]).all(|(found, expected)| (found - expected).abs() < 1e-6));
}

#[test]
fn rotations_are_about_the_nodes_own_axes_and_translations_in_the_parents_space() {
    let sandbox = Sandbox::new();
    sandbox.trace("select robot1\nrotate z 90\nrotate x 90\ntranslate 1 2 3\n");
    let robot = &sandbox.json("state.json")["pose"][2];
    assert_eq!(robot["translation"], json!([-1, 3, 3]));
    let rotation: Vec<f64> = robot["rotation"].as_array().unwrap().iter().map(|n| n.as_f64().unwrap()).collect();
    assert!(rotation.iter().all(|number| (number - 0.5).abs() < 1e-6), "z · x is (½, ½, ½, ½): {rotation:?}");
}

#[test]
fn what_the_window_would_refuse_is_a_message_and_the_script_goes_on() {
    let sandbox = Sandbox::new();
    sandbox.write("bad.json", "{}");
    let mut file: Value = keyframe_file(2);
    file["keyframes"][1]["pose"][HEAD]["rotation"] = json!([0, 0, 0, 2]);
    file["interpolation"] = json!("x");
    sandbox.write("wrong.json", file.to_string());
    let script = "key n\nrotate x 3\ntranslate 1 1 1\nkey i\nkey y\nselect none\nrotate x 3\nkey n\n";
    for (keyframes, sentence) in [
        ("none.json", "none.json: there is no such file or folder"),
        ("bad.json", "bad.json: line 1 column 2: format is missing"),
        (
            "wrong.json",
            "wrong.json: interpolation is \"x\", expected \"linear\" or \"catmull-rom\" (and 1 more problem)",
        ),
    ] {
        let mut command = sandbox.command(&["script", "-", "--trace", "--keyframes", keyframes]);
        command.write_stdin(script);
        let stdout = Sandbox::outcome(command).succeeds();
        let trace: Vec<Value> = stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        for line in [1, 2, 6] {
            assert!(trace[line]["message"].as_str().unwrap().starts_with("No node is chosen."));
        }
        assert_eq!(trace[3]["message"], json!(sentence));
        assert_eq!((&trace[3]["keyframes"], &trace[3]["current"]), (&json!(1), &json!(0)), "the list stays");
        assert!(trace[4]["message"].as_str().unwrap().starts_with("Fewer than 4 keyframes"));
        assert_eq!(trace[7]["keyframes"], json!(2), "the script goes on");
    }
}

#[test]
fn refusals_go_to_standard_error_where_no_trace_has_them() {
    let sandbox = Sandbox::new();
    sandbox.write("s.txt", "key n\n\nrotate x 3 # nothing is chosen\nkey ctrl+e\nundo\nundo\nkey w\n");
    let outcome = sandbox.run(&["script", "s.txt"]);
    let no_node = "s.txt: line 3: No node is chosen. ";
    assert_eq!((outcome.status, outcome.stdout.as_str()), (0, ""));
    assert!(outcome.stderr.starts_with(no_node), "{}", outcome.stderr);
    assert!(outcome.stderr.ends_with("s.txt: line 6: There is nothing to undo.\n"), "{}", outcome.stderr);
    let traced = sandbox.run(&["script", "s.txt", "--trace"]).succeeds();
    assert_eq!(traced.lines().count(), 6);
}

#[test]
fn a_strict_script_ends_at_the_first_refusal() {
    let sandbox = Sandbox::new();
    sandbox.write("s.txt", "key n\nkey >\nundo\nundo\nkey w\n");
    sandbox
        .run(&["script", "s.txt", "--strict", "--state", "state.json"])
        .refuses("s.txt: line 4: There is nothing to undo.");
    assert_eq!(sandbox.names(), ["s.txt"], "what comes after it has not run");
    let traced = sandbox.run(&["script", "s.txt", "--strict", "--trace"]);
    assert_eq!((traced.status, traced.stdout.lines().count()), (1, 4));
    assert_eq!(traced.stderr, "s.txt: line 4: There is nothing to undo.\n");
    sandbox.write("s.txt", "key n\nkey >\nundo\nkey w\n");
    sandbox.run(&["script", "s.txt", "--strict"]).succeeds();
}

#[test]
fn bad_lines_are_named_and_nothing_is_run() {
    let sandbox = Sandbox::new();
    sandbox.write("s.txt", "key n\nkey w\nselect robot9\n\njump\nkey q # none\n");
    sandbox.run(&["script", "s.txt", "--trace", "--state", "state.json"]).refuses(
        "s.txt: line 3: node \"robot9\" is not in the scene \"two-robots\"\n\
         s.txt: line 5: \"jump\" is not a command; `inbetween help script` lists them\n\
         s.txt: line 6: \"q\" is not a hotkey",
    );
    sandbox.run(&["script", "none.txt"]).refuses("none.txt: there is no such file or folder");
    assert_eq!(sandbox.names(), ["s.txt"]);
    // Of a file that is no script, the first five lines are enough.
    let no_script = |lines: usize, last: &str| {
        sandbox.write("s.txt", "selct a\n".repeat(lines));
        let line = |number: usize| {
            format!(
                "s.txt: line {number}: \"selct\" is not a command; did you mean select? `inbetween help script` lists them\n"
            )
        };
        let first: String = (1..=5).map(line).collect();
        sandbox.run(&["script", "s.txt"]).refuses((first + last).trim_end());
    };
    no_script(5, "");
    no_script(6, "s.txt: 1 more line makes no sense");
    no_script(200, "s.txt: 195 more lines make no sense");
}

#[test]
fn a_file_that_cannot_be_written_ends_it_with_1() {
    let sandbox = Sandbox::new();
    sandbox.write("s.txt", "key n\nkey w\nkey n\n");
    let outcome =
        sandbox.run(&["script", "s.txt", "--trace", "--keyframes", "no/such/a.json", "--state", "state.json"]);
    assert_eq!((outcome.status, outcome.stderr.trim_end()), (1, "no/such/a.json: there is no such file or folder"));
    assert_eq!(outcome.stdout.lines().count(), 2, "the third line has not run");
    assert_eq!(sandbox.names(), ["s.txt"]);
    sandbox
        .run(&["script", "s.txt", "--state", "no/such/state.json"])
        .refuses("no/such/state.json: there is no such file or folder");
}

#[test]
fn quitting_ends_the_script() {
    let sandbox = Sandbox::new();
    let trace = sandbox.trace("key n\nkey ctrl+q\nkey n\n");
    assert_eq!(trace.len(), 2);
    assert_eq!((&trace[1]["message"], &trace[1]["keyframes"]), (&json!(""), &json!(1)));
    assert_eq!(sandbox.json("state.json")["keyframes"], json!(1));
}

#[test]
fn an_empty_list_writes_a_file_with_no_keyframes() {
    let sandbox = Sandbox::new();
    sandbox.trace("key w\n");
    assert_eq!(sandbox.json("animation.json")["keyframes"], json!([]));
    assert_eq!(
        sandbox.run(&["check", "animation.json"]).succeeds(),
        "animation.json: ok, 0 keyframes, linear, 2000 ms\n"
    );
}

#[test]
fn control_nodes_and_their_keys_are_scripted_and_saved() {
    let sandbox = Sandbox::new();
    sandbox.write("animation.json", keyframe_file(2).to_string());
    let trace = sandbox.trace(
        "put-control robot1\nrename-control spin robot1_control\nset-key translation 0 0,0,0 spin\n\
         set-key translation 2 4,0,0 spin\nadd-key translation 1.5 spin\nmove-key translation 1.5 1 spin\n\
         set-key colour 1 ff8000 robot1/chest\ndelete-key scale 1 spin\nseconds 1\nsave-scene spin.json\n",
    );
    let message = |line: usize| trace[line]["message"].as_str().unwrap().to_owned();
    assert!(message(0).starts_with("robot1_control stands above it"));
    assert_eq!(message(4), "1 key at 1.500 s.");
    assert_eq!(message(5), "Moved 1 key by -0.500 s.");
    assert_eq!(message(7), "spin has no key of its scale at 1 s.");
    assert_eq!(message(9), "Wrote the scene to spin.json.");
    let saved = sandbox.json("spin.json");
    assert_eq!(saved["version"], json!(3));
    let spin = saved["nodes"].as_array().unwrap().iter().find(|node| node["name"] == json!("spin")).unwrap();
    assert_eq!(spin["control"]["translation"], json!([[0, [0, 0, 0]], [1, [3, 0, 0]], [2, [4, 0, 0]]]));
    // The same keyframe file fits both scenes, and what is sampled in the world has moved.
    let run = |arguments: &[&str]| Sandbox::outcome(sandbox.command(arguments)).succeeds();
    assert_eq!(run(&["nodes", "--scene", "spin.json"]), run(&["nodes"]));
    assert!(run(&["check", "animation.json", "--scene", "spin.json"]).contains("animation.json"));
    // Opened and written again, it is the same to the byte.
    let mut again = sandbox.command(&["script", "-", "--scene", "spin.json"]);
    again.write_stdin("save-scene again.json\n");
    Sandbox::outcome(again).succeeds();
    assert_eq!(sandbox.json("again.json"), saved);
    assert_eq!(sandbox.read("again.json"), sandbox.read("spin.json"));
}

#[test]
fn a_script_exports_a_model_that_is_imported_again() {
    let sandbox = Sandbox::new();
    sandbox.write("animation.json", keyframe_file(4).to_string());
    let trace = sandbox.trace("open animation.json\nexport-model walk.glb\nexport-model walk.bvh\n");
    let message = |line: usize| trace[line]["message"].as_str().unwrap().to_owned();
    assert_eq!([message(1), message(2)], ["glb", "bvh"].map(|ending| format!("Wrote the model to walk.{ending}.")));
    sandbox.write("wrong.txt", "export-model walk.obj\n");
    sandbox.run(&["script", "wrong.txt"]).refuses("walk.obj: the name of a model ends in .glb, .gltf or .bvh");
    assert!(!sandbox.path("walk.obj").exists());
    let run = |arguments: &[&str]| Sandbox::outcome(sandbox.command(arguments)).succeeds();
    run(&["import", "walk.glb", "-o", "again.json", "--keyframes", "keys.json"]);
    assert_eq!(run(&["nodes", "--scene", "again.json"]), run(&["nodes"]));
    assert!(run(&["check", "keys.json", "--scene", "again.json"]).contains("ok"));
}
