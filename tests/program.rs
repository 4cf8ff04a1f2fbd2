//! The window's own side, with no window: the list of commands, keys and their changes, toasts and the log, languages, sizes, Tab.

use std::path::PathBuf;
use std::sync::Arc;

use egui::{Key, Modifiers, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use inbetween::editor::keymap::bindings;
use inbetween::editor::{Command, Edit, Editor, Effect, FileCommand, Severity, ViewCommand, WindowCommand};
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use inbetween::settings::{Settings, ThemeChoice};
use inbetween::ui::{Panels, Statistics, theme};
use inbetween::words::Language;

struct App {
    editor: Editor,
    ui: Panels,
    settings: Settings,
    commands: Vec<Command>,
    panels: Vec<(&'static str, Option<f32>)>,
    viewport: egui::Rect,
    is_dressed: bool,
}

impl App {
    /// What the window does with a command.
    fn apply(&mut self, command: Command) {
        if let Ok(Some(Effect::Window(command))) = self.editor.apply(command.clone()) {
            match self.ui.perform(&command, &mut self.settings) {
                Ok(None) => {}
                Ok(Some(said)) => self.editor.say(said.with_severity(Severity::Outcome)),
                Err(error) => self.editor.say(error.message()),
            }
        }
        self.commands.push(command);
    }
}

fn harness_with(keyframes: usize, settings: Settings) -> Harness<'static, App> {
    let scene = built_in_scene(DEFAULT_SCENE).expect("the default scene is built in");
    let mut editor = Editor::new(Arc::new(scene), PathBuf::from("folder/걷기.json"));
    for _ in 0..keyframes {
        editor.apply(Command::Edit(Edit::CreateKeyframe)).unwrap();
    }
    let mut ui = Panels::new();
    assert_eq!(ui.adopt(&settings), []);
    let app = App {
        editor,
        ui,
        settings,
        commands: Vec::new(),
        panels: Vec::new(),
        viewport: egui::Rect::NOTHING,
        is_dressed: false,
    };
    let mut harness = Harness::builder().with_size(vec2(1280.0, 800.0)).build_ui_state(
        |ui, app: &mut App| {
            if !std::mem::replace(&mut app.is_dressed, true) {
                theme::install(ui.ctx());
            }
            let output = app.ui.show(ui, &app.editor);
            app.panels.extend(output.panels);
            app.viewport = output.viewport;
            for command in output.commands {
                app.apply(command);
            }
        },
        app,
    );
    harness.run();
    harness
}

fn harness(keyframes: usize) -> Harness<'static, App> {
    harness_with(keyframes, Settings::default())
}

fn ask(harness: &mut Harness<'_, App>, command: WindowCommand) {
    harness.state_mut().apply(Command::Window(command));
    harness.state_mut().commands.clear();
    harness.run();
}

fn type_text(harness: &mut Harness<'_, App>, text: &str) {
    harness.event(egui::Event::Text(text.to_owned()));
    harness.run();
}

fn press(harness: &mut Harness<'_, App>, key: Key) {
    harness.key_press(key);
    harness.run();
}

fn click(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by_label(label).click();
    harness.run();
}

fn selected(harness: &Harness<'_, App>) -> Vec<String> {
    harness
        .query_all_by(|node| node.is_selected() == Some(true) && node.role() == egui::Role::ListBoxOption)
        .filter_map(|node| node.accesskit_node().label())
        .collect()
}

#[test]
fn the_list_of_commands_narrows_and_runs() {
    let mut harness = harness(0);
    ask(&mut harness, WindowCommand::ShowCommands);
    assert!(harness.state().ui.has_dialog());
    type_text(&mut harness, "new key");
    assert_eq!(selected(&harness), ["New keyframe"]);
    press(&mut harness, Key::Enter);
    assert_eq!(harness.state().commands, [Command::Edit(Edit::CreateKeyframe)]);
    assert!(!harness.state().ui.has_dialog());
}

#[test]
fn arrows_move_in_the_list_and_escape_leaves_it() {
    let mut harness = harness(0);
    ask(&mut harness, WindowCommand::ShowCommands);
    type_text(&mut harness, "larger");
    press(&mut harness, Key::Escape);
    assert!(!harness.state().ui.has_dialog());
    assert_eq!(harness.state().commands, []);
    ask(&mut harness, WindowCommand::ShowCommands);
    let first = selected(&harness);
    press(&mut harness, Key::ArrowDown);
    let second = selected(&harness);
    press(&mut harness, Key::ArrowUp);
    assert_ne!(first, second);
    assert_eq!(selected(&harness), first);
    press(&mut harness, Key::ArrowUp);
    assert_eq!(selected(&harness), ["Snap moves to: 1"]);
    press(&mut harness, Key::Enter);
    assert!((harness.state().editor.session().snap.units - 1.0).abs() < f64::EPSILON);
}

#[test]
fn what_cannot_be_done_is_not_run_from_the_list() {
    let mut harness = harness(0);
    ask(&mut harness, WindowCommand::ShowCommands);
    type_text(&mut harness, "delete keyframe");
    let is_row = |node: &egui_kittest::Node<'_>| node.accesskit_node().role() == egui::Role::ListBoxOption;
    let row = harness.get_all_by_label("Delete keyframe").find(is_row).expect("it is listed");
    assert!(row.accesskit_node().is_disabled());
    press(&mut harness, Key::Enter);
    assert_eq!(harness.state().commands, []);
    assert!(harness.state().ui.has_dialog());
}

#[test]
fn every_row_of_the_table_is_in_the_list() {
    for binding in bindings() {
        let mut harness = harness(0);
        ask(&mut harness, WindowCommand::ShowCommands);
        type_text(&mut harness, binding.title().english());
        assert!(
            selected(&harness).iter().any(|name| name == binding.title().english()),
            "{}: {:?}",
            binding.title().english(),
            selected(&harness)
        );
    }
}

#[test]
fn a_key_is_changed_by_pressing_it() {
    let mut harness = harness(0);
    ask(&mut harness, WindowCommand::ShowHotkeys);
    click(&mut harness, "New keyframe: change the key n");
    harness.key_press_modifiers(Modifiers::CTRL, Key::K);
    harness.run();
    assert_eq!(harness.state().settings.keys["keyframe-new"], ["Ctrl+K"]);
    assert_eq!(harness.state().ui.keymap().get("keyframe-new").unwrap().keys(), "Ctrl+K");
    click(&mut harness, "Reset the keys of New keyframe");
    assert!(harness.state().settings.keys.is_empty());
}

#[test]
fn a_clash_is_refused_and_said() {
    let mut harness = harness(0);
    ask(&mut harness, WindowCommand::ShowHotkeys);
    click(&mut harness, "New keyframe: change the key n");
    press(&mut harness, Key::Y);
    harness.get_by_label("y is the key of \"Play or stop\": give that another key first.");
    assert!(harness.state().settings.keys.is_empty());
    assert_eq!(harness.state().commands, []);
    // Escape leaves first what waits, then the dialog.
    click(&mut harness, "New keyframe: one more key");
    press(&mut harness, Key::Escape);
    assert!(harness.state().ui.has_dialog());
    press(&mut harness, Key::Escape);
    assert!(!harness.state().ui.has_dialog());
}

#[test]
fn changed_keys_show_everywhere() {
    // Older settings have English names in place of ids.
    for name in ["keyframe-new", "New keyframe"] {
        let mut settings = Settings::default();
        settings.keys.insert(name.to_owned(), vec!["F5".to_owned()]);
        let mut harness = harness_with(0, settings);
        click(&mut harness, "Edit");
        harness.get_by_label("New keyframe F5");
        press(&mut harness, Key::Escape);
        harness.state_mut().apply(Command::View(ViewCommand::ToggleHelp));
        harness.run();
        harness.get_by_label("F5: New keyframe from the scene, after the current one");
    }
}

#[test]
fn results_and_errors_are_toasts_and_all_is_in_the_log() {
    let mut harness = harness(1);
    harness.state_mut().apply(Command::Undo);
    harness.state_mut().apply(Command::Undo);
    harness.state_mut().editor.screenshot_taken(&PathBuf::from("shot.png"), Ok(())).unwrap();
    harness.run();
    let alerts = |harness: &Harness<'_, App>| -> Vec<String> {
        harness.query_all_by_role(egui::Role::Alert).filter_map(|node| node.accesskit_node().label()).collect()
    };
    let mut shown = alerts(&harness);
    shown.sort();
    assert_eq!(shown, ["Screenshot: shot.png.", "There is nothing to undo."]);
    ask(&mut harness, WindowCommand::ToggleMessages);
    for said in
        ["Keyframe 0 (0 to 0): created the first keyframe.", "Undone: new keyframe.", "There is nothing to undo."]
    {
        assert!(harness.query_all_by_label(said).next().is_some(), "the log lacks {said}");
    }
    // A result goes, an error stays longer, and then nothing wants the window to be drawn again.
    for _ in 0..24 {
        harness.step();
    }
    assert_eq!(alerts(&harness), ["There is nothing to undo."]);
    for _ in 0..24 {
        harness.step();
    }
    assert_eq!(alerts(&harness), Vec::<String>::new());
    harness.step();
    let delay = harness.output().viewport_output[&egui::ViewportId::ROOT].repaint_delay;
    assert_eq!(delay, std::time::Duration::MAX);
}

#[test]
fn statistics_are_in_the_status_line() {
    let english = "58 pictures/s · 60 ticks/s · ms: input 0.1, evaluation 0.2, frame 0.3, UI 1.4, drawing 15.5";
    let korean = "58화면/초 · 60틱/초 · 밀리초: 입력 0.1, 계산 0.2, 장면 0.3, 패널 1.4, 그리기 15.5";
    let mut harness = harness(4);
    assert!(harness.query_by_label_contains("pictures/s").is_none());
    ask(&mut harness, WindowCommand::ToggleStatistics);
    let shown = &mut harness.state_mut().ui.statistics;
    assert_eq!(*shown, Some(Statistics::default()));
    *shown = Some(Statistics {
        pictures: 57.6,
        ticks: 60.0,
        input_ms: 0.06,
        evaluation_ms: 0.2,
        frame_ms: 0.3,
        ui_ms: 1.4,
        drawing_ms: 15.5,
    });
    harness.run();
    harness.get_by_label(english);
    ask(&mut harness, WindowCommand::SetLanguage(Language::of_code("ko").unwrap()));
    harness.get_by_label(korean);
    ask(&mut harness, WindowCommand::SetLanguage(Language::default()));
    ask(&mut harness, WindowCommand::ToggleStatistics);
    assert!(harness.query_by_label_contains("pictures/s").is_none());
}

#[test]
fn a_repeated_error_is_one_toast() {
    let mut harness = harness(0);
    for _ in 0..3 {
        harness.state_mut().apply(Command::Undo);
        harness.run();
    }
    let said = "There is nothing to undo. (×3)";
    assert_eq!(
        harness.query_all_by(|node| node.role() == egui::Role::Alert && node.label().as_deref() == Some(said)).count(),
        1
    );
}

#[test]
fn the_window_speaks_korean() {
    let mut harness = harness(0);
    ask(&mut harness, WindowCommand::SetLanguage(Language::of_code("ko").unwrap()));
    click(&mut harness, "편집(E)");
    harness.get_by_label("새 키프레임 n");
    press(&mut harness, Key::Escape);
    harness.state_mut().apply(Command::Edit(Edit::CreateKeyframe));
    harness.run();
    harness.get_by_label("첫 키프레임을 만들었습니다.");
    ask(&mut harness, WindowCommand::ShowCommands);
    type_text(&mut harness, "영");
    type_text(&mut harness, "x");
    harness.get_by_label("\"영x\"(이)라는 것이 여기에 없습니다.");
}

#[test]
fn colours_and_sizes_are_settings() {
    let mut harness = harness(0);
    ask(&mut harness, WindowCommand::SetTheme(ThemeChoice::Light));
    harness.run();
    assert_eq!(harness.ctx.theme(), egui::Theme::Light);
    ask(&mut harness, WindowCommand::Larger);
    harness.run();
    assert_eq!(harness.state().settings.scale_percent, 125);
    assert!((harness.ctx.zoom_factor() - 1.25).abs() < 1e-6);
}

#[test]
fn a_dragged_panel_is_remembered() {
    let mut harness = harness(0);
    let edge = egui::pos2(harness.state().viewport.right(), 300.0);
    harness.hover_at(edge);
    harness.run();
    harness.drag_at(edge);
    harness.run();
    for step in 1..=5u8 {
        harness.hover_at(edge - vec2(f32::from(step) * 12.0, 0.0));
        harness.run();
    }
    assert_eq!(harness.state().panels, []);
    harness.drop_at(edge - vec2(60.0, 0.0));
    harness.run();
    let panels = harness.state().panels.clone();
    assert_eq!(panels.len(), 1, "{panels:?}");
    assert!(panels[0].0 == "side" && (panels[0].1.unwrap() - theme::SIDE - 60.0).abs() < 4.0, "{panels:?}");

    let mut settings = Settings::default();
    settings.resized("side", Some(400.0));
    settings.resized("timeline", Some(300.0));
    let usual = harness.state().viewport.bottom();
    let harness = harness_with(0, settings);
    let bottom = harness.state().viewport.bottom();
    assert!(usual - bottom > 300.0 - theme::TIMELINE - 10.0, "{usual} and {bottom}: a higher timeline leaves less");
    let name = harness.get_by_label("Translation x").rect();
    let side = harness.state().viewport.right();
    assert!(name.left() > side && (1272.0 - side - 400.0).abs() < 2.0, "{name} {side}");
}

#[test]
fn recent_files_are_in_the_menu() {
    let mut settings = Settings::default();
    settings.used(&PathBuf::from("/tmp/걷기.json"));
    let mut harness = harness_with(0, settings);
    click(&mut harness, "File");
    harness.get_by_label_contains("Open recent").click();
    harness.run();
    harness.get_by_label("/tmp/걷기.json").click();
    harness.run();
    assert_eq!(harness.state().commands, [Command::File(FileCommand::Open(PathBuf::from("/tmp/걷기.json")))]);
}

#[test]
fn tab_reaches_every_control() {
    let mut harness = harness(5);
    let pressable = [egui::Role::Button, egui::Role::SpinButton, egui::Role::ComboBox, egui::Role::ListBoxOption];
    let wanted: Vec<String> = harness
        .query_all_by(|node| pressable.contains(&node.role()) && !node.is_disabled())
        .map(|node| node.accesskit_node().label().unwrap_or_default())
        .collect();
    assert!(wanted.len() > 40, "{wanted:?}");
    assert!(wanted.iter().all(|name| !name.is_empty()), "a control has no name: {wanted:?}");
    let mut reached = Vec::new();
    for _ in 0..2 * wanted.len() {
        harness.key_press(Key::Tab);
        harness.run();
        let focused = harness
            .query_all_by(|node| node.is_focused() && !node.is_hidden())
            .filter_map(|node| node.accesskit_node().label());
        reached.extend(focused);
    }
    // Within the timeline arrows move; a row's triangle is Right and Left on its name.
    let focused = |harness: &Harness<'_, App>| {
        let mut nodes = harness.query_all_by(|node| node.is_focused() && !node.is_hidden());
        nodes.find_map(|node| node.accesskit_node().label()).unwrap_or_default()
    };
    while !focused(&harness).starts_with("Keyframe ") {
        harness.key_press(Key::Tab);
        harness.run();
    }
    for key in [Key::ArrowLeft, Key::ArrowRight, Key::ArrowDown, Key::ArrowUp] {
        for _ in 0..12 {
            harness.key_press(key);
            harness.run();
            reached.push(focused(&harness));
        }
    }
    let is_triangle = |name: &str| name.starts_with("Fold the row of ") || name.starts_with("Unfold the row of ");
    // Digits look along the axes.
    let is_axis = |name: &str| name.starts_with("Look from ") || name == "Look along";
    for name in wanted.into_iter().filter(|name| !is_triangle(name) && !is_axis(name)) {
        assert!(reached.contains(&name), "Tab does not reach {name}");
    }
}
