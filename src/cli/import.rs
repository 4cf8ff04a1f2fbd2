//! `inbetween import`: a file of another program to a scene and keyframes.

use serde_json::json;

use super::arguments::ImportArguments;
use super::places::Places;
use super::told::{Report, write_keyframes};
use super::{CliError, Common, misuse};
use crate::files;
use crate::files::model::{Model, ModelError, ModelOptions};
use crate::interchange::gltf_in::AnimationChoice;
use crate::interchange::reduce::reduced;
use crate::storage::{Place, input_name, output_name};
use crate::words::texts;

/// Reads the file, writes the scene and the keyframes, and prints the report.
///
/// # Errors
/// [`CliError`]: a file that is none of the known formats or is bad; an output that cannot be written.
pub fn run(arguments: &ImportArguments, common: Common<'_>) -> Result<(), CliError> {
    let ImportArguments { file, output, keyframes, reduction, .. } = arguments;
    let places = Places::default().reads("MODEL", file).writes("--output", output);
    keyframes.iter().fold(places, |places, keyframes| places.writes("--keyframes", keyframes)).check()?;
    if arguments.timed && (keyframes.is_some() || !reduction.is_usual()) {
        return Err(misuse(&texts::MODEL_TIMED_KEYFRAMES.to_string()));
    }
    let options = ModelOptions {
        animation: arguments.animation.clone().map(AnimationChoice::Words),
        gltf_scene: arguments.gltf_scene,
        is_timed: arguments.timed,
        scale: arguments.scale,
    };
    let Model { scene, samples, kept, tolerance, mut notes, mut others } =
        Model::read(file, &options).map_err(|error| match error {
            ModelError::Misuse(said) => misuse(&said.to_string()),
            ModelError::File(error) => error.into(),
        })?;
    notes.append(&mut others);
    let name = input_name(file);
    let is_over_model = Place::of_output(&output.with_extension("glb")) == Place::of_input(file);
    let copies = if is_over_model && scene.meshes().is_some() {
        notes.push(texts::model_meshes_within(input_name(file)));
        files::scene::save_with_meshes_within(&scene, output)?
    } else {
        files::scene::save(&scene, output)?
    };
    notes.push(texts::model_scene_written(output_name(output)));
    notes.extend(copies.iter().map(|copy| texts::model_kept(copy.display())));
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
