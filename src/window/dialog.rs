//! The system's dialogs for files, each in a thread of its own, since they wait.

use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use rfd::FileDialog;
use winit::event_loop::EventLoopProxy;

use super::{UserEvent, now};
use crate::editor::MODEL_ENDINGS;
use crate::storage;
use crate::ui::PathPurpose;
use crate::ui::words::Words;
use crate::words::texts;

/// If a dialog is cancelled faster than this, it was not the user: the system has no dialog.
pub const TOO_FAST_FOR_A_USER: Duration = Duration::from_millis(150);

/// Asks the system for a path; the answer comes as [`UserEvent::PathChosen`].
pub fn ask(purpose: PathPurpose, proposed: PathBuf, words: Words, proxy: EventLoopProxy<UserEvent>) {
    let folder = proposed.parent().filter(|folder| storage::is_folder(folder)).map(Path::to_owned);
    let name = proposed.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    thread::spawn(move || {
        let start = now();
        let mut dialog = FileDialog::new();
        match purpose {
            PathPurpose::Open | PathPurpose::Compare | PathPurpose::SaveAs => {
                dialog = dialog.add_filter(words.say(texts::KEYFRAME_FILES), &["json"]);
            }
            PathPurpose::SaveSceneAs | PathPurpose::OpenScene => {
                dialog = dialog.add_filter(words.say(texts::SCENE_FILES), &["json"]);
            }
            PathPurpose::ExportModel | PathPurpose::Film | PathPurpose::FilmFolder => {}
        }
        if matches!(purpose, PathPurpose::Open | PathPurpose::OpenScene | PathPurpose::ExportModel) {
            dialog = dialog.add_filter(words.say(texts::MODEL_FILES), &MODEL_ENDINGS);
        }
        if matches!(purpose, PathPurpose::Open | PathPurpose::Compare) {
            dialog = dialog.add_filter(words.say(texts::KEYFRAMES_AS_TEXT), &["txt", "csv"]);
        }
        dialog = dialog.add_filter(words.say(texts::ALL_FILES), &["*"]);
        if let Some(folder) = folder {
            dialog = dialog.set_directory(folder);
        }
        let path = if purpose.is_folder() {
            dialog.pick_folder()
        } else if purpose.is_saving() {
            dialog.set_file_name(name).save_file()
        } else {
            dialog.pick_file()
        };
        // Where the window is gone, so is the question.
        let _ = proxy.send_event(UserEvent::PathChosen { purpose, proposed, path, took: start.elapsed() });
    });
}
