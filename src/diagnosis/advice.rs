//! What each candidate means, in words: what the program does, and what to change.

/// A mistake explained.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Advice {
    /// What the program does: a sentence.
    pub what: &'static str,
    /// What to change; empty where nothing is wrong.
    pub change: &'static str,
}

/// The explanation of a candidate, by its name.
#[must_use]
pub fn advice(name: &str) -> Option<Advice> {
    ADVICE.iter().find(|(known, ..)| *known == name).map(|&(_, what, change)| Advice { what, change })
}

const ADVICE: [(&str, &str, &str); 16] = [
    ("correct", "The samples show the right result of linear playback.", ""),
    ("correct-catmull-rom", "The samples show the right result of Catmull-Rom playback.", ""),
    (
        "no-conditional-negation",
        "Rotations take the long way round wherever the stored quaternions have opposite signs.",
        "Before taking the power, negate all four components of q1 * inv(q0) if its w is negative.",
    ),
    (
        "lerp-for-slerp",
        "The components of the quaternions are blended as they are, so that rotations speed up, slow down and distort.",
        "Interpolate rotations by slerp: cn(q1 * inv(q0))^alpha * q0.",
    ),
    (
        "nlerp-for-slerp",
        "Quaternions are blended and renormalised: the right way round, but not at an even speed.",
        "Interpolate rotations by slerp: cn(q1 * inv(q0))^alpha * q0.",
    ),
    (
        "nan-when-equal",
        "Where a rotation does not change, the sine of the angle is divided by and is 0: the result is no number.",
        "Take the angle by atan2, and where the vector part of the quaternion is 0, let its power be the identity.",
    ),
    (
        "angle-not-halved",
        "The power of a quaternion turns by twice the angle.",
        "A quaternion (cos phi, sin phi k) turns by 2 phi: its power is (cos(alpha phi), sin(alpha phi) k), with phi itself, not 2 phi.",
    ),
    (
        "identity-when-equal",
        "Where a rotation does not change between two keyframes, the identity is shown.",
        "The guard against a zero angle belongs into the power, before the product with q0: slerp of equal rotations is q0.",
    ),
    (
        "second-control-point-on-wrong-keyframe",
        "The second control point of each spline piece starts from the piece's first keyframe.",
        "Build e_i on c_(i+1): e_i = -(c_(i+2) - c_i)/6 + c_(i+1), and the same with powers for rotations.",
    ),
    (
        "no-division-by-six",
        "The tangents in the control points are six times too long.",
        "Divide by six: d_i = (c_(i+1) - c_(i-1))/6 + c_i, and the power 1/6 for rotations; likewise in e_i.",
    ),
    (
        "no-conditional-negation-in-control-points",
        "The control points of rotations take the long way round wherever the stored quaternions have opposite signs.",
        "In d_i and e_i, negate c_(i+1) * inv(c_(i-1)) and c_(i+2) * inv(c_i) if w is negative, before taking the power.",
    ),
    (
        "all-keyframes-played",
        "Playing starts at keyframe 0 of the list.",
        "Key time 0 is keyframe 1 of the list: the first and the last keyframe only steer the spline.",
    ),
    (
        "one-keyframe-early",
        "Playing starts at keyframe 2 of the list: everything comes one keyframe early.",
        "Key time 0 is keyframe 1 of the list.",
    ),
    (
        "last-sample-missing",
        "All is right up to the end, and the last pose is never shown.",
        "At or past key time n - 1, show the last played keyframe before ending.",
    ),
    (
        "quaternion-order-swapped",
        "The components of quaternions stand as x, y, z, w where w, x, y, z belong.",
        "Read and print w first.",
    ),
    (
        "integer-tick",
        "The clock counts 16 whole milliseconds a tick, where 60 ticks a second take 1000/60 each: it plays 4 % slow.",
        "Divide as floating point: 1000.0/60, or take the time from a clock.",
    ),
];

#[cfg(test)]
mod tests {
    use super::super::model::MODELS;
    use super::*;

    #[test]
    fn every_candidate_is_explained() {
        assert!(MODELS.iter().map(|model| model.name).eq(ADVICE.iter().map(|(name, ..)| *name)));
    }
}
