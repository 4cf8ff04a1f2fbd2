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
use inbetween::render::{Gpu, Offscreen, Renderer, default_samples};

/// One more frame may take so many times the bare one.
const MOST_FRAME_RATIO: f64 = 14.0;

fn main() -> ExitCode {
    if frames() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
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
    report("frame, a shape moves", &moving, &bare, f64::INFINITY);
    report("frame, nothing moves", &still, &bare, MOST_FRAME_RATIO)
}

/// The fastest tenth's slowest: what a machine that others use too takes when it is left alone.
fn undisturbed(times: &[Duration]) -> Duration {
    let mut sorted = times.to_vec();
    sorted.sort();
    sorted[sorted.len() / 10]
}

/// Prints a ratio of undisturbed times and whether it is met.
fn report(name: &str, ours: &[Duration], bare: &[Duration], most: f64) -> bool {
    let [ours, bare] = [ours, bare].map(|times| undisturbed(times).as_secs_f64() * 1e3);
    let ratio = ours / bare;
    let met = ratio <= most;
    let limit = if most.is_finite() {
        format!(", at most {most}: {}", if met { "met" } else { "missed" })
    } else {
        String::new()
    };
    println!("ratio of {name}: {ratio:.2} times the bare {bare:.2} ms ({ours:.2} ms){limit}");
    met
}
