//! Other ways of blending two keyframes, for lessons: the view shows them as ghosts and pictures compare them, nothing plays them.

use glam::{Affine3A, DQuat, Mat3A, Vec3A};

use super::list::KeyframeIndex;
use super::sample::PlayRange;
use crate::interpolation::{Interpolation, lerp, nlerp};
use crate::pose::RbtIndex;
use crate::rbt::Rbt;
use crate::words::{Phrase, texts};

/// A way of blending two keyframes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Blend {
    /// One of the interpolations that play.
    Played(Interpolation),
    /// Translations by lerp, rotations by normalised lerp: the same path as slerp at an uneven speed.
    Nlerp,
    /// The two matrices blended element by element: not a rotation in between, so that shapes shrink and shear.
    Matrices,
}

impl Blend {
    /// All of them: those that play, then the others.
    pub const ALL: [Self; Interpolation::ALL.len() + 2] =
        [Self::Played(Interpolation::ALL[0]), Self::Played(Interpolation::ALL[1]), Self::Nlerp, Self::Matrices];

    /// The number of blends that [`Self::others`] returns.
    pub const OTHERS: usize = Interpolation::ALL.len() + 1;

    /// The blends to compare with `playing`: every other interpolation, then nlerp and matrices.
    #[must_use]
    pub fn others(playing: Interpolation) -> [Self; Self::OTHERS] {
        let mut others = [Self::Nlerp; Self::OTHERS];
        let interpolations = Interpolation::ALL.into_iter().filter(|&other| other != playing).map(Self::Played);
        for (slot, other) in others.iter_mut().zip(interpolations.chain([Self::Nlerp, Self::Matrices])) {
            *slot = other;
        }
        others
    }

    /// Its name in scripts and on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Played(interpolation) => interpolation.name(),
            Self::Nlerp => "nlerp",
            Self::Matrices => "matrix",
        }
    }

    /// The blend with this name; scripts may also say `matrices`. `None` if there is none.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        let name = if name == "matrices" { Self::Matrices.name() } else { name };
        Self::ALL.into_iter().find(|blend| blend.name() == name)
    }

    /// Its name for people.
    #[must_use]
    pub const fn title(self) -> Phrase {
        match self {
            Self::Played(interpolation) => interpolation.title(),
            Self::Nlerp => texts::BLEND_NLERP,
            Self::Matrices => texts::BLEND_MATRICES,
        }
    }
}

/// Half the time over which a speed is measured, in key times.
const HALF_STEP: f64 = 0.004;

impl PlayRange<'_> {
    /// `parent_from_node` of one node at a key time, clamped to the range, by this blend.
    #[must_use]
    pub fn blended_at(&self, key_time: f64, blend: Blend, rbt: RbtIndex) -> Affine3A {
        let (start, alpha) = self.interval_at(key_time);
        let (from, to) = self.ends(start, rbt);
        match blend {
            Blend::Played(interpolation) => self.rbt_at(start, alpha, interpolation, rbt).to_affine(),
            Blend::Nlerp => {
                Rbt::new(lerp(from.translation, to.translation, alpha), nlerp(from.rotation, to.rotation, alpha))
                    .to_affine()
            }
            Blend::Matrices => {
                let (from, to) = (from.to_affine(), to.to_affine());
                let column = |from: Vec3A, to: Vec3A| from * (1.0 - alpha) + to * alpha;
                Affine3A {
                    matrix3: Mat3A::from_cols(
                        column(from.matrix3.x_axis, to.matrix3.x_axis),
                        column(from.matrix3.y_axis, to.matrix3.y_axis),
                        column(from.matrix3.z_axis, to.matrix3.z_axis),
                    ),
                    translation: column(from.translation, to.translation),
                }
            }
        }
    }

    /// The rotation of one node at a key time, clamped to the range, by this blend: `parent_from_node`. Of blended matrices it is the
    /// rotation that is nearest to them (the rotation of their polar decomposition).
    #[must_use]
    pub fn rotation_at(&self, key_time: f64, blend: Blend, rbt: RbtIndex) -> DQuat {
        let (start, alpha) = self.interval_at(key_time);
        let (from, to) = self.ends(start, rbt);
        match blend {
            Blend::Played(interpolation) => self.rbt_at(start, alpha, interpolation, rbt).rotation.as_dquat(),
            Blend::Nlerp => nlerp(from.rotation, to.rotation, alpha).as_dquat(),
            Blend::Matrices => {
                let (from, to, alpha) = (from.rotation.as_dquat(), to.rotation.as_dquat(), f64::from(alpha));
                let turn = to * from.conjugate();
                let turn = if turn.w < 0.0 { -turn } else { turn };
                let Some(axis) = turn.xyz().try_normalize() else { return from };
                // (1 − α) I + α R keeps the axis of R, and in the plane across it turns and shrinks, as the complex number 1 − α + α e^iθ.
                let (sine, cosine) = (2.0 * turn.xyz().length().atan2(turn.w)).sin_cos();
                DQuat::from_axis_angle(axis, (alpha * sine).atan2(1.0 - alpha + alpha * cosine)) * from
            }
        }
    }

    /// How fast one node turns in its parent's space at a key time, clamped to the range, in degrees a second: the angle from 0.004 key
    /// times before to 0.004 after, as far as both lie in one interval, divided by the time between. At a keyframe it is that of the
    /// interval that begins there.
    #[must_use]
    pub fn angular_speed_at(&self, key_time: f64, blend: Blend, rbt: RbtIndex, ms_between_keyframes: u32) -> f64 {
        let interval = self.interval_at(key_time).0.get().min(self.last_key_time());
        #[expect(clippy::cast_precision_loss, reason = "no list has 2^52 keyframes")]
        let start = (interval - 1) as f64;
        let [before, after] = [key_time - HALF_STEP, key_time + HALF_STEP].map(|at| at.clamp(start, start + 1.0));
        let [before_rotation, after_rotation] = [before, after].map(|at| self.rotation_at(at, blend, rbt));
        let turn = after_rotation * before_rotation.conjugate();
        let degrees = (2.0 * turn.xyz().length().atan2(turn.w.abs())).to_degrees();
        let units = (after - before) * self.duration(KeyframeIndex::new(interval));
        degrees / (units * f64::from(ms_between_keyframes) / 1000.0)
    }
}

#[cfg(test)]
mod tests {
    use glam::{DMat3, Quat, Vec3};

    use super::*;
    use crate::keyframe::{Keyframe, KeyframeList};
    use crate::pose::Pose;

    #[test]
    fn every_blend_is_listed_once() {
        for playing in Interpolation::ALL {
            assert!(Blend::ALL.contains(&Blend::Played(playing)));
        }
        assert_eq!(Blend::ALL.len(), Blend::OTHERS + 1);
    }

    #[test]
    fn all_interpolations_but_the_one_that_plays_are_compared() {
        for playing in Interpolation::ALL {
            let others = Blend::others(playing);
            assert!(!others.contains(&Blend::Played(playing)));
            assert!(others.ends_with(&[Blend::Nlerp, Blend::Matrices]));
            for other in Interpolation::ALL.into_iter().filter(|&other| other != playing) {
                assert_eq!(others.iter().filter(|&&blend| blend == Blend::Played(other)).count(), 1);
            }
        }
    }

    /// Turns about z by these angles in degrees, one keyframe each, of these durations.
    fn turns(degrees: &[f32], duration: f64) -> KeyframeList {
        let pose = |degrees: &f32| Pose::new(vec![Rbt::new(Vec3::ZERO, Quat::from_rotation_z(degrees.to_radians()))]);
        let keyframe = |degrees: &f32| Keyframe { duration, ..Keyframe::new(pose(degrees)) };
        KeyframeList::new(degrees.iter().map(keyframe).collect())
    }

    fn speed(list: &KeyframeList, key_time: f64, blend: Blend) -> f64 {
        PlayRange::new(list).unwrap().angular_speed_at(key_time, blend, RbtIndex::new(0), 500)
    }

    #[test]
    fn slerp_turns_evenly_and_others_as_their_formulas_say() {
        // A quarter turn in a second, then a third of a turn.
        let list = turns(&[0.0, 0.0, 90.0, 210.0, 210.0], 2.0);
        let linear = Blend::Played(Interpolation::Linear);
        for key_time in [0.0, 0.002, 0.3, 0.5, 0.999] {
            let speed = speed(&list, key_time, linear);
            assert!((speed - 90.0).abs() < 0.02, "{speed} at {key_time}");
        }
        for key_time in [1.0, 1.5, 2.0] {
            let speed = speed(&list, key_time, linear);
            assert!((speed - 120.0).abs() < 0.02, "{speed} at {key_time}");
        }
        // Half way: of a chord of angle φ the speed is 2 tan(φ/2); nlerp's is half the turn's, and counts twice.
        for (key_time, turn) in [(0.5, 90.0_f64), (1.5, 120.0)] {
            let turn = turn.to_radians();
            let (nlerp, matrices) = (4.0 * (turn / 4.0).tan().to_degrees(), 2.0 * (turn / 2.0).tan().to_degrees());
            assert!((speed(&list, key_time, Blend::Nlerp) - nlerp).abs() < 0.03, "{nlerp}");
            assert!((speed(&list, key_time, Blend::Matrices) - matrices).abs() < 0.03, "{matrices}");
        }
        // At the ends of a chord it is slower: the sine of the angle.
        assert!((speed(&list, 0.0, Blend::Nlerp) - 2.0 * 45_f64.to_radians().sin().to_degrees()).abs() < 0.5);
    }

    #[test]
    fn the_rotation_of_blended_matrices_is_that_of_their_polar_decomposition() {
        let from = Rbt::new(Vec3::ZERO, Quat::from_euler(glam::EulerRot::XYZ, 0.3, -0.9, 2.0));
        let to = Rbt::new(Vec3::ZERO, Quat::from_euler(glam::EulerRot::XYZ, -1.3, 0.4, 0.5));
        let list = KeyframeList::new(
            [from, from, to, to].map(|rbt| Keyframe::new(Pose::new(vec![rbt]))).into_iter().collect(),
        );
        let (range, rbt) = (PlayRange::new(&list).unwrap(), RbtIndex::new(0));
        for key_time in [0.0, 0.2, 0.5, 0.9, 1.0] {
            // Higham's iteration converges to the orthogonal factor.
            let mut matrix = range.blended_at(key_time, Blend::Matrices, rbt).matrix3.as_dmat3();
            for _ in 0..30 {
                matrix = (matrix + matrix.inverse().transpose()) * 0.5;
            }
            let found = DMat3::from_quat(range.rotation_at(key_time, Blend::Matrices, rbt));
            assert!(found.abs_diff_eq(matrix, 1e-6), "{found} and {matrix} at {key_time}");
        }
    }

    #[test]
    fn every_name_is_read_back() {
        for blend in Blend::ALL {
            assert_eq!(Blend::from_name(blend.name()), Some(blend));
        }
        assert_eq!(Blend::from_name("matrices"), Some(Blend::Matrices));
        assert_eq!(Blend::from_name("cubic"), None);
    }
}
