//! The running export: on a thread and a device of its own, so that the window goes on meanwhile.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};

use super::UserEvent;
use super::shell::Shell;
use crate::editor::Severity;
use crate::export::Job;
use crate::film::{ExportEnd, ExportOptions};
use crate::storage;
use crate::ui::Exporting;
use crate::words::{Message, texts};

/// The shortest time between two progress events.
const MOST_NEWS: usize = 200;

/// A running export.
#[derive(Debug)]
pub struct Export {
    thread: JoinHandle<()>,
    is_ending: Arc<AtomicBool>,
    path: PathBuf,
}

impl Export {
    /// Cancels it, and waits until its partial files are removed.
    pub fn end(self) {
        self.is_ending.store(true, Ordering::Relaxed);
        // A thread that panicked has ended as well.
        let _ = self.thread.join();
    }
}

impl Shell {
    /// Begins an export of the document as it is now.
    pub(super) fn export(&mut self, options: ExportOptions) {
        if self.export.is_some() {
            self.editor.say(Message::from(texts::FILE_EXPORT_BEGUN_ALREADY).with_severity(Severity::Error));
            return;
        }
        let editor = &self.editor;
        let job = Job::new(Arc::clone(editor.scene()), editor.animation(), editor.keyframe_file().to_owned(), options);
        let path = job.path().to_owned();
        let is_ending = Arc::new(AtomicBool::new(false));
        let (asked, proxy) = (Arc::clone(&is_ending), self.proxy.clone());
        let thread = thread::spawn(move || {
            let mut news = None;
            let mut watch = |done: usize, count: usize| {
                let now = done * MOST_NEWS / count.max(1);
                if news.replace(now) != Some(now) {
                    // If the window is gone, nothing receives it.
                    let _ = proxy.send_event(UserEvent::ExportAt { done, count });
                }
                !asked.load(Ordering::Relaxed)
            };
            let end = catch_unwind(AssertUnwindSafe(|| job.run(&mut watch)))
                .unwrap_or_else(|_| ExportEnd::Failed(texts::EXPORT_PROGRAM_FAILED.into()));
            let _ = proxy.send_event(UserEvent::ExportEnded(end));
        });
        self.export = Some(Export { thread, is_ending, path });
        self.export_at(0, 0);
    }

    /// Reports the export's progress in frames.
    pub(super) fn export_at(&mut self, done: usize, count: usize) {
        self.ui.exporting = self.export.as_ref().map(|export| Exporting {
            path: export.path.clone(),
            done,
            count,
            is_ending: export.is_ending.load(Ordering::Relaxed),
        });
    }

    pub(super) fn cancel_running_export(&mut self) {
        if let (Some(export), Some(shown)) = (&self.export, &mut self.ui.exporting) {
            export.is_ending.store(true, Ordering::Relaxed);
            shown.is_ending = true;
        }
    }

    pub(super) fn export_ended(&mut self, end: ExportEnd) {
        if let Some(export) = self.export.take() {
            if matches!(end, ExportEnd::Written(_)) {
                self.ui.made = Some(storage::absolute(&export.path));
            }
            self.editor.exported(&export.path, end);
            export.end();
        }
        self.ui.exporting = None;
    }
}
