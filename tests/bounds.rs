//! The bounds of documents and files: what an editor can hold, its files can hold and its readers read.

mod common;

use std::thread;

use common::editor;
use inbetween::editor::{Command, Edit, Editor, SceneEdit};
use inbetween::scene::{MOST_LEVELS, SceneError, SceneGraph, scene_from_json, scene_to_json};

/// A scene file with nodes below each other.
fn chain(levels: usize) -> String {
    let begin: String = (1..=levels).map(|level| format!(r#"{{"name": "n{level}", "children": ["#)).collect();
    let nodes = begin + &"]}".repeat(levels);
    format!(r#"{{"format": "inbetween.scene", "version": 1, "name": "chain", "eyes": ["n1"], "nodes": [{nodes}]}}"#)
}

/// Reads and writes a scene in a thread with a small stack.
fn read_with_little_room(text: String) -> Result<SceneGraph, SceneError> {
    let read = move || {
        let scene = scene_from_json(&text)?;
        assert_eq!(scene_from_json(&scene_to_json(&scene))?, scene);
        Ok(scene)
    };
    thread::Builder::new().stack_size(SMALL_STACK).spawn(read).unwrap().join().unwrap()
}

/// What some systems give threads that are not the main one.
const SMALL_STACK: usize = 512 << 10;

#[test]
fn scenes_are_read_and_written_up_to_the_bound_of_levels() {
    for levels in [1, 59, 61, 200, MOST_LEVELS] {
        assert_eq!(read_with_little_room(chain(levels)).unwrap().nodes().len(), levels);
    }
    let error = read_with_little_room(chain(MOST_LEVELS + 1)).unwrap_err();
    assert!(matches!(error, SceneError::TooDeep { .. }), "{error}");
    assert!(error.to_string().ends_with("is too deep: a scene has at most 256 levels of nodes"), "{error}");
}

#[test]
fn brackets_without_end_are_one_sentence_with_their_place() {
    for text in [chain(100_000), r#"{"nodes": "#.to_owned() + &r#"[{"children": "#.repeat(600)] {
        let error = read_with_little_room(text).unwrap_err().to_string();
        let column = error.strip_prefix("brackets within each other are more than 520 levels deep at line 1 column ");
        assert!(column.unwrap_or_else(|| panic!("{error}")).parse::<usize>().is_ok(), "{error}");
    }
    // The reader of settings, as one of those that need no depth.
    let text = r#"{"format": "inbetween.settings", "version": 1, "panels": "#.to_owned() + &"[".repeat(1000);
    let error = inbetween::settings::Settings::from_json(text.as_bytes()).unwrap_err().to_string();
    assert!(!error.contains("recursion"), "{error}");
}

#[test]
fn no_control_node_makes_a_scene_too_deep() {
    let mut editor = editor();
    let put =
        |editor: &mut Editor| editor.apply(Command::Edit(Edit::Scene(SceneEdit::PutControlAbove("robot1".into()))));
    // Below robot 1 there are two levels of joints and their shapes.
    let mut count = 0;
    let refused = loop {
        match put(&mut editor) {
            Ok(_) => count += 1,
            Err(error) => break error.to_string(),
        }
        assert!(count <= MOST_LEVELS);
    };
    assert!(refused.contains("a scene has at most 256 levels of nodes"), "{refused}");
    assert_eq!(count, MOST_LEVELS - 4);
    assert_eq!(&scene_from_json(&scene_to_json(editor.scene())).unwrap(), &**editor.scene());
}
