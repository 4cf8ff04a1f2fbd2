//! Sixteen rigid body transforms, component by component: the unit of SIMD blending.

use glam::{Quat, Vec3};

use crate::rbt::Rbt;

/// Transforms in a block.
pub const LANES: usize = 16;

/// [`LANES`] transforms, each component in its own row. A partial last block is filled up with the identity.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct RbtBlock {
    /// x, y and z of the translations.
    pub translation: [[f32; LANES]; 3],
    /// x, y, z and w of the rotations.
    pub rotation: [[f32; LANES]; 4],
}

impl RbtBlock {
    /// Identity transforms.
    pub const IDENTITY: Self =
        Self { translation: [[0.0; LANES]; 3], rotation: [[0.0; LANES], [0.0; LANES], [0.0; LANES], [1.0; LANES]] };

    /// The transform in a lane, below [`LANES`].
    #[must_use]
    #[inline]
    pub fn get(&self, lane: usize) -> Rbt {
        let [x, y, z] = self.translation.each_ref().map(|row| row[lane]);
        let [qx, qy, qz, qw] = self.rotation.each_ref().map(|row| row[lane]);
        Rbt::new(Vec3::new(x, y, z), Quat::from_xyzw(qx, qy, qz, qw))
    }

    /// Replaces the transform in a lane, below [`LANES`].
    #[inline]
    pub fn set(&mut self, lane: usize, rbt: Rbt) {
        for (row, component) in self.translation.iter_mut().zip(rbt.translation.to_array()) {
            row[lane] = component;
        }
        for (row, component) in self.rotation.iter_mut().zip(rbt.rotation.to_array()) {
            row[lane] = component;
        }
    }
}
