//! `grade --roster`: whose each submission is, and who handed nothing in.

use serde_json::{Value, json};

use crate::grade::{course, follows, text_of};
use crate::results::{cells, grade};
use crate::sandbox::Sandbox;

fn table(sandbox: &Sandbox, name: &str) -> Vec<Vec<String>> {
    cells(sandbox.read(&format!("out/{name}")).strip_prefix('\u{feff}').expect("the mark of UTF-8"))
}

/// A class with a right submission under each of these names.
fn class(names: &[&str]) -> Sandbox {
    let (sandbox, made) = course();
    for name in names {
        sandbox.write(&format!("all/{name}"), text_of(&made, "linear"));
    }
    sandbox
}

#[test]
fn canvas_numbers_find_the_students_and_the_missing_get_rows() {
    let sandbox = class(&["kimann_100_2000_a.json", "leebob_LATE_101_2001_b.json", "whoever_999_2002_c.json"]);
    let roster = "Student,ID,SIS User ID,SIS Login ID,Section,A (1)\n    Points Possible,,,,,10\n\
        \"Kim, Ann\",100,S1,akim,L1,\n\"Lee, Bob\",101,S2,blee,L2,\n\"Roh, Cem\",102,S3,croh,L2,\n\"Student, Test\",7,,t,L1,\n";
    sandbox.write("roster.csv", roster);
    let said = grade(&sandbox, &["--roster", "roster.csv", "--to", "canvas", "--assignment", "A (1)"]);
    assert!(said.starts_with("3 submissions graded"), "{said}");
    assert!(said.contains("\nnothing handed in: Roh, Cem\nnot on the roster: whoever_999_2002_c.json\n"), "{said}");
    let rows = table(&sandbox, "canvas.csv");
    assert_eq!(rows[2], ["Kim, Ann", "100", "S1", "akim", "L1", "26"]);
    assert_eq!(rows[3], ["Lee, Bob", "101", "S2", "blee", "L2", "26"]);
    assert_eq!(rows[4], ["whoever", "999", "", "", "", "26"]);
    assert_eq!(rows[5], ["Roh, Cem", "102", "S3", "croh", "L2", "0"]);
    assert_eq!(rows.len(), 6);

    let grades = sandbox.json("out/grades.json");
    let schema: Value = serde_json::from_str(include_str!("../../assets/grading/grades.schema.json")).unwrap();
    follows(&grades, &schema, "grades");
    let missing = &grades["submissions"][3];
    assert_eq!([&missing["name"], &missing["id"], &missing["section"]], ["Roh, Cem", "102", "L2"]);
    assert_eq!(
        (&missing["missing"], &missing["points"], &missing["out_of"]),
        (&json!(true), &json!(0.0), &json!(26.0))
    );
    assert_eq!(missing["items"][0]["reason"], "Nothing was handed in.");
    assert_eq!(grades["submissions"][0]["missing"], false);
    let rows = table(&sandbox, "grades.csv");
    let missing = rows[0].iter().position(|name| name == "missing").unwrap();
    assert_eq!(rows[0][missing - 1], "section");
    assert_eq!(
        (&rows[1][missing - 1..=missing], &rows[4][missing - 1..=missing]),
        (&["L1".to_owned(), String::new()][..], &["L2".to_owned(), "missing".to_owned()][..])
    );
    assert!(sandbox.read("out/report.html").contains("Roh, Cem"));
}

#[test]
fn names_find_the_students_where_numbers_do_not() {
    let names = [
        "Ann Kim_7_assignsubmission_file_/a.json",
        "Lefèvre Zoë_8_assignsubmission_file_/a.json",
        "Max Roh_9_assignsubmission_file_/a.json",
    ];
    let sandbox = class(&names);
    let zoe = "Zoe\u{308},LEFE\u{300}VRE";
    sandbox.write("roster.csv", format!("First name,Last name,ID number,Email address,Groups\nAnn,Kim,07,a@b.c,G1\n{zoe},08,z@b.c,G2\nMax,Roh,1,,\nMax,Roh,2,,\n"));
    let said = grade(&sandbox, &["--roster", "roster.csv", "--to", "moodle"]);
    assert!(said.contains("not on the roster: Max Roh_9_assignsubmission_file_\n"), "two have that name: {said}");
    let rows = table(&sandbox, "moodle.csv");
    assert_eq!(rows[1][..4], ["Participant 7", "Ann Kim", "07", "a@b.c"]);
    assert_eq!(rows[2][..4], ["Participant 8", "Zoe\u{308} LEFE\u{300}VRE", "08", "z@b.c"]);
    assert_eq!(rows[3][..4], ["Participant 9", "Max Roh", "", ""]);
    assert_eq!([&*rows[4][1], &*rows[4][2], &*rows[5][1], &*rows[5][2]], ["Max Roh", "1", "Max Roh", "2"]);
    let grades = sandbox.json("out/grades.json");
    let names = [3, 4].map(|index: usize| grades["submissions"][index]["name"].as_str().unwrap().to_owned());
    assert_eq!(names, ["Max Roh", "Max Roh #4"]);
}

#[test]
fn folders_named_by_numbers_and_groups_find_their_students() {
    let sandbox = class(&["2026-1/a.json", "submission_5/a.json", "submission_6/a.json"]);
    sandbox.write(
        "all/submission_metadata.yml",
        "submission_5:\n  :submitters:\n  - :name: Ann Kim\n    :sid: '07'\n  - :name: Bob Lee\n    :sid: '08'\n\
         submission_6:\n  :submitters:\n  - :name: Bob Lee\n    :sid: '08'\n",
    );
    sandbox.write("roster.csv", "name;id;section\nKim, Ann;07;A\nLee, Bob;08;B\nRoh, Cem;2026-1;A\n");
    let said = grade(&sandbox, &["--roster", "roster.csv", "--to", "canvas", "--assignment", "A (1)"]);
    assert!(said.contains("more than one submission of Lee, Bob: submission_5, submission_6\n"), "{said}");
    assert!(!said.contains("nothing handed in") && !said.contains("not on the roster"), "{said}");
    let rows: Vec<String> = table(&sandbox, "canvas.csv")[2..].iter().map(|row| row[0].clone()).collect();
    assert_eq!(rows, ["Roh, Cem", "Kim, Ann", "Lee, Bob", "Lee, Bob"], "each of a group has a row");
}

#[test]
fn a_list_that_is_none_is_refused() {
    let sandbox = class(&["a.json"]);
    for (text, sentence) in [
        ("", "the header has no column of names or numbers: "),
        ("points,grade\n1,2\n", "the header has no column of names or numbers: points, grade"),
        ("name,id\n", "there are no students in it"),
        ("name,id\n\"Kim,7\n", "line 2: a quotation mark is not closed"),
    ] {
        sandbox.write("roster.csv", text);
        let arguments = ["grade", "rubric.json", "all", "-o", "out", "--no-images", "--roster", "roster.csv"];
        sandbox.run(&arguments).refuses(format!("roster.csv: {sentence}").trim_end());
    }
    assert!(!sandbox.path("out").exists());
}
