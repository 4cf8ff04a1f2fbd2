//! Dialogs: Enter, tooltips under them, the status line.

use std::path::PathBuf;

use egui::{Key, vec2};
use egui_kittest::kittest::Queryable as _;
use inbetween::editor::{Command, Edit, FileCommand, GestureCommand, WindowCommand};
use inbetween::ui::{OverwriteAnswer, OverwriteQuestion, OverwriteReason, PathPurpose, QuitAnswer};

use crate::{click, does, editor, harness, press};

#[test]
fn enter_presses_the_default_button_of_every_dialog() {
    let mut harness = harness(editor(5));
    does(&mut harness, Command::Window(WindowCommand::ShowExport));
    // The field of the path has the keyboard.
    press(&mut harness, Key::Enter);
    assert!(matches!(harness.state().commands.last(), Some(Command::File(FileCommand::Export(_)))));
    assert!(!harness.state().ui.has_dialog());

    harness.state_mut().ui.ask_for_path(PathPurpose::SaveAs, &PathBuf::from("wave.json"));
    harness.run();
    press(&mut harness, Key::Enter);
    let saves = Command::File(FileCommand::SaveAs(PathBuf::from("wave.json")));
    assert_eq!(harness.state().commands.last(), Some(&saves));

    harness.state_mut().ui.ask_before_quitting();
    harness.run();
    press(&mut harness, Key::Enter);
    assert_eq!(harness.state().output.quit_answer, Some(QuitAnswer::Save));

    let question =
        OverwriteQuestion { path: PathBuf::from("wave.json"), reason: OverwriteReason::Changed, differences: None };
    harness.state_mut().ui.ask_before_overwriting(question);
    harness.run();
    press(&mut harness, Key::Enter);
    assert_eq!(harness.state().output.overwrite, Some(OverwriteAnswer::SaveAs));
}

#[test]
fn enter_on_another_button_presses_that_one() {
    let mut harness = harness(editor(5));
    harness.state_mut().ui.ask_before_quitting();
    harness.run();
    harness.get_by_label("Discard").focus();
    harness.run();
    press(&mut harness, Key::Enter);
    assert_eq!(harness.state().output.quit_answer, Some(QuitAnswer::Discard));
}

#[test]
fn a_tooltip_goes_when_a_dialog_comes() {
    for command in [WindowCommand::ShowExport, WindowCommand::ShowCommands] {
        let mut harness = harness(editor(5));
        let tips = |harness: &egui_kittest::Harness<'_, crate::App>| {
            harness.query_all_by_label_contains("Keep the scene's pose as").count()
                + harness.ctx.memory(|memory| {
                    memory
                        .areas()
                        .visible_layer_ids()
                        .iter()
                        .filter(|layer| layer.order == egui::Order::Tooltip)
                        .count()
                })
        };
        let at = harness.get_by_label("New keyframe").rect().center();
        harness.hover_at(at);
        harness.run();
        for _ in 0..60 {
            harness.step();
        }
        assert!(tips(&harness) > 0, "the button has a tooltip");
        does(&mut harness, Command::Window(command));
        for _ in 0..5 {
            harness.step();
        }
        assert_eq!(tips(&harness), 0);
    }
}

#[test]
fn a_drag_makes_the_status_line_forget() {
    let mut harness = harness(editor(2));
    does(&mut harness, Command::Undo);
    assert!(harness.query_all_by_label_contains("Undone").count() > 0);
    does(&mut harness, Command::Gesture(GestureCommand::Begin));
    assert!(harness.state().editor.status().is_none());
    does(&mut harness, Command::Gesture(GestureCommand::Abort));
    // What a command of the drag says stays while it goes on.
    does(&mut harness, Command::Edit(Edit::CreateKeyframe));
    assert!(harness.state().editor.status().is_some());
}

#[test]
fn dialogs_fit_a_small_window() {
    for command in [WindowCommand::ShowExport, WindowCommand::ShowHotkeys] {
        let mut harness = crate::harness_of(crate::App::new(editor(5)), vec2(720.0, 480.0));
        does(&mut harness, Command::Window(command));
        for label in ["Cancel", "Close", "Export"] {
            for button in harness.query_all_by_role_and_label(egui::accesskit::Role::Button, label) {
                let rect = button.rect();
                assert!(rect.bottom() <= 480.0 && rect.right() <= 720.0, "{label} at {rect}");
            }
        }
    }
    let mut harness = harness(editor(0));
    does(&mut harness, Command::Window(WindowCommand::ShowExport));
    click(&mut harness, "Cancel");
    assert!(!harness.state().ui.has_dialog());
}
