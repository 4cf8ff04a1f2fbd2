//! `inbetween import`: a file of another program to a scene and keyframes.

use std::path::Path;

use serde_json::json;

use super::arguments::ImportArguments;
use super::places::Places;
use super::told::{Report, write_keyframes};
use super::{CliError, Common};
use crate::files::{self, FileError};
use crate::interchange::bvh::{self, LARGEST_BVH_BYTES, PERSON_HEIGHT, is_bvh, read_bvh};
use crate::interchange::reduce::{Samples, Tolerance, reduced};
use crate::scene::{SceneGraph, scene_to_json};
use crate::storage::{input_name, is_standard, output_name};
use crate::words::{Message, texts};

/// A file of another program as values.
struct Imported {
    scene: SceneGraph,
    samples: Option<Samples>,
    /// The tolerance of keyframes if none is asked for.
    tolerance: Tolerance,
    notes: Vec<Message>,
}

/// Reads the file, writes the scene and the keyframes, and prints the report.
///
/// # Errors
/// [`CliError`]: a file that is none of the known formats or is bad; an output that cannot be written.
pub fn run(arguments: &ImportArguments, common: Common<'_>) -> Result<(), CliError> {
    let ImportArguments { file, output, keyframes, reduction, .. } = arguments;
    let places = Places::default().reads("MODEL", file).writes("--output", output);
    keyframes.iter().fold(places, |places, keyframes| places.writes("--keyframes", keyframes)).check()?;
    let bytes = files::read(file, LARGEST_BVH_BYTES)?;
    let name = input_name(file);
    let Imported { scene, samples, tolerance, mut notes } =
        imported(&bytes, arguments).map_err(|problem| FileError::new(&name, problem))?;
    files::write(output, scene_to_json(&scene).as_bytes())?;
    notes.push(texts::model_scene_written(output_name(output)));
    let mut written = None;
    match (keyframes, samples) {
        (Some(target), Some(samples)) => {
            let reduced = reduced(&samples, reduction.choice(tolerance), reduction.interpolation());
            notes.push(reduced.message());
            write_keyframes(target, &scene, reduced.animation)?;
            notes.push(texts::model_keyframes_written(output_name(target)));
            written = Some(output_name(target));
        }
        (Some(target), None) => notes.push(texts::model_still(output_name(target))),
        (None, Some(_)) => notes.push(texts::MODEL_NO_KEYFRAMES.into()),
        (None, None) => {}
    }
    let fields = json!({"scene": output_name(output), "keyframes": written});
    let data = std::iter::once(output).chain(keyframes).map(|path| &**path).collect();
    Report { name, notes, fields, is_json: arguments.json, data }.tell(common)
}

/// What the bytes of a file are, told by how they begin.
fn imported(bytes: &[u8], arguments: &ImportArguments) -> Result<Imported, Message> {
    if !is_bvh(bytes) {
        return Err(texts::MODEL_UNKNOWN.into());
    }
    let capture = read_bvh(bytes).map_err(|error| error.message())?;
    let bvh::CapturedScene { scene, samples, notes } =
        bvh::scene_of(&capture, &scene_name(&arguments.file), arguments.scale)?;
    Ok(Imported { scene, samples, tolerance: Tolerance::for_size(PERSON_HEIGHT), notes })
}

/// The name of a scene made of a file.
pub fn scene_name(file: &Path) -> String {
    let stem = file.file_stem().filter(|_| !is_standard(file));
    stem.map_or_else(|| "model".to_owned(), |stem| stem.to_string_lossy().into_owned())
}
