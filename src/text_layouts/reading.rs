//! Keyframes out of what others wrote: the one door through which `diff`, `diagnose` and `grade` read them.

use crate::keyframe::KeyframeFile;
use crate::scene::SceneGraph;
use crate::text_layouts::{Certainty, Imported, Options, Report, import};

/// Keyframes, and what was inferred of the text that they are from.
#[derive(Clone, Debug)]
pub struct Reading {
    /// The keyframes.
    pub file: KeyframeFile,
    /// What was inferred; nothing of this program's own format.
    pub report: Option<Report>,
}

impl Reading {
    /// What should be looked at: a sentence each.
    pub fn warnings(&self) -> Vec<&str> {
        let findings = self.report.iter().flat_map(|report| &report.findings);
        findings
            .filter(|finding| finding.certainty == Certainty::Warning)
            .map(|finding| finding.text.as_str())
            .collect()
    }
}

/// Reads keyframes for a scene: this program's own format, or any layout of text that `convert` reads.
///
/// # Errors
/// What is wrong: a sentence a problem; never empty.
pub fn keyframes(bytes: &[u8], scene: &SceneGraph) -> Result<Reading, Vec<String>> {
    match import(bytes, scene, &Options::default()).map_err(|error| error.sentences())? {
        Imported::KeyframeFile(file) => Ok(Reading { file, report: None }),
        Imported::Text(file, report) => Ok(Reading { file, report: Some(report) }),
        Imported::Scene(..) => Err(vec!["these are the keys of a control node, not keyframes".to_owned()]),
    }
}
