//! What the editor asks of the shell, done: files read and written, pictures taken, questions asked.

use std::convert::Infallible;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

use super::desktop;
use super::dialog;
use super::shell::Shell;
use crate::editor::{
    Command, CommandError, Edit, Editor, FileAccess, FileCommand, FileOutcome, Host, PathQuestion, Severity,
    WindowCommand, WindowHost, Writing, Written,
};
use crate::files;
use crate::film::ExportOptions;
use crate::storage;
use crate::ui::words::Words;
use crate::ui::{FolderEntry, Listing, PathPurpose, QuitAnswer, RecoveryAnswer};
use crate::words::{Message, texts};

impl Host for Shell {
    /// What fails is the editor's message.
    type Stop = Infallible;

    fn editor(&mut self) -> &mut Editor {
        &mut self.editor
    }

    fn read(&mut self, access: FileAccess, path: &Path) -> Result<FileOutcome<Vec<u8>>, Infallible> {
        let read = files::read_known(&mut self.outside.known, access, path);
        if let Ok(bytes) = &read {
            self.keeper.read(access, path, bytes);
        }
        Ok(read)
    }

    fn write(&mut self, writing: Writing<'_>) -> Result<Option<FileOutcome<Written>>, Infallible> {
        Ok(self.write_or_ask(writing))
    }

    fn take_screenshot(
        &mut self,
        path: Option<PathBuf>,
        has_overlays: bool,
    ) -> Result<Option<(PathBuf, FileOutcome<()>)>, Infallible> {
        let path = path.unwrap_or_else(|| self.next_screenshot_path());
        Ok(self.begin_screenshot(&path, has_overlays).err().map(|reason| (path, Err(reason))))
    }

    fn read_pose(&mut self, name: &str) -> Result<FileOutcome<Vec<u8>>, Infallible> {
        Ok(files::poses::read(name))
    }

    fn write_pose(&mut self, name: &str, text: &str) -> Result<FileOutcome<(PathBuf, Written)>, Infallible> {
        let outcome = files::poses::write(name, text);
        self.ui.put_own_poses(files::poses::own());
        Ok(outcome)
    }

    fn write_model(&mut self, path: &Path) -> Result<FileOutcome<Vec<Message>>, Infallible> {
        Ok(files::model::write(path, self.editor.document()))
    }

    fn told(&mut self, access: FileAccess, path: &Path, told: Result<(), CommandError>) -> Result<(), Infallible> {
        let is_keyframe_file = matches!(access, FileAccess::KeyframesRead | FileAccess::KeyframesWritten);
        if told.is_ok() {
            if matches!(access, FileAccess::KeyframesRead | FileAccess::SceneRead) {
                self.outside.known.took_in();
            }
            self.keeper.wrote(access, path);
            self.settled_outside(path);
        }
        if is_keyframe_file && told.is_ok() {
            self.used(path);
        }
        Ok(())
    }

    fn window(&mut self) -> &mut dyn WindowHost {
        self
    }

    fn carry_out(&mut self, command: Command) -> Result<(), Infallible> {
        self.keeper.command(&self.editor, &command);
        let eased_from = self.eased_from(&command);
        let applied = self.editor.apply(command);
        self.ease(eased_from);
        match applied {
            Ok(Some(effect)) => self.perform(effect),
            Ok(None) | Err(_) => Ok(()),
        }
    }
}

impl WindowHost for Shell {
    fn ask_for_path(&mut self, question: PathQuestion) {
        let purpose = PathPurpose::of(&question);
        match question {
            PathQuestion::Export { proposed, .. } => self.choose_path(purpose, proposed),
            _ => self.choose_named(purpose),
        }
    }

    fn begin_export(&mut self, options: ExportOptions) {
        self.export(options);
    }

    fn cancel_export(&mut self) {
        self.cancel_running_export();
    }

    fn quit(&mut self) {
        self.quit_or_ask();
    }

    fn change_window(&mut self, command: WindowCommand) {
        self.window_command(&command);
    }
}

impl Shell {
    /// Applies a command and does what it asks for. Refusals are the editor's message already.
    pub(super) fn apply(&mut self, command: Command) {
        if !self.asks_before(&command) {
            self.apply_now(command);
        }
    }

    /// The same, whatever is unsaved.
    pub(super) fn apply_now(&mut self, command: Command) {
        let is_new = command == Command::Edit(Edit::BeginAnew);
        let is_new_scene = matches!(command, Command::Window(WindowCommand::Begin(_)));
        self.guarded(|shell| shell.carry_out(command));
        if is_new && self.editor.message().is_some_and(|message| message.severity() != Severity::Error) {
            self.name_new_animation();
        }
        if is_new_scene && self.editor.message().is_none_or(|message| message.severity() != Severity::Error) {
            self.look_as_at_first();
        }
        let (session, settings) = (self.editor.session(), &mut self.settings_file.settings);
        if (settings.gizmo_axes, settings.snap) != (session.gizmo_axes, session.snap) {
            (settings.gizmo_axes, settings.snap) = (session.gizmo_axes, session.snap);
            self.keep_settings();
        }
    }

    /// Does something with the editor. If it panics, the editor is as it was before.
    pub(super) fn guarded(&mut self, act: impl FnOnce(&mut Self) -> Result<(), Infallible>) {
        let before = self.editor.before();
        let done = catch_unwind(AssertUnwindSafe(|| {
            let Ok(()) = act(self);
        }));
        if done.is_err() {
            self.editor.go_back(before);
            self.keeper.panicked();
            self.editor.say(Message::from(texts::JOURNAL_PANICKED).with_severity(Severity::Error));
        }
        self.keeper.done(&self.editor);
        if self.outside.has_noticed() {
            self.offer_change();
        }
        if let Some(problem) = self.keeper.take_problem() {
            self.editor.say(problem);
        }
    }

    /// Does what the user answered to the offer of what was not saved.
    pub(super) fn recovery_answered(&mut self, answer: RecoveryAnswer) {
        match answer {
            RecoveryAnswer::Restore => {
                if let Some((restored, said)) = self.keeper.restore(&self.editor) {
                    if let Some(mut restored) = restored {
                        // What its document was made of may stand in no file any more.
                        self.outside.forget();
                        restored.go_on_saying(&self.editor);
                        restored.set_keymap(self.ui.keymap().clone());
                        self.editor = restored;
                    }
                    self.editor.say(said);
                }
            }
            RecoveryAnswer::Later => self.keeper.put_off(),
            RecoveryAnswer::Discard => self.keeper.discard(),
        }
        self.ui.recovery = self.keeper.offer();
        if let Some(problem) = self.keeper.take_problem() {
            self.editor.say(problem);
        }
    }

    fn window_command(&mut self, command: &WindowCommand) {
        match command {
            WindowCommand::ChooseOpenScene => self.choose_named(PathPurpose::OpenScene),
            WindowCommand::Begin(beginning) => self.begin(beginning),
            WindowCommand::ShowFolder(path) => desktop::show_folder(path, self.proxy.clone()),
            _ => {}
        }
        let before = self.settings_file.settings.clone();
        match self.ui.perform(command, &mut self.settings_file.settings) {
            Ok(None) => {}
            Ok(Some(said)) => self.editor.say(said.with_severity(Severity::Outcome)),
            Err(error) => self.editor.say(error.message()),
        }
        if self.settings_file.settings != before {
            self.keep_settings();
            self.keeper.want(self.settings_file.settings.journal, &self.editor);
        }
    }

    /// Writes the settings, and puts them in force.
    pub(super) fn keep_settings(&mut self) {
        let written = self.settings_file.write();
        // Another window may have changed settings as well.
        self.ui.adopt(&self.settings_file.settings);
        self.editor.set_keymap(self.ui.keymap().clone());
        self.editor.set_handles(self.settings_file.settings.gizmo_axes, self.settings_file.settings.snap);
        match written {
            Ok(None) => {}
            Ok(Some(message)) => self.editor.say(message.with_severity(Severity::Outcome)),
            Err(message) => self.editor.say(message.with_severity(Severity::Error)),
        }
    }

    pub(super) fn used(&mut self, path: &Path) {
        let before = self.settings_file.settings.recent.clone();
        self.settings_file.settings.used(&storage::absolute(path));
        if self.settings_file.settings.recent != before {
            self.keep_settings();
        }
    }

    fn choose_path(&mut self, purpose: PathPurpose, proposed: PathBuf) {
        if !std::mem::replace(&mut self.is_choosing_path, true) {
            let words = Words::new(self.settings_file.settings.language);
            dialog::ask(purpose, proposed, words, self.proxy.clone());
        }
    }

    /// Asks for a path, and proposes the document's own.
    fn choose_named(&mut self, purpose: PathPurpose) {
        let is_scene = matches!(purpose, PathPurpose::SaveSceneAs | PathPurpose::OpenScene);
        let file = self.editor.keyframe_file();
        let proposed = match purpose {
            PathPurpose::ExportModel => file.with_extension("glb"),
            _ if is_scene => self.editor.proposed_scene_path(),
            _ => file.to_owned(),
        };
        self.choose_path(purpose, proposed);
    }

    /// Reads the folder that our own dialog for a path shows.
    pub(super) fn read_wanted_folder(&mut self) {
        let Some(folder) = self.ui.wanted_folder() else { return };
        let entries = storage::folder_contents(&folder).map_err(|error| error.message());
        let named = |(name, is_folder)| FolderEntry { name, is_folder };
        let entries = entries.map(|entries| entries.into_iter().map(named).collect());
        self.ui.put_folder(Listing { folder, entries, home: storage::home_folder() });
        self.request_redraw();
    }

    /// The system's dialog was answered, or there is none: then a dialog of our own asks.
    pub(super) fn path_chosen(
        &mut self,
        purpose: PathPurpose,
        proposed: &Path,
        path: Option<PathBuf>,
        took: std::time::Duration,
    ) {
        self.is_choosing_path = false;
        match path {
            Some(path) => {
                if let Some(command) = self.ui.path_chosen(purpose, path) {
                    self.apply(command);
                }
            }
            None if took < dialog::TOO_FAST_FOR_A_USER => self.ui.ask_for_path(purpose, proposed),
            None => {}
        }
    }

    fn quit_or_ask(&mut self) {
        self.leaving = None;
        if self.has_unsaved_work() || self.export.is_some() {
            self.ui.ask_before_quitting();
        } else {
            self.is_quitting = true;
        }
    }

    /// Does what the user answered to the question about unsaved work. A file that cannot be written, or is not named yet, keeps the
    /// window open.
    pub(super) fn quit_answered(&mut self, answer: QuitAnswer) {
        if answer == QuitAnswer::Discard {
            self.leave();
            return;
        }
        if answer == QuitAnswer::KeepPoseAndSave {
            self.apply(Command::Edit(Edit::CreateKeyframe));
        }
        self.outside.set_quitting(true);
        if self.editor.has_unsaved_keyframes() {
            self.apply(Command::File(FileCommand::Write));
        }
        let is_written = self.editor.message().is_none_or(|message| message.severity() != Severity::Error);
        let goes_on = is_written && !self.outside.is_asking();
        if goes_on && self.editor.has_unsaved_scene() {
            self.apply(Command::File(FileCommand::WriteScene));
        }
        self.outside.set_quitting(false);
        if goes_on && !self.editor.has_unsaved_changes() {
            self.leave();
        }
    }
}
