//! Commands and effects as plain data: what users ask of the editor, and what the editor asks of its host.

use std::path::PathBuf;
use std::sync::Arc;

use glam::{Quat, Vec3};

use super::gizmo::{Axis, GizmoAxes, Handle, Pull, SnapSteps};
use super::{Eye, KeyAt, Pivot, PlayMode, SceneEdit, Side, WorkEye};
use crate::film::ExportOptions;
use crate::interpolation::Interpolation;
use crate::keyframe::{Blend, Easing, KeyframeIndex, KeyframesText, Retiming};
use crate::pose::RbtIndex;
use crate::pose_file::PoseFile;
use crate::rbt::Rbt;
use crate::scene::SceneFiles;
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
    /// Selects keyframes or timed keys; not undone.
    Selection(SelectionCommand),
    /// Copies, without a change of the document.
    Clipboard(ClipboardCommand),
    /// Reads, writes, quits.
    File(FileCommand),
    /// A drag, which is one step of undo from its beginning to its end.
    Gesture(GestureCommand),
    /// Takes back the last edit.
    Undo,
    /// Brings back what was undone.
    Redo,
    /// Cancels the drag, leaves the mode, or closes the panel.
    Cancel,
    /// Changes the window itself, or what it keeps; the editor only hands it on.
    Window(WindowCommand),
}

/// What a window can begin with, in place of what it shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Beginning {
    /// A scene file, with no keyframes.
    SceneFile(PathBuf),
    /// The built-in scene of this name, with no keyframes.
    Scene(&'static str),
    /// The built-in animation of this name, with its scene.
    Animation(&'static str),
    /// A model or motion of another format, glTF or BVH, as a scene with its keyframes.
    Model {
        /// Its file.
        path: PathBuf,
        /// What of it; `None`: the user is asked where there is a choice.
        choice: Option<ModelChoice>,
    },
}

/// What of a model is opened.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ModelChoice {
    /// The number of its scene, from 0; `None`: the one that the file shows first.
    pub scene: Option<usize>,
    /// The number of its animation, from 0; `None`: the first one.
    pub animation: Option<usize>,
}

/// What concerns the window and its settings, not the scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum WindowCommand {
    /// Shows the list of commands.
    ShowCommands,
    /// Shows the keys, which can be changed there.
    ShowHotkeys,
    /// Shows the manual.
    ShowManual,
    /// Asks what film to make of the keyframes.
    ShowExport,
    /// Shows or hides the poses with names.
    TogglePoses,
    /// Shows or hides the log of messages.
    ToggleMessages,
    /// Shows or hides how fast the window is.
    ToggleStatistics,
    /// Reads files again when another program changes them, or only offers to.
    ToggleReload,
    /// Begins with the scene's first eye the next time, or with the work eye.
    ToggleRecordedEye,
    /// Goes on showing what the recorded camera sees while something plays, or not.
    ToggleInsetWhilePlaying,
    /// Shows changes of the view at once, or eases them.
    ToggleReduceMotion,
    /// Refines the picture while nothing moves, or shows the plain one.
    ToggleRefineAtRest,
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
    SetHotkeys(&'static str, Vec<Chord>),
    /// Gives the binding of this id the keys of the table.
    ResetHotkeys(&'static str),
    /// Gives every binding the keys of the table.
    ResetAllHotkeys,
    /// Forgets the recent files.
    ForgetRecent,
    /// Asks which scene file to begin with.
    ChooseOpenScene,
    /// Begins with another scene. Scripts are written for one scene, so they have no line for it.
    Begin(Beginning),
    /// Shows version and licences.
    ShowAbout,
    /// Shows the first steps again.
    ShowTour,
    /// Hides the first steps, from now on.
    CloseTour,
    /// Shows a file's folder in the system's file manager.
    ShowFolder(PathBuf),
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
    /// Begins a new animation of the scene: no keyframes, the scene at rest, the usual values, and [`super::NEW_FILE`] as its file.
    BeginAnew,
    /// Switches to the next interpolation.
    NextInterpolation,
    /// Switches to an interpolation.
    SetInterpolation(Interpolation),
    /// 100 ms less between keyframes.
    Faster,
    /// 100 ms more between keyframes.
    Slower,
    /// Sets the milliseconds between keyframes, clamped to 100 to 10,000.
    SetMsBetweenKeyframes(u32),
    /// Places a node: its `parent_from_node` translation.
    SetTranslation(RbtIndex, Vec3),
    /// Turns a node: its `parent_from_node` rotation; normalised, and refused where it has no direction.
    SetRotation(RbtIndex, Quat),
    /// Turns the chosen nodes by radians: each about an axis of its own, or all about the common centre and an axis of the primary.
    RotateChosen {
        /// A unit vector in the node's space, or in the primary's.
        axis_in_node: Vec3,
        /// The angle in radians, right-handed.
        radians: f64,
    },
    /// Moves the chosen nodes, each in its parent's space. What hangs below a chosen node is only carried along.
    TranslateChosen(Vec3),
    /// Reaches with the limb that a node ends: its end goes as near to a point in world space as bones and limits allow.
    Reach(RbtIndex, Vec3),
    /// The same, by so much from where the end is, in world space.
    ReachBy(RbtIndex, Vec3),
    /// Turns the limb that a node ends about the line from its root joint to its end, by degrees, right-handed along that line: the elbow
    /// or knee goes around it, and the end stays.
    TurnPole(RbtIndex, f64),
    /// Gives a named pose to the chosen nodes, or to the node that it was taken of.
    Pose(Arc<PoseFile>),
    /// Poses this node or, with `None`, the chosen ones.
    Nodes(NodeEdit, Option<RbtIndex>),
    /// Edits the list as a timeline.
    Timeline(TimelineEdit),
    /// Edits control nodes and timed keys, which are part of the scene.
    Scene(SceneEdit),
    /// Turns or moves the chosen nodes about or along axes.
    PullChosen(Pull),
    /// Moves the chosen nodes, or the eye, along the view, with respect to their auxiliary frames.
    /// Consecutive ones are one undo step.
    Wheel(Rbt),
}

/// Edits of the live pose that mean a node whatever its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NodeEdit {
    /// Returns a node to rest; what hangs below it keeps its own places.
    Reset(NodePart),
    /// Gives the other side the mirrored pose of a node and of all below it. A node in the middle swaps the sides below it.
    Mirror,
    /// Gives a node and all below it the copied pose. Another node than the copied one keeps its own translation.
    Paste {
        /// Whether the pose is mirrored first.
        is_mirrored: bool,
    },
}

/// What of a node's place is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NodePart {
    /// Translation and rotation.
    Both,
    /// The translation.
    Translation,
    /// The rotation.
    Rotation,
}

/// Edits of the keyframe list as a timeline. "The selected keyframes" are the current keyframe if none is selected.
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
    /// Moves the selected keyframes in time, not in the list. Within a drag, milliseconds count from its beginning.
    RetimeKeyframes(Retiming),
    /// Sets the easing of the intervals that begin at the selected keyframes.
    SetEasing(Easing),
    /// Moves the selected keyframes to before the keyframe with this index. The list's length moves them to the end.
    MoveKeyframes(usize),
    /// Deletes the selected keyframes.
    DeleteKeyframes,
    /// Copies the selected keyframes, then deletes them.
    CutKeyframes,
    /// Inserts the copied keyframes after the last selected one.
    PasteKeyframes,
    /// Inserts copies of the selected keyframes after the last of them.
    DuplicateKeyframes,
    /// Reverses the order of the selected keyframes, or of all where fewer than two are selected.
    ReverseKeyframes,
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
    /// Moves the playhead by ticks; negative ones move it back.
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

/// Changes of the view and of other session state; undo leaves it alone.
#[derive(Clone, Debug, PartialEq)]
pub enum ViewCommand {
    /// Looks from the next eye.
    NextEye,
    /// Looks from this eye.
    SetEye(Eye),
    /// Puts the work eye somewhere, in force or not; numbers out of range are moved into it.
    SetWorkEye(WorkEye),
    /// Looks from a side of the work eye's target, at the same distance.
    LookFrom(Side),
    /// Puts the work eye at the origin of a node, looking along the node's −Z; `None`: of the primary of the chosen nodes.
    LookFromNode(Option<RbtIndex>),
    /// Puts the work eye at the height of its target.
    LevelEye,
    /// Brings all shapes in sight of the work eye.
    ShowAll,
    /// Brings the chosen nodes in sight of the work eye.
    ShowChosen,
    /// Puts the work eye where it was at first.
    ResetWorkEye,
    /// With the sky as eye and nothing chosen: moves about the world's centre, or about the eye itself.
    ToggleSkyMode,
    /// The next click in the view chooses the node to move.
    StartPicking,
    /// Chooses the node to move and no other, or none.
    Choose(Option<RbtIndex>),
    /// Adds a node to the chosen ones as the primary, or takes it out if it is one of them.
    ChooseAlso(RbtIndex),
    /// What several chosen nodes turn about.
    SetPivot(Pivot),
    /// Shows or hides the arcball.
    ToggleArcball,
    /// Shows or hides the handles around the chosen node.
    ToggleGizmo,
    /// Whose axes handles go by.
    SetGizmoAxes(GizmoAxes),
    /// The next of local, parent, world, view.
    NextGizmoAxes,
    /// The steps of drags with Shift, kept within [`SnapSteps::DEGREES`] and [`SnapSteps::UNITS`].
    SetSnapSteps(SnapSteps),
    /// Shows or hides the help.
    ToggleHelp,
    /// Shows or hides all panels.
    TogglePanels,
    /// Shows or hides what the recorded camera sees, in a corner while the work eye is in force.
    ToggleInset,
    /// Whether that shows.
    SetInset(bool),
    /// Shows or hides the path that the chosen node takes.
    ToggleMotionPath,
    /// Shows or hides the poses that other interpolations give, wherever a sample is shown.
    ToggleComparison,
    /// Shows the poses that these blends give, wherever a sample is shown; none of them: no comparison.
    CompareBlends(Vec<Blend>),
    /// Ends the comparison with the animation of another file.
    EndCompareWith,
    /// Shows ghosts of the chosen node and what is below it only, or of all again.
    ToggleGhostsOfChosen,
    /// Whether ghosts are of the chosen node and what is below it only.
    SetGhostsOfChosen(bool),
    /// Switches whether the end of each drag updates the current keyframe.
    ToggleAutoKeys,
    /// Whether the end of each drag updates the current keyframe.
    SetAutoKeys(bool),
    /// Switches whether feet stay in place while the body above them moves.
    ToggleKeepFeet,
    /// Whether feet stay in place while the body above them moves.
    SetKeepFeet(bool),
    /// The number of neighbouring keyframes shown as ghosts on each side, at most [`crate::frame::MOST_GHOSTS`].
    SetGhosts(u8),
    /// Shows one more on each side, and after the most of them none.
    NextGhosts,
    /// Sets the clock of the timed keys to zero.
    RestartTimedKeys,
    /// Plays the timed keys from their start, or stops there.
    PlayTimedKeys,
    /// Holds that clock, or lets it go on.
    HoldTimedKeys,
    /// Sets that clock to a time in seconds, and holds it until playback starts.
    ScrubSeconds(f64),
}

/// The selection of the timeline. Keyframes and timed keys are never selected together.
#[derive(Clone, Debug, PartialEq)]
pub enum SelectionCommand {
    /// Selects these keyframes, and nothing else.
    Keyframes(Vec<KeyframeIndex>),
    /// Selects these timed keys, and nothing else.
    TimedKeys(Vec<KeyAt>),
}

/// What is copied for a later paste. Cutting and pasting are edits: [`TimelineEdit`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClipboardCommand {
    /// Copies the selected keyframes, or the current one.
    CopyKeyframes,
    /// Copies the displayed pose of this node, or of the primary of the chosen ones, and of all nodes below it.
    CopyPose(Option<RbtIndex>),
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
    /// Asks with which file to compare.
    ChooseCompare,
    /// Shows the animation of another file beside the document's: a keyframe file, or a text in any layout that is imported.
    CompareWith(PathBuf),
    /// Writes the scene's file. Asks for a path if it has none.
    WriteScene,
    /// Reads the scene's file again.
    ReloadScene,
    /// Asks where to save the scene.
    ChooseSaveSceneAs,
    /// Writes the scene to a file, which becomes its own from now on.
    SaveSceneAs(PathBuf),
    /// Asks where to write a model of another format.
    ChooseExportModel,
    /// Writes the scene and what the keyframes play as a model of another format, by the path's ending.
    ExportModel(PathBuf),
    /// Gives the pose of this name, or in this file, to the chosen nodes.
    ApplyPose(String),
    /// Writes the pose of the primary chosen node and all below it, or of the whole scene, under this name or to this file.
    SavePose(String),
    /// Writes a picture.
    Screenshot {
        /// Where to; `None`: the next free name beside the keyframe file.
        path: Option<PathBuf>,
        /// Whether it shows all that the window would: arcball, outline, ghosts, motion path and comparison. If not, the scene alone.
        has_overlays: bool,
    },
    /// Makes a film of what the keyframes play, beside whatever else goes on.
    Export(Box<ExportOptions>),
    /// Cancels the running export and removes its partial file.
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

/// A drag of the chosen nodes, or of the eye. Between `Begin` and `Commit` or `Abort`, changes of poses are one step.
#[derive(Clone, Debug, PartialEq)]
pub enum GestureCommand {
    /// A drag begins.
    Begin,
    /// Moves the dragged nodes with respect to their auxiliary frames, on top of the drag's earlier motions.
    Move(Rbt),
    /// Puts the dragged nodes where motions led them, in their parents' spaces: what stands for all of them.
    MoveTo {
        /// `parent_from_node` of each chosen node, in the order of the choice; of the eye if none is chosen.
        placed: Vec<Rbt>,
        /// Whether the last motion turned and did not move.
        is_turn: bool,
    },
    /// A drag begins with a handle that is held: keys that lock axes and type numbers belong to it.
    Grab(Handle),
    /// Puts the chosen nodes where a pull takes them from where they were when the drag began.
    Pull(Pull),
    /// Turns about this axis alone, or moves along it. Again: about the world's or the node's.
    Lock(Axis),
    /// Types a digit, `.` or `-` of the number that the drag goes by.
    Type(char),
    /// Takes back what was typed last.
    Erase,
    /// The drag ends and counts.
    Commit,
    /// The drag ends and is as if it had not been.
    Abort,
}

/// What the host must do for the editor. The host reports the result to the editor.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Read this file and hand the outcome to [`super::Editor::keyframes_read`].
    ReadKeyframes {
        /// Which file.
        path: PathBuf,
    },
    /// Read this file and hand the outcome to [`super::Editor::compared_read`].
    ReadCompared {
        /// Which file.
        path: PathBuf,
    },
    /// Read this file and hand the outcome to [`super::Editor::scene_read`].
    ReadScene {
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
        /// Its text, and the file of its meshes.
        files: SceneFiles,
        /// Whether the file was read or written before, as for keyframes.
        is_known: bool,
    },
    /// Read the pose of this name, or in this file, and hand it to [`super::Editor::pose_read`].
    ReadPose(String),
    /// Write this text and hand the outcome to [`super::Editor::pose_written`].
    WritePose {
        /// The pose's name, or its file.
        name: String,
        /// All of its text.
        text: String,
    },
    /// Ask where to save the scene.
    ChooseSaveSceneAs,
    /// Ask where to write a model of another format.
    ChooseExportModel,
    /// Write the document as a model by the path's ending and hand the outcome to [`super::Editor::model_written`].
    WriteModel {
        /// Which file.
        path: PathBuf,
    },
    /// Render what is displayed and hand the path, or what went wrong, to [`super::Editor::screenshot_taken`].
    Screenshot {
        /// Where to; `None`: the next free `inbetween-0001.png` beside the keyframe file.
        path: Option<PathBuf>,
        /// Whether it shows more than the scene.
        has_overlays: bool,
    },
    /// Make a film of the document as it is now and hand the outcome to [`super::Editor::exported`].
    Export(Box<ExportOptions>),
    /// Cancel the running export.
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
    /// Ask with which file to compare.
    ChooseCompare,
    /// Ask where to save.
    ChooseSaveAs,
    /// End the program, asking first where something is unsaved.
    Quit,
    /// Change the window or its settings. Without a window there is nothing to do.
    Window(WindowCommand),
}
