//! Transforms to matrices, and `world_from_node` by composition with the parents' matrices.

use fearless_simd::prelude::*;
use fearless_simd::{dispatch, f32x4, f32x16, u8x64};
use glam::{Affine3A, Mat3A, Vec3A};

use super::{Lanes, Level, Transforms};
use crate::pose::{LANES, RbtBlock};

/// Four numbers of a matrix: one SIMD register.
type Quad = [f32; 4];

/// An affine matrix that fills one cache line.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct AlignedAffine {
    /// The three columns of the linear part, then the translation, each x, y, z and 0.
    columns: [Quad; 4],
}

impl AlignedAffine {
    /// The identity.
    pub const IDENTITY: Self =
        Self { columns: [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0; 4]] };

    /// The matrix as glam's type.
    #[must_use]
    #[inline]
    pub fn get(&self) -> Affine3A {
        let [x, y, z, translation] = self.columns.map(|[x, y, z, _]| Vec3A::new(x, y, z));
        Affine3A { matrix3: Mat3A::from_cols(x, y, z), translation }
    }
}

impl From<Affine3A> for AlignedAffine {
    #[inline]
    fn from(affine: Affine3A) -> Self {
        let Mat3A { x_axis, y_axis, z_axis } = affine.matrix3;
        let column = |column: Vec3A| column.extend(0.0).to_array();
        Self { columns: [x_axis, y_axis, z_axis, affine.translation].map(column) }
    }
}

/// The matrices of sixteen rigid body transforms.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C, align(64))]
pub struct MatrixBlock {
    /// The three rows of each of the sixteen matrices: x, y and z axis, then the translation.
    rows: [[Quad; LANES]; 3],
}

/// The matrices of transforms. Slices should have one length; elements beyond the shorter are left unchanged.
pub fn matrices(level: Level, transforms: &[RbtBlock], into: &mut [MatrixBlock]) {
    dispatch!(level, simd => matrices_with(simd, transforms, into));
}

/// Sets `world_from_node` of consecutive nodes from `first_node` on to `world_from_parent · parent_from_node`. `matrices` holds
/// `parent_from_node`, from matrix `first_matrix` on; `parents` holds indices into `world_from_node`. A parent index out of range means the
/// world. For finite matrices the result equals glam's product, except for the sign of zeros.
pub fn compose(
    level: Level,
    matrices: &[MatrixBlock],
    first_matrix: usize,
    parents: &[u32],
    world_from_node: &mut [AlignedAffine],
    first_node: usize,
) {
    dispatch!(level, simd => compose_with(simd, matrices, first_matrix, parents, world_from_node, first_node));
}

#[inline(always)]
fn matrices_with<S: Simd>(simd: S, transforms: &[RbtBlock], into: &mut [MatrixBlock]) {
    let one = Lanes::splat(simd, 1.0);
    for (block, into) in transforms.iter().zip(into) {
        let Transforms { translation: [tx, ty, tz], rotation: [x, y, z, w] } = Transforms::load(simd, block);
        let (x2, y2, z2) = (x + x, y + y, z + z);
        let (xx, xy, xz) = (x * x2, x * y2, x * z2);
        let (yy, yz, zz) = (y * y2, y * z2, z * z2);
        let (wx, wy, wz) = (w * x2, w * y2, w * z2);
        let [x_row, y_row, z_row] = &mut into.rows;
        store_quads([one - (yy + zz), xy - wz, xz + wy, tx], x_row);
        store_quads([xy + wz, one - (xx + zz), yz - wx, ty], y_row);
        store_quads([xz - wy, yz + wx, one - (xx + yy), tz], z_row);
    }
}

/// Stores the four numbers of each lane next to each other.
#[inline(always)]
fn store_quads<S: Simd>([a, b, c, d]: [Lanes<S>; 4], into: &mut [Quad; LANES]) {
    let (ac_low, ac_high) = a.interleave(c);
    let (bd_low, bd_high) = b.interleave(d);
    let (first, second) = ac_low.interleave(bd_low);
    let (third, fourth) = ac_high.interleave(bd_high);
    let into = into.as_flattened_mut();
    first.store_slice(&mut into[..16]);
    second.store_slice(&mut into[16..32]);
    third.store_slice(&mut into[32..48]);
    fourth.store_slice(&mut into[48..]);
}

#[inline(always)]
fn compose_with<S: Simd>(
    simd: S,
    matrices: &[MatrixBlock],
    first_matrix: usize,
    parents: &[u32],
    world_from_node: &mut [AlignedAffine],
    first_node: usize,
) {
    // Shuffles four copies of (a, b, c, d) into aaaa bbbb cccc dddd.
    let each_four_times = u8x64::from_fn(simd, |byte| (byte / 16 * 4 + byte % 4) as u8);
    let of_translation = f32x16::from_fn(simd, |element| if element < 12 { 0.0 } else { 1.0 });
    for (offset, &parent) in parents.iter().enumerate() {
        let (block, lane) = (&matrices[(first_matrix + offset) / LANES], (first_matrix + offset) % LANES);
        let above = world_from_node.get(parent as usize).unwrap_or(&AlignedAffine::IDENTITY);
        macro_rules! term {
            ($axis:literal) => {
                four_times(simd, &above.columns[$axis])
                    * four_times(simd, &block.rows[$axis][lane]).swizzle_dyn_within_blocks(each_four_times)
            };
        }
        let linear = term!(0) + term!(1) + term!(2);
        let placed = of_translation.mul_add(four_times(simd, &above.columns[3]), linear);
        placed.store_slice(world_from_node[first_node + offset].columns.as_flattened_mut());
    }
}

#[inline(always)]
fn four_times<S: Simd>(simd: S, quad: &Quad) -> f32x16<S> {
    f32x16::block_splat(f32x4::from_slice(simd, quad))
}
