//! The window's journal, and the journals that other windows left.

use std::io::Write as _;
use std::path::PathBuf;

use super::ForTests;
use super::ending::Whereabouts;
use crate::editor::{Command, Editor, FileAccess, Severity};
use crate::journal::{self, ENDING, Ending, Left, Writer};
use crate::script::Restore;
use crate::storage::{self, Log};
use crate::ui::RecoveryOffer;
use crate::words::{Message, texts};

/// Keeps the journal of a window.
pub struct Keeper {
    writer: Option<Writer>,
    folder: Option<PathBuf>,
    /// Journals that hold what was not saved, the newest first. They are held, so that no other window offers them.
    left: Vec<Left>,
    problem: Option<Message>,
    was_playing: bool,
    count: u64,
    whereabouts: Whereabouts,
    tests: ForTests,
}

impl Keeper {
    /// Looks for journals that were left, and begins one where `is_wanted`.
    pub fn new(is_wanted: bool, editor: &Editor, tests: ForTests) -> Self {
        let folder = storage::state_folder();
        let left = folder.as_deref().map(journal::left).unwrap_or_default();
        if let Some(folder) = &folder {
            journal::tidy_up(folder);
        }
        let (writer, problem) = (None, None);
        let whereabouts = Whereabouts::default();
        let mut keeper = Self { writer, folder, left, problem, was_playing: false, count: 0, whereabouts, tests };
        keeper.want(is_wanted, editor);
        keeper
    }

    /// Says there from now on where the journal is.
    pub fn keep_whereabouts(&mut self, whereabouts: Whereabouts) {
        self.whereabouts = whereabouts;
        self.say_where();
    }

    /// Where it says where the journal is.
    pub const fn whereabouts(&self) -> &Whereabouts {
        &self.whereabouts
    }

    fn say_where(&self) {
        self.whereabouts.set(self.writer.as_ref().map(|writer| writer.path().to_owned()));
    }

    /// Begins a journal, or ends it.
    pub fn want(&mut self, is_wanted: bool, editor: &Editor) {
        if is_wanted && self.writer.is_none() {
            self.writer = self.log().map(|log| Writer::begin(log, editor));
        } else if !is_wanted && let Some(writer) = self.writer.take() {
            writer.end(editor, Ending::Quit);
        }
        self.say_where();
    }

    fn log(&mut self) -> Option<Log> {
        let log = match &self.folder {
            Some(folder) => Log::create_in(folder, ENDING).map_err(|error| error.message()),
            None => Err(texts::JOURNAL_NO_PLACE.into()),
        };
        log.map_err(|reason| self.problem = Some(texts::journal_not_kept(reason))).ok()
    }

    /// What is to be said of the journal, once.
    pub fn take_problem(&mut self) -> Option<Message> {
        if let Some(error) = self.writer.as_mut().and_then(Writer::take_problem) {
            self.problem = Some(texts::journal_not_kept(error.message()));
            self.whereabouts.set(None);
        }
        let problem = self.problem.take()?;
        if self.tests.prints {
            let _ = writeln!(std::io::stdout(), "{problem}");
        }
        Some(problem.with_severity(Severity::Error))
    }

    /// A command is about to be done.
    pub fn command(&mut self, editor: &Editor, command: &Command) {
        if let Some(writer) = &mut self.writer {
            writer.command(editor, command);
        }
        self.was_playing = editor.is_playing();
        self.count += 1;
        assert!(self.tests.panics_at != Some(self.count), "a test asked for this panic");
    }

    /// A command was done.
    pub fn done(&mut self, editor: &Editor) {
        self.was_playing = editor.is_playing();
        self.go_on_in_a_new_one(editor);
        if self.tests.prints && !editor.is_dragging() {
            let lines = self.writer.as_ref().map_or(0, Writer::handed_lines);
            // A reader that has gone is no mishap.
            let _ = writeln!(std::io::stdout(), "{lines} {}", journal::fingerprint(editor));
        }
    }

    /// A picture was drawn: tests that count commands count pictures too.
    pub fn drawn(&self) {
        if self.tests.prints {
            let _ = writeln!(std::io::stdout(), "picture");
        }
    }

    /// Whether a test wants the device to be lost for good now.
    pub fn loses_device(&self) -> bool {
        self.tests.loses_device_at.is_some_and(|count| self.count >= count)
    }

    /// Whether a test wants drawing to panic now.
    pub fn panics_in_drawing(&self) -> bool {
        self.tests.panics_in_drawing_at.is_some_and(|count| self.count >= count)
    }

    fn go_on_in_a_new_one(&mut self, editor: &Editor) {
        if self.writer.as_ref().is_some_and(Writer::is_full) && editor.is_at_rest() {
            self.begin_anew(editor);
        }
    }

    /// Goes on in a new journal, which begins with what the editor is now, at rest. The old one is no longer wanted.
    pub fn begin_anew(&mut self, editor: &Editor) {
        if self.writer.is_none() {
            return;
        }
        let Some(log) = self.log() else { return };
        let new = Writer::begin(log, editor);
        if new.sync().is_ok()
            && let Some(old) = self.writer.replace(new)
        {
            let path = old.path().to_owned();
            old.end(editor, Ending::Quit);
            // What cannot be removed is ended at least.
            let _ = storage::remove(&path);
        }
        self.say_where();
    }

    /// The last command panicked and was taken back.
    pub fn panicked(&mut self) {
        if let Some(writer) = &mut self.writer {
            writer.panicked();
        }
    }

    /// The editor took in ticks.
    pub fn ticked(&mut self, editor: &Editor, ticks: u64) {
        if let Some(writer) = &mut self.writer {
            writer.ticked(self.was_playing, editor, ticks);
        }
        self.was_playing = editor.is_playing();
    }

    /// The editor is about to become what a line of a journal says.
    pub fn restored(&mut self, restore: &Restore) {
        if let Some(writer) = &mut self.writer {
            writer.restored(restore);
        }
    }

    /// A file was read, and the editor is about to be told.
    pub fn read(&mut self, access: FileAccess, path: &std::path::Path, bytes: &[u8]) {
        if let Some(writer) = &mut self.writer {
            writer.read(access, path, bytes);
        }
    }

    /// A file was written.
    pub fn wrote(&mut self, access: FileAccess, path: &std::path::Path) {
        if let Some(writer) = &mut self.writer {
            writer.wrote(access, path);
        }
    }

    /// What the user can get back, or not.
    pub fn offer(&self) -> Option<RecoveryOffer> {
        let survey = &self.left.first()?.survey;
        let file = survey.keyframes.file_name().unwrap_or(survey.keyframes.as_os_str()).to_string_lossy().into_owned();
        let seconds = storage::epoch_seconds().saturating_sub(survey.began);
        Some(RecoveryOffer { file, path: survey.keyframes.clone(), commands: survey.commands, seconds })
    }

    /// Leaves the journals alone until the next start.
    pub fn put_off(&mut self) {
        self.left.clear();
    }

    /// Removes the journal that is offered.
    pub fn discard(&mut self) {
        if !self.left.is_empty() {
            let _ = self.left.remove(0).log.remove();
        }
    }

    /// The editor that the offered journal leads to, and what to say. The journal goes on in one of this window. What is unsaved in
    /// `editor` stays in its own journal, which is offered next.
    pub fn restore(&mut self, editor: &Editor) -> Option<(Option<Editor>, Message)> {
        if self.left.is_empty() {
            return None;
        }
        let left = self.left.remove(0);
        let (restored, played, bytes) = match journal::recover(&left.log) {
            Ok(recovered) => recovered,
            Err(error) => {
                let said = texts::journal_unreadable(error.message()).with_severity(Severity::Error);
                self.left.insert(0, left);
                return Some((None, said));
            }
        };
        if self.writer.is_some() {
            let new = self.log().map(|log| Writer::continuing(log, &bytes, &restored));
            let is_safe = new.as_ref().is_some_and(|new| new.sync().is_ok());
            if let Some(old) = std::mem::replace(&mut self.writer, new) {
                self.end_other(old, editor);
            }
            if is_safe {
                let _ = left.log.remove();
            }
            self.say_where();
        }
        let file = restored.keyframe_file().display().to_string();
        let commands = texts::journal_count(played.lines);
        let said = if played.damage.is_some() || played.is_cut {
            texts::journal_restored_part(file, commands)
        } else {
            texts::journal_restored(file, commands)
        };
        Some((Some(restored), said.with_severity(Severity::Outcome)))
    }

    fn end_other(&mut self, writer: Writer, editor: &Editor) {
        let is_unsaved = is_unsaved(editor);
        let path = writer.path().to_owned();
        writer.end(editor, if is_unsaved { Ending::Unwanted } else { Ending::Quit });
        if let Some(left) = is_unsaved.then(|| Left::open(&path)).flatten() {
            self.left.insert(0, left);
        }
    }

    /// Ends the journal. Where it holds what is not saved and nobody wanted to lose that, it says where it is.
    pub fn end(&mut self, editor: &Editor, ending: Ending) -> Option<PathBuf> {
        let writer = self.writer.take()?;
        let path = writer.path().to_owned();
        let is_kept = ending != Ending::Quit && is_unsaved(editor);
        writer.end(editor, if is_kept { ending } else { Ending::Quit });
        is_kept.then_some(path)
    }
}

fn is_unsaved(editor: &Editor) -> bool {
    editor.has_unsaved_changes() || editor.has_unsaved_posing()
}
