//! A parser for the subset of Python in dictionaries of timed keys.

use glam::{Quat, Vec3};

use super::functions::{Arguments, FUNCTIONS, Term, call};
use crate::rbt::LARGEST_COORDINATE;
use crate::text_layouts::error::{TextError, TextProblem, quoted};
use crate::words::{Argument, Phrase, texts};

/// The most keys that a dictionary can have, so that memory is bounded.
const MOST_KEYS: usize = 20_000;
/// The deepest nesting of parentheses.
const DEEPEST: usize = 8;

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

/// Seconds and values of one dictionary.
pub(super) type TimedValues = Vec<(f64, Value)>;

/// The result of a text.
#[derive(Debug, Default)]
pub(super) struct Keys {
    /// The keys of `translate_keys`.
    pub(super) translations: TimedValues,
    /// The keys of `rotate_keys`.
    pub(super) rotations: TimedValues,
    /// The keys of `scale_keys`.
    pub(super) scales: TimedValues,
    /// Whether `quaternion` is called with components.
    pub(super) has_quaternions: bool,
    /// Whether `quaternion_from_euler` is called.
    pub(super) has_euler_angles: bool,
}

/// The channel of a dictionary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Purpose {
    Translate,
    Rotate,
    Scale,
}

/// Reads a Python text.
pub(super) struct Parser<'a> {
    bytes: &'a [u8],
    at: usize,
    keys: Keys,
}

impl<'a> Parser<'a> {
    /// A parser that starts at a byte offset.
    pub(super) fn new(bytes: &'a [u8], at: usize) -> Self {
        Self { bytes, at, keys: Keys::default() }
    }

    /// Reads all dictionaries.
    ///
    /// # Errors
    /// The first error, with its location.
    pub(super) fn keys(&mut self) -> Result<Keys, TextError> {
        loop {
            self.skip_blanks();
            let at = self.at;
            match self.peek() {
                None => return Ok(std::mem::take(&mut self.keys)),
                Some(b',' | b';') => self.at += 1,
                Some(b'{') => self.dictionary(None)?,
                Some(_) => {
                    let name = self.name().ok_or_else(|| self.expected(texts::TEXT_EXPECTED_DICTIONARY_NAME))?;
                    if matches!(name, "import" | "from") {
                        self.skip_line();
                        continue;
                    }
                    let purpose = match name {
                        "translate_keys" => Purpose::Translate,
                        "rotate_keys" => Purpose::Rotate,
                        "scale_keys" => Purpose::Scale,
                        _ => {
                            self.at = at;
                            return Err(self.expected(texts::TEXT_EXPECTED_DICTIONARY_NAME));
                        }
                    };
                    self.token(b'=', texts::TEXT_EXPECTED_EQUALS)?;
                    self.dictionary(Some(purpose))?;
                }
            }
        }
    }

    fn dictionary(&mut self, named: Option<Purpose>) -> Result<(), TextError> {
        self.skip_blanks();
        let start = self.at;
        self.token(b'{', texts::TEXT_EXPECTED_DICTIONARY)?;
        let mut values = TimedValues::new();
        let mut key_offsets = Vec::new();
        let mut purpose = named;
        loop {
            if self.takes(b'}') {
                break;
            }
            if values.len() == MOST_KEYS {
                return Err(self.error(self.at, TextProblem::TooManyKeys { limit: MOST_KEYS }));
            }
            self.skip_blanks();
            let key_at = self.at;
            let seconds = self.seconds()?;
            self.token(b':', texts::TEXT_EXPECTED_COLON)?;
            self.skip_blanks();
            let at = self.at;
            let term = self.term(0)?;
            let wanted = *purpose.get_or_insert(match term {
                Term::Number(_) => Purpose::Scale,
                Term::Numbers(..) => Purpose::Translate,
                Term::Rotation(_) => Purpose::Rotate,
            });
            values.push((seconds, self.value(at, wanted, term)?));
            key_offsets.push(key_at);
            if !self.takes(b',') {
                self.token(b'}', texts::TEXT_EXPECTED_COMMA_OR_BRACE)?;
                break;
            }
        }
        self.check_times(&values, &key_offsets)?;
        let held = match purpose {
            None => return Ok(()),
            Some(Purpose::Translate) => &mut self.keys.translations,
            Some(Purpose::Rotate) => &mut self.keys.rotations,
            Some(Purpose::Scale) => &mut self.keys.scales,
        };
        if !held.is_empty() {
            let problem = TextProblem::Unexpected {
                found: texts::TEXT_FOUND_SECOND_DICTIONARY.into(),
                expected: texts::TEXT_EXPECTED_ONE_EACH.into(),
            };
            return Err(self.error(start, problem));
        }
        values.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        *held = values;
        Ok(())
    }

    fn check_times(&self, values: &TimedValues, key_offsets: &[usize]) -> Result<(), TextError> {
        let mut order: Vec<usize> = (0..values.len()).collect();
        order.sort_by(|&a, &b| values[a].0.total_cmp(&values[b].0));
        match order.windows(2).find(|pair| values[pair[0]].0 == values[pair[1]].0) {
            Some(pair) => {
                Err(self.error(key_offsets[pair[1]], TextProblem::TwoAtOneTime { seconds: values[pair[1]].0 }))
            }
            None => Ok(()),
        }
    }

    /// Converts a value to that of a channel, within the ranges of scene files.
    fn value(&self, at: usize, purpose: Purpose, term: Term) -> Result<Value, TextError> {
        let is_coordinate = |number: &f32| number.abs() <= LARGEST_COORDINATE;
        let is_scale = |number: &f32| *number > 0.0 && *number <= LARGEST_COORDINATE;
        let (value, expected) = match (purpose, term) {
            (Purpose::Translate, Term::Numbers([x, y, z, _], 3)) => (
                [x, y, z].iter().all(is_coordinate).then_some(Value::Vector(Vec3::new(x, y, z))),
                texts::TEXT_EXPECTED_COORDINATES,
            ),
            (Purpose::Translate, _) => (None, texts::TEXT_EXPECTED_TRANSLATION),
            (Purpose::Rotate, Term::Rotation(rotation)) => return Ok(Value::Rotation(rotation)),
            (Purpose::Rotate, _) => (None, texts::TEXT_EXPECTED_ROTATION),
            (Purpose::Scale, Term::Number(number)) => {
                (is_scale(&number).then_some(Value::Number(number)), texts::TEXT_EXPECTED_SCALE_NUMBER)
            }
            (Purpose::Scale, Term::Numbers([x, y, z, _], 3)) => (
                [x, y, z].iter().all(is_scale).then_some(Value::Vector(Vec3::new(x, y, z))),
                texts::TEXT_EXPECTED_SCALES,
            ),
            (Purpose::Scale, _) => (None, texts::TEXT_EXPECTED_SCALE),
        };
        value.ok_or_else(|| self.unexpected(at, expected))
    }

    fn term(&mut self, depth: usize) -> Result<Term, TextError> {
        self.skip_blanks();
        let at = self.at;
        if depth > DEEPEST {
            return Err(self.expected(texts::TEXT_EXPECTED_FEWER_PARENTHESES));
        }
        if let Some(close) = self.opens() {
            return self.sequence(close, depth);
        }
        let Some(name) = self.name() else { return self.number().map(Term::Number) };
        if is_not_finite(name) {
            let found = name.to_owned();
            return Err(self.error(at, TextProblem::NotFinite { found }));
        }
        // A module's name may precede the function's.
        let mut function = name;
        while self.takes(b'.') {
            function = self.name().ok_or_else(|| self.expected(texts::TEXT_EXPECTED_NAME))?;
        }
        if !FUNCTIONS.contains(&function) {
            return Err(self.unexpected(at, texts::text_expected_function(FUNCTIONS.join(", "))));
        }
        self.token(b'(', texts::TEXT_EXPECTED_OPEN)?;
        let arguments = self.arguments(depth)?;
        self.keys.has_quaternions |= function == "quaternion" && !arguments.terms.is_empty();
        self.keys.has_euler_angles |= function == "quaternion_from_euler";
        call(function, &arguments).map_err(|expected| self.unexpected(at, expected))
    }

    fn arguments(&mut self, depth: usize) -> Result<Arguments<'a>, TextError> {
        let mut arguments = Arguments::default();
        loop {
            if self.takes(b')') {
                return Ok(arguments);
            }
            if arguments.terms.len() == 4 {
                return Err(self.expected(texts::TEXT_EXPECTED_FOUR_ARGUMENTS));
            }
            self.skip_blanks();
            let at = self.at;
            let mut name = self.name();
            if !(name.is_some() && self.takes(b'=')) {
                (self.at, name) = (at, None);
            }
            let term = self.term(depth + 1)?;
            arguments.terms.push((name, term));
            if !self.takes(b',') {
                self.token(b')', texts::TEXT_EXPECTED_COMMA_OR_CLOSE)?;
                return Ok(arguments);
            }
        }
    }

    /// A tuple or a list of numbers; one number in parentheses is a number.
    fn sequence(&mut self, close: u8, depth: usize) -> Result<Term, TextError> {
        let mut numbers = [0.0; 4];
        let mut count = 0;
        loop {
            if self.takes(close) {
                return Ok(Term::Numbers(numbers, count));
            }
            let Some(next) = numbers.get_mut(count) else {
                return Err(self.expected(texts::TEXT_EXPECTED_FOUR_NUMBERS));
            };
            match self.term(depth + 1)? {
                Term::Number(number) => *next = number,
                other if count == 0 && self.takes(close) => return Ok(other),
                _ => return Err(self.expected(texts::TEXT_EXPECTED_ONLY_NUMBERS)),
            }
            count += 1;
            if !self.takes(b',') {
                self.token(close, texts::TEXT_EXPECTED_COMMA_OR_CLOSING)?;
                let is_number = count == 1 && close == b')';
                return Ok(if is_number { Term::Number(numbers[0]) } else { Term::Numbers(numbers, count) });
            }
        }
    }

    fn opens(&mut self) -> Option<u8> {
        if self.takes(b'(') {
            Some(b')')
        } else if self.takes(b'[') {
            Some(b']')
        } else {
            None
        }
    }

    fn number_text(&mut self) -> Option<&'a str> {
        self.skip_blanks();
        let rest = &self.bytes[self.at..];
        let length = rest
            .iter()
            .enumerate()
            .take_while(|&(index, &byte)| {
                byte.is_ascii_digit()
                    || matches!(byte, b'.' | b'e' | b'E')
                    || matches!(byte, b'+' | b'-') && (index == 0 || matches!(rest[index - 1], b'e' | b'E'))
            })
            .count();
        self.at += length;
        std::str::from_utf8(&rest[..length]).ok()
    }

    fn number(&mut self) -> Result<f32, TextError> {
        let at = self.at;
        let number = self.number_text().and_then(|text| text.parse::<f32>().ok());
        self.finite(at, number, f32::is_finite, texts::TEXT_EXPECTED_NUMBER)
    }

    fn seconds(&mut self) -> Result<f64, TextError> {
        let at = self.at;
        // Normalise -0.0 to 0.0 so that equal values give equal bytes.
        let seconds = self.number_text().and_then(|text| text.parse::<f64>().ok()).map(|seconds| seconds + 0.0);
        self.finite(at, seconds, f64::is_finite, texts::TEXT_EXPECTED_SECONDS)
    }

    fn finite<N: Copy>(
        &self,
        at: usize,
        number: Option<N>,
        is_finite: impl Fn(N) -> bool,
        expected: Phrase,
    ) -> Result<N, TextError> {
        match number {
            Some(number) if is_finite(number) => Ok(number),
            Some(_) => {
                let found = String::from_utf8_lossy(&self.bytes[at..self.at.min(at + 40)]).trim().to_owned();
                Err(self.error(at, TextProblem::NotFinite { found }))
            }
            None => Err(self.unexpected(at, expected)),
        }
    }

    fn name(&mut self) -> Option<&'a str> {
        self.skip_blanks();
        let rest = &self.bytes[self.at..];
        let length = rest.iter().take_while(|byte| byte.is_ascii_alphanumeric() || **byte == b'_').count();
        if length == 0 || rest[0].is_ascii_digit() {
            return None;
        }
        self.at += length;
        std::str::from_utf8(&rest[..length]).ok()
    }

    fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    fn takes(&mut self, byte: u8) -> bool {
        self.skip_blanks();
        let is_there = self.peek() == Some(byte);
        self.at += usize::from(is_there);
        is_there
    }

    fn token(&mut self, byte: u8, expected: Phrase) -> Result<(), TextError> {
        if self.takes(byte) { Ok(()) } else { Err(self.expected(expected)) }
    }

    fn skip_line(&mut self) {
        let rest = &self.bytes[self.at..];
        self.at += rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
    }

    fn skip_blanks(&mut self) {
        loop {
            match self.peek() {
                Some(b'#') => self.skip_line(),
                Some(b' ' | b'\t' | b'\r' | b'\n' | b'\\' | 0x0c) => self.at += 1,
                _ => return,
            }
        }
    }

    fn error(&self, at: usize, problem: TextProblem) -> TextError {
        TextError::new(self.bytes, at, problem)
    }

    fn expected(&self, expected: Phrase) -> TextError {
        self.unexpected(self.at, expected)
    }

    fn unexpected(&self, at: usize, expected: impl Into<Argument>) -> TextError {
        let mut at = at;
        while self.bytes.get(at).is_some_and(u8::is_ascii_whitespace) {
            at += 1;
        }
        let rest = &self.bytes[at..];
        let length = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(rest.len());
        let found = if length == 0 { texts::TEXT_FOUND_END_OF_FILE.into() } else { quoted(&rest[..length]).into() };
        self.error(at, TextProblem::Unexpected { found, expected: expected.into() })
    }
}

fn is_not_finite(name: &str) -> bool {
    matches!(name.to_ascii_lowercase().as_str(), "nan" | "inf" | "infinity")
}
