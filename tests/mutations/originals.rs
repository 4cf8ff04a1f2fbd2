//! Good inputs of every kind.

use std::io::{Cursor, Write as _};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use glam::{Affine3A, Vec2, Vec3, Vec4};
use inbetween::editor::{Command, Editor, FileAccess, FileCommand};
use inbetween::gltf::data_uri;
use inbetween::interpolation::Interpolation;
use inbetween::journal::Writer;
use inbetween::keyframe::{Keyframe, KeyframeList, keyframes_to_json};
use inbetween::model::{Material, MeshLibrary, Skin, TriangleMesh};
use inbetween::picture::Image;
use inbetween::scene::{built_in_scene, built_in_scene_names, scene_to_json};
use inbetween::script::{self, Action};
use inbetween::settings::Settings;
use inbetween::storage::Log;
use inbetween::text_layouts::{Imported, Options, import};
use zip::write::SimpleFileOptions;

use super::samples;

pub const SCENE: &str = r##"{
  "format": "inbetween.scene", "version": 2, "name": "spin", "eyes": ["sky", "top"], "vertical_fov_degrees": 50,
  "nodes": [
    { "name": "sky", "translation": [0, 0.25, 8] },
    { "name": "hub", "control": { "translation": [[0, [0, 1, 0]], [2, [0, 2, 0]]],
      "rotation": [[0, { "euler_degrees": [0, 0, 0] }], [4, [0, 0, 0.6, 0.8]]], "scale": [[1, 2]] }, "in_paths": false,
      "children": [
        { "name": "ball", "shape": { "sphere": { "radius": 0.5 } }, "colour": "#f5b642", "colour_keys": [[0, "#f7c04a"], [2.5, "#f39a3a"]] },
        { "name": "box", "shape": { "box": { "size": [1, 2, 3], "bevel": 0.05 } }, "scale": 2 }
      ] },
    { "name": "top", "translation": [0, 3, 0], "rotation": [0, 0, 0, 1],
      "children": [
        { "name": "rod", "shape": { "cylinder": { "radius": 0.1, "height": 2 } }, "scale": [1, 2, 1] },
        { "name": "tip", "shape": { "cone": { "radius": 0.2, "height": 0.4 } } },
        { "name": "pill", "shape": { "capsule": { "radius": 0.2, "height": 0.6 } } },
        { "name": "floor", "shape": { "plane": { "size": [9, 7] } } }
      ] }
  ]
}
"##;

pub const SCRIPT: &str = "key n\nselect robot1/head\ntranslate 1 0 0\nrotate x 30\nkey n\nput-control robot1\nundo\nput-control robot2\n\
    drag begin\ndrag move 0 1 0\ndrag end\nkey n\nwait 700ms\nrename 0 the #1\nkey n\nkey n\nkey y\nwait 2s\nkey w\nkey i\n# no line\n\
    screenshot a.png\nsave-scene scene.json\nkey ctrl+z\n";

pub const PICTURES: &str = r#"{ "format": "inbetween.pictures", "version": 1, "pictures": [
    { "name": "rest" },
    { "name": "half", "file": "walk.json", "at": 0.5, "size": [64, 48], "samples": 4, "tolerance": 0.01, "camera": "turntable" } ] }
"#;

pub const TRACE: &str = r#"{"line": 1, "command": "key n", "message": "Keyframe 0", "keyframes": 1, "current": 0, "playing": false, "key_time": null, "ms_between_keyframes": 2000, "interpolation": "linear"}
{"line": 2, "command": "key n", "message": "", "keyframes": 2, "current": 1, "playing": true, "key_time": 0.25, "ms_between_keyframes": 2000, "interpolation": "catmull-rom"}
"#;

pub fn rubrics() -> [Vec<u8>; 2] {
    ["rubric.json", "rubric.toml"].map(|name| {
        let text = std::fs::read_to_string(grading().join(name)).expect("it is in the package");
        text.into_bytes()
    })
}

/// The folder of the package that has a rubric and what it names.
pub fn grading() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/grading")
}

/// Keyframe files of both versions.
pub fn keyframe_files() -> Vec<Vec<u8>> {
    let scene = samples::scene();
    let text = samples::texts(&samples::keyframes(3), false).remove(0).text;
    let Ok(Imported::Text(file, _)) = import(text.as_bytes(), &scene, &Options::default()) else {
        panic!("it is a text of keyframes")
    };
    let json = |keyframes: Vec<Keyframe>| {
        keyframes_to_json(&scene, &KeyframeList::new(keyframes), Interpolation::CatmullRom, 1500).into_bytes()
    };
    let mut named = file.keyframes.clone();
    named[0].name = Some("걷기".into());
    named[1].duration = 2.5;
    vec![json(file.keyframes), json(named), json(Vec::new())]
}

pub fn texts() -> Vec<Vec<u8>> {
    let keyframes = samples::keyframes(2);
    let texts = samples::texts(&keyframes, false).into_iter().chain(samples::texts(&keyframes, true));
    let mut texts: Vec<Vec<u8>> = texts.map(|sample| sample.text.into_bytes()).collect();
    texts.push(samples::matrices(&keyframes[..1]).into_bytes());
    texts.extend(samples::variants(&keyframes).into_iter().map(String::into_bytes));
    let headless = keyframes.iter().map(|rows| [&rows[..11], &rows[12..21]].concat()).collect::<Vec<_>>();
    texts.extend(samples::variants(&headless).into_iter().take(2).map(String::into_bytes));
    texts
}

/// Programs with keys: the course's way, and whatever else the reader knows.
pub fn programs() -> Vec<Vec<u8>> {
    vec![samples::PYTHON.into(), PROGRAM.into()]
}

const PROGRAM: &str = r#"#!/usr/bin/env python3
"""Birds."""
import numpy as np
from animation import KeyFrameControlNode, TransformKeyFrames

height, turn = 2.5, quaternion_from_axis_angle(vec(0, 1, 0), degrees=90)
names = [f"bird {i!r:>{width}}" for i in range(3) if i]

@decorated(lambda a, *b, c=1: a or not b)
class Bird(Node):
    def __init__(self, *args, speed: float = 1.0, **params):
        super().__init__({0: vec(0, height, 0)}, {0: turn, 2: -turn}, {0: 1, 2: 0}, **params)
        self.keys = {}
        self.keys[np.pi / 2] = np.array([1, 2 ** -1, 7 // 2 % 3], 'f') * 2 + vec(*(1, 0, 0))
        node = KeyFrameControlNode(self.keys, [(0, quaternion_mul(turn, turn))], dict({0: vec(2)}))

def main(camera):
    for i in range(8):
        keys = {i: vec(camera.x + 3, i, 0)}
        if i > 4 and keys: keys.update(others)
    try:
        with open("a") as file: moved = TransformKeyFrames(translate_keys=keys, rotate_keys={}, scale_keys={1: .5})
    except (KeyError, ValueError) as error:
        match error:
            case [a, *_] | {"b": a}: return (yield a)
    else:
        global height; height += 1; del keys[0]
"#;

pub fn scenes() -> Vec<Vec<u8>> {
    let built_in = built_in_scene_names().filter_map(built_in_scene).map(|scene| scene_to_json(&scene).into_bytes());
    built_in.chain([SCENE.as_bytes().to_vec(), mesh_scene().into_bytes()]).collect()
}

/// A scene with a mesh of one triangle that two joints move.
fn mesh_scene() -> String {
    let triangle = TriangleMesh {
        name: "triangle".to_owned(),
        positions: vec![Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, -1.0, 0.0), Vec3::new(0.0, 1.0, 0.0)],
        normals: vec![Vec3::Z; 3],
        colours: vec![Vec4::ONE; 3],
        texture_coordinates: vec![Vec2::ZERO, Vec2::X, Vec2::Y],
        indices: vec![0, 1, 2],
        material: Material { alpha_cutoff: Some(0.5), ..Material::default() },
        skin: Some(Skin {
            joints: vec![[0, 1, 0, 0]; 3],
            weights: vec![[0.25, 0.75, 0.0, 0.0]; 3],
            joint_from_shape: vec![Affine3A::IDENTITY; 2],
        }),
    };
    let uri = data_uri("model/gltf-binary", &MeshLibrary::to_glb(&[triangle]));
    format!(
        r#"{{"format": "inbetween.scene", "version": 3, "name": "mesh", "eyes": ["sky"], "meshes": "{uri}", "nodes": [
        {{"name": "sky", "children": [{{"name": "a", "control": {{}}, "children": []}}]}},
        {{"name": "skin", "shape": {{"mesh": {{"name": "triangle", "joints": ["sky", "sky/a"]}}}}}}]}}"#
    )
}

pub fn settings() -> Vec<Vec<u8>> {
    let mut settings = Settings::default();
    settings.keys.insert("keyframe-new".to_owned(), vec!["Ctrl+K".to_owned(), "F5".to_owned()]);
    settings.used(Path::new("folder/걷기.json"));
    settings.resized("side", Some(300.0));
    vec![settings.to_json().into_bytes()]
}

/// A journal of the script, as the window writes it.
pub fn journals(folder: &Path) -> Vec<Vec<u8>> {
    let scene = samples::scene();
    let lines = script::parse(SCRIPT.as_bytes(), &scene).expect("it is a script");
    let path = folder.join("a.journal");
    let mut editor = Editor::new(Arc::new(scene), PathBuf::from("a.json"));
    let mut journal = Writer::begin(Log::create(&path, |_| true).expect("the folder is writable"), &editor);
    for line in lines {
        if let Action::Apply(command) = line.action {
            journal.command(&editor, &command);
            let is_import = command == Command::File(FileCommand::Import);
            let _ = editor.apply(command);
            if is_import {
                let bytes = keyframe_files().remove(2);
                journal.read(FileAccess::KeyframesRead, Path::new("a.json"), &bytes);
                let _ = editor.keyframes_read(Path::new("a.json"), Ok(bytes));
            }
        } else {
            let was_playing = editor.is_playing();
            editor.tick(40);
            journal.ticked(was_playing, &editor, 40);
        }
    }
    drop(journal);
    vec![std::fs::read(path).expect("it was written")]
}

pub fn pngs() -> Vec<Vec<u8>> {
    let image = |opacity: u8| {
        let pixel = |index: u32| [index as u8, (index / 7) as u8, 90, opacity];
        Image { width: 20, height: 9, rgba: (0..180).flat_map(pixel).collect() }
    };
    let mut deep = Vec::new();
    let grey = image::ImageBuffer::<image::Luma<u16>, _>::from_fn(9, 9, |x, y| image::Luma([(x * y * 700) as u16]));
    grey.write_to(&mut Cursor::new(&mut deep), image::ImageFormat::Png).expect("memory takes it");
    vec![image(255).to_png().expect("a PNG"), image(9).to_png().expect("a PNG"), deep]
}

pub fn zips() -> Vec<Vec<u8>> {
    let zip = |method| {
        let mut bytes = Vec::new();
        let mut zip = zip::ZipWriter::new(Cursor::new(&mut bytes));
        let options = SimpleFileOptions::default().compression_method(method);
        for (name, content) in [
            ("keys/a.json", keyframe_files().remove(1)),
            ("trace.jsonl", TRACE.into()),
            ("notes.md", vec![b'a'; 50_000]),
        ] {
            zip.start_file(name, options).expect("it is a name");
            zip.write_all(&content).expect("memory takes it");
        }
        zip.finish().expect("memory takes it");
        bytes
    };
    vec![zip(zip::CompressionMethod::Deflated), zip(zip::CompressionMethod::Stored)]
}
