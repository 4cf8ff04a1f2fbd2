//! How well a playback fits what is right: its frames within the tolerances, and its largest error.

use super::off::{Fault, Off};
use super::rubric::Credit;
use crate::pose::RbtIndex;
use crate::scene::SceneGraph;
use crate::text::counted;

/// An error this many times the tolerances counts no more than that when two playbacks are compared.
const LARGEST_WEIGHT: f64 = 1e3;

/// The largest error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Worst {
    off: Off,
    key_time: f64,
    node: RbtIndex,
}

/// A playback, frame by frame. A frame is everything at one key time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Judgement {
    /// The key time of the last frame, and its share.
    last: Option<(f64, f64)>,
    frames: usize,
    frames_within: usize,
    shares: f64,
    least_share: Option<f64>,
    worst: Option<Worst>,
    /// The largest errors in scene units and in degrees.
    largest: (f64, f64),
    /// The sum of all errors in units of the tolerances.
    weights: f64,
}

impl Judgement {
    /// Adds one node at one key time. Those of a frame follow each other.
    pub fn take(&mut self, key_time: f64, node: RbtIndex, off: Off, credit: &Credit) {
        let share = off.share(credit);
        match &mut self.last {
            Some((time, frame_share)) if *time == key_time => *frame_share = frame_share.min(share),
            _ => {
                self.close_frame();
                self.last = Some((key_time, share));
            }
        }
        let weight = off.weight(credit);
        self.largest = (self.largest.0.max(off.units), self.largest.1.max(off.degrees));
        self.weights += weight.min(LARGEST_WEIGHT);
        let is_worse = self.worst.is_none_or(|worst| off.is_worse_than(&worst.off, credit));
        if is_worse {
            self.worst = Some(Worst { off, key_time, node });
        }
    }

    fn close_frame(&mut self) {
        if let Some((_, share)) = self.last.take() {
            self.frames += 1;
            self.frames_within += usize::from(share >= 1.0);
            self.shares += share;
            self.least_share = Some(self.least_share.map_or(share, |least| least.min(share)));
        }
    }

    /// All frames were taken.
    #[must_use]
    pub fn closed(mut self) -> Self {
        self.close_frame();
        self
    }

    /// The share of the points: the worst frame's, or the mean of all frames' where the rubric says so.
    #[must_use]
    pub fn share(&self, credit: &Credit) -> f64 {
        if credit.share_of_frames && self.frames > 0 {
            return self.shares / self.frames as f64;
        }
        self.least_share.unwrap_or(0.0)
    }

    /// Whether every frame is within the tolerances.
    #[must_use]
    pub const fn is_right(&self) -> bool {
        self.frames > 0 && self.frames_within == self.frames
    }

    /// Whether this playback fits clearly better than another of the same rows: with less than half of its errors.
    #[must_use]
    pub fn fits_better_than(&self, other: &Self) -> bool {
        self.weights < 0.5 * other.weights
    }

    /// The frames within the tolerances, and the largest error with its place: a clause without a full stop.
    #[must_use]
    pub fn clause(&self, scene: &SceneGraph, credit: &Credit) -> String {
        let Some(Worst { off, key_time, node }) = self.worst else { return "there are no frames".to_owned() };
        let path = scene.rbt_paths().nth(node.get()).unwrap_or_default();
        let within = if self.is_right() {
            format!("all {} are", counted(self.frames, "frame"))
        } else {
            let verb = if self.frames_within == 1 { "is" } else { "are" };
            format!("{} of {} {verb}", self.frames_within, counted(self.frames, "frame"))
        };
        let error = match off.fault {
            // Which of the errors of rounding is the largest, is rounding too.
            None if self.largest.0 < 1e-4 && self.largest.1 < 1e-3 => {
                "no error reaches 0.0001 units or 0.001 degrees".to_owned()
            }
            None => format!("the largest error is {} of {path} at key time {key_time:.3}", off.amount(credit)),
            Some(Fault::NoNumber) => format!("{path} has numbers that are NaN or infinite at key time {key_time:.3}"),
            Some(Fault::Length(length)) => {
                format!("the rotation of {path} is not of unit length but {length:.4} long at key time {key_time:.3}")
            }
            Some(Fault::Missing) => format!("{path} has no samples"),
        };
        let rounding =
            if self.is_right() && off.is_rounding(credit) { ", beside the rounding of what is printed" } else { "" };
        format!("{within} within the tolerances{rounding}; {error}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::animation_diff::Tolerances;
    use crate::grading::rubric::Band;
    use crate::rbt::Rbt;
    use glam::Vec3;

    fn judged(units: &[f32], credit: &Credit) -> Judgement {
        let mut judgement = Judgement::default();
        for (frame, units) in units.iter().enumerate() {
            let off = Off::between(Rbt::from_translation(Vec3::X * *units), Rbt::IDENTITY);
            judgement.take(frame as f64, RbtIndex::new(0), off, credit);
            judgement.take(frame as f64, RbtIndex::new(1), Off::between(Rbt::IDENTITY, Rbt::IDENTITY), credit);
        }
        judgement.closed()
    }

    #[test]
    fn shares_are_those_of_the_worst_frame_or_of_the_mean() {
        let tolerances = Tolerances::default();
        let band = Band { tolerances: Tolerances { translation: 0.01, rotation_degrees: 1.0 }, share: 0.5 };
        let plain = Credit::new(tolerances, Vec::new());
        let banded = Credit::new(tolerances, vec![band]);
        let of_frames = |credit: &Credit| Credit { share_of_frames: true, ..credit.clone() };
        let units = [0.0, 0.0, 0.005, 0.0];
        assert_eq!(judged(&units, &plain).share(&plain), 0.0);
        assert_eq!(judged(&units, &banded).share(&banded), 0.5);
        assert_eq!(judged(&units, &plain).share(&of_frames(&plain)), 0.75);
        assert_eq!(judged(&units, &banded).share(&of_frames(&banded)), 0.875);
        assert_eq!(judged(&[], &plain).share(&of_frames(&plain)), 0.0);
        assert!(judged(&[0.0, 0.0005], &plain).is_right() && !judged(&units, &plain).is_right());
        assert!(judged(&[0.0], &plain).fits_better_than(&judged(&[0.1], &plain)));
    }
}
