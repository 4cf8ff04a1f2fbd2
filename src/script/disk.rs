//! The host of `inbetween script`: it reads and writes files and takes screenshots.

use std::path::{Path, PathBuf};

use thiserror::Error;

use super::run::{NoWindow, Windowless};
use crate::editor::{CommandError, Editor, FileAccess, FileOutcome, Host, WindowHost, Writing, Written};
use crate::export::{ExportError, Painter};
use crate::files;
use crate::storage::{self, KnownFiles, OutsideChange};
use crate::view::picture_of_editor;
use crate::words::{Message, texts};

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
    known: KnownFiles,
    overwrites: bool,
    /// Whether the write that the editor is told of next was refused because another program has changed the file.
    is_refusing: bool,
    refused: Vec<CommandError>,
}

impl Disk {
    /// A host; `painter` is there if any line takes a screenshot.
    #[must_use]
    pub fn new(editor: Editor, painter: Option<Painter>) -> Self {
        let known = files::known_at_start(&editor);
        let (no_window, refused) = (NoWindow::default(), Vec::new());
        Self { editor, painter, no_window, known, overwrites: false, is_refusing: false, refused }
    }

    /// Whether files are written that another program has changed since they were read or written, or since the start. What they held
    /// is kept beside them.
    #[must_use]
    pub fn overwriting(self, overwrites: bool) -> Self {
        Self { overwrites, ..self }
    }

    /// The editor as the script left it, and why files were not written that another program has changed.
    #[must_use]
    pub fn finish(self) -> (Editor, Vec<CommandError>) {
        (self.editor, self.refused)
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

    fn read(&mut self, access: FileAccess, path: &Path) -> Result<FileOutcome<Vec<u8>>, DiskStop> {
        Ok(files::read_known(&mut self.known, access, path))
    }

    fn write(&mut self, writing: Writing<'_>) -> Result<Option<FileOutcome<Written>>, DiskStop> {
        let change = self.known.change(writing.path);
        if let Some(change) = change.filter(|_| !self.overwrites) {
            self.is_refusing = true;
            return Ok(Some(Err(refusal(change))));
        }
        Ok(Some(files::write_known(&mut self.known, writing, change.is_some())))
    }

    fn take_screenshot(
        &mut self,
        path: Option<PathBuf>,
        has_overlays: bool,
    ) -> Result<Option<(PathBuf, FileOutcome<()>)>, DiskStop> {
        let path = path.unwrap_or_else(|| storage::next_screenshot_path(self.editor.keyframe_file(), &[]));
        let painter = self.painter.as_mut().expect("a script that takes screenshots has a painter");
        let png = painter.png(picture_of_editor(&self.editor, painter.size_px(), has_overlays))?;
        let written = storage::write(&path, &png).map_err(|error| error.message());
        Ok(Some((path, written)))
    }

    fn read_pose(&mut self, name: &str) -> Result<FileOutcome<Vec<u8>>, DiskStop> {
        Ok(files::poses::read(name))
    }

    fn write_pose(&mut self, name: &str, text: &str) -> Result<FileOutcome<(PathBuf, Written)>, DiskStop> {
        Ok(files::poses::write(name, text))
    }

    fn write_model(&mut self, path: &Path) -> Result<FileOutcome<Vec<Message>>, DiskStop> {
        Ok(files::model::write(path, self.editor.document()))
    }

    fn told(&mut self, access: FileAccess, _path: &Path, told: Result<(), CommandError>) -> Result<(), DiskStop> {
        if std::mem::take(&mut self.is_refusing) {
            self.refused.extend(told.err());
            return Ok(());
        }
        match access {
            // What is wrong with a file that is read is the editor's message, and the script goes on.
            FileAccess::KeyframesRead | FileAccess::SceneRead => {
                if told.is_ok() {
                    self.known.took_in();
                }
                Ok(())
            }
            FileAccess::ComparedRead => Ok(()),
            FileAccess::KeyframesWritten
            | FileAccess::SceneWritten
            | FileAccess::ScreenshotTaken
            | FileAccess::PoseWritten
            | FileAccess::ModelWritten => Ok(told?),
        }
    }

    fn window(&mut self) -> &mut dyn WindowHost {
        &mut self.no_window
    }
}

fn refusal(change: OutsideChange) -> Message {
    match change {
        OutsideChange::Appeared => texts::FILE_APPEARED_REFUSED.into(),
        OutsideChange::Changed => texts::FILE_CHANGED_REFUSED.into(),
    }
}
