//! Handles: lit, taken, dragged, snapped, slowed, read and taken back.

use glam::{Vec2, Vec3};
use inbetween::editor::gizmo::{Axis, GizmoAxes, Handle, HandleKind};
use inbetween::window::handle::REACH;
use winit::keyboard::ModifiersState;

use crate::table::{Left, SHOULDER, Table, VIEW};

const fn handle(kind: HandleKind, axis: Axis, axes: GizmoAxes) -> Handle {
    Handle { kind, axis, axes }
}

const RING: Handle = handle(HandleKind::Turn, Axis::Z, GizmoAxes::Local);
const ARROW: Handle = handle(HandleKind::Move, Axis::X, GizmoAxes::Local);

fn with_handles() -> Table {
    Table::after("select robot1/right_shoulder")
}

/// A pixel of the window that takes a handle.
fn grip_px(table: &Table, handle: Handle) -> Vec2 {
    let gizmo = table.editor.gizmo(&table.camera()).expect("a node is chosen");
    let reach_px = REACH * VIEW.pixels_per_point;
    VIEW.min_px + gizmo.grip_px(handle, reach_px).unwrap_or_else(|| panic!("{handle:?} is not seen"))
}

fn readout(table: &Table) -> String {
    table.editor.readout().map(|readout| readout.text.to_string()).unwrap_or_default()
}

/// Degrees about its own z by which the shoulder is turned.
fn degrees(table: &Table) -> f32 {
    let (axis, angle) = table.live(SHOULDER).rotation.to_axis_angle();
    assert!(angle == 0.0 || axis.z.abs() > 1.0 - 1e-5, "{axis}");
    angle.to_degrees() * axis.z.signum()
}

#[test]
fn what_a_press_would_take_is_lit() {
    for taken in [RING, ARROW, handle(HandleKind::Plane, Axis::Z, GizmoAxes::Local)] {
        let mut table = with_handles();
        let at_px = grip_px(&table, taken);
        table.move_to(at_px);
        assert_eq!(table.hands.hovered_handle, Some(taken));
        assert_eq!(table.lit().0, None, "a part under a handle is not lit");
        table.down(Left);
        table.move_to(at_px + Vec2::new(20.0, 10.0));
        assert_eq!(table.editor.held(), Some(taken));
        table.up(Left);
        assert_eq!((table.editor.held(), table.changed()), (None, vec![SHOULDER]));
    }
}

#[test]
fn a_ring_turns_about_its_axis_with_a_readout() {
    let mut table = with_handles();
    table.begin_drag(Left, grip_px(&table, RING), Vec2::new(30.0, 40.0));
    let turned = degrees(&table);
    assert!(turned.abs() > 3.0, "{turned}");
    assert_eq!(readout(&table), format!("{turned:+.1}° about z"));
    table.up(Left);
    assert_eq!((table.undo_label(), readout(&table)), (Some("turn a node"), String::new()));
    // The line that does the same.
    let by_line = Table::after(&format!("select {SHOULDER}\nturn z {turned} local"));
    assert!(by_line.live(SHOULDER).rotation.dot(table.live(SHOULDER).rotation) > 1.0 - 1e-6);
}

#[test]
fn shift_snaps_to_the_steps_that_are_set() {
    for (lines, degrees_step, units_step) in [("", 15.0, 0.25), ("snap 5 0.1", 5.0, 0.1)] {
        let mut table = with_handles();
        table.run(lines);
        table.hold(ModifiersState::SHIFT);
        table.drag(Left, grip_px(&table, RING), Vec2::new(30.0, 40.0));
        let turned = degrees(&table) / degrees_step;
        assert!(turned.abs() > 0.5 && (turned - turned.round()).abs() < 1e-3, "{turned} steps");
        table.press("ctrl+z");
        table.drag(Left, grip_px(&table, ARROW), Vec2::new(70.0, 3.0));
        let moved = (table.live(SHOULDER).translation - Vec3::new(0.5, 0.75, 0.0)) / units_step;
        assert!(moved.x > 0.5 && (moved - moved.round()).length() < 1e-3, "{moved} steps");
        assert_eq!((moved.y, moved.z), (0.0, 0.0));
    }
}

#[test]
fn ctrl_is_fine() {
    let turned = |keys| {
        let mut table = with_handles();
        table.move_to(grip_px(&table, RING));
        table.down(Left);
        table.hold(keys);
        table.move_to(grip_px(&with_handles(), RING) + Vec2::new(20.0, 30.0));
        degrees(&table)
    };
    let (whole, fine) = (turned(ModifiersState::empty()), turned(ModifiersState::CONTROL));
    assert!(whole.abs() > 2.0 && (whole / 10.0 - fine).abs() < 0.01, "{whole} {fine}");
}

#[test]
fn escape_takes_back_and_the_button_moves_nothing_more() {
    let mut table = with_handles();
    table.begin_drag(Left, grip_px(&table, RING), Vec2::new(30.0, 40.0));
    assert_eq!(table.changed(), [SHOULDER]);
    table.press("esc");
    assert_eq!((table.changed(), table.undo_label()), (vec![], None));
    table.move_to(table.on_ground());
    table.up(Left);
    assert_eq!((table.changed(), table.chosen()), (vec![], vec![SHOULDER]));
}

#[test]
fn hidden_handles_take_nothing() {
    let mut table = with_handles();
    let at_px = grip_px(&table, ARROW);
    table.press("shift+h");
    table.move_to(at_px);
    assert_eq!(table.hands.hovered_handle, None);
}

#[test]
fn axes_are_chosen_by_key_and_by_line() {
    let mut table = with_handles();
    for axes in ["parent", "world", "view", "local"] {
        table.press("shift+x");
        let by_line = Table::after(&format!("gizmo-axes {axes}"));
        assert_eq!(table.editor.session().gizmo_axes, by_line.editor.session().gizmo_axes, "{axes}");
    }
}
