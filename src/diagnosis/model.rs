//! The known mistakes: a table of names, advice, and the rules by which a program that makes the mistake plays.
//!
//! Most mistakes can be made in either interpolation. Such a model has a form for each; the form with the smaller residual counts.

use super::{CORRECT, CORRECT_CATMULL_ROM, LAST_SAMPLE_MISSING};

/// A candidate's explanation for people.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Advice {
    /// What the program does: a sentence.
    pub what: &'static str,
    /// What to change; empty for the two right results.
    pub change: &'static str,
}

/// A candidate: all that is known about a mistake, or about right playback.
#[derive(Debug, PartialEq)]
pub(super) struct Model {
    /// The name that `diagnose` prints.
    pub name: &'static str,
    /// The explanation that follows the name.
    pub advice: Advice,
    /// The rules that a program with this mistake may play by. Never empty; the first is not lenient.
    pub forms: &'static [Rules],
    /// Whether the mistake is visible only in samples with a column of milliseconds.
    pub needs_ms: bool,
}

impl Model {
    /// Whether the mistake is a wrong playing range: every form begins or ends elsewhere than right playback.
    pub fn is_about_range(&self) -> bool {
        self.forms.iter().all(Rules::changes_range)
    }
}

/// How a program blends two rotations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Blend {
    /// `(to * inv(from))^alpha * from`.
    Slerp,
    /// A linear blend of the stored components, not renormalised.
    Lerp,
    /// A linear blend of the components, one side negated if the dot product is negative, renormalised.
    Nlerp,
}

/// The result of a power of the identity rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum WhenEqual {
    /// The identity: correct.
    Right,
    /// NaN: 0/0.
    NoNumber,
    /// NaN or the identity, depending on rounding. Needed for samples that contain both.
    PerhapsNoNumber,
    /// The identity, and as the result of the whole blend.
    Identity,
}

/// How a program plays. [`LINEAR`] and [`SPLINE`] are right; a mistake changes one or two fields of one of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rules {
    /// Whether it plays Catmull-Rom splines; otherwise lerp and slerp.
    pub is_spline: bool,
    /// The blend of two rotations.
    pub blend: Blend,
    /// Whether a blend takes the short way: it negates `to * inv(from)` if its w is negative.
    pub negates_in_blends: bool,
    /// Factor on the angle in a power of a quaternion; right is 1.
    pub angle_factor: f64,
    /// The power of the identity rotation.
    pub when_equal: WhenEqual,
    /// Whether the powers in control points take the short way.
    pub negates_in_control_points: bool,
    /// Divisor of the tangents in control points; right is 6.
    pub tangent_divisor: f64,
    /// Which of the four keyframes c(i−1) to c(i+2), counted from 0, the second control point is built on; right is 2.
    pub second_base: usize,
    /// Index of the keyframe at key time 0; right is 1.
    pub first_keyframe: usize,
    /// Speed of playback; right is 1.
    pub pace: f64,
    /// Whether the last pose is shown.
    pub shows_end: bool,
    /// Printed order: for each column, the index of its component in w, x, y, z.
    pub printed: [usize; 4],
    /// Order in which components were read from the keyframe file: for each of w, x, y, z, the index of the number taken.
    pub read: [usize; 4],
}

impl Rules {
    /// Whether it allows two values for one key time. Lenient rules are tried only on samples that contain NaN.
    pub fn is_lenient(&self) -> bool {
        self.when_equal == WhenEqual::PerhapsNoNumber
    }

    /// Whether playing begins or ends at another keyframe than it should.
    pub fn changes_range(&self) -> bool {
        self.first_keyframe != LINEAR.first_keyframe || !self.shows_end
    }
}

const IN_ORDER: [usize; 4] = [0, 1, 2, 3];
/// x, y, z, w instead of w, x, y, z.
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

/// Speed of a clock that counts 16 ms where a tick lasts 1000/60 ms.
pub(super) const INTEGER_TICK_PACE: f64 = 16.0 * 60.0 / 1000.0;

/// Every candidate. Of candidates that explain the samples equally well, the earlier one is named first. A mistake is one row here.
pub(super) const MODELS: [Model; 17] = [
    Model {
        name: CORRECT,
        advice: Advice { what: "The samples show the right result of linear playback.", change: "" },
        forms: &[LINEAR],
        needs_ms: false,
    },
    Model {
        name: CORRECT_CATMULL_ROM,
        advice: Advice { what: "The samples show the right result of Catmull-Rom playback.", change: "" },
        forms: &[SPLINE],
        needs_ms: false,
    },
    Model {
        name: "no-conditional-negation",
        advice: Advice {
            what: "Rotations take the long way round wherever the stored quaternions have opposite signs.",
            change: "Before taking the power, negate all four components of q1 * inv(q0) if its w is negative.",
        },
        forms: &[Rules { negates_in_blends: false, ..LINEAR }],
        needs_ms: false,
    },
    Model {
        name: "lerp-for-slerp",
        advice: Advice {
            what: "The components of the quaternions are blended as they are, so that rotations speed up, slow down and distort.",
            change: "Interpolate rotations by slerp: cn(q1 * inv(q0))^alpha * q0.",
        },
        forms: &[Rules { blend: Blend::Lerp, ..LINEAR }, Rules { blend: Blend::Lerp, ..SPLINE }],
        needs_ms: false,
    },
    Model {
        name: "nlerp-for-slerp",
        advice: Advice {
            what: "Quaternions are blended and renormalised: the right way round, but not at an even speed.",
            change: "Interpolate rotations by slerp: cn(q1 * inv(q0))^alpha * q0.",
        },
        forms: &[Rules { blend: Blend::Nlerp, ..LINEAR }, Rules { blend: Blend::Nlerp, ..SPLINE }],
        needs_ms: false,
    },
    Model {
        name: "nan-when-equal",
        advice: Advice {
            what: "Where a rotation does not change, the sine of the angle is divided by and is 0: the result is no number.",
            change: "Take the angle by atan2, and where the vector part of the quaternion is 0, let its power be the identity.",
        },
        forms: &[
            Rules { when_equal: WhenEqual::NoNumber, ..LINEAR },
            Rules { when_equal: WhenEqual::NoNumber, ..SPLINE },
            Rules { when_equal: WhenEqual::PerhapsNoNumber, ..LINEAR },
            Rules { when_equal: WhenEqual::PerhapsNoNumber, ..SPLINE },
        ],
        needs_ms: false,
    },
    Model {
        name: "angle-not-halved",
        advice: Advice {
            what: "The power of a quaternion turns by twice the angle.",
            change: "A quaternion (cos phi, sin phi k) turns by 2 phi: its power is (cos(alpha phi), sin(alpha phi) k), with phi itself, not 2 phi.",
        },
        forms: &[Rules { angle_factor: 2.0, ..LINEAR }, Rules { angle_factor: 2.0, ..SPLINE }],
        needs_ms: false,
    },
    Model {
        name: "identity-when-equal",
        advice: Advice {
            what: "Where a rotation does not change between two keyframes, the identity is shown.",
            change: "The guard against a zero angle belongs into the power, before the product with q0: slerp of equal rotations is q0.",
        },
        forms: &[
            Rules { when_equal: WhenEqual::Identity, ..LINEAR },
            Rules { when_equal: WhenEqual::Identity, ..SPLINE },
        ],
        needs_ms: false,
    },
    Model {
        name: "second-control-point-on-wrong-keyframe",
        advice: Advice {
            what: "The second control point of each spline piece starts from the piece's first keyframe.",
            change: "Build e_i on c_(i+1): e_i = -(c_(i+2) - c_i)/6 + c_(i+1), and the same with powers for rotations.",
        },
        forms: &[Rules { second_base: 1, ..SPLINE }],
        needs_ms: false,
    },
    Model {
        name: "no-division-by-six",
        advice: Advice {
            what: "The tangents in the control points are six times too long.",
            change: "Divide by six: d_i = (c_(i+1) - c_(i-1))/6 + c_i, and the power 1/6 for rotations; likewise in e_i.",
        },
        forms: &[Rules { tangent_divisor: 1.0, ..SPLINE }],
        needs_ms: false,
    },
    Model {
        name: "sixth-in-integers",
        advice: Advice {
            what: "The control points are the keyframes themselves: each spline piece is straight and stops at both ends.",
            change: "In C++, 1/6 is 0 in whole numbers: write 1.0/6 in d_i and e_i, and in the exponents of the powers.",
        },
        // A tangent divided by infinity is 0.
        forms: &[Rules { tangent_divisor: f64::INFINITY, ..SPLINE }],
        needs_ms: false,
    },
    Model {
        name: "no-conditional-negation-in-control-points",
        advice: Advice {
            what: "The control points of rotations take the long way round wherever the stored quaternions have opposite signs.",
            change: "In d_i and e_i, negate c_(i+1) * inv(c_(i-1)) and c_(i+2) * inv(c_i) if w is negative, before taking the power.",
        },
        forms: &[Rules { negates_in_control_points: false, ..SPLINE }],
        needs_ms: false,
    },
    Model {
        name: "all-keyframes-played",
        advice: Advice {
            what: "Playing starts at keyframe 0 of the list.",
            change: "Key time 0 is keyframe 1 of the list: the first and the last keyframe only steer the spline.",
        },
        forms: &[Rules { first_keyframe: 0, ..LINEAR }, Rules { first_keyframe: 0, ..SPLINE }],
        needs_ms: false,
    },
    Model {
        name: "one-keyframe-early",
        advice: Advice {
            what: "Playing starts at keyframe 2 of the list: everything comes one keyframe early.",
            change: "Key time 0 is keyframe 1 of the list.",
        },
        forms: &[Rules { first_keyframe: 2, ..LINEAR }, Rules { first_keyframe: 2, ..SPLINE }],
        needs_ms: false,
    },
    Model {
        name: LAST_SAMPLE_MISSING,
        advice: Advice {
            what: "All is right up to the end, and the last pose is never shown.",
            change: "At or past key time n - 1, show the last played keyframe before ending.",
        },
        forms: &[Rules { shows_end: false, ..LINEAR }, Rules { shows_end: false, ..SPLINE }],
        needs_ms: false,
    },
    Model {
        name: "quaternion-order-swapped",
        advice: Advice {
            what: "The components of quaternions stand as x, y, z, w where w, x, y, z belong.",
            change: "Read and print w first.",
        },
        // A program that reads them in the wrong order prints them in it too. Slerp does not notice, control points do.
        forms: &[
            Rules { printed: W_LAST, ..LINEAR },
            Rules { printed: W_LAST, ..SPLINE },
            Rules { read: W_LAST, ..SPLINE },
        ],
        needs_ms: false,
    },
    Model {
        name: "integer-tick",
        advice: Advice {
            what: "The clock counts 16 whole milliseconds a tick, where 60 ticks a second take 1000/60 each: it plays 4 % slow.",
            change: "Divide as floating point: 1000.0/60, or take the time from a clock.",
        },
        forms: &[Rules { pace: INTEGER_TICK_PACE, ..LINEAR }, Rules { pace: INTEGER_TICK_PACE, ..SPLINE }],
        needs_ms: true,
    },
];
