//! `inbetween sample`: poses as JSON or CSV.

use std::fmt::Write as _;
use std::io;
use std::path::Path;

use glam::Mat4;

use super::arguments::{SampleArguments, SampleFormat, Space};
use super::output;
use super::places::Places;
use super::{CliError, misuse, scene};
use crate::blend::AlignedAffine;
use crate::export::{Animation, FrameTime, frame_times};
use crate::json::{push_f32, push_f32s, push_rbts, push_strings};
use crate::keyframe::SampleError;
use crate::pose::Pose;
use crate::scene::SceneGraph;
use crate::storage::input_name;

/// Prints samples, all in the scene's order. Nothing is printed before all of the input is known to be good.
///
/// # Errors
/// [`CliError`]
pub fn run(arguments: &SampleArguments, scene: Option<&Path>) -> Result<(), CliError> {
    if arguments.space == Space::World && arguments.format == SampleFormat::Csv {
        return Err(misuse("--space world is printed as JSON: leave --format csv out"));
    }
    let places = Places::with_scene(scene);
    arguments.file.iter().fold(places, |places, file| places.reads("FILE", file)).check()?;
    let scene = &scene::load(scene)?;
    let Some(file) = &arguments.file else {
        let rest = (FrameTime { key_time: 0.0, ms: 0.0 }, scene.rest_pose().clone());
        return print(arguments, scene, std::iter::once(Ok(rest)));
    };
    let animation = Animation::load(file, scene, arguments.interpolation)?;
    let range = animation.play_range(file)?;
    let pose_at = |time: FrameTime| range.pose_at(time.key_time, animation.interpolation).map(|pose| (time, pose));
    let ms_between_keyframes = animation.ms_between_keyframes;
    if let Some(fps) = arguments.fps {
        return print(arguments, scene, frame_times(fps, ms_between_keyframes, range.timing()).map(pose_at));
    }
    let key_times = arguments.at.as_ref().map_or(&[0.0][..], |key_times| &key_times.0);
    let problems: Vec<String> = key_times
        .iter()
        .filter_map(|&key_time| range.check(key_time).err())
        .map(|error| format!("{}: {error}", input_name(file)))
        .collect();
    if !problems.is_empty() {
        return Err(CliError::bad_inputs(problems));
    }
    let times =
        key_times.iter().map(|&key_time| FrameTime::at_key_time(key_time, ms_between_keyframes, range.timing()));
    print(arguments, scene, times.map(pose_at))
}

type Sample = Result<(FrameTime, Pose), SampleError>;

fn print(
    arguments: &SampleArguments,
    scene: &SceneGraph,
    samples: impl Iterator<Item = Sample>,
) -> Result<(), CliError> {
    output::print(|output| match arguments.format {
        SampleFormat::Json => print_json(output, arguments, scene, samples),
        SampleFormat::Csv => print_csv(output, samples),
    })
}

fn print_json(
    output: &mut dyn io::Write,
    arguments: &SampleArguments,
    scene: &SceneGraph,
    samples: impl Iterator<Item = Sample>,
) -> io::Result<()> {
    let mut text = String::from("{\"nodes\": ");
    match arguments.space {
        Space::Parent => push_strings(&mut text, scene.rbt_paths()),
        Space::World => push_strings(&mut text, scene.nodes().iter().map(|node| node.path.as_str())),
    }
    text.push_str(", \"frames\": [\n");
    for (index, sample) in samples.enumerate() {
        let (FrameTime { key_time, ms }, pose) = sample.map_err(io::Error::other)?;
        if index > 0 {
            text.push_str(",\n");
        }
        let _ = write!(text, "{{\"key_time\": {key_time:?}, \"ms\": {ms:?}, ");
        match arguments.space {
            Space::Parent => {
                text.push_str("\"pose\": ");
                push_rbts(&mut text, pose.iter());
            }
            Space::World => {
                let seconds = arguments.seconds + if arguments.fps.is_some() { ms / 1000.0 } else { 0.0 };
                text.push_str("\"world_from_node\": ");
                push_matrices(&mut text, &scene.world_from_nodes(&pose, seconds));
            }
        }
        text.push('}');
        output.write_all(text.as_bytes())?;
        text.clear();
    }
    text.push_str("\n]}\n");
    output.write_all(text.as_bytes())
}

/// Appends matrices of sixteen numbers in column order.
fn push_matrices(text: &mut String, matrices: &[AlignedAffine]) {
    text.push('[');
    for (index, matrix) in matrices.iter().enumerate() {
        text.push_str(if index == 0 { "" } else { ", " });
        push_f32s(text, &Mat4::from(matrix.get()).to_cols_array());
    }
    text.push(']');
}

fn print_csv(output: &mut dyn io::Write, samples: impl Iterator<Item = Sample>) -> io::Result<()> {
    let mut text = String::from("key_time,rbt_ind,tx,ty,tz,rw,rx,ry,rz\n");
    for sample in samples {
        let (FrameTime { key_time, .. }, pose) = sample.map_err(io::Error::other)?;
        for (rbt, parent_from_node) in pose.iter().enumerate() {
            let _ = write!(text, "{key_time:?},{rbt}");
            let [x, y, z, w] = parent_from_node.rotation.to_array();
            for number in parent_from_node.translation.to_array().into_iter().chain([w, x, y, z]) {
                text.push(',');
                push_f32(&mut text, number);
            }
            text.push('\n');
        }
        output.write_all(text.as_bytes())?;
        text.clear();
    }
    output.write_all(text.as_bytes())
}
