//! Results that are handed on: tables for spreadsheets and files for course systems.

use serde_json::{Value, json};
use sha2::{Digest as _, Sha256};

use crate::grade::{course, follows, text_of};
use crate::sandbox::Sandbox;

/// A course with a right submission, one with a wrong keyframe, and one that cannot be read.
pub fn three() -> Sandbox {
    let (sandbox, mut made) = course();
    sandbox.write("all/ann/animation.json", text_of(&made, "linear"));
    made[3][5].0[1] += 0.5;
    sandbox.write("all/bob.json", text_of(&made, "linear"));
    sandbox.write("all/＝cem.json", "{");
    sandbox
}

pub fn grade(sandbox: &Sandbox, more: &[&str]) -> String {
    let arguments = ["grade", "rubric.json", "all", "-o", "out", "--no-images"];
    sandbox.run(&[&arguments[..], more].concat()).succeeds()
}

/// A table's rows of cells. Every cell that needs it is in quotes.
pub fn cells(table: &str) -> Vec<Vec<String>> {
    let row = |line: &str| {
        let mut cells = vec![String::new()];
        let mut is_quoted = false;
        let mut signs = line.chars().peekable();
        while let Some(sign) = signs.next() {
            let cell = cells.last_mut().unwrap();
            match sign {
                '"' if is_quoted && signs.next_if_eq(&'"').is_some() => cell.push('"'),
                '"' => is_quoted = !is_quoted,
                ',' if !is_quoted => cells.push(String::new()),
                _ => cell.push(sign),
            }
        }
        assert!(!is_quoted, "{line}");
        cells
    };
    assert!(table.ends_with("\r\n"));
    table.trim_end_matches("\r\n").split("\r\n").map(row).collect()
}

#[test]
fn the_table_has_a_column_a_keyframe_only_where_it_is_wide() {
    let sandbox = three();
    grade(&sandbox, &[]);
    let table = sandbox.read("out/grades.csv");
    let rows = cells(table.strip_prefix('\u{feff}').expect("the mark of UTF-8"));
    let after = ["each_keyframe", "linear_playback", "catmull_rom_playback", "range_and_end", "script"];
    assert_eq!(rows[0][8..10], ["readable", "keyframe_count"]);
    assert_eq!(rows[0][10..15], after);
    assert_eq!(
        rows[0][15..],
        ["keyframe_file", "reasons", "notes", "section", "missing", "days_late", "late_points", "comment"]
    );
    let of_keyframes = rows[1..].iter().map(|row| row[10].as_str()).collect::<Vec<_>>();
    assert_eq!(of_keyframes, ["8", "7", "0"]);
    assert_eq!(rows[3][0], "'＝cem.json");

    grade(&sandbox, &["--wide"]);
    let wide = sandbox.read("out/grades.csv");
    let wide = cells(wide.strip_prefix('\u{feff}').unwrap());
    let names: Vec<String> = (0..8).map(|keyframe| format!("keyframe {keyframe}")).collect();
    assert_eq!(wide[0][10..18], names);
    assert_eq!(wide[0][18..22], after[1..]);
    assert_eq!(wide[2][10..18], ["1", "1", "1", "0", "1", "1", "1", "1"]);
    assert_eq!((&wide[2][4], &wide[2][22..]), (&rows[2][4], &rows[2][15..]));
}

#[test]
fn the_results_say_what_they_are_of() {
    let sandbox = three();
    grade(&sandbox, &[]);
    let grades = sandbox.json("out/grades.json");
    let schema: Value = serde_json::from_str(include_str!("../../assets/grading/grades.schema.json")).unwrap();
    follows(&grades, &schema, "grades");
    let hash = |path: &str| format!("{:x}", Sha256::digest(std::fs::read(sandbox.path(path)).unwrap()));
    let file = |name: &str, path: &str| json!({"name": name, "sha256": hash(path)});
    assert_eq!(grades["version"], 2);
    assert_eq!(grades["program"], json!({"name": "inbetween", "version": env!("CARGO_PKG_VERSION")}));
    let files = ["rubric.json", "hotkeys.txt", "reference.json"].map(|name| file(name, name));
    assert_eq!(grades["rubric"], json!(files));
    let of = |index: usize| &grades["submissions"][index]["files"];
    assert_eq!(of(0), &json!([file("animation.json", "all/ann/animation.json")]));
    assert_eq!(of(1), &json!([file("bob.json", "all/bob.json")]));
    assert_eq!(of(2)[0]["sha256"], hash("all/＝cem.json"));
}

#[test]
fn what_could_not_be_read_is_said_and_may_end_with_status_1() {
    let sandbox = three();
    let said = grade(&sandbox, &[]);
    assert!(said.starts_with("3 submissions graded: "), "{said}");
    assert!(said.contains("\n1 of 3 submissions could not be read\ncould not be read: ＝cem.json ("), "{said}");
    assert!(!said.contains("below"), "{said}");

    let files = ["out/grades.csv", "out/grades.json", "out/report.html"];
    let written = files.map(|name| sandbox.read(name));
    let ends = |more: &[&str]| {
        std::fs::remove_dir_all(sandbox.path("out")).unwrap();
        let arguments = ["grade", "rubric.json", "all", "-o", "out", "--no-images"];
        let outcome = sandbox.run(&[&arguments[..], more].concat());
        assert_eq!(outcome.stderr, "");
        assert_eq!(files.map(|name| sandbox.read(name)), written, "{more:?}");
        (outcome.status, outcome.stdout)
    };
    assert_eq!(ends(&["--strict"]), (1, said.clone()));
    // A quiet one says why it fails, and nothing else.
    assert_eq!(ends(&["--quiet"]), (0, String::new()));
    let (status, reasons) = ends(&["--strict", "--quiet"]);
    let are_reasons = reasons.lines().all(|line| line.contains("could not be read"));
    assert!(status == 1 && !reasons.is_empty() && are_reasons, "{reasons}");
    assert_eq!(ends(&["--fail-under", "0"]), (0, said));
    let (status, said) = ends(&["--fail-under", "1"]);
    assert!(status == 1 && said.contains("\nbelow 1 %: ＝cem.json (0 of 26 points)\n"), "{said}");
    assert_eq!(said.matches("below").count(), 1);
    let (status, said) = ends(&["--fail-under", "100", "--strict"]);
    assert!(status == 1 && said.contains("\nbelow 100 %: bob.json ("), "{said}");
    assert_eq!(said.matches("below").count(), 2);
    std::fs::remove_file(sandbox.path("all/＝cem.json")).unwrap();
    std::fs::remove_file(sandbox.path("all/bob.json")).unwrap();
    let arguments = ["grade", "rubric.json", "all", "-o", "out", "--no-images", "--strict", "--fail-under", "100"];
    sandbox.run(&arguments).succeeds();
    for percent in ["-1", "101", "nan", "half"] {
        let percent = format!("--fail-under={percent}");
        sandbox.run(&["grade", "rubric.json", "all", "-o", "out", &percent]).misuses();
    }
}
