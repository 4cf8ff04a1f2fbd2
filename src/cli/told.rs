//! What the commands for models of other programs have in common: they write keyframes, and tell what was done.

use std::path::Path;
use std::sync::Arc;

use serde_json::{Value, json};

use super::{CliError, Common, output};
use crate::keyframe::{Animation, KeyframesText, LARGEST_FILE_BYTES};
use crate::scene::SceneGraph;
use crate::storage;
use crate::words::{Message, texts};

/// Writes a keyframe file.
///
/// # Errors
/// [`CliError`]: it would be too large to be read, or cannot be written.
pub fn write_keyframes(target: &Path, scene: &SceneGraph, animation: Animation) -> Result<(), CliError> {
    let Animation { keyframes, interpolation, ms_between_keyframes } = animation;
    let text = KeyframesText { scene: Arc::new(scene.clone()), keyframes, interpolation, ms_between_keyframes };
    if !text.can_be_read() {
        return Err(CliError::bad_input(target.display(), texts::model_too_large(LARGEST_FILE_BYTES >> 20)));
    }
    storage::write_with(target, |file| write!(file, "{text}")).map_err(|reason| CliError::unwritten(target, reason))
}

/// A report: sentences about an input, and its fields as JSON.
pub struct Report<'a> {
    /// The input's name.
    pub name: String,
    /// The sentences.
    pub notes: Vec<Message>,
    /// The fields of the JSON object besides the notes.
    pub fields: Value,
    /// Whether JSON is asked for.
    pub is_json: bool,
    /// The outputs: where one of them is standard output, the report goes to standard error.
    pub data: Vec<&'a Path>,
}

impl Report<'_> {
    /// Prints it: the sentences, a line each, or JSON.
    ///
    /// # Errors
    /// [`CliError`]: standard output does not take it.
    pub fn tell(self, common: Common<'_>) -> Result<(), CliError> {
        let Self { name, notes, mut fields, is_json, data } = self;
        let said = if is_json {
            fields["notes"] = notes.iter().map(ToString::to_string).collect::<Vec<_>>().into();
            fields["input"] = json!(name);
            format!("{fields}\n")
        } else if common.is_quiet {
            return Ok(());
        } else {
            notes.iter().flat_map(|note| [name.clone(), format!(": {note}\n")]).collect()
        };
        let standard = data.into_iter().find(|path| storage::is_standard(path));
        output::say_beside(standard, &said)
    }
}
