//! The table as a whole.

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::Arc;

use super::*;
use crate::editor::keymap::bindings;
use crate::editor::{Edit, PlaybackCommand};

fn editor(keyframes: usize) -> Editor {
    let mut editor = Editor::new(
        Arc::new(crate::scene::built_in_scene(crate::scene::DEFAULT_SCENE).unwrap()),
        PathBuf::from("animation.json"),
    );
    for _ in 0..keyframes {
        editor.apply(Command::Edit(Edit::CreateKeyframe)).unwrap();
    }
    editor
}

#[test]
fn what_is_refused_is_shown_as_disabled() {
    let mut playing = editor(4);
    playing.apply(Command::Playback(PlaybackCommand::PlayOrStop)).unwrap();
    for editor in [editor(0), editor(1), editor(4), playing] {
        for binding in bindings() {
            let is_refused = editor.clone().apply(binding.command.clone()).is_err();
            assert!(!(is_refused && editor.can(&binding.command)), "{} is refused but not disabled", binding.id);
        }
    }
}

#[test]
fn ids_are_kebab_case_and_each_is_of_one_row() {
    let mut seen = BTreeSet::new();
    for row in rows() {
        let others = row.bindings.iter().map(|binding| binding.id).filter(|id| *id != row.id);
        for id in others.chain([row.id]) {
            assert!(seen.insert(id), "{id} stands twice");
            assert!(id.chars().all(|c| c.is_ascii_lowercase() || c == '-') && !id.starts_with('-'), "{id}");
        }
    }
}

#[test]
fn what_is_bound_is_of_its_row_alone() {
    for row in rows() {
        for binding in &row.bindings {
            let owners: Vec<&str> = rows().iter().filter(|row| row.owns(&binding.command)).map(|row| row.id).collect();
            assert_eq!(owners, [row.id]);
        }
    }
}

#[test]
fn first_words_of_lines_are_one_line_each() {
    let names: Vec<&str> = lines().map(|line| line.name).collect();
    assert_eq!(names.iter().collect::<BTreeSet<_>>().len(), names.len(), "{names:?}");
    for line in lines() {
        assert!(line.usage.starts_with(line.name) && !line.does.is_empty(), "{}", line.usage);
    }
}

#[test]
fn what_changes_the_document_or_the_session_can_be_written() {
    for row in rows().iter().filter(|row| matches!(row.changes, Changes::Document | Changes::Session)) {
        assert!(!row.lines.is_empty() || !row.bindings.is_empty(), "{} has no line and no binding", row.id);
    }
}
