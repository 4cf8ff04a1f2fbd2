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

    /// Adds what was inferred from a file, and warnings about it.
    fn note(&mut self, file: &Path, reading: &Reading, common: Common<'_>) {
        let name = input_name(file);
        if let (Some(report), false) = (&reading.report, common.is_quiet) {
            self.0.push(texts::reading_as_text(&name, report.summary.clone()).to_string());
        }
        self.warn(&name, reading.warnings());
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
    notes.note(file, &reading, common);
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

/// The same of bytes that were read already.
///
/// # Errors
/// [`FileError`] with everything that is wrong with the file.
pub fn keyframes_in(bytes: &[u8], file: &Path, scene: &SceneGraph, common: Common<'_>) -> Result<Reading, FileError> {
    let mut notes = Notes::default();
    let reading = files::keyframes_in(bytes, file, scene)?;
    notes.note(file, &reading, common);
    notes.say();
    Ok(reading)
}
