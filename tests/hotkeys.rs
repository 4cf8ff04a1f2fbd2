//! Hotkeys: state before, keys, state after.

mod common;

use std::path::Path;

use common::{apply, editor, editor_with, pose, press, shown};
use inbetween::editor::{
    ClipboardCommand, Command, Edit, Editor, Effect, Eye, GestureCommand, SelectionCommand, Severity, ViewCommand,
    Written,
};
use inbetween::interpolation::Interpolation;
use inbetween::keyframe::{KeyframeIndex, keyframes_to_json};
use inbetween::rbt::Rbt;
use inbetween::words::texts;

/// With `keyframes` in the list (their x is their place) and the `current` one on screen, `keys` lead to `expected`.
#[track_caller]
fn check(keyframes: usize, current: usize, keys: &str, expected: &str) -> Editor {
    let mut editor = editor_with(keyframes);
    if keyframes > 0 {
        apply(&mut editor, Command::Edit(Edit::GoTo(KeyframeIndex::new(current))));
    }
    press(&mut editor, keys);
    assert_eq!(shown(&editor), expected, "{keys:?} at {current} of {keyframes}");
    editor
}

#[test]
fn the_list_is_managed_by_single_keys() {
    check(0, 0, "n", "[-2] | -2");
    check(0, 0, "u", "[-2] | -2");
    check(3, 0, "n", "0 [0] 1 2 | 0");
    check(3, 2, "n", "0 1 2 [2] | 2");
    check(3, 0, "> >", "0 1 [2] | 2");
    check(3, 2, ">", "0 1 [2] | 2");
    check(3, 0, "<", "[0] 1 2 | 0");
    check(3, 2, "< ,", "[0] 1 2 | 0");
    check(3, 0, ". =", "0 [1] 2 | 1");
    check(3, 2, "d", "0 [1] | 1");
    check(3, 1, "d", "[0] 2 | 0");
    check(3, 0, "d", "[1] 2 | 1");
    check(1, 0, "d", " | 0");
    check(3, 1, "d d d", " | 2");
}

#[test]
fn what_cannot_be_done_says_so_and_changes_nothing() {
    for (keyframes, keys, word) in
        [(0, "space", "No keyframe"), (0, "c", "No keyframe"), (0, "d", "empty"), (3, "y", "Fewer than 4")]
    {
        let mut editor = editor_with(keyframes);
        let before = editor.document().clone();
        press(&mut editor, keys);
        assert!(editor.message_text().contains(word), "{keys}: {}", editor.message_text());
        assert_eq!(editor.message().unwrap().severity(), Severity::Error);
        assert_eq!(editor.document(), &before);
    }
}

#[test]
fn space_and_c_bring_the_keyframe_back_and_u_keeps_the_pose() {
    for key in ["space", "c"] {
        let mut editor = editor_with(2);
        pose(&mut editor, 9.0);
        press(&mut editor, key);
        assert_eq!(shown(&editor), "0 [1] | 1");
        press(&mut editor, "ctrl+z");
        assert_eq!(shown(&editor), "0 [1] | 9", "the posing that was discarded comes back");
    }
    let mut editor = editor_with(2);
    pose(&mut editor, 9.0);
    press(&mut editor, "u");
    assert_eq!(shown(&editor), "0 [9] | 9");
}

#[test]
fn stepping_away_from_unsaved_posing_can_be_undone() {
    let mut editor = editor_with(3);
    pose(&mut editor, 9.0);
    press(&mut editor, "<");
    assert_eq!(shown(&editor), "0 [1] 2 | 1");
    press(&mut editor, "ctrl+z");
    assert_eq!(shown(&editor), "0 1 [2] | 9");
    let mut editor = editor_with(3);
    press(&mut editor, "< < ctrl+z");
    assert_eq!(shown(&editor), "0 [1] | 2", "steps that lose nothing are not steps of undo: the third keyframe goes");
}

#[test]
fn pace_keeps_its_bounds_and_a_run_is_one_step() {
    let mut editor = editor();
    press(&mut editor, "+ + = - +");
    assert_eq!(editor.document().ms_between_keyframes, 1700);
    press(&mut editor, "ctrl+z");
    assert_eq!(editor.document().ms_between_keyframes, 2000);
    press(&mut editor, &"+ ".repeat(30));
    assert_eq!(editor.document().ms_between_keyframes, 100);
    press(&mut editor, &"- ".repeat(130));
    assert_eq!(editor.document().ms_between_keyframes, 10_000);
    press(&mut editor, "ctrl+z");
    assert_eq!(editor.document().ms_between_keyframes, 2000);
}

#[test]
fn playing_takes_exactly_its_ticks_and_ends_at_the_last_played() {
    let mut editor = check(5, 0, "y", "[0] 1 2 3 4 | 1");
    for tick in 1..240 {
        editor.tick(1);
        assert!(editor.is_playing(), "tick {tick}");
        assert_eq!(editor.key_time(), Some(f64::from(tick) * 50.0 / 6000.0));
    }
    editor.tick(1);
    assert!(!editor.is_playing());
    assert_eq!(shown(&editor), "0 1 2 [3] 4 | 3");
}

#[test]
fn stopping_ends_at_the_last_played_too() {
    let mut editor = check(5, 0, "y", "[0] 1 2 3 4 | 1");
    editor.tick(60);
    assert_eq!(shown(&editor), "[0] 1 2 3 4 | 1.5");
    press(&mut editor, "y");
    assert_eq!(shown(&editor), "0 1 2 [3] 4 | 3");
}

#[test]
fn playing_over_unsaved_posing_can_be_undone() {
    let mut editor = editor_with(4);
    pose(&mut editor, 9.0);
    press(&mut editor, "y");
    editor.tick(10_000);
    assert_eq!(shown(&editor), "0 1 [2] 3 | 2");
    press(&mut editor, "ctrl+z");
    assert_eq!(shown(&editor), "0 1 2 [3] | 9");
}

#[test]
fn pausing_freezes_the_pose_and_goes_on_from_there() {
    let mut editor = check(5, 0, "y", "[0] 1 2 3 4 | 1");
    editor.tick(60);
    press(&mut editor, "shift+p");
    assert!(!editor.is_playing());
    assert_eq!(shown(&editor), "[0] 1 2 3 4 | 1.5");
    editor.tick(1000);
    press(&mut editor, "n");
    assert_eq!(shown(&editor), "0 [1.5] 1 2 3 4 | 1.5");
    press(&mut editor, "shift+p");
    assert!(editor.is_playing());
    assert_eq!(editor.key_time(), Some(0.5));
}

#[test]
fn another_pace_while_playing_does_not_jump() {
    let mut editor = check(5, 0, "y", "[0] 1 2 3 4 | 1");
    editor.tick(61);
    let before = editor.key_time().unwrap();
    press(&mut editor, "+");
    assert!((editor.key_time().unwrap() - before).abs() < 1e-15);
    editor.tick(1);
    assert!((editor.key_time().unwrap() - before - 50.0 / (3.0 * 1900.0)).abs() < 1e-12);
}

#[test]
fn what_playing_refuses_leaves_it_running() {
    let mut editor = check(5, 0, "y", "[0] 1 2 3 4 | 1");
    editor.tick(30);
    let before = editor.document().clone();
    for key in ["u", "n", "d", "<", ">", "i", "r", "space", "c", "ctrl+z", "ctrl+shift+z", "ctrl+y"] {
        let effects = press(&mut editor, key);
        assert!(editor.is_playing() && effects.is_empty(), "{key}");
        assert!(editor.message_text().contains("while playing"), "{key}: {}", editor.message_text());
        assert_eq!(editor.document(), &before, "{key}");
    }
    let refused = editor.apply(Command::Gesture(GestureCommand::Begin));
    assert!(refused.is_err() && editor.is_playing());
    for key in ["w", "t", "v", "p", "m", "a", "s", "h", "+", "-", "f11"] {
        press(&mut editor, key);
        assert!(editor.is_playing(), "{key}");
    }
    assert_eq!(editor.document().interpolation, Interpolation::CatmullRom);
}

#[test]
fn a_drag_is_one_step_and_escape_takes_it_back() {
    let drag = |editor: &mut Editor| {
        let robot = editor.scene().find_rbt("robot1").unwrap();
        apply(editor, Command::View(ViewCommand::Choose(Some(robot))));
        apply(editor, Command::Gesture(GestureCommand::Begin));
        for _ in 0..10 {
            let motion = Rbt::from_translation(glam::Vec3::X);
            apply(editor, Command::Gesture(GestureCommand::Move(motion)));
        }
    };
    let mut editor = editor();
    drag(&mut editor);
    press(&mut editor, "ctrl+z");
    assert!(editor.message_text().contains("drag"), "undo waits for the end of the drag");
    apply(&mut editor, Command::Gesture(GestureCommand::Commit));
    assert_eq!(shown(&editor), " | 8");
    press(&mut editor, "ctrl+z");
    assert_eq!(shown(&editor), " | -2");
    press(&mut editor, "ctrl+y");
    assert_eq!(shown(&editor), " | 8");
    press(&mut editor, "r");
    drag(&mut editor);
    press(&mut editor, "escape");
    assert_eq!(shown(&editor), " | -2");
    drag(&mut editor);
    press(&mut editor, "n");
    assert_eq!(shown(&editor), "[8] | 8", "a keyframe during a drag takes what is on screen");
}

#[test]
fn the_eye_moves_where_nothing_is_chosen() {
    let mut editor = editor();
    let sky = editor.scene().find_rbt("sky").unwrap();
    assert_eq!(editor.dragged_node(), Some(sky));
    press(&mut editor, "v");
    assert_eq!(editor.scene().rbt_path(editor.dragged_node().unwrap()), "robot1");
    press(&mut editor, "m");
    assert_eq!(editor.message().unwrap().severity(), Severity::Error, "the sky modes need the sky as eye");
    press(&mut editor, "v v m");
    assert_eq!(editor.message().unwrap().severity(), Severity::Information);
    assert_eq!(editor.dragged_node(), Some(sky));
    editor.apply(Command::View(ViewCommand::SetEye(Eye::Work))).unwrap();
    assert_eq!(editor.dragged_node(), None);
    press(&mut editor, "m");
    assert_eq!(editor.message().unwrap().severity(), Severity::Error, "the sky modes need the sky as eye");
}

#[test]
fn a_chosen_node_turns_about_its_own_centre_with_the_axes_of_the_eye() {
    let mut editor = editor();
    let elbow = editor.scene().find_rbt("robot1/right_shoulder/right_elbow").unwrap();
    apply(&mut editor, Command::View(ViewCommand::Choose(Some(elbow))));
    let before = editor.scene().world_from_rbt(&editor.displayed_pose(), 0.0, elbow);
    apply(&mut editor, Command::Gesture(GestureCommand::Begin));
    let turn = glam::Quat::from_rotation_y(0.5);
    apply(&mut editor, Command::Gesture(GestureCommand::Move(Rbt::from_rotation(turn))));
    let after = editor.scene().world_from_rbt(&editor.displayed_pose(), 0.0, elbow);
    assert!(after.translation.distance(before.translation) < 1e-5);
    assert!((after.rotation.dot(turn).abs() - 1.0).abs() < 1e-6, "the sky camera's axes are the world's at rest");
}

#[test]
fn importing_replaces_the_list_and_can_be_undone() {
    let file = {
        let editor = editor_with(6);
        let document = editor.document();
        keyframes_to_json(editor.scene(), &document.keyframes, Interpolation::CatmullRom, 700)
    };
    let mut editor = editor_with(2);
    let effects = press(&mut editor, "i");
    let [Effect::ReadKeyframes { path }] = effects.as_slice() else { panic!("{effects:?}") };
    editor.keyframes_read(path, Ok(file.into_bytes())).unwrap();
    assert_eq!(shown(&editor), "[0] 1 2 3 4 5 | 0");
    assert_eq!(editor.document().ms_between_keyframes, 700);
    assert_eq!(editor.document().interpolation, Interpolation::CatmullRom);
    assert!(!editor.has_unsaved_changes());
    press(&mut editor, "ctrl+z");
    assert_eq!(shown(&editor), "0 [1] | 1");
    assert_eq!(editor.document().ms_between_keyframes, 2000);
    assert!(editor.has_unsaved_changes());
}

#[test]
fn what_the_program_was_started_with_is_not_undone() {
    let mut editor = editor_with(3);
    editor.begin_history();
    press(&mut editor, "n ctrl+z ctrl+z ctrl+z");
    assert_eq!(editor.document().keyframes.len(), 3);
    assert_eq!(editor.message_text(), "There is nothing to undo.");
}

#[test]
fn a_bad_import_changes_nothing_and_says_why() {
    for (bytes, words) in
        [(Ok(b"{".to_vec()), "line 1 column 1"), (Err(texts::STORAGE_NOT_FOUND.into()), "no such file")]
    {
        let mut editor = editor_with(2);
        let before = editor.document().clone();
        assert!(editor.keyframes_read(Path::new("wave.json"), bytes).is_err());
        assert_eq!(editor.document(), &before);
        assert!(editor.message_text().starts_with("wave.json: ") && editor.message_text().contains(words));
        assert_eq!(editor.keyframe_file(), Path::new("animation.json"));
    }
}

#[test]
fn a_text_is_imported_and_not_written_over_unseen() {
    let text = include_str!("data/student-files/n-m-header-one-rbt-per-line.txt");
    let mut editor = editor_with(2);
    editor.keyframes_read(Path::new("student.txt"), Ok(text.as_bytes().to_vec())).unwrap();
    assert_eq!(
        editor.message_text(),
        "Imported 6 keyframes from student.txt. Read as text: 6 keyframes of 22 nodes, layout header."
    );
    assert_eq!(editor.document().keyframes.len(), 6);
    assert!(!editor.has_unsaved_changes());
    let effects = press(&mut editor, "w");
    let [Effect::WriteKeyframes { path, is_known: false, .. }] = effects.as_slice() else { panic!("{effects:?}") };
    assert_eq!(path, Path::new("student.txt"));
    press(&mut editor, "ctrl+z");
    assert_eq!(shown(&editor), "0 [1] | 1");
    for (text, words) in
        [("1 22\n0 0 nan", "line 2 column 5"), ("{0: 1}", "`inbetween convert`"), ("hello", "line 1 column 1")]
    {
        let before = editor.document().clone();
        assert!(editor.keyframes_read(Path::new("bad.txt"), Ok(text.into())).is_err());
        assert_eq!(editor.document(), &before);
        assert!(editor.message_text().contains(words), "{}", editor.message_text());
    }
}

#[test]
fn writing_keeps_track_of_what_is_saved() {
    let mut editor = editor();
    assert!(!editor.has_unsaved_changes());
    press(&mut editor, "n");
    assert!(editor.has_unsaved_changes());
    let effects = press(&mut editor, "w");
    let [Effect::WriteKeyframes { path, is_known: false, .. }] = effects.as_slice() else { panic!("{effects:?}") };
    editor.keyframes_written(path, Ok(Written::default())).unwrap();
    assert!(!editor.has_unsaved_changes());
    press(&mut editor, "n");
    assert!(editor.has_unsaved_changes());
    press(&mut editor, "ctrl+z");
    assert!(!editor.has_unsaved_changes());
}

#[test]
fn an_empty_list_is_written_and_read() {
    let editor = editor();
    let document = editor.document();
    let text = keyframes_to_json(editor.scene(), &document.keyframes, Interpolation::Linear, 2000);
    let mut other = editor_with(2);
    other.keyframes_read(Path::new("a.json"), Ok(text.into_bytes())).unwrap();
    assert_eq!(shown(&other), " | 1");
}

#[test]
fn no_two_bindings_share_a_chord() {
    let table = inbetween::editor::keymap::bindings();
    let mut seen = std::collections::HashSet::new();
    for chord in table.iter().flat_map(|binding| &binding.chords) {
        assert!(seen.insert(*chord), "{} stands twice", chord.label());
    }
}

#[test]
fn an_import_of_fewer_keyframes_leaves_nothing_selected_that_is_gone() {
    let one = editor_with(1);
    let path = Path::new("one.json");
    let text = keyframes_to_json(one.scene(), &one.document().keyframes, Interpolation::Linear, 2000);
    let mut editor = editor_with(3);
    let last = editor.document().keyframes.last().unwrap();
    editor.apply(Command::Selection(SelectionCommand::Keyframes(vec![last]))).unwrap();
    editor.keyframes_read(path, Ok(text.into_bytes())).unwrap();
    assert!(editor.session().selected.is_empty());
    editor.apply(Command::Clipboard(ClipboardCommand::CopyKeyframes)).unwrap();
}
