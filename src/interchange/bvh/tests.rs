//! Small captures in, scenes and sentences out; scenes out and in again.

use std::fmt::Write as _;

use glam::{EulerRot, Quat, Vec3};

use super::*;
use crate::interchange::figure::Figure;
use crate::interchange::reduce::{Choice, Samples, Tolerance, reduced};
use crate::interpolation::Interpolation;
use crate::keyframe::{Animation, PlayRange};
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;
use crate::scene::{BUILT_IN_ANIMATIONS, SceneGraph, built_in_scene, scene_from_json, scene_to_json};

/// Two roots, a joint without length, channels in several orders, two ends of one joint.
const SMALL: &str = "\u{feff}HIERARCHY\r
ROOT Hips\r
{\r
\tOFFSET 0 0 0\r
\tCHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation\r
\tJOINT LHip { OFFSET 0 0 0 CHANNELS 1 Yrotation\r
\t\tJOINT left leg\r
\t\t{\r
\t\t\toffset .5 -10 0.0\r
\t\t\tchannels 3 Xrotation Zrotation Yrotation\r
\t\t\tEnd Site { OFFSET 0 -8 1 }\r
\t\t\tEnd Site { OFFSET 0 -8 -1 }\r
\t\t}\r
\t}\r
\tJOINT Neck { OFFSET 0 6 0 CHANNELS 4 Yposition Xscale Zrotation Yrotation End Site { OFFSET 0 2 0 } }\r
}\r
ROOT Ball { OFFSET 3 0 0 }\r
MOTION\r
Frames: 2\r
Frame Time:\t.0083333\r
1 2 3 10 20 30  40  50 60 70  7 1.5 80 90\r
\r
-1 -2e0 +3 0 0 0  0  0 0 0  6 1 0 0\r
";

fn small() -> Capture {
    read_bvh(SMALL.as_bytes()).unwrap()
}

fn parsed(text: &str) -> Result<Capture, String> {
    read_bvh(text.as_bytes()).map_err(|error| error.to_string())
}

#[test]
fn channels_are_factors_in_the_order_of_the_file() {
    let capture = small();
    assert_eq!((capture.joint_count(), capture.frame_count()), (5, 2));
    assert_eq!(capture.joints[2].name, "left leg");
    assert_eq!(capture.joints[2].ends, [DVec3::new(0.0, -8.0, 1.0), DVec3::new(0.0, -8.0, -1.0)]);
    assert_eq!((capture.joints[4].parent, capture.frame_seconds), (None, 0.008_333_3));
    let locals = capture.locals(Some(0));
    let angles =
        |order, a: f64, b: f64, c: f64| DQuat::from_euler(order, a.to_radians(), b.to_radians(), c.to_radians());
    let expected = [
        ([1.0, 2.0, 3.0], angles(EulerRot::ZYX, 10.0, 20.0, 30.0)),
        ([0.0, 0.0, 0.0], DQuat::from_rotation_y(40f64.to_radians())),
        ([0.5, -10.0, 0.0], angles(EulerRot::XZY, 50.0, 60.0, 70.0)),
        ([0.0, 7.0, 0.0], angles(EulerRot::ZYX, 80.0, 90.0, 0.0)),
        ([3.0, 0.0, 0.0], DQuat::IDENTITY),
    ];
    for (local, (translation, rotation)) in locals.iter().zip(expected) {
        assert_eq!(local.translation.to_array(), translation);
        assert!(local.rotation.angle_between(rotation) < 1e-7, "{:?} is not {rotation:?}", local.rotation);
    }
    assert_eq!(capture.locals(Some(1))[0].translation, DVec3::new(-1.0, -2.0, 3.0));
}

#[test]
fn a_capture_becomes_a_scene_that_stands_on_the_ground() {
    let CapturedScene { scene, samples, notes } = scene_of(&small(), "small", None).unwrap();
    let paths: Vec<&str> = scene.rbt_paths().collect();
    assert_eq!(paths, ["sky", "ground", "Hips", "Hips/LHip", "Hips/LHip/left leg", "Hips/Neck", "Ball"]);
    // A leg of 18 and a trunk of 8 are as tall as a robot.
    let height = |path: &str, tip: Vec3| {
        let node = scene.find_rbt(path).unwrap();
        scene.world_from_rbt(scene.rest_pose(), 0.0, node).transform_point(tip).y
    };
    let factor = PERSON_HEIGHT as f32 / 26.0;
    let (sole, top) =
        (height("Hips/LHip/left leg", Vec3::Y * -8.0 * factor), height("Hips/Neck", Vec3::Y * 2.0 * factor));
    assert!((top - sole - PERSON_HEIGHT as f32).abs() < 1e-4 && (0.0..0.2).contains(&sole), "{sole} to {top}");
    let samples = samples.unwrap();
    assert_eq!((samples.len(), samples.duration()), (2, 0.008_333_3));
    let first = samples.poses()[0].get(scene.find_rbt("Hips").unwrap()).translation;
    assert_eq!((first.x, first.z), (0.0, 0.0));
    let said: Vec<String> = notes.iter().map(ToString::to_string).collect();
    assert_eq!(
        said,
        [
            "5 joints, 2 frames at 120 a second",
            "0.1654 times as large as in the file: a person of 4.30 units",
            "its scale channels are left out",
        ]
    );
    assert_eq!(scene_from_json(&scene_to_json(&scene)).unwrap(), scene);
    let doubled = scene_of(&small(), "small", Some(2.0)).unwrap();
    let leg = doubled.scene.find_rbt("Hips/LHip/left leg").unwrap();
    assert_eq!(doubled.scene.rest_pose().get(leg).translation, Vec3::new(1.0, -20.0, 0.0));
}

/// Joints from which a person is built: name, level, offset.
const PERSON: [(&str, usize, [f64; 3]); 17] = [
    ("Hips", 0, [0.0, 0.0, 0.0]),
    ("LHipJoint", 1, [0.0, 0.0, 0.0]),
    ("LeftUpLeg", 2, [1.4, -1.8, 0.8]),
    ("LeftLeg", 3, [2.4, -6.7, 0.0]),
    ("LeftFoot", 4, [2.5, -7.0, 0.0]),
    ("RightUpLeg", 1, [-1.3, -1.8, 0.8]),
    ("RightLeg", 2, [-2.5, -7.0, 0.0]),
    ("RightFoot", 3, [-2.5, -7.0, 0.0]),
    ("Spine", 1, [0.0, 4.0, 0.0]),
    ("Head", 2, [0.0, 4.0, 0.0]),
    ("LeftShoulder", 2, [0.0, 0.0, 0.0]),
    ("LeftArm", 3, [3.4, 1.2, 0.0]),
    ("LeftForeArm", 4, [5.0, 0.0, 0.0]),
    ("LeftHand", 5, [3.5, 0.0, 0.0]),
    ("RightArm", 2, [-3.4, 1.2, 0.0]),
    ("RightForeArm", 3, [-5.0, 0.0, 0.0]),
    ("RightHand", 4, [-3.5, 0.0, 0.0]),
];

/// A person whose toes point along z, turned about y by degrees and, if asked, with z as the up axis.
fn person(turn: f64, is_z_up: bool) -> String {
    let rotation = DQuat::from_rotation_y(turn.to_radians());
    let upright = if is_z_up { DQuat::from_rotation_x(90f64.to_radians()) } else { DQuat::IDENTITY };
    let turned = |offset: [f64; 3]| upright * rotation * DVec3::from(offset);
    let mut text = String::from("HIERARCHY\n");
    for (index, &(name, level, offset)) in PERSON.iter().enumerate() {
        let DVec3 { x, y, z } = turned(offset);
        let keyword = if level == 0 { "ROOT" } else { "JOINT" };
        let _ = writeln!(text, "{keyword} {name} {{ OFFSET {x} {y} {z} CHANNELS 0");
        let next = PERSON.get(index + 1).map_or(0, |next| next.1);
        if next <= level {
            let end = if name.ends_with("Foot") { [0.0, -0.5, 3.0] } else { [0.0, 1.0, 0.0] };
            let DVec3 { x, y, z } = turned(end);
            let _ = writeln!(text, "End Site {{ OFFSET {x} {y} {z} }}");
        }
        let closed = (level + 1).saturating_sub(next);
        text += &"}\n".repeat(if index + 1 == PERSON.len() { level + 1 } else { closed });
    }
    text + "MOTION\nFrames: 0\nFrame Time: 0.01\n"
}

#[test]
fn limbs_are_told_whatever_way_a_person_faces() {
    for (turn, is_z_up) in [(0.0, false), (90.0, false), (180.0, false), (-90.0, false), (0.0, true), (180.0, true)] {
        let capture = parsed(&person(turn, is_z_up)).unwrap();
        let CapturedScene { scene, samples, notes } = scene_of(&capture, "person", None).unwrap();
        assert!(samples.is_none());
        assert_eq!(notes.iter().any(|note| note.id() == "bvh.turned"), is_z_up, "{turn}");
        let figure = Figure::of(&scene).unwrap();
        let name = |rbt: RbtIndex| scene.rbt_path(rbt).rsplit('/').next().unwrap().to_owned();
        let limbs: Vec<[String; 2]> = figure.limbs().map(|limb| [name(limb.upper), name(limb.lower)]).collect();
        let expected = [
            ["LeftUpLeg", "LeftLeg"],
            ["RightUpLeg", "RightLeg"],
            ["LeftArm", "LeftForeArm"],
            ["RightArm", "RightForeArm"],
        ];
        assert_eq!(limbs, expected, "{turn} {is_z_up}");
        assert_eq!((name(figure.hips), name(figure.head.unwrap())), ("Hips".to_owned(), "Head".to_owned()));
        let forward = Quat::from_rotation_y(turn.to_radians() as f32) * Vec3::Z;
        assert!(figure.forward.distance(forward) < 1e-3, "{turn}: {}", figure.forward);
        let knee = scene.node(scene.rbt_node(figure.legs[0].lower)).joint;
        assert!(knee.stands && knee.reach.is_some_and(|end| (end.length() - 0.166 * 7.43).abs() < 0.2), "{knee:?}");
    }
}

#[test]
fn what_is_flat_and_no_person_keeps_its_up_axis() {
    let text = "HIERARCHY\nROOT a { JOINT b { OFFSET 0 1 9 } }\nMOTION\nFrames: 0\nFrame Time: 1\n";
    let made = scene_of(&parsed(text).unwrap(), "a", Some(1.0)).unwrap();
    assert_eq!(made.scene.rest_pose().get(made.scene.find_rbt("a/b").unwrap()).translation, Vec3::new(0.0, 1.0, 9.0));
    assert!(made.notes.iter().all(|note| note.id() != "bvh.turned"));
}

#[test]
fn what_is_wrong_is_said_with_its_line() {
    let rest = "MOTION\nFrames: 1\nFrame Time: 0.1\n";
    for (text, said) in [
        ("", "line 1: expected HIERARCHY, found the end of the file"),
        ("{\"asset\": 1}", "line 1: expected HIERARCHY, found \"{\""),
        ("HIERARCHY\nMOTION", "line 2: expected ROOT, found \"MOTION\""),
        (
            "HIERARCHY\nROOT a\n{\nOFSET 0 0 0\n}",
            "line 4: expected OFFSET / CHANNELS / JOINT / End Site / }, found \"OFSET\"",
        ),
        ("HIERARCHY\nROOT a\n{\nOFFSET 0 0 x\n}", "line 4: expected a number, found \"x\""),
        ("HIERARCHY\nROOT a { OFFSET 0 0 nan }", "line 2: expected a number, found \"nan\""),
        ("HIERARCHY\nROOT a", "line 2: expected {, found the end of the file"),
        (
            "HIERARCHY\nROOT a {\nCHANNELS 1 Wrotation }",
            "line 3: \"Wrotation\" is no channel: they are Xposition, Yposition, Zposition, Xrotation, Yrotation and Zrotation",
        ),
        ("HIERARCHY\nROOT a {\nCHANNELS 2 Xrotation xrotation }", "line 3: the joint has the channel Xrotation twice"),
        ("HIERARCHY\nROOT a { }", "line 2: expected ROOT / MOTION, found the end of the file"),
    ] {
        assert_eq!(parsed(text), Err(said.to_owned()));
    }
    let skeleton = "HIERARCHY\nROOT a { OFFSET 0 0 0 CHANNELS 2 Xrotation Yrotation\nEnd Site { OFFSET 0 1 0 } }\n";
    for (motion, said) in [
        ("MOTION\nFrame Time: 1\n", "line 5: expected Frames:, found \"Frame Time: 1\""),
        ("MOTION\nFrames: 1\n", "line 5: expected Frame Time:, found the end of the file"),
        ("MOTION\nFrames: -1\nFrame Time: 1\n", "line 5: expected a number, found \"-1\""),
        ("MOTION\nFrames: 2\nFrame Time: 0\n1 2\n1 2", "line 6: a frame time of 0 s; it is from 0.0001 to 100 s"),
        ("MOTION\nFrames: 1\nFrame Time: 1\n1 2 3", "line 7: a frame has 2 numbers, and this line has 3"),
        ("MOTION\nFrames: 1\nFrame Time: 1\n1 2,5", "line 7: expected a number, found \"2,5\""),
    ] {
        assert_eq!(parsed(&format!("{skeleton}{motion}")), Err(said.to_owned()));
    }
    let fewer = parsed(&format!("{skeleton}MOTION\nFrames : 3\nFrame  Time : .1\n1 2\n3 4\n")).unwrap();
    assert_eq!((fewer.said_frames, fewer.frames), (3, 2));
    let deep = format!("HIERARCHY\nROOT a {{ {} {rest}", "JOINT a { ".repeat(300));
    assert_eq!(parsed(&deep), Err("line 2: joints in more than 250 levels".to_owned()));
    let many = format!("HIERARCHY\n{}{rest}", "ROOT a { }\n".repeat(5000));
    assert_eq!(parsed(&many), Err("line 4098: more than 4096 joints".to_owned()));
    let frames = "HIERARCHY\nROOT a { }\nMOTION\nFrames: 99999999999\nFrame Time: 1\n";
    assert!(parsed(frames).unwrap_err().contains("of all joints in all frames 8388608 are the most"));
}

#[test]
fn captures_without_extent_or_beyond_all_bounds_are_refused() {
    let of = |offset: &str, scale| {
        let text =
            format!("HIERARCHY\nROOT a {{ End Site {{ OFFSET {offset} }} }}\nMOTION\nFrames: 0\nFrame Time: 1\n");
        scene_of(&parsed(&text).unwrap(), "a", scale).map(|_| ()).map_err(|message| message.to_string())
    };
    assert_eq!(of("1 0 0", None), Err("no two joints or ends are at different places".to_owned()));
    assert_eq!(of("0 1e9 0", None), Ok(()));
    let far = "HIERARCHY\nROOT a { JOINT b { OFFSET 1e9 1 0 } }\nMOTION\nFrames: 0\nFrame Time: 1\n";
    let said = scene_of(&parsed(far).unwrap(), "a", None).map(|_| ()).unwrap_err().to_string();
    assert_eq!(said, "joint b is not within a million units of the origin");
    let long = "HIERARCHY\nROOT a { End Site { OFFSET 0 1 0 } }\nMOTION\nFrames: 1100\nFrame Time: 100\n";
    let said = scene_of(&parsed(long).unwrap(), "a", None).map(|_| ()).unwrap_err().to_string();
    assert_eq!(said, "an animation of 100100 s: 100000 s are the most");
}

/// The poses of an animation at a rate.
fn poses(animation: &Animation, fps: u32, frames: usize) -> Vec<Pose> {
    let range = PlayRange::new(&animation.keyframes).unwrap();
    let ms = f64::from(animation.ms_between_keyframes);
    (0..frames)
        .map(|frame| {
            let elapsed = 1000.0 * frame as f64 / f64::from(fps) / ms;
            let elapsed = num_rational::BigRational::from_float(elapsed).unwrap();
            range.pose_at(range.timing().key_time_at(&elapsed), animation.interpolation).unwrap()
        })
        .collect()
}

fn written(scene: &SceneGraph, animation: Option<&Animation>, fps: u32) -> (String, Vec<String>) {
    let text = BvhText::new(scene, animation, None, fps).unwrap();
    let mut bytes = Vec::new();
    text.write(&mut bytes).unwrap();
    (String::from_utf8(bytes).unwrap(), text.notes().iter().map(ToString::to_string).collect())
}

#[test]
fn what_is_written_reads_back_with_the_same_poses() {
    for example in BUILT_IN_ANIMATIONS {
        let scene = built_in_scene(example.scene).unwrap();
        let file = crate::keyframe::keyframes_from_json(example.text.as_bytes(), &scene).unwrap();
        let (keyframes, interpolation, ms_between_keyframes) = file.into_parts();
        let animation = Animation { keyframes, interpolation, ms_between_keyframes };
        let (text, notes) = written(&scene, Some(&animation), 60);
        let capture = parsed(&text).unwrap();
        assert_eq!(capture.joint_count(), scene.rbt_count());
        assert!(notes[0].starts_with(&format!("{} joints, {} frames", scene.rbt_count(), capture.frames)), "{notes:?}");
        if scene.is_timed() {
            continue;
        }
        let poses = poses(&animation, 60, capture.frames);
        for (frame, pose) in poses.iter().enumerate() {
            for (local, rbt) in capture.locals(Some(frame)).iter().zip(pose.iter()) {
                let read = Rbt::new(local.translation.as_vec3(), local.rotation.as_quat());
                let off = Tolerance { degrees: 0.0, units: 0.0 };
                let angle = local.rotation.angle_between(rbt.rotation.as_dquat().normalize()).to_degrees();
                assert!(angle < 2e-5, "{} frame {frame}: {angle} degrees, {off:?}", example.name);
                assert!(read.translation.distance(rbt.translation) < 1e-6, "{} frame {frame}", example.name);
            }
        }
    }
}

#[test]
fn one_skeleton_of_several_is_written_alone() {
    let scene = built_in_scene("two-robots").unwrap();
    let text = BvhText::new(&scene, None, scene.find_rbt("robot2"), 60).unwrap();
    let mut bytes = Vec::new();
    text.write(&mut bytes).unwrap();
    let capture = read_bvh(&bytes).unwrap();
    assert_eq!((capture.joint_count(), capture.joints[0].name.as_str()), (10, "robot2"));
    assert_eq!(capture.locals(Some(0))[0].translation, DVec3::new(2.0, 1.0, 0.0));
    assert_eq!(text.notes().len(), 2, "one root is no reason for a note");
}

#[test]
fn angles_do_not_jump_from_frame_to_frame() {
    let scene = scene_from_json(
        r#"{"format": "inbetween.scene", "version": 1, "name": "one", "eyes": ["a"], "nodes": [{"name": "a"}]}"#,
    )
    .unwrap();
    let turn = |degrees: f32| {
        Pose::new(vec![Rbt::from_rotation(Quat::from_euler(EulerRot::ZXY, 0.3, degrees.to_radians(), 0.2))])
    };
    let samples = Samples::of(1.0, 30.0, |at| turn(40.0 + 350.0 * at as f32)).unwrap();
    let tolerance = Tolerance { degrees: 0.01, units: 1e-3 };
    let made = reduced(&samples, Choice::Within(tolerance), Interpolation::Linear);
    let (text, _) = written(&scene, Some(&made.animation), 30);
    let capture = parsed(&text).unwrap();
    for pair in capture.values.chunks(6).collect::<Vec<_>>().windows(2) {
        let step = pair[0].iter().zip(pair[1]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(step < 15.0, "{pair:?}");
    }
}

#[test]
fn scales_are_part_of_positions_and_shears_are_refused() {
    let scene = |inner: &str| {
        scene_from_json(&format!(
            r#"{{"format": "inbetween.scene", "version": 2, "name": "s", "eyes": ["a"], "nodes": [{{"name": "a", "children": [
                {{"name": "c", "control": {{"scale": [[0, [2, 3, 2]]]}}, "in_paths": false, "children": [{inner}]}}]}}]}}"#
        ))
        .unwrap()
    };
    let scaled = scene(r#"{"name": "b one", "translation": [1, 1, 0]}"#);
    let (text, notes) = written(&scaled, None, 60);
    assert!(text.contains("\tJOINT b_one\n\t{\n\t\tOFFSET 2 3 0\n"), "{text}");
    assert!(text.ends_with("MOTION\nFrames: 1\nFrame Time: 0.016666666666666666\n0 0 0 0 0 0 0 0 0\n"), "{text}");
    assert_eq!(notes[1], "shapes, colours and eyes are left out: the format has joints alone");
    let sheared = scene(r#"{"name": "b", "rotation": {"euler_degrees": [0, 0, 40]}}"#);
    let said = BvhText::new(&sheared, None, None, 60).map(|_| ()).unwrap_err().to_string();
    assert_eq!(said, "node a/b: scales above it turn its axes out of square, which the format cannot say");
}

/// Whatever a file holds, reading it ends with a scene or a sentence.
#[test]
fn no_mutant_of_a_capture_makes_the_program_fail() {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut random = |below: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        usize::try_from(state % below as u64).unwrap()
    };
    let pieces: [&[u8]; 16] = [
        b"{",
        b"}",
        b"ROOT",
        b"JOINT",
        b"End Site",
        b"OFFSET",
        b"CHANNELS",
        b"MOTION",
        b"Frames: ",
        b"Frame Time: ",
        b"1e308",
        b"-0",
        b"999999999999999999999",
        b"\n",
        b"nan",
        b"1e-320",
    ];
    let person = person(0.0, false);
    let originals = [SMALL.as_bytes(), person.as_bytes()];
    let mut read = 0;
    for mutant in 0..20_000 {
        let mut bytes = originals[mutant % 2].to_vec();
        for _ in 0..=random(2) {
            let at = random(bytes.len());
            match random(5) {
                0 => bytes[at] = u8::try_from(random(256)).unwrap(),
                1 => drop(bytes.splice(at..at, pieces[random(pieces.len())].iter().copied())),
                2 => bytes.truncate(at + 1),
                3 => drop(bytes.drain(at..(at + 1 + random(40)).min(bytes.len()))),
                _ => {
                    let end = (at + random(60)).min(bytes.len());
                    let copy = bytes[at..end].to_vec();
                    let to = random(bytes.len());
                    bytes.splice(to..to, copy);
                }
            }
            if bytes.is_empty() {
                bytes.push(b' ');
            }
        }
        let Ok(capture) = read_bvh(&bytes) else { continue };
        if let Ok(made) = scene_of(&capture, "mutant", (mutant % 3 == 0).then_some(0.1)) {
            read += 1;
            assert!(made.scene.rest_pose().iter().all(Rbt::is_finite));
            let poses = made.samples.iter().flat_map(Samples::poses);
            assert!(poses.flat_map(Pose::iter).all(Rbt::is_in_bounds));
            if mutant % 50 == 0 {
                assert!(scene_from_json(&scene_to_json(&made.scene)).is_ok());
            }
        }
    }
    assert!(read > 1000, "only {read} mutants are captures");
}
