//! The first pass over a text: counts numbers, lines and marks, and finds the first error.

use super::error::{TextError, TextProblem, quoted};
use super::lexer::{Lexer, Piece, Token, not_a_number};
use crate::words::{Message, Phrase, texts};

/// The number of first numbers that are kept: those of a matrix.
const FIRST: usize = 16;

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
    pub(super) first_lines: [usize; 4],
    /// The number of lines with numbers.
    pub(super) lines: usize,
    /// The numbers per line, if equal in all lines.
    pub(super) every_line: Option<usize>,
    /// The first line that breaks the pattern of the lines before it.
    pub(super) irregular_line: Option<Irregular>,
    /// The lines `frame [k]` and `end`.
    pub(super) marks: Marks,
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

/// The lines `frame [k]` and `end`, and the numbers between them.
#[derive(Debug, Default)]
pub(super) struct Marks {
    /// The number of lines `frame [k]`.
    pub(super) frames: usize,
    /// The number of lines `end`.
    pub(super) ends: usize,
    /// The number of numbers before the first `frame [k]`.
    pub(super) lead: usize,
    /// The number of blocks of numbers.
    pub(super) blocks: usize,
    /// The lengths of the first two blocks in numbers.
    pub(super) first_blocks: [usize; 2],
    /// The byte offsets of the first two blocks.
    pub(super) first_blocks_at: [usize; 2],
    /// The first block, from the third on, whose length differs from the second's.
    pub(super) irregular: Option<Irregular>,
    /// The first `frame [k]` out of sequence: the number found and the number expected.
    pub(super) out_of_turn: Option<(u64, u64)>,
    next_frame: u64,
    in_block: usize,
    block_at: usize,
    is_open: bool,
}

impl Marks {
    fn number(&mut self, at: usize) {
        if self.in_block == 0 && !self.is_open {
            self.block_at = at;
        }
        self.in_block += 1;
    }

    fn close(&mut self) {
        let (found, at, index) = (self.in_block, self.block_at, self.blocks);
        if let Some(first) = self.first_blocks.get_mut(index) {
            *first = found;
            self.first_blocks_at[index] = at;
        } else if found != self.first_blocks[1] && self.irregular.is_none() {
            self.irregular = Some(Irregular { at, index, found, expected: self.first_blocks[1] });
        }
        self.blocks += 1;
        self.in_block = 0;
        self.is_open = false;
    }

    fn frame(&mut self, at: usize, number: u64) {
        if self.frames == 0 && self.ends == 0 {
            self.lead = std::mem::take(&mut self.in_block);
            self.next_frame = number.min(1);
        } else if self.is_open || self.in_block > 0 {
            self.close();
        }
        if number != self.next_frame && self.out_of_turn.is_none() {
            self.out_of_turn = Some((number, self.next_frame));
        }
        self.next_frame = number.saturating_add(1);
        self.frames += 1;
        self.is_open = true;
        self.block_at = at;
    }

    fn end(&mut self) {
        if self.is_open || self.in_block > 0 {
            self.close();
        }
        self.ends += 1;
    }

    /// Whether the marks delimit keyframes. A single `end` may also close the file.
    pub(super) fn divide(&self) -> bool {
        self.frames > 0 || self.blocks > 1
    }
}

const NUMBER: Phrase = texts::TEXT_EXPECTED_NUMBER;

/// Reads a text of numbers, separators and marks.
pub(super) fn structure(bytes: &[u8]) -> Structure {
    let mut structure = Structure { end: bytes.len(), ..Structure::default() };
    let mut lexer = Lexer::new(bytes, 0);
    let mut line = Line::default();
    while let Some(piece) = lexer.next() {
        if let Err(problem) = structure.take(bytes, piece, &mut lexer, &mut line) {
            structure.end = piece.at;
            structure.problem = Some(problem);
            break;
        }
    }
    structure.line_ends(&line);
    if structure.marks.in_block > 0 || structure.marks.is_open {
        structure.marks.close();
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
    fn take<'a>(
        &mut self,
        bytes: &'a [u8],
        piece: Piece<'a>,
        lexer: &mut Lexer<'a>,
        line: &mut Line,
    ) -> Result<(), TextError> {
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
                self.numbers += 1;
                line.numbers += 1;
                line.last_separated = false;
                self.marks.number(piece.at);
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
                    self.ends_rows |= self.numbers.is_multiple_of(7);
                    self.splits_rows |= matches!(self.numbers % 7, 3 | 4);
                }
                line.last_separated = true;
            }
            Token::LineEnd => {
                self.line_ends(line);
                *line = Line::default();
            }
            Token::Word(word) if word.eq_ignore_ascii_case(b"end") => self.marks.end(),
            Token::Word(word) if word.len() >= 5 && word[..5].eq_ignore_ascii_case(b"frame") => {
                lexer.rest_of_line();
                let number = frame_number(bytes, piece.at).ok_or_else(|| {
                    let found = quoted(line_from(bytes, piece.at)).into();
                    let expected = texts::TEXT_EXPECTED_FRAME_NUMBER.into();
                    TextError::new(bytes, piece.at, TextProblem::Unexpected { found, expected })
                })?;
                self.marks.frame(piece.at, number);
            }
            Token::Number(_) | Token::Word(_) => {
                let expected =
                    if self.numbers == 0 && self.marks.frames == 0 { texts::TEXT_EXPECTED_KEYFRAMES } else { NUMBER };
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
        } else {
            // The header may take the first two lines; translations and quaternions may alternate.
            let expected = self.first_lines[2 + self.lines % 2];
            if line.numbers != expected && self.irregular_line.is_none() {
                self.irregular_line = Some(Irregular { at: line.at, index: self.lines, found: line.numbers, expected });
            }
        }
        self.every_line =
            if self.lines == 0 { Some(line.numbers) } else { self.every_line.filter(|&every| every == line.numbers) };
        self.lines += 1;
    }

    /// The probable location of an error in the rows, as a part of a sentence.
    pub(super) fn hint(&self, bytes: &[u8]) -> Option<Message> {
        self.irregular_line.map(|Irregular { at, found, expected, .. }| {
            let line = TextError::new(bytes, at, TextProblem::Empty).line;
            texts::text_hint_line(line, found, expected)
        })
    }
}

fn line_from(bytes: &[u8], at: usize) -> &[u8] {
    bytes[at..].split(|&byte| byte == b'\n').next().unwrap_or_default().trim_ascii_end()
}

fn frame_number(bytes: &[u8], at: usize) -> Option<u64> {
    let text = std::str::from_utf8(line_from(bytes, at)).ok()?;
    let bracketed = text.get(5..)?.trim().trim_end_matches([':', ',', ';']);
    let digits = bracketed.strip_prefix('[')?.strip_suffix(']')?.trim();
    if digits.bytes().all(|byte| byte.is_ascii_digit()) { digits.parse().ok() } else { None }
}
