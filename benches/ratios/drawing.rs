//! Goal 4: drawing ten thousand boxes, beside all of them in one instanced draw, neither sorted nor cut, in full detail.

use std::fmt::Write as _;
use std::hint::black_box;

use glam::{Mat3, Quat, Vec2, Vec3};
use inbetween::camera::Camera;
use inbetween::rbt::Rbt;
use inbetween::render::{Arrangement, Gpu, Offscreen, Renderer, default_samples};
use inbetween::scene::{SceneGraph, scene_from_json};

use crate::report::{Report, in_turn};
use inbetween::view::frame_of_scene;

/// Boxes along each side of the grid.
const SIDE: i32 = 100;

/// A scene file of boxes in a grid on the ground, a unit apart.
fn grid() -> SceneGraph {
    let mut text = String::from(
        "{\"format\": \"inbetween.scene\", \"version\": 1, \"name\": \"grid\", \"eyes\": [\"sky\"], \"nodes\": [{\"name\": \"sky\"}",
    );
    for place in 0..SIDE * SIDE {
        let (x, z) = (place % SIDE - SIDE / 2, place / SIDE - SIDE / 2);
        let _ = write!(
            text,
            ", {{\"name\": \"n{place}\", \"translation\": [{x}, 0, {z}], \"children\": [{{\"name\": \"box\", \
             \"shape\": {{\"box\": {{\"size\": [0.7, 0.7, 0.7], \"bevel\": 0.05}}}}, \"colour\": \"#c8553d\"}}]}}"
        );
    }
    text.push_str("]}");
    scene_from_json(&text).expect("a scene")
}

/// A camera in a place that looks at another.
fn looking(from: Vec3, at: Vec3) -> Camera {
    let back = (from - at).normalize();
    let right = Vec3::Y.cross(back).normalize();
    let rotation = Quat::from_mat3(&Mat3::from_cols(right, back.cross(right), back)).normalize();
    Camera {
        world_from_eye: Rbt::new(from, rotation),
        vertical_fov: 60.0_f32.to_radians(),
        size_px: Vec2::new(640.0, 480.0),
    }
}

/// 4. A view that has half of the boxes outside, and one of all.
pub fn boxes(report: &mut Report) {
    let scene = grid();
    let gpu = Gpu::headless().expect("an adapter");
    let views = [
        ("half of the boxes outside", looking(Vec3::new(0.0, 4.0, 8.0), Vec3::new(0.0, 0.0, -10.0)), 0.6),
        ("all boxes in sight", looking(Vec3::new(0.0, 14.0, 92.0), Vec3::new(0.0, -8.0, 0.0)), 0.9),
    ];
    for (what, camera, most) in views {
        let frame = frame_of_scene(&scene, scene.rest_pose(), 0.0, &camera, None);
        let renderers = [Arrangement::SortedAndCut, Arrangement::AsGiven].map(|arrangement| {
            let mut renderer = Renderer::new(&gpu, Offscreen::FORMAT, default_samples(gpu.is_software));
            renderer.set_arrangement(arrangement);
            renderer
        });
        let [mut ours, mut theirs] = renderers;
        let targets = [(), ()].map(|()| Offscreen::new(&gpu, 640, 480).expect("a target"));
        let [mut our_target, mut their_target] = targets;
        let picture = our_target.render(&gpu, &mut ours, &frame).expect("a picture");
        ours.set_arrangement(Arrangement::Sorted);
        assert!(picture == our_target.render(&gpu, &mut ours, &frame).expect("a picture"), "the cut changes no byte");
        ours.set_arrangement(Arrangement::SortedAndCut);
        let mut draw_ours = || {
            black_box(our_target.render(&gpu, &mut ours, &frame)).expect("a picture");
        };
        let mut draw_theirs = || {
            black_box(their_target.render(&gpu, &mut theirs, &frame)).expect("a picture");
        };
        let [ours, theirs] = in_turn(30, [&mut draw_ours, &mut draw_theirs]);
        report.at_most(&format!("a picture with {what}"), ours, theirs, most);
    }
}
