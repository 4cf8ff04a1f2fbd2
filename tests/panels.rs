//! The panels, driven by pointer and keyboard with no window: what is clicked and typed becomes commands.

use std::path::PathBuf;
use std::sync::Arc;

use egui::{Key, Modifiers, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use glam::{Quat, Vec3};
use inbetween::editor::keymap::bindings;
use inbetween::editor::{
    Command, Edit, Editor, Eye, FileCommand, GestureCommand, PlaybackCommand, SelectionCommand, ViewCommand,
    WindowCommand,
};
use inbetween::keyframe::KeyframeIndex;
use inbetween::pose::RbtIndex;
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use inbetween::settings::Settings;
use inbetween::ui::{
    ChangeAnswer, ChangeOffer, OverwriteAnswer, OverwriteQuestion, OverwriteReason, Panels, PathPurpose, QuitAnswer,
    UiOutput, theme,
};
use inbetween::words::texts;

struct App {
    editor: Editor,
    ui: Panels,
    /// Whether commands reach the editor.
    applies: bool,
    commands: Vec<Command>,
    output: UiOutput,
    viewport: egui::Rect,
    is_dressed: bool,
}

fn editor(keyframes: usize) -> Editor {
    let scene = built_in_scene(DEFAULT_SCENE).expect("the default scene is built in");
    let mut editor = Editor::new(Arc::new(scene), PathBuf::from("folder/wave.json"));
    for _ in 0..keyframes {
        editor.apply(Command::Edit(Edit::CreateKeyframe)).unwrap();
    }
    editor
}

fn harness(editor: Editor) -> Harness<'static, App> {
    let app = App {
        editor,
        ui: Panels::new(),
        applies: true,
        commands: Vec::new(),
        output: UiOutput::default(),
        viewport: egui::Rect::NOTHING,
        is_dressed: false,
    };
    let mut harness = Harness::builder().with_size(vec2(1280.0, 800.0)).build_ui_state(
        |ui, app: &mut App| {
            if !std::mem::replace(&mut app.is_dressed, true) {
                theme::install(ui.ctx());
            }
            let output = app.ui.show(ui, &app.editor);
            app.viewport = output.viewport;
            for command in output.commands.clone() {
                if app.applies {
                    let _ = app.editor.apply(command.clone());
                }
                app.commands.push(command);
            }
            app.output.go_on(output);
        },
        app,
    );
    harness.run();
    harness
}

fn click(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by_label(label).click();
    harness.run();
}

/// Where a field stands whose accessible name is this.
fn type_into(harness: &mut Harness<'_, App>, label: &str, text: &str) {
    click(harness, label);
    harness.key_press_modifiers(Modifiers::CTRL, Key::A);
    harness.event(egui::Event::Text(text.to_owned()));
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
}

#[test]
fn every_menu_shows_its_commands_with_their_keys() {
    let mut seen = Vec::new();
    let submenus = ["Look", "Axes of the handles"].map(|submenu| ("View", Some(submenu)));
    let menus = ["File", "Edit", "View", "Animation", "Help"].map(|menu| (menu, None));
    for (menu, submenu) in menus.into_iter().chain(submenus) {
        let mut harness = harness(editor(5));
        harness.get_all_by_label(menu).next().expect("the menu stands in the bar").click();
        harness.run();
        if let Some(submenu) = submenu {
            let is_it = |label: &str| label == submenu || label.strip_prefix(submenu) == Some(" ⏵");
            harness.get_by(|node| is_it(&node.label().unwrap_or_default())).click();
            harness.run();
        }
        for binding in bindings() {
            let key = binding.menu_key();
            let name = |node: &egui_kittest::Node<'_>| node.accesskit_node().label().unwrap_or_default();
            if harness.query_all_by(|_| true).any(|node| {
                let label = name(&node);
                label.ends_with(&key) && label.len() > key.len() + 2
            }) {
                seen.push(binding.title().english());
            }
        }
    }
    for binding in bindings() {
        assert!(
            seen.contains(&binding.title().english()),
            "no menu shows {} with {}",
            binding.title().english(),
            binding.menu_key()
        );
    }
}

#[test]
fn a_menu_item_is_its_command() {
    let mut harness = harness(editor(0));
    click(&mut harness, "Edit");
    click(&mut harness, "New keyframe n");
    assert_eq!(harness.state().commands, [Command::Edit(Edit::CreateKeyframe)]);
    assert_eq!(harness.state().editor.document().keyframes.len(), 1);
}

#[test]
fn feet_kept_by_the_menu_stay_while_the_inspector_moves_the_body() {
    let mut harness = harness(editor(0));
    click(&mut harness, "Edit");
    click(&mut harness, "Keep feet in place ");
    let editor = &mut harness.state_mut().editor;
    assert!(editor.session().keeps_feet);
    let scene = editor.scene().clone();
    let find = |path| scene.find_rbt(path).unwrap();
    editor.apply(Command::View(ViewCommand::Choose(Some(find("robot1"))))).unwrap();
    let sole = |harness: &Harness<'_, App>| {
        harness.state().editor.limb_ball(find("robot1/left_hip/left_knee")).unwrap().end_in_world
    };
    let before = sole(&harness);
    harness.run();
    type_into(&mut harness, "Translation y", "0.7");
    assert_eq!(harness.state().editor.document().live_pose.get(find("robot1")).translation.y, 0.7);
    assert!(sole(&harness).distance(before) < 1e-4, "{} is not {before}", sole(&harness));
}

#[test]
fn a_click_on_the_letter_of_an_axis_looks_along_it() {
    let mut harness = harness(editor(0));
    for (letter, yaw_degrees, pitch_degrees) in [("Look from +X", 90.0, 0.0), ("Look from below", 0.0, -90.0)] {
        click(&mut harness, letter);
        let session = harness.state().editor.session();
        assert_eq!(session.eye, Eye::Work);
        assert_eq!((session.work_eye.yaw_degrees, session.work_eye.pitch_degrees), (yaw_degrees, pitch_degrees));
    }
}

#[test]
fn a_clicked_keyframe_becomes_current() {
    let mut harness = harness(editor(5));
    click(&mut harness, "Keyframe 2");
    let index = KeyframeIndex::new(2);
    let selects = Command::Selection(SelectionCommand::Keyframes(vec![index]));
    assert_eq!(harness.state().commands, [selects, Command::Edit(Edit::GoTo(index))]);
    assert_eq!(harness.state().editor.document().keyframes.current(), Some(KeyframeIndex::new(2)));
}

#[test]
fn ten_thousand_keyframes_cost_only_what_is_seen() {
    let harness = harness(editor(2000));
    let shown = harness.query_all_by(|node| node.label().is_some_and(|label| label.starts_with("Keyframe "))).count();
    assert!(shown > 10 && shown < 60, "{shown} of 2000 keyframes are laid out");
}

#[test]
fn the_empty_timeline_teaches() {
    let harness = harness(editor(0));
    harness
        .get_by_label("No keyframes yet: pose the scene, press n to keep a pose. Four make an animation; y plays it.");
}

#[test]
fn a_click_with_ctrl_or_shift_chooses_several() {
    let mut harness = harness(editor(0));
    let chosen = |harness: &Harness<'_, App>| {
        harness.state().editor.session().chosen.iter().map(|rbt| rbt.get()).collect::<Vec<_>>()
    };
    click(&mut harness, "robot1/right_shoulder");
    for (modifiers, label, expected) in [
        (Modifiers::COMMAND, "robot1/right_shoulder/right_elbow", vec![3, 4]),
        (Modifiers::SHIFT, "robot1", vec![3, 4, 2]),
        (Modifiers::SHIFT, "robot1/right_shoulder/right_elbow", vec![3, 2]),
        (Modifiers::NONE, "robot1/right_shoulder", vec![3]),
        (Modifiers::NONE, "robot1/right_shoulder", vec![]),
    ] {
        harness.get_by_label(label).click_modifiers(modifiers);
        harness.run();
        assert_eq!(chosen(&harness), expected, "{label} with {modifiers:?}");
    }
}

#[test]
fn a_clicked_node_is_chosen_and_clicked_again_is_not() {
    let mut harness = harness(editor(0));
    click(&mut harness, "robot1/right_shoulder");
    let chosen = harness.state().editor.session().chosen.primary().unwrap();
    assert_eq!(harness.state().editor.scene().rbt_path(chosen), "robot1/right_shoulder");
    click(&mut harness, "robot1/right_shoulder");
    assert_eq!(harness.state().editor.session().chosen.primary(), None);
}

#[test]
fn a_typed_number_is_one_command() {
    let mut harness = harness(editor(0));
    harness.state_mut().editor.apply(Command::View(ViewCommand::Choose(Some(RbtIndex::new(3))))).unwrap();
    harness.run();
    type_into(&mut harness, "Translation y", "1.25");
    let expected = Edit::SetTranslation(RbtIndex::new(3), Vec3::new(0.5, 1.25, 0.0));
    assert_eq!(harness.state().commands, [Command::Edit(expected)]);
}

#[test]
fn typed_degrees_turn_the_node_and_stay_as_typed() {
    let mut harness = harness(editor(0));
    harness.state_mut().editor.apply(Command::View(ViewCommand::Choose(Some(RbtIndex::new(3))))).unwrap();
    harness.run();
    type_into(&mut harness, "Rotation about z", "90");
    type_into(&mut harness, "Rotation about y", "135");
    let rotation = harness.state().editor.document().live_pose.get(RbtIndex::new(3)).rotation;
    let expected = Quat::from_rotation_z(90_f32.to_radians()) * Quat::from_rotation_y(135_f32.to_radians());
    assert!(rotation.dot(expected).abs() > 1.0 - 1e-6, "{rotation} is not {expected}");
    assert_eq!(harness.get_by_label("Rotation about y").value().as_deref(), Some("135.0"));
}

#[test]
fn typed_full_turns_are_said_to_be_none() {
    let mut harness = harness(editor(0));
    harness.state_mut().editor.apply(Command::View(ViewCommand::Choose(Some(RbtIndex::new(3))))).unwrap();
    harness.run();
    let note = "degrees is the same rotation as";
    assert!(harness.query_by_label_contains(note).is_none());
    type_into(&mut harness, "Rotation about z", "360");
    assert_eq!(harness.get_by_label("Rotation about z").value().as_deref(), Some("360.0"));
    harness.get_by_label_contains("360 degrees is the same rotation as 0");
    type_into(&mut harness, "Rotation about z", "180");
    assert!(harness.query_by_label_contains(note).is_none());
}

#[test]
fn a_dragged_number_is_one_step_of_undo() {
    let mut harness = harness(editor(0));
    let from = harness.get_by_label("Translation x").rect().center();
    harness.drag_at(from);
    harness.run();
    for step in 1..=6u8 {
        harness.hover_at(from + vec2(f32::from(step) * 8.0, 0.0));
        harness.run();
    }
    harness.drop_at(from + vec2(48.0, 0.0));
    harness.run();
    let commands = &harness.state().commands;
    assert_eq!(commands.first(), Some(&Command::Gesture(GestureCommand::Begin)));
    assert_eq!(commands.last(), Some(&Command::Gesture(GestureCommand::Commit)));
    assert!(commands.len() > 4, "the scene follows the drag: {commands:?}");
    let editor = &mut harness.state_mut().editor;
    assert!(editor.document().live_pose.get(RbtIndex::new(0)).translation.x > 0.1);
    editor.apply(Command::Undo).unwrap();
    assert_eq!(editor.document().live_pose, *editor.scene().rest_pose());
    assert_eq!(editor.undo_label(), None);
}

#[test]
fn numbers_are_disabled_while_playing() {
    let mut harness = harness(editor(4));
    harness.state_mut().editor.apply(Command::Playback(PlaybackCommand::PlayOrStop)).unwrap();
    harness.step();
    assert!(harness.get_by_label("Translation x").accesskit_node().is_disabled());
    harness.get_by_label("Stop").click();
    harness.step();
    harness.step();
    assert_eq!(harness.state().commands, [Command::Playback(PlaybackCommand::PlayOrStop)]);
}

#[test]
fn a_text_field_has_the_keyboard_and_escape_gives_it_back() {
    let mut harness = harness(editor(0));
    assert!(!harness.state().ui.has_keyboard(&harness.ctx));
    click(&mut harness, "Translation x");
    harness.run();
    assert!(harness.state().ui.has_keyboard(&harness.ctx));
    harness.key_press(Key::Escape);
    harness.run();
    assert!(!harness.state().ui.has_keyboard(&harness.ctx));
    assert_eq!(harness.state().commands, []);
}

#[test]
fn a_clicked_button_does_not_take_the_space_bar() {
    let mut harness = harness(editor(5));
    for label in ["New keyframe", "Previous keyframe", "Keyframe 1", "Look from robot1", "ground"] {
        click(&mut harness, label);
        assert!(!harness.ctx.egui_wants_keyboard_input(), "{label} keeps the keyboard");
        let before = harness.state().commands.len();
        harness.key_press(Key::Space);
        harness.run();
        assert_eq!(harness.state().commands.len(), before, "the space bar presses {label}");
    }
}

#[test]
fn a_button_reached_with_tab_takes_the_space_bar_until_it_is_clicked() {
    let mut harness = harness(editor(5));
    harness.get_by_label("New keyframe").focus();
    harness.run();
    harness.key_press(Key::Space);
    harness.run();
    assert_eq!(harness.state().commands, [Command::Edit(Edit::CreateKeyframe)]);
    click(&mut harness, "New keyframe");
    assert_eq!(harness.state().commands.len(), 2);
    harness.key_press(Key::Space);
    harness.run();
    assert_eq!(harness.state().commands.len(), 2);
}

#[test]
fn the_help_lists_every_key_and_the_mouse() {
    let mut harness = harness(editor(0));
    harness.state_mut().editor.apply(Command::View(ViewCommand::ToggleHelp)).unwrap();
    harness.run();
    for binding in bindings().into_iter().filter(|binding| !binding.chords.is_empty()) {
        harness.get_by_label(&format!("{}: {}", binding.keys(), binding.explanation().english()));
    }
    for gesture in [
        "Left drag",
        "Right drag",
        "Middle drag",
        "Wheel",
        "Click",
        "Left drag on nothing",
        "Drag a ball",
        "Wheel in that drag",
    ] {
        assert!(harness.query_all_by_label_contains(&format!("{gesture}: ")).count() > 0, "{gesture}");
    }
}

#[test]
fn without_panels_the_scene_has_all_of_the_window() {
    let mut harness = harness(editor(0));
    let with_panels = harness.state().viewport;
    harness.state_mut().editor.apply(Command::View(ViewCommand::TogglePanels)).unwrap();
    harness.run();
    let without = harness.state().viewport;
    assert!((without.width() - with_panels.width() - theme::SIDE).abs() <= 1.0, "{without} and {with_panels}");
    let bars = theme::MENU_BAR + theme::TRANSPORT + theme::TIMELINE + theme::STATUS;
    assert!((without.height() - with_panels.height() - bars).abs() <= 1.0, "{without} and {with_panels}");
}

#[test]
fn a_path_is_asked_for() {
    let mut harness = harness(editor(0));
    harness.state_mut().applies = false;
    harness.state_mut().ui.ask_for_path(PathPurpose::SaveAs, &PathBuf::from("wave"));
    harness.run();
    assert!(harness.state().ui.has_keyboard(&harness.ctx));
    harness.event(egui::Event::Text(".json".to_owned()));
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
    assert_eq!(harness.state().commands, [Command::File(FileCommand::SaveAs(PathBuf::from("wave.json")))]);
    assert!(!harness.state().ui.has_dialog());
}

#[test]
fn escape_leaves_a_dialog() {
    let mut harness = harness(editor(0));
    harness.state_mut().ui.ask_for_path(PathPurpose::Open, &PathBuf::from("wave.json"));
    harness.run();
    harness.key_press(Key::Escape);
    harness.run();
    assert!(!harness.state().ui.has_dialog());
    assert_eq!(harness.state().commands, []);
}

#[test]
fn unsaved_work_is_asked_about() {
    let mut harness = harness(editor(3));
    let moved = Edit::SetTranslation(RbtIndex::new(2), Vec3::ONE);
    harness.state_mut().editor.apply(Command::Edit(moved)).unwrap();
    harness.state_mut().ui.ask_before_quitting();
    harness.run();
    harness.get_by_label("The scene stands in a pose that no keyframe holds.");
    harness.get_by_label("Discard");
    click(&mut harness, "Cancel");
    assert_eq!(harness.state().output.quit_answer, None);
    assert!(!harness.state().ui.has_dialog());
    harness.state_mut().ui.ask_before_quitting();
    harness.run();
    click(&mut harness, "Save");
    assert_eq!(harness.state().output.quit_answer, Some(QuitAnswer::Save));
}

fn question(reason: OverwriteReason) -> OverwriteQuestion {
    OverwriteQuestion { path: PathBuf::from("folder/wave.json"), reason, differences: None }
}

#[test]
fn a_file_that_others_changed_is_asked_about() {
    for (label, answer) in [
        ("Save as…", OverwriteAnswer::SaveAs),
        ("Overwrite", OverwriteAnswer::Overwrite),
        ("Reload", OverwriteAnswer::Reload),
    ] {
        let mut harness = harness(editor(1));
        harness.state_mut().ui.ask_before_overwriting(question(OverwriteReason::Changed));
        harness.run();
        harness.get_by_label("Another program has changed wave.json.");
        click(&mut harness, label);
        assert_eq!((harness.state().output.overwrite, harness.state().ui.has_dialog()), (Some(answer), false));
    }
    let mut harness = harness(editor(1));
    harness.state_mut().ui.ask_before_overwriting(question(OverwriteReason::HoldsKeyframes(1)));
    harness.run();
    harness.get_by_label("The list is empty, and wave.json has 1 keyframe.");
    // Return loses nothing.
    harness.key_press(Key::Enter);
    harness.run();
    assert_eq!(harness.state().output.overwrite, Some(OverwriteAnswer::SaveAs));
}

#[test]
fn what_differs_is_shown_in_the_question() {
    let mut harness = harness(editor(1));
    harness.state_mut().ui.ask_before_overwriting(question(OverwriteReason::Appeared));
    harness.run();
    click(&mut harness, "What differs");
    assert_eq!(harness.state().output.overwrite, Some(OverwriteAnswer::Compare));
    harness.state_mut().ui.show_differences(vec![texts::differs_unreadable("no keyframes")]);
    harness.run();
    harness.get_by_label("The file cannot be read: no keyframes");
    assert!(harness.query_by_label("What differs").is_none());
    harness.key_press(Key::Escape);
    harness.run();
    assert!(!harness.state().ui.has_dialog());
}

#[test]
fn a_changed_file_is_offered_in_a_bar_that_takes_no_keyboard() {
    for (label, answer) in
        [("Reload", ChangeAnswer::Reload), ("What differs", ChangeAnswer::Compare), ("Later", ChangeAnswer::Later)]
    {
        let mut harness = harness(editor(1));
        let above = harness.state().viewport.min.y;
        let (file, path) = ("wave.json".to_owned(), PathBuf::from("folder/wave.json"));
        harness.state_mut().ui.changed = Some(ChangeOffer { file, path, replaces_unsaved: false });
        harness.run();
        harness.get_by_label("Another program has written wave.json.");
        assert!(harness.state().viewport.min.y > above);
        let context = harness.ctx.clone();
        assert!(!harness.state().ui.has_keyboard(&context) && !context.egui_wants_keyboard_input());
        click(&mut harness, label);
        assert_eq!(harness.state().output.change, Some(answer));
        assert!(!context.egui_wants_keyboard_input());
    }
}

#[test]
fn a_click_on_a_picture_gives_a_pose() {
    let mut app = harness(editor(0));
    app.state_mut().ui.perform(&WindowCommand::TogglePoses, &mut Settings::default()).unwrap();
    app.run();
    assert!(app.state().ui.wanted_thumbnail().is_some(), "its picture is asked for");
    click(&mut app, "Give the pose wave");
    assert_eq!(app.state().editor.message_text(), "Gave wave to robot1.");
    type_into(&mut app, "Name of a new pose", "mine");
    let is_saved = |command: &Command| *command == Command::File(FileCommand::SavePose("mine".to_owned()));
    assert!(app.state().commands.iter().any(is_saved));
}

#[test]
fn the_menu_of_a_node_mirrors_and_resets_it() {
    let mut app = harness(editor(0));
    click(&mut app, "robot1/left_shoulder");
    app.state_mut().editor.apply(Command::Edit(Edit::RotateChosen { axis_in_node: Vec3::Z, radians: 1.0 })).unwrap();
    let right = |app: &Harness<'_, App>| app.state().editor.document().live_pose.get(RbtIndex::new(3)).rotation;
    app.get_by_label("robot1/left_shoulder").click_secondary();
    app.run();
    app.get_by_label_contains("Mirror").click();
    app.run();
    assert!(right(&app).z < -0.4);
    app.get_by_label("robot1/right_shoulder").click_secondary();
    app.run();
    app.get_by_label_contains("Return rotation to rest").click();
    app.run();
    assert_eq!(right(&app), Quat::IDENTITY);
    // What is not chosen is chosen first, so that it is in sight.
    app.get_by_label("robot1/right_shoulder").click_secondary();
    app.run();
    let title = texts::COMMAND_SHOW_CHOSEN.english();
    app.get_by_label_contains(title).click();
    app.run();
    assert_eq!(*app.state().editor.session().chosen, [RbtIndex::new(3)]);
    assert!(app.state().commands.contains(&Command::View(ViewCommand::ShowChosen)));
}

#[test]
fn the_filter_shows_nodes_by_name_and_shapes_too() {
    let mut app = harness(editor(0));
    assert!(app.query_by_label("robot1/chest").is_none());
    click(&mut app, "Filter");
    let type_text = |app: &mut Harness<'_, App>, text: &str| {
        app.event(egui::Event::Text(text.to_owned()));
        app.run();
    };
    type_text(&mut app, "chest_pl");
    assert!(app.query_by_label("robot1/chest_plate").is_some() && app.query_by_label("ground").is_none());
    type_text(&mut app, "zzz");
    app.get_by_label("No node is called that.");
    app.key_press(Key::Escape);
    app.run();
    click(&mut app, "Show shapes in the list");
    click(&mut app, "robot1/chest");
    assert_eq!(*app.state().editor.session().chosen, [RbtIndex::new(2)], "what carries a shape is chosen");
}

#[test]
fn a_double_click_returns_a_number_to_rest() {
    let mut app = harness(editor(0));
    click(&mut app, "robot1");
    type_into(&mut app, "Translation y", "3");
    let y = |app: &Harness<'_, App>| app.state().editor.document().live_pose.get(RbtIndex::new(2)).translation.y;
    assert_eq!(y(&app), 3.0);
    let at = app.get_by_label("Translation y").rect().center();
    // Two clicks within the time of a double click: in one picture.
    let button = |pressed| {
        let (button, modifiers) = (egui::PointerButton::Primary, Modifiers::NONE);
        egui::Event::PointerButton { pos: at, button, pressed, modifiers }
    };
    app.input_mut().events.push(egui::Event::PointerMoved(at));
    app.input_mut().events.extend([true, false, true, false].map(button));
    app.run();
    assert_eq!(y(&app), 1.0);
}

#[test]
fn a_right_click_in_the_scene_opens_the_menu_of_what_is_there() {
    let mut app = harness(editor(1));
    let viewport = app.state().viewport;
    let camera = app.state().editor.camera(glam::Vec2::new(viewport.width(), viewport.height()));
    let (robot_px, _) = camera.project(Vec3::new(-2.0, 1.4, 0.0)).unwrap();
    for (at, has_menu) in
        [(viewport.center_top() + vec2(0.0, 20.0), false), (viewport.min + vec2(robot_px.x, robot_px.y), true)]
    {
        app.event(egui::Event::PointerMoved(at));
        for pressed in [true, false] {
            let button = egui::PointerButton::Secondary;
            app.event(egui::Event::PointerButton { pos: at, button, pressed, modifiers: Modifiers::NONE });
        }
        app.run();
        assert_eq!(app.query_by_label_contains("Mirror").is_some(), has_menu);
    }
    app.get_by_label_contains("Copy pose").click();
    app.run();
    assert_eq!(app.state().editor.message_text(), "Copied the pose of robot1.");
}
