use crate::sandbox::{HEAD, Sandbox, keyframe_file};

const LAYOUTS: [&str; 10] = [
    "header",
    "header-two-lines",
    "header-keyframe-a-line",
    "header-quaternion-first",
    "rows",
    "frames",
    "end",
    "csv",
    "pairs",
    "endless",
];

const STUDENT: &str = include_str!("../data/student-files/n-m-header-two-lines-per-rbt.txt");

/// A sandbox with `a.json`, a keyframe file as the program writes it.
fn with_keyframes() -> Sandbox {
    let sandbox = Sandbox::new();
    let mut file = keyframe_file(5);
    let third = 1.0_f64 / 3.0;
    file["keyframes"][1]["pose"][HEAD]["rotation"] = serde_json::json!([0.6, 0.0, 0.0, -0.8]);
    file["keyframes"][2]["pose"][HEAD]["translation"] = serde_json::json!([third, -1e-16, 123_456.789]);
    sandbox.write("raw.json", file.to_string());
    let report = sandbox.run(&["convert", "raw.json", "-o", "a.json"]).succeeds();
    assert_eq!(report, "raw.json: 5 keyframes of 22 nodes, keyframe file\n");
    sandbox
}

#[test]
fn there_and_back_through_every_layout() {
    let sandbox = with_keyframes();
    for layout in LAYOUTS {
        sandbox.run(&["convert", "a.json", "--to", layout, "--exact", "-o", "a.text"]).succeeds();
        let report = sandbox.run(&["convert", "a.text", "-o", "b.json"]).succeeds();
        assert!(report.starts_with(&format!("a.text: 5 keyframes of 22 nodes, layout {layout}\n")), "{report}");
        assert!(report.contains("\nsure: order: "), "{report}");
        assert_eq!(sandbox.read("b.json"), sandbox.read("a.json"), "{layout}");
        sandbox.run(&["convert", "a.json", "--to", layout, "-o", "six.text"]).succeeds();
        assert!(sandbox.read("six.text").contains("0.333333"));
        assert!(sandbox.read("a.text").contains("0.33333334"));
        sandbox.run(&["convert", "six.text", "--to", layout, "-o", "again.text"]).succeeds();
        assert_eq!(sandbox.read("again.text"), sandbox.read("six.text"), "{layout}");
    }
    let help = sandbox.run(&["convert", "--help"]).succeeds();
    assert!(LAYOUTS.iter().all(|layout| help.contains(&format!("- {layout}:"))), "{help}");
}

#[test]
fn a_students_file_and_its_report() {
    let sandbox = Sandbox::new();
    sandbox.write("a.txt", STUDENT);
    assert_eq!(
        sandbox.run(&["convert", "a.txt", "-o", "a.json"]).succeeds(),
        "a.txt: 12 keyframes of 24 nodes, layout header-two-lines\n\
         sure: header: 12 keyframes of 24 nodes, as many numbers as follow\n\
         sure: order: translation first: only those four numbers are unit in all 288 rows\n\
         note: nodes: 2 more than the scene has: the first 22 are used, not 22 and 23 (two lights)\n\
         sure: joints of robot1, robot2: matched by the offsets of keyframe 0: right_shoulder, right_elbow, left_shoulder, left_elbow, \
         head, right_hip, right_knee, left_hip, left_knee\n\
         note: offsets differ from the scene's by up to 0.25 in length, and stay as the file has them\n"
    );
    assert_eq!(sandbox.run(&["check", "a.json"]).succeeds(), "a.json: ok, 12 keyframes, linear, 2000 ms\n");
    assert_eq!(sandbox.json("a.json")["keyframes"][5]["pose"][HEAD]["translation"][0], 0.383_683);
}

#[test]
fn bad_input_writes_nothing() {
    let sandbox = Sandbox::new();
    sandbox.write("a.txt", STUDENT.replacen("13.213", "-nan(ind)", 1));
    sandbox.write("short.txt", STUDENT.lines().take(100).collect::<Vec<_>>().join("\n"));
    sandbox.write("bad.json", "{\"format\": 1}");
    sandbox.write("list.txt", "sky\nearth\n");
    sandbox.write("out.json", "as it was");
    let convert = |input: &str| sandbox.run(&["convert", input, "-o", "out.json"]);
    convert("a.txt").refuses("a.txt: line 2 column 19: \"-nan(ind)\" is not finite, expected a number");
    convert("short.txt").refuses(
        "short.txt: line 1 column 1: the header says 12 keyframes of 24 nodes, expected 288 rows (2016 numbers) after it, \
         found 49 rows and 3 numbers (346 in all); --salvage takes the whole keyframes",
    );
    convert("bad.json").refuses("bad.json: line 1 column 12: found 1, expected a text in double quotes");
    convert("none.txt").refuses("none.txt: there is no such file or folder");
    sandbox
        .run(&["convert", "short.txt", "-o", "out.json", "--joints", "list.txt"])
        .refuses("list.txt: line 2 column 1: found \"earth\", expected a path that `inbetween nodes` prints, or -");
    assert_eq!(sandbox.read("out.json"), "as it was");
    let report = sandbox.run(&["convert", "short.txt", "-o", "out.json", "--salvage"]).succeeds();
    assert!(report.starts_with("short.txt: 2 keyframes of 24 nodes, "), "{report}");
    assert!(report.contains("warning: salvaged: the header says 12 keyframes of 24 nodes"), "{report}");
    assert_eq!(sandbox.json("out.json")["keyframes"].as_array().unwrap().len(), 2);
}

#[test]
fn wrong_usage() {
    let sandbox = with_keyframes();
    sandbox.run(&["convert"]).misuses();
    sandbox.run(&["convert", "a.json"]).misuses();
    sandbox.run(&["convert", "a.json", "-o", "b.txt", "--to", "xml"]).misuses();
    sandbox.run(&["convert", "a.json", "-o", "b.txt", "--order", "sideways"]).misuses();
    assert_eq!(sandbox.names(), ["a.json", "raw.json"]);
}

#[test]
fn empty_lists_need_a_header() {
    let sandbox = Sandbox::new();
    sandbox.write("a.json", keyframe_file(0).to_string());
    sandbox.run(&["convert", "a.json", "-o", "a.txt", "--to", "header"]).succeeds();
    assert_eq!(sandbox.read("a.txt"), "0 22\n");
    sandbox.run(&["convert", "a.json", "-o", "b.txt", "--to", "rows"]).refuses(
        "a.json: there are no keyframes, and only header, header-two-lines, header-keyframe-a-line, header-quaternion-first, csv can say so",
    );
}

#[test]
fn python_keys_give_a_scene() {
    let sandbox = Sandbox::new();
    sandbox.write("keys.py", "translate_keys = {0: vec(0, 0, 0), 2: vec(1, 1, 0)}\nscale_keys = {0: 1, 2: 0.5}\n");
    let report = sandbox.run(&["convert", "keys.py", "-o", "scene.json"]).succeeds();
    assert!(report.starts_with(
        "keys.py: a control node with 2 translations, 0 rotations and 2 scales, layout python, as a scene\n"
    ));
    let world = sandbox.run(&["sample", "--scene", "scene.json", "--seconds", "1", "--space", "world"]).succeeds();
    assert!(world.contains("[0.75, 0, 0, 0, 0, 0.75, 0, 0, 0, 0, 0.75, 0, 0.5, 0.5, 0, 1]"), "{world}");
    sandbox.run(&["convert", "keys.py", "-o", "a.txt", "--to", "csv"]).refuses(
        "keys.py: keys of a control node, which the layout csv cannot hold: a scene file ends in .json, without --to",
    );
    assert_eq!(sandbox.names(), ["keys.py", "scene.json"]);
}

#[test]
fn the_keyframe_file_of_a_script_may_be_a_text() {
    let sandbox = Sandbox::new();
    sandbox.write("animation.json", STUDENT);
    let trace = sandbox.trace("key i\nkey w\n");
    assert_eq!(
        trace[0]["message"],
        "Imported 12 keyframes from animation.json. Read as text: 12 keyframes of 24 nodes, layout header-two-lines."
    );
    assert_eq!(
        sandbox.run(&["check", "animation.json"]).succeeds(),
        "animation.json: ok, 12 keyframes, linear, 2000 ms\n"
    );
    sandbox.write("animation.json", "{0: vec(0, 0, 0), 2: vec(1, 1, 0)}");
    let trace = sandbox.trace("key n\nkey i\n");
    assert_eq!(
        trace[1]["message"],
        "animation.json: keys of a control node, which belong to a scene, not to the list: make a scene file of them with `inbetween convert`"
    );
    assert_eq!(trace[1]["keyframes"], 1);
    sandbox.write("animation.json", STUDENT.replacen("13.213", "1.#QNAN", 1));
    let trace = sandbox.trace("key n\nkey i\n");
    assert_eq!(trace[1]["message"], "animation.json: line 2 column 19: \"1.#QNAN\" is not finite, expected a number");
    assert_eq!(trace[1]["keyframes"], 1);
}
