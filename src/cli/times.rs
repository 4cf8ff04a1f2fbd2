//! When frames are: key times and milliseconds from the start of playing.

/// One frame's time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameTime {
    /// Played keyframes, from 0.
    pub key_time: f64,
    /// Milliseconds from the start.
    pub ms: f64,
}

impl FrameTime {
    /// The frame at a key time.
    #[must_use]
    pub fn at_key_time(key_time: f64, ms_between_keyframes: u32) -> Self {
        Self { key_time, ms: key_time * f64::from(ms_between_keyframes) }
    }
}

/// The frames of a whole playing range: frame k at k · 1000/fps ms while that is short of the end, and the end.
///
/// What is short of the end is decided in whole numbers; each time is rounded once.
#[expect(clippy::cast_precision_loss, reason = "times in whole milliseconds stay far below 2^53")]
pub fn frame_times(
    fps: u32,
    ms_between_keyframes: u32,
    last_key_time: usize,
) -> impl ExactSizeIterator<Item = FrameTime> {
    let end_ms = last_key_time * ms_between_keyframes as usize;
    let before_end = (end_ms * fps as usize).div_ceil(1000);
    let count = before_end + 1;
    (0..count).map(move |frame| {
        if frame == before_end {
            return FrameTime { key_time: last_key_time as f64, ms: end_ms as f64 };
        }
        let thousandths = (1000 * frame) as f64;
        let fps = f64::from(fps);
        FrameTime { key_time: thousandths / (fps * f64::from(ms_between_keyframes)), ms: thousandths / fps }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_run_to_the_end_and_the_end_is_the_last() {
        let times: Vec<FrameTime> = frame_times(3, 500, 2).collect();
        let ms: Vec<f64> = times.iter().map(|time| time.ms).collect();
        assert_eq!(ms, [0.0, 1000.0 / 3.0, 2000.0 / 3.0, 1000.0]);
        assert_eq!(times[1], FrameTime { key_time: 1000.0 / 1500.0, ms: 1000.0 / 3.0 });
        assert_eq!(times[3], FrameTime { key_time: 2.0, ms: 1000.0 });
    }

    #[test]
    fn an_end_between_two_frames_still_comes() {
        let ms: Vec<f64> = frame_times(2, 1300, 1).map(|time| time.ms).collect();
        assert_eq!(ms, [0.0, 500.0, 1000.0, 1300.0]);
        assert_eq!(frame_times(1, 100, 1).len(), 2);
        assert_eq!(frame_times(60, 2000, 1).len(), 121);
    }
}
