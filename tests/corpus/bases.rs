//! Good files of every kind, from which bad ones are made.

use std::fmt::Write as _;

use glam::Vec3;
use inbetween::gltf::data_uri;
use inbetween::model::{MeshLibrary, TriangleMesh};

use crate::{models, student};

/// The files that all cases can read, as `../shared/NAME`.
pub const SHARED: [(&str, &str); 13] = [
    ("good.json", "keyframes 4"),
    ("six.json", "keyframes 6"),
    ("slow.json", "slow 6"),
    ("three.json", "keyframes 3"),
    ("none.json", "keyframes 0"),
    ("rows.txt", "rows 5"),
    ("keys.py", "python"),
    ("spin.json", "scene 2"),
    ("plain.json", "scene 1"),
    ("samples.csv", "samples"),
    ("hotkeys.txt", "hotkeys"),
    ("joints.txt", "joints"),
    ("person.bvh", "capture"),
];

/// The RBT nodes of the built-in scene and their offsets.
pub const NODES: [(&str, [&str; 3]); 22] = [
    ("sky", ["0", "0.25", "4"]),
    ("ground", ["0", "0", "0"]),
    ("robot1", ["-2", "1", "0"]),
    ("robot1/right_shoulder", ["0.5", "0.75", "0"]),
    ("robot1/right_shoulder/right_elbow", ["0.7", "0", "0"]),
    ("robot1/left_shoulder", ["-0.5", "0.75", "0"]),
    ("robot1/left_shoulder/left_elbow", ["-0.7", "0", "0"]),
    ("robot1/right_hip", ["0.375", "-0.75", "0"]),
    ("robot1/right_hip/right_knee", ["0", "-1", "0"]),
    ("robot1/left_hip", ["-0.375", "-0.75", "0"]),
    ("robot1/left_hip/left_knee", ["0", "-1", "0"]),
    ("robot1/head", ["0", "0.75", "0"]),
    ("robot2", ["2", "1", "0"]),
    ("robot2/right_shoulder", ["0.5", "0.75", "0"]),
    ("robot2/right_shoulder/right_elbow", ["0.7", "0", "0"]),
    ("robot2/left_shoulder", ["-0.5", "0.75", "0"]),
    ("robot2/left_shoulder/left_elbow", ["-0.7", "0", "0"]),
    ("robot2/right_hip", ["0.375", "-0.75", "0"]),
    ("robot2/right_hip/right_knee", ["0", "-1", "0"]),
    ("robot2/left_hip", ["-0.375", "-0.75", "0"]),
    ("robot2/left_hip/left_knee", ["0", "-1", "0"]),
    ("robot2/head", ["0", "0.75", "0"]),
];

/// A good file: its kind, and how many keyframes it has where that matters; of `shown` the mistake that a program shows.
pub fn base(spec: &str) -> String {
    if let Some(mistake) = spec.strip_prefix("shown ") {
        return shown(mistake);
    }
    let (kind, count) = spec.split_once(' ').unwrap_or((spec, "4"));
    let count: usize = count.parse().unwrap_or_else(|_| panic!("{spec} is no base"));
    match kind {
        "keyframes" => keyframes(count, ""),
        "slow" => keyframes(count, "").replacen("2000", "3100", 1).replacen("linear", "catmull-rom", 1),
        "named" => keyframes(count, "\"name\": \"up\", \"duration\": 1.5, \"easing\": \"sine-in-out\", "),
        "json" => compact_keyframes(count),
        "rows" => rows(count, 22),
        "header" => format!("{count} 22\n{}", rows(count, 22)),
        "header24" => format!("{count} 24\n{}", rows(count, 24)),
        "rows26" => rows(count, 26),
        "a-line24" => rows(count, 24)
            .lines()
            .enumerate()
            .map(|(row, line)| format!("{line}{}", if row % 24 == 23 { "\n" } else { " " }))
            .collect(),
        "either" => "1 0 0 0 1 0 0\n".repeat(22 * count),
        "either-csv" => {
            let row = |row: usize| format!("{},{},1,0,0,0,1,0,0\n", row / 22, row % 22);
            csv(0) + &(0..22 * count).map(row).collect::<String>()
        }
        "bad" => keyframes(4, "").replacen("[0, 0, 0, 1]", "[0, 0, 0, 2]", count),
        "quaternion-first" => format!("{count} 22\n{}", swapped(count)),
        "frames" => (0..count).map(|keyframe| format!("frame [{keyframe}]\n{}", keyframe_rows(keyframe, 22))).collect(),
        "end" => (0..count).map(|keyframe| format!("{}end\n", keyframe_rows(keyframe, 22))).collect(),
        "csv" => csv(count),
        "pairs" => joined(count, |[x, y, z, qw, qx, qy, qz]| format!("{x},{y},{z};{qw},{qx},{qy},{qz} ")),
        "endless" => joined(count, |row| format!("{};", row.join(","))).replace('\n', ""),
        "a-line" => format!("{count} 22\n{}", joined(count, |row| format!("{} ", row.join(" ")))),
        "two-lines" => {
            let lines = joined(count, |[x, y, z, qw, qx, qy, qz]| format!("{x} {y} {z}\n{qw} {qx} {qy} {qz}\n"));
            format!("{count} 22\n{lines}")
        }
        "matrices" => joined(count, |row| matrix(&row)),
        "python" => PYTHON.to_owned(),
        "many-keys" => {
            format!("scale_keys = {{{}}}\n", (0..count).map(|time| format!("{time}: 1,")).collect::<String>())
        }
        "many-groups" => "{0: 1}\n".repeat(count),
        "deep-python" => format!("scale_keys = {{0: {}1{}}}\n", "(".repeat(count), ")".repeat(count)),
        "long-python" => format!("names = '{}'\n", "a".repeat(count)),
        "zeros" => "\0".repeat(count),
        "scene" => scene(count),
        "mesh" => mesh(),
        "gltf" => models::gltf(),
        "samples" => samples(),
        "hotkeys" => "key i\nkey >\nkey +\nkey y\nwait 1s\nkey t\nwait 10s\nkey <\nundo\n".to_owned(),
        "joints" => NODES.iter().map(|(path, _)| format!("{path}\n")).collect(),
        "animated" => student::file(&made(), &NODES.map(|(path, _)| path.to_owned()), "two-robots", "linear", 2000),
        "outside" => "open ../elsewhere.json\nsave-scene /tmp/scene.json\n".to_owned(),
        "journal-line" => "keyframe-file \"animation.json\"\nkey n\n".to_owned(),
        "long-wait" => "key i\nwait 3601s\n".to_owned(),
        "many-lines" => "key c\n".repeat(count),
        "nonsense" => "fly away\n".to_owned(),
        "turned" => keyframes(6, "").replace("[0.6, 0, 0, 0.8]", "[0, 0.6, 0, 0.8]"),
        "cut-zip" => "PK\u{3}\u{4}\u{14}\0\0\0\0\0".to_owned(),
        "cut-journal" => format!("{JOURNAL}do keyframe-new\ndo keyframe-"),
        "trace" => TRACE.to_owned(),
        "other-trace" => "{\"step\": 0}\n".to_owned(),
        "deep" => format!("{{\"step\": {}", "[".repeat(count)),
        "one-picture" => ONE_PICTURE.to_owned(),
        "rubric" => RUBRIC.to_owned(),
        "rubric-toml" => RUBRIC_TOML.to_owned(),
        "pictures" => PICTURES.to_owned(),
        "settings" => SETTINGS.to_owned(),
        "capture" => CAPTURE.to_owned(),
        "many-joints" => format!("HIERARCHY\n{}", "ROOT a { }\n".repeat(count)),
        "deep-joints" => format!("HIERARCHY\nROOT a {{ {}", "JOINT a { ".repeat(count)),
        _ => panic!("{spec} is no base"),
    }
}

/// A captured person: three frames of a step.
const CAPTURE: &str = "HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT LeftUpLeg
  {
    OFFSET 10 -5 0
    CHANNELS 1 Xrotation
    JOINT LeftLeg
    {
      OFFSET 0 -42 0
      CHANNELS 1 Xrotation
      JOINT LeftFoot
      {
        OFFSET 0 -40 0
        CHANNELS 0
        End Site { OFFSET 0 -8 18 }
      }
    }
  }
  JOINT RightUpLeg
  {
    OFFSET -10 -5 0
    CHANNELS 1 Xrotation
    JOINT RightLeg
    {
      OFFSET 0 -42 0
      CHANNELS 1 Xrotation
      JOINT RightFoot
      {
        OFFSET 0 -40 0
        CHANNELS 0
        End Site { OFFSET 0 -8 18 }
      }
    }
  }
  JOINT Head
  {
    OFFSET 0 50 0
    CHANNELS 1 Yrotation
    End Site { OFFSET 0 20 0 }
  }
}
MOTION
Frames: 3
Frame Time: 0.1
0 95 0 0 0 0 0 0 0 0 0
0 94 5 0 0 5 -20 25 15 5 10
0 95 10 0 0 0 -30 10 20 20 0
";

/// Unit quaternions w, x, y, z of few digits.
const ROTATIONS: [[&str; 4]; 4] =
    [["1", "0", "0", "0"], ["0.8", "0.6", "0", "0"], ["0.96", "0", "0.28", "0"], ["0.8", "0", "0", "-0.6"]];

/// tx ty tz qw qx qy qz of a node; the head of the first robot is at x = 0, 1, 2, …, and turns.
fn row(keyframe: usize, node: usize) -> [String; 7] {
    let (_, offset) = NODES.get(node).copied().unwrap_or(("light", ["3", "9", "2"]));
    let mut row = offset.map(str::to_owned).to_vec();
    if node == 11 {
        row[0] = keyframe.to_string();
    }
    let turn = if matches!(node, 2 | 11) { ROTATIONS[keyframe % ROTATIONS.len()] } else { ROTATIONS[0] };
    row.extend(turn.map(str::to_owned));
    row.try_into().expect("there are seven")
}

fn keyframe_rows(keyframe: usize, nodes: usize) -> String {
    (0..nodes).map(|node| row(keyframe, node).join(" ") + "\n").collect()
}

fn rows(count: usize, nodes: usize) -> String {
    (0..count).map(|keyframe| keyframe_rows(keyframe, nodes)).collect()
}

fn swapped(count: usize) -> String {
    let all = (0..count).flat_map(|keyframe| (0..22).map(move |node| row(keyframe, node)));
    all.map(|[x, y, z, quaternion @ ..]| format!("{} {x} {y} {z}\n", quaternion.join(" "))).collect()
}

/// A keyframe a line, of rows that are put into text so.
fn joined(count: usize, text: impl Fn([String; 7]) -> String) -> String {
    let line =
        |keyframe| (0..22).map(|node| text(row(keyframe, node))).collect::<String>().trim_end().to_owned() + "\n";
    (0..count).map(line).collect()
}

fn csv(count: usize) -> String {
    let mut text = String::from("frame_num,rbt_ind,tx,ty,tz,rw,rx,ry,rz\n");
    for keyframe in 0..count {
        for node in 0..22 {
            let _ = writeln!(text, "{keyframe},{node},{}", row(keyframe, node).join(","));
        }
    }
    text
}

fn matrix(row: &[String; 7]) -> String {
    let [tx, ty, tz, w, x, y, z] = row.clone().map(|number| number.parse::<f64>().unwrap());
    let columns = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y), 0.0],
        [2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x), 0.0],
        [2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y), 0.0],
        [tx, ty, tz, 1.0],
    ];
    columns.iter().flatten().fold(String::new(), |text, number| text + &format!("{number:.4},"))
}

/// What the built-in scene's keyframe file looks like when the program writes it.
fn keyframes(count: usize, extras: &str) -> String {
    let version = if extras.is_empty() { 1 } else { 2 };
    let nodes: Vec<String> = NODES.iter().map(|(path, _)| format!("    \"{path}\"")).collect();
    let poses: Vec<String> = (0..count)
        .map(|keyframe| {
            let rows: Vec<String> = (0..22)
                .map(|node| {
                    let [x, y, z, qw, qx, qy, qz] = row(keyframe, node);
                    format!("      {{ \"translation\": [{x}, {y}, {z}], \"rotation\": [{qx}, {qy}, {qz}, {qw}] }}")
                })
                .collect();
            format!("    {{ {extras}\"pose\": [\n{}\n    ] }}", rows.join(",\n"))
        })
        .collect();
    let list = if count == 0 { "[]".to_owned() } else { format!("[\n{}\n  ]", poses.join(",\n")) };
    format!(
        "{{\n  \"format\": \"inbetween.keyframes\",\n  \"version\": {version},\n  \"scene\": \"two-robots\",\n  \
         \"interpolation\": \"linear\",\n  \"ms_between_keyframes\": 2000,\n  \"nodes\": [\n{}\n  ],\n  \"keyframes\": {list}\n}}\n",
        nodes.join(",\n"),
    )
}

/// The same with other blanks than the program writes.
fn compact_keyframes(count: usize) -> String {
    keyframes(count, "").split_whitespace().collect()
}

const PYTHON: &str = "\
from quaternion import *
translate_keys = {0: vec(0, 0, 0), 1: vec(0.5, 0.5, 0), 3: (0, -0.85, 0)}
rotate_keys = {0: quaternion(), 2: quaternion_from_euler(180, 45, 90),
               3: quaternion_from_axis_angle(vec(0, 1, 0), degrees=90), 4: quaternion(0, 0, 0.6, 0.8)}
scale_keys = {0: 1, 2: vec(0.5, 1, 2), 4: 0.5}
";

fn scene(version: usize) -> String {
    let in_paths = if version == 2 { ", \"in_paths\": false" } else { "" };
    format!(
        r##"{{
  "format": "inbetween.scene",
  "version": {version},
  "name": "spin",
  "eyes": ["sky", "top"],
  "vertical_fov_degrees": 50,
  "nodes": [
    {{ "name": "sky", "translation": [0, 0.25, 8] }},
    {{
      "name": "hub",
      "control": {{ "translation": [[0, [0, 1, 0]], [2, [0, 2, 0]]], "rotation": [[0, {{ "euler_degrees": [0, 0, 0] }}], [4, [0, 0, 0.6, 0.8]]], "scale": [[1, 2]] }}{in_paths},
      "children": [
        {{ "name": "ball", "shape": {{ "sphere": {{ "radius": 0.5 }} }}, "colour": "#f5b642", "colour_keys": [[0, "#f7c04a"], [2.5, "#f39a3a"]] }},
        {{ "name": "box", "shape": {{ "box": {{ "size": [1, 2, 3], "bevel": 0.05 }} }}, "scale": 2 }}
      ]
    }},
    {{
      "name": "top", "translation": [0, 3, 0], "rotation": [0, 0, 0, 1],
      "children": [
        {{ "name": "rod", "shape": {{ "cylinder": {{ "radius": 0.1, "height": 2 }} }}, "scale": [1, 2, 1] }},
        {{ "name": "tip", "shape": {{ "cone": {{ "radius": 0.2, "height": 0.4 }} }} }},
        {{ "name": "pill", "shape": {{ "capsule": {{ "radius": 0.2, "height": 0.6 }} }} }},
        {{ "name": "floor", "shape": {{ "plane": {{ "size": [9, 7] }} }} }}
      ]
    }}
  ]
}}
"##
    )
}

/// A scene with a mesh of one triangle.
fn mesh() -> String {
    let triangle = TriangleMesh {
        positions: vec![Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, -1.0, 0.0), Vec3::new(0.0, 1.0, 0.0)],
        normals: vec![Vec3::Z; 3],
        indices: vec![0, 1, 2],
        ..TriangleMesh::empty("triangle")
    };
    let uri = data_uri("model/gltf-binary", &MeshLibrary::to_glb(&[triangle]));
    let (head, nodes) = (format!("\"meshes\": \"{uri}\",\n  \"nodes\""), "\"mesh\": { \"name\": \"triangle\" }");
    scene(3).replacen("\"nodes\"", &head, 1).replacen("\"cylinder\": { \"radius\": 0.1, \"height\": 2 }", nodes, 1)
}

/// Samples that hold keyframe 1 of four until key time 1.
fn samples() -> String {
    let mut text = String::from("key_time,rbt_ind,tx,ty,tz,rw,rx,ry,rz\n");
    for (key_time, keyframe) in [("0", 1), ("0.5", 1), ("1", 2)] {
        for node in 0..22 {
            let _ = writeln!(text, "{key_time},{node},{}", row(keyframe, node).join(","));
        }
    }
    text
}

/// Keyframes in which everything moves.
fn made() -> Vec<Vec<student::Placed>> {
    student::keyframes(7, 8, NODES.len())
}

/// The samples that a program with a mistake shows of the base `animated`; after `catmull-rom` those of a spline.
fn shown(mistake: &str) -> String {
    let (plays_splines, mistake) = mistake.strip_prefix("catmull-rom ").map_or((false, mistake), |rest| (true, rest));
    let keyframes = made();
    let program = student::Student { mistake, plays_splines, keyframes: &keyframes };
    program.samples(6.0, 2000.0, mistake == "integer-tick", 6)
}

const RUBRIC: &str = r#"{
  "format": "inbetween.rubric",
  "version": 1,
  "title": "Corpus",
  "reference": "reference.json",
  "script": "hotkeys.txt",
  "tolerances": { "translation": 0.001, "rotation_degrees": 0.1 },
  "fps": 4,
  "points": { "readable": 10, "keyframe_count": 5, "each_keyframe": 5, "linear_playback": 20, "catmull_rom_playback": 20, "range_and_end": 5, "script": 5 }
}
"#;

const RUBRIC_TOML: &str = "\
format = \"inbetween.rubric\"
version = 1
title = \"Corpus\"
reference = \"reference.json\"
script = \"hotkeys.txt\"
fps = 4

[points]
readable = 10
each_keyframe = 2.5
script = 5
";

const PICTURES: &str = r#"{
  "format": "inbetween.pictures",
  "version": 1,
  "pictures": [
    { "name": "rest" },
    { "name": "half", "file": "walk.json", "at": 0.5, "size": [64, 48], "samples": 4, "tolerance": 0.01 }
  ]
}
"#;

/// What the first line of the base `hotkeys` leaves of six keyframes.
const TRACE: &str = r#"{"line": 1, "command": "key i", "message": "Imported 6 keyframes from animation.json.", "keyframes": 6, "current": 0, "playing": false, "ms_between_keyframes": 2000, "interpolation": "linear"}
"#;

const JOURNAL: &str = r#"# inbetween.journal 1
# program 0.1.0
# began 1700000000
# keyframes "animation.json"
# scene "two-robots"
scene two-robots "animation.json"
# commands
"#;

const ONE_PICTURE: &str =
    r#"{ "format": "inbetween.pictures", "version": 1, "pictures": [ { "name": "rest", "size": [32, 24] } ] }"#;

const SETTINGS: &str = r#"{
  "format": "inbetween.settings",
  "version": 1,
  "theme": "light",
  "language": "ko",
  "scale_percent": 125,
  "panels": { "side": 300 },
  "keys": { "New keyframe": ["Ctrl+K", "F5"] },
  "recent": ["walk.json"]
}
"#;
