//! Keyboard and screen readers: menus by letters, names of what is no widget.

use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use inbetween::editor::keymap::Chord;

use crate::{editor, harness, press};

#[test]
fn alt_and_a_letter_opens_a_menu() {
    for (key, menu, item) in [
        (Key::F, "File", "Quit Ctrl+Q"),
        (Key::E, "Edit", "New keyframe n"),
        (Key::V, "View", "Panels F11"),
        (Key::A, "Animation", "Faster +"),
        (Key::H, "Help", "Manual F1"),
    ] {
        let mut harness = harness(editor(3));
        let is_open = |harness: &egui_kittest::Harness<'_, crate::App>| {
            let buttons = harness.get_all_by_label(menu);
            buttons.filter_map(|node| node.accesskit_node().data().is_expanded()).any(|is_open| is_open)
        };
        assert!(!is_open(&harness));
        harness.key_press_modifiers(Modifiers::ALT, key);
        harness.run();
        assert!(is_open(&harness), "{menu} is not open");
        harness.get_by_label(item);
        press(&mut harness, Key::ArrowDown);
        press(&mut harness, Key::Escape);
        assert!(!is_open(&harness), "{menu} stays open");
        assert_eq!(harness.state().commands, []);
    }
}

#[test]
fn f10_opens_the_first_menu_and_its_items_are_reached() {
    let mut harness = harness(editor(3));
    press(&mut harness, Key::F10);
    harness.get_by_label("Quit Ctrl+Q");
    press(&mut harness, Key::ArrowUp);
    press(&mut harness, Key::Enter);
    assert_eq!(harness.state().commands.len(), 1);
}

#[test]
fn a_hotkey_with_the_letter_comes_first() {
    let mut harness = harness(editor(3));
    let chords = vec![Chord::parse("Alt+F").unwrap().label()];
    harness.state_mut().settings.keys.insert("ghosts-next".to_owned(), chords);
    let settings = harness.state().settings.clone();
    assert_eq!(harness.state_mut().ui.adopt(&settings), []);
    harness.key_press_modifiers(Modifiers::ALT, Key::F);
    harness.run();
    assert!(harness.query_by_label("Quit Ctrl+Q").is_none());
}

#[test]
fn screen_readers_have_names_for_everything() {
    let harness = harness(editor(3));
    harness.get_by_label("Fold robot1");
    assert!(harness.query_by_label("Fold").is_none());
    let view = harness.get_by_label("3D view");
    assert!(view.accesskit_node().value().is_some_and(|value| value.contains("sky")));
    let frame = harness.root().accesskit_node().label().unwrap_or_default();
    assert!(frame.ends_with("wave.json • Inbetween"), "{frame}");
}

#[test]
fn escape_is_for_a_dialog_or_a_menu_before_the_choice() {
    let takes_escape = |harness: &egui_kittest::Harness<'_, crate::App>| harness.state().ui.takes_escape(&harness.ctx);
    let mut harness = harness(editor(3));
    assert!(!takes_escape(&harness));
    harness.get_by_label("File").click();
    harness.run();
    assert!(takes_escape(&harness), "a menu");
    press(&mut harness, Key::Escape);
    assert!(!takes_escape(&harness));
    harness.state_mut().ui.ask_before_quitting();
    harness.run();
    assert!(takes_escape(&harness), "a dialog");
    press(&mut harness, Key::Escape);
    assert!(!takes_escape(&harness));
}
