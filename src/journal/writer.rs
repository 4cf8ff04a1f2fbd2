//! Writing a journal: each line is handed to the system before what it says is done.

use std::fmt::Write as _;
use std::path::Path;

use super::{mark, start};
use crate::editor::commands::row_of;
use crate::editor::{Command, Editor, FileAccess, FileCommand, GestureCommand, Reach, ViewCommand, WorkEye};
use crate::script::{Restore, imported_line, print_swiftly};
use crate::storage::{self, Log, StorageError, epoch_seconds};

/// A journal that has grown by so many bytes since its start goes on in a new one, which begins with a snapshot.
pub const LARGEST_JOURNAL_BYTES: u64 = 16 << 20;
/// The same of so many lines, which are read back within a second.
pub const MOST_LINES: u64 = 200_000;
/// Lines of a drag that changes other things than a node's place wait for its end, up to so many bytes.
const MOST_PENDING_BYTES: usize = 1 << 16;

/// How a program ended, as far as its journal is concerned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// Its user wanted that, and nothing is to be recovered.
    Quit,
    /// What is in the journal is to be recovered.
    Unwanted,
    /// As [`Self::Unwanted`]; what the last line led to may be the reason.
    Fault,
}

/// A drag that is going on.
#[derive(Clone, Copy, Debug, Default)]
struct Drag {
    /// Whether motions of the node at hand were asked for since the last line.
    is_moving: bool,
}

/// Writes a journal.
#[derive(Debug)]
pub struct Writer {
    log: Log,
    /// What is not handed to the system yet.
    pending: String,
    drag: Option<Drag>,
    /// The line for where the work eye was moved since the last line.
    work_eye: Option<String>,
    /// Ticks that the editor took in since the last line.
    ticks: u64,
    lines: u64,
    /// How many of them were handed over.
    handed_lines: u64,
    bytes: u64,
    /// How far undo and redo lead where the journal is read back; `None`: as far as in the editor now.
    reach: Option<Reach>,
    /// The same before the last command.
    reach_before: Option<Reach>,
    /// Why nothing is written any more, until somebody takes it.
    problem: Option<StorageError>,
    is_broken: bool,
}

impl Writer {
    /// Begins a journal with what the editor is now.
    #[must_use]
    pub fn begin(log: Log, editor: &Editor) -> Self {
        let mut writer = Self::with_head(log, editor);
        for line in start::lines(editor) {
            writer.push(&line);
        }
        writer.push(mark::START);
        writer.hand_over();
        writer.bytes = 0;
        let position = editor.undo_reach().position;
        writer.reach = Some(Reach { first: position, position, last: position });
        writer
    }

    /// Begins anew where it is, with what the editor is now, which is at rest. Where that fails the journal goes on as it was.
    ///
    /// # Errors
    /// [`StorageError`]
    pub fn begin_anew(&mut self, editor: &Editor) -> Result<(), StorageError> {
        let Some(log) = Log::create_for(self.path())? else { return Ok(()) };
        let mut new = Self::begin(log, editor);
        if let Some(problem) = new.take_problem() {
            return Err(problem);
        }
        new.log.take_place_of(self.path())?;
        *self = new;
        Ok(())
    }

    /// Begins a journal that goes on from another one, whose lines are copied as far as they are whole: the steps of undo stay.
    #[must_use]
    pub fn continuing(log: Log, old: &[u8], editor: &Editor) -> Self {
        let mut writer = Self::with_head(log, editor);
        for line in super::play::lines_that_count(old) {
            writer.push(line);
            writer.lines += 1;
        }
        writer.hand_over();
        writer
    }

    fn with_head(log: Log, editor: &Editor) -> Self {
        let (pending, drag, problem) = (format!("{}\n", mark::FORMAT), None, None);
        let (ticks, lines, handed_lines, bytes, reach, is_broken) = (0, 0, 0, 0, None, false);
        let reach_before = reach;
        let mut writer = Self {
            log,
            pending,
            drag,
            work_eye: None,
            ticks,
            lines,
            handed_lines,
            bytes,
            reach,
            reach_before,
            problem,
            is_broken,
        };
        let keyframes = mark::quoted(&storage::absolute(editor.keyframe_file()));
        let scene = serde_json::Value::from(editor.scene().name());
        for line in [
            format!("{}inbetween {}", mark::PROGRAM, env!("CARGO_PKG_VERSION")),
            format!("{}{}", mark::BEGAN, epoch_seconds()),
            format!("{}{keyframes}", mark::KEYFRAMES),
            format!("{}{scene}", mark::SCENE),
        ] {
            writer.push(&line);
        }
        writer
    }

    /// Where the journal is.
    #[must_use]
    pub fn path(&self) -> &Path {
        self.log.path()
    }

    /// How many lines were handed over since the journal began.
    #[must_use]
    pub const fn handed_lines(&self) -> u64 {
        self.handed_lines
    }

    /// Whether it has grown so much that a new journal should begin, with a snapshot of an editor at rest.
    #[must_use]
    pub const fn is_full(&self) -> bool {
        self.bytes > LARGEST_JOURNAL_BYTES || self.lines > MOST_LINES
    }

    /// Why nothing is written any more, once.
    pub const fn take_problem(&mut self) -> Option<StorageError> {
        self.problem.take()
    }

    /// A command is about to be done by an editor.
    pub fn command(&mut self, editor: &Editor, command: &Command) {
        match command {
            Command::Gesture(GestureCommand::Begin) => {
                self.end_of_motions(editor);
                self.line("drag begin");
                self.drag = Some(Drag::default());
            }
            Command::Gesture(
                GestureCommand::Move(_)
                | GestureCommand::Pull(_)
                | GestureCommand::Lock(_)
                | GestureCommand::Type(_)
                | GestureCommand::Erase,
            ) => {
                if editor.takes_motions() {
                    self.drag.get_or_insert_default().is_moving = true;
                }
            }
            Command::File(file) => {
                if commits_drag(file) && editor.is_dragging() {
                    self.end_of_motions(editor);
                    self.line("drag end");
                }
                self.drag = self.drag.filter(|_| editor.is_dragging() && !commits_drag(file));
            }
            Command::Window(_) => {}
            // Where it stands is wanted once something else happens.
            Command::View(ViewCommand::SetWorkEye(eye)) => self.work_eye_moved(editor, *eye),
            _ => self.other(editor, &editor.meant_by(command.clone())),
        }
    }

    fn other(&mut self, editor: &Editor, command: &Command) {
        self.end_of_motions(editor);
        self.reach_before = self.reach;
        if let Some(line) = self.unreached(editor, command) {
            self.line(&line);
            self.hand_over();
            return;
        }
        let Some(line) = print_swiftly(command, editor.scene()) else {
            // The editor refuses what has no line, but an edit has ended the drag before that.
            if matches!(command, Command::Edit(_)) && editor.is_dragging() && !row_of(command).is_continuous {
                self.line("drag end");
                self.drag = None;
                self.hand_over();
            }
            return;
        };
        self.line(&line);
        let is_part = self.drag.is_some() && editor.is_dragging() && row_of(command).is_continuous;
        if is_part && self.pending.len() < MOST_PENDING_BYTES {
            return;
        }
        if matches!(command, Command::Gesture(_) | Command::Cancel) {
            self.drag = None;
        }
        self.hand_over();
    }

    /// The line for an undo or redo of a step that the journal does not hold: where it leads.
    fn unreached(&mut self, editor: &Editor, command: &Command) -> Option<String> {
        if !matches!(command, Command::Undo | Command::Redo) {
            return None;
        }
        let Reach { position, .. } = editor.undo_reach();
        let reach = self.reach.get_or_insert_with(|| editor.undo_reach());
        let (is_known, is_possible) = match command {
            Command::Undo => {
                reach.last = reach.last.max(position);
                (position > reach.first, editor.undo_label().is_some())
            }
            _ => (position < reach.last, editor.redo_label().is_some()),
        };
        if is_known || !is_possible {
            return None;
        }
        // A copy shares what it can.
        let mut after = editor.clone();
        after.apply(command.clone()).ok()?;
        let line = Restore::Document(Box::new(after.snapshot())).line()?;
        let position = after.undo_reach().position;
        self.reach = Some(Reach { first: position, position, last: position });
        Some(line)
    }

    /// Writes where the motions of a drag have led so far.
    fn end_of_motions(&mut self, editor: &Editor) {
        let has_moved = self.drag.as_mut().is_some_and(|drag| std::mem::take(&mut drag.is_moving));
        if has_moved && editor.dragged_node().is_none() {
            self.work_eye_moved(editor, editor.session().work_eye);
            self.end_of_work_eye();
        }
        // The editor knows whether a motion counted: it refuses those that lead too far.
        if let Some(led) = editor.drag_so_far().filter(|_| has_moved) {
            let led = Command::Gesture(led);
            if let Some(line) = print_swiftly(&led, editor.scene()) {
                self.line(&line);
            }
        }
    }

    /// A file was read, and the editor is about to be told.
    pub fn read(&mut self, access: FileAccess, path: &Path, bytes: &[u8]) {
        if access == FileAccess::ComparedRead {
            // Nothing that is kept depends on it.
            return;
        }
        if let Some(line) = imported_line(access == FileAccess::SceneRead, &start::plain(path), bytes) {
            self.line(&line);
            self.hand_over();
        }
    }

    /// A file was written.
    pub fn wrote(&mut self, access: FileAccess, path: &Path) {
        let mark = match access {
            FileAccess::KeyframesRead | FileAccess::ComparedRead | FileAccess::SceneRead => return,
            FileAccess::KeyframesWritten => mark::WROTE,
            FileAccess::SceneWritten => mark::WROTE_SCENE,
            FileAccess::ScreenshotTaken | FileAccess::PoseWritten | FileAccess::ModelWritten => mark::WROTE_PICTURE,
        };
        self.end_of_ticks();
        self.push(&format!("{mark}{}", mark::quoted(&storage::absolute(path))));
        self.hand_over();
    }

    /// A line of a journal is about to be restored.
    pub fn restored(&mut self, restore: &Restore) {
        if let Some(line) = restore.line() {
            self.line(&line);
            self.hand_over();
        }
        // Some of them end what can be undone, in the editor as well.
        self.reach = self.reach.filter(|_| {
            matches!(restore, Restore::Imported { .. } | Restore::ImportedScene { .. } | Restore::KeyframeFile(_))
        });
    }

    /// The editor took in ticks. They stand in the journal before the next line; at once where they ended what played.
    pub fn ticked(&mut self, was_playing: bool, editor: &Editor, ticks: u64) {
        self.ticks = self.ticks.saturating_add(ticks);
        if was_playing && !editor.is_playing() {
            self.end_of_ticks();
            self.hand_over();
        }
    }

    /// Hands over what waits for the end of a drag or of playing.
    pub fn flush(&mut self, editor: &Editor) {
        self.end_of_motions(editor);
        self.end_of_work_eye();
        self.end_of_ticks();
        self.hand_over();
    }

    /// The command of the last line panicked and was taken back.
    pub fn panicked(&mut self) {
        self.reach = self.reach_before;
        self.push(mark::PANICKED);
        self.hand_over();
    }

    /// The program ends. What was handed over is on the disk afterwards.
    pub fn end(mut self, editor: &Editor, ending: Ending) {
        if ending == Ending::Fault {
            // What waits may not be read any more: the editor may be the reason. The mark takes back the last line.
            self.hand_over();
            self.push(mark::ENDED);
        } else {
            self.flush(editor);
        }
        if ending == Ending::Quit {
            self.push(mark::QUIT);
        }
        self.hand_over();
        // What the disk refuses now, nobody can mend.
        let _ = self.log.sync();
    }

    /// Waits until the disk has the journal.
    ///
    /// # Errors
    /// [`StorageError::System`]
    pub fn sync(&self) -> Result<(), StorageError> {
        self.log.sync()
    }

    fn end_of_ticks(&mut self) {
        if self.ticks > 0 {
            let _ = writeln!(self.pending, "wait {}t", std::mem::take(&mut self.ticks));
            self.lines += 1;
        }
    }

    /// Writes where the work eye was moved last: a drag of it is one line.
    fn end_of_work_eye(&mut self) {
        if let Some(line) = self.work_eye.take() {
            self.push(&line);
            self.lines += 1;
        }
    }

    fn work_eye_moved(&mut self, editor: &Editor, eye: WorkEye) {
        let eye = eye.in_range().map(|eye| Command::View(ViewCommand::SetWorkEye(eye)));
        self.work_eye = eye.and_then(|command| print_swiftly(&command, editor.scene())).or(self.work_eye.take());
    }

    /// A line at its place in time.
    fn line(&mut self, line: &str) {
        self.end_of_work_eye();
        self.end_of_ticks();
        self.push(line);
        self.lines += 1;
    }

    fn push(&mut self, line: &str) {
        self.pending.push_str(line);
        self.pending.push('\n');
    }

    fn hand_over(&mut self) {
        if self.pending.is_empty() {
            return;
        }
        if !self.is_broken
            && let Err(error) = self.log.append(self.pending.as_bytes())
        {
            self.is_broken = true;
            self.problem = Some(error);
        }
        self.bytes += self.pending.len() as u64;
        self.handed_lines = self.lines;
        self.pending.clear();
    }
}

const fn commits_drag(command: &FileCommand) -> bool {
    matches!(
        command,
        FileCommand::Import
            | FileCommand::Open(_)
            | FileCommand::Write
            | FileCommand::SaveAs(_)
            | FileCommand::WriteScene
            | FileCommand::ReloadScene
            | FileCommand::SaveSceneAs(_)
    )
}
