//! Goal 6: keyframe files, beside serde_json and plain structs.

use std::hint::black_box;
use std::io::{self, BufWriter, Write as _};

use inbetween::interpolation::Interpolation;
use inbetween::keyframe::{Keyframe, KeyframeList, KeyframesJson, keyframes_from_json, keyframes_to_json};
use inbetween::pose::Pose;
use peak_alloc::PeakAlloc;
use serde::{Deserialize, Serialize};

use crate::poses::{rbts, tree};
use crate::report::{Report, in_turn};

const KEYFRAMES: usize = 1000;
const NODES: usize = 1000;
const ROUNDS: usize = 15;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

#[derive(Deserialize, Serialize)]
struct PlainFile {
    format: String,
    version: u64,
    scene: String,
    interpolation: String,
    ms_between_keyframes: u32,
    nodes: Vec<String>,
    keyframes: Vec<PlainKeyframe>,
}

#[derive(Deserialize, Serialize)]
struct PlainKeyframe {
    pose: Vec<PlainRbt>,
}

#[derive(Deserialize, Serialize)]
struct PlainRbt {
    translation: [f32; 3],
    rotation: [f32; 4],
}

/// 6. Reading and writing many keyframes of many nodes.
pub fn keyframe_files(report: &mut Report) {
    let scene = tree(NODES);
    let keyframe = |keyframe: usize| Keyframe::new(Pose::new(rbts(NODES, keyframe)));
    let keyframes = KeyframeList::new((0..KEYFRAMES).map(keyframe).collect());
    let text = keyframes_to_json(&scene, &keyframes, Interpolation::Linear, 2000);
    let plain: PlainFile = serde_json::from_str(&text).expect("it is JSON");
    let json = KeyframesJson {
        scene: &scene,
        keyframes: &keyframes,
        interpolation: Interpolation::Linear,
        ms_between_keyframes: 2000,
    };
    let [mut written, mut plainly_written] = [(); 2].map(|()| vec![0; text.len()]);
    // The plain file has no white space; what it takes to write that is on our side alone.
    let [reading, plainly_reading, writing, plainly_writing] = in_turn(
        ROUNDS,
        [
            &mut || drop(black_box(keyframes_from_json(text.as_bytes(), &scene).expect("it is a keyframe file"))),
            &mut || drop(black_box(serde_json::from_slice::<PlainFile>(text.as_bytes()).expect("it is JSON"))),
            &mut || {
                written.clear();
                write!(black_box(&mut written), "{json}").expect("memory takes all");
            },
            &mut || {
                plainly_written.clear();
                serde_json::to_writer(black_box(&mut plainly_written), &plain).expect("memory takes all");
            },
        ],
    );
    assert_eq!(written, text.as_bytes());
    let bytes = text.len();
    drop((text, plain, written, plainly_written));
    report.at_most("reading 1,000 keyframes of 1,000 nodes", reading, plainly_reading, 1.0);
    report.at_most("writing them", writing, plainly_writing, 1.0);
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    write!(BufWriter::new(io::sink()), "{json}").expect("a sink takes all");
    report.bytes_at_most("memory while writing, beside the file", MEMORY.peak_usage() - before, bytes, 1.0);
}
