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
    assert_eq!((missing.status, missing.stderr.as_str()), (1, ""));
    assert!(missing.stdout.contains("rest: the reference dir/rest.png is missing"), "{}", missing.stdout);
    assert!(missing.stdout.ends_with("4 of 4 not as they should be: see dir/actual\n"), "{}", missing.stdout);
    assert!(!sandbox.path("dir/rest.png").exists());
    let accepted = sandbox.run(&["verify", "dir", "--update"]).succeeds();
    assert_eq!(accepted, "rest: new\nmiddle: new\nkey: new\nturning: new\n");
    assert!(sandbox.path("dir/third.png").exists());
    let verified = sandbox.run(&["verify", "dir"]).succeeds();
    assert!(verified.starts_with("rest: score 0.000000, within the tolerance 0.06"), "{verified}");
    assert!(verified.ends_with("all 4 as they should be\n"), "{verified}");
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
    assert_eq!((outcome.status, outcome.stderr.as_str()), (1, ""));
    assert!(outcome.stdout.contains("1 of 4 not as they should be: see found"), "{}", outcome.stdout);
    assert!(sandbox.path("found/key-difference.png").exists() && sandbox.path("found/key.png").exists());
    assert!(!sandbox.path("found/middle-difference.png").exists() && !sandbox.path("dir/actual").exists());
    sandbox.write("dir/a.json", keyframe_file(5).to_string());
    sandbox.run(&["verify", "dir", "-o", "found"]).succeeds();
    assert!(!sandbox.path("found/key-difference.png").exists(), "it told of another run");
}

#[test]
fn a_reference_of_another_size_or_none_at_all_is_a_difference() {
    let sandbox = sandbox();
    list(&sandbox, &json!([{"name": "rest", "size": [64, 48]}]));
    sandbox.run(&["verify", "dir", "--update"]).succeeds();
    list(&sandbox, &json!([{"name": "rest", "size": [48, 64]}]));
    let outcome = sandbox.run(&["verify", "dir"]);
    assert_eq!(outcome.status, 1);
    assert!(outcome.stdout.contains("rest: the pictures have different sizes: 64x48 and 48x64"), "{}", outcome.stdout);
    sandbox.write("dir/rest.png", "no picture");
    assert!(sandbox.run(&["verify", "dir"]).stdout.contains("rest: dir/rest.png: it is no PNG"));
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
    check(json!({"name": "a", "file": "a.json", "at": 7}), "picture \"a\": dir/a.json: key time 7 is outside 0 to 2");
    check(json!({"name": "a", "tolerance": 2}), "tolerance is 2, expected 0 to 1");
    check(json!({"name": "a", "colour": "red"}), "unknown field \"colour\", expected name, ");
    sandbox.run(&["verify", "none"]).refuses("none/pictures.json: there is no such file or folder");
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
