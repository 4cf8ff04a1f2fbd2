//! Keyframe files, and texts that are read as such.

use std::path::Path;

use super::FileError;
use crate::export::Animation;
use crate::interpolation::Interpolation;
use crate::keyframe::{KeyframeFile, LARGEST_FILE_BYTES, PlayRange, keyframes_from_json};
use crate::scene::SceneGraph;
use crate::storage;
use crate::text_layouts::{Reading, read_keyframes};

/// Reads a keyframe file.
///
/// # Errors
/// [`FileError`] with everything that is wrong with it.
pub fn keyframe_file(file: &Path, scene: &SceneGraph) -> Result<KeyframeFile, FileError> {
    let bytes = super::read(file, LARGEST_FILE_BYTES)?;
    keyframes_from_json(&bytes, scene).map_err(|problems| FileError::all(storage::input_name(file), problems))
}

/// Reads keyframes: a keyframe file, or a text in any layout that `convert` reads.
///
/// # Errors
/// [`FileError`] with everything that is wrong with it.
pub fn keyframes_of_any_layout(file: &Path, scene: &SceneGraph) -> Result<Reading, FileError> {
    let bytes = super::read(file, LARGEST_FILE_BYTES)?;
    read_keyframes(&bytes, scene).map_err(|problems| FileError::all(storage::input_name(file), problems))
}

impl Animation {
    /// Reads a keyframe file, with defaults where it does not say; `interpolation`, where given, replaces the file's.
    ///
    /// # Errors
    /// [`FileError`]
    pub fn load(file: &Path, scene: &SceneGraph, interpolation: Option<Interpolation>) -> Result<Self, FileError> {
        let (keyframes, in_file, ms_between_keyframes) = keyframe_file(file, scene)?.into_parts();
        Ok(Self { keyframes, interpolation: interpolation.unwrap_or(in_file), ms_between_keyframes })
    }

    /// The part that plays; `file` is for the error.
    ///
    /// # Errors
    /// [`FileError`]: fewer than 4 keyframes.
    pub fn play_range(&self, file: &Path) -> Result<PlayRange<'_>, FileError> {
        PlayRange::new(&self.keyframes).map_err(|error| FileError::new(storage::input_name(file), error))
    }
}
