//! Writing of JSON, shared by all of its formats.

use std::fmt::{self, Write as _};

use crate::rbt::Rbt;

/// `{:?}` writes numbers with an absolute value below this (except 0) with an exponent.
const ALWAYS_WITH_EXPONENT: f32 = 1e-6;
/// `{:?}` writes numbers from this absolute value on without an exponent.
const SMALLEST_WITHOUT_EXPONENT: f32 = 1e-4;
/// Below this absolute value all digits before the point are significant.
const ALL_WHOLE: f32 = 16_777_216.0;
/// Numbers from [`SMALLEST_WITHOUT_EXPONENT`] on have at most this many decimal places.
const MOST_PLACES: i32 = 13;

/// A text as a JSON string.
#[must_use]
pub fn quoted(unquoted: &str) -> String {
    serde_json::Value::from(unquoted).to_string()
}

/// Appends a text as a JSON string.
pub fn push_quoted(text: &mut String, unquoted: &str) {
    text.push_str(&quoted(unquoted));
}

/// An upper bound of the bytes of a text as a JSON string: a control character becomes six.
#[must_use]
pub const fn quoted_bytes_at_most(unquoted: &str) -> u64 {
    6 * unquoted.len() as u64 + 2
}

/// Appends texts as a JSON array of strings.
pub fn push_strings<'a>(text: &mut String, unquoted: impl Iterator<Item = &'a str>) {
    text.push('[');
    for (index, unquoted) in unquoted.enumerate() {
        if index > 0 {
            text.push_str(", ");
        }
        push_quoted(text, unquoted);
    }
    text.push(']');
}

/// Appends transforms as a JSON array: `[{"translation": [x, y, z], "rotation": [x, y, z, w]}, …]`.
pub fn push_rbts(text: &mut String, rbts: impl Iterator<Item = Rbt>) {
    text.push('[');
    for (index, rbt) in rbts.enumerate() {
        text.push_str(if index == 0 { "{\"translation\": " } else { ", {\"translation\": " });
        push_f32s(text, &rbt.translation.to_array());
        text.push_str(", \"rotation\": ");
        push_f32s(text, &rbt.rotation.to_array());
        text.push('}');
    }
    text.push(']');
}

/// Appends a finite number in its shortest form that reads back to the same value: `0.25`, `4`, `1e-7`, `-0`.
pub fn push_f32(text: &mut String, number: f32) {
    debug_assert!(number.is_finite(), "JSON has no {number}");
    if let Some(shortest) = shortest(&mut zmij::Buffer::new(), number) {
        text.push_str(shortest);
        return;
    }
    let _ = write!(text, "{number:?}");
    if text.ends_with(".0") {
        text.truncate(text.len() - 2);
    }
}

/// The text that `{:?}` gives a number, without `.0`, several times as fast. `None` if the two texts may differ.
#[inline]
fn shortest(buffer: &mut zmij::Buffer, number: f32) -> Option<&str> {
    let size = number.abs();
    let is_known = size < ALWAYS_WITH_EXPONENT || (SMALLEST_WITHOUT_EXPONENT..ALL_WHOLE).contains(&size);
    if !is_known {
        return None;
    }
    let text = buffer.format_finite(number);
    match text.as_bytes() {
        [.., b'.', b'0'] => Some(&text[..text.len() - 2]),
        // An odd multiple of 1/2^n has n decimal places. If n - 1 places identify it, the exact decimal lies half-way between two shortest
        // texts, and `{:?}` and zmij may break the tie differently: leave those to the standard library.
        all => match fractional_bits(size) {
            n @ 1..=MOST_PLACES if all.iter().nth_back(n as usize - 1) == Some(&b'.') => None,
            _ => Some(text),
        },
    }
}

/// The number of binary digits after the point; 0 or less for a whole number.
#[inline]
fn fractional_bits(size: f32) -> i32 {
    const FRACTION: u32 = (1 << (f32::MANTISSA_DIGITS - 1)) - 1;
    let bits = size.to_bits();
    let significand = bits & FRACTION | (FRACTION + 1);
    let exponent = (bits >> (f32::MANTISSA_DIGITS - 1)) as i32 - (f32::MAX_EXP - 1);
    f32::MANTISSA_DIGITS as i32 - 1 - exponent - significand.trailing_zeros() as i32
}

/// Like [`push_f32`], in double precision.
pub fn push_f64(text: &mut String, number: f64) {
    debug_assert!(number.is_finite(), "JSON has no {number}");
    let _ = write!(text, "{number:?}");
    if text.ends_with(".0") {
        text.truncate(text.len() - 2);
    }
}

/// Appends numbers as an array: `[0, 0.25, 4]`.
pub fn push_f32s(text: &mut String, numbers: &[f32]) {
    text.push('[');
    for (index, &number) in numbers.iter().enumerate() {
        if index > 0 {
            text.push_str(", ");
        }
        push_f32(text, number);
    }
    text.push(']');
}

/// A buffer for the text of one transform. Its parts have lengths known to the compiler where possible.
#[derive(Debug)]
pub struct RbtBuffer {
    bytes: [u8; Self::MOST_BYTES],
    len: usize,
}

impl Default for RbtBuffer {
    fn default() -> Self {
        Self { bytes: [0; Self::MOST_BYTES], len: 0 }
    }
}

impl RbtBuffer {
    /// Enough for seven numbers, the names and the text before them.
    const MOST_BYTES: usize = 256;

    /// `before`, then `{ "translation": [x, y, z], "rotation": [x, y, z, w] }` in ASCII. `before` has at most 32 bytes.
    pub fn of<const N: usize>(&mut self, before: &[u8; N], rbt: &Rbt) -> &[u8] {
        const { assert!(N <= 32) }
        self.len = 0;
        self.put(before);
        self.put(b"{ \"translation\": [");
        self.put_numbers(rbt.translation.to_array());
        self.put(b"], \"rotation\": [");
        self.put_numbers(rbt.rotation.to_array());
        self.put(b"] }");
        &self.bytes[..self.len]
    }

    #[inline]
    fn put<const N: usize>(&mut self, part: &[u8; N]) {
        self.bytes[self.len..self.len + N].copy_from_slice(part);
        self.len += N;
    }

    #[inline]
    fn put_numbers<const N: usize>(&mut self, numbers: [f32; N]) {
        for (index, number) in numbers.into_iter().enumerate() {
            if index > 0 {
                self.put(b", ");
            }
            if let Some(shortest) = shortest(&mut zmij::Buffer::new(), number) {
                self.put_digits(shortest.as_bytes());
            } else {
                let _ = write!(self, "{number:?}");
                self.len -= if self.bytes[..self.len].ends_with(b".0") { 2 } else { 0 };
            }
        }
    }

    /// Copies up to 16 bytes as two copies that overlap.
    #[inline]
    fn put_digits(&mut self, digits: &[u8]) {
        let into = &mut self.bytes[self.len..self.len + digits.len()];
        self.len += digits.len();
        match (digits.first_chunk::<8>(), digits.last_chunk::<8>()) {
            (Some(first), Some(last)) if digits.len() <= 16 => {
                *into.first_chunk_mut().expect("it is as long") = *first;
                *into.last_chunk_mut().expect("it is as long") = *last;
            }
            _ => into.copy_from_slice(digits),
        }
    }
}

impl fmt::Write for RbtBuffer {
    fn write_str(&mut self, part: &str) -> fmt::Result {
        self.put_digits(part.as_bytes());
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_the_standard_library_does() {
        let written = |number: f32| {
            let mut text = String::new();
            push_f32(&mut text, number);
            text
        };
        let expected = |number: f32| {
            let text = format!("{number:?}");
            text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
        };
        // A step that is prime to the number of bit patterns passes through all sizes.
        let spread = (0..400_000_u32).map(|index| f32::from_bits(index.wrapping_mul(2_654_435_761)));
        let near = |number: f32| (-3..=3).map(move |step| f32::from_bits((number.to_bits() as i32 + step) as u32));
        let round = (-45..=38).flat_map(|power| near(format!("1e{power}").parse().expect("it is a number")));
        let whole = (0..70_000).map(|whole| whole as f32);
        let named = [0.0, f32::MIN_POSITIVE, f32::MAX, 16_777_216.0, 0.1, 0.25, 1.0 / 3.0];
        let all = spread.chain(round).chain(whole).chain(named.into_iter().flat_map(near));
        for number in all.filter(|number| number.is_finite()) {
            assert_eq!(written(number), expected(number));
            assert_eq!(written(-number), expected(-number));
        }
    }

    #[test]
    fn a_transform_has_its_numbers_in_it() {
        let numbers = [-f32::MIN_POSITIVE, f32::MAX, -0.0, 1.0, 123_456.79, -1e12, -0.000_123_456_79];
        let [x, y, z, i, j, k, w] = numbers;
        let rbt = Rbt::new(glam::Vec3::new(x, y, z), glam::Quat::from_xyzw(i, j, k, w));
        let mut buffer = RbtBuffer::default();
        let text = buffer.of(b"a", &rbt);
        let mut plain = "a{ \"translation\": ".to_owned();
        push_f32s(&mut plain, &numbers[..3]);
        plain.push_str(", \"rotation\": ");
        push_f32s(&mut plain, &numbers[3..]);
        assert_eq!(std::str::from_utf8(text).expect("it is ASCII"), plain + " }");
    }
}
