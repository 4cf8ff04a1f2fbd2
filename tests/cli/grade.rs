use std::collections::BTreeMap;
use std::io::{Cursor, Write as _};

use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use serde_json::{Value, json};
use zip::write::SimpleFileOptions;

use crate::sandbox::Sandbox;
use crate::student::{LINEAR, Placed, SPLINE, Student, file, varied_keyframes};

pub const RUBRIC: &str = r#"{"format": "inbetween.rubric", "version": 1, "title": "<b>Six</b>", "reference": "reference.json",
    "script": "hotkeys.txt", "playback": "assumed", "tolerances": {"translation": 0.001, "rotation_degrees": 0.1},
    "points": {"readable": 2, "keyframe_count": 1, "each_keyframe": 1, "linear_playback": 5, "catmull_rom_playback": 5,
    "range_and_end": 2, "script": 3}}"#;

fn paths() -> Vec<String> {
    built_in_scene(DEFAULT_SCENE).unwrap().rbt_paths().map(str::to_owned).collect()
}

pub fn text_of(keyframes: &[Vec<Placed>], interpolation: &str) -> String {
    file(keyframes, &paths(), "two-robots", interpolation, 2000)
}

/// A rubric, its reference, and an empty folder `all`.
pub fn course() -> (Sandbox, Vec<Vec<Placed>>) {
    let sandbox = Sandbox::new();
    let made = varied_keyframes(11, 8, 22);
    sandbox.write("rubric.json", RUBRIC);
    sandbox.write("reference.json", text_of(&made, "linear"));
    sandbox.write("hotkeys.txt", "key i\nkey >\nkey n\nkey y\nwait 300ms\nkey t\nwait 60s\n");
    std::fs::create_dir(sandbox.path("all")).unwrap();
    (sandbox, made)
}

fn graded(sandbox: &Sandbox) -> BTreeMap<String, Value> {
    let arguments = ["grade", "rubric.json", "all", "-o", "out", "--no-images"];
    assert!(sandbox.run(&arguments).succeeds().contains("graded"));
    let grades = sandbox.json("out/grades.json");
    let schema: Value = serde_json::from_str(include_str!("../../assets/grading/grades.schema.json")).unwrap();
    follows(&grades, &schema, "grades");
    let submissions = grades["submissions"].as_array().unwrap();
    submissions.iter().map(|graded| (graded["name"].as_str().unwrap().to_owned(), graded.clone())).collect()
}

/// Checks what the schema uses of JSON Schema.
pub fn follows(value: &Value, schema: &Value, place: &str) {
    let is_type = |name: &str| match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        "integer" => value.is_u64(),
        _ => value.is_number(),
    };
    let types = schema["type"].as_array().cloned().unwrap_or_else(|| vec![schema["type"].clone()]);
    assert!(types.iter().any(|name| is_type(name.as_str().unwrap())), "{place} is {value}");
    if let Some(allowed) = schema["enum"].as_array() {
        assert!(allowed.contains(value), "{place} is {value}");
    }
    for (number, entry) in value.as_array().into_iter().flatten().enumerate() {
        follows(entry, &schema["items"], &format!("{place}[{number}]"));
    }
    if let Some(object) = value.as_object() {
        for required in schema["required"].as_array().unwrap() {
            assert!(object.contains_key(required.as_str().unwrap()), "{place} has no {required}");
        }
        for (key, entry) in object {
            assert!(!schema["properties"][key].is_null(), "{place} has an unknown {key}");
            follows(entry, &schema["properties"][key], &format!("{place}.{key}"));
        }
    }
}

pub fn item<'a>(graded: &'a Value, name: &str) -> &'a Value {
    graded["items"].as_array().unwrap().iter().find(|item| item["item"] == name).unwrap()
}

pub fn zipped(members: &[(&str, &[u8])]) -> Vec<u8> {
    let mut writer = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in members {
        writer.start_file(*name, SimpleFileOptions::default()).unwrap();
        writer.write_all(bytes).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

#[test]
fn every_mistake_of_a_submission_is_diagnosed_rightly() {
    let (sandbox, made) = course();
    let mut expected: Vec<(String, &str)> = Vec::new();
    for (mistakes, plays_splines) in [(&LINEAR[..], false), (&SPLINE[..], true)] {
        let interpolation = if plays_splines { "catmull-rom" } else { "linear" };
        for mistake in mistakes {
            let name = format!("{interpolation} {mistake}");
            let student = Student { mistake, plays_splines, keyframes: &made };
            let samples = student.samples(6.0, 2000.0, *mistake == "integer-tick", 6);
            let keys = text_of(&made, interpolation);
            if plays_splines {
                std::fs::create_dir(sandbox.path(&format!("all/{name}"))).unwrap();
                sandbox.write(&format!("all/{name}/keys.json"), keys);
                sandbox.write(&format!("all/{name}/shown.csv"), samples);
                sandbox.write(&format!("all/{name}/player.cpp"), "int main() {}");
                expected.push((name, mistake));
            } else {
                let name = format!("{name}.zip");
                let members = [("work/keys.json", keys.as_bytes()), ("work/shown.csv", samples.as_bytes())];
                sandbox.write(&format!("all/{name}"), zipped(&members));
                expected.push((name, mistake));
            }
        }
    }
    sandbox.write("all/right.json", text_of(&made, "linear"));
    sandbox.write("all/broken.json", "{\"format\": ");
    sandbox.write("all/broken.zip", b"PK\x03\x04 and no more");
    sandbox.write("all/=1+1.json", "=2+2");
    let submissions = expected.len() + 4;
    assert_eq!(std::fs::read_dir(sandbox.path("all")).unwrap().count(), submissions);

    let graded = graded(&sandbox);
    assert_eq!(graded.len(), submissions);
    for (name, mistake) in &expected {
        let graded = &graded[name];
        assert_eq!(graded["samples"][0]["best"], *mistake, "{name}");
        assert_eq!(graded["samples"][0]["explained"], true);
        assert_eq!(item(graded, "readable")["points"], 2.0);
        let is_right = ["correct", "correct-catmull-rom", "last-sample-missing"].contains(mistake);
        let playback = if name.starts_with("linear") { "linear_playback" } else { "catmull_rom_playback" };
        assert_eq!(item(graded, playback)["points"], if is_right { 5.0 } else { 0.0 }, "{name}");
        assert!(item(graded, playback)["reason"].as_str().unwrap().contains(mistake) || is_right);
        let ends_wrong = ["last-sample-missing", "all-keyframes-played", "one-keyframe-early"].contains(mistake);
        assert_eq!(item(graded, "range_and_end")["points"], if ends_wrong { 0.0 } else { 2.0 }, "{name}");
    }
    assert_eq!(graded["right.json"]["points"], graded["right.json"]["out_of"]);
    for broken in ["broken.json", "broken.zip", "=1+1.json"] {
        assert_eq!(graded[broken]["points"], 0.0);
    }
    let csv = sandbox.read("out/grades.csv");
    assert!(csv.contains("'=1+1.json") && !csv.lines().any(|line| line.starts_with('=')), "{csv}");
    let html = sandbox.read("out/report.html");
    assert!(html.contains("&lt;b&gt;Six&lt;/b&gt;") && !html.contains("<b>"));

    let again = ["grade", "rubric.json", "all", "-o", "again", "--no-images"];
    sandbox.run(&again).succeeds();
    for name in ["grades.csv", "grades.json", "report.html"] {
        assert!(sandbox.read(&format!("out/{name}")) == sandbox.read(&format!("again/{name}")), "{name} differs");
    }
}

#[test]
fn other_keyframes_lose_their_own_points() {
    let (sandbox, mut made) = course();
    made[3][5].0[1] += 0.5;
    sandbox.write("all/a.json", text_of(&made, "linear"));
    made.pop();
    sandbox.write("all/b.json", text_of(&made, "linear"));
    let graded = graded(&sandbox);
    let a = &graded["a.json"];
    let lost: Vec<&str> = a["items"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|item| item["points"] == 0.0)
        .map(|item| item["item"].as_str().unwrap())
        .collect();
    assert_eq!(lost, ["keyframe 3", "linear_playback", "catmull_rom_playback"]);
    assert_eq!(item(a, "keyframe 3")["reason"], "The translation of robot1/left_shoulder is 0.5000 units off.");
    let b = &graded["b.json"];
    assert_eq!(item(b, "keyframe_count")["reason"], "7 keyframes, expected 8.");
    assert_eq!(item(b, "keyframe 7")["reason"], "It is not there.");
    assert_eq!(item(b, "range_and_end")["points"], 0.0);
    assert_eq!(item(b, "script")["points"], 0.0);
}

#[test]
fn a_students_own_layout_is_read() {
    let (sandbox, _) = course();
    for layout in ["header", "frames", "pairs", "header-quaternion-first"] {
        let out = format!("all/{layout}.txt");
        sandbox.run(&["convert", "reference.json", "-o", &out, "--to", layout, "--exact"]).succeeds();
    }
    let graded = graded(&sandbox);
    assert_eq!(graded.len(), 4);
    for (name, graded) in graded {
        assert_eq!(graded["points"], graded["out_of"], "{name}: {graded}");
        assert!(graded["notes"][0].as_str().unwrap().starts_with(&format!("{name}: 8 keyframes")), "{graded}");
    }
}

#[test]
fn scripts_stay_in_their_own_folder() {
    let (sandbox, made) = course();
    sandbox.write("secret.json", text_of(&made, "linear"));
    for (name, script) in [
        ("out", "screenshot ../stolen.png\n"),
        ("absolute", "screenshot /tmp/inbetween-stolen.png\n"),
        ("writes", "key n\nkey w\nsave-scene scene.json\nscreenshot shot.png\n"),
        ("scene", "save-scene ../stolen.json\n"),
        ("waits", "wait 1000000s\n"),
        ("right", "key i\nkey >\nkey n\nkey y\nwait 300ms\nkey t\nwait 60s\n"),
    ] {
        std::fs::create_dir(sandbox.path(&format!("all/{name}"))).unwrap();
        sandbox.write(&format!("all/{name}/keys.json"), text_of(&made, "linear"));
        sandbox.write(&format!("all/{name}/script.txt"), script);
    }
    let before = sandbox.names();
    let graded = graded(&sandbox);
    for (name, sentence) in [
        ("out", "script.txt: line 1: ../stolen.png: a script that is graded reads and writes only in its own folder."),
        ("absolute", "a script that is graded reads and writes only in its own folder."),
        ("writes", "script.txt: after command 1 (key i), keyframes is 1, expected 8."),
        (
            "scene",
            "script.txt: line 1: ../stolen.json: a script that is graded reads and writes only in its own folder.",
        ),
        ("waits", "script.txt: line 1: it waits for more than 3600 s."),
        ("right", "script.txt: all 7 commands match."),
    ] {
        let reason = item(&graded[name], "script")["reason"].as_str().unwrap();
        assert!(reason.ends_with(sentence), "{name}: {reason}");
    }
    assert_eq!(item(&graded["right"], "script")["points"], 3.0);
    let after: Vec<String> = sandbox.names().into_iter().filter(|name| name != "out").collect();
    assert_eq!(after, before);
    for name in ["shot.png", "animation.json", "scene.json"] {
        assert!(!sandbox.path(&format!("all/writes/{name}")).exists(), "{name}");
    }
}

#[test]
fn what_a_submission_unpacks_to_is_bounded() {
    let (sandbox, made) = course();
    sandbox.write("all/large.zip", zipped(&[("a.json", &vec![b' '; (16 << 20) + 1])]));
    let many: Vec<String> = (0..201).map(|number| format!("{number}.json")).collect();
    let many: Vec<(&str, &[u8])> = many.iter().map(|name| (name.as_str(), &b"{}"[..])).collect();
    sandbox.write("all/many.zip", zipped(&many));
    sandbox.write("all/outside.zip", zipped(&[("../../outside.json", text_of(&made, "linear").as_bytes())]));
    let graded = graded(&sandbox);
    let reason = |name: &str| item(&graded[name], "readable")["reason"].as_str().unwrap().to_owned();
    assert_eq!(reason("large.zip"), "there is no keyframe file; skipped a.json: larger than 16 MiB.");
    assert_eq!(
        reason("many.zip"),
        "there is no keyframe file; looked at: 0.json, 1.json, 10.json, 100.json and 196 more."
    );
    let note = graded["many.zip"]["notes"].as_array().unwrap().last().unwrap();
    assert_eq!(note, "Skipped 99.json: at most 200 files and 64 MiB of a submission are read.");
    assert_eq!(item(&graded["outside.zip"], "readable")["points"], 2.0);
    assert!(!sandbox.path("outside.json").exists());
}

#[test]
fn what_a_program_showed_is_what_is_drawn() {
    let (sandbox, made) = course();
    let student = Student { mistake: "nan-when-equal", plays_splines: false, keyframes: &made };
    std::fs::create_dir(sandbox.path("all/a")).unwrap();
    sandbox.write("all/a/keys.json", text_of(&made, "linear"));
    sandbox.write("all/a/linear.csv", student.samples(6.0, 2000.0, false, 6));
    sandbox.run(&["grade", "rubric.json", "all", "-o", "out"]).succeeds();
    let html = sandbox.read("out/report.html");
    assert!(html.contains("Linear, as linear.csv shows it") && html.contains("Linear, key time "), "captions");
    assert!(!html.contains("Catmull-Rom, "), "that playback lost nothing");
    assert!(html.contains("<td>keyframes 0 to 7</td>"), "one row");
}

#[test]
fn every_bound_is_named_when_it_is_hit() {
    let (sandbox, made) = course();
    let keys = text_of(&made, "linear");
    let folder = |name: &str, members: &[(&str, Vec<u8>)]| {
        std::fs::create_dir(sandbox.path(&format!("all/{name}"))).unwrap();
        for (file, bytes) in members {
            sandbox.write(&format!("all/{name}/{file}"), bytes);
        }
    };
    std::fs::create_dir_all(sandbox.path("all/deep/1/2/3/4/5/6/7/8/9/10")).unwrap();
    let entries: Vec<String> = (0..20_001).map(|number| format!("{number}.o")).collect();
    let entries: Vec<(&str, &[u8])> = entries.iter().map(|name| (name.as_str(), &b""[..])).collect();
    sandbox.write("all/entries.zip", zipped(&entries));
    let blank = vec![b' '; 15 << 20];
    sandbox.write("all/sum.zip", zipped(&["a", "b", "c", "d", "e"].map(|name| (name, &blank[..]))));
    folder(
        "nested",
        &[("keys.json", [&b"{\"format\": \"inbetween.keyframes\", \"more\": "[..], &b"[".repeat(1 << 20)].concat())],
    );
    folder("rows", &[("keys.txt", b"0 0 0 1 0 0 0\n".repeat(22 * 2001))]);
    let mut samples = b"key_time,rbt_ind,tx,ty,tz,rw,rx,ry,rz\n".to_vec();
    samples.extend(b"0,0,0,0,0,1,0,0,0\n".repeat((4 << 20) / 18));
    folder("samples", &[("keys.json", keys.clone().into_bytes()), ("linear.csv", samples)]);
    folder("script", &[("keys.json", keys.clone().into_bytes()), ("script.txt", b"undo\n".repeat(2001))]);
    folder(
        "writes",
        &[("keys.json", keys.into_bytes()), ("script.txt", [&b"key i\n"[..], &b"key n\nkey w\n".repeat(900)].concat())],
    );
    let spaces = [&b" ".repeat(12 << 20)[..], text_of(&made, "linear").as_bytes()].concat();
    folder("reads", &[("keys.json", spaces), ("script.txt", b"key i\n".repeat(6))]);
    let graded = graded(&sandbox);
    for (name, place, sentence) in [
        ("reads", "script", "script.txt: line 6: it reads more than 67108864 bytes"),
        ("deep", "readable", "folders more than 8 deep"),
        ("entries.zip", "readable", "the rest: at most 20000 files and folders of a submission are listed"),
        ("sum.zip", "readable", "there is no keyframe file; looked at: a, b, c, d"),
        ("nested", "readable", "unknown field \"more\""),
        ("rows", "readable", "2001 keyframes, and at most 2000 are graded"),
        ("samples", "linear_playback", "at most 4194304 are read"),
        ("script", "script", "2001 commands, and at most 2000 are run"),
        ("writes", "script", "it writes more than 33554432 bytes"),
    ] {
        let item = item(&graded[name], place);
        assert_eq!(item["points"], 0.0, "{name}");
        assert!(item["reason"].as_str().unwrap().contains(sentence), "{name}: {}", item["reason"]);
    }
    assert_eq!(
        graded["sum.zip"]["notes"],
        json!(["Skipped e: at most 200 files and 64 MiB of a submission are read."])
    );
}

#[cfg(unix)]
#[test]
fn links_out_of_the_folder_are_not_followed() {
    use std::os::unix::fs::symlink;
    let (sandbox, made) = course();
    sandbox.write("all/inside.json", text_of(&made, "linear"));
    symlink(sandbox.path("reference.json"), sandbox.path("all/out.json")).unwrap();
    symlink(sandbox.path("all/inside.json"), sandbox.path("all/in.json")).unwrap();
    std::fs::create_dir(sandbox.path("all/folder")).unwrap();
    symlink(sandbox.path("reference.json"), sandbox.path("all/folder/keys.json")).unwrap();
    sandbox.write("all/folder/try.json", text_of(&made, "linear"));
    symlink("../folder/try.json", sandbox.path("all/folder/in.json")).unwrap();
    let graded = graded(&sandbox);
    let names: Vec<&str> = graded.keys().map(String::as_str).collect();
    assert_eq!(names, ["folder", "inside.json"]);
    assert_eq!(graded["folder"]["keyframe_file"], "in.json");
    assert_eq!(
        graded["folder"]["notes"],
        json!([
            "The keyframes are those of in.json; also found: try.json (8 keyframes).",
            "Skipped keys.json: a link that does not lead to a file of the submission."
        ])
    );
    let passed = sandbox.json("out/grades.json")["passed_over"].clone();
    let link = |name: &str| json!({"name": name, "reason": "a link, which is not followed"});
    assert_eq!(passed, json!([link("in.json"), link("out.json")]));
    // A link that the user names alone is followed.
    symlink(sandbox.path("all"), sandbox.path("linked")).unwrap();
    sandbox.run(&["grade", "rubric.json", "linked", "-o", "again", "--no-images"]).succeeds();
    assert_eq!(sandbox.read("out/grades.json"), sandbox.read("again/grades.json"));
}

#[test]
fn a_bad_rubric_is_bad_input() {
    let (sandbox, _) = course();
    let run = |rubric: String| {
        sandbox.write("bad.json", rubric);
        sandbox.run(&["grade", "bad.json", "all", "-o", "out", "--no-images"])
    };
    run(RUBRIC.replace("\"title\"", "\"tittle\"")).refuses(
        "bad.json: line 1 column 53: unknown field \"tittle\", expected format, version, title, reference, script, keyframe_file, tolerances, fps, playback, samples_per_interval, bands, share_of_frames, follow_through, align_keyframes, late, points or requirements",
    );
    run(RUBRIC.replace("\"readable\": 2", "\"readable\": -2"))
        .refuses("bad.json: points.readable is -2, expected 0 to 1000000");
    run(RUBRIC.replace("reference.json", "none.json")).refuses("none.json: there is no such file or folder");
    run(RUBRIC.replace("\"script\": \"hotkeys.txt\",", ""))
        .refuses("bad.json: points.script is there, but script names no file");
    run(RUBRIC.replace("\"reference\": \"reference.json\",", ""))
        .refuses("bad.json: points.keyframe_count is there, but reference names no file");
    sandbox
        .run(&["grade", "rubric.json", "none", "-o", "out", "--no-images"])
        .refuses("none: there is no such file or folder");
    sandbox.run(&["grade", "rubric.json", "-o", "out"]).misuses();
    assert!(!sandbox.path("out").exists());
}

#[test]
fn a_rubric_may_have_no_reference() {
    let (sandbox, made) = course();
    sandbox.write("all/right.json", text_of(&made, "linear"));
    sandbox.write("rubric.json", r#"{"format": "inbetween.rubric", "version": 1, "points": {"readable": 2}}"#);
    let graded = graded(&sandbox);
    assert_eq!((&graded["right.json"]["points"], &graded["right.json"]["out_of"]), (&json!(2.0), &json!(2.0)));
}

#[test]
fn a_rubric_in_toml_is_the_same() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/grading");
    let sandbox = Sandbox::new();
    let graded = |rubric: &str, out: &str| {
        let (rubric, reference) = (folder.join(rubric), folder.join("reference.json"));
        let arguments = ["grade", rubric.to_str().unwrap(), reference.to_str().unwrap(), "-o", out, "--no-images"];
        sandbox.run(&arguments).succeeds();
        let mut grades = sandbox.json(&format!("{out}/grades.json"));
        let files = grades.as_object_mut().unwrap().remove("rubric").unwrap();
        (grades, files[0]["name"].clone())
    };
    let (of_toml, toml_name) = graded("rubric.toml", "a");
    assert_eq!((of_toml, toml_name), (graded("rubric.json", "b").0, json!("rubric.toml")));

    let toml = std::fs::read_to_string(folder.join("rubric.toml")).unwrap();
    sandbox.write("sub.txt", "");
    for (from, to, sentence) in [
        (
            "title =",
            "tittle =",
            "line 4 column 1: unknown field \"tittle\", expected format, version, title, reference, script, keyframe_file, tolerances, fps, playback, samples_per_interval, bands, share_of_frames, follow_through, align_keyframes, late, points or requirements",
        ),
        ("readable = 10", "readable = -2", "points.readable is -2, expected 0 to 1000000"),
        ("readable = 10", "readable = nan", "points.readable is NaN, expected 0 to 1000000"),
        ("fps = 10", "fps = \"ten\"", "line 9 column 7: found the text \"ten\", expected a whole number"),
        ("version = 1\n", "", "line 27 column 1: version is missing"),
        ("[points]", "[tolerances]", "line 20 column 2: this name is there twice"),
        ("script = 5", "script = ", "line 27 column 10: a text needs double quotes"),
    ] {
        let text = toml.replacen(from, to, 1);
        assert_ne!(text, toml);
        sandbox.write("bad.TOML", text);
        sandbox
            .run(&["grade", "bad.TOML", "sub.txt", "-o", "out", "--no-images"])
            .refuses(&format!("bad.TOML: {sentence}"));
    }
    sandbox.write("bad.toml", b"title = \"\xff\"");
    sandbox
        .run(&["grade", "bad.toml", "sub.txt", "-o", "out", "--no-images"])
        .refuses("bad.toml: line 1 column 10: the text is not UTF-8");
    assert!(!sandbox.path("out").exists());
}

#[test]
fn the_example_gives_right_samples_all_points_and_pictures() {
    let sandbox = Sandbox::new();
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/grading");
    let rubric = folder.join("rubric.json");
    let mut keyframes: Value =
        serde_json::from_str(&std::fs::read_to_string(folder.join("reference.json")).unwrap()).unwrap();
    std::fs::create_dir(sandbox.path("right")).unwrap();
    for interpolation in ["linear", "catmull-rom"] {
        keyframes["interpolation"] = json!(interpolation);
        sandbox.write("right/keys.json", keyframes.to_string());
        let samples = sandbox.run(&["sample", "right/keys.json", "--fps", "10", "--format", "csv"]).succeeds();
        sandbox.write(&format!("right/{interpolation}.csv"), samples);
    }
    keyframes["interpolation"] = json!("linear");
    sandbox.write("right/keys.json", keyframes.to_string());
    sandbox.write("alone.json", keyframes.to_string());
    keyframes["keyframes"][3]["pose"][3]["rotation"] = json!([0, 0, 0, 1]);
    sandbox.write("other.json", keyframes.to_string());
    let arguments = ["grade", rubric.to_str().unwrap(), "right", "alone.json", "other.json", "-o", "out"];
    sandbox.run(&arguments).succeeds();
    let grades = sandbox.json("out/grades.json");
    let points: Vec<&Value> =
        grades["submissions"].as_array().unwrap().iter().map(|graded| &graded["points"]).collect();
    assert_eq!(points, [&json!(100.0), &json!(55.0), &json!(50.0)]);
    let html = sandbox.read("out/report.html");
    // One animation each, and of what is wrong two moments of three pictures.
    assert_eq!(html.matches("<figure").count(), 3 + 2 * 3);
    assert!(
        html.contains("Catmull-Rom, as catmull-rom.csv shows it")
            && html.contains("Catmull-Rom, as its keyframes play")
    );
    assert!(html.contains("Catmull-Rom, key time "), "captions");
}
