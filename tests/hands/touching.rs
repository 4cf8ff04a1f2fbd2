//! Fingers on a touch screen: one does what the left button does, two move the work eye.

use std::time::{Duration, Instant};

use glam::Vec2;
use inbetween::editor::{Eye, ViewCommand};
use winit::event::TouchPhase;

use crate::table::{HEAD, KNEE, Left, SHOULDER, Table};

const BY: Vec2 = Vec2::new(60.0, -40.0);

/// Fingers over a table, and a clock.
struct Touch {
    table: Table,
    start: Instant,
    ms: u64,
}

impl Touch {
    fn on(table: Table) -> Self {
        Self { table, start: Instant::now(), ms: 0 }
    }

    fn new() -> Self {
        Self::on(Table::new())
    }

    fn touch(&mut self, phase: TouchPhase, id: u64, at_px: Vec2) {
        self.ms += 16;
        self.table.touch(phase, id, at_px, self.start + Duration::from_millis(self.ms));
    }

    fn down(&mut self, id: u64, at_px: Vec2) {
        self.touch(TouchPhase::Started, id, at_px);
    }

    fn up(&mut self, id: u64, at_px: Vec2) {
        self.touch(TouchPhase::Ended, id, at_px);
    }

    /// A finger that is down goes in small steps to another pixel, within this time.
    fn slide(&mut self, id: u64, from_px: Vec2, by_px: Vec2, ms: u64) {
        for step in 1..=10_u8 {
            self.ms = (self.ms + ms / 10).saturating_sub(16);
            self.touch(TouchPhase::Moved, id, from_px + by_px * f32::from(step) / 10.0);
        }
    }

    fn drag(&mut self, from_px: Vec2, by_px: Vec2) {
        self.down(1, from_px);
        self.slide(1, from_px, by_px, 500);
        self.up(1, from_px + by_px);
    }

    /// Two fingers, which go to other pixels by turns.
    fn pinch(&mut self, from_px: [Vec2; 2], to_px: [Vec2; 2]) {
        self.down(1, from_px[0]);
        self.down(2, from_px[1]);
        for step in 1..=20_u8 {
            let part = f32::from(step) / 20.0;
            self.touch(TouchPhase::Moved, 1, from_px[0].lerp(to_px[0], part));
            self.touch(TouchPhase::Moved, 2, from_px[1].lerp(to_px[1], part));
        }
        self.up(1, to_px[0]);
        self.up(2, to_px[1]);
    }

    fn eye(&self) -> inbetween::editor::WorkEye {
        self.table.editor.session().work_eye
    }
}

#[test]
fn a_finger_poses_and_orbits_as_the_left_button_does() {
    for from in [|table: &Table| table.on(SHOULDER), Table::on_nothing, Table::on_ground] {
        let mut by_mouse = Table::new();
        by_mouse.drag(Left, from(&by_mouse), BY);
        let mut by_finger = Touch::new();
        let from_px = from(&by_finger.table);
        by_finger.drag(from_px, BY);
        let (found, wanted) = (&by_finger.table, &by_mouse);
        assert_eq!((found.chosen(), found.changed()), (wanted.chosen(), wanted.changed()));
        assert_eq!(found.undo_label(), wanted.undo_label());
        assert!(found.live(SHOULDER).rotation.angle_between(wanted.live(SHOULDER).rotation) < 1e-4);
        let (found, wanted) = (by_finger.eye(), wanted.editor.session().work_eye);
        assert!((found.yaw_degrees - wanted.yaw_degrees).abs() < 1e-3, "{found:?} {wanted:?}");
    }
}

#[test]
fn a_finger_drags_a_ball() {
    let mut touch = Touch::new();
    // The ball of a foot, which shows once its robot is chosen.
    touch.table.run("select robot1/left_hip");
    let knee = touch.table.node(KNEE);
    let end = touch.table.editor.limb_ball(knee).expect("it has a ball").end_in_world;
    let ball_px = touch.table.seen_px(end);
    touch.drag(ball_px, BY);
    assert_eq!(touch.table.changed(), ["robot1/left_hip", KNEE]);
}

#[test]
fn a_tap_chooses_though_the_finger_is_not_quite_still() {
    let mut touch = Touch::new();
    let at_px = touch.table.on(HEAD);
    touch.down(1, at_px);
    touch.touch(TouchPhase::Moved, 1, at_px + Vec2::new(5.0, 3.0));
    touch.up(1, at_px + Vec2::new(5.0, 3.0));
    assert_eq!((touch.table.chosen(), touch.table.changed()), (vec![HEAD], vec![]));
    assert_eq!(touch.table.lit(), (None, String::new()), "nothing lights up where no finger is");
}

#[test]
fn two_fingers_pan_with_their_middle_and_zoom_as_they_move_apart() {
    let [left, right] = [Vec2::new(500.0, 400.0), Vec2::new(700.0, 400.0)];
    let mut touch = Touch::new();
    let before = touch.eye();
    touch.pinch([left, right], [left - Vec2::X * 100.0, right + Vec2::X * 100.0]);
    let after = touch.eye();
    assert!((before.distance / after.distance - 2.0).abs() < 1e-3, "{after:?}");
    assert_eq!((after.yaw_degrees, after.pitch_degrees), (before.yaw_degrees, before.pitch_degrees));

    let mut touch = Touch::new();
    let target_px = touch.table.seen_px(touch.eye().target_in_world);
    touch.pinch([left, right], [left + BY, right + BY]);
    let moved_px = touch.table.seen_px(before.target_in_world) - target_px;
    assert!(moved_px.distance(BY) < 1.0, "{moved_px}");
    assert!((touch.eye().distance / before.distance - 1.0).abs() < 1e-3);
    assert_eq!((touch.table.chosen(), touch.table.changed()), (vec![], vec![]));
}

#[test]
fn two_fingers_on_parts_pose_nothing() {
    let mut touch = Touch::new();
    let [shoulder, head] = [touch.table.on(SHOULDER), touch.table.on(HEAD)];
    touch.pinch([shoulder, head], [shoulder + BY, head - BY]);
    assert_ne!(touch.eye(), Touch::new().eye());
    assert_eq!((touch.table.chosen(), touch.table.changed(), touch.table.undo_label()), (vec![], vec![], None));
}

#[test]
fn a_pose_that_was_just_begun_is_taken_back_by_the_second_finger_and_a_longer_one_counts() {
    for (ms, is_kept) in [(200, false), (600, true)] {
        let mut touch = Touch::new();
        let from_px = touch.table.on(SHOULDER);
        touch.down(1, from_px);
        touch.slide(1, from_px, BY, ms);
        assert_eq!(touch.table.changed(), [SHOULDER]);
        touch.down(2, touch.table.on(HEAD));
        let expected = if is_kept { (vec![SHOULDER], Some("turn a node")) } else { (vec![], None) };
        assert_eq!((touch.table.changed(), touch.table.undo_label()), expected);
        let (placed, eye) = (touch.table.live(SHOULDER), touch.eye());
        touch.slide(1, from_px + BY, BY, 100);
        assert_eq!(touch.table.live(SHOULDER), placed);
        assert_ne!(touch.eye(), eye, "both move the eye now");
        assert!(!touch.table.editor.is_dragging());
    }
}

#[test]
fn the_finger_that_is_left_of_two_does_nothing_until_it_is_up() {
    let mut touch = Touch::new();
    let [shoulder, head] = [touch.table.on(SHOULDER), touch.table.on(HEAD)];
    touch.down(1, head);
    touch.down(2, shoulder);
    touch.up(1, head);
    let eye = touch.eye();
    touch.slide(2, shoulder, BY, 500);
    assert_eq!((touch.eye(), touch.table.changed()), (eye, vec![]));
    // A new one goes on with it.
    touch.down(3, head);
    touch.slide(3, head, BY, 100);
    assert_ne!(touch.eye(), eye);
    touch.up(3, head);
    touch.up(2, shoulder);
    assert_eq!(touch.table.chosen(), Vec::<&str>::new());
    let from_px = touch.table.on(SHOULDER);
    touch.drag(from_px, BY);
    assert_eq!(touch.table.changed(), [SHOULDER]);
}

#[test]
fn a_touch_that_the_system_cancels_leaves_nothing() {
    let mut touch = Touch::new();
    let from_px = touch.table.on(SHOULDER);
    touch.down(1, from_px);
    touch.slide(1, from_px, BY, 900);
    touch.touch(TouchPhase::Cancelled, 1, from_px + BY);
    assert_eq!((touch.table.changed(), touch.table.undo_label()), (vec![], None));
}

#[test]
fn an_eye_of_the_scene_stays_where_two_fingers_move() {
    let mut touch = Touch::on(Table::as_a_script_begins());
    let before = touch.table.editor.document().live_pose.clone();
    touch.pinch([Vec2::new(500.0, 400.0), Vec2::new(700.0, 400.0)], [Vec2::new(300.0, 300.0), Vec2::new(900.0, 500.0)]);
    assert_eq!(touch.table.editor.document().live_pose, before);
    touch.table.editor.apply(inbetween::editor::Command::View(ViewCommand::SetEye(Eye::Work))).unwrap();
    assert_eq!(touch.eye(), Touch::new().eye());
}

#[test]
fn a_finger_ends_what_a_key_began_where_it_is() {
    let mut touch = Touch::on(Table::after("select robot2/head"));
    touch.table.move_to(touch.table.on_ground());
    touch.table.press("ctrl+g");
    touch.table.move_to(touch.table.on_ground() + BY);
    let placed = touch.table.live(HEAD);
    assert_ne!(placed, Table::new().live(HEAD));
    let at_px = touch.table.on_nothing();
    touch.drag(at_px, BY);
    assert_eq!((touch.table.live(HEAD), touch.table.undo_label()), (placed, Some("move a node")));
}
