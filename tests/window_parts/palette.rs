//! The list of commands.

use egui::{Key, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use inbetween::editor::keymap::bindings;
use inbetween::editor::{Command, ViewCommand, WindowCommand};
use inbetween::ui::words::Words;
use inbetween::words::Language;

use crate::{App, does, editor, harness, press, type_text};

const SHOW: Command = Command::Window(WindowCommand::ShowCommands);

/// The names in the list, from the top, and how high they stand.
fn rows(harness: &Harness<'_, App>) -> Vec<String> {
    let rows = harness.get_all_by_role(egui::accesskit::Role::ListBoxOption);
    let rows = rows.filter(|row| row.rect().width() > 400.0);
    rows.filter_map(|row| row.accesskit_node().label()).collect()
}

#[test]
fn the_list_is_as_high_after_any_search() {
    let mut harness = harness(editor(3));
    does(&mut harness, SHOW);
    let dialog = |harness: &Harness<'_, App>| {
        let rows = harness.get_all_by_role(egui::accesskit::Role::ListBoxOption);
        rows.filter(|row| row.rect().width() > 400.0).map(|row| row.rect()).reduce(egui::Rect::union)
    };
    let before = dialog(&harness).unwrap();
    assert!(before.height() > 11.0 * 26.0, "{before}");
    for typed in ["zzzz", "statistics"] {
        type_text(&mut harness, typed);
        press(&mut harness, Key::Escape);
        does(&mut harness, SHOW);
        let after = dialog(&harness).unwrap();
        assert!((after.height() - before.height()).abs() < 1.0, "{after} after {typed}, {before} before");
    }
}

#[test]
fn commands_are_found_by_other_words() {
    let mut harness = harness(editor(3));
    does(&mut harness, SHOW);
    for (typed, first) in [
        ("zoom in", "Larger"),
        ("onion", "Ghosts"),
        ("video", "Export…"),
        ("light", "Theme: Light"),
        ("trajectory", "Motion path"),
        ("save", "Save"),
    ] {
        type_text(&mut harness, typed);
        let found = rows(&harness);
        assert!(found.iter().take(3).any(|name| name == first), "{typed}: {found:?}");
    }
    type_text(&mut harness, "grid of nothing");
    assert_eq!(rows(&harness), [""; 0]);
    harness.get_by_label("Nothing here is called \"grid of nothing\".");
}

#[test]
fn every_synonym_is_found_in_both_languages() {
    for binding in bindings() {
        for language in Language::all() {
            let Some(also) = binding.synonyms() else { continue };
            let also = Words::new(language).say(also);
            assert!(also.split(", ").all(|word| !word.trim().is_empty()), "{}: {also:?}", binding.id);
        }
    }
    assert!(bindings().iter().filter(|binding| binding.synonyms().is_some()).count() > 40);
}

#[test]
fn a_node_is_chosen_by_its_name() {
    let mut harness = harness(editor(3));
    let elbow = harness.state().editor.scene().find_rbt("robot1/right_shoulder/right_elbow").unwrap();
    does(&mut harness, SHOW);
    type_text(&mut harness, "right elbow");
    assert_eq!(rows(&harness)[0], "robot1/right_shoulder/right_elbow");
    press(&mut harness, Key::Enter);
    assert_eq!(harness.state().commands, [Command::View(ViewCommand::Choose(Some(elbow)))]);
    assert!(!harness.state().ui.has_dialog());
}

#[test]
fn the_list_fits_a_small_window() {
    let app = App::new(editor(3));
    let mut harness = crate::harness_of(app, vec2(720.0, 480.0));
    does(&mut harness, SHOW);
    let rows = harness.get_all_by_role(egui::accesskit::Role::ListBoxOption);
    let seen = rows.filter(|row| row.rect().width() > 400.0).filter(|row| row.rect().bottom() < 470.0).count();
    assert!(seen >= 8, "{seen}");
}
