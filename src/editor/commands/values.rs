//! Parsing and printing of values in script lines. A printed value reads back to the same bits.

use std::fmt;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

use glam::{Quat, Vec3};

use super::line::{ArgumentError, Arguments};
use crate::keyframe::KeyframeIndex;
use crate::pose::RbtIndex;
use crate::rbt::Rbt;
use crate::scene::SceneGraph;
use crate::text::listed;

type Value<T> = Result<T, ArgumentError>;

/// An axis as a unit vector.
pub(super) fn axis(word: &str) -> Value<Vec3> {
    match word {
        "x" => Ok(Vec3::X),
        "y" => Ok(Vec3::Y),
        "z" => Ok(Vec3::Z),
        _ => Err(ArgumentError::Axis { word: word.to_owned() }),
    }
}

/// A finite number.
pub(super) fn number(word: &str) -> Value<f32> {
    word.parse()
        .ok()
        .filter(|number: &f32| number.is_finite())
        .ok_or_else(|| ArgumentError::Number { word: word.to_owned() })
}

/// As many finite numbers as there are words.
pub(super) fn numbers<const N: usize>(words: &[&str; N]) -> Value<[f32; N]> {
    let mut numbers = [0.0; N];
    for (value, word) in numbers.iter_mut().zip(words) {
        *value = number(word)?;
    }
    Ok(numbers)
}

/// A translation, then a rotation as a quaternion.
pub(super) fn rbt(words: &[&str; 7]) -> Value<Rbt> {
    let [x, y, z, a, b, c, d] = numbers(words)?;
    Ok(Rbt::new(Vec3::new(x, y, z), Quat::from_xyzw(a, b, c, d)))
}

/// A finite number in double precision.
pub(super) fn double(word: &str) -> Value<f64> {
    word.parse()
        .ok()
        .filter(|number: &f64| number.is_finite())
        .ok_or_else(|| ArgumentError::Number { word: word.to_owned() })
}

impl Arguments<'_> {
    /// A number of a range.
    pub(super) fn number_in(&self, word: &str, what: &'static str, range: &RangeInclusive<f64>) -> Value<f64> {
        let (low, high) = (*range.start(), *range.end());
        let wrong = || ArgumentError::Range { word: word.to_owned(), what, kind: "number", low, high };
        let is_taken = |number: &f64| range.contains(number) || self.allows_out_of_range && number.is_finite();
        word.parse().ok().filter(is_taken).ok_or_else(wrong)
    }

    /// A whole number of a range.
    pub(super) fn whole_in<T>(&self, word: &str, what: &'static str, range: &RangeInclusive<T>) -> Value<T>
    where
        T: Copy + PartialOrd + std::str::FromStr + Into<f64>,
    {
        let (low, high) = ((*range.start()).into(), (*range.end()).into());
        let wrong = || ArgumentError::Range { word: word.to_owned(), what, kind: "whole number", low, high };
        word.parse().ok().filter(|number| self.allows_out_of_range || range.contains(number)).ok_or_else(wrong)
    }
}

/// A keyword, such as `loop`.
pub(super) fn one_of<T>(word: &str, what: &'static str, all: impl Iterator<Item = (T, &'static str)>) -> Value<T> {
    let mut names = Vec::new();
    for (value, name) in all {
        if name == word {
            return Ok(value);
        }
        names.push(name);
    }
    Err(ArgumentError::Choice { word: word.to_owned(), what, expected: listed(&names, "or") })
}

/// An index of the list, from 0. Whether the list has it is seen when the line runs.
pub(super) fn index(word: &str) -> Value<usize> {
    let expected = || "a whole number from 0".to_owned();
    word.parse().map_err(|_| ArgumentError::Choice { word: word.to_owned(), what: "a keyframe", expected: expected() })
}

/// The index of a keyframe.
pub(super) fn keyframe(word: &str) -> Value<KeyframeIndex> {
    index(word).map(KeyframeIndex::new)
}

/// The most keyframes that a range of indices may stand for.
const LONGEST_RANGE: usize = 1 << 20;

/// Indices of keyframes: `3`, or `3-6`, which is 3, 4, 5 and 6.
pub(super) fn keyframes(words: &[&str]) -> Value<Vec<KeyframeIndex>> {
    let mut all = Vec::new();
    for word in words {
        let wrong = || ArgumentError::Choice {
            word: (*word).to_owned(),
            what: "a range of keyframes",
            expected: "as in 3-6".to_owned(),
        };
        match word.split_once('-') {
            None => all.push(keyframe(word)?),
            Some((first, last)) => {
                let (Ok(first), Ok(last)) = (index(first), index(last)) else { return Err(wrong()) };
                if first > last || last - first >= LONGEST_RANGE {
                    return Err(wrong());
                }
                all.extend((first..=last).map(KeyframeIndex::new));
            }
        }
    }
    Ok(all)
}

/// Indices of keyframes as [`keyframes`] reads them; `none` for an empty list.
pub(super) fn keyframes_text(indices: &[KeyframeIndex]) -> String {
    let mut runs: Vec<(usize, usize)> = Vec::new();
    for index in indices.iter().map(|index| index.get()) {
        match runs.last_mut() {
            Some((first, last)) if last.checked_add(1) == Some(index) && index - *first < LONGEST_RANGE => {
                *last = index;
            }
            _ => runs.push((index, index)),
        }
    }
    let run = |(first, last)| if first == last { format!("{first}") } else { format!("{first}-{last}") };
    if runs.is_empty() { "none".to_owned() } else { runs.into_iter().map(run).collect::<Vec<_>>().join(" ") }
}

/// An angle in degrees as radians; whole turns are left out before anything is rounded.
pub(crate) fn radians(word: &str) -> Value<f64> {
    Ok((double(word)? % 360.0).to_radians())
}

/// A number in the fewest digits that read back to the same bits.
pub(super) fn number_text(number: impl fmt::Debug) -> String {
    let mut text = format!("{number:?}");
    if text.ends_with(".0") {
        text.truncate(text.len() - 2);
    }
    text
}

/// Numbers with a separator between them.
pub(super) fn numbers_text(numbers: &[f32], separator: &str) -> String {
    numbers.iter().map(number_text).collect::<Vec<_>>().join(separator)
}

/// `X Y Z`.
pub(super) fn vector_text(vector: Vec3) -> String {
    numbers_text(&vector.to_array(), " ")
}

/// `X Y Z W`.
pub(super) fn rotation_text(rotation: Quat) -> String {
    numbers_text(&rotation.to_array(), " ")
}

/// A translation, then a rotation as a quaternion, as [`rbt`] reads it.
pub(super) fn rbt_text(rbt: Rbt) -> String {
    format!("{} {}", vector_text(rbt.translation), rotation_text(rbt.rotation))
}

/// Whether two lists of numbers are the same bits: -0.0 is not 0.0.
pub(super) fn same_bits(a: &[f32], b: &[f32]) -> bool {
    a.iter().map(|number| number.to_bits()).eq(b.iter().map(|number| number.to_bits()))
}

/// The text that a string in double quotes, as in JSON, stands for, if it is one as a whole.
pub(super) fn read_quoted(text: &str) -> Option<String> {
    text.starts_with('"').then(|| serde_json::from_str(text).ok())?
}

/// A string in double quotes, as in JSON.
pub(super) fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

/// The length in bytes of the string in double quotes that a text begins with, and what it stands for.
pub(crate) fn quoted_prefix(text: &str) -> Option<(usize, String)> {
    if !text.starts_with('"') {
        return None;
    }
    let mut texts = serde_json::Deserializer::from_str(text).into_iter::<String>();
    let first = texts.next()?.ok()?;
    Some((texts.byte_offset(), first))
}

/// The first word of a text, and the rest without blanks before it.
pub(super) fn word_and_rest(text: &str) -> Option<(&str, &str)> {
    let (word, rest) = text.split_once(char::is_whitespace)?;
    Some((word, rest.trim_start()))
}

/// The words of a text up to a comment, each of them bare or in double quotes, and where they end in bytes.
pub(crate) fn tokens(text: &str) -> (Vec<String>, usize) {
    let mut tokens = Vec::new();
    let mut end = 0;
    loop {
        let rest = text[end..].trim_start();
        let start = text.len() - rest.len();
        if rest.is_empty() || rest.starts_with('#') {
            return (tokens, end);
        }
        let (length, token) = quoted_prefix(rest).unwrap_or_else(|| {
            let length = rest.find(|c: char| c.is_whitespace() || c == '#').unwrap_or(rest.len());
            (length, rest[..length].to_owned())
        });
        tokens.push(token);
        end = start + length;
    }
}

/// Whether a text must stand in double quotes to be read back where it stands last.
fn needs_quotes(text: &str) -> bool {
    text.is_empty() || text.trim() != text || text.starts_with('"') || text.contains(char::is_control)
}

/// The path of a node, which stands last in a line.
pub(super) fn node_text(path: &str) -> String {
    if path == "none" || path == "work" || needs_quotes(path) { quoted(path) } else { path.to_owned() }
}

/// The path of an RBT node, which stands last in a line; `None` where the scene has no such node.
pub(super) fn rbt_path_text(rbt: RbtIndex, scene: &SceneGraph) -> Option<String> {
    (rbt.get() < scene.rbt_count()).then(|| node_text(scene.rbt_path(rbt)))
}

/// A name that stands last in a line.
pub(super) fn name_text(name: &str) -> String {
    if needs_quotes(name) || name.contains(['#', '"']) { quoted(name) } else { name.to_owned() }
}

/// A word in a line of many: in double quotes if it would not be one word otherwise.
pub(super) fn token_text(token: &str) -> String {
    let is_bare = !needs_quotes(token) && !token.contains(|c: char| c.is_whitespace() || c == '#');
    if is_bare { token.to_owned() } else { quoted(token) }
}

/// Whether a text begins with an option, and what stands after that.
pub(crate) fn split_option<'t>(text: &'t str, option: Option<&str>) -> (bool, &'t str) {
    let after = option.and_then(|option| text.strip_prefix(option));
    let after = after.filter(|after| after.is_empty() || after.starts_with(char::is_whitespace));
    after.map_or((false, text), |after| (true, after.trim_start()))
}

/// A file's path, which is the rest of a line, bare or in double quotes; `None` where there is none.
pub(super) fn file(text: &str) -> Option<PathBuf> {
    (!text.is_empty()).then(|| read_quoted(text).map_or_else(|| PathBuf::from(text), PathBuf::from))
}

/// A file's path as [`fn@file`] reads it; `None` where it is not Unicode.
pub(super) fn file_text(path: &Path) -> Option<String> {
    let path = path.to_str()?;
    Some(if needs_quotes(path) || path.contains('#') { quoted(path) } else { path.to_owned() })
}
