//! Our own dialog for a path, for systems that have none.

use std::path::{Path, PathBuf};

use egui::{Key, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use inbetween::editor::{Command, FileCommand, WindowCommand};
use inbetween::ui::{FolderEntry, Listing, PathPurpose};
use inbetween::words::texts;

use crate::{App, click, does, editor, harness, harness_of, press, type_text};

/// Reads what the dialog wants to know of folders that exist only here.
fn read(harness: &mut Harness<'_, App>) {
    while let Some(folder) = harness.state().ui.wanted_folder() {
        let entry = |name: &str, is_folder| FolderEntry { name: name.to_owned(), is_folder };
        let entries = match folder.to_str().unwrap() {
            "." => Ok(vec![entry("walk.json", false), entry("walk-2.json", false), entry("lessons", true)]),
            "lessons/" => Ok(vec![entry("hello.json", false), entry("picture.png", false)]),
            "/home/me/" => Ok(vec![entry("mine.json", false)]),
            _ => Err(texts::STORAGE_NOT_FOUND.into()),
        };
        harness.state_mut().ui.put_folder(Listing { folder, entries, home: Some(PathBuf::from("/home/me")) });
        harness.run();
    }
}

fn asked(purpose: PathPurpose, proposed: &str) -> Harness<'static, App> {
    let mut harness = harness(editor(1));
    harness.state_mut().ui.ask_for_path(purpose, Path::new(proposed));
    harness.run();
    read(&mut harness);
    harness
}

fn opened(path: &str) -> Command {
    Command::File(FileCommand::Open(PathBuf::from(path)))
}

#[test]
fn arrows_and_enter_go_into_folders_and_open_files() {
    let mut harness = asked(PathPurpose::Open, "");
    press(&mut harness, Key::ArrowDown);
    press(&mut harness, Key::Enter);
    read(&mut harness);
    assert!(harness.state().ui.has_dialog(), "a folder is no answer");
    assert!(harness.query_by_label("picture.png").is_none());
    press(&mut harness, Key::ArrowDown);
    press(&mut harness, Key::Enter);
    assert_eq!(harness.state().commands.last(), Some(&opened("lessons/hello.json")));
    assert!(!harness.state().ui.has_dialog());
}

#[test]
fn tab_completes_a_name() {
    let mut harness = asked(PathPurpose::Open, "");
    type_text(&mut harness, "le");
    press(&mut harness, Key::Tab);
    read(&mut harness);
    harness.event(egui::Event::Text("h".to_owned()));
    harness.run();
    press(&mut harness, Key::Tab);
    press(&mut harness, Key::Enter);
    assert_eq!(harness.state().commands.last(), Some(&opened("lessons/hello.json")));
}

#[test]
fn a_click_fills_the_field_and_the_button_opens() {
    let mut harness = asked(PathPurpose::Open, "");
    click(&mut harness, "lessons/");
    read(&mut harness);
    click(&mut harness, "hello.json");
    click(&mut harness, "Open");
    assert_eq!(harness.state().commands.last(), Some(&opened("lessons/hello.json")));
}

#[test]
fn places_are_one_click_away() {
    let mut harness = asked(PathPurpose::SaveAs, "new.json");
    click(&mut harness, "Home");
    read(&mut harness);
    assert!(harness.query_by_label("mine.json").is_some(), "{:?}", harness.state().ui);
    press(&mut harness, Key::Enter);
    let saved = Command::File(FileCommand::SaveAs(PathBuf::from("/home/me/new.json")));
    assert_eq!(harness.state().commands.last(), Some(&saved));

    let mut app = App::new(editor(1));
    app.settings.used(Path::new("/home/me/old/walk.json"));
    app.ui.adopt(&app.settings);
    let mut harness = harness_of(app, vec2(1280.0, 800.0));
    harness.state_mut().ui.ask_for_path(PathPurpose::Open, Path::new(""));
    harness.run();
    read(&mut harness);
    click(&mut harness, "old");
    assert_eq!(harness.state().ui.wanted_folder(), Some(PathBuf::from("/home/me/old/")));
    read(&mut harness);
    harness.get_by_label("there is no such file or folder");
}

#[test]
fn it_fits_a_small_window() {
    let mut harness = harness_of(App::new(editor(1)), vec2(720.0, 480.0));
    harness.state_mut().ui.ask_for_path(PathPurpose::Open, Path::new(""));
    harness.run();
    read(&mut harness);
    for label in ["Cancel", "Open"] {
        let rect = harness.get_by_label(label).rect();
        assert!(rect.bottom() <= 480.0 && rect.right() <= 720.0, "{label}: {rect}");
    }
}

/// The export dialog, whose "Browse" no dialog of the system answers.
fn browsing(format: &str) -> Harness<'static, App> {
    let mut harness = harness(editor(5));
    does(&mut harness, Command::Window(WindowCommand::ShowExport));
    if format != "GIF" {
        harness.get_by_role_and_label(egui::Role::ComboBox, "Format").click();
        harness.run();
        click(&mut harness, format);
    }
    click(&mut harness, "Browse…");
    let Some(Command::File(FileCommand::ChooseExport { proposed, is_folder })) =
        harness.state().commands.last().cloned()
    else {
        panic!("{:?}", harness.state().commands)
    };
    let purpose = if is_folder { PathPurpose::FilmFolder } else { PathPurpose::Film };
    harness.state_mut().ui.ask_for_path(purpose, &proposed);
    harness.run();
    read(&mut harness);
    harness
}

fn exported(harness: &Harness<'static, App>) -> PathBuf {
    match harness.state().commands.last() {
        Some(Command::File(FileCommand::Export(options))) => options.path.clone(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn browsing_for_an_export_comes_back_to_it() {
    let mut harness = browsing("GIF");
    harness.get_by_label("Export to a file");
    click(&mut harness, "Home");
    read(&mut harness);
    assert!(harness.query_by_label("mine.json").is_none(), "it is no film");
    click(&mut harness, "Choose");
    harness.get_by_label("Export a film");
    click(&mut harness, "Export");
    assert_eq!(exported(&harness), Path::new("/home/me/wave.gif"));
    assert!(!harness.state().ui.has_dialog());
}

#[test]
fn browsing_for_a_folder_lists_folders() {
    let mut harness = browsing("PNG frames in a folder");
    harness.get_by_label("Export into a folder");
    click(&mut harness, "Home");
    read(&mut harness);
    assert!(harness.query_by_label("mine.json").is_none(), "it is no folder");
    click(&mut harness, "Choose");
    click(&mut harness, "Export");
    assert_eq!(exported(&harness), Path::new("/home/me/"));
}

#[test]
fn a_cancelled_browse_leaves_the_path() {
    let mut harness = browsing("GIF");
    click(&mut harness, "Home");
    press(&mut harness, Key::Escape);
    harness.get_by_label("Export a film");
    click(&mut harness, "Export");
    assert_eq!(exported(&harness), Path::new("folder/wave.gif"));
}

#[test]
fn a_browse_that_is_over_opens_nothing() {
    let mut harness = harness(editor(5));
    harness.state_mut().ui.ask_for_path(PathPurpose::Film, Path::new("wave.gif"));
    harness.run();
    assert!(!harness.state().ui.has_dialog());
}
