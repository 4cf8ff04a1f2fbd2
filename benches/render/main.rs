//! What a picture costs, against the least that any wgpu program does for one: `cargo bench --bench render`.
//!
//! Two ratios: one more frame in a running program, and whole processes from start to exit.

mod bare;
#[path = "../../tests/support/mod.rs"]
mod support;

use std::hint::black_box;
use std::process::{Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

use glam::Vec3;
use inbetween::render::{Gpu, Offscreen, Renderer, default_samples};

/// With this argument the benchmark is the bare program.
const BARE: &str = "--be-the-bare-program";
/// One more frame may take so many times the bare one.
const MOST_FRAME_RATIO: f64 = 14.0;
/// A process may take so many times the bare one.
const MOST_PROCESS_RATIO: f64 = 1.3;

fn main() -> ExitCode {
    if std::env::args().any(|argument| argument == BARE) {
        black_box(bare::Bare::new().draw());
        return ExitCode::SUCCESS;
    }
    frames();
    processes();
    ExitCode::SUCCESS
}

fn frames() {
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
    let [bare, still, moving] = times.map(median);
    report("frame, nothing moves", still, bare, MOST_FRAME_RATIO);
    report("frame, a shape moves", moving, bare, MOST_FRAME_RATIO);
}

fn processes() {
    let directory = tempfile::tempdir().expect("a temporary directory");
    let picture = directory.path().join("picture.png");
    let mut ours = Command::new(env!("CARGO_BIN_EXE_inbetween"));
    ours.arg("render").arg("-o").arg(&picture).stdout(Stdio::null()).stderr(Stdio::null());
    let mut bare = Command::new(std::env::current_exe().expect("the benchmark's own path"));
    bare.arg(BARE).stdout(Stdio::null()).stderr(Stdio::null());
    let mut times = [Vec::new(), Vec::new()];
    for round in 0..23 {
        for (which, command) in [&mut bare, &mut ours].into_iter().enumerate() {
            let start = Instant::now();
            let status = command.status().expect("the process starts");
            if round >= 3 {
                times[which].push(start.elapsed());
            }
            assert!(status.success(), "{command:?}: {status}");
        }
    }
    if !picture.exists() {
        println!("process: `inbetween render` wrote no picture, so there is nothing to compare");
        return;
    }
    let [bare, ours] = times.map(median);
    report("process", ours, bare, MOST_PROCESS_RATIO);
}

fn median(mut times: Vec<Duration>) -> Duration {
    times.sort();
    times[times.len() / 2]
}

fn report(name: &str, ours: Duration, bare: Duration, most: f64) {
    let ratio = ours.as_secs_f64() / bare.as_secs_f64();
    let verdict = if ratio <= most { "met" } else { "MISSED" };
    let ms = |time: Duration| time.as_secs_f64() * 1e3;
    println!("{name}: {ratio:.2} times the bare {:.2} ms ({:.2} ms), at most {most}: {verdict}", ms(bare), ms(ours));
}
