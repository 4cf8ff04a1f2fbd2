//! The manifest of a render as JSON: adapter, versions and file hashes, so that differing pictures can be explained.

use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::super::CliError;
use crate::export::{Painter, Size};
use crate::files::LARGEST_IMAGE_BYTES;
use crate::storage;

/// The adapter, the versions and the files written so far.
pub struct Manifest {
    about: Value,
    files: Vec<(PathBuf, String)>,
}

impl Manifest {
    /// No files yet. Pictures have a size.
    pub fn new(painter: &Painter, size: Size) -> Self {
        let info = &painter.gpu().info;
        let about = json!({
            "format": "inbetween.rendered",
            "version": 1,
            "program": {"name": env!("CARGO_PKG_NAME"), "version": env!("CARGO_PKG_VERSION")},
            "adapter": {
                "name": info.name,
                "kind": format!("{:?}", info.device_type),
                "backend": info.backend.to_str(),
                "driver": info.driver,
                "driver_version": info.driver_info,
            },
            "size": [size.width, size.height],
            "samples": painter.samples(),
        });
        Self { about, files: Vec::new() }
    }

    /// Adds a file that was just written with these bytes.
    pub fn add(&mut self, path: &Path, bytes: &[u8]) {
        self.files.push((path.to_owned(), storage::sha256(bytes)));
    }

    /// Adds a file that was just written.
    ///
    /// # Errors
    /// [`CliError`]: it cannot be read back.
    pub fn add_file(&mut self, path: &Path) -> Result<(), CliError> {
        let bytes =
            storage::read(path, 64 * LARGEST_IMAGE_BYTES).map_err(|reason| CliError::unwritten(path, reason))?;
        self.add(path, &bytes);
        Ok(())
    }

    /// Writes it.
    ///
    /// # Errors
    /// [`CliError`]: it cannot be written.
    pub fn write(mut self, path: &Path) -> Result<(), CliError> {
        let files = self.files.iter().map(|(path, hash)| json!({"path": path.to_string_lossy(), "sha256": hash}));
        self.about["files"] = files.collect();
        let text = format!("{:#}\n", self.about);
        storage::write(path, text.as_bytes()).map_err(|reason| CliError::unwritten(path, reason))
    }
}
