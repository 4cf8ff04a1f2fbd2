//! Items of menus: each asks for its own command, and what is chosen there is what script lines choose.

use egui::accesskit::Role;
use egui::vec2;
use egui_kittest::Harness;
use egui_kittest::kittest::{AccessKitNode, NodeT as _, Queryable as _};
use inbetween::editor::commands::{Binding, Menu};
use inbetween::editor::gizmo::SnapSteps;
use inbetween::editor::keymap::bindings;
use inbetween::editor::{Command, Edit, Editor, Effect, FileCommand, ViewCommand};
use inbetween::keyframe::KeyframeIndex;
use inbetween::script::script_commands;
use inbetween::ui::PathPurpose;

use crate::{App, click, does, editor, editor_of, harness_of};

const MENUS: [(Menu, &str); 5] = [
    (Menu::File, "File"),
    (Menu::Edit, "Edit"),
    (Menu::View, "View"),
    (Menu::Animation, "Animation"),
    (Menu::Help, "Help"),
];

/// An editor in which nearly everything can be done.
fn busy() -> Editor {
    let mut editor = editor(6);
    let lines = "select robot1/left_shoulder\ncopy-pose\nselect-keyframes 2 3\ncopy\nrotate z 30\nundo";
    for command in script_commands(lines.as_bytes(), editor.scene()).unwrap() {
        editor.apply(command).unwrap();
    }
    editor
}

/// What the item of a binding says.
fn label_of(binding: &Binding) -> String {
    format!("{} {}", binding.title().english(), binding.menu_key())
}

/// What the menus call these says what they would do now.
fn has_another_name(command: &Command) -> bool {
    let play = bindings().into_iter().filter(|binding| ["play-or-stop", "pause-or-resume"].contains(&binding.id));
    matches!(command, Command::Undo | Command::Redo) || play.map(|binding| binding.command).any(|one| one == *command)
}

/// The panels of an editor in a window in which every menu has room.
fn harness(editor: Editor) -> Harness<'static, App> {
    harness_of(App::new(editor), vec2(1280.0, 1600.0))
}

#[test]
fn every_item_of_a_menu_is_its_command() {
    let mut tried = 0;
    for (menu, title) in MENUS {
        for binding in bindings().iter().filter(|binding| binding.menu == menu && !has_another_name(&binding.command)) {
            let editor = busy();
            let is_enabled = editor.can(&binding.command);
            let mut harness = harness(editor);
            harness.get_all_by_label(title).next().unwrap().click();
            harness.run();
            let label = label_of(binding);
            for submenu in ["Look", "Lighting", "Axes of the handles"] {
                let opens = |node: &AccessKitNode<'_>| node.label().is_some_and(|label| label.trim() == submenu);
                if harness.query_by_label(&label).is_none() && harness.query_all_by(opens).count() == 1 {
                    harness.get_by(opens).click();
                    harness.run();
                }
            }
            let item = harness.query_by_label(&label).unwrap_or_else(|| panic!("{title} has no {label}"));
            assert_eq!(!item.accesskit_node().is_disabled(), is_enabled, "{}", binding.id);
            if is_enabled {
                item.click();
                harness.step();
                harness.step();
            }
            let expected = if is_enabled { vec![binding.command.clone()] } else { Vec::new() };
            assert_eq!(harness.state().commands, expected, "{}", binding.id);
            tried += usize::from(is_enabled);
        }
    }
    assert!(tried > 80, "{tried}");
}

fn choose(harness: &mut Harness<'_, App>, menu: &str, submenu: &str, item: &str) {
    harness.get_all_by_label(menu).next().unwrap().click();
    harness.run();
    harness.get_by_label_contains(submenu).click();
    harness.run();
    click(harness, item);
}

#[test]
fn steps_of_drags_that_snap_are_chosen_in_menus() {
    let mut harness = harness(editor(0));
    choose(&mut harness, "View", "Snap turns to", "5°");
    choose(&mut harness, "View", "Snap moves to", "0.1");
    let snap = SnapSteps { degrees: 5.0, units: 0.1 };
    assert_eq!(harness.state().editor.session().snap, snap);
    let by_line = script_commands(b"snap 5 0.1", harness.state().editor.scene()).unwrap();
    assert_eq!(harness.state().commands.last(), by_line.last());
    // A step that only a script can set is offered as long as it is in force.
    does(&mut harness, Command::View(ViewCommand::SetSnapSteps(SnapSteps { degrees: 7.5, units: 0.1 })));
    choose(&mut harness, "View", "Snap turns to", "7.5°");
    choose(&mut harness, "View", "Snap turns to", "90°");
    harness.get_all_by_label("View").next().unwrap().click();
    harness.run();
    harness.get_by_label_contains("Snap turns to").click();
    harness.run();
    assert!(harness.query_by_label("7.5°").is_none());
}

#[test]
fn what_is_selected_is_said_to_screen_readers() {
    let mut harness = harness(editor(3));
    does(&mut harness, Command::Edit(Edit::GoTo(KeyframeIndex::new(1))));
    click(&mut harness, "robot2");
    let is_selected =
        |role: Role, label: &str| harness.get_by_role_and_label(role, label).accesskit_node().is_selected();
    let is_item_selected = |label: &str| is_selected(Role::ListBoxOption, label);
    assert_eq!(
        ["Keyframe 0", "Keyframe 1", "Keyframe 2"].map(is_item_selected),
        [Some(false), Some(true), Some(false)]
    );
    assert_eq!(["robot1", "robot2"].map(is_item_selected), [Some(false), Some(true)]);
    assert_eq!(["Keyframes", "Graphs"].map(|label| is_selected(Role::Tab, label)), [Some(true), Some(false)]);
}

#[test]
fn a_click_in_the_tree_on_what_only_keys_move_selects_its_keys() {
    let mut harness = harness(editor_of("cylinder", 0));
    // The shape has no keys of its own: those of the node that moves it.
    for label in ["cylinder", "cylinder/cylinder"] {
        click(&mut harness, label);
        assert_eq!(harness.state().editor.session().selected_keys.len(), 10, "{label}");
    }
}

#[test]
fn a_pose_is_pasted_mirrored_by_the_menu_of_a_node() {
    let mut harness = harness(editor(0));
    let mut by_lines = editor(0);
    let turn = "select robot1/left_shoulder\nrotate z 40\nselect none";
    let paste = "copy-pose robot1/left_shoulder\npaste-pose mirrored robot1/right_shoulder";
    for command in script_commands(turn.as_bytes(), by_lines.scene()).unwrap() {
        by_lines.apply(command.clone()).unwrap();
        harness.state_mut().apply(command);
    }
    for command in script_commands(paste.as_bytes(), by_lines.scene()).unwrap() {
        by_lines.apply(command).unwrap();
    }
    for (node, item) in [("robot1/left_shoulder", "Copy pose"), ("robot1/right_shoulder", "Paste pose mirrored")] {
        harness.get_by_label(node).click_secondary();
        harness.run();
        harness.get_by_label_contains(item).click();
        harness.run();
    }
    assert_eq!(harness.state().editor.document().live_pose, by_lines.document().live_pose);
    assert_ne!(by_lines.document().live_pose, *by_lines.scene().rest_pose());
}

#[test]
fn another_animation_is_asked_for_and_compared_with() {
    let mut harness = harness(editor(4));
    click(&mut harness, "File");
    harness.get_by_label_contains("Compare with…").click();
    harness.run();
    assert_eq!(harness.state().effects, [Effect::ChooseCompare]);
    harness.state_mut().ui.ask_for_path(PathPurpose::Compare, &std::path::PathBuf::from("teacher.json"));
    harness.run();
    crate::press(&mut harness, egui::Key::Enter);
    let by_line = script_commands(b"compare-with teacher.json", harness.state().editor.scene()).unwrap();
    assert_eq!(harness.state().commands.last(), by_line.last());
    assert!(matches!(by_line[..], [Command::File(FileCommand::CompareWith(_))]));
}
