//! Every word of the window is in the catalogue, in every language: the sources are read for what they say.

use std::collections::HashSet;
use std::fs;
use std::path::Path;

use inbetween::editor::keymap::{Group, bindings};
use inbetween::settings::Language;
use inbetween::ui::words::Words;

fn walk(folder: &Path, texts: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            walk(&path, texts);
        } else {
            texts.push((path.display().to_string(), fs::read_to_string(&path).unwrap()));
        }
    }
}

/// The texts that stand right after some words of the sources.
fn literals(text: &str, before: &str) -> Vec<String> {
    text.split(before)
        .skip(1)
        .filter_map(|rest| {
            let rest = rest.trim_start().strip_prefix('"')?;
            let mut said = String::new();
            let mut characters = rest.chars();
            loop {
                match characters.next()? {
                    '"' => return Some(said),
                    '\\' => match characters.next()? {
                        // A line that goes on.
                        '\n' => {
                            let rest = characters.as_str().trim_start();
                            characters = rest.chars();
                        }
                        other => said.push(other),
                    },
                    other => said.push(other),
                }
            }
        })
        .collect()
}

/// Everything that the window says by the catalogue.
fn keys() -> HashSet<String> {
    let mut keys: HashSet<String> = HashSet::new();
    for binding in bindings() {
        keys.extend([binding.name.to_owned(), binding.help.to_owned()]);
    }
    keys.extend(Group::ALL.map(|group| group.heading().to_owned()));
    let mut texts = Vec::new();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    walk(&root.join("ui"), &mut texts);
    walk(&root.join("window"), &mut texts);
    for (_, text) in &texts {
        for before in [".say(", ".fill("] {
            keys.extend(literals(text, before));
        }
    }
    for place in ["editor/error.rs", "editor/keymap/changes.rs"] {
        let errors = fs::read_to_string(root.join(place)).unwrap();
        keys.extend(literals(&errors, "#[error(").iter().map(|text| plain_holes(text)));
    }
    keys
}

/// `{what}` and such as `{}`.
fn plain_holes(text: &str) -> String {
    let mut plain = String::new();
    let mut is_hole = false;
    for character in text.chars() {
        match character {
            '{' => is_hole = true,
            '}' => {
                is_hole = false;
                plain.push_str("{}");
            }
            _ if is_hole => {}
            other => plain.push(other),
        }
    }
    plain
}

#[test]
fn every_key_is_said_in_korean() {
    let korean = Words::new(Language::Korean);
    let mut missing: Vec<String> = keys()
        .into_iter()
        .filter(|key| !korean.knows(key) && key.chars().any(|letter| letter.is_ascii_alphabetic()))
        .collect();
    missing.sort();
    assert!(missing.is_empty(), "words/ko.rs lacks {missing:#?}");
}
