//! Exports, as the editor sees them: what there is to export, and how it ended.

use std::path::Path;

use super::{CommandError, Editor};
use crate::film::ExportEnd;
use crate::keyframe::Animation;
use crate::words::texts;

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
            ExportEnd::Written(frames) => self.say_outcome(texts::file_exported(frames, path)),
            ExportEnd::Cancelled(0) => self.say_outcome(texts::FILE_EXPORT_CANCELLED),
            ExportEnd::Cancelled(frames) => self.say_outcome(texts::file_export_cancelled_within(frames, path)),
            ExportEnd::Failed(reason) => self.say_error(&CommandError::Export { reason }),
        }
    }
}
