//! Why a command was refused: sentences for the status line, the trace and the log.

use std::path::PathBuf;

use thiserror::Error;

use crate::keyframe::KeyframeFileError;
use crate::pose_file::LONGEST_POSE_NAME;
use crate::scene::{Channel, SceneError};
use crate::text_layouts::TextError;
use crate::words::{Argument, Message, Phrase, Severity, display_by_message, quoted, texts};

/// A command that did nothing, and why.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum CommandError {
    /// There is no current keyframe.
    NoKeyframe {
        /// The key that creates one.
        create: Argument,
    },
    /// There is nothing to delete.
    NothingToDelete,
    /// There is no keyframe with that index.
    NoSuchKeyframe {
        /// The requested index.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// The list is too short to play.
    TooFewToPlay {
        /// The key that creates one.
        create: Argument,
    },
    /// The command cannot be done while playing.
    WhilePlaying {
        /// What was asked, as in "delete a keyframe".
        what: Phrase,
        /// The key that stops.
        stop: Argument,
        /// The key that pauses.
        pause: Argument,
    },
    /// A range of keyframes that cannot play.
    NoSuchRange {
        /// Its first keyframe.
        first: usize,
        /// Its last keyframe.
        last: usize,
    },
    /// There is nothing to paste.
    NothingCopied {
        /// The key that copies.
        copy: Argument,
    },
    /// A text that cannot name a pose.
    NotAPoseName {
        /// The text.
        name: String,
    },
    /// A pose that is shipped has that name.
    PoseIsShipped {
        /// The name.
        name: String,
    },
    /// No node of a pose is in the scene.
    PoseFitsNowhere {
        /// The pose's name.
        name: String,
    },
    /// There is no copied pose.
    NoPoseCopied,
    /// Nothing mirrors the node.
    NoOtherSide {
        /// Its path.
        path: String,
    },
    /// The copied pose is of other nodes.
    OtherNodes {
        /// The path below the node that was copied.
        path: String,
        /// The node that is chosen.
        chosen: String,
    },
    /// Pausing needs something that plays.
    NothingPlaying {
        /// The key that plays.
        play: Argument,
    },
    /// A movement needs a node.
    NothingChosen {
        /// The key after which a click chooses.
        pick: Argument,
    },
    /// A node has neither an end that reaches nor a shape.
    NoLimb {
        /// The node's path.
        path: String,
    },
    /// A control node scales a limb differently along its axes.
    SqueezedLimb {
        /// The path of the limb's last node.
        path: String,
    },
    /// There is no line about which a limb could turn.
    NoPole {
        /// The path of the limb's last node.
        path: String,
    },
    /// The scene has no such node or eye.
    NotInScene {
        /// `node` or `eye`.
        what: Phrase,
    },
    /// The scene has no node with that path.
    NoSuchNode {
        /// The path.
        path: String,
    },
    /// There is no key at that time.
    NoSuchKey {
        /// The node's path.
        path: String,
        /// Which of its values.
        channel: Channel,
        /// The time asked for.
        seconds: f64,
    },
    /// The scene has no timed keys to play.
    NoTimedKeys,
    /// No key is meant.
    NoKeys,
    /// The scene cannot become so.
    Scene(#[from] SceneError),
    /// A number is not finite, or a rotation has no direction.
    NotAValue {
        /// `position`, `rotation`, `duration`, `time` or `key time`.
        what: Phrase,
    },
    /// A node would be out of bounds: [`crate::rbt::LARGEST_COORDINATE`].
    TooFar,
    /// A time of timed keys is out of bounds: [`crate::scene::LATEST_SECONDS`].
    TooLate,
    /// The keyframe file could be larger than files that are read.
    KeyframesTooLarge {
        /// The most bytes that are read.
        limit: u64,
    },
    /// The scene's file could be larger than files that are read.
    SceneTooLarge {
        /// The most bytes that are read.
        limit: u64,
    },
    /// Undo and redo wait for the end of a drag.
    DuringDrag,
    /// There is no drag to go on with.
    NoDrag,
    /// There is nothing to undo.
    NothingToUndo,
    /// There is nothing to redo.
    NothingToRedo,
    /// The sky modes are for the sky camera with nothing chosen.
    NoSkyMode,
    /// The keyframe file could not be read.
    Read {
        /// Which file.
        path: PathBuf,
        /// Why.
        reason: Message,
    },
    /// The keyframe file is wrong.
    File {
        /// Which file.
        path: PathBuf,
        /// What is wrong with it; never empty.
        problems: Vec<KeyframeFileError>,
    },
    /// The keyframe file is a text that cannot be read.
    Text {
        /// Which file.
        path: PathBuf,
        /// What is wrong with it, and where.
        problem: TextError,
    },
    /// The file has a control node's keys, which are a part of a scene.
    HoldsScene {
        /// Which file.
        path: PathBuf,
    },
    /// An animation to compare with is too short to play.
    TooFewToCompare {
        /// Which file.
        path: PathBuf,
        /// How many keyframes it has.
        count: usize,
    },
    /// The scene was not read from a file.
    NoSceneFile,
    /// A scene's file holds a scene to which the keyframes do not fit.
    OtherScene {
        /// Which file.
        path: PathBuf,
    },
    /// A film could not be made.
    Export {
        /// Why.
        reason: Message,
    },
    /// A file could not be written.
    Write {
        /// Which file.
        path: PathBuf,
        /// Why.
        reason: Message,
    },
}

display_by_message!(CommandError);

impl CommandError {
    /// Why, as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        self.sentence().with_severity(Severity::Error)
    }

    fn sentence(&self) -> Message {
        match self {
            Self::NoKeyframe { create } => texts::refused_no_keyframe(create.clone()),
            Self::NothingToDelete => texts::REFUSED_NOTHING_TO_DELETE.into(),
            Self::NoSuchKeyframe { index, count: 0 } => texts::refused_no_such_keyframe_in_empty_list(*index),
            Self::NoSuchKeyframe { index, count: 1 } => texts::refused_no_such_keyframe_but_one(*index),
            Self::NoSuchKeyframe { index, count } => texts::refused_no_such_keyframe(*index, count - 1),
            Self::TooFewToPlay { create } => texts::refused_too_few_to_play(create.clone()),
            Self::WhilePlaying { what, stop, pause } => {
                texts::refused_while_playing(*what, stop.clone(), pause.clone())
            }
            Self::NoSuchRange { first, last } => texts::refused_no_such_range(*first, *last),
            Self::NothingCopied { copy } => texts::refused_nothing_copied(copy.clone()),
            Self::NotAPoseName { name } => texts::pose_file_name(quoted(name), LONGEST_POSE_NAME),
            Self::PoseIsShipped { name } => texts::refused_pose_is_shipped(quoted(name)),
            Self::PoseFitsNowhere { name } => texts::refused_pose_fits_nowhere(quoted(name)),
            Self::NoOtherSide { path } => texts::refused_no_other_side(quoted(path)),
            Self::NoPoseCopied => texts::REFUSED_NO_POSE_COPIED.into(),
            Self::OtherNodes { path, chosen } => texts::refused_other_nodes(quoted(path), quoted(chosen)),
            Self::NothingPlaying { play } => texts::refused_nothing_playing(play.clone()),
            Self::NothingChosen { pick } => texts::refused_nothing_chosen(pick.clone()),
            Self::NoLimb { path } => texts::refused_no_limb(quoted(path)),
            Self::SqueezedLimb { path } => texts::refused_squeezed_limb(quoted(path)),
            Self::NoPole { path } => texts::refused_no_pole(quoted(path)),
            Self::NotInScene { what } => texts::refused_not_in_scene(*what),
            Self::NoSuchNode { path } => texts::refused_no_such_node(quoted(path)),
            Self::NoSuchKey { path, channel, seconds } => texts::refused_no_such_key(path, channel.title(), *seconds),
            Self::NoTimedKeys => texts::REFUSED_NO_TIMED_KEYS.into(),
            Self::NoKeys => texts::REFUSED_NO_KEYS.into(),
            Self::Scene(error) => error.message(),
            Self::NotAValue { what } => texts::refused_not_a_value(*what),
            Self::TooFar => texts::REFUSED_TOO_FAR.into(),
            Self::TooLate => texts::REFUSED_TOO_LATE.into(),
            Self::KeyframesTooLarge { limit } => texts::refused_keyframes_too_large(limit >> 20),
            Self::SceneTooLarge { limit } => texts::refused_scene_too_large(limit >> 20),
            Self::DuringDrag => texts::REFUSED_DURING_DRAG.into(),
            Self::NoDrag => texts::REFUSED_NO_DRAG.into(),
            Self::NothingToUndo => texts::REFUSED_NOTHING_TO_UNDO.into(),
            Self::NothingToRedo => texts::REFUSED_NOTHING_TO_REDO.into(),
            Self::NoSkyMode => texts::REFUSED_NO_SKY_MODE.into(),
            Self::Read { path, reason } | Self::Write { path, reason } => {
                texts::refused_file(path.display(), reason.clone())
            }
            Self::File { path, problems } => {
                let problem = problems.first().map_or_else(|| Argument::from(""), |problem| problem.message().into());
                match problems.len() {
                    0 | 1 => texts::refused_file(path.display(), problem),
                    more => texts::refused_file_and_more(path.display(), problem, more - 1),
                }
            }
            Self::Text { path, problem } => texts::refused_file(path.display(), problem.message()),
            Self::HoldsScene { path } => texts::refused_holds_scene(path.display()),
            Self::TooFewToCompare { path, count } => {
                texts::refused_too_few_to_compare(path.display(), texts::count_keyframes(*count))
            }
            Self::NoSceneFile => texts::REFUSED_NO_SCENE_FILE.into(),
            Self::OtherScene { path } => texts::refused_other_scene(path.display()),
            Self::Export { reason } => texts::refused_export(reason.clone()),
        }
    }
}
