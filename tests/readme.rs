//! The README says what the program does: its block of keys is the table's, and its example scene reads.

use std::fs;
use std::path::PathBuf;

use inbetween::editor::keymap;
use inbetween::scene::scene_from_json;

const BEGIN: &str = "<!-- keys: begin -->\n";
const END: &str = "<!-- keys: end -->";

fn path() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("README.md")
}

#[test]
fn the_block_of_keys_is_made_from_the_table() {
    let text = fs::read_to_string(path()).expect("the README");
    let (before, rest) = text.split_once(BEGIN).expect("the block begins");
    let (block, after) = rest.split_once(END).expect("the block ends");
    let made = keymap::markdown();
    if std::env::var_os("UPDATE_GOLDENS").is_some() {
        fs::write(path(), format!("{before}{BEGIN}{made}{END}{after}")).expect("the README can be written");
    } else {
        assert_eq!(block, made, "the keys have changed: UPDATE_GOLDENS=1 cargo test --test readme");
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
