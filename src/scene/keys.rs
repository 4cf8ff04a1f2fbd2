//! Keys at their own times, by node and channel: which there are, and scenes with others.

use std::fmt;

use glam::{Quat, Vec3};

use super::file::SceneError;
use super::graph::{NodeId, NodeKind, SceneGraph};
use super::place::Place;
use super::shape::Colour;
use crate::timed::{Interpolate, KeyError, Keyframes, TransformKeyframes};
use crate::words::{Phrase, texts};

/// The latest time of a key that is made here, and the earliest below zero, in seconds: about eleven days.
const LATEST: f64 = 1e6;

/// What of a node has keys at their own times.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Channel {
    /// A control node's translation.
    Translation,
    /// A control node's rotation.
    Rotation,
    /// A control node's scale.
    Scale,
    /// A shape's colour.
    Colour,
}

impl Channel {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Translation, Self::Rotation, Self::Scale, Self::Colour];

    /// What files and scripts call it: `translation`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Translation => "translation",
            Self::Rotation => "rotation",
            Self::Scale => "scale",
            Self::Colour => "colour",
        }
    }

    /// Its name within a sentence.
    #[must_use]
    pub const fn title(self) -> Phrase {
        match self {
            Self::Translation => texts::CHANNEL_TRANSLATION,
            Self::Rotation => texts::CHANNEL_ROTATION,
            Self::Scale => texts::CHANNEL_SCALE,
            Self::Colour => texts::CHANNEL_COLOUR,
        }
    }

    /// The channel of that name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|channel| channel.name() == name)
    }

    /// Its field in a scene file.
    const fn field(self) -> &'static str {
        match self {
            Self::Translation => "control.translation",
            Self::Rotation => "control.rotation",
            Self::Scale => "control.scale",
            Self::Colour => "colour_keys",
        }
    }
}

impl fmt::Display for Channel {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.name())
    }
}

/// What a key holds, for the channel that it says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum KeyValue {
    /// In the parent's space, in scene units.
    Translation(Vec3),
    /// A unit quaternion.
    Rotation(Quat),
    /// Along each axis, above 0.
    Scale(Vec3),
    /// One that `#rrggbb` can say.
    Colour(Colour),
}

impl KeyValue {
    /// The channel that it is for.
    #[must_use]
    pub const fn channel(self) -> Channel {
        match self {
            Self::Translation(_) => Channel::Translation,
            Self::Rotation(_) => Channel::Rotation,
            Self::Scale(_) => Channel::Scale,
            Self::Colour(_) => Channel::Colour,
        }
    }
}

/// What becomes of the keys of a channel.
enum Change<'a> {
    Without(&'a [f64]),
    Moved(&'a [f64], f64),
}

impl Change<'_> {
    fn of<V: Interpolate>(&self, keys: Option<&Keyframes<V>>) -> Result<Option<Keyframes<V>>, KeyError> {
        let Some(keys) = keys else { return Ok(None) };
        match *self {
            Self::Without(times) => Ok(keys.without(times)),
            Self::Moved(times, by) => keys.moved(times, |seconds| moved_seconds(seconds, by)).map(Some),
        }
    }
}

impl SceneGraph {
    /// The channels that a node can have keys of: three of a control node, one of a shape, none of an RBT node.
    #[must_use]
    pub fn channels(&self, id: NodeId) -> &'static [Channel] {
        match self.node(id).kind {
            NodeKind::Rbt(_) => &[],
            NodeKind::Shape(_) => &[Channel::Colour],
            NodeKind::Control(_) => &[Channel::Translation, Channel::Rotation, Channel::Scale],
        }
    }

    /// The times of the keys of a channel in seconds, ascending; empty where it has none.
    #[must_use]
    pub fn key_seconds(&self, id: NodeId, channel: Channel) -> &[f64] {
        let times = match (&self.node(id).kind, channel) {
            (NodeKind::Control(keys), Channel::Translation) => keys.translation.as_ref().map(Keyframes::seconds),
            (NodeKind::Control(keys), Channel::Rotation) => keys.rotation.as_ref().map(Keyframes::seconds),
            (NodeKind::Control(keys), Channel::Scale) => keys.scale.as_ref().map(Keyframes::seconds),
            (NodeKind::Shape(placed), Channel::Colour) => placed.colour_keys.as_ref().map(Keyframes::seconds),
            _ => None,
        };
        times.unwrap_or_default()
    }

    /// The value of a channel at a time, between keys too; `None` where the node has no such channel.
    #[must_use]
    pub fn key_value_at(&self, id: NodeId, channel: Channel, seconds: f64) -> Option<KeyValue> {
        Some(match (&self.node(id).kind, channel) {
            (NodeKind::Control(keys), Channel::Translation) => KeyValue::Translation(keys.translation_at(seconds)),
            (NodeKind::Control(keys), Channel::Rotation) => KeyValue::Rotation(keys.rotation_at(seconds)),
            (NodeKind::Control(keys), Channel::Scale) => KeyValue::Scale(keys.scale_at(seconds)),
            (NodeKind::Shape(placed), Channel::Colour) => {
                KeyValue::Colour(Colour::nearest_to_linear(placed.colour_at(seconds)))
            }
            _ => return None,
        })
    }

    /// The scene with a key at a time; one of the same channel at that time gives way to it.
    ///
    /// # Errors
    /// [`SceneError`] where the node has no such channel, or the time or the value is out of range: as in a scene file.
    pub fn with_key(&self, id: NodeId, seconds: f64, value: KeyValue) -> Result<Self, SceneError> {
        let place = Place { path: &self.node(id).path };
        let failed = |error| keys_error(place, value.channel(), error);
        check_seconds(place, value.channel(), seconds)?;
        // No zero has a sign: what is the same is so to the byte.
        let seconds = seconds + 0.0;
        let kind = match (&self.node(id).kind, value) {
            (NodeKind::Control(keys), KeyValue::Translation(value)) => {
                let value = place.coordinates("translation", value)? + Vec3::ZERO;
                let translation = Some(with(keys.translation.as_ref(), seconds, value).map_err(failed)?);
                NodeKind::Control(TransformKeyframes { translation, ..keys.clone() })
            }
            (NodeKind::Control(keys), KeyValue::Rotation(value)) => {
                let value = Quat::from_array(place.rotation(value)?.to_array().map(|component| component + 0.0));
                let rotation = with(keys.rotation.as_ref(), seconds, value).map_err(failed)?;
                NodeKind::Control(TransformKeyframes { rotation: Some(rotation), ..keys.clone() })
            }
            (NodeKind::Control(keys), KeyValue::Scale(value)) => {
                let scale = with(keys.scale.as_ref(), seconds, place.scale(value)?).map_err(failed)?;
                NodeKind::Control(TransformKeyframes { scale: Some(scale), ..keys.clone() })
            }
            (NodeKind::Shape(placed), KeyValue::Colour(value)) => {
                let value = Colour::nearest(value.0).to_linear();
                let keys = with(placed.colour_keys.as_ref(), seconds, value).map_err(failed)?;
                NodeKind::Shape(placed.with_colour_keys(Some(keys)))
            }
            _ => return Err(self.no_channel(id, value.channel())),
        };
        Ok(self.with_kind(id, kind))
    }

    /// The scene without the keys of a channel at these times.
    ///
    /// # Errors
    /// [`SceneError`] where the node has no such channel.
    pub fn without_keys(&self, id: NodeId, channel: Channel, times: &[f64]) -> Result<Self, SceneError> {
        self.with_change(id, channel, &Change::Without(times))
    }

    /// The scene with the keys of a channel at these times moved by so many seconds; keys that they come to stand on give way.
    ///
    /// # Errors
    /// [`SceneError`] where the node has no such channel, or a key would leave the times that there can be.
    pub fn with_keys_moved(&self, id: NodeId, channel: Channel, times: &[f64], by: f64) -> Result<Self, SceneError> {
        let place = Place { path: &self.node(id).path };
        for &seconds in times {
            check_seconds(place, channel, seconds + by)?;
        }
        self.with_change(id, channel, &Change::Moved(times, by))
    }

    fn with_change(&self, id: NodeId, channel: Channel, change: &Change<'_>) -> Result<Self, SceneError> {
        let node = self.node(id);
        let failed = |error| keys_error(Place { path: &node.path }, channel, error);
        let kind = match (&node.kind, channel) {
            (NodeKind::Control(keys), Channel::Translation) => {
                let translation = change.of(keys.translation.as_ref()).map_err(failed)?;
                NodeKind::Control(TransformKeyframes { translation, ..keys.clone() })
            }
            (NodeKind::Control(keys), Channel::Rotation) => {
                let rotation = change.of(keys.rotation.as_ref()).map_err(failed)?;
                NodeKind::Control(TransformKeyframes { rotation, ..keys.clone() })
            }
            (NodeKind::Control(keys), Channel::Scale) => {
                let scale = change.of(keys.scale.as_ref()).map_err(failed)?;
                NodeKind::Control(TransformKeyframes { scale, ..keys.clone() })
            }
            (NodeKind::Shape(placed), Channel::Colour) => {
                NodeKind::Shape(placed.with_colour_keys(change.of(placed.colour_keys.as_ref()).map_err(failed)?))
            }
            _ => return Err(self.no_channel(id, channel)),
        };
        Ok(self.with_kind(id, kind))
    }

    fn no_channel(&self, id: NodeId, channel: Channel) -> SceneError {
        let path = self.node(id).path.clone();
        let reason = match channel {
            Channel::Colour => texts::SCENE_KEYS_OF_SHAPES,
            _ => texts::SCENE_KEYS_OF_CONTROLS,
        };
        SceneError::Misplaced { path, field: channel.field(), reason }
    }
}

/// Where a key comes to stand that is moved by so many seconds: at a whole microsecond, unless it stays where it is.
#[must_use]
pub fn moved_seconds(seconds: f64, by: f64) -> f64 {
    // No zero has a sign.
    if by == 0.0 { seconds } else { ((seconds + by) * 1e6).round() / 1e6 + 0.0 }
}

fn with<V: Interpolate>(keys: Option<&Keyframes<V>>, seconds: f64, value: V) -> Result<Keyframes<V>, KeyError> {
    keys.map_or_else(|| Keyframes::new([(seconds, value)]), |keys| keys.with_key(seconds, value))
}

fn keys_error(place: Place<'_>, channel: Channel, error: KeyError) -> SceneError {
    SceneError::Keys { path: place.path.to_owned(), field: channel.field(), error }
}

fn check_seconds(place: Place<'_>, channel: Channel, seconds: f64) -> Result<(), SceneError> {
    if seconds.abs() <= LATEST {
        Ok(())
    } else {
        Err(place.error(channel.field(), texts::scene_found_time(seconds), texts::SCENE_EXPECTED_TIME))
    }
}
