//! The help.

use egui::{Key, vec2};
use egui_kittest::kittest::Queryable as _;
use inbetween::editor::{Command, ViewCommand};

use crate::{App, click, does, editor, harness_of, type_text};

const TOGGLE: Command = Command::View(ViewCommand::ToggleHelp);

#[test]
fn the_help_fits_every_window() {
    for size in [vec2(720.0, 480.0), vec2(1366.0, 768.0), vec2(2560.0, 1440.0)] {
        let mut harness = harness_of(App::new(editor(0)), size);
        does(&mut harness, TOGGLE);
        let close = harness.get_by_label("Close").rect();
        assert!(close.top() >= 0.0 && close.bottom() <= size.y && close.right() <= size.x, "{close} in {size}");
        assert!(harness.query_all_by_label_contains("Drag on the ruler: ").count() == 1);
        click(&mut harness, "Close");
        assert!(!harness.state().editor.session().shows_help);
    }
}

#[test]
fn the_help_is_searched() {
    let mut harness = harness_of(App::new(editor(0)), vec2(1280.0, 800.0));
    does(&mut harness, TOGGLE);
    assert!(!harness.state().ui.has_keyboard(&harness.ctx), "hotkeys work over the help");
    click(&mut harness, "Search the help");
    type_text(&mut harness, "keyframe");
    assert!(harness.query_all_by_label_contains("n: ").count() > 0);
    type_text(&mut harness, "onion skin");
    assert_eq!(harness.query_all_by_label_contains("Shift+G: ").count(), 1);
    assert!(harness.query_by_label_contains("Left drag: ").is_none());
    type_text(&mut harness, "xyzzy");
    harness.get_by_label("Nothing here is called \"xyzzy\".");
    harness.key_press(Key::Escape);
    harness.run();
    assert!(harness.state().editor.session().shows_help, "Escape leaves the field first");
}

#[test]
fn a_click_beside_the_help_closes_it() {
    let mut harness = harness_of(App::new(editor(0)), vec2(1280.0, 800.0));
    does(&mut harness, TOGGLE);
    let at = egui::pos2(4.0, 400.0);
    harness.hover_at(at);
    harness.run();
    harness.drag_at(at);
    harness.drop_at(at);
    harness.run();
    assert_eq!(harness.state().commands, [TOGGLE]);
}
