//! Splits a text into numbers, separators, marks, line ends and words. Nothing is stored: a second pass reads the text again.
//!
//! Numbers decide what a text says. Everything else is a separator, which may stand anywhere; a mark, whose places are checked later; a
//! comment, which is skipped; or a word, which is an error.

use super::error::{TextError, TextProblem, quoted};
use super::marks::MarkKind;
use crate::text::without_byte_order_mark;
use crate::words::{Phrase, texts};

/// A line that begins with a word is a mark if it has fewer numbers than this. The shortest line of a row has three.
const NUMBERS_OF_A_ROW: usize = 3;

/// A token.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Token<'a> {
    /// A number; infinite if it is beyond single precision.
    Number(f32),
    /// `,` or `;`.
    Separator(u8),
    /// What stands between rows or keyframes: a line that begins with no number, such as `frame 3` or `****`, or signs such as `|`.
    Mark(&'a [u8]),
    /// The end of a line.
    LineEnd,
    /// Anything else up to the next blank or separator.
    Word(&'a [u8]),
}

/// A token with its location.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Piece<'a> {
    /// The byte offset of its start.
    pub(super) at: usize,
    /// The byte offset of its end.
    pub(super) end: usize,
    /// The token.
    pub(super) token: Token<'a>,
}

/// Reads tokens from a text.
#[derive(Clone, Debug)]
pub(super) struct Lexer<'a> {
    bytes: &'a [u8],
    at: usize,
    /// Whether nothing of the line was read.
    is_line_start: bool,
    /// Whether a number was read.
    has_numbers: bool,
}

impl<'a> Lexer<'a> {
    /// A lexer that starts at a byte offset, at which a line begins.
    pub(super) fn new(bytes: &'a [u8], at: usize) -> Self {
        let mark = if at == 0 { bytes.len() - without_byte_order_mark(bytes).len() } else { 0 };
        Self { bytes, at: at + mark, is_line_start: true, has_numbers: false }
    }

    /// The length and the token of what begins here; `rest` begins with no blank.
    fn token(&self, rest: &'a [u8]) -> (usize, Token<'a>) {
        match rest[0] {
            b'\n' => return (1, Token::LineEnd),
            // Some tables have a first column without a name.
            b',' if self.is_line_start && !self.has_numbers && is_mark_line(rest) => {}
            separator @ (b',' | b';') => return (1, Token::Separator(separator)),
            _ => {}
        }
        let run = run(rest);
        if let Some(value) = number(run) {
            return (run.len(), Token::Number(value));
        }
        if is_not_finite(run) {
            return (run.len(), Token::Word(run));
        }
        if self.is_line_start && is_mark_line(rest) {
            let line = line(rest).trim_ascii_end();
            return (line.len(), Token::Mark(line));
        }
        // Nothing but a number begins as one does.
        let begins_number = is_plain(run[0]) && !run[0].is_ascii_alphabetic();
        let kind = if begins_number { MarkKind::Other } else { MarkKind::of(&run[..run.len().min(LONGEST_WORD)]) };
        if kind == MarkKind::Frame && !self.is_line_start {
            let line = line(rest).trim_ascii_end();
            return (line.len(), Token::Mark(line));
        }
        if kind == MarkKind::End {
            return (run.len(), Token::Mark(run));
        }
        if let Some(label) = self.label(rest, run) {
            return (label.len(), Token::Mark(label));
        }
        let digits = run.iter().position(|&byte| is_sign(byte)).unwrap_or(run.len());
        if digits == 0 {
            let signs = run.iter().position(|&byte| !is_sign(byte)).unwrap_or(run.len());
            return (signs, Token::Mark(&run[..signs]));
        }
        match number(&run[..digits]) {
            Some(value) => (digits, Token::Number(value)),
            // A minus alone stands between numbers as any other sign does.
            None if run.iter().all(|&byte| byte == b'-' || byte == b'+' || byte == b'.') => {
                (run.len(), Token::Mark(run))
            }
            None => (run.len(), Token::Word(run)),
        }
    }
}

impl<'a> Lexer<'a> {
    /// A word at the begin or the end of a line with numbers, or before a bracket, a colon or an equals sign.
    fn label(&self, rest: &'a [u8], run: &'a [u8]) -> Option<&'a [u8]> {
        let is_letter = |byte: &u8| byte.is_ascii_alphabetic() || *byte == b'_' || !byte.is_ascii();
        run.first().filter(|first| is_letter(first))?;
        let length = run.iter().position(|byte| !is_letter(byte) && !byte.is_ascii_digit()).unwrap_or(run.len());
        let label = &run[..length];
        let stands_before = matches!(run.get(length), Some(b'(' | b'[' | b'{' | b':' | b'='));
        let is_all = length == run.len();
        let behind = rest[length..].iter().take_while(|&&byte| byte != b'\n');
        let ends_line = is_all && behind.copied().all(|byte| is_blank(byte) || matches!(byte, b',' | b';'));
        let is_text = std::str::from_utf8(label).is_ok();
        (is_text && (stands_before || is_all && (self.is_line_start || ends_line))).then_some(label)
    }
}

impl<'a> Iterator for Lexer<'a> {
    type Item = Piece<'a>;

    fn next(&mut self) -> Option<Piece<'a>> {
        loop {
            let rest = &self.bytes[self.at..];
            let blanks = rest.iter().position(|&byte| !is_blank(byte))?;
            let rest = &rest[blanks..];
            self.at += blanks;
            if !is_comment(rest) {
                let (length, token) = self.token(rest);
                let at = self.at;
                self.at += length;
                self.is_line_start = token == Token::LineEnd;
                self.has_numbers |= matches!(token, Token::Number(_));
                return Some(Piece { at, end: self.at, token });
            }
            self.at += line(rest).len();
        }
    }
}

/// The numbers of a text with their byte offsets; other tokens are ignored.
pub(super) fn numbers(bytes: &[u8], from: usize) -> impl Iterator<Item = (usize, f32)> {
    Lexer::new(bytes, from).filter_map(|piece| match piece.token {
        Token::Number(value) => Some((piece.at, value)),
        _ => None,
    })
}

/// The error for a number that is not finite, or for a word instead of a number.
pub(super) fn not_a_number(bytes: &[u8], piece: Piece<'_>, expected: Phrase) -> TextError {
    let run = run(&bytes[piece.at..]);
    let run = if run.is_empty() { &bytes[piece.at..piece.end] } else { run };
    let problem = if matches!(piece.token, Token::Number(_)) || is_not_finite(run) {
        TextProblem::NotFinite { found: String::from_utf8_lossy(&run[..run.len().min(40)]).into_owned() }
    } else if let Some(byte) = run.iter().find(|byte| byte.is_ascii_control()) {
        TextProblem::Unexpected {
            found: texts::text_found_byte(format!("{byte:#04x}")).into(),
            expected: expected.into(),
        }
    } else {
        TextProblem::Unexpected { found: quoted(run).into(), expected: expected.into() }
    };
    TextError::new(bytes, piece.at, problem)
}

/// A run is looked at so far behind the signs of numbers that it begins with: more would be looked at again and again.
const LONGEST_RUN: usize = 100;
/// The words of marks stand within so many bytes.
const LONGEST_WORD: usize = 40;

/// The bytes up to the next blank, separator or line end, or as many as are looked at.
fn run(rest: &[u8]) -> &[u8] {
    let plain = rest.iter().position(|&byte| !is_plain(byte)).unwrap_or(rest.len());
    let longest = &rest[..rest.len().min(plain + LONGEST_RUN)];
    let is_end = |&byte: &u8| is_blank(byte) || matches!(byte, b'\n' | b',' | b';');
    &rest[..longest.iter().position(is_end).unwrap_or(longest.len())]
}

/// Whether numbers may be written with a byte.
fn is_plain(byte: u8) -> bool {
    matches!(byte, b'0'..=b'9' | b'+' | b'-' | b'.' | b'e' | b'E')
}

/// The rest of a line, without its end.
fn line(rest: &[u8]) -> &[u8] {
    &rest[..rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len())]
}

/// Whether a line that begins with no number stands between rows: it has fewer numbers than a row, and is text.
fn is_mark_line(rest: &[u8]) -> bool {
    let line = line(rest);
    let pieces = line.split(|&byte| is_blank(byte) || is_sign(byte) || matches!(byte, b',' | b';'));
    let mut has_letters = false;
    let mut numbers = 0;
    for piece in pieces.filter(|piece| !piece.is_empty()) {
        if number(piece).is_some() {
            numbers += 1;
        } else {
            has_letters |= piece.iter().any(|byte| byte.is_ascii_alphabetic() || !byte.is_ascii());
        }
        if numbers == NUMBERS_OF_A_ROW {
            return false;
        }
    }
    // Brackets around a few numbers are the brackets of a row that goes on, or of a header.
    let is_bracketed = matches!(line[0], b'[' | b'(' | b'{' | b'|') && !has_letters && numbers > 0;
    let is_text =
        std::str::from_utf8(line).is_ok_and(|line| !line.chars().any(|c| c.is_control() && !c.is_whitespace()));
    let is_separator =
        numbers == 0 && !has_letters && line.iter().all(|&byte| is_blank(byte) || matches!(byte, b',' | b';'));
    is_text && !is_bracketed && !is_separator
}

fn is_comment(rest: &[u8]) -> bool {
    rest.starts_with(b"#") || rest.starts_with(b"//")
}

/// Quotes around numbers or names mean nothing.
fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\r' | 0x0b | 0x0c | b'"' | b'\'')
}

/// Signs that may stand beside a number without a blank.
fn is_sign(byte: u8) -> bool {
    byte.is_ascii_punctuation() && !matches!(byte, b'+' | b'-' | b'.' | b',' | b';' | b'#' | b'_' | b'"' | b'\'')
}

/// A number, with or without the `f` of C.
fn number(run: &[u8]) -> Option<f32> {
    let run = run.strip_suffix(b"f").unwrap_or(run);
    // The standard library also accepts `inf` and `nan`.
    if run.iter().copied().all(is_plain) { std::str::from_utf8(run).ok()?.parse().ok() } else { None }
}

/// The output of C and C++ programs for NaN and infinity: `nan`, `-nan(ind)`, `inf`, `1.#QNAN`, `-1.#IND`.
fn is_not_finite(run: &[u8]) -> bool {
    let unsigned = run.strip_prefix(b"-").or(run.strip_prefix(b"+")).unwrap_or(run).to_ascii_lowercase();
    let begins = |word: &[u8]| {
        unsigned.strip_prefix(word).is_some_and(|rest| !rest.first().is_some_and(u8::is_ascii_alphabetic))
    };
    begins(b"nan") || begins(b"inf") || begins(b"infinity") || unsigned.starts_with(b"1.#")
}
