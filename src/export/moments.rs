//! The moments that are rendered: of an animation, of a scene with timed keys, or of a still scene with a turntable camera.

use std::path::Path;

use num_rational::BigRational;
use num_traits::FromPrimitive as _;

use super::{Animation, ExportError, FrameTime, Size, Viewpoint, frame_times};
use crate::film::{Grid, Plan};
use crate::keyframe::{KeyframeIndex, KeyframeList, PlayRange, SampleError};
use crate::scene::SceneGraph;
use crate::storage::input_name;

/// Duration of a turn of the turntable if nothing else moves, in milliseconds.
const TURN_MS: u32 = 4000;

/// The source of moments.
#[derive(Clone, Copy)]
pub struct Source<'a> {
    /// The scene that poses are of.
    pub scene: &'a SceneGraph,
    /// The animation, if there is a keyframe file.
    pub animation: Option<&'a Animation>,
    /// The keyframe file, for errors.
    pub file: Option<&'a Path>,
}

/// The pose of a moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MomentPose {
    /// The scene's rest pose.
    Rest,
    /// A keyframe of the list.
    Keyframe(KeyframeIndex),
    /// A sample of the playing range.
    KeyTime(f64),
}

/// A part of an animation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Span {
    /// The key time at which it begins; default: the playing range's start.
    pub from: Option<f64>,
    /// The key time at which it ends; default: the playing range's end.
    pub to: Option<f64>,
    /// The time of the timed keys at its beginning, in seconds.
    pub seconds: f64,
}

/// The pose and the times of one picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// Its pose.
    pub shown: MomentPose,
    /// Seconds into the timed keys.
    pub seconds: f64,
    /// The turn of the turntable, 0 to 1.
    pub turn: f64,
    /// Its number in the film, from 0.
    pub number: usize,
}

impl Moment {
    /// The caption in a contact sheet: key time and seconds, seconds alone, or the camera's angle.
    #[must_use]
    pub fn caption(&self) -> Vec<String> {
        let seconds = format!("{:.2} s", self.seconds);
        match self.shown {
            MomentPose::KeyTime(key_time) => vec![format!("key {key_time:.2}"), seconds],
            MomentPose::Keyframe(index) => vec![format!("key {}", index.get())],
            MomentPose::Rest if self.seconds == 0.0 && self.turn > 0.0 => vec![format!("{:.0}°", 360.0 * self.turn)],
            MomentPose::Rest => vec![seconds],
        }
    }
}

/// The pictures of a film or a contact sheet.
pub struct Moments {
    /// The moments in order.
    pub all: Vec<Moment>,
}

impl Source<'_> {
    /// The name for errors: the file, or the scene if there is no file.
    #[must_use]
    pub fn name(&self) -> String {
        match self.file {
            Some(file) => input_name(file),
            None => format!("scene \"{}\"", self.scene.name()),
        }
    }

    pub(super) fn unplayable(&self, cause: SampleError) -> ExportError {
        ExportError::Unplayable { source_name: self.name(), cause }
    }

    pub(super) fn no_keyframe(&self, index: i64, keyframes: &KeyframeList) -> ExportError {
        let last = keyframes.last().map(KeyframeIndex::get);
        ExportError::NoKeyframe { source_name: self.name(), index, last }
    }

    /// The pose at a key time or of a keyframe; by default at the start of the playing range.
    ///
    /// # Errors
    /// [`ExportError`]: there is no such key time or keyframe.
    pub fn shown(&self, at: Option<f64>, keyframe: Option<i64>) -> Result<MomentPose, ExportError> {
        let Some(animation) = self.animation else { return Ok(MomentPose::Rest) };
        if let Some(index) = keyframe {
            let known = usize::try_from(index).ok().filter(|&known| known < animation.keyframes.len());
            let shown = known.map(|known| MomentPose::Keyframe(KeyframeIndex::new(known)));
            return shown.ok_or_else(|| self.no_keyframe(index, &animation.keyframes));
        }
        let key_time = at.unwrap_or(0.0);
        self.range(animation)?.check(key_time).map_err(|cause| self.unplayable(cause))?;
        Ok(MomentPose::KeyTime(key_time))
    }

    fn range<'b>(&self, animation: &'b Animation) -> Result<PlayRange<'b>, ExportError> {
        PlayRange::new(&animation.keyframes).map_err(|cause| self.unplayable(cause))
    }

    /// The key times at which the span begins and ends.
    #[expect(clippy::cast_precision_loss, reason = "no list has 2^52 keyframes")]
    pub(super) fn key_times(&self, span: Span, animation: &Animation) -> Result<[f64; 2], ExportError> {
        let range = self.range(animation)?;
        let key_times = [span.from.unwrap_or(0.0), span.to.unwrap_or(range.last_key_time() as f64)];
        for key_time in key_times {
            range.check(key_time).map_err(|cause| self.unplayable(cause))?;
        }
        if key_times[0] > key_times[1] {
            return Err(ExportError::Backwards { from: key_times[0], to: key_times[1] });
        }
        Ok(key_times)
    }
}

impl Moments {
    /// A single picture.
    #[must_use]
    pub fn of_picture(shown: MomentPose, seconds: f64) -> Self {
        Self { all: vec![Moment { shown, seconds, turn: 0.0, number: 0 }] }
    }

    /// The pictures of a film: picture k is k · 1000/fps ms after the start while that is before the end; the last picture is the end.
    /// A film shows each for 1000/fps ms, also where the end comes a little sooner: pictures and their rate are all that a film is made of.
    ///
    /// # Errors
    /// [`ExportError`]: a range outside of the playing range, or nothing that moves.
    pub fn of_film(span: Span, source: Source<'_>, viewpoint: Viewpoint, fps: u32) -> Result<Self, ExportError> {
        let seconds_at = |ms: f64| span.seconds + ms / 1000.0;
        let still = |ms| Moment { shown: MomentPose::Rest, seconds: seconds_at(ms), turn: 0.0, number: 0 };
        let mut all: Vec<Moment> = if let Some(animation) = source.animation {
            let [from, to] = source.key_times(span, animation)?;
            let (ms, timing) = (animation.ms_between_keyframes, source.range(animation)?.timing());
            let moment = |key_time: f64, ms| Moment { shown: MomentPose::KeyTime(key_time), ..still(ms) };
            if span.from.is_none() && span.to.is_none() {
                frame_times(fps, ms, timing).map(|time| moment(time.key_time, time.ms)).collect()
            } else {
                let [start, end] = [from, to].map(|key_time| FrameTime::at_key_time(key_time, ms, timing).ms);
                let key_time = |start_ms: f64| {
                    let elapsed = BigRational::from_f64((start + start_ms) / f64::from(ms)).unwrap_or_default();
                    timing.key_time_at(&elapsed).clamp(from, to)
                };
                let mut all: Vec<Moment> =
                    starts(end - start, fps).map(|start_ms| moment(key_time(start_ms), start_ms)).collect();
                // The ends exactly as requested.
                let last = all.len() - 1;
                (all[last].shown, all[0].shown) = (MomentPose::KeyTime(to), MomentPose::KeyTime(from));
                all
            }
        } else if let Some(last_second) = source.scene.last_second().filter(|&second| second > span.seconds) {
            starts((last_second - span.seconds) * 1000.0, fps).map(still).collect()
        } else if viewpoint == Viewpoint::Turntable {
            // The last picture would equal the first.
            starts(f64::from(TURN_MS), fps).take((TURN_MS * fps / 1000) as usize).map(still).collect()
        } else {
            return Err(ExportError::NothingMoves { source_name: source.name() });
        };
        let count = to_f64(all.len());
        for (index, moment) in all.iter_mut().enumerate() {
            (moment.turn, moment.number) = (to_f64(index) / count, index);
        }
        Ok(Self { all })
    }

    /// The pictures of a contact sheet, evenly spread, both ends included.
    ///
    /// # Errors
    /// [`ExportError`]: a range outside of the playing range, or nothing that moves.
    pub fn of_sheet(span: Span, source: Source<'_>, grid: Grid) -> Result<Self, ExportError> {
        let count = grid.columns * grid.rows;
        let fractions = (0..count).map(|index| f64::from(index) / f64::from((count - 1).max(1)));
        let still = Moment { shown: MomentPose::Rest, seconds: span.seconds, turn: 0.0, number: 0 };
        let all = if let Some(animation) = source.animation {
            let [from, to] = source.key_times(span, animation)?;
            let (ms, timing) = (animation.ms_between_keyframes, source.range(animation)?.timing());
            fractions
                .map(|fraction| {
                    let key_time = (from + (to - from) * fraction).min(to);
                    let seconds = span.seconds + FrameTime::at_key_time(key_time, ms, timing).ms / 1000.0;
                    Moment { shown: MomentPose::KeyTime(key_time), seconds, turn: fraction, ..still }
                })
                .collect()
        } else if let Some(last_second) = source.scene.last_second() {
            let length = (last_second - span.seconds).max(0.0);
            fractions
                .map(|fraction| Moment { seconds: span.seconds + length * fraction, turn: fraction, ..still })
                .collect()
        } else {
            (0..count).map(|index| Moment { turn: f64::from(index) / f64::from(count), ..still }).collect()
        };
        Ok(Self { all })
    }

    /// Of these moments of a film, those with these numbers, which are in ascending order.
    #[must_use]
    pub fn with_numbers(&self, numbers: &[usize]) -> Self {
        let is_chosen = |moment: &&Moment| numbers.binary_search(&moment.number).is_ok();
        Self { all: self.all.iter().filter(is_chosen).copied().collect() }
    }

    /// The properties of a film of these moments.
    ///
    /// # Errors
    /// [`ExportError::TooManyFrames`]
    pub fn plan(&self, size: Size, frames_per_second: u32, is_opaque: bool) -> Result<Plan, ExportError> {
        Plan::new([size.width, size.height], self.all.len(), frames_per_second, is_opaque)
            .ok_or(ExportError::TooManyFrames)
    }
}

/// 0, 1000/fps, … ms while before the end, and the end.
fn starts(end_ms: f64, fps: u32) -> impl Iterator<Item = f64> {
    let start_ms = move |frame: u32| f64::from(frame) * 1000.0 / f64::from(fps);
    // A start that is before the end only by rounding is the end.
    (0..).map(start_ms).take_while(move |&start_ms| start_ms < end_ms - 1e-6).chain(std::iter::once(end_ms))
}

#[expect(clippy::cast_precision_loss, reason = "there are fewer than 2^52 frames")]
fn to_f64(count: usize) -> f64 {
    count as f64
}

#[cfg(test)]
mod tests {
    use super::starts;

    #[test]
    fn starts_run_to_the_end() {
        assert_eq!(starts(100.0, 20).collect::<Vec<_>>(), [0.0, 50.0, 100.0]);
        assert_eq!(starts(120.0, 20).collect::<Vec<_>>(), [0.0, 50.0, 100.0, 120.0]);
        assert_eq!(starts(0.0, 20).collect::<Vec<_>>(), [0.0]);
        assert_eq!(starts(1000.0, 30).count(), 31);
    }
}
