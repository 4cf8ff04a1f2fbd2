//! Control nodes and keys at their own times, by their commands: what each does, and that undo of each returns the scene to the same bytes.

mod common;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use common::{apply, editor, editor_with, press};
use glam::{Quat, Vec3};
use inbetween::colour::Colour;
use inbetween::editor::{
    Command, Edit, Editor, Effect, FileCommand, GestureCommand, KeyAt, PlaybackCommand, SceneEdit, SelectionCommand,
    TimelineEdit, ViewCommand, Written,
};
use inbetween::keyframe::{KeyframeIndex, keyframes_to_json};
use inbetween::lighting::BuiltInLighting;
use inbetween::scene::{Channel, KeyValue, SceneFiles, built_in_scene, scene_from_json, scene_to_json};
use inbetween::words::texts;

/// The cylinder, whose control node has keys of its translation at 0, 2 and 4 s, of its rotation at 0, 2, 3 and 4, of its scale at 0, 2, 4.
fn cylinder() -> Editor {
    Editor::new(Arc::new(built_in_scene("cylinder").unwrap()), PathBuf::from("animation.json"))
}

fn key(channel: Channel, seconds: f64) -> KeyAt {
    KeyAt::new("cylinder", channel, seconds)
}

fn edit(editor: &mut Editor, edit: SceneEdit) -> String {
    apply(editor, Command::Edit(Edit::Scene(edit)));
    editor.message_text()
}

/// What both files would hold.
fn bytes(editor: &Editor) -> String {
    let document = editor.document();
    let keyframes =
        keyframes_to_json(editor.scene(), &document.keyframes, document.interpolation, document.ms_between_keyframes);
    scene_to_json(editor.scene()) + &keyframes
}

fn times(editor: &Editor, path: &str, channel: Channel) -> Vec<f64> {
    let scene = editor.scene();
    scene.key_seconds(scene.find(path).unwrap(), channel).to_vec()
}

fn value(editor: &Editor, channel: Channel, seconds: f64) -> KeyValue {
    let scene = editor.scene();
    scene.key_value_at(scene.find("cylinder").unwrap(), channel, seconds).unwrap()
}

/// An edit changes the scene; undo gives back the same bytes, and redo the edit's.
#[track_caller]
fn check(does: SceneEdit, channel: Channel, expected: &[f64]) -> Editor {
    let mut editor = cylinder();
    let before = bytes(&editor);
    edit(&mut editor, does.clone());
    let after = bytes(&editor);
    assert_ne!(after, before, "{does:?}: {}", editor.message_text());
    assert_eq!(times(&editor, "cylinder", channel), expected, "{does:?}");
    assert!(editor.has_unsaved_scene() && editor.has_unsaved_changes() && !editor.has_unsaved_keyframes());
    let done = editor.clone();
    press(&mut editor, "ctrl+z");
    assert_eq!(bytes(&editor), before, "undo of {does:?}");
    assert!(!editor.has_unsaved_changes());
    press(&mut editor, "ctrl+y");
    assert_eq!(bytes(&editor), after, "redo of {does:?}");
    done
}

#[test]
fn keys_are_added_with_what_is_there() {
    let editor =
        check(SceneEdit::AddKeys(vec![key(Channel::Translation, 1.0)]), Channel::Translation, &[0.0, 1.0, 2.0, 4.0]);
    assert_eq!(value(&editor, Channel::Translation, 1.0), KeyValue::Translation(Vec3::new(0.5, 0.5, 0.0)));
    assert_eq!(value(&editor, Channel::Translation, 1.5), KeyValue::Translation(Vec3::new(0.75, 0.75, 0.0)));
    assert_eq!(editor.session().selected_keys, [key(Channel::Translation, 1.0)]);
    // Where a key stands already nothing changes.
    let mut editor = cylinder();
    edit(&mut editor, SceneEdit::AddKeys(vec![key(Channel::Scale, 2.0)]));
    assert!(!editor.has_unsaved_scene() && editor.undo_label().is_none());
}

#[test]
fn keys_are_edited_moved_and_deleted() {
    let node: Arc<str> = "cylinder".into();
    let set = |seconds, value| SceneEdit::SetKey { node: Arc::clone(&node), seconds, value };
    let editor = check(set(2.0, KeyValue::Scale(Vec3::splat(3.0))), Channel::Scale, &[0.0, 2.0, 4.0]);
    assert_eq!(value(&editor, Channel::Scale, 2.0), KeyValue::Scale(Vec3::splat(3.0)));
    let turn = Quat::from_rotation_x(0.5);
    check(set(7.5, KeyValue::Rotation(turn)), Channel::Rotation, &[0.0, 2.0, 3.0, 4.0, 7.5]);
    let moves = |times: &[f64], by| SceneEdit::MoveKeys {
        keys: times.iter().map(|&seconds| key(Channel::Rotation, seconds)).collect(),
        by,
    };
    let editor = check(moves(&[2.0, 3.0], 0.1), Channel::Rotation, &[0.0, 2.1, 3.1, 4.0]);
    assert_eq!(editor.session().selected_keys, [key(Channel::Rotation, 2.1), key(Channel::Rotation, 3.1)]);
    check(moves(&[2.0, 3.0], 1.0), Channel::Rotation, &[0.0, 3.0, 4.0]);
    check(moves(&[0.0], -0.25), Channel::Rotation, &[-0.25, 2.0, 3.0, 4.0]);
    let several = vec![key(Channel::Scale, 0.0), key(Channel::Rotation, 2.0), key(Channel::Scale, 4.0)];
    let editor = check(SceneEdit::DeleteKeys(several), Channel::Scale, &[2.0]);
    assert_eq!(times(&editor, "cylinder", Channel::Rotation), [0.0, 3.0, 4.0]);
}

#[test]
fn the_last_key_of_a_channel_can_go_and_come_again() {
    let all = [0.0, 2.0, 4.0].map(|seconds| key(Channel::Scale, seconds)).to_vec();
    let mut editor = check(SceneEdit::DeleteKeys(all), Channel::Scale, &[]);
    assert_eq!(value(&editor, Channel::Scale, 2.0), KeyValue::Scale(Vec3::ONE));
    edit(&mut editor, SceneEdit::AddKeys(vec![key(Channel::Scale, 1.0)]));
    assert_eq!(times(&editor, "cylinder", Channel::Scale), [1.0]);
}

#[test]
fn colours_have_keys_on_any_shape() {
    let shape = "cylinder/cylinder";
    let mut editor = cylinder();
    let before = bytes(&editor);
    edit(&mut editor, SceneEdit::AddKeys(vec![KeyAt::new(shape, Channel::Colour, 0.5)]));
    let red = KeyValue::Colour(Colour::from_hex("#ff0000").unwrap());
    edit(&mut editor, SceneEdit::SetKey { node: shape.into(), seconds: 1.0, value: red });
    assert_eq!(times(&editor, shape, Channel::Colour), [0.5, 1.0]);
    let text = scene_to_json(editor.scene());
    assert!(text.contains("[0.5, \"#e0803c\"]") && text.contains("[1, \"#ff0000\"]"), "{text}");
    press(&mut editor, "ctrl+z ctrl+z");
    assert_eq!(bytes(&editor), before);
}

#[test]
fn a_drag_of_keys_is_one_step_and_what_it_passes_over_stays() {
    let mut editor = cylinder();
    let before = bytes(&editor);
    apply(&mut editor, Command::Gesture(GestureCommand::Begin));
    for by in [0.5, 1.0, 1.5, 0.75] {
        edit(&mut editor, SceneEdit::MoveKeys { keys: vec![key(Channel::Rotation, 2.0)], by });
    }
    assert_eq!(times(&editor, "cylinder", Channel::Rotation), [0.0, 2.75, 3.0, 4.0]);
    apply(&mut editor, Command::Gesture(GestureCommand::Commit));
    press(&mut editor, "ctrl+z");
    assert_eq!(bytes(&editor), before);
    apply(&mut editor, Command::Gesture(GestureCommand::Begin));
    edit(&mut editor, SceneEdit::MoveKeys { keys: vec![key(Channel::Rotation, 2.0)], by: 1.0 });
    apply(&mut editor, Command::Gesture(GestureCommand::Abort));
    assert_eq!(bytes(&editor), before);
}

#[test]
fn the_delete_key_is_for_what_is_selected() {
    let mut editor = cylinder();
    press(&mut editor, "n");
    let keys = vec![key(Channel::Scale, 2.0), key(Channel::Rotation, 3.0)];
    apply(&mut editor, Command::Selection(SelectionCommand::TimedKeys(keys)));
    assert!(editor.can(&Command::Edit(Edit::Timeline(TimelineEdit::DeleteKeyframes))));
    press(&mut editor, "delete");
    assert_eq!(editor.document().keyframes.len(), 1, "the keyframe stays");
    assert_eq!(times(&editor, "cylinder", Channel::Scale), [0.0, 4.0]);
    assert!(editor.session().selected_keys.is_empty());
    // A selection of keyframes ends one of keys, and the other way round.
    apply(&mut editor, Command::Selection(SelectionCommand::TimedKeys(vec![key(Channel::Scale, 4.0)])));
    apply(&mut editor, Command::Selection(SelectionCommand::Keyframes(vec![KeyframeIndex::new(0)])));
    assert!(editor.session().selected_keys.is_empty());
    apply(&mut editor, Command::Selection(SelectionCommand::TimedKeys(vec![key(Channel::Scale, 4.0)])));
    assert!(editor.session().selected.is_empty());
    press(&mut editor, "ctrl+z");
    assert_eq!(editor.session().selected_keys, [key(Channel::Scale, 4.0)], "it is still there");
}

#[test]
fn a_control_node_is_put_above_any_node_and_taken_away() {
    let mut editor = editor_with(5);
    apply(&mut editor, Command::File(FileCommand::Write));
    editor.keyframes_written(Path::new("animation.json"), Ok(Written::default())).unwrap();
    let before = (bytes(&editor), editor.displayed_pose());
    let head = editor.scene().find_rbt("robot1/head").unwrap();
    let at = |editor: &Editor| editor.scene().world_from_rbt(&editor.displayed_pose(), editor.seconds(), head);
    let stood = at(&editor);
    apply(&mut editor, Command::View(ViewCommand::Choose(Some(head))));
    apply(&mut editor, Command::Edit(Edit::Scene(SceneEdit::PutControlAboveChosen)));
    assert!(editor.message_text().starts_with("robot1/head_control stands above it"), "{}", editor.message_text());
    assert_eq!(at(&editor), stood);
    assert!(!editor.has_unsaved_keyframes(), "the keyframes are what they were");
    let control = || Arc::from("robot1/head_control");
    edit(&mut editor, SceneEdit::RenameControl(control(), " nod ".to_owned()));
    assert!(editor.scene().find("robot1/nod").is_some());
    press(&mut editor, "ctrl+z");
    edit(&mut editor, SceneEdit::SetKey { node: control(), seconds: 0.0, value: KeyValue::Translation(Vec3::Y) });
    assert_ne!(at(&editor), stood);
    edit(&mut editor, SceneEdit::RemoveControl(control()));
    assert_eq!((bytes(&editor), editor.displayed_pose()), before);
    assert_eq!(editor.session().chosen.primary(), Some(head), "the choice stays");
    press(&mut editor, "ctrl+z ctrl+z ctrl+z");
    assert_eq!((bytes(&editor), editor.displayed_pose()), before);
}

#[test]
fn a_lighting_is_part_of_the_scene_and_can_be_undone() {
    let mut editor = cylinder();
    let before = bytes(&editor);
    let said = edit(&mut editor, SceneEdit::SetLighting(BuiltInLighting::Evening));
    assert_eq!(said, "Lighting: Evening.");
    assert!(bytes(&editor).contains("\"lighting\": \"evening\"") && editor.has_unsaved_scene());
    assert!(editor.is_lit_by(BuiltInLighting::Evening) && !editor.is_lit_by(BuiltInLighting::Day));
    let after = bytes(&editor);
    edit(&mut editor, SceneEdit::SetLighting(BuiltInLighting::Evening));
    press(&mut editor, "ctrl+z");
    assert_eq!(bytes(&editor), before, "the same light again is no step");
    press(&mut editor, "ctrl+y");
    assert_eq!(bytes(&editor), after);
}

#[test]
fn what_cannot_be_is_refused_with_a_sentence_and_changes_nothing() {
    let mut editor = cylinder();
    let before = bytes(&editor);
    for (does, sentence) in [
        (SceneEdit::PutControlAbove("x".into()), "The scene has no node \"x\"."),
        (
            SceneEdit::PutControlAboveChosen,
            "No node is chosen. Choose one first: a click on a part, p and a click, or the list of nodes.",
        ),
        (SceneEdit::RemoveControl("sky".into()), "node \"sky\" is not a control node"),
        (SceneEdit::DeleteKeys(vec![key(Channel::Scale, 1.0)]), "cylinder has no key of its scale at 1 s."),
        (SceneEdit::DeleteKeys(Vec::new()), "No keys are selected: click one in the timeline."),
        (SceneEdit::AddKeys(vec![key(Channel::Colour, 1.0)]), "node \"cylinder\": colour_keys are for shapes only"),
        (
            SceneEdit::AddKeys(vec![key(Channel::Scale, 2e6)]),
            "node \"cylinder\": control.scale is at 2000000 s, expected a time between -1e6 and 1e6 seconds",
        ),
        (
            SceneEdit::RenameControl("cylinder".into(), "sky".to_owned()),
            "node \"sky\" stands twice: names are unique under one parent",
        ),
    ] {
        assert_eq!(edit(&mut editor, does), sentence);
        assert_eq!(bytes(&editor), before);
    }
    assert!(editor.undo_label().is_none());
}

#[test]
fn scenes_are_not_edited_while_playing() {
    let mut editor = editor_with(4);
    press(&mut editor, "y");
    let robot = SceneEdit::PutControlAbove("robot1".into());
    assert_eq!(
        edit(&mut editor, robot),
        "Cannot edit the scene while playing. Press y to stop or Shift+P to pause first."
    );
    assert!(editor.is_playing() && !editor.has_unsaved_scene());
}

#[test]
fn a_scene_is_saved_and_opened_again() {
    let mut editor = editor();
    assert_eq!(apply(&mut editor, Command::File(FileCommand::WriteScene)), [Effect::ChooseSaveSceneAs]);
    edit(&mut editor, SceneEdit::PutControlAbove("robot1".into()));
    assert_eq!(editor.proposed_scene_path(), PathBuf::from("two-robots.json"));
    let effects = apply(&mut editor, Command::File(FileCommand::SaveSceneAs("lamp.json".into())));
    let [Effect::WriteScene { path, files, is_known: false }] = effects.as_slice() else { panic!("{effects:?}") };
    let SceneFiles { text, meshes: None } = files else { panic!("{files:?}") };
    assert_eq!(*text, scene_to_json(editor.scene()));
    assert!(editor.has_unsaved_scene(), "it is not written yet");
    assert!(editor.scene_written(path, Err(texts::STORAGE_PERMISSION_DENIED.into())).is_err());
    assert_eq!((editor.message_text().as_str(), editor.scene_path()), ("lamp.json: permission denied", None));
    editor.scene_written(path, Ok(Written::default())).unwrap();
    assert_eq!(editor.message_text(), "Wrote the scene to lamp.json.");
    assert!(!editor.has_unsaved_changes());
    let again = scene_from_json(text).unwrap();
    assert!(again == **editor.scene());
    assert_eq!(scene_to_json(&again), *text);
    // From then on it has a file of its own.
    let effects = apply(&mut editor, Command::File(FileCommand::WriteScene));
    assert!(matches!(effects.as_slice(), [Effect::WriteScene { is_known: true, .. }]));
    press(&mut editor, "ctrl+z");
    assert!(editor.has_unsaved_scene(), "the file has the control node");
}

#[test]
fn a_scrubbed_time_is_held_until_something_plays() {
    let mut editor = cylinder();
    let scrub = |editor: &mut Editor, seconds| apply(editor, Command::View(ViewCommand::ScrubSeconds(seconds)));
    editor.tick(30);
    scrub(&mut editor, 1.25);
    editor.tick(60);
    assert_eq!((editor.seconds(), editor.holds_timed_keys()), (1.25, true));
    scrub(&mut editor, -3.0);
    assert_eq!(editor.seconds(), 0.0);
    apply(&mut editor, Command::View(ViewCommand::ScrubSeconds(f64::NAN)));
    assert_eq!((editor.seconds(), editor.message_text().as_str()), (0.0, "That is not a time: nothing was changed."));
    press(&mut editor, "n n n n");
    scrub(&mut editor, 1.0);
    apply(&mut editor, Command::Playback(PlaybackCommand::Scrub(0.5)));
    apply(&mut editor, Command::Playback(PlaybackCommand::PlayFromPlayhead));
    assert_eq!((editor.seconds(), editor.holds_timed_keys()), (1.0, false));
    editor.tick(30);
    assert_eq!((editor.seconds(), editor.playhead()), (1.5, Some(0.75)), "both go on together");
    press(&mut editor, "y");
    scrub(&mut editor, 3.0);
    press(&mut editor, "y");
    assert_eq!(editor.seconds(), 0.0, "playing from the start");
    // A clock that somebody holds stays held.
    press(&mut editor, "y shift+home");
    scrub(&mut editor, 2.0);
    press(&mut editor, "y");
    assert_eq!((editor.seconds(), editor.holds_timed_keys()), (2.0, true));
    press(&mut editor, "y shift+home");
    scrub(&mut editor, 2.0);
    press(&mut editor, "home");
    assert_eq!((editor.seconds(), editor.holds_timed_keys()), (0.0, false));
}
