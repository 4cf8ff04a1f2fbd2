//! `inbetween render`: images with no window.

use std::mem::ManuallyDrop;
use std::path::Path;

use super::animation::Animation;
use super::arguments::RenderArguments;
use super::picture::Painter;
use super::progress::Progress;
use super::times::frame_times;
use super::{CliError, misuse, scene};
use crate::camera::Camera;
use crate::frame::Frame;
use crate::keyframe::KeyframeIndex;
use crate::pose::Pose;
use crate::scene::SceneGraph;
use crate::storage;

/// Renders what the arguments say, as the scene's first eye sees it. The GPU adapter is acquired before any file is read.
///
/// # Errors
/// [`CliError`]
pub fn run(arguments: &RenderArguments, scene: Option<&Path>) -> Result<(), CliError> {
    if arguments.fps.is_some() && arguments.output.extension().is_some_and(|extension| extension == "png") {
        return Err(misuse("with --fps, --output names a folder for the numbered images"));
    }
    // The system takes back in no time what a driver takes milliseconds to give back, and the process ends after this.
    let mut painter = ManuallyDrop::new(Painter::new(arguments.size, arguments.samples)?);
    let scene = scene::load(scene)?;
    let Some(file) = &arguments.file else {
        return write(&mut painter, &scene, scene.rest_pose(), arguments.seconds, &arguments.output);
    };
    let animation = Animation::load(file, &scene, arguments.interpolation)?;
    if let Some(index) = arguments.keyframe {
        let pose = keyframe(&animation, index).map_err(|problem| CliError::bad_input(file.display(), problem))?;
        return write(&mut painter, &scene, pose, arguments.seconds, &arguments.output);
    }
    let range = animation.play_range(file)?;
    let pose_at = |key_time| {
        range.pose_at(key_time, animation.interpolation).map_err(|error| CliError::bad_input(file.display(), error))
    };
    let Some(fps) = arguments.fps else {
        return write(
            &mut painter,
            &scene,
            &pose_at(arguments.at.unwrap_or(0.0))?,
            arguments.seconds,
            &arguments.output,
        );
    };
    let folder = &arguments.output;
    storage::create_folder(folder).map_err(|reason| CliError::unwritten(folder, reason))?;
    let times = frame_times(fps, animation.ms_between_keyframes, range.timing());
    let mut progress = Progress::new("frame", times.len());
    for (number, time) in times.enumerate() {
        let path = folder.join(format!("frame-{number:05}.png"));
        write(&mut painter, &scene, &pose_at(time.key_time)?, arguments.seconds + time.ms / 1000.0, &path)?;
        progress.step();
    }
    Ok(())
}

fn keyframe(animation: &Animation, index: i64) -> Result<&Pose, String> {
    usize::try_from(index)
        .ok()
        .and_then(|place| animation.keyframes.get(KeyframeIndex::new(place)))
        .map(|keyframe| &keyframe.pose)
        .ok_or_else(|| match animation.keyframes.last() {
            None => format!("there is no keyframe {index}: the list is empty"),
            Some(last) => format!("there is no keyframe {index}: they are 0 to {}", last.get()),
        })
}

fn write(painter: &mut Painter, scene: &SceneGraph, pose: &Pose, seconds: f64, path: &Path) -> Result<(), CliError> {
    let camera = Camera {
        world_from_eye: scene.world_from_rbt(pose, seconds, scene.eyes()[0]),
        vertical_fov: scene.vertical_fov(),
        size_px: painter.size_px(),
    };
    let png = painter.png(&Frame::new(scene, pose, seconds, &camera, None))?;
    storage::write(path, &png).map_err(|reason| CliError::unwritten(path, reason))
}
