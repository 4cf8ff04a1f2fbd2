//! Words of a line as values.

use std::ops::RangeInclusive;
use std::time::Duration;

use glam::Vec3;

use super::LineProblem;
use crate::keyframe::KeyframeIndex;

type Value<T> = Result<T, LineProblem>;

/// An axis as a unit vector.
pub fn axis(word: &str) -> Value<Vec3> {
    match word {
        "x" => Ok(Vec3::X),
        "y" => Ok(Vec3::Y),
        "z" => Ok(Vec3::Z),
        _ => Err(LineProblem::Axis { word: word.to_owned() }),
    }
}

/// A finite number.
pub fn number(word: &str) -> Value<f32> {
    word.parse()
        .ok()
        .filter(|number: &f32| number.is_finite())
        .ok_or_else(|| LineProblem::Number { word: word.to_owned() })
}

/// As many finite numbers as there are words.
pub fn numbers<const N: usize>(words: &[&str; N]) -> Value<[f32; N]> {
    let mut numbers = [0.0; N];
    for (place, word) in numbers.iter_mut().zip(words) {
        *place = number(word)?;
    }
    Ok(numbers)
}

/// A finite number, kept as it is written.
pub fn double(word: &str) -> Value<f64> {
    word.parse()
        .ok()
        .filter(|number: &f64| number.is_finite())
        .ok_or_else(|| LineProblem::Number { word: word.to_owned() })
}

/// A number of a range.
pub fn number_in(word: &str, what: &'static str, range: &RangeInclusive<f64>) -> Value<f64> {
    let (low, high) = (*range.start(), *range.end());
    let wrong = || LineProblem::Range { word: word.to_owned(), what, kind: "number", low, high };
    word.parse().ok().filter(|number| range.contains(number)).ok_or_else(wrong)
}

/// A whole number of a range.
pub fn whole_in(word: &str, what: &'static str, range: &RangeInclusive<u32>) -> Value<u32> {
    let (low, high) = (f64::from(*range.start()), f64::from(*range.end()));
    let wrong = || LineProblem::Range { word: word.to_owned(), what, kind: "whole number", low, high };
    word.parse().ok().filter(|number| range.contains(number)).ok_or_else(wrong)
}

/// A word that means something by itself, such as `loop`.
pub fn one_of<T>(word: &str, what: &'static str, all: impl Iterator<Item = (T, &'static str)>) -> Value<T> {
    let mut names = Vec::new();
    for (value, name) in all {
        if name == word {
            return Ok(value);
        }
        names.push(name);
    }
    Err(LineProblem::Choice { word: word.to_owned(), what, expected: listed(&names) })
}

/// Words in a sentence: `a, b or c`.
pub fn listed(words: &[&str]) -> String {
    match words {
        [] => String::new(),
        [only] => (*only).to_owned(),
        [all @ .., last] => format!("{} or {last}", all.join(", ")),
    }
}

/// A place in the list, from 0. Whether it is in the list is seen when the line runs.
pub fn place(word: &str) -> Value<usize> {
    let expected = || "a whole number from 0".to_owned();
    word.parse().map_err(|_| LineProblem::Choice { word: word.to_owned(), what: "a keyframe", expected: expected() })
}

/// A keyframe's place.
pub fn keyframe(word: &str) -> Value<KeyframeIndex> {
    place(word).map(KeyframeIndex::new)
}

/// The most keyframes that a range of places may stand for.
const MOST_PLACES: usize = 1 << 20;

/// Keyframes' places: `3`, or `3-6`, which is 3, 4, 5 and 6.
pub fn keyframes(words: &[&str]) -> Value<Vec<KeyframeIndex>> {
    let mut all = Vec::new();
    for word in words {
        let wrong = || LineProblem::Choice {
            word: (*word).to_owned(),
            what: "a range of keyframes",
            expected: "as in 3-6".to_owned(),
        };
        match word.split_once('-') {
            None => all.push(keyframe(word)?),
            Some((first, last)) => {
                let (Ok(first), Ok(last)) = (place(first), place(last)) else { return Err(wrong()) };
                if first > last || last - first >= MOST_PLACES {
                    return Err(wrong());
                }
                all.extend((first..=last).map(KeyframeIndex::new));
            }
        }
    }
    Ok(all)
}

/// An angle in degrees as radians; whole turns are left out before anything is rounded.
pub fn radians(word: &str) -> Value<f32> {
    #[expect(clippy::cast_possible_truncation, reason = "rotations are held in f32")]
    let radians = (double(word)? % 360.0).to_radians() as f32;
    Ok(radians)
}

/// A time in milliseconds or seconds, to the nanosecond.
pub fn duration(word: &str) -> Value<Duration> {
    let (digits, per_second) = match word.strip_suffix("ms") {
        Some(digits) => (digits, 1000.0),
        None => (word.strip_suffix('s').unwrap_or_default(), 1.0),
    };
    digits
        .parse::<f64>()
        .ok()
        .and_then(|count| Duration::try_from_secs_f64(count / per_second).ok())
        .ok_or_else(|| LineProblem::Time { word: word.to_owned() })
}
