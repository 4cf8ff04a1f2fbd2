//! What presses, drags and clicks mean, with each eye.

use std::time::Duration;

use super::*;

const FROM: Vec2 = Vec2::new(10.0, 20.0);
const TO: Vec2 = Vec2::new(20.0, 20.0);
const PLAIN: Held = Held { ctrl: false, shift: false, alt: false, space: false };
const SHIFT: Held = Held { shift: true, ..PLAIN };
const CTRL: Held = Held { ctrl: true, ..PLAIN };
const ALT: Held = Held { alt: true, ..PLAIN };
const ALT_SHIFT: Held = Held { alt: true, ..SHIFT };

fn part() -> RbtIndex {
    RbtIndex::new(3)
}

fn with_work_eye(target: Target, held: Held) -> Press {
    Press { target, held, picks: false, by_work_eye: true }
}

/// The actions of a drag with buttons that go down one after the other.
#[track_caller]
fn check(buttons: &[Button], press: Press, expected: Drag) {
    let mut pointer = Pointer::default();
    for &button in buttons {
        assert_eq!(pointer.press(button, FROM, press), None);
    }
    let moved = Action::Move { drag: expected, from_px: FROM, to_px: TO };
    let chosen = match press.target {
        Target::Part(rbt) if press.by_work_eye => Some(rbt),
        _ => None,
    };
    let poses = matches!(expected, Drag::Pose(_));
    let begin = poses.then_some(Action::Begin { chosen, from_px: FROM });
    let actions: Vec<_> = begin.into_iter().chain([moved]).collect();
    assert_eq!(pointer.move_to(TO, press.held.space), actions, "{buttons:?} {press:?}");
    let now = Instant::now();
    let mut ends: Vec<_> = buttons.iter().map(|&button| pointer.release(button, now)).collect();
    assert_eq!(ends.pop(), Some(poses.then_some(Action::Commit)));
    assert!(ends.iter().all(Option::is_none));
    assert_eq!(pointer.move_to(FROM, press.held.space), []);
}

#[test]
fn with_an_eye_of_the_scene_buttons_mean_kinds_of_drags_wherever_they_begin() {
    let space = Held { space: true, ..PLAIN };
    for target in [Target::Nothing, Target::Arcball, Target::Handle, Target::Part(part())] {
        for (buttons, held, kind) in [
            (&[Button::Left][..], PLAIN, DragKind::Rotate),
            (&[Button::Right], PLAIN, DragKind::Translate),
            (&[Button::Middle], PLAIN, DragKind::Dolly),
            (&[Button::Left, Button::Right], PLAIN, DragKind::Dolly),
            (&[Button::Right, Button::Left], PLAIN, DragKind::Dolly),
            (&[Button::Left], space, DragKind::Dolly),
            (&[Button::Right], space, DragKind::Translate),
        ] {
            let press = Press { target, held, picks: false, by_work_eye: false };
            check(buttons, press, Drag::Pose(kind));
        }
    }
}

#[test]
fn with_the_work_eye_it_matters_where_a_drag_begins() {
    let on_part = Target::Part(part());
    for target in [Target::Nothing, Target::Arcball, on_part] {
        check(&[Button::Middle], with_work_eye(target, PLAIN), Drag::Orbit);
        check(&[Button::Middle], with_work_eye(target, SHIFT), Drag::Pan);
        check(&[Button::Left], with_work_eye(target, ALT), Drag::Orbit);
        check(&[Button::Left], with_work_eye(target, ALT_SHIFT), Drag::Pan);
    }
    check(&[Button::Left], with_work_eye(Target::Nothing, PLAIN), Drag::Orbit);
    check(&[Button::Left], with_work_eye(Target::Nothing, SHIFT), Drag::Pan);
    check(&[Button::Right], with_work_eye(Target::Nothing, PLAIN), Drag::Pan);
    for target in [Target::Arcball, Target::Handle, on_part] {
        check(&[Button::Left], with_work_eye(target, PLAIN), Drag::Pose(DragKind::Rotate));
        check(&[Button::Right], with_work_eye(target, PLAIN), Drag::Pose(DragKind::Translate));
        check(&[Button::Right, Button::Left], with_work_eye(target, PLAIN), Drag::Pose(DragKind::Dolly));
        let space = Held { space: true, ..PLAIN };
        check(&[Button::Left], with_work_eye(target, space), Drag::Pose(DragKind::Dolly));
    }
}

/// What clicks at once one after the other do, with each eye.
#[track_caller]
fn clicks(target: Target, held: Held, expected: &[Option<Click>]) {
    for by_work_eye in [false, true] {
        let mut pointer = Pointer::default();
        let now = Instant::now();
        for &click in expected {
            let press = Press { target, held, picks: false, by_work_eye };
            assert_eq!(pointer.press(Button::Left, FROM, press), None);
            assert_eq!(pointer.move_to(FROM + Vec2::X, false), [], "a hand is never quite still");
            let expected = click.map(|click| Action::Click(click, FROM));
            assert_eq!(pointer.release(Button::Left, now), expected, "{target:?} {held:?}");
        }
    }
}

#[test]
fn clicks_choose_and_keep_the_choice_where_they_miss() {
    let on_part = Target::Part(part());
    clicks(on_part, PLAIN, &[Some(Click::Choose(part()))]);
    clicks(on_part, SHIFT, &[Some(Click::Also(part()))]);
    clicks(on_part, CTRL, &[Some(Click::GoOn), Some(Click::GoOn)]);
    clicks(on_part, ALT, &[None]);
    let keyed = crate::scene::built_in_scene("cylinder").unwrap().find("cylinder").unwrap();
    clicks(Target::Keyed(keyed), PLAIN, &[Some(Click::SelectKeys(keyed))]);
    clicks(Target::Nothing, PLAIN, &[None, Some(Click::ChooseNone)]);
    clicks(Target::Arcball, PLAIN, &[None, Some(Click::ChooseNone)]);
}

#[test]
fn two_clicks_far_apart_are_no_double_click() {
    let mut pointer = Pointer::default();
    let now = Instant::now();
    for later in [0, 900, 1800] {
        pointer.press(Button::Left, FROM, Press::default());
        assert_eq!(pointer.release(Button::Left, now + Duration::from_millis(later)), None);
    }
    pointer.press(Button::Left, FROM + Vec2::splat(40.0), Press::default());
    assert_eq!(pointer.release(Button::Left, now + Duration::from_millis(1900)), None);
}

#[test]
fn a_picking_click_does_not_drag() {
    let mut pointer = Pointer::default();
    let press = Press { picks: true, ..Press::default() };
    assert_eq!(pointer.press(Button::Left, Vec2::ONE, press), Some(Action::Pick(Vec2::ONE)));
    assert_eq!(pointer.move_to(TO, false), []);
    assert_eq!(pointer.release(Button::Left, Instant::now()), None);
}

#[test]
fn losing_the_focus_ends_a_drag() {
    let mut pointer = Pointer::default();
    pointer.press(Button::Right, Vec2::ZERO, Press::default());
    pointer.move_to(TO, false);
    assert_eq!(pointer.let_go(), Some(Action::Commit));
    assert_eq!(pointer.let_go(), None);
    pointer.press(Button::Middle, Vec2::ZERO, with_work_eye(Target::Nothing, PLAIN));
    pointer.move_to(TO, false);
    assert_eq!(pointer.let_go(), None);
}
