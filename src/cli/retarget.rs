//! `inbetween retarget`: motion from one skeleton to another.

use std::path::{Path, PathBuf};

use serde_json::json;

use super::arguments::RetargetArguments;
use super::places::Places;
use super::told::{Report, write_keyframes};
use super::{CliError, Common, misuse, reading, scene};
use crate::files::model::scene_name;
use crate::files::{self, FileError};
use crate::interchange::bvh::{CapturedScene, read_bvh, scene_of};
use crate::interchange::reduce::Samples;
use crate::interchange::retarget::{LARGEST_MAP_BYTES, RetargetMap, Source, retargeted, sampled, tolerance_for};
use crate::keyframe::{Animation, LARGEST_FILE_BYTES};
use crate::model::ModelFormat;
use crate::scene::SceneGraph;
use crate::storage::{self, input_name, output_name};
use crate::words::{Message, quoted, texts};

/// Writes the keyframes and the map, and prints the report.
///
/// # Errors
/// [`CliError`]: a bad file, skeletons that cannot be told, an output that cannot be written.
pub fn run(arguments: &RetargetArguments, common: Common<'_>) -> Result<(), CliError> {
    let RetargetArguments { file, output, map, write_map, reduction, .. } = arguments;
    let (onto_scene, onto_node) = onto(&arguments.onto);
    let places = Places::with_scene(common.scene).reads("FILE", file);
    let places =
        scene::file_of(Some(&onto_scene)).into_iter().fold(places, |places, file| places.reads("--onto", file));
    let places = map.iter().fold(places, |places, map| places.reads("--map", map)).writes("--output", output);
    write_map.iter().fold(places, |places, map| places.writes("--write-map", map)).check()?;
    let target = scene::load(Some(&onto_scene))?;
    let top = onto_node.map(|path| {
        let problem = || CliError::bad_input(input_name(&onto_scene), texts::retarget_no_node(quoted(&path)));
        target.find_rbt(&path).ok_or_else(problem)
    });
    let top = top.transpose()?;
    let name = input_name(file);
    let (source, samples, mut notes) = motion(file, common)?;
    let bad = |problem: Message| CliError::bad_input(&name, problem);
    let map_used = match map {
        Some(map) => map_in(map)?,
        None => RetargetMap::guessed(&source, &target, top).map_err(bad)?,
    };
    let source = Source { scene: &source, samples: &samples };
    let location = map.as_deref().map_or_else(|| name.clone(), input_name);
    let made = retargeted(source, &target, &map_used).map_err(|problem| CliError::bad_input(location, problem))?;
    let tolerance = tolerance_for(&target, made.top());
    let keyframes = made.keyframes(reduction.choice(tolerance), reduction.interpolation());
    notes.extend(keyframes.notes);
    write_keyframes(output, &target, keyframes.reduced.animation)?;
    notes.push(texts::model_keyframes_written(output_name(output)));
    if let Some(target) = write_map {
        files::write(target, map_used.to_json().as_bytes())?;
        notes.push(texts::retarget_map_written(output_name(target)));
    }
    let feet: Vec<_> =
        keyframes.feet.iter().map(|foot| json!({"stances": foot.stances, "slide": foot.slide})).collect();
    let fields = json!({"output": output_name(output), "map": write_map.as_deref().map(output_name), "feet": feet});
    let data = std::iter::once(output).chain(write_map).map(|path| &**path).collect();
    Report { name, notes, fields, is_json: arguments.json, data }.tell(common)
}

/// The scene and the node that `--onto` names. A colon may be part of a file's name.
fn onto(text: &Path) -> (PathBuf, Option<String>) {
    let whole = || (text.to_owned(), None);
    let is_scene = scene::file_of(Some(text)).is_none() || storage::exists(text);
    match text.to_str().and_then(|text| text.rsplit_once(':')) {
        Some((scene, node)) if !is_scene => (scene.into(), Some(node.to_owned())),
        _ => whole(),
    }
}

fn map_in(file: &Path) -> Result<RetargetMap, FileError> {
    let bytes = files::read(file, LARGEST_MAP_BYTES)?;
    RetargetMap::from_json(&bytes).map_err(|error| FileError::new(input_name(file), error))
}

/// The scene and the motion of a file, and what is to be said of it.
fn motion(file: &Path, common: Common<'_>) -> Result<(SceneGraph, Samples, Vec<Message>), CliError> {
    let bytes = files::read(file, LARGEST_FILE_BYTES)?;
    let name = input_name(file);
    let bad = |problem: Message| CliError::bad_input(&name, problem);
    if ModelFormat::of(&bytes) == Some(ModelFormat::Bvh) {
        if common.scene.is_some() {
            return Err(misuse(&texts::RETARGET_OWN_SCENE.to_string()));
        }
        let capture = read_bvh(&bytes).map_err(|error| bad(error.message()))?;
        let CapturedScene { scene, samples, notes } = scene_of(&capture, &scene_name(file), None).map_err(bad)?;
        let samples = samples.ok_or_else(|| bad(texts::retarget_still(scene.name())))?;
        return Ok((scene, samples, notes));
    }
    let scene = scene::load(common.scene)?;
    let animation = Animation::of(reading::keyframes_in(&bytes, file, &scene, common)?.file, None);
    animation.play_range(file)?;
    let samples = sampled(&scene, &animation).map_err(bad)?;
    Ok((scene, samples, Vec::new()))
}
