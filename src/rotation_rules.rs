//! Which quaternions are accepted as rotations: the tolerances and rules for everything that is read or edited.
//!
//! Rounded numbers give quaternions that are not quite of unit length. A file that this program wrote must read back to the same bits, so
//! the smallest errors are kept. Larger errors come from rounding in other programs and are normalised. Beyond that the file is wrong.

use glam::{DQuat, Quat, Vec3};

use crate::words::{Message, texts};

/// A rotation whose length differs from 1 by at most this is kept bit for bit.
pub const KEPT: f64 = 1e-6;
/// A rotation whose length differs from 1 by at most this is normalised; beyond, it is an error.
pub const NORMALISED: f64 = 0.01;
/// Largest difference from unit length at which four numbers of a text are recognised as a quaternion, if the text does not say which four
/// are.
pub const RECOGNISED: f64 = 5e-3;
/// The least length of a quaternion that has a direction.
const SHORTEST: f32 = 1e-6;

/// The treatment of a quaternion that is read as a rotation, by its length.
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

/// The quaternion scaled to unit length; `None` if it is too short or not finite. For edits, which may give any length.
#[must_use]
pub fn unit(rotation: Quat) -> Option<Quat> {
    let length = rotation.length();
    (length > SHORTEST && length.is_finite()).then(|| rotation / length)
}

/// The rotation about a unit axis by an angle in radians. Half a turn is computed in double precision: in single precision its w is a small
/// negative number, and interpolation then goes the other way round than in programs that compute in double precision.
#[must_use]
pub fn rotation_about_axis(axis: Vec3, radians: f64) -> Quat {
    DQuat::from_axis_angle(axis.as_dvec3(), radians).as_quat()
}

/// The rotation of Euler angles in degrees: `q = qz(yaw) · qy(pitch) · qx(roll)`, each about an axis of the parent. In double precision, as
/// [`rotation_about_axis`].
#[must_use]
pub fn rotation_from_euler_degrees(degrees: [f32; 3]) -> Quat {
    exact_rotation_from_euler_degrees(degrees.map(f64::from)).as_quat()
}

/// [`rotation_from_euler_degrees`] of angles in double precision, before it is rounded to single precision.
#[must_use]
pub fn exact_rotation_from_euler_degrees(degrees: [f64; 3]) -> DQuat {
    let [yaw, pitch, roll] = degrees.map(f64::to_radians);
    DQuat::from_rotation_z(yaw) * DQuat::from_rotation_y(pitch) * DQuat::from_rotation_x(roll)
}

/// What to tell someone who typed an angle beyond half a turn: a rotation has no turns in it. `None` for an angle within ±180 degrees.
#[must_use]
pub fn beyond_half_turn(degrees: f64) -> Option<Message> {
    if degrees.abs() <= 180.0 || !degrees.is_finite() {
        return None;
    }
    let rest = degrees % 360.0;
    let same = rest - if rest.abs() > 180.0 { 360.0_f64.copysign(rest) } else { 0.0 };
    // Adding 0.0 makes a zero of minus zero.
    let same = (same * 1e4).round() / 1e4 + 0.0;
    let third = 120.0_f64.copysign(degrees);
    Some(texts::rotation_is_the_same(degrees, same, third, 2.0 * third))
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
    fn angles_beyond_half_a_turn_are_those_of_smaller_ones() {
        for degrees in [0.0, 180.0, -180.0, 0.1, f64::NAN] {
            assert_eq!(beyond_half_turn(degrees), None);
        }
        for (degrees, expected) in [
            (360.0, "360 degrees is the same rotation as 0, and"),
            (-360.0, "-360 degrees is the same rotation as 0, and"),
            (200.5, "200.5 degrees is the same rotation as -159.5, and"),
            (-190.0, "-190 degrees is the same rotation as 170, and"),
            (400.1, "400.1 degrees is the same rotation as 40.1, and"),
        ] {
            let said = beyond_half_turn(degrees).unwrap().to_string();
            assert!(said.starts_with(expected), "{said}");
            let keys = if degrees > 0.0 { "keys at 120 and 240" } else { "keys at -120 and -240" };
            assert!(said.contains(keys), "{said}");
        }
    }

    #[test]
    fn what_has_a_direction_becomes_unit() {
        assert_eq!(unit(Quat::from_xyzw(0.0, 0.0, 3.0, 4.0)), Some(Quat::from_xyzw(0.0, 0.0, 0.6, 0.8)));
        for none in [[0.0; 4], [f32::NAN, 0.0, 0.0, 1.0], [f32::INFINITY, 0.0, 0.0, 1.0], [3e38; 4]] {
            assert_eq!(unit(Quat::from_array(none)), None, "{none:?}");
        }
    }

    #[test]
    fn euler_angles_turn_about_x_first_and_z_last() {
        let rotation = rotation_from_euler_degrees([90.0, 0.0, 90.0]);
        assert!((rotation * Vec3::Y).distance(Vec3::Z) < 1e-6);
        assert!((rotation * Vec3::X).distance(Vec3::Y) < 1e-6);
        let rotation = rotation_from_euler_degrees([0.0, 90.0, 0.0]);
        assert!((rotation * Vec3::X).distance(Vec3::NEG_Z) < 1e-6);
    }

    #[test]
    fn half_a_turn_has_no_negative_w() {
        for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
            let turned = rotation_about_axis(axis, std::f64::consts::PI);
            assert!(turned.w >= 0.0 && turned.w < 1e-12 && turned.xyz() == axis, "{turned}");
        }
        for degrees in [[180.0, 0.0, 0.0], [0.0, 180.0, 0.0], [0.0, 0.0, 180.0], [-180.0, 0.0, 0.0]] {
            let turned = rotation_from_euler_degrees(degrees);
            assert!(turned.w >= 0.0 && turned.w < 1e-12, "{turned}");
        }
    }
}
