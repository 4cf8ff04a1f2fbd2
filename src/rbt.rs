//! Rigid body transforms: the values that nodes hold and keyframes record.
//!
//! An [`Rbt`] is a rotation followed by a translation, `x ↦ R x + t` (Gortler, *Foundations of 3D Computer Graphics*, chapter 8). This
//! module does not know scenes, time or files.

use glam::{Affine3A, Quat, Vec3};

/// The largest absolute value, in scene units, of a coordinate that a document or a file of this program can hold. The only bound of its
/// kind: edits, readers and scenes share it, so that whatever is saved can be read, and sums along a chain of nodes stay finite.
pub const LARGEST_COORDINATE: f32 = 1e6;

/// A rigid body transform `target_from_source`: rotates, then translates.
///
/// The name of a value states its spaces, as in `world_from_node`. Lengths are in scene units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rbt {
    /// Where the source's origin lies, in target space.
    pub translation: Vec3,
    /// The rotation from source axes to target axes. Unit to within 1e-6; either sign means the same rotation.
    pub rotation: Quat,
}

impl Rbt {
    /// The transform that changes nothing.
    pub const IDENTITY: Self = Self { translation: Vec3::ZERO, rotation: Quat::IDENTITY };

    /// A transform from its two factors, as in `T · R`.
    #[must_use]
    pub const fn new(translation: Vec3, rotation: Quat) -> Self {
        Self { translation, rotation }
    }

    /// A translation with no rotation.
    #[must_use]
    pub const fn from_translation(translation: Vec3) -> Self {
        Self { translation, rotation: Quat::IDENTITY }
    }

    /// A rotation about the origin.
    #[must_use]
    pub const fn from_rotation(rotation: Quat) -> Self {
        Self { translation: Vec3::ZERO, rotation }
    }

    /// The inverse: `source_from_target`.
    #[must_use]
    pub fn inverse(self) -> Self {
        let rotation = self.rotation.conjugate();
        Self { translation: -(rotation * self.translation), rotation }
    }

    /// Takes a point from source to target space.
    #[must_use]
    pub fn transform_point(self, point_in_source: Vec3) -> Vec3 {
        self.rotation * point_in_source + self.translation
    }

    /// Takes a direction from source to target space; the translation does not matter.
    #[must_use]
    pub fn transform_vector(self, vector_in_source: Vec3) -> Vec3 {
        self.rotation * vector_in_source
    }

    /// The same transform with a rotation of unit length, to remove the drift of many products.
    #[must_use]
    pub fn renormalized(self) -> Self {
        Self { rotation: self.rotation.normalize(), ..self }
    }

    /// Whether each coordinate of the translation is one that documents and files can hold; not if one is infinite or NaN.
    #[must_use]
    #[inline]
    pub fn is_in_bounds(self) -> bool {
        are_coordinates(self.translation)
    }

    /// The same map as an affine matrix.
    #[must_use]
    pub fn to_affine(self) -> Affine3A {
        Affine3A::from_rotation_translation(self.rotation, self.translation)
    }

    /// The rigid part of an affine map whose linear part is a rotation times a positive scale.
    #[must_use]
    pub fn from_affine(target_from_source: &Affine3A) -> Self {
        let (_, rotation, translation) = target_from_source.to_scale_rotation_translation();
        Self { translation, rotation }.renormalized()
    }

    /// Whether every component is a finite number.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.translation.is_finite() && self.rotation.is_finite()
    }

    /// "Do `motion` to this object with respect to `auxiliary`": `A M A⁻¹ O`, all three in the same target space
    /// (Gortler, section 4.4 and chapter 8).
    #[must_use]
    pub fn moved(self, motion: Self, auxiliary: Self) -> Self {
        (auxiliary * motion * auxiliary.inverse() * self).renormalized()
    }
}

/// Whether each component lies within ±[`LARGEST_COORDINATE`]; not if one is infinite or NaN.
#[must_use]
#[inline]
pub fn are_coordinates(vector: Vec3) -> bool {
    vector.abs().cmple(Vec3::splat(LARGEST_COORDINATE)).all()
}

impl Default for Rbt {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl std::ops::Mul for Rbt {
    type Output = Self;

    /// `a_from_c = a_from_b * b_from_c`.
    fn mul(self, b_from_c: Self) -> Self {
        Self { translation: self.transform_point(b_from_c.translation), rotation: self.rotation * b_from_c.rotation }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn any_rbt() -> impl Strategy<Value = Rbt> {
        (prop::array::uniform3(-10.0f32..10.0), prop::array::uniform4(-1.0f32..1.0))
            .prop_filter("a rotation needs a direction", |(_, q)| q.iter().map(|c| c * c).sum::<f32>() > 0.01)
            .prop_map(|(t, q)| Rbt::new(Vec3::from(t), Quat::from_array(q).normalize()))
    }

    proptest! {
        #[test]
        fn inverse_undoes(a in any_rbt(), p in prop::array::uniform3(-10.0f32..10.0)) {
            let p = Vec3::from(p);
            let back = a.inverse().transform_point(a.transform_point(p));
            prop_assert!(back.distance(p) < 1e-4);
        }

        #[test]
        fn product_applies_right_to_left(a in any_rbt(), b in any_rbt(), p in prop::array::uniform3(-10.0f32..10.0)) {
            let p = Vec3::from(p);
            let once = (a * b).transform_point(p);
            let twice = a.transform_point(b.transform_point(p));
            prop_assert!(once.distance(twice) < 1e-4);
        }

        #[test]
        fn matrix_agrees(a in any_rbt(), p in prop::array::uniform3(-10.0f32..10.0)) {
            let p = Vec3::from(p);
            prop_assert!(a.to_affine().transform_point3(p).distance(a.transform_point(p)) < 1e-4);
            prop_assert!(Rbt::from_affine(&a.to_affine()).transform_point(p).distance(a.transform_point(p)) < 1e-3);
        }
    }

    #[test]
    fn turning_about_an_auxiliary_frame_keeps_its_origin() {
        let pivot = Rbt::from_translation(Vec3::new(1.0, 2.0, 3.0));
        let object = Rbt::from_translation(Vec3::new(2.0, 2.0, 3.0));
        let quarter = Rbt::from_rotation(Quat::from_rotation_z(std::f32::consts::FRAC_PI_2));
        let moved = object.moved(quarter, pivot);
        assert!(moved.translation.distance(Vec3::new(1.0, 3.0, 3.0)) < 1e-6);
    }
}
