//! Keyframes out of keyframe files and texts.

use std::path::Path;

use super::FileError;
use crate::export::Animation;
use crate::interpolation::Interpolation;
use crate::keyframe::{KeyframeFile, LARGEST_FILE_BYTES, PlayRange};
use crate::scene::SceneGraph;
use crate::storage;
use crate::text_layouts::{Reading, read_keyframes};

/// Reads keyframes: a keyframe file, or a text in any layout that `convert` reads.
///
/// # Errors
/// [`FileError`] with everything that is wrong with it.
pub fn keyframes(file: &Path, scene: &SceneGraph) -> Result<Reading, FileError> {
    keyframes_in(&super::read(file, LARGEST_FILE_BYTES)?, file, scene)
}

/// The same of bytes that were read already; `file` is for the error.
///
/// # Errors
/// [`FileError`] with everything that is wrong with it.
pub fn keyframes_in(bytes: &[u8], file: &Path, scene: &SceneGraph) -> Result<Reading, FileError> {
    read_keyframes(bytes, scene).map_err(|problems| FileError::all(storage::input_name(file), problems))
}

impl Animation {
    /// What a file holds, with defaults where it does not say; `interpolation`, where given, replaces the file's.
    #[must_use]
    pub fn of(file: KeyframeFile, interpolation: Option<Interpolation>) -> Self {
        let (keyframes, in_file, ms_between_keyframes) = file.into_parts();
        Self { keyframes, interpolation: interpolation.unwrap_or(in_file), ms_between_keyframes }
    }

    /// Reads keyframes as [`keyframes`] does.
    ///
    /// # Errors
    /// [`FileError`]
    pub fn load(file: &Path, scene: &SceneGraph, interpolation: Option<Interpolation>) -> Result<Self, FileError> {
        Ok(Self::of(keyframes(file, scene)?.file, interpolation))
    }

    /// The part that plays; `file` is for the error.
    ///
    /// # Errors
    /// [`FileError`]: fewer than 4 keyframes.
    pub fn play_range(&self, file: &Path) -> Result<PlayRange<'_>, FileError> {
        PlayRange::new(&self.keyframes).map_err(|error| FileError::new(storage::input_name(file), error))
    }
}
