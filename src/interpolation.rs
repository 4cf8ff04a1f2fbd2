//! Interpolation of translations, rotations and rigid body transforms: pure functions, no time, no lists.
//!
//! The fraction `alpha` runs over [0, 1] between two values. Rotations are interpolated by `slerp(q0, q1, α) = (cn(q1 q0⁻¹))^α q0` and
//! smooth motion by Catmull-Rom splines through Bézier control points (Gortler, *Foundations of 3D Computer Graphics*, chapters 7 and 9).
//! Rotations are unit quaternions; either sign of one means the same rotation, and no function here depends on it, except at exactly half a
//! turn, where both directions are right.

use glam::{Quat, Vec3};

use crate::rbt::Rbt;
use crate::words::{self, Argument, Phrase, texts};

/// Which interpolation plays between keyframes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Interpolation {
    /// Translations by lerp, rotations by slerp.
    #[default]
    Linear,
    /// Catmull-Rom splines: smooth in value and in speed through every keyframe.
    CatmullRom,
}

impl Interpolation {
    /// Every interpolation, in the order of the hotkey.
    pub const ALL: [Self; 2] = [Self::Linear, Self::CatmullRom];

    /// The names in files, as a list for error messages: `"linear" or "catmull-rom"`.
    #[must_use]
    pub fn names_quoted() -> Argument {
        words::one_of(&Self::ALL.map(|interpolation| words::quoted(interpolation.name())))
    }

    /// Its name in files and on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::CatmullRom => "catmull-rom",
        }
    }

    /// Its name for people.
    #[must_use]
    pub const fn title(self) -> Phrase {
        match self {
            Self::Linear => texts::BLEND_LINEAR,
            Self::CatmullRom => texts::BLEND_CATMULL_ROM,
        }
    }

    /// The interpolation with this name in files; `None` if there is none.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|candidate| candidate.name() == name)
    }

    /// The next interpolation, cyclically. The hotkey uses it.
    #[must_use]
    pub const fn next(self) -> Self {
        Self::ALL[(self as usize + 1) % Self::ALL.len()]
    }
}

/// Linear interpolation of points: `(1 − α) from + α to`; exact at both ends.
#[must_use]
pub fn lerp(from: Vec3, to: Vec3, alpha: f32) -> Vec3 {
    from * (1.0 - alpha) + to * alpha
}

/// Conditional negation, `cn`: the one of `rotation` and `-rotation` with w ≥ 0, so that a power of it takes the short way. Both are the
/// same rotation.
#[must_use]
pub fn conditionally_negated(rotation: Quat) -> Quat {
    if rotation.w < 0.0 { -rotation } else { rotation }
}

/// The rotation about the same axis by `exponent` times the angle.
///
/// For `(cos φ, sin φ k)` this is `(cos αφ, sin αφ k)`, with φ from `atan2`, so that tiny rotations and half turns are as exact as others.
/// The identity to any power is the identity.
#[must_use]
pub fn power(rotation: Quat, exponent: f32) -> Quat {
    let vector = Vec3::new(rotation.x, rotation.y, rotation.z);
    let sine = vector.length();
    if sine == 0.0 {
        return Quat::IDENTITY;
    }
    let (new_sine, new_cosine) = (exponent * sine.atan2(rotation.w)).sin_cos();
    let vector = vector * (new_sine / sine);
    Quat::from_xyzw(vector.x, vector.y, vector.z, new_cosine)
}

/// Spherical linear interpolation the short way: `(cn(to · from⁻¹))^α · from`. Unit and finite for any unit input.
#[must_use]
pub fn slerp(from: Quat, to: Quat, alpha: f32) -> Quat {
    (power(conditionally_negated(to * from.conjugate()), alpha) * from).normalize()
}

/// The two inner Bézier control points of one piece of a Catmull-Rom spline.
///
/// The piece runs from `c1` to `c2`; `c0` and `c3`, its neighbours, give the tangents.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ControlPoints<V> {
    /// `d`, which follows the piece's start.
    pub after_start: V,
    /// `e`, which precedes the piece's end.
    pub before_end: V,
}

/// The divisors d in tangent = (next − previous) / d: 6 at both ends if all intervals have one length.
///
/// The curve spans the middle one of three intervals of lengths p, q, r. The velocity at its start is `(c2 − c0)/(p + q)` and at its end
/// `(c3 − c1)/(q + r)`; a cubic Bézier curve of length q leaves its start with `3 (d − c1)/q`. So `d = (c2 − c0) q/(3 (p + q)) + c1`, and
/// the speed in seconds is the same on both sides of every keyframe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TangentDivisors {
    /// At the start of the curve.
    pub start: f32,
    /// At the end of the curve.
    pub end: f32,
}

impl TangentDivisors {
    /// For intervals of one length.
    pub const UNIFORM: Self = Self { start: 6.0, end: 6.0 };

    /// The divisors for a curve in the middle one of three intervals of these lengths, all above 0.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "tangents need no more than f32")]
    pub fn of([before, own, after]: [f64; 3]) -> Self {
        Self { start: (3.0 * ((before + own) / own)) as f32, end: (3.0 * ((own + after) / own)) as f32 }
    }
}

/// Control points for translations: `d = (c2 − c0)/6 + c1`, `e = −(c3 − c1)/6 + c2`, if all intervals have one length.
#[must_use]
pub fn translation_control_points([c0, c1, c2, c3]: [Vec3; 4], divisors: TangentDivisors) -> ControlPoints<Vec3> {
    ControlPoints { after_start: (c2 - c0) / divisors.start + c1, before_end: c2 - (c3 - c1) / divisors.end }
}

/// Control points for rotations: `d = (cn(c2 c0⁻¹))^(1/6) c1`, `e = (cn(c3 c1⁻¹))^(−1/6) c2`, if all intervals have one length.
#[must_use]
pub fn rotation_control_points([c0, c1, c2, c3]: [Quat; 4], divisors: TangentDivisors) -> ControlPoints<Quat> {
    let part = |to: Quat, from: Quat, exponent: f32| power(conditionally_negated(to * from.conjugate()), exponent);
    ControlPoints {
        after_start: (part(c2, c0, 1.0 / divisors.start) * c1).normalize(),
        before_end: (part(c3, c1, -1.0 / divisors.end) * c2).normalize(),
    }
}

/// Control points for both parts of rigid body transforms.
#[must_use]
pub fn rbt_control_points(c: [Rbt; 4], divisors: TangentDivisors) -> ControlPoints<Rbt> {
    let translation = translation_control_points(c.map(|rbt| rbt.translation), divisors);
    let rotation = rotation_control_points(c.map(|rbt| rbt.rotation), divisors);
    ControlPoints {
        after_start: Rbt::new(translation.after_start, rotation.after_start),
        before_end: Rbt::new(translation.before_end, rotation.before_end),
    }
}

/// The cubic Bézier curve through `start` and `end` by de Casteljau's six blends.
fn de_casteljau<V: Copy>(start: V, inner: ControlPoints<V>, end: V, alpha: f32, blend: impl Fn(V, V, f32) -> V) -> V {
    let start_inner = blend(start, inner.after_start, alpha);
    let middle = blend(inner.after_start, inner.before_end, alpha);
    let inner_end = blend(inner.before_end, end, alpha);
    blend(blend(start_inner, middle, alpha), blend(middle, inner_end, alpha), alpha)
}

/// A point of the cubic Bézier curve of `start`, the inner points and `end`.
#[must_use]
pub fn bezier_translation(start: Vec3, inner: ControlPoints<Vec3>, end: Vec3, alpha: f32) -> Vec3 {
    de_casteljau(start, inner, end, alpha, lerp)
}

/// A rotation on the cubic Bézier curve of `start`, the inner rotations and `end`, with slerp for lerp.
#[must_use]
pub fn bezier_rotation(start: Quat, inner: ControlPoints<Quat>, end: Quat, alpha: f32) -> Quat {
    de_casteljau(start, inner, end, alpha, slerp)
}

/// Linear interpolation of rigid body transforms: translations by [`lerp`], rotations by [`slerp`].
#[must_use]
pub fn linear_rbt(from: Rbt, to: Rbt, alpha: f32) -> Rbt {
    Rbt::new(lerp(from.translation, to.translation, alpha), slerp(from.rotation, to.rotation, alpha))
}

/// A transform on the cubic Bézier curve, its two parts apart.
#[must_use]
pub fn bezier_rbt(start: Rbt, inner: ControlPoints<Rbt>, end: Rbt, alpha: f32) -> Rbt {
    let ControlPoints { after_start, before_end } = inner;
    let translations = ControlPoints { after_start: after_start.translation, before_end: before_end.translation };
    let rotations = ControlPoints { after_start: after_start.rotation, before_end: before_end.rotation };
    Rbt::new(
        bezier_translation(start.translation, translations, end.translation, alpha),
        bezier_rotation(start.rotation, rotations, end.rotation, alpha),
    )
}

/// Normalised linear interpolation: negates one quaternion if the dot product is negative, blends linearly, and normalises.
///
/// It takes the same path as [`slerp`] at an uneven speed. Used only to compare, never to play.
#[must_use]
pub fn nlerp(from: Quat, to: Quat, alpha: f32) -> Quat {
    let to = if from.dot(to) < 0.0 { -to } else { to };
    (from * (1.0 - alpha) + to * alpha).normalize()
}
