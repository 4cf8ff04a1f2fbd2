//! The manual in the window, with no window: opening and closing, pages, links, keys, languages, and letters that the fonts have.

use std::path::PathBuf;
use std::sync::Arc;

use egui::{Key, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use inbetween::editor::{Command, Editor, Effect, WindowCommand};
use inbetween::manual;
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use inbetween::settings::Settings;
use inbetween::ui::{Ui, theme};
use inbetween::words::Language;

struct App {
    editor: Editor,
    ui: Ui,
    settings: Settings,
    is_dressed: bool,
}

impl App {
    fn apply(&mut self, command: Command) {
        if let Ok(Some(Effect::Window(command))) = self.editor.apply(command) {
            self.ui.perform(&command, &mut self.settings).expect("it cannot be refused");
        }
    }
}

fn harness(language: Language) -> Harness<'static, App> {
    let scene = built_in_scene(DEFAULT_SCENE).expect("the default scene is built in");
    let editor = Editor::new(Arc::new(scene), PathBuf::from("animation.json"));
    let mut ui = Ui::new();
    let settings = Settings { language, ..Settings::default() };
    assert_eq!(ui.adopt(&settings), []);
    let app = App { editor, ui, settings, is_dressed: false };
    let mut harness = Harness::builder().with_size(vec2(1280.0, 800.0)).build_ui_state(
        |ui, app: &mut App| {
            if !std::mem::replace(&mut app.is_dressed, true) {
                theme::install(ui.ctx());
            }
            for command in app.ui.show(ui, &app.editor).commands {
                app.apply(command);
            }
        },
        app,
    );
    harness.run();
    harness
}

fn opened(language: Language) -> Harness<'static, App> {
    let mut harness = harness(language);
    harness.state_mut().apply(Command::Window(WindowCommand::ShowManual));
    harness.run();
    harness
}

fn press(harness: &mut Harness<'_, App>, key: Key) {
    harness.key_press(key);
    settle(harness);
}

/// Lets the bars of what scrolls fade in.
fn settle(harness: &mut Harness<'_, App>) {
    harness.run_steps(16);
}

/// Clicks a page in the list, which comes before links with the same label.
fn choose(harness: &mut Harness<'_, App>, title: &str) {
    harness.query_all_by_label(title).next().expect("the page is listed").click();
    settle(harness);
}

/// How far below the window's top a heading of the page is, in points.
fn top(harness: &Harness<'_, App>, heading: &str) -> f32 {
    harness.get_by_label(heading).rect().top()
}

#[test]
fn the_menu_opens_it_and_escape_closes_it() {
    let mut harness = harness(Language::default());
    harness.get_by_label("Help").click();
    settle(&mut harness);
    harness.get_by_label_contains("Manual").click();
    settle(&mut harness);
    assert!(harness.state().ui.has_dialog(), "hotkeys still fire");
    harness.get_by_label("Make an animation");
    press(&mut harness, Key::Escape);
    assert!(!harness.state().ui.has_dialog());
    assert!(harness.query_by_label("Make an animation").is_none());
}

#[test]
fn pages_are_chosen_in_the_list_by_links_and_by_arrows() {
    let mut harness = opened(Language::default());
    choose(&mut harness, "Grading");
    harness.get_by_label("Grade a folder of submissions");
    press(&mut harness, Key::ArrowRight);
    harness.get_by_label("Layouts");
    press(&mut harness, Key::ArrowLeft);
    harness.get_by_label("The rubric");
    // The page on texts leads here, and back.
    press(&mut harness, Key::ArrowRight);
    harness.get_by_label("grading").click();
    settle(&mut harness);
    harness.get_by_label("The rubric");
    harness.get_by_label("Go back").click();
    settle(&mut harness);
    harness.get_by_label("Layouts");
}

#[test]
fn a_link_to_a_heading_scrolls_to_it() {
    let mut harness = opened(Language::default());
    choose(&mut harness, "Hotkeys");
    press(&mut harness, Key::End);
    harness.query_all_by_label("Window and timeline").last().unwrap().click();
    settle(&mut harness);
    let wanted = top(&harness, "Mouse in the scene");
    assert!((0.0..800.0).contains(&wanted), "{wanted}");
    press(&mut harness, Key::End);
    assert!(top(&harness, "Mouse in the scene") < wanted - 400.0);
}

#[test]
fn keys_scroll() {
    let mut harness = opened(Language::default());
    let heading = "Make an animation";
    let start = top(&harness, heading);
    press(&mut harness, Key::ArrowDown);
    let down = top(&harness, heading);
    assert!(down < start - 20.0, "{start} {down}");
    press(&mut harness, Key::ArrowUp);
    assert_eq!(top(&harness, heading), start);
    press(&mut harness, Key::PageDown);
    let page_down = top(&harness, heading);
    assert!(page_down < down);
    press(&mut harness, Key::Home);
    assert_eq!(top(&harness, heading), start);
    // A closed manual keeps its place.
    press(&mut harness, Key::ArrowDown);
    press(&mut harness, Key::Escape);
    harness.state_mut().apply(Command::Window(WindowCommand::ShowManual));
    settle(&mut harness);
    assert_eq!(top(&harness, heading), down);
}

#[test]
fn its_labels_are_korean_in_a_korean_window() {
    let mut harness = opened(Language::of_code("ko").unwrap());
    for label in ["설명서", "뒤로", "닫기"] {
        harness.get_by_label(label);
    }
    choose(&mut harness, "Window and timeline");
    assert!(harness.query_by_label_contains("그림: The window while a robot walks").is_some());
}

/// A letter that no font has is a panic.
#[test]
fn every_page_is_drawn_and_the_fonts_have_its_letters() {
    let mut harness = opened(Language::default());
    let pages = manual::names().len();
    for _ in 1..pages {
        press(&mut harness, Key::ArrowRight);
    }
    harness.get_by_label("Add a page to this manual");
}
