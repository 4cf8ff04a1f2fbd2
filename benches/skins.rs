//! What a skinned model of 65,000 triangles and 60 joints costs at 1280x720: `cargo bench --bench skins`.
//!
//! Pictures a second of one model and of ten in ten poses, with the skin moved by the processor and by the vertex shader, and how long
//! reading the model's file takes.

use std::f32::consts::TAU;
use std::fmt::Write as _;
use std::hint::black_box;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use glam::{Affine3A, Mat3, Quat, Vec2, Vec3};
use inbetween::camera::Camera;
use inbetween::frame::Frame;
use inbetween::gltf::data_uri;
use inbetween::model::{MeshLibrary, Skin, TriangleMesh};
use inbetween::rbt::Rbt;
use inbetween::render::{Gpu, Offscreen, Renderer, Skinning, default_samples};
use inbetween::scene::{SceneGraph, scene_from_json};
use inbetween::view::frame_of_scene;

const RINGS: u32 = 508;
const AROUND: u32 = 64;
const JOINTS: u32 = 60;
/// One model may take so long a picture, and reading its file so long in all.
const MOST_A_PICTURE: Duration = Duration::from_millis(50);
const MOST_READING: Duration = Duration::from_secs(1);

/// A bar along y, moved by a chain of joints.
fn bar() -> TriangleMesh {
    let mut mesh = TriangleMesh::empty("bar");
    let (mut joints, mut weights) = (Vec::new(), Vec::new());
    for ring in 0..=RINGS {
        let along = (JOINTS - 1) as f32 * ring as f32 / RINGS as f32;
        let (joint, share) = ((along as u32).min(JOINTS - 2), along - along.floor());
        for step in 0..AROUND {
            let turn = TAU * step as f32 / AROUND as f32;
            let outwards = Vec3::new(turn.cos(), 0.0, -turn.sin());
            mesh.positions.push(outwards * 0.5 + Vec3::Y * (along * 0.1 - 2.95));
            mesh.normals.push(outwards);
            joints.push([joint as u8, joint as u8 + 1, 0, 0]);
            weights.push([1.0 - share, share, 0.0, 0.0]);
        }
    }
    for ring in 0..RINGS {
        for step in 0..AROUND {
            let next = (step + 1) % AROUND;
            let [a, b] = [ring, ring + 1].map(|ring| ring * AROUND);
            mesh.indices.extend([a + step, a + next, b + next, a + step, b + next, b + step]);
        }
    }
    let joint_from_shape =
        (0..JOINTS).map(|joint| Affine3A::from_translation(Vec3::Y * (2.95 - joint as f32 * 0.1))).collect();
    mesh.skin = Some(Skin { joints, weights, joint_from_shape });
    mesh
}

/// The text of a scene of so many bars in a row.
fn text(count: u32) -> String {
    let uri = data_uri("model/gltf-binary", &MeshLibrary::to_glb(&[bar()]));
    let mut text = format!(
        r##"{{"format": "inbetween.scene", "version": 3, "name": "bars", "eyes": ["sky"], "meshes": "{uri}", "nodes": [{{"name": "sky"}},
        {{"name": "ground", "shape": {{"plane": {{"size": [80, 80]}}}}, "colour": "#7d8791"}}"##
    );
    for bar in 0..count {
        let x = (bar as f32 - (count - 1) as f32 * 0.5) * 2.2;
        let _ = write!(text, r#", {{"name": "b{bar}", "translation": [{x}, 0, 0], "children": ["#);
        let mut paths = vec![format!("b{bar}")];
        for joint in 1..JOINTS {
            let _ = write!(text, r#"{{"name": "j{joint}", "translation": [0, 0.1, 0], "children": ["#);
            let path = format!("{}/j{joint}", paths[joint as usize - 1]);
            paths.push(path);
        }
        text.push_str(&"]}".repeat(JOINTS as usize - 1));
        let joints = paths.iter().map(|path| format!("\"{path}\"")).collect::<Vec<_>>().join(", ");
        let _ = write!(
            text,
            r##", {{"name": "skin", "shape": {{"mesh": {{"name": "bar", "joints": [{joints}]}}}}, "colour": "#c8553d"}}]}}"##
        );
    }
    text.push_str("]}");
    text
}

/// The bars bent more and more, each by another angle.
fn frame(scene: &SceneGraph, count: u32, step: u32) -> Frame {
    let mut pose = scene.rest_pose().clone();
    for (rbt, path) in scene.rbt_indices().zip(scene.rbt_paths()) {
        if path.contains('/') {
            let bar: u32 = path[1..path.find('/').unwrap_or(path.len())].parse().unwrap_or_default();
            let mut at = pose.get(rbt);
            at.rotation = Quat::from_rotation_z(0.03 * ((step + 7 * bar) as f32 * 0.1).sin());
            pose.set(rbt, at);
        }
    }
    let from = Vec3::new(0.0, 4.0, 7.0 + 1.6 * count as f32);
    let back = (from - Vec3::Y * 3.0).normalize();
    let right = Vec3::Y.cross(back).normalize();
    let rotation = Quat::from_mat3(&Mat3::from_cols(right, back.cross(right), back)).normalize();
    let camera = Camera {
        world_from_eye: Rbt::new(from, rotation),
        vertical_fov: 60.0_f32.to_radians(),
        size_px: Vec2::new(1280.0, 720.0),
    };
    frame_of_scene(scene, &pose, 0.0, &camera, None)
}

fn main() -> ExitCode {
    let gpu = Gpu::headless().expect("an adapter");
    println!("{} triangles, {JOINTS} joints, 1280x720 on {}", 2 * RINGS * AROUND, gpu.info.name);
    let one = text(1);
    let start = Instant::now();
    let scene = scene_from_json(&one).expect("a scene");
    let reading = start.elapsed();
    println!("read in {reading:.0?}");
    let mut is_fast = reading < MOST_READING;
    for (count, scene) in [(1, scene), (10, scene_from_json(&text(10)).expect("a scene"))] {
        for skinning in [Skinning::Processor, Skinning::Shader] {
            let mut renderer = Renderer::new(&gpu, Offscreen::FORMAT, default_samples(gpu.is_software));
            renderer.set_skinning(skinning);
            let mut offscreen = Offscreen::new(&gpu, 1280, 720).expect("a target");
            let mut times = Vec::new();
            for step in 0..24 {
                let start = Instant::now();
                let frame = frame(&scene, count, step);
                drop(black_box(offscreen.render(&gpu, &mut renderer, &frame).expect("a picture")));
                times.push(start.elapsed());
            }
            times.sort();
            let usual = times[times.len() / 2];
            println!("{count} skinned by {skinning:?}: {usual:.1?} a picture, {:.1?} at best", times[0]);
            is_fast &= count > 1 || skinning != Skinning::of_adapter(gpu.is_software) || usual < MOST_A_PICTURE;
        }
    }
    if is_fast { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
