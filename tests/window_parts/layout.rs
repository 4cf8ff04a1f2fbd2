//! How the window is divided.

use egui::{Rect, pos2, vec2};
use egui_kittest::kittest::Queryable as _;

use inbetween::editor::{Command, Side, ViewCommand, WindowCommand};

use crate::{App, click, does, drag, editor, harness_of, press};

/// Panels in a window of this size and scale, with the timeline as high as this.
fn panels(size: egui::Vec2, percent: u16, timeline: Option<f32>) -> egui_kittest::Harness<'static, App> {
    let mut app = App::new(editor(5));
    app.settings.scale_percent = percent;
    app.settings.panels.extend(timeline.map(|height| ("timeline".to_owned(), height)));
    app.ui.adopt(&app.settings);
    harness_of(app, size)
}

#[test]
fn nothing_is_painted_over_anything() {
    let sizes = [vec2(720.0, 480.0), vec2(1280.0, 800.0), vec2(1500.0, 900.0) / 2.0];
    for (size, percent) in sizes.into_iter().flat_map(|size| [(size, 100), (size, 200)]) {
        for timeline in [None, Some(407.0), Some(4000.0)] {
            let mut harness = panels(size, percent, timeline);
            let window = Rect::from_min_size(pos2(0.0, 0.0), harness.ctx.content_rect().size());
            let scene = harness.state().viewport;
            assert!(window.contains_rect(scene) && scene.width() >= 160.0 && scene.height() >= 60.0, "{size}: {scene}");
            // A press on a number is the inspector's, and one on a row the tree's, wherever they can be seen.
            let side = Rect::from_min_max(pos2(scene.right(), scene.top()), window.max);
            let numbers: Vec<Rect> =
                harness.get_all_by_role(egui::accesskit::Role::SpinButton).map(|node| node.rect()).collect();
            let rows: Vec<Rect> =
                harness.get_all_by_role(egui::accesskit::Role::ListBoxOption).map(|node| node.rect()).collect();
            let inspector =
                numbers.iter().filter(|rect| side.contains(rect.center())).map(Rect::top).fold(f32::MAX, f32::min);
            assert!(inspector > side.top() + 60.0, "{size} at {percent} %: the inspector begins at {inspector}");
            let visible = rows.iter().filter(|row| side.contains(row.center()) && row.bottom() <= inspector).count();
            let least = if side.height() < 240.0 { 1 } else { 3 };
            assert!(visible >= least, "{size} at {percent} %: {visible} rows of the tree");
            let before = harness.state().commands.len();
            harness.hover_at(pos2(side.center().x, inspector + 8.0));
            harness.run();
            assert_eq!(harness.state().commands.len(), before);
        }
    }
}

#[test]
fn in_a_narrow_window_the_right_panel_lies_over_the_scene_while_it_is_asked_for() {
    for size in [vec2(400.0, 800.0), vec2(360.0, 480.0), vec2(550.0, 345.0)] {
        let mut harness = panels(size, 100, None);
        let window = Rect::from_min_size(pos2(0.0, 0.0), harness.ctx.content_rect().size());
        let scene = harness.state().viewport;
        // The harness has a margin.
        assert!(scene.width() >= window.width() - 16.0, "{size}: {scene}");
        assert!(scene.height() >= 60.0 && harness.query_by_label("Translation x").is_none(), "{size}: {scene}");
        for label in ["Auto-key is off", "More of the transport", "Show the nodes and the inspector"] {
            let rect = harness.get_by_label(label).rect();
            assert!(window.contains_rect(rect) && rect.top() >= scene.bottom(), "{size}: {label} at {rect}");
        }
        let over_scene = |harness: &egui_kittest::Harness<'_, App>| {
            let at = pos2(scene.right() - 20.0, scene.center().y);
            harness.ctx.layer_id_at(at).is_some_and(|layer| layer.order != egui::Order::Background)
        };
        assert!(!over_scene(&harness), "{size}");
        click(&mut harness, "Show the nodes and the inspector");
        assert_eq!(harness.state().viewport, scene, "the scene stays as it is");
        assert!(over_scene(&harness), "{size}");
        let is_over = |row: Rect| scene.contains(row.center());
        assert!(harness.get_all_by_role(egui::accesskit::Role::ListBoxOption).any(|row| is_over(row.rect())), "{size}");
        click(&mut harness, "Hide the nodes and the inspector");
        assert!(harness.query_by_label("Translation x").is_none() && !over_scene(&harness), "{size}");
    }
}

#[test]
fn dialogs_fit_a_narrow_window() {
    let mut harness = panels(vec2(400.0, 800.0), 100, None);
    let window = Rect::from_min_size(pos2(0.0, 0.0), harness.ctx.content_rect().size());
    let is_within = |rect: Rect| window.left() <= rect.left() && rect.right() <= window.right();
    for command in [WindowCommand::ShowHotkeys, WindowCommand::ShowAbout] {
        does(&mut harness, Command::Window(command.clone()));
        let close = harness.get_by_label("Close").rect();
        assert!(window.contains_rect(close), "{command:?}: {close}");
        press(&mut harness, egui::Key::Escape);
    }
    for (command, role) in [
        (WindowCommand::ShowExport, egui::accesskit::Role::TextInput),
        (WindowCommand::ShowExport, egui::accesskit::Role::ComboBox),
        (WindowCommand::ShowCommands, egui::accesskit::Role::TextInput),
    ] {
        does(&mut harness, Command::Window(command.clone()));
        let shown: Vec<Rect> = harness.get_all_by_role(role).map(|node| node.rect()).collect();
        assert!(!shown.is_empty() && shown.iter().all(|&rect| is_within(rect)), "{command:?}: {shown:?}");
        press(&mut harness, egui::Key::Escape);
    }
}

#[test]
fn edges_are_dragged_and_kept() {
    let mut harness = panels(vec2(1280.0, 800.0), 100, None);
    let before = harness.state().viewport;
    let edge = harness.get_by_label("Edge of the right panel").rect().center();
    drag(&mut harness, edge, edge - vec2(60.0, 0.0));
    let width = before.right() - harness.state().viewport.right();
    assert!((width - 60.0).abs() <= 1.0, "{width}");
    let edge = harness.get_by_label("Edge of the timeline").rect().center();
    drag(&mut harness, edge, edge + vec2(0.0, 40.0));
    let height = harness.state().viewport.bottom() - before.bottom();
    assert!((height - 40.0).abs() <= 1.0, "{height}");
    let kept: Vec<&str> = harness.state().output.panels.iter().map(|(name, _)| *name).collect();
    assert_eq!(kept, ["side", "timeline"]);
    // A drag beyond the window leaves room for the scene.
    let edge = harness.state().viewport.center_bottom();
    drag(&mut harness, edge, pos2(edge.x, -50.0));
    assert!(harness.state().viewport.height() >= 90.0, "{}", harness.state().viewport);
}

#[test]
fn the_divider_of_the_right_panel_moves_and_goes_back() {
    let mut harness = panels(vec2(1280.0, 800.0), 100, None);
    let top = |harness: &egui_kittest::Harness<'_, App>| harness.get_by_label("Translation x").rect().top();
    let before = top(&harness);
    let edge = |harness: &egui_kittest::Harness<'_, App>| harness.get_by_label("Edge of the inspector").rect().center();
    let at = edge(&harness);
    drag(&mut harness, at, at - vec2(0.0, 80.0));
    let moved = before - top(&harness);
    assert!((moved - 80.0).abs() <= 1.0, "{moved}");
    assert!(harness.state().output.panels.iter().any(|(name, _)| *name == "inspector"));
    let at = edge(&harness);
    harness.hover_at(at);
    harness.run();
    for _ in 0..2 {
        harness.drag_at(at);
        harness.step();
        harness.drop_at(at);
        harness.step();
    }
    harness.run();
    assert!((top(&harness) - before).abs() <= 1.0);
    assert_eq!(harness.state().output.panels.last(), Some(&("inspector", None)));
}

#[test]
fn the_export_dialog_and_menus_fit_a_low_window() {
    // What a display of 1366x768 leaves a window at 200 %.
    let mut harness = panels(vec2(1229.0, 691.0) / 2.0, 100, None);
    let window = Rect::from_min_size(pos2(0.0, 0.0), harness.ctx.content_rect().size());
    does(&mut harness, Command::Window(WindowCommand::ShowExport));
    for label in ["Export a film", "Cancel", "Export"] {
        let rect = harness.get_by_label(label).rect();
        assert!(window.contains_rect(rect), "{label}: {rect}");
    }
    press(&mut harness, egui::Key::Escape);
    click(&mut harness, "Edit");
    let (edit, item) = (harness.get_by_label("Edit").rect(), harness.get_by_label("Display keyframe Space").rect());
    assert!(item.top() >= edit.bottom() && item.left() <= edit.right(), "{item} below {edit}");
}

#[test]
fn what_is_said_of_a_film_leaves_the_letters_of_the_axes_free() {
    let mut harness = panels(vec2(1280.0, 800.0), 100, None);
    harness.state_mut().ui.made = Some("/films/walk.gif".into());
    harness.run();
    let letter = harness.get_by_label("Look from +X").rect();
    let close = harness.get_by_label("Close").rect();
    assert!(close.right() < harness.state().viewport.right() - 84.0, "{close}");
    assert!(!close.intersects(letter), "{close} and {letter}");
    click(&mut harness, "Look from +X");
    assert_eq!(harness.state().commands, [Command::View(ViewCommand::LookFrom(Side::Right))]);
}
