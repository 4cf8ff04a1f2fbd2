//! Beginning anew: a new animation, another scene, an example. Unsaved work is asked about first, as before quitting.

use std::path::Path;

use super::outside::Outside;
use super::shell::Shell;
use crate::editor::{Beginning, Command, Edit, NEW_FILE, Severity, WindowCommand};
use crate::files::{self, Begun};
use crate::script::Restore;
use crate::storage;

/// Whether a command leaves the document behind.
const fn leaves(command: &Command) -> bool {
    match command {
        // The user was asked before the question what of a model is opened.
        Command::Window(WindowCommand::Begin(Beginning::Model { choice: Some(_), .. })) => false,
        Command::Edit(Edit::BeginAnew) | Command::Window(WindowCommand::Begin(_)) => true,
        _ => false,
    }
}

impl Shell {
    /// Keeps a command that would leave unsaved work behind, and asks about that. Says whether it does.
    pub(super) fn asks_before(&mut self, command: &Command) -> bool {
        let is_asking = leaves(command) && self.has_unsaved_work();
        if is_asking {
            self.leaving = Some(command.clone());
            self.ui.ask_before_going_on();
        }
        is_asking
    }

    pub(super) fn has_unsaved_work(&self) -> bool {
        self.editor.has_unsaved_changes() || self.editor.has_unsaved_posing()
    }

    /// Does what had to wait until unsaved work was saved or discarded: a command, or the end.
    pub(super) fn leave(&mut self) {
        match self.leaving.take() {
            Some(command) => self.apply_now(command),
            None => self.is_quitting = true,
        }
    }

    /// A new animation gets a file that is not there yet, so that saving it replaces nothing.
    pub(super) fn name_new_animation(&mut self) {
        let path = storage::free_path(&self.editor.keyframe_file().with_file_name(NEW_FILE));
        if path != self.editor.keyframe_file() {
            self.keeper.restored(&Restore::KeyframeFile(storage::absolute(&path)));
            self.editor.set_path(path);
        }
    }

    /// Shows another scene, or says why not.
    pub(super) fn begin(&mut self, beginning: &Beginning) {
        let folder = self.editor.keyframe_file().parent().unwrap_or(Path::new("")).to_owned();
        if let Beginning::Model { path, choice: None } = beginning
            && let Ok(contents) = files::model::contents(path)
            && contents.has_choice()
        {
            self.ui.ask_what_of_model(path.clone(), contents);
            return;
        }
        match files::begun(beginning, &folder) {
            Ok(Begun { mut editor, said }) => {
                editor.go_on_saying(&self.editor);
                editor.set_keymap(self.ui.keymap().clone());
                editor.set_handles(self.settings_file.settings.gizmo_axes, self.settings_file.settings.snap);
                editor.begin_history();
                self.editor = editor;
                self.outside = Outside::new(files::known_at_start(&self.editor));
                self.hands.forget_scene();
                self.ui.begin_anew();
                self.keeper.begin_anew(&self.editor);
                for message in said {
                    self.editor.say(message.with_severity(Severity::Outcome));
                }
                if let Beginning::Model { path, .. } | Beginning::SceneFile(path) = beginning {
                    self.used(path);
                }
            }
            Err(said) => self.editor.say(said.with_severity(Severity::Error)),
        }
    }
}
