//! Keyframes for every command that reads them: a keyframe file, or a text in any layout.

use std::path::Path;

use super::{Common, output};
use crate::files::{self, FileError};
use crate::scene::SceneGraph;
use crate::storage::input_name;
use crate::text_layouts::Reading;
use crate::words::texts;

/// What was inferred from texts, as lines for standard error.
#[derive(Debug, Default)]
pub struct Notes(Vec<String>);

impl Notes {
    /// Adds warnings about a file.
    pub fn warn<'a>(&mut self, name: &str, warnings: impl IntoIterator<Item = &'a str>) {
        self.0.extend(warnings.into_iter().map(|warning| format!("{name}: warning: {warning}")));
    }

    /// Says them.
    pub fn say(&self) {
        if !self.0.is_empty() {
            output::complain(&self.0.join("\n"));
        }
    }
}

/// Reads keyframes. What was inferred from a text becomes a note, and so do warnings, which a person should check: these also where a
/// command is to be quiet.
///
/// # Errors
/// [`FileError`] with everything that is wrong with the file.
pub fn noted_keyframes(
    file: &Path,
    scene: &SceneGraph,
    common: Common<'_>,
    notes: &mut Notes,
) -> Result<Reading, FileError> {
    let reading = files::keyframes(file, scene)?;
    let name = input_name(file);
    if let (Some(report), false) = (&reading.report, common.is_quiet) {
        notes.0.push(texts::reading_as_text(&name, report.summary.clone()).to_string());
    }
    notes.warn(&name, reading.warnings());
    Ok(reading)
}

/// Reads keyframes as [`noted_keyframes`] does, and says the notes.
///
/// # Errors
/// [`FileError`] with everything that is wrong with the file.
pub fn keyframes(file: &Path, scene: &SceneGraph, common: Common<'_>) -> Result<Reading, FileError> {
    let mut notes = Notes::default();
    let reading = noted_keyframes(file, scene, common, &mut notes)?;
    notes.say();
    Ok(reading)
}
