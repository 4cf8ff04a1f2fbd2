//! Poses at ascending times.

use thiserror::Error;

use super::{LONGEST_STEP, SHORTEST_STEP};
use crate::interpolation::linear_rbt;
use crate::pose::Pose;
use crate::words::{Message, display_by_message, texts};

/// The longest animation, in seconds: more than a day.
pub const LONGEST_SECONDS: f64 = 100_000.0;

/// Samples reach further than [`LONGEST_SECONDS`] after the first one.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub struct TooLong {
    /// The time of the sample after the first one, in seconds.
    pub seconds: f64,
}

display_by_message!(TooLong);

impl TooLong {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        texts::reduced_too_long(format!("{}", self.seconds), format!("{LONGEST_SECONDS}"))
    }
}

/// Poses at ascending times: never none, no two at one time, and no gap that a keyframe's duration could not bridge.
#[derive(Clone, Debug)]
pub struct Samples {
    seconds: Vec<f64>,
    poses: Vec<Pose>,
}

impl Samples {
    /// The first sample, at 0 s.
    #[must_use]
    pub fn starting_with(pose: Pose) -> Self {
        Self { seconds: vec![0.0], poses: vec![pose] }
    }

    /// Samples of a function of the time in seconds: so many a second from 0 on, and at the end. `fps`: above 0.
    ///
    /// # Errors
    /// [`TooLong`]
    pub fn of(seconds: f64, fps: f64, mut pose_at: impl FnMut(f64) -> Pose) -> Result<Self, TooLong> {
        if seconds.is_nan() || seconds > LONGEST_SECONDS {
            return Err(TooLong { seconds });
        }
        let mut samples = Self::starting_with(pose_at(0.0));
        for at in times(seconds, fps) {
            samples.push(at, pose_at(at))?;
        }
        Ok(samples)
    }

    /// Adds a sample with as many nodes as the first. One that is not at least 0.1 ms after the sample before it replaces that.
    ///
    /// # Errors
    /// [`TooLong`]
    pub fn push(&mut self, seconds: f64, pose: Pose) -> Result<(), TooLong> {
        if seconds > LONGEST_SECONDS {
            return Err(TooLong { seconds });
        }
        let last = self.seconds.len() - 1;
        // Rounding must not make a step of just that length too short.
        let is_later = seconds - self.seconds[last] >= SHORTEST_STEP * (1.0 - 1e-9);
        if !is_later {
            self.poses[last] = pose;
            return Ok(());
        }
        let (start, from) = (self.seconds[last], self.poses[last].clone());
        let parts = ((seconds - start) / LONGEST_STEP).ceil();
        let mut part = 1.0;
        while part < parts {
            let alpha = part / parts;
            self.seconds.push(start + (seconds - start) * alpha);
            self.poses.push(between(&from, &pose, alpha));
            part += 1.0;
        }
        self.seconds.push(seconds);
        self.poses.push(pose);
        Ok(())
    }

    /// How many there are; never 0.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "they are never empty")]
    pub fn len(&self) -> usize {
        self.seconds.len()
    }

    /// Their times in seconds, the first 0.
    #[must_use]
    pub fn seconds(&self) -> &[f64] {
        &self.seconds
    }

    /// Their poses.
    #[must_use]
    pub fn poses(&self) -> &[Pose] {
        &self.poses
    }

    /// The time of the last one, in seconds.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.seconds[self.seconds.len() - 1]
    }

    /// The pose at a time in seconds, linearly interpolated; before and after all samples that of the nearest one.
    #[must_use]
    pub fn pose_at(&self, seconds: f64) -> Pose {
        let after = self.seconds.partition_point(|&at| at <= seconds);
        if after == 0 || after == self.seconds.len() {
            return self.poses[after.saturating_sub(1)].clone();
        }
        let (start, end) = (self.seconds[after - 1], self.seconds[after]);
        if seconds == start {
            return self.poses[after - 1].clone();
        }
        between(&self.poses[after - 1], &self.poses[after], (seconds - start) / (end - start))
    }

    /// The same samples, and more of them where two are farther apart than `longest` seconds.
    #[must_use]
    pub fn at_least_every(&self, longest: f64) -> Self {
        let mut finer = Self { seconds: vec![self.seconds[0]], poses: vec![self.poses[0].clone()] };
        for (times, poses) in self.seconds.windows(2).zip(self.poses.windows(2)) {
            let parts = ((times[1] - times[0]) / longest).ceil();
            let mut part = 1.0;
            while part < parts {
                finer.seconds.push(times[0] + (times[1] - times[0]) * part / parts);
                finer.poses.push(between(&poses[0], &poses[1], part / parts));
                part += 1.0;
            }
            finer.seconds.push(times[1]);
            finer.poses.push(poses[1].clone());
        }
        finer
    }

    /// The same animation with so many samples a second, and one at the end. `fps`: above 0.
    #[must_use]
    pub fn every(&self, fps: f64) -> Self {
        let mut even = Self::starting_with(self.poses[0].clone());
        for at in times(self.duration(), fps) {
            // None is later than the last of these samples.
            let _ = even.push(at, self.pose_at(at));
        }
        even
    }
}

/// The times of so many samples a second after 0, and the end. No two are nearer than samples may be.
fn times(seconds: f64, fps: f64) -> impl Iterator<Item = f64> {
    let step = (1.0 / fps).max(SHORTEST_STEP);
    let whole = (1u32..).map(move |index| f64::from(index) * step);
    // A time just before the end is the end.
    whole.take_while(move |&at| at < seconds - 1e-3 * step).chain((seconds > 0.0).then_some(seconds))
}

/// The pose at the fraction `alpha` between two.
fn between(from: &Pose, to: &Pose, alpha: f64) -> Pose {
    #[expect(clippy::cast_possible_truncation, reason = "the interpolation takes f32")]
    let alpha = alpha as f32;
    Pose::new(from.iter().zip(to.iter()).map(|(from, to)| linear_rbt(from, to, alpha)).collect())
}
