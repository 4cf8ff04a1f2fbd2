//! The walking robot as a GIF against the same frames as plain PNGs: 640x480, 30 frames a second, 4 seconds. Runs alternate, so that
//! whatever else the machine does meets both. Ends with 1 where a GIF takes twice as long or two GIFs differ.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

/// Pairs of runs; the first warms the driver's caches up and is not counted.
const PAIRS: usize = 6;
/// How many times as long as its PNG frames a GIF may take.
const MOST_TIMES: f64 = 2.0;

fn render(output: &Path) -> Duration {
    let walk = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/animations/walk.json");
    let start = Instant::now();
    let status = Command::new(env!("CARGO_BIN_EXE_inbetween"))
        .arg("render")
        .arg(walk)
        .args(["--size", "640x480", "--fps", "30", "-o"])
        .arg(output)
        .stderr(Stdio::null())
        .status()
        .expect("the program runs");
    assert!(status.success(), "{status}");
    start.elapsed()
}

fn median(times: &mut [Duration]) -> Duration {
    times.sort_unstable();
    times[times.len() / 2]
}

fn main() -> ExitCode {
    // `cargo test --benches` only wants to know whether it builds.
    if std::env::args().any(|argument| argument == "--test") {
        return ExitCode::SUCCESS;
    }
    let folder: PathBuf = tempfile::tempdir().expect("a folder").keep();
    let (frames, gif) = (folder.join("frames"), folder.join("walk.gif"));
    std::fs::create_dir(&frames).expect("a folder for frames");
    let (mut of_frames, mut of_gifs, mut gifs) = (Vec::new(), Vec::new(), Vec::new());
    for pair in 0..PAIRS {
        let times = (render(&frames), render(&gif));
        gifs.push(std::fs::read(&gif).expect("the GIF was written"));
        if pair > 0 {
            of_frames.push(times.0);
            of_gifs.push(times.1);
        }
    }
    let count = std::fs::read_dir(&frames).expect("the folder of frames").count();
    std::fs::remove_dir_all(&folder).expect("the folder can be removed");
    let are_same = gifs.windows(2).all(|pair| pair[0] == pair[1]);
    let (png, gif) = (median(&mut of_frames), median(&mut of_gifs));
    let times = gif.as_secs_f64() / png.as_secs_f64();
    println!(
        "{count} frames of 640x480: PNG {:.0} ms, GIF {:.0} ms: {times:.2} times as long (at most {MOST_TIMES}); {PAIRS} GIFs of {} bytes are {}",
        png.as_secs_f64() * 1e3,
        gif.as_secs_f64() * 1e3,
        gifs[0].len(),
        if are_same { "the same" } else { "different" }
    );
    if times < MOST_TIMES && are_same { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
