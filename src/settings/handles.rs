//! Settings of the handles around the chosen node.

use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

/// Whose axes handles go by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum GizmoAxes {
    /// The node's own, as they are when a drag begins.
    #[default]
    Local,
    /// Those of the node's parent, in which its translation is measured.
    Parent,
    /// The world's.
    World,
    /// The view's: x to the right, y up, z towards the viewer.
    View,
}

impl GizmoAxes {
    /// All of them, in the order of the menu.
    pub const ALL: [Self; 4] = [Self::Local, Self::Parent, Self::World, Self::View];

    /// The next one, and after the last the first.
    #[must_use]
    pub const fn next(self) -> Self {
        Self::ALL[(self as usize + 1) % Self::ALL.len()]
    }

    /// Its word in scripts and settings.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Local => "local",
            Self::Parent => "parent",
            Self::World => "world",
            Self::View => "view",
        }
    }
}

/// The steps of a drag that snaps.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SnapSteps {
    /// Of turns, in degrees; above 0.
    pub degrees: f64,
    /// Of moves, in units; above 0.
    pub units: f64,
}

impl SnapSteps {
    /// The range of steps of turns, in degrees.
    pub const DEGREES: RangeInclusive<f64> = 0.1..=180.0;
    /// The range of steps of moves, in units.
    pub const UNITS: RangeInclusive<f64> = 0.001..=1000.0;

    /// Steps of turns that menus offer, in degrees.
    pub const OFFERED_DEGREES: [f64; 7] = [1.0, 5.0, 10.0, 15.0, 30.0, 45.0, 90.0];
    /// Steps of moves that menus offer, in units.
    pub const OFFERED_UNITS: [f64; 5] = [0.05, 0.1, 0.25, 0.5, 1.0];

    /// The steps with each kept within its range. What is not a number is taken from others.
    #[must_use]
    pub fn in_range_or(self, others: Self) -> Self {
        let within = |number: f64, range: RangeInclusive<f64>, other: f64| {
            if number.is_nan() { other } else { number.clamp(*range.start(), *range.end()) }
        };
        Self {
            degrees: within(self.degrees, Self::DEGREES, others.degrees),
            units: within(self.units, Self::UNITS, others.units),
        }
    }
}

impl Default for SnapSteps {
    fn default() -> Self {
        Self { degrees: 15.0, units: 0.25 }
    }
}
