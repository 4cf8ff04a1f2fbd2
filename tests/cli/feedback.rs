//! `grade --feedback` and `grade --anonymous`: what is handed back, and what nobody is to see.

use std::collections::BTreeSet;

use serde_json::Value;

use crate::grade::course;
use crate::report::{between, hand_in};
use crate::sandbox::Sandbox;

/// Hand-ins by names of Moodle.
fn class() -> (Sandbox, [&'static str; 3]) {
    let (sandbox, made) = course();
    let entries = [
        "Ada Lovelace_48101_assignsubmission_file_",
        "Bob <b>Stone_48102_assignsubmission_file_",
        "Cyd Chan_48103_assignsubmission_file_",
    ];
    for (entry, mistake) in entries.iter().zip(["correct", "nan-when-equal", "nan-when-equal"]) {
        hand_in(&sandbox, entry, &made, mistake);
    }
    sandbox.write("all/Cyd Chan_48103_assignsubmission_file_/cyd_chan.pdf", "");
    (sandbox, ["Lovelace", "Stone", "Chan"])
}

fn grade(sandbox: &Sandbox, arguments: &[&str]) -> String {
    let all = [&["grade", "rubric.json", "all", "-o", "out", "--no-images"], arguments].concat();
    sandbox.run(&all).succeeds()
}

fn names_in(sandbox: &Sandbox, folder: &str) -> Vec<String> {
    let entries = std::fs::read_dir(sandbox.path(folder)).unwrap();
    let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn each_student_gets_a_page_and_a_text_with_nothing_of_others() {
    let (sandbox, last_names) = class();
    grade(&sandbox, &["--feedback", "back"]);
    assert_eq!(
        names_in(&sandbox, "back"),
        ["48101.html", "48101.md", "48102.html", "48102.md", "48103.html", "48103.md"]
    );
    let results = sandbox.json("out/grades.json");
    for (index, id) in ["48101", "48102", "48103"].iter().enumerate() {
        let (html, markdown) = (sandbox.read(&format!("back/{id}.html")), sandbox.read(&format!("back/{id}.md")));
        for text in [&html, &markdown] {
            for (other, name) in last_names.iter().enumerate() {
                assert_eq!(text.contains(name), index == other, "{name}: {text}");
            }
            assert_eq!(text.contains("nan-when-equal"), index > 0, "{text}");
            assert!(!text.contains("<b>"), "{text}");
        }
        let ids: BTreeSet<&str> = between(&html, " id=\"", "\"").into_iter().collect();
        for link in between(&html, "href=\"#", "\"") {
            assert!(ids.contains(link), "{link}");
        }
        assert!(!html.contains("<script"), "{html}");
        // What the table says of points and reasons stands in both.
        let submission = &results["submissions"][index];
        let head = format!("{} of {}", submission["points"], submission["out_of"]).replace(".0", "");
        assert!(markdown.contains(&head), "{head}: {markdown}");
        for item in submission["items"].as_array().unwrap() {
            let reason = item["reason"].as_str().unwrap();
            assert!(html.contains(&inbetween::markup::escaped(reason)), "{reason}");
            assert!(markdown.contains(&inbetween::markup::markdown_escaped(reason)), "{reason}");
        }
        // A table in Markdown: each row has four cells.
        let rows = markdown.lines().filter(|line| line.starts_with('|'));
        for row in rows {
            assert_eq!(row.replace("\\|", "").matches('|').count(), 5, "{row}");
        }
    }
    sandbox.run(&["grade", "rubric.json", "all", "-o", "out", "--no-images", "--feedback", "-"]).misuses();
}

#[test]
fn without_ids_feedback_has_the_names_of_submissions_made_safe() {
    let (sandbox, made) = course();
    for name in ["ada", "con"] {
        hand_in(&sandbox, name, &made, "correct");
    }
    grade(&sandbox, &["--feedback", "back"]);
    assert_eq!(names_in(&sandbox, "back"), ["_con.html", "_con.md", "ada.html", "ada.md"]);
}

#[test]
fn nothing_that_is_written_without_names_names_anybody() {
    let (sandbox, last_names) = class();
    let usual = grade(&sandbox, &["--no-cache"]);
    assert!(!usual.contains("Lovelace"), "{usual}");
    let named = sandbox.json("out/grades.json");
    let said = grade(&sandbox, &["--anonymous", "--feedback", "back", "--key", "key.json"]);
    let mut texts = vec![said];
    for folder in ["out", "back"] {
        texts.extend(names_in(&sandbox, folder).iter().map(|name| sandbox.read(&format!("{folder}/{name}"))));
        texts.extend(names_in(&sandbox, folder));
    }
    for text in &texts {
        for name in last_names.iter().chain(&["Ada", "Cyd", "cyd_", "48101", "48102", "48103"]) {
            assert!(!text.contains(name), "{name}: {text}");
        }
    }
    // The key leads back: the points are those of the same submission.
    let (key, hidden) = (sandbox.json("key.json"), sandbox.json("out/grades.json"));
    let find = |name: &Value| {
        let all = named["submissions"].as_array().unwrap();
        all.iter().find(|one| one["name"] == *name).unwrap()
    };
    let numbers: Vec<&str> =
        hidden["submissions"].as_array().unwrap().iter().map(|one| one["name"].as_str().unwrap()).collect();
    assert_eq!(numbers, ["1", "2", "3"]);
    for one in hidden["submissions"].as_array().unwrap() {
        let who = &key[one["name"].as_str().unwrap()];
        let meant = find(&who["submission"]);
        assert_eq!((&who["student"], &who["id"]), (&meant["student"], &meant["id"]));
        assert_eq!((&one["points"], &one["student"], &one["id"]), (&meant["points"], &Value::Null, &Value::Null));
    }
    sandbox.run(&["grade", "rubric.json", "all", "-o", "out", "--no-images", "--key", "key.json"]).misuses();
}
