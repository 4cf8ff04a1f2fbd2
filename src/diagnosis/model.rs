//! The known mistakes: a table of names and of the rules by which a program that makes the mistake plays.
//!
//! Most mistakes can be made in either interpolation: such a model has a form for each, and the better one counts.

use super::{CORRECT, CORRECT_CATMULL_ROM, LAST_SAMPLE_MISSING};

/// A candidate: its name and the rules that it plays by.
#[derive(Debug)]
pub(super) struct Model {
    /// Its name, as `diagnose` prints it.
    pub name: &'static str,
    /// The rules; never empty, the first strict.
    pub forms: &'static [Rules],
    /// Whether it shows only where the samples carry milliseconds.
    pub needs_ms: bool,
}

/// How a program blends two rotations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Blend {
    /// By a power of what leads from one to the other.
    Slerp,
    /// The stored components, as they are.
    Lerp,
    /// The components of the nearer signs, renormalised.
    Nlerp,
}

/// What a power of no rotation gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum WhenEqual {
    /// The identity, as it should.
    Right,
    /// No number: 0/0.
    NoNumber,
    /// No number or the right one, as rounding has it: for samples that hold some of each.
    PerhapsNoNumber,
    /// The blend as a whole gives the identity.
    Identity,
}

/// How a program plays. [`LINEAR`] and [`SPLINE`] are right; each mistake differs from one of them in little.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rules {
    /// Whether it plays Catmull-Rom splines.
    pub is_spline: bool,
    /// How it blends rotations.
    pub blend: Blend,
    /// Whether a blend takes the short way, by negating where w < 0.
    pub negates_in_blends: bool,
    /// How often the angle is turned by in a power: 1.
    pub angle_factor: f64,
    /// What it does where nothing turns.
    pub when_equal: WhenEqual,
    /// Whether the powers in control points take the short way.
    pub negates_in_control_points: bool,
    /// What the tangents in control points are divided by: 6.
    pub tangent_divisor: f64,
    /// Which of the four keyframes c(i−1) to c(i+2) the second control point is built on: 2.
    pub second_base: usize,
    /// Which keyframe of the list is at key time 0: 1.
    pub first_keyframe: usize,
    /// How many key times pass in the time of one: 1.
    pub pace: f64,
    /// Whether the last pose is shown.
    pub shows_end: bool,
    /// In which places the components w, x, y, z are printed: each column's component.
    pub printed: [usize; 4],
    /// In which order they were read from the keyframe file.
    pub read: [usize; 4],
}

impl Rules {
    /// Whether it allows more than one value where nothing turns; counted only where samples hold what is no number.
    pub fn is_lenient(&self) -> bool {
        self.when_equal == WhenEqual::PerhapsNoNumber
    }

    /// Whether it begins or ends elsewhere than right playback.
    pub fn changes_range(&self) -> bool {
        self.first_keyframe != LINEAR.first_keyframe || !self.shows_end
    }
}

const IN_ORDER: [usize; 4] = [0, 1, 2, 3];
/// x, y, z, w where w, x, y, z belong.
const W_LAST: [usize; 4] = [1, 2, 3, 0];

const LINEAR: Rules = Rules {
    is_spline: false,
    blend: Blend::Slerp,
    negates_in_blends: true,
    angle_factor: 1.0,
    when_equal: WhenEqual::Right,
    negates_in_control_points: true,
    tangent_divisor: 6.0,
    second_base: 2,
    first_keyframe: 1,
    pace: 1.0,
    shows_end: true,
    printed: IN_ORDER,
    read: IN_ORDER,
};

const SPLINE: Rules = Rules { is_spline: true, ..LINEAR };

/// 16 whole milliseconds for 1000/60.
pub(super) const INTEGER_TICK_PACE: f64 = 16.0 * 60.0 / 1000.0;

const fn model(name: &'static str, forms: &'static [Rules]) -> Model {
    Model { name, forms, needs_ms: false }
}

/// Every candidate, in the order that decides among equals.
pub(super) const MODELS: [Model; 16] = [
    model(CORRECT, &[LINEAR]),
    model(CORRECT_CATMULL_ROM, &[SPLINE]),
    model("no-conditional-negation", &[Rules { negates_in_blends: false, ..LINEAR }]),
    model("lerp-for-slerp", &[Rules { blend: Blend::Lerp, ..LINEAR }, Rules { blend: Blend::Lerp, ..SPLINE }]),
    model("nlerp-for-slerp", &[Rules { blend: Blend::Nlerp, ..LINEAR }, Rules { blend: Blend::Nlerp, ..SPLINE }]),
    model(
        "nan-when-equal",
        &[
            Rules { when_equal: WhenEqual::NoNumber, ..LINEAR },
            Rules { when_equal: WhenEqual::NoNumber, ..SPLINE },
            Rules { when_equal: WhenEqual::PerhapsNoNumber, ..LINEAR },
            Rules { when_equal: WhenEqual::PerhapsNoNumber, ..SPLINE },
        ],
    ),
    model("angle-not-halved", &[Rules { angle_factor: 2.0, ..LINEAR }, Rules { angle_factor: 2.0, ..SPLINE }]),
    model(
        "identity-when-equal",
        &[Rules { when_equal: WhenEqual::Identity, ..LINEAR }, Rules { when_equal: WhenEqual::Identity, ..SPLINE }],
    ),
    model("second-control-point-on-wrong-keyframe", &[Rules { second_base: 1, ..SPLINE }]),
    model("no-division-by-six", &[Rules { tangent_divisor: 1.0, ..SPLINE }]),
    model("no-conditional-negation-in-control-points", &[Rules { negates_in_control_points: false, ..SPLINE }]),
    model("all-keyframes-played", &[Rules { first_keyframe: 0, ..LINEAR }, Rules { first_keyframe: 0, ..SPLINE }]),
    model("one-keyframe-early", &[Rules { first_keyframe: 2, ..LINEAR }, Rules { first_keyframe: 2, ..SPLINE }]),
    model(LAST_SAMPLE_MISSING, &[Rules { shows_end: false, ..LINEAR }, Rules { shows_end: false, ..SPLINE }]),
    model(
        "quaternion-order-swapped",
        // Read in the wrong order, they are printed so as well; slerp does not see the difference, control points do.
        &[Rules { printed: W_LAST, ..LINEAR }, Rules { printed: W_LAST, ..SPLINE }, Rules { read: W_LAST, ..SPLINE }],
    ),
    Model {
        name: "integer-tick",
        forms: &[Rules { pace: INTEGER_TICK_PACE, ..LINEAR }, Rules { pace: INTEGER_TICK_PACE, ..SPLINE }],
        needs_ms: true,
    },
];
