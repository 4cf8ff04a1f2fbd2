//! Blends of whole poses, sixteen nodes at a time: the same as [`crate::interpolation`] says of one, within rounding.
//!
//! Between two keyframes every node has the same fraction α. So both weights of `slerp`, `sin((1 − α)θ)/sin θ` and `sin(αθ)/sin θ`,
//! are functions of `|cos θ|` alone for the whole pose. [`Weights`] fits a polynomial of degree 9 to each of them once; what is left
//! for each node are products and sums. Rotations differ from those of `slerp` in exact arithmetic by less than 3e-7 radians, on a
//! Catmull-Rom spline by less than 5e-7, and are as near to unit length.
//!
//! The widest instructions that the processor has are chosen when the program runs. Those with fused multiplication and addition
//! (AVX2, AVX-512, NEON) agree with each other to the bit.

#![expect(clippy::inline_always, reason = "what is not inlined is compiled for the oldest processor")]

mod weights;

use fearless_simd::prelude::*;
use fearless_simd::{dispatch, f32x16};

use glam::{Affine3A, Mat3A, Vec3A};

use crate::pose::{LANES, RbtBlock};

pub use fearless_simd::Level;
pub use weights::Weights;

/// The widest instructions that this processor has.
#[must_use]
pub fn widest() -> Level {
    Level::new()
}

/// Translations by `lerp`, rotations by `slerp`, from one pose to another. All slices are of one length, or the rest stays as it is.
pub fn linear(level: Level, weights: &Weights, from: &[RbtBlock], to: &[RbtBlock], into: &mut [RbtBlock]) {
    dispatch!(level, simd => linear_with(simd, weights, from, to, into));
}

/// The four control points of the Bézier curves of all nodes.
#[derive(Clone, Copy, Debug)]
pub struct Curves<'a> {
    /// Where the curves start.
    pub start: &'a [RbtBlock],
    /// The control points after that.
    pub after_start: &'a [RbtBlock],
    /// Those before the end.
    pub before_end: &'a [RbtBlock],
    /// Where the curves end.
    pub end: &'a [RbtBlock],
}

/// A place on cubic Bézier curves by de Casteljau's six blends. All slices are of one length, or the rest stays as it is.
pub fn bezier(level: Level, weights: &Weights, curves: Curves<'_>, into: &mut [RbtBlock]) {
    dispatch!(level, simd => bezier_with(simd, weights, curves, into));
}

/// The matrices of sixteen rigid body transforms, each element in a row of its own.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct MatrixBlock {
    /// The three columns of the rotation, then the translation, each x, y and z.
    pub columns: [[[f32; LANES]; 3]; 4],
}

impl Default for MatrixBlock {
    fn default() -> Self {
        Self { columns: [[[0.0; LANES]; 3]; 4] }
    }
}

impl MatrixBlock {
    /// One transform's matrix; `lane` is below [`LANES`].
    #[must_use]
    pub fn get(&self, lane: usize) -> Affine3A {
        let column = |column: usize| Vec3A::from_array(self.columns[column].each_ref().map(|row| row[lane]));
        Affine3A { matrix3: Mat3A::from_cols(column(0), column(1), column(2)), translation: column(3) }
    }
}

/// The matrices of transforms. Both slices are of one length, or the rest stays as it is.
pub fn matrices(level: Level, transforms: &[RbtBlock], into: &mut [MatrixBlock]) {
    dispatch!(level, simd => matrices_with(simd, transforms, into));
}

/// Puts nodes that follow each other, the first at `place`, below their parents: `world_from_parent · parent_from_node`, the second
/// from the transform `first` of the matrices on. A parent that is in no place is the world.
pub fn place_below(
    level: Level,
    matrices: &[MatrixBlock],
    first: usize,
    parents: &[u32],
    world_from_node: &mut [Affine3A],
    place: usize,
) {
    dispatch!(level, simd => place_below_with(simd, matrices, first, parents, world_from_node, place));
}

// What follows is compiled once for each set of instructions. Every function must be inlined into one that `dispatch` makes, and
// closures are not: what they hold would be compiled for the oldest processor.

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

#[inline(always)]
fn matrices_with<S: Simd>(simd: S, transforms: &[RbtBlock], into: &mut [MatrixBlock]) {
    let one = Lanes::splat(simd, 1.0);
    for (block, into) in transforms.iter().zip(into) {
        let [x, y, z, w] = Transforms::load(simd, block).rotation;
        let (x2, y2, z2) = (x + x, y + y, z + z);
        let (xx, xy, xz) = (x * x2, x * y2, x * z2);
        let (yy, yz, zz) = (y * y2, y * z2, z * z2);
        let (wx, wy, wz) = (w * x2, w * y2, w * z2);
        let [[xx_row, xy_row, xz_row], [yx_row, yy_row, yz_row], [zx_row, zy_row, zz_row], translation] =
            &mut into.columns;
        (one - (yy + zz)).store_slice(xx_row);
        (xy + wz).store_slice(xy_row);
        (xz - wy).store_slice(xz_row);
        (xy - wz).store_slice(yx_row);
        (one - (xx + zz)).store_slice(yy_row);
        (yz + wx).store_slice(yz_row);
        (xz + wy).store_slice(zx_row);
        (yz - wx).store_slice(zy_row);
        (one - (xx + yy)).store_slice(zz_row);
        *translation = block.translation;
    }
}

#[inline(always)]
fn place_below_with<S: Simd>(
    _simd: S,
    matrices: &[MatrixBlock],
    first: usize,
    parents: &[u32],
    world_from_node: &mut [Affine3A],
    place: usize,
) {
    for (offset, &parent) in parents.iter().enumerate() {
        let (block, lane) = (&matrices[(first + offset) / LANES], (first + offset) % LANES);
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz], [tx, ty, tz]] = &block.columns;
        let placed = if let Some(above) = world_from_node.get(parent as usize) {
            let (x, y, z) = (above.matrix3.x_axis, above.matrix3.y_axis, above.matrix3.z_axis);
            Affine3A {
                matrix3: Mat3A::from_cols(
                    x * Vec3A::splat(xx[lane]) + y * Vec3A::splat(xy[lane]) + z * Vec3A::splat(xz[lane]),
                    x * Vec3A::splat(yx[lane]) + y * Vec3A::splat(yy[lane]) + z * Vec3A::splat(yz[lane]),
                    x * Vec3A::splat(zx[lane]) + y * Vec3A::splat(zy[lane]) + z * Vec3A::splat(zz[lane]),
                ),
                translation: x * Vec3A::splat(tx[lane])
                    + y * Vec3A::splat(ty[lane])
                    + z * Vec3A::splat(tz[lane])
                    + above.translation,
            }
        } else {
            block.get(lane)
        };
        world_from_node[place + offset] = placed;
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

    /// Translations: `from + α (to − from)`, which leaves equal ones as they are. Rotations: `slerp` the short way.
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
    // Horner's scheme for both, written out: a loop would be one over memory.
    let (f, t) = (&by.weights.from, &by.weights.to);
    let mut from_weight = Lanes::splat(simd, f[9]);
    let mut to_weight = Lanes::splat(simd, t[9]);
    macro_rules! terms {
        ($($power:literal)*) => { $(
            from_weight = from_weight.mul_add(versine, Lanes::splat(simd, f[$power]));
            to_weight = to_weight.mul_add(versine, Lanes::splat(simd, t[$power]));
        )* };
    }
    terms!(8 7 6 5 4 3 2 1 0);
    // `to` or its negative, whichever is nearer.
    let to_weight = to_weight.copysign(to_weight * cosine);
    let blended = [
        from[0].mul_add(from_weight, to[0] * to_weight),
        from[1].mul_add(from_weight, to[1] * to_weight),
        from[2].mul_add(from_weight, to[2] * to_weight),
        from[3].mul_add(from_weight, to[3] * to_weight),
    ];
    // One step of Newton's method towards unit length, from very near.
    let scale = dot(blended, blended).mul_add(Lanes::splat(simd, -0.5), Lanes::splat(simd, 1.5));
    [blended[0] * scale, blended[1] * scale, blended[2] * scale, blended[3] * scale]
}

#[cfg(test)]
mod tests;
