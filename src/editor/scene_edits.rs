//! Edits of timed keys and of the control nodes that have them. Both are part of the scene, which the
//! document holds, so that all of it is undone.

use std::sync::Arc;

use super::apply::CommandResult;
use super::{CommandError, Editor};
use crate::lighting::BuiltInLighting;
use crate::scene::{Channel, KeyValue, NodeId, SceneError, SceneGraph, moved_seconds};
use crate::words::{Phrase, texts};

/// A channel of a node.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct TrackPath {
    /// The node's path.
    pub node: Arc<str>,
    /// The channel.
    pub channel: Channel,
}

/// The track and the time of a timed key, which need not exist.
#[derive(Clone, Debug, PartialEq)]
pub struct KeyAt {
    /// The track.
    pub track: TrackPath,
    /// Its time in seconds.
    pub seconds: f64,
}

impl KeyAt {
    /// A key of a channel of the node with this path.
    #[must_use]
    pub fn new(node: &str, channel: Channel, seconds: f64) -> Self {
        Self { track: TrackPath { node: node.into(), channel }, seconds }
    }
}

/// Edits of control nodes and of timed keys. Nodes are named by their paths, which hold when other nodes come and go.
#[derive(Clone, Debug, PartialEq)]
pub enum SceneEdit {
    /// Adds keys with the values shown at their times, and selects them. Existing keys stay.
    AddKeys(Vec<KeyAt>),
    /// Sets the value of the key at a time. A missing key is added.
    SetKey {
        /// The node's path.
        node: Arc<str>,
        /// The key's time in seconds.
        seconds: f64,
        /// The value, which says the channel too.
        value: KeyValue,
    },
    /// Moves keys in time. They replace keys at their new times. Within a drag, keys and times refer to its beginning.
    MoveKeys {
        /// Which keys.
        keys: Vec<KeyAt>,
        /// By how many seconds.
        by: f64,
    },
    /// Deletes keys.
    DeleteKeys(Vec<KeyAt>),
    /// Inserts a control node without keys above the node with this path. Nothing moves.
    PutControlAbove(Arc<str>),
    /// The same above the chosen node.
    PutControlAboveChosen,
    /// Removes a control node. Its children take its place.
    RemoveControl(Arc<str>),
    /// Gives a control node another name.
    RenameControl(Arc<str>, String),
    /// Gives the scene the light of a built-in lighting.
    SetLighting(BuiltInLighting),
}

impl Editor {
    pub(super) fn edit_scene(&mut self, edit: SceneEdit) -> CommandResult {
        match edit {
            SceneEdit::AddKeys(keys) => self.add_keys(keys),
            SceneEdit::SetKey { node, seconds, value } => {
                let id = self.known_node(&node)?;
                let scene = self.document.scene.with_key(id, seconds, value)?;
                self.put_scene(texts::ACT_CHANGE_OF_A_KEY, scene)?;
                Ok(None)
            }
            SceneEdit::MoveKeys { keys, by } => self.move_keys(&keys, by),
            SceneEdit::DeleteKeys(keys) => self.delete_keys(keys),
            SceneEdit::PutControlAbove(path) => {
                let id = self.known_node(&path)?;
                self.put_control_above(id)
            }
            SceneEdit::PutControlAboveChosen => {
                let chosen = self.session.chosen.primary().ok_or_else(|| self.nothing_chosen())?;
                self.put_control_above(self.document.scene.rbt_node(chosen))
            }
            SceneEdit::RemoveControl(path) => {
                let scene = self.document.scene.without_control(self.known_node(&path)?)?;
                self.put_scene(texts::ACT_REMOVAL_OF_A_CONTROL_NODE, scene)?;
                Ok(Some(texts::control_removed(&*path)))
            }
            SceneEdit::RenameControl(path, name) => {
                let id = self.known_node(&path)?;
                let scene = self.document.scene.with_control_renamed(id, name.trim())?;
                self.put_scene(texts::ACT_RENAMING_OF_A_CONTROL_NODE, scene)?;
                Ok(Some(texts::control_renamed(name.trim())))
            }
            SceneEdit::SetLighting(lighting) => {
                if !self.is_lit_by(lighting) {
                    let scene = self.document.scene.with_lighting(lighting.into());
                    self.put_scene(texts::ACT_CHANGE_OF_LIGHTING, scene)?;
                }
                Ok(Some(texts::lighting_is(lighting.title())))
            }
        }
    }

    /// Whether the scene has the light of a built-in lighting, without changes of its own.
    #[must_use]
    pub fn is_lit_by(&self, lighting: BuiltInLighting) -> bool {
        *self.document.scene.lighting() == lighting.into()
    }

    fn known_node(&self, path: &str) -> Result<NodeId, CommandError> {
        self.document.scene.find(path).ok_or_else(|| CommandError::NoSuchNode { path: path.to_owned() })
    }

    /// Replaces the scene as one undo step, or as part of the current drag.
    fn put_scene(&mut self, label: Phrase, scene: SceneGraph) -> Result<(), CommandError> {
        self.record(label, None, |document| document.scene = Arc::new(scene))
    }

    fn put_control_above(&mut self, id: NodeId) -> CommandResult {
        let (scene, path) = self.document.scene.with_control_above(id)?;
        self.put_scene(texts::ACT_NEW_CONTROL_NODE, scene)?;
        Ok(Some(texts::control_put_above(path)))
    }

    fn add_keys(&mut self, keys: Vec<KeyAt>) -> CommandResult {
        let mut scene = (*self.document.scene).clone();
        for key in &keys {
            let id = self.known_node(&key.track.node)?;
            if scene.key_seconds(id, key.track.channel).contains(&key.seconds) {
                continue;
            }
            let value = scene.key_value_at(id, key.track.channel, key.seconds);
            scene = scene.with_key(id, key.seconds, value.ok_or_else(|| no_channel(&scene, id, key.track.channel))?)?;
        }
        self.put_scene(texts::ACT_NEW_KEYS, scene)?;
        let said = keys
            .first()
            .map(|KeyAt { seconds, .. }| texts::keys_added(texts::count_keys(keys.len()), format!("{seconds:.3}")));
        self.select_keys(keys)?;
        Ok(said)
    }

    fn move_keys(&mut self, keys: &[KeyAt], by: f64) -> CommandResult {
        if keys.is_empty() {
            return Err(CommandError::NoKeys);
        }
        // A drag always starts from its first state, so that keys that were only passed over are restored.
        let base = Arc::clone(&self.gesture.as_ref().map_or(&self.document, |gesture| &gesture.before).scene);
        let mut scene = (*base).clone();
        for (id, track, times) in by_track(&base, keys)? {
            scene = scene.with_keys_moved(id, track.channel, &times, by)?;
        }
        self.put_scene(texts::ACT_MOVING_OF_KEYS, scene)?;
        let moved = keys.iter().map(|key| KeyAt { seconds: moved_seconds(key.seconds, by), ..key.clone() });
        self.select_keys(moved.collect())?;
        Ok(Some(texts::keys_moved(texts::count_keys(keys.len()), format!("{by:.3}"))))
    }

    pub(super) fn delete_keys(&mut self, keys: Vec<KeyAt>) -> CommandResult {
        if keys.is_empty() {
            return Err(CommandError::NoKeys);
        }
        let mut scene = (*self.document.scene).clone();
        for (id, track, times) in by_track(&self.document.scene, &keys)? {
            scene = scene.without_keys(id, track.channel, &times)?;
        }
        self.put_scene(texts::ACT_DELETION_OF_KEYS, scene)?;
        Ok(Some(texts::keys_deleted(texts::count_keys(keys.len()))))
    }

    pub(super) fn select_keys(&mut self, mut keys: Vec<KeyAt>) -> CommandResult {
        keys.sort_by(|a, b| a.track.cmp(&b.track).then(a.seconds.total_cmp(&b.seconds)));
        keys.dedup();
        by_track(&self.document.scene, &keys)?;
        if !keys.is_empty() {
            self.session.selected.clear();
        }
        self.session.selected_keys = keys;
        Ok(None)
    }

    /// Removes keys from the selection that the scene no longer has.
    pub(super) fn fit_keys_to_scene(&mut self) {
        let scene = &self.document.scene;
        self.session.selected_keys.retain(|key| {
            let id = scene.find(&key.track.node);
            id.is_some_and(|id| has_key(scene, id, key))
        });
    }
}

fn has_key(scene: &SceneGraph, id: NodeId, key: &KeyAt) -> bool {
    let times = scene.key_seconds(id, key.track.channel);
    times.binary_search_by(|own| own.total_cmp(&key.seconds)).is_ok() || times.contains(&key.seconds)
}

fn no_channel(scene: &SceneGraph, id: NodeId, channel: Channel) -> SceneError {
    scene.without_keys(id, channel, &[]).err().unwrap_or(SceneError::NotControl { path: scene.node(id).path.clone() })
}

/// A channel's node, the channel, and the times of some of its keys.
type TrackTimes<'a> = (NodeId, &'a TrackPath, Vec<f64>);

/// The times of some keys, those of one channel together; all of them must be there.
fn by_track<'a>(scene: &SceneGraph, keys: &'a [KeyAt]) -> Result<Vec<TrackTimes<'a>>, CommandError> {
    let mut tracks: Vec<TrackTimes<'a>> = Vec::new();
    for key in keys {
        let path = &key.track.node;
        let id = scene.find(path).ok_or_else(|| CommandError::NoSuchNode { path: path.to_string() })?;
        if !has_key(scene, id, key) {
            let (channel, seconds) = (key.track.channel, key.seconds);
            return Err(CommandError::NoSuchKey { path: path.to_string(), channel, seconds });
        }
        match tracks.iter_mut().find(|(_, track, _)| **track == key.track) {
            Some((.., times)) => times.push(key.seconds),
            None => tracks.push((id, &key.track, vec![key.seconds])),
        }
    }
    Ok(tracks)
}
