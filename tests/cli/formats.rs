//! Results as course systems and services read them, field by field.

use std::collections::BTreeMap;

use quick_xml::events::{BytesStart, Event};
use serde_json::{Value, json};

use crate::grade::{course, text_of};
use crate::results::{cells, grade, three};
use crate::sandbox::Sandbox;

/// A table's cells, after the mark of UTF-8.
fn table(sandbox: &Sandbox, name: &str) -> Vec<Vec<String>> {
    let text = sandbox.read(&format!("out/{name}"));
    cells(text.strip_prefix('\u{feff}').expect("the mark of UTF-8"))
}

/// A class as a course system exports it: ann, who is right, and bob, who is late and has one keyframe wrong.
fn exported(names: [&str; 2]) -> Sandbox {
    let (sandbox, mut made) = course();
    sandbox.write(&format!("all/{}", names[0]), text_of(&made, "linear"));
    made[3][5].0[1] += 0.5;
    sandbox.write(&format!("all/{}", names[1]), text_of(&made, "linear"));
    sandbox
}

#[test]
fn canvas_gets_its_columns() {
    let sandbox = exported(["kimann_100_2000_a.json", "leebob_LATE_101_2001_b.json"]);
    grade(&sandbox, &["--to", "canvas", "--assignment", "Keyframes, 6 (4711)"]);
    let rows = table(&sandbox, "canvas.csv");
    assert_eq!(rows[0], ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "Keyframes, 6 (4711)"]);
    assert_eq!(rows[1], ["Points Possible", "", "", "", "", "26"]);
    let graded = sandbox.json("out/grades.json");
    let points = |index: usize| graded["submissions"][index]["points"].as_f64().unwrap().to_string();
    assert_eq!(rows[2], ["kimann", "100", "", "", "", &*points(0)]);
    assert_eq!(rows[3], ["leebob", "101", "", "", "", &*points(1)]);
    assert_eq!(rows.len(), 4);
}

#[test]
fn moodle_gets_grade_and_feedback_together() {
    let folders = ["Ann Kim_7_assignsubmission_file_/a.json", "Bob <i>_8_assignsubmission_file_/b.json"];
    let sandbox = exported(folders);
    grade(&sandbox, &["--to", "moodle"]);
    let rows = table(&sandbox, "moodle.csv");
    let columns = [
        "Identifier",
        "Full name",
        "ID number",
        "Email address",
        "Grade",
        "Maximum Grade",
        "Last modified (grade)",
        "Feedback comments",
    ];
    assert_eq!(rows[0], columns);
    assert_eq!(rows[1], ["Participant 7", "Ann Kim", "", "", "26", "26", "-", "26 of 26 points."]);
    assert_eq!(rows[2][..2], ["Participant 8", "Bob <i>"]);
    let feedback = &rows[2][7];
    assert!(feedback.starts_with(&format!("{} of 26 points. keyframe 3: ", rows[2][4])), "{feedback}");
    assert!(!feedback.contains(['<', '>']), "feedback is HTML: {feedback}");
}

#[test]
fn gradescope_gets_a_test_an_item() {
    let sandbox = three();
    grade(&sandbox, &["--to", "gradescope"]);
    let graded = sandbox.json("out/grades.json");
    for (index, name) in ["ann", "bob.json", "＝cem.json"].into_iter().enumerate() {
        let results = sandbox.json(&format!("out/gradescope/{name}/results.json"));
        let own = &graded["submissions"][index];
        assert_eq!(results["score"], own["points"]);
        assert_eq!([&results["output_format"], &results["visibility"]], ["text", "visible"]);
        let tests = results["tests"].as_array().unwrap();
        assert_eq!(tests.len(), 14);
        for (test, item) in tests.iter().zip(own["items"].as_array().unwrap()) {
            assert_eq!([&test["score"], &test["max_score"]], [&item["points"], &item["out_of"]]);
            let is_full = item["points"] == item["out_of"];
            assert_eq!(test["status"], if is_full { "passed" } else { "failed" });
            assert_eq!(test["output"], item["reason"]);
            assert_eq!([&test["output_format"], &test["visibility"]], ["text", "visible"]);
            let fields: Vec<&String> = test.as_object().unwrap().keys().collect();
            let expected = ["max_score", "name", "number", "output", "output_format", "score", "status", "visibility"];
            assert_eq!(fields, expected);
        }
        let text = |test: &Value, field: &str| test[field].as_str().unwrap().to_owned();
        let numbers: Vec<String> = tests.iter().map(|test| text(test, "number")).collect();
        let expected = ["1", "2", "3.1", "3.2", "3.3", "3.4", "3.5", "3.6", "3.7", "3.8", "4", "5", "6", "7"];
        assert_eq!(numbers, expected);
        let names = [0, 1, 5, 11].map(|index: usize| text(&tests[index], "name"));
        assert_eq!(names, ["readable", "keyframe count", "keyframe 3", "Catmull-Rom playback"]);
    }
}

const VARIABLES: [(&str, &str); 7] = [
    ("CLASSROOM", "cs-6"),
    ("ASSIGNMENT", "keyframes"),
    ("USERNAME", "ann"),
    ("SUBMISSION_TAG", "submit/2026-06-01T14-32-05Z-a1b2c3d"),
    ("COMMIT_URL", "https://example.org/commit/a1"),
    ("RELEASE_URL", "https://example.org/releases/1"),
    ("GITHUB_ACTOR", "bob"),
];

/// Grades for Classroom 50 with these variables.
fn for_classroom50(sandbox: &Sandbox, variables: &[(&str, &str)]) -> crate::sandbox::Outcome {
    let arguments = ["grade", "rubric.json", "all", "-o", "out", "--no-images", "--to", "classroom50"];
    let mut command = sandbox.command(&arguments);
    for name in ["OWNER", "REVIEW_URL", "ASSIGNMENT_TYPE", "MODE", "GITHUB_ACTOR_ID"] {
        command.env_remove(name);
    }
    for (name, _) in VARIABLES {
        command.env_remove(name);
    }
    command.envs(variables.iter().copied());
    Sandbox::outcome(command)
}

#[test]
fn classroom50_gets_whole_points_and_what_its_runner_says() {
    let sandbox = three();
    let rubric = sandbox.read("rubric.json").replace("\"each_keyframe\": 1,", "\"each_keyframe\": 0.7,");
    sandbox.write("rubric.json", rubric);
    for_classroom50(&sandbox, &VARIABLES).succeeds();
    let result = sandbox.json("out/classroom50/bob.json/result.json");
    let expected = json!({
        "schema": "classroom50/result/v1", "classroom": "cs-6", "assignment": "keyframes",
        "assignment_type": "individual", "owner": "ann", "submission": "submit/2026-06-01T14-32-05Z-a1b2c3d",
        "commit": "https://example.org/commit/a1", "release": "https://example.org/releases/1",
        "review": "https://example.org/commit/a1", "datetime": "2026-06-01T14:32:05Z",
        "submitted_by": {"username": "bob", "id": null},
    });
    for (field, value) in expected.as_object().unwrap() {
        assert_eq!(&result[field], value, "{field}");
    }
    let own = &sandbox.json("out/grades.json")["submissions"][1];
    let whole = |value: &Value| value.as_f64().unwrap().round() as u64;
    assert_eq!(result["score"], whole(&own["points"]));
    assert_eq!(result["max-score"], 24, "23.6 in whole points");
    let tests = result["tests"].as_array().unwrap();
    for (test, item) in tests.iter().zip(own["items"].as_array().unwrap()) {
        assert_eq!(test["score"], whole(&item["points"]));
        assert_eq!(test["max-score"], whole(&item["out_of"]));
        assert_eq!(test["passed"], item["points"] == item["out_of"]);
        assert!(!test["test-name"].as_str().unwrap().is_empty());
    }
    assert_eq!((tests.len(), tests[5]["passed"].clone()), (14, json!(false)));
    assert_eq!(result.as_object().unwrap().len(), expected.as_object().unwrap().len() + 3);

    let more =
        [("OWNER", "eva"), ("REVIEW_URL", "https://example.org/r"), ("MODE", "group"), ("GITHUB_ACTOR_ID", "12")];
    for_classroom50(&sandbox, &[&VARIABLES[..], &more].concat()).succeeds();
    let result = sandbox.json("out/classroom50/ann/result.json");
    assert_eq!([&result["owner"], &result["assignment_type"]], ["eva", "group"]);
    assert_eq!((&result["review"], &result["submitted_by"]["id"]), (&json!("https://example.org/r"), &json!(12)));
}

#[test]
fn what_a_form_needs_is_asked_before_anything_is_written() {
    let sandbox = three();
    for without in ["CLASSROOM", "ASSIGNMENT", "USERNAME", "SUBMISSION_TAG", "COMMIT_URL", "RELEASE_URL"] {
        let variables: Vec<_> = VARIABLES.into_iter().filter(|(name, _)| *name != without).collect();
        let outcome = for_classroom50(&sandbox, &variables);
        let named = if without == "USERNAME" { "OWNER" } else { without };
        assert!(outcome.stderr.contains(&format!("needs the environment variable {named},")), "{}", outcome.stderr);
        outcome.misuses();
    }
    let outcome = for_classroom50(&sandbox, &[&VARIABLES[..], &[("SUBMISSION_TAG", "v1")]].concat());
    assert!(outcome.stderr.contains("SUBMISSION_TAG is v1"), "{}", outcome.stderr);
    outcome.misuses();
    let arguments = ["grade", "rubric.json", "all", "-o", "out", "--no-images", "--to"];
    let outcome = sandbox.run(&[&arguments[..], &["canvas"]].concat());
    assert!(outcome.stderr.contains("--to canvas needs --assignment"), "{}", outcome.stderr);
    outcome.misuses();
    sandbox.run(&[&arguments[..], &["nosuch"]].concat()).misuses();
    assert!(!sandbox.path("out").exists());
}

/// A case of JUnit: its attributes, its properties, and the element of its failure with the text.
#[derive(Default)]
struct Case {
    attributes: BTreeMap<String, String>,
    properties: BTreeMap<String, String>,
    failure: Option<(String, String)>,
}

fn attributes(element: &BytesStart) -> BTreeMap<String, String> {
    let attribute = |found: quick_xml::events::attributes::Attribute| {
        let value = std::str::from_utf8(&found.value).unwrap();
        let value = quick_xml::escape::unescape(value).unwrap().into_owned();
        (String::from_utf8(found.key.as_ref().to_vec()).unwrap(), value)
    };
    element.attributes().map(|found| attribute(found.expect("well-formed"))).collect()
}

/// The suites of a document, each with its attributes and cases.
fn suites(text: &str) -> Vec<(BTreeMap<String, String>, Vec<Case>)> {
    let mut reader = quick_xml::Reader::from_str(text);
    reader.config_mut().check_end_names = true;
    let mut suites: Vec<(BTreeMap<String, String>, Vec<Case>)> = Vec::new();
    loop {
        let event = reader.read_event().expect("well-formed");
        match &event {
            Event::Start(element) | Event::Empty(element) => {
                let name = String::from_utf8(element.name().as_ref().to_vec()).unwrap();
                let mut attributes = attributes(element);
                let case = suites.last_mut().and_then(|(_, cases)| cases.last_mut());
                match name.as_str() {
                    "testsuite" => suites.push((attributes, Vec::new())),
                    "testcase" => {
                        suites.last_mut().unwrap().1.push(Case { attributes, ..Case::default() });
                    }
                    "property" => {
                        let mut take = |name: &str| attributes.remove(name).unwrap();
                        case.unwrap().properties.insert(take("name"), take("value"));
                    }
                    "failure" | "error" => case.unwrap().failure = Some((name, attributes["message"].clone())),
                    _ => assert!(["testsuites", "properties"].contains(&name.as_str()), "{name}"),
                }
            }
            Event::Eof => return suites,
            _ => {}
        }
    }
}

#[test]
fn junit_has_a_suite_a_submission_with_points_as_properties() {
    let sandbox = three();
    grade(&sandbox, &["--to", "junit", "--to", "moodle"]);
    assert!(sandbox.path("out/moodle.csv").exists(), "both forms");
    let graded = sandbox.json("out/grades.json");
    let suites = suites(&sandbox.read("out/junit.xml"));
    assert_eq!(suites.len(), 3);
    for (index, (suite, cases)) in suites.iter().enumerate() {
        let own = &graded["submissions"][index];
        assert_eq!(own["name"], suite["name"].as_str());
        assert_eq!(suite["tests"], "14");
        let lost = cases.iter().filter(|case| case.failure.is_some()).count();
        let is_unreadable = own["keyframe_file"].is_null();
        let counted = if is_unreadable { &suite["errors"] } else { &suite["failures"] };
        assert_eq!(*counted, lost.to_string());
        for (case, item) in cases.iter().zip(own["items"].as_array().unwrap()) {
            assert_eq!(own["name"], case.attributes["classname"].as_str());
            let number = |name: &str| case.properties[name].parse::<f64>().unwrap();
            assert_eq!(
                (json!(number("points")), json!(number("out_of"))),
                (item["points"].clone(), item["out_of"].clone())
            );
            assert_eq!(case.properties.get("evidence").map(String::as_str), item["evidence"].as_str());
            let expected = (item["points"] != item["out_of"]).then(|| {
                let element = if is_unreadable { "error" } else { "failure" };
                (element.to_owned(), item["reason"].as_str().unwrap().to_owned())
            });
            assert_eq!(case.failure, expected);
        }
        assert_eq!(cases[5].attributes["name"], "keyframe 3");
    }
}

#[test]
fn results_in_a_class_are_no_submissions() {
    let sandbox = three();
    let arguments =
        ["grade", "rubric.json", "all", "-o", "all", "--no-images", "--to", "canvas", "--assignment", "A (1)"];
    let more = ["--to", "moodle", "--to", "junit", "--to", "gradescope"];
    sandbox.run(&[&arguments[..], &more].concat()).succeeds();
    grade(&sandbox, &[]);
    let grades = sandbox.json("out/grades.json");
    assert_eq!(grades["submissions"].as_array().unwrap().len(), 3, "{grades}");
}
