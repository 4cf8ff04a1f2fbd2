//! The bounds of documents and files: what an editor can hold, its files can hold and its readers read.

mod common;

use std::thread;

use common::{editor, press};
use inbetween::editor::{Command, Edit, Editor, SceneEdit, TimelineEdit};
use inbetween::keyframe::{KeyframeIndex, LARGEST_FILE_BYTES, file_bytes_at_most};
use inbetween::scene::{LARGEST_SCENE_BYTES, MOST_LEVELS, SceneError, SceneGraph, scene_from_json, scene_to_json};

/// A scene file with nodes below each other.
fn chain(levels: usize) -> String {
    let begin: Vec<String> = (1..=levels).map(|level| format!(r#"{{"name": "n{level}", "children": ["#)).collect();
    let nodes = begin.concat() + &"]}".repeat(levels);
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
        let place = error.strip_suffix(": brackets within each other are more than 520 levels deep");
        let column = place.and_then(|place| place.strip_prefix("line 1 column "));
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

#[test]
fn no_list_grows_beyond_the_files_that_are_read() {
    let mut editor = editor();
    press(&mut editor, "n");
    let command = |edit| Command::Edit(Edit::Timeline(edit));
    let too_large = "The keyframe file could become larger than 1024 MiB, the most that is read. Nothing was changed.";
    let refused = loop {
        // All copies share one pose, so that this takes little memory.
        let all = (0..editor.document().keyframes.len()).map(KeyframeIndex::new).collect();
        editor.apply(Command::Selection(inbetween::editor::SelectionCommand::Keyframes(all))).unwrap();
        if let Err(error) = editor.apply(command(TimelineEdit::DuplicateKeyframes)) {
            break error.to_string();
        }
        assert!(file_bytes_at_most(editor.scene(), &editor.document().keyframes) <= LARGEST_FILE_BYTES);
    };
    assert_eq!(refused, too_large);
    let count = editor.document().keyframes.len();
    assert_eq!(count, 1 << 18);
    editor.apply(Command::Clipboard(inbetween::editor::ClipboardCommand::CopyKeyframes)).unwrap();
    let pasted = editor.apply(command(TimelineEdit::PasteKeyframes)).unwrap_err().to_string();
    assert_eq!((pasted.as_str(), editor.document().keyframes.len()), (too_large, count));
    // One more has room, and what makes the list shorter is always possible.
    press(&mut editor, "n d");
    assert_eq!(editor.document().keyframes.len(), count);
}

#[test]
fn no_scene_grows_beyond_the_files_that_are_read() {
    let mut editor = editor();
    let edit = |edit| Command::Edit(Edit::Scene(edit));
    editor.apply(edit(SceneEdit::PutControlAbove("robot1".into()))).unwrap();
    let renamed = |bytes| edit(SceneEdit::RenameControl("robot1_control".into(), "n".repeat(bytes)));
    let error = editor.apply(renamed(LARGEST_SCENE_BYTES as usize / 6)).unwrap_err().to_string();
    assert_eq!(error, "The scene file could become larger than 256 MiB, the most that is read. Nothing was changed.");
    assert!(editor.scene().find("robot1_control").is_some());
    editor.apply(renamed(1000)).unwrap();
}
