//! Before anything is graded: `grade --check` and `grade --example`.

use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::grade::follows;
use crate::sandbox::{Sandbox, keyframe_file};

const RUBRIC: &str = r#"{"format": "inbetween.rubric", "version": 1, "reference": "reference.json",
    "points": {"readable": 1, "linear_playback": 5, "catmull_rom_playback": 5}}"#;

fn shipped(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/grading").join(name)
}

fn names(list: &Value) -> Vec<&str> {
    list.as_array().unwrap().iter().map(|name| name.as_str().unwrap()).collect()
}

#[test]
fn the_shipped_reference_reveals_every_known_mistake() {
    let sandbox = Sandbox::new();
    let known = inbetween::diagnosis::names().count() - 2;
    for rubric in ["rubric.json", "rubric.toml"] {
        let rubric = shipped(rubric);
        let text = sandbox.run(&["grade", "--check", rubric.to_str().unwrap()]).succeeds();
        assert!(text.contains(&format!("It reveals all {known} known mistakes: no-conditional-negation, ")), "{text}");
        let json = sandbox.run(&["grade", "--check", rubric.to_str().unwrap(), "--json"]).succeeds();
        let json: Value = serde_json::from_str(&json).unwrap();
        assert_eq!((names(&json["revealed"]).len(), &json["not_revealed"]), (known, &json!([])));
        assert_eq!(json["playbacks"], json!(["linear", "catmull-rom"]));
    }
}

#[test]
fn the_check_names_a_change_that_reveals_a_mistake() {
    let sandbox = Sandbox::new();
    sandbox.write("rubric.json", RUBRIC);
    let mut reference: Value =
        serde_json::from_str(&std::fs::read_to_string(shipped("reference.json")).unwrap()).unwrap();
    // Without signs of its own, keyframe 3 of robot1 does not reveal who forgets cn.
    let rotation = &mut reference["keyframes"][3]["pose"][2]["rotation"];
    *rotation = json!(rotation.as_array().unwrap().iter().map(|number| -number.as_f64().unwrap()).collect::<Vec<_>>());
    sandbox.write("reference.json", reference.to_string());
    let text = sandbox.run(&["grade", "rubric.json", "--check"]).succeeds();
    assert!(
        text.starts_with("The reference has 7 keyframes. Playback that gets points: Linear and Catmull-Rom. "),
        "{text}"
    );
    assert!(text.contains("\nNot revealed: no-conditional-negation. "), "{text}");
    let json: Value =
        serde_json::from_str(&sandbox.run(&["grade", "rubric.json", "--check", "--json"]).succeeds()).unwrap();
    let hidden = json["not_revealed"].as_array().unwrap();
    let hidden = hidden.iter().find(|hidden| hidden["mistake"] == "no-conditional-negation").unwrap();
    assert_eq!(hidden["playbacks"], json!(["linear", "catmull-rom"]));
    let example = hidden["example"].as_str().unwrap();
    let words: Vec<&str> = example.split(' ').collect();
    assert_eq!(words[..4], ["write", "the", "rotation", "of"], "{example}");
    assert_eq!(words[5..7], ["in", "keyframe"], "{example}");
    // Follow the advice.
    let node = names(&reference["nodes"]).iter().position(|node| *node == words[4]).unwrap();
    let keyframe: usize = words[7].parse().unwrap();
    let rotation = &mut reference["keyframes"][keyframe]["pose"][node]["rotation"];
    *rotation = json!(rotation.as_array().unwrap().iter().map(|number| -number.as_f64().unwrap()).collect::<Vec<_>>());
    sandbox.write("reference.json", reference.to_string());
    let text = sandbox.run(&["grade", "rubric.json", "--check"]).succeeds();
    assert!(!text.contains("Not revealed: no-conditional-negation. "), "{text}");
}

#[test]
fn what_is_not_revealed_is_said_with_the_marks() {
    let sandbox = Sandbox::new();
    sandbox.write("rubric.json", RUBRIC.replace("\"linear_playback\": 5, ", ""));
    sandbox.write("reference.json", keyframe_file(6).to_string());
    let said = sandbox.run(&["grade", "rubric.json", "reference.json", "-o", "out", "--no-images"]).succeeds();
    let warning = said.lines().find(|line| line.starts_with("The reference does not reveal ")).unwrap();
    assert!(warning.contains("small-turns-frozen"), "{warning}");
    assert!(sandbox.read("out/report.html").contains(warning));
    let grades = sandbox.json("out/grades.json");
    let schema: Value = serde_json::from_str(include_str!("../../assets/grading/grades.schema.json")).unwrap();
    follows(&grades, &schema, "grades");
    let hidden = grades["not_revealed"].as_array().unwrap();
    assert!(hidden.iter().any(|hidden| hidden["mistake"] == "small-turns-frozen"));
    // What can be made in linear playback alone costs nothing here.
    assert!(hidden.iter().all(|hidden| hidden["playbacks"] == json!(["catmull-rom"])));

    let shipped = shipped("rubric.toml");
    sandbox.run(&["grade", shipped.to_str().unwrap(), "reference.json", "-o", "out", "--no-images"]).succeeds();
    assert_eq!(sandbox.json("out/grades.json")["not_revealed"], json!([]));
    assert!(!sandbox.read("out/report.html").contains("does not reveal"));
}

#[test]
fn a_rubric_that_judges_no_playback_says_so() {
    let sandbox = Sandbox::new();
    sandbox.write("none.json", r#"{"format": "inbetween.rubric", "version": 1, "points": {"readable": 1}}"#);
    let text = sandbox.run(&["grade", "--check", "none.json"]).succeeds();
    assert_eq!(text, "The rubric has no reference: it reveals no mistake of playback.\n");
    sandbox.write("reference.json", keyframe_file(6).to_string());
    sandbox.write("poses.json", RUBRIC.replace(", \"linear_playback\": 5, \"catmull_rom_playback\": 5", ""));
    let text = sandbox.run(&["grade", "--check", "poses.json"]).succeeds();
    assert_eq!(text, "The rubric gives no points for playback: no mistake of playback costs points.\n");
    sandbox.run(&["grade", "--check", "nowhere.json"]).refuses("nowhere.json: there is no such file or folder");
    for wrong in [
        &["grade", "--check"][..],
        &["grade", "none.json", "--json"],
        &["grade", "--example", "new", "--json"],
        &["grade", "--check", "none.json", "reference.json"],
        &["grade", "--check", "none.json", "-o", "out"],
        &["grade", "--example", "new", "none.json"],
    ] {
        sandbox.run(wrong).misuses();
    }
    // Where something is graded, the JSON is that of the results.
    let printed =
        sandbox.run(&["grade", "none.json", "reference.json", "-o", "out", "--no-images", "--json"]).succeeds();
    assert_eq!(printed, sandbox.read("out/grades.json"));
}

#[test]
fn the_example_can_be_graded_at_once() {
    let sandbox = Sandbox::new();
    let said = sandbox.run(&["grade", "--example", "new/folder"]).succeeds();
    assert_eq!(
        said,
        "Wrote rubric.toml, reference.json, hotkeys.txt and README.md to new/folder. Begin with README.md.\n"
    );
    for name in ["rubric.toml", "reference.json", "hotkeys.txt", "README.md"] {
        assert_eq!(sandbox.read(&format!("new/folder/{name}")), std::fs::read_to_string(shipped(name)).unwrap());
    }
    let readme = sandbox.read("new/folder/README.md");
    assert!(readme.contains("inbetween grade rubric.toml reference.json -o results --no-images\n"));
    let graded = ["grade", "new/folder/rubric.toml", "new/folder/reference.json", "-o", "results", "--no-images"];
    sandbox.run(&graded).succeeds();
    let grades = sandbox.json("results/grades.json");
    let items = grades["submissions"][0]["items"].as_array().unwrap();
    let poses = items.iter().filter(|item| item["item"].as_str().unwrap().starts_with("keyframe"));
    assert!(poses.clone().count() == 8 && poses.clone().all(|item| item["points"] == item["out_of"]));
    sandbox.write("new/folder/README.md", "mine");
    std::fs::remove_file(sandbox.path("new/folder/rubric.toml")).unwrap();
    sandbox
        .run(&["grade", "--example", "new/folder"])
        .refuses("new/folder/reference.json: something else stands there, and is not written over");
    assert!(!sandbox.path("new/folder/rubric.toml").exists());
    assert_eq!(sandbox.read("new/folder/README.md"), "mine");
    sandbox.run(&["grade", "--example", "-"]).misuses();
}

#[test]
fn the_example_fits_each_scene() {
    let sandbox = Sandbox::new();
    for scene in ["cylinder", "orbits"] {
        sandbox.run(&["--scene", scene, "grade", "--example", scene]).succeeds();
        let rubric = format!("{scene}/rubric.toml");
        let json = sandbox.run(&["--scene", scene, "grade", "--check", &rubric, "--json"]).succeeds();
        let json: Value = serde_json::from_str(&json).unwrap();
        let hidden: Vec<&Value> = json["not_revealed"].as_array().unwrap().iter().map(|one| &one["mistake"]).collect();
        // Of the first scene keyframes move two nodes, and both turn.
        let expected: &[&str] = if scene == "cylinder" { &["nan-when-equal", "identity-when-equal"] } else { &[] };
        assert_eq!(hidden, expected, "{scene}");
        let readme = sandbox.read(&format!("{scene}/README.md"));
        assert!(readme.contains(&format!("inbetween --scene {scene} grade --check rubric.toml\n")), "{readme}");
    }
}
