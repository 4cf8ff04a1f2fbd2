//! Exports, as the editor sees them: what there is to export, and how it ended.

use std::path::Path;

use super::{CommandError, Editor, Severity};
use crate::film::ExportEnd;
use crate::keyframe::Animation;

impl Editor {
    /// What plays; `None` where the list is empty.
    #[must_use]
    pub fn animation(&self) -> Option<Animation> {
        let document = self.document();
        (!document.keyframes.is_empty()).then(|| Animation {
            keyframes: document.keyframes.clone(),
            interpolation: document.interpolation,
            ms_between_keyframes: document.ms_between_keyframes,
        })
    }

    /// Takes in how an export to a path ended.
    pub fn exported(&mut self, path: &Path, end: ExportEnd) {
        let path = path.display();
        match end {
            ExportEnd::Written(1) => self.say_of(Severity::Outcome, format!("Exported 1 frame to {path}.")),
            ExportEnd::Written(frames) => {
                self.say_of(Severity::Outcome, format!("Exported {frames} frames to {path}."));
            }
            ExportEnd::Cancelled(0) => {
                self.say_of(Severity::Outcome, "The export was cancelled: nothing of it is kept.".to_owned());
            }
            ExportEnd::Cancelled(frames) => {
                let text = format!("The export was cancelled: its first {frames} frames are in {path}.");
                self.say_of(Severity::Outcome, text);
            }
            ExportEnd::Failed(reason) => self.say_error(&CommandError::Export { reason }),
        }
    }
}
