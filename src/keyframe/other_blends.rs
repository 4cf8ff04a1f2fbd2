//! Other ways of blending two keyframes, for lessons: the view shows them as ghosts, nothing plays them.

use glam::{Affine3A, Mat3A, Vec3A};

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

    /// Its name in scripts.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Played(interpolation) => interpolation.name(),
            Self::Nlerp => "nlerp",
            Self::Matrices => "matrices",
        }
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
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
