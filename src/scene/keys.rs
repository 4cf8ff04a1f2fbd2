//! Timed keys by node and channel: queries, and scenes with changed keys.

use glam::Vec4;

use super::channel::{Channel, Holder, KeyValue};
use super::checks::NodeChecks;
use super::file::SceneError;
use super::graph::{NodeId, NodeKind, SceneGraph};
use super::tracks::Tracks;
use crate::timed::{KeyError, Track};
use crate::words::texts;

/// The largest absolute time of a key that is made here, and that can be shown, in seconds: about eleven days.
pub const LATEST_SECONDS: f64 = 1e6;

impl SceneGraph {
    /// The channels that a node can have keys of: three of a control node, one of a shape, none of an RBT node.
    #[must_use]
    pub fn channels(&self, id: NodeId) -> &'static [Channel] {
        match self.node(id).kind {
            NodeKind::Rbt(_) => &[],
            NodeKind::Shape(_) => Channel::of(Holder::Shape),
            NodeKind::Control(_) => Channel::of(Holder::Control),
        }
    }

    /// The times of the keys of a channel in seconds, ascending; empty without keys.
    #[must_use]
    pub fn key_seconds(&self, id: NodeId, channel: Channel) -> &[f64] {
        self.tracks(id, channel).and_then(|tracks| tracks.get(channel)).map(Track::seconds).unwrap_or_default()
    }

    /// The value of a channel at a time, between keys too; `None` if the node has no such channel.
    #[must_use]
    pub fn key_value_at(&self, id: NodeId, channel: Channel, seconds: f64) -> Option<KeyValue> {
        let numbers = self.tracks(id, channel)?.numbers_at(channel, seconds);
        Some(channel.value(numbers.unwrap_or_else(|| channel.default_numbers(&self.node(id).kind))))
    }

    /// The scene with a key at a time. It replaces a key of the same channel at that time.
    ///
    /// # Errors
    /// [`SceneError`] if the node has no such channel, or the time or the value is out of the range of scene files.
    pub fn with_key(&self, id: NodeId, seconds: f64, value: KeyValue) -> Result<Self, SceneError> {
        let (channel, checks) = (value.channel(), NodeChecks { path: &self.node(id).path });
        check_seconds(checks, channel, seconds)?;
        // Normalise -0.0 to 0.0, so that equal times give equal bytes.
        let seconds = seconds + 0.0;
        self.with_track(id, channel, |track| {
            let numbers = value.checked(checks)?;
            let added = match track {
                Some(track) => track.with_key(seconds, numbers),
                None => Track::with_interpolation([(seconds, numbers)], channel.interpolate()),
            };
            added.map(Some).map_err(|error| keys_error(checks, channel, error))
        })
    }

    /// The scene without the keys of a channel at these times.
    ///
    /// # Errors
    /// [`SceneError`] if the node has no such channel.
    pub fn without_keys(&self, id: NodeId, channel: Channel, times: &[f64]) -> Result<Self, SceneError> {
        self.with_track(id, channel, |track| Ok(track.and_then(|track| track.without(times))))
    }

    /// The scene with the keys of a channel at these times moved by some seconds. A moved key replaces a key that was there.
    ///
    /// # Errors
    /// [`SceneError`] if the node has no such channel, or a key would leave the allowed times.
    pub fn with_keys_moved(&self, id: NodeId, channel: Channel, times: &[f64], by: f64) -> Result<Self, SceneError> {
        let checks = NodeChecks { path: &self.node(id).path };
        for &seconds in times {
            check_seconds(checks, channel, seconds + by)?;
        }
        self.with_track(id, channel, |track| {
            let moved = track.map(|track| track.moved(times, |seconds| moved_seconds(seconds, by)));
            moved.transpose().map_err(|error| keys_error(checks, channel, error))
        })
    }

    /// The tracks of a node; an error if it has no such channel.
    fn tracks(&self, id: NodeId, channel: Channel) -> Option<&Tracks> {
        match (&self.node(id).kind, channel.holder()) {
            (NodeKind::Control(tracks), Holder::Control) => Some(tracks),
            (NodeKind::Shape(placed), Holder::Shape) => Some(placed.tracks()),
            (NodeKind::Rbt(_) | NodeKind::Control(_) | NodeKind::Shape(_), _) => None,
        }
    }

    /// The scene with another track for a channel of a node.
    fn with_track(
        &self,
        id: NodeId,
        channel: Channel,
        change: impl FnOnce(Option<&Track<Vec4>>) -> Result<Option<Track<Vec4>>, SceneError>,
    ) -> Result<Self, SceneError> {
        let tracks = self.tracks(id, channel).ok_or_else(|| self.no_channel(id, channel))?;
        let tracks = tracks.with(channel, change(tracks.get(channel))?);
        let kind = match &self.node(id).kind {
            NodeKind::Shape(placed) => NodeKind::Shape(placed.with_tracks(tracks)),
            NodeKind::Rbt(_) | NodeKind::Control(_) => NodeKind::Control(tracks),
        };
        let scene = self.with_kind(id, kind);
        if channel == Channel::Scale {
            scene.check_scales()?;
        }
        Ok(scene)
    }

    fn no_channel(&self, id: NodeId, channel: Channel) -> SceneError {
        let reason = match channel.holder() {
            Holder::Shape => texts::SCENE_KEYS_OF_SHAPES,
            Holder::Control => texts::SCENE_KEYS_OF_CONTROLS,
        };
        SceneError::Misplaced { path: self.node(id).path.clone(), field: channel.field(), reason }
    }
}

/// The time of a key at `seconds` after a move: at a whole microsecond, unless it stays where it is.
#[must_use]
pub fn moved_seconds(seconds: f64, by: f64) -> f64 {
    // Adding 0.0 normalises -0.0, so that equal times give equal bytes.
    if by == 0.0 { seconds } else { ((seconds + by) * 1e6).round() / 1e6 + 0.0 }
}

pub(super) fn keys_error(checks: NodeChecks<'_>, channel: Channel, error: KeyError) -> SceneError {
    SceneError::Keys { path: checks.path.to_owned(), field: channel.field(), error }
}

fn check_seconds(checks: NodeChecks<'_>, channel: Channel, seconds: f64) -> Result<(), SceneError> {
    if seconds.abs() <= LATEST_SECONDS {
        Ok(())
    } else {
        Err(checks.error(channel.field(), texts::scene_found_time(seconds), texts::SCENE_EXPECTED_TIME))
    }
}
