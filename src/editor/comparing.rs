//! Comparisons: with the poses of other interpolations, and with the animation of another file. Undo leaves them alone.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use num_rational::BigRational;
use num_traits::Zero as _;

use super::{CommandError, Editor, Message};
use crate::keyframe::{Animation, Blend, PlayRange, whole};
use crate::text_layouts::{ImportError, Imported, Options, import};
use crate::words::texts;

/// An animation of another file, long enough to play, for the document's scene.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedAnimation {
    /// The file.
    pub path: PathBuf,
    /// What it holds, with defaults where it does not say.
    pub animation: Animation,
}

impl Editor {
    /// The animation that is shown beside the document's.
    #[must_use]
    pub fn compared(&self) -> Option<&ComparedAnimation> {
        self.compared.as_deref()
    }

    /// The playing time at the playhead, in milliseconds from the first played keyframe; 0 while the list is too short to play.
    #[must_use]
    pub fn playhead_ms(&self) -> BigRational {
        let Some(timing) = self.document.keyframes.timing() else { return BigRational::zero() };
        let elapsed = self.playback.elapsed().unwrap_or_else(|| self.elapsed_at_current(timing));
        elapsed * whole(self.document.ms_between_keyframes as usize)
    }

    /// Takes in a file to compare with, or why it could not be read. The document stays as it is.
    ///
    /// # Errors
    /// Why nothing is compared with it; what was compared before still is.
    pub fn compared_read(&mut self, path: &Path, bytes: Result<Vec<u8>, Message>) -> Result<(), CommandError> {
        let read = self.parse_compared(path, bytes);
        match &read {
            Ok((_, message)) => self.say_outcome(message.clone()),
            Err(error) => self.say_error(error),
        }
        self.compared = Some(Arc::new(read?.0));
        Ok(())
    }

    fn parse_compared(
        &self,
        path: &Path,
        bytes: Result<Vec<u8>, Message>,
    ) -> Result<(ComparedAnimation, Message), CommandError> {
        let path = path.to_owned();
        let bytes = bytes.map_err(|reason| CommandError::Read { path: path.clone(), reason })?;
        let (file, report) = match import(&bytes, &self.document.scene, &Options::of_keyframes()) {
            Ok(Imported::KeyframeFile(file)) => (file, None),
            Ok(Imported::Text(file, report)) => (file, Some(report)),
            Ok(Imported::Scene(..)) => return Err(CommandError::HoldsScene { path }),
            Err(ImportError::KeyframeFile(problems)) => return Err(CommandError::File { path, problems }),
            Err(ImportError::Text(problem)) => return Err(CommandError::Text { path, problem }),
        };
        let (keyframes, interpolation, ms_between_keyframes) = file.into_parts();
        if PlayRange::new(&keyframes).is_err() {
            return Err(CommandError::TooFewToCompare { path, count: keyframes.len() });
        }
        let what = texts::count_keyframes(keyframes.len());
        let said = match report {
            None => texts::file_compared(path.display(), what),
            Some(report) => texts::file_compared_text(path.display(), what, report.summary),
        };
        let animation = Animation { keyframes, interpolation, ms_between_keyframes };
        Ok((ComparedAnimation { path, animation }, said))
    }

    pub(super) fn end_compare_with(&mut self) -> Message {
        self.compared = None;
        texts::VIEW_COMPARED_FILE_OFF.into()
    }

    pub(super) fn toggle_comparison(&mut self) -> Message {
        self.compare_blends(if self.session.compared_blends.is_empty() { &Blend::ALL } else { &[] })
    }

    pub(super) fn compare_blends(&mut self, blends: &[Blend]) -> Message {
        self.session.compared_blends = Blend::ALL.into_iter().filter(|blend| blends.contains(blend)).collect();
        if blends.is_empty() {
            return texts::VIEW_COMPARISON_OFF.into();
        }
        let [other, nlerp, matrices] = Blend::others(self.document.interpolation).map(Blend::title);
        texts::view_comparing(other, nlerp, matrices)
    }

    pub(super) fn set_ghosts_of_chosen(&mut self, is_on: bool) -> Message {
        self.session.ghosts_of_chosen = is_on;
        if is_on { texts::VIEW_GHOSTS_OF_CHOSEN.into() } else { texts::VIEW_GHOSTS_OF_ALL.into() }
    }
}
