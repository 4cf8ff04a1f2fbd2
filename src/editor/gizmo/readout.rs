//! How far a handle was pulled, in words.

use super::{Axis, GizmoAxes, Pull};
use crate::editor::Editor;
use crate::words::{Message, Phrase, texts};

/// How far the handle at hand was pulled.
#[derive(Clone, Debug, PartialEq)]
pub struct Readout {
    /// As in `+32.5° about z`; a number that is being typed has a mark at its end.
    pub text: Message,
    /// Whose axes it goes by; `None` for the view's.
    pub axes: Option<Phrase>,
}

impl GizmoAxes {
    /// What users read.
    #[must_use]
    pub const fn title(self) -> Phrase {
        match self {
            Self::Local => texts::AXES_LOCAL,
            Self::Parent => texts::AXES_PARENT,
            Self::World => texts::AXES_WORLD,
            Self::View => texts::AXES_VIEW,
        }
    }
}

impl Editor {
    /// How far the handle that is held was pulled; `None` where none is held.
    #[must_use]
    pub fn readout(&self) -> Option<Readout> {
        let hold = self.gesture.as_ref()?.hold.as_ref()?;
        let typed = (!hold.typed.is_empty()).then(|| format!("{}|", hold.typed));
        let number = |number: String| typed.clone().unwrap_or(number);
        Some(match hold.pull() {
            Pull::Turn { axis: Axis::Z, degrees, axes: GizmoAxes::View } => {
                Readout { text: texts::readout_turn_in_view(number(degrees_text(degrees))), axes: None }
            }
            Pull::Turn { axis, degrees, axes } => Readout {
                text: texts::readout_turn(number(degrees_text(degrees)), axis.name()),
                axes: Some(axes.title()),
            },
            Pull::Move { by, axes } => {
                let along = |axis: Axis| units_text(by[axis.index()]);
                let text = match (hold.handle.directions().as_slice(), axes) {
                    ([Axis::X, Axis::Y], GizmoAxes::View) => {
                        texts::readout_move_in_view(number(along(Axis::X)), along(Axis::Y))
                    }
                    (&[first, second], _) => {
                        texts::readout_move_in_plane(number(along(first)), first.name(), along(second), second.name())
                    }
                    (all, _) => {
                        let axis = all.first().copied().unwrap_or(Axis::X);
                        texts::readout_move(number(along(axis)), axis.name())
                    }
                };
                Readout { text, axes: (axes != GizmoAxes::View).then(|| axes.title()) }
            }
        })
    }
}

/// With a sign, and one place after the point.
fn degrees_text(degrees: f64) -> String {
    // Adding 0.0 makes a zero of minus zero.
    format!("{:+.1}", (degrees * 10.0).round() / 10.0 + 0.0)
}

/// With a sign, and two places after the point, or three where the third is not zero.
fn units_text(units: f64) -> String {
    let mut text = format!("{:+.3}", (units * 1000.0).round() / 1000.0 + 0.0);
    if text.ends_with('0') {
        text.pop();
    }
    text
}
