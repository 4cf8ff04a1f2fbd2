//! Where an editor is: a copy to go back to within a run, and plain data from which another run goes on.

use std::path::PathBuf;
use std::sync::Arc;

use glam::{Quat, Vec3};

use super::gesture::Gesture;
use super::history::History;
use super::placing::placeable;
use super::playback::Playback;
use super::timed_key_clock::TimedKeyClock;
use super::timeline::Clipboard;
use super::{Document, Editor, Session};
use crate::keyframe::{KeyframeIndex, KeyframeList, keyframes_from_json, keyframes_to_json};
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;
use crate::scene::SceneGraph;

/// An editor as it was before a command, but for what it said and the keys that it names. Cheap: the document shares its parts.
#[derive(Clone, Debug)]
pub struct Before {
    document: Document,
    saved: Document,
    session: Session,
    playback: Playback,
    timed_key_clock: TimedKeyClock,
    gesture: Option<Gesture>,
    clipboard: Clipboard,
    path: PathBuf,
    scene_path: Option<PathBuf>,
    is_file_known: bool,
    history: History,
    saved_scene: Arc<SceneGraph>,
}

/// A document and what is kept beside it, without what can be undone. Session and mode are set by commands.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    /// The keyframe file.
    pub path: PathBuf,
    /// The scene's file; `None` where it has none.
    pub scene_path: Option<PathBuf>,
    /// The scene, with its control nodes and keys.
    pub scene: Arc<SceneGraph>,
    /// The keyframes, interpolation and ms between keyframes, as a keyframe file.
    pub keyframes: String,
    /// The current keyframe.
    pub current: Option<usize>,
    /// The live pose: for each node `parent_from_node`, a translation and a quaternion as x, y, z, w.
    pub pose: Vec<[f32; 7]>,
    /// Whether the keyframe file holds something else.
    pub has_unsaved_keyframes: bool,
    /// The scene as its file has it; `None`: the same.
    pub saved_scene: Option<Arc<SceneGraph>>,
    /// Whether the keyframe file was read or written.
    pub is_file_known: bool,
    /// Copied keyframes, as a keyframe file; `None` where none are.
    pub copied: Option<String>,
    /// The node whose pose was copied, and the pose of everything, as [`Self::pose`].
    pub copied_pose: Option<(usize, Vec<[f32; 7]>)>,
    /// The clock of keys at their own times: what it was set to in seconds, and the ticks since then.
    pub seconds: (f64, u64),
    /// Whether that clock is held.
    pub holds_seconds: bool,
    /// Whether it is held until something plays.
    pub is_scrubbed_in_seconds: bool,
}

type Numbers = [f32; 7];

fn numbers_of(pose: &Pose) -> Vec<Numbers> {
    let numbers = |rbt: Rbt| {
        let ([x, y, z], [a, b, c, d]) = (rbt.translation.to_array(), rbt.rotation.to_array());
        [x, y, z, a, b, c, d]
    };
    pose.iter().map(numbers).collect()
}

fn set_numbers(pose: &mut Pose, numbers: &[Numbers]) {
    for (place, numbers) in numbers.iter().enumerate() {
        pose.set(RbtIndex::new(place), rbt_of(numbers));
    }
}

fn rbt_of(&[x, y, z, a, b, c, d]: &Numbers) -> Rbt {
    Rbt::new(Vec3::new(x, y, z), Quat::from_xyzw(a, b, c, d))
}

impl Snapshot {
    /// Whether the parts belong together, so that an editor can be made of them.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        let is_list = |text: &String| keyframes_from_json(text.as_bytes(), &self.scene).is_ok();
        let is_held = |numbers: &Numbers| placeable(rbt_of(numbers)).is_ok();
        let count = self.scene.rbt_count();
        let is_pose = |pose: &[Numbers]| pose.len() == count && pose.iter().all(is_held);
        is_pose(&self.pose)
            && is_list(&self.keyframes)
            && self.copied.as_ref().is_none_or(is_list)
            && self.copied_pose.as_ref().is_none_or(|(node, pose)| *node < count && is_pose(pose))
            && self.seconds.0.is_finite()
    }
}

impl Editor {
    /// The editor as it is before a command.
    #[must_use]
    pub fn before(&self) -> Before {
        Before {
            document: self.document.clone(),
            saved: self.saved.clone(),
            session: self.session.clone(),
            playback: self.playback.clone(),
            timed_key_clock: self.timed_key_clock,
            gesture: self.gesture.clone(),
            clipboard: self.clipboard.clone(),
            path: self.keyframe_file.clone(),
            scene_path: self.scene_path.clone(),
            is_file_known: self.is_file_known,
            history: self.history.clone(),
            saved_scene: Arc::clone(&self.saved_scene),
        }
    }

    /// Goes back to what was before a command that panicked.
    pub fn go_back(&mut self, before: Before) {
        self.document = before.document;
        self.saved = before.saved;
        self.session = before.session;
        self.playback = before.playback;
        self.timed_key_clock = before.timed_key_clock;
        self.gesture = before.gesture;
        self.clipboard = before.clipboard;
        self.keyframe_file = before.path;
        self.scene_path = before.scene_path;
        self.is_file_known = before.is_file_known;
        self.history = before.history;
        self.saved_scene = before.saved_scene;
    }

    /// Whether it is as a new editor of its scene: with no keyframes, nothing done, and nothing set.
    #[must_use]
    pub fn is_fresh(&self) -> bool {
        let fresh = Self::new(Arc::clone(self.scene()), PathBuf::new());
        self.document == fresh.document
            && self.session == fresh.session
            && self.timed_key_clock == fresh.timed_key_clock
            && self.clipboard.keyframes().is_empty()
            && self.clipboard.pose().is_none()
            && self.is_at_rest()
            && !self.is_file_known
            && !self.has_unsaved_scene()
            && self.undo_label().is_none()
            && self.redo_label().is_none()
    }

    /// Goes on with what another editor has said.
    pub fn go_on_saying(&mut self, other: &Self) {
        self.said = other.said.clone();
        (self.message, self.status) = (None, None);
    }

    /// Names the keyframe file without reading it.
    pub fn set_path(&mut self, path: PathBuf) {
        self.keyframe_file = path;
    }

    /// Whether the editor rests: nothing plays, is scrubbed or dragged, so that [`Editor::snapshot`] holds all there is to keep.
    #[must_use]
    pub const fn is_at_rest(&self) -> bool {
        matches!(self.playback, Playback::Stopped) && self.gesture.is_none()
    }

    /// The document and what is kept beside it, as plain data.
    #[must_use]
    pub fn snapshot(&self) -> Snapshot {
        let document = &self.document;
        let text = |list: &KeyframeList| {
            keyframes_to_json(&document.scene, list, document.interpolation, document.ms_between_keyframes)
        };
        let copied = self.clipboard.keyframes();
        Snapshot {
            path: self.keyframe_file.clone(),
            scene_path: self.scene_path.clone(),
            scene: Arc::clone(&document.scene),
            keyframes: text(&document.keyframes),
            current: document.keyframes.current().map(KeyframeIndex::get),
            pose: numbers_of(&document.live_pose),
            has_unsaved_keyframes: self.has_unsaved_keyframes(),
            saved_scene: self.has_unsaved_scene().then(|| Arc::clone(&self.saved_scene)),
            is_file_known: self.is_file_known,
            copied: (!copied.is_empty()).then(|| text(&KeyframeList::new(copied.to_vec()))),
            copied_pose: self.clipboard.pose().map(|(node, pose)| (node.get(), numbers_of(pose))),
            seconds: (self.timed_key_clock.from, self.timed_key_clock.ticks),
            holds_seconds: self.timed_key_clock.is_held,
            is_scrubbed_in_seconds: self.timed_key_clock.is_scrubbed,
        }
    }

    /// An editor of a snapshot that is whole.
    #[must_use]
    pub fn of_snapshot(snapshot: &Snapshot) -> Self {
        let mut editor = Self::new(Arc::clone(&snapshot.scene), snapshot.path.clone());
        editor.scene_path.clone_from(&snapshot.scene_path);
        editor.is_file_known = snapshot.is_file_known;
        let list = |text: &str| {
            let file = keyframes_from_json(text.as_bytes(), &snapshot.scene).ok()?;
            let (keyframes, interpolation, ms_between_keyframes) = file.into_parts();
            Some((keyframes, interpolation, ms_between_keyframes))
        };
        if let Some((keyframes, interpolation, ms_between_keyframes)) = list(&snapshot.keyframes) {
            let document = &mut editor.document;
            document.keyframes = keyframes;
            document.interpolation = interpolation;
            document.ms_between_keyframes = ms_between_keyframes;
            if let Some(current) = snapshot.current {
                document.keyframes.set_current(KeyframeIndex::new(current));
            }
        }
        set_numbers(&mut editor.document.live_pose, &snapshot.pose);
        let copied = snapshot.copied.as_deref().and_then(list);
        let copied_pose = snapshot.copied_pose.as_ref().map(|(node, numbers)| {
            let mut pose = editor.scene().rest_pose().clone();
            set_numbers(&mut pose, numbers);
            (RbtIndex::new(*node), pose)
        });
        editor.clipboard =
            Clipboard::new(copied.map_or_else(Vec::new, |(list, ..)| list.as_slice().to_vec()), copied_pose);
        editor.timed_key_clock = TimedKeyClock {
            from: snapshot.seconds.0,
            ticks: snapshot.seconds.1,
            is_held: snapshot.holds_seconds,
            is_scrubbed: snapshot.is_scrubbed_in_seconds,
        };
        if !snapshot.has_unsaved_keyframes {
            editor.saved = editor.document.clone();
        }
        if let Some(saved) = &snapshot.saved_scene {
            editor.saved_scene = Arc::clone(saved);
        }
        editor
    }
}
