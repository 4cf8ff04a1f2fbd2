use inbetween::diagnosis::{Listing, Sequence, diagnose, samples_from_csv};
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use inbetween::text_layouts::read_keyframes;
use serde_json::Value;

use crate::sandbox::{Sandbox, keyframe_file};
use crate::student::{LINEAR, LINEAR_PAIRS, SINGLE, SPLINE, SPLINE_PAIRS, Student, file, keyframes, varied_keyframes};

fn paths() -> Vec<String> {
    built_in_scene(DEFAULT_SCENE).unwrap().rbt_paths().map(str::to_owned).collect()
}

fn diagnosed(sandbox: &Sandbox) -> Value {
    serde_json::from_str(&sandbox.run(&["diagnose", "k.json", "s.csv", "--json"]).succeeds()).unwrap()
}

fn names(value: &Value) -> Vec<&str> {
    value.as_array().unwrap().iter().map(|name| name.as_str().unwrap()).collect()
}

/// A check that what a program shows is named: with a column of milliseconds or without, to so many decimals.
struct Check<'a> {
    mistake: &'a str,
    plays_splines: bool,
    seed: u64,
    has_ms: bool,
    decimals: usize,
    is_single: bool,
}

/// What is asked of the plainest check of a mistake.
fn plain(mistake: &str, plays_splines: bool) -> Check<'_> {
    Check { mistake, plays_splines, seed: 7, has_ms: false, decimals: 6, is_single: false }
}

impl Check<'_> {
    #[track_caller]
    fn passes(&self) {
        let Self { mistake, plays_splines, seed, has_ms, decimals, is_single } = *self;
        let sandbox = Sandbox::new();
        let made = varied_keyframes(seed, 8, 22);
        let interpolation = if plays_splines { "catmull-rom" } else { "linear" };
        sandbox.write("k.json", file(&made, &paths(), "two-robots", interpolation, 2000));
        let made_mistake = if is_single { format!("{mistake} + {SINGLE}") } else { mistake.to_owned() };
        let student = Student { mistake: &made_mistake, plays_splines, keyframes: &made };
        sandbox.write("s.csv", student.samples(6.0, 2000.0, has_ms, decimals));
        let found = diagnosed(&sandbox);
        let residual = found["residual"].as_f64().unwrap();
        let noise = 20.0 * 0.1_f64.powi(i32::try_from(decimals).unwrap()) + if is_single { 1e-5 } else { 0.0 };
        let what = format!("{mistake}, {interpolation}, seed {seed}, {decimals} decimals, single {is_single}: {found}");
        assert_eq!(found["best"], mistake, "{what}");
        assert_eq!(found["explained"], true, "{what}");
        assert!(residual < noise, "{what}");
        let expected_also = match (mistake.strip_suffix("last-sample-missing"), plays_splines) {
            (Some(""), false) => vec!["correct"],
            (Some(""), true) => vec!["correct-catmull-rom"],
            (Some(other), _) => vec![other.trim_end_matches(" + ")],
            (None, _) => Vec::new(),
        };
        assert_eq!(names(&found["also"]), expected_also, "{what}");
        let candidates = found["candidates"].as_array().unwrap();
        let is_pair = mistake.contains(" + ");
        assert_eq!(candidates.len(), if is_pair { 29 } else { 28 });
        assert_eq!(candidates[0]["name"], mistake);
        let residuals: Vec<f64> = candidates.iter().map(|candidate| candidate["residual"].as_f64().unwrap()).collect();
        assert!(residuals.is_sorted_by(|a, b| *a <= *b + 1e-9), "{residuals:?}");
    }
}

const PLAYBACKS: [(&[&str], &[&str], bool); 2] = [(&LINEAR, &LINEAR_PAIRS, false), (&SPLINE, &SPLINE_PAIRS, true)];

#[test]
fn every_mistake_is_named() {
    for (mistakes, _, plays_splines) in PLAYBACKS {
        for mistake in mistakes {
            plain(mistake, plays_splines).passes();
            Check { seed: 12, decimals: 3, is_single: true, ..plain(mistake, plays_splines) }.passes();
        }
    }
    Check { seed: 8, has_ms: true, ..plain("correct", false) }.passes();
    Check { has_ms: true, ..plain("integer-tick", true) }.passes();
    Check { seed: 9, has_ms: true, decimals: 3, ..plain("nlerp-for-slerp", false) }.passes();
    Check { seed: 10, decimals: 4, ..plain("no-division-by-six", true) }.passes();
}

#[test]
fn every_pair_is_named() {
    assert!(LINEAR_PAIRS.len() + SPLINE_PAIRS.len() >= 30);
    for (_, pairs, plays_splines) in PLAYBACKS {
        for (index, pair) in pairs.iter().enumerate() {
            let (seed, is_single) = (20 + index as u64, index % 2 == 1);
            let decimals = if index % 3 == 2 { 3 } else { 6 };
            Check { seed, decimals, is_single, ..plain(pair, plays_splines) }.passes();
        }
    }
}

#[test]
fn the_work_is_bounded_by_rows_and_not_by_candidates() {
    let scene = built_in_scene(DEFAULT_SCENE).unwrap();
    let made = varied_keyframes(11, 8, 22);
    let keys = file(&made, &paths(), "two-robots", "linear", 2000);
    let keys = read_keyframes(keys.as_bytes(), &scene).unwrap().file.keyframes;
    let sequence = Sequence::new(&keys).unwrap();
    // Transforms computed for each row: right playback of a part, each mistake that shows, and what tells them apart.
    let computed = |mistake: &str, plays_splines: bool, expected: &str, for_each_row: usize| {
        let student = Student { mistake, plays_splines, keyframes: &made };
        let mut text = student.samples(30.0, 2000.0, false, 6);
        if expected == "none" {
            text = text.replace("00,5,", "00,6,");
        }
        let samples = samples_from_csv(text.as_bytes(), 22, 2000).unwrap();
        assert!(samples.rows.len() >= 300 * 22, "{}", samples.rows.len());
        let found = diagnose(&sequence, &samples, Listing::Explanations);
        assert_eq!(if found.is_explained() { &found.best().name } else { "none" }, expected);
        let most = for_each_row * samples.rows.len();
        assert!(found.computed <= most, "{mistake}: {} transforms, expected at most {most}", found.computed);
    };
    for plays_splines in [false, true] {
        let right = if plays_splines { "correct-catmull-rom" } else { "correct" };
        computed("correct", plays_splines, right, 4);
        computed("nlerp-for-slerp", plays_splines, "nlerp-for-slerp", 6);
        computed("correct", plays_splines, "none", 6);
    }
    for (pair, plays_splines, for_each_row) in [
        ("no-conditional-negation + last-sample-missing", false, 8),
        ("nan-when-equal + nan-where-the-axis-has-no-x", true, 12),
        ("angle-not-halved + sixth-in-integers-in-translations", true, 12),
        ("small-turns-frozen + second-control-point-on-wrong-keyframe-in-translations", true, 30),
    ] {
        computed(pair, plays_splines, pair, for_each_row);
    }
}

#[test]
fn the_worked_examples_are_named() {
    let sandbox = Sandbox::new();
    let examples = [
        ("correct", include_str!("../data/diagnosis/correct.json"), include_str!("../data/diagnosis/correct.csv")),
        (
            "lerp-for-slerp",
            include_str!("../data/diagnosis/lerp-for-slerp.json"),
            include_str!("../data/diagnosis/lerp-for-slerp.csv"),
        ),
        (
            "no-conditional-negation",
            include_str!("../data/diagnosis/no-conditional-negation.json"),
            include_str!("../data/diagnosis/no-conditional-negation.csv"),
        ),
        (
            "second-control-point-on-wrong-keyframe",
            include_str!("../data/diagnosis/second-control-point-on-wrong-keyframe.json"),
            include_str!("../data/diagnosis/second-control-point-on-wrong-keyframe.csv"),
        ),
    ];
    for (name, keyframes, samples) in examples {
        sandbox.write("k.json", keyframes);
        sandbox.write("s.csv", samples);
        let found = diagnosed(&sandbox);
        assert_eq!(found["best"], name);
        assert!(found["residual"].as_f64().unwrap() < 1e-6);
        let said = sandbox.run(&["diagnose", "k.json", "s.csv"]).succeeds();
        assert!(said.starts_with(&format!("{name} explains the samples, with a residual of ")), "{said}");
        assert!(said.contains("Runners-up: ") && (name == "correct" || said.contains("What to change: ")), "{said}");
    }
}

#[test]
fn what_this_program_samples_is_correct() {
    let sandbox = Sandbox::new();
    sandbox.write("k.json", file(&keyframes(3, 6, 22), &paths(), "two-robots", "linear", 2000));
    for (interpolation, name) in [("linear", "correct"), ("catmull-rom", "correct-catmull-rom")] {
        let arguments = ["sample", "k.json", "--fps", "7", "--format", "csv", "--interpolation", interpolation];
        sandbox.write("s.csv", sandbox.run(&arguments).succeeds());
        assert_eq!(diagnosed(&sandbox)["best"], name);
    }
}

#[test]
fn where_nothing_turns_or_moves_the_right_result_comes_first() {
    let sandbox = Sandbox::new();
    sandbox.write("k.json", keyframe_file(4).to_string());
    sandbox.write("s.csv", sandbox.run(&["sample", "k.json", "--fps", "7", "--format", "csv"]).succeeds());
    let found = diagnosed(&sandbox);
    assert_eq!(found["best"], "correct");
    assert_eq!(
        names(&found["also"]),
        [
            "correct-catmull-rom",
            "no-conditional-negation",
            "lerp-for-slerp",
            "nlerp-for-slerp",
            "angle-not-halved",
            "identity-when-equal",
            "no-conditional-negation-in-control-points",
            "sixth-in-integers-in-rotations",
            "small-turns-frozen",
            "powers-for-slerp",
            "only-w-negated",
            "nan-where-the-axis-has-no-x",
            "tangent-from-wrong-neighbour",
            "cubic-by-components",
            "slerp-angle-from-cross-product",
        ]
    );
}

#[test]
fn either_way_round_at_half_a_turn_is_right() {
    let sandbox = Sandbox::new();
    let turned = |half: bool| ([0.0; 3], if half { [0.0, 0.0, 0.0, 1.0] } else { [1.0, 0.0, 0.0, 0.0] });
    let mut made = vec![vec![turned(false); 22]; 5];
    made[2][5] = turned(true);
    sandbox.write("k.json", file(&made, &paths(), "two-robots", "linear", 2000));
    let student = Student { mistake: "correct", plays_splines: false, keyframes: &made };
    let samples = student.samples(6.0, 2000.0, false, 6);
    sandbox.write("s.csv", &samples);
    assert_eq!(diagnosed(&sandbox)["best"], "correct");
    let other_way: String = samples
        .lines()
        .map(|line| {
            let (head, z) = line.rsplit_once(',').unwrap();
            if head.starts_with("0.") { format!("{head},-{z}\n") } else { format!("{line}\n") }
        })
        .collect();
    assert_ne!(samples, other_way);
    sandbox.write("s.csv", other_way);
    assert_eq!(diagnosed(&sandbox)["best"], "correct");
}

#[test]
fn rows_beyond_the_end_show_the_end() {
    let sandbox = Sandbox::new();
    let made = keyframes(5, 6, 22);
    sandbox.write("k.json", file(&made, &paths(), "two-robots", "linear", 2000));
    let student = Student { mistake: "correct", plays_splines: false, keyframes: &made };
    let mut samples = student.samples(6.0, 2000.0, false, 6);
    let end: Vec<String> =
        samples.lines().filter(|line| line.starts_with("3.0")).map(|line| format!("4.5{}", &line[8..])).collect();
    samples.push_str(&end.join("\n"));
    sandbox.write("s.csv", samples);
    let found = diagnosed(&sandbox);
    assert_eq!((found["best"].as_str(), found["residual"].as_f64().map(|r| r < 1e-5)), (Some("correct"), Some(true)));
}

/// Keyframes and what a program without mistakes shows of them, six frames a second, with its lines.
fn shown_rightly(sandbox: &Sandbox, plays_splines: bool, decimals: usize) -> String {
    let made = varied_keyframes(5, 8, 22);
    let interpolation = if plays_splines { "catmull-rom" } else { "linear" };
    sandbox.write("k.json", file(&made, &paths(), "two-robots", interpolation, 2000));
    let mistake = if plays_splines { "correct-catmull-rom" } else { "correct" };
    Student { mistake, plays_splines, keyframes: &made }.samples(6.0, 2000.0, false, decimals)
}

/// The text with a number replaced: of a line, a field, with so many decimals.
fn with_field(text: &str, [line, field, decimals]: [usize; 3], by: impl Fn(f64) -> f64) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let mut fields: Vec<String> = lines[line].split(',').map(str::to_owned).collect();
    fields[field] = format!("{:.decimals$}", by(fields[field].parse().unwrap()));
    lines[line] = fields.join(",");
    lines.join("\n")
}

#[test]
fn one_number_that_is_off_has_no_name() {
    let sandbox = Sandbox::new();
    for plays_splines in [false, true] {
        let right = shown_rightly(&sandbox, plays_splines, 6);
        for (field, off, is_right) in [(2, 9e-5, true), (2, 2e-4, false), (7, 1.5e-4, true), (7, 4e-4, false)] {
            sandbox.write("s.csv", with_field(&right, [400, field, 6], |number| number + off));
            let found = diagnosed(&sandbox);
            assert_eq!(found["explained"], is_right, "column {field}, {off}: {found}");
        }
        let said = sandbox.run(&["diagnose", "k.json", "s.csv"]).succeeds();
        assert!(said.starts_with("None of the known mistakes explains the samples. correct"), "{said}");
        assert!(!said.contains("What to change"), "{said}");
    }
}

#[test]
fn printed_decimals_count() {
    let sandbox = Sandbox::new();
    for decimals in [2, 3, 4] {
        let right = shown_rightly(&sandbox, false, decimals);
        let unit = 0.1_f64.powi(i32::try_from(decimals).unwrap());
        // Two units of the last decimal are no rounding.
        for (off, is_right) in [(0.0, true), (2.0 * unit, false)] {
            sandbox.write("s.csv", with_field(&right, [300, 3, decimals], |number| number + off));
            let found = diagnosed(&sandbox);
            assert_eq!((&found["best"], &found["explained"]), (&"correct".into(), &is_right.into()), "{decimals}");
        }
    }
}

#[test]
fn either_sign_of_a_quaternion_is_the_same_rotation() {
    let sandbox = Sandbox::new();
    let mut text = shown_rightly(&sandbox, true, 6);
    for field in 5..9 {
        text = with_field(&text, [77, field, 6], |number| -number);
    }
    sandbox.write("s.csv", text);
    assert_eq!(diagnosed(&sandbox)["best"], "correct-catmull-rom");
}

#[test]
fn samples_that_end_early_say_how_early() {
    let sandbox = Sandbox::new();
    let right = shown_rightly(&sandbox, false, 6);
    let early: Vec<&str> = right.lines().filter(|line| !line.starts_with("5.")).collect();
    sandbox.write("s.csv", early.join("\n"));
    let said = sandbox.run(&["diagnose", "k.json", "s.csv"]).succeeds();
    assert!(said.starts_with("last-sample-missing explains the samples"), "{said}");
    assert!(said.contains("The samples end 0.083333 before the end, at key time 4.916667."), "{said}");
    assert!(!said.contains("cannot tell") && !said.contains("too few"), "{said}");
}

#[test]
fn too_few_samples_are_called_too_few() {
    let sandbox = Sandbox::new();
    let right = shown_rightly(&sandbox, false, 6);
    // The first row of every whole key time.
    let few: Vec<&str> = right.lines().filter(|line| line.contains(".000000,0,") || line.starts_with('k')).collect();
    sandbox.write("s.csv", few.join("\n"));
    let said = sandbox.run(&["diagnose", "k.json", "s.csv"]).succeeds();
    assert!(said.starts_with("correct explains the samples"), "{said}");
    let too_few = said.lines().find(|line| line.starts_with("The samples are too few to tell it from: ")).unwrap();
    assert!(too_few.contains("lerp-for-slerp") && too_few.contains("nlerp-for-slerp"), "{said}");
    assert!(!said.contains("These keyframes cannot tell"), "{said}");
}

#[test]
fn semicolons_and_tabs_part_fields_too() {
    let sandbox = Sandbox::new();
    let right = shown_rightly(&sandbox, false, 6);
    for separator in [";", "\t"] {
        sandbox.write("s.csv", right.replace(',', separator));
        assert_eq!(diagnosed(&sandbox)["best"], "correct");
    }
    sandbox.write("s.csv", right.replace(',', ";").replace('.', ","));
    sandbox.run(&["diagnose", "k.json", "s.csv"]).refuses(
        "s.csv: line 2, column tx: \"-4,602000\" is not a number: write decimals with a point, not with a comma",
    );
}

#[test]
fn a_film_shows_right_beside_wrong() {
    let sandbox = Sandbox::new();
    let right = shown_rightly(&sandbox, false, 6);
    sandbox.write("s.csv", right.lines().take(1 + 3 * 22).collect::<Vec<_>>().join("\n"));
    sandbox.run(&["diagnose", "k.json", "s.csv", "--film", "samples.gif"]).succeeds();
    sandbox.write("four.json", file(&varied_keyframes(5, 4, 22), &paths(), "two-robots", "linear", 2000));
    sandbox.run(&["diagnose", "four.json", "--mistake", "nan-when-equal", "--film", "mistake.apng"]).succeeds();
    for (name, begins) in [("samples.gif", &b"GIF89a"[..]), ("mistake.apng", b"\x89PNG")] {
        assert!(std::fs::read(sandbox.path(name)).unwrap().starts_with(begins), "{name}");
    }
    sandbox
        .run(&["diagnose", "k.json", "s.csv", "--film", "film.mp4"])
        .refuses("film.mp4: the name of this film ends in one of .gif, .apng, .webp, .y4m");
    sandbox.run(&["diagnose", "k.json", "--mistake", "nan-when-equal"]).misuses();
    sandbox.run(&["diagnose", "k.json", "--mistake", "nothing", "--film", "film.gif"]).misuses();
}

#[test]
fn bad_input_is_named_with_its_place() {
    let sandbox = Sandbox::new();
    sandbox.write("k.json", keyframe_file(4).to_string());
    sandbox.write("short.json", keyframe_file(3).to_string());
    sandbox.write("s.csv", "key_time,rbt_ind,tx,ty,tz,rw,rx,ry,rz\n0,0,0,0,0,1,0,0,0\n1,22,0,0,0,1,0,0,0\n");
    sandbox.write("nan.csv", "key_time,rbt_ind,tx,ty,tz,rw,rx,ry,rz\n0,0,0,0,0,1.#QNAN,nan,-nan(ind),0\n");
    sandbox
        .run(&["diagnose", "k.json", "s.csv"])
        .refuses("s.csv: line 3: rbt_ind \"22\" is not a node of the scene, whose nodes are 0 to 21");
    sandbox.run(&["diagnose", "k.json", "none.csv"]).refuses("none.csv: there is no such file or folder");
    sandbox.run(&["diagnose", "short.json", "nan.csv"]).refuses(
        "short.json: 3 keyframes cannot be played: the first and the last only steer, so at least 4 are needed",
    );
    sandbox.run(&["diagnose", "k.json", "nan.csv"]).succeeds();
    sandbox.run(&["diagnose", "k.json"]).misuses();
    sandbox.run(&["diagnose", "k.json", "nan.csv", "more"]).misuses();
}

#[test]
fn the_help_lists_every_name() {
    let help = Sandbox::new().run(&["diagnose", "--help"]).succeeds();
    for name in LINEAR.into_iter().chain(SPLINE) {
        assert!(help.contains(name), "{name}");
    }
}
