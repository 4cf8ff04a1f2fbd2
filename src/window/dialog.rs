//! The system's dialogs for files, each in a thread of its own, since they wait.

use std::path::Path;
use std::thread;
use std::time::Duration;

use rfd::FileDialog;
use winit::event_loop::EventLoopProxy;

use super::{UserEvent, now};
use crate::storage;
use crate::ui::PathPurpose;
use crate::ui::words::Words;
use crate::words::texts;

/// If a dialog is cancelled faster than this, it was not the user: the system has no dialog.
pub const TOO_FAST_FOR_A_USER: Duration = Duration::from_millis(150);

/// What the system is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Question {
    /// Keyframes.
    Keyframes(PathPurpose),
    /// A film to write.
    Film,
    /// A folder for a film's frames.
    Folder,
}

/// Asks the system for a path; the answer comes as [`UserEvent::PathChosen`].
pub fn ask(question: Question, current: &Path, words: Words, proxy: EventLoopProxy<UserEvent>) {
    let folder = current.parent().filter(|folder| storage::is_folder(folder)).map(Path::to_owned);
    let name = current.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    thread::spawn(move || {
        let start = now();
        let kind = match question {
            Question::Keyframes(PathPurpose::Open | PathPurpose::Compare | PathPurpose::SaveAs) => {
                Some(texts::KEYFRAME_FILES)
            }
            Question::Keyframes(PathPurpose::SaveSceneAs | PathPurpose::OpenScene) => Some(texts::SCENE_FILES),
            Question::Film | Question::Folder => None,
        };
        let mut dialog = FileDialog::new();
        if let Some(kind) = kind {
            dialog = dialog.add_filter(words.say(kind), &["json"]);
        }
        if matches!(question, Question::Keyframes(PathPurpose::Open | PathPurpose::Compare)) {
            dialog = dialog.add_filter(words.say(texts::KEYFRAMES_AS_TEXT), &["txt", "csv"]);
        }
        dialog = dialog.add_filter(words.say(texts::ALL_FILES), &["*"]);
        if let Some(folder) = folder {
            dialog = dialog.set_directory(folder);
        }
        let path = match question {
            Question::Keyframes(PathPurpose::Open | PathPurpose::Compare | PathPurpose::OpenScene) => {
                dialog.pick_file()
            }
            Question::Keyframes(PathPurpose::SaveAs | PathPurpose::SaveSceneAs) | Question::Film => {
                dialog.set_file_name(name).save_file()
            }
            Question::Folder => dialog.pick_folder(),
        };
        // Where the window is gone, so is the question.
        let _ = proxy.send_event(UserEvent::PathChosen { question, path, took: start.elapsed() });
    });
}
