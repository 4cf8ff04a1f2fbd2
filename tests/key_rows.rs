//! Rows of keys at their own times, driven by pointer and keyboard with no window: each operation leaves the editor as its command would,
//! and undo returns the scene to the same bytes.

mod common;

use std::path::PathBuf;
use std::sync::Arc;

use common::{apply, press};
use egui::{CursorIcon, Event, Key, Modifiers, PointerButton, Pos2, Role, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use glam::Vec3;
use inbetween::editor::{Command, Editor, FileCommand, ViewCommand};
use inbetween::scene::{Channel, KeyValue, built_in_scene, scene_to_json};
use inbetween::ui::{Panels, PathPurpose, theme};

struct App {
    editor: Editor,
    ui: Panels,
    commands: Vec<Command>,
    is_dressed: bool,
    cursor: CursorIcon,
}

type Panel = Harness<'static, App>;

/// A timeline of a scene with no keyframes; the clock of its keys stands at 1 s.
fn panel(scene: &str) -> Panel {
    let scene = Arc::new(built_in_scene(scene).unwrap());
    let mut editor = Editor::new(scene, PathBuf::from("animation.json"));
    apply(&mut editor, Command::View(ViewCommand::ScrubSeconds(1.0)));
    let app = App { editor, ui: Panels::new(), commands: Vec::new(), is_dressed: false, cursor: CursorIcon::Default };
    let mut harness = Harness::builder()
        .with_size(vec2(1280.0 + theme::SIDE, 900.0))
        .with_max_steps(60)
        .with_step_dt(1.0 / 60.0)
        .build_ui_state(
            |ui, app: &mut App| {
                if !std::mem::replace(&mut app.is_dressed, true) {
                    theme::install(ui.ctx());
                }
                for command in app.ui.show(ui, &app.editor).commands {
                    apply(&mut app.editor, command.clone());
                    app.commands.push(command);
                }
                app.cursor = ui.output(|output| output.cursor_icon);
            },
            app,
        );
    harness.run();
    // All rows are in sight.
    let edge = harness.get_by_label("Edge of the timeline").rect().center();
    drag(&mut harness, edge, edge - vec2(0.0, 240.0));
    harness.state_mut().commands.clear();
    harness
}

fn bytes(harness: &Panel) -> String {
    scene_to_json(harness.state().editor.scene())
}

fn times(harness: &Panel, path: &str, channel: Channel) -> Vec<f64> {
    let scene = harness.state().editor.scene();
    scene.key_seconds(scene.find(path).unwrap(), channel).to_vec()
}

fn selected(harness: &Panel) -> Vec<(Channel, f64)> {
    let keys = &harness.state().editor.session().selected_keys;
    keys.iter().map(|key| (key.track.channel, key.seconds)).collect()
}

/// Where a key of the cylinder stands.
fn at(harness: &Panel, channel: &str, seconds: &str) -> Pos2 {
    let label = format!("{channel} of cylinder at {seconds} s");
    harness.get_by_role_and_label(Role::ListBoxOption, &label).rect().center()
}

fn hold(harness: &mut Panel, modifiers: Modifiers) {
    harness.event(Event::ModifiersChanged(modifiers));
    harness.run();
}

fn button(harness: &mut Panel, at: Pos2, button: PointerButton, pressed: bool) {
    harness.event(Event::PointerButton { pos: at, button, pressed, modifiers: Modifiers::NONE });
    harness.run();
}

fn click_with(harness: &mut Panel, at: Pos2, modifiers: Modifiers) {
    hold(harness, modifiers);
    harness.hover_at(at);
    harness.run();
    button(harness, at, PointerButton::Primary, true);
    button(harness, at, PointerButton::Primary, false);
    hold(harness, Modifiers::NONE);
}

fn double_click(harness: &mut Panel, at: Pos2) {
    harness.hover_at(at);
    harness.step();
    for _ in 0..2 {
        for pressed in [true, false] {
            let modifiers = Modifiers::NONE;
            harness.event(Event::PointerButton { pos: at, button: PointerButton::Primary, pressed, modifiers });
        }
        harness.step();
    }
    harness.run();
}

fn press_and_move(harness: &mut Panel, from: Pos2, to: Pos2) {
    harness.hover_at(from);
    harness.run();
    button(harness, from, PointerButton::Primary, true);
    for step in 1..=4u8 {
        harness.hover_at(from + (to - from) * (f32::from(step) / 4.0));
        harness.run();
    }
}

fn drag(harness: &mut Panel, from: Pos2, to: Pos2) {
    press_and_move(harness, from, to);
    button(harness, to, PointerButton::Primary, false);
}

fn secondary_click(harness: &mut Panel, at: Pos2) {
    harness.hover_at(at);
    harness.run();
    button(harness, at, PointerButton::Secondary, true);
    button(harness, at, PointerButton::Secondary, false);
}

fn click(harness: &mut Panel, label: &str) {
    harness.get_by_label(label).click();
    harness.run();
}

fn type_number(harness: &mut Panel, field: &str, number: &str) {
    click(harness, field);
    harness.key_press_modifiers(Modifiers::CTRL, Key::A);
    harness.event(Event::Text(number.to_owned()));
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
}

/// What pointer or keyboard does changes the cylinder's scene, and one undo returns it to the same bytes.
#[track_caller]
fn check(does: impl FnOnce(&mut Panel), channel: Channel, expected: &[f64]) -> Panel {
    let mut harness = panel("cylinder");
    let before = bytes(&harness);
    does(&mut harness);
    let after = bytes(&harness);
    assert_ne!(after, before);
    assert_eq!(times(&harness, "cylinder", channel), expected);
    press(&mut harness.state_mut().editor, "ctrl+z");
    assert_eq!(bytes(&harness), before, "one undo takes it back");
    press(&mut harness.state_mut().editor, "ctrl+y");
    assert_eq!(bytes(&harness), after);
    harness
}

#[test]
fn a_double_click_adds_a_key_and_the_button_adds_one_at_the_playhead() {
    check(
        |harness| {
            let (from, to) = (at(harness, "Scale", "2"), at(harness, "Scale", "4"));
            double_click(harness, from + (to - from) * 0.5);
            assert_eq!(selected(harness), [(Channel::Scale, 3.0)]);
        },
        Channel::Scale,
        &[0.0, 2.0, 3.0, 4.0],
    );
    let harness = check(
        |harness| click(harness, "Add a key at the playhead: Keys: Translation of cylinder"),
        Channel::Translation,
        &[0.0, 1.0, 2.0, 4.0],
    );
    let scene = harness.state().editor.scene();
    let value = scene.key_value_at(scene.find("cylinder").unwrap(), Channel::Translation, 1.0);
    assert_eq!(value, Some(KeyValue::Translation(Vec3::new(0.5, 0.5, 0.0))), "as it was there");
    // The button of the control node keys all its channels.
    let harness = check(
        |harness| click(harness, "Add a key at the playhead: cylinder"),
        Channel::Rotation,
        &[0.0, 1.0, 2.0, 3.0, 4.0],
    );
    assert_eq!(times(&harness, "cylinder", Channel::Scale), [0.0, 1.0, 2.0, 4.0]);
}

#[test]
fn clicks_select_and_show_the_time() {
    let mut harness = panel("cylinder");
    let place = at(&harness, "Rotation", "3");
    click_with(&mut harness, place, Modifiers::NONE);
    assert_eq!(selected(&harness), [(Channel::Rotation, 3.0)]);
    assert_eq!(harness.state().editor.seconds(), 3.0);
    let place = at(&harness, "Scale", "2");
    click_with(&mut harness, place, Modifiers::SHIFT);
    assert_eq!(selected(&harness), [(Channel::Rotation, 3.0), (Channel::Scale, 2.0)]);
    let place = at(&harness, "Rotation", "3");
    click_with(&mut harness, place, Modifiers::CTRL);
    assert_eq!(selected(&harness), [(Channel::Scale, 2.0)]);
    click_with(&mut harness, place + vec2(30.0, 0.0), Modifiers::NONE);
    assert_eq!(selected(&harness), []);
    click(&mut harness, "Keys: Scale of cylinder");
    assert_eq!(selected(&harness).len(), 3);
    // A diamond of the control node's own row stands for all keys of its time.
    let summary = harness.get_by_label("Control node cylinder").rect().center().y;
    let place = egui::pos2(at(&harness, "Scale", "2").x, summary);
    click_with(&mut harness, place, Modifiers::NONE);
    assert_eq!(selected(&harness).len(), 3);
    assert!(selected(&harness).iter().all(|(_, seconds)| *seconds == 2.0));
}

#[test]
fn a_drag_moves_a_key_in_time_and_snaps_to_others() {
    check(
        |harness| {
            let from = at(harness, "Rotation", "2");
            let second = at(harness, "Rotation", "3").x - from.x;
            press_and_move(harness, from, from + vec2(0.5 * second, 0.0));
            assert_eq!(harness.state().cursor, CursorIcon::Grabbing);
            button(harness, from + vec2(0.5 * second, 0.0), PointerButton::Primary, false);
            assert_eq!(selected(harness), [(Channel::Rotation, 2.5)]);
        },
        Channel::Rotation,
        &[0.0, 2.5, 3.0, 4.0],
    );
    // Three points beside the rotation's key at 3 s it is at 3 s; with Shift it is not.
    let beside = |harness: &Panel| at(harness, "Rotation", "3").x - at(harness, "Scale", "2").x - 3.0;
    check(
        |harness| {
            let (from, by) = (at(harness, "Scale", "2"), beside(harness));
            drag(harness, from, from + vec2(by, 0.0));
        },
        Channel::Scale,
        &[0.0, 3.0, 4.0],
    );
    let mut harness = panel("cylinder");
    let (from, by) = (at(&harness, "Scale", "2"), beside(&harness));
    hold(&mut harness, Modifiers::SHIFT);
    drag(&mut harness, from, from + vec2(by, 0.0));
    let moved = times(&harness, "cylinder", Channel::Scale)[1];
    assert!(moved != 3.0 && (moved - 3.0).abs() < 0.1, "{moved}");
}

#[test]
fn a_drag_that_escape_ends_is_as_if_it_had_not_been() {
    let mut harness = panel("cylinder");
    let before = bytes(&harness);
    let from = at(&harness, "Rotation", "2");
    press_and_move(&mut harness, from, from + vec2(60.0, 0.0));
    assert_ne!(bytes(&harness), before, "the scene follows");
    assert!(harness.state().ui.takes_escape(&harness.ctx));
    harness.key_press(Key::Escape);
    harness.run();
    button(&mut harness, from, PointerButton::Primary, false);
    let editor = &harness.state().editor;
    assert_eq!((bytes(&harness), editor.undo_label(), editor.is_dragging()), (before, None, false));
    assert_eq!(selected(&harness), []);
}

#[test]
fn a_box_selects_over_rows_and_the_selection_moves_and_goes_together() {
    let boxed = |harness: &mut Panel| {
        let (from, to) = (at(harness, "Translation", "2"), at(harness, "Scale", "4"));
        drag(harness, from - vec2(20.0, 6.0), to + vec2(-10.0, 6.0));
        let expected =
            [(Channel::Translation, 2.0), (Channel::Rotation, 2.0), (Channel::Rotation, 3.0), (Channel::Scale, 2.0)];
        assert_eq!(selected(harness), expected);
    };
    let harness = check(
        |harness| {
            boxed(harness);
            let from = at(harness, "Rotation", "3");
            let second = from.x - at(harness, "Rotation", "2").x;
            drag(harness, from, from + vec2(-0.5 * second, 0.0));
        },
        Channel::Rotation,
        &[0.0, 1.5, 2.5, 4.0],
    );
    assert_eq!(times(&harness, "cylinder", Channel::Scale), [0.0, 1.5, 4.0]);
    let harness = check(
        |harness| {
            boxed(harness);
            press(&mut harness.state_mut().editor, "delete");
            harness.run();
        },
        Channel::Rotation,
        &[0.0, 4.0],
    );
    assert_eq!(times(&harness, "cylinder", Channel::Translation), [0.0, 4.0]);
}

#[test]
fn the_menu_of_a_key_has_its_numbers() {
    let open = |harness: &mut Panel| {
        let place = at(harness, "Translation", "2");
        secondary_click(harness, place);
    };
    check(
        |harness| {
            open(harness);
            type_number(harness, "Time of the key in seconds", "2.75");
        },
        Channel::Translation,
        &[0.0, 2.75, 4.0],
    );
    let harness = check(
        |harness| {
            open(harness);
            type_number(harness, "Key: Translation y", "-1.5");
        },
        Channel::Translation,
        &[0.0, 2.0, 4.0],
    );
    let scene = harness.state().editor.scene();
    let value = scene.key_value_at(scene.find("cylinder").unwrap(), Channel::Translation, 2.0);
    assert_eq!(value, Some(KeyValue::Translation(Vec3::new(1.0, -1.5, 0.0))));
    check(
        |harness| {
            open(harness);
            click(harness, "Delete keys Delete");
        },
        Channel::Translation,
        &[0.0, 4.0],
    );
}

#[test]
fn a_drag_of_a_number_in_the_menu_is_one_step() {
    check(
        |harness| {
            let place = at(harness, "Scale", "2");
            secondary_click(harness, place);
            let from = harness.get_by_label("Time of the key in seconds").rect().center();
            drag(harness, from, from + vec2(40.0, 0.0));
        },
        Channel::Scale,
        &[0.0, 2.4, 4.0],
    );
}

#[test]
fn the_keyboard_alone_reaches_keys_and_their_numbers() {
    let harness = check(
        |harness| {
            harness.get_by_label("Rotation of cylinder at 3 s").focus();
            harness.run();
            harness.key_press(Key::Enter);
            harness.run();
            assert_eq!(selected(harness), [(Channel::Rotation, 3.0)]);
            type_number(harness, "Key: Rotation about z", "90");
        },
        Channel::Rotation,
        &[0.0, 2.0, 3.0, 4.0],
    );
    drop(harness);
    check(
        |harness| {
            harness.get_by_label("Add a key at the playhead: Keys: Scale of cylinder").focus();
            harness.run();
            harness.key_press(Key::Enter);
            harness.run();
        },
        Channel::Scale,
        &[0.0, 1.0, 2.0, 4.0],
    );
}

#[test]
fn the_menu_of_a_row_adds_and_the_row_folds() {
    check(
        |harness| {
            let place = harness.get_by_label("Keys: Scale of cylinder").rect().center();
            secondary_click(harness, place);
            click(harness, "Add a key at 1.000 s");
        },
        Channel::Scale,
        &[0.0, 1.0, 2.0, 4.0],
    );
    let mut harness = panel("cylinder");
    click(&mut harness, "Fold the row of cylinder");
    assert!(harness.query_by_label("Keys: Scale of cylinder").is_none());
    click(&mut harness, "Unfold the row of cylinder");
    assert!(harness.query_by_label("Keys: Scale of cylinder").is_some());
}

#[test]
fn control_nodes_are_put_above_renamed_and_removed_by_menus() {
    let mut harness = panel("two-robots");
    let before = bytes(&harness);
    let robot = harness.get_by_role_and_label(Role::ListBoxOption, "robot1").rect().center();
    secondary_click(&mut harness, robot);
    click(&mut harness, "Put a control node above it");
    let scene = harness.state().editor.scene();
    assert!(scene.find("robot1_control").is_some() && scene.find("robot1/head").is_some());
    press(&mut harness.state_mut().editor, "ctrl+z");
    assert_eq!(bytes(&harness), before);
    press(&mut harness.state_mut().editor, "ctrl+y");
    harness.run();
    let with = bytes(&harness);
    // Its row stands in the timeline, above the robot's, which has a menu too.
    let row = harness.get_by_label("Control node robot1_control").rect().center();
    secondary_click(&mut harness, row);
    click(&mut harness, "Name of the control node");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.event(Event::Text("nod".to_owned()));
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
    assert!(harness.state().editor.scene().find("nod").is_some());
    press(&mut harness.state_mut().editor, "ctrl+z");
    assert_eq!(bytes(&harness), with);
    harness.run();
    secondary_click(&mut harness, row);
    click(&mut harness, "Remove the control node");
    assert_eq!(bytes(&harness), before);
    press(&mut harness.state_mut().editor, "ctrl+z");
    assert_eq!(bytes(&harness), with);
}

#[test]
fn colours_are_keyed_from_the_menu_of_a_node() {
    let mut harness = panel("two-robots");
    let before = bytes(&harness);
    let robot = harness.get_by_role_and_label(Role::ListBoxOption, "robot1").rect().center();
    secondary_click(&mut harness, robot);
    let submenu = harness.get_by_label_contains("Key a colour").accesskit_node().label().expect("it has a name");
    click(&mut harness, &submenu);
    let item = harness
        .get_all_by_role(Role::Button)
        .find_map(|node| node.accesskit_node().label().filter(|label| label.starts_with("Key the colour of ")))
        .expect("the robot has shapes");
    click(&mut harness, &item);
    assert_ne!(bytes(&harness), before);
    let scene = harness.state().editor.scene();
    assert!(scene.nodes_with_ids().any(|(id, _)| scene.key_seconds(id, Channel::Colour) == [1.0]));
    press(&mut harness.state_mut().editor, "ctrl+z");
    assert_eq!(bytes(&harness), before);
}

#[test]
fn the_ruler_scrubs_the_keys() {
    let mut harness = panel("cylinder");
    let before = bytes(&harness);
    let ruler = harness.get_by_label("Timeline").rect().top() + 8.0;
    let at_three = egui::pos2(at(&harness, "Rotation", "3").x, ruler);
    drag(&mut harness, at_three - vec2(80.0, 0.0), at_three);
    let editor = &harness.state().editor;
    assert!((editor.seconds() - 3.0).abs() < 0.02 && editor.holds_timed_keys(), "{}", editor.seconds());
    assert_eq!((bytes(&harness), editor.undo_label()), (before, None));
}

#[test]
fn the_scene_is_saved_from_the_file_menu() {
    let mut harness = panel("cylinder");
    click(&mut harness, "Add a key at the playhead: Keys: Scale of cylinder");
    click(&mut harness, "File");
    harness.get_by_label_contains("Save scene as…").click();
    harness.run();
    assert_eq!(harness.state().commands.last(), Some(&Command::File(FileCommand::ChooseSaveSceneAs)));
    harness.state_mut().ui.ask_for_path(PathPurpose::SaveSceneAs, &PathBuf::from("cylinder2.json"));
    harness.run();
    harness.get_by_label("Save the scene as");
    click(&mut harness, "Save");
    let saved = Command::File(FileCommand::SaveSceneAs(PathBuf::from("cylinder2.json")));
    assert_eq!(harness.state().commands.last(), Some(&saved));
}

/// Presses a button of the transport. While keys play the panels ask for a picture after each, so `run` would not end.
fn press_button(harness: &mut Panel, label: &str) {
    harness.get_by_role_and_label(Role::Button, label).click();
    harness.run_steps(3);
}

/// A scene without keyframes: the buttons play its timed keys.
#[test]
fn the_transport_plays_timed_keys_where_there_are_no_keyframes() {
    let mut harness = panel("cylinder");
    assert!(harness.state().editor.holds_timed_keys());
    press_button(&mut harness, "Play");
    let editor = &harness.state().editor;
    assert!(editor.timed_keys_run() && editor.seconds() == 0.0 && !editor.is_playing());
    harness.state_mut().editor.tick(90);
    harness.run_steps(3);
    assert_eq!(harness.state().editor.seconds(), 1.5);
    assert!(harness.query_by_label("1.50 / 4.00 s").is_some());
    press_button(&mut harness, "Pause");
    assert!(harness.state().editor.holds_timed_keys());
    harness.state_mut().editor.tick(60);
    assert_eq!(harness.state().editor.seconds(), 1.5);
    press_button(&mut harness, "Next key");
    assert_eq!(harness.state().editor.seconds(), 2.0);
    press_button(&mut harness, "Previous key");
    assert_eq!(harness.state().editor.seconds(), 0.0);
    press_button(&mut harness, "Go on");
    harness.state_mut().editor.tick(30);
    assert_eq!(harness.state().editor.seconds(), 0.5);
    harness.run_steps(3);
    press_button(&mut harness, "Stop");
    let editor = &harness.state().editor;
    assert!(editor.holds_timed_keys() && editor.seconds() == 0.0);
}

#[test]
fn timed_keys_are_played_in_a_loop() {
    let mut harness = panel("cylinder");
    press_button(&mut harness, "Plays once");
    press_button(&mut harness, "Play");
    for (ticks, seconds) in [(240, 0.0), (90, 1.5), (480, 1.5)] {
        harness.state_mut().editor.tick(ticks);
        assert_eq!(harness.state().editor.seconds(), seconds);
        assert!(harness.state().editor.wants_ticks());
    }
    harness.run_steps(3);
    press_button(&mut harness, "Plays in a loop");
    let editor = &mut harness.state_mut().editor;
    editor.tick(210);
    assert_eq!(editor.seconds(), 3.0, "there and back from 1.5 s");
    press(editor, "shift+l");
    assert_eq!(editor.seconds(), 3.0, "the time stays where the mode changes");
    editor.tick(600);
    assert!(!editor.wants_ticks() && editor.seconds() >= 4.0, "once");
}

#[test]
fn enter_opens_the_numbers_of_a_selected_key() {
    let mut harness = panel("cylinder");
    let place = at(&harness, "Scale", "2");
    click_with(&mut harness, place, Modifiers::NONE);
    assert_eq!(selected(&harness), [(Channel::Scale, 2.0)]);
    assert!(harness.query_by_label("Time of the key in seconds").is_none());
    harness.key_press(Key::Enter);
    harness.run();
    assert!(harness.query_by_label("Time of the key in seconds").is_some());
}
