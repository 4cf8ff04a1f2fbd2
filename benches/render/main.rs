//! What a picture costs, against the least that any wgpu program does for one: `cargo bench --bench render`.
//!
//! One more frame in a running program; whole processes are goal 5 of `cargo bench --bench ratios`.

mod bare;
#[path = "../../tests/support/mod.rs"]
mod support;

use std::hint::black_box;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use glam::Vec3;
use inbetween::frame::Frame;
use inbetween::render::{Gpu, Offscreen, Refinement, Refiner, Renderer, Target, Viewport, default_samples};

/// One more frame may take so many times the bare one.
const MOST_FRAME_RATIO: f64 = 14.0;

fn main() -> ExitCode {
    let are_met = [frames(), sub_frames()];
    if are_met.iter().all(|is_met| *is_met) { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// A sub-frame, with its own shadow map and the addition, may take so many times a plain frame in which something moves.
const MOST_SUB_FRAME_RATIO: f64 = 1.3;
/// The sub-frames that are timed together. The driver draws one while the next is made ready, as in a film.
const TOGETHER: u32 = 16;

/// Whether a sub-frame costs no more than it may. Read-back is in neither.
fn sub_frames() -> bool {
    let gpu = Gpu::headless().expect("an adapter");
    let mut renderer = Renderer::new(&gpu, Offscreen::FORMAT, 1);
    let mut refiner = Refiner::new(&gpu, Offscreen::FORMAT, Refinement::of(TOGETHER));
    let target = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width: 640, height: 480, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: Offscreen::FORMAT,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
        view_formats: &[],
    });
    let view = target.create_view(&wgpu::TextureViewDescriptor::default());
    let mut frame = support::frame(support::sample_items().into_iter().map(|(_, item)| item).collect());
    let wait = || gpu.device.poll(wgpu::PollType::wait_indefinitely()).expect("a working device");
    let moved = |frame: &mut Frame| frame.items[9].world_from_shape.translation += glam::Vec3A::from(Vec3::X * 1e-4);
    let mut times = [Vec::new(), Vec::new()];
    for round in 0..44_u16 {
        let mut timed = |which: usize, work: &mut dyn FnMut()| {
            let start = Instant::now();
            work();
            wait();
            if round >= 4 {
                times[which].push(start.elapsed() / TOGETHER);
            }
        };
        timed(0, &mut || {
            for _ in 0..TOGETHER {
                moved(&mut frame);
                renderer.render(&gpu, &frame, Target { view: &view, viewport: Viewport::whole(640, 480) });
            }
        });
        timed(1, &mut || {
            refiner.restart();
            while refiner.next().is_some() {
                moved(&mut frame);
                refiner.add(&gpu, &mut frame, [640, 480]);
            }
        });
    }
    let [plain, sub_frames] = times;
    report("sub-frame", &sub_frames, "plain", &plain, MOST_SUB_FRAME_RATIO)
}

/// Whether one more frame costs no more than it may.
fn frames() -> bool {
    let bare = bare::Bare::new();
    let gpu = Gpu::headless().expect("an adapter");
    let mut renderer = Renderer::new(&gpu, Offscreen::FORMAT, default_samples(gpu.is_software));
    let mut offscreen = Offscreen::new(&gpu, 640, 480).expect("a target");
    let mut frame = support::frame(support::sample_items().into_iter().map(|(_, item)| item).collect());
    println!("{} shapes on {} ({})", frame.items.len(), gpu.info.name, gpu.info.driver_info);
    // Interleaved, so that whatever else the machine does weighs on all of them.
    let mut times = [Vec::new(), Vec::new(), Vec::new()];
    for round in 0..220_u16 {
        let mut timed = |which: usize, work: &mut dyn FnMut()| {
            let start = Instant::now();
            work();
            if round >= 20 {
                times[which].push(start.elapsed());
            }
        };
        timed(0, &mut || drop(black_box(bare.draw())));
        timed(1, &mut || drop(black_box(offscreen.render(&gpu, &mut renderer, &frame).expect("a picture"))));
        frame.items[9].world_from_shape.translation += glam::Vec3A::from(Vec3::X * 1e-4);
        timed(2, &mut || drop(black_box(offscreen.render(&gpu, &mut renderer, &frame).expect("a picture"))));
        // The next still frame must find the map drawn.
        drop(offscreen.render(&gpu, &mut renderer, &frame).expect("a picture"));
    }
    let [bare, still, moving] = times;
    // What nobody has a limit for is printed all the same.
    report("frame, a shape moves", &moving, "bare", &bare, f64::INFINITY);
    report("frame, nothing moves", &still, "bare", &bare, MOST_FRAME_RATIO)
}

/// The fastest tenth's slowest: what a machine that others use too takes when it is left alone.
fn undisturbed(times: &[Duration]) -> Duration {
    let mut sorted = times.to_vec();
    sorted.sort();
    sorted[sorted.len() / 10]
}

/// Prints a ratio of undisturbed times and whether it is met.
fn report(name: &str, ours: &[Duration], what: &str, bare: &[Duration], most: f64) -> bool {
    let [ours, bare] = [ours, bare].map(|times| undisturbed(times).as_secs_f64() * 1e3);
    let ratio = ours / bare;
    let met = ratio <= most;
    let limit = if most.is_finite() {
        format!(", at most {most}: {}", if met { "met" } else { "missed" })
    } else {
        String::new()
    };
    println!("ratio of {name}: {ratio:.2} times the {what} {bare:.2} ms ({ours:.2} ms){limit}");
    met
}
