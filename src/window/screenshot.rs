//! Screenshots: drawn while the window goes on, and written once they are there.

use std::path::{Path, PathBuf};

use super::idle::LOOK;
use super::now;
use super::shell::Shell;
use crate::editor::{FileAccess, Host as _};
use crate::render::{Image, Offscreen};
use crate::storage;
use crate::words::{Message, texts};

/// A screenshot that is being drawn.
#[derive(Debug)]
pub struct Screenshot {
    path: PathBuf,
    picture: Offscreen,
}

impl Shell {
    /// The first free name beside the keyframe file that no screenshot under way has.
    pub(super) fn next_screenshot_path(&self) -> PathBuf {
        let taken: Vec<&Path> = self.screenshots.iter().map(|screenshot| screenshot.path.as_path()).collect();
        storage::next_screenshot_path(self.editor.keyframe_file(), &taken)
    }

    /// Starts to draw a screenshot.
    ///
    /// # Errors
    /// Why that cannot be.
    pub(super) fn begin_screenshot(&mut self, path: &Path, has_overlays: bool) -> Result<(), Message> {
        let stage = self.stage.as_ref().ok_or_else(|| Message::from(texts::SCREENSHOT_NO_WINDOW))?;
        let picture = stage.begin_picture(&self.editor, has_overlays).map_err(|error| error.message())?;
        self.screenshots.push(Screenshot { path: path.to_owned(), picture });
        Ok(())
    }

    /// Writes the screenshots that are drawn by now, and tells the editor.
    pub(super) fn take_screenshots(&mut self) {
        for mut screenshot in std::mem::take(&mut self.screenshots) {
            let picture = match &self.stage {
                Some(stage) => stage.picture(&mut screenshot.picture).map_err(|error| error.message()),
                None => Err(texts::SCREENSHOT_NO_WINDOW.into()),
            };
            let outcome = match picture {
                Ok(None) => {
                    self.screenshots.push(screenshot);
                    continue;
                }
                Ok(Some(picture)) => write(&screenshot.path, &picture),
                Err(reason) => Err(reason),
            };
            let told = self.editor.screenshot_taken(&screenshot.path, outcome);
            let Ok(()) = self.told(FileAccess::ScreenshotTaken, &screenshot.path, told);
            self.request_redraw();
        }
    }

    /// When to look for them again.
    pub(super) fn next_screenshot_look(&self) -> Option<web_time::Instant> {
        now().checked_add(LOOK).filter(|_| !self.screenshots.is_empty())
    }
}

fn write(path: &Path, picture: &Image) -> Result<(), Message> {
    let png = picture.to_png().map_err(|error| texts::foreign(error.to_string()))?;
    storage::write(path, &png).map_err(|error| error.message())
}
