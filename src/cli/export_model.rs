//! `inbetween export`: a scene and an animation to a file of another program.

use std::path::Path;

use clap::ValueEnum as _;
use serde_json::json;

use super::arguments::{ExportArguments, ModelFormat};
use super::places::Places;
use super::told::Report;
use super::{CliError, Common, misuse, reading, scene};
use crate::files::model::{DEFAULT_FRAMES_PER_SECOND, scene_name};
use crate::interchange::bvh::BvhText;
use crate::interchange::gltf_out::{self, Export};
use crate::keyframe::Animation;
use crate::scene::SceneGraph;
use crate::storage::{self, input_name, output_name};
use crate::words::{one_of, quoted, texts};

/// Writes the file, and prints the report.
///
/// # Errors
/// [`CliError`]: bad keyframes, a scene that the format cannot say, an output that cannot be written.
pub fn run(arguments: &ExportArguments, common: Common<'_>) -> Result<(), CliError> {
    let output = &arguments.output;
    let format = format_of(arguments)?;
    let misplaced = match format {
        ModelFormat::Bvh => arguments.only_gltf().map(|option| texts::model_only_of(option, "glTF")),
        ModelFormat::Glb | ModelFormat::Gltf => arguments.only_bvh().map(|option| texts::model_only_of(option, "BVH")),
    };
    if let Some(sentence) = misplaced {
        return Err(misuse(&sentence.to_string()));
    }
    let places = Places::with_scene(common.scene);
    let places = arguments.file.iter().fold(places, |places, file| places.reads("FILE", file));
    places.writes("--output", output).check()?;
    let scene = scene::load(common.scene)?;
    let animation = match &arguments.file {
        None => None,
        Some(file) => {
            let animation = Animation::of(reading::keyframes(file, &scene, common)?.file, arguments.interpolation);
            animation.play_range(file)?;
            Some(animation)
        }
    };
    let name = arguments.file.as_deref().map_or_else(|| scene.name().to_owned(), input_name);
    let mut fields = json!({"output": output_name(output), "format": format.ending()});
    let notes = match format {
        ModelFormat::Bvh => {
            let fps = arguments.fps.unwrap_or(DEFAULT_FRAMES_PER_SECOND);
            let top = arguments.node.as_deref().map(|path| {
                let problem = || CliError::bad_input(scene.name(), texts::retarget_no_node(quoted(path)));
                scene.find_rbt(path).ok_or_else(problem)
            });
            let text = BvhText::new(&scene, animation.as_ref(), top.transpose()?, fps);
            let text = text.map_err(|problem| CliError::bad_input(&name, problem))?;
            storage::write_with(output, |out| text.write(out)).map_err(|reason| CliError::unwritten(output, reason))?;
            text.notes()
        }
        ModelFormat::Glb | ModelFormat::Gltf => {
            let (bytes, report) = gltf(arguments, format, &scene, animation.as_ref());
            storage::write_with(output, |out| out.write_all(&bytes))
                .map_err(|reason| CliError::unwritten(output, reason))?;
            fields["nodes"] = json!(report.nodes);
            fields["channels"] = json!(report.channels);
            fields["keys"] = json!(report.keys);
            fields["exactness"] = report.exactness.as_ref().map(gltf_out::Exactness::json).into();
            report.messages()
        }
    };
    Report { name, notes, fields, is_json: arguments.json, data: vec![output] }.tell(common)
}

/// The bytes of a glTF file, and what is to be said of it.
fn gltf(
    arguments: &ExportArguments,
    format: ModelFormat,
    scene: &SceneGraph,
    animation: Option<&Animation>,
) -> (Vec<u8>, gltf_out::Report) {
    let name = arguments.file.as_deref().map(scene_name).unwrap_or_default();
    let export = Export {
        animation: animation.map(|animation| (animation, &*name)),
        tolerance: arguments.tolerance.unwrap_or_default(),
        curves: arguments.curves.unwrap_or_default(),
        frames_per_second: arguments.fps,
        has_meshes: !arguments.no_meshes,
        ..Export::of(scene)
    };
    if format == ModelFormat::Glb {
        return export.glb();
    }
    let (text, report) = export.gltf();
    (text.into_bytes(), report)
}

/// The format that is asked for, or that the output's ending names.
fn format_of(arguments: &ExportArguments) -> Result<ModelFormat, CliError> {
    let formats = ModelFormat::value_variants();
    let ending = Path::new(&arguments.output).extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    let of_ending = formats.iter().copied().find(|format| ending.as_deref() == Some(format.ending()));
    match (arguments.format, of_ending) {
        (Some(asked), Some(found)) if asked != found => {
            let option = format!("--format {}", asked.ending());
            Err(misuse(&texts::places_ending_contradicts(found.ending(), option).to_string()))
        }
        (asked, found) => asked.or(found).ok_or_else(|| {
            let endings: Vec<String> = formats.iter().map(|format| format!(".{}", format.ending())).collect();
            misuse(&texts::model_ending(one_of(&endings)).to_string())
        }),
    }
}
