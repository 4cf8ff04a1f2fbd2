//! `grade` again: what has not changed is not graded again, and the results are the same.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use serde_json::Value;

use crate::grade::{course, text_of};
use crate::report::hand_in;
use crate::sandbox::Sandbox;

fn class() -> Sandbox {
    let (sandbox, made) = course();
    hand_in(&sandbox, "ada", &made, "correct");
    hand_in(&sandbox, "bob", &made, "nan-when-equal + one-keyframe-early");
    let mut own = made.clone();
    own[2][3].0[1] += 0.25;
    hand_in(&sandbox, "cy", &own, "correct");
    sandbox.write("all/dan.json", "{\"format\": ");
    sandbox
}

fn grade(sandbox: &Sandbox, folder: &str, arguments: &[&str]) -> [String; 3] {
    let pictures = ["--images", "4", "--image-size", "40x30"];
    let pictures = if arguments.contains(&"--no-images") { &[][..] } else { &pictures };
    let all = [&["grade", "rubric.json", "all", "-o", folder], pictures, arguments].concat();
    sandbox.run(&all).succeeds();
    ["grades.csv", "grades.json", "report.html"].map(|name| sandbox.read(&format!("{folder}/{name}")))
}

fn lines(sandbox: &Sandbox, file: &str) -> Vec<String> {
    sandbox.read(file).lines().map(str::to_owned).collect()
}

#[test]
fn results_from_the_cache_are_those_of_a_first_run() {
    let sandbox = class();
    let first = grade(&sandbox, "out", &[]);
    let kept = lines(&sandbox, "out/.cache/grades.cache");
    // Four submissions and two films.
    assert_eq!(kept.len(), 6);
    let written = |file: &str| -> SystemTime { sandbox.path(file).metadata().unwrap().modified().unwrap() };
    let before = written("out/.cache/grades.cache");
    assert_eq!(grade(&sandbox, "out", &[]), first);
    assert_eq!(written("out/.cache/grades.cache"), before, "nothing is new");

    // One changes: its entry is new, the others stay.
    let (_, made) = course();
    sandbox.write("all/dan.json", text_of(&made, "linear"));
    let second = grade(&sandbox, "out", &[]);
    assert_ne!(second, first);
    assert_eq!(second, grade(&sandbox, "plain", &["--no-cache"]));
    assert!(!sandbox.path("plain/.cache").exists());
    let now = lines(&sandbox, "out/.cache/grades.cache");
    assert_eq!((now.len(), kept.iter().all(|line| now.contains(line))), (7, true));
}

#[test]
fn what_results_rest_on_decides_whether_they_are_used() {
    let sandbox = class();
    grade(&sandbox, "out", &["--cache", "kept"]);
    assert!(!sandbox.path("out/.cache").exists());
    let count = || lines(&sandbox, "kept/grades.cache").len();
    assert_eq!(count(), 6);
    // Names do not count: a copy under another name has the same results.
    std::fs::create_dir(sandbox.path("all/eve")).unwrap();
    for file in ["keys.json", "linear.csv"] {
        std::fs::copy(sandbox.path(&format!("all/ada/{file}")), sandbox.path(&format!("all/eve/{file}"))).unwrap();
    }
    let copied = grade(&sandbox, "out", &["--cache", "kept"]);
    assert_eq!((count(), copied), (6, grade(&sandbox, "plain", &["--no-cache"])));
    // Another size of pictures, another rubric: other results, and no film of another first submission.
    let larger = grade(&sandbox, "out", &["--cache", "kept", "--no-images"]);
    assert_eq!((count(), larger), (10, grade(&sandbox, "plain", &["--no-cache", "--no-images"])));
    let mut rubric: Value = serde_json::from_str(&sandbox.read("rubric.json")).unwrap();
    rubric["points"]["linear_playback"] = 50.into();
    sandbox.write("rubric.json", rubric.to_string());
    let other = grade(&sandbox, "out", &["--cache", "kept"]);
    assert_eq!(other, grade(&sandbox, "plain", &["--no-cache"]));
    assert!(other[1].contains("\"out_of\": 50.0"), "{}", other[1]);
}

#[test]
fn broken_results_are_left_out() {
    let sandbox = class();
    let first = grade(&sandbox, "out", &[]);
    let kept = sandbox.read("out/.cache/grades.cache");
    let cut = &kept[..kept.len() / 2];
    let changed = kept.replace("10.0", "99.0").replace("2.0", "7.0");
    assert_ne!(changed, kept);
    for broken in [cut.as_bytes(), changed.as_bytes(), b"", b"\n\n", b"a b c\n", b"\xff\xfe\0"] {
        sandbox.write("out/.cache/grades.cache", broken);
        assert_eq!(grade(&sandbox, "out", &[]), first);
    }
    sandbox.write("notafolder", "");
    let all = ["grade", "rubric.json", "all", "-o", "out", "--no-images", "--cache", "notafolder"];
    assert_eq!(sandbox.run(&all).status, 1);
}

#[test]
fn names_are_taken_out_of_what_was_kept_too() {
    let sandbox = class();
    let path = |name: &str| sandbox.path(&format!("all/{name}"));
    std::fs::rename(path("bob"), path("Bob Stone_48102_assignsubmission_file_")).unwrap();
    std::fs::rename(
        path("Bob Stone_48102_assignsubmission_file_/linear.csv"),
        path("Bob Stone_48102_assignsubmission_file_/stone_linear.csv"),
    )
    .unwrap();
    let named = grade(&sandbox, "out", &["--cache", "kept"]);
    assert!(named.iter().all(|text| text.contains("stone_linear")));
    // Without a folder of its own nothing is kept: it would lie beside the results, with names of files.
    for arguments in [&["--anonymous"][..], &["--anonymous", "--cache", "kept"]] {
        let hidden = grade(&sandbox, "hidden", arguments);
        assert!(!sandbox.path("hidden/.cache").exists());
        for text in &hidden {
            assert!(!text.to_lowercase().contains("stone") && !text.contains("48102"), "{text}");
        }
    }
    let kept = grade(&sandbox, "out", &["--anonymous", "--cache", "kept"]);
    assert_eq!(kept, grade(&sandbox, "plain", &["--anonymous"]));
    assert_eq!(grade(&sandbox, "out", &["--cache", "kept"]), named);
}

#[test]
fn one_submission_can_be_graded_alone() {
    let sandbox = class();
    let all = ["grade", "rubric.json", "all", "-o", "out", "--no-images"];
    let run = |more: &[&str]| sandbox.run(&[&all[..], more].concat());
    // Without results of earlier runs there is nothing to say of others, and it says so.
    let said = run(&["--only", "bob", "--only", "dan.json"]).succeeds();
    assert!(said.contains("no earlier run has kept their results: ada, cy\n"), "{said}");
    let rows = || lines(&sandbox, "out/grades.csv");
    let some = rows();
    run(&[]).succeeds();
    let whole = rows();
    assert_eq!(some, [0, 2, 4].map(|row: usize| whole[row].clone()));

    // Those of the others are as they were; one that has changed too is not lost.
    let (_, made) = course();
    sandbox.write("all/dan.json", text_of(&made, "linear"));
    let report = sandbox.read("out/report.html");
    let said = run(&["--only", "dan.json"]).succeeds();
    assert!(!said.contains("left out"), "{said}");
    let now = rows();
    assert_eq!((&now[..4], now.len()), (&whole[..4], 5));
    assert_ne!((&now[4], sandbox.read("out/report.html")), (&whole[4], report));
    sandbox.write("all/ada/more.txt", "words");
    let lost = "out/grades.json has results that would be lost, as --only leaves them out: ada";
    run(&["--only", "bob"]).refuses(&format!("--only: {lost}. Grade without --only, or into another folder"));
    assert_eq!(rows(), now);
    run(&["--only", "zoe"]).refuses("--only: no submission is called zoe, by name, student or id");

    // Of a student whose submission is left out nobody can say that nothing was handed in.
    sandbox.write("roster.csv", "name,id,section\nada,1,a\nbob,2,a\nnobody,3,b\n");
    let alone =
        ["grade", "rubric.json", "all", "-o", "other", "--no-images", "--only", "bob", "--roster", "roster.csv"];
    let said = sandbox.run(&alone).succeeds();
    assert!(!said.contains("nothing handed in"), "{said}");
    assert_eq!(lines(&sandbox, "other/grades.csv").len(), 2);
}

/// All files of a folder but what is kept, with their bytes.
fn files(sandbox: &Sandbox, folder: &str) -> BTreeMap<PathBuf, Vec<u8>> {
    let root = sandbox.path(folder);
    let (mut found, mut folders) = (BTreeMap::new(), vec![root.clone()]);
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.extend((!path.ends_with(".cache")).then_some(path));
            } else {
                found.insert(path.strip_prefix(&root).unwrap().to_owned(), std::fs::read(&path).unwrap());
            }
        }
    }
    found
}

#[test]
fn shards_together_are_the_class() {
    let sandbox = class();
    let path = |name: &str| sandbox.path(&format!("all/{name}"));
    std::fs::rename(path("bob"), path("Bob Stone_48102_assignsubmission_file_")).unwrap();
    std::fs::create_dir(path("eve")).unwrap();
    std::fs::copy(path("cy/keys.json"), path("eve/keys.json")).unwrap();
    sandbox.write("all/list.xlsx", "");
    let overrides = "format = \"inbetween.overrides\"\nversion = 1\n\n[students.ada]\ncomment = \"Well done – ☺\"\n\n[students.ada.points]\nreadable = 1\n";
    sandbox.write("overrides.toml", overrides);
    sandbox.write("roster.csv", "name,id,section\nBob Stone,48102,a\nada,2,a\nZoe,3,b\n");
    let pictures = ["--images", "4", "--image-size", "40x30"];
    let forms = [
        "--roster",
        "roster.csv",
        "--to",
        "junit",
        "--to",
        "gradescope",
        "--to",
        "canvas",
        "--assignment",
        "A (1)",
        "--wide",
    ];
    let outputs = [&["-o", "whole", "--feedback", "whole/back"][..], &forms].concat();
    let said = sandbox.run(&[&["grade", "rubric.json", "all"][..], &pictures, &outputs].concat()).succeeds();
    for number in 1..=3 {
        let (shard, folder) = (format!("{number}/3"), format!("part{number}"));
        let all = [&["grade", "rubric.json", "all", "--shard", &shard, "-o", &folder][..], &pictures].concat();
        let said = sandbox.run(&all).succeeds();
        assert!(said.starts_with(&format!("shard {number} of 3, submissions graded: ")), "{said}");
        assert_eq!(files(&sandbox, &folder).keys().collect::<Vec<_>>(), [Path::new("shard.json")]);
    }
    // The class itself is not needed, nor are its files.
    std::fs::rename(sandbox.path("all"), sandbox.path("gone")).unwrap();
    std::fs::remove_file(sandbox.path("rubric.json")).unwrap();
    std::fs::remove_file(sandbox.path("overrides.toml")).unwrap();
    let outputs = [&["-o", "merged", "--feedback", "merged/back"][..], &forms].concat();
    let merged = [&["grade", "--merge", "part3", "part1", "part2"][..], &outputs].concat();
    assert_eq!(sandbox.run(&merged).succeeds(), said.replace("whole/", "merged/"));
    let whole = files(&sandbox, "whole");
    assert!(whole.len() > 15, "{:?}", whole.keys());
    let merged = files(&sandbox, "merged");
    assert_eq!(merged.keys().collect::<Vec<_>>(), whole.keys().collect::<Vec<_>>());
    for (path, bytes) in &whole {
        assert!(merged[path] == *bytes, "{}", path.display());
    }
    // Without names too.
    std::fs::rename(sandbox.path("gone"), sandbox.path("all")).unwrap();
    sandbox.write("rubric.json", crate::grade::RUBRIC);
    sandbox.write("overrides.toml", overrides);
    let hidden = |folder: &'static str| ["--anonymous", "-o", folder];
    sandbox.run(&[&["grade", "rubric.json", "all"][..], &pictures, &hidden("whole-hidden")].concat()).succeeds();
    sandbox.run(&[&["grade", "--merge", "part1", "part2", "part3"][..], &hidden("hidden")].concat()).succeeds();
    assert!(files(&sandbox, "hidden") == files(&sandbox, "whole-hidden"));
}

#[test]
fn shards_that_do_not_go_together_are_refused() {
    let sandbox = class();
    let part = |number: &str, folder: &str, more: &[&str]| {
        let all = ["grade", "rubric.json", "all", "--shard", number, "-o", folder];
        sandbox.run(&[&all[..], more].concat()).succeeds();
    };
    let none = ["--no-images"];
    part("1/2", "one", &none);
    part("2/2", "two", &none);
    part("2/3", "of-three", &none);
    sandbox.write("overrides.toml", "format = \"inbetween.overrides\"\nversion = 1\n");
    part("2/2", "overridden", &none);
    std::fs::remove_file(sandbox.path("overrides.toml")).unwrap();
    sandbox.write("all/more.json", "{}");
    part("2/2", "of-more", &none);
    std::fs::remove_file(sandbox.path("all/more.json")).unwrap();
    sandbox.write("rubric.json", sandbox.read("rubric.json").replace("Six", "Seven"));
    part("2/2", "of-other-rubric", &none);
    let refuses = |parts: &[&str], sentence: &str| {
        let all = [&["grade", "-o", "out", "--merge"][..], parts].concat();
        sandbox.run(&all).refuses(sentence);
        assert!(!sandbox.path("out").exists());
    };
    let both = |other: &str| format!("one/shard.json and {other}/shard.json");
    refuses(&["one"], "--merge: of 2 shards these are missing: 2");
    refuses(&["one", "two", "one"], &format!("{} are both shard 1 of 2", both("one")));
    refuses(&["one", "of-three"], &format!("{} are shards of different counts", both("of-three")));
    refuses(&["one", "overridden"], &format!("{} are graded with different overrides", both("overridden")));
    refuses(&["one", "of-more"], &format!("{} are shards of different classes", both("of-more")));
    refuses(&["one", "of-other-rubric"], &format!("{} are graded by different rubrics", both("of-other-rubric")));
    let text = sandbox.read("two/shard.json");
    let program = sandbox.json("two/shard.json")["basis"]["program"].as_str().unwrap().to_owned();
    for (name, from, to, sentence) in [
        (
            "other-program",
            program.as_str(),
            "0",
            "one/shard.json and other-program/shard.json are of different builds of inbetween",
        ),
        (
            "newer",
            "\"version\":1",
            "\"version\":2",
            "newer/shard.json: format is inbetween.shard and version 2, expected inbetween.shard and 1",
        ),
        (
            "pictures",
            "\"images\":null",
            "\"images\":{\"most\":1,\"size\":[4,3]}",
            "one/shard.json and pictures/shard.json are graded with different --images, --image-size or --no-images",
        ),
        ("broken", "keyframe_file", "keyframe_fail", "broken/shard.json: this is no whole shard of a class"),
    ] {
        assert!(text.contains(from), "{from}");
        sandbox.write(&format!("{name}/shard.json"), text.replace(from, to));
        refuses(&["one", name], sentence);
    }
    refuses(
        &["other-program"],
        "other-program/shard.json: another build of inbetween made it, and only that one can merge it",
    );
    for wrong in ["0/2", "3/2", "1/0", "1", "a/b", "+1/2", "1/10001"] {
        sandbox.run(&["grade", "rubric.json", "all", "--shard", wrong, "-o", "out"]).misuses();
    }
    sandbox.run(&["grade", "rubric.json", "all", "--merge", "one", "-o", "out"]).misuses();
}
