//! Reset, mirror, copy and paste of poses: by script lines and by hotkeys.

mod common;

use common::{apply, editor, press};
use glam::{Quat, Vec3};
use inbetween::editor::{Command, Editor};
use inbetween::rbt::Rbt;
use inbetween::script::script_commands;

const LEFT: &str = "robot1/left_shoulder";
const RIGHT: &str = "robot1/right_shoulder";

/// Runs lines; the answer is what the last one says.
fn run(editor: &mut Editor, script: &str) -> String {
    for command in script_commands(script.as_bytes(), editor.scene()).unwrap() {
        apply(editor, command);
    }
    editor.message_text()
}

fn live(editor: &Editor, path: &str) -> Rbt {
    editor.document().live_pose.get(editor.scene().find_rbt(path).unwrap())
}

/// The paths of the nodes whose places differ from those at rest.
fn changed(editor: &Editor) -> Vec<&str> {
    let scene = editor.scene();
    let differs = |rbt: &_| {
        let (live, rest) = (editor.document().live_pose.get(*rbt), scene.rest_pose().get(*rbt));
        live.translation.distance(rest.translation) > 1e-6 || live.rotation.dot(rest.rotation).abs() < 1.0 - 1e-6
    };
    scene.rbt_indices().filter(differs).map(|rbt| scene.rbt_path(rbt)).collect()
}

#[track_caller]
fn check_turned(editor: &Editor, path: &str, rotation: Quat) {
    let found = live(editor, path).rotation;
    assert!(found.dot(rotation).abs() > 1.0 - 1e-6, "{path}: {found} is not {rotation}");
}

fn about_z(degrees: f32) -> Quat {
    Quat::from_rotation_z(degrees.to_radians())
}

/// Robot 1 with its left arm up, and the elbow bent forward.
fn with_an_arm_up() -> Editor {
    let mut editor = editor();
    run(&mut editor, &format!("select {LEFT}\nrotate z -60\nselect {LEFT}/left_elbow\nrotate y 40\nselect {LEFT}"));
    editor
}

#[test]
fn a_limb_is_mirrored_to_the_other_side() {
    let mut editor = with_an_arm_up();
    assert_eq!(run(&mut editor, &format!("mirror {LEFT}")), format!("Mirrored {LEFT} to {RIGHT}."));
    check_turned(&editor, RIGHT, about_z(60.0));
    check_turned(&editor, "robot1/right_shoulder/right_elbow", Quat::from_rotation_y(-40f32.to_radians()));
    check_turned(&editor, LEFT, about_z(-60.0));
    assert!(live(&editor, RIGHT).translation.distance(Vec3::new(0.5, 0.75, 0.0)) < 1e-6);
    assert_eq!(run(&mut editor, "undo"), "Undone: mirroring of a pose.");
    check_turned(&editor, RIGHT, Quat::IDENTITY);
}

#[test]
fn a_robot_is_mirrored_in_place_and_the_chosen_sides_are_swapped() {
    let mut whole = with_an_arm_up();
    run(&mut whole, "select robot1\ntranslate 0.3 0 1\nrotate y 90\nrotate z 10\nselect robot1/head\nrotate y 20");
    let before = live(&whole, "robot1");
    assert_eq!(run(&mut whole, "mirror robot1"), "Mirrored robot1.");
    check_turned(&whole, RIGHT, about_z(60.0));
    check_turned(&whole, LEFT, Quat::IDENTITY);
    check_turned(&whole, "robot1/head", Quat::from_rotation_y(-20f32.to_radians()));
    // It stays where it is and looks where it looked, and leans to the other side.
    assert_eq!(live(&whole, "robot1").translation, before.translation);
    check_turned(&whole, "robot1", Quat::from_rotation_y(90f32.to_radians()) * about_z(-10.0));

    let mut sides = with_an_arm_up();
    run(&mut sides, &format!("select-also {RIGHT}"));
    press(&mut sides, "ctrl+m");
    assert_eq!(sides.message_text(), "Mirrored 2 nodes.");
    check_turned(&sides, RIGHT, about_z(60.0));
    check_turned(&sides, LEFT, Quat::IDENTITY);
}

#[test]
fn a_copied_limb_is_pasted_mirrored() {
    // To the other side; where the copied side is still chosen, that is meant too; to the other robot.
    for (chosen, target) in [
        (RIGHT, RIGHT),
        (LEFT, RIGHT),
        ("robot2/right_shoulder", "robot2/right_shoulder"),
        ("robot2/left_shoulder", "robot2/right_shoulder"),
    ] {
        let mut editor = with_an_arm_up();
        press(&mut editor, "ctrl+shift+c");
        run(&mut editor, &format!("select {chosen}"));
        press(&mut editor, "ctrl+shift+m");
        assert_eq!(editor.message_text(), format!("Pasted the mirrored pose of {LEFT} to {chosen}."));
        check_turned(&editor, target, about_z(60.0));
        let paths = [target.to_owned(), format!("{target}/right_elbow"), LEFT.to_owned(), format!("{LEFT}/left_elbow")];
        let changed = changed(&editor);
        assert!(changed.len() == 4 && paths.iter().all(|path| changed.contains(&path.as_str())), "{changed:?}");
    }
}

#[test]
fn a_pose_is_pasted_to_each_chosen_node() {
    let mut editor = with_an_arm_up();
    let said = run(
        &mut editor,
        &format!("copy-pose {LEFT}\nselect robot2/left_shoulder\nselect-also {LEFT}\nreset-node\npaste-pose"),
    );
    assert_eq!(said, format!("Pasted the pose of {LEFT} to 2 nodes."));
    check_turned(&editor, "robot2/left_shoulder", about_z(-60.0));
    check_turned(&editor, LEFT, about_z(-60.0));
    let said = run(&mut editor, "paste-pose mirrored robot1/head");
    assert_eq!(said, "The copied pose has a node \"right_elbow\" that \"robot1/head\" has not.");
}

#[test]
fn a_node_returns_to_rest_in_part_or_whole() {
    let moved = || {
        let mut editor = with_an_arm_up();
        run(&mut editor, "translate 0 1 0");
        editor
    };
    let rest = Vec3::new(-0.5, 0.75, 0.0);
    for (keys, line, is_turned, is_moved) in [
        ("alt+r", "reset-node rotation", false, true),
        ("alt+g", "reset-node translation", true, false),
        ("", "reset-node", false, false),
    ] {
        let mut by_line = moved();
        assert_eq!(run(&mut by_line, line), format!("Returned to rest: {LEFT}."));
        assert_eq!(live(&by_line, LEFT).rotation != Quat::IDENTITY, is_turned, "{line}");
        assert_eq!(live(&by_line, LEFT).translation != rest, is_moved, "{line}");
        assert_ne!(live(&by_line, "robot1/left_shoulder/left_elbow").rotation, Quat::IDENTITY, "{line}");
        let mut by_path = moved();
        run(&mut by_path, &format!("select none\n{line} {LEFT}"));
        assert_eq!(by_path.document().live_pose, by_line.document().live_pose);
        let mut by_key = moved();
        press(&mut by_key, keys);
        assert!(keys.is_empty() || by_key.document().live_pose == by_line.document().live_pose, "{keys}");
        apply(&mut by_line, Command::Undo);
        assert_eq!(by_line.document().live_pose, moved().document().live_pose);
    }
}

#[test]
fn what_cannot_be_done_is_said() {
    let mut editor = editor();
    let pick = "No node is chosen. Choose one first: a click on a part, p and a click, or the list of nodes.";
    for (line, said) in [
        ("mirror", pick),
        ("reset-node", pick),
        ("copy-pose", pick),
        ("paste-pose mirrored", pick),
        ("paste-pose robot1", "No pose is copied yet: choose a node and copy its pose first."),
    ] {
        assert_eq!(run(&mut editor, line), said, "{line}");
    }
}
