//! The times of frames: key time, and milliseconds from the start of playing.

use num_traits::ToPrimitive as _;

use crate::keyframe::{Timing, to_f64, whole};

/// One frame's time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameTime {
    /// The key time, from 0.
    pub key_time: f64,
    /// Milliseconds from the start.
    pub ms: f64,
}

impl FrameTime {
    /// The frame at a key time.
    #[must_use]
    pub fn at_key_time(key_time: f64, ms_between_keyframes: u32, timing: &Timing) -> Self {
        let ms = timing.elapsed_at(key_time) * whole(ms_between_keyframes as usize);
        Self { key_time, ms: to_f64(&ms) }
    }
}

/// The frames of a whole playing range: frame k at k · 1000/fps ms while that is before the end, and the end.
///
/// The comparison with the end is exact; each time is rounded once.
#[expect(clippy::range_plus_one, reason = "a range with its end included does not know its length")]
#[must_use]
pub fn frame_times(
    fps: u32,
    ms_between_keyframes: u32,
    timing: &Timing,
) -> impl ExactSizeIterator<Item = FrameTime> + use<> {
    let ms_per_unit = whole(ms_between_keyframes as usize);
    let end_ms = timing.total() * &ms_per_unit;
    let ms_per_frame = whole(1000) / whole(fps as usize);
    let before_end = (&end_ms / &ms_per_frame).ceil().to_integer().to_usize().unwrap_or(usize::MAX - 1);
    let timing = timing.clone();
    (0..before_end + 1).map(move |frame| {
        let ms = if frame == before_end { end_ms.clone() } else { whole(frame) * &ms_per_frame };
        FrameTime { key_time: timing.key_time_at(&(&ms / &ms_per_unit)), ms: to_f64(&ms) }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keyframe::Keyframe;
    use crate::pose::Pose;

    fn timing(intervals: usize) -> Timing {
        Timing::of(&vec![Keyframe::new(Pose::new(Vec::new())); intervals + 3]).unwrap()
    }

    #[test]
    fn frames_run_to_the_end_and_the_end_is_the_last() {
        let times: Vec<FrameTime> = frame_times(3, 500, &timing(2)).collect();
        let ms: Vec<f64> = times.iter().map(|time| time.ms).collect();
        assert_eq!(ms, [0.0, 1000.0 / 3.0, 2000.0 / 3.0, 1000.0]);
        assert_eq!(times[1], FrameTime { key_time: 1000.0 / 1500.0, ms: 1000.0 / 3.0 });
        assert_eq!(times[3], FrameTime { key_time: 2.0, ms: 1000.0 });
    }

    #[test]
    fn an_end_between_two_frames_still_comes() {
        let ms: Vec<f64> = frame_times(2, 1300, &timing(1)).map(|time| time.ms).collect();
        assert_eq!(ms, [0.0, 500.0, 1000.0, 1300.0]);
        assert_eq!(frame_times(1, 100, &timing(1)).len(), 2);
        assert_eq!(frame_times(60, 2000, &timing(1)).len(), 121);
    }
}
