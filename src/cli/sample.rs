//! `inbetween sample`: poses as JSON or CSV.

use std::fmt::Write as _;
use std::io;
use std::path::{Path, PathBuf};

use glam::Mat4;
use serde_json::json;

use super::arguments::{SampleArguments, SampleFormat, Space};
use super::each::{Done, Telling, each, tell};
use super::places::Places;
use super::targets::{ending_of, make_folder, targets};
use super::{CliError, Common, Ended, misuse, output, reading, scene};
use crate::blend::AlignedAffine;
use crate::export::{Animation, FrameTime, frame_times};
use crate::json::{push_f32, push_f32s, push_rbts, push_strings};
use crate::keyframe::SampleError;
use crate::pose::Pose;
use crate::scene::SceneGraph;
use crate::storage::{self, input_name, is_standard};
use crate::words::texts;

/// Prints or writes samples, all in the scene's order. Nothing of a file is printed before all of it is known to be good.
///
/// # Errors
/// [`CliError`]
pub fn run(arguments: &SampleArguments, common: Common<'_>) -> Result<Ended, CliError> {
    let form = Form { arguments, format: format_of(arguments)? };
    let files = &arguments.files;
    let output = arguments.output.as_deref().unwrap_or(Path::new("-"));
    if files.len() > 1 && arguments.output.is_none() {
        return Err(misuse(texts::PLACES_SEVERAL_NEED_FOLDER.english()));
    }
    let targets = targets(files, output, form.format.ending(), false)?;
    let places = Places::with_scene(common.scene);
    let places = files.iter().fold(places, |places, file| places.reads("FILE", file));
    targets.iter().fold(places, |places, target| places.writes("--output", target)).check()?;
    let scene = &scene::load(common.scene)?;
    if files.is_empty() {
        let rest = (FrameTime { key_time: 0.0, ms: 0.0 }, scene.rest_pose().clone());
        form.write(scene, std::iter::once(Ok(rest)), output)?;
        return Ok(Ended::Well);
    }
    let pairs: Vec<(&PathBuf, &PathBuf)> = files.iter().zip(&targets).collect();
    let shown = |(file, _): &(&PathBuf, &PathBuf)| input_name(file);
    let named = |(file, _): &(&PathBuf, &PathBuf)| json!({"file": input_name(file)});
    let outcomes = each(&pairs, common, shown, named, |&(file, target), notes| {
        let read = reading::noted_keyframes(file, scene, common, notes)?;
        let animation = Animation::of(read.file, arguments.interpolation);
        let samples = Samples { form, scene, file, animation: &animation };
        make_folder(output, target)?;
        samples.write(target)?;
        Ok(Done::well(String::new(), json!({})))
    })?;
    // The samples are the data: of files, nothing is told but problems.
    tell(outcomes, Telling { is_json: false, data: None })
}

/// The format that the arguments ask for, or that the output's ending has.
fn format_of(arguments: &SampleArguments) -> Result<SampleFormat, CliError> {
    let ending = arguments.output.as_deref().and_then(|output| ending_of(output, arguments.files.len()));
    let of_ending = ending.as_deref().and_then(SampleFormat::of_ending);
    let asked = if arguments.json { Some(SampleFormat::Json) } else { arguments.format };
    if let (Some(asked), Some(found), Some(ending)) = (asked, of_ending, &ending)
        && asked != found
    {
        let option = if arguments.json { "--json".to_owned() } else { format!("--format {}", asked.ending()) };
        return Err(misuse(&texts::places_ending_contradicts(ending, option).to_string()));
    }
    let format = asked.or(of_ending).unwrap_or(SampleFormat::Json);
    if arguments.space == Space::World && format == SampleFormat::Csv {
        return Err(misuse("--space world is printed as JSON, not as CSV"));
    }
    Ok(format)
}

type Sample = Result<(FrameTime, Pose), SampleError>;

/// How samples are printed.
#[derive(Clone, Copy)]
struct Form<'a> {
    arguments: &'a SampleArguments,
    format: SampleFormat,
}

impl Form<'_> {
    fn write(self, scene: &SceneGraph, samples: impl Iterator<Item = Sample>, target: &Path) -> Result<(), CliError> {
        let write = |output: &mut dyn io::Write| match self.format {
            SampleFormat::Json => print_json(output, self.arguments, scene, samples),
            SampleFormat::Csv => print_csv(output, samples),
        };
        if is_standard(target) {
            return output::print(write);
        }
        storage::write_with(target, write).map_err(|reason| CliError::unwritten(target, reason))
    }
}

/// The samples of a file.
struct Samples<'a> {
    form: Form<'a>,
    scene: &'a SceneGraph,
    file: &'a Path,
    animation: &'a Animation,
}

impl Samples<'_> {
    fn write(&self, target: &Path) -> Result<(), CliError> {
        let Self { form, scene, file, animation } = self;
        let arguments = form.arguments;
        let range = animation.play_range(file)?;
        let pose_at = |time: FrameTime| range.pose_at(time.key_time, animation.interpolation).map(|pose| (time, pose));
        let ms_between_keyframes = animation.ms_between_keyframes;
        if let Some(fps) = arguments.fps {
            return form.write(scene, frame_times(fps, ms_between_keyframes, range.timing()).map(pose_at), target);
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
        form.write(scene, times.map(pose_at), target)
    }
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
