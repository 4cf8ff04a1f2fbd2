//! The channels of timed keys: one table of everything that differs between translation, rotation, scale and colour.
//!
//! A track holds four numbers at each key, whatever its channel. A row of the table gives their meaning: the value they encode, the
//! interpolation, the allowed values, and the text in files and scripts.

use std::fmt;

use glam::{Quat, Vec3, Vec4};

use super::checks::NodeChecks;
use super::file::SceneError;
use super::graph::NodeKind;
use super::write::{number, numbers};
use crate::colour::Colour;
use crate::rotation_rules::rotation_from_euler_degrees;
use crate::timed::Interpolate;
use crate::words::{Phrase, texts};

/// A value of a node that timed keys can drive.
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

/// The value of a key, for the channel of the same name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum KeyValue {
    /// In the parent's space, in scene units.
    Translation(Vec3),
    /// A unit quaternion, once `checked` has accepted it.
    Rotation(Quat),
    /// Along each axis; above 0, once `checked` has accepted it.
    Scale(Vec3),
    /// Any colour; `checked` rounds it to one that `#rrggbb` can express.
    Colour(Colour),
}

/// Which nodes have a channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Holder {
    /// Control nodes.
    Control,
    /// Shapes.
    Shape,
}

/// A row of the table of channels.
struct Row {
    channel: Channel,
    name: &'static str,
    /// Its name within a sentence.
    title: Phrase,
    /// The field of a scene file that holds its keys.
    field: &'static str,
    holder: Holder,
    /// How a script writes a value.
    expected: &'static str,
    /// Interpolates the four numbers of two keys at a fraction, 0 to 1.
    interpolate: fn(Vec4, Vec4, f64) -> Vec4,
    /// The default value, for a node without keys in this channel.
    default: fn(&NodeKind) -> Vec4,
    /// The value of four numbers of a track.
    value: fn(Vec4) -> KeyValue,
    /// The numbers of a track for an allowed value. Normalises -0.0 to 0.0 so that equal values give equal bytes.
    checked: fn(NodeChecks<'_>, KeyValue) -> Result<Option<Vec4>, SceneError>,
    /// Parses a script word. Gets the word, and its comma-separated numbers (empty if they do not parse).
    parse: fn(&str, &[f32]) -> Option<KeyValue>,
    /// The numbers as a scene file writes them.
    json: fn(Vec4) -> String,
}

static ROWS: [Row; Channel::ALL.len()] = [
    Row {
        channel: Channel::Translation,
        name: "translation",
        title: texts::CHANNEL_TRANSLATION,
        field: "control.translation",
        holder: Holder::Control,
        expected: "x,y,z",
        interpolate: linear,
        default: |_| Vec4::ZERO,
        value: |numbers| KeyValue::Translation(numbers.truncate()),
        checked: |checks, value| {
            let KeyValue::Translation(value) = value else { return Ok(None) };
            Ok(Some((checks.coordinates("translation", value)? + Vec3::ZERO).extend(0.0)))
        },
        parse: |_, numbers| match *numbers {
            [x, y, z] => Some(KeyValue::Translation(Vec3::new(x, y, z))),
            _ => None,
        },
        json: |value| numbers(&value.truncate().to_array()),
    },
    Row {
        channel: Channel::Rotation,
        name: "rotation",
        title: texts::CHANNEL_ROTATION,
        field: "control.rotation",
        holder: Holder::Control,
        expected: "yaw,pitch,roll in degrees, or a unit quaternion x,y,z,w",
        interpolate: |from, to, alpha| Quat::interpolate(Quat::from_vec4(from), Quat::from_vec4(to), alpha).into(),
        default: |_| Quat::IDENTITY.into(),
        value: |numbers| KeyValue::Rotation(Quat::from_vec4(numbers)),
        checked: |checks, value| {
            let KeyValue::Rotation(value) = value else { return Ok(None) };
            Ok(Some(Vec4::from(checks.rotation(value)?.to_array().map(|component| component + 0.0))))
        },
        parse: |_, numbers| match *numbers {
            [yaw, pitch, roll] => Some(KeyValue::Rotation(rotation_from_euler_degrees([yaw, pitch, roll]).normalize())),
            [x, y, z, w] => Some(KeyValue::Rotation(Quat::from_xyzw(x, y, z, w))),
            _ => None,
        },
        json: |value| numbers(&value.to_array()),
    },
    Row {
        channel: Channel::Scale,
        name: "scale",
        title: texts::CHANNEL_SCALE,
        field: "control.scale",
        holder: Holder::Control,
        expected: "one number, or x,y,z",
        interpolate: linear,
        default: |_| Vec3::ONE.extend(0.0),
        value: |numbers| KeyValue::Scale(numbers.truncate()),
        checked: |checks, value| {
            let KeyValue::Scale(value) = value else { return Ok(None) };
            Ok(Some(checks.scale(value)?.extend(0.0)))
        },
        parse: |_, numbers| match *numbers {
            [scale] => Some(KeyValue::Scale(Vec3::splat(scale))),
            [x, y, z] => Some(KeyValue::Scale(Vec3::new(x, y, z))),
            _ => None,
        },
        json: |value| scale_json(value.truncate()),
    },
    Row {
        channel: Channel::Colour,
        name: "colour",
        title: texts::CHANNEL_COLOUR,
        field: "colour_keys",
        holder: Holder::Shape,
        expected: "rrggbb",
        // In linear light.
        interpolate: linear,
        default: |kind| match kind {
            NodeKind::Shape(placed) => placed.colour.to_linear().extend(0.0),
            NodeKind::Rbt(_) | NodeKind::Control(_) => Colour::DEFAULT.to_linear().extend(0.0),
        },
        value: |numbers| KeyValue::Colour(Colour::nearest_to_linear(numbers.truncate())),
        checked: |_, value| {
            let KeyValue::Colour(value) = value else { return Ok(None) };
            Ok(Some(Colour::nearest(value.0).to_linear().extend(0.0)))
        },
        parse: |word, _| Colour::from_hex(&format!("#{word}")).map(KeyValue::Colour),
        json: |value| format!("\"{}\"", Colour::nearest_to_linear(value.truncate()).to_hex()),
    },
];

fn linear(from: Vec4, to: Vec4, alpha: f64) -> Vec4 {
    Vec3::interpolate(from.truncate(), to.truncate(), alpha).extend(0.0)
}

/// A scale as a scene file writes it: one number if all axes are equal.
pub(super) fn scale_json(scale: Vec3) -> String {
    if scale == Vec3::splat(scale.x) { number(scale.x) } else { numbers(&scale.to_array()) }
}

impl Channel {
    /// All channels, in the order of files and of the timeline.
    pub const ALL: [Self; 4] = [Self::Translation, Self::Rotation, Self::Scale, Self::Colour];

    fn row(self) -> &'static Row {
        ROWS.iter().find(|row| row.channel == self).expect("each channel has a row")
    }

    /// Its name in files and scripts: `translation`.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// Its name within a sentence.
    #[must_use]
    pub fn title(self) -> Phrase {
        self.row().title
    }

    /// The channel of that name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|channel| channel.name() == name)
    }

    /// How a script writes its values, for a sentence: `x,y,z`.
    #[must_use]
    pub fn expected(self) -> &'static str {
        self.row().expected
    }

    /// Parses the value of a script's word: numbers with commas between them, or six hexadecimal digits. Its range is not checked.
    #[must_use]
    pub fn parse(self, word: &str) -> Option<KeyValue> {
        let numbers: Option<Vec<f32>> = word.split(',').map(|number| number.parse().ok()).collect();
        (self.row().parse)(word, &numbers.unwrap_or_default())
    }

    /// Its field in a scene file.
    pub(super) fn field(self) -> &'static str {
        self.row().field
    }

    /// The channels of a kind of nodes. They are adjacent in [`Self::ALL`].
    pub(super) fn of(holder: Holder) -> &'static [Self] {
        static ALL: [Channel; Channel::ALL.len()] = Channel::ALL;
        let is_of = |channel: &Self| channel.holder() == holder;
        let before = ALL.iter().take_while(|channel| !is_of(channel)).count();
        let count = ALL.iter().filter(|channel| is_of(channel)).count();
        &ALL[before..before + count]
    }

    /// Which nodes have it.
    pub(super) fn holder(self) -> Holder {
        self.row().holder
    }

    /// The function that interpolates its tracks.
    pub(super) fn interpolate(self) -> fn(Vec4, Vec4, f64) -> Vec4 {
        self.row().interpolate
    }

    /// The default value, for a node without keys in this channel.
    pub(super) fn default_numbers(self, kind: &NodeKind) -> Vec4 {
        (self.row().default)(kind)
    }

    /// The value that four numbers of a track encode.
    pub(super) fn value(self, numbers: Vec4) -> KeyValue {
        (self.row().value)(numbers)
    }

    /// Four numbers of a track as a scene file writes them.
    pub(super) fn json(self, numbers: Vec4) -> String {
        (self.row().json)(numbers)
    }
}

impl fmt::Display for Channel {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.name())
    }
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

    /// The four numbers of a track that encode it.
    ///
    /// # Errors
    /// [`SceneError::Value`]: the value is out of its range.
    pub(super) fn checked(self, checks: NodeChecks<'_>) -> Result<Vec4, SceneError> {
        let numbers = (self.channel().row().checked)(checks, self)?;
        Ok(numbers.expect("a row checks the values of its channel"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn channels_of_one_holder_are_adjacent() {
        for channel in Channel::ALL {
            assert_eq!(Channel::from_name(channel.name()), Some(channel));
            assert!(
                Channel::of(channel.holder()).contains(&channel),
                "{channel} stands apart from those of its holder"
            );
        }
    }

    #[test]
    fn a_value_survives_a_track_and_has_the_channel_of_its_row() {
        for (channel, word) in Channel::ALL.into_iter().zip(["1,-2,3", "0,0,0.6,0.8", "1,2,0.5", "f39a3a"]) {
            let value = channel.parse(word).unwrap();
            assert_eq!(value.channel(), channel);
            assert_eq!(channel.value(value.checked(NodeChecks { path: "a" }).unwrap()), value);
        }
    }
}
