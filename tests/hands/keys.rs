//! Keys during a drag, turns and moves begun by keyboard, and what Escape ends.

use glam::{Quat, Vec2, Vec3};
use inbetween::editor::Eye;
use inbetween::script::script_commands;

use crate::table::{Left, Right, SHOULDER, Table};

fn with_shoulder() -> Table {
    let mut table = Table::after("select robot1/right_shoulder");
    table.move_to(table.on_ground());
    table
}

/// Keys lead to the same place as a line.
#[track_caller]
fn check(keys: &str, line: &str) {
    let mut table = with_shoulder();
    table.press(keys);
    let by_line = Table::after(&format!("select {SHOULDER}\n{line}"));
    let (at, there) = (table.live(SHOULDER), by_line.live(SHOULDER));
    assert!(at.translation.distance(there.translation) < 1e-6, "{keys}: {at:?}, not {there:?}");
    assert!(at.rotation.dot(there.rotation).abs() > 1.0 - 1e-6, "{keys}: {at:?}, not {there:?}");
    assert_eq!(table.undo_label(), by_line.undo_label(), "{keys}");
    assert!(!table.editor.is_dragging(), "{keys}");
}

#[test]
fn turns_and_moves_are_typed() {
    check("ctrl+r x 4 5 enter", "turn x 45 local");
    check("ctrl+r x x 4 5 enter", "turn x 45 world");
    check("ctrl+r z - 9 0 enter", "turn z -90 local");
    check("ctrl+r y 1 2 . 5 enter", "turn y 12.5 local");
    check("ctrl+r y 4 7 backspace 5 enter", "turn y 45 local");
    check("ctrl+r 3 0 enter", "turn z 30 view");
    check("ctrl+g z 1 . 5 enter", "shift 0 0 1.5 local");
    check("ctrl+g x - . 2 5 enter", "shift -0.25 0 0 local");
}

#[test]
fn the_pointer_leads_what_a_key_began() {
    let mut table = with_shoulder();
    table.press("ctrl+g");
    table.move_to(table.on_ground() - Vec2::new(80.0, 50.0));
    assert_eq!(table.changed(), [SHOULDER]);
    table.press("x");
    let moved = table.live(SHOULDER).translation - Vec3::new(0.5, 0.75, 0.0);
    assert!(moved.x.abs() > 0.01 && (moved.y, moved.z) == (0.0, 0.0), "{moved}");
    table.down(Left);
    table.up(Left);
    assert_eq!((table.undo_label(), table.chosen()), (Some("move a node"), vec![SHOULDER]));
}

#[test]
fn a_right_click_takes_back_what_a_key_began() {
    let mut table = with_shoulder();
    table.press("ctrl+r");
    table.move_to(table.on_ground() - Vec2::new(80.0, 50.0));
    assert_eq!(table.changed(), [SHOULDER]);
    table.down(Right);
    table.up(Right);
    assert_eq!((table.changed(), table.undo_label()), (vec![], None));
}

#[test]
fn axes_and_numbers_belong_to_a_drag_of_the_pointer() {
    let mut table = Table::new();
    table.begin_drag(Left, table.on(SHOULDER), Vec2::new(60.0, -40.0));
    table.press("x 4 5 enter");
    let forty_five = Quat::from_rotation_x(45f32.to_radians());
    assert!(table.live(SHOULDER).rotation.dot(forty_five) > 1.0 - 1e-6);
    table.up(Left);
    assert_eq!((table.changed(), table.undo_label()), (vec![SHOULDER], Some("turn a node")));
}

#[test]
fn no_other_letter_does_anything_in_a_drag() {
    for begin in [
        |table: &mut Table| table.begin_drag(Left, table.on(SHOULDER), Vec2::new(60.0, -40.0)),
        |table: &mut Table| {
            table.run("select robot1/right_shoulder");
            table.press("ctrl+r");
        },
    ] {
        let mut table = Table::new();
        begin(&mut table);
        let before = (table.editor.document().clone(), table.editor.session().clone());
        table.press("n u d c i w t v p m a r s h f c > < + = space home ctrl+n ctrl+d delete shift+a shift+p f11");
        assert_eq!((table.editor.document(), table.editor.session()), (&before.0, &before.1));
        assert!(table.editor.is_dragging());
    }
}

#[test]
fn a_scripts_drag_leaves_keys_as_they_are() {
    let mut table = Table::after("select robot1/right_shoulder\ndrag begin\nrotate z 30");
    assert!(table.editor.is_dragging());
    table.press("n t");
    assert_eq!(table.editor.document().keyframes.len(), 1);
    assert_ne!(table.editor.document().interpolation, Table::new().editor.document().interpolation);
    table.run("drag end");
    assert_eq!(table.changed(), [SHOULDER]);
}

#[test]
fn escape_ends_one_thing_at_a_time() {
    let mut table = with_shoulder();
    table.press("p");
    table.begin_drag(Right, table.on(SHOULDER), Vec2::new(60.0, -40.0));
    assert!(table.editor.is_dragging());
    let state = |table: &Table| {
        (table.editor.is_dragging(), table.editor.session().is_picking, !table.editor.session().chosen.is_empty())
    };
    let mut states = vec![state(&table)];
    for _ in 0..4 {
        table.press("esc");
        states.push(state(&table));
    }
    let expected = [(true, true, true), (false, true, true), (false, false, true), (false, false, false)];
    assert_eq!(states[..4], expected);
    assert_eq!(states[4], states[3], "it never quits");
    assert_eq!(table.changed(), [""; 0]);
}

#[test]
fn v_goes_on_from_the_work_eye_to_the_three_of_the_scene_and_back() {
    let mut table = Table::new();
    let mut eyes = Vec::new();
    for _ in 0..5 {
        eyes.push(table.editor.session().eye);
        table.press("v");
    }
    assert_eq!(eyes, [Eye::Work, Eye::Recorded(0), Eye::Recorded(1), Eye::Recorded(2), Eye::Work]);
}

#[test]
fn a_script_starts_with_the_sky_and_its_v_goes_through_the_three() {
    let mut table = Table::as_a_script_begins();
    let mut eyes = vec![table.editor.session().eye];
    for line in ["key v", "key v", "key v", "eye work", "key v"] {
        table.run(line);
        eyes.push(table.editor.session().eye);
    }
    let recorded = [0, 1, 2, 0].map(Eye::Recorded);
    assert_eq!(eyes[..4], recorded);
    assert_eq!(eyes[4..], [Eye::Work, Eye::Recorded(0)]);
}

#[test]
fn what_moves_nodes_is_refused_while_playing_and_the_playback_goes_on() {
    let lines = [
        "key u",
        "key n",
        "key d",
        "key <",
        "key >",
        "key i",
        "key r",
        "key space",
        "key c",
        "undo",
        "redo",
        "rotate z 30",
        "turn z 30 world",
        "translate 0 1 0",
        "shift 0 1 0 view",
        "key ctrl+r",
        "key ctrl+g",
        "drag-grab turn z local",
        "reach 0 1 1 robot1/right_shoulder/right_elbow",
        "pole 20 robot1/right_shoulder/right_elbow",
        "mirror",
        "paste-pose",
        "paste-pose mirrored",
        "reset-node",
        "pose-of \"{\\\"format\\\": \\\"inbetween.pose\\\", \\\"version\\\": 1, \\\"name\\\": \\\"a\\\", \\\"nodes\\\": []}\"",
        "set-rotation 0 0 1 0 robot2",
        "retime 100",
    ];
    for line in lines {
        let mut table = Table::after("select robot1/right_shoulder\nrotate x 10\ncopy-pose\nundo");
        table.play();
        let before = table.editor.document().clone();
        let commands = script_commands(line.as_bytes(), table.editor.scene()).unwrap_or_else(|all| panic!("{all:?}"));
        for command in commands {
            let refused = table.editor.apply(command).expect_err(line).message().to_string();
            assert!(refused.contains(" while playing"), "{line}: {refused}");
        }
        assert!(table.editor.is_playing() && !table.editor.is_dragging(), "{line}");
        assert_eq!(*table.editor.document(), before, "{line}");
    }
}
