//! A whole file: its JSON, and the bytes of its buffers.

use std::borrow::Cow;

use thiserror::Error;

use super::container::{Container, decoded_data_uri};
use super::json::{Index, Root};
use super::uri::relative_path;
use crate::decode;
use crate::words::{Message, display_by_message, texts};

/// The most bytes of all buffers together. Files that several buffers name count several times.
pub const MOST_BUFFER_BYTES: usize = 1 << 30;

/// The most numbers that all meshes and animations have together once they are read. Accessors that several of them name count several
/// times, and so do indices, of which each may become a vertex.
pub const MOST_NUMBERS: usize = 1 << 27;
/// The most numbers of a vertex.
const NUMBERS_OF_A_VERTEX: usize = 20;

/// The extensions that are read wherever a file needs them.
pub const UNDERSTOOD: [&str; 4] =
    ["KHR_materials_emissive_strength", "KHR_materials_unlit", "KHR_mesh_quantization", "KHR_texture_transform"];
/// Extensions that compress, which other programs can undo.
const COMPRESSIONS: [&str; 3] = ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"];

/// What is wrong with a glTF file, and where.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub struct GltfError {
    /// The place in the JSON, such as `/meshes/0/primitives/1`; empty where the file as a whole is meant.
    pub at: String,
    /// What is wrong there.
    pub problem: Message,
}

display_by_message!(GltfError);

impl GltfError {
    /// A problem at a place in the JSON.
    #[must_use]
    pub fn new(at: impl Into<String>, problem: impl Into<Message>) -> Self {
        Self { at: at.into(), problem: problem.into() }
    }

    /// A place that names something that the file does not have.
    #[must_use]
    pub fn leads_nowhere(at: impl Into<String>, to: &str) -> Self {
        Self::new(at, texts::gltf_leads_nowhere(to))
    }

    /// The error as a message with its place.
    #[must_use]
    pub fn message(&self) -> Message {
        if self.at.is_empty() { self.problem.clone() } else { texts::gltf_at(&self.at, self.problem.clone()) }
    }
}

/// Reads a file that a glTF file names: a path relative to its folder, made safe by [`relative_path`].
pub type ReadFile<'a> = dyn FnMut(&str) -> Result<Vec<u8>, Message> + 'a;

/// A glTF file with its buffers.
#[derive(Clone, Debug)]
pub struct Document<'a> {
    /// The JSON. Its indices are not checked.
    pub root: Root,
    buffers: Vec<Cow<'a, [u8]>>,
}

impl<'a> Document<'a> {
    /// Reads a file, text or binary, and its buffers.
    ///
    /// # Errors
    /// [`GltfError`]: it is no glTF 2.0, it needs an extension that is not understood, a buffer cannot be read or is shorter than it says.
    pub fn read(file: &'a [u8], read_file: &mut ReadFile<'_>) -> Result<Self, GltfError> {
        let container = Container::of(file).map_err(|error| GltfError::new("", error.message()))?;
        let root: Root = decode::json(container.json).map_err(|error| GltfError::new("", error.message()))?;
        check_version(&root)?;
        if let Some(name) = root.extensions_required.iter().find(|name| !UNDERSTOOD.contains(&name.as_str())) {
            let is_compression = COMPRESSIONS.contains(&name.as_str());
            let problem = if is_compression { texts::gltf_compressed(name) } else { texts::gltf_needs(name) };
            return Err(GltfError::new("/extensionsRequired", problem));
        }
        check_amount(&root)?;
        let buffers = buffers(&root, container.binary, read_file)?;
        Ok(Self { root, buffers })
    }

    /// The bytes of a buffer view, and its stride if it states one.
    ///
    /// # Errors
    /// [`GltfError`]: there is no such view, or it goes beyond its buffer.
    pub fn view(&self, view: Index) -> Result<(&[u8], Option<usize>), GltfError> {
        let at = format!("/bufferViews/{view}");
        let Some(json) = self.root.buffer_views.get(view) else {
            return Err(GltfError::new("/bufferViews", texts::gltf_leads_nowhere(&at)));
        };
        let Some(buffer) = self.buffers.get(json.buffer) else {
            return Err(GltfError::leads_nowhere(at, &format!("/buffers/{}", json.buffer)));
        };
        let start = json.byte_offset.unwrap_or(0);
        let bytes = start.checked_add(json.byte_length).and_then(|end| buffer.get(start..end));
        let bytes = bytes.ok_or_else(|| {
            GltfError::new(at, texts::gltf_short(start.saturating_add(json.byte_length), buffer.len()))
        })?;
        Ok((bytes, json.byte_stride))
    }
}

/// Whether a version is one of glTF 2.
fn check_version(root: &Root) -> Result<(), GltfError> {
    let version = &root.asset.version;
    let least = root.asset.min_version.as_deref().unwrap_or("2.0");
    if version.split('.').next() != Some("2") {
        return Err(GltfError::new("/asset/version", texts::gltf_version(version)));
    }
    if least != "2.0" {
        return Err(GltfError::new("/asset/minVersion", texts::gltf_version(least)));
    }
    Ok(())
}

/// Whether all meshes and animations together are of a size that fits into memory.
fn check_amount(root: &Root) -> Result<(), GltfError> {
    let count = |accessor: &Index| root.accessors.get(*accessor).map_or(0, |accessor| accessor.count);
    let primitives = root.meshes.iter().flat_map(|mesh| &mesh.primitives).map(|primitive| {
        let vertices = primitive.attributes.values().map(count).max().unwrap_or(0);
        primitive.indices.as_ref().map_or(0, count).max(vertices).saturating_mul(NUMBERS_OF_A_VERTEX)
    });
    let samplers = root
        .animations
        .iter()
        .flat_map(|animation| &animation.samplers)
        .map(|sampler| count(&sampler.input).saturating_add(count(&sampler.output).saturating_mul(4)));
    let numbers = primitives.chain(samplers).fold(0_usize, usize::saturating_add);
    if numbers > MOST_NUMBERS {
        return Err(GltfError::new("", texts::gltf_too_many_numbers(MOST_NUMBERS)));
    }
    Ok(())
}

fn buffers<'a>(
    root: &Root,
    binary: Option<&'a [u8]>,
    read_file: &mut ReadFile<'_>,
) -> Result<Vec<Cow<'a, [u8]>>, GltfError> {
    let mut total = 0_usize;
    let mut buffers = Vec::new();
    for (index, buffer) in root.buffers.iter().enumerate() {
        let error = |problem| GltfError::new(format!("/buffers/{index}"), problem);
        total = total.saturating_add(buffer.byte_length);
        if total > MOST_BUFFER_BYTES {
            return Err(error(texts::gltf_buffers_too_large(MOST_BUFFER_BYTES >> 20)));
        }
        let mut bytes = match &buffer.uri {
            None if index == 0 => Cow::Borrowed(binary.ok_or_else(|| error(texts::GLTF_BUFFER_WITHOUT_BYTES.into()))?),
            None => return Err(error(texts::GLTF_BUFFER_WITHOUT_BYTES.into())),
            Some(uri) => Cow::Owned(bytes_of(uri, read_file).map_err(error)?),
        };
        if bytes.len() < buffer.byte_length {
            return Err(error(texts::gltf_short(buffer.byte_length, bytes.len())));
        }
        match &mut bytes {
            Cow::Borrowed(bytes) => *bytes = &bytes[..buffer.byte_length],
            Cow::Owned(bytes) => bytes.truncate(buffer.byte_length),
        }
        buffers.push(bytes);
    }
    Ok(buffers)
}

/// The bytes that a URI leads to.
pub(super) fn bytes_of(uri: &str, read_file: &mut ReadFile<'_>) -> Result<Vec<u8>, Message> {
    match decoded_data_uri(uri) {
        Some(decoded) => decoded.map_err(|error| error.message()),
        None => read_file(&relative_path(uri)?),
    }
}
