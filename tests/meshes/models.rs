//! Small models, made here, and scenes of them.

use std::f32::consts::{PI, TAU};
use std::sync::Arc;

use glam::{Affine3A, Vec2, Vec3, Vec4};
use inbetween::gltf::data_uri;
use inbetween::model::{MeshLibrary, Skin, Texture, TriangleMesh, Wrap};
use inbetween::picture::Image;
use inbetween::scene::{SceneGraph, scene_from_json};

/// Adds a square around a middle, `u` and `v` from there to the middles of its sides, seen from where `u`, `v` and the eye are
/// right-handed.
pub fn add_square(mesh: &mut TriangleMesh, middle: Vec3, u: Vec3, v: Vec3) {
    let first = mesh.positions.len() as u32;
    for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
        mesh.positions.push(middle + u * x + v * y);
        mesh.normals.push(u.cross(v).normalize());
        mesh.texture_coordinates.push(Vec2::new(0.5 + 0.5 * x, 0.5 - 0.5 * y));
    }
    mesh.indices.extend([0, 1, 2, 0, 2, 3].map(|corner| first + corner));
}

/// A cube with sides of 2.
pub fn cube(name: &str) -> TriangleMesh {
    let mut cube = TriangleMesh::empty(name);
    for (u, v) in [
        (Vec3::X, Vec3::Y),
        (Vec3::Y, Vec3::X),
        (Vec3::Y, Vec3::Z),
        (Vec3::Z, Vec3::Y),
        (Vec3::Z, Vec3::X),
        (Vec3::X, Vec3::Z),
    ] {
        add_square(&mut cube, u.cross(v), u, v);
    }
    cube
}

/// A ball of radius 1.
pub fn ball(name: &str, rings: u32) -> TriangleMesh {
    let around = 2 * rings;
    let mut ball = TriangleMesh::empty(name);
    for ring in 0..=rings {
        for step in 0..=around {
            let (up, turn) = (PI * ring as f32 / rings as f32, TAU * step as f32 / around as f32);
            let at = Vec3::new(up.sin() * turn.cos(), up.cos(), -up.sin() * turn.sin());
            ball.positions.push(at);
            ball.normals.push(at);
            ball.texture_coordinates.push(Vec2::new(step as f32 / around as f32, ring as f32 / rings as f32));
        }
    }
    for ring in 0..rings {
        for step in 0..around {
            let [a, b] = [ring, ring + 1].map(|ring| ring * (around + 1) + step);
            ball.indices.extend([a, b, b + 1, a, b + 1, a + 1]);
        }
    }
    ball
}

/// A bar of radius 0.25 along y from -1.5 to 1.5. Its skin has two joints: one at its lower end and one in its middle.
pub fn bar(name: &str, rings: u32, around: u32) -> TriangleMesh {
    let mut bar = TriangleMesh::empty(name);
    let mut skin = Skin {
        joints: Vec::new(),
        weights: Vec::new(),
        joint_from_shape: vec![Affine3A::from_translation(Vec3::Y * 1.5), Affine3A::IDENTITY],
    };
    for ring in 0..=rings {
        let y = 3.0 * ring as f32 / rings as f32 - 1.5;
        let upper = (0.5 + y).clamp(0.0, 1.0);
        for step in 0..around {
            let turn = TAU * step as f32 / around as f32;
            let outwards = Vec3::new(turn.cos(), 0.0, -turn.sin());
            bar.positions.push(outwards * 0.25 + Vec3::Y * y);
            bar.normals.push(outwards);
            skin.joints.push([0, 1, 0, 0]);
            skin.weights.push([1.0 - upper, upper, 0.0, 0.0]);
        }
    }
    for ring in 0..rings {
        for step in 0..around {
            let next = (step + 1) % around;
            let [a, b] = [ring, ring + 1].map(|ring| ring * around);
            bar.indices.extend([a + step, a + next, b + next, a + step, b + next, b + step]);
        }
    }
    bar.skin = Some(skin);
    bar
}

/// A texture whose pixels are these.
pub fn texture(side: u32, pixel: impl Fn(u32, u32) -> [u8; 4]) -> Arc<Texture> {
    let pixels: Vec<u8> = (0..side * side).flat_map(|at| pixel(at % side, at / side)).collect();
    let image = Image { width: side, height: side, rgba: pixels.clone() };
    Arc::new(Texture {
        file: image.to_png().expect("a PNG").into(),
        media_type: "image/png",
        size_px: [side, side],
        pixels: pixels.into(),
        wrap: [Wrap::Repeat; 2],
        is_pixelated: false,
    })
}

/// Squares of two colours, 8 by 8, with the upper left one blue.
pub fn squares() -> Arc<Texture> {
    texture(64, |x, y| match (x / 8, y / 8) {
        (0, 0) => [40, 80, 220, 255],
        (x, y) if (x + y) % 2 == 0 => [230, 220, 200, 255],
        _ => [180, 60, 40, 255],
    })
}

/// A ring on a clear ground.
pub fn ring() -> Arc<Texture> {
    texture(64, |x, y| {
        let from_middle = Vec2::new(x as f32 - 31.5, y as f32 - 31.5).length();
        [60, 150, 70, if (14.0..30.0).contains(&from_middle) { 255 } else { 0 }]
    })
}

/// A colour for each vertex by its place.
pub fn coloured(mut mesh: TriangleMesh) -> TriangleMesh {
    mesh.colours = mesh.positions.iter().map(|at| (*at * 0.5 + 0.5).extend(1.0)).collect::<Vec<Vec4>>();
    mesh
}

/// The bytes of a file of meshes.
pub fn glb(meshes: &[TriangleMesh]) -> Vec<u8> {
    MeshLibrary::to_glb(meshes)
}

/// The text of a scene with its meshes within. `nodes` is a JSON list.
pub fn text_within(meshes: &[TriangleMesh], nodes: &str) -> String {
    text(&data_uri("model/gltf-binary", &glb(meshes)), nodes)
}

/// The text of a scene that names its meshes so.
pub fn text(meshes: &str, nodes: &str) -> String {
    format!(
        r#"{{"format": "inbetween.scene", "version": 3, "name": "models", "eyes": ["sky"], "meshes": "{meshes}", "nodes": {nodes}}}"#
    )
}

/// A scene of meshes.
#[track_caller]
pub fn scene(meshes: &[TriangleMesh], nodes: &str) -> SceneGraph {
    scene_from_json(&text_within(meshes, nodes)).unwrap_or_else(|error| panic!("{error}"))
}

/// Two joints with a bar, bent by an angle in degrees.
pub fn bent(name: &str, x: f32, degrees: f32) -> String {
    format!(
        r##"{{"name": "{name}", "translation": [{x}, -1.5, 0], "children": [
            {{"name": "upper", "translation": [0, 1.5, 0], "rotation": {{"euler_degrees": [{degrees}, 0, 0]}}, "children": []}},
            {{"name": "skin", "shape": {{"mesh": {{"name": "bar", "joints": ["{name}", "{name}/upper"]}}}}, "colour": "#c8553d"}}]}}"##
    )
}
