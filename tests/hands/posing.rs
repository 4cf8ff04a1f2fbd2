//! Drags from parts and from nothing, with the work eye.

use glam::Vec2;

use crate::table::{HEAD, Left, Middle, Right, SHOULDER, Table};

const BY: Vec2 = Vec2::new(60.0, -40.0);

#[test]
fn a_drag_on_a_part_chooses_and_turns_it_in_one_step() {
    let mut table = Table::after("select robot2");
    table.drag(Left, table.on(SHOULDER), BY);
    assert_eq!((table.chosen(), table.changed()), (vec![SHOULDER], vec![SHOULDER]));
    let placed = table.live(SHOULDER);
    assert!(placed.rotation.to_axis_angle().1 > 0.1);
    assert_eq!(placed.translation, Table::new().live(SHOULDER).translation);
    assert_eq!(table.undo_label(), Some("turn a node"));
    table.press("ctrl+z");
    assert_eq!((table.changed(), table.chosen()), (vec![], vec![SHOULDER]));
}

#[test]
fn a_drag_on_one_of_several_chosen_parts_moves_all() {
    let mut table = Table::after("select robot1/right_shoulder\nselect-also robot2/head\ndo gizmo");
    table.drag(Left, table.on(SHOULDER), BY);
    assert_eq!(table.chosen(), [SHOULDER, HEAD]);
    assert_eq!(table.changed(), [SHOULDER, HEAD]);
}

#[test]
fn a_right_drag_from_a_part_moves_it_in_the_views_plane() {
    let mut table = Table::new();
    let (depth, seen_px) = (table.depth(SHOULDER), table.seen_px(table.in_world(SHOULDER).translation));
    table.drag(Right, table.on(SHOULDER), BY);
    assert_eq!((table.chosen(), table.changed()), (vec![SHOULDER], vec![SHOULDER]));
    assert!((table.depth(SHOULDER) - depth).abs() < 1e-4);
    let moved_px = table.seen_px(table.in_world(SHOULDER).translation) - seen_px;
    assert!(moved_px.distance(BY) < 0.5, "{moved_px}");
    assert_eq!(table.live(SHOULDER).rotation, Table::new().live(SHOULDER).rotation);
    assert_eq!(table.undo_label(), Some("move a node"));
}

#[test]
fn with_space_or_both_buttons_it_goes_along_the_view() {
    let ways: [fn(&mut Table); 3] = [
        |table| {
            table.hold_space(true);
            table.drag(Left, table.on(SHOULDER), BY);
            table.hold_space(false);
        },
        |table| {
            table.move_to(table.on(SHOULDER));
            table.down(Right);
            table.begin_drag(Left, table.on(SHOULDER), BY);
            table.up(Left);
            table.up(Right);
        },
        |table| {
            table.move_to(table.on(SHOULDER));
            table.down(Left);
            table.begin_drag(Right, table.on(SHOULDER), BY);
            table.up(Left);
            table.up(Right);
        },
    ];
    for along_the_view in ways {
        let mut table = Table::new();
        let before = table.in_world(SHOULDER);
        along_the_view(&mut table);
        let moved = table.in_world(SHOULDER).translation - before.translation;
        let forward = table.camera().world_from_eye.rotation * -glam::Vec3::Z;
        assert!(moved.dot(forward) > 0.05 && moved.reject_from(forward).length() < 1e-4, "{moved}");
        assert_eq!(table.in_world(SHOULDER).rotation, before.rotation);
        assert_eq!(table.chosen(), [SHOULDER]);
    }
}

#[test]
fn the_inside_of_the_arcball_poses_what_is_chosen() {
    // Above the head, within its arcball.
    let inside = |table: &Table| table.edge(table.on(HEAD), -Vec2::Y) - Vec2::Y * 40.0;
    for (button, turns) in [(Left, true), (Right, false)] {
        let mut table = Table::after("select robot2/head\ndo gizmo");
        let before = table.live(HEAD);
        table.drag(button, inside(&table), BY);
        let after = table.live(HEAD);
        assert_eq!(table.changed(), [HEAD]);
        assert_eq!((after.rotation != before.rotation, after.translation != before.translation), (turns, !turns));
    }
}

#[test]
fn a_drag_on_nothing_or_the_ground_moves_the_eye_and_no_node() {
    for from in [Table::on_nothing, Table::on_ground] {
        for button in [Left, Middle, Right] {
            let mut table = Table::after("select robot2/head");
            let before = table.editor.session().work_eye;
            table.drag(button, from(&table), BY);
            assert_ne!(table.editor.session().work_eye, before);
            assert_eq!((table.changed(), table.chosen()), (vec![], vec![HEAD]));
            assert_eq!(table.undo_label(), None, "the eye is not undone");
        }
    }
}

#[test]
fn playing_refuses_to_move_nodes_and_goes_on() {
    for button in [Left, Right] {
        let mut table = Table::new();
        table.play();
        let before = table.editor.document().clone();
        table.drag(button, table.on(SHOULDER), BY);
        assert_eq!(table.said(), "Cannot move a node while playing. Press y to stop or Shift+P to pause first.");
        assert_eq!(table.editor.document().live_pose, before.live_pose);
        assert!(table.editor.is_playing() && !table.editor.is_dragging());
    }
}

#[test]
fn playing_never_refuses_to_move_the_work_eye() {
    let mut table = Table::new();
    table.play();
    let before = table.editor.session().work_eye;
    table.drag(Left, table.on_nothing(), BY);
    table.wheel(2.0);
    assert_ne!(table.editor.session().work_eye, before);
    assert!(table.editor.is_playing());
}

#[test]
fn losing_the_focus_ends_a_drag_which_counts() {
    let mut table = Table::new();
    table.begin_drag(Left, table.on(SHOULDER), BY);
    table.lose_focus();
    assert_eq!((table.changed(), table.undo_label()), (vec![SHOULDER], Some("turn a node")));
    let placed = table.live(SHOULDER);
    table.move_to(table.on_ground());
    table.up(Left);
    assert_eq!(table.live(SHOULDER), placed);
}
