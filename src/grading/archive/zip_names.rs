//! The names in a zip, which are bytes of an encoding that it may not tell.
//!
//! Zips of macOS hold UTF-8 without saying so, and those of Korean Windows hold code page 949. Where the bytes are neither, they are of
//! code page 437, as the format has it.

use std::borrow::Cow;

use encoding_rs::EUC_KR;

/// Whether names that are not UTF-8 are of code page 949.
///
/// Accented letters of code page 437 can look like rare syllables. So one of the names must hold a common syllable, one of the 2350 of
/// KS X 1001: in code page 437 those bytes begin with the lines of boxes.
pub fn are_korean(mut names: impl Iterator<Item = impl AsRef<[u8]>>) -> bool {
    let is_korean =
        |name: &[u8]| std::str::from_utf8(name).is_err() && korean(name).is_some() && has_common_syllable(name);
    names.any(|name| is_korean(name.as_ref()))
}

/// A name: UTF-8, or of code page 949 where `are_korean`; `None` where its bytes are neither.
pub fn decoded(name: &[u8], are_korean: bool) -> Option<Cow<'_, str>> {
    match std::str::from_utf8(name) {
        Ok(name) => Some(name.into()),
        Err(_) => korean(name).filter(|_| are_korean),
    }
}

/// A name of code page 949, which the web calls EUC-KR.
fn korean(name: &[u8]) -> Option<Cow<'_, str>> {
    EUC_KR.decode_without_bom_handling_and_without_replacement(name)
}

fn has_common_syllable(name: &[u8]) -> bool {
    let mut rest = name;
    while let [first, after @ ..] = rest {
        rest = match after {
            [second, after @ ..] if *first >= 0x80 => {
                if (0xb0..=0xc8).contains(first) && *second >= 0xa1 {
                    return true;
                }
                after
            }
            _ => after,
        };
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 김철수/걷기.txt in code page 949.
    const WALK: &[u8] = b"\xb1\xe8\xc3\xb6\xbc\xf6/\xb0\xc8\xb1\xe2.txt";

    #[test]
    fn names_of_korean_windows_are_hangul() {
        assert!(are_korean([&b"a.txt"[..], WALK].into_iter()));
        assert_eq!(decoded(WALK, true).as_deref(), Some("김철수/걷기.txt"));
        // A syllable that code page 949 adds to KS X 1001, once another name shows what the zip is of.
        assert_eq!(decoded(b"\x8c\x63.txt", true).as_deref(), Some("똠.txt"));
        assert_eq!(decoded("이수진.txt".as_bytes(), true).as_deref(), Some("이수진.txt"));
    }

    #[test]
    fn accented_names_stay_of_code_page_437() {
        // élan.txt, whose first two bytes would be a syllable; Müller; UTF-8.
        for name in [&b"\x82lan.txt"[..], b"M\x81ller.txt", "김철수".as_bytes(), b"plain"] {
            assert!(!are_korean([name].into_iter()), "{name:?}");
        }
        assert_eq!(decoded(b"\x82lan.txt", false), None);
        // Bytes that are no code page 949, in a zip that is of it.
        assert_eq!(decoded(b"caf\x82.txt", true), None);
    }
}
