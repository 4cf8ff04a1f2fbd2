//! The rules by which a program plays: when which keyframes are shown, along which paths nodes move, and how they turn.
//!
//! A known mistake changes some of them. Translations and rotations have rules of their own, so that what is computed for one mistake
//! serves every other that leaves that part alone.

/// How a program plays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rules {
    /// Which moment of the keyframes it shows.
    pub timing: Timing,
    /// How it interpolates translations.
    pub moves: Moves,
    /// How it interpolates rotations.
    pub turns: Turns,
}

/// Which moment of the keyframes is shown at a key time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Timing {
    /// Index of the keyframe at key time 0; right is 1.
    pub first_keyframe: usize,
    /// Speed of playback; right is 1.
    pub pace: f64,
    /// Whether the last pose is shown.
    pub shows_end: bool,
}

/// How the control points of a spline piece are made of the four keyframes c(i−1), c(i), c(i+1), c(i+2), counted from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ControlPoints {
    /// The share of a tangent that a control point is away from its base; right is 1/6.
    pub share: f64,
    /// The two keyframes whose difference is the first tangent: to, from; right is 2, 0.
    pub first: [usize; 2],
    /// The two keyframes whose difference is the second tangent; right is 3, 1.
    pub second: [usize; 2],
    /// The keyframe that the second control point is built on; right is 2.
    pub second_base: usize,
}

/// How translations are interpolated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Moves {
    /// The control points of a spline; without them, lerp.
    pub spline: Option<ControlPoints>,
    /// Whether the two weights of a lerp are the wrong way round.
    pub swaps_weights: bool,
}

/// How rotations are interpolated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Turns {
    /// The control points of a spline; without them, one blend.
    pub spline: Option<ControlPoints>,
    /// The blend of two rotations.
    pub blend: Blend,
    /// What `cn` does in a blend.
    pub cn_in_blends: Negation,
    /// What `cn` does in the powers of control points.
    pub cn_in_control_points: Negation,
    /// Factor on the angle in a power of a quaternion; right is 1.
    pub angle_factor: f64,
    /// What comes of a turn by nothing.
    pub when_equal: WhenEqual,
    /// What of the axis is divided by: a turn is NaN where it is 0.
    pub divides_by: Divisor,
    /// Where turns below a threshold are left out.
    pub freezes: Freezes,
    /// Printed order: for each column, the index of its component in w, x, y, z.
    pub printed: [usize; 4],
    /// Order in which components were read from the keyframe file: for each of w, x, y, z, the index of the number taken.
    pub read: [usize; 4],
}

/// How a program blends two rotations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Blend {
    /// `cn(q1 * inv(q0))^alpha * q0`: right.
    Slerp,
    /// A linear blend of the stored components, not renormalised.
    Lerp,
    /// A linear blend of the components, renormalised. One side is negated if the dot product is negative, unless `cn` is left out.
    Nlerp,
    /// `q0^(1 - alpha) * q1^alpha`.
    Powers {
        /// Whether both go through `cn` first.
        shortened: bool,
    },
    /// `(sin((1 - alpha) w) q0 + sin(alpha w) q1) / sin w`, w of the cross product of the vector parts.
    CrossProduct(CrossAngle),
    /// Of splines alone: the components are four numbers, control points included.
    Components {
        /// Whether the four keyframes are first given the sign that is nearer to c(i).
        aligned: bool,
        /// Whether the result is renormalised.
        renormalised: bool,
    },
}

/// How an angle is taken of a cross product c of the vector parts, and what is shown where it is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CrossAngle {
    /// `asin(|c|)`; otherwise `atan2(|c|, dot)` with the dot product of the quaternions.
    pub by_asin: bool,
    /// Whether the second rotation is first given the sign that is nearer to the first.
    pub aligned: bool,
    /// What is shown where the angle is 0.
    pub at_zero: AtZero,
}

/// What is shown where an angle is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum AtZero {
    /// The first rotation.
    First,
    /// A linear blend.
    Lerp,
    /// NaN.
    NoNumber,
}

/// What `cn` negates where w is negative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Negation {
    /// All four components: right.
    All,
    /// w alone.
    OnlyW,
    /// Nothing.
    Nothing,
}

/// What comes of a turn by nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum WhenEqual {
    /// The power is the identity: right.
    Right,
    /// The power is NaN: 0/0.
    NoNumber,
    /// The whole blend is the identity.
    Identity,
}

/// What of a turn's axis is divided by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Divisor {
    /// Its length: right.
    Length,
    /// Its x.
    X,
    /// Each of its components.
    EachComponent,
}

/// Where turns below a threshold are left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Freezes {
    /// Nowhere: right.
    Nowhere,
    /// In blends.
    Blends,
    /// In every power: those of control points too.
    Powers,
}

const IN_ORDER: [usize; 4] = [0, 1, 2, 3];
/// x, y, z, w instead of w, x, y, z.
pub(super) const W_LAST: [usize; 4] = [1, 2, 3, 0];

const CONTROL_POINTS: ControlPoints = ControlPoints { share: 1.0 / 6.0, first: [2, 0], second: [3, 1], second_base: 2 };

/// Right linear playback.
pub(super) const LINEAR: Rules = Rules {
    timing: Timing { first_keyframe: 1, pace: 1.0, shows_end: true },
    moves: Moves { spline: None, swaps_weights: false },
    turns: Turns {
        spline: None,
        blend: Blend::Slerp,
        cn_in_blends: Negation::All,
        cn_in_control_points: Negation::All,
        angle_factor: 1.0,
        when_equal: WhenEqual::Right,
        divides_by: Divisor::Length,
        freezes: Freezes::Nowhere,
        printed: IN_ORDER,
        read: IN_ORDER,
    },
};

/// Right Catmull-Rom playback.
pub(super) const SPLINE: Rules = Rules {
    moves: Moves { spline: Some(CONTROL_POINTS), ..LINEAR.moves },
    turns: Turns { spline: Some(CONTROL_POINTS), ..LINEAR.turns },
    ..LINEAR
};

/// Speed of a clock that counts 16 ms where a tick lasts 1000/60 ms.
pub(super) const INTEGER_TICK_PACE: f64 = 16.0 * 60.0 / 1000.0;

impl Turns {
    /// Whether rounding decides in more than half turns: it does where a special case of exact numbers is met.
    pub fn rounding_decides(&self) -> bool {
        self.when_equal != WhenEqual::Right
            || self.divides_by != Divisor::Length
            || matches!(self.blend, Blend::CrossProduct(_))
    }
}

impl Rules {
    /// The control points of translations and of rotations, of rules for splines.
    pub fn control_points(&mut self, change: impl Fn(&mut ControlPoints)) {
        self.control_points_of_moves(&change);
        self.control_points_of_turns(&change);
    }

    /// The control points of translations, of rules for splines.
    pub fn control_points_of_moves(&mut self, change: impl Fn(&mut ControlPoints)) {
        self.moves.spline.iter_mut().for_each(change);
    }

    /// The control points of rotations, of rules for splines.
    pub fn control_points_of_turns(&mut self, change: impl Fn(&mut ControlPoints)) {
        self.turns.spline.iter_mut().for_each(change);
    }
}
