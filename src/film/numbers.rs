//! Lists of frame numbers: `0-59`, `60-119:2`, `0,7,12-14`.

use std::collections::BTreeSet;

use thiserror::Error;

use crate::words::{Message, display_by_message, texts};

/// Frames of a film by their numbers, which count from 0. Never empty.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FrameNumbers(Vec<Range>);

/// The numbers `first`, `first + step` and so on, up to `last`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Range {
    first: usize,
    last: usize,
    /// At least 1.
    step: usize,
}

/// Why a text is no list of frame numbers.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum FrameNumbersError {
    /// A part between commas is neither a number nor a range.
    Unreadable(String),
    /// A range ends before it begins.
    Backwards(String),
}

display_by_message!(FrameNumbersError);

impl FrameNumbersError {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::Unreadable(part) => texts::film_frames_unreadable(part),
            Self::Backwards(part) => texts::film_frames_backwards(part),
        }
    }
}

impl FrameNumbers {
    /// Reads numbers and ranges between commas. A range is `FIRST-LAST` or `FIRST-LAST:STEP`.
    ///
    /// # Errors
    /// [`FrameNumbersError`] with the first part that is wrong.
    pub fn parse(text: &str) -> Result<Self, FrameNumbersError> {
        text.split(',').map(|part| Range::parse(part.trim())).collect::<Result<_, _>>().map(Self)
    }

    /// The numbers from 0 of a film of `count` frames, at least 1.
    #[must_use]
    pub fn first(count: usize) -> Self {
        Self(vec![Range { first: 0, last: count.saturating_sub(1), step: 1 }])
    }

    /// The numbers in ascending order, each once.
    ///
    /// # Errors
    /// The first number that a film of `count` frames does not have.
    pub fn of_film(&self, count: usize) -> Result<Vec<usize>, usize> {
        // Before the numbers are listed: a range may have any end.
        for range in &self.0 {
            if range.last >= count {
                return Err(range.numbers().find(|&number| number >= count).unwrap_or(range.last));
            }
        }
        let mut numbers: Vec<usize> = self.0.iter().flat_map(Range::numbers).collect();
        numbers.sort_unstable();
        numbers.dedup();
        Ok(numbers)
    }

    /// How many numbers are not among those that are there, the smallest and the largest of them; `None` if all are there. A number that
    /// two ranges have counts twice.
    #[must_use]
    pub fn absent(&self, there: &BTreeSet<usize>) -> Option<(usize, usize, usize)> {
        let is_absent = |number: &usize| !there.contains(number);
        let of_range = |range: &Range| {
            let present = there.range(range.first..=range.last).filter(|&&number| range.leads_to(number)).count();
            // A search ends at the first number that is absent, so it passes only numbers that are there.
            let [first, last] = [range.numbers().find(is_absent)?, range.numbers().rev().find(is_absent)?];
            Some(((range.last - range.first) / range.step + 1 - present, first, last))
        };
        self.0.iter().filter_map(of_range).reduce(|(count, first, last), (more, other_first, other_last)| {
            (count + more, first.min(other_first), last.max(other_last))
        })
    }
}

impl Range {
    fn parse(part: &str) -> Result<Self, FrameNumbersError> {
        let unreadable = || FrameNumbersError::Unreadable(part.to_owned());
        // `parse` would take a sign.
        let number = |digits: &str| {
            let is_number = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
            digits.parse::<u32>().ok().filter(|_| is_number).map(|number| number as usize).ok_or_else(unreadable)
        };
        let Some((first, rest)) = part.split_once('-') else {
            let only = number(part)?;
            return Ok(Self { first: only, last: only, step: 1 });
        };
        let (last, step) = rest.split_once(':').unwrap_or((rest, "1"));
        let [first, last, step] = [number(first)?, number(last)?, number(step)?];
        match (step, last < first) {
            (0, _) => Err(unreadable()),
            (_, true) => Err(FrameNumbersError::Backwards(part.to_owned())),
            // A range names its last number only if a step leads to it.
            (_, false) => Ok(Self { first, last: last - (last - first) % step, step }),
        }
    }

    fn leads_to(&self, number: usize) -> bool {
        (number - self.first).is_multiple_of(self.step)
    }

    fn numbers(&self) -> impl DoubleEndedIterator<Item = usize> + use<> {
        let Self { first, last, step } = *self;
        (0..=(last - first) / step).map(move |place| first + place * step)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_name_frames_once_and_in_order() {
        let of = |text: &str, count| FrameNumbers::parse(text).unwrap().of_film(count);
        assert_eq!(of("0-3", 9), Ok(vec![0, 1, 2, 3]));
        assert_eq!(of("2-8:3", 9), Ok(vec![2, 5, 8]));
        assert_eq!(of("7, 0,12-14,13", 15), Ok(vec![0, 7, 12, 13, 14]));
        assert_eq!(of("4-4", 5), Ok(vec![4]));
        // 9 is not among them.
        assert_eq!(of("0-9:2", 9), Ok(vec![0, 2, 4, 6, 8]));
        assert_eq!(of("0-4294967295", 9), Err(9));
        assert_eq!(of("0,9", 9), Err(9));
        assert_eq!(of("8-12:4", 9), Err(12));
    }

    #[test]
    fn what_is_not_there_is_counted() {
        let there: BTreeSet<usize> = (0..10).filter(|number| *number != 4).collect();
        let absent = |text: &str| FrameNumbers::parse(text).unwrap().absent(&there);
        assert_eq!(absent("0-3,5-9"), None);
        assert_eq!(absent("1-9:2"), None);
        assert_eq!(absent("0-9"), Some((1, 4, 4)));
        assert_eq!(absent("8-12,4"), Some((4, 4, 12)));
        assert_eq!(absent("0-4294967295"), Some((4_294_967_287, 4, 4_294_967_295)));
    }

    #[test]
    fn what_is_no_list_is_said() {
        for part in ["", "-3", "3-", "a", "1-2-3", "1:2", "1-5:0", "1-5:", "+1", "1.5", "4294967296"] {
            assert_eq!(FrameNumbers::parse(part), Err(FrameNumbersError::Unreadable(part.to_owned())), "{part}");
        }
        assert_eq!(FrameNumbers::parse("0,"), Err(FrameNumbersError::Unreadable(String::new())));
        assert_eq!(FrameNumbers::parse("0,5-4"), Err(FrameNumbersError::Backwards("5-4".to_owned())));
    }
}
