//! Helpers for reading and writing texts: byte order marks, locations, counts and alternatives in sentences.

use std::borrow::Cow;
use std::io;

const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// A text without the byte order mark that some editors put before it.
#[must_use]
pub fn without_byte_order_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes)
}

/// Like [`without_byte_order_mark`], for UTF-8.
#[must_use]
pub fn str_without_byte_order_mark(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text)
}

/// The line and the column of a byte, both from 1. The column counts characters; a byte order mark is not counted.
#[must_use]
pub fn line_and_column(bytes: &[u8], at: usize) -> (usize, usize) {
    let before = &bytes[..at.min(bytes.len())];
    let line = before.split(|&byte| byte == b'\n').count();
    let line_start = before.iter().rposition(|&byte| byte == b'\n').map_or(0, |newline| newline + 1);
    let in_line = without_byte_order_mark(&before[line_start..]);
    // Continuation bytes of UTF-8 do not count as columns.
    let column = in_line.iter().filter(|&&byte| byte & 0xc0 != 0x80).count() + 1;
    (line, column)
}

/// A count with its noun: `1 keyframe`, `2 keyframes`. The plural of `thing` ends in s.
#[must_use]
pub fn counted(count: usize, thing: &str) -> String {
    if count == 1 { format!("1 {thing}") } else { format!("{count} {thing}s") }
}

/// The system's words for an error, without the number that Rust adds.
#[must_use]
pub fn system_words(error: &io::Error) -> String {
    let words = error.to_string();
    match (error.raw_os_error(), words.rsplit_once(" (os error ")) {
        (Some(_), Some((words, _))) => words.to_owned(),
        _ => words,
    }
}

/// Words in a sentence, with a conjunction such as `or` before the last: `a, b or c`.
#[must_use]
pub fn listed<T: AsRef<str>>(words: &[T], conjunction: &str) -> String {
    let words: Vec<&str> = words.iter().map(AsRef::as_ref).collect();
    match words.as_slice() {
        [all @ .., last] if !all.is_empty() => format!("{} {conjunction} {last}", all.join(", ")),
        _ => words.concat(),
    }
}

/// A text in which no character does anything to a terminal: control characters, and those that turn the direction of writing, are shown
/// as escapes, such as `\u{1b}`. Line ends and tabs stay.
#[must_use]
pub fn visible(text: &str) -> Cow<'_, str> {
    let is_hidden = |character: char| {
        let is_layout = matches!(character, '\n' | '\t');
        let turns = matches!(character, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
        (character.is_control() && !is_layout) || turns
    };
    if !text.contains(is_hidden) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 8);
    for character in text.chars() {
        if is_hidden(character) {
            shown.extend(character.escape_unicode());
        } else {
            shown.push(character);
        }
    }
    Cow::Owned(shown)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_characters() {
        let text = "\u{feff}aé\nüb".as_bytes();
        assert_eq!(line_and_column(text, 0), (1, 1));
        assert_eq!(line_and_column(text, 6), (1, 3));
        assert_eq!(line_and_column(text, 9), (2, 2));
        assert_eq!(line_and_column(text, 99), (2, 3));
    }

    #[test]
    fn nothing_reaches_a_terminal_but_letters() {
        assert_eq!(visible("plain: é 걷기\n\ttwo"), "plain: é 걷기\n\ttwo");
        assert_eq!(visible("\u{1b}[31mred\r\u{9b}\u{202e}"), "\\u{1b}[31mred\\u{d}\\u{9b}\\u{202e}");
    }

    #[test]
    fn numbers_and_alternatives() {
        assert_eq!([0, 1, 2].map(|count| counted(count, "key")), ["0 keys", "1 key", "2 keys"]);
        assert_eq!(listed(&["a"; 0], "or"), "");
        assert_eq!([listed(&["a"], "or"), listed(&["a", "b"], "or")], ["a", "a or b"]);
        assert_eq!(listed(&["a", "b", "c"], "and"), "a, b and c");
    }
}
