//! Running a script against an editor without a window.
//!
//! Time passes only by `wait`. Questions that a window would ask its user need no answer: a script that writes over a file means to,
//! and one that quits ends.

use super::parse::{Action, Line};
use super::restore::Restore;
use super::trace::{State, TraceLine};
use crate::clock::AnimationClock;
use crate::editor::gizmo::DragKey;
use crate::editor::keymap::KeyPress;
use crate::editor::{Command, CommandError, Host, PathQuestion, Severity, WindowCommand, WindowHost};
use crate::film::ExportOptions;

/// What hosts without a window keep of what only a window can do.
#[derive(Clone, Debug, Default)]
pub struct NoWindow {
    said: Option<&'static str>,
    has_quit: bool,
}

impl WindowHost for NoWindow {
    fn ask_for_path(&mut self, question: PathQuestion) {
        self.said = Some(match question {
            PathQuestion::Open | PathQuestion::SaveAs => "Without a window there is no dialog: use --keyframes FILE.",
            PathQuestion::Compare => "Without a window there is no dialog: use compare-with FILE.",
            PathQuestion::ExportModel => "Without a window there is no dialog: use export-model FILE.",
            PathQuestion::SaveSceneAs => "Without a window there is no dialog: use save-scene FILE.",
            PathQuestion::Export { .. } => NO_EXPORT,
        });
    }

    fn begin_export(&mut self, _: ExportOptions) {
        self.said = Some(NO_EXPORT);
    }

    fn cancel_export(&mut self) {
        self.said = Some(NO_EXPORT);
    }

    /// The script ends.
    fn quit(&mut self) {
        self.has_quit = true;
    }

    fn change_window(&mut self, _: WindowCommand) {}
}

const NO_EXPORT: &str = "Without a window nothing is exported: use `inbetween render`.";

/// A host without a window.
pub trait Windowless: Host {
    /// What it keeps instead of a window.
    fn no_window(&mut self) -> &mut NoWindow;

    /// The editor took in so many ticks.
    fn ticked(&mut self, _ticks: u64) {}

    /// The editor is about to become what a line of a journal says.
    fn restoring(&mut self, _restore: &Restore) {}
}

/// What a line led to.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// What was said; empty where nothing was.
    pub message: String,
    /// Whether that refuses what the line asks for.
    pub is_refusal: bool,
    /// Whether the script ends here.
    pub is_last: bool,
}

/// Runs lines one after the other.
pub struct Runner<H> {
    host: H,
    clock: AnimationClock,
}

impl<H: Windowless> Runner<H> {
    /// A runner whose clock stands at zero.
    pub fn new(host: H) -> Self {
        Self { host, clock: AnimationClock::new() }
    }

    /// The host, with the editor as the lines left it.
    pub fn into_host(self) -> H {
        self.host
    }

    /// Runs all lines, to the end or to the command that quits, and gives back the host. `observe` gets the trace of each line; of a line
    /// at which the host stops as well, with the reason as its message.
    ///
    /// # Errors
    /// Why the host or the observer stopped; the lines after that have not run.
    pub fn run<E>(mut self, lines: &[Line], mut observe: impl FnMut(&TraceLine<'_>) -> Result<(), E>) -> Result<H, E>
    where
        E: From<H::Stop>,
        H::Stop: ToString,
    {
        for line in lines {
            let outcome = self.step(line);
            let (message, is_refusal) = match &outcome {
                Ok(step) => (step.message.clone(), step.is_refusal),
                Err(stop) => (stop.to_string(), false),
            };
            observe(&TraceLine { line, message, is_refusal, state: self.state() })?;
            if outcome?.is_last {
                break;
            }
        }
        Ok(self.host)
    }

    /// Runs a line.
    ///
    /// # Errors
    /// Why the host stopped.
    pub fn step(&mut self, line: &Line) -> Result<Step, H::Stop> {
        let was_playing = self.host.editor().is_playing();
        match &line.action {
            Action::Wait(duration) => {
                let ticks = self.clock.advance(*duration);
                Ok(self.tick(ticks))
            }
            Action::Ticks(ticks) => Ok(self.tick(*ticks)),
            Action::Restore(restore) => {
                self.host.restoring(restore);
                restore.apply(self.host.editor());
                self.clock.restart();
                Ok(self.said(false))
            }
            Action::Apply(command) => {
                let command = match line.key {
                    None => command.clone(),
                    Some(press) => match self.pressed(press, command) {
                        Ok(command) => command,
                        Err(step) => return Ok(step),
                    },
                };
                let performed = self.host.carry_out(command);
                if self.host.editor().is_playing() && !was_playing {
                    // The first tick comes a whole period after the start, whatever was waited for before.
                    self.clock.restart();
                }
                performed?;
                let editor = self.host.editor();
                if let Some(note) = line.note.clone().filter(|_| editor.message().is_none()) {
                    editor.say(note);
                }
                let NoWindow { said, has_quit } = std::mem::take(self.host.no_window());
                Ok(match said {
                    Some(said) => Step { message: said.to_owned(), is_refusal: true, is_last: has_quit },
                    None => self.said(has_quit),
                })
            }
        }
    }

    /// What a key means now: in a turn or move that a key has begun, axes, numbers and Enter belong to that, and but Escape no other key
    /// does anything. A drag that a script began leaves keys as they are.
    fn pressed(&mut self, press: KeyPress, hotkey: &Command) -> Result<Command, Step> {
        let editor = self.host.editor();
        let in_drag = DragKey::of(press);
        let nothing = Step { message: String::new(), is_refusal: false, is_last: false };
        if editor.held().is_some() {
            let is_escape = *hotkey == Command::Cancel;
            return if is_escape { Ok(Command::Cancel) } else { in_drag.map(DragKey::command).ok_or(nothing) };
        }
        if in_drag.is_some_and(|key| key.command() == *hotkey) {
            editor.say(CommandError::NoDrag.message());
            return Err(self.said(false));
        }
        Ok(hotkey.clone())
    }

    fn tick(&mut self, ticks: u64) -> Step {
        let editor = self.host.editor();
        let was_playing = editor.is_playing();
        editor.tick(ticks);
        let has_ended = was_playing && !editor.is_playing();
        let message = if has_ended { editor.message_text() } else { String::new() };
        self.host.ticked(ticks);
        Step { message, is_refusal: false, is_last: false }
    }

    /// What the editor said of the last line.
    fn said(&mut self, is_last: bool) -> Step {
        let editor = self.host.editor();
        let is_refusal = editor.message().is_some_and(|message| message.severity() == Severity::Error);
        Step { message: editor.message_text(), is_refusal, is_last }
    }

    /// The host that the lines act on.
    pub fn host(&mut self) -> &mut H {
        &mut self.host
    }

    /// What the trace says of the editor now.
    pub fn state(&mut self) -> State {
        State::of(self.host.editor())
    }
}
