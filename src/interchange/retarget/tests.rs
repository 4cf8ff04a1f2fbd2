//! A walker that the tests make, onto a robot; and maps, right and wrong.

use std::f64::consts::PI;
use std::fmt::Write as _;

use glam::{DVec3, Vec3Swizzles as _};

use super::way::{FootWay, runs, spread};
use super::*;
use crate::interchange::bvh::{CapturedScene, read_bvh, scene_of};
use crate::keyframe::keyframes_from_json;
use crate::scene::{BUILT_IN_ANIMATIONS, DEFAULT_SCENE, built_in_scene};

const THIGH: f64 = 42.0;
const SHIN: f64 = 40.0;
const LEG: f64 = THIGH + SHIN;
const FPS: f64 = 60.0;
/// Seconds of two steps, and the length of the two.
const CYCLE: f64 = 1.2;
const STRIDE: f64 = 110.0;

/// Where an ankle is at a time: it stands for 6 tenths of the cycle, and slides a little as captured feet do.
fn ankle(seconds: f64, phase: f64) -> (f64, f64) {
    let cycles = seconds / CYCLE + phase;
    let part = cycles.fract();
    let start = (cycles.floor() - phase) * STRIDE;
    if part < 0.6 {
        return (start + 0.03 * LEG * (PI * part / 0.6).sin(), 8.0 + 0.5 * (40.0 * part).sin());
    }
    let swing = (part - 0.6) / 0.4;
    (start + STRIDE * swing * swing * (3.0 - 2.0 * swing), 8.0 + 14.0 * (PI * swing).sin())
}

/// The angles about x of thigh and shin that bring the ankle to a place from the hip joint, forward and up, knees forward.
fn leg(forward: f64, up: f64) -> (f64, f64) {
    let reach = forward.hypot(up).min(0.999 * LEG);
    let towards = (-forward).atan2(-up);
    let thigh = ((THIGH * THIGH + reach * reach - SHIN * SHIN) / (2.0 * THIGH * reach)).acos();
    let knee = PI - ((THIGH * THIGH + SHIN * SHIN - reach * reach) / (2.0 * THIGH * SHIN)).acos();
    ((towards - thigh).to_degrees(), knee.to_degrees())
}

/// A person who walks along z, or along -z where `turned`. Names of sides are the person's own.
fn walker(seconds: f64, turned: bool) -> String {
    let side = if turned { -1.0 } else { 1.0 };
    let mut text = String::from(
        "HIERARCHY\nROOT Hips {\nOFFSET 0 0 0 CHANNELS 6 Xposition Yposition Zposition Yrotation Xrotation Zrotation\n",
    );
    for (name, x) in [("Left", 10.0 * side), ("Right", -10.0 * side)] {
        let _ = writeln!(
            text,
            "JOINT {name}UpLeg {{ OFFSET {x} -5 0 CHANNELS 1 Xrotation JOINT {name}Leg {{ OFFSET 0 {} 0 CHANNELS 1 Xrotation \
             JOINT {name}Foot {{ OFFSET 0 {} 0 CHANNELS 1 Xrotation End Site {{ OFFSET 0 -8 {} }} }} }} }}",
            -THIGH,
            -SHIN,
            18.0 * side
        );
    }
    text +=
        "JOINT Spine { OFFSET 0 20 0 CHANNELS 3 Yrotation Xrotation Zrotation JOINT Chest { OFFSET 0 25 0 CHANNELS 0\n";
    for (name, x) in [("Left", side), ("Right", -side)] {
        let _ = writeln!(
            text,
            "JOINT {name}Shoulder {{ OFFSET 0 0 0 CHANNELS 0 JOINT {name}Arm {{ OFFSET {} 4 0 CHANNELS 3 Yrotation Zrotation Xrotation \
             JOINT {name}ForeArm {{ OFFSET {} 0 0 CHANNELS 1 Yrotation JOINT {name}Hand {{ OFFSET {} 0 0 CHANNELS 0 \
             End Site {{ OFFSET {} 0 0 }} }} }} }} }}",
            18.0 * x,
            28.0 * x,
            24.0 * x,
            9.0 * x
        );
    }
    text += "JOINT Neck { OFFSET 0 10 0 CHANNELS 0 JOINT Head { OFFSET 0 8 0 CHANNELS 3 Yrotation Xrotation Zrotation \
             End Site { OFFSET 0 14 0 } } } } }\n}\nMOTION\n";
    let frames = (seconds * FPS) as usize + 1;
    let _ = write!(text, "Frames: {frames}\nFrame Time: {}\n", 1.0 / FPS);
    for frame in 0..frames {
        let at = frame as f64 / FPS;
        let swing = (2.0 * PI * at / CYCLE).sin();
        let (forward, up) = (at / CYCLE * STRIDE + 8.0, 8.0 + 0.95 * LEG + 5.0 + 1.5 * (4.0 * PI * at / CYCLE).sin());
        let _ = write!(text, "0 {up} {} {} 2 {}", forward * side, 6.0 * swing, 2.0 * swing);
        for phase in [0.0, 0.5] {
            let (ankle_forward, ankle_up) = ankle(at, phase);
            let (thigh, knee) = leg(ankle_forward - forward, ankle_up - (up - 5.0));
            let _ = write!(text, " {} {} {}", thigh * side, knee * side, -(thigh + knee) * side);
        }
        let _ = write!(text, " {} 3 0", -8.0 * swing);
        for arm in [1.0, -1.0] {
            let _ = write!(text, " {} {} {} {}", -30.0 * swing, -70.0 * arm * side, 5.0, -20.0 * arm * side);
        }
        let _ = writeln!(text, " {} 5 0", 10.0 * swing);
    }
    text
}

fn captured(text: &str) -> (SceneGraph, Samples) {
    let CapturedScene { scene, samples, .. } = scene_of(&read_bvh(text.as_bytes()).unwrap(), "walker", None).unwrap();
    (scene, samples.unwrap())
}

fn usual(scene: &SceneGraph, top: RbtIndex) -> Choice {
    Choice::Within(tolerance_for(scene, top))
}

#[test]
fn a_captured_walk_onto_a_robot_keeps_its_feet() {
    let target = built_in_scene(DEFAULT_SCENE).unwrap();
    let robot = target.find_rbt("robot2").unwrap();
    for turned in [false, true] {
        let (scene, samples) = captured(&walker(6.0, turned));
        let source = Source { scene: &scene, samples: &samples };
        let map = RetargetMap::guessed(&scene, &target, Some(robot)).unwrap();
        assert_eq!(map.turn_degrees.abs(), if turned { 180.0 } else { 0.0 });
        // The robots' sides are named as their viewer sees them.
        for (onto, from) in [
            ("robot2", "Hips"),
            ("robot2/right_hip/right_knee", "Hips/LeftUpLeg/LeftLeg"),
            ("robot2/left_shoulder", "Hips/Spine/Chest/RightShoulder/RightArm"),
            ("robot2/right_shoulder/right_elbow", "Hips/Spine/Chest/LeftShoulder/LeftArm/LeftForeArm"),
            ("robot2/head", "Hips/Spine/Chest/Neck/Head"),
        ] {
            assert_eq!(map.nodes[onto], from, "turned: {turned}");
        }
        assert_eq!(map.feet["robot2/left_hip/left_knee"], "Hips/RightUpLeg/RightLeg/RightFoot");
        let made = retargeted(source, &target, &map).unwrap();
        for interpolation in Interpolation::ALL {
            let keyframes = made.clone().keyframes(usual(&target, robot), interpolation);
            assert!(keyframes.reduced.animation.keyframes.len() < 300, "{:?}", keyframes.reduced.message());
            for foot in &keyframes.feet {
                assert!(foot.stances >= 5 && foot.slide < 0.005, "turned: {turned}, {interpolation:?}: {foot:?}");
            }
            let said = keyframes.notes.last().unwrap().to_string();
            assert!(said.starts_with("feet stand 1"), "{said}");
        }
        // The walk goes as far as the legs are longer, along z.
        let hips = |pose: &Pose| pose.get(robot).translation;
        let poses = made.samples().poses();
        let way = hips(&poses[poses.len() - 1]) - hips(&poses[0]);
        let expected = 2.25 / LEG as f32 * (5.0 * STRIDE as f32);
        assert!((way.z - expected).abs() < 0.01 * expected && way.x.abs() < 0.05, "{way}");
        // Without feet in the map they slide as captured.
        let without = RetargetMap { feet: [].into(), ..map.clone() };
        let sliding = retargeted(source, &target, &without).unwrap();
        let knee = target.find_rbt("robot2/right_hip/right_knee").unwrap();
        let keyframes = sliding.keyframes(usual(&target, robot), Interpolation::Linear);
        let foot = watched(&target, knee, Vec3::Y * -1.25, Vec::new());
        let slides = standing(&keyframes.reduced.animation, &foot, 2.25);
        assert!(slides.slide > 0.02, "{slides:?}");
    }
}

#[test]
fn bones_point_as_those_of_the_source() {
    let target = built_in_scene(DEFAULT_SCENE).unwrap();
    let (scene, samples) = captured(&walker(1.5, false));
    let map = RetargetMap::guessed(&scene, &target, None).unwrap();
    let made = retargeted(Source { scene: &scene, samples: &samples }, &target, &map).unwrap();
    let bone = |scene: &SceneGraph, pose: &Pose, path: &str, tip: Vec3| {
        let node = scene.world_from_rbt(pose, 0.0, scene.find_rbt(path).unwrap());
        node.transform_vector(tip).normalize()
    };
    for (pose, own) in samples.poses().iter().zip(made.samples().poses()) {
        for (from, onto) in [
            ("Hips/Spine/Chest/LeftShoulder/LeftArm", "robot1/right_shoulder"),
            ("Hips/Spine/Chest/LeftShoulder/LeftArm/LeftForeArm", "robot1/right_shoulder/right_elbow"),
        ] {
            let off = bone(&scene, pose, from, Vec3::X).distance(bone(&target, own, onto, Vec3::X));
            assert!(off < 1e-3, "{onto}: {off}");
        }
    }
    let still = |path: &str| target.find_rbt(path).unwrap();
    for pose in made.samples().poses() {
        for rbt in [still("sky"), still("robot2/head"), still("robot2")] {
            assert_eq!(pose.get(rbt), target.rest_pose().get(rbt));
        }
    }
}

#[test]
fn a_robot_moves_as_another_robot() {
    let scene = built_in_scene(DEFAULT_SCENE).unwrap();
    let text = BUILT_IN_ANIMATIONS.iter().find(|example| example.name == "walk").unwrap().text;
    let (keyframes, interpolation, ms_between_keyframes) =
        keyframes_from_json(text.as_bytes(), &scene).unwrap().into_parts();
    let animation = Animation { keyframes, interpolation, ms_between_keyframes };
    let samples = sampled(&scene, &animation).unwrap();
    let find = |path: &str| scene.find_rbt(path).unwrap();
    let mut map = RetargetMap::guessed(&scene, &scene, Some(find("robot2"))).unwrap();
    assert_eq!(map.feet["robot2/left_hip/left_knee"], "robot1/left_hip/left_knee");
    map.feet.clear();
    let made = retargeted(Source { scene: &scene, samples: &samples }, &scene, &map).unwrap();
    for (pose, own) in samples.poses().iter().zip(made.samples().poses()) {
        for part in ["", "/head", "/left_shoulder/left_elbow", "/right_hip", "/right_hip/right_knee"] {
            let [from, onto] = ["robot1", "robot2"].map(|robot| find(&format!("{robot}{part}")));
            let off = pose.get(from).rotation.angle_between(own.get(onto).rotation).to_degrees();
            assert!(off < 0.1, "{part}: {off} degrees");
        }
    }
}

#[test]
fn a_map_is_written_and_read_back() {
    let scene = built_in_scene(DEFAULT_SCENE).unwrap();
    let map = RetargetMap::guessed(&scene, &scene, None).unwrap();
    assert_eq!(RetargetMap::from_json(map.to_json().as_bytes()), Ok(map.clone()));
    let empty = RetargetMap { turn_degrees: -90.5, ..RetargetMap::default() };
    assert_eq!(RetargetMap::from_json(empty.to_json().as_bytes()), Ok(empty.clone()));
    for (text, said) in [
        (
            r#"{"format": "x", "version": 1, "nodes": {}}"#,
            r#"format is "x" and version is 1; expected inbetween.retarget and 1"#,
        ),
        (
            r#"{"format": "inbetween.retarget", "version": 1, "turn_degrees": 400, "nodes": {}}"#,
            "turn_degrees is 400; expected a number from -360 to 360",
        ),
    ] {
        assert_eq!(RetargetMap::from_json(text.as_bytes()).unwrap_err().to_string(), said);
    }
    assert!(RetargetMap::from_json(b"{").unwrap_err().to_string().starts_with("line 1"));
    let samples = Samples::starting_with(scene.rest_pose().clone());
    let source = Source { scene: &scene, samples: &samples };
    let pairs = |pairs: &[(&str, &str)]| pairs.iter().map(|&(onto, from)| (onto.to_owned(), from.to_owned())).collect();
    let said = |nodes: &[(&str, &str)], feet: &[(&str, &str)]| {
        let map = RetargetMap { turn_degrees: 0.0, nodes: pairs(nodes), feet: pairs(feet) };
        retargeted(source, &scene, &map).map(|_| ()).unwrap_err().to_string()
    };
    assert_eq!(said(&[], &[]), "nodes is empty: nothing would move");
    assert_eq!(said(&[("robot9", "sky")], &[]), "nodes names \"robot9\", and two-robots has no such RBT node");
    assert_eq!(said(&[("robot1", "no")], &[]), "nodes names \"no\", and two-robots has no such RBT node");
    let foot = "robot1/left_hip/left_knee";
    let expected = format!(
        "feet names \"{foot}\": that node, and the RBT node above it, have to be in nodes, and need a bone between them"
    );
    assert_eq!(said(&[("robot1", "robot2")], &[(foot, foot)]), expected);
    let other = built_in_scene("orbits").unwrap();
    assert_eq!(
        RetargetMap::guessed(&scene, &other, None).unwrap_err().to_string(),
        "orbits has no two legs that its rest pose tells: --map takes a map written by hand"
    );
}

/// A foot that is dragged over the ground steps instead: it goes up, along, and down.
#[test]
fn a_dragged_foot_is_lifted_before_it_moves() {
    let leg = 2.0;
    let seconds: Vec<f64> = (0..300).map(|index| f64::from(index) / 100.0).collect();
    let natural: Vec<DVec3> = seconds
        .iter()
        .map(|&at| DVec3::new(1.5 * ((at - 1.0) / 0.4).clamp(0.0, 1.0), 0.01 * (9.0 * at).sin(), 0.2))
        .collect();
    let way = FootWay::of(&natural, &seconds, -1.0, leg);
    let stances = runs(way.planted.iter().copied());
    assert_eq!(stances.len(), 2, "{stances:?}");
    let low = runs(way.ends.iter().map(|end| end.y < -1.0 + 0.02 * leg));
    assert_eq!(low.len(), 2);
    for (from, to) in low {
        assert!(spread(&way.ends[from..=to]) < 1e-9);
    }
    for pair in way.ends.windows(2) {
        assert!(pair[0].distance(pair[1]) < 0.3, "{pair:?}");
    }
    assert!(way.ends[299].xz().distance(natural[299].xz()) < 0.02);
    // One that never stands goes its way.
    let sliding: Vec<DVec3> = seconds.iter().map(|&at| DVec3::new(3.0 * at, 0.0, 0.0)).collect();
    let way = FootWay::of(&sliding, &seconds, 0.0, leg);
    assert!(!way.planted.contains(&true) && way.ends == sliding);
}
