//! Several files in one command: each is done by itself, and the exit status is the worst.

use serde_json::{Value, json};

use crate::sandbox::{HEAD, Sandbox, keyframe_file};

/// Two good files, a text of one of them, and a bad file.
fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new();
    sandbox.write("a.json", keyframe_file(5).to_string());
    let mut other = keyframe_file(5);
    other["keyframes"][2]["pose"][HEAD]["translation"] = json!([9, 9, 9]);
    sandbox.write("b.json", other.to_string());
    sandbox.run(&["convert", "a.json", "-o", "rows.txt", "--to", "rows", "--exact"]).succeeds();
    sandbox.write("bad.txt", "1 2 3 four\n");
    sandbox
}

/// The objects on standard output, one a line.
fn objects(stdout: &str) -> Vec<Value> {
    stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

#[test]
fn one_bad_file_of_several_is_said_and_the_others_are_converted() {
    let sandbox = sandbox();
    let outcome = sandbox.run(&["convert", "b.json", "bad.txt", "rows.txt", "none.txt", "-o", "made", "--to", "csv"]);
    assert_eq!(outcome.status, 1);
    assert!(outcome.stdout.contains("b.json: 5 keyframes of 22 nodes") && outcome.stdout.contains("\nrows.txt: "));
    let said: Vec<&str> = outcome.stderr.lines().collect();
    assert!(said[0].starts_with("bad.txt: line 1 column 7: ") && said[1].starts_with("none.txt: "), "{said:?}");
    assert_eq!(said.len(), 2);
    let mut made: Vec<_> = std::fs::read_dir(sandbox.path("made")).unwrap().map(|e| e.unwrap().file_name()).collect();
    made.sort();
    assert_eq!(made, ["b.csv", "rows.csv"]);
    let by_itself = sandbox.run(&["convert", "rows.txt", "-o", "rows.csv"]);
    assert_eq!(by_itself.status, 0);
    assert_eq!(sandbox.read("made/rows.csv"), sandbox.read("rows.csv"), "the ending tells the layout");

    let outcome = sandbox.run(&["convert", "rows.txt", "bad.txt", "-o", "made", "--json"]);
    let found = objects(&outcome.stdout);
    assert_eq!((outcome.status, found.len()), (1, 2));
    assert_eq!(found[0]["summary"], "5 keyframes of 22 nodes, layout rows");
    assert_eq!(found[0]["output"].as_str().unwrap().replace('\\', "/"), "made/rows.json");
    assert_eq!((&found[1]["file"], found[1]["problems"].as_array().unwrap().len()), (&json!("bad.txt"), 1));
}

#[test]
fn several_results_need_a_folder_and_a_name_each() {
    let sandbox = sandbox();
    std::fs::create_dir(sandbox.path("other")).unwrap();
    std::fs::copy(sandbox.path("rows.txt"), sandbox.path("other/a.txt")).unwrap();
    for (arguments, sentence) in [
        (&["convert", "a.json", "b.json", "-o", "-"][..], "a folder cannot be standard input or standard output"),
        (&["convert", "a.json", "b.json", "-o", "made.json"], "made.json has the name of a file"),
        (&["convert", "b.json", "a.json", "other/a.txt", "-o", "made"], "a.json and other/a.txt would both become "),
        (&["sample", "a.json", "b.json"], "several FILEs need --output with a folder"),
        (&["sample", "a.json", "other/a.txt", "-o", "made"], "a.json and other/a.txt would both become "),
        (&["compare", "a.png", "b.png", "c.png", "-o", "d.png"], "d.png has the name of a file"),
        (&["convert", "a.json", "-o", "made.json", "--to", "rows"], "ends in .json contradicts --to rows"),
        (&["convert", "a.json", "-o", "made.CSV", "--to", "rows"], "ends in .csv contradicts --to rows"),
        (&["sample", "a.json", "-o", "made.csv", "--format", "json"], "ends in .csv contradicts --format json"),
        (&["sample", "a.json", "-o", "made.csv", "--json"], "ends in .csv contradicts --json"),
        (&["sample", "a.json", "-o", "made.csv", "--space", "world"], "--space world is printed as JSON"),
        (&["render", "a.json", "-o", "made.png", "--format", "gif"], "ends in .png contradicts --format gif"),
        (&["render", "a.json", "-o", "other", "--fps", "2", "--format", "png"], "--format is for one file"),
        (&["render", "a.json", "-o", "-", "--format", "gif", "--manifest", "m.json"], "--output needs a file"),
    ] {
        let outcome = sandbox.run(arguments);
        assert!(outcome.stderr.contains(sentence), "{arguments:?}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(&format!("Usage: inbetween {}", arguments[0])), "{}", outcome.stderr);
        outcome.misuses();
    }
    assert_eq!(sandbox.names(), ["a.json", "b.json", "bad.txt", "other", "rows.txt"]);
    let text = sandbox.run(&["convert", "a.json", "-o", "made.txt"]);
    assert!(text.status == 0 && sandbox.read("made.txt").starts_with("5 22\n"), "{}", text.stderr);
}

#[test]
fn samples_of_several_files_are_those_of_each() {
    let sandbox = sandbox();
    let outcome = sandbox.run(&["sample", "a.json", "bad.txt", "rows.txt", "--at", "0,1.5", "-o", "made/"]);
    assert_eq!((outcome.status, outcome.stdout.as_str()), (1, ""));
    assert_eq!(
        outcome.stderr,
        "bad.txt: line 1 column 7: found \"four\", expected a number\n\
         rows.txt: read as a text: 5 keyframes of 22 nodes, layout rows\n"
    );
    let alone = sandbox.run(&["sample", "a.json", "--at", "0,1.5"]).succeeds();
    assert_eq!(sandbox.read("made/a.json"), alone);
    assert_eq!(sandbox.read("made/rows.json"), alone, "a text gives the same");
    sandbox.run(&["sample", "a.json", "-o", "made/one.csv", "--fps", "2"]).succeeds();
    assert_eq!(
        sandbox.read("made/one.csv"),
        sandbox.run(&["sample", "a.json", "--fps", "2", "--format", "csv"]).succeeds()
    );
}

#[test]
fn a_quiet_check_says_problems_and_a_summary() {
    let sandbox = sandbox();
    assert_eq!(sandbox.run(&["check", "-q", "a.json", "b.json"]).succeeds(), "all 2 are good\n");
    let outcome = sandbox.run(&["check", "--quiet", "a.json", "bad.txt", "rows.txt", "none.txt"]);
    assert_eq!((outcome.status, outcome.stdout.as_str()), (1, ""));
    let said: Vec<&str> = outcome.stderr.lines().collect();
    assert!(said[0].starts_with("bad.txt: ") && said[1].starts_with("none.txt: "), "{said:?}");
    assert_eq!(said[2..], ["2 of 4 are bad"]);
    let outcome = sandbox.run(&["check", "--json", "a.json", "bad.txt", "rows.txt"]);
    let found = objects(&outcome.stdout);
    assert_eq!((outcome.status, found.len()), (1, 3));
    assert_eq!((&found[0]["ok"], &found[0]["keyframes"], &found[0]["text"]), (&json!(true), &json!(5), &json!(null)));
    assert_eq!((&found[1]["ok"], found[1]["problems"].as_array().unwrap().len()), (&json!(null), 1));
    assert_eq!(found[2]["text"]["summary"], "5 keyframes of 22 nodes, layout rows");
}

#[test]
fn one_reference_is_compared_with_several_animations() {
    let sandbox = sandbox();
    sandbox.run(&["diff", "a.json", "a.json", "rows.txt", "--quiet"]).succeeds();
    let outcome = sandbox.run(&["diff", "a.json", "rows.txt", "b.json", "--quiet"]);
    assert_eq!((outcome.status, outcome.stderr.as_str(), outcome.stdout.lines().count()), (1, "", 1));
    assert!(outcome.stdout.starts_with("b.json: Beyond the tolerances"), "{}", outcome.stdout);
    let outcome = sandbox.run(&["diff", "a.json", "b.json", "bad.txt", "a.json", "--json"]);
    let found = objects(&outcome.stdout);
    assert_eq!((outcome.status, found.len()), (2, 3), "trouble is worse than a difference");
    assert_eq!((&found[0]["b"], &found[0]["within_tolerance"]), (&json!("b.json"), &json!(false)));
    assert_eq!((&found[1]["b"], found[1]["problems"].as_array().unwrap().len()), (&json!("bad.txt"), 1));
    assert_eq!((&found[2]["b"], &found[2]["within_tolerance"]), (&json!("a.json"), &json!(true)));
}

fn picture(sandbox: &Sandbox, name: &str, level: u8) {
    let path = sandbox.path(name);
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    image::RgbImage::from_pixel(24, 16, image::Rgb([level, 90, 90])).save(path).unwrap();
}

#[test]
fn folders_of_images_are_compared_by_names() {
    let sandbox = Sandbox::new();
    for (name, level) in [("a/one.png", 90), ("b/one.png", 90), ("a/two.png", 90), ("b/two.png", 200)] {
        picture(&sandbox, name, level);
    }
    let outcome = sandbox.run(&["compare", "a", "b", "-o", "made"]);
    let said: Vec<&str> = outcome.stdout.lines().collect();
    assert_eq!((outcome.status, outcome.stderr.as_str(), said.len()), (1, "", 2));
    assert!(said[0].contains("one.png: score 0.000000, within") && said[1].contains("two.png: score "), "{said:?}");
    assert!(sandbox.path("made/one.png").exists() && sandbox.path("made/two.png").exists());
    picture(&sandbox, "a/three.png", 90);
    picture(&sandbox, "b/two.png", 90);
    sandbox.write("b/notes.txt", "no picture");
    let outcome = sandbox.run(&["compare", "a", "b", "--quiet"]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (1, ""));
    assert!(outcome.stdout.contains("three.png: b has no picture of this name"), "{}", outcome.stdout);
    assert_eq!(outcome.stdout.lines().count(), 1);
    picture(&sandbox, "b/three.png", 90);
    sandbox.run(&["compare", "a", "b", "--quiet"]).succeeds();
    sandbox.run(&["compare", "a", "b/one.png"]).misuses();
    sandbox.run(&["compare", "a", "b", "b"]).misuses();
    picture(&sandbox, "c/one.png", 90);
    picture(&sandbox, "d/one.png", 90);
    sandbox.run(&["compare", "c", "d", "-o", "one-of-them"]).succeeds();
    assert!(sandbox.path("one-of-them/one.png").exists(), "a folder also for one picture");
    std::fs::create_dir_all(sandbox.path("empty/more")).unwrap();
    let outcome = sandbox.run(&["compare", "empty", "empty/more"]);
    assert_eq!((outcome.status, outcome.stdout.as_str()), (2, ""));
    assert!(outcome.stderr.contains("neither folder has a PNG image"), "{}", outcome.stderr);
}

#[test]
fn one_image_is_compared_with_several() {
    let sandbox = Sandbox::new();
    for (name, level) in [("a.png", 90), ("same.png", 90), ("other.png", 200)] {
        picture(&sandbox, name, level);
    }
    let outcome = sandbox.run(&["compare", "a.png", "same.png", "other.png", "none.png", "--json"]);
    let found = objects(&outcome.stdout);
    assert_eq!((outcome.status, found.len()), (2, 3));
    assert_eq!((&found[0]["within"], &found[0]["score"]), (&json!(true), &json!(0.0)));
    assert_eq!((&found[1]["b"], &found[1]["tolerance"]), (&json!("other.png"), &json!(0.06)));
    assert_eq!(found[2]["problems"], json!(["none.png: there is no such file or folder"]));
    let alone = sandbox.run(&["compare", "a.png", "other.png", "--quiet"]);
    assert_eq!((alone.status, alone.stdout.lines().count()), (1, 1));
    assert_eq!(sandbox.run(&["compare", "a.png", "same.png", "--quiet"]).succeeds(), "");
}

#[test]
fn a_film_can_go_to_standard_output() {
    let sandbox = sandbox();
    let film = ["a.json", "--fps", "2", "--size", "16x12"];
    sandbox.run(&[&["render", "-o", "film.gif"], &film[..]].concat()).succeeds();
    let output = |arguments: &[&str]| sandbox.command(arguments).output().unwrap().stdout;
    let bytes = std::fs::read(sandbox.path("film.gif")).unwrap();
    assert!(output(&[&["render", "-o", "-", "--format", "gif"], &film[..]].concat()) == bytes);
    sandbox.run(&[&["render", "-o", "frames/"], &film[..]].concat()).succeeds();
    assert!(output(&["join", "frames", "--fps", "2", "-o", "-", "--format", "gif"]) == bytes);
}
