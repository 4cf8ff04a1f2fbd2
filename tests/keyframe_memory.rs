//! What reading and writing a large keyframe file takes in memory. A test of its own because memory is counted over the whole process.

use std::io::{self, Write as _};

use glam::{Quat, Vec3};
use inbetween::interpolation::Interpolation;
use inbetween::keyframe::{Keyframe, KeyframeList, KeyframesJson, keyframes_from_json, keyframes_to_json};
use inbetween::pose::Pose;
use inbetween::rbt::Rbt;
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use peak_alloc::PeakAlloc;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// What is made ahead of the writing, and what is held of the text that is being read.
const FIXED_BYTES: usize = 4 << 20;

fn taken<T>(work: impl FnOnce() -> T) -> (T, usize) {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let value = work();
    (value, MEMORY.peak_usage() - before)
}

#[test]
fn a_large_file_is_not_held_twice() {
    let scene = built_in_scene(DEFAULT_SCENE).expect("it is built in");
    let keyframe = |place: usize| {
        let phase = 0.1 * place as f32;
        let rbt =
            |node: usize| Rbt::new(Vec3::new(phase.sin(), phase.cos(), node as f32), Quat::from_rotation_y(phase));
        Keyframe::new(Pose::new((0..scene.rbt_count()).map(rbt).collect()))
    };
    let keyframes = KeyframeList::new((0..20_000).map(keyframe).collect());
    let text = keyframes_to_json(&scene, &keyframes, Interpolation::Linear, 2000);
    let bytes = text.len();
    assert!(bytes > 8 * FIXED_BYTES);
    let json = KeyframesJson {
        scene: &scene,
        keyframes: &keyframes,
        interpolation: Interpolation::Linear,
        ms_between_keyframes: 2000,
    };
    let (written, while_writing) = taken(|| write!(io::sink(), "{json}"));
    written.expect("a sink takes all");
    assert!(while_writing < FIXED_BYTES, "{while_writing} bytes to write {bytes}");
    let (file, while_reading) = taken(|| keyframes_from_json(text.as_bytes(), &scene));
    assert_eq!(KeyframeList::new(file.expect("it was written").keyframes), keyframes);
    assert!(while_reading < bytes / 2 + FIXED_BYTES, "{while_reading} bytes to read {bytes}");
}
