//! The first pass over a text: counts numbers, lines and marks, and finds the first error.

use super::error::{TextError, TextProblem, quoted};
use super::lexer::{Lexer, Piece, Token, not_a_number};
use super::marks::{MarkKind, Marks, names};
use super::plan::ROW;
use crate::words::{Message, Phrase, texts};

/// The number of first numbers that are kept: those of a matrix.
const FIRST: usize = 16;
/// The number of first lines of which the numbers are counted.
pub(super) const FIRST_LINES: usize = 4;

/// The structure of a stream of numbers. Its size does not depend on the text's.
#[derive(Debug, Default)]
pub(super) struct Structure {
    /// The number of numbers.
    pub(super) numbers: usize,
    /// The first numbers.
    pub(super) first: Vec<f32>,
    /// The byte offset of the first number.
    pub(super) first_at: usize,
    /// The numbers per line of the first lines with numbers.
    pub(super) first_lines: [usize; FIRST_LINES],
    /// The byte offsets of the first lines with numbers.
    pub(super) first_lines_at: [usize; FIRST_LINES],
    /// The number of lines with numbers.
    pub(super) lines: usize,
    /// The numbers per line, if equal in all lines but so many first ones.
    pub(super) every_line: [Option<usize>; FIRST_LINES],
    /// The numbers per line, if equal in all lines but the last, which has fewer: the text ends within it.
    pub(super) every_whole_line: Option<usize>,
    /// The first line that breaks the pattern of the lines before it.
    pub(super) irregular_line: Option<Irregular>,
    /// The marks `frame` and `end`.
    pub(super) named: Marks,
    /// All other marks.
    pub(super) other: Marks,
    /// Whether any numbers are separated by commas.
    pub(super) has_commas: bool,
    /// Whether a semicolon occurs inside a group of seven numbers.
    pub(super) splits_rows: bool,
    /// Whether a semicolon occurs after a group of seven numbers.
    pub(super) ends_rows: bool,
    /// The byte offset at which the readable part ends.
    pub(super) end: usize,
    /// The error at that offset; `None` at the end of the text.
    pub(super) problem: Option<TextError>,
    commas: Commas,
    kinds: Kinds,
    last_at: usize,
}

/// A line or a keyframe of an unexpected length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Irregular {
    /// The byte offset of its start.
    pub(super) at: usize,
    /// The index of the line or keyframe, from 0.
    pub(super) index: usize,
    /// The number of numbers found.
    pub(super) found: usize,
    /// The number of numbers expected.
    pub(super) expected: usize,
}

/// Prose with fewer numbers than this is no animation.
const FEWEST: usize = 10 * ROW;

const NUMBER: Phrase = texts::TEXT_EXPECTED_NUMBER;

/// Reads a text of numbers, separators and marks.
pub(super) fn structure(bytes: &[u8]) -> Structure {
    let mut structure = Structure { end: bytes.len(), ..Structure::default() };
    let mut line = Line::default();
    for piece in Lexer::new(bytes, 0) {
        structure.commas.take(bytes, piece, structure.lines);
        if let Err(problem) = structure.take(bytes, piece, &mut line) {
            structure.end = piece.at;
            structure.problem = Some(problem);
            break;
        }
    }
    structure.line_ends(&line);
    structure.named.finish();
    structure.other.finish();
    if let Some([at, end]) = structure.commas.decimal() {
        let found = String::from_utf8_lossy(&bytes[at..end]).into_owned();
        let problem = TextProblem::DecimalComma { found };
        structure.problem = Some(TextError::new(bytes, at, problem));
        structure.end = at;
        structure.numbers = 0;
    }
    structure
}

#[derive(Default)]
struct Line {
    at: usize,
    numbers: usize,
    last_separated: bool,
}

impl Structure {
    fn take(&mut self, bytes: &[u8], piece: Piece<'_>, line: &mut Line) -> Result<(), TextError> {
        match piece.token {
            Token::Number(value) if value.is_finite() => {
                if self.numbers == 0 {
                    self.first_at = piece.at;
                }
                if self.first.len() < FIRST {
                    self.first.push(value);
                }
                if line.numbers == 0 {
                    line.at = piece.at;
                }
                self.last_at = piece.at;
                self.numbers += 1;
                line.numbers += 1;
                line.last_separated = false;
                self.named.number(piece.at);
                self.other.number(piece.at);
            }
            Token::Separator(separator) => {
                let is_comma = separator == b',';
                let comes_too_early =
                    if is_comma { line.numbers == 0 || line.last_separated } else { self.numbers == 0 };
                if comes_too_early {
                    return Err(not_a_number(bytes, piece, NUMBER));
                }
                self.has_commas |= is_comma;
                if !is_comma {
                    self.ends_rows |= self.numbers.is_multiple_of(ROW);
                    self.splits_rows |= matches!(self.numbers % ROW, 3 | 4);
                }
                line.last_separated = true;
            }
            Token::LineEnd => {
                self.line_ends(line);
                *line = Line::default();
            }
            Token::Mark(text) => {
                line.last_separated = false;
                let is_other = MarkKind::of(text) == MarkKind::Other;
                if is_other {
                    self.other.mark(piece.at, text);
                } else {
                    self.named.mark(piece.at, text);
                }
                // What stands before all numbers says something about them.
                if self.numbers > 0 && (is_other || line.numbers > 0) {
                    let rest = &bytes[piece.end..];
                    let blanks = rest.len() - rest.trim_ascii_start().len();
                    let ends_line = blanks == rest.len() || rest[..blanks].contains(&b'\n');
                    let are_signs = ends_line && line.numbers == 0 && !text.iter().any(u8::is_ascii_alphabetic);
                    self.kinds.take(bytes, piece, are_signs);
                }
            }
            Token::Number(_) | Token::Word(_) => {
                let is_first = self.numbers == 0 && self.named.count == 0;
                if (is_first || self.is_prose(bytes))
                    && let Some(error) = self.unexpected_mark(bytes)
                {
                    return Err(error);
                }
                let expected = if is_first { texts::TEXT_EXPECTED_KEYFRAMES } else { NUMBER };
                return Err(not_a_number(bytes, piece, expected));
            }
        }
        Ok(())
    }

    fn line_ends(&mut self, line: &Line) {
        if line.numbers == 0 {
            return;
        }
        if let Some(first) = self.first_lines.get_mut(self.lines) {
            *first = line.numbers;
            self.first_lines_at[self.lines] = line.at;
        } else {
            // The header may take the first two lines; translations and quaternions may alternate.
            let expected = self.first_lines[2 + self.lines % 2];
            if line.numbers != expected && self.irregular_line.is_none() {
                self.irregular_line = Some(Irregular { at: line.at, index: self.lines, found: line.numbers, expected });
            }
        }
        self.every_whole_line = self.every_line[0].filter(|&every| line.numbers < every);
        for (before, every) in self.every_line.iter_mut().enumerate() {
            if self.lines == before {
                *every = Some(line.numbers);
            } else if self.lines > before {
                *every = every.filter(|&every| every == line.numbers);
            }
        }
        self.lines += 1;
    }

    /// The bytes of the first mark that is neither `frame` nor `end`.
    pub(super) fn first_other_mark<'a>(&self, bytes: &'a [u8]) -> Option<(usize, &'a [u8])> {
        let [at, end] = self.other.first;
        (self.other.count > 0).then(|| (at, &bytes[at..end]))
    }

    /// Whether a word after the first number, which is that of a list, shows a text of words: it holds no keyframes.
    fn is_prose(&self, bytes: &[u8]) -> bool {
        let number = || bytes[self.first_at..].split(u8::is_ascii_whitespace).next().unwrap_or_default();
        self.numbers == 1 && self.named.count == 0 && self.other.first[0] < self.first_at && number().ends_with(b".")
    }

    /// The error for the first mark of a text that holds no keyframes.
    pub(super) fn unexpected_mark(&self, bytes: &[u8]) -> Option<TextError> {
        let [at, end] = self.other.first;
        let is_within = self.numbers > 0 && at > self.first_at;
        let expected = if is_within { NUMBER } else { texts::TEXT_EXPECTED_KEYFRAMES };
        (self.other.count > 0).then(|| mark_error(bytes, [at, end], expected))
    }

    /// The error for a mark that is probably a mistake: its like stands nowhere else, within the rows.
    pub(super) fn odd_mark(&self, bytes: &[u8]) -> Option<(usize, TextError)> {
        let first = self.first_other_mark(bytes).map(|(_, text)| text);
        let is_word = first.is_some_and(|text| text.iter().any(u8::is_ascii_alphabetic));
        if self.numbers < ROW || is_word && self.numbers < FEWEST {
            let are_names = first.is_some_and(|text| names(text).is_some());
            let error = self.unexpected_mark(bytes).filter(|_| self.problem.is_none() && !are_names);
            return error.map(|error| (0, error));
        }
        let [at, end] = self.kinds.odd(self.last_at, self.named.count > 0)?;
        let expected = if at < self.first_at { texts::TEXT_EXPECTED_KEYFRAMES } else { NUMBER };
        Some((at, mark_error(bytes, [at, end], expected)))
    }

    /// The probable location of an error in the rows, as a part of a sentence.
    pub(super) fn hint(&self, bytes: &[u8]) -> Option<Message> {
        let every =
            self.every_line[1].filter(|&every| self.lines > 2 && !every.is_multiple_of(ROW) && every > ROW / 2 + 1);
        match (self.irregular_line, every) {
            (Some(Irregular { at, found, expected, .. }), _) => {
                let line = TextError::new(bytes, at, TextProblem::Empty).line;
                Some(texts::text_hint_line(line, found, expected))
            }
            (None, Some(every)) => Some(texts::text_hint_every_line(every, ROW)),
            (None, None) => None,
        }
    }
}

fn mark_error(bytes: &[u8], [at, end]: [usize; 2], expected: Phrase) -> TextError {
    let word = bytes[at..end].split(u8::is_ascii_whitespace).next().unwrap_or_default();
    let problem = TextProblem::Unexpected { found: quoted(word).into(), expected: expected.into() };
    TextError::new(bytes, at, problem)
}

/// The most different marks that are told apart.
const MOST_KINDS: usize = 8;

/// The different marks within the rows. Digits do not make a difference.
#[derive(Debug, Default)]
struct Kinds {
    /// The bytes of the first of each kind, how many there are, and whether it is a line of signs.
    kinds: Vec<([usize; 2], usize, bool)>,
    are_too_many: bool,
}

impl Kinds {
    fn take(&mut self, bytes: &[u8], piece: Piece<'_>, are_signs: bool) {
        let text = |[at, end]: [usize; 2]| bytes[at..end].iter().filter(|byte| !byte.is_ascii_digit());
        let here = [piece.at, piece.end];
        let are_all = self.kinds.len() == MOST_KINDS;
        match self.kinds.iter_mut().find(|(first, ..)| text(*first).eq(text(here))) {
            Some((_, count, _)) => *count += 1,
            None if are_all => self.are_too_many = true,
            None => self.kinds.push((here, 1, are_signs)),
        }
    }

    /// The first that stands alone and before the last number. A line of signs may stand between two keyframes, if no words do.
    fn odd(&self, last_number_at: usize, have_names: bool) -> Option<[usize; 2]> {
        let is_odd = |&&([at, _], count, are_signs): &&([usize; 2], usize, bool)| {
            count == 1 && at < last_number_at && (have_names || !are_signs)
        };
        let alone = self.kinds.iter().find(is_odd)?;
        (!self.are_too_many).then_some(alone.0)
    }
}

/// A header has fewer pairs of numbers than this.
const FEW_PAIRS: usize = 4;

/// Tells whether commas are decimal commas: they stand between digits only, they join two numbers at most, and nothing has a point.
#[derive(Debug, Default)]
struct Commas {
    /// The bytes of the first two numbers that a comma joins.
    first: Option<[usize; 2]>,
    /// How many commas join two numbers, and whether any does in another line than the first, which may be a header.
    pairs: usize,
    is_below_header: bool,
    /// Whether something cannot be so with decimal commas.
    are_separators: bool,
    /// The numbers that are joined so far, and the bytes of the last of them.
    joined: usize,
    last: [usize; 2],
    comma_at: Option<usize>,
}

impl Commas {
    fn take(&mut self, bytes: &[u8], piece: Piece<'_>, line: usize) {
        let before = self.comma_at.take();
        match piece.token {
            Token::Number(_) => {
                let text = &bytes[piece.at..piece.end];
                let is_joined = before == Some(piece.at.wrapping_sub(1));
                let are_digits = text[0].is_ascii_digit();
                self.are_separators |= text.contains(&b'.') || before.is_some() && !(is_joined && are_digits);
                self.joined = if is_joined { self.joined + 1 } else { 1 };
                self.are_separators |= self.joined > 2;
                if is_joined {
                    self.first = self.first.or(Some([self.last[0], piece.end]));
                    self.pairs += 1;
                    self.is_below_header |= line > 0;
                }
                self.last = [piece.at, piece.end];
            }
            Token::Separator(b',') => {
                self.are_separators |= self.last[1] != piece.at;
                self.comma_at = Some(piece.at);
            }
            _ => self.are_separators |= before.is_some(),
        }
    }

    /// The bytes of the first number with a decimal comma.
    fn decimal(&self) -> Option<[usize; 2]> {
        self.first.filter(|_| !self.are_separators && (self.is_below_header || self.pairs >= FEW_PAIRS))
    }
}
