//! Reading of keyframes from any supported format, for `diff`, `diagnose` and `grade`.

use super::{Imported, Options, Report, import};
use crate::keyframe::KeyframeFile;
use crate::scene::SceneGraph;

/// Keyframes, and the inferences about their text.
#[derive(Clone, Debug)]
pub struct Reading {
    /// The content, as that of a keyframe file.
    pub file: KeyframeFile,
    /// The inferences; `None` for this program's own format.
    pub report: Option<Report>,
}

impl Reading {
    /// The findings that a person should check, one sentence each.
    #[must_use]
    pub fn warnings(&self) -> Vec<&str> {
        self.report.iter().flat_map(Report::warnings).collect()
    }
}

/// Reads keyframes for a scene: this program's own format, or any layout of text that `convert` reads.
///
/// # Errors
/// A message for each error; never empty.
pub fn read_keyframes(bytes: &[u8], scene: &SceneGraph) -> Result<Reading, Vec<String>> {
    match import(bytes, scene, &Options::of_keyframes()).map_err(|error| error.sentences())? {
        Imported::KeyframeFile(file) => Ok(Reading { file, report: None }),
        Imported::Text(file, report) => Ok(Reading { file, report: Some(report) }),
        Imported::Scene(..) => Err(vec!["these are the keys of a control node, not keyframes".to_owned()]),
    }
}
