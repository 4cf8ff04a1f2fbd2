//! A host without a window that keeps a journal.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::path::{Path, PathBuf};

use super::{Ending, Writer};
use crate::editor::{Command, CommandError, Editor, FileAccess, FileOutcome, Host, WindowHost, Writing, Written};
use crate::script::{NoWindow, Restore, Windowless};
use crate::storage::StorageError;
use crate::words::Message;

/// A host whose commands are written down before they are done.
#[derive(Debug)]
pub struct Journaled<H> {
    host: H,
    journal: Option<Writer>,
    was_playing: bool,
    /// How many commands were carried out.
    count: u64,
    /// Whether the journal could not begin anew at its bound.
    is_unbounded: bool,
    panic_at: Option<u64>,
}

impl<H: Windowless> Journaled<H> {
    /// A host with a journal, or without one.
    pub const fn new(host: H, journal: Option<Writer>) -> Self {
        Self { host, journal, was_playing: false, count: 0, is_unbounded: false, panic_at: None }
    }

    /// For tests: the command of this number panics, counted from 1.
    #[must_use]
    pub fn panicking_at(self, panic_at: Option<u64>) -> Self {
        Self { panic_at, ..self }
    }

    fn bound_journal(&mut self) {
        let editor = self.host.editor();
        if let Some(journal) = &mut self.journal
            && journal.is_full()
            && editor.is_at_rest()
            && !self.is_unbounded
        {
            // A longer journal is better than none.
            self.is_unbounded = journal.begin_anew(editor).is_err() || journal.is_full();
        }
    }

    /// The host, after the end of the journal.
    ///
    /// # Errors
    /// [`StorageError`]: the journal could not be written.
    pub fn finish(mut self) -> Result<H, StorageError> {
        if let Some(mut journal) = self.journal {
            journal.flush(self.host.editor());
            let problem = journal.take_problem();
            journal.end(self.host.editor(), Ending::Quit);
            problem.map_or(Ok(()), Err)?;
        }
        Ok(self.host)
    }
}

impl<H: Windowless> Windowless for Journaled<H> {
    fn no_window(&mut self) -> &mut NoWindow {
        self.host.no_window()
    }

    fn ticked(&mut self, ticks: u64) {
        if let Some(journal) = &mut self.journal {
            let editor = self.host.editor();
            journal.ticked(self.was_playing, editor, ticks);
            self.was_playing = editor.is_playing();
        }
    }

    fn restoring(&mut self, restore: &Restore) {
        if let Some(journal) = &mut self.journal {
            journal.restored(restore);
        }
    }
}

impl<H: Windowless> Host for Journaled<H> {
    type Stop = H::Stop;

    fn editor(&mut self) -> &mut Editor {
        self.host.editor()
    }

    fn read(&mut self, access: FileAccess, path: &Path) -> Result<FileOutcome<Vec<u8>>, H::Stop> {
        let outcome = self.host.read(access, path)?;
        if let (Some(journal), Ok(bytes)) = (&mut self.journal, &outcome) {
            journal.read(access, path, bytes);
        }
        Ok(outcome)
    }

    fn write(&mut self, writing: Writing<'_>) -> Result<Option<FileOutcome<Written>>, H::Stop> {
        self.host.write(writing)
    }

    fn take_screenshot(
        &mut self,
        path: Option<PathBuf>,
        has_overlays: bool,
    ) -> Result<Option<(PathBuf, FileOutcome<()>)>, H::Stop> {
        self.host.take_screenshot(path, has_overlays)
    }

    fn read_pose(&mut self, name: &str) -> Result<FileOutcome<Vec<u8>>, H::Stop> {
        self.host.read_pose(name)
    }

    fn write_pose(&mut self, name: &str, text: &str) -> Result<FileOutcome<(PathBuf, Written)>, H::Stop> {
        self.host.write_pose(name, text)
    }

    fn write_model(&mut self, path: &Path) -> Result<FileOutcome<Vec<Message>>, H::Stop> {
        self.host.write_model(path)
    }

    fn told(&mut self, access: FileAccess, path: &Path, told: Result<(), CommandError>) -> Result<(), H::Stop> {
        if let (Some(journal), Ok(())) = (&mut self.journal, &told) {
            journal.wrote(access, path);
        }
        self.host.told(access, path, told)
    }

    fn window(&mut self) -> &mut dyn WindowHost {
        self.host.window()
    }

    fn carry_out(&mut self, command: Command) -> Result<(), H::Stop> {
        if let Some(journal) = &mut self.journal {
            journal.command(self.host.editor(), &command);
        }
        self.count += 1;
        let done = catch_unwind(AssertUnwindSafe(|| {
            assert!(self.panic_at != Some(self.count), "a test asked for this panic");
            match self.editor().apply(command) {
                Ok(Some(effect)) => self.perform(effect),
                Ok(None) | Err(_) => Ok(()),
            }
        }));
        if let (Err(_), Some(journal)) = (&done, &mut self.journal) {
            journal.panicked();
        }
        self.was_playing = self.host.editor().is_playing();
        if done.is_ok() {
            self.bound_journal();
        }
        done.unwrap_or_else(|panic| resume_unwind(panic))
    }
}
