//! An editor at the end of a keyboard: keys in, state out.

#![allow(dead_code, reason = "each test file uses its part")]

use std::path::PathBuf;
use std::sync::Arc;

use glam::Vec3;
use inbetween::editor::gizmo::{Axis, GizmoAxes, Handle, HandleKind, Pull};
use inbetween::editor::keymap::{binding_for, bindings, press_from_word};
use inbetween::editor::{
    Command, Document, Edit, Editor, Effect, GestureCommand, KeyAt, NodeEdit, NodePart, TimelineEdit,
};
use inbetween::interpolation::Interpolation;
use inbetween::keyframe::{
    KeyframeIndex, MS_BETWEEN_KEYFRAMES_RANGE, file_bytes_at_most, keyframes_from_json, keyframes_to_json,
};
use inbetween::pose::{Pose, RbtIndex};
use inbetween::rbt::Rbt;
use inbetween::rotation_rules::Mending;
use inbetween::scene::{DEFAULT_SCENE, built_in_scene, scene_from_json, scene_to_json};
use proptest::prelude::*;

/// An editor of the built-in scene, with nothing in its list.
pub fn editor() -> Editor {
    let scene = built_in_scene(DEFAULT_SCENE).expect("it is built in");
    Editor::new(Arc::new(scene), PathBuf::from("animation.json"))
}

/// Applies a command; refusals are messages. The editor's invariants are asserted after it.
pub fn apply(editor: &mut Editor, command: Command) -> Vec<Effect> {
    let shown = format!("{command:?}");
    let effects = editor.apply(command).unwrap_or_default().into_iter().collect();
    assert_invariants(editor, &shown);
    effects
}

/// Presses keys, given as a script would: `n n > ctrl+z`.
pub fn press(editor: &mut Editor, keys: &str) -> Vec<Effect> {
    let table = bindings();
    let mut effects = Vec::new();
    for word in keys.split_whitespace() {
        let press = press_from_word(word).unwrap_or_else(|| panic!("{word} is no key"));
        let binding = binding_for(&table, press).unwrap_or_else(|| panic!("{word} is bound to nothing"));
        effects.extend(apply(editor, binding.command.clone()));
    }
    effects
}

/// Poses the scene so that it can be told apart: robot 1 stands at this x.
pub fn pose(editor: &mut Editor, x: f32) {
    let robot = editor.scene().find_rbt("robot1").expect("the scene has it");
    apply(editor, Command::Edit(Edit::SetTranslation(robot, Vec3::new(x, 1.0, 0.0))));
}

/// Robot 1's x in a pose.
pub fn x_in(editor: &Editor, pose: &Pose) -> f32 {
    pose.get(editor.scene().find_rbt("robot1").expect("the scene has it")).translation.x
}

/// An editor with keyframes told apart by robot 1's x: 0, 1, 2, and so on; the last is current.
pub fn editor_with(keyframes: usize) -> Editor {
    let mut editor = editor();
    for place in 0..keyframes {
        pose(&mut editor, place as f32);
        press(&mut editor, "n");
    }
    editor
}

/// The list as text: the x of each keyframe, the current one in brackets, and after a bar the x on screen.
pub fn shown(editor: &Editor) -> String {
    let document = editor.document();
    let current = document.keyframes.current().map(KeyframeIndex::get);
    let list: Vec<String> = document
        .keyframes
        .as_slice()
        .iter()
        .enumerate()
        .map(|(place, keyframe)| {
            let x = x_in(editor, &keyframe.pose);
            if current == Some(place) { format!("[{x}]") } else { x.to_string() }
        })
        .collect();
    format!("{} | {}", list.join(" "), x_in(editor, &editor.displayed_pose()))
}

/// What holds after every command.
#[track_caller]
pub fn assert_invariants(editor: &Editor, after: &str) {
    let document = editor.document();
    let keyframes = &document.keyframes;
    assert_eq!(keyframes.current().is_none(), keyframes.is_empty(), "after {after}: current and empty disagree");
    assert!(keyframes.current().is_none_or(|index| index.get() < keyframes.len()), "after {after}: current is beyond");
    assert!(MS_BETWEEN_KEYFRAMES_RANGE.contains(&document.ms_between_keyframes), "after {after}: pace out of range");
    assert!(Interpolation::ALL.contains(&document.interpolation));
    let count = editor.scene().rbt_count();
    let poses = keyframes.as_slice().iter().map(|keyframe| &keyframe.pose).chain([&document.live_pose]);
    for pose in poses {
        assert_eq!(pose.len(), count, "after {after}: a pose of another length");
    }
    for rbt in editor.displayed_pose().iter() {
        assert!(rbt.is_finite(), "after {after}: {rbt:?}");
        assert!((rbt.rotation.length() - 1.0).abs() < 2e-6, "after {after}: {rbt:?}");
    }
    assert!(!(editor.is_playing() && keyframes.len() < 4), "after {after}: plays too short a list");
    assert!(!(editor.is_playing() && editor.is_dragging()), "after {after}: plays during a drag");
    assert!(editor.session().eye.recorded().is_none_or(|eye| eye < editor.scene().eyes().len()));
    let (session, scene) = (editor.session(), editor.scene());
    assert!(session.chosen.iter().all(|rbt| rbt.get() < count), "after {after}: what is chosen is in no scene");
    assert!(
        session.selected.iter().all(|index| index.get() < keyframes.len()),
        "after {after}: selected beyond the list"
    );
    assert!(session.selected.is_sorted(), "after {after}: the selection is in no order");
    assert!(session.play_range.is_none_or(|(first, last)| 1 <= first && first < last && last + 1 < keyframes.len()));
    assert!(editor.edited_keyframes().iter().all(|&index| index < keyframes.len()), "after {after}: edits go beyond");
    assert!(session.selected.is_empty() || session.selected_keys.is_empty(), "after {after}: two selections");
    for KeyAt { track, seconds } in &session.selected_keys {
        let id = scene.find(&track.node).unwrap_or_else(|| panic!("after {after}: a key of no node"));
        assert!(scene.key_seconds(id, track.channel).contains(seconds), "after {after}: a key that is not there");
    }
    assert!(
        editor.key_time().is_none_or(|key_time| key_time + 2.0 <= keyframes.len() as f64),
        "after {after}: playhead"
    );
    let is_held =
        |rbt: Rbt| rbt.is_in_bounds() && Mending::of_length(rbt.rotation.as_dquat().length()) == Mending::Keep;
    assert!(document.live_pose.iter().all(is_held), "after {after}: {:?}", document.live_pose);
}

/// How many commands are random; more by hand: `JOURNAL_COMMANDS=1000000 cargo test --release --test journal --test random_commands random`.
pub fn random_commands() -> usize {
    std::env::var("JOURNAL_COMMANDS").ok().and_then(|count| count.parse().ok()).unwrap_or(20_000)
}

/// What is saved reads back as it was: the keyframes and the scene.
#[track_caller]
pub fn assert_reads_back(editor: &Editor) {
    let document = editor.document();
    let text =
        keyframes_to_json(editor.scene(), &document.keyframes, document.interpolation, document.ms_between_keyframes);
    assert!(text.len() as u64 <= file_bytes_at_most(editor.scene(), &document.keyframes));
    let file = keyframes_from_json(text.as_bytes(), editor.scene()).unwrap_or_else(|problems| panic!("{problems:?}"));
    let (keyframes, interpolation, ms) = file.into_parts();
    assert!(keyframes.same_keyframes(&document.keyframes), "the keyframes read back otherwise");
    assert_eq!((interpolation, ms), (document.interpolation, document.ms_between_keyframes));
    let text = scene_to_json(editor.scene());
    assert!(text.len() as u64 <= editor.scene().file_bytes_at_most());
    assert_eq!(&scene_from_json(&text).unwrap(), &**editor.scene());
}

/// Files of other people, good and bad: other lengths, another scene, texts, and none of these.
pub fn other_files() -> Vec<Vec<u8>> {
    let list = |editor: &Editor| {
        let Document { keyframes, interpolation, ms_between_keyframes, .. } = editor.document();
        keyframes_to_json(editor.scene(), keyframes, *interpolation, *ms_between_keyframes).into_bytes()
    };
    let mut files: Vec<Vec<u8>> = (0..7).map(|count| list(&editor_with(count))).collect();
    let orbits = Editor::new(Arc::new(built_in_scene("orbits").expect("it is built in")), PathBuf::from("a.json"));
    let named = |mut editor: Editor| {
        apply(
            &mut editor,
            Command::Edit(Edit::Timeline(TimelineEdit::RenameKeyframe(KeyframeIndex::new(0), "a #\"b".into()))),
        );
        list(&editor)
    };
    files.push(named(editor_with(4)));
    files.push(list(&orbits));
    files.push(scene_to_json(orbits.scene()).into_bytes());
    let row = "0.5 1 2 0 0 0 1\n";
    files.push(row.repeat(22 * 5).into_bytes());
    files.push(("2 22\n".to_owned() + &row.repeat(22 * 2)).into_bytes());
    files.push(row.repeat(22).replacen("0.5", "2e6", 1).into_bytes());
    files.push(b"{0: vec(0, 1, 0), 2: vec(1, 1, 0)}".to_vec());
    files.extend([b"1 2 3\n".to_vec(), b"\xff\xfe\x00".to_vec(), b"{\"format\": 3}".to_vec(), Vec::new()]);
    files
}

/// Any edit of a node whatever its place.
pub fn any_node_edit() -> impl Strategy<Value = NodeEdit> {
    proptest::sample::select(&[
        NodeEdit::Mirror,
        NodeEdit::Paste { is_mirrored: false },
        NodeEdit::Paste { is_mirrored: true },
        NodeEdit::Reset(NodePart::Both),
        NodeEdit::Reset(NodePart::Rotation),
        NodeEdit::Reset(NodePart::Translation),
    ])
}

/// A node of the built-in scene, or one that is not in it.
pub fn any_rbt_index() -> impl Strategy<Value = RbtIndex> {
    (0usize..24).prop_map(RbtIndex::new)
}

/// Pulls of handles, by such numbers.
pub fn any_pull(number: impl Strategy<Value = f64> + Clone + 'static) -> impl Strategy<Value = Pull> {
    let (axis, axes) = (prop::sample::select(&Axis::ALL), prop::sample::select(&GizmoAxes::ALL));
    let turn =
        (axis, number.clone(), axes.clone()).prop_map(|(axis, degrees, axes)| Pull::Turn { axis, degrees, axes });
    let along = (prop::array::uniform3(number), axes).prop_map(|(by, axes)| Pull::Move { by, axes });
    prop_oneof![turn, along]
}

/// Drags of handles: taken, pulled by such numbers, and by keys.
pub fn any_hold(number: impl Strategy<Value = f64> + Clone + 'static) -> impl Strategy<Value = GestureCommand> {
    let kinds = [HandleKind::Turn, HandleKind::Move, HandleKind::Plane];
    let (kind, axis) = (prop::sample::select(kinds.to_vec()), prop::sample::select(&Axis::ALL));
    let handle = (kind, axis, prop::sample::select(&GizmoAxes::ALL));
    prop_oneof![
        2 => handle.prop_map(|(kind, axis, axes)| GestureCommand::Grab(Handle { kind, axis, axes })),
        4 => any_pull(number).prop_map(GestureCommand::Pull),
        1 => prop::sample::select(&Axis::ALL).prop_map(GestureCommand::Lock),
        3 => prop::sample::select("0123456789.-".chars().collect::<Vec<_>>()).prop_map(GestureCommand::Type),
        1 => Just(GestureCommand::Erase),
    ]
}
