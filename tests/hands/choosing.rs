//! Hover and clicks: what lights up, what is chosen, added, gone on to, kept and ended.

use glam::Vec2;
use inbetween::editor::{Command, Eye, ViewCommand};
use inbetween::scene::Part;
use winit::keyboard::ModifiersState;

use crate::table::{HEAD, KNEE, Left, SHOULDER, Table, VIEW};

/// Every eye, and a node that is seen from it.
fn eyes() -> [(Eye, &'static str); 4] {
    [
        (Eye::Work, SHOULDER),
        (Eye::Recorded(0), SHOULDER),
        (Eye::Recorded(1), "robot2/left_shoulder"),
        (Eye::Recorded(2), SHOULDER),
    ]
}

/// A table seen from an eye, with the robots before both of them.
fn seen_from(eye: Eye) -> Table {
    let mut table = Table::new();
    match eye {
        Eye::Recorded(1) => table.run("set-translation 2 1 -6 robot2"),
        Eye::Recorded(2) => table.run("set-translation -2 1 -6 robot1"),
        Eye::Work | Eye::Recorded(_) => table.run("set-translation 0 0.25 8 sky"),
    }
    table.editor.apply(Command::View(ViewCommand::SetEye(eye))).unwrap();
    table
}

#[test]
fn what_a_click_would_choose_lights_up_with_its_name() {
    for (eye, path) in eyes() {
        let mut table = seen_from(eye);
        let at_px = table.on(path);
        table.move_to(at_px);
        assert_eq!(table.lit(), (Some(Part::Rbt(table.node(path))), path.to_owned()), "{eye:?}");
        table.click(at_px);
        assert_eq!(table.chosen(), [path], "{eye:?}");
        table.move_to(table.on_nothing());
        assert_eq!(table.lit(), (None, String::new()), "{eye:?}");
    }
}

#[test]
fn a_click_takes_the_nearest_part_within_8_points() {
    for (points, expected) in [(1.0, true), (7.0, true), (10.0, false)] {
        let mut table = Table::new();
        let beside_px = table.edge(table.on(KNEE), -Vec2::X) - Vec2::X * points * VIEW.pixels_per_point;
        assert_eq!(table.direct(beside_px), None);
        table.move_to(beside_px);
        assert_eq!(table.lit().0.is_some(), expected, "{points} points");
        table.click(beside_px);
        assert_eq!(table.chosen() == [KNEE], expected, "{points} points");
    }
}

#[test]
fn a_click_chooses_as_the_line_does() {
    let mut table = Table::after("select robot2");
    table.click(table.on(SHOULDER));
    assert_eq!(table.editor.session(), Table::after("select robot1/right_shoulder").editor.session());
    assert_eq!(table.undo_label(), None, "a choice is not undone");
}

#[test]
fn ctrl_and_a_click_go_on_to_what_is_behind() {
    let mut table = Table::after("look right");
    let at_px = table.on("robot2");
    table.hold(ModifiersState::CONTROL);
    let mut met = Vec::new();
    for _ in 0..12 {
        table.click(at_px);
        met.push(table.chosen().join(" "));
    }
    assert_eq!(met[0], "robot2");
    assert!(met.contains(&"robot1".to_owned()), "{met:?}");
    let round = met.iter().skip(1).position(|path| path == "robot2").unwrap() + 1;
    assert!((0..met.len() - round).all(|index| met[index] == met[index + round]), "{met:?}");
}

#[test]
fn shift_and_a_click_add_and_take_out() {
    let mut table = Table::new();
    table.click(table.on(SHOULDER));
    table.hold(ModifiersState::SHIFT);
    table.click(table.on(HEAD));
    assert_eq!(table.chosen(), [SHOULDER, HEAD]);
    let lines = "select robot1/right_shoulder\nselect-also robot2/head";
    assert_eq!(table.editor.session().chosen, Table::after(lines).editor.session().chosen);
    // Handles surround the last one: a click beside them.
    table.run("do gizmo");
    table.click(table.on(HEAD));
    assert_eq!(table.chosen(), [SHOULDER]);
}

#[test]
fn a_click_on_nothing_keeps_the_choice_and_a_double_click_ends_it() {
    for (eye, path) in eyes() {
        let mut table = seen_from(eye);
        table.click(table.on(path));
        let nothing_px = table.on_nothing();
        table.click(nothing_px);
        assert_eq!(table.chosen(), [path], "{eye:?}");
        table.click(nothing_px);
        assert_eq!(table.chosen(), [""; 0], "{eye:?}");
    }
}

#[test]
fn the_ground_is_nothing() {
    let mut table = Table::after("select robot2");
    table.click(table.on_ground());
    assert_eq!(table.chosen(), ["robot2"]);
    assert_eq!(table.lit().0, None);
}

#[test]
fn after_p_the_next_click_chooses_and_ground_or_nothing_none() {
    for (eye, path) in eyes() {
        for miss in [Table::on_nothing, Table::on_ground] {
            let mut table = seen_from(eye);
            table.run(&format!("select {HEAD}"));
            table.press("p");
            assert!(table.editor.session().is_picking);
            table.click(table.on(path));
            assert_eq!(table.chosen(), [path], "{eye:?}");
            assert!(!table.editor.session().is_picking, "p is for one click");
            table.press("p");
            table.click(miss(&table));
            assert_eq!(table.chosen(), [""; 0], "{eye:?}");
        }
    }
}

#[test]
fn a_picking_press_moves_nothing_with_any_eye() {
    for (eye, path) in eyes() {
        let mut table = seen_from(eye);
        let before = table.editor.document().live_pose.clone();
        table.press("p");
        table.drag(Left, table.on(path), Vec2::new(60.0, 20.0));
        assert_eq!((table.chosen(), &table.editor.document().live_pose), (vec![path], &before), "{eye:?}");
    }
}

#[test]
fn clicks_choose_while_playing() {
    let mut table = Table::new();
    table.play();
    table.click(table.on(SHOULDER));
    assert_eq!(table.chosen(), [SHOULDER]);
    assert!(table.editor.is_playing());
}

#[test]
fn a_click_on_what_only_keys_move_selects_its_keys() {
    let mut table = Table::of("cylinder");
    table.run("seconds 0");
    let id = table.editor.scene().find("cylinder").unwrap();
    let at_px = table.seen_px(glam::Vec3::ZERO);
    table.move_to(at_px);
    assert_eq!(table.lit(), (Some(Part::Keyed(id)), "cylinder".to_owned()));
    table.click(at_px);
    let mut by_line = Table::of("cylinder");
    by_line.run("select-keys translation 0 cylinder translation 2 cylinder translation 4 cylinder rotation 0 cylinder rotation 2 cylinder rotation 3 cylinder rotation 4 cylinder scale 0 cylinder scale 2 cylinder scale 4 cylinder");
    assert_eq!(table.editor.session().selected_keys, by_line.editor.session().selected_keys);
    assert_eq!(table.editor.session().selected_keys.len(), 10);
    assert_eq!(table.chosen(), [""; 0]);
    // It cannot be posed: a drag on it is one on nothing.
    let before = table.editor.session().work_eye;
    table.drag(Left, at_px, Vec2::new(60.0, 20.0));
    assert_ne!(table.editor.session().work_eye, before);
    assert_eq!(table.undo_label(), None);
    // After p it is what a click may miss.
    table.run("select sky");
    table.press("p");
    table.click(table.seen_px(glam::Vec3::ZERO));
    assert_eq!(table.chosen(), [""; 0]);
}
