//! The wordings of serde, serde_json and toml, and what is said instead.

use serde_json::error::Category;

use super::USUAL_LEVELS;
use crate::words::{Argument, Message, Phrase, one_of, quoted, texts};

/// The levels of values within each other that toml reads.
const USUAL_TOML_LEVELS: usize = 80;

/// The most characters of a text or name that are repeated.
const MOST_SHOWN: usize = 60;

/// A reason of serde_json's. `next` is the byte where reading stopped, if there is one.
pub(super) fn json(error: &serde_json::Error, next: Option<u8>) -> Message {
    let words = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    let words = words.strip_suffix(&place).unwrap_or(&words);
    match error.classify() {
        Category::Data => data(words),
        Category::Eof => ended(words).into(),
        Category::Syntax | Category::Io => syntax(words, next),
    }
}

fn ended(words: &str) -> Phrase {
    match words {
        "EOF while parsing a list" => texts::DECODE_ENDS_IN_LIST,
        "EOF while parsing an object" => texts::DECODE_ENDS_IN_OBJECT,
        "EOF while parsing a string" => texts::DECODE_ENDS_IN_TEXT,
        _ => texts::DECODE_ENDS_BEFORE_VALUE,
    }
}

fn syntax(words: &str, next: Option<u8>) -> Message {
    let begins_value = matches!(next, Some(b'"' | b'[' | b'{' | b'-' | b'0'..=b'9'));
    let phrase = match words {
        "expected `:`" => texts::DECODE_NO_COLON,
        "expected `,` or `]`" => texts::DECODE_NO_COMMA_IN_LIST,
        "expected `,` or `}`" => texts::DECODE_NO_COMMA_IN_OBJECT,
        "expected ident" => texts::DECODE_MISSPELT,
        // The value is one, but of another kind than the type has.
        "expected value" if begins_value => texts::DECODE_OTHER,
        "expected value" if matches!(next, Some(b',' | b':' | b']' | b'}')) => texts::DECODE_NO_VALUE,
        "expected value" => texts::DECODE_BAD_VALUE,
        "key must be a string" | "expected `\"`" => texts::DECODE_NO_NAME,
        "invalid escape" | "lone leading surrogate in hex escape" | "unexpected end of hex escape" => {
            texts::DECODE_BAD_ESCAPE
        }
        "invalid unicode code point" => texts::DECODE_NOT_UTF_8,
        "invalid number" => texts::DECODE_BAD_NUMBER,
        "number out of range" => texts::DECODE_NUMBER_TOO_LARGE,
        "control character (\\u0000-\\u001F) found while parsing a string" => texts::DECODE_CONTROL_CHARACTER,
        "trailing comma" => texts::DECODE_COMMA_AT_END,
        // After the end of the whole text this is said elsewhere.
        "trailing characters" => texts::DECODE_LIST_TOO_LONG,
        "recursion limit exceeded" => return texts::decode_too_deep(USUAL_LEVELS),
        _ => texts::DECODE_NOT_JSON,
    };
    phrase.into()
}

/// Whether a wording says that a field is missing.
pub(super) fn is_missing_field(words: &str) -> bool {
    words.starts_with("missing field `")
}

/// A reason of toml's: in its syntax, or serde's.
pub(super) fn toml(words: &str) -> Message {
    // What it would have expected instead follows in further lines, or after a comma.
    let first = words.lines().next().unwrap_or_default();
    let reason = first.split(", expected ").next().unwrap_or_default();
    let phrase = match reason {
        "duplicate key" => texts::DECODE_KEY_TWICE,
        "string values must be quoted" | "unquoted string" => texts::DECODE_NO_QUOTES,
        "invalid basic string" | "invalid literal string" | "invalid string" => texts::DECODE_QUOTES_LEFT_OPEN,
        "invalid multi-line basic string" | "invalid multi-line literal string" => texts::DECODE_QUOTES_LEFT_OPEN,
        "key with no value" | "missing value for key" | "missing value" => texts::DECODE_NO_VALUE,
        "unclosed array" | "missing comma between array elements" => texts::DECODE_NO_COMMA_IN_LIST,
        "unclosed inline table" | "missing comma between key-value pairs" => texts::DECODE_NO_COMMA_IN_OBJECT,
        "unclosed table" | "unclosed array table" => texts::DECODE_TABLE_LEFT_OPEN,
        "invalid key" | "invalid table" | "invalid key-value pair" => texts::DECODE_BAD_KEY,
        "cannot recurse further; max recursion depth met" => return texts::decode_too_deep(USUAL_TOML_LEVELS),
        _ => return known(words).unwrap_or_else(|| texts::DECODE_NOT_TOML.into()),
    };
    phrase.into()
}

/// A reason of serde's: a value that is no part of the type. Others are what serde does not say.
fn data(words: &str) -> Message {
    known(words).unwrap_or_else(|| texts::DECODE_OTHER.into())
}

fn known(words: &str) -> Option<Message> {
    if let Some(phrase) = own_phrase(words) {
        return Some(texts::decode_expected(phrase));
    }
    if let Some(rest) = words.strip_prefix("missing field ") {
        return Some(texts::decode_missing(between_ticks(rest)?));
    }
    if let Some(rest) = words.strip_prefix("duplicate field ") {
        return Some(texts::decode_twice(between_ticks(rest)?));
    }
    if let Some(rest) = words.strip_prefix("unknown field ") {
        return Some(match rest.rsplit_once(", expected ") {
            Some((name, known)) => texts::decode_unknown_field(shown(between_ticks(name)?), names(known)),
            None => texts::decode_no_fields(shown(between_ticks(rest.strip_suffix(", there are no fields")?)?)),
        });
    }
    if let Some(rest) = words.strip_prefix("unknown variant ") {
        let (value, known) = rest.rsplit_once(", expected ")?;
        return Some(texts::decode_unknown_value(shown(between_ticks(value)?), names(known)));
    }
    if let Some(rest) = words.strip_prefix("invalid length ") {
        let (length, wanted) = rest.split_once(", expected ")?;
        return Some(texts::decode_found_expected(texts::decode_list_of(length.parse::<usize>().ok()?), kind(wanted)));
    }
    if let Some(rest) = words.strip_prefix("invalid type: ") {
        let (given, wanted) = rest.rsplit_once(", expected ")?;
        return Some(texts::decode_found_expected(found(given), kind(wanted)));
    }
    let (given, wanted) = words.strip_prefix("invalid value: ")?.rsplit_once(", expected ")?;
    Some(texts::decode_found_expected(found(given), range(wanted).unwrap_or_else(|| kind(wanted))))
}

/// A phrase that a type of this program names instead of a wording.
fn own_phrase(words: &str) -> Option<Phrase> {
    Phrase::of_id(words).filter(|_| words.starts_with("decode."))
}

fn between_ticks(words: &str) -> Option<&str> {
    words.strip_prefix('`')?.strip_suffix('`')
}

/// A name out of a file, in double quotes, cut off where it is long.
fn shown(name: &str) -> String {
    match name.char_indices().nth(MOST_SHOWN) {
        Some((end, _)) => format!("{}…", quoted(&name[..end])),
        None => quoted(name),
    }
}

/// The names in a list such as "one of `a`, `b`, `c`".
fn names(words: &str) -> Argument {
    let names: Vec<&str> = words.split('`').skip(1).step_by(2).collect();
    one_of(&names)
}

/// What serde calls a value that was found.
fn found(words: &str) -> Argument {
    let is_number = words.starts_with("integer ") || words.starts_with("floating point ");
    if is_number || words.starts_with("boolean ") {
        let value = words.split('`').nth(1).unwrap_or_default();
        return value.strip_suffix(".0").unwrap_or(value).into();
    }
    if let Some(text) = words.strip_prefix("string ") {
        // It is quoted and escaped.
        let text = text.strip_prefix('"').and_then(|text| text.strip_suffix('"')).unwrap_or(text);
        let cut = text.char_indices().nth(MOST_SHOWN).map(|(end, _)| format!("\"{}\"…", &text[..end]));
        return texts::decode_text_found(cut.unwrap_or_else(|| format!("\"{text}\""))).into();
    }
    match words {
        "null" | "unit value" => "null".into(),
        "sequence" => texts::DECODE_KIND_LIST.into(),
        "map" => texts::DECODE_KIND_OBJECT.into(),
        _ => texts::DECODE_KIND_OTHER.into(),
    }
}

/// The range of a type of whole numbers, for a number that is not in it.
fn range(words: &str) -> Option<Argument> {
    let up_to = |most: u64| texts::decode_kind_whole_up_to(most).into();
    Some(match words {
        "u8" => up_to(u8::MAX.into()),
        "u16" => up_to(u16::MAX.into()),
        "u32" => up_to(u32::MAX.into()),
        "u64" | "usize" => texts::DECODE_KIND_WHOLE_FROM_0.into(),
        _ => return None,
    })
}

/// What serde calls a kind of values.
fn kind(words: &str) -> Argument {
    if let Some(phrase) = own_phrase(words) {
        return phrase.into();
    }
    match words {
        "a string" | "a borrowed string" | "string" | "path string" => texts::DECODE_KIND_TEXT.into(),
        "a boolean" => texts::DECODE_KIND_TRUTH.into(),
        "u8" | "u16" | "u32" | "u64" | "usize" | "i32" | "i64" => texts::DECODE_KIND_WHOLE.into(),
        "f32" | "f64" => texts::DECODE_KIND_NUMBER.into(),
        "a sequence" => texts::DECODE_KIND_LIST.into(),
        "a map" => texts::DECODE_KIND_OBJECT.into(),
        _ if words.starts_with("struct ") => texts::DECODE_KIND_OBJECT.into(),
        _ => {
            let count = ["an array of length ", "a tuple of size "].iter().find_map(|start| words.strip_prefix(start));
            match count.and_then(|count| count.parse::<usize>().ok()) {
                Some(count) => texts::decode_list_of(count).into(),
                None => texts::DECODE_KIND_OTHER.into(),
            }
        }
    }
}
