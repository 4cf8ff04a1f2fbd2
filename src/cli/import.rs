//! `inbetween import`: a file of another program to a scene and keyframes.

use std::path::Path;

use serde_json::json;

use super::arguments::ImportArguments;
use super::places::Places;
use super::told::{Report, write_keyframes};
use super::{CliError, Common, misuse};
use crate::files::{self, FileError};
use crate::interchange::bvh::{self, LARGEST_BVH_BYTES, PERSON_HEIGHT, is_bvh, read_bvh};
use crate::interchange::gltf_in::{self, LARGEST_MODEL_BYTES, is_gltf};
use crate::interchange::reduce::{Samples, Tolerance, reduced};
use crate::keyframe::Animation;
use crate::scene::SceneGraph;
use crate::storage::{input_name, is_standard, output_name};
use crate::words::{Message, texts};

/// A file of another program as values.
struct Imported {
    scene: SceneGraph,
    samples: Option<Samples>,
    /// The keyframes that this program has exported, and what is to be said of them.
    kept: Option<(Animation, Message)>,
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
    if arguments.timed && keyframes.is_some() {
        return Err(misuse(&texts::MODEL_TIMED_KEYFRAMES.to_string()));
    }
    let bytes = files::read(file, LARGEST_MODEL_BYTES.max(LARGEST_BVH_BYTES))?;
    let name = input_name(file);
    let is_for_gltf = arguments.animation.is_some() || arguments.gltf_scene.is_some() || arguments.timed;
    let imported = if is_bvh(&bytes) {
        if is_for_gltf {
            return Err(misuse(&texts::MODEL_ONLY_GLTF.to_string()));
        }
        of_bvh(&bytes, arguments)
    } else if is_gltf(&bytes) {
        if arguments.scale.is_some() {
            return Err(misuse(&texts::MODEL_ONLY_CAPTURES.to_string()));
        }
        of_gltf(&bytes, arguments)
    } else {
        Err(texts::MODEL_UNKNOWN.into())
    };
    let Imported { scene, samples, kept, tolerance, mut notes } =
        imported.map_err(|problem| FileError::new(&name, problem))?;
    files::scene::save(&scene, output)?;
    notes.push(texts::model_scene_written(output_name(output)));
    let mut written = None;
    match (keyframes, samples) {
        (Some(target), Some(samples)) => {
            let (animation, said) = kept.filter(|_| reduction.is_usual()).unwrap_or_else(|| {
                let reduced = reduced(&samples, reduction.choice(tolerance), reduction.interpolation());
                let said = reduced.message();
                (reduced.animation, said)
            });
            notes.push(said);
            write_keyframes(target, &scene, animation)?;
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

fn of_bvh(bytes: &[u8], arguments: &ImportArguments) -> Result<Imported, Message> {
    let capture = read_bvh(bytes).map_err(|error| error.message())?;
    let bvh::CapturedScene { scene, samples, notes } =
        bvh::scene_of(&capture, &scene_name(&arguments.file), arguments.scale)?;
    Ok(Imported { scene, samples, kept: None, tolerance: Tolerance::for_size(PERSON_HEIGHT), notes })
}

fn of_gltf(bytes: &[u8], arguments: &ImportArguments) -> Result<Imported, Message> {
    let ImportArguments { file, animation, gltf_scene, timed, .. } = arguments;
    let options = gltf_in::Options {
        name: scene_name(file),
        animation: animation.clone(),
        gltf_scene: *gltf_scene,
        is_timed: *timed,
    };
    let gltf_in::Imported { scene, moving, tolerance, report } =
        gltf_in::imported(bytes, &mut files::model::beside(file), &options)?;
    let (samples, kept) = moving.map_or((None, None), |moving| (Some(moving.samples), moving.kept));
    Ok(Imported { scene, samples, kept, tolerance, notes: report })
}

/// The name of a scene made of a file.
pub fn scene_name(file: &Path) -> String {
    let stem = file.file_stem().filter(|_| !is_standard(file));
    stem.map_or_else(|| "model".to_owned(), |stem| stem.to_string_lossy().into_owned())
}
