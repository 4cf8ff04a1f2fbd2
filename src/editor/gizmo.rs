//! Handles around the chosen node: rings that turn it, arrows and squares that move it.
//!
//! What a handle does is a [`Pull`]: a turn about an axis or a move along axes, counted from the beginning of the drag, so that nothing
//! adds up. [`Gizmo`] is where the handles are in the view, [`Track`] makes pulls of a pointer's way, and [`Readout`] says them.

mod hold;
mod place;
mod pull;
mod readout;
mod shown;
mod track;

pub use hold::DragKey;
pub(super) use hold::Hold;
pub use place::{Gizmo, Part};
pub use readout::Readout;
pub use track::{Steps, Track};

pub use crate::settings::{GizmoAxes, SnapSteps};

/// One of three axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The first.
    X,
    /// The second.
    Y,
    /// The third.
    Z,
}

impl Axis {
    /// All of them, in order.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// Its place in a vector: 0, 1 or 2.
    #[must_use]
    pub const fn index(self) -> usize {
        self as usize
    }

    /// Its letter.
    #[must_use]
    pub const fn name(self) -> &'static str {
        ["x", "y", "z"][self.index()]
    }

    /// The two others, in the order in which a turn about this one leads from the first to the second.
    #[must_use]
    pub const fn others(self) -> [Self; 2] {
        match self {
            Self::X => [Self::Y, Self::Z],
            Self::Y => [Self::Z, Self::X],
            Self::Z => [Self::X, Self::Y],
        }
    }
}

/// What a handle does with its axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HandleKind {
    /// A ring: turns about the axis.
    Turn,
    /// An arrow: moves along the axis.
    Move,
    /// A square: moves in the plane of the two other axes.
    Plane,
}

/// A handle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Handle {
    /// What it does.
    pub kind: HandleKind,
    /// Its axis.
    pub axis: Axis,
    /// Whose axis that is.
    pub axes: GizmoAxes,
}

impl Handle {
    /// Turns about the line of sight: the outer ring.
    pub const TURN_IN_VIEW: Self = Self { kind: HandleKind::Turn, axis: Axis::Z, axes: GizmoAxes::View };
    /// Moves in the view's plane.
    pub const MOVE_IN_VIEW: Self = Self { kind: HandleKind::Plane, axis: Axis::Z, axes: GizmoAxes::View };

    /// The axes along which it moves, the first of which takes a typed number; the one about which it turns.
    #[must_use]
    pub fn directions(self) -> Vec<Axis> {
        match self.kind {
            HandleKind::Turn | HandleKind::Move => vec![self.axis],
            HandleKind::Plane => {
                let mut both = self.axis.others();
                both.sort_by_key(|axis| axis.index());
                both.to_vec()
            }
        }
    }

    /// It pulled by so much along its directions: degrees for turns, units for moves.
    #[must_use]
    pub fn pulled(self, amounts: [f64; 2]) -> Pull {
        let axes = self.axes;
        if self.kind == HandleKind::Turn {
            return Pull::Turn { axis: self.axis, degrees: amounts[0], axes };
        }
        let mut by = [0.0; 3];
        for (direction, amount) in self.directions().into_iter().zip(amounts) {
            by[direction.index()] = amount;
        }
        Pull::Move { by, axes }
    }
}

/// A motion of the chosen nodes, each about its own origin and, with local or parent axes, by axes of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pull {
    /// Turns.
    Turn {
        /// About which axis.
        axis: Axis,
        /// By how many degrees, by the right-hand rule.
        degrees: f64,
        /// Whose axis it is.
        axes: GizmoAxes,
    },
    /// Moves.
    Move {
        /// How far along x, y and z: in units of the node's parent for local and parent axes, else in scene units.
        by: [f64; 3],
        /// Whose axes they are.
        axes: GizmoAxes,
    },
}

#[cfg(test)]
mod tests;
