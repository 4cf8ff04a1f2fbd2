//! Running a script: the editor's shell without a window.
//!
//! Time passes only by `wait`. What the window asks its user about needs no answer here: a script that writes over a file means to,
//! and one that quits is done.

use std::path::Path;

use super::parse::{Action, Line};
use super::trace::Trace;
use crate::cli::CliError;
use crate::clock::AnimationClock;
use crate::editor::{Command, Editor, Effect};
use crate::export::Painter;
use crate::frame::Frame;
use crate::keyframe::LARGEST_FILE_BYTES;
use crate::storage;

/// An editor with what its effects need.
pub struct Runner {
    editor: Editor,
    clock: AnimationClock,
    painter: Option<Painter>,
    trace: Option<Trace>,
}

/// Whether the script goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Flow {
    GoOn,
    Quit,
}

/// What a line led to: what is said, and whether the script goes on.
type Outcome = Result<(String, Flow), CliError>;

impl Runner {
    /// A runner; `painter` is there if any line takes a screenshot.
    pub fn new(editor: Editor, painter: Option<Painter>, trace: Option<Trace>) -> Self {
        Self { editor, clock: AnimationClock::new(), painter, trace }
    }

    /// Runs the lines, to the end or to the key that quits, and gives back the editor.
    ///
    /// # Errors
    /// [`CliError`]: a file could not be written, or a picture not made; the lines after that have not run.
    pub fn run(mut self, lines: &[Line]) -> Result<Editor, CliError> {
        let outcome = self.run_lines(lines);
        let traced = self.trace.as_mut().map_or(Ok(()), Trace::finish);
        outcome.and(traced)?;
        Ok(self.editor)
    }

    fn run_lines(&mut self, lines: &[Line]) -> Result<(), CliError> {
        for line in lines {
            let outcome = match &line.action {
                Action::Wait(duration) => {
                    let ticks = self.clock.advance(*duration);
                    Ok((self.tick(ticks), Flow::GoOn))
                }
                Action::Apply(command) => self.apply(command.clone()),
            };
            if let Some(trace) = &mut self.trace {
                let message = match &outcome {
                    Ok((message, _)) => message.clone(),
                    Err(error) => error.to_string(),
                };
                trace.line(line, &message, &self.editor)?;
            }
            if outcome?.1 == Flow::Quit {
                break;
            }
        }
        Ok(())
    }

    /// Lets ticks pass, and says what the end of playing says.
    fn tick(&mut self, ticks: u64) -> String {
        let was_playing = self.editor.is_playing();
        self.editor.tick(ticks);
        if was_playing && !self.editor.is_playing() { self.editor.message_text() } else { String::new() }
    }

    fn apply(&mut self, command: Command) -> Outcome {
        let was_playing = self.editor.is_playing();
        let effects = self.editor.apply(command).unwrap_or_default();
        if self.editor.is_playing() && !was_playing {
            // The first tick comes a whole period after the start, whatever was waited for before.
            self.clock.restart();
        }
        let mut said = None;
        let mut flow = Flow::GoOn;
        for effect in effects {
            match effect {
                Effect::ReadKeyframes { path } => {
                    let bytes = storage::read(&path, LARGEST_FILE_BYTES).map_err(|error| error.message());
                    // What is wrong with the file is the editor's message, and the script goes on.
                    let _ = self.editor.keyframes_read(&path, bytes);
                }
                Effect::WriteKeyframes { path, text, is_known: _ } => {
                    let written = storage::write_with(&path, |file| write!(file, "{text}")).map(|()| None);
                    self.editor.keyframes_written(&path, written.map_err(|error| error.message()))?;
                }
                Effect::WriteScene { path, text, is_known: _ } => {
                    let written = storage::write(&path, text.as_bytes()).map(|()| None);
                    self.editor.scene_written(&path, written.map_err(|error| error.message()))?;
                }
                Effect::Screenshot { path } => {
                    let path = path.unwrap_or_else(|| storage::next_screenshot_path(self.editor.path()));
                    self.take_screenshot(&path)?;
                }
                Effect::ChooseSaveSceneAs => {
                    said = Some("Without a window there is no dialog: use save-scene FILE.".to_owned());
                }
                Effect::ChooseOpen | Effect::ChooseSaveAs => {
                    said = Some("Without a window there is no dialog: use --keyframes FILE.".to_owned());
                }
                Effect::Export(_) | Effect::CancelExport | Effect::ChooseExport { .. } => {
                    said = Some("Without a window nothing is exported: use `inbetween render`.".to_owned());
                }
                Effect::Quit => flow = Flow::Quit,
                // There is no window to change.
                Effect::Window(_) => {}
            }
        }
        Ok((said.unwrap_or_else(|| self.editor.message_text()), flow))
    }

    fn take_screenshot(&mut self, path: &Path) -> Result<(), CliError> {
        let painter = self.painter.as_mut().expect("a script that takes screenshots has a painter");
        let png = painter.png(&Frame::of_editor(&self.editor, painter.size_px()))?;
        let written = storage::write(path, &png).map_err(|error| error.message());
        Ok(self.editor.screenshot_taken(path, written)?)
    }
}
