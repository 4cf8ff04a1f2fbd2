//! Files beside a model of another program.

use std::path::Path;

use crate::interchange::gltf_in::LARGEST_MODEL_BYTES;
use crate::storage;
use crate::words::{Message, texts};

/// Reads files that a model names: in its folder or below it, all links followed, and nowhere else.
pub fn beside(model: &Path) -> impl FnMut(&str) -> Result<Vec<u8>, Message> {
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
