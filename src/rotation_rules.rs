//! Which quaternions count as rotations: the tolerances and rules of all that is read and edited.
//!
//! Rounded numbers give quaternions that are a little off unit length. A file that this program wrote must read back to the same bits, so
//! the smallest errors are kept; larger ones are rounding in somebody's text and are normalised; beyond that a file is wrong.

use glam::Quat;

/// How far from unit length a rotation may be to be kept bit for bit.
pub const KEPT: f64 = 1e-6;
/// How far from unit length a rotation may be to be normalised; beyond, it is an error.
pub const NORMALISED: f64 = 0.01;
/// How far from unit length four numbers of a text may be to be taken for its quaternions, where nothing says which four they are.
pub const RECOGNISED: f64 = 5e-3;
/// The least length of a quaternion that has a direction.
const SHORTEST: f32 = 1e-6;

/// What becomes of a quaternion of some length that stands for a rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mending {
    /// It is kept bit for bit.
    Keep,
    /// It is normalised.
    Normalise,
    /// It is no rotation.
    Refuse,
}

impl Mending {
    /// The rule for a quaternion of this length.
    #[must_use]
    pub fn of_length(length: f64) -> Self {
        let off_unit = (length - 1.0).abs();
        if off_unit <= KEPT {
            Self::Keep
        } else if off_unit <= NORMALISED {
            Self::Normalise
        } else {
            Self::Refuse
        }
    }
}

/// A rotation of unit length, if the quaternion has a direction: what an edit gives may be of any other length.
#[must_use]
pub fn unit(rotation: Quat) -> Option<Quat> {
    let length = rotation.length();
    (length > SHORTEST && length.is_finite()).then(|| rotation / length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_errors_are_kept_and_larger_ones_normalised() {
        for (length, expected) in [
            (1.0, Mending::Keep),
            (1.0 - 9e-7, Mending::Keep),
            (1.0 + 2e-6, Mending::Normalise),
            (0.991, Mending::Normalise),
            (1.011, Mending::Refuse),
            (0.0, Mending::Refuse),
            (f64::NAN, Mending::Refuse),
            (f64::INFINITY, Mending::Refuse),
        ] {
            assert_eq!(Mending::of_length(length), expected, "{length}");
        }
    }

    #[test]
    fn what_has_a_direction_becomes_unit() {
        assert_eq!(unit(Quat::from_xyzw(0.0, 0.0, 3.0, 4.0)), Some(Quat::from_xyzw(0.0, 0.0, 0.6, 0.8)));
        for none in [[0.0; 4], [f32::NAN, 0.0, 0.0, 1.0], [f32::INFINITY, 0.0, 0.0, 1.0], [3e38; 4]] {
            assert_eq!(unit(Quat::from_array(none)), None, "{none:?}");
        }
    }
}
