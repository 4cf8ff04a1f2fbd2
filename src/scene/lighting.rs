//! The lighting of a scene: a built-in one, and what the scene changes of it.

use std::fmt;

use glam::Vec3;
use serde::de::value::MapAccessDeserializer;
use serde::de::{self, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::file::{ColourText, SceneError};
use super::write::{number, numbers};
use crate::colour::Colour;
use crate::json::quoted as json_text;
use crate::lighting::{BuiltInLighting, Lighting};
use crate::rbt::are_coordinates;
use crate::words::{Argument, Phrase, quoted, texts};

/// The first version of scene files with a lighting.
pub(super) const VERSION_OF_LIGHTING: u32 = 3;
/// The largest factor of the sun's light.
const MOST_BRIGHTNESS: f32 = 10.0;
/// The largest sun, in degrees.
const MOST_DEGREES: f32 = 90.0;

/// The lighting of a scene. The default is the day.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SceneLighting {
    /// What holds where the scene says nothing else.
    pub of: BuiltInLighting,
    /// A direction towards the sun in world space, of any length but 0, with y above 0.
    pub direction: Option<Vec3>,
    /// The sun's colour.
    pub colour: Option<Colour>,
    /// The factor of the sun's light, 0 to 10.
    pub brightness: Option<f32>,
    /// The sun's diameter in degrees, 0 to 90.
    pub degrees: Option<f32>,
    /// The colour of the sky where it meets the ground.
    pub horizon: Option<Colour>,
    /// The colour of the sky overhead.
    pub zenith: Option<Colour>,
    /// The light that the ground gives back.
    pub ground: Option<Colour>,
}

impl From<BuiltInLighting> for SceneLighting {
    fn from(of: BuiltInLighting) -> Self {
        Self { of, ..Self::default() }
    }
}

impl SceneLighting {
    /// The light that it makes.
    #[must_use]
    pub fn lighting(&self) -> Lighting {
        let of = self.of.lighting();
        let [horizon, zenith, ground, sun] =
            [(self.horizon, of.horizon), (self.zenith, of.zenith), (self.ground, of.ground), (self.colour, of.sun)]
                .map(|(own, of)| own.map_or(of, Colour::to_linear));
        let towards_sun_in_world = self.direction.map_or(of.towards_sun_in_world, |direction| {
            // In double precision no direction is too short or too long.
            direction.as_dvec3().normalize().as_vec3()
        });
        Lighting {
            towards_sun_in_world,
            sun: sun * self.brightness.unwrap_or(1.0),
            sun_degrees: self.degrees.unwrap_or(of.sun_degrees),
            ground,
            ..of.with_sky(horizon, zenith)
        }
    }

    /// As a scene file has it: a name, or an object.
    pub(super) fn json(&self) -> String {
        let colour = |colour: Option<Colour>| colour.map(|colour| json_text(&colour.to_hex()));
        let sun = object(&[
            ("direction", self.direction.map(|direction| numbers(&direction.to_array()))),
            ("colour", colour(self.colour)),
            ("brightness", self.brightness.map(number)),
            ("degrees", self.degrees.map(number)),
        ]);
        let sky = object(&[
            ("horizon", colour(self.horizon)),
            ("zenith", colour(self.zenith)),
            ("ground", colour(self.ground)),
        ]);
        let of = json_text(self.of.name());
        if *self == Self::from(self.of) {
            return of;
        }
        let is_of_default = self.of == BuiltInLighting::default();
        object(&[("of", (!is_of_default).then_some(of)), ("sun", sun), ("sky", sky)]).unwrap_or_default()
    }
}

/// An object of the fields that have a value; `None` if none has.
fn object(fields: &[(&str, Option<String>)]) -> Option<String> {
    let fields: Vec<String> =
        fields.iter().filter_map(|(name, value)| Some(format!("\"{name}\": {}", value.as_ref()?))).collect();
    (!fields.is_empty()).then(|| format!("{{ {} }}", fields.join(", ")))
}

/// `lighting` as a scene file has it.
pub(super) enum LightingText {
    Name(String),
    Own(OwnText),
}

impl<'de> Deserialize<'de> for LightingText {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct LightingVisitor;

        impl<'de> Visitor<'de> for LightingVisitor {
            type Value = LightingText;

            fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
                formatter.write_str("decode.kind.lighting")
            }

            fn visit_str<E: de::Error>(self, name: &str) -> Result<LightingText, E> {
                Ok(LightingText::Name(name.to_owned()))
            }

            fn visit_map<A: MapAccess<'de>>(self, fields: A) -> Result<LightingText, A::Error> {
                OwnText::deserialize(MapAccessDeserializer::new(fields)).map(LightingText::Own)
            }
        }

        deserializer.deserialize_any(LightingVisitor)
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct OwnText {
    of: Option<String>,
    #[serde(default)]
    sun: SunText,
    #[serde(default)]
    sky: SkyText,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct SunText {
    direction: Option<[f32; 3]>,
    colour: Option<ColourText>,
    brightness: Option<f32>,
    degrees: Option<f32>,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct SkyText {
    horizon: Option<ColourText>,
    zenith: Option<ColourText>,
    ground: Option<ColourText>,
}

impl LightingText {
    /// The lighting, checked.
    ///
    /// # Errors
    /// [`SceneError::LightingVersion`] or [`SceneError::Lighting`]
    pub fn lighting(&self, version: u32) -> Result<SceneLighting, SceneError> {
        if version < VERSION_OF_LIGHTING {
            return Err(SceneError::LightingVersion);
        }
        match self {
            Self::Name(name) => Ok(built_in("lighting", name)?.into()),
            Self::Own(OwnText { of, sun, sky }) => Ok(SceneLighting {
                of: of.as_deref().map(|name| built_in("lighting.of", name)).transpose()?.unwrap_or_default(),
                direction: sun.direction.map(direction).transpose()?,
                colour: sun.colour.map(|colour| colour.0),
                brightness: within("lighting.sun.brightness", sun.brightness, MOST_BRIGHTNESS)?,
                degrees: within("lighting.sun.degrees", sun.degrees, MOST_DEGREES)?,
                horizon: sky.horizon.map(|colour| colour.0),
                zenith: sky.zenith.map(|colour| colour.0),
                ground: sky.ground.map(|colour| colour.0),
            }),
        }
    }
}

fn error(field: &'static str, found: impl Into<Argument>, expected: Phrase) -> SceneError {
    SceneError::Lighting { field, found: found.into(), expected }
}

fn built_in(field: &'static str, name: &str) -> Result<BuiltInLighting, SceneError> {
    BuiltInLighting::from_name(name).ok_or_else(|| error(field, quoted(name), texts::SCENE_EXPECTED_LIGHTING))
}

fn direction(direction: [f32; 3]) -> Result<Vec3, SceneError> {
    let direction = Vec3::from(direction);
    if are_coordinates(direction) && direction.y > 0.0 {
        Ok(direction)
    } else {
        Err(error("lighting.sun.direction", format!("{direction}"), texts::SCENE_EXPECTED_SUN))
    }
}

fn within(field: &'static str, value: Option<f32>, most: f32) -> Result<Option<f32>, SceneError> {
    match value {
        Some(found) if !(0.0..=most).contains(&found) => {
            let expected =
                if most == MOST_DEGREES { texts::SCENE_EXPECTED_DEGREES } else { texts::SCENE_EXPECTED_BRIGHTNESS };
            Err(error(field, found, expected))
        }
        value => Ok(value.map(|value| value + 0.0)),
    }
}
