//! Commands and effects: what users ask of the editor and what it asks of the shell, as plain data.

use std::path::PathBuf;

use glam::{Quat, Vec3};

use crate::interpolation::Interpolation;
use crate::keyframe::KeyframeIndex;
use crate::pose::RbtIndex;
use crate::rbt::Rbt;
use crate::settings::{Language, ThemeChoice};

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
    /// Shows or hides the log of messages.
    ToggleMessages,
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
    /// Gives the binding of this name other keys; none: it has no key.
    SetKeys(&'static str, Vec<Chord>),
    /// Gives the binding of this name the keys of the table.
    ResetKeys(&'static str),
    /// Gives every binding the keys of the table.
    ResetAllKeys,
    /// Forgets the recent files.
    ForgetRecent,
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
    /// Moves the node at hand (the chosen one, or the eye) along the view, with respect to its auxiliary frame; a run of these is one step.
    Wheel(Rbt),
}

/// Playing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaybackCommand {
    /// Plays from the first playable keyframe, or stops at the last.
    PlayOrStop,
    /// Freezes the pose on screen into the scene, or goes on from there.
    PauseOrResume,
}

/// How the scene is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
    /// Sets the clock of keys at their own times to zero.
    RestartSeconds,
    /// Holds that clock, or lets it go on.
    HoldSeconds,
}

/// Files and the program itself.
#[derive(Clone, Debug, PartialEq, Eq)]
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
    /// Writes a picture of the scene: to a path, or beside the keyframe file under the next free name.
    Screenshot(Option<PathBuf>),
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
    /// The drag ends and counts.
    Commit,
    /// The drag ends and is as if it had not been.
    Abort,
}

/// What the shell must do for the editor, and then tell it of.
#[derive(Clone, Debug, PartialEq, Eq)]
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
        /// All of its text.
        text: String,
        /// Whether the file was read or written before: where not, what it held is not known here, and a careful shell keeps it.
        is_known: bool,
    },
    /// Render what is displayed and hand the path, or what went wrong, to [`super::Editor::screenshot_taken`].
    Screenshot {
        /// Where to; `None`: the next free `inbetween-0001.png` beside the keyframe file.
        path: Option<PathBuf>,
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
