use serde_json::{Value, json};

use crate::sandbox::{HEAD, Sandbox, keyframe_file};

#[track_caller]
fn check_text(text: impl AsRef<[u8]>, expected: &str) {
    let sandbox = Sandbox::new();
    sandbox.write("a.json", text);
    sandbox.run(&["check", "a.json"]).refuses(expected);
}

#[track_caller]
fn check_value(change: impl FnOnce(&mut Value), expected: &str) {
    let mut file = keyframe_file(4);
    change(&mut file);
    check_text(file.to_string(), expected);
}

#[test]
fn good_files_have_a_line_each() {
    let sandbox = Sandbox::new();
    let mut file = keyframe_file(6);
    file["interpolation"] = json!("catmull-rom");
    file["ms_between_keyframes"] = json!(700);
    sandbox.write("a.json", file.to_string());
    sandbox.write("b.json", "\u{feff}".to_owned() + &keyframe_file(1).to_string());
    sandbox.write("c.json", keyframe_file(0).to_string());
    assert_eq!(
        sandbox.run(&["check", "a.json", "b.json", "c.json"]).succeeds(),
        "a.json: ok, 6 keyframes, catmull-rom, 700 ms\nb.json: ok, 1 keyframe, linear, 2000 ms\n\
         c.json: ok, 0 keyframes, linear, 2000 ms\n"
    );
}

#[test]
fn one_bad_file_sends_every_line_to_standard_error_in_order() {
    let sandbox = Sandbox::new();
    sandbox.write("good.json", keyframe_file(4).to_string());
    let mut bad = keyframe_file(4);
    bad["interpolation"] = json!("cubic");
    bad["keyframes"][2]["pose"][HEAD]["rotation"] = json!([0, 0, 0, 0.5]);
    sandbox.write("bad.json", bad.to_string());
    sandbox.run(&["check", "bad.json", "good.json", "none.json"]).refuses(
        "bad.json: interpolation is \"cubic\", expected \"linear\" or \"catmull-rom\"\n\
         bad.json: keyframe 2, node \"robot1/head\": rotation has length 0.5, expected 1\n\
         good.json: ok, 4 keyframes, linear, 2000 ms\n\
         none.json: there is no such file or folder",
    );
}

#[test]
fn values_that_are_wrong() {
    check_value(|file| file["format"] = json!("x"), "a.json: format is \"x\", expected \"inbetween.keyframes\"");
    check_value(|file| file["version"] = json!(3), "a.json: version is 3, and this program reads versions 1 and 2");
    for ms in [99.0, 10001.0, 500.5] {
        check_value(
            |file| file["ms_between_keyframes"] = json!(ms),
            &format!("a.json: ms_between_keyframes is {ms}, expected a whole number from 100 to 10000"),
        );
    }
    check_value(
        |file| file["nodes"][HEAD] = json!("robot1/tail"),
        "a.json: node \"robot1/tail\" is not in the scene \"two-robots\"\n\
         a.json: node \"robot1/head\" of the scene \"two-robots\" is missing in nodes",
    );
    check_value(
        |file| file["nodes"][HEAD] = json!("sky"),
        "a.json: node \"sky\" stands twice in nodes\n\
         a.json: node \"robot1/head\" of the scene \"two-robots\" is missing in nodes",
    );
    check_value(
        |file| drop(file["keyframes"][1]["pose"].as_array_mut().unwrap().pop()),
        "a.json: keyframe 1: pose has 21 entries, expected 22, one for each of nodes",
    );
    check_value(
        |file| file["keyframes"][3]["pose"][HEAD]["translation"] = json!([0, 1e39, 0]),
        "a.json: keyframe 3, node \"robot1/head\": translation is too far away, expected coordinates between -1e6 and 1e6",
    );
    check_value(
        |file| {
            file["keyframes"][0]["pose"][0]["rotation"] = json!([0, 0, 0, -1e300]);
            file["keyframes"][3]["pose"][HEAD]["rotation"] = json!([0, 1e39, 0, 1]);
        },
        "a.json: keyframe 0, node \"sky\": rotation is not finite\n\
         a.json: keyframe 3, node \"robot1/head\": rotation is not finite",
    );
}

#[test]
fn json_that_is_wrong_has_line_and_column() {
    let good = serde_json::to_string(&keyframe_file(1)).unwrap();
    for (text, expected) in [
        (String::new(), "line 1 column 1: the file is empty, expected keyframes"),
        (good.replace("\"scene\"", "\"scenery\""), "unknown field \"scenery\", expected format, "),
        (good.replace("\"pose\"", "\"poses\""), "unknown field \"poses\", expected name, "),
        (good.replace("\"rotation\":", "\"spin\":"), "unknown field \"spin\", expected translation or rotation"),
        (good.replace("\"version\":1", "\"version\":\"1\""), "found the text \"1\", expected a whole number"),
        (good.replacen("[0,0,0,1]", "[0,0,0,NaN]", 1), "no value is written like this"),
        (good.replacen("[0,0,0,1]", "[0,0,0,1e999]", 1), "the number is too large"),
        (good.replacen("[0,0,0,1]", "[0,0,0]", 1), "found a list of 3 values, expected a list of 4 values"),
        (good[..good.len() / 2].to_owned(), "the file ends "),
        (good.clone() + "]", "there is more after the end"),
    ] {
        let sandbox = Sandbox::new();
        sandbox.write("a.json", &text);
        let outcome = sandbox.run(&["check", "a.json"]);
        assert_eq!((outcome.status, outcome.stdout.as_str(), outcome.stderr.lines().count()), (1, "", 1));
        let rest = outcome.stderr.strip_prefix("a.json: line ").expect(&outcome.stderr);
        let (line, rest) = rest.split_once(" column ").expect(&outcome.stderr);
        let (column, sentence) = rest.split_once(": ").expect(&outcome.stderr);
        assert!(line.parse::<usize>().is_ok() && column.parse::<usize>().is_ok(), "{}", outcome.stderr);
        assert!(outcome.stderr.contains(expected) && !sentence.contains('`'), "{}", outcome.stderr);
    }
}

#[test]
fn what_is_neither_json_nor_a_text_is_refused() {
    check_text(
        "[]",
        "a.json: line 1 column 1: found \"[]\", expected keyframes: numbers, a line \"frame [0]\", the header \
         \"frame_num,rbt_ind,…\", keys as a Python dictionary, or JSON",
    );
}

#[test]
fn a_missing_field_is_named() {
    for field in ["format", "version", "scene", "nodes", "keyframes"] {
        let mut file = keyframe_file(1);
        file.as_object_mut().unwrap().remove(field);
        let sandbox = Sandbox::new();
        sandbox.write("a.json", file.to_string());
        let outcome = sandbox.run(&["check", "a.json"]);
        assert_eq!((outcome.status, outcome.stdout.as_str()), (1, ""));
        assert!(outcome.stderr.contains(&format!(": {field} is missing")), "{}", outcome.stderr);
    }
}

#[test]
fn files_beyond_the_limits_are_refused_unread() {
    let sandbox = Sandbox::new();
    for (name, bytes) in [("a.json", (1 << 30) + 1), ("script.txt", (16 << 20) + 1), ("scene.json", (256 << 20) + 1)] {
        std::fs::File::create(sandbox.path(name)).unwrap().set_len(bytes).unwrap();
    }
    sandbox.run(&["check", "a.json"]).refuses("a.json: the file has 1073741825 bytes, and at most 1073741824 are read");
    sandbox
        .run(&["script", "script.txt"])
        .refuses("script.txt: the file has 16777217 bytes, and at most 16777216 are read");
    sandbox.run(&["nodes", "--scene", "scene.json"]).refuses(
        "scene.json: neither a built-in scene (two-robots, cylinder, orbits) nor a file that can be read: \
         the file has 268435457 bytes, and at most 268435456 are read",
    );
}

#[test]
fn a_folder_is_no_file() {
    Sandbox::new().run(&["check", "."]).refuses(".: it is a folder, not a file");
}

#[test]
fn nodes_in_another_order_are_matched_by_path() {
    let sandbox = Sandbox::new();
    let mut file = keyframe_file(4);
    file["nodes"].as_array_mut().unwrap().reverse();
    for keyframe in file["keyframes"].as_array_mut().unwrap() {
        keyframe["pose"].as_array_mut().unwrap().reverse();
    }
    sandbox.write("a.json", keyframe_file(4).to_string());
    sandbox.write("reversed.json", file.to_string());
    let sampled = |name| sandbox.run(&["sample", name, "--at", "0,0.3,1"]).succeeds();
    assert_eq!(sampled("a.json"), sampled("reversed.json"));
}

#[test]
fn rotations_near_to_unit_are_kept_and_those_less_near_normalised() {
    let sandbox = Sandbox::new();
    let mut file = keyframe_file(4);
    file["keyframes"][1]["pose"][HEAD]["rotation"] = json!([0.0, 0.6, 0.0, 0.800_000_4]);
    file["keyframes"][2]["pose"][HEAD]["rotation"] = json!([0.0, 0.0, 0.0, 1.003]);
    sandbox.write("a.json", file.to_string());
    let csv = sandbox.run(&["sample", "a.json", "--at", "0,1", "--format", "csv"]).succeeds();
    let heads: Vec<&str> = csv.lines().filter(|line| line.split(',').nth(1) == Some("11")).collect();
    assert_eq!(heads, ["0.0,11,1,0.75,0,0.8000004,0,0.6,0", "1.0,11,2,0.75,0,1,0,0,0"]);
}

#[test]
fn what_the_program_wrote_it_writes_again_to_the_byte() {
    let sandbox = Sandbox::new();
    sandbox.trace(
        "select robot2/head\nrotate x 33.3\ntranslate 0.1 -0.2 0.3\nkey n\nrotate y 12\nkey n\nkey t\nkey +\nkey w\n",
    );
    let written = sandbox.read("animation.json");
    assert!(written.starts_with("{\n  \"format\": \"inbetween.keyframes\",\n  \"version\": 1,\n"));
    std::fs::remove_file(sandbox.path("animation.json")).unwrap();
    sandbox.write("copy.json", &written);
    sandbox.write("again.txt", "key i\nkey w\n");
    sandbox.run(&["script", "again.txt", "--keyframes", "copy.json"]).succeeds();
    assert_eq!(sandbox.read("copy.json"), written);
    assert_eq!(sandbox.run(&["check", "copy.json"]).succeeds(), "copy.json: ok, 2 keyframes, catmull-rom, 1900 ms\n");
}
