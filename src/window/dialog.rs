//! The system's dialogs for files, each in a thread of its own, since they wait.

use std::path::Path;
use std::thread;
use std::time::Duration;

use rfd::FileDialog;
use winit::event_loop::EventLoopProxy;

use super::{Happening, now};
use crate::ui::PathPurpose;
use crate::ui::words::Words;

/// An answer of "nothing" within this time is no user's: the system has no dialog.
pub const TOO_FAST_FOR_A_USER: Duration = Duration::from_millis(150);

/// Asks the system for a path; the answer comes as [`Happening::PathChosen`].
pub fn ask(purpose: PathPurpose, current: &Path, words: Words, proxy: EventLoopProxy<Happening>) {
    let folder = current.parent().filter(|folder| folder.is_dir()).map(Path::to_owned);
    let name = current.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    thread::spawn(move || {
        let start = now();
        let kind = match purpose {
            PathPurpose::Open | PathPurpose::SaveAs => words.say("Keyframe files"),
            PathPurpose::SaveSceneAs => words.say("Scene files"),
        };
        let mut dialog = FileDialog::new().add_filter(kind, &["json"]);
        if purpose == PathPurpose::Open {
            dialog = dialog.add_filter(words.say("Keyframes as text"), &["txt", "csv"]);
        }
        dialog = dialog.add_filter(words.say("All files"), &["*"]);
        if let Some(folder) = folder {
            dialog = dialog.set_directory(folder);
        }
        let path = match purpose {
            PathPurpose::Open => dialog.pick_file(),
            PathPurpose::SaveAs | PathPurpose::SaveSceneAs => dialog.set_file_name(name).save_file(),
        };
        // Where the window is gone, so is the question.
        let _ = proxy.send_event(Happening::PathChosen { purpose, path, took: start.elapsed() });
    });
}
