//! Models and motion of other programs, read and written: glTF, and the captures of BVH.

use std::path::Path;

use super::FileError;
use crate::editor::Document;
use crate::interchange::bvh::{self, BvhText, LARGEST_BVH_BYTES, PERSON_HEIGHT, read_bvh};
use crate::interchange::gltf_in::{self, AnimationChoice, Contents, LARGEST_MODEL_BYTES};
use crate::interchange::gltf_out::Export;
use crate::interchange::reduce::{Choice, Samples, Tolerance, reduced};
use crate::interpolation::Interpolation;
use crate::keyframe::Animation;
use crate::model::ModelFormat;
use crate::scene::SceneGraph;
use crate::storage::{self, input_name, is_standard};
use crate::words::{Message, texts};

/// Frames a second of a capture that is written, if nothing else is asked for.
pub const DEFAULT_FRAMES_PER_SECOND: u32 = 60;

/// How a model is read; by default as it is usual.
#[derive(Clone, Debug, Default)]
pub struct ModelOptions {
    /// The animation of a glTF file; the first one without a choice.
    pub animation: Option<AnimationChoice>,
    /// The number of the scene of a glTF file from 0; the file's own without a choice.
    pub gltf_scene: Option<usize>,
    /// Whether the animation of a glTF file becomes timed keys, with the file's times.
    pub is_timed: bool,
    /// Scene units for one unit of a capture; without it, what makes a person as tall as the robots.
    pub scale: Option<f64>,
}

/// Why there is no model.
#[derive(Debug)]
pub enum ModelError {
    /// Options are for another format than the file's.
    Misuse(Message),
    /// The file is none of the known formats or is bad.
    File(FileError),
}

/// A model of another program as values.
#[derive(Debug)]
pub struct Model {
    /// The scene with its meshes.
    pub scene: SceneGraph,
    /// What moves its poses, if anything does.
    pub samples: Option<Samples>,
    /// The keyframes that this program has exported, and what is to be said of them.
    pub kept: Option<(Animation, Message)>,
    /// How far keyframes may be from the samples if nothing else is asked for.
    pub tolerance: Tolerance,
    /// What was taken, simplified and left out: a sentence each.
    pub notes: Vec<Message>,
    /// The scenes and animations that were not taken: sentences with the options of the command line that take them.
    pub others: Vec<Message>,
}

impl Model {
    /// Reads a model. What it is is told by how its bytes begin.
    ///
    /// # Errors
    /// [`ModelError`]
    pub fn read(path: &Path, options: &ModelOptions) -> Result<Self, ModelError> {
        let bytes = super::read(path, LARGEST_MODEL_BYTES.max(LARGEST_BVH_BYTES)).map_err(ModelError::File)?;
        let is_for_gltf = options.animation.is_some() || options.gltf_scene.is_some() || options.is_timed;
        let model = match ModelFormat::of(&bytes) {
            Some(ModelFormat::Bvh) if is_for_gltf => return Err(ModelError::Misuse(texts::MODEL_ONLY_GLTF.into())),
            Some(ModelFormat::Gltf) if options.scale.is_some() => {
                return Err(ModelError::Misuse(texts::MODEL_ONLY_CAPTURES.into()));
            }
            Some(ModelFormat::Bvh) => Self::of_bvh(&bytes, path, options),
            Some(ModelFormat::Gltf) => Self::of_gltf(&bytes, path, options),
            None => Err(texts::MODEL_UNKNOWN.into()),
        };
        model.map_err(|problem| ModelError::File(FileError::new(input_name(path), problem)))
    }

    fn of_bvh(bytes: &[u8], path: &Path, options: &ModelOptions) -> Result<Self, Message> {
        let capture = read_bvh(bytes).map_err(|error| error.message())?;
        let bvh::CapturedScene { scene, samples, notes } = bvh::scene_of(&capture, &scene_name(path), options.scale)?;
        let tolerance = Tolerance::for_size(PERSON_HEIGHT);
        Ok(Self { scene, samples, kept: None, tolerance, notes, others: Vec::new() })
    }

    fn of_gltf(bytes: &[u8], path: &Path, options: &ModelOptions) -> Result<Self, Message> {
        let ModelOptions { animation, gltf_scene, is_timed, .. } = options.clone();
        let options = gltf_in::Options { name: scene_name(path), animation, gltf_scene, is_timed };
        let gltf_in::Imported { scene, moving, tolerance, report: notes, others } =
            gltf_in::imported(bytes, &mut beside(path), &options)?;
        let (samples, kept) = moving.map_or((None, None), |moving| (Some(moving.samples), moving.kept));
        Ok(Self { scene, samples, kept, tolerance, notes, others })
    }

    /// The keyframes that are usual, and what is to be said of them; `None` where no pose moves.
    #[must_use]
    pub fn usual_keyframes(&self) -> Option<(Animation, Message)> {
        self.kept.clone().or_else(|| {
            let reduced = reduced(self.samples.as_ref()?, Choice::Within(self.tolerance), Interpolation::Linear);
            let said = reduced.message();
            Some((reduced.animation, said))
        })
    }
}

/// What a glTF file has to choose from; of any other file nothing.
///
/// # Errors
/// Why the file cannot be read, without its name.
pub fn contents(path: &Path) -> Result<Contents, Message> {
    let bytes = storage::read(path, LARGEST_MODEL_BYTES).map_err(|error| error.message())?;
    match ModelFormat::of(&bytes) {
        Some(ModelFormat::Gltf) => gltf_in::contents(&bytes),
        _ => Ok(Contents::default()),
    }
}

/// Writes a document as a model, in the format that the path's ending names. Returns what is to be said of it.
///
/// # Errors
/// Why it was not written; a regular file is then unchanged.
pub fn write(path: &Path, document: &Document) -> Result<Vec<Message>, Message> {
    let Document { scene, keyframes, interpolation, ms_between_keyframes, .. } = document;
    let animation = Animation {
        keyframes: keyframes.clone(),
        interpolation: *interpolation,
        ms_between_keyframes: *ms_between_keyframes,
    };
    let animation = keyframes.timing().is_some().then_some(&animation);
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default();
    let name = scene_name(path);
    let export = Export { animation: animation.map(|animation| (animation, &*name)), ..Export::of(scene) };
    let (written, mut said) = match &*ending {
        "bvh" => {
            let text = BvhText::new(scene, animation, None, DEFAULT_FRAMES_PER_SECOND)?;
            (storage::write_with(path, |out| text.write(out)), text.notes())
        }
        "glb" => {
            let (bytes, report) = export.glb();
            (storage::write(path, &bytes), report.messages())
        }
        "gltf" => {
            let (text, report) = export.gltf();
            (storage::write(path, text.as_bytes()), report.messages())
        }
        _ => return Err(texts::FILE_MODEL_ENDING.into()),
    };
    written.map_err(|error| error.message())?;
    said.push(texts::file_model_written(path.display()));
    Ok(said)
}

/// The name of a scene made of a file.
#[must_use]
pub fn scene_name(file: &Path) -> String {
    let stem = file.file_stem().filter(|_| !is_standard(file));
    stem.map_or_else(|| "model".to_owned(), |stem| stem.to_string_lossy().into_owned())
}

/// Reads files that a model names: in its folder or below it, all links followed, and nowhere else.
fn beside(model: &Path) -> impl FnMut(&str) -> Result<Vec<u8>, Message> {
    move |name: &str| {
        if storage::is_standard(model) {
            return Err(texts::gltf_in_no_folder(name));
        }
        let path = model.with_file_name(name);
        let folder = model.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        if storage::exists(&path) && storage::inside(&path, folder).is_none() {
            return Err(texts::gltf_in_outside(name));
        }
        storage::read(&path, LARGEST_MODEL_BYTES).map_err(|error| texts::gltf_in_file(name, error.message()))
    }
}
