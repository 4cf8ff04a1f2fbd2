//! Arguments of refined pictures.

use clap::Args;

use crate::export::{Exposure, Focus, Shutter};
use crate::film::Quality;
use crate::render::Refinement;

/// Arguments of refined pictures.
#[derive(Debug, Args)]
pub struct RefiningArguments {
    /// Sub-frames a picture: draft (1), good (16), film (64), poster (256), or a number. From 2 on edges are smooth, shadows soft, and what
    /// moves in a film is blurred.
    #[arg(long, value_name = "QUALITY", default_value_t, value_parser = quality, hide_default_value = true)]
    pub quality: Quality,
    /// How long the shutter is open, as an angle: 360 is the time between two frames, or 1/30 s of a single picture. With ,trailing it closes
    /// at the frame's time; otherwise that is its middle [default: 180 in films, 0 in single pictures].
    #[arg(long, value_name = "DEGREES[,trailing]", value_parser = shutter)]
    pub shutter: Option<Shutter>,
    /// What is sharp: a node's path. What is nearer or farther is blurred.
    #[arg(long, value_name = "NODE")]
    pub focus: Option<String>,
    /// The focal length over the diameter of the lens, 0.1 to 1000: the smaller, the more is blurred [default: 2.8].
    #[arg(long, value_name = "X", requires = "focus", value_parser = f_stop)]
    pub f_stop: Option<f32>,
    /// The diameter of the sun in degrees, 0 to 90: the wider, the softer shadows are [default: that of the
    /// lighting, 0.53 by day].
    #[arg(long, value_name = "DEGREES", value_parser = sun_size)]
    pub sun_size: Option<f32>,
    /// Whether shapes hide the sky from each other and from the ground [default: on].
    #[arg(long, value_name = "on|off", value_parser = on_or_off)]
    pub sky_light: Option<bool>,
}

/// The lens's usual stop.
const USUAL_F_STOP: f32 = 2.8;

impl RefiningArguments {
    /// How pictures are refined; `None`: they are plain.
    pub fn refinement(&self) -> Option<Refinement> {
        let usual = Refinement::of_quality(self.quality)?;
        Some(Refinement { sun_degrees: self.sun_size, sky_light: self.sky_light.unwrap_or(usual.sky_light), ..usual })
    }

    /// How pictures of a film, or single ones, are taken.
    pub fn exposure(&self, is_film: bool) -> Exposure<'_> {
        let usual = if is_film { Shutter::OF_FILMS } else { Shutter::default() };
        Exposure {
            shutter: self.shutter.unwrap_or(usual),
            focus: self.focus.as_deref().map(|node| Focus { node, f_stop: self.f_stop.unwrap_or(USUAL_F_STOP) }),
        }
    }

    /// The first option that only refined pictures have.
    pub fn of_refined(&self) -> Option<&'static str> {
        [
            ("--shutter", self.shutter.is_some()),
            ("--focus", self.focus.is_some()),
            ("--sun-size", self.sun_size.is_some()),
            ("--sky-light", self.sky_light.is_some()),
        ]
        .into_iter()
        .find_map(|(name, is_given)| is_given.then_some(name))
    }
}

fn quality(text: &str) -> Result<Quality, String> {
    Quality::parse(text).ok_or_else(|| {
        let names = Quality::NAMED.map(|(name, _)| name).join(", ");
        format!("expected {names}, or a number of sub-frames from 1 to {}", Quality::MOST)
    })
}

fn shutter(text: &str) -> Result<Shutter, String> {
    let (degrees, trails) = match text.split_once(',') {
        None => (text, false),
        Some((degrees, "trailing")) => (degrees, true),
        Some(_) => ("", false),
    };
    number(degrees, 0.0, 360.0)
        .map(|degrees| Shutter { degrees, trails })
        .ok_or_else(|| "expected degrees from 0 to 360, and perhaps ,trailing, as in 180 or 90,trailing".to_owned())
}

fn f_stop(text: &str) -> Result<f32, String> {
    number(text, 0.1, 1000.0).map(|stop| stop as f32).ok_or_else(|| "expected a number from 0.1 to 1000".to_owned())
}

fn sun_size(text: &str) -> Result<f32, String> {
    number(text, 0.0, 90.0).map(|degrees| degrees as f32).ok_or_else(|| "expected degrees from 0 to 90".to_owned())
}

fn on_or_off(text: &str) -> Result<bool, String> {
    match text {
        "on" => Ok(true),
        "off" => Ok(false),
        _ => Err("expected on or off".to_owned()),
    }
}

fn number(text: &str, least: f64, most: f64) -> Option<f64> {
    text.trim().parse().ok().filter(|number| (least..=most).contains(number))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shutters() {
        assert_eq!(shutter("180"), Ok(Shutter { degrees: 180.0, trails: false }));
        assert_eq!(shutter("90.5,trailing"), Ok(Shutter { degrees: 90.5, trails: true }));
        for wrong in ["", "-1", "361", "180,leading", "180,", "nan", ",trailing"] {
            assert!(shutter(wrong).is_err(), "{wrong}");
        }
    }
}
