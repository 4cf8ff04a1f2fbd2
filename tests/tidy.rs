//! The architecture's rules, checked by reading the sources.

use std::fs;
use std::path::{Path, PathBuf};

fn sources() -> Vec<(String, String)> {
    fn walk(folder: &Path, found: &mut Vec<PathBuf>) {
        for entry in fs::read_dir(folder).expect("src is a folder") {
            let path = entry.expect("it can be read").path();
            if path.is_dir() {
                walk(&path, found);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                found.push(path);
            }
        }
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut found = Vec::new();
    walk(&root, &mut found);
    found.sort();
    assert!(found.len() > 20);
    found
        .into_iter()
        .map(|path| {
            let name = path.strip_prefix(&root).unwrap().to_string_lossy().replace('\\', "/");
            (name, fs::read_to_string(&path).expect("sources are text"))
        })
        .collect()
}

/// The code of a source, without comments and without its unit tests.
fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]").next().unwrap_or_default();
    text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n")
}

/// The room that a source belongs to: its module of the top level.
fn room(name: &str) -> &str {
    name.split('/').next().unwrap().trim_end_matches(".rs")
}

fn names(code: &str, word: &str) -> bool {
    code.match_indices(word).any(|(at, _)| {
        let before = code[..at].chars().next_back();
        let after = code[at + word.len()..].chars().next();
        let is_part = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
        !is_part(before) && !is_part(after)
    })
}

#[track_caller]
fn only(words: &[&str], allowed: &[&str]) {
    for (name, text) in sources() {
        let code = code(&text);
        for word in words {
            assert!(
                allowed.contains(&room(&name)) || !names(&code, word),
                "src/{name} names {word}, which only {allowed:?} may"
            );
        }
    }
}

#[test]
fn only_the_window_names_winit() {
    only(&["winit", "egui_winit"], &["window"]);
}

#[test]
fn only_render_and_window_name_wgpu() {
    only(&["wgpu", "egui_wgpu"], &["render", "window"]);
}

#[test]
fn only_ui_and_window_name_egui() {
    only(&["egui"], &["ui", "window"]);
}

#[test]
fn only_storage_touches_the_file_system() {
    only(&["std::fs", "fs::read", "fs::write", "File::open", "File::create"], &["storage"]);
}

#[test]
fn only_the_command_line_names_clap() {
    only(&["clap"], &["cli"]);
}

#[test]
fn the_wall_clock_is_read_in_one_function_each() {
    only(&["Instant", "SystemTime"], &["window", "cli"]);
    for room_name in ["window", "cli"] {
        let readings: usize = sources()
            .iter()
            .filter(|(name, _)| room(name) == room_name)
            .map(|(_, text)| code(text).matches("Instant::now()").count())
            .sum();
        assert!(readings <= 1, "{room_name} reads the clock in {readings} places");
    }
}

#[test]
fn no_shared_mutable_state() {
    only(&["Rc", "RefCell", "static mut", "thread_local", "lazy_static", "Mutex<Editor>"], &[]);
}

/// Rooms in the order of the architecture: each may name only rooms of a lower number, and itself.
const ROOMS: &[(&str, u8, &[&str])] = &[
    ("rbt", 0, &[]),
    ("timed", 1, &[]),
    ("interpolation", 0, &["rbt"]),
    ("pose", 1, &[]),
    ("blend", 1, &["pose"]),
    ("scene", 1, &["pose", "blend", "json", "timed"]),
    ("camera", 1, &["scene"]),
    ("json", 0, &["rbt"]),
    ("manual", 0, &[]),
    ("keyframe", 2, &[]),
    ("clock", 2, &[]),
    ("settings", 2, &[]),
    ("text_layouts", 2, &["keyframe"]),
    ("editor", 3, &[]),
    ("diagnosis", 3, &[]),
    ("difference", 3, &[]),
    ("frame", 4, &[]),
    ("render", 5, &[]),
    ("ui", 5, &[]),
    ("compare", 6, &[]),
    ("film", 6, &[]),
    ("storage", 6, &[]),
    ("export", 7, &[]),
    ("window", 8, &[]),
    ("cli", 8, &["window"]),
    ("main", 9, &[]),
    ("lib", 9, &[]),
];

#[test]
fn modules_import_only_from_below() {
    for (name, text) in sources() {
        let room = room(&name);
        let Some((_, level, peers)) = ROOMS.iter().find(|(known, ..)| *known == room) else {
            panic!("src/{name} is in a room that the architecture does not know: {room}");
        };
        for (other, other_level, _) in ROOMS {
            let is_named = code(&text).contains(&format!("crate::{other}::"));
            let is_below = other_level < level || other == &room || peers.contains(other);
            assert!(!is_named || is_below, "src/{name} imports from {other}, which is not below it");
        }
    }
}

#[test]
fn render_can_draw_whatever_there_is() {
    for (name, text) in sources().iter().filter(|(name, _)| room(name) == "render") {
        assert!(!names(&code(text), "editor") && !names(&code(text), "ui"), "src/{name} names the editor or the ui");
    }
}

#[test]
fn files_are_one_idea_each() {
    for (name, text) in sources() {
        let lines = text.lines().count();
        assert!(lines <= 600, "src/{name} has {lines} lines, and none has more than 600");
    }
}

#[test]
fn unwrap_is_for_tests() {
    for (name, text) in sources().iter().filter(|(name, _)| !name.ends_with("tests.rs")) {
        let code = code(text);
        for word in [".unwrap()", "todo!(", "unimplemented!(", "dbg!("] {
            assert!(!code.contains(word), "src/{name} has {word}");
        }
    }
}

#[test]
fn every_module_opens_with_what_it_is() {
    for (name, text) in sources() {
        assert!(text.starts_with("//!"), "src/{name} does not say what it is");
    }
}

#[test]
fn no_test_is_switched_off() {
    for (name, text) in sources() {
        assert!(!text.contains(concat!("#[", "ignore")), "src/{name} switches a test off");
    }
}
