//! The corpus: scripts and bad files with what the program said about them, to the byte.
//!
//! `scripts.txt`, `files.txt` and `programs.txt` hold the cases that are written by hand; `random.rs` makes more from seeds. What each
//! case must leave stands in `expected-scripts.txt`, `expected-files.txt`, `expected-programs.txt` and `expected-library.txt`: exit status, standard output, standard error, and
//! the SHA-256 of every file written. Each message of `en.txt` and each sentence of `messages.txt` must occur at least once.
//!
//! To record the expectations anew: `UPDATE_CORPUS=1 cargo test --test corpus`. `CORPUS_BINARY=PATH` runs another binary than the one
//! under test, for instance one built before a change.
//!
//! The texts of the operating system's errors are Linux's, so the corpus runs there only.

#![cfg(target_os = "linux")]
#![allow(clippy::format_collect, reason = "these texts are short")]

mod bases;
mod cases;
mod library;
mod messages;
mod models;
mod other_files;
mod random;
#[path = "../common/random_numbers.rs"]
mod random_numbers;
mod run;
#[path = "../student/mod.rs"]
mod student;
mod trace;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use cases::Case;
use run::Shared;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus")
}

fn text(name: &str) -> String {
    std::fs::read_to_string(folder().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn is_update() -> bool {
    std::env::var_os("UPDATE_CORPUS").is_some()
}

/// The sections of an expectation file by their case's name.
fn sections(text: &str) -> BTreeMap<&str, &str> {
    text.split("=== ").skip(1).filter_map(|section| section.split_once('\n')).collect()
}

/// A repeated sentence of a drag, which is marked with `~`, counts as nothing said. See `trace.rs`.
fn without_repeats(section: &str) -> String {
    let lines = section.lines().map(|line| match line.split_once('\t') {
        Some((place, said)) if said.starts_with('~') => format!("{place}\t\n"),
        _ => format!("{line}\n"),
    });
    lines.collect()
}

/// Runs the cases and compares them with the expectations, or records them.
fn check(cases: &[Case], name: &str) {
    let shared = Shared::new();
    let found = run::all(cases, &shared);
    check_sections(&found, name);
}

fn check_sections(found: &[(String, String)], name: &str) {
    if is_update() {
        let text: Vec<String> = found.iter().map(|(case, section)| format!("=== {case}\n{section}")).collect();
        std::fs::write(folder().join(name), text.concat()).unwrap();
        return;
    }
    let expected = text(name);
    let mut expected = sections(&expected);
    let mut differences = Vec::new();
    for (case, section) in found {
        let wanted = expected.remove(case.as_str()).unwrap_or_else(|| panic!("{case} is not in {name}"));
        let (section, wanted) = (without_repeats(section), without_repeats(wanted));
        if section != wanted {
            let first = section.lines().zip(wanted.lines()).find(|(a, b)| a != b);
            differences.push(format!("{case}: found, and expected, first at\n{first:?}\nof\n{section}"));
        }
    }
    assert!(expected.is_empty(), "{name} has cases that nothing makes: {:?}", expected.keys());
    assert!(differences.is_empty(), "{} cases differ:\n{}", differences.len(), differences.join("\n"));
}

/// The scripts written by hand and those made from seeds.
fn scripts() -> Vec<Case> {
    let mut cases = cases::scripts(&text("scripts.txt"));
    cases.extend(random::scripts());
    cases
}

/// The bad files written by hand and those made from seeds.
fn files() -> Vec<Case> {
    let mut cases = cases::files(&text("files.txt"));
    cases.extend(random::files());
    cases
}

#[test]
fn scripts_leave_the_same_traces() {
    let scripts = scripts();
    assert!(scripts.len() >= 300, "{} scripts", scripts.len());
    check(&scripts, "expected-scripts.txt");
}

#[test]
fn bad_files_give_the_same_sentences() {
    let files = files();
    assert!(files.len() >= 300, "{} files", files.len());
    check(&files, "expected-files.txt");
}

#[test]
fn whole_commands_say_the_same() {
    check(&cases::programs(&text("programs.txt")), "expected-programs.txt");
}

#[test]
fn the_library_says_the_same_of_what_no_command_line_reaches() {
    check_sections(
        &[
            ("editor".to_owned(), library::editor()),
            ("keymap".to_owned(), library::keymap()),
            ("window and failures".to_owned(), library::window_and_failures()),
            ("files of other programs".to_owned(), other_files::said()),
        ],
        "expected-library.txt",
    );
}

#[test]
fn every_message_occurs() {
    if is_update() {
        // The other tests are writing what this one reads.
        return;
    }
    let said: Vec<String> =
        ["expected-scripts.txt", "expected-files.txt", "expected-programs.txt", "expected-library.txt"]
            .into_iter()
            .flat_map(|name| messages::said(&text(name)))
            .collect();
    let list = text("messages.txt");
    let without_id = messages::patterns(&list).map(|pattern| (pattern, pattern.to_owned()));
    let all: Vec<(&str, String)> =
        messages::of_english(include_str!("../../assets/words/en.txt")).into_iter().chain(without_id).collect();
    assert!(all.len() > 500, "{} messages", all.len());
    let occurs = |pattern: &str| said.iter().any(|line| messages::occurs(pattern, line));
    let missing: Vec<&str> = all.iter().filter(|(_, pattern)| !occurs(pattern)).map(|(name, _)| *name).collect();
    assert!(missing.is_empty(), "{} of {} messages do not occur:\n{}", missing.len(), all.len(), missing.join("\n"));
}

/// Words of Rust and of the libraries that read files.
const FOREIGN: [&str; 21] = [
    "invalid type",
    "invalid value:",
    "invalid length",
    "unknown variant",
    "missing field",
    "duplicate field",
    "did not match any variant",
    "recursion limit",
    "trailing characters",
    "trailing comma",
    "EOF while",
    "key must be a string",
    "expected ident",
    "expected value",
    "expected struct",
    "expected a sequence",
    "expected a map",
    "expected one of `",
    "usize",
    "(os error",
    "panicked at",
];

#[test]
fn no_word_of_rust_or_its_libraries_is_said() {
    for name in ["expected-scripts.txt", "expected-files.txt", "expected-library.txt"] {
        for line in text(name).lines() {
            let is_type = |word: &str| matches!(word, "u8" | "u16" | "u32" | "u64" | "i32" | "i64" | "f32" | "f64");
            let has_type = line.split(|character: char| !character.is_ascii_alphanumeric()).any(is_type);
            let foreign = FOREIGN.iter().find(|word| line.contains(**word));
            assert!(foreign.is_none() && !has_type, "{name}: {line}");
        }
    }
}
