//! The keys of one group, checked for the ranges of scene files.

use glam::{DVec3, Quat, Vec3};
use ruff_text_size::TextRange;

use super::evaluate::Met;
use super::fault::Fault;
use super::functions::{Term, unit_quaternion};
use crate::rbt::LARGEST_COORDINATE;
use crate::text_layouts::error::TextProblem;
use crate::words::{Phrase, texts};

/// The scale that is written for one of 0, which scene files do not have: nothing is seen of a node of this size.
const HIDDEN_SCALE: f32 = 1e-6;

/// The channel of a dictionary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Channel {
    Translation,
    Rotation,
    Scale,
}

impl Channel {
    /// In the order of the arguments of the course's functions.
    pub(super) const ALL: [Self; 3] = [Self::Translation, Self::Rotation, Self::Scale];

    /// Its name in the course's programs.
    pub(super) fn exact_name(self) -> &'static str {
        match self {
            Self::Translation => "translate_keys",
            Self::Rotation => "rotate_keys",
            Self::Scale => "scale_keys",
        }
    }

    /// The channel that a word of a name, in small letters, speaks of.
    pub(super) fn of_word(word: &str) -> Option<Self> {
        let word = word.trim_end_matches("keys").trim_end_matches("key");
        let begins = |beginnings: &[&str]| beginnings.iter().any(|beginning| word.starts_with(beginning));
        if begins(&["transl", "position"]) || word == "trans" || word == "pos" {
            Some(Self::Translation)
        } else if begins(&["rotat", "quat", "orient"]) || word == "rot" {
            Some(Self::Rotation)
        } else if begins(&["scal", "size"]) {
            Some(Self::Scale)
        } else {
            None
        }
    }

    /// The channel that a value belongs to.
    pub(super) fn of_term(term: &Term) -> Option<Self> {
        match term {
            Term::Number(_) => Some(Self::Scale),
            Term::Rotation(_) => Some(Self::Rotation),
            Term::Numbers(numbers) => match numbers.as_slice().len() {
                4 => Some(Self::Rotation),
                3 => Some(Self::Translation),
                _ => None,
            },
        }
    }
}

/// A key's value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Value {
    /// A number: a scale.
    Number(f32),
    /// A vector: a translation, or a scale along each axis.
    Vector(Vec3),
    /// A unit quaternion.
    Rotation(Quat),
}

/// A key as it stands in the program.
#[derive(Clone, Copy, Debug)]
pub(super) struct Key {
    /// The time in seconds.
    pub(super) seconds: f64,
    /// The value.
    pub(super) term: Term,
    /// Where the time stands, and where the value.
    pub(super) places: [TextRange; 2],
}

/// Seconds and values of one dictionary.
pub(super) type TimedValues = Vec<(f64, Value)>;

/// The keys of a group.
#[derive(Debug, Default)]
pub(super) struct Keys {
    /// Translations.
    pub(super) translations: TimedValues,
    /// Rotations.
    pub(super) rotations: TimedValues,
    /// Scales.
    pub(super) scales: TimedValues,
    /// What was met in them.
    pub(super) met: Met,
    /// Whether a rotation is four numbers.
    pub(super) has_four_numbers: bool,
    /// Whether a scale is 0.
    pub(super) hides: bool,
}

impl Keys {
    /// Adds the keys of a dictionary to a channel that has none.
    ///
    /// # Errors
    /// A value that the channel cannot have; two keys at one time.
    pub(super) fn add(&mut self, source: &str, channel: Channel, keys: &[Key]) -> Result<(), Fault> {
        let mut sorted: Vec<&Key> = keys.iter().collect();
        let mut values = TimedValues::with_capacity(keys.len());
        for key in keys {
            values.push((key.seconds, self.value(source, channel, key)?));
        }
        sorted.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
        if let Some(pair) = sorted.windows(2).find(|pair| pair[0].seconds == pair[1].seconds) {
            return Err(Fault::of(pair[1].places[0], TextProblem::TwoAtOneTime { seconds: pair[1].seconds }));
        }
        values.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        *match channel {
            Channel::Translation => &mut self.translations,
            Channel::Rotation => &mut self.rotations,
            Channel::Scale => &mut self.scales,
        } = values;
        Ok(())
    }

    /// Whether there is no key.
    pub(super) fn are_empty(&self) -> bool {
        self.translations.is_empty() && self.rotations.is_empty() && self.scales.is_empty()
    }

    fn value(&mut self, source: &str, channel: Channel, key: &Key) -> Result<Value, Fault> {
        let made = match channel {
            Channel::Translation => translation(key.term),
            Channel::Rotation => self.rotation(key.term),
            Channel::Scale => self.scale(key.term),
        };
        made.map_err(|expected| Fault::unexpected(source, key.places[1], expected))
    }

    fn rotation(&mut self, term: Term) -> Result<Value, Phrase> {
        let rotation = match term {
            Term::Rotation(rotation) => rotation,
            Term::Numbers(numbers) => {
                let &[w, x, y, z] = numbers.as_slice() else { return Err(texts::TEXT_EXPECTED_ROTATION) };
                self.has_four_numbers = true;
                unit_quaternion([x, y, z, w]).ok_or(texts::TEXT_EXPECTED_FOUR_UNIT_NUMBERS)?
            }
            Term::Number(_) => return Err(texts::TEXT_EXPECTED_ROTATION),
        };
        Ok(Value::Rotation(rotation.as_quat().normalize()))
    }

    fn scale(&mut self, term: Term) -> Result<Value, Phrase> {
        let mut checked = |number: f64| {
            let number = number as f32;
            self.hides |= number == 0.0;
            let is_scale = (0.0..=LARGEST_COORDINATE).contains(&number);
            is_scale.then_some(if number == 0.0 { HIDDEN_SCALE } else { number })
        };
        match term {
            Term::Number(number) => checked(number).map(Value::Number).ok_or(texts::TEXT_EXPECTED_SCALE_NUMBER),
            Term::Numbers(numbers) => {
                let &[x, y, z] = numbers.as_slice() else { return Err(texts::TEXT_EXPECTED_SCALE) };
                match [checked(x), checked(y), checked(z)] {
                    [Some(x), Some(y), Some(z)] => Ok(Value::Vector(Vec3::new(x, y, z))),
                    _ => Err(texts::TEXT_EXPECTED_SCALES),
                }
            }
            Term::Rotation(_) => Err(texts::TEXT_EXPECTED_SCALE),
        }
    }
}

fn translation(term: Term) -> Result<Value, Phrase> {
    let Term::Numbers(numbers) = term else { return Err(texts::TEXT_EXPECTED_TRANSLATION) };
    let &[x, y, z] = numbers.as_slice() else { return Err(texts::TEXT_EXPECTED_TRANSLATION) };
    // Normalises -0.0 to 0.0 so that equal values give equal bytes.
    let translation = DVec3::new(x, y, z).as_vec3() + Vec3::ZERO;
    let is_in_bounds = translation.abs().max_element() <= LARGEST_COORDINATE;
    is_in_bounds.then_some(Value::Vector(translation)).ok_or(texts::TEXT_EXPECTED_COORDINATES)
}
