use std::collections::HashSet;
use std::fs;
use std::path::Path;

use super::*;
use crate::editor::keymap::{Group, bindings};
use crate::ui::theme;

const KOREAN: Words = Words::new(Language::Korean);

#[test]
fn sentences_are_filled() {
    assert_eq!(fill("{} of {}", &["a", "b"]), "a of b");
    assert_eq!(fill("{1} of {0}", &["a", "b"]), "b of a");
    assert_eq!(holes("Keyframe {} ({} to {})", "Keyframe 3 (0 to 5)"), Some(vec!["3", "0", "5"]));
    assert_eq!(holes("Keyframe {}", "Keyframe "), None);
    assert_eq!(holes("Keyframe", "Keyframe"), None);
}

#[test]
fn english_is_itself() {
    assert_eq!(Words::default().say("New keyframe"), "New keyframe");
    assert_eq!(Words::default().message("Keyframe 3 (0 to 5): updated from the scene."), "Keyframe 3 (0 to 5): updated from the scene.");
}

#[test]
fn what_the_editor_says_is_said_in_korean() {
    assert_eq!(KOREAN.message("Keyframe 3 (0 to 5)"), "키프레임 3 (0–5)");
    assert_eq!(
        KOREAN.message("Keyframe 3 (0 to 5): created after keyframe 2."),
        "키프레임 3 (0–5): 키프레임 2 다음에 만들었습니다."
    );
    assert_eq!(KOREAN.message("Deleted keyframe 2. No keyframes."), "키프레임 2 삭제. 키프레임 없음.");
}

fn walk(folder: &Path, texts: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            walk(&path, texts);
        } else if !path.ends_with("words/tests.rs") {
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
    let mut missing: Vec<String> = keys()
        .into_iter()
        .filter(|key| KOREAN.entry(key).is_none() && key.chars().any(|letter| letter.is_ascii_alphabetic()))
        .collect();
    missing.sort();
    assert!(missing.is_empty(), "words/ko.rs lacks {missing:#?}");
}

#[test]
fn holes_are_as_many_in_both_languages() {
    let mut seen = HashSet::new();
    for (english, korean) in ko::WORDS {
        assert!(seen.insert(english), "{english} stands twice");
        assert_eq!(english.matches('{').count(), korean.matches('{').count(), "{english}: {korean}");
        assert!(!korean.is_empty());
    }
}

#[test]
fn every_korean_letter_is_in_the_fonts() {
    let context = Context::default();
    theme::install(&context);
    let mut output = context.run_ui(egui::RawInput::default(), |_| {});
    output.textures_delta.clear();
    let text: String = ko::WORDS.iter().flat_map(|(_, korean)| korean.chars()).chain(Language::Korean.name().chars()).collect();
    for font in [theme::text_font(), theme::number_font()] {
        for letter in text.chars() {
            let has = context.fonts_mut(|fonts| fonts.has_glyph(&font, letter));
            assert!(has, "no font has {letter}");
        }
        // The most frequent syllables, which file names are made of, and letters on their own.
        for letter in "가각힘힝글ㄱㅎㅏㅣ".chars() {
            let has = context.fonts_mut(|fonts| fonts.has_glyph(&font, letter));
            assert!(has, "no font has {letter}");
        }
    }
}
