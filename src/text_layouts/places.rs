//! The pass that checks the places of marks: each keyframe has them where the first has.

use super::error::{TextError, TextProblem, quoted};
use super::layout::Layout;
use super::lexer::{Lexer, Token};
use super::marks::{MarkKind, names};
use super::plan::{Plan, ROW};
use super::report::Certainty;
use crate::words::texts;

/// A report names at most so many different marks.
const MOST_NAMES: usize = 3;

/// The marks of a keyframe: for each of its numbers, whether a mark stands before it.
struct Places {
    first: Vec<bool>,
    here: Vec<bool>,
    /// Whether a mark stands between the first two keyframes.
    between: Option<bool>,
}

/// Checks that marks stand at the same places of every keyframe, and notes which they are. A mark before the first keyframe or after the
/// last may be missing.
///
/// # Errors
/// A mark that stands elsewhere than in keyframe 0, or is missing.
pub(super) fn check(bytes: &[u8], plan: &mut Plan) -> Result<(), TextError> {
    let length = plan.nodes * (ROW + plan.lead);
    if length == 0 || plan.keyframes == 0 || plan.layout == Layout::Matrices {
        return Ok(());
    }
    let mut places = Places { first: vec![false; length], here: vec![false; length], between: None };
    let mut numbers = 0_usize;
    let mut seen: Vec<String> = Vec::new();
    let is_read = |numbers: usize| numbers < plan.skip + plan.keyframes * length;
    for piece in Lexer::new(&bytes[..plan.end], plan.from) {
        match piece.token {
            Token::Number(_) => {
                let (keyframe, place) = position(numbers, plan.skip, length);
                if numbers > plan.skip && is_read(numbers) {
                    places.number(bytes, piece.at, keyframe, place)?;
                }
                numbers += 1;
            }
            Token::Mark(text) => {
                let is_named = MarkKind::of(text) != MarkKind::Other || names(text).is_some();
                let name = quoted(text);
                if !is_named && seen.len() <= MOST_NAMES && !seen.contains(&name) {
                    seen.push(name);
                }
                if numbers > plan.skip && is_read(numbers) && MarkKind::of(text) == MarkKind::Other {
                    let (keyframe, place) = position(numbers, plan.skip, length);
                    places.mark(bytes, piece.at, text, keyframe, place)?;
                }
            }
            _ => {}
        }
    }
    if !seen.is_empty() {
        let more = if seen.len() > MOST_NAMES { " and others" } else { "" };
        seen.truncate(MOST_NAMES);
        plan.find(Certainty::Note, format!("what stands between numbers is not used: {}{more}", seen.join(", ")));
    }
    Ok(())
}

/// The keyframe and the place in it of a number.
fn position(numbers: usize, skip: usize, length: usize) -> (usize, usize) {
    let number = numbers.saturating_sub(skip);
    (number / length, number % length)
}

impl Places {
    /// Takes in a mark before a number.
    fn mark(&mut self, bytes: &[u8], at: usize, text: &[u8], keyframe: usize, place: usize) -> Result<(), TextError> {
        let is_expected = match (keyframe, place) {
            (1, 0) => true,
            (_, 0) => self.between == Some(true),
            (0, _) => {
                self.first[place] = true;
                true
            }
            _ => self.first[place],
        };
        self.here[place] = true;
        if is_expected {
            return Ok(());
        }
        let problem =
            TextProblem::Unexpected { found: quoted(text).into(), expected: texts::TEXT_EXPECTED_NUMBER_HERE.into() };
        Err(TextError::new(bytes, at, problem))
    }

    /// Takes in a number, before which all marks of its place stood.
    fn number(&mut self, bytes: &[u8], at: usize, keyframe: usize, place: usize) -> Result<(), TextError> {
        let found = std::mem::take(&mut self.here[place]);
        let expected = match (keyframe, place) {
            (0, _) => found,
            (_, 0) => *self.between.get_or_insert(found),
            _ => self.first[place],
        };
        if found == expected {
            return Ok(());
        }
        let problem = TextProblem::Unexpected {
            found: texts::TEXT_FOUND_NO_MARK.into(),
            expected: texts::TEXT_EXPECTED_MARK.into(),
        };
        Err(TextError::new(bytes, at, problem))
    }
}
