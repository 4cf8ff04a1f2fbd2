//! Commands and effects: what users ask of the editor and what it asks of the shell, as plain data.

use std::path::PathBuf;

use glam::{Quat, Vec3};

use super::{KeyAt, PlayMode, SceneEdit};
use crate::film::ExportOptions;
use crate::interpolation::Interpolation;
use crate::keyframe::{Easing, KeyframeIndex, KeyframesText};
use crate::pose::RbtIndex;
use crate::rbt::Rbt;
use crate::settings::ThemeChoice;
use crate::words::Language;

use super::keymap::Chord;

/// Everything that can be asked of the editor. A hotkey, a menu item, a button and a script line that mean the same are the same command.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Changes the document.
    Edit(Edit),
    /// Plays, stops, pauses.
    Playback(PlaybackCommand),
    /// Changes how the scene is looked at; not undone.
    View(ViewCommand),
    /// Reads, writes, quits.
    File(FileCommand),
    /// A drag, which is one step of undo from its beginning to its end.
    Gesture(GestureCommand),
    /// Takes back the last edit.
    Undo,
    /// Brings back what was undone.
    Redo,
    /// Leaves the drag, the mode or the panel at hand.
    Cancel,
    /// Changes the window itself, or what it keeps; the editor only hands it on.
    Window(WindowCommand),
}

/// What concerns the window and its settings, not the scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum WindowCommand {
    /// Shows the list of commands.
    ShowCommands,
    /// Shows the keys, which can be changed there.
    ShowKeys,
    /// Shows the manual.
    ShowManual,
    /// Asks what film to make of the keyframes.
    ShowExport,
    /// Shows or hides the log of messages.
    ToggleMessages,
    /// Shows or hides how fast the window is.
    ToggleStatistics,
    /// Keeps a journal, or none.
    ToggleJournal,
    /// The panels one step larger.
    Larger,
    /// The panels one step smaller.
    Smaller,
    /// The panels in this size, in percent of what the system asks for.
    SetScale(u16),
    /// Which colours show.
    SetTheme(ThemeChoice),
    /// The language of the window's words.
    SetLanguage(Language),
    /// Gives the binding of this id other keys; none: it has no key.
    SetKeys(&'static str, Vec<Chord>),
    /// Gives the binding of this id the keys of the table.
    ResetKeys(&'static str),
    /// Gives every binding the keys of the table.
    ResetAllKeys,
    /// Forgets the recent files.
    ForgetRecent,
    /// Asks for the name of the current keyframe.
    RenameCurrent,
    /// Brings the whole list into sight in the timeline.
    FitTimeline,
    /// Brings the selected keyframes into sight in the timeline, or the current one with its neighbours.
    FitSelection,
}

/// Changes of the document.
#[derive(Clone, Debug, PartialEq)]
pub enum Edit {
    /// Copies the current keyframe to the scene.
    DisplayCurrent,
    /// Replaces the current keyframe by the scene's pose; in an empty list, creates one.
    UpdateCurrent,
    /// Inserts the scene's pose after the current keyframe.
    CreateKeyframe,
    /// Makes the next keyframe current and copies it to the scene.
    GoToNext,
    /// Makes the previous keyframe current and copies it to the scene.
    GoToPrevious,
    /// Makes the first keyframe current and copies it to the scene.
    GoToFirst,
    /// Makes the last keyframe current and copies it to the scene.
    GoToLast,
    /// Makes a keyframe current and copies it to the scene.
    GoTo(KeyframeIndex),
    /// Deletes the current keyframe.
    DeleteCurrent,
    /// Returns the scene to its rest pose.
    ResetPose,
    /// Puts the next interpolation in force.
    NextInterpolation,
    /// Puts an interpolation in force.
    SetInterpolation(Interpolation),
    /// 100 ms less between keyframes.
    Faster,
    /// 100 ms more between keyframes.
    Slower,
    /// So many milliseconds between keyframes, kept within 100 and 10,000.
    SetMsBetweenKeyframes(u32),
    /// Places a node: its `parent_from_node` translation.
    SetTranslation(RbtIndex, Vec3),
    /// Turns a node: its `parent_from_node` rotation; normalised, and refused where it has no direction.
    SetRotation(RbtIndex, Quat),
    /// Turns the chosen node about an axis of its own, by radians.
    RotateChosen {
        /// A unit vector in the node's space.
        axis_in_node: Vec3,
        /// The angle in radians, right-handed.
        radians: f32,
    },
    /// Moves the chosen node, in its parent's space.
    TranslateChosen(Vec3),
    /// Edits the list as a timeline.
    Timeline(TimelineEdit),
    /// Edits control nodes and keys at their own times, which are a part of the scene.
    Scene(SceneEdit),
    /// Moves the node at hand (the chosen one, or the eye) along the view, with respect to its auxiliary frame; a run of these is one step.
    Wheel(Rbt),
}

/// Edits of the list as a timeline; of the selected keyframes, or of the current one where none is selected.
#[derive(Clone, Debug, PartialEq)]
pub enum TimelineEdit {
    /// Names a keyframe; blank takes the name away.
    RenameKeyframe(KeyframeIndex, String),
    /// Sets the length of the interval that begins at a keyframe.
    SetDuration {
        /// Where the interval begins.
        keyframe: KeyframeIndex,
        /// Its length in units of the ms between keyframes, kept within [`crate::keyframe::DURATION_RANGE`].
        duration: f64,
        /// Whether the next interval gives what this one takes, so that what follows stays in time.
        ripple_free: bool,
    },
    /// Sets the easing of the intervals that begin at the keyframes at hand.
    SetEasing(Easing),
    /// Moves the keyframes at hand, to before the keyframe in this place; the list's length: to the end.
    MoveKeyframes(usize),
    /// Deletes the keyframes at hand.
    DeleteKeyframes,
    /// Copies the keyframes at hand, and deletes them.
    CutKeyframes,
    /// Inserts the copied keyframes after the last of those at hand.
    PasteKeyframes,
    /// Inserts copies of the keyframes at hand, after them.
    DuplicateKeyframes,
    /// Reverses the order of the selected keyframes, or of all where fewer than two are selected.
    ReverseKeyframes,
    /// Gives the chosen node and all below it the copied pose; another root keeps its own place.
    PastePose,
    /// Moves one node in one keyframe of the list, as dragging its dot on the motion path does: in the parent's space.
    SetTranslationInKeyframe(KeyframeIndex, RbtIndex, Vec3),
    /// Turns one node in one keyframe of the list.
    SetRotationInKeyframe(KeyframeIndex, RbtIndex, Quat),
}

/// Playing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlaybackCommand {
    /// Plays from the first playable keyframe, or stops at the last.
    PlayOrStop,
    /// Plays from the playhead, or stops.
    PlayFromPlayhead,
    /// Freezes the pose on screen into the scene, or goes on from there.
    PauseOrResume,
    /// Shows the sample at a key time, kept within what plays; while playing, goes on from there.
    Scrub(f64),
    /// Shows the sample so many ticks after the playhead, or before.
    Step(i32),
    /// What happens at the end.
    SetMode(PlayMode),
    /// The next of once, loop, ping-pong.
    NextMode,
    /// Which keyframes of the list play, the first and the last of them; `None`: all but the first and the last of the list.
    SetRange(Option<(usize, usize)>),
    /// Speed on top of the ms between keyframes, in percent, kept within 10 and 1000.
    SetSpeedPercent(u32),
}

/// How the scene is looked at.
#[derive(Clone, Debug, PartialEq)]
pub enum ViewCommand {
    /// Looks from the next eye.
    NextEye,
    /// Looks from the eye in this place of [`crate::scene::SceneGraph::eyes`].
    SetEye(usize),
    /// With the sky as eye and nothing chosen: moves about the world's centre, or about the eye itself.
    ToggleSkyMode,
    /// The next click in the view chooses the node to move.
    StartPicking,
    /// Chooses the node to move, or none.
    Choose(Option<RbtIndex>),
    /// Shows or hides the arcball.
    ToggleArcball,
    /// Shows or hides the help.
    ToggleHelp,
    /// Shows or hides all panels.
    TogglePanels,
    /// Shows or hides the path that the chosen node takes.
    TogglePath,
    /// Shows or hides, while playing, what the interpolations that are not in force would show.
    ToggleComparison,
    /// Selects these keyframes in the timeline, and no others.
    SelectKeyframes(Vec<KeyframeIndex>),
    /// Copies the selected keyframes, or the current one.
    CopyKeyframes,
    /// Copies what is on screen of the chosen node and all below it.
    CopyPose,
    /// Switches whether the end of each drag updates the current keyframe.
    ToggleAutoKeys,
    /// Whether the end of each drag updates the current keyframe.
    SetAutoKeys(bool),
    /// Shows so many neighbouring keyframes on each side as ghosts, at most [`crate::frame::MOST_GHOSTS`].
    SetGhosts(u8),
    /// Selects these keys at their own times, and no others, and no keyframes.
    SelectKeys(Vec<KeyAt>),
    /// Shows one more on each side, and after the most of them none.
    NextGhosts,
    /// Sets the clock of keys at their own times to zero.
    RestartSeconds,
    /// Holds that clock, or lets it go on.
    HoldSeconds,
    /// Sets that clock to so many seconds, and holds it until something plays.
    ScrubSeconds(f64),
}

/// Files and the program itself.
#[derive(Clone, Debug, PartialEq)]
pub enum FileCommand {
    /// Reads the keyframe file again.
    Import,
    /// Writes the keyframe file.
    Write,
    /// Asks which file to open.
    ChooseOpen,
    /// Opens a keyframe file, which becomes the one that is written.
    Open(PathBuf),
    /// Asks where to save.
    ChooseSaveAs,
    /// Writes to a file, which becomes the one that is written from now on.
    SaveAs(PathBuf),
    /// Writes the scene's file; asks where to, as long as it has none.
    WriteScene,
    /// Asks where to save the scene.
    ChooseSaveSceneAs,
    /// Writes the scene to a file, which becomes its own from now on.
    SaveSceneAs(PathBuf),
    /// Writes a picture of the scene: to a path, or beside the keyframe file under the next free name.
    Screenshot(Option<PathBuf>),
    /// Makes a film of what the keyframes play, beside whatever else goes on.
    Export(Box<ExportOptions>),
    /// Ends the export that is under way; what is not finished is not kept.
    CancelExport,
    /// Asks the system where an export is to go.
    ChooseExport {
        /// Where it would go.
        proposed: PathBuf,
        /// Whether that is a folder.
        is_folder: bool,
    },
    /// Ends the program; the shell asks first where something is unsaved.
    Quit,
}

/// A drag of the node at hand. Between `Begin` and `Commit` or `Abort`, changes of poses are one step.
#[derive(Clone, Debug, PartialEq)]
pub enum GestureCommand {
    /// A drag begins.
    Begin,
    /// "Do this to the node at hand with respect to its auxiliary frame", on top of what the drag did so far.
    Move(Rbt),
    /// Puts the node at hand where motions led it, in its parent's space: what stands for all of them.
    MoveTo {
        /// Its `parent_from_node`.
        placed: Rbt,
        /// Whether the last motion turned it and did not move it.
        is_turn: bool,
    },
    /// The drag ends and counts.
    Commit,
    /// The drag ends and is as if it had not been.
    Abort,
}

/// What the shell must do for the editor, and then tell it of.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Read this file and hand the outcome to [`super::Editor::keyframes_read`].
    ReadKeyframes {
        /// Which file.
        path: PathBuf,
    },
    /// Write this text and hand the outcome to [`super::Editor::keyframes_written`].
    WriteKeyframes {
        /// Which file.
        path: PathBuf,
        /// Its text, to be made as it is written.
        text: KeyframesText,
        /// Whether the file was read or written before: where not, what it held is not known here, and a careful shell keeps it.
        is_known: bool,
    },
    /// Write this text and hand the outcome to [`super::Editor::scene_written`].
    WriteScene {
        /// Which file.
        path: PathBuf,
        /// All of its text.
        text: String,
        /// Whether the file was read or written before, as for keyframes.
        is_known: bool,
    },
    /// Ask where to save the scene.
    ChooseSaveSceneAs,
    /// Render what is displayed and hand the path, or what went wrong, to [`super::Editor::screenshot_taken`].
    Screenshot {
        /// Where to; `None`: the next free `inbetween-0001.png` beside the keyframe file.
        path: Option<PathBuf>,
    },
    /// Make a film of the document as it is now and hand the outcome to [`super::Editor::exported`].
    Export(Box<ExportOptions>),
    /// End the export that is under way.
    CancelExport,
    /// Ask where an export is to go.
    ChooseExport {
        /// Where it would go.
        proposed: PathBuf,
        /// Whether that is a folder.
        is_folder: bool,
    },
    /// Ask which file to open.
    ChooseOpen,
    /// Ask where to save.
    ChooseSaveAs,
    /// End the program, asking first where something is unsaved.
    Quit,
    /// Change the window or its settings. Without a window there is nothing to do.
    Window(WindowCommand),
}
