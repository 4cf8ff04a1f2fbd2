//! Pictures of meshes: against what they must look like, and against each other.

use glam::Vec2;
use inbetween::camera::Camera;
use inbetween::flip::{DEFAULT_TOLERANCE, compare};
use inbetween::frame::Frame;
use inbetween::keyframe::{Keyframe, KeyframeList};
use inbetween::model::{Material, TriangleMesh};
use inbetween::rbt::Rbt;
use inbetween::render::{Arrangement, Gpu, Image, Offscreen, Renderer, Skinning, node_picture};
use inbetween::scene::SceneGraph;
use inbetween::view::{Neighbours, add_ghosts, frame_of_scene};

use super::golden::check_golden;
use super::models::{add_square, ball, bar, bent, coloured, cube, ring, scene, squares};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 240;

struct Studio {
    gpu: Gpu,
    renderer: Renderer,
    offscreen: Offscreen,
}

impl Studio {
    fn new() -> Self {
        let gpu = Gpu::headless().expect("a GPU adapter");
        let renderer = Renderer::new(&gpu, Offscreen::FORMAT, 1);
        let offscreen = Offscreen::new(&gpu, WIDTH, HEIGHT).expect("a target");
        Self { gpu, renderer, offscreen }
    }

    fn draw(&mut self, frame: &Frame) -> Image {
        self.offscreen.render(&self.gpu, &mut self.renderer, frame).expect("a picture")
    }
}

fn frame(scene: &SceneGraph) -> Frame {
    let pose = scene.rest_pose();
    let camera = Camera {
        world_from_eye: scene.world_from_rbt(pose, 0.0, scene.eyes()[0]),
        vertical_fov: scene.vertical_fov(),
        size_px: Vec2::new(WIDTH as f32, HEIGHT as f32),
    };
    frame_of_scene(scene, pose, 0.0, &camera, None)
}

/// Nodes before an eye over a ground.
fn seen(nodes: &str) -> String {
    format!(
        r##"[{{"name": "sky", "translation": [0, 1.6, 5.5], "rotation": {{"euler_degrees": [0, 0, -14]}}}},
        {{"name": "ground", "translation": [0, -1.5, 0], "children": [{{"name": "plane", "shape": {{"plane": {{"size": [60, 60]}}}}, "colour": "#7d8791"}}]}},
        {nodes}]"##
    )
}

fn placed(name: &str, mesh: &str, more: &str) -> String {
    format!(r#"{{"name": "{name}", "shape": {{"mesh": {{"name": "{mesh}"}}}}, {more}}}"#)
}

fn with_material(mesh: TriangleMesh, change: impl FnOnce(&mut Material)) -> TriangleMesh {
    let mut mesh = mesh;
    change(&mut mesh.material);
    mesh
}

/// A textured cube, a ball with vertex colours, one without light, and one of metal.
fn materials() -> SceneGraph {
    let meshes = [
        with_material(cube("cube"), |material| material.texture = Some(squares())),
        coloured(ball("coloured", 24)),
        with_material(ball("unlit", 24), |material| material.is_unlit = true),
        with_material(ball("metal", 24), |material| (material.metallic, material.roughness) = (1.0, 0.3)),
        with_material(ball("glow", 24), |material| material.emissive = glam::Vec3::new(0.1, 0.4, 0.1)),
    ];
    let nodes = [
        placed("cube", "cube", r##""translation": [-2.2, -0.6, 0], "rotation": {"euler_degrees": [0, 30, 0]}, "scale": 0.85, "colour": "#ffffff""##),
        placed("coloured", "coloured", r##""translation": [0, 0.4, 0], "scale": 0.7, "colour": "#ffffff""##),
        placed("unlit", "unlit", r##""translation": [1.6, 0.4, 0], "scale": 0.7, "colour": "#3d7cc8""##),
        placed("metal", "metal", r##""translation": [0.2, -1, 1], "scale": 0.5, "colour": "#e0b050""##),
        placed("glow", "glow", r##""translation": [1.6, -1, 1], "scale": 0.5, "colour": "#406080""##),
        r##"{"name": "own", "shape": {"sphere": {"radius": 0.5}}, "translation": [2.9, -1, 0.6], "colour": "#c8553d"}"##.to_owned(),
        placed("as-own", "plain", r##""translation": [2.7, 0.4, 0.6], "scale": 0.5, "colour": "#c8553d""##),
    ];
    let mut all = meshes.to_vec();
    all.push(ball("plain", 24));
    scene(&all, &seen(&nodes.join(",")))
}

/// Open surfaces: a ring with a hole seen from both sides, one that is seen from the front alone, and a roof.
fn open() -> SceneGraph {
    let square = |name: &str| {
        let mut square = TriangleMesh::empty(name);
        add_square(&mut square, glam::Vec3::ZERO, glam::Vec3::X, glam::Vec3::Y);
        square
    };
    let meshes = [
        with_material(square("ring"), |material| {
            (material.texture, material.alpha_cutoff, material.is_double_sided) = (Some(ring()), Some(0.5), true);
        }),
        square("front"),
        with_material(square("both"), |material| material.is_double_sided = true),
    ];
    let turned = |degrees: f32| format!(r#""rotation": {{"euler_degrees": [0, {degrees}, 0]}}"#);
    let nodes = [
        placed("ring", "ring", &format!(r##""translation": [-2.2, -0.3, 0], {}, "colour": "#ffffff""##, turned(20.0))),
        placed("behind", "ring", &format!(r##""translation": [0, -0.3, 0], {}, "colour": "#ffffff""##, turned(200.0))),
        placed(
            "front",
            "front",
            &format!(r##""translation": [2.2, -0.3, -1], {}, "colour": "#c8553d""##, turned(180.0)),
        ),
        placed(
            "roof",
            "both",
            r##""translation": [2, -0.5, 0.6], "rotation": {"euler_degrees": [0, 0, 75]}, "scale": 0.7, "colour": "#3d7cc8""##,
        ),
    ];
    scene(&meshes, &seen(&nodes.join(",")))
}

/// Bars with a skin, bent by different angles.
fn bars() -> SceneGraph {
    let nodes = [bent("a", -2.4, 0.0), bent("b", -0.6, 45.0), bent("c", 1.8, 100.0)].join(",");
    scene(&[bar("bar", 24, 16)], &seen(&nodes))
}

/// A bar with a skin, a ring with a hole and a cube, the first two with an outline, and where the next keyframe has them.
fn ghosts() -> Frame {
    let mut ring_mesh = TriangleMesh::empty("ring");
    add_square(&mut ring_mesh, glam::Vec3::ZERO, glam::Vec3::X, glam::Vec3::Y);
    (ring_mesh.material.texture, ring_mesh.material.alpha_cutoff) = (Some(ring()), Some(0.5));
    let carried = |name: &str, x: f32, shape: &str| {
        format!(r#"{{"name": "{name}", "translation": [{x}, -0.4, 0], "children": [{shape}]}}"#)
    };
    let nodes = [
        bent("arm", -2.0, 0.0),
        carried("leaf", 0.0, &placed("ring", "ring", r##""scale": 0.8, "colour": "#ffffff""##)),
        carried("die", 2.2, &placed("cube", "cube", r##""scale": 0.6, "colour": "#3d7cc8""##)),
    ];
    let scene = scene(&[bar("bar", 24, 16), ring_mesh, cube("cube")], &seen(&nodes.join(",")));
    let mut next = scene.rest_pose().clone();
    let mut turn = |path: &str, moved: glam::Vec3, angle: f32| {
        let rbt = scene.find_rbt(path).expect("it is there");
        let before = next.get(rbt);
        next.set(rbt, Rbt::new(before.translation + moved, before.rotation * glam::Quat::from_rotation_z(angle)));
    };
    turn("arm/upper", glam::Vec3::ZERO, -1.0);
    turn("leaf", glam::Vec3::new(0.5, 0.6, -0.5), 0.0);
    turn("die", glam::Vec3::new(0.4, 0.9, 0.0), 0.5);
    let keyframes = KeyframeList::new(vec![Keyframe::new(scene.rest_pose().clone()), Keyframe::new(next)]);
    let mut frame = frame(&scene);
    let neighbours = Neighbours { keyframes: &keyframes, from: [0, 0], count: 1, only: &[] };
    add_ghosts(&mut frame, &scene, 0.0, neighbours);
    for item in &mut frame.items {
        let path = &scene.nodes()[item.node as usize].path;
        item.outlined = path.starts_with("arm") || path.starts_with("leaf");
    }
    frame
}

#[test]
fn meshes_look_as_they_did() {
    let mut studio = Studio::new();
    for (name, scene) in [("mesh-materials", materials()), ("mesh-open", open()), ("mesh-bars", bars())] {
        check_golden(name, &studio.draw(&frame(&scene)));
    }
    let ghosts = ghosts();
    assert_eq!(ghosts.ghosts.len(), 3);
    check_golden("mesh-ghosts", &studio.draw(&ghosts));
}

#[test]
fn what_is_culled_and_sorted_is_the_same_picture() {
    let mut studio = Studio::new();
    for mut frame in [frame(&materials()), frame(&open()), frame(&bars()), ghosts()] {
        for item in frame.items.iter_mut().step_by(3) {
            item.outlined = true;
        }
        let culled = studio.draw(&frame);
        studio.renderer.set_arrangement(Arrangement::Sorted);
        assert!(studio.draw(&frame) == culled);
        studio.renderer.set_arrangement(Arrangement::default());
    }
}

#[test]
fn skins_look_the_same_whoever_moves_them() {
    let mut studio = Studio::new();
    let mut frame = frame(&bars());
    frame.items.iter_mut().filter(|item| item.node % 2 == 1).for_each(|item| item.outlined = true);
    let pictures = [Skinning::Processor, Skinning::Shader].map(|skinning| {
        studio.renderer.set_skinning(skinning);
        studio.draw(&frame)
    });
    let found = compare(&pictures[0], &pictures[1]).expect("they are of one size");
    assert!(found.scores().is_within(DEFAULT_TOLERANCE), "{:?}", found.scores());
}

/// The identity picture names the node that a pixel shows: where all other nodes are hidden the pixel stays.
#[test]
fn the_identity_picture_shows_what_the_picture_shows() {
    let studio = Studio::new();
    for scene in [materials(), open(), bars()] {
        let whole = frame(&scene);
        let identities = node_picture(&studio.gpu, &whole, WIDTH, HEIGHT).expect("a picture");
        let nodes: Vec<u32> = whole.items.iter().filter(|item| !item.is_ground()).map(|item| item.node).collect();
        for node in nodes {
            let mut without = whole.clone();
            without.items.retain(|item| item.node != node);
            let without = node_picture(&studio.gpu, &without, WIDTH, HEIGHT).expect("a picture");
            for (with, without) in identities.iter().zip(&without) {
                // What is shown without the node was shown with it too, or the node hid it.
                assert!(*with == *without || *with == node + 1);
            }
            let is_shown = identities.contains(&(node + 1));
            let is_away = scene.nodes()[node as usize].name == "front";
            assert_eq!(is_shown, !is_away, "{}", scene.nodes()[node as usize].path);
        }
    }
}
