//! A class of 60 in four forms, in which every known mistake is made: each mark, and what is said of it.

use std::collections::BTreeMap;

use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use serde_json::Value;

use crate::class::{HandIn, as_text, exported, files, graded, hand_ins, write_all};
use crate::grade::{item, text_of};
use crate::sandbox::Sandbox;
use crate::student::{LINEAR, Placed, Quaternion, SPLINE, SPLINE_PAIRS, Student, varied_keyframes};

const RUBRIC: &str = r#"{"format": "inbetween.rubric", "version": 1, "reference": "reference.json",
    "points": {"readable": 2, "keyframe_count": 1, "each_keyframe": 1, "linear_playback": 5, "catmull_rom_playback": 5,
    "range_and_end": 2}}"#;

/// What a student's program shows, and what should be said of it.
struct Shown<'a> {
    mistake: &'a str,
    plays_splines: bool,
    samples: String,
}

impl<'a> Shown<'a> {
    fn new(mistake: &'a str, plays_splines: bool, keyframes: &[Vec<Placed>]) -> Self {
        let student = Student { mistake, plays_splines, keyframes };
        Self { mistake, plays_splines, samples: student.samples(4.0, 2000.0, mistake.contains("integer-tick"), 6) }
    }

    fn file(&self) -> &'static str {
        if self.plays_splines { "catmull.csv" } else { "linear.csv" }
    }

    fn item(&self) -> &'static str {
        if self.plays_splines { "catmull_rom_playback" } else { "linear_playback" }
    }

    fn ends_right(&self) -> bool {
        let ends = ["last-sample-missing", "all-keyframes-played", "one-keyframe-early"];
        !self.mistake.split(" + ").any(|made| ends.contains(&made))
    }

    fn plays_right(&self) -> bool {
        ["correct", "correct-catmull-rom", "last-sample-missing"].contains(&self.mistake)
    }

    fn points(&self) -> f64 {
        11.0 + if self.plays_right() { 5.0 } else { 0.0 } + if self.ends_right() { 2.0 } else { 0.0 }
    }

    /// How far each node is off at each key time: units, degrees; `None` where that is no pose.
    fn errors(&self, keyframes: &[Vec<Placed>]) -> BTreeMap<(String, usize), Option<[f64; 2]>> {
        let right = Student { mistake: "correct", plays_splines: self.plays_splines, keyframes };
        let mut errors = BTreeMap::new();
        for line in self.samples.lines().skip(1) {
            let fields: Vec<f64> = line.split(',').map(|field| field.parse().unwrap_or(f64::NAN)).collect();
            let (key_time, node) = (fields[0], fields[1] as usize);
            let shown: Placed = (fields[2..5].try_into().unwrap(), fields[5..9].try_into().unwrap());
            errors.insert((format!("{key_time:.3}"), node), apart(shown, right.shows(key_time, node)));
        }
        errors
    }
}

/// The distance of translations, and the angle between rotations in degrees; `None` if the first is no pose.
fn apart((t, q): Placed, (right_t, right_q): Placed) -> Option<[f64; 2]> {
    let dot = |a: Quaternion, b: Quaternion| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let length = dot(q, q).sqrt();
    let units = t.iter().zip(right_t).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    let is_pose = units.is_finite() && (length - 1.0).abs() < 1e-3;
    let cosine = dot(q, right_q).abs() / (length * dot(right_q, right_q).sqrt());
    is_pose.then(|| [units, 2.0 * cosine.min(1.0).acos().to_degrees()])
}

/// Checks that a reason names a place at which nothing is farther off, or something that is no pose where there is one.
fn check_place(shown: &Shown, reason: &str, paths: &[String], keyframes: &[Vec<Placed>]) {
    let errors = shown.errors(keyframes);
    let place = |text: &str| {
        let (path, rest) = text.split_once(" at key time ").unwrap();
        let key_time = rest.split(['.', ' ', ';']).take(2).collect::<Vec<_>>().join(".");
        (key_time, paths.iter().position(|known| known == path).unwrap())
    };
    if errors.values().any(Option::is_none) {
        let said = reason.split_once("; ").unwrap().1;
        let path = said.strip_prefix("the rotation of ").unwrap_or(said).split(' ').next().unwrap();
        let key_time = said.split_once(" at key time ").unwrap().1;
        let said = format!("{path} at key time {key_time}");
        assert_eq!(errors[&place(&said)], None, "{}: {reason}", shown.mistake);
        assert!(reason.contains("NaN or infinite") || reason.contains("is not of unit length"), "{reason}");
        return;
    }
    let weight = |[units, degrees]: [f64; 2]| (units / 0.001).max(degrees / 0.1);
    let largest = errors.values().flatten().map(|error| weight(*error)).fold(0.0, f64::max);
    let said = reason.split_once("the largest error is ").unwrap_or_else(|| panic!("{reason}")).1;
    let (amount, at) = said.split_once(" of ").unwrap();
    let [units, degrees] = errors[&place(at)].unwrap();
    let (number, unit) = amount.split_once(' ').unwrap();
    let (expected, is_close) = match unit {
        "units" => (units, 1e-3),
        _ => (degrees, 0.02),
    };
    let number: f64 = number.parse().unwrap();
    assert!((number - expected).abs() < is_close, "{}: {expected}: {reason}", shown.mistake);
    assert!(weight([units, degrees]) > 0.999 * largest, "{}: {largest} elsewhere: {reason}", shown.mistake);
}

#[test]
fn every_known_mistake_is_marked_named_and_placed_in_a_class() {
    let sandbox = Sandbox::new();
    let made = varied_keyframes(11, 8, 22);
    sandbox.write("rubric.json", RUBRIC);
    sandbox.write("reference.json", text_of(&made, "linear"));
    let all = [(&LINEAR[..], false), (&SPLINE[..], true), (&SPLINE_PAIRS[..1], true)];
    let shown: Vec<Shown> = all
        .into_iter()
        .flat_map(|(mistakes, plays_splines)| mistakes.iter().map(move |mistake| (*mistake, plays_splines)))
        .map(|(mistake, plays_splines)| Shown::new(mistake, plays_splines, &made))
        .collect();
    for name in inbetween::diagnosis::names() {
        assert!(shown.iter().any(|shown| shown.mistake == name), "nobody makes {name}");
    }
    let text = as_text(&made);
    let as_hand_in = |shown: &Shown| HandIn {
        files: files(&[("animation.txt", &text), (shown.file(), shown.samples.as_bytes()), ("main.cpp", b"//")]),
        points: shown.points(),
        keyframe_file: Some("animation.txt"),
        reason: "holds 8 keyframes",
        notes: &["Skipped: 1 source (main.cpp)."],
    };
    let mut rows = Vec::new();
    let others = hand_ins(&made);
    for (form, chunk) in ["canvas", "moodle", "gradescope"].into_iter().zip(shown.chunks(15)) {
        let handed: Vec<HandIn> = chunk.iter().map(as_hand_in).collect();
        let (class, of_class) = exported(form, &handed);
        write_all(&sandbox, form, &class);
        let of_class = of_class.into_iter().map(|row| row.0);
        rows.extend(of_class.zip(handed).zip(chunk.iter().map(Some)));
    }
    let (class, of_class) = exported("folders", &others);
    write_all(&sandbox, "folders", &class);
    rows.extend(of_class.into_iter().map(|row| row.0).zip(others).map(|row| (row, None)));
    assert_eq!(rows.len(), 60);

    let (submissions, _) = graded(&sandbox, &["--classes", "canvas", "moodle", "gradescope", "folders"]);
    assert_eq!(submissions.len(), 60);
    let paths: Vec<String> = built_in_scene(DEFAULT_SCENE).unwrap().rbt_paths().map(str::to_owned).collect();
    for ((name, hand_in), shown) in &rows {
        check(&submissions[name], hand_in, *shown, &paths, &made);
    }
}

fn check(graded: &Value, hand_in: &HandIn, shown: Option<&Shown>, paths: &[String], made: &[Vec<Placed>]) {
    let name = &graded["name"];
    assert_eq!(graded["points"], hand_in.points, "{name}: {graded}");
    let reason = |id: &str| item(graded, id)["reason"].as_str().unwrap();
    assert!(reason("readable").contains(hand_in.reason), "{name}: {}", reason("readable"));
    for note in hand_in.notes {
        assert!(graded["notes"].as_array().unwrap().iter().any(|found| found == note), "{name}: {}", graded["notes"]);
    }
    let Some(shown) = shown else {
        for id in ["linear_playback", "catmull_rom_playback", "range_and_end"] {
            assert_eq!(item(graded, id)["points"], 0.0, "{name}: {id}");
            assert!(reason(id).starts_with("No samples show "), "{name}: {}", reason(id));
        }
        return;
    };
    let mistake = shown.mistake;
    let other = if shown.plays_splines { "linear_playback" } else { "catmull_rom_playback" };
    assert_eq!(item(graded, shown.item())["points"], if shown.plays_right() { 5.0 } else { 0.0 }, "{name}: {mistake}");
    assert_eq!(item(graded, other)["points"], 0.0, "{name}: {mistake}");
    assert!(reason(other).starts_with("No samples show "), "{name}: {}", reason(other));
    assert_eq!(
        item(graded, "range_and_end")["points"],
        if shown.ends_right() { 2.0 } else { 0.0 },
        "{name}: {mistake}"
    );
    let samples = &graded["samples"][0];
    assert_eq!(samples["file"], shown.file());
    let is_right = ["correct", "correct-catmull-rom"].contains(&mistake);
    let right = if shown.plays_splines { "correct-catmull-rom" } else { "correct" };
    assert_eq!(samples["best"], if is_right { right } else { mistake }, "{name}");
    assert_eq!(samples["explained"], true, "{name}: {mistake}");
    let of_playback = reason(shown.item());
    if shown.plays_right() {
        assert!(of_playback.contains(" are within the tolerances; "), "{name}: {of_playback}");
    } else {
        assert!(of_playback.contains(&format!("Diagnosis: {mistake}. ")), "{name}: {of_playback}");
        check_place(shown, of_playback, paths, made);
    }
}
