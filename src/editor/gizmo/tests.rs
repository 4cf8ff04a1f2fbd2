//! Handles without a window: pulls, keys, tracks of the pointer.

use std::path::PathBuf;
use std::sync::Arc;

use glam::{Quat, Vec2, Vec3};
use proptest::prelude::*;

use super::*;
use crate::camera::Camera;
use crate::editor::keymap::press_from_word;
use crate::editor::{Command, Edit, Editor, GestureCommand, ViewCommand};
use crate::pose::RbtIndex;
use crate::rbt::Rbt;

const SIZE_PX: Vec2 = Vec2::new(1000.0, 600.0);
const REACH_PX: f32 = 6.0;

fn editor() -> Editor {
    let scene = crate::scene::built_in_scene(crate::scene::DEFAULT_SCENE).unwrap();
    Editor::new(Arc::new(scene), PathBuf::from("animation.json"))
}

/// An editor with the node of a path chosen.
fn choosing(path: &str) -> (Editor, RbtIndex) {
    let mut editor = editor();
    let rbt = editor.scene().rbt_indices().find(|&rbt| editor.scene().rbt_path(rbt) == path).unwrap();
    editor.apply(Command::View(ViewCommand::Choose(Some(rbt)))).unwrap();
    (editor, rbt)
}

fn gesture(editor: &mut Editor, gesture: GestureCommand) {
    editor.apply(Command::Gesture(gesture)).unwrap();
}

fn placed(editor: &Editor, rbt: RbtIndex) -> Rbt {
    editor.document().live_pose.get(rbt)
}

fn world_from(editor: &Editor, rbt: RbtIndex) -> Rbt {
    editor.scene().world_from_rbt(&editor.document().live_pose, editor.seconds(), rbt)
}

fn press(editor: &mut Editor, keys: &[&str]) {
    for key in keys {
        let key = DragKey::of(press_from_word(key).unwrap()).unwrap();
        editor.apply(key.command()).unwrap();
    }
}

fn any_rotation() -> impl Strategy<Value = Quat> {
    prop::array::uniform4(-1.0f32..1.0)
        .prop_filter("a rotation needs a direction", |q| q.iter().map(|c| c * c).sum::<f32>() > 0.01)
        .prop_map(|q| Quat::from_array(q).normalize())
}

/// A chosen elbow below a turned shoulder, seen from somewhere around it.
fn posed(shoulder: Quat, elbow: Quat, eye: Quat) -> (Editor, RbtIndex, Camera) {
    let (mut editor, rbt) = choosing("robot1/right_shoulder/right_elbow");
    for (index, rotation) in [(3, shoulder), (4, elbow)] {
        let rbt = editor.scene().rbt_indices().nth(index).unwrap();
        editor.apply(Command::Edit(Edit::SetRotation(rbt, rotation))).unwrap();
    }
    let centre = world_from(&editor, rbt).translation;
    let sky = editor.scene().eyes()[0];
    editor.apply(Command::Edit(Edit::SetRotation(sky, eye))).unwrap();
    let eye = centre + eye * Vec3::new(0.4, -0.3, 5.0);
    editor.apply(Command::Edit(Edit::SetTranslation(sky, eye))).unwrap();
    let camera = editor.camera(SIZE_PX);
    (editor, rbt, camera)
}

/// The pull that leads from one place of the node to another, told from the places alone.
fn told(editor: &Editor, rbt: RbtIndex, was: Rbt, pull: Pull) -> Pull {
    let is = placed(editor, rbt);
    let pose = &editor.document().live_pose;
    let parent = Rbt::from_affine(&editor.scene().world_from_parent(pose, editor.seconds(), rbt)).rotation;
    let eye = editor.camera(SIZE_PX).world_from_eye.rotation;
    let axes_of = |axes| match axes {
        GizmoAxes::Local => was.rotation,
        GizmoAxes::Parent => Quat::IDENTITY,
        GizmoAxes::World => parent.inverse(),
        GizmoAxes::View => parent.inverse() * eye,
    };
    match pull {
        Pull::Turn { axis, axes, .. } => {
            let axes_in_parent = axes_of(axes);
            let turn = axes_in_parent.inverse() * (is.rotation * was.rotation.inverse()) * axes_in_parent;
            let across = axis.others().map(|other| turn.xyz()[other.index()].abs());
            assert!(across[0].max(across[1]) < 2e-6, "{turn} is not about {axis:?}");
            let degrees = 2.0 * f64::from(turn.xyz()[axis.index()]).atan2(f64::from(turn.w)).to_degrees();
            Pull::Turn { axis, degrees, axes }
        }
        Pull::Move { axes, .. } => {
            let by = axes_of(axes).inverse() * (is.translation - was.translation);
            Pull::Move { by: by.as_dvec3().to_array(), axes }
        }
    }
}

fn check_same(readout: Pull, real: Pull) {
    match (readout, real) {
        (Pull::Turn { degrees: a, .. }, Pull::Turn { degrees: b, .. }) => {
            let off = (a - b) - 360.0 * ((a - b) / 360.0).round();
            assert!(off.abs() < 1e-3, "{readout:?} is {real:?}");
        }
        (Pull::Move { by: a, .. }, Pull::Move { by: b, .. }) => {
            assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-4), "{readout:?} is {real:?}");
        }
        _ => panic!("{readout:?} is {real:?}"),
    }
}

proptest! {
    /// However long a drag is and wherever it goes: where the node ends is what the readout says, counted from the drag's beginning.
    #[test]
    fn a_long_drag_does_what_it_says(
        (shoulder, elbow, eye) in (any_rotation(), any_rotation(), any_rotation()),
        axes in prop::sample::select(GizmoAxes::ALL.as_slice()),
        nth in 0..10usize,
        way in prop::collection::vec((0.0f32..1000.0, 0.0f32..600.0, any::<bool>(), any::<bool>()), 1..80),
    ) {
        let (mut editor, rbt, camera) = posed(shoulder, elbow, eye);
        editor.apply(Command::View(ViewCommand::SetGizmoAxes(axes))).unwrap();
        let gizmo = editor.gizmo(&camera).unwrap();
        let handles: Vec<Handle> = gizmo.handles().collect();
        let handle = handles[nth % handles.len()];
        let was = placed(&editor, rbt);
        gesture(&mut editor, GestureCommand::Grab(handle));
        let mut track = Track::new(gizmo, handle, camera.project(gizmo.centre_in_world).unwrap().0 + 50.0);
        let mut pull = handle.pulled([0.0; 2]);
        for (x, y, snaps, is_fine) in way {
            let snap = snaps.then(SnapSteps::default);
            pull = track.move_to(Vec2::new(x, y), Steps { snap, is_fine });
            let (degrees, units) = if is_fine { (1.5, 0.025) } else { (15.0, 0.25) };
            if snaps {
                match pull {
                    Pull::Turn { degrees: pulled, .. } => prop_assert!((pulled / degrees).round() * degrees == pulled),
                    Pull::Move { by, .. } => {
                        prop_assert!(by.iter().all(|pulled| (pulled / units).round() * units == *pulled));
                    }
                }
            }
            // Near the vanishing point of an axis, a pixel is as far as one likes: further than coordinates go.
            if editor.apply(Command::Gesture(GestureCommand::Pull(pull))).is_err() {
                return Ok(());
            }
        }
        if let Pull::Move { by, .. } = pull && by.iter().any(|by| by.abs() > 50.0) {
            return Ok(());
        }
        check_same(pull, told(&editor, rbt, was, pull));
        gesture(&mut editor, GestureCommand::Commit);
        editor.apply(Command::Undo).unwrap();
        prop_assert_eq!(placed(&editor, rbt), was);
    }

    /// What was taken stays under the pointer: the node's centre moves as the pointer does, along the axis or in the plane.
    #[test]
    fn what_is_moved_stays_under_the_pointer(
        (shoulder, elbow, eye) in (any_rotation(), any_rotation(), any_rotation()),
        axes in prop::sample::select(GizmoAxes::ALL.as_slice()),
        by_px in (-40.0f32..40.0, -40.0f32..40.0),
    ) {
        let (mut editor, rbt, camera) = posed(shoulder, elbow, eye);
        editor.apply(Command::View(ViewCommand::SetGizmoAxes(axes))).unwrap();
        let gizmo = editor.gizmo(&camera).unwrap();
        let from_px = gizmo.centre_px;
        for handle in gizmo.handles().chain([Handle::MOVE_IN_VIEW]).filter(|handle| handle.kind != HandleKind::Turn) {
            gesture(&mut editor, GestureCommand::Grab(handle));
            let to_px = from_px + Vec2::from(by_px);
            let pull = Track::new(gizmo, handle, from_px).move_to(to_px, Steps::default());
            gesture(&mut editor, GestureCommand::Pull(pull));
            let (seen_px, _) = camera.project(world_from(&editor, rbt).translation).unwrap();
            if handle.kind == HandleKind::Plane {
                prop_assert!(seen_px.distance(to_px) < 0.1, "{handle:?}: {seen_px} is not {to_px}");
            } else {
                let seen_along = (seen_px - from_px).normalize_or_zero();
                // The nearest point of the axis to the ray is near to the nearest one as seen.
                let off = (to_px - seen_px).dot(seen_along);
                prop_assert!(off.abs() < 20.0, "{handle:?}: {off} px off");
            }
            gesture(&mut editor, GestureCommand::Abort);
        }
    }
}

#[test]
fn each_handle_can_be_taken_somewhere() {
    let turn = |x, y| Quat::from_rotation_y(y) * Quat::from_rotation_x(x);
    for eye in [turn(0.0, 0.0), turn(-0.4, 0.6), turn(0.5, -2.0), turn(-1.2, 0.1)] {
        let (editor, _, camera) = posed(Quat::IDENTITY, Quat::IDENTITY, eye);
        let gizmo = editor.gizmo(&camera).unwrap();
        for handle in gizmo.handles() {
            assert!(gizmo.grip_px(handle, REACH_PX).is_some(), "{handle:?} with the eye turned by {eye}");
        }
        assert!(gizmo.handles().count() >= 6);
    }
}

#[test]
fn a_ring_turns_with_the_pointer() {
    let (mut editor, rbt, camera) = posed(Quat::IDENTITY, Quat::IDENTITY, Quat::IDENTITY);
    let gizmo = editor.gizmo(&camera).unwrap();
    let centre_px = gizmo.centre_px;
    let drag = |editor: &mut Editor, handle, from: Vec2, to: Vec2| {
        gesture(editor, GestureCommand::Grab(handle));
        let pull = Track::new(gizmo, handle, centre_px + from).move_to(centre_px + to, Steps::default());
        gesture(editor, GestureCommand::Pull(pull));
        let turned = placed(editor, rbt).rotation;
        gesture(editor, GestureCommand::Abort);
        turned
    };
    let of = |axis| Handle { kind: HandleKind::Turn, axis, axes: GizmoAxes::Local };
    // Seen from the front: a quarter counterclockwise.
    let turned = drag(&mut editor, of(Axis::Z), Vec2::new(100.0, 0.0), Vec2::new(0.0, -80.0));
    assert!(turned.angle_between(Quat::from_rotation_z(90f32.to_radians())) < 1e-3, "{turned}");
    // Seen from the edge: its near side goes with the pointer, a radius of the ball for a radian.
    let turned = drag(&mut editor, of(Axis::Y), Vec2::ZERO, Vec2::new(150.0, 0.0));
    assert!(turned.angle_between(Quat::from_rotation_y(1.0)) < 1e-3, "{turned}");
    let turned = drag(&mut editor, of(Axis::X), Vec2::ZERO, Vec2::new(0.0, 150.0));
    assert!(turned.angle_between(Quat::from_rotation_x(1.0)) < 1e-3, "{turned}");
}

#[test]
fn turns_go_on_beyond_half_a_turn() {
    let (editor, _, camera) = posed(Quat::IDENTITY, Quat::IDENTITY, Quat::IDENTITY);
    let gizmo = editor.gizmo(&camera).unwrap();
    let at = |degrees: f32| gizmo.centre_px + Vec2::from_angle(-degrees.to_radians()) * 90.0;
    let mut track = Track::new(gizmo, Handle::TURN_IN_VIEW, at(0.0));
    for step in 1..=25u8 {
        let Pull::Turn { degrees, .. } = track.move_to(at(f32::from(step) * 30.0), Steps::default()) else { panic!() };
        assert!((degrees - f64::from(step) * 30.0).abs() < 1e-3, "{degrees} at step {step}");
    }
}

#[test]
fn a_typed_angle_is_that_of_rotate() {
    let (mut editor, rbt) = choosing("robot1/right_shoulder");
    gesture(&mut editor, GestureCommand::Grab(Handle::TURN_IN_VIEW));
    press(&mut editor, &["z", "4", "5"]);
    assert_eq!(editor.readout().unwrap().text.to_string(), "45|° about z");
    press(&mut editor, &["enter"]);
    assert!(!editor.is_dragging());
    assert!(placed(&editor, rbt).rotation.abs_diff_eq(Quat::from_rotation_z(45f32.to_radians()), 1e-6));
    editor.apply(Command::Undo).unwrap();
    assert_eq!(placed(&editor, rbt).rotation, Quat::IDENTITY);
}

#[test]
fn half_a_turn_goes_the_way_of_the_courses() {
    let (mut editor, rbt) = choosing("robot1/head");
    for axes in GizmoAxes::ALL {
        editor.apply(Command::Edit(Edit::PullChosen(Pull::Turn { axis: Axis::Z, degrees: 180.0, axes }))).unwrap();
        let turned = placed(&editor, rbt).rotation;
        assert!(turned.w >= 0.0 && turned.z > 0.0, "{axes:?}: {turned}");
        editor.apply(Command::Undo).unwrap();
    }
}

#[test]
fn numbers_are_typed_as_they_are_read() {
    let (mut editor, rbt) = choosing("robot1");
    gesture(&mut editor, GestureCommand::Grab(Handle::MOVE_IN_VIEW));
    let mut check = |keys: &[&str], text: &str, x: f32| {
        press(&mut editor, keys);
        assert_eq!(editor.readout().unwrap().text.to_string(), text);
        let moved = placed(&editor, rbt).translation;
        assert!((moved - Vec3::new(x - 2.0, 1.0, 0.0)).length() < 1e-6, "{text} leads to {moved}");
    };
    check(&["x"], "+0.00 along x", 0.0);
    check(&["-"], "-| along x", 0.0);
    check(&["1"], "-1| along x", -1.0);
    check(&[".", "."], "-1.| along x", -1.0);
    check(&["2", "5"], "-1.25| along x", -1.25);
    check(&["-"], "1.25| along x", 1.25);
    check(&["backspace", "backspace"], "1.| along x", 1.0);
    check(&["backspace", "backspace", "backspace"], "+0.00 along x", 0.0);
}

#[test]
fn the_pointer_counts_until_a_number_is_typed() {
    let (mut editor, rbt) = choosing("robot1");
    gesture(&mut editor, GestureCommand::Grab(Handle::MOVE_IN_VIEW));
    gesture(&mut editor, GestureCommand::Pull(Handle::MOVE_IN_VIEW.pulled([0.5, 0.1])));
    assert_eq!(editor.readout().unwrap().text.to_string(), "+0.50 right, +0.10 up");
    press(&mut editor, &["2"]);
    gesture(&mut editor, GestureCommand::Pull(Handle::MOVE_IN_VIEW.pulled([0.7, 0.1])));
    assert_eq!(placed(&editor, rbt).translation, Vec3::new(0.0, 1.0, 0.0));
    press(&mut editor, &["backspace"]);
    assert!(placed(&editor, rbt).translation.distance(Vec3::new(-1.3, 1.1, 0.0)) < 1e-6);
}

#[test]
fn an_axis_locked_again_is_the_worlds() {
    let (mut editor, rbt) = choosing("robot1/right_shoulder");
    editor.apply(Command::Edit(Edit::SetRotation(rbt, Quat::from_rotation_x(1.0)))).unwrap();
    gesture(&mut editor, GestureCommand::Grab(Handle::TURN_IN_VIEW));
    for axes in [GizmoAxes::Local, GizmoAxes::World, GizmoAxes::Local] {
        press(&mut editor, &["y"]);
        assert_eq!(editor.held(), Some(Handle { kind: HandleKind::Turn, axis: Axis::Y, axes }));
    }
    press(&mut editor, &["z"]);
    assert_eq!(editor.held().unwrap().axes, GizmoAxes::Local);
}

#[test]
fn keys_turn_a_drag_of_the_arcball_into_a_turn_about_an_axis() {
    let (mut editor, rbt) = choosing("robot1/right_shoulder");
    gesture(&mut editor, GestureCommand::Begin);
    gesture(&mut editor, GestureCommand::Move(Rbt::from_rotation(Quat::from_rotation_y(0.4))));
    press(&mut editor, &["x", "9", "0"]);
    assert!(placed(&editor, rbt).rotation.abs_diff_eq(Quat::from_rotation_x(90f32.to_radians()), 1e-6));
}

#[test]
fn handles_hide_with_the_arcball_while_playing_and_for_the_eye() {
    let (mut editor, _) = choosing("robot1");
    assert!(editor.shows_gizmo());
    editor.apply(Command::View(ViewCommand::ToggleArcball)).unwrap();
    assert!(!editor.shows_gizmo());
    editor.apply(Command::View(ViewCommand::ToggleArcball)).unwrap();
    editor.apply(Command::View(ViewCommand::ToggleGizmo)).unwrap();
    assert!(!editor.shows_gizmo());
    let camera = editor.camera(SIZE_PX);
    assert!(editor.gizmo(&camera).is_some());
    editor.apply(Command::View(ViewCommand::NextEye)).unwrap();
    assert!(editor.gizmo(&editor.camera(SIZE_PX)).is_none());
}

#[test]
fn escape_ends_one_thing_at_a_time() {
    let (mut editor, rbt) = choosing("robot1");
    let was = placed(&editor, rbt);
    editor.apply(Command::View(ViewCommand::StartPicking)).unwrap();
    gesture(&mut editor, GestureCommand::Grab(Handle::MOVE_IN_VIEW));
    press(&mut editor, &["3"]);
    editor.apply(Command::View(ViewCommand::ToggleHelp)).unwrap();
    let mut left = Vec::new();
    for _ in 0..5 {
        let session = editor.session();
        left.push((session.shows_help, editor.is_dragging(), session.is_picking, !editor.session().chosen.is_empty()));
        editor.apply(Command::Cancel).unwrap();
    }
    assert_eq!(
        left,
        [
            (true, true, true, true),
            (false, true, true, true),
            (false, false, true, true),
            (false, false, false, true),
            (false, false, false, false),
        ]
    );
    assert_eq!(placed(&editor, rbt), was);
}

#[test]
fn without_a_choice_nothing_is_held() {
    let mut editor = editor();
    assert!(editor.apply(Command::Gesture(GestureCommand::Grab(Handle::TURN_IN_VIEW))).is_err());
    assert!(!editor.is_dragging());
    assert!(editor.apply(DragKey::Lock(Axis::X).command()).is_err());
}

#[test]
fn other_keys_do_nothing_in_a_drag() {
    for word in ["n", "u", "d", "r", "w", "ctrl+z", "alt+x", "space", "f1", "ctrl+4"] {
        assert_eq!(DragKey::of(press_from_word(word).unwrap()), None, "{word}");
    }
    assert_eq!(DragKey::of(press_from_word("X").unwrap()), Some(DragKey::Lock(Axis::X)));
}

#[test]
fn several_nodes_turn_each_about_its_own_origin_or_as_one() {
    let (mut editor, shoulder) = choosing("robot1/right_shoulder");
    let robot2 = RbtIndex::new(12);
    editor.apply(Command::View(ViewCommand::ChooseAlso(robot2))).unwrap();
    let turn = Command::Edit(Edit::PullChosen(Pull::Turn { axis: Axis::Z, degrees: 90.0, axes: GizmoAxes::World }));
    editor.apply(turn.clone()).unwrap();
    let quarter = Quat::from_rotation_z(90f32.to_radians());
    for rbt in [shoulder, robot2] {
        assert!(placed(&editor, rbt).rotation.abs_diff_eq(quarter, 1e-6));
    }
    editor.apply(Command::Undo).unwrap();
    editor.apply(Command::View(ViewCommand::SetPivot(crate::editor::Pivot::Common))).unwrap();
    // The shoulder is at (-1.5, 1.75) and the robot at (2, 1).
    editor.apply(turn).unwrap();
    assert!(world_from(&editor, robot2).translation.distance(Vec3::new(0.625, 3.125, 0.0)) < 1e-5);
    assert!(world_from(&editor, shoulder).translation.distance(Vec3::new(-0.125, -0.375, 0.0)) < 1e-5);
}
