//! Values that arguments of several commands take.

use clap::builder::{PossibleValuesParser, TypedValueParser};

use crate::export::Size;
use crate::film::{Format, films, format_of_ending, stills};
use crate::interpolation::Interpolation;
use crate::lighting::BuiltInLighting;
use crate::scene::LATEST_SECONDS;

/// A key time.
pub fn key_time(text: &str) -> Result<f64, String> {
    // Adding zero makes a zero of minus zero.
    text.trim().parse::<f64>().map(|key_time| key_time + 0.0).map_err(|_| format!("{text:?} is not a number"))
}

/// A time of timed keys, in seconds.
pub fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text.trim().parse().ok().filter(|seconds: &f64| seconds.abs() <= LATEST_SECONDS);
    seconds.ok_or_else(|| format!("{text:?} is not a number of seconds from -1e6 to 1e6"))
}

/// A number above 0, at most 1e6.
pub fn positive(text: &str) -> Result<f64, String> {
    let number = text.trim().parse().ok().filter(|number: &f64| *number > 0.0 && *number <= 1e6);
    number.ok_or_else(|| format!("{text:?} is not a number above 0, and at most 1e6"))
}

/// The longest side of a picture that can be asked for, in pixels. What the GPU adapter takes may be less.
const LONGEST_SIDE: u32 = 65_536;

/// Width and height in pixels.
pub fn size(text: &str) -> Result<Size, String> {
    let side = |text: &str| {
        let digits_only = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        text.parse().ok().filter(|side| digits_only && (1..=LONGEST_SIDE).contains(side))
    };
    text.split_once('x')
        .and_then(|(width, height)| Some(Size { width: side(width)?, height: side(height)? }))
        .ok_or_else(|| format!("expected WIDTHxHEIGHT in pixels, as in 640x480, each from 1 to {LONGEST_SIDE}"))
}

/// The name of an interpolation.
pub fn interpolation() -> impl TypedValueParser<Value = Interpolation> {
    PossibleValuesParser::new(Interpolation::ALL.map(Interpolation::name))
        .try_map(|name| Interpolation::from_name(&name).ok_or("unknown interpolation"))
}

/// The name of a lighting.
pub fn lighting() -> impl TypedValueParser<Value = BuiltInLighting> {
    PossibleValuesParser::new(BuiltInLighting::ALL.map(BuiltInLighting::name))
        .try_map(|name| BuiltInLighting::from_name(&name).ok_or("unknown lighting"))
}

/// The ending of a format of single pictures.
pub fn still_format() -> impl TypedValueParser<Value = &'static Format> {
    PossibleValuesParser::new(stills().map(|format| format.ending))
        .try_map(|ending| format_of_ending(&ending).ok_or("unknown format"))
}

/// The ending of a format of pictures or films.
pub fn format() -> impl TypedValueParser<Value = &'static Format> {
    // An ending that pictures and films share is named once.
    let films = films().map(|format| format.ending);
    let stills = stills().filter(|format| format.of_films().is_still()).map(|format| format.ending);
    PossibleValuesParser::new(films.chain(stills)).try_map(|ending| format_of_ending(&ending).ok_or("unknown format"))
}

/// The ending of a format of films.
pub fn film_format() -> impl TypedValueParser<Value = &'static Format> {
    PossibleValuesParser::new(films().map(|format| format.ending))
        .try_map(|ending| format_of_ending(&ending).map(Format::of_films).ok_or("unknown format"))
}

/// Samples a pixel.
pub fn samples() -> impl TypedValueParser<Value = u32> {
    PossibleValuesParser::new(["1", "4"]).try_map(|samples| samples.parse::<u32>())
}

/// A tolerance of scores, 0 to 1.
pub fn tolerance(text: &str) -> Result<f32, String> {
    text.trim()
        .parse()
        .ok()
        .filter(|tolerance| (0.0..=1.0).contains(tolerance))
        .ok_or_else(|| format!("{text:?} is not a number from 0 to 1"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes() {
        assert_eq!(size("640x480"), Ok(Size { width: 640, height: 480 }));
        for bad in ["", "640", "0x480", "640x0", "-1x5", "640x480x3", "+6x6", "640X480", "99999999999x1", "a x b"] {
            assert!(size(bad).is_err(), "{bad}");
        }
    }
}
