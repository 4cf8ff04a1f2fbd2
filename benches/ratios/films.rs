//! Goal 7: a folder of frames, beside drawing and reading back the same frames and nothing else.

use std::hint::black_box;
use std::path::Path;

use inbetween::export::{
    Animation, Drawing, Moments, Painter, Scenery, Size, Source, Span, Stage, Viewpoint, write_folder,
};
use inbetween::film::StillEncoder;
use inbetween::frame::Frame;
use inbetween::keyframe::keyframes_from_json;
use inbetween::picture::PngMemory;
use inbetween::render::Gpu;
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};

use crate::report::{Report, in_turn};

const FRAMES_PER_SECOND: u32 = 60;
const SIZE: Size = Size { width: 640, height: 480 };
const ROUNDS: usize = 8;

/// The walking robots at 60 frames a second, written as PNGs, beside the same pictures drawn one after another and dropped.
pub fn frames(report: &mut Report) {
    let scene = built_in_scene(DEFAULT_SCENE).expect("the default scene is built in");
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/animations/walk.json");
    let bytes = std::fs::read(file).expect("the animation is there");
    let (keyframes, interpolation, ms_between_keyframes) =
        keyframes_from_json(&bytes, &scene).expect("the animation is valid").into_parts();
    let animation = Animation { keyframes, interpolation, ms_between_keyframes };
    let source = Source { scene: &scene, animation: Some(&animation), file: None };
    let view = Viewpoint::named(None, &scene).expect("the scene has an eye");
    let moments = Moments::of_film(Span::default(), source, view, FRAMES_PER_SECOND).expect("it plays");
    let painter = || Painter::on(Gpu::headless().expect("an adapter"), SIZE, None).expect("the size can be drawn");
    let (mut ours, mut theirs) = (painter(), painter());
    let stage = Stage::new(source, view, 0, ours.size_px());
    let frames: Vec<Frame> =
        moments.all.iter().map(|moment| stage.frame(moment).expect("it can be evaluated")).collect();
    let folder = tempfile::tempdir().expect("a folder");
    let mut written = 0;
    let mut write = || {
        let mut watch = |_, _| true;
        let mut drawing = Drawing { scenery: Scenery::Stage(&stage), moments: &moments, painter: &mut ours };
        let start = |_| -> Box<dyn StillEncoder> { Box::new(PngMemory::default()) };
        write_folder(folder.path(), "png", start, &mut drawing, &mut watch, &mut |_, _| written += 1)
            .expect("the frames can be written");
    };
    let mut draw = || {
        for frame in &frames {
            black_box(theirs.image(frame).expect("a picture"));
        }
    };
    let [ours, theirs] = in_turn(ROUNDS, [&mut write, &mut draw]);
    assert_eq!(written, ROUNDS * frames.len());
    report.at_most(&format!("{} frames of 640x480 as PNGs", frames.len()), ours, theirs, 1.25);
}
