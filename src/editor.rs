//! The editor owns all state and is the only way to change it.
//!
//! [`Command`]s go in through [`Editor::apply`], ticks through [`Editor::tick`]. Work outside of the editor comes out as an [`Effect`],
//! which a [`Host`] performs. The editor knows no window, no GPU, no file system and no clock, so it cannot fail because of them.

mod apply;
mod choice;
mod command;
pub mod commands;
mod comparing;
mod document;
mod error;
mod export;
mod eye;
mod files;
mod framing;
mod gesture;
pub mod gizmo;
mod history;
mod host;
pub mod keymap;
mod limb_balls;
mod manipulate;
mod motion_path;
mod named_poses;
mod node_edits;
mod picking;
mod placing;
mod playback;
mod playing;
mod reaching;
mod said;
mod scene_edits;
mod snapshot;
mod timed_key_clock;
mod timeline;
mod view;

use std::path::{Path, PathBuf};
use std::sync::Arc;

pub use choice::{Choice, Pivot};
pub use command::{
    Beginning, ClipboardCommand, Command, Edit, Effect, FileCommand, GestureCommand, ModelChoice, NodeEdit, NodePart,
    PlaybackCommand, SelectionCommand, TimelineEdit, ViewCommand, WindowCommand,
};
pub use comparing::ComparedAnimation;
pub use document::Document;
pub use error::CommandError;
pub use eye::{Eye, WorkEye};
pub use files::{MODEL_ENDINGS, NEW_FILE};
pub use framing::Side;
pub use history::{MOST_STEPS, Reach};
pub use host::{FileAccess, FileOutcome, Host, PathQuestion, WindowHost, Writing, Written};
pub use limb_balls::{LimbBall, dragged_point};
pub use manipulate::{DragKind, Manipulation};
pub use motion_path::PathDot;
pub use picking::CLICK_REACH;
pub use playback::PlayMode;
pub use playing::SPEED_PERCENT_RANGE;
pub use said::Said;
pub use scene_edits::{KeyAt, SceneEdit, TrackPath};
pub use snapshot::{Before, Snapshot};
pub use timed_key_clock::Transport;

use crate::keyframe::{Blend, KeyframeIndex};
use crate::pose::Pose;
use crate::scene::SceneGraph;
use crate::words::Phrase;
pub use crate::words::{Message, Severity};
use gesture::Gesture;
use gizmo::{GizmoAxes, SnapSteps};
use history::History;
use keymap::Keymap;
use playback::Playback;
use timed_key_clock::TimedKeyClock;
use timeline::Clipboard;

/// What the sky camera moves about, with the sky as eye and no node chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SkyMode {
    /// The world's centre.
    #[default]
    WorldCentre,
    /// The eye itself.
    Eye,
}

/// State of viewing, selecting and playing. It is in no file, and undo leaves it alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Session {
    /// The nodes that drags move; none: the eye, or the work eye where that is in force.
    pub chosen: Choice,
    /// What several chosen nodes turn about.
    pub pivot: Pivot,
    /// What one looks from.
    pub eye: Eye,
    /// Where the work eye stands, in force or not.
    pub work_eye: WorkEye,
    /// The eye of the scene that was in force last, by its index: what keyframes are looked at with.
    pub recorded_eye: usize,
    /// Whether the work eye was in force: the hotkey of the next eye then leads back to it.
    pub has_used_work_eye: bool,
    /// What the sky camera moves about.
    pub sky_mode: SkyMode,
    /// Whether the next click in the view chooses a node.
    pub is_picking: bool,
    /// Whether the arcball is drawn.
    pub shows_arcball: bool,
    /// Whether handles are drawn around the chosen node, where the arcball is.
    pub shows_gizmo: bool,
    /// Whose axes handles go by.
    pub gizmo_axes: GizmoAxes,
    /// The steps of drags with Shift.
    pub snap: SnapSteps,
    /// Whether what the recorded camera sees shows in a corner while the work eye is in force.
    pub shows_inset: bool,
    /// Whether the path of the chosen node is drawn.
    pub shows_motion_path: bool,
    /// The blends whose poses are shown wherever a sample is, apart from the one that plays.
    pub compared_blends: Vec<Blend>,
    /// The keyframes that are selected in the timeline, in order.
    pub selected: Vec<KeyframeIndex>,
    /// The selected timed keys. If there are any, no keyframe is selected.
    pub selected_keys: Vec<KeyAt>,
    /// What happens at the end of what plays.
    pub play_mode: PlayMode,
    /// The first and the last keyframe of the list that play; `None`: all but the first and the last of the list.
    pub play_range: Option<(usize, usize)>,
    /// Speed of playing on top of the ms between keyframes, in percent.
    pub speed_percent: u32,
    /// Whether the end of each drag updates the current keyframe.
    pub auto_keys: bool,
    /// Whether feet stay in place while the body above them moves.
    pub keeps_feet: bool,
    /// How many neighbouring keyframes on each side are shown as ghosts: 0 to [`crate::frame::MOST_GHOSTS`].
    pub ghosts: u8,
    /// Whether there are ghosts only of the chosen node and what is below it.
    pub ghosts_of_chosen: bool,
    /// Whether the help is shown.
    pub shows_help: bool,
    /// Whether the panels are shown.
    pub shows_panels: bool,
}

/// All state of the program except that of the window.
///
/// ```
/// use std::path::PathBuf;
/// use std::sync::Arc;
///
/// use inbetween::editor::{Command, Edit, Editor};
/// use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
///
/// let scene = Arc::new(built_in_scene(DEFAULT_SCENE).expect("it is built in"));
/// let mut editor = Editor::new(scene, PathBuf::from("animation.json"));
/// editor.apply(Command::Edit(Edit::CreateKeyframe))?;
/// assert_eq!(editor.document().keyframes.len(), 1);
/// editor.apply(Command::Undo)?;
/// assert!(editor.document().keyframes.is_empty());
/// # Ok::<(), inbetween::editor::CommandError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Editor {
    document: Document,
    history: History,
    session: Session,
    playback: Playback,
    timed_key_clock: TimedKeyClock,
    /// What happens at the last timed key, where the transport plays those.
    timed_key_mode: PlayMode,
    /// The drag that is going on.
    gesture: Option<Gesture>,
    /// The hotkeys that messages name.
    keymap: Keymap,
    clipboard: Clipboard,
    /// The animation that is shown beside the document's.
    compared: Option<Arc<ComparedAnimation>>,
    /// The message of the last command or tick.
    message: Option<Message>,
    /// What the status line shows.
    status: Option<Message>,
    said: Said,
    keyframe_file: PathBuf,
    /// The document as last read or written; an empty one before that. Used to detect unsaved changes.
    saved: Document,
    is_file_known: bool,
    /// The scene's file; `None` if it has none yet.
    scene_path: Option<PathBuf>,
    /// The scene as last read or written, or as it was at the start.
    saved_scene: Arc<SceneGraph>,
}

impl Editor {
    /// An editor of a scene at rest, with no keyframes, whose keyframe file is `keyframe_file`.
    #[must_use]
    pub fn new(scene: Arc<SceneGraph>, keyframe_file: PathBuf) -> Self {
        let document = Document::new(Arc::clone(&scene));
        let mut editor = Self {
            saved_scene: scene,
            scene_path: None,
            saved: document.clone(),
            document,
            history: History::default(),
            session: Session {
                chosen: Choice::default(),
                pivot: Pivot::default(),
                eye: Eye::Recorded(0),
                work_eye: WorkEye::default(),
                recorded_eye: 0,
                has_used_work_eye: false,
                sky_mode: SkyMode::default(),
                is_picking: false,
                shows_arcball: true,
                shows_gizmo: true,
                gizmo_axes: GizmoAxes::default(),
                snap: SnapSteps::default(),
                shows_inset: true,
                shows_motion_path: true,
                compared_blends: Vec::new(),
                selected: Vec::new(),
                selected_keys: Vec::new(),
                play_mode: PlayMode::default(),
                play_range: None,
                speed_percent: 100,
                auto_keys: false,
                keeps_feet: false,
                ghosts: 0,
                ghosts_of_chosen: false,
                shows_help: false,
                shows_panels: true,
            },
            playback: Playback::default(),
            timed_key_clock: TimedKeyClock::default(),
            timed_key_mode: PlayMode::Once,
            gesture: None,
            keymap: Keymap::default(),
            clipboard: Clipboard::default(),
            compared: None,
            message: None,
            status: None,
            said: Said::default(),
            keyframe_file,
            is_file_known: false,
        };
        editor.session.work_eye = editor.first_work_eye();
        editor
    }

    /// The same with a scene that was read from this file, which is where it is saved.
    #[must_use]
    pub fn with_scene_path(self, path: PathBuf) -> Self {
        Self { scene_path: Some(path), ..self }
    }

    /// An editor of a document that is in no file yet: neither its scene nor its keyframes are saved.
    #[must_use]
    pub fn of_unsaved(document: Document, keyframe_file: PathBuf) -> Self {
        let mut editor = Self::new(Arc::clone(&document.scene), keyframe_file);
        editor.saved_scene = Arc::new(document.scene.renamed(""));
        editor.document = document;
        editor
    }

    /// The scene.
    #[must_use]
    pub const fn scene(&self) -> &Arc<SceneGraph> {
        &self.document.scene
    }

    /// The document: scene, keyframes, live pose, interpolation, ms between keyframes.
    #[must_use]
    pub const fn document(&self) -> &Document {
        &self.document
    }

    /// How the scene is looked at and handled.
    #[must_use]
    pub const fn session(&self) -> &Session {
        &self.session
    }

    /// What the last command said, or playing when it ended; `None` where it said nothing.
    #[must_use]
    pub const fn message(&self) -> Option<&Message> {
        self.message.as_ref()
    }

    /// The same in English, as traces have it; empty where nothing was said.
    #[must_use]
    pub fn message_text(&self) -> String {
        self.message.as_ref().map(Message::to_string).unwrap_or_default()
    }

    /// What the status line shows: the last message. The beginning of a drag takes it away; what follows of the drag says nothing.
    #[must_use]
    pub const fn status(&self) -> Option<&Message> {
        self.status.as_ref()
    }

    /// What was said lately, so that nothing is missed where several things are said at once.
    #[must_use]
    pub const fn said(&self) -> &Said {
        &self.said
    }

    /// The keyframe file: what `i` reads and `w` writes.
    #[must_use]
    pub fn keyframe_file(&self) -> &Path {
        &self.keyframe_file
    }

    /// The file that the scene is saved in; `None` where it was not read from one and not saved yet.
    #[must_use]
    pub fn scene_path(&self) -> Option<&Path> {
        self.scene_path.as_deref()
    }

    /// Whether a file, that of the keyframes or that of the scene, does not hold all that it should.
    #[must_use]
    pub fn has_unsaved_changes(&self) -> bool {
        self.has_unsaved_keyframes() || self.has_unsaved_scene()
    }

    /// Whether the keyframes, the interpolation or the ms between keyframes differ from what the file holds.
    #[must_use]
    pub fn has_unsaved_keyframes(&self) -> bool {
        !self.document.same_file_as(&self.saved)
    }

    /// Whether control nodes or timed keys differ from those in the scene's file.
    #[must_use]
    pub fn has_unsaved_scene(&self) -> bool {
        !Arc::ptr_eq(&self.document.scene, &self.saved_scene) && self.document.scene != self.saved_scene
    }

    /// Whether the robots stand in a pose that no keyframe holds; the eyes' own places do not count.
    #[must_use]
    pub fn has_unsaved_posing(&self) -> bool {
        let kept =
            self.document.keyframes.current_keyframe().map_or(self.scene().rest_pose(), |keyframe| &keyframe.pose);
        let sky = self.scene().eyes()[0];
        self.scene().rbt_indices().any(|rbt| rbt != sky && kept.get(rbt) != self.document.live_pose.get(rbt))
    }

    /// Whether something plays; paused is not playing.
    #[must_use]
    pub const fn is_playing(&self) -> bool {
        matches!(self.playback, Playback::Playing(_))
    }

    /// Whether playing was paused and can go on.
    #[must_use]
    pub const fn is_paused(&self) -> bool {
        matches!(self.playback, Playback::Paused(_))
    }

    /// Whether a drag is going on.
    #[must_use]
    pub const fn is_dragging(&self) -> bool {
        self.gesture.is_some()
    }

    /// What is on screen: a sample while playing or scrubbed, otherwise the live pose.
    #[must_use]
    pub fn displayed_pose(&self) -> Pose {
        self.sampled_pose().unwrap_or_else(|| self.document.live_pose.clone())
    }

    /// Makes the document as it is now the ground of undo: what the program was started with is not undone.
    pub fn begin_history(&mut self) {
        self.history.forget();
    }

    /// How far undo and redo lead.
    #[must_use]
    pub fn undo_reach(&self) -> Reach {
        self.history.reach()
    }

    /// What the next undo would take back, as in "new keyframe".
    #[must_use]
    pub fn undo_label(&self) -> Option<Phrase> {
        self.history.undo_label()
    }

    /// What the next redo would bring back.
    #[must_use]
    pub fn redo_label(&self) -> Option<Phrase> {
        self.history.redo_label()
    }
}
