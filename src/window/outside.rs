//! Files that other programs change: the question before they are replaced, and the offer to read them again.

use std::path::{Path, PathBuf};
use std::time::Duration;

use web_time::Instant;

use super::shell::Shell;
use crate::animation_diff::{Version, keyframe_differences, scene_differences};
use crate::editor::{
    Command, Edit, Editor, Effect, FileAccess, FileCommand, FileOutcome, Host as _, Severity, Writing, Written,
};
use crate::files;
use crate::keyframe::{KeyframeFile, KeyframeIndex, LARGEST_FILE_BYTES};
use crate::settings::Settings;
use crate::storage::{self, KnownFiles, OutsideChange, Place, Stamp};
use crate::text_layouts::{Imported, Options, import};
use crate::ui::{ChangeAnswer, ChangeOffer, OverwriteAnswer, OverwriteQuestion, OverwriteReason, QuitAnswer};
use crate::words::{Message, texts};

/// How often files are looked at while "Reload when it changes" is ticked.
const PERIOD: Duration = Duration::from_millis(500);

/// A write that waits for an answer, or a notice about which more is asked.
#[derive(Clone, Debug)]
struct Asked {
    is_scene: bool,
    path: PathBuf,
    /// Whether the window is to close after the file was written.
    is_quitting: bool,
}

/// A file that another program has changed.
#[derive(Clone, Debug)]
struct Notice {
    is_scene: bool,
    path: PathBuf,
    /// What the file was when it was last looked at.
    seen: Stamp,
    /// Whether the user was offered to read it, and said no, or reading it failed. Another change is offered again.
    is_answered: bool,
}

/// What the window knows of its files, and what it asks about them.
#[derive(Debug, Default)]
pub struct Outside {
    /// What the files were.
    pub known: KnownFiles,
    asked: Option<Asked>,
    /// The file that the user allowed to be replaced, once.
    allowed: Option<PathBuf>,
    is_quitting: bool,
    notices: Vec<Notice>,
    /// When files are looked at next.
    due: Option<Instant>,
}

impl Outside {
    /// Files as they are at the start.
    pub fn new(known: KnownFiles) -> Self {
        Self { known, ..Self::default() }
    }

    /// Forgets what files were: the document is another one.
    pub fn forget(&mut self) {
        self.known.forget_all();
        self.notices.clear();
    }

    /// What is written next is written because the window is to close, or not any more.
    pub fn set_quitting(&mut self, is_quitting: bool) {
        if is_quitting {
            self.asked = None;
        }
        self.is_quitting = is_quitting;
    }

    /// Whether a write waits for an answer.
    pub const fn is_asking(&self) -> bool {
        self.asked.is_some()
    }

    /// Whether a file was noticed that another program has changed.
    pub const fn has_noticed(&self) -> bool {
        !self.notices.is_empty()
    }
}

impl Shell {
    /// Writes a file, or asks first where it holds something that the user may not know of.
    pub(super) fn write_or_ask(&mut self, writing: Writing<'_>) -> Option<FileOutcome<Written>> {
        let reason = self.reason_to_ask(&writing);
        let is_allowed = self.outside.allowed.as_deref() == Some(writing.path);
        if let Some(reason) = reason.filter(|_| !is_allowed) {
            let is_scene = writing.access == FileAccess::SceneWritten;
            self.ask_before_overwriting(is_scene, writing.path, reason);
            return None;
        }
        let keeps = reason.is_some() || !writing.is_known || !self.outside.known.knows(writing.path);
        Some(files::write_known(&mut self.outside.known, writing, keeps))
    }

    fn reason_to_ask(&self, writing: &Writing<'_>) -> Option<OverwriteReason> {
        match self.outside.known.change(writing.path) {
            Some(OutsideChange::Appeared) => return Some(OverwriteReason::Appeared),
            Some(OutsideChange::Changed) => return Some(OverwriteReason::Changed),
            None => {}
        }
        let is_empty_list =
            writing.access == FileAccess::KeyframesWritten && self.editor.document().keyframes.is_empty();
        if !is_empty_list || !matches!(Place::of_output(writing.path), Place::File(_)) {
            return None;
        }
        let count = self.keyframes_of(writing.path).ok()?.keyframes.len();
        (count > 0).then_some(OverwriteReason::HoldsKeyframes(count))
    }

    fn ask_before_overwriting(&mut self, is_scene: bool, path: &Path, reason: OverwriteReason) {
        let is_quitting = self.outside.is_quitting;
        self.outside.asked = Some(Asked { is_scene, path: path.to_owned(), is_quitting });
        self.ui.ask_before_overwriting(OverwriteQuestion { path: path.to_owned(), reason, differences: None });
    }

    /// Does what the user answered to the question before a file is replaced.
    pub(super) fn overwrite_answered(&mut self, answer: OverwriteAnswer) {
        if answer == OverwriteAnswer::Compare {
            self.show_differences();
            return;
        }
        let Some(asked) = self.outside.asked.take() else { return };
        match answer {
            OverwriteAnswer::Compare => {}
            OverwriteAnswer::Overwrite => {
                self.outside.allowed = Some(asked.path.clone());
                self.apply(Command::File(if asked.is_scene {
                    FileCommand::SaveSceneAs(asked.path)
                } else {
                    FileCommand::SaveAs(asked.path)
                }));
                self.outside.allowed = None;
                if asked.is_quitting {
                    self.quit_answered(QuitAnswer::Save);
                }
            }
            OverwriteAnswer::SaveAs => self.apply(Command::File(if asked.is_scene {
                FileCommand::ChooseSaveSceneAs
            } else {
                FileCommand::ChooseSaveAs
            })),
            OverwriteAnswer::Reload => self.reload(asked.is_scene, asked.path),
        }
    }

    fn show_differences(&mut self) {
        let Some(asked) = &self.outside.asked else { return };
        let differences =
            if asked.is_scene { self.scene_differences(&asked.path) } else { self.keyframe_differences(&asked.path) };
        let unreadable = |reason| vec![texts::differs_unreadable(reason)];
        self.ui.show_differences(differences.unwrap_or_else(unreadable));
    }

    /// The keyframes that a file has.
    fn keyframes_of(&self, path: &Path) -> Result<KeyframeFile, Message> {
        let bytes = storage::read(path, LARGEST_FILE_BYTES).map_err(|error| error.message())?;
        match import(&bytes, self.editor.scene(), &Options::of_keyframes()) {
            Ok(Imported::KeyframeFile(file) | Imported::Text(file, _)) => Ok(file),
            Ok(Imported::Scene(..)) => Err(texts::DIFFERS_HOLDS_KEYS.into()),
            Err(error) => Err(error.message()),
        }
    }

    fn keyframe_differences(&self, path: &Path) -> Result<Vec<Message>, Message> {
        let (keyframes, interpolation, ms_between_keyframes) = self.keyframes_of(path)?.into_parts();
        let theirs = Version { keyframes: &keyframes, interpolation, ms_between_keyframes };
        let document = self.editor.document();
        let ours = Version {
            keyframes: &document.keyframes,
            interpolation: document.interpolation,
            ms_between_keyframes: document.ms_between_keyframes,
        };
        Ok(keyframe_differences(&document.scene, theirs, ours))
    }

    fn scene_differences(&self, path: &Path) -> Result<Vec<Message>, Message> {
        let theirs = files::scene::load_file(&self.read_for(path))?;
        Ok(scene_differences(&theirs, self.editor.scene()))
    }

    /// Reads a file again. The keyframe of the same number stays current.
    fn reload(&mut self, is_scene: bool, path: PathBuf) {
        if is_scene {
            // Not the command, which reads the scene's own file: this may be another one.
            let path = self.read_for(&path);
            self.guarded(|shell| shell.perform(Effect::ReadScene { path }));
            return;
        }
        let current = self.editor.document().keyframes.current();
        self.apply(Command::File(FileCommand::Open(path)));
        let is_read = self.editor.message().is_some_and(|message| message.severity() == Severity::Outcome);
        let last = self.editor.document().keyframes.last();
        if let (true, Some(current), Some(last)) = (is_read, current, last)
            && current.get() > 0
        {
            let index = KeyframeIndex::new(current.get().min(last.get()));
            self.apply(Command::Edit(Edit::GoTo(index)));
        }
    }

    /// The file that is read for the content of another: for the meshes of the scene, the scene.
    fn read_for(&self, path: &Path) -> PathBuf {
        let scene = self.editor.scene_path().filter(|scene| meshes_of(scene) == path);
        scene.unwrap_or(path).to_owned()
    }

    /// A file was read or written: what was noticed of it is over.
    pub(super) fn settled_outside(&mut self, path: &Path) {
        let mut notices = std::mem::take(&mut self.outside.notices);
        notices.retain(|notice| Place::of_output(&self.read_for(&notice.path)) != Place::of_output(path));
        self.outside.notices = notices;
        self.offer_change();
    }

    /// Looks whether another program has changed a file, and offers to read it again. Where the user wants it, it is read at once.
    pub(super) fn look_outside(&mut self) {
        let keyframes = Some((false, self.editor.keyframe_file().to_owned()));
        let scene = self.editor.scene_path().map(|path| [(true, path.to_owned()), (true, meshes_of(path))]);
        let files: Vec<(bool, PathBuf)> = keyframes.into_iter().chain(scene.into_iter().flatten()).collect();
        self.outside.notices.retain(|notice| files.contains(&(notice.is_scene, notice.path.clone())));
        for (is_scene, path) in files {
            self.look_at(is_scene, path);
        }
        self.offer_change();
    }

    fn look_at(&mut self, is_scene: bool, path: PathBuf) {
        let outside = &mut self.outside;
        let place = outside.notices.iter().position(|notice| notice.path == path);
        let Some(seen) = outside.known.suspect(&path) else {
            if let Some(place) = place {
                outside.notices.remove(place);
            }
            return;
        };
        let is_settled = place.is_some_and(|place| outside.notices[place].seen == seen);
        if !is_settled {
            if let Some(place) = place {
                outside.notices.remove(place);
            }
            // Only the time may be another one.
            if outside.known.change(&path).is_none() {
                outside.known.is_still(&path);
                return;
            }
            outside.notices.push(Notice { is_scene, path, seen, is_answered: false });
            return;
        }
        // A program that writes the file just now is given the time until the next look.
        let notice = place.map(|place| &mut outside.notices[place]).filter(|notice| !notice.is_answered);
        if let Some(notice) = notice
            && is_read_by_itself(&self.settings_file.settings, &self.editor, is_scene)
        {
            // Where it cannot be read, it is not tried again until it changes.
            notice.is_answered = true;
            self.reload(is_scene, path);
            self.request_redraw();
        }
    }

    /// Shows or hides the offer to read a file again that is not read by itself.
    pub(super) fn offer_change(&mut self) {
        let (settings, editor) = (&self.settings_file.settings, &self.editor);
        let is_offered =
            |notice: &&Notice| !notice.is_answered && !is_read_by_itself(settings, editor, notice.is_scene);
        let offer = self.outside.notices.iter().find(is_offered).map(|notice| ChangeOffer {
            file: notice.path.file_name().unwrap_or(notice.path.as_os_str()).to_string_lossy().into_owned(),
            path: notice.path.clone(),
            replaces_unsaved: replaces_unsaved(editor, notice.is_scene),
        });
        if self.ui.changed != offer {
            self.ui.changed = offer;
            self.request_redraw();
        }
    }

    /// Does what the user answered to the offer to read a file again.
    pub(super) fn change_answered(&mut self, answer: ChangeAnswer) {
        let Some(offer) = &self.ui.changed else { return };
        let Some(notice) = self.outside.notices.iter_mut().find(|notice| notice.path == offer.path) else { return };
        match answer {
            ChangeAnswer::Later => notice.is_answered = true,
            ChangeAnswer::Reload => {
                let (is_scene, path) = (notice.is_scene, notice.path.clone());
                self.reload(is_scene, path);
            }
            ChangeAnswer::Compare => {
                let (is_scene, path) = (notice.is_scene, notice.path.clone());
                // What would be written is the scene, with its meshes.
                self.ask_before_overwriting(is_scene, &self.read_for(&path), OverwriteReason::Changed);
                self.show_differences();
            }
        }
        self.offer_change();
    }

    /// Looks at files where that is due, and says when it is due again: never, unless the user wants them read when they change.
    pub(super) fn look_outside_when_due(&mut self, at: Instant) -> Option<Instant> {
        if !self.settings_file.settings.reload {
            self.outside.due = None;
        } else if self.outside.due.is_none_or(|due| due <= at) {
            self.look_outside();
            self.outside.due = at.checked_add(PERIOD);
        }
        self.outside.due
    }
}

/// The file beside a scene to which its meshes are written. It is known, and looked at, only where it holds them.
fn meshes_of(scene: &Path) -> PathBuf {
    scene.with_extension("glb")
}

/// Whether a file that was changed is read without a word from the user.
fn is_read_by_itself(settings: &Settings, editor: &Editor, is_scene: bool) -> bool {
    settings.reload && editor.is_at_rest() && !replaces_unsaved(editor, is_scene)
}

/// Whether reading a file again replaces what is not saved.
fn replaces_unsaved(editor: &Editor, is_scene: bool) -> bool {
    if is_scene { editor.has_unsaved_scene() } else { editor.has_unsaved_keyframes() || editor.has_unsaved_posing() }
}
