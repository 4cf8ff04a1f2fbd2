//! Handles around the chosen node: taken and dragged over the view without a window, drawn, and read beside the pointer.

mod common;

use common::editor;
use glam::{Quat, Vec2, Vec3};
use inbetween::editor::gizmo::{Axis, DragKey, Gizmo, GizmoAxes, Handle, HandleKind, SnapSteps, Steps};
use inbetween::editor::{Command, Edit, Editor, GestureCommand, ViewCommand};
use inbetween::frame::Line;
use inbetween::pose::RbtIndex;
use inbetween::rbt::Rbt;
use inbetween::view::{frame_of_editor, light_handle};
use inbetween::window::handle::{HandleDrag, REACH};

const SIZE_PX: Vec2 = Vec2::new(1000.0, 600.0);

/// Robot 1, chosen.
const ROBOT: RbtIndex = RbtIndex::new(2);

/// A robot that is chosen, with the sky camera a little to its side, so that no handle is seen from its edge.
fn chosen() -> Editor {
    let mut editor = editor();
    let sky = editor.scene().eyes()[0];
    let eye = Quat::from_rotation_y(0.5) * Quat::from_rotation_x(-0.4);
    let at = Vec3::new(-2.0, 1.0, 0.0) + eye * Vec3::new(0.3, 0.2, 7.0);
    for edit in [Edit::SetRotation(sky, eye), Edit::SetTranslation(sky, at)] {
        editor.apply(Command::Edit(edit)).unwrap();
    }
    editor.apply(Command::View(ViewCommand::Choose(Some(ROBOT)))).unwrap();
    editor
}

fn gizmo(editor: &Editor) -> Gizmo {
    editor.gizmo(&editor.camera(SIZE_PX)).unwrap()
}

fn placed(editor: &Editor) -> Rbt {
    editor.document().live_pose.get(ROBOT)
}

fn gesture(editor: &mut Editor, gesture: GestureCommand) {
    editor.apply(Command::Gesture(gesture)).unwrap();
}

/// The handle under a pixel, pressed: the drag that it begins.
fn press(editor: &mut Editor, at_px: Vec2) -> HandleDrag {
    let camera = editor.camera(SIZE_PX);
    let handle = editor.handle_at(&camera, at_px, REACH).unwrap();
    let drag = HandleDrag::begin(editor, &camera, at_px).unwrap();
    gesture(editor, GestureCommand::Grab(handle));
    drag
}

fn move_to(editor: &mut Editor, drag: &mut HandleDrag, at_px: Vec2, steps: Steps) {
    let pull = drag.move_to(editor.held().unwrap(), at_px, steps);
    editor.apply(pull).unwrap();
}

fn readout(editor: &Editor) -> String {
    editor.readout().unwrap().text.to_string()
}

const SNAPS: Steps = Steps { snap: Some(SnapSteps { degrees: 15.0, units: 0.25 }), is_fine: false };
const IS_FINE: Steps = Steps { snap: None, is_fine: true };

#[test]
fn an_arrow_is_taken_and_dragged_along_its_axis() {
    let mut editor = chosen();
    let arrow = Handle { kind: HandleKind::Move, axis: Axis::X, axes: GizmoAxes::Local };
    let grip_px = gizmo(&editor).grip_px(arrow, REACH).unwrap();
    let mut drag = press(&mut editor, grip_px);
    assert_eq!(editor.held(), Some(arrow));
    move_to(&mut editor, &mut drag, grip_px + Vec2::new(80.0, 5.0), Steps::default());
    let free = placed(&editor).translation;
    assert!(free.x > -1.7 && (free.y, free.z) == (1.0, 0.0), "{free}");
    move_to(&mut editor, &mut drag, grip_px + Vec2::new(81.0, 5.0), SNAPS);
    let snapped = placed(&editor).translation;
    assert_eq!((snapped.x / 0.25).fract(), 0.0, "{snapped}");
    let text = readout(&editor);
    assert!(text == format!("{:+.2} along x", snapped.x + 2.0), "{text}");
    gesture(&mut editor, GestureCommand::Commit);
    editor.apply(Command::Undo).unwrap();
    assert_eq!(placed(&editor).translation, Vec3::new(-2.0, 1.0, 0.0));
}

#[test]
fn a_fine_drag_goes_a_tenth_of_the_way() {
    let ring = Handle { kind: HandleKind::Turn, axis: Axis::Y, axes: GizmoAxes::World };
    let turned = |steps| {
        let mut editor = chosen();
        editor.apply(Command::View(ViewCommand::SetGizmoAxes(GizmoAxes::World))).unwrap();
        let grip_px = gizmo(&editor).grip_px(ring, REACH).unwrap();
        let mut drag = press(&mut editor, grip_px);
        move_to(&mut editor, &mut drag, grip_px + Vec2::new(30.0, 0.0), steps);
        placed(&editor).rotation.to_scaled_axis()
    };
    let (whole, fine) = (turned(Steps::default()), turned(IS_FINE));
    assert!(whole.y.abs() > 0.1 && whole.x.abs() + whole.z.abs() < 1e-5, "{whole}");
    assert!((whole * 0.1).distance(fine) < 1e-5, "{whole}, {fine}");
}

#[test]
fn what_a_key_locks_is_taken_where_the_drag_began() {
    let mut editor = chosen();
    let square = Handle { kind: HandleKind::Plane, axis: Axis::Z, axes: GizmoAxes::Local };
    let grip_px = gizmo(&editor).grip_px(square, REACH).unwrap();
    let mut drag = press(&mut editor, grip_px);
    let to_px = grip_px + Vec2::new(60.0, -40.0);
    move_to(&mut editor, &mut drag, to_px, Steps::default());
    let free = placed(&editor).translation;
    editor.apply(DragKey::Lock(Axis::Y).command()).unwrap();
    assert_eq!(placed(&editor).translation, Vec3::new(-2.0, 1.0, 0.0));
    move_to(&mut editor, &mut drag, to_px, Steps::default());
    let locked = placed(&editor).translation;
    assert!((locked.x, locked.z) == (-2.0, 0.0) && locked.y > 1.1 && locked != free, "{free}, then {locked}");
    editor.apply(Command::Cancel).unwrap();
    assert_eq!(placed(&editor).translation, Vec3::new(-2.0, 1.0, 0.0));
}

#[test]
fn the_handle_that_is_held_is_drawn_in_full_and_the_others_faint() {
    let mut editor = chosen();
    let strongest =
        |editor: &Editor| frame_of_editor(editor, SIZE_PX).lines.iter().map(|line| line.colour.w).fold(0.0, f32::max);
    assert!(strongest(&editor) < 1.0);
    let ring = Handle { kind: HandleKind::Turn, axis: Axis::X, axes: GizmoAxes::Local };
    gesture(&mut editor, GestureCommand::Grab(ring));
    let frame = frame_of_editor(&editor, SIZE_PX);
    let in_full: Vec<_> = frame.lines.iter().filter(|line| line.colour.w > 0.99).collect();
    assert!(in_full.len() > 30 && in_full.iter().all(|line| line.colour.x > line.colour.y), "{in_full:?}");
    let (edges, coloured): (Vec<&Line>, Vec<&Line>) =
        frame.lines.iter().partition(|line| line.colour.truncate().max_element() < 0.05);
    assert!(coloured.iter().all(|line| line.colour.w > 0.99 || line.colour.w < 0.34));
    // A dark edge lies under each of them, and under none of the faint ones.
    assert_eq!(edges.len(), in_full.len());
    for (edge, line) in edges.iter().zip(&in_full) {
        assert_eq!((edge.from_in_world, edge.to_in_world), (line.from_in_world, line.to_in_world));
        assert!(edge.width_px > line.width_px && edge.colour.w < line.colour.w, "{edge:?}");
    }
}

#[test]
fn what_is_under_the_pointer_is_lit() {
    let editor = chosen();
    let gizmo = gizmo(&editor);
    let plain = frame_of_editor(&editor, SIZE_PX);
    for handle in gizmo.handles() {
        let mut lit = plain.clone();
        light_handle(&mut lit, &editor, &gizmo, handle);
        assert!(lit.lines.len() > plain.lines.len(), "{handle:?}");
    }
    let mut hidden = chosen();
    hidden.apply(Command::View(ViewCommand::ToggleGizmo)).unwrap();
    let frame = frame_of_editor(&hidden, SIZE_PX);
    assert!(frame.lines.is_empty() && frame.arcball.is_some());
    let mut lit = frame.clone();
    light_handle(&mut lit, &hidden, &gizmo, Handle::TURN_IN_VIEW);
    assert_eq!(lit, frame);
    hidden.apply(Command::View(ViewCommand::ToggleArcball)).unwrap();
    assert!(frame_of_editor(&hidden, SIZE_PX).arcball.is_none());
}

#[test]
fn handles_have_one_size_whatever_the_distance() {
    let width_px = |depth: f32| {
        let mut editor = editor();
        let sky = editor.scene().eyes()[0];
        let at = Vec3::new(-2.0, 1.0, depth);
        editor.apply(Command::Edit(Edit::SetTranslation(sky, at))).unwrap();
        editor.apply(Command::View(ViewCommand::Choose(Some(ROBOT)))).unwrap();
        let camera = editor.camera(SIZE_PX);
        let gizmo = editor.gizmo(&camera).unwrap();
        let seen = gizmo.parts(Handle::TURN_IN_VIEW).into_iter().map(|part| {
            let (seen_px, _) = camera.project(gizmo.point_in_world(part.ends[0])).unwrap();
            seen_px.distance(SIZE_PX * 0.5)
        });
        seen.fold((f32::MAX, 0.0f32), |(least, most), now| (least.min(now), most.max(now)))
    };
    for depth in [1.0, 6.0, 500.0] {
        let (least, most) = width_px(depth);
        assert!((least - 180.0).abs() < 0.5 && (most - 180.0).abs() < 0.5, "{least} to {most} at {depth}");
    }
}
