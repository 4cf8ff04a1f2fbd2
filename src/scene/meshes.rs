//! The meshes of a scene file: a binary glTF file beside it, or the same bytes within it.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use thiserror::Error;

use super::file::scene_with_meshes;
use super::graph::SceneGraph;
use super::write::{scene_to_json, scene_to_json_beside};
use crate::gltf::decoded_data_uri;
use crate::model::MeshLibrary;
use crate::words::{Message, display_by_message, quoted, texts};

/// The largest file of meshes that is read: 128 MiB. Within a scene's text it is a third longer.
pub const LARGEST_MESHES_BYTES: u64 = 128 << 20;

/// The media type of meshes that stand within the text of a scene.
pub(super) const MEDIA_TYPE: &str = "model/gltf-binary";

/// Why a scene has not its meshes.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum MeshesError {
    /// The file says an older version, which has no meshes.
    Version,
    /// The name is not that of a file in the scene's own folder.
    Name {
        /// The name in the file.
        name: String,
    },
    /// The file cannot be read, or holds no meshes.
    File {
        /// Its name.
        name: String,
        /// Why.
        reason: Message,
    },
    /// The data URI holds no meshes.
    Within {
        /// Why.
        reason: Message,
    },
}

display_by_message!(MeshesError);

impl MeshesError {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::Version => texts::SCENE_MESHES_NEED_VERSION_3.into(),
            Self::Name { name } => texts::scene_meshes_name(quoted(name)),
            Self::File { name, reason } => texts::scene_meshes_file(quoted(name), reason.clone()),
            Self::Within { reason } => texts::scene_meshes_within(reason.clone()),
        }
    }
}

/// The meshes that the field `meshes` of a scene file names or holds.
pub(super) fn meshes_of(
    text: &str,
    read: impl FnOnce(&str) -> Result<Vec<u8>, Message>,
) -> Result<MeshLibrary, MeshesError> {
    if let Some(decoded) = decoded_data_uri(text) {
        let library = decoded.map_err(|error| error.message()).and_then(|bytes| library(&bytes));
        return library.map_err(|reason| MeshesError::Within { reason });
    }
    if !is_file_name(text) {
        return Err(MeshesError::Name { name: text.to_owned() });
    }
    let library = read(text).and_then(|bytes| library(&bytes));
    library.map_err(|reason| MeshesError::File { name: text.to_owned(), reason })
}

/// Whether a name can only be that of a file in the folder itself, on any system.
fn is_file_name(name: &str) -> bool {
    !matches!(name, "" | "." | "..") && !name.contains(|c: char| matches!(c, '/' | '\\' | ':') || c.is_control())
}

fn library(bytes: &[u8]) -> Result<MeshLibrary, Message> {
    MeshLibrary::from_glb(bytes).map_err(|error| error.message())
}

/// What is written for a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneFiles {
    /// The text of the scene.
    pub text: String,
    /// The file beside it that has the meshes; `None` where the text has them, or the scene has none.
    pub meshes: Option<MeshesFile>,
}

/// A file of meshes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshesFile {
    /// Where it is.
    pub path: PathBuf,
    /// Its bytes.
    pub glb: Arc<[u8]>,
}

impl SceneFiles {
    /// What is written for a scene at a path. Meshes go to `STEM.glb` in the same folder. They stay in the text where there is no such
    /// name: on standard output, for a scene that is called so itself, and where the name is not Unicode.
    #[must_use]
    pub fn new(scene: &SceneGraph, path: &Path) -> Self {
        let beside = path.with_extension("glb");
        let name = beside.file_name().and_then(OsStr::to_str).filter(|name| is_file_name(name));
        match (scene.meshes(), name) {
            (Some(meshes), Some(name)) if beside != path && path != Path::new("-") => Self {
                text: scene_to_json_beside(scene, name),
                meshes: Some(MeshesFile { glb: Arc::clone(&meshes.glb), path: beside }),
            },
            _ => Self { text: scene_to_json(scene), meshes: None },
        }
    }
}

/// The bytes of a scene file with its meshes within, so that they are all of the scene. `read_meshes` is as for [`scene_with_meshes`].
///
/// # Errors
/// Why the scene cannot be read, if it names meshes.
pub fn with_meshes_within(
    bytes: Vec<u8>,
    read_meshes: impl FnOnce(&str) -> Result<Vec<u8>, Message> + Send,
) -> Result<Vec<u8>, Message> {
    const FIELD: &[u8] = b"\"meshes\"";
    if !bytes.windows(FIELD.len()).any(|window| window == FIELD) {
        return Ok(bytes);
    }
    let scene = scene_with_meshes(&bytes, read_meshes).map_err(|error| error.message())?;
    Ok(if scene.meshes().is_some() { scene_to_json(&scene).into_bytes() } else { bytes })
}
