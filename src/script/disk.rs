//! The host of `inbetween script`: it reads and writes files and takes screenshots.

use std::fmt::Display;
use std::path::{Path, PathBuf};

use thiserror::Error;

use super::run::{NoWindow, Windowless};
use crate::editor::{CommandError, Editor, FileAccess, FileOutcome, Host, PathQuestion, WindowCommand};
use crate::export::{ExportError, Painter};
use crate::film::ExportOptions;
use crate::keyframe::LARGEST_FILE_BYTES;
use crate::storage;
use crate::view::frame_of_editor;

/// Why a script ended early.
#[derive(Debug, Error)]
pub enum DiskStop {
    /// A file could not be written.
    #[error(transparent)]
    Unwritten(#[from] CommandError),
    /// A picture could not be made.
    #[error(transparent)]
    Picture(#[from] ExportError),
}

/// An editor with the files of the disk and, where the script takes pictures, a painter.
pub struct Disk {
    editor: Editor,
    painter: Option<Painter>,
    no_window: NoWindow,
}

impl Disk {
    /// A host; `painter` is there if any line takes a screenshot.
    #[must_use]
    pub fn new(editor: Editor, painter: Option<Painter>) -> Self {
        Self { editor, painter, no_window: NoWindow::default() }
    }

    /// The editor as the script left it.
    #[must_use]
    pub fn into_editor(self) -> Editor {
        self.editor
    }
}

impl Windowless for Disk {
    fn no_window(&mut self) -> &mut NoWindow {
        &mut self.no_window
    }
}

impl Host for Disk {
    type Stop = DiskStop;

    fn editor(&mut self) -> &mut Editor {
        &mut self.editor
    }

    fn read(&mut self, path: &Path) -> Result<FileOutcome<Vec<u8>>, DiskStop> {
        Ok(storage::read(path, LARGEST_FILE_BYTES).map_err(|error| error.message()))
    }

    fn write(
        &mut self,
        path: &Path,
        text: &dyn Display,
        _is_known: bool,
    ) -> Result<FileOutcome<Option<PathBuf>>, DiskStop> {
        let written = storage::write_with(path, |file| write!(file, "{text}"));
        Ok(written.map(|()| None).map_err(|error| error.message()))
    }

    fn take_screenshot(&mut self, path: Option<PathBuf>) -> Result<(PathBuf, FileOutcome<()>), DiskStop> {
        let path = path.unwrap_or_else(|| storage::next_screenshot_path(self.editor.keyframe_file()));
        let painter = self.painter.as_mut().expect("a script that takes screenshots has a painter");
        let png = painter.png(&frame_of_editor(&self.editor, painter.size_px()))?;
        let written = storage::write(&path, &png).map_err(|error| error.message());
        Ok((path, written))
    }

    fn told(&mut self, access: FileAccess, _path: &Path, told: Result<(), CommandError>) -> Result<(), DiskStop> {
        match access {
            // What is wrong with a file that is read is the editor's message, and the script goes on.
            FileAccess::KeyframesRead => Ok(()),
            FileAccess::KeyframesWritten | FileAccess::SceneWritten | FileAccess::ScreenshotTaken => Ok(told?),
        }
    }

    fn ask_for_path(&mut self, question: PathQuestion) {
        self.no_window.ask_for_path(&question);
    }

    fn begin_export(&mut self, _options: ExportOptions) {
        self.no_window.refuse_export();
    }

    fn cancel_export(&mut self) {
        self.no_window.refuse_export();
    }

    fn quit(&mut self) {
        self.no_window.quit();
    }

    fn change_window(&mut self, _command: WindowCommand) {
        // There is no window to change.
    }
}
