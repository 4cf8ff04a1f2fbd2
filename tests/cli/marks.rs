//! What earns points: samples by the rubric's tolerances, shown or assumed playback, coverage, the range, and partial credit.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use serde_json::{Value, json};

use crate::grade::{follows, item, text_of};
use crate::sandbox::Sandbox;
use crate::student::{Placed, Quaternion, Student, varied_keyframes};

const NODES: usize = 22;
/// With 8 keyframes playback ends here.
const END: f64 = 5.0;

/// How a program prints a number.
type Print = fn(f64) -> String;

fn six(number: f64) -> String {
    format!("{number:.6}")
}

fn two(number: f64) -> String {
    format!("{number:.2}")
}

fn one(number: f64) -> String {
    format!("{number:.1}")
}

/// Zeros at the end are left out, as `%g` does.
fn general(number: f64) -> String {
    let text = format!("{number:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// So many key times in each interval, and the end.
fn times(of_interval: usize) -> Vec<f64> {
    (0..=END as usize * of_interval).map(|time| time as f64 / of_interval as f64).collect()
}

/// What a program shows of each node at each time; `None` where it shows nothing.
fn csv(times: &[f64], print: Print, shows: impl Fn(f64, usize) -> Option<Placed>) -> String {
    let mut text = "key_time,rbt_ind,tx,ty,tz,rw,rx,ry,rz\n".to_owned();
    for time in times {
        for node in 0..NODES {
            if let Some(([x, y, z], [w, i, j, k])) = shows(*time, node) {
                let numbers = [x, y, z, w, i, j, k].map(print).join(",");
                writeln!(text, "{time:.6},{node},{numbers}").unwrap();
            }
        }
    }
    text
}

/// A course of one rubric.
struct Course {
    sandbox: Sandbox,
    made: Vec<Vec<Placed>>,
    /// What standard output said last.
    said: String,
}

impl Course {
    fn new() -> Self {
        Self::of(varied_keyframes(5, 8, NODES))
    }

    fn of(made: Vec<Vec<Placed>>) -> Self {
        let sandbox = Sandbox::new();
        sandbox.write("reference.json", text_of(&made, "linear"));
        sandbox.write("hotkeys.txt", "key i\nkey >\nkey n\n");
        std::fs::create_dir(sandbox.path("all")).unwrap();
        Self { sandbox, made, said: String::new() }
    }

    /// Hands in the reference's keyframes and files.
    fn hand_in(&self, name: &str, files: &[(&str, &str)]) {
        self.hand_in_keyframes(name, &self.made, files);
    }

    fn hand_in_keyframes(&self, name: &str, keyframes: &[Vec<Placed>], files: &[(&str, &str)]) {
        std::fs::create_dir_all(self.sandbox.path(&format!("all/{name}"))).unwrap();
        self.sandbox.write(&format!("all/{name}/keys.json"), text_of(keyframes, "linear"));
        for (file, text) in files {
            self.sandbox.write(&format!("all/{name}/{file}"), text);
        }
    }

    /// Right playback, perhaps changed.
    fn samples(
        &self,
        interpolation: &str,
        times: &[f64],
        print: Print,
        change: impl Fn(f64, usize, Placed) -> Option<Placed>,
    ) -> String {
        let student = Student {
            mistake: if interpolation == "linear" { "correct" } else { "correct-catmull-rom" },
            plays_splines: interpolation != "linear",
            keyframes: &self.made,
        };
        csv(times, print, |time, node| change(time, node, student.shows(time.clamp(0.0, END), node)))
    }

    fn right(&self, interpolation: &str) -> String {
        self.samples(interpolation, &times(4), six, |_, _, placed| Some(placed))
    }

    /// Grades by a rubric with more fields.
    fn graded(&mut self, fields: &Value, points: &Value) -> BTreeMap<String, Value> {
        let mut rubric =
            json!({"format": "inbetween.rubric", "version": 1, "reference": "reference.json", "points": points});
        rubric.as_object_mut().unwrap().extend(fields.as_object().unwrap().clone());
        rubric.as_object_mut().unwrap().retain(|_, value| !value.is_null());
        self.sandbox.write("rubric.json", rubric.to_string());
        self.said = self.sandbox.run(&["grade", "rubric.json", "all", "-o", "out", "--no-images"]).succeeds();
        let grades = self.sandbox.json("out/grades.json");
        let schema: Value = serde_json::from_str(include_str!("../../assets/grading/grades.schema.json")).unwrap();
        follows(&grades, &schema, "grades");
        let submissions = grades["submissions"].as_array().unwrap();
        submissions.iter().map(|graded| (graded["name"].as_str().unwrap().to_owned(), graded.clone())).collect()
    }
}

fn path(node: usize) -> String {
    built_in_scene(DEFAULT_SCENE).unwrap().rbt_paths().nth(node).unwrap().to_owned()
}

fn node(path: &str) -> usize {
    built_in_scene(DEFAULT_SCENE).unwrap().rbt_paths().position(|found| found == path).unwrap()
}

/// Turned by so many degrees about its own x.
fn turned([w, x, y, z]: Quaternion, degrees: f64) -> Quaternion {
    let (s, c) = (degrees / 2.0).to_radians().sin_cos();
    [w * c - x * s, w * s + x * c, y * c + z * s, z * c - y * s]
}

fn about_z(degrees: f64) -> Quaternion {
    let (sine, cosine) = (degrees / 2.0).to_radians().sin_cos();
    [cosine, 0.0, 0.0, sine]
}

#[track_caller]
fn check(graded: &Value, name: &str, points: f64, parts: &[&str]) {
    let item = item(graded, name);
    let found = item["points"].as_f64().unwrap();
    assert!((found - points).abs() < 1e-9, "{found} for {points}: {item}");
    for part in parts {
        assert!(item["reason"].as_str().unwrap().contains(part), "{part}: {item}");
    }
}

const LINEAR: &str = "linear_playback";

#[test]
fn the_rubrics_tolerances_decide_row_by_row() {
    let mut course = Course::new();
    let (knee, head) = (node("robot1/left_hip/left_knee"), node("robot2/head"));
    let linear = |change: &dyn Fn(f64, usize, Placed) -> Placed, print| {
        course.samples("linear", &times(8), print, |time, node, placed| Some(change(time, node, placed)))
    };
    let moved = |([x, y, z], q): Placed, by: f64| ([x, y + by, z], q);
    let knee_off = linear(&|_, node, (t, q)| (t, if node == knee { turned(q, 2.6) } else { q }), six);
    let head_off = linear(&|_, node, placed| moved(placed, if node == head { 0.022 } else { 0.0 }), six);
    let all_off = linear(&|_, _, placed| moved(placed, 0.004), six);
    let once = linear(&|time, node, (t, q)| (t, if node == head && time == 2.5 { turned(q, 20.0) } else { q }), six);
    let near = linear(&|_, _, (t, q)| moved((t, turned(q, 0.09)), 0.0009), six);
    for (name, samples) in [
        ("knee", &knee_off),
        ("head", &head_off),
        ("all", &all_off),
        ("once", &once),
        ("near", &near),
        ("two", &linear(&|_, _, placed| placed, two)),
        ("two off", &linear(&|_, node, placed| moved(placed, if node == head { 0.022 } else { 0.0 }), two)),
        ("one", &linear(&|_, _, placed| placed, one)),
        ("general", &linear(&|_, _, placed| placed, general)),
    ] {
        course.hand_in(name, &[("linear.csv", samples)]);
    }
    let graded = course.graded(&json!({}), &json!({LINEAR: 20}));
    let knee = "linear.csv: 0 of 41 frames are within the tolerances; the largest error is 2.600 degrees of robot1/left_hip/left_knee at key time ";
    check(&graded["knee"], LINEAR, 0.0, &[knee, "None of the known mistakes explains it"]);
    check(&graded["head"], LINEAR, 0.0, &["0 of 41 frames are", "is 0.0220 units of robot2/head at key time "]);
    check(&graded["all"], LINEAR, 0.0, &["is 0.0040 units of "]);
    check(&graded["once"], LINEAR, 0.0, &["40 of 41 frames are", "is 20.000 degrees of robot2/head at key time 2.500"]);
    check(
        &graded["near"],
        LINEAR,
        20.0,
        &["linear.csv: all 41 frames are within the tolerances; the largest error is 0.0009 units of "],
    );
    let two = "all 41 frames are within the tolerances, beside the rounding of what is printed; the largest error is ";
    check(&graded["two"], LINEAR, 20.0, &[two]);
    check(&graded["two off"], LINEAR, 0.0, &[" units of robot2/head at key time "]);
    let coarse = "translations are printed with 1 decimal, and at least 2 are needed to judge playback";
    check(&graded["one"], LINEAR, 0.0, &[coarse]);
    check(&graded["general"], LINEAR, 20.0, &["all 41 frames are"]);

    let graded =
        course.graded(&json!({"tolerances": {"translation": 0.03, "rotation_degrees": 3}}), &json!({LINEAR: 20}));
    for name in ["knee", "head", "all"] {
        check(&graded[name], LINEAR, 20.0, &["all 41 frames are"]);
    }
}

#[test]
fn what_is_no_pose_is_named_with_its_place() {
    let mut course = Course::new();
    let strange = |change: fn(Placed) -> Placed| {
        let shown = |time, node, placed| Some(if node == 3 && time == 1.25 { change(placed) } else { placed });
        course.samples("linear", &times(4), |number| format!("{number:.6}"), shown)
    };
    course.hand_in("nan", &[("linear.csv", &strange(|([x, y, _], q)| ([x, y, f64::NAN], q)))]);
    course.hand_in("long", &[("linear.csv", &strange(|(t, q)| (t, q.map(|part| part * 1.1))))]);
    let lax = json!({"tolerances": {"translation": 1e6, "rotation_degrees": 1e6}});
    let graded = course.graded(&lax, &json!({LINEAR: 20}));
    let place = |what: &str| format!("20 of 21 frames are within the tolerances; {what} at key time 1.250");
    check(&graded["nan"], LINEAR, 0.0, &[&place(&format!("{} has numbers that are NaN or infinite", path(3)))]);
    let long = format!("the rotation of {} is not of unit length but 1.1000 long", path(3));
    check(&graded["long"], LINEAR, 0.0, &[&place(&long)]);
}

#[test]
fn where_rounding_decides_either_way_is_right() {
    let mut made = varied_keyframes(5, 8, NODES);
    for (keyframe, pose) in made.iter_mut().enumerate() {
        pose[4].1 = about_z(180.0 * keyframe as f64);
    }
    let mut course = Course::of(made);
    let spun = |sign: f64, share: f64| {
        course.samples("linear", &times(8), six, |time, node, (t, q)| {
            let shown = about_z(180.0 + sign * 180.0 * (time.fract() + share) + 180.0 * time.floor());
            Some((t, if node == 4 { shown } else { q }))
        })
    };
    for (name, samples) in [("one", spun(1.0, 0.0)), ("other", spun(-1.0, 0.0)), ("neither", spun(1.0, 0.01))] {
        course.hand_in(name, &[("linear.csv", &samples)]);
    }
    // Key times in steps that two decimals do not show.
    let uneven: Vec<f64> = (0..=150).map(|frame| f64::from(frame) / 30.0).collect();
    let of_uneven = |print: fn(f64) -> String| {
        let text = course.samples("catmull-rom", &uneven, six, |_, _, placed| Some(placed));
        let rounded = text.lines().skip(1).map(|line| {
            let (time, rest) = line.split_once(',').unwrap();
            format!("{},{rest}\n", print(time.parse().unwrap()))
        });
        ["key_time,rbt_ind,tx,ty,tz,rw,rx,ry,rz\n".to_owned()].into_iter().chain(rounded).collect::<String>()
    };
    course.hand_in("two", &[("spline.csv", &of_uneven(two))]);
    course.hand_in("whole", &[("spline.csv", &of_uneven(one))]);
    let graded = course.graded(&json!({}), &json!({LINEAR: 20, "catmull_rom_playback": 10, "range_and_end": 5}));
    check(&graded["one"], LINEAR, 20.0, &[]);
    check(&graded["other"], LINEAR, 20.0, &[]);
    check(&graded["neither"], LINEAR, 0.0, &["is 1.800 degrees of "]);
    check(&graded["two"], "catmull_rom_playback", 10.0, &["all 151 frames are"]);
    check(&graded["two"], "range_and_end", 5.0, &[]);
    check(&graded["whole"], "catmull_rom_playback", 0.0, &["key times are printed with fewer than 2 decimals"]);
}

#[test]
fn playback_is_shown_or_assumed() {
    let mut course = Course::new();
    let trace = {
        let arguments = ["script", "hotkeys.txt", "--keyframes", "reference.json", "--trace"];
        course.sandbox.run(&arguments).succeeds()
    };
    course.hand_in("shown", &[("linear.csv", &course.right("linear")), ("trace.jsonl", &trace)]);
    course.hand_in("not", &[]);
    course.hand_in("script", &[("script.txt", "key i\nkey >\nkey n\n")]);
    course.sandbox.write("all/broken.json", "{");
    let points = json!({"readable": 1, LINEAR: 20, "catmull_rom_playback": 10, "range_and_end": 5, "script": 2});
    let fields = |playback: &str| json!({"script": "hotkeys.txt", "playback": playback});
    let evidence = |graded: &Value, name: &str| item(graded, name)["evidence"].clone();

    let graded = course.graded(&fields("samples"), &points);
    assert!(course.said.contains("\n1 of 4 submissions: playback shown by samples; 3 not shown\n"), "{}", course.said);
    check(
        &graded["shown"],
        LINEAR,
        20.0,
        &["linear.csv: all 21 frames are within the tolerances; no error reaches 0.0001 units or 0.001 degrees."],
    );
    check(&graded["not"], LINEAR, 0.0, &["No samples show linear playback: hand in"]);
    check(&graded["not"], "range_and_end", 0.0, &["No samples show where playback begins and ends: hand in"]);
    assert_eq!(evidence(&graded["shown"], LINEAR), "samples");
    assert_eq!(evidence(&graded["shown"], "catmull_rom_playback"), Value::Null);
    assert_eq!(evidence(&graded["shown"], "range_and_end"), "samples");
    assert_eq!(evidence(&graded["not"], LINEAR), Value::Null);
    assert_eq!(evidence(&graded["not"], "readable"), Value::Null);
    let scripts = ["shown", "script", "not"].map(|name| evidence(&graded[name], "script"));
    assert_eq!(scripts, [json!("trace"), json!("script"), json!("assumed")]);
    let table = course.sandbox.read("out/grades.csv");
    assert!(table.contains(",out_of,evidence,diagnosis,"), "{table}");
    assert!(table.contains(",\"playback by samples, script by trace\","), "{table}");
    assert!(table.contains(",\"playback not shown, own script run\","), "{table}");
    let report = course.sandbox.read("out/report.html");
    assert!(report.contains("<th>evidence</th>") && report.contains("<td>playback not shown, script assumed</td>"));
    assert!(report.contains("<td class=\"by\">samples</td>") && report.contains("<td class=\"by\">assumed</td>"));

    let graded = course.graded(&fields("assumed"), &points);
    assert!(
        course.said.contains("\n1 of 4 submissions: playback shown by samples; 2 assumed; 1 not shown\n"),
        "{}",
        course.said
    );
    check(&graded["not"], LINEAR, 20.0, &["Its keyframes, played by Inbetween: all 101 frames are within"]);
    assert_eq!(evidence(&graded["not"], LINEAR), "assumed");
    assert_eq!(evidence(&graded["not"], "range_and_end"), "assumed");
    assert_eq!(evidence(&graded["shown"], LINEAR), "samples");
    assert_eq!(evidence(&graded["shown"], "catmull_rom_playback"), "assumed");
}

#[test]
fn the_name_or_else_the_content_says_which_playback_it_is() {
    let mut course = Course::new();
    let (linear, spline) = (course.right("linear"), course.right("catmull-rom"));
    course.hand_in("unnamed", &[("a.csv", &spline), ("b.csv", &linear)]);
    course.hand_in("both", &[("linear_vs_spline.csv", &spline)]);
    course.hand_in("folder", &[("out.csv", &linear), ("spline.csv", &spline)]);
    course.hand_in("wrong", &[("spline.csv", &linear)]);
    let graded = course.graded(&json!({}), &json!({LINEAR: 20, "catmull_rom_playback": 10}));
    assert_eq!(graded["unnamed"]["points"], 30.0);
    assert_eq!(graded["both"]["points"], 10.0);
    assert_eq!(graded["folder"]["points"], 30.0);
    check(&graded["wrong"], "catmull_rom_playback", 0.0, &["spline.csv: 6 of 21 frames are", "Diagnosis: correct."]);
    assert_eq!(graded["wrong"]["points"], 0.0);
}

#[test]
fn too_few_samples_cost_in_proportion() {
    let mut course = Course::new();
    let linear = |of_interval, shows: &dyn Fn(f64, usize) -> bool| {
        course.samples("linear", &times(of_interval), six, |time, node, placed| shows(time, node).then_some(placed))
    };
    let head = node("robot1/head");
    course.hand_in("half", &[("linear.csv", &linear(2, &|_, _| true))]);
    course.hand_in("headless", &[("linear.csv", &linear(4, &|_, node| node != head))]);
    course.hand_in("two rows", &[("linear.csv", &linear(4, &|time, node| node == 0 && (time == 0.0 || time == END)))]);
    course.hand_in("gap", &[("linear.csv", &linear(4, &|time, node| node != head || !(2.0..3.0).contains(&time)))]);
    let points = json!({LINEAR: 20, "range_and_end": 22});
    let graded = course.graded(&json!({}), &points);
    // The sample at the end counts for the last interval.
    let share = (4.0 * 2.0 + 3.0) / 20.0;
    let first =
        format!("{} has 2 samples from key time 0 to 1, and 4 are asked; 55 % of what is asked is there.", path(0));
    check(&graded["half"], LINEAR, 20.0 * share, &["all 11 frames are", &first]);
    check(&graded["half"], "range_and_end", 22.0, &["begin with keyframe 1 and end with keyframe 6"]);
    check(&graded["headless"], LINEAR, 20.0 * 21.0 / 22.0, &["robot1/head has no samples; 95.4 % of"]);
    check(&graded["headless"], "range_and_end", 21.0, &["show 21 of 22 nodes there"]);
    check(
        &graded["two rows"],
        LINEAR,
        20.0 * 2.0 / 440.0,
        &["all 2 frames are", "sky has 1 sample from key time 0 to 1, and 4 are asked; 0.4 % of"],
    );
    check(&graded["two rows"], "range_and_end", 1.0, &["show 1 of 22 nodes there"]);
    check(&graded["gap"], LINEAR, 20.0 * 436.0 / 440.0, &["robot1/head has 0 samples from key time 2 to 3"]);

    let graded = course.graded(&json!({"samples_per_interval": 0}), &points);
    check(&graded["half"], LINEAR, 20.0, &["all 11 frames are"]);
    check(&graded["gap"], LINEAR, 20.0, &[]);
    check(&graded["headless"], LINEAR, 0.0, &["0 of 21 frames are within the tolerances; robot1/head has no samples"]);
}

#[test]
fn playback_begins_and_ends_where_it_should() {
    let mut course = Course::new();
    let of = |name: &str, times: &[f64], shown_at: &dyn Fn(f64) -> f64| {
        let student = Student { mistake: "correct", plays_splines: false, keyframes: &course.made };
        course
            .hand_in(name, &[("linear.csv", &csv(times, six, |time, node| Some(student.shows(shown_at(time), node))))]);
    };
    let held = |time: f64| time.min(END);
    let mut on = times(4);
    on.extend([5.25, 5.5]);
    of("on", &on, &held);
    let mut early = times(4);
    *early.last_mut().unwrap() = 4.998;
    of("early", &early, &held);
    of("late", &times(4)[1..], &held);
    of("next", &times(4), &|time| (time + 1.0).min(END));
    of("rounding", &[&times(4)[..20], &[5.000_001][..]].concat(), &held);
    let graded = course.graded(&json!({}), &json!({LINEAR: 20, "range_and_end": 5}));
    let range = "range_and_end";
    check(&graded["on"], range, 0.0, &["linear.csv: the samples go on to key time 5.5, and playback ends at 5."]);
    check(&graded["early"], range, 0.0, &["linear.csv: the samples end 0.002 before the end."]);
    check(&graded["late"], range, 0.0, &["linear.csv: the samples begin 0.25 after the start."]);
    check(&graded["next"], range, 0.0, &["at key time 0 the samples show keyframe 2, expected keyframe 1."]);
    check(&graded["rounding"], range, 5.0, &["the samples begin with keyframe 1 and end with keyframe 6."]);
    for (name, points) in [("on", 20.0), ("early", 20.0), ("rounding", 20.0), ("next", 0.0)] {
        check(&graded[name], LINEAR, points, &[]);
    }
    check(&graded["late"], LINEAR, 20.0 * 19.0 / 20.0, &["has 3 samples from key time 0 to 1"]);
}

#[test]
fn bands_and_shares_of_frames_give_partial_credit() {
    let mut course = Course::new();
    let off = |by: &dyn Fn(f64) -> f64| {
        course.samples("linear", &times(4), six, |time, node, (t, q)| {
            Some((t, if node == 5 { turned(q, by(time)) } else { q }))
        })
    };
    course.hand_in("always", &[("linear.csv", &off(&|_| 0.5))]);
    course.hand_in("at times", &[("linear.csv", &off(&|time| if time < 1.0 { 0.5 } else { 0.0 }))]);
    course.hand_in("far", &[("linear.csv", &off(&|time| if time == 1.0 { 9.0 } else { 0.0 }))]);
    let mut made = course.made.clone();
    made[3][5].1 = turned(made[3][5].1, 0.5);
    course.hand_in_keyframes("keyframe", &made, &[]);
    let points = json!({"each_keyframe": 2, LINEAR: 21});
    let bands = json!([
        {"translation": 0.01, "rotation_degrees": 1, "share": 0.5},
        {"translation": 0.01, "rotation_degrees": 2, "share": 0.25}
    ]);
    let graded = course.graded(&json!({"bands": bands}), &points);
    check(&graded["always"], LINEAR, 10.5, &["0 of 21 frames are"]);
    check(&graded["at times"], LINEAR, 10.5, &["17 of 21 frames are"]);
    check(&graded["far"], LINEAR, 0.0, &["20 of 21 frames are", "9.000 degrees"]);
    check(&graded["keyframe"], "keyframe 3", 1.0, &["The rotation of ", " is 0.500 degrees off."]);
    let graded = course.graded(&json!({"share_of_frames": true}), &points);
    check(&graded["always"], LINEAR, 0.0, &[]);
    check(&graded["at times"], LINEAR, 17.0, &[]);
    check(&graded["far"], LINEAR, 20.0, &[]);
    check(&graded["keyframe"], "keyframe 3", 0.0, &[]);
    let graded = course.graded(&json!({"share_of_frames": true, "bands": bands}), &points);
    check(&graded["at times"], LINEAR, 19.0, &[]);
    let graded = course.graded(&json!({"playback": "assumed", "share_of_frames": true}), &points);
    // Two intervals of 20 frames each begin or end at that keyframe; near their other ends the error is small.
    let assumed = item(&graded["keyframe"], LINEAR);
    assert!((13.0..17.0).contains(&assumed["points"].as_f64().unwrap()), "{assumed}");
}

#[test]
fn an_error_of_keyframes_may_follow_through() {
    let mut course = Course::new();
    let mut own = course.made.clone();
    own[3][5].0[1] += 0.5;
    let student = |mistake| Student { mistake, plays_splines: false, keyframes: &own };
    let shows = |mistake| csv(&times(4), six, |time, node| Some(student(mistake).shows(time, node)));
    course.hand_in_keyframes("own", &own, &[("linear.csv", &shows("correct"))]);
    course.hand_in_keyframes("reference", &own, &[("linear.csv", &course.right("linear"))]);
    course.hand_in_keyframes("wrong", &own, &[("linear.csv", &shows("nlerp-for-slerp"))]);
    course.hand_in_keyframes("none", &own, &[]);
    course.hand_in("same", &[("linear.csv", &shows("correct"))]);
    let points = json!({"each_keyframe": 1, LINEAR: 20});
    let graded = course.graded(&json!({}), &points);
    check(&graded["own"], LINEAR, 0.0, &["It is right playback of the submission's own keyframes."]);
    check(&graded["reference"], LINEAR, 20.0, &[]);
    let follow = course.graded(&json!({"follow_through": true}), &points);
    check(&follow["own"], LINEAR, 20.0, &["all 21 frames are", " of its own keyframes' playback."]);
    check(&follow["reference"], LINEAR, 20.0, &[]);
    check(&follow["wrong"], LINEAR, 0.0, &["Diagnosis: nlerp-for-slerp."]);
    check(&follow["same"], LINEAR, 0.0, &[]);
    let assumed = course.graded(&json!({"follow_through": true, "playback": "assumed"}), &points);
    check(&assumed["none"], LINEAR, 20.0, &["they lost their points already"]);
    check(&course.graded(&json!({"playback": "assumed"}), &points)["none"], LINEAR, 0.0, &[]);

    // Without a reference there are no keyframes but the submission's own.
    let points = json!({"readable": 1, LINEAR: 20, "range_and_end": 5});
    let free = course.graded(&json!({"reference": null}), &points);
    for (name, playback) in [("own", 20.0), ("reference", 0.0), ("wrong", 0.0), ("none", 0.0)] {
        check(&free[name], LINEAR, playback, &[]);
        check(&free[name], "range_and_end", if name == "none" { 0.0 } else { 5.0 }, &[]);
    }
}

#[test]
fn keyframes_may_be_aligned() {
    let mut course = Course::new();
    let mut fewer = course.made.clone();
    fewer.remove(3);
    course.hand_in_keyframes("fewer", &fewer, &[]);
    let points = json!({"keyframe_count": 1, "each_keyframe": 1});
    assert_eq!(course.graded(&json!({}), &points)["fewer"]["points"], 3.0);
    let graded = course.graded(&json!({"align_keyframes": true}), &points);
    assert_eq!(graded["fewer"]["points"], 7.0);
    check(&graded["fewer"], "keyframe 2", 1.0, &["Compared with keyframe 2 of the submission. As in the reference."]);
    check(&graded["fewer"], "keyframe 3", 0.0, &["No keyframe of the submission stands in its place."]);
    check(&graded["fewer"], "keyframe 4", 1.0, &["Compared with keyframe 3 of the submission. As in the reference."]);
}

#[test]
fn rubrics_of_partial_credit_are_checked() {
    let course = Course::new();
    let band =
        |translation: f64, share: f64| json!({"translation": translation, "rotation_degrees": 1, "share": share});
    for (field, value, sentence) in [
        ("playback", json!("played"), "line 1 column 48: unknown value \"played\", expected samples or assumed"),
        ("samples_per_interval", json!(1001), "samples_per_interval is 1001, expected a whole number from 0 to 1000"),
        ("bands", json!([band(0.01, 1.5)]), "bands[0].share is 1.5, expected 0 to 1"),
        ("bands", json!([band(0.0001, 0.5)]), "bands[0] is not wider than the tolerances"),
        (
            "bands",
            json!([band(0.01, 0.5), band(0.02, 0.6)]),
            "bands[1].share is 0.6, expected less than 0.5, as bands[0] has",
        ),
    ] {
        let rubric = json!({"format": "inbetween.rubric", "version": 1, field: value, "reference": "reference.json", "points": {}});
        course.sandbox.write("bad.json", rubric.to_string());
        let run = course.sandbox.run(&["grade", "bad.json", "all", "-o", "out", "--no-images"]);
        run.refuses(&format!("bad.json: {sentence}"));
    }
    course.sandbox.write(
        "bad.json",
        r#"{"format": "inbetween.rubric", "version": 1, "playback": "assumed", "points": {"linear_playback": 1}}"#,
    );
    let run = course.sandbox.run(&["grade", "bad.json", "all", "-o", "out", "--no-images"]);
    run.refuses("bad.json: playback is \"assumed\", but reference names no file to compare with");
}
