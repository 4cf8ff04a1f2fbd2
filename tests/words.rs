//! Messages in every language: of commands, and of what the editor refuses.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use inbetween::editor::keymap::bindings;
use inbetween::editor::{Command, Edit, Editor, FileCommand, GestureCommand, Severity, ViewCommand};
use inbetween::rbt::Rbt;
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use inbetween::ui::words::Words;
use inbetween::words::{Language, Message, Phrase, texts};

fn editor() -> Editor {
    Editor::new(Arc::new(built_in_scene(DEFAULT_SCENE).unwrap()), PathBuf::from("animation.json"))
}

fn korean() -> Words {
    Words::new(Language::of_code("ko").unwrap())
}

#[test]
fn every_command_has_a_name_and_a_help() {
    for binding in bindings() {
        for id in [format!("command.{}", binding.id), format!("command.{}.help", binding.id)] {
            assert!(Phrase::of_id(&id).is_some(), "{id}");
        }
        assert!(!binding.title().english().is_empty() && !binding.explanation().english().is_empty(), "{}", binding.id);
    }
}

/// What the editor says of a file that cannot be imported.
fn import(bytes: &[u8]) -> Message {
    let mut editor = editor();
    editor.keyframes_read(Path::new("걷기.json"), Ok(bytes.to_vec())).unwrap_err();
    let message = editor.message().unwrap().clone();
    assert_eq!((message.severity(), editor.status()), (Severity::Error, Some(&message)));
    message
}

/// What a Korean sentence has of Latin letters beside what it quotes: the names of files, fields and options.
const NAMES: [&str; 3] = ["json", "version", "salvage"];

#[track_caller]
fn check_korean(message: &Message, expected: &str) {
    let said = korean().message(message);
    assert!(said.contains(expected), "{said}");
    let unquoted: String = said.split(['"', '`']).step_by(2).collect();
    let words = unquoted.split(|letter: char| !letter.is_ascii_alphabetic());
    let foreign: Vec<&str> = words.filter(|word| word.len() > 1 && !NAMES.contains(word)).collect();
    assert!(foreign.is_empty(), "{said}: {foreign:?}");
}

#[test]
fn a_bad_import_is_korean_in_a_korean_window() {
    let keyframe_file =
        br#"{"format": "inbetween.keyframes", "version": 9, "scene": "x", "nodes": [], "keyframes": []}"#;
    check_korean(&import(keyframe_file), "걷기.json: version이 9입니다. 이 프로그램은 1과 2를 읽습니다");
    check_korean(&import(b""), "걷기.json: 1행 1열: 파일이 비어 있습니다. 키프레임이 있어야 합니다");
    check_korean(&import(b"1 22\n0 0 nan"), "유한하지 않습니다. 수가 있어야 합니다");
    check_korean(&import(b"1 22\n0 0 0 1 0 0 0\n"), "머리글은 노드 22개의 키프레임 1개라고 하므로");
    check_korean(&import(b"1 2 3 4 5 6 7 8"), "온전한 키프레임 0개와 숫자 8개");
    check_korean(&import(b"translate_keys = {0: vec(0, 0, 0), 0: vec(1, 1, 1)}"), "0초에 키가 또 있습니다");
    check_korean(&import(b"translate_keys = {0: vec(0, 0, 0)}"), "제어 노드의 키는 목록이 아니라");
    let mut editor = editor();
    let missing = Err(texts::STORAGE_NOT_FOUND.into());
    editor.keyframes_read(Path::new("걷기.json"), missing).unwrap_err();
    check_korean(editor.message().unwrap(), "걷기.json: 그런 파일이나 폴더가 없습니다");
}

#[test]
fn what_an_edit_says_is_korean() {
    let mut editor = editor();
    editor.apply(Command::Edit(Edit::CreateKeyframe)).unwrap();
    check_korean(editor.message().unwrap(), "키프레임 0 (0–0): 첫 키프레임을 만들었습니다.");
    editor.apply(Command::Undo).unwrap();
    check_korean(editor.message().unwrap(), "실행 취소: 새 키프레임.");
    editor.apply(Command::Edit(Edit::DeleteCurrent)).unwrap_err();
    check_korean(editor.message().unwrap(), "목록이 비어 있어 삭제할 키프레임이 없습니다.");
}

#[test]
fn movements_of_a_drag_say_nothing() {
    let mut editor = editor();
    editor.apply(Command::Edit(Edit::DeleteCurrent)).unwrap_err();
    let said = editor.said().count();
    assert_eq!(editor.status().unwrap().severity(), Severity::Error);
    let motion = Rbt::from_translation(glam::Vec3::X);
    for gesture in
        [GestureCommand::Begin, GestureCommand::Move(motion), GestureCommand::Move(motion), GestureCommand::Commit]
    {
        editor.apply(Command::Gesture(gesture)).unwrap();
        assert_eq!((editor.message(), editor.message_text().as_str()), (None, ""));
        // The beginning has the line forget what was said before.
        assert_eq!((editor.status(), editor.said().count()), (None, said));
    }
    // What else says nothing clears the line, and adds nothing to what was said.
    editor.apply(Command::View(ViewCommand::ToggleArcball)).unwrap();
    assert_eq!((editor.status(), editor.said().count()), (None, said));
    editor.apply(Command::File(FileCommand::ChooseSaveAs)).unwrap();
    assert_eq!((editor.message(), editor.said().count()), (None, said));
}

#[test]
fn what_the_end_of_a_drag_does_is_said_once() {
    let mut editor = editor();
    editor.apply(Command::Edit(Edit::CreateKeyframe)).unwrap();
    editor.apply(Command::View(ViewCommand::SetAutoKeys(true))).unwrap();
    let said = editor.said().count();
    for gesture in
        [GestureCommand::Begin, GestureCommand::Move(Rbt::from_translation(glam::Vec3::X)), GestureCommand::Commit]
    {
        editor.apply(Command::Gesture(gesture)).unwrap();
    }
    assert_eq!(editor.message_text(), "Keyframe 0 (0 to 0): updated by auto-key.");
    assert_eq!(editor.said().count(), said + 1);
}
