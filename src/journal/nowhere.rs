//! The host of a journal that is played: it has no files and no window, since a journal needs none.

use std::convert::Infallible;
use std::path::{Path, PathBuf};

use crate::editor::{CommandError, Editor, FileAccess, FileOutcome, Host, WindowHost, Writing, Written};
use crate::script::{NoWindow, Windowless};
use crate::words::{Message, texts};

/// A host that has no files and no window.
#[derive(Debug)]
pub(super) struct Nowhere {
    editor: Editor,
    no_window: NoWindow,
}

impl Nowhere {
    pub(super) fn new(editor: Editor) -> Self {
        Self { editor, no_window: NoWindow::default() }
    }

    pub(super) fn into_editor(self) -> Editor {
        self.editor
    }
}

impl Windowless for Nowhere {
    fn no_window(&mut self) -> &mut NoWindow {
        &mut self.no_window
    }
}

impl Host for Nowhere {
    type Stop = Infallible;

    fn editor(&mut self) -> &mut Editor {
        &mut self.editor
    }

    fn read(&mut self, _: FileAccess, _: &Path) -> Result<FileOutcome<Vec<u8>>, Infallible> {
        Ok(Err(texts::JOURNAL_NO_FILES.into()))
    }

    fn write(&mut self, _: Writing<'_>) -> Result<Option<FileOutcome<Written>>, Infallible> {
        Ok(Some(Err(texts::JOURNAL_NO_FILES.into())))
    }

    fn take_screenshot(
        &mut self,
        path: Option<PathBuf>,
        _has_overlays: bool,
    ) -> Result<Option<(PathBuf, FileOutcome<()>)>, Infallible> {
        Ok(Some((path.unwrap_or_default(), Err(texts::JOURNAL_NO_FILES.into()))))
    }

    fn read_pose(&mut self, _: &str) -> Result<FileOutcome<Vec<u8>>, Infallible> {
        Ok(Err(texts::JOURNAL_NO_FILES.into()))
    }

    fn write_pose(&mut self, _: &str, _: &str) -> Result<FileOutcome<(PathBuf, Written)>, Infallible> {
        Ok(Err(texts::JOURNAL_NO_FILES.into()))
    }

    fn write_model(&mut self, _: &Path) -> Result<FileOutcome<Vec<Message>>, Infallible> {
        Ok(Err(texts::JOURNAL_NO_FILES.into()))
    }

    fn told(&mut self, _: FileAccess, _: &Path, _: Result<(), CommandError>) -> Result<(), Infallible> {
        Ok(())
    }

    fn window(&mut self) -> &mut dyn WindowHost {
        &mut self.no_window
    }
}
