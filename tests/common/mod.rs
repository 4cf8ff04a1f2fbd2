//! An editor at the end of a keyboard: keys in, state out.

#![allow(dead_code, reason = "each test file uses its part")]

use std::path::PathBuf;
use std::sync::Arc;

use glam::Vec3;
use inbetween::editor::keymap::{binding_for, bindings, press_from_word};
use inbetween::editor::{Command, Edit, Editor, Effect};
use inbetween::interpolation::Interpolation;
use inbetween::keyframe::{KeyframeIndex, MS_BETWEEN_KEYFRAMES_RANGE};
use inbetween::pose::Pose;
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};

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
    assert!(editor.session().eye < editor.scene().eyes().len());
}
