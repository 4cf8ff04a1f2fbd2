//! Keyframe files as the commands read them.

use std::path::Path;

use super::CliError;
use crate::export::Animation;
use crate::interpolation::Interpolation;
use crate::keyframe::{KeyframeFile, LARGEST_FILE_BYTES, PlayRange, keyframes_from_json};
use crate::scene::SceneGraph;
use crate::storage;

/// Reads a keyframe file.
///
/// # Errors
/// What is wrong with it: a sentence a problem, without the file's name; never empty.
pub fn read(file: &Path, scene: &SceneGraph) -> Result<KeyframeFile, Vec<String>> {
    let bytes = storage::read(file, LARGEST_FILE_BYTES).map_err(|error| vec![error.to_string()])?;
    keyframes_from_json(&bytes, scene).map_err(|problems| problems.iter().map(ToString::to_string).collect())
}

impl Animation {
    /// What a keyframe file says, with defaults where it does not; `interpolation`, where given, takes the place of what it says.
    ///
    /// # Errors
    /// [`CliError::BadInput`]
    pub(super) fn load(
        file: &Path,
        scene: &SceneGraph,
        interpolation: Option<Interpolation>,
    ) -> Result<Self, CliError> {
        let place = file.display();
        let (keyframes, in_file, ms_between_keyframes) = read(file, scene)
            .map_err(|problems| CliError::BadInput {
                sentences: problems.iter().map(|problem| format!("{place}: {problem}")).collect(),
            })?
            .into_parts();
        Ok(Self { keyframes, interpolation: interpolation.unwrap_or(in_file), ms_between_keyframes })
    }

    /// The part that plays.
    ///
    /// # Errors
    /// [`CliError::BadInput`] below 4 keyframes.
    pub(super) fn play_range(&self, file: &Path) -> Result<PlayRange<'_>, CliError> {
        PlayRange::new(&self.keyframes).map_err(|error| CliError::bad_input(file.display(), error))
    }
}
