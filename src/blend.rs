//! Blends of whole poses, sixteen nodes at a time, with the results of [`crate::interpolation`] within rounding.
//!
//! Between two keyframes every node has the same fraction α. So both weights of `slerp`, `sin((1 − α)θ)/sin θ` and `sin(αθ)/sin θ`, are
//! functions of `|cos θ|` alone for the whole pose. [`Weights`] fits a polynomial of degree 9 to each of them once per pose. Each node then
//! takes only products and sums. Rotations differ from those of `slerp` in exact arithmetic by less than 3e-7 radians, on a Catmull-Rom
//! spline by less than 5e-7, and are as near to unit length. On processors without fused multiplication and addition it is 3.5e-7, near
//! half a turn.
//!
//! The widest instruction set of the processor is chosen at run time. The sets with fused multiplication and addition (AVX2, AVX-512, NEON)
//! agree with each other to the bit.

#![expect(clippy::inline_always, reason = "what is not inlined is compiled for the oldest processor")]

mod compose;
mod skin;
mod weights;

use fearless_simd::prelude::*;
use fearless_simd::{dispatch, f32x16};

use crate::pose::RbtBlock;

pub use compose::{AlignedAffine, MatrixBlock, compose, matrices};
pub use fearless_simd::Level;
pub use skin::{SkinVertices, SkinnedVertex, skin};
pub use weights::Weights;

/// The widest instructions that this processor has.
#[must_use]
pub fn widest() -> Level {
    Level::new()
}

/// Translations by `lerp`, rotations by `slerp`, from one pose to another. Slices should have one length; elements beyond the shortest are
/// left unchanged.
pub fn linear(level: Level, weights: &Weights, from: &[RbtBlock], to: &[RbtBlock], into: &mut [RbtBlock]) {
    dispatch!(level, simd => linear_with(simd, weights, from, to, into));
}

/// The four control points of the Bézier curves of all nodes.
#[derive(Clone, Copy, Debug)]
pub struct Curves<'a> {
    /// The start points.
    pub start: &'a [RbtBlock],
    /// The control points after the start.
    pub after_start: &'a [RbtBlock],
    /// The control points before the end.
    pub before_end: &'a [RbtBlock],
    /// The end points.
    pub end: &'a [RbtBlock],
}

/// Points on cubic Bézier curves by de Casteljau's six blends. Slices should have one length; elements beyond the shortest are left
/// unchanged.
pub fn bezier(level: Level, weights: &Weights, curves: Curves<'_>, into: &mut [RbtBlock]) {
    dispatch!(level, simd => bezier_with(simd, weights, curves, into));
}

// The functions below are compiled once for each instruction set. Each must be inlined into a function that `dispatch` makes. Closures are
// not inlined: their code would be compiled for the oldest processor.

/// One component of sixteen nodes.
type Lanes<S> = f32x16<S>;

#[inline(always)]
fn linear_with<S: Simd>(simd: S, weights: &Weights, from: &[RbtBlock], to: &[RbtBlock], into: &mut [RbtBlock]) {
    let by = Fitted::new(simd, weights);
    for ((from, to), into) in from.iter().zip(to).zip(into) {
        Transforms::load(simd, from).blended(simd, &by, Transforms::load(simd, to)).store(into);
    }
}

#[inline(always)]
fn bezier_with<S: Simd>(simd: S, weights: &Weights, curves: Curves<'_>, into: &mut [RbtBlock]) {
    let by = Fitted::new(simd, weights);
    let inner = curves.after_start.iter().zip(curves.before_end);
    for (((start, end), (after_start, before_end)), into) in curves.start.iter().zip(curves.end).zip(inner).zip(into) {
        let after_start = Transforms::load(simd, after_start);
        let before_end = Transforms::load(simd, before_end);
        let start_inner = Transforms::load(simd, start).blended(simd, &by, after_start);
        let middle = after_start.blended(simd, &by, before_end);
        let inner_end = before_end.blended(simd, &by, Transforms::load(simd, end));
        let early = start_inner.blended(simd, &by, middle);
        early.blended(simd, &by, middle.blended(simd, &by, inner_end)).store(into);
    }
}

/// The fraction, and the polynomials of its weights.
struct Fitted<'a, S: Simd> {
    alpha: Lanes<S>,
    weights: &'a Weights,
}

impl<'a, S: Simd> Fitted<'a, S> {
    #[inline(always)]
    fn new(simd: S, weights: &'a Weights) -> Self {
        Self { alpha: Lanes::splat(simd, weights.alpha), weights }
    }
}

/// Sixteen transforms.
#[derive(Clone, Copy)]
struct Transforms<S: Simd> {
    translation: [Lanes<S>; 3],
    rotation: [Lanes<S>; 4],
}

impl<S: Simd> Transforms<S> {
    #[inline(always)]
    fn load(simd: S, block: &RbtBlock) -> Self {
        let ([x, y, z], [qx, qy, qz, qw]) = (&block.translation, &block.rotation);
        Self {
            translation: [Lanes::from_slice(simd, x), Lanes::from_slice(simd, y), Lanes::from_slice(simd, z)],
            rotation: [
                Lanes::from_slice(simd, qx),
                Lanes::from_slice(simd, qy),
                Lanes::from_slice(simd, qz),
                Lanes::from_slice(simd, qw),
            ],
        }
    }

    #[inline(always)]
    fn store(self, block: &mut RbtBlock) {
        let ([x, y, z], [qx, qy, qz, qw]) = (&mut block.translation, &mut block.rotation);
        self.translation[0].store_slice(x);
        self.translation[1].store_slice(y);
        self.translation[2].store_slice(z);
        self.rotation[0].store_slice(qx);
        self.rotation[1].store_slice(qy);
        self.rotation[2].store_slice(qz);
        self.rotation[3].store_slice(qw);
    }

    /// Translations: `from + α (to − from)`, which keeps equal ones bit for bit. Rotations: `slerp` the short way.
    #[inline(always)]
    fn blended(self, simd: S, by: &Fitted<'_, S>, to: Self) -> Self {
        let ([x0, y0, z0], [x1, y1, z1]) = (self.translation, to.translation);
        Self {
            translation: [by.alpha.mul_add(x1 - x0, x0), by.alpha.mul_add(y1 - y0, y0), by.alpha.mul_add(z1 - z0, z0)],
            rotation: slerp(simd, by, self.rotation, to.rotation),
        }
    }
}

#[inline(always)]
fn dot<S: Simd>(a: [Lanes<S>; 4], b: [Lanes<S>; 4]) -> Lanes<S> {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2].mul_add(b[2], a[3] * b[3])))
}

#[inline(always)]
fn slerp<S: Simd>(simd: S, by: &Fitted<'_, S>, from: [Lanes<S>; 4], to: [Lanes<S>; 4]) -> [Lanes<S>; 4] {
    let cosine = dot(from, to);
    let versine = Lanes::splat(simd, 1.0) - cosine.abs();
    // Horner's scheme for the even and the odd powers of both, unrolled by hand: a loop would go through memory.
    let (f, t) = (&by.weights.from, &by.weights.to);
    let square = versine * versine;
    macro_rules! horner {
        ($weights:ident $first:literal $($power:literal)*) => {{
            let mut sum = Lanes::splat(simd, $weights[$first]);
            $( sum = sum.mul_add(square, Lanes::splat(simd, $weights[$power])); )*
            sum
        }};
    }
    let (from_odd, from_even) = (horner!(f 9 7 5 3 1), horner!(f 8 6 4 2 0));
    let (to_odd, to_even) = (horner!(t 9 7 5 3 1), horner!(t 8 6 4 2 0));
    let from_weight = from_odd.mul_add(versine, from_even);
    let to_weight = to_odd.mul_add(versine, to_even);
    // `to` or its negative, whichever is nearer.
    let to_weight = to_weight.copysign(to_weight * cosine);
    let blended = [
        from[0].mul_add(from_weight, to[0] * to_weight),
        from[1].mul_add(from_weight, to[1] * to_weight),
        from[2].mul_add(from_weight, to[2] * to_weight),
        from[3].mul_add(from_weight, to[3] * to_weight),
    ];
    // One step of Newton's method towards unit length; the length is already close to 1.
    let scale = dot(blended, blended).mul_add(Lanes::splat(simd, -0.5), Lanes::splat(simd, 1.5));
    [blended[0] * scale, blended[1] * scale, blended[2] * scale, blended[3] * scale]
}

#[cfg(test)]
mod tests;
