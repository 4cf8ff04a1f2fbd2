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

/// Sentences that the catalogue has in each of their forms, or as a part of longer ones.
const IN_PARTS: [&str; 4] = [
    "Read as text: {}{}.",
    "What it held before is in {}.",
    "Keys at their own times {} at {} s.",
    "The path of the chosen node is {}.",
];

/// What the editor says that is no refusal, and what undo calls its steps.
#[test]
fn what_the_editor_says_is_said_in_korean() {
    let korean = Words::new(Language::Korean);
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/editor");
    let mut missing = Vec::new();
    let mut count = 0;
    for name in ["apply.rs", "files.rs", "playing.rs", "timeline.rs", "view.rs"] {
        let text = fs::read_to_string(root.join(name)).unwrap();
        let code = code(&text);
        for (before, said) in texts(&code) {
            let is_label = ["record(", "rearrange(", "show_keyframe(", "insert_after_hand(", "delete_keyframes("]
                .iter()
                .any(|call| before.ends_with(call));
            let is_sentence = said.ends_with('.') && is_words(&said);
            if is_label || is_sentence {
                count += 1;
                let key = plain_holes(&said);
                // Where we are is said first, and is a sentence of its own.
                let whole = key.replacen("{}", "Keyframe {} ({} to {})", 1);
                let is_known = korean.knows(&key)
                    || korean.knows(&whole)
                    || korean.message(&said) != said
                    || IN_PARTS.contains(&key.as_str());
                if !is_known {
                    missing.push(format!("{name}: {key}"));
                }
            }
        }
    }
    assert!(count > 60, "only {count} are found");
    assert!(missing.is_empty(), "words/ko.rs lacks {missing:#?}");
}

/// The code of a source without comments, attributes' reasons and unit tests.
fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]").next().unwrap_or_default();
    let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    lines.collect::<Vec<_>>().join("\n")
}

/// Every text of some code, with what stands before it.
fn texts(code: &str) -> Vec<(&str, String)> {
    let mut found = Vec::new();
    let mut rest = 0;
    while let Some(at) = code[rest..].find('"').map(|at| rest + at) {
        // A character, not a text.
        if code[..at].ends_with('\'') && code[at + 1..].starts_with('\'') {
            rest = at + 1;
            continue;
        }
        let body = &code[at + 1..];
        let mut is_escaped = false;
        let end = body.find(|letter| {
            let ends = letter == '"' && !is_escaped;
            is_escaped = letter == '\\' && !is_escaped;
            ends
        });
        let Some(end) = end else { break };
        // A line that goes on.
        let said = body[..end].split("\\\n").map(str::trim_start).collect::<String>().replace("\\\"", "\"");
        found.push((code[..at].trim_end(), said));
        rest = at + 1 + end + 1;
    }
    found
}

/// Whether a text is words for people: names of things within the program are one word in small letters.
fn is_words(said: &str) -> bool {
    let plain = plain_holes(said).replace("{}", "");
    let has_word = plain.split(|letter: char| !letter.is_ascii_alphabetic()).any(|word| word.len() >= 3);
    has_word && (plain.trim().contains(' ') || plain.starts_with(|letter: char| letter.is_ascii_uppercase()))
}

/// What takes texts that nobody reads.
const UNREAD: [&str; 12] = [
    "Id::unique(",
    ".with(",
    ".with((",
    "Panel::top(",
    "Panel::bottom(",
    "Grid::new(",
    "from_id_salt(",
    ".expect(",
    "reason =",
    "load_texture(",
    "write!(formatter,",
    "push_id(",
];
/// What shows texts, which the catalogue must have been asked for.
const SHOWN: [&str; 10] = [
    "label(",
    "RichText::new(",
    "Button::new(",
    "on_hover_text(",
    "menu_button(",
    "hint_text(",
    "suffix(",
    "heading(",
    "true,",
    "text(",
];
/// Names that are the same in every language: of programs, of formats, of keys on the keyboard.
const NAMES: [&str; 4] = ["Inbetween", "GIF", "APNG", "Delete"];

/// What bypasses the catalogue in some code.
fn bypassing(text: &str) -> Vec<String> {
    let korean = Words::new(Language::Korean);
    let code = code(text);
    let is_bypass = |(before, said): &(&str, String)| {
        let ends = |all: &[&str]| all.iter().any(|end| before.ends_with(end));
        let is_asked = ends(&["say(", "fill("]);
        let is_known = korean.knows(said) || korean.knows(&plain_holes(said)) || NAMES.contains(&said.as_str());
        is_words(said) && !is_asked && !ends(&UNREAD) && (ends(&SHOWN) || !is_known)
    };
    texts(&code).into_iter().filter(is_bypass).map(|(_, said)| said).collect()
}

#[test]
fn no_words_bypass_the_catalogue() {
    let mut sources = Vec::new();
    walk(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src/ui"), &mut sources);
    let mut found = Vec::new();
    for (name, text) in sources.iter().filter(|(name, _)| !name.contains("words")) {
        found.extend(bypassing(text).into_iter().map(|said| format!("{name}: {said}")));
    }
    assert!(found.is_empty(), "said without the catalogue: {found:#?}");
}

#[test]
fn what_bypasses_the_catalogue_is_found() {
    for (source, is_found) in [
        ("ui.label(\"New keyframe\");", true),
        ("ui.label(words.say(\"New keyframe\"));", false),
        ("let text = format!(\"{place} of a thing\");", true),
        ("words.fill(\n    \"Keyframe {}\", &[place])", false),
        ("// \"Not Korean at all\"", false),
        ("let id = ui.id().with(\"name of a thing\");", false),
        ("const NAME: &str = \"Nobody knows this\";", true),
        ("const NAME: &str = \"New keyframe\";", false),
        ("let tracks = \"tracks\";", false),
    ] {
        assert_eq!(!bypassing(source).is_empty(), is_found, "{source}");
    }
}
