//! Names of folders for submissions, on every system.

use std::collections::HashSet;

use crate::grading::marks::Marks;

/// The longest name in bytes: there is room for a number.
const LONGEST_BYTES: usize = 200;

/// A name of a folder for each submission: its own, but for signs that some system forbids; no two are the same, in capitals or not.
pub fn folder_names(marks: &[Marks]) -> Vec<String> {
    names(marks.iter().map(|marks| marks.name.as_str()))
}

fn names<'a>(names: impl Iterator<Item = &'a str>) -> Vec<String> {
    let mut taken = HashSet::new();
    let mut free = |name: &str| {
        let plain = plain(name);
        let numbered = (2..).map(|number| format!("{plain} ({number})"));
        let free = std::iter::once(plain.clone()).chain(numbered).find(|name| taken.insert(name.to_lowercase()));
        free.unwrap_or_default()
    };
    names.map(&mut free).collect()
}

fn plain(name: &str) -> String {
    let is_forbidden = |c: char| {
        c.is_control()
            || matches!(c, '/' | '\\' | ':' | '*' | '?' | '"' | '<' | '>' | '|' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    };
    let mut plain: String = name.chars().map(|c| if is_forbidden(c) { '_' } else { c }).collect();
    let end = (0..=LONGEST_BYTES.min(plain.len())).rev().find(|&at| plain.is_char_boundary(at)).unwrap_or(0);
    plain.truncate(end);
    let end = plain.trim_end_matches(['.', ' ']).len();
    plain.truncate(end);
    if plain.is_empty() || plain.starts_with('.') || is_device(&plain) {
        plain.insert(0, '_');
    }
    plain
}

/// Whether Windows takes a name for a device: `NUL`, `com1.txt`.
fn is_device(name: &str) -> bool {
    let stem = name.split('.').next().unwrap_or_default().trim_end().to_ascii_lowercase();
    let is_numbered = |start: &str| {
        stem.strip_prefix(start).is_some_and(|rest| rest.len() == 1 && rest.bytes().all(|byte| byte.is_ascii_digit()))
    };
    ["con", "prn", "aux", "nul"].contains(&stem.as_str()) || is_numbered("com") || is_numbered("lpt")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_every_system_takes() {
        let long = "가".repeat(100);
        let given =
            ["ann", "Ann", "a/b.txt", "a_b.txt", "..", "", "nul.txt", "x. ", "김\u{202e}민지", "com10", long.as_str()];
        let short = "가".repeat(66);
        let expected =
            ["ann", "Ann (2)", "a_b.txt", "a_b.txt (2)", "_", "_ (2)", "_nul.txt", "x", "김_민지", "com10", &short];
        assert_eq!(names(given.into_iter()), expected);
    }
}
