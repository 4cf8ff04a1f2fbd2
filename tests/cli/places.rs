//! Where commands read and write: `-` in every command, and nothing that is written twice or over an input.

use std::collections::BTreeMap;

use inbetween::scene::{built_in_scene, scene_to_json};
use serde_json::json;

use crate::sandbox::{Outcome, Sandbox, keyframe_file};

const SCRIPT: &str = "key i\nselect robot1/head\ntranslate 1 0 0\nkey n\n";

fn rubric(reference: &str) -> String {
    json!({"format": "inbetween.rubric", "version": 1, "reference": reference, "points": {"readable": 1}}).to_string()
}

/// A folder with a file of every kind that is read.
pub fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new();
    sandbox.write("a.json", keyframe_file(5).to_string());
    let mut other = keyframe_file(5);
    other["keyframes"][2]["pose"][3]["translation"] = json!([7, 0, 0]);
    sandbox.write("b.json", other.to_string());
    sandbox.write("scene.json", scene_to_json(&built_in_scene("orbits").unwrap()));
    sandbox.write("script.txt", SCRIPT);
    sandbox.write("writes.txt", "key i\nkey n\nkey w\n");
    sandbox.write("makes.txt", "key n\nkey w\n");
    sandbox.write("saves.txt", "save-scene out\n");
    sandbox.write("saves-standard.txt", "save-scene -\n");
    sandbox.write("shoots.txt", "screenshot out\n");
    sandbox.write("shoots-standard.txt", "screenshot -\n");
    sandbox.write("rubric.json", rubric("a.json"));
    sandbox.write("rubric-standard.json", rubric("-"));
    sandbox.write("joints.txt", sandbox.run(&["nodes"]).succeeds());
    sandbox.run(&["convert", "a.json", "-o", "rows.txt", "--to", "rows", "--exact"]).succeeds();
    sandbox.write("s.csv", sandbox.run(&["sample", "a.json", "--fps", "10", "--format", "csv"]).succeeds());
    for (name, level) in [("a.png", 90), ("b.png", 140)] {
        image::RgbImage::from_pixel(24, 16, image::Rgb([level, 90, 90])).save(sandbox.path(name)).unwrap();
    }
    let outcome = sandbox.run(&["script", "script.txt", "--keyframes", "a.json", "--journal", "a.journal"]);
    assert_eq!(outcome.status, 0, "{}", outcome.stderr);
    sandbox
}

/// Every file of the folder, but for those below folders.
fn files(sandbox: &Sandbox) -> BTreeMap<String, Vec<u8>> {
    let names = sandbox.names().into_iter();
    names.filter_map(|name| Some((name.clone(), std::fs::read(sandbox.path(&name)).ok()?))).collect()
}

/// What a run left.
pub struct Ran {
    pub status: Option<i32>,
    pub stdout: Vec<u8>,
    pub stderr: String,
}

/// Runs the program, with a file as standard input.
pub fn run(sandbox: &Sandbox, arguments: &[&str], input: Option<&str>) -> Ran {
    let mut command = sandbox.command(arguments);
    if let Some(input) = input {
        command.write_stdin(std::fs::read(sandbox.path(input)).unwrap());
    }
    let output = command.output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    Ran { status: output.status.code(), stdout: output.stdout, stderr }
}

#[test]
fn what_is_read_can_be_standard_input_in_every_command() {
    let sandbox = sandbox();
    // `@` stands for the file, and for - in its place.
    for (file, arguments) in [
        ("a.json", &["check", "b.json", "@"][..]),
        ("a.json", &["sample", "@", "--at", "0.5"]),
        ("a.json", &["convert", "@", "-o", "out"]),
        ("rows.txt", &["convert", "@", "-o", "out"]),
        ("joints.txt", &["convert", "rows.txt", "-o", "out", "--joints", "@"]),
        ("scene.json", &["nodes", "--scene", "@"]),
        ("scene.json", &["sample", "--scene", "@"]),
        ("a.json", &["diff", "@", "b.json", "--fps", "5"]),
        ("a.json", &["diff", "b.json", "@", "--fps", "5"]),
        ("a.json", &["diagnose", "@", "s.csv"]),
        ("s.csv", &["diagnose", "a.json", "@"]),
        ("a.png", &["compare", "@", "b.png"]),
        ("a.png", &["compare", "b.png", "@"]),
        ("script.txt", &["script", "@", "--trace", "--keyframes", "a.json"]),
        ("a.journal", &["script", "@", "--state", "out"]),
        ("a.json", &["script", "script.txt", "--keyframes", "@", "--state", "out"]),
        ("a.json", &["render", "@", "-o", "out.png", "--at", "1", "--size", "32x24"]),
        ("rubric.json", &["grade", "@", "b.json", "-o", "graded", "--no-images"]),
        ("a.json", &["grade", "rubric.json", "@", "-o", "graded", "--no-images"]),
    ] {
        let with = |name: &str| -> Vec<String> { arguments.iter().map(|word| word.replace('@', name)).collect() };
        let left = |name: &str, input: Option<&str>| {
            let words = with(name);
            let ran = run(&sandbox, &words.iter().map(String::as_str).collect::<Vec<_>>(), input);
            let mut files = files(&sandbox);
            for made in ["out", "out.png"] {
                let _ = std::fs::remove_file(sandbox.path(made));
            }
            files.retain(|name, _| name.starts_with("out"));
            (ran, files)
        };
        let ((named, files_of_named), (standard, files_of_standard)) = (left(file, None), left("-", Some(file)));
        let said = |ran: &Ran| String::from_utf8_lossy(&ran.stdout).replace("standard input", file) + &ran.stderr;
        assert_eq!((standard.status, said(&standard)), (named.status, said(&named)), "{arguments:?}");
        assert!(named.status < Some(2), "{arguments:?}: {}", named.stderr);
        assert_eq!(files_of_standard, files_of_named, "{arguments:?}");
    }
    let reference = ["grade", "rubric-standard.json", "b.json", "-o", "graded", "--no-images"];
    let ran = run(&sandbox, &reference, Some("a.json"));
    assert_eq!((ran.status, ran.stderr.as_str()), (Some(0), ""));
}

#[test]
fn what_is_written_can_be_standard_output_in_every_command() {
    let sandbox = sandbox();
    // `@` stands for the file `out`, and for - in its place.
    for arguments in [
        &["convert", "a.json", "-o", "@"][..],
        &["convert", "a.json", "-o", "@", "--to", "csv"],
        &["compare", "a.png", "b.png", "-o", "@"],
        &["recover", "a.journal", "-o", "@"],
        &["script", "script.txt", "--keyframes", "a.json", "--state", "@"],
        &["script", "makes.txt", "--keyframes", "@"],
        &["script", "saves@.txt"],
        &["script", "shoots@.txt", "--size", "32x24"],
        &["render", "-o", "@", "--size", "32x24"],
        &["render", "-o", "@", "--size", "32x24", "--id"],
        &["render", "a.json", "-o", "@", "--sheet", "2x1", "--size", "32x24"],
        &["render", "-o", "pic.png", "--size", "32x24", "--manifest", "@"],
    ] {
        let with = |name: &str, in_name: &str| -> Vec<String> {
            let word = |word: &&str| if *word == "@" { name.to_owned() } else { word.replace('@', in_name) };
            arguments.iter().map(word).collect()
        };
        let ran = |words: Vec<String>| run(&sandbox, &words.iter().map(String::as_str).collect::<Vec<_>>(), None);
        let named = ran(with("out", ""));
        let written = std::fs::read(sandbox.path("out")).unwrap_or_else(|_| panic!("{arguments:?}: {}", named.stderr));
        std::fs::remove_file(sandbox.path("out")).unwrap();
        let before = sandbox.names();
        let standard = ran(with("-", "-standard"));
        assert_eq!(standard.status, named.status, "{arguments:?}: {}", standard.stderr);
        assert!(standard.stdout == written, "{arguments:?}: {}", String::from_utf8_lossy(&standard.stdout));
        // What is said beside it goes to standard error then.
        let said = String::from_utf8_lossy(&named.stdout).replace("out: ", "standard output: ") + &*named.stderr;
        assert_eq!(standard.stderr, said, "{arguments:?}");
        assert_eq!(sandbox.names(), before, "{arguments:?}");
    }
    let both = run(&sandbox, &["convert", "-", "-o", "-"], Some("rows.txt"));
    let by_name = sandbox.run(&["convert", "rows.txt", "-o", "out"]);
    assert_eq!((both.status, by_name.status), (Some(0), 0));
    assert_eq!(String::from_utf8(both.stdout).unwrap(), sandbox.read("out"));
}

/// Wrong usage, with a sentence, and nothing in the folder changes.
#[track_caller]
fn misuses(sandbox: &Sandbox, arguments: &[&str], sentence: &str) {
    let before = files(sandbox);
    let ran = run(sandbox, arguments, Some("a.json"));
    assert_eq!((ran.status, ran.stdout.is_empty()), (Some(2), true), "{arguments:?}: {}", ran.stderr);
    assert!(ran.stderr.contains(sentence), "{arguments:?}: {}", ran.stderr);
    assert!(files(sandbox) == before, "{arguments:?} changed a file");
}

#[test]
fn standard_input_and_output_have_one_use_each() {
    let sandbox = sandbox();
    sandbox.write("imports-twice.txt", "key i\nkey i\n");
    sandbox.write("saves-twice.txt", "save-scene -\nscreenshot -\n");
    for arguments in [
        &["check", "-", "-"][..],
        &["diff", "-", "-"],
        &["compare", "-", "/dev/stdin"],
        &["diagnose", "-", "-"],
        &["sample", "-", "--scene", "-"],
        &["render", "-", "--scene", "-", "-o", "x.png"],
        &["convert", "-", "-o", "x.json", "--joints", "-"],
        &["script", "-", "--scene", "-"],
        &["script", "imports-twice.txt", "--keyframes", "-"],
        &["grade", "-", "-", "-o", "graded"],
    ] {
        misuses(&sandbox, arguments, "cannot both be standard input");
    }
    for arguments in [
        &["render", "-o", "-", "--manifest", "-"][..],
        &["render", "-o", "-", "--manifest", "/dev/stdout"],
        &["script", "script.txt", "--keyframes", "-", "--state", "-"],
        &["script", "script.txt", "--trace", "--state", "-"],
        &["script", "writes.txt", "--trace", "--keyframes", "-"],
        &["script", "saves-twice.txt"],
    ] {
        misuses(&sandbox, arguments, "cannot both go to standard output");
    }
    misuses(
        &sandbox,
        &["render", "a.json", "-o", "-", "--fps", "5"],
        "numbered images of a film are files in a folder",
    );
    for arguments in
        [&["grade", "rubric.json", "a.json", "-o", "-"][..], &["verify", "-"], &["verify", "all", "-o", "-"]]
    {
        misuses(&sandbox, arguments, "a folder cannot be standard input or standard output");
    }
    for arguments in [&["-"][..], &["recover", "-"], &["script", "script.txt", "--journal", "-"]] {
        misuses(&sandbox, arguments, "needs a file that has a name");
    }
    // A device is no file: two outputs may go there.
    assert_eq!(sandbox.run(&["render", "-o", "/dev/null", "--size", "9x9", "--manifest", "/dev/null"]).status, 0);
}

#[cfg(unix)]
#[test]
fn no_file_is_written_twice_or_over_an_input() {
    let sandbox = sandbox();
    for (name, target) in [("link.json", "a.json"), ("dangling", "x.png"), ("link.png", "a.png")] {
        std::os::unix::fs::symlink(target, sandbox.path(name)).unwrap();
    }
    std::fs::create_dir(sandbox.path("frames")).unwrap();
    sandbox.write("shoots-script.txt", "screenshot ./shoots-script.txt\n");
    sandbox.write("shoots-keyframes.txt", "screenshot w.json\nkey n\nsave-as ./w.json\n");
    for arguments in [
        &["convert", "a.json", "-o", "./a.json"][..],
        &["convert", "a.json", "-o", "link.json"],
        &["convert", "a.json", "b.json", "-o", "."],
        &["convert", "rows.txt", "-o", "joints.txt", "--joints", "joints.txt"],
        &["convert", "rows.txt", "-o", "joints.txt", "--joints", "joints.txt", "--overwrite"],
        &["convert", "a.json", "-o", "scene.json", "--scene", "scene.json"],
        &["render", "a.json", "-o", "link.json"],
        &["render", "-o", "scene.json", "--scene", "scene.json"],
        &["render", "-o", "x.png", "--manifest", "dangling"],
        &["render", "a.json", "-o", "x.png", "--manifest", "link.json"],
        &["render", "a.json", "-o", "frames", "--fps", "5", "--manifest", "./frames/frame-00001.png"],
        &["compare", "a.png", "b.png", "-o", "link.png"],
        &["script", "script.txt", "--state", "script.txt"],
        &["script", "script.txt", "--keyframes", "script.txt"],
        &["script", "script.txt", "--keyframes", "a.json", "--state", "link.json"],
        &["script", "a.journal", "--journal", "a.journal"],
        &["script", "script.txt", "--scene", "scene.json", "--state", "./scene.json"],
        &["script", "shoots-script.txt"],
        &["script", "shoots-keyframes.txt"],
        &["recover", "a.journal", "-o", "./a.journal"],
    ] {
        misuses(&sandbox, arguments, "name the same file");
    }
    let results = "grades.json";
    sandbox.write(results, rubric("a.json"));
    misuses(&sandbox, &["grade", results, "b.json", "-o", ".", "--no-images"], "name the same file");
    sandbox.write(results, keyframe_file(5).to_string());
    sandbox.write("rubric.json", rubric(results));
    misuses(&sandbox, &["grade", "rubric.json", "b.json", "-o", ".", "--no-images"], "name the same file");
    sandbox.write("rubric.json", rubric("a.json"));
    misuses(&sandbox, &["grade", "rubric.json", results, "-o", ".", "--no-images"], "name the same file");
    // What is meant is done.
    sandbox.run(&["convert", "link.json", "-o", "a.json", "--overwrite"]).succeeds();
    let outcome = sandbox.run(&["script", "writes.txt", "--keyframes", "a.json"]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
}

#[test]
fn references_are_not_written_over_each_other_or_the_list() {
    let sandbox = sandbox();
    std::fs::create_dir(sandbox.path("dir")).unwrap();
    let list = |pictures: serde_json::Value| {
        let list = json!({"format": "inbetween.pictures", "version": 1, "pictures": pictures});
        sandbox.write("dir/pictures.json", list.to_string());
        list.to_string()
    };
    let keeps = |written: String, arguments: &[&str]| {
        misuses(&sandbox, arguments, "name the same file");
        assert_eq!(sandbox.read("dir/pictures.json"), written);
    };
    keeps(list(json!([{"name": "a", "reference": "./pictures.json"}])), &["verify", "dir", "--update"]);
    keeps(
        list(json!([{"name": "a", "reference": "same.png"}, {"name": "b", "reference": "same.png"}])),
        &["verify", "dir", "--update"],
    );
    keeps(list(json!([{"name": "a"}])), &["verify", "dir", "-o", "./dir"]);
    keeps(list(json!([{"name": "a"}, {"name": "a-difference"}])), &["verify", "dir"]);
}

#[cfg(target_os = "linux")]
#[test]
fn pictures_too_large_to_compare_are_refused_by_their_heads() {
    let sandbox = sandbox();
    let head = |name: &str, width: u32, height: u32| {
        let sides = [width.to_be_bytes(), height.to_be_bytes()].concat();
        sandbox.write(name, [&b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR"[..], &sides].concat());
    };
    head("huge.png", 16_384, 16_384);
    head("wide.png", 25, 16);
    for (arguments, sentence) in [
        (
            ["huge.png", "a.png"],
            "huge.png: a picture of 16384x16384 pixels, and at most 16384 on a side and 67108864 in all are read",
        ),
        (["a.png", "wide.png"], "a.png and wide.png: the pictures have different sizes: 24x16 and 25x16"),
    ] {
        let Outcome { status, stderr, .. } = sandbox.run(&[&["compare"][..], &arguments].concat());
        assert_eq!((status, stderr.trim_end()), (2, sentence));
    }
    let refused = run(&sandbox, &["compare", "-", "a.png"], Some("huge.png"));
    assert_eq!(refused.status, Some(2));
    assert!(refused.stderr.starts_with("standard input: a picture of 16384x16384 pixels"), "{}", refused.stderr);
}

#[test]
fn the_meshes_beside_a_scene_are_not_written_over() {
    let sandbox = sandbox();
    sandbox.write("scene.glb", "meshes");
    let ran = run(&sandbox, &["sample", "--scene", "scene.json", "-o", "scene.glb"], None);
    assert_eq!(ran.status, Some(2), "{}", ran.stderr);
    assert_eq!(std::fs::read(sandbox.path("scene.glb")).unwrap(), b"meshes");
}
