//! The mistakes that came to be known later. A new one is added at the end.

use super::{Change, Mistake};
use crate::diagnosis::rules::{AtZero, Blend, CrossAngle, Divisor, Freezes, Negation, Rules};

pub(super) const ROWS: [Mistake; 11] = [
    Mistake {
        name: "sixth-in-integers-in-rotations",
        what: "The control points of rotations are the keyframes themselves: each turn stops at both ends. Translations are right.",
        change: "In C++, 1/6 is 0 in whole numbers: write 1.0/6 in the exponents of the powers.",
        wrong: "d_i = cn(c_(i+1) * inv(c_(i-1)))^0 * c_i",
        right: "d_i = cn(c_(i+1) * inv(c_(i-1)))^(1/6) * c_i",
        looks: "Bodies move smoothly, and limbs stop at every keyframe.",
        line: "d = pow(cn(c[i+1] * inv(c[i-1])), 1/6) * c[i];",
        revealed_by: "A turn over three keyframes.",
        linear: &[],
        spline: &[|rules| rules.control_points_of_turns(|points| points.share = 0.0)],
    },
    Mistake {
        name: "sixth-in-integers-in-translations",
        what: "The control points of translations are the keyframes themselves: each move stops at both ends. Rotations are right.",
        change: "In C++, 1/6 is 0 in whole numbers: write 1.0/6 in d_i and e_i of translations.",
        wrong: "d_i = 0 (c_(i+1) - c_(i-1)) + c_i",
        right: "d_i = (c_(i+1) - c_(i-1))/6 + c_i",
        looks: "Limbs turn smoothly, and bodies stop at every keyframe.",
        line: "d = (c[i+1] - c[i-1]) * (1/6) + c[i];",
        revealed_by: "A move over three keyframes.",
        linear: &[],
        spline: &[|rules| rules.control_points_of_moves(|points| points.share = 0.0)],
    },
    Mistake {
        name: "small-turns-frozen",
        what: "Turns below a threshold are left out: the rotation stays as it is and jumps at the next keyframe.",
        change: "Take slerp for small angles too. Guard against the angle 0 alone, or blend linearly and renormalise where it is small.",
        wrong: "dot(q0, q1) > 0.9995: q0",
        right: "slerp(q0, q1, a) = cn(q1 * inv(q0))^a * q0",
        looks: "Slow turns stand still and jump once at every keyframe; large turns are right.",
        line: "if (dot > 0.9995) return q0;",
        revealed_by: "A turn of less than 3.6 degrees, and more than the tolerance, between two keyframes.",
        linear: &[|rules| rules.turns.freezes = Freezes::Blends],
        spline: &[|rules| rules.turns.freezes = Freezes::Blends, |rules| rules.turns.freezes = Freezes::Powers],
    },
    Mistake {
        name: "powers-for-slerp",
        what: "The powers of both rotations are multiplied: right only where both turn about the same axis.",
        change: "Take the power of the turn between them: cn(q1 * inv(q0))^alpha * q0.",
        wrong: "q0^(1 - a) * q1^a",
        right: "cn(q1 * inv(q0))^a * q0",
        looks: "Limbs that turn about one axis are right; others leave their path in the middle of the interval.",
        line: "return pow(q0, 1 - a) * pow(q1, a);",
        revealed_by: "A turn about one axis from a rotation about another.",
        linear: &[
            |rules| rules.turns.blend = Blend::Powers { shortened: false },
            |rules| rules.turns.blend = Blend::Powers { shortened: true },
        ],
        spline: &[
            |rules| rules.turns.blend = Blend::Powers { shortened: false },
            |rules| rules.turns.blend = Blend::Powers { shortened: true },
        ],
    },
    Mistake {
        name: "only-w-negated",
        what: "Where the stored quaternions have opposite signs, cn negates w alone: the turn goes about the opposite axis.",
        change: "Negate all four components of the quaternion if its w is negative.",
        wrong: "cn(w, v) = (-w, v) if w < 0",
        right: "cn(w, v) = (-w, -v) if w < 0",
        looks: "Some limbs turn the wrong way and jump at the next keyframe. Other intervals are right.",
        line: "if (q[0] < 0) q[0] = -q[0];",
        revealed_by: "A turn between two keyframes whose stored quaternions have opposite signs, so that q1 * inv(q0) has a negative w.",
        linear: &[|rules| rules.turns.cn_in_blends = Negation::OnlyW],
        spline: &[|rules| {
            rules.turns.cn_in_blends = Negation::OnlyW;
            rules.turns.cn_in_control_points = Negation::OnlyW;
        }],
    },
    Mistake {
        name: "nan-where-the-axis-has-no-x",
        what: "The power divides by the x of the axis, or by each of its parts: a turn about an axis without x is no number.",
        change: "Take the axis by dividing the whole vector part by its length, and the sine from atan2 or the length.",
        wrong: "sin(phi) = x / k_x",
        right: "sin(phi) = |v|",
        looks: "Limbs that turn about their y or z axis vanish, and all that hangs on them.",
        line: "s = q[1] / k[0];",
        revealed_by: "A turn about the y or z axis.",
        linear: &[|rules| rules.turns.divides_by = Divisor::X, |rules| rules.turns.divides_by = Divisor::EachComponent],
        spline: &[|rules| rules.turns.divides_by = Divisor::X, |rules| rules.turns.divides_by = Divisor::EachComponent],
    },
    Mistake {
        name: "second-control-point-on-wrong-keyframe-in-translations",
        what: "The second control point of translations starts from the piece's first keyframe. Rotations are right.",
        change: "Build e_i on c_(i+1): e_i = -(c_(i+2) - c_i)/6 + c_(i+1).",
        wrong: "e_i = -(c_(i+2) - c_i)/6 + c_i",
        right: "e_i = -(c_(i+2) - c_i)/6 + c_(i+1)",
        looks: "Bodies hesitate after each keyframe, then hurry to the next and stop there with a jerk. Limbs turn rightly.",
        line: "e = (c[i+2] - c[i]) * (-1.0/6) + c[i];",
        revealed_by: "A move between two keyframes.",
        linear: &[],
        spline: &[|rules| rules.control_points_of_moves(|points| points.second_base = 1)],
    },
    Mistake {
        name: "translation-weights-swapped",
        what: "The weights of the two translations are swapped: each move runs backwards between its keyframes.",
        change: "Give the first keyframe the weight 1 - alpha, the second alpha.",
        wrong: "a t0 + (1 - a) t1",
        right: "(1 - a) t0 + a t1",
        looks: "Bodies jump ahead to the next keyframe, move back and jump again. Limbs turn rightly.",
        line: "return t0 * a + t1 * (1 - a);",
        revealed_by: "A move between two keyframes.",
        linear: &[|rules| rules.moves.swaps_weights = true],
        spline: &[|rules| rules.moves.swaps_weights = true],
    },
    Mistake {
        name: "tangent-from-wrong-neighbour",
        what: "A tangent is taken between a keyframe and its neighbour, not between the two neighbours: c_i stands for c_(i+1).",
        change: "The tangent at c_i is c_(i+1) - c_(i-1), the one at c_(i+1) is c_(i+2) - c_i.",
        wrong: "d_i = (c_i - c_(i-1))/6 + c_i",
        right: "d_i = (c_(i+1) - c_(i-1))/6 + c_i",
        looks: "Smooth within each interval, with a corner at the keyframes and about half the swing.",
        line: "d = (c[i] - c[i-1]) * (1.0/6) + c[i];",
        revealed_by: "A move and a turn over three keyframes that change their speed or direction.",
        linear: &[],
        // In the first tangent, in both, in the second; of both parts, of rotations, of translations.
        spline: &[
            |rules| rules.control_points(|points| points.first = [1, 0]),
            |rules| {
                rules.control_points(|points| {
                    points.first = [1, 0];
                    points.second = [2, 1];
                });
            },
            |rules| rules.control_points(|points| points.second = [2, 1]),
            |rules| rules.control_points_of_turns(|points| points.first = [1, 0]),
            |rules| {
                rules.control_points_of_turns(|points| {
                    points.first = [1, 0];
                    points.second = [2, 1];
                });
            },
            |rules| rules.control_points_of_turns(|points| points.second = [2, 1]),
            |rules| rules.control_points_of_moves(|points| points.first = [1, 0]),
            |rules| {
                rules.control_points_of_moves(|points| {
                    points.first = [1, 0];
                    points.second = [2, 1];
                });
            },
            |rules| rules.control_points_of_moves(|points| points.second = [2, 1]),
        ],
    },
    Mistake {
        name: "cubic-by-components",
        what: "The spline of rotations is a cubic of the quaternions' four numbers, as for translations.",
        change: "Build the control points of rotations with powers and products, and blend them by slerp in de Casteljau's six steps.",
        wrong: "d_i = (q_(i+1) - q_(i-1))/6 + q_i, and a cubic of the numbers",
        right: "d_i = cn(q_(i+1) * inv(q_(i-1)))^(1/6) * q_i, and six slerps",
        looks: "Almost right where turns are small; limbs distort or spin where they are large or signs differ.",
        line: "q = catmullRom(q0, q1, q2, q3, a);",
        revealed_by: "A turn of 60 degrees or more between two keyframes.",
        linear: &[],
        spline: &[
            |rules| rules.turns.blend = Blend::Components { aligned: false, renormalised: false },
            |rules| rules.turns.blend = Blend::Components { aligned: false, renormalised: true },
            |rules| rules.turns.blend = Blend::Components { aligned: true, renormalised: false },
            |rules| rules.turns.blend = Blend::Components { aligned: true, renormalised: true },
        ],
    },
    Mistake {
        name: "slerp-angle-from-cross-product",
        what: "The angle of slerp comes of the cross product of the vector parts, which is no measure of the turn.",
        change: "Take the angle of the dot product of all four components, or of the turn: atan2(|v|, w) of cn(q1 * inv(q0)).",
        wrong: "omega = atan2(|v0 x v1|, dot(q0, q1))",
        right: "omega = acos(dot(q0, q1))",
        looks: "Limbs that turn about one axis stand still and jump at the next keyframe; others shrink in the middle.",
        line: "omega = atan2(norm(cross(v0, v1)), dot(q0, q1));",
        revealed_by: "Any turn between two keyframes.",
        linear: BY_CROSS_PRODUCT,
        spline: BY_CROSS_PRODUCT,
    },
];

/// The angle by `atan2` or `asin`, with signs aligned or not, with and without a guard against the angle 0.
const BY_CROSS_PRODUCT: &[Change] = &[
    |rules| by_cross_product(rules, false, false, AtZero::First),
    |rules| by_cross_product(rules, false, false, AtZero::Lerp),
    |rules| by_cross_product(rules, false, false, AtZero::NoNumber),
    |rules| by_cross_product(rules, false, true, AtZero::First),
    |rules| by_cross_product(rules, false, true, AtZero::NoNumber),
    |rules| by_cross_product(rules, true, false, AtZero::First),
    |rules| by_cross_product(rules, true, false, AtZero::NoNumber),
    |rules| by_cross_product(rules, true, true, AtZero::First),
];

fn by_cross_product(rules: &mut Rules, by_asin: bool, aligned: bool, at_zero: AtZero) {
    rules.turns.blend = Blend::CrossProduct(CrossAngle { by_asin, aligned, at_zero });
}
