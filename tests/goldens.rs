//! Golden images: few and small, drawn without a window and compared by what an eye would notice.
//!
//! `UPDATE_GOLDENS=1 cargo test --test goldens` takes what is drawn now. A missing golden fails. A failure writes what was drawn and the
//! difference under `target/goldens/`.

#[path = "common/golden.rs"]
mod golden;

use glam::{Quat, Vec2, Vec3};
use inbetween::camera::Camera;
use inbetween::flip::{DEFAULT_TOLERANCE, compare};
use inbetween::interpolation::Interpolation;
use inbetween::keyframe::{Keyframe, KeyframeList, PlayRange};
use inbetween::pose::Pose;
use inbetween::render::{Gpu, Image, Offscreen, Renderer};
use inbetween::scene::{SceneGraph, built_in_scene};
use inbetween::view::frame_of_scene;

use golden::check_golden;

const WIDTH: u16 = 320;
const HEIGHT: u16 = 240;

fn draw(scene: &SceneGraph, pose: &Pose, seconds: f64) -> Image {
    let gpu = Gpu::headless().expect("a GPU adapter");
    let mut renderer = Renderer::new(&gpu, Offscreen::FORMAT, 1);
    let mut offscreen = Offscreen::new(&gpu, WIDTH.into(), HEIGHT.into()).expect("a target");
    let camera = Camera {
        world_from_eye: scene.world_from_rbt(pose, seconds, scene.eyes()[0]),
        vertical_fov: scene.vertical_fov(),
        size_px: Vec2::new(WIDTH.into(), HEIGHT.into()),
    };
    let frame = frame_of_scene(scene, pose, seconds, &camera, None);
    offscreen.render(&gpu, &mut renderer, &frame).expect("a picture")
}

/// The two robots in the middle of waving, by Catmull-Rom, so many ticks past key time 0.4.
fn waving(ticks: u32) -> Image {
    let scene = built_in_scene("two-robots").expect("it is built in");
    let waved = [0.0, 0.3, 1.2, 0.6_f32].map(|lift| {
        let mut pose = scene.rest_pose().clone();
        for (path, angle) in [
            ("robot1/right_shoulder", lift),
            ("robot1/right_shoulder/right_elbow", 0.7 * lift),
            ("robot2/left_shoulder", -lift),
        ] {
            let rbt = scene.find_rbt(path).expect("robots have arms");
            let mut parent_from_node = pose.get(rbt);
            parent_from_node.rotation = Quat::from_axis_angle(Vec3::Z, angle);
            pose.set(rbt, parent_from_node);
        }
        Keyframe::new(pose)
    });
    let list = KeyframeList::new(waved.into());
    let range = PlayRange::new(&list).expect("four keyframes play");
    let key_time = 0.4 + f64::from(ticks) * (1000.0 / 60.0) / 2000.0;
    draw(&scene, &range.pose_at(key_time, Interpolation::CatmullRom).expect("it is in the range"), 0.0)
}

fn rest() -> Image {
    let scene = built_in_scene("two-robots").expect("it is built in");
    draw(&scene, scene.rest_pose(), 0.0)
}

fn cylinder(seconds: f64) -> Image {
    let scene = built_in_scene("cylinder").expect("it is built in");
    draw(&scene, scene.rest_pose(), seconds)
}

#[test]
fn two_robots_at_rest() {
    check_golden("rest", &rest());
}

#[test]
fn the_cylinder_at_a_second_and_a_half() {
    check_golden("cylinder", &cylinder(1.5));
}

#[test]
fn two_robots_in_between() {
    check_golden("waving", &waving(0));
}

#[test]
fn the_picture_one_tick_later_is_another() {
    for (now, next) in [(waving(0), waving(1)), (cylinder(1.5), cylinder(1.5 + 1.0 / 60.0))] {
        let score = compare(&now, &next).expect("one size").scores().score;
        assert!(score > 2.0 * DEFAULT_TOLERANCE, "one tick later scores {score}");
    }
}

#[test]
fn what_nobody_sees_is_no_difference() {
    let rest = rest();
    let mut noisy = rest.clone();
    // One level up or down, from pixel to pixel by a fixed noise.
    let mut state = 1_u32;
    for channel in &mut noisy.rgba {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        *channel = match state >> 30 {
            0 => channel.saturating_sub(1),
            1 => channel.saturating_add(1),
            _ => *channel,
        };
    }
    for alpha in noisy.rgba.iter_mut().skip(3).step_by(4) {
        *alpha = 255;
    }
    let mut brighter = rest.clone();
    for pixel in brighter.rgba.chunks_exact_mut(4) {
        pixel[..3].iter_mut().for_each(|channel| *channel = channel.saturating_add(1));
    }
    for changed in [noisy, brighter] {
        let score = compare(&rest, &changed).expect("one size").scores().score;
        assert!(score < DEFAULT_TOLERANCE, "what nobody sees scores {score}");
    }
}
