//! The README says what the program does: its block of keys is the table's, and its example scene reads.

use std::fs;
use std::path::PathBuf;

use inbetween::editor::keymap;
use inbetween::scene::scene_from_json;
use inbetween::script::markdown as script_lines;

fn path() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("README.md")
}

/// The README's block of this name is what was made.
#[track_caller]
fn check(text: &str, name: &str, made: &str) -> String {
    let (begin, end) = (format!("<!-- {name}: begin -->\n"), format!("<!-- {name}: end -->"));
    let (before, rest) = text.split_once(&begin).expect("the block begins");
    let (block, after) = rest.split_once(&end).expect("the block ends");
    if std::env::var_os("UPDATE_GOLDENS").is_none() {
        assert_eq!(block, made, "the {name} have changed: UPDATE_GOLDENS=1 cargo test --test readme");
    }
    format!("{before}{begin}{made}{end}{after}")
}

#[test]
fn the_blocks_of_keys_and_of_script_lines_are_made_from_the_tables() {
    let text = fs::read_to_string(path()).expect("the README");
    let made = check(&text, "keys", &keymap::markdown());
    let made = check(&made, "lines", &script_lines());
    if made != text {
        fs::write(path(), made).expect("the README can be written");
    }
}

#[test]
fn the_example_scene_reads() {
    let text = fs::read_to_string(path()).expect("the README");
    let example = text
        .split("```json\n")
        .skip(1)
        .map(|block| block.split("```").next().unwrap_or_default())
        .find(|block| block.contains("inbetween.scene"))
        .expect("an example of a scene file");
    let scene = scene_from_json(example).unwrap_or_else(|error| panic!("{error}"));
    assert!(scene.is_timed());
}
