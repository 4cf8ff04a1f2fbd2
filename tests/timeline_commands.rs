//! The timeline by its commands: what each does, and that undo of each returns the document to the same bytes.

mod common;

use common::{apply, editor_with, pose, press, shown};
use glam::Vec3;
use inbetween::editor::{
    ClipboardCommand, Command, Edit, Editor, GestureCommand, PlayMode, PlaybackCommand, SelectionCommand, TimelineEdit,
    ViewCommand,
};
use inbetween::interpolation::Interpolation;
use inbetween::keyframe::{
    Easing, Keyframe, KeyframeIndex, KeyframeList, PlayRange, Retiming, StretchEnd, keyframes_from_json,
    keyframes_to_json,
};
use inbetween::pose::{Pose, RbtIndex};
use inbetween::rbt::Rbt;
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use proptest::prelude::*;

fn index(place: usize) -> KeyframeIndex {
    KeyframeIndex::new(place)
}

fn select(editor: &mut Editor, places: &[usize]) {
    let selected = places.iter().copied().map(index).collect();
    apply(editor, Command::Selection(SelectionCommand::Keyframes(selected)));
}

fn timeline(editor: &mut Editor, edit: TimelineEdit) {
    apply(editor, Command::Edit(Edit::Timeline(edit)));
}

fn play(editor: &mut Editor, command: PlaybackCommand) {
    apply(editor, Command::Playback(command));
}

fn text(editor: &Editor) -> String {
    let document = editor.document();
    keyframes_to_json(editor.scene(), &document.keyframes, document.interpolation, document.ms_between_keyframes)
}

/// With keyframes 0 to 5 and some selected, an edit gives this list; undo gives back the same bytes, and redo the edit's.
#[track_caller]
fn check(selected: &[usize], edit: TimelineEdit, expected: &str) {
    let mut editor = editor_with(6);
    select(&mut editor, selected);
    let before = (text(&editor), shown(&editor));
    let copied = matches!(edit, TimelineEdit::PasteKeyframes);
    if copied {
        apply(&mut editor, Command::Clipboard(ClipboardCommand::CopyKeyframes));
    }
    timeline(&mut editor, edit.clone());
    assert_eq!(shown(&editor), expected, "{edit:?}");
    let after = text(&editor);
    press(&mut editor, "ctrl+z");
    assert_eq!((text(&editor), shown(&editor)), before, "undo of {edit:?}");
    press(&mut editor, "ctrl+y");
    assert_eq!(text(&editor), after, "redo of {edit:?}");
}

#[test]
fn keyframes_are_moved_copied_and_deleted_and_undo_returns_the_same_bytes() {
    check(&[1, 2], TimelineEdit::MoveKeyframes(6), "0 3 4 5 [1] 2 | 1");
    check(&[4], TimelineEdit::MoveKeyframes(0), "[4] 0 1 2 3 5 | 4");
    check(&[1, 4], TimelineEdit::MoveKeyframes(3), "0 2 [1] 4 3 5 | 1");
    check(&[1, 3], TimelineEdit::DeleteKeyframes, "[0] 2 4 5 | 0");
    check(&[0, 1, 2, 3, 4, 5], TimelineEdit::DeleteKeyframes, " | 5");
    check(&[2, 3], TimelineEdit::CutKeyframes, "0 [1] 4 5 | 1");
    check(&[1, 2], TimelineEdit::DuplicateKeyframes, "0 1 2 [1] 2 3 4 5 | 1");
    check(&[0, 1], TimelineEdit::PasteKeyframes, "0 1 [0] 1 2 3 4 5 | 0");
    check(&[], TimelineEdit::ReverseKeyframes, "5 4 3 2 1 [0] | 0");
    check(&[1, 2, 3], TimelineEdit::ReverseKeyframes, "0 3 2 1 4 [5] | 5");
    check(&[], TimelineEdit::DuplicateKeyframes, "0 1 2 3 4 5 [5] | 5");
}

#[test]
fn names_durations_and_easings_are_kept_and_undone() {
    let easing = Easing::from_name("cubic-in-out").unwrap();
    for edit in [
        TimelineEdit::RenameKeyframe(index(2), "  the wave ".to_owned()),
        TimelineEdit::SetDuration { keyframe: index(2), duration: 2.5, ripple_free: false },
        TimelineEdit::SetDuration { keyframe: index(2), duration: 1.5, ripple_free: true },
        TimelineEdit::SetEasing(easing),
        TimelineEdit::SetTranslationInKeyframe(index(1), RbtIndex::new(2), Vec3::splat(7.0)),
        TimelineEdit::SetRotationInKeyframe(index(1), RbtIndex::new(2), glam::Quat::from_rotation_y(1.0)),
    ] {
        let mut editor = editor_with(6);
        let before = text(&editor);
        timeline(&mut editor, edit.clone());
        assert_ne!(text(&editor), before, "{edit:?}");
        press(&mut editor, "ctrl+z");
        assert_eq!(text(&editor), before, "undo of {edit:?}");
    }
}

#[test]
fn retiming_without_ripple_takes_from_the_neighbour() {
    let mut editor = editor_with(6);
    timeline(&mut editor, TimelineEdit::SetDuration { keyframe: index(2), duration: 1.75, ripple_free: true });
    let durations = |editor: &Editor| -> Vec<f64> {
        editor.document().keyframes.as_slice().iter().map(|keyframe| keyframe.duration).collect()
    };
    assert_eq!(durations(&editor), [1.0, 1.0, 1.75, 0.25, 1.0, 1.0]);
    timeline(&mut editor, TimelineEdit::SetDuration { keyframe: index(2), duration: 9.0, ripple_free: true });
    assert_eq!(durations(&editor), [1.0, 1.0, 1.999, 0.001, 1.0, 1.0]);
}

fn durations_ms(editor: &Editor) -> Vec<f64> {
    let document = editor.document();
    let ms = f64::from(document.ms_between_keyframes);
    document.keyframes.as_slice().iter().map(|keyframe| keyframe.duration * ms).collect()
}

#[test]
fn keyframes_are_moved_in_time_by_whole_milliseconds() {
    let mut editor = editor_with(6);
    let before = text(&editor);
    select(&mut editor, &[2, 3]);
    let retiming = |by_ms| Retiming { by_ms, end: None, ripples: false };
    timeline(&mut editor, TimelineEdit::RetimeKeyframes(retiming(117)));
    assert_eq!(durations_ms(&editor), [2000.0, 2117.0, 2000.0, 1883.0, 2000.0, 2000.0]);
    timeline(&mut editor, TimelineEdit::RetimeKeyframes(Retiming { ripples: true, ..retiming(-117) }));
    assert_eq!(durations_ms(&editor), [2000.0, 2000.0, 2000.0, 1883.0, 2000.0, 2000.0]);
    press(&mut editor, "ctrl+z ctrl+z");
    assert_eq!(text(&editor), before);
    select(&mut editor, &[1, 2, 3]);
    timeline(&mut editor, TimelineEdit::RetimeKeyframes(Retiming { end: Some(StretchEnd::End), ..retiming(1000) }));
    assert_eq!(durations_ms(&editor), [2000.0, 2500.0, 2500.0, 1000.0, 2000.0, 2000.0]);
    assert!(text(&editor).contains("\"version\": 2"), "durations need version 2");
}

#[test]
fn a_drag_in_time_counts_from_its_beginning() {
    let mut editor = editor_with(6);
    select(&mut editor, &[2]);
    apply(&mut editor, Command::Gesture(GestureCommand::Begin));
    for by_ms in [5000, -5000, 250] {
        timeline(&mut editor, TimelineEdit::RetimeKeyframes(Retiming { by_ms, end: None, ripples: false }));
    }
    apply(&mut editor, Command::Gesture(GestureCommand::Commit));
    assert_eq!(durations_ms(&editor), [2000.0, 2250.0, 1750.0, 2000.0, 2000.0, 2000.0]);
    press(&mut editor, "ctrl+z");
    assert_eq!(durations_ms(&editor), [2000.0; 6]);
}

#[test]
fn a_retiming_drag_is_one_step() {
    let mut editor = editor_with(6);
    let before = text(&editor);
    apply(&mut editor, Command::Gesture(GestureCommand::Begin));
    for duration in [1.1, 1.4, 2.0] {
        timeline(&mut editor, TimelineEdit::SetDuration { keyframe: index(1), duration, ripple_free: false });
    }
    apply(&mut editor, Command::Gesture(GestureCommand::Commit));
    press(&mut editor, "ctrl+z");
    assert_eq!(text(&editor), before);
}

#[test]
fn playing_follows_the_durations_tick_for_tick() {
    let mut editor = editor_with(5);
    timeline(&mut editor, TimelineEdit::SetDuration { keyframe: index(1), duration: 0.5, ripple_free: false });
    timeline(&mut editor, TimelineEdit::SetDuration { keyframe: index(2), duration: 2.0, ripple_free: false });
    press(&mut editor, "y");
    editor.tick(30);
    assert_eq!(editor.key_time(), Some(0.5));
    editor.tick(30);
    assert_eq!(editor.key_time(), Some(1.0));
    editor.tick(60);
    assert_eq!(editor.key_time(), Some(1.25));
    editor.tick(179);
    assert!(editor.is_playing());
    editor.tick(1);
    assert!(!editor.is_playing(), "2.5 steps of 2000 ms are 300 ticks");
    assert_eq!(shown(&editor), "0 1 2 [3] 4 | 3");
}

#[test]
fn scrubbing_shows_a_pose_without_touching_the_document() {
    let mut editor = editor_with(5);
    let before = (editor.document().clone(), editor.undo_label());
    play(&mut editor, PlaybackCommand::Scrub(0.5));
    assert_eq!(shown(&editor), "0 1 2 3 [4] | 1.5");
    assert_eq!((editor.document().clone(), editor.undo_label()), before);
    play(&mut editor, PlaybackCommand::Scrub(99.0));
    assert_eq!(shown(&editor), "0 1 2 3 [4] | 3");
    press(&mut editor, "space");
    assert_eq!(shown(&editor), "0 1 2 3 [4] | 4");
}

#[test]
fn n_and_u_capture_a_scrubbed_pose() {
    let mut editor = editor_with(5);
    play(&mut editor, PlaybackCommand::Scrub(1.5));
    press(&mut editor, "n");
    assert_eq!(shown(&editor), "0 1 2 [2.5] 3 4 | 2.5");
    press(&mut editor, "ctrl+z");
    assert_eq!(shown(&editor), "0 1 2 3 [4] | 4");
    play(&mut editor, PlaybackCommand::Scrub(1.5));
    press(&mut editor, "u");
    assert_eq!(shown(&editor), "0 1 2 3 [2.5] | 2.5");
    let mut editor = editor_with(5);
    play(&mut editor, PlaybackCommand::Scrub(0.5));
    pose(&mut editor, 9.0);
    assert_eq!(shown(&editor), "0 1 2 3 [4] | 9", "posing starts from what is on screen");
}

#[test]
fn steps_ranges_loops_and_speed() {
    let mut editor = editor_with(6);
    press(&mut editor, "right right left");
    assert!((editor.key_time().unwrap() - (3.0 - 50.0 / 6000.0)).abs() < 1e-12, "it steps within what plays");
    play(&mut editor, PlaybackCommand::Scrub(1.0));
    press(&mut editor, "right");
    assert!((editor.key_time().unwrap() - (1.0 + 50.0 / 6000.0)).abs() < 1e-12);
    press(&mut editor, "shift+y");
    editor.tick(29);
    assert!((editor.key_time().unwrap() - 1.25).abs() < 1e-12);
    press(&mut editor, "y");
    play(&mut editor, PlaybackCommand::SetRange(Some((2, 3))));
    play(&mut editor, PlaybackCommand::SetMode(PlayMode::Loop));
    press(&mut editor, "y");
    editor.tick(180);
    assert_eq!(editor.key_time(), Some(1.5));
    play(&mut editor, PlaybackCommand::SetMode(PlayMode::Once));
    editor.tick(60);
    assert_eq!(shown(&editor), "0 1 2 [3] 4 5 | 3");
    play(&mut editor, PlaybackCommand::SetRange(None));
    play(&mut editor, PlaybackCommand::SetSpeedPercent(200));
    press(&mut editor, "y");
    editor.tick(30);
    assert_eq!(editor.key_time(), Some(0.5));
    assert!(editor.apply(Command::Playback(PlaybackCommand::SetRange(Some((0, 3))))).is_err());
    assert!(editor.apply(Command::Playback(PlaybackCommand::SetRange(Some((3, 5))))).is_err());
}

#[test]
fn auto_key_updates_the_current_keyframe_in_the_same_step() {
    let mut editor = editor_with(3);
    press(&mut editor, "shift+a");
    let before = (text(&editor), shown(&editor));
    let robot = editor.scene().find_rbt("robot1").unwrap();
    apply(&mut editor, Command::View(ViewCommand::Choose(Some(robot))));
    apply(&mut editor, Command::Gesture(GestureCommand::Begin));
    apply(&mut editor, Command::Gesture(GestureCommand::Move(Rbt::from_translation(Vec3::X))));
    apply(&mut editor, Command::Gesture(GestureCommand::Commit));
    assert_eq!(shown(&editor), "0 1 [3] | 3");
    assert!(editor.message_text().contains("auto-key"));
    press(&mut editor, "ctrl+z");
    assert_eq!((text(&editor), shown(&editor)), before);
}

#[test]
fn a_pose_is_pasted_to_the_other_robot() {
    let mut editor = editor_with(0);
    let [robot1, robot2, elbow1, elbow2] =
        ["robot1", "robot2", "robot1/right_shoulder/right_elbow", "robot2/right_shoulder/right_elbow"]
            .map(|path| editor.scene().find_rbt(path).unwrap());
    let turned = glam::Quat::from_rotation_y(0.7);
    apply(&mut editor, Command::Edit(Edit::SetRotation(elbow1, turned)));
    apply(&mut editor, Command::View(ViewCommand::Choose(Some(robot1))));
    press(&mut editor, "ctrl+shift+c");
    apply(&mut editor, Command::View(ViewCommand::Choose(Some(robot2))));
    let before = editor.displayed_pose();
    press(&mut editor, "ctrl+shift+v");
    let pose = editor.displayed_pose();
    assert_eq!(pose.get(elbow2).rotation, turned);
    assert_eq!(pose.get(robot2).translation, Vec3::new(2.0, 1.0, 0.0), "the other robot stays where it is");
    press(&mut editor, "ctrl+z");
    assert_eq!(editor.displayed_pose(), before);
    apply(&mut editor, Command::View(ViewCommand::Choose(Some(elbow2))));
    press(&mut editor, "ctrl+shift+v");
    assert!(editor.message_text().contains("has not"), "{}", editor.message_text());
}

#[test]
fn files_are_of_version_1_unless_they_need_version_2() {
    let scene = built_in_scene(DEFAULT_SCENE).unwrap();
    let mut editor = editor_with(5);
    assert!(text(&editor).contains("\"version\": 1,"));
    for (edit, field) in [
        (TimelineEdit::RenameKeyframe(index(1), "a \"b\"\u{d55c}".to_owned()), "\"name\": \"a \\\"b\\\"\u{d55c}\""),
        (TimelineEdit::SetDuration { keyframe: index(2), duration: 0.1, ripple_free: false }, "\"duration\": 0.1"),
        (TimelineEdit::SetEasing(Easing::Hold), "\"easing\": \"hold\""),
    ] {
        timeline(&mut editor, edit);
        let written = text(&editor);
        assert!(written.contains("\"version\": 2,") && written.contains(field), "{field}");
        let file = keyframes_from_json(written.as_bytes(), &scene).unwrap();
        let read = KeyframeList::new(file.keyframes);
        assert_eq!(keyframes_to_json(&scene, &read, Interpolation::Linear, 2000), written);
        let as_version_1 = written.replace("\"version\": 2,", "\"version\": 1,");
        let problems = keyframes_from_json(as_version_1.as_bytes(), &scene).unwrap_err();
        assert!(problems[0].to_string().contains("needs version 2"), "{}", problems[0]);
    }
    let bad = text(&editor).replace("\"duration\": 0.1", "\"duration\": 0").replace("\"hold\"", "\"wobble\"");
    let problems = keyframes_from_json(bad.as_bytes(), &scene).unwrap_err();
    assert_eq!(problems[0].to_string(), "keyframe 2: duration is 0, expected a number from 0.001 to 1000");
    assert!(problems[1].to_string().starts_with("keyframe 4: easing is \"wobble\", expected linear, hold, or"));
}

#[test]
fn easing_bends_an_interval_and_nothing_else() {
    let mut editor = editor_with(5);
    select(&mut editor, &[1]);
    timeline(&mut editor, TimelineEdit::SetEasing(Easing::from_name("quad-in").unwrap()));
    for (key_time, x) in [(0.0, "1"), (0.5, "1.25"), (1.0, "2"), (1.5, "2.5")] {
        play(&mut editor, PlaybackCommand::Scrub(key_time));
        assert!(shown(&editor).ends_with(&format!("| {x}")), "{key_time}: {}", shown(&editor));
    }
    timeline(&mut editor, TimelineEdit::SetEasing(Easing::Hold));
    play(&mut editor, PlaybackCommand::Scrub(0.99));
    assert!(shown(&editor).ends_with("| 1"), "{}", shown(&editor));
}

proptest! {
    /// Speed in seconds is the same on both sides of a keyframe, whatever the lengths of the intervals.
    #[test]
    fn splines_keep_their_speed_with_unequal_durations(
        x in prop::array::uniform5(-5.0f32..5.0), turn in prop::array::uniform5(-0.5f32..0.5),
        durations in prop::array::uniform5(0.2f64..4.0),
    ) {
        let keyframes = (0..5).map(|place| Keyframe {
            duration: durations[place],
            ..Keyframe::new(Pose::new(vec![Rbt::new(
                Vec3::new(x[place], 0.0, 0.0),
                glam::Quat::from_rotation_z(turn[place]),
            )]))
        });
        let list = KeyframeList::new(keyframes.collect());
        let range = PlayRange::new(&list).unwrap();
        let at = |key_time: f64| range.pose_at(key_time, Interpolation::CatmullRom).unwrap().get(RbtIndex::new(0));
        let step = 1.0 / 1024.0;
        let (before, middle, after) = (at(1.0 - step), at(1.0), at(1.0 + step));
        let arriving = f64::from(middle.translation.x - before.translation.x) / (step * durations[1]);
        let leaving = f64::from(after.translation.x - middle.translation.x) / (step * durations[2]);
        let scale = 1.0 + 10.0 / durations[1].min(durations[2]);
        prop_assert!((arriving - leaving).abs() < 0.05 * scale * scale, "{arriving} and {leaving}");
        let angle = |from: Rbt, to: Rbt| f64::from((to.rotation * from.rotation.conjugate()).to_scaled_axis().z);
        let arriving = angle(before, middle) / (step * durations[1]);
        let leaving = angle(middle, after) / (step * durations[2]);
        prop_assert!((arriving - leaving).abs() < 0.02 * scale * scale, "{arriving} and {leaving}");
    }
}

#[test]
fn keyframes_that_came_during_a_drag_are_retimed_from_what_they_are() {
    let mut editor = editor_with(0);
    apply(&mut editor, Command::View(ViewCommand::Choose(Some(RbtIndex::new(1)))));
    apply(&mut editor, Command::Gesture(GestureCommand::Begin));
    let keyframes = editor_with(6).document().keyframes.clone();
    let read = keyframes_to_json(editor.scene(), &keyframes, Interpolation::Linear, 2000);
    let _ = editor.keyframes_read(std::path::Path::new("other.json"), Ok(read.into_bytes()));
    apply(&mut editor, Command::Gesture(GestureCommand::Begin));
    select(&mut editor, &[2]);
    timeline(&mut editor, TimelineEdit::RetimeKeyframes(Retiming { by_ms: 500, end: None, ripples: false }));
    let durations: Vec<f64> = editor.document().keyframes.as_slice().iter().map(|keyframe| keyframe.duration).collect();
    assert_eq!(durations[1..3], [1.25, 0.75]);
}
