//! The light of a picture: the sun, the sky, and what the ground gives back.

use glam::Vec3;

use crate::colour::Colour;
use crate::words::{Phrase, texts};

/// A lighting that is part of the program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BuiltInLighting {
    /// A warm sun from the upper left and a blue sky.
    #[default]
    Day,
    /// A low sun with long shadows, and a sky from orange to deep blue.
    Evening,
    /// A large neutral lamp before a light backdrop.
    Studio,
}

impl BuiltInLighting {
    /// All of them; the first is the default.
    pub const ALL: [Self; 3] = [Self::Day, Self::Evening, Self::Studio];

    /// Its name in files and options: `evening`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Day => "day",
            Self::Evening => "evening",
            Self::Studio => "studio",
        }
    }

    /// Its name for people.
    #[must_use]
    pub const fn title(self) -> Phrase {
        match self {
            Self::Day => texts::LIGHTING_DAY,
            Self::Evening => texts::LIGHTING_EVENING,
            Self::Studio => texts::LIGHTING_STUDIO,
        }
    }

    /// The lighting of that name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|lighting| lighting.name() == name)
    }

    /// Its light.
    #[must_use]
    pub fn lighting(self) -> Lighting {
        match self {
            Self::Day => Lighting {
                towards_sun_in_world: Vec3::new(-0.5, 0.78, 0.5).normalize(),
                sun: Vec3::new(0.96, 0.84, 0.68),
                sun_degrees: Lighting::SUN_DEGREES,
                sky: Vec3::new(0.33, 0.39, 0.47),
                ground: Vec3::new(0.20, 0.185, 0.17),
                horizon: Colour::HORIZON.to_linear(),
                zenith: Colour::ZENITH.to_linear(),
            },
            Self::Evening => Lighting {
                towards_sun_in_world: Vec3::new(-0.86, 0.27, 0.36).normalize(),
                sun: Vec3::new(1.85, 1.16, 0.58),
                sun_degrees: Lighting::SUN_DEGREES,
                sky: Vec3::new(0.25, 0.27, 0.43),
                ground: Vec3::new(0.26, 0.17, 0.14),
                horizon: Colour::from_rgb(0xf6, 0xb1, 0x84).to_linear(),
                zenith: Colour::from_rgb(0x23, 0x48, 0x96).to_linear(),
            },
            Self::Studio => Lighting {
                towards_sun_in_world: Vec3::new(-0.45, 0.95, 0.55).normalize(),
                sun: Vec3::new(0.80, 0.79, 0.77),
                sun_degrees: 8.0,
                sky: Vec3::new(0.47, 0.475, 0.48),
                ground: Vec3::new(0.27, 0.267, 0.262),
                horizon: Colour::from_rgb(0xe4, 0xe4, 0xe3).to_linear(),
                zenith: Colour::from_rgb(0xb4, 0xb6, 0xb9).to_linear(),
            },
        }
    }
}

/// The light of a picture. Colours are linear light and at least 0; white surfaces that face the light reflect as much.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lighting {
    /// Unit direction from any point towards the middle of the sun, in world space; above the horizon.
    pub towards_sun_in_world: Vec3,
    /// The light of the sun.
    pub sun: Vec3,
    /// The diameter of the sun as one sees it, in degrees, 0 to 90. 0 is a point, whose shadows are sharp.
    pub sun_degrees: f32,
    /// The light of the whole sky.
    pub sky: Vec3,
    /// The light that comes from below.
    pub ground: Vec3,
    /// The colour of the sky where it meets the ground, as pictures show it: each part at most 1.
    pub horizon: Vec3,
    /// The colour of the sky overhead, as pictures show it: each part at most 1.
    pub zenith: Vec3,
}

impl Default for Lighting {
    fn default() -> Self {
        BuiltInLighting::default().lighting()
    }
}

impl Lighting {
    /// The sun's diameter seen from the earth, in degrees.
    pub const SUN_DEGREES: f32 = 0.53;

    /// The same with a sky of other colours, which gives more or less light as these do.
    #[must_use]
    pub fn with_sky(self, horizon: Vec3, zenith: Vec3) -> Self {
        // What a level surface gets of the gradient: its upper parts count most.
        let mean = |horizon: Vec3, zenith: Vec3| horizon * 0.18 + zenith * 0.82;
        let before = mean(self.horizon, self.zenith).max(Vec3::splat(1e-3));
        Self { sky: self.sky * (mean(horizon, zenith) / before), horizon, zenith, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_lights() {
        for built_in in BuiltInLighting::ALL {
            assert_eq!(BuiltInLighting::from_name(built_in.name()), Some(built_in));
            let lighting = built_in.lighting();
            assert!(lighting.towards_sun_in_world.is_normalized() && lighting.towards_sun_in_world.y > 0.0);
            assert_eq!(lighting.with_sky(lighting.horizon, lighting.zenith), lighting, "the same sky gives the same");
        }
        assert_eq!(BuiltInLighting::from_name("noon"), None);
        assert_eq!(Lighting::default(), BuiltInLighting::Day.lighting());
    }

    #[test]
    fn a_darker_sky_gives_less_light() {
        let day = Lighting::default();
        let darker = day.with_sky(day.horizon * 0.5, day.zenith * 0.5);
        assert!((darker.sky - day.sky * 0.5).abs().max_element() < 1e-6);
    }
}
