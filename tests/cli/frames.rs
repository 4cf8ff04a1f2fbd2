//! Frames by their numbers, films joined from them, and `info`.

use std::path::Path;

use serde_json::json;

use crate::sandbox::{Outcome, Sandbox, keyframe_file};

/// Seven keyframes with durations of their own, of which five play, for 1.32 s: 15 frames at 10 a second, the last between two others.
fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new();
    let mut file = keyframe_file(7);
    file["version"] = json!(2);
    file["ms_between_keyframes"] = json!(400);
    file["keyframes"][1]["duration"] = json!(0.5);
    file["keyframes"][2]["duration"] = json!(1.3);
    file["keyframes"][3]["easing"] = json!("sine-in-out");
    file["keyframes"][4]["duration"] = json!(0.5);
    sandbox.write("a.json", file.to_string());
    sandbox
}

fn render(sandbox: &Sandbox, arguments: &[&str]) -> Outcome {
    sandbox.run(&[&["render", "a.json", "--size", "32x24", "--fps", "10"], arguments].concat())
}

fn names(sandbox: &Sandbox, folder: &str) -> Vec<String> {
    let entries = std::fs::read_dir(sandbox.path(folder)).unwrap();
    let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

fn bytes(sandbox: &Sandbox, name: impl AsRef<Path>) -> Vec<u8> {
    std::fs::read(sandbox.path("").join(name)).unwrap()
}

/// The names and the bytes in a folder.
fn content(sandbox: &Sandbox, folder: &str) -> Vec<(String, Vec<u8>)> {
    let read = |name: String| {
        let bytes = bytes(sandbox, Path::new(folder).join(&name));
        (name, bytes)
    };
    names(sandbox, folder).into_iter().map(read).collect()
}

#[test]
fn parts_in_one_folder_are_the_film() {
    let sandbox = sandbox();
    render(&sandbox, &["-o", "whole"]).succeeds();
    assert_eq!(names(&sandbox, "whole").len(), 15);
    for numbers in ["7-14", "0-6:2,1", "3,5"] {
        render(&sandbox, &["-o", "parts", "--frames", numbers]).succeeds();
    }
    assert_eq!(content(&sandbox, "parts"), content(&sandbox, "whole"));
    render(&sandbox, &["-o", "one", "--frames", "14", "--frame-format", "webp"]).succeeds();
    assert_eq!(names(&sandbox, "one"), ["frame-00014.webp"]);
    // With --from, the film begins there, and numbers count from there.
    render(&sandbox, &["-o", "from", "--from", "1", "--frames", "2"]).succeeds();
    render(&sandbox, &["-o", "all-from", "--from", "1"]).succeeds();
    assert_eq!(content(&sandbox, "from")[0], content(&sandbox, "all-from")[2]);
    // A turntable turns once in the whole film, not in each part.
    render(&sandbox, &["-o", "turn", "--camera", "turntable"]).succeeds();
    render(&sandbox, &["-o", "turn-part", "--camera", "turntable", "--frames", "9"]).succeeds();
    assert_eq!(content(&sandbox, "turn-part")[0], content(&sandbox, "turn")[9]);
}

#[test]
fn a_part_of_a_film_that_is_no_folder_is_a_film_of_these_frames() {
    let sandbox = sandbox();
    render(&sandbox, &["-o", "part.gif", "--frames", "4-9"]).succeeds();
    render(&sandbox, &["-o", "frames"]).succeeds();
    sandbox.run(&["join", "frames", "--fps", "10", "--frames", "4-9", "-o", "joined.gif"]).succeeds();
    assert_eq!(bytes(&sandbox, "joined.gif"), bytes(&sandbox, "part.gif"));
}

#[test]
fn frames_that_the_film_does_not_have_are_refused() {
    let sandbox = sandbox();
    let outside = "a.json: there is no frame 15: at 10 fps they are 0 to 14";
    render(&sandbox, &["-o", "f", "--frames", "0-15"]).refuses(outside);
    render(&sandbox, &["-o", "f", "--frames", "0,15"]).refuses(outside);
    for wrong in ["", "3-1", "1-9:0", "a", "-1", "1,,2"] {
        render(&sandbox, &["-o", "f", &format!("--frames={wrong}")]).misuses();
    }
    for wrong in [
        &["a.json", "-o", "x.png", "--frames", "1"][..],
        &["a.json", "-o", "x.png", "--frames", "1", "--at", "0"],
        &["a.json", "-o", "x.png", "--frames", "1", "--sheet", "2x2"],
        &["a.json", "-o", "x.gif", "--missing"],
        &["a.json", "-o", "x.png", "--missing"],
        &["a.json", "-o", "-", "--progress", "openjd"],
    ] {
        sandbox.run(&[&["render"], wrong].concat()).misuses();
    }
    assert_eq!(sandbox.names(), ["a.json"]);
}

#[test]
fn parts_are_not_stale_and_frames_of_a_longer_film_are() {
    let sandbox = sandbox();
    render(&sandbox, &["-o", "frames", "--frames", "10-14"]).succeeds();
    render(&sandbox, &["-o", "frames", "--frames", "0-2"]).succeeds();
    sandbox.write("frames/frame-00015.png", "of another film");
    let outcome = render(&sandbox, &["-o", "frames", "--frames", "3", "--missing"]);
    outcome.refuses("frames: an image of an earlier film is in the way, frame-00015.png: --clean removes it, or name another folder");
    render(&sandbox, &["-o", "frames", "--frames", "3", "--clean"]).succeeds();
    assert_eq!(names(&sandbox, "frames").len(), 5 + 3 + 1);
}

#[test]
fn missing_frames_alone_are_drawn() {
    for ending in ["png", "webp"] {
        let sandbox = sandbox();
        let run = |more: &[&str]| {
            let arguments = [&["-o", "frames", "--frame-format", ending, "--manifest", "drawn.json"], more].concat();
            render(&sandbox, &arguments).succeeds();
            sandbox.json("drawn.json")["files"].as_array().unwrap().len()
        };
        assert_eq!(run(&[]), 15);
        let whole = content(&sandbox, "frames");
        assert_eq!(run(&["--missing"]), 0);
        let name = |number: usize| format!("frames/frame-{number:05}.{ending}");
        // Missing, empty, cut short in its middle and at its end, damaged, of another size, of another program.
        std::fs::remove_file(sandbox.path(&name(0))).unwrap();
        sandbox.write(&name(1), "");
        let frame = bytes(&sandbox, name(2));
        sandbox.write(&name(2), &frame[..frame.len() / 2]);
        sandbox.write(&name(3), &frame[..frame.len() - 1]);
        let mut damaged = frame.clone();
        let middle = frame.len() / 2;
        damaged[middle..middle + 20].fill(0);
        // A WebP has no checksum.
        let damaged = if ending == "png" { &damaged } else { &frame[1..] };
        sandbox.write(&name(4), damaged);
        let small = ["render", "a.json", "-o", "small", "--fps", "10", "--size", "16x12", "--frame-format", ending];
        sandbox.run(&small).succeeds();
        std::fs::copy(sandbox.path(&name(5).replace("frames", "small")), sandbox.path(&name(5))).unwrap();
        sandbox.write(&name(6), "GIF89a");
        assert_eq!(run(&["--missing", "--frames", "6-14"]), 1);
        assert_eq!(run(&["--missing"]), 6, "{ending}");
        assert_eq!(content(&sandbox, "frames"), whole, "{ending}");
    }
}

#[test]
fn joined_frames_are_the_film_of_one_run() {
    let sandbox = sandbox();
    for (more, endings) in [
        (&[][..], &["gif", "apng", "y4m"][..]),
        (&["--background", "transparent", "--camera", "turntable", "--ghosts", "1"], &["gif", "apng"]),
    ] {
        for still in ["png", "webp"] {
            render(&sandbox, &[&["-o", still, "--frame-format", still], more].concat()).succeeds();
            for ending in endings {
                let [one, joined] = ["one", "joined"].map(|name| format!("{name}.{ending}"));
                render(&sandbox, &[&["-o", &one], more].concat()).succeeds();
                assert_eq!(sandbox.run(&["join", still, "--fps", "10", "-o", &joined]).succeeds(), "");
                assert!(bytes(&sandbox, &one) == bytes(&sandbox, &joined), "{joined} of {still}, {more:?}");
            }
        }
    }
}

#[test]
fn what_cannot_be_joined_is_named() {
    let sandbox = sandbox();
    let join = |more: &[&str]| sandbox.run(&[&["join", "frames", "--fps", "10", "-o", "film.gif"], more].concat());
    render(&sandbox, &["-o", "frames", "--frames", "0-9"]).succeeds();
    join(&["--frames", "0-14"]).refuses(
        "frames: 5 frames are missing or not whole, frame-00010.png to frame-00014.png: render --missing draws them",
    );
    for number in [3, 6] {
        std::fs::remove_file(sandbox.path(&format!("frames/frame-{number:05}.png"))).unwrap();
    }
    join(&[]).refuses(
        "frames: 2 frames are missing or not whole, frame-00003.png to frame-00006.png: render --missing draws them",
    );
    render(&sandbox, &["-o", "frames", "--frames", "0-9", "--missing"]).succeeds();
    sandbox.write("frames/frame-00008.png", &bytes(&sandbox, "frames/frame-00008.png")[..99]);
    join(&[]).refuses("frames: a frame is missing or not whole, frame-00008.png: render --missing draws it");
    sandbox.run(&["render", "a.json", "-o", "frames", "--fps", "10", "--frames", "8", "--size", "16x12"]).succeeds();
    join(&[]).refuses("frames/frame-00008.png: it has 16x12 pixels, and frame-00000.png has 32x24");
    render(&sandbox, &["-o", "frames", "--frames", "8", "--frame-format", "webp"]).succeeds();
    join(&[])
        .refuses("frames: the folder holds numbered images of several formats, png and webp: --frame-format names one");
    join(&["--frame-format", "webp", "--frames", "8"]).succeeds();
    std::fs::create_dir(sandbox.path("empty")).unwrap();
    sandbox
        .run(&["join", "empty", "--fps", "10", "-o", "x.gif"])
        .refuses("empty: the folder holds no numbered images, such as frame-00000.png");
    sandbox
        .run(&["join", "a.json", "--fps", "10", "-o", "x.gif"])
        .refuses("a.json: a file stands where a folder is needed");
    sandbox.run(&["join", "none", "--fps", "10", "-o", "x.gif"]).refuses("none: there is no such file or folder");
    for wrong in [&["-o", "x.png"][..], &["-o", "x"], &["-o", "x.gif", "--fps", "60"]] {
        sandbox.run(&[&["join", "frames", "--fps", "10", "--frames", "0-7"], wrong].concat()).misuses();
    }
    assert_eq!(sandbox.names(), ["a.json", "empty", "film.gif", "frames"]);
}

#[test]
fn progress_in_the_words_of_open_job_description() {
    let sandbox = sandbox();
    let lines = |outcome: Outcome| outcome.succeeds();
    let rendered = lines(render(&sandbox, &["-o", "frames", "--frames", "0-3", "--progress", "openjd"]));
    assert!(rendered.starts_with("openjd_progress: 25.0\nopenjd_status: frame 1 of 4\n"), "{rendered}");
    assert!(rendered.ends_with("openjd_progress: 100.0\nopenjd_status: frame 4 of 4\n"), "{rendered}");
    let joined = lines(sandbox.run(&["join", "frames", "--fps", "10", "-o", "x.gif", "--progress", "openjd"]));
    assert_eq!(joined, rendered);
    let failed = render(&sandbox, &["-o", "frames", "--frames", "99", "--progress", "openjd"]);
    assert_eq!(failed.status, 1);
    assert_eq!(failed.stdout, format!("openjd_fail: {}", failed.stderr));
}

#[test]
fn info_says_how_many_frames_there_are() {
    let sandbox = sandbox();
    let text = sandbox.run(&["info", "a.json", "--fps", "10"]).succeeds();
    assert_eq!(
        text,
        "file           a.json: a keyframe file\n\
         scene          two-robots: 119 nodes, 22 of them in poses\n\
         keyframes      7, 5 of them played\n\
         interpolation  linear\n\
         between        400 ms\n\
         durations      3 of 7 differ from 1: 0.5 to 1.3\n\
         timed keys     0\n\
         length         1.32 s\n\
         frames         15 with 10 a second: 0 to 14\n"
    );
    let info = |arguments: &[&str]| -> serde_json::Value {
        let text = sandbox.run(&[&["info", "--json"], arguments].concat()).succeeds();
        serde_json::from_str(&text).unwrap()
    };
    let json = info(&["a.json", "--fps", "10"]);
    assert_eq!((&json["frames"], &json["seconds"], &json["text"]), (&json!(15), &json!(1.32), &json!(null)));
    assert_eq!(json["keyframes"]["durations"], json!([1.0, 0.5, 1.3, 1.0, 0.5, 1.0, 1.0]));
    sandbox.run(&["convert", "a.json", "-o", "a.txt", "--to", "rows"]).succeeds();
    let json = info(&["a.txt", "--quiet"]);
    assert_eq!((&json["keyframes"]["count"], &json["keyframes"]["played"]), (&json!(7), &json!(5)));
    assert!(json["text"].as_str().unwrap().contains("7 keyframes"), "{json}");
    let json = info(&["--scene", "cylinder", "--fps", "5"]);
    assert_eq!(json["keyframes"], json!(null));
    sandbox.run(&["render", "--scene", "cylinder", "--fps", "5", "--size", "8x6", "-o", "cylinder"]).succeeds();
    assert_eq!(json["frames"], json!(names(&sandbox, "cylinder").len()));
    sandbox.write("short.json", keyframe_file(3).to_string());
    let short = sandbox.run(&["info", "short.json"]).succeeds();
    assert!(short.contains("keyframes      3, too few to play: an animation has 4 or more\n"), "{short}");
    assert!(short.ends_with("frames         0 with 30 a second\n"), "{short}");
    sandbox.write("bad.json", "{");
    assert_eq!(sandbox.run(&["info", "bad.json"]).status, 1);
}
