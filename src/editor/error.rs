//! Why a command was refused: sentences for the status line, the trace and the log.

use std::path::PathBuf;

use thiserror::Error;

use crate::keyframe::KeyframeFileError;
use crate::scene::SceneError;
use crate::text_layouts::TextError;

/// A command that did nothing, and why.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum CommandError {
    /// There is no current keyframe.
    #[error("No keyframe is defined yet. Press {create} to create one.")]
    NoKeyframe {
        /// The key that creates one.
        create: String,
    },
    /// There is nothing to delete.
    #[error("The list is empty: there is no keyframe to delete.")]
    NothingToDelete,
    /// There is no keyframe in that place.
    #[error("There is no keyframe {index}: {}", range_sentence(*.count))]
    NoSuchKeyframe {
        /// The place asked for.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// The list is too short to play.
    #[error("Fewer than 4 keyframes: nothing to play yet. Press {create} to add one.")]
    TooFewToPlay {
        /// The key that creates one.
        create: String,
    },
    /// The command cannot be done while playing.
    #[error("Cannot {what} while playing. Press {stop} to stop or {pause} to pause first.")]
    WhilePlaying {
        /// What was asked, as in "delete a keyframe".
        what: &'static str,
        /// The key that stops.
        stop: String,
        /// The key that pauses.
        pause: String,
    },
    /// A range of keyframes that cannot play.
    #[error(
        "Keyframes {first} to {last} cannot play: a range runs from keyframe 1 or later to the last but one or earlier."
    )]
    NoSuchRange {
        /// Its first keyframe.
        first: usize,
        /// Its last keyframe.
        last: usize,
    },
    /// There is nothing to paste.
    #[error("Nothing is copied yet: {copy} copies the selected keyframes.")]
    NothingCopied {
        /// The key that copies.
        copy: String,
    },
    /// There is no copied pose.
    #[error("No pose is copied yet: choose a node and copy its pose first.")]
    NoPoseCopied,
    /// The copied pose is of other nodes.
    #[error("The copied pose has a node {path:?} that {chosen:?} has not.")]
    OtherNodes {
        /// The path below the node that was copied.
        path: String,
        /// The node that is chosen.
        chosen: String,
    },
    /// Pausing needs something that plays.
    #[error("Nothing is playing. Press {play} to play.")]
    NothingPlaying {
        /// The key that plays.
        play: String,
    },
    /// A movement needs a node.
    #[error("No node is chosen. Choose one first: {pick} and a click, Ctrl+click, or the list of nodes.")]
    NothingChosen {
        /// The key after which a click chooses.
        pick: String,
    },
    /// The scene has no such node or eye.
    #[error("The scene has no such {what}.")]
    NotInScene {
        /// `node` or `eye`.
        what: &'static str,
    },
    /// The scene has no node with that path.
    #[error("The scene has no node {path:?}.")]
    NoSuchNode {
        /// The path.
        path: String,
    },
    /// There is no key at that time.
    #[error("{path} has no key of its {channel} at {seconds} s.")]
    NoSuchKey {
        /// The node's path.
        path: String,
        /// Which of its values.
        channel: &'static str,
        /// The time asked for.
        seconds: f64,
    },
    /// No key is meant.
    #[error("No keys are selected: click one in the timeline.")]
    NoKeys,
    /// The scene cannot become so.
    #[error("{0}")]
    Scene(#[from] SceneError),
    /// A number is not finite, or a rotation has no direction.
    #[error("That is not a {what}: nothing was changed.")]
    NotAValue {
        /// `position`, `rotation`, `duration`, `time` or `key time`.
        what: &'static str,
    },
    /// Undo and redo wait for the end of a drag.
    #[error("Finish the drag first, or press Escape to take it back.")]
    DuringDrag,
    /// There is no drag to go on with.
    #[error("There is no drag to go on with.")]
    NoDrag,
    /// There is nothing to undo.
    #[error("There is nothing to undo.")]
    NothingToUndo,
    /// There is nothing to redo.
    #[error("There is nothing to redo.")]
    NothingToRedo,
    /// The sky modes are for the sky camera with nothing chosen.
    #[error("The two ways to move the sky camera need the sky as eye and no node chosen.")]
    NoSkyMode,
    /// The keyframe file could not be read.
    #[error("{}: {reason}", path.display())]
    Read {
        /// Which file.
        path: PathBuf,
        /// Why.
        reason: String,
    },
    /// The keyframe file is wrong.
    #[error("{}: {}{}", path.display(), .problems.first().map(ToString::to_string).unwrap_or_default(), more_sentence(.problems.len()))]
    File {
        /// Which file.
        path: PathBuf,
        /// What is wrong with it; never empty.
        problems: Vec<KeyframeFileError>,
    },
    /// The keyframe file is a text that cannot be read.
    #[error("{}: {problem}", path.display())]
    Text {
        /// Which file.
        path: PathBuf,
        /// What is wrong with it, and where.
        problem: TextError,
    },
    /// The file has a control node's keys, which are a part of a scene.
    #[error("{}: keys of a control node, which belong to a scene, not to the list: make a scene file of them with `inbetween convert`", path.display())]
    HoldsScene {
        /// Which file.
        path: PathBuf,
    },
    /// A film could not be made.
    #[error("Nothing was exported: {reason}.")]
    Export {
        /// Why.
        reason: String,
    },
    /// A file could not be written.
    #[error("{}: {reason}", path.display())]
    Write {
        /// Which file.
        path: PathBuf,
        /// Why.
        reason: String,
    },
}

fn range_sentence(count: usize) -> String {
    match count {
        0 => "the list is empty.".to_owned(),
        1 => "the only one is 0.".to_owned(),
        _ => format!("they are 0 to {}.", count - 1),
    }
}

fn more_sentence(problems: usize) -> String {
    match problems {
        0 | 1 => String::new(),
        2 => " (and 1 more problem)".to_owned(),
        _ => format!(" (and {} more problems)", problems - 1),
    }
}
