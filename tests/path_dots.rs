//! The dots of the motion path in the 3D view: which of them a press takes, and where a drag puts the node in that keyframe.

mod common;

use common::{apply, editor_with, press, shown};
use glam::{Quat, Vec2, Vec3};
use inbetween::camera::Camera;
use inbetween::editor::{Command, Edit, Editor, PathDot, PlaybackCommand, ViewCommand};
use inbetween::keyframe::{KeyframeIndex, keyframes_to_json};
use inbetween::view::{frame_of_editor, mark_dot};
use inbetween::window::motion_path::{PathDrag, REACH};
use inbetween::words::Phrase;

const SIZE: Vec2 = Vec2::new(1020.0, 580.0);

/// Six keyframes with robot 1 at x from 0 to 5; this node chosen, and this keyframe current.
fn editor(path: &str, current: usize) -> Editor {
    let mut editor = editor_with(6);
    let rbt = editor.scene().find_rbt(path).unwrap();
    apply(&mut editor, Command::View(ViewCommand::Choose(Some(rbt))));
    apply(&mut editor, Command::Edit(Edit::GoTo(KeyframeIndex::new(current))));
    editor
}

fn dot(editor: &Editor, place: usize) -> PathDot {
    editor.path_dot(KeyframeIndex::new(place)).expect("it has a dot")
}

fn seen(editor: &Editor, camera: &Camera, place: usize) -> Vec2 {
    camera.project(dot(editor, place).centre_in_world).expect("it is in front of the eye").0
}

fn bytes(editor: &Editor) -> String {
    let document = editor.document();
    keyframes_to_json(editor.scene(), &document.keyframes, document.interpolation, document.ms_between_keyframes)
}

/// Drags a dot by so many pixels, as the window does; says where it is seen before and after.
#[track_caller]
fn drag(editor: &mut Editor, place: usize, by_px: Vec2) -> (Vec2, Vec2) {
    let camera = editor.camera(SIZE);
    let from_px = seen(editor, &camera, place);
    // A press is never quite in the middle.
    let pressed_px = from_px + Vec2::new(2.0, -1.0);
    let mut drag = PathDrag::at(editor, &camera, pressed_px, REACH).expect("the press takes the dot");
    assert_eq!(drag.dot().keyframe, KeyframeIndex::new(place));
    for part in [0.0_f32, 0.25, 0.5, 1.0] {
        for command in drag.move_to(editor, &camera, pressed_px + by_px * part) {
            apply(editor, command);
        }
    }
    if let Some(command) = drag.release(editor) {
        apply(editor, command);
    }
    (from_px, seen(editor, &camera, place))
}

#[test]
fn a_dragged_dot_moves_the_node_in_its_keyframe_in_one_step() {
    for node in ["robot1", "robot1/right_shoulder", "robot1/right_shoulder/right_elbow"] {
        let mut editor = editor(node, 3);
        // The robot is turned, so that the parent's axes are not the view's.
        let robot = editor.scene().find_rbt("robot1").unwrap();
        apply(&mut editor, Command::Edit(Edit::SetRotation(robot, Quat::from_rotation_y(0.9))));
        press(&mut editor, "u");
        for place in [1, 2] {
            let before = bytes(&editor);
            let camera = editor.camera(SIZE);
            let depth = |editor: &Editor| camera.project(dot(editor, place).centre_in_world).unwrap().1;
            let depth_before = depth(&editor);
            let (from_px, to_px) = drag(&mut editor, place, Vec2::new(40.0, -25.0));
            assert!((to_px - from_px).distance(Vec2::new(40.0, -25.0)) < 0.05, "{node}: {from_px} to {to_px}");
            assert!((depth(&editor) - depth_before).abs() < 1e-4, "it stays in the plane parallel to the view");
            assert_ne!(bytes(&editor), before);
            assert_eq!(editor.undo_label().map(Phrase::english), Some("change of a node in a keyframe"));
            let others = |editor: &Editor| {
                let keyframes = editor.document().keyframes.as_slice();
                let others = keyframes.iter().enumerate().filter(|(other, _)| *other != place);
                others.map(|(_, keyframe)| keyframe.pose.clone()).collect::<Vec<_>>()
            };
            let other_poses = others(&editor);
            press(&mut editor, "ctrl+z");
            assert_eq!(bytes(&editor), before, "one undo takes it back");
            assert_eq!(others(&editor), other_poses, "the others stayed");
        }
    }
}

#[test]
fn the_scene_follows_where_the_keyframe_is_on_screen() {
    let mut editor = editor("robot1", 2);
    press(&mut editor, "a");
    assert_eq!(shown(&editor), "0 1 [2] 3 4 5 | 2");
    drag(&mut editor, 2, Vec2::new(30.0, 0.0));
    let x = editor.document().live_pose.get(editor.session().chosen.primary().unwrap()).translation.x;
    assert!(x > 2.05, "{x}");
    assert_eq!(shown(&editor), format!("0 1 [{x}] 3 4 5 | {x}"));
    press(&mut editor, "ctrl+z");
    assert_eq!(shown(&editor), "0 1 [2] 3 4 5 | 2");
}

#[test]
fn the_arcball_keeps_the_current_dot_while_it_shows() {
    let mut editor = editor("robot1", 2);
    let camera = editor.camera(SIZE);
    let (current_px, other_px) = (seen(&editor, &camera, 2), seen(&editor, &camera, 1));
    assert_eq!(editor.path_dot_at(&camera, current_px, REACH), None);
    assert_eq!(editor.path_dot_at(&camera, other_px, REACH), Some(dot(&editor, 1)), "the others come first");
    press(&mut editor, "a");
    assert_eq!(editor.path_dot_at(&camera, current_px, REACH), Some(dot(&editor, 2)));
}

#[test]
fn there_is_nothing_to_take_where_no_dot_shows() {
    let mut editor = editor("robot1", 5);
    let camera = editor.camera(SIZE);
    let at_px = seen(&editor, &camera, 1);
    assert!(PathDrag::at(&editor, &camera, at_px, REACH).is_some());
    assert!(PathDrag::at(&editor, &camera, at_px + Vec2::new(0.0, 3.0 * REACH), REACH).is_none(), "too far away");
    press(&mut editor, "alt+p");
    assert!(PathDrag::at(&editor, &camera, at_px, REACH).is_none(), "the path is hidden");
    press(&mut editor, "alt+p y");
    assert!(PathDrag::at(&editor, &camera, at_px, REACH).is_none(), "it plays");
    press(&mut editor, "y");
    apply(&mut editor, Command::View(ViewCommand::Choose(None)));
    assert!(PathDrag::at(&editor, &camera, at_px, REACH).is_none(), "nothing is chosen");
}

#[test]
fn a_click_moves_nothing_and_escape_takes_a_drag_back() {
    let mut editor = editor("robot1", 5);
    let (before, undo) = (bytes(&editor), editor.undo_label());
    drag(&mut editor, 1, Vec2::ZERO);
    assert_eq!((bytes(&editor), editor.undo_label()), (before.clone(), undo));
    let camera = editor.camera(SIZE);
    let at_px = seen(&editor, &camera, 1);
    let mut held = PathDrag::at(&editor, &camera, at_px, REACH).unwrap();
    for command in held.move_to(&editor, &camera, at_px + Vec2::new(50.0, 0.0)) {
        apply(&mut editor, command);
    }
    assert_ne!(bytes(&editor), before);
    press(&mut editor, "escape");
    assert_eq!(held.move_to(&editor, &camera, at_px + Vec2::new(90.0, 0.0)), []);
    assert_eq!(held.release(&editor), None);
    assert_eq!((bytes(&editor), editor.undo_label()), (before, undo));
}

#[test]
fn a_scrubbed_pose_stays_on_screen_while_a_dot_moves() {
    let mut editor = editor("robot1", 5);
    apply(&mut editor, Command::Playback(PlaybackCommand::Scrub(2.5)));
    drag(&mut editor, 1, Vec2::new(0.0, -40.0));
    assert!(editor.is_scrubbed());
    assert_eq!(editor.playhead(), Some(2.5));
}

#[test]
fn what_a_press_would_take_is_marked() {
    let editor = editor("robot1", 5);
    let plain = frame_of_editor(&editor, SIZE);
    let mut marked = plain.clone();
    mark_dot(&mut marked, dot(&editor, 1));
    let added = &marked.dots[plain.dots.len()..];
    assert!(!added.is_empty());
    let centre = dot(&editor, 1).centre_in_world;
    assert!(added.iter().all(|mark| mark.centre_in_world == centre && mark.diameter_px > plain.dots[1].diameter_px));
    assert_eq!(plain.dots[1].centre_in_world, centre, "the mark stands where the path draws the dot");
    assert_ne!(centre, Vec3::ZERO);
}
