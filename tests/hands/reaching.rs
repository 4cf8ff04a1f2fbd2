//! The balls at limbs' ends, and feet that stay.

use glam::{Quat, Vec2, Vec3};

use crate::table::{HEAD, Left, Right, SHOULDER, Table};

const ELBOW: &str = "robot1/right_shoulder/right_elbow";
const SOLES: [&str; 2] = ["robot1/right_hip/right_knee", "robot1/left_hip/left_knee"];

fn end(table: &Table, path: &str) -> Vec3 {
    table.editor.limb_ball(table.node(path)).expect("it has an end").end_in_world
}

fn ball_px(table: &Table, path: &str) -> Vec2 {
    table.seen_px(end(table, path))
}

/// A table whose robot 1 has its arm bent, so that its hand can go both ways.
fn bent() -> Table {
    Table::after("set-rotation 0 -0.5 0 0.8660254 robot1/right_shoulder/right_elbow")
}

#[test]
fn a_ball_lights_up_with_its_name() {
    let mut table = bent();
    table.move_to(ball_px(&table, ELBOW));
    let (part, name) = table.lit();
    assert_eq!(part, None, "the part below it is not lit");
    assert!(name.contains(ELBOW), "{name}");
    assert_eq!(table.hands.lit_ball(&table.editor).map(|ball| ball.last), Some(table.node(ELBOW)));
}

#[test]
fn a_dragged_ball_follows_the_pointer_in_one_step_of_undo_and_keeps_the_choice() {
    for eye in ["work", "sky"] {
        let mut table = bent();
        table.run(&format!("set-translation 0 0.25 8 sky\neye {eye}\nselect {HEAD}\ndo gizmo"));
        let before = table.editor.document().live_pose.clone();
        let (from_px, by_px) = (ball_px(&table, ELBOW), Vec2::new(-30.0, -20.0));
        table.drag(Left, from_px, by_px);
        let off = ball_px(&table, ELBOW) - (from_px + by_px);
        assert!(off.length() < 0.5, "{eye}: {off}");
        assert_eq!(table.chosen(), [HEAD]);
        let changed: Vec<_> = table.changed().into_iter().filter(|path| *path != "sky").collect();
        assert_eq!(changed, [SHOULDER, ELBOW]);
        // The line that does the same.
        let there = end(&table, ELBOW);
        let mut by_line = bent();
        by_line.run(&format!("reach {} {} {} {ELBOW}", there.x, there.y, there.z));
        assert!(end(&by_line, ELBOW).distance(there) < 1e-4);
        table.press("ctrl+z");
        assert_eq!(table.editor.document().live_pose, before);
    }
}

#[test]
fn with_space_or_both_buttons_a_ball_goes_along_the_view() {
    for is_space in [true, false] {
        let mut table = bent();
        let (from_px, before) = (ball_px(&table, ELBOW), end(&table, ELBOW));
        table.move_to(from_px);
        table.down(Left);
        if is_space {
            table.hold_space(true);
        } else {
            table.down(Right);
        }
        table.move_to(from_px + Vec2::Y * 20.0);
        let moved = end(&table, ELBOW) - before;
        let back = table.camera().world_from_eye.rotation * Vec3::Z;
        assert!(moved.dot(back) > 0.02 && moved.reject_from(back).length() < 0.01, "{moved}");
        table.up(Left);
    }
}

#[test]
fn the_wheel_turns_the_elbow_around_a_held_ball() {
    let mut table = bent();
    let (hand, eye) = (end(&table, ELBOW), table.editor.session().work_eye);
    table.move_to(ball_px(&table, ELBOW));
    table.down(Left);
    table.wheel(3.0);
    table.up(Left);
    assert!(end(&table, ELBOW).distance(hand) < 1e-4);
    assert_eq!(table.editor.session().work_eye, eye, "the wheel belongs to the ball");
    let mut by_line = bent();
    by_line.run(&format!("pole 15 {ELBOW}"));
    for path in [SHOULDER, ELBOW] {
        assert!(table.live(path).rotation.dot(by_line.live(path).rotation).abs() > 1.0 - 1e-6, "{path}");
    }
}

#[test]
fn escape_takes_a_reach_back_and_a_click_on_a_ball_chooses_what_is_below() {
    let mut table = bent();
    let before = table.editor.document().live_pose.clone();
    table.begin_drag(Left, ball_px(&table, ELBOW), Vec2::new(-30.0, -20.0));
    table.press("esc");
    table.move_to(table.on_ground());
    table.up(Left);
    assert_eq!(table.editor.document().live_pose, before);
    table.click(ball_px(&table, ELBOW));
    assert_eq!(table.chosen(), [ELBOW]);
}

#[test]
fn feet_stay_while_the_pointer_moves_the_body() {
    let mut table = Table::after("set-rotation 0.3826834 0 0 0.9238795 robot1/right_hip/right_knee");
    table.run("set-rotation 0.3826834 0 0 0.9238795 robot1/left_hip/left_knee\nkeep-feet on");
    let before = SOLES.map(|path| end(&table, path));
    table.drag(Right, table.on("robot1"), Vec2::new(0.0, 12.0));
    assert!(table.live("robot1").translation.y < 0.99);
    for (path, was) in SOLES.into_iter().zip(before) {
        assert!(end(&table, path).distance(was) < 1e-3, "{path}");
    }
    assert_eq!(table.undo_label(), Some("move a node"));
}

#[test]
fn limits_bind_reaching_alone() {
    // Backwards, and about an axis that no elbow has: drags, lines and fields take it.
    let turned = Quat::from_rotation_y(1.0) * Quat::from_rotation_x(0.5);
    let mut table = Table::new();
    let line = format!("set-rotation {} {} {} {} {ELBOW}", turned.x, turned.y, turned.z, turned.w);
    table.run(&line);
    assert!(table.live(ELBOW).rotation.dot(turned) > 1.0 - 1e-6);
    table.run(&format!("select {ELBOW}\nrotate y 60"));
    assert!(table.live(ELBOW).rotation.dot(turned * Quat::from_rotation_y(60f32.to_radians())) > 1.0 - 1e-6);
    let before = table.live(ELBOW).rotation;
    table.run("do gizmo");
    table.drag(Left, table.on(ELBOW), Vec2::new(70.0, 50.0));
    assert!(before.dot(table.live(ELBOW).rotation).abs() < 1.0 - 1e-3, "the arcball is free");
}

#[test]
fn playing_refuses_to_reach_and_goes_on() {
    let mut table = bent();
    table.play();
    let before = table.editor.document().live_pose.clone();
    table.drag(Left, ball_px(&table, ELBOW), Vec2::new(-30.0, -20.0));
    assert_eq!(table.editor.document().live_pose, before);
    assert!(table.editor.is_playing());
}
