//! Whether handles are shown, whose axes they go by, and the steps of drags with Shift.

use super::{GizmoAxes, SnapSteps};
use crate::editor::{Editor, Message};
use crate::words::texts;

impl Editor {
    pub(in crate::editor) fn toggle_gizmo(&mut self) -> Message {
        self.session.shows_gizmo = !self.session.shows_gizmo;
        if self.session.shows_gizmo { texts::VIEW_GIZMO_SHOWN } else { texts::VIEW_GIZMO_HIDDEN }.into()
    }

    pub(in crate::editor) fn set_gizmo_axes(&mut self, axes: GizmoAxes) -> Message {
        self.session.gizmo_axes = axes;
        texts::view_gizmo_axes(axes.title())
    }

    pub(in crate::editor) fn set_snap_steps(&mut self, steps: SnapSteps) -> Message {
        let snap = steps.in_range_or(self.session.snap);
        self.session.snap = snap;
        texts::view_snap_steps(snap.degrees, snap.units)
    }
}
