//! What a program with given rules shows between keyframes, in double precision.

use glam::{DQuat, DVec3, DVec4};

use super::choices::Choices;
use super::rules::{AtZero, Blend, ControlPoints, CrossAngle, Divisor, Freezes, Moves, Negation, Turns, WhenEqual};

/// If the absolute w of a rotation is below this, it is half a turn and rounding decides the direction.
const HALF_TURN: f64 = 1e-6;
/// A rotation is the identity if the sine of half its angle is below this.
const NO_TURN: f64 = 1e-7;
/// A rotation whose sine is below this has no axis but rounding's.
const NOTHING: f64 = 1e-12;
/// Up to this sine of half its angle, rounding in single precision decides whether a rotation is the identity: its cosine is 1 − 2⁻²³.
const PERHAPS_NO_TURN: f64 = 5e-4;
/// Up to this, rounding in single precision decides whether a component of a turn is 0.
const PERHAPS_ZERO: f64 = 1e-6;

const NO_NUMBER: DQuat = DQuat::from_xyzw(f64::NAN, f64::NAN, f64::NAN, f64::NAN);

/// Half the angle below which a program leaves a turn out, in radians.
#[derive(Clone, Copy, Debug)]
pub(super) struct Threshold {
    /// The threshold.
    pub half_angle: f64,
    /// The smallest half angle at or above it that was met: with a threshold up to it, the result is the same.
    pub next: f64,
}

impl Threshold {
    /// A threshold, in radians of half the angle.
    pub const fn at(half_angle: f64) -> Self {
        Self { half_angle, next: f64::INFINITY }
    }

    /// A threshold that the samples show; otherwise the usual one, a dot product of 0.9995.
    pub fn known(half_angle: Option<f64>) -> Self {
        Self::at(half_angle.unwrap_or(0.031_62))
    }

    fn freezes(&mut self, turn: DQuat) -> bool {
        let half_angle = sine(turn).atan2(turn.w);
        if half_angle >= self.half_angle {
            self.next = self.next.min(half_angle);
        }
        half_angle < self.half_angle
    }
}

/// The translation at the fraction `alpha` from the second to the third of four keyframes.
pub(super) fn translation(c: [DVec3; 4], alpha: f64, rules: &Moves) -> DVec3 {
    let alpha = if rules.swaps_weights { 1.0 - alpha } else { alpha };
    let lerp = |from: DVec3, to: DVec3| from.lerp(to, alpha);
    match rules.spline {
        None => lerp(c[1], c[2]),
        Some(points) => {
            let tangent = |[to, from]: [usize; 2]| (c[to] - c[from]) * points.share;
            let inner = [c[1] + tangent(points.first), c[points.second_base] - tangent(points.second)];
            de_casteljau([c[1], inner[0], inner[1], c[2]], lerp)
        }
    }
}

/// How rotations turn: the rules, and what they meet.
pub(super) struct Turning<'a> {
    /// The rules.
    pub rules: &'a Turns,
    /// Whether rounding decides more than half turns.
    pub is_lenient: bool,
    /// The ways at the choices that rounding makes.
    pub choices: Choices,
    /// The threshold of turns that are left out.
    pub threshold: Threshold,
}

impl Turning<'_> {
    /// The rotation at the fraction `alpha` from the second to the third of four keyframes.
    pub fn rotation(&mut self, c: [DQuat; 4], alpha: f64) -> DQuat {
        let Some(points) = self.rules.spline else { return self.blend(c[1], c[2], alpha) };
        if let Blend::Components { aligned, renormalised } = self.rules.blend {
            return components(c, alpha, &points, aligned, renormalised);
        }
        let first = self.tangent(c, points.first, points.share) * c[1];
        let second = self.tangent(c, points.second, -points.share) * c[points.second_base];
        de_casteljau([c[1], first, second, c[2]], |from, to| self.blend(from, to, alpha))
    }

    fn tangent(&mut self, c: [DQuat; 4], [to, from]: [usize; 2], exponent: f64) -> DQuat {
        let turn = self.short_way(c[to] * c[from].conjugate(), self.rules.cn_in_control_points);
        if self.rules.freezes == Freezes::Powers && self.threshold.freezes(turn) {
            return DQuat::IDENTITY;
        }
        self.power(turn, exponent)
    }

    fn blend(&mut self, from: DQuat, to: DQuat, alpha: f64) -> DQuat {
        match self.rules.blend {
            Blend::Lerp | Blend::Components { .. } => from * (1.0 - alpha) + to * alpha,
            Blend::Nlerp => {
                let dot = from.dot(to);
                let is_far = match self.rules.cn_in_blends {
                    Negation::Nothing => false,
                    _ if dot.abs() < HALF_TURN => self.choices.pick(),
                    _ => dot < 0.0,
                };
                let to = if is_far { -to } else { to };
                let blended = from * (1.0 - alpha) + to * alpha;
                blended * blended.length().recip()
            }
            Blend::Powers { shortened } => {
                let negation = if shortened { Negation::All } else { Negation::Nothing };
                let [from, to] = [from, to].map(|rotation| self.short_way(rotation, negation));
                self.power(from, 1.0 - alpha) * self.power(to, alpha)
            }
            Blend::CrossProduct(angle) => self.by_cross_product(from, to, alpha, angle),
            Blend::Slerp => {
                let turn = self.short_way(to * from.conjugate(), self.rules.cn_in_blends);
                if self.rules.when_equal == WhenEqual::Identity && self.is_no_turn(sine(turn)) {
                    return DQuat::IDENTITY;
                }
                if self.rules.freezes != Freezes::Nowhere && self.threshold.freezes(turn) {
                    return from;
                }
                self.power(turn, alpha) * from
            }
        }
    }

    /// `cn`. At half a turn rounding decides the direction.
    fn short_way(&mut self, turn: DQuat, negation: Negation) -> DQuat {
        let mut is_long = || if turn.w.abs() < HALF_TURN { self.choices.pick() } else { turn.w < 0.0 };
        match negation {
            Negation::Nothing => turn,
            Negation::All => {
                if is_long() {
                    -turn
                } else {
                    turn
                }
            }
            Negation::OnlyW => DQuat { w: turn.w.abs(), ..turn },
        }
    }

    fn is_no_turn(&mut self, sine: f64) -> bool {
        if self.is_lenient { sine < PERHAPS_NO_TURN && self.choices.pick() } else { sine < NO_TURN }
    }

    fn power(&mut self, turn: DQuat, exponent: f64) -> DQuat {
        let sine = sine(turn);
        let has_no_number = self.rules.when_equal == WhenEqual::NoNumber && self.is_no_turn(sine);
        let components: &[f64] = match self.rules.divides_by {
            Divisor::Length => &[],
            Divisor::X => &[turn.x],
            Divisor::EachComponent => &[turn.x, turn.y, turn.z],
        };
        let divides_by_zero = sine > NO_TURN && components.iter().any(|component| self.is_zero(*component));
        if has_no_number || divides_by_zero {
            return NO_NUMBER;
        }
        if sine < NOTHING {
            return DQuat::IDENTITY;
        }
        let (new_sine, new_cosine) = (self.rules.angle_factor * exponent * sine.atan2(turn.w)).sin_cos();
        let vector = DVec3::new(turn.x, turn.y, turn.z) * (new_sine / sine);
        DQuat::from_xyzw(vector.x, vector.y, vector.z, new_cosine)
    }

    /// Whether a component of a turn is 0.
    fn is_zero(&mut self, component: f64) -> bool {
        if self.is_lenient { component.abs() < PERHAPS_ZERO && self.choices.pick() } else { component.abs() < NO_TURN }
    }

    fn by_cross_product(&mut self, from: DQuat, to: DQuat, alpha: f64, angle: CrossAngle) -> DQuat {
        let to = if angle.aligned && from.dot(to) < 0.0 { -to } else { to };
        let cross = from.xyz().cross(to.xyz()).length();
        let angle_between = if angle.by_asin { cross.min(1.0).asin() } else { cross.atan2(from.dot(to)) };
        let sine = angle_between.sin();
        let is_zero = sine < NO_TURN || (self.is_lenient && sine < PERHAPS_NO_TURN && self.choices.pick());
        match angle.at_zero {
            AtZero::First if is_zero => return from,
            AtZero::Lerp if is_zero => return from * (1.0 - alpha) + to * alpha,
            AtZero::NoNumber if is_zero => return NO_NUMBER,
            _ => {}
        }
        (from * ((1.0 - alpha) * angle_between).sin() + to * (alpha * angle_between).sin()) * sine.recip()
    }
}

/// Four quaternions as points in space: a cubic of each component.
fn components(c: [DQuat; 4], alpha: f64, points: &ControlPoints, aligned: bool, renormalised: bool) -> DQuat {
    let c = c.map(|rotation| {
        let is_far = aligned && rotation.dot(c[1]) < 0.0;
        DVec4::from(if is_far { -rotation } else { rotation })
    });
    let tangent = |[to, from]: [usize; 2]| (c[to] - c[from]) * points.share;
    let inner = [c[1] + tangent(points.first), c[points.second_base] - tangent(points.second)];
    let blended = de_casteljau([c[1], inner[0], inner[1], c[2]], |from, to| from.lerp(to, alpha));
    DQuat::from_vec4(if renormalised { blended / blended.length() } else { blended })
}

/// Bézier's cubic by de Casteljau's six blends.
fn de_casteljau<V: Copy>([a, b, c, d]: [V; 4], mut blend: impl FnMut(V, V) -> V) -> V {
    let (ab, bc, cd) = (blend(a, b), blend(b, c), blend(c, d));
    let (abc, bcd) = (blend(ab, bc), blend(bc, cd));
    blend(abc, bcd)
}

/// The sine of half the angle.
fn sine(turn: DQuat) -> f64 {
    turn.xyz().length()
}
