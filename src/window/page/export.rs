//! Films of a page: a frame a turn of the event loop, on the page's device.

use std::path::PathBuf;
use std::sync::Arc;

use crate::editor::Severity;
use crate::export::{Job, Step, Steps};
use crate::film::{ExportEnd, ExportOptions};
use crate::storage;
use crate::ui::Exporting;
use crate::window::shell::Shell;
use crate::words::{Message, texts};

/// A running export.
pub struct Export {
    steps: Steps,
    path: PathBuf,
    is_ending: bool,
}

impl Export {
    /// Cancels it: nothing of it is written yet.
    pub fn end(self) {}
}

impl Shell {
    /// Begins an export of the document as it is now.
    pub(in crate::window) fn export(&mut self, options: ExportOptions) {
        if self.export.is_some() {
            self.editor.say(Message::from(texts::FILE_EXPORT_BEGUN_ALREADY).with_severity(Severity::Error));
            return;
        }
        let Some(stage) = &self.stage else { return };
        let editor = &self.editor;
        let job = Job::new(Arc::clone(editor.scene()), editor.animation(), editor.keyframe_file().to_owned(), options);
        let path = job.path().to_owned();
        match Steps::new(job, stage.device()) {
            Ok(steps) => {
                self.export = Some(Export { steps, path, is_ending: false });
                self.export_at(0, 0);
            }
            Err(end) => self.editor.exported(&path, end),
        }
    }

    /// The device is gone: the export waits for another one.
    pub(in crate::window) fn suspend_export(&mut self) {
        if let Some(export) = &mut self.export {
            export.steps.suspend();
        }
    }

    /// Goes on with an export that waits for a device.
    pub(in crate::window) fn resume_export(&mut self) {
        let (Some(export), Some(stage)) = (&mut self.export, &self.stage) else { return };
        if let Err(end) = export.steps.resume(stage.device()) {
            self.export_ended(end);
        }
    }

    /// Goes on with the export, if one runs.
    pub(in crate::window) fn step_export(&mut self) {
        let Some(export) = &mut self.export else { return };
        let step = if export.is_ending { Step::Ended(ExportEnd::Cancelled(0)) } else { export.steps.step() };
        match step {
            Step::Drawn(done, count) => self.export_at(done, count),
            Step::Ended(end) => self.export_ended(end),
        }
        self.request_redraw();
    }

    pub(in crate::window) fn export_at(&mut self, done: usize, count: usize) {
        self.ui.exporting = self.export.as_ref().map(|export| Exporting {
            path: export.path.clone(),
            done,
            count,
            is_ending: export.is_ending,
        });
    }

    pub(in crate::window) fn cancel_running_export(&mut self) {
        if let (Some(export), Some(shown)) = (&mut self.export, &mut self.ui.exporting) {
            export.is_ending = true;
            shown.is_ending = true;
        }
    }

    pub(in crate::window) fn export_ended(&mut self, end: ExportEnd) {
        if let Some(export) = self.export.take() {
            if matches!(end, ExportEnd::Written(_)) {
                self.ui.made = Some(storage::absolute(&export.path));
            }
            self.editor.exported(&export.path, end);
        }
        self.ui.exporting = None;
    }
}
