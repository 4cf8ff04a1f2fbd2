//! Splits a text into numbers, separators, line ends and words. Nothing is stored: a second pass reads the text again.

use super::error::{TextError, TextProblem, quoted};
use crate::text::without_byte_order_mark;
use crate::words::{Phrase, texts};

/// A token.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Token<'a> {
    /// A number; infinite if it is beyond single precision.
    Number(f32),
    /// `,` or `;`.
    Separator(u8),
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
    /// The token.
    pub(super) token: Token<'a>,
}

/// Reads tokens from a text.
#[derive(Clone, Debug)]
pub(super) struct Lexer<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Lexer<'a> {
    /// A lexer that starts at a byte offset.
    pub(super) fn new(bytes: &'a [u8], at: usize) -> Self {
        let mark = if at == 0 { bytes.len() - without_byte_order_mark(bytes).len() } else { 0 };
        Self { bytes, at: at + mark }
    }

    /// The unread rest.
    pub(super) fn rest(&self) -> &'a [u8] {
        &self.bytes[self.at..]
    }

    /// Reads the rest of the line and returns it without its end.
    pub(super) fn rest_of_line(&mut self) -> &'a [u8] {
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
        self.at += length;
        &rest[..length]
    }
}

impl<'a> Iterator for Lexer<'a> {
    type Item = Piece<'a>;

    fn next(&mut self) -> Option<Piece<'a>> {
        let rest = &self.bytes[self.at..];
        let blanks = rest.iter().position(|&byte| !is_blank(byte))?;
        let (at, rest) = (self.at + blanks, &rest[blanks..]);
        let (length, token) = match rest[0] {
            b'\n' => (1, Token::LineEnd),
            separator @ (b',' | b';') => (1, Token::Separator(separator)),
            _ => {
                let is_end = |&byte: &u8| is_blank(byte) || matches!(byte, b'\n' | b',' | b';');
                let length = rest.iter().position(is_end).unwrap_or(rest.len());
                let run = &rest[..length];
                (length, number(run).map_or(Token::Word(run), Token::Number))
            }
        };
        self.at = at + length;
        Some(Piece { at, token })
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
    let rest = &bytes[piece.at..];
    let is_end = |&byte: &u8| is_blank(byte) || matches!(byte, b'\n' | b',' | b';');
    let length = rest.iter().position(is_end).unwrap_or(rest.len()).max(1).min(rest.len());
    let run = &rest[..length];
    let problem = if matches!(piece.token, Token::Number(_)) || is_not_finite(run) {
        TextProblem::NotFinite { found: String::from_utf8_lossy(&run[..length.min(40)]).into_owned() }
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

fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\r' | 0x0b | 0x0c)
}

fn number(run: &[u8]) -> Option<f32> {
    // The standard library also accepts `inf` and `nan`.
    let is_plain = run.iter().all(|byte| matches!(byte, b'0'..=b'9' | b'+' | b'-' | b'.' | b'e' | b'E'));
    if is_plain { std::str::from_utf8(run).ok()?.parse().ok() } else { None }
}

/// The output of C and C++ programs for NaN and infinity: `nan`, `-nan(ind)`, `inf`, `1.#QNAN`, `-1.#IND`.
fn is_not_finite(run: &[u8]) -> bool {
    let unsigned = run.strip_prefix(b"-").or(run.strip_prefix(b"+")).unwrap_or(run).to_ascii_lowercase();
    unsigned.starts_with(b"nan") || unsigned.starts_with(b"inf") || unsigned.starts_with(b"1.#")
}
