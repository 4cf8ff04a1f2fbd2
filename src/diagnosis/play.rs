//! The output of a program with given rules at a key time, in double precision, and its distance from a sample.
//!
//! If correct programs may differ, or rounding decides, the value nearest to the sample is used: at half a turn either direction; at a
//! whole key time the end of one interval or the start of the next (a mistake can make them differ); at the end also the last keyframe
//! itself. After the end a program shows its last pose.

use glam::{DQuat, DVec3};
use thiserror::Error;

use super::DISTANCE_OF_NO_NUMBER;
use super::model::{Blend, Rules, WhenEqual};
use super::samples::Row;
use crate::keyframe::Keyframe;
use crate::pose::RbtIndex;

/// If the absolute w of a rotation is below this, it is half a turn and rounding decides the direction.
const HALF_TURN: f64 = 1e-6;
/// A rotation is the identity if the sine of half its angle is below this.
const NO_TURN: f64 = 1e-7;
/// Key times within this of a whole number are equal to it: they are printed with six decimals.
pub(super) const WHOLE: f64 = 1e-6;

/// Upper bound of a squared distance, so that residuals are finite.
const LARGEST_SQUARE: f64 = 1e60;

/// The fewest keyframes that can be played.
const FEWEST: usize = 4;

/// There are not enough keyframes to play.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("{found} keyframes cannot be played: the first and the last only steer, so at least 4 are needed")]
pub struct TooFewKeyframes {
    /// The number of keyframes.
    pub found: usize,
}

/// One node's transform in its parent's space.
#[derive(Clone, Copy, Debug)]
struct Transform {
    translation: DVec3,
    rotation: DQuat,
}

/// The keyframes to play, at least 4, in double precision, their rotations of unit length with the stored signs.
#[derive(Clone, Debug)]
pub struct Sequence {
    keyframes: Vec<Vec<Transform>>,
}

impl Sequence {
    /// The keyframes of a list.
    ///
    /// # Errors
    /// [`TooFewKeyframes`]
    pub fn new(keyframes: &[Keyframe]) -> Result<Self, TooFewKeyframes> {
        if keyframes.len() < FEWEST {
            return Err(TooFewKeyframes { found: keyframes.len() });
        }
        let pose = |keyframe: &Keyframe| {
            let rbts = keyframe.pose.iter();
            rbts.map(|rbt| Transform {
                translation: rbt.translation.as_dvec3(),
                rotation: rbt.rotation.as_dquat().normalize(),
            })
            .collect()
        };
        Ok(Self { keyframes: keyframes.iter().map(pose).collect() })
    }

    /// The key time of the last played keyframe: n − 1.
    #[must_use]
    pub fn last_key_time(&self) -> f64 {
        (self.keyframes.len() - 3) as f64
    }

    /// One node of a keyframe. The index is clamped to the list.
    fn at(&self, index: isize, node: RbtIndex, rules: &Rules) -> Transform {
        let last = self.keyframes.len() as isize - 1;
        let Transform { translation, rotation } = self.keyframes[index.clamp(0, last) as usize][node.get()];
        Transform { translation, rotation: quaternion(reordered(rotation, rules.read)) }
    }
}

/// Reorders components: entry i is component `order[i]` of w, x, y, z.
fn reordered(rotation: DQuat, order: [usize; 4]) -> [f64; 4] {
    let [x, y, z, w] = rotation.to_array();
    order.map(|component| [w, x, y, z][component])
}

fn quaternion([w, x, y, z]: [f64; 4]) -> DQuat {
    DQuat::from_xyzw(x, y, z, w)
}

/// The direction at half a turn: in the blend of two keyframes or the first control point, and in the second control point.
#[derive(Clone, Copy, Debug, Default)]
struct Ways {
    first: bool,
    second: bool,
}

const WAYS: [Ways; 4] = [
    Ways { first: false, second: false },
    Ways { first: true, second: false },
    Ways { first: false, second: true },
    Ways { first: true, second: true },
];

/// The squared distance of a row from the prediction of the rules. A program that does not show its end stays at the key time
/// `last_before_end`.
pub(super) fn distance_squared(sequence: &Sequence, last_before_end: f64, row: &Row, rules: &Rules) -> f64 {
    let mut key_time = row.key_time;
    if !rules.shows_end && key_time > sequence.last_key_time() - WHOLE {
        key_time = last_before_end;
    }
    let first = rules.first_keyframe as f64;
    // A program that plays one end of the list plays the other end too.
    let last = (sequence.keyframes.len() - if rules.first_keyframe == 1 { 2 } else { 1 }) as f64;
    let position = (key_time * rules.pace + first).clamp(first, last);
    let mut nearest = f64::INFINITY;
    let mut consider = |shown: Transform| nearest = nearest.min(distance_of(row, &shown, rules));
    let is_end = position > last - WHOLE;
    if is_end {
        consider(sequence.at(last as isize, row.node, rules));
    }
    let start = position.floor();
    let mut starts = [Some(start), None];
    if (position - position.round()).abs() < WHOLE {
        let whole = position.round();
        // A spline that starts at the end has no keyframe after it; a linear blend needs none.
        let follows = !(is_end && rules.is_spline);
        starts = [(whole > first).then_some(whole - 1.0), follows.then_some(whole)];
    }
    for start in starts.into_iter().flatten() {
        let corners = [-1, 0, 1, 2].map(|offset| sequence.at(start as isize + offset, row.node, rules));
        let alpha = position - start;
        for ways in ways_worth_trying(&corners, rules) {
            for shown in shown(&corners, alpha, rules, ways) {
                consider(shown);
            }
        }
    }
    nearest
}

fn ways_worth_trying(corners: &[Transform; 4], rules: &Rules) -> impl Iterator<Item = Ways> + use<> {
    let is_half_turn =
        |to: usize, from: usize| (corners[to].rotation * corners[from].rotation.conjugate()).w.abs() < HALF_TURN;
    let (first, second) =
        if rules.is_spline { (is_half_turn(2, 0), is_half_turn(3, 1)) } else { (is_half_turn(2, 1), false) };
    WAYS.into_iter().filter(move |ways| (first || !ways.first) && (second || !ways.second))
}

/// The prediction at the fraction `alpha` from the second to the third of four keyframes; two values if rounding decides.
fn shown(corners: &[Transform; 4], alpha: f64, rules: &Rules, ways: Ways) -> impl Iterator<Item = Transform> {
    let at = |when_equal| {
        let rules = Rules { when_equal, ..*rules };
        if rules.is_spline { spline(corners, alpha, &rules, ways) } else { line(corners, alpha, &rules, ways) }
    };
    let (one, other) = match rules.when_equal {
        WhenEqual::PerhapsNoNumber => (at(WhenEqual::NoNumber), Some(at(WhenEqual::Right))),
        when_equal => (at(when_equal), None),
    };
    std::iter::once(one).chain(other)
}

fn line([_, from, to, _]: &[Transform; 4], alpha: f64, rules: &Rules, ways: Ways) -> Transform {
    Transform {
        translation: from.translation.lerp(to.translation, alpha),
        rotation: blend(from.rotation, to.rotation, alpha, rules, ways.first),
    }
}

fn spline(corners: &[Transform; 4], alpha: f64, rules: &Rules, ways: Ways) -> Transform {
    let c = corners.map(|corner| corner.translation);
    let inner =
        [(c[2] - c[0]) / rules.tangent_divisor + c[1], c[rules.second_base] - (c[3] - c[1]) / rules.tangent_divisor];
    let translation = de_casteljau([c[1], inner[0], inner[1], c[2]], |from, to| from.lerp(to, alpha));
    let c = corners.map(|corner| corner.rotation);
    let tangent = |to: DQuat, from: DQuat, sign: f64, way| {
        let turn = to * from.conjugate();
        let turn = if rules.negates_in_control_points { short_way(turn, way) } else { turn };
        power(turn, sign / rules.tangent_divisor, rules)
    };
    let inner =
        [tangent(c[2], c[0], 1.0, ways.first) * c[1], tangent(c[3], c[1], -1.0, ways.second) * c[rules.second_base]];
    let rotation = de_casteljau([c[1], inner[0], inner[1], c[2]], |from, to| blend(from, to, alpha, rules, false));
    Transform { translation, rotation }
}

/// Bézier's cubic by de Casteljau's six blends.
fn de_casteljau<V: Copy>([a, b, c, d]: [V; 4], blend: impl Fn(V, V) -> V) -> V {
    let (ab, bc, cd) = (blend(a, b), blend(b, c), blend(c, d));
    blend(blend(ab, bc), blend(bc, cd))
}

fn blend(from: DQuat, to: DQuat, alpha: f64, rules: &Rules, way: bool) -> DQuat {
    match rules.blend {
        Blend::Lerp => from * (1.0 - alpha) + to * alpha,
        Blend::Nlerp => {
            let dot = from.dot(to);
            let is_far = if dot.abs() < HALF_TURN { way } else { dot < 0.0 };
            let to = if is_far { -to } else { to };
            let blended = from * (1.0 - alpha) + to * alpha;
            blended * blended.length().recip()
        }
        Blend::Slerp => {
            let turn = to * from.conjugate();
            let turn = if rules.negates_in_blends { short_way(turn, way) } else { turn };
            if rules.when_equal == WhenEqual::Identity && sine(turn) < NO_TURN {
                return DQuat::IDENTITY;
            }
            power(turn, alpha, rules) * from
        }
    }
}

/// The one of a rotation and its negative with w ≥ 0; at half a turn, `way` decides.
fn short_way(turn: DQuat, way: bool) -> DQuat {
    let is_long = if turn.w.abs() < HALF_TURN { way } else { turn.w < 0.0 };
    if is_long { -turn } else { turn }
}

/// The sine of half the angle.
fn sine(turn: DQuat) -> f64 {
    DVec3::new(turn.x, turn.y, turn.z).length()
}

fn power(turn: DQuat, exponent: f64, rules: &Rules) -> DQuat {
    let sine = sine(turn);
    if sine < NO_TURN && rules.when_equal == WhenEqual::NoNumber {
        return DQuat::from_xyzw(f64::NAN, f64::NAN, f64::NAN, f64::NAN);
    }
    if sine == 0.0 {
        return DQuat::IDENTITY;
    }
    let (new_sine, new_cosine) = (rules.angle_factor * exponent * sine.atan2(turn.w)).sin_cos();
    let vector = DVec3::new(turn.x, turn.y, turn.z) * (new_sine / sine);
    DQuat::from_xyzw(vector.x, vector.y, vector.z, new_cosine)
}

/// The squared distance of a row from a prediction.
fn distance_of(row: &Row, shown: &Transform, rules: &Rules) -> f64 {
    let printed = reordered(shown.rotation, rules.printed);
    let off = |sign: f64| {
        let squares = row.rotation_wxyz.iter().zip(printed).map(|(sample, shown)| (sample - sign * shown).powi(2));
        squares.sum::<f64>()
    };
    let translation = match (row.translation.is_finite(), shown.translation.is_finite()) {
        (true, true) => row.translation.distance_squared(shown.translation),
        (false, false) => 0.0,
        _ => DISTANCE_OF_NO_NUMBER.powi(2),
    };
    let is_number = |rotation: &[f64; 4]| rotation.iter().all(|component| component.is_finite());
    let rotation = match (is_number(&row.rotation_wxyz), is_number(&printed)) {
        (true, true) => off(1.0).min(off(-1.0)),
        (false, false) => 0.0,
        _ => DISTANCE_OF_NO_NUMBER.powi(2),
    };
    (translation + rotation).min(LARGEST_SQUARE)
}
