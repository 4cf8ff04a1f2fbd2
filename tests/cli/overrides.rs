//! A teacher's own points, comments and late days, and what lateness costs.

use serde_json::{Value, json};

use crate::grade::{course, follows, item, text_of};
use crate::results::{cells, grade};
use crate::sandbox::Sandbox;

/// A class as Gradescope exports it, all of it right: ann, bob who is 49 hours late, cem who is late; by Canvas, dee who is late.
fn class(late: &str) -> Sandbox {
    let (sandbox, made) = course();
    for name in ["submission_1/a.json", "submission_2/a.json", "submission_3/a.json", "leedee_LATE_104_2004_a.json"] {
        sandbox.write(&format!("all/{name}"), text_of(&made, "linear"));
    }
    let student = |number: u32, name: &str, late: &str| {
        format!("submission_{number}:\n  :submitters:\n  - :name: {name}\n    :sid: '0{number}'\n  :lateness: {late}\n")
    };
    let metadata =
        student(1, "Ann Kim", "'00:00:00'") + &student(2, "Bob Lee", "'49:00:00'") + &student(3, "Cem Roh", "true");
    sandbox.write("all/submission_metadata.yml", metadata);
    let rubric = sandbox.read("rubric.json").replacen("\"points\"", &format!("{late}\"points\""), 1);
    sandbox.write("rubric.json", rubric);
    sandbox
}

fn submissions(sandbox: &Sandbox) -> Vec<Value> {
    let grades = sandbox.json("out/grades.json");
    let schema: Value = serde_json::from_str(include_str!("../../assets/grading/grades.schema.json")).unwrap();
    follows(&grades, &schema, "grades");
    let mut all = grades["submissions"].as_array().unwrap().clone();
    all.sort_by_key(|submission| submission["id"].as_str().unwrap().to_owned());
    all
}

fn points(sandbox: &Sandbox) -> Vec<f64> {
    let round = |points: f64| (points * 1e6).round() / 1e6;
    submissions(sandbox).iter().map(|submission| round(submission["points"].as_f64().unwrap())).collect()
}

const LATE: &str = r#""late": {"free_days": 1, "percent_a_day": 10}, "#;

#[test]
fn lateness_costs_what_the_rubric_says() {
    let sandbox = class("");
    grade(&sandbox, &[]);
    assert_eq!(points(&sandbox), [26.0; 4]);

    let sandbox = class(LATE);
    grade(&sandbox, &["--to", "moodle", "--to", "junit"]);
    // Three days have begun, of which one is free; who is only known to be late is one day late.
    assert_eq!(points(&sandbox), [26.0, 20.8, 26.0, 26.0]);
    let all = submissions(&sandbox);
    assert_eq!((&all[1]["days_late"], &all[2]["days_late"]), (&json!(3), &Value::Null));
    assert!((all[1]["late_points"].as_f64().unwrap() - 5.2).abs() < 1e-9);
    assert_eq!(all[1]["notes"][0], "3 days late, 1 day free: 20 % of the points are lost.");
    assert!(all[3]["notes"][0].as_str().unwrap().ends_with("so one day is assumed."), "{}", all[3]);
    let moodle = sandbox.read("out/moodle.csv");
    assert!(moodle.contains("\"20.8 of 26 points. Lateness costs 5.2 points.\""), "{moodle}");
    let junit = sandbox.read("out/junit.xml");
    assert!(junit.contains("name=\"late\"") && junit.contains("<property name=\"points\" value=\"-5.2\"/>"), "{junit}");

    let sandbox = class(r#""late": {"percent_a_day": 50}, "#);
    grade(&sandbox, &[]);
    assert_eq!(points(&sandbox), [26.0, 0.0, 13.0, 13.0], "never below nothing");
    for (late, sentence) in [
        (r#""late": {"free_days": 366}, "#, "late.free_days is 366, expected a whole number from 0 to 365"),
        (r#""late": {"percent_a_day": 101}, "#, "late.percent_a_day is 101, expected 0 to 100"),
    ] {
        let arguments = ["grade", "rubric.json", "all", "-o", "out", "--no-images"];
        class(late).run(&arguments).refuses(&format!("rubric.json: {sentence}"));
    }
}

const HEAD: &str = "format = \"inbetween.overrides\"\nversion = 1\n";

#[test]
fn overrides_hold_over_all_runs() {
    let sandbox = class(LATE);
    let overrides = format!(
        "{HEAD}[students.\"01\"]\npoints = {{ script = 1, each_keyframe = 4, \"keyframe 3\" = 0 }}\ncomment = \"=Seen, in the lab.\"\n\
         [students.submission_2]\nlate_days = 2\n[students.\"104\"]\nlate_days = 0\n[students.nobody]\ncomment = \"?\"\n"
    );
    sandbox.write("overrides.toml", &overrides);
    for run in 0..2 {
        let said = grade(&sandbox, &["--to", "moodle", "--to", "gradescope"]);
        assert!(said.contains("\noverrides for nobody: nobody\n"), "{said}");
        // 26 less 2 for the script, 4 for the keyframes, and 0.5 for keyframe 3.
        assert_eq!(points(&sandbox), [19.5, 23.4, 26.0, 26.0], "run {run}");
        assert_eq!(sandbox.read("overrides.toml"), overrides);
    }
    let all = submissions(&sandbox);
    let script = item(&all[0], "script");
    assert_eq!((&script["points"], &script["by_hand"]), (&json!(1.0), &json!(true)));
    assert!(script["reason"].as_str().unwrap().starts_with("Given by hand. "), "{script}");
    assert_eq!(item(&all[0], "keyframe 2")["points"], 0.5);
    let keyframe = item(&all[0], "keyframe 3");
    assert_eq!(keyframe["points"], 0.0);
    assert_eq!(keyframe["reason"].as_str().unwrap().matches("Given by hand.").count(), 1);
    assert_eq!(item(&all[0], "readable")["by_hand"], false);
    assert_eq!([&all[0]["comment"], &all[0]["notes"][0]], ["=Seen, in the lab."; 2]);
    assert_eq!((&all[3]["late"], &all[3]["late_points"]), (&json!(false), &json!(0.0)));
    assert!(sandbox.read("out/moodle.csv").contains("\"19.5 of 26 points. =Seen, in the lab. "));
    let results = sandbox.json("out/gradescope/submission_1/results.json");
    assert!(results["output"].as_str().unwrap().starts_with("=Seen, in the lab."), "{results}");
    let table = sandbox.read("out/grades.csv");
    let rows = cells(table.strip_prefix('\u{feff}').unwrap());
    let ann = rows.iter().find(|row| row[0] == "submission_1").unwrap();
    assert_eq!(ann.last().unwrap(), "'=Seen, in the lab.");

    sandbox.write("other.toml", format!("{HEAD}[students.\"02\"]\nlate_days = 0\n"));
    grade(&sandbox, &["--overrides", "other.toml"]);
    assert_eq!(points(&sandbox), [26.0; 4], "the file that is named, and no other");

    sandbox.write("roster.csv", "name,id,username\nAnn Kim,01,akim\n");
    sandbox.write("other.toml", format!("{HEAD}[students.AKIM]\npoints.script = 0\n"));
    grade(&sandbox, &["--overrides", "other.toml", "--roster", "roster.csv"]);
    assert_eq!(points(&sandbox)[0], 23.0, "by a number of the roster");
}

#[test]
fn wrong_overrides_are_refused_with_their_place() {
    let sandbox = class("");
    for (text, sentence) in [
        (HEAD.replace('1', "2"), "format is inbetween.overrides and version 2, expected inbetween.overrides and 1"),
        (
            format!("{HEAD}[students.a]\npoints.nosuch = 1\n"),
            "students.a.points.nosuch: the rubric gives no points for it",
        ),
        (format!("{HEAD}[students.a]\npoints.script = 4\n"), "students.a.points.script is 4, expected 0 to 3"),
        (
            format!("{HEAD}[students.a]\npoints.each_keyframe = -1\n"),
            "students.a.points.each_keyframe is -1, expected 0 to 8",
        ),
        (
            format!("{HEAD}[students.a]\nlate_days = 1\n"),
            "students.a.late_days: the rubric has no late, so days cost nothing",
        ),
        (
            format!("{HEAD}[students.a]\nnote = 1\n"),
            "line 4 column 1: unknown field \"note\", expected points, comment or late_days",
        ),
    ] {
        sandbox.write("overrides.toml", text);
        let outcome = sandbox.run(&["grade", "rubric.json", "all", "-o", "out", "--no-images"]);
        outcome.refuses(&format!("./overrides.toml: {sentence}").replace("./", ""));
    }
    let arguments = ["grade", "rubric.json", "all", "-o", "out", "--no-images", "--overrides", "gone.toml"];
    assert_eq!(sandbox.run(&arguments).status, 1);
    assert!(!sandbox.path("out").exists());
}
