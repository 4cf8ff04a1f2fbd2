//! The eyes of the scene: their drags and wheel are the course's wherever they begin; clicks choose as with the work eye.

use glam::{Quat, Vec2, Vec3};

use crate::table::{Left, Middle, Right, SHOULDER, Table};

const BY: Vec2 = Vec2::new(50.0, -30.0);

/// What a drag from nothing does with the sky as eye and a shoulder chosen: the rotation and the way of the shoulder in the eye's axes.
fn dragged(does: impl FnOnce(&mut Table)) -> (Quat, Vec3) {
    let mut table = Table::after("eye sky\nset-translation 0 0.25 8 sky\nselect robot1/right_shoulder");
    let before = table.in_world(SHOULDER);
    does(&mut table);
    assert_eq!(table.chosen(), [SHOULDER]);
    let after = table.in_world(SHOULDER);
    let eye = table.in_world("sky").rotation;
    (after.rotation * before.rotation.conjugate(), eye.conjugate() * (after.translation - before.translation))
}

#[test]
fn a_left_drag_turns_by_the_arcball_wherever_it_begins() {
    let (turned, moved) = dragged(|table| table.drag(Left, table.on_nothing(), BY));
    assert!(turned.to_axis_angle().1 > 1e-3 && moved.length() < 1e-6, "{turned} {moved}");
}

#[test]
fn a_right_drag_moves_in_the_views_plane() {
    let (turned, moved) = dragged(|table| table.drag(Right, table.on_nothing(), BY));
    assert!(turned.to_axis_angle().1 < 1e-5, "{turned}");
    assert!(moved.x > 0.01 && moved.y > 0.01 && moved.z.abs() < 1e-5, "{moved}");
}

#[test]
fn middle_both_buttons_space_and_the_wheel_move_along_the_view() {
    let ways: [fn(&mut Table); 4] = [
        |table| table.drag(Middle, table.on_nothing(), BY),
        |table| {
            table.move_to(table.on_nothing());
            table.down(Right);
            table.drag(Left, table.on_nothing(), BY);
            table.up(Right);
        },
        |table| {
            table.hold_space(true);
            table.drag(Left, table.on_nothing(), BY);
            table.hold_space(false);
        },
        |table| {
            table.move_to(table.on_nothing());
            table.wheel(1.0);
        },
    ];
    for way in ways {
        let (turned, moved) = dragged(way);
        assert!(turned.to_axis_angle().1 < 1e-5 && moved.truncate().length() < 1e-5, "{turned} {moved}");
        assert!(moved.z < -0.01, "forward: {moved}");
    }
}

#[test]
fn a_space_press_that_went_with_a_drag_displays_no_keyframe() {
    let mut table = Table::after("eye sky\nselect robot1/right_shoulder");
    table.hold_space(true);
    table.drag(Left, table.on_nothing(), BY);
    assert!(!table.hands.space.release());
    table.hold_space(true);
    assert!(table.hands.space.release(), "alone it acts when it is let go");
}

#[test]
fn with_nothing_chosen_a_drag_moves_the_recorded_camera() {
    let mut table = Table::after("eye sky");
    table.drag(Left, table.on_nothing(), BY);
    assert_eq!((table.changed(), table.chosen()), (vec!["sky"], vec![]));
    table.press("ctrl+z");
    assert_eq!(table.changed(), [""; 0]);
}
