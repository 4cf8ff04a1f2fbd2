//! The File and Help menus: a new animation, examples, scenes, About, and what is said of an export.

use std::path::PathBuf;

use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable as _;
use inbetween::editor::{Beginning, Command, Edit, FileCommand, ModelChoice, WindowCommand};
use inbetween::interchange::gltf_in::Contents;
use inbetween::scene::BUILT_IN_ANIMATIONS;
use inbetween::ui::{PathPurpose, QuitAnswer};

use crate::{click, does, editor, harness, press};

#[test]
fn a_new_animation_is_one_edit() {
    let mut harness = harness(editor(3));
    click(&mut harness, "File");
    click(&mut harness, "New Ctrl+N");
    assert_eq!(harness.state().commands, [Command::Edit(Edit::BeginAnew)]);
    let editor = &harness.state().editor;
    assert!(editor.document().keyframes.is_empty() && !editor.has_unsaved_changes());
    assert!(editor.keyframe_file().ends_with("animation.json"));
    does(&mut harness, Command::Undo);
    assert_eq!(harness.state().editor.document().keyframes.len(), 3);
}

#[test]
fn examples_are_in_the_menu_and_in_the_list() {
    for example in BUILT_IN_ANIMATIONS {
        let mut harness = harness(editor(0));
        click(&mut harness, "File");
        harness.get_by_label_contains("Examples").click();
        harness.run();
        click(&mut harness, &format!("{} (animation of {})", example.name, example.scene));
        let begins = Command::Window(WindowCommand::Begin(Beginning::Animation(example.name)));
        assert_eq!(harness.state().commands, [begins]);
    }
    let mut harness = harness(editor(0));
    does(&mut harness, Command::Window(WindowCommand::ShowCommands));
    crate::type_text(&mut harness, "cylinder");
    press(&mut harness, Key::Enter);
    assert_eq!(harness.state().commands, [Command::Window(WindowCommand::Begin(Beginning::Scene("cylinder")))]);
}

#[test]
fn a_scene_file_is_asked_for() {
    let mut harness = harness(editor(0));
    click(&mut harness, "File");
    harness.get_by_label_contains("Open scene…").click();
    harness.run();
    assert_eq!(harness.state().commands, [Command::Window(WindowCommand::ChooseOpenScene)]);
    harness.state_mut().ui.ask_for_path(PathPurpose::OpenScene, &PathBuf::from("mine.json"));
    harness.run();
    press(&mut harness, Key::Enter);
    let begins = Command::Window(WindowCommand::Begin(Beginning::SceneFile(PathBuf::from("mine.json"))));
    assert_eq!(harness.state().commands.last(), Some(&begins));
}

#[test]
fn a_model_is_opened_by_its_ending() {
    for purpose in [PathPurpose::Open, PathPurpose::OpenScene] {
        for name in ["fox.glb", "fox.GLTF", "walk.bvh"] {
            let path = PathBuf::from(name);
            let begins = Command::Window(WindowCommand::Begin(Beginning::Model { path: path.clone(), choice: None }));
            assert_eq!(purpose.command(path), Some(begins), "{name}");
        }
    }
    let path = PathBuf::from("glb");
    assert_eq!(PathPurpose::Open.command(path.clone()), Some(Command::File(FileCommand::Open(path))));
    let path = PathBuf::from("walk.glb");
    let exports = Command::File(FileCommand::ExportModel(path.clone()));
    assert_eq!(PathPurpose::ExportModel.command(path), Some(exports));
}

#[test]
fn one_of_a_models_animations_is_asked_for() {
    let names = ["Survey", "Walk", "Run"].map(|name| Some(name.to_owned())).to_vec();
    let contents = Contents { animations: names, ..Contents::default() };
    let mut harness = harness(editor(0));
    harness.state_mut().ui.ask_what_of_model(PathBuf::from("models/fox.glb"), contents.clone());
    harness.run();
    assert!(harness.query_by_label("fox.glb has 3 animations.").is_some());
    click(&mut harness, "1  Walk");
    let choice = ModelChoice { scene: None, animation: Some(1) };
    let begins = Beginning::Model { path: PathBuf::from("models/fox.glb"), choice: Some(choice) };
    assert_eq!(harness.state().commands, [Command::Window(WindowCommand::Begin(begins))]);
    assert!(!harness.state().ui.has_dialog());
    harness.state_mut().ui.ask_what_of_model(PathBuf::from("fox.glb"), contents);
    harness.run();
    click(&mut harness, "Cancel");
    assert!(!harness.state().ui.has_dialog() && harness.state().commands.len() == 1);
}

#[test]
fn one_of_a_models_scenes_is_asked_for_before_its_animation() {
    let mut harness = harness(editor(0));
    let path = PathBuf::from("house.gltf");
    let scenes = vec![Some("Day".to_owned()), None];
    let mut contents = Contents { scenes, own_scene: 1, animations: vec![None] };
    harness.state_mut().ui.ask_what_of_model(path.clone(), contents.clone());
    harness.run();
    harness.get_by_label("house.gltf has 2 scenes. Other programs show scene 1 first.");
    click(&mut harness, "1");
    let begins = |scene, animation| {
        let choice = Some(ModelChoice { scene, animation });
        Command::Window(WindowCommand::Begin(Beginning::Model { path: path.clone(), choice }))
    };
    assert_eq!(harness.state().commands, [begins(Some(1), None)]);
    assert!(!harness.state().ui.has_dialog());
    contents.animations = vec![Some("open".to_owned()), None];
    harness.state_mut().ui.ask_what_of_model(path.clone(), contents);
    harness.run();
    click(&mut harness, "0  Day");
    assert!(harness.state().ui.has_dialog() && harness.state().commands.len() == 1);
    harness.get_by_label("house.gltf has 2 animations.");
    click(&mut harness, "0  open");
    assert_eq!(harness.state().commands.last(), Some(&begins(Some(0), Some(0))));
}

#[test]
fn unsaved_work_is_asked_about_before_going_on() {
    let mut harness = harness(editor(3));
    harness.state_mut().ui.ask_before_going_on();
    harness.run();
    harness.get_by_label("Save the changes before going on?");
    click(&mut harness, "Discard");
    assert_eq!(harness.state().output.quit_answer, Some(QuitAnswer::Discard));
}

#[test]
fn about_says_version_and_licence_and_leads_to_the_manual() {
    let mut harness = harness(editor(0));
    harness.key_press_modifiers(Modifiers::ALT, Key::H);
    harness.run();
    harness.get_by_label_contains("About").click();
    harness.run();
    harness.get_by_label(&format!("Inbetween {}", env!("CARGO_PKG_VERSION")));
    harness.get_by_label("Licence: MIT OR Apache-2.0.");
    click(&mut harness, "Open the manual");
    assert_eq!(harness.state().commands.last(), Some(&Command::Window(WindowCommand::ShowManual)));
    press(&mut harness, Key::Escape);
    assert!(!harness.state().ui.has_dialog());
}

#[test]
fn about_copies_what_a_report_needs_and_shows_all_licences() {
    let mut harness = harness(editor(0));
    harness.state_mut().ui.facts = "inbetween 1\ncommit: abc\n".to_owned();
    does(&mut harness, Command::Window(WindowCommand::ShowAbout));
    harness.get_by_label("inbetween 1\ncommit: abc");
    harness.get_by_label("Copy for a report").click();
    harness.step();
    let commands = &harness.output().platform_output.commands;
    let copied = egui::OutputCommand::CopyText("inbetween 1\ncommit: abc\n".to_owned());
    assert!(commands.contains(&copied), "{commands:?}");
    click(&mut harness, "Licences of what it is made of");
    harness.get_by_label(inbetween::notices::lines()[0]);
    assert!(harness.query_by_label("Copy for a report").is_none());
    click(&mut harness, "Hide the licences");
    harness.get_by_label("Copy for a report");
}

#[test]
fn the_shape_of_the_picture_is_said() {
    let mut harness = harness(editor(5));
    does(&mut harness, Command::Window(WindowCommand::ShowExport));
    assert!(harness.query_by_label_contains("4:3: narrower than the 3D view").is_some());
}

#[test]
fn after_an_export_its_place_is_shown() {
    let mut harness = harness(editor(5));
    let path = PathBuf::from("/films/walk.gif");
    harness.state_mut().ui.made = Some(path.clone());
    harness.run();
    harness.get_by_label("walk.gif is written.");
    click(&mut harness, "Show folder");
    assert_eq!(harness.state().commands, [Command::Window(WindowCommand::ShowFolder(path))]);
    click(&mut harness, "Copy path");
    assert!(!harness.ctx.egui_wants_keyboard_input());
    click(&mut harness, "Close");
    assert!(harness.query_by_label("Show folder").is_none());
}
