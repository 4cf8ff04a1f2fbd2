//! Text in HTML, XML and Markdown: escapes, Base64, and the hashes that a page's Content Security Policy names.

use sha2::{Digest as _, Sha256};

/// Text escaped for HTML and XML, attributes included. Control characters, those that change the direction of writing, and the two that
/// XML forbids become blanks.
#[must_use]
pub fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{fffe}' | '\u{ffff}' => safe.push(' '),
            c if c.is_control() => safe.push(' '),
            c => safe.push(c),
        }
    }
    safe
}

/// Text escaped for a line of Markdown: signs are signs, and nothing in it is markup or HTML. Control characters, and those that change the
/// direction of writing, become blanks.
#[must_use]
pub fn markdown_escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\\' | '`' | '*' | '_' | '{' | '}' | '[' | ']' | '<' | '>' | '#' | '|' | '~' | '&' | '!' => {
                safe.extend(['\\', c]);
            }
            '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => safe.push(' '),
            c if c.is_control() => safe.push(' '),
            c => safe.push(c),
        }
    }
    safe
}

/// Bytes in Base64, with `=` at the end.
#[must_use]
pub fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let bits =
            three.iter().enumerate().fold(0_u32, |bits, (index, &byte)| bits | u32::from(byte) << (16 - 8 * index));
        for letter in 0..4 {
            let is_there = letter <= three.len();
            text.push(if is_there { LETTERS[(bits >> (18 - 6 * letter)) as usize & 63] as char } else { '=' });
        }
    }
    text
}

/// The source expression by which a Content Security Policy allows a page's own script or style: its SHA-256.
#[must_use]
pub fn policy_hash(text: &str) -> String {
    format!("'sha256-{}'", base64(&Sha256::digest(text)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base_64() {
        for (text, expected) in [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")] {
            assert_eq!(base64(text.as_bytes()), expected);
        }
    }

    #[test]
    fn nothing_that_is_escaped_ends_its_place() {
        assert_eq!(escaped("<a title=\"b\">&'\u{1b}\u{202e}\u{ffff}é"), "&lt;a title=&quot;b&quot;&gt;&amp;&#39;   é");
    }

    #[test]
    fn nothing_that_is_escaped_is_markdown() {
        assert_eq!(markdown_escaped("a|b <i>_c_\n[x](y)"), r"a\|b \<i\>\_c\_ \[x\](y)");
    }

    #[test]
    fn the_hash_of_a_policy_is_that_of_the_specification() {
        let known = "'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='";
        assert_eq!(policy_hash("alert('Hello, world.');"), known);
    }
}
