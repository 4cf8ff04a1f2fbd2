//! Classes as course systems export them: which rows there are, and what each gets.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::Write as _;

use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use serde_json::{Value, json};

use crate::grade::{follows, item, text_of, zipped};
use crate::sandbox::Sandbox;
use crate::student::{Placed, keyframes};

pub type Files = Vec<(String, Vec<u8>)>;

const RUBRIC: &str = r#"{"format": "inbetween.rubric", "version": 1, "reference": "reference.json",
    "points": {"readable": 2, "keyframe_count": 1, "each_keyframe": 1}}"#;

/// A student: first and last name, and what is handed in.
const STUDENTS: [&str; 15] = [
    "Anna 김",
    "José Ñandú",
    "Zoe\u{308} Lefe\u{300}vre",
    "이민지",
    "\u{1100}\u{1161}\u{11bc} 호동",
    "Ada Lovelace",
    "Grace Hopper",
    "Ken Thompson",
    "Lin Tao",
    "Mary Shaw",
    "Niklaus Wirth",
    "Ole Dahl",
    "Per Hansen",
    "Quinn O'Neil",
    "Rózsa Péter",
];

/// What a student handed in, and what it is worth.
pub struct HandIn {
    pub files: Files,
    pub points: f64,
    pub keyframe_file: Option<&'static str>,
    /// What the reason for `readable` contains.
    pub reason: &'static str,
    /// What the notes contain.
    pub notes: &'static [&'static str],
}

pub fn files(files: &[(&str, &[u8])]) -> Files {
    files.iter().map(|(name, bytes)| ((*name).to_owned(), bytes.to_vec())).collect()
}

fn tarred(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut packer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    {
        let mut tar = tar::Builder::new(&mut packer);
        for (name, bytes) in files {
            let mut header = tar::Header::new_gnu();
            header.set_size(bytes.len() as u64);
            header.set_mode(0o644);
            tar.append_data(&mut header, name, *bytes).unwrap();
        }
        tar.finish().unwrap();
    }
    packer.finish().unwrap()
}

/// A zip whose entries say that they are encrypted.
fn locked(name: &str, bytes: &[u8]) -> Vec<u8> {
    let mut zip = zipped(&[(name, bytes)]);
    for (mark, at) in [(b"PK\x03\x04", 6), (b"PK\x01\x02", 8)] {
        let header = zip.windows(4).position(|window| window == mark).unwrap();
        zip[header + at] |= 1;
    }
    zip
}

/// The keyframes as rows of translation and rotation, after a header.
pub fn as_text(keyframes: &[Vec<Placed>]) -> Vec<u8> {
    let mut text = format!("{} {}\n", keyframes.len(), keyframes[0].len());
    for ([x, y, z], [w, i, j, k]) in keyframes.iter().flatten() {
        writeln!(text, "{x} {y} {z} {w} {i} {j} {k}").unwrap();
    }
    text.into_bytes()
}

/// Fifteen hand-ins: right, packed, beside other things, wrong and unreadable.
pub fn hand_ins(made: &[Vec<Placed>]) -> Vec<HandIn> {
    let right = as_text(made);
    let json = text_of(made, "linear").into_bytes();
    let mut off = made.to_vec();
    off[3][5].0[1] += 0.5;
    let off = as_text(&off);
    let video = vec![0; 20 << 20];
    let large = vec![b' '; (16 << 20) + 1];
    let full = |handed: Files, file, notes| HandIn {
        files: handed,
        points: 11.0,
        keyframe_file: Some(file),
        reason: "holds 8 keyframes",
        notes,
    };
    let none = |handed: Files, reason, notes| HandIn { files: handed, points: 0.0, keyframe_file: None, reason, notes };
    vec![
        full(files(&[("animation.txt", &right)]), "animation.txt", &[]),
        full(
            files(&[("my_description.json", &json), ("linear.csv", b"time,node\n0,1\n")]),
            "my_description.json",
            &["Neither keyframes, samples, trace nor script: linear.csv."],
        ),
        full(files(&[("hw.zip", &zipped(&[("src/animation.txt", &right)]))]), "hw.zip/src/animation.txt", &[]),
        full(
            files(&[("all.zip", &zipped(&[("hw.zip", &zipped(&[("animation.txt", &right)]))]))]),
            "all.zip/hw.zip/animation.txt",
            &[],
        ),
        full(files(&[("hw.tar.gz", &tarred(&[("hw/animation.txt", &right)]))]), "hw.tar.gz/hw/animation.txt", &[]),
        full(
            files(&[("aaa_old.txt", &off), ("animation copy.txt", &off), ("animation.txt", &right)]),
            "animation.txt",
            &[
                "The keyframes are those of animation.txt; also found: animation copy.txt (8 keyframes), aaa_old.txt (8 keyframes).",
            ],
        ),
        full(
            files(&[
                ("Makefile", b"all:\n\tg++ asst6.cpp\n"),
                ("anim.h", b"float key_time = 0; int rbt_ind;\n"),
                ("asst6.cpp", b"int main() {}\n"),
                ("key.frames", &right),
                ("raytrace.cpp", b"int x;\n"),
            ]),
            "key.frames",
            &[
                "Neither keyframes, samples, trace nor script: Makefile.",
                "Skipped: 3 sources (anim.h, asst6.cpp, raytrace.cpp).",
            ],
        ),
        full(
            files(&[("animation.txt", &right), ("large.txt", &large), ("video.mp4", &video)]),
            "animation.txt",
            &["Skipped: 1 video or sound (video.mp4).", "Skipped large.txt: larger than 16 MiB."],
        ),
        none(
            files(&[("Makefile", b"all:\n"), ("animation.txt", b"")]),
            "animation.txt: line 1 column 1: the file is empty",
            &[],
        ),
        none(files(&[("animation.txt", &right[..right.len() / 2])]), "animation.txt: line 1", &[]),
        none(
            files(&[("asst6.rar", b"Rar!\x1a\x07\x01\0 and more")]),
            "asst6.rar: it is a RAR archive, and only zip, tar and tar.gz are opened",
            &[],
        ),
        none(files(&[("hw.zip", &locked("animation.txt", &right))]), "hw.zip/animation.txt: it needs a password", &[]),
        HandIn { points: 10.0, ..full(files(&[("script.script", &off)]), "script.script", &[]) },
        full(
            files(&[("animation.txt.gz", &{
                let mut packer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
                packer.write_all(&right).unwrap();
                packer.finish().unwrap()
            })]),
            "animation.txt.gz/animation.txt",
            &[],
        ),
        none(
            files(&[("AUTHORS", b"These are the authors.\n"), ("LICENSE", b"Free.\n"), ("notes.cpp", b"//")]),
            "there is no keyframe file; looked at: AUTHORS, LICENSE",
            &["Skipped: 1 source (notes.cpp)."],
        ),
    ]
}

/// A row: the name, student, id and whether it is late.
pub type Row = (String, String, String, bool);

/// The files of a class in the form of a course system, with its rows in the order of the hand-ins.
pub fn exported(form: &str, hand_ins: &[HandIn]) -> (Files, Vec<Row>) {
    let mut class = Files::new();
    let mut rows = Vec::new();
    let mut metadata = String::from("---\n");
    for (index, (hand_in, student)) in hand_ins.iter().zip(STUDENTS).enumerate() {
        let (id, is_late) = (100_000 + index, form == "canvas" && index % 4 == 1);
        let late = if is_late { "LATE_" } else { "" };
        let short: String = student.to_lowercase().split(' ').rev().collect();
        let folder = match form {
            "canvas" => format!("{short}_{late}{id}_"),
            "moodle" => format!("{student}_{id}_assignsubmission_file_/"),
            "gradescope" => format!("submission_{id}/"),
            _ => format!("{student}/"),
        };
        let numbered = |at: usize, name: &str| {
            if form == "canvas" { format!("{}_{name}", 7_000_000 + at) } else { name.to_owned() }
        };
        for (at, (name, bytes)) in hand_in.files.iter().enumerate() {
            class.push((format!("{folder}{}", numbered(at, name)), bytes.clone()));
        }
        let composed = match student {
            "Zoe\u{308} Lefe\u{300}vre" => "Zo\u{eb} Lef\u{e8}vre",
            "\u{1100}\u{1161}\u{11bc} 호동" => "강 호동",
            other => other,
        };
        let name = match form {
            "canvas" => format!("{folder}{}", numbered(0, &hand_in.files[0].0)),
            _ => folder.trim_end_matches('/').to_owned(),
        };
        let composed =
            if form == "canvas" { composed.to_lowercase().split(' ').rev().collect() } else { composed.to_owned() };
        rows.push((name, composed, if form == "folders" { String::new() } else { id.to_string() }, is_late));
        write!(
            metadata,
            "submission_{id}:\n  :submitters:\n  - :name: \"{student}\"\n    :sid: '{id}'\n  :created_at: 2026-10-01 12:00:00 Z\n"
        )
        .unwrap();
    }
    if form == "gradescope" {
        class.push(("submission_metadata.yml".to_owned(), metadata.into_bytes()));
    }
    (class, rows)
}

pub fn write_all(sandbox: &Sandbox, folder: &str, files: &Files) {
    for (name, bytes) in files {
        let path = sandbox.path(folder).join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, bytes).unwrap();
    }
}

fn borrowed(files: &Files) -> Vec<(&str, &[u8])> {
    files.iter().map(|(name, bytes)| (name.as_str(), bytes.as_slice())).collect()
}

/// Grades, checks the schema and returns the submissions by name, and what was passed over.
pub fn graded(sandbox: &Sandbox, arguments: &[&str]) -> (BTreeMap<String, Value>, Vec<String>) {
    let all: Vec<&str> =
        ["grade", "rubric.json"].iter().chain(arguments).chain(&["-o", "out", "--no-images"]).copied().collect();
    sandbox.run(&all).succeeds();
    let grades = sandbox.json("out/grades.json");
    let schema: Value = serde_json::from_str(include_str!("../../assets/grading/grades.schema.json")).unwrap();
    follows(&grades, &schema, "grades");
    let named = |value: &Value| value["name"].as_str().unwrap().to_owned();
    let submissions = grades["submissions"].as_array().unwrap();
    let by_name: BTreeMap<String, Value> = submissions.iter().map(|graded| (named(graded), graded.clone())).collect();
    assert_eq!(by_name.len(), submissions.len(), "names are different");
    (by_name, grades["passed_over"].as_array().unwrap().iter().map(named).collect())
}

fn course() -> (Sandbox, Vec<Vec<Placed>>) {
    let sandbox = Sandbox::new();
    let made = keyframes(11, 8, 22);
    sandbox.write("rubric.json", RUBRIC);
    sandbox.write("reference.json", text_of(&made, "linear"));
    (sandbox, made)
}

#[track_caller]
fn same(rows: &BTreeMap<String, Value>, expected: &BTreeMap<String, Value>, what: &str) {
    assert_eq!(rows.keys().collect::<Vec<_>>(), expected.keys().collect::<Vec<_>>(), "{what}");
    for (name, row) in rows {
        for (key, value) in row.as_object().unwrap() {
            assert_eq!(value, &expected[name][key], "{what}: {name}: {key}");
        }
    }
}

#[test]
fn a_class_gets_the_same_marks_in_every_form() {
    let (sandbox, made) = course();
    let hand_ins = hand_ins(&made);
    for form in ["canvas", "moodle", "gradescope", "folders"] {
        let (mut class, rows) = exported(form, &hand_ins);
        assert_eq!(rows.len(), 15);
        class.extend(files(&[
            ("Thumbs.db", b"x"),
            ("desktop.ini", b"x"),
            ("__MACOSX/._a", b"x"),
            ("Grades.xlsx", b"PK\x03\x04"),
            ("roster.csv", b"Student,ID,SIS Login ID\nAda,1,a\n"),
        ]));
        write_all(&sandbox, form, &class);
        let (graded_class, passed_over) = graded(&sandbox, &[form]);
        for (hand_in, (name, student, id, is_late)) in hand_ins.iter().zip(&rows) {
            let graded = graded_class.get(name).unwrap_or_else(|| panic!("{form}: {name}: {:?}", graded_class.keys()));
            assert_eq!(graded["student"], *student, "{form}: {name}");
            assert_eq!(graded["id"], if id.is_empty() { Value::Null } else { json!(id) }, "{form}: {name}");
            assert_eq!(graded["late"], *is_late, "{form}: {name}");
            assert_eq!(graded["points"], hand_in.points, "{form}: {name}: {graded}");
            let reason = item(graded, "readable")["reason"].as_str().unwrap();
            let is_alone = form == "canvas" && hand_in.files.len() == 1;
            let strip = |text: &str| {
                let archive = format!("{}/", hand_in.files[0].0);
                if is_alone { text.strip_prefix(&archive).unwrap_or(text).to_owned() } else { text.to_owned() }
            };
            assert!(reason.contains(&strip(hand_in.reason)), "{form}: {name}: {reason}");
            assert_eq!(graded["keyframe_file"], hand_in.keyframe_file.map(strip).map_or(Value::Null, Value::from));
            let notes = graded["notes"].as_array().unwrap();
            for note in hand_in.notes {
                assert!(notes.iter().any(|found| found == note), "{form}: {name}: {notes:?}");
            }
        }
        assert_eq!(graded_class.len(), rows.len(), "{form}");
        let metadata = (form == "gradescope").then_some("submission_metadata.yml");
        let rubbish = ["Grades.xlsx", "Thumbs.db", "__MACOSX", "desktop.ini", "roster.csv"];
        let mut found = passed_over.clone();
        found.sort();
        assert_eq!(found, rubbish.into_iter().chain(metadata).collect::<Vec<_>>(), "{form}");

        let mut entries: Vec<String> = std::fs::read_dir(sandbox.path(form))
            .unwrap()
            .map(|entry| format!("{form}/{}", entry.unwrap().file_name().into_string().unwrap()))
            .collect();
        entries.sort();
        let entries: Vec<&str> = entries.iter().map(String::as_str).collect();
        same(&graded(&sandbox, &entries).0, &graded_class, &format!("{form}/*"));
        let wrapped: Files = class.iter().map(|(name, bytes)| (format!("{form}/{name}"), bytes.clone())).collect();
        sandbox.write("flat.zip", zipped(&borrowed(&class)));
        sandbox.write(&format!("{form}.zip"), zipped(&borrowed(&wrapped)));
        sandbox.write(&format!("{form}.tar.gz"), tarred(&borrowed(&wrapped)));
        for archive in ["flat.zip", &format!("{form}.zip"), &format!("{form}.tar.gz")] {
            let (rows, passed) = graded(&sandbox, &[archive]);
            same(&rows, &graded_class, archive);
            assert_eq!(passed, passed_over, "{archive}");
        }
    }
    let (all, _) = graded(&sandbox, &["--classes", "canvas", "moodle", "gradescope.zip", "folders"]);
    assert_eq!(all.len(), 60);
    let table = sandbox.read("out/grades.csv");
    assert!(
        table.starts_with("\u{feff}submission,student,id,late,points,out_of,evidence,diagnosis,readable,"),
        "{table}"
    );
    assert!(table.contains("\r\n김anna_100000_7000000_animation.txt,김anna,100000,,11,11,"), "{table}");
    assert!(table.contains(",ñandújosé,100001,late,11,11,"), "{table}");
    let report = sandbox.read("out/report.html");
    assert!(report.contains("<p class=\"sum\">ñandújosé, id 100001, late</p>"), "the student");
    assert!(report.contains("<th>student</th>") && report.contains("<td>ñandújosé, id 100001, late</td>"), "overview");
    assert!(report.contains("Passed over: ") && report.contains("Thumbs.db (a hidden or system file)"), "passed over");
}

#[test]
fn rows_have_names_that_tell_them_apart() {
    let (sandbox, made) = course();
    let right = as_text(&made);
    let class = |name: &str| (format!("{name}/animation.txt"), right.clone());
    write_all(&sandbox, "a", &vec![class("ann"), class("bob")]);
    write_all(&sandbox, "b", &vec![class("ann"), class("cem")]);
    let names = |arguments: &[&str]| graded(&sandbox, arguments).0.into_keys().collect::<Vec<_>>();
    assert_eq!(names(&["a"]), ["ann", "bob"]);
    assert_eq!(names(&["a/ann/animation.txt"]), ["animation.txt"]);
    assert_eq!(
        names(&["a/ann/animation.txt", "a/bob/animation.txt", "./a/bob/animation.txt"]),
        ["ann/animation.txt", "bob/animation.txt"]
    );
    assert_eq!(names(&["--classes", "a", "b"]), ["a/ann", "b/ann", "bob", "cem"]);
    assert_eq!(names(&["a/ann", "b/cem"]), ["ann", "cem"]);
    assert_eq!(names(&["--one", "a/ann"]), ["ann"]);
    let (one, _) = graded(&sandbox, &["--one", "a"]);
    assert_eq!(
        one["a"]["notes"].as_array().unwrap().last().unwrap(),
        "The keyframes are those of ann/animation.txt; also found: bob/animation.txt (8 keyframes)."
    );
    // Every file is the program's own or a student's: results that stand in the class are not graded.
    sandbox.run(&["grade", "rubric.json", "a", "-o", "a/out", "--no-images"]).succeeds();
    let beside = ["--feedback", "a/back", "--cache", "a/kept"];
    sandbox.run(&[&["grade", "rubric.json", "a", "-o", "a", "--no-images"][..], &beside].concat()).succeeds();
    sandbox.run(&["grade", "rubric.json", "a", "-o", "a/part", "--no-images", "--shard", "1/1"]).succeeds();
    std::fs::create_dir(sandbox.path("a/.cache")).unwrap();
    let (again, passed_over) = graded(&sandbox, &["a"]);
    assert_eq!(again.into_keys().collect::<Vec<_>>(), ["ann", "bob"]);
    assert_eq!(passed_over, [".cache", "back", "grades.csv", "grades.json", "kept", "out", "part", "report.html"]);
    std::fs::create_dir(sandbox.path("empty")).unwrap();
    sandbox
        .run(&["grade", "rubric.json", "empty", "-o", "x", "--no-images"])
        .refuses("empty: there are no submissions");
    for (name, bytes, sentence) in [
        ("class.zip", &b"PK\x03\x04"[..], "the zip is broken or cut off"),
        ("class.rar", b"Rar!\x1a\x07\x01", "it is a RAR archive, and only zip, tar and tar.gz are opened"),
    ] {
        sandbox.write(name, bytes);
        sandbox.run(&["grade", "rubric.json", name, "-o", "x", "--no-images"]).refuses(&format!("{name}: {sentence}"));
    }
    sandbox.run(&["grade", "rubric.json", "a", "--one", "--classes", "-o", "x"]).misuses();
}

#[test]
fn the_rubric_names_the_keyframe_file() {
    let (sandbox, made) = course();
    let right = as_text(&made);
    let mut off = made.clone();
    off.pop();
    let other = as_text(&off);
    write_all(
        &sandbox,
        "class/ann",
        &files(&[("animation.txt", &other), ("deep/Final.TXT", &right), ("keys.h", &other)]),
    );
    let points = |rubric: String| {
        sandbox.write("rubric.json", rubric);
        let (graded, _) = graded(&sandbox, &["class"]);
        (graded["ann"]["keyframe_file"].as_str().unwrap().to_owned(), graded["ann"]["points"].as_f64().unwrap())
    };
    let with = |names: &str| RUBRIC.replace("\"points\"", &format!("\"keyframe_file\": {names}, \"points\""));
    assert_eq!(points(RUBRIC.to_owned()), ("animation.txt".to_owned(), 9.0));
    assert_eq!(points(with("[\"final.*\", \"*.txt\"]")), ("deep/Final.TXT".to_owned(), 11.0));
    assert_eq!(points(with("[\"*.h\"]")), ("keys.h".to_owned(), 9.0));
    sandbox.write("rubric.json", with("[\"a\", \"[\"]"));
    let outcome = sandbox.run(&["grade", "rubric.json", "class", "-o", "x", "--no-images"]);
    assert!(outcome.stderr.starts_with("rubric.json: keyframe_file: \"[\" is no pattern: "), "{}", outcome.stderr);
    assert_eq!(outcome.status, 1);
}

#[test]
fn names_of_files_do_not_decide() {
    let (sandbox, made) = course();
    let reference = text_of(&made, "linear");
    let paths = built_in_scene(DEFAULT_SCENE).unwrap().rbt_paths().count();
    assert_eq!(made[0].len(), paths);
    sandbox.write("hotkeys.txt", "key i\nkey >\nkey n\n");
    sandbox.write(
        "rubric.json",
        RUBRIC.replace("\"points\": {", "\"script\": \"hotkeys.txt\", \"points\": {\"script\": 4, "),
    );
    let trace = sandbox.run(&["script", "hotkeys.txt", "--keyframes", "reference.json", "--trace"]).succeeds();
    let plain = |name: &str| (name.to_owned(), reference.clone().into_bytes());
    let class: Files = ["bracelet_trace.json", "prescription.json", "my_description.json", "a/trace", "b/script.csv"]
        .map(plain)
        .into_iter()
        .chain([
            plain("c/keys.json"),
            ("c/shown.jsonl".to_owned(), trace.into_bytes()),
            plain("d/keys.json"),
            ("d/transcript.md.txt".to_owned(), b"This is how I pressed keys.\n".to_vec()),
        ])
        .collect();
    write_all(&sandbox, "class", &class);
    let (graded, _) = graded(&sandbox, &["class"]);
    assert_eq!(graded.len(), 7);
    for (name, graded) in &graded {
        assert_eq!(graded["points"], 15.0, "{name}: {graded}");
    }
    assert_eq!(item(&graded["c"], "script")["reason"], "shown.jsonl: all 3 commands match.");
}
