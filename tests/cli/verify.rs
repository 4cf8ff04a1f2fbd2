use serde_json::{Value, json};

use crate::sandbox::{Sandbox, keyframe_file};

/// A folder with a list of pictures of an animation and no references yet.
fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new();
    std::fs::create_dir(sandbox.path("dir")).unwrap();
    sandbox.write("dir/a.json", keyframe_file(5).to_string());
    list(
        &sandbox,
        &json!([
            {"name": "rest", "size": [64, 48]},
            {"name": "middle", "file": "a.json", "at": 0.5, "size": [64, 48], "interpolation": "linear", "tolerance": 0.02},
            {"name": "key", "file": "a.json", "keyframe": 3, "size": [64, 48], "reference": "third.png"},
            {"name": "turning", "scene": "cylinder", "seconds": 1.5, "size": [64, 48], "camera": "turntable"},
        ]),
    );
    sandbox
}

fn list(sandbox: &Sandbox, pictures: &Value) {
    let list = json!({"format": "inbetween.pictures", "version": 1, "pictures": pictures});
    sandbox.write("dir/pictures.json", list.to_string());
}

#[test]
fn references_are_missed_accepted_and_kept() {
    let sandbox = sandbox();
    let missing = sandbox.run(&["verify", "dir"]);
    assert_eq!(missing.status, 1);
    assert!(
        missing.stderr.starts_with("FAIL rest: the reference dir/rest.png is missing (--update"),
        "{}",
        missing.stderr
    );
    assert_eq!(missing.stderr.lines().count(), 4);
    assert_eq!(
        missing.stdout,
        "dir/actual holds what each run draws: put actual/ into dir/.gitignore\n\
         4 of 4 not as they should be: see dir/actual/index.html\n"
    );
    assert!(!sandbox.path("dir/rest.png").exists());
    let accepted = sandbox.run(&["verify", "dir", "--update"]).succeeds();
    let words = "rest: new\nmiddle: new\nkey: new\nturning: new\n";
    assert_eq!(accepted, format!("{words}4 new, 0 updated, 0 unchanged, 0 not drawn\n"));
    assert!(sandbox.path("dir/third.png").exists());
    let verified = sandbox.run(&["verify", "dir"]).succeeds();
    assert!(
        verified.starts_with("ok   rest: score 0.000000, within the tolerance 0.06; FLIP's mean 0.000000"),
        "{verified}"
    );
    assert!(verified.ends_with("all 4 as they should be\n") && !verified.contains("gitignore"), "{verified}");
    assert_eq!(sandbox.run(&["verify", "dir", "--quiet"]).succeeds(), "all 4 as they should be\n");
    assert!(sandbox.run(&["verify", "dir", "--update"]).succeeds().contains("key: unchanged"));
}

#[test]
fn a_difference_is_status_1_and_shown() {
    let sandbox = sandbox();
    sandbox.run(&["verify", "dir", "--update"]).succeeds();
    let mut file = keyframe_file(5);
    file["keyframes"][3]["pose"][12]["translation"] = json!([1.6, 1.0, 0.0]);
    sandbox.write("dir/a.json", file.to_string());
    let outcome = sandbox.run(&["verify", "dir", "-o", "found"]);
    assert_eq!(outcome.status, 1);
    assert!(
        outcome.stderr.starts_with("FAIL key: score 0.") && outcome.stderr.lines().count() == 1,
        "{}",
        outcome.stderr
    );
    assert!(outcome.stdout.contains("put found/ into .gitignore\n"), "{}", outcome.stdout);
    assert!(outcome.stdout.ends_with("1 of 4 not as they should be: see found/index.html\n"), "{}", outcome.stdout);
    let of_key = ["found/key-difference.png", "found/key-reference.png", "found/key.png"];
    assert!(of_key.iter().all(|name| sandbox.path(name).exists()));
    assert!(!sandbox.path("found/middle-difference.png").exists() && !sandbox.path("dir/actual").exists());
    let page = sandbox.read("found/index.html");
    let pictures: Vec<&str> = page.split("<img src=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    assert_eq!(pictures, ["key-reference.png", "key.png", "key-difference.png"]);
    assert!(page.contains("<h1 class=\"bad\">1 of 4 not as they should be"), "{page}");
    let quiet = sandbox.run(&["verify", "dir", "-o", "found", "--quiet"]);
    assert_eq!(quiet.stdout, "1 of 4 not as they should be: see found/index.html\n");
    assert_eq!(quiet.stderr, outcome.stderr);
    sandbox.run(&["verify", "dir", "-o", "found", "--tolerance", "1"]).succeeds();
    sandbox.run(&["verify", "dir", "-o", "found", "--only", "rest", "--only", "m?d*"]).succeeds();
    sandbox.write("dir/a.json", keyframe_file(5).to_string());
    sandbox.run(&["verify", "dir", "-o", "found"]).succeeds();
    assert!(of_key.map(|name| sandbox.path(name).exists()) == [false, false, true], "they told of another run");
    assert!(!sandbox.read("found/index.html").contains("<img"));
}

#[test]
fn a_reference_of_another_size_or_none_at_all_is_a_difference() {
    let sandbox = sandbox();
    list(&sandbox, &json!([{"name": "rest", "size": [64, 48]}]));
    sandbox.run(&["verify", "dir", "--update"]).succeeds();
    list(&sandbox, &json!([{"name": "rest", "size": [48, 64]}]));
    let outcome = sandbox.run(&["verify", "dir"]);
    assert_eq!(outcome.status, 1);
    assert!(
        outcome.stderr.contains("FAIL rest: the pictures have different sizes: 64x48 and 48x64"),
        "{}",
        outcome.stderr
    );
    sandbox.write("dir/rest.png", "no picture");
    assert!(sandbox.run(&["verify", "dir"]).stderr.contains("FAIL rest: dir/rest.png: it is no PNG"));
}

#[test]
fn a_bad_list_is_bad_input_and_says_where() {
    let sandbox = sandbox();
    let check = |picture: Value, sentence: &str| {
        list(&sandbox, &json!([picture]));
        let outcome = sandbox.run(&["verify", "dir"]);
        assert_eq!((outcome.status, outcome.stdout.as_str()), (1, ""));
        assert!(outcome.stderr.contains(sentence), "{}", outcome.stderr);
    };
    check(json!({"name": "a", "file": "../secret.json"}), "picture \"a\": \"../secret.json\" leads out of the folder");
    check(json!({"name": "../a"}), "the name names files");
    check(json!({"name": "a", "interpolation": "cubic"}), "unknown interpolation \"cubic\"");
    check(json!({"name": "a", "at": 0.5}), "\"at\" and \"keyframe\" need a \"file\"");
    check(
        json!({"name": "a", "file": "a.json", "at": "7"}),
        "line 1 column 52: expected a key time, or a list of them",
    );
    check(json!({"name": "a", "file": "a.json", "at": 1, "keyframe": 1}), "cannot go together");
    check(json!({"name": "a", "file": "a.json", "at": [1], "reference": "b.png"}), "\"reference\" names one picture");
    check(json!({"name": "a", "file": "a.json", "frames": "0-5"}), "\"frames\" needs \"fps\"");
    check(json!({"name": "a", "file": "a.json", "fps": 5}), "\"fps\" needs \"frames\"");
    check(json!({"name": "a", "file": "a.json", "fps": 0, "frames": "1"}), "fps is 0, expected 1 to 1000");
    check(json!({"name": "a", "file": "a.json", "fps": 5, "frames": "5-1"}), "\"5-1\" ends before it begins");
    check(json!({"name": "a\nb"}), "no control character");
    check(json!({"name": "a", "tolerance": 2}), "tolerance is 2, expected 0 to 1");
    check(json!({"name": "a", "colour": "red"}), "unknown field \"colour\", expected name, ");
    sandbox.run(&["verify", "none"]).refuses("none/pictures.json: there is no such file or folder");
    list(&sandbox, &json!([{"name": "a", "file": "a.json", "at": [0, 0.0]}]));
    sandbox.run(&["verify", "dir"]).refuses("dir/pictures.json: picture \"a-0\": stands twice");
    list(&sandbox, &json!([{"name": "a"}]));
    sandbox.run(&["verify", "dir", "--only", "b*"]).refuses("dir/pictures.json: no picture has a name like \"b*\"");
    sandbox.run(&["verify", "dir", "--only", "[a"]).misuses();
    sandbox.run(&["verify", "dir", "--json", "--junit", "-"]).misuses();
    sandbox.run(&["verify", "dir", "--junit", "dir/pictures.json"]).misuses();
}

#[test]
fn a_picture_that_cannot_be_drawn_does_not_stop_the_rest() {
    let sandbox = sandbox();
    list(
        &sandbox,
        &json!([
            {"name": "gone", "file": "none.json", "size": [64, 48]},
            {"name": "late", "file": "a.json", "at": 7, "size": [64, 48]},
            {"name": "wide", "size": [1_000_000, 1]},
            {"name": "rest", "size": [64, 48]},
        ]),
    );
    let accepted = sandbox.run(&["verify", "dir", "--update"]);
    assert_eq!(accepted.stdout, "rest: new\n1 new, 0 updated, 0 unchanged, 3 not drawn\n");
    let lines: Vec<&str> = accepted.stderr.lines().collect();
    assert_eq!((accepted.status, lines[0]), (1, "FAIL gone: dir/none.json: there is no such file or folder"));
    assert!(lines[1].starts_with("FAIL late: dir/a.json: key time 7 is outside 0 to 2"), "{}", lines[1]);
    assert!(lines[2].starts_with("FAIL wide: ") && lines.len() == 3, "{}", lines[2]);
    let verified = sandbox.run(&["verify", "dir"]);
    assert_eq!((verified.status, verified.stderr), (1, accepted.stderr));
    assert!(verified.stdout.contains("ok   rest: score 0.000000"), "{}", verified.stdout);
}

#[test]
fn one_entry_asks_for_many_pictures_and_defaults_are_for_all() {
    let sandbox = sandbox();
    let list = json!({
        "format": "inbetween.pictures", "version": 1,
        "defaults": {"file": "a.json", "size": [64, 48], "fps": 2, "interpolation": "linear"},
        "pictures": [
            {"name": "at", "at": [0, 0.5, 1.25]},
            {"name": "film", "frames": "0-6:3,8", "size": [48, 64]},
            {"name": "one", "frames": "4"},
            {"name": "turn", "scene": "cylinder", "file": "a.json", "at": 0.5},
        ],
    });
    sandbox.write("dir/pictures.json", list.to_string());
    sandbox.write("dir/orphan.png", "nobody looks at it");
    let accepted = sandbox.run(&["verify", "dir", "--update", "--only", "[afo]*"]).succeeds();
    assert_eq!(accepted.lines().last(), Some("8 new, 0 updated, 0 unchanged, 0 not drawn"));
    // 2000 ms between keyframes: frame 4 of 2 a second is at key time 1.
    std::fs::create_dir(sandbox.path("film")).unwrap();
    sandbox
        .run(&[
            "render",
            "dir/a.json",
            "-o",
            "film",
            "--fps",
            "2",
            "--size",
            "48x64",
            "--samples",
            "1",
            "--interpolation",
            "linear",
        ])
        .succeeds();
    for number in ["00000", "00003", "00006", "00008"] {
        let read = |name: String| std::fs::read(sandbox.path(&name)).unwrap();
        assert_eq!(read(format!("dir/film-{number}.png")), read(format!("film/frame-{number}.png")), "{number}");
    }
    let verified = sandbox.run(&["verify", "dir", "--only", "[afo]*"]).succeeds();
    assert!(
        verified.contains("ok   at-1.25: score 0.0") && verified.contains("ok   one-00004: score 0.0"),
        "{verified}"
    );
    assert!(verified.contains("dir/orphan.png: no picture of the list has it as its reference\n"), "{verified}");
    assert_eq!(verified.matches("no picture of the list").count(), 1);
    let beyond = json!({
        "format": "inbetween.pictures", "version": 1,
        "pictures": [{"name": "film", "file": "a.json", "fps": 2, "frames": "8-9", "size": [64, 48]}],
    });
    sandbox.write("dir/pictures.json", beyond.to_string());
    let outcome = sandbox.run(&["verify", "dir"]);
    assert!(
        outcome.stderr.contains("FAIL film-00009: dir/a.json: there is no frame 9: at 2 fps they are 0 to 8\n"),
        "{}",
        outcome.stderr
    );
}

#[test]
fn results_are_json_and_junit_too() {
    let sandbox = sandbox();
    sandbox.run(&["verify", "dir", "--update"]).succeeds();
    std::fs::remove_file(sandbox.path("dir/rest.png")).unwrap();
    std::fs::rename(sandbox.path("dir/turning.png"), sandbox.path("dir/third.png")).unwrap();
    std::fs::remove_file(sandbox.path("dir/a.json")).unwrap();
    let mut only_scenes = Sandbox::outcome(sandbox.command(&["verify", "dir", "--json", "--junit", "junit.xml"]));
    assert_eq!((only_scenes.status, only_scenes.stderr.lines().count()), (1, 4));
    let found: Value = serde_json::from_str(&only_scenes.stdout).unwrap();
    let results: Vec<&str> =
        found["pictures"].as_array().unwrap().iter().map(|picture| picture["result"].as_str().unwrap()).collect();
    assert_eq!(results, ["missing", "undrawn", "undrawn", "missing"]);
    assert_eq!(
        (&found["good"], &found["bad"], &found["page"]),
        (&json!(0), &json!(4), &json!("dir/actual/index.html"))
    );
    assert_eq!(found["pictures"][1]["tolerance"], json!(0.02));
    let xml = sandbox.read("junit.xml");
    assert!(xml.contains("<testsuites tests=\"4\" failures=\"2\" errors=\"2\" skipped=\"0\">"), "{xml}");
    assert!(xml.contains("<testcase name=\"middle\" classname=\"dir\" file=\"dir/middle.png\">"), "{xml}");
    assert!(xml.contains("<error message=\"dir/a.json: there is no such file or folder\""), "{xml}");
    sandbox.run(&["verify", "dir", "--update", "--only", "rest"]).succeeds();
    only_scenes = sandbox.run(&["verify", "dir", "--only", "rest", "--junit", "-"]);
    assert_eq!(only_scenes.status, 0);
    assert!(only_scenes.stdout.contains("<property name=\"score\" value=\"0\"/>"), "{}", only_scenes.stdout);
    assert!(only_scenes.stderr.ends_with("the picture is as it should be\n"), "{}", only_scenes.stderr);
    let found: Value =
        serde_json::from_str(&sandbox.run(&["verify", "dir", "--only", "rest", "--json"]).succeeds()).unwrap();
    assert_eq!((&found["pictures"][0]["result"], &found["pictures"][0]["score"]), (&json!("ok"), &json!(0.0)));
}

#[test]
fn in_github_actions_failures_are_annotations_and_a_summary() {
    let sandbox = sandbox();
    list(&sandbox, &json!([{"name": "a,b", "size": [64, 48]}, {"name": "rest", "size": [64, 48]}]));
    sandbox.run(&["verify", "dir", "--update", "--only", "rest"]).succeeds();
    sandbox.write("summary.md", "before\n");
    let mut command = sandbox.command(&["verify", "dir"]);
    command.env("GITHUB_ACTIONS", "true").env("GITHUB_STEP_SUMMARY", sandbox.path("summary.md"));
    let outcome = Sandbox::outcome(command);
    let reason = "the reference dir/a,b.png is missing (--update accepts what is drawn now)";
    let annotation = "::error file=dir/pictures.json,title=Picture a%2Cb::";
    assert_eq!(outcome.stderr, format!("FAIL a,b: {reason}\n{annotation}a,b: {reason}\n"));
    assert!(!outcome.stdout.contains("gitignore"), "{}", outcome.stdout);
    let summary = sandbox.read("summary.md");
    assert!(summary.starts_with("before\n### Reference pictures of dir/pictures.json\n\n1 of 2 not"), "{summary}");
    assert!(summary.contains("| a,b | the reference dir/a,b.png is missing"), "{summary}");
}

#[test]
fn the_documented_list_verifies() {
    let sandbox = sandbox();
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/manual/ci.md")).unwrap();
    let example = text.split("```json\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    sandbox.write("dir/pictures.json", example);
    std::fs::rename(sandbox.path("dir/a.json"), sandbox.path("dir/wave.json")).unwrap();
    sandbox.run(&["verify", "dir", "--update"]).succeeds();
    sandbox.run(&["verify", "dir"]).succeeds();
}
