//! The keyframes of an animation that this program exported: at the times that its file still says, if its motion is still that.

use std::sync::Arc;

use serde_json::{Map, Value};

use super::steering::{Moved, steer};
use crate::interchange::reduce::{Tolerance, beyond};
use crate::interpolation::Interpolation;
use crate::keyframe::{
    Animation, DURATION_RANGE, Easing, Keyframe, KeyframeIndex, KeyframeList, MS_BETWEEN_KEYFRAMES_RANGE, PlayRange,
};
use crate::pose::{Pose, RbtIndex};

/// How far the times of a file may be from those of its keys, in seconds: they are written in single precision.
const SAME_TIME: f64 = 1e-3;
/// The fractions of an interval at which motions are compared.
const FRACTIONS: [f64; 4] = [0.2, 0.4, 0.6, 0.8];
/// The most keyframes that a pace is read of.
const MOST_KEYFRAMES: usize = 1 << 20;

/// How an animation played before it was exported.
pub(super) struct Pace {
    interpolation: Interpolation,
    ms_between_keyframes: u32,
    /// Of the intervals between played keyframes.
    intervals: Vec<(f64, Easing)>,
    names: Vec<Option<Arc<str>>>,
}

impl Pace {
    /// What a file says, for an animation that ends at a time in seconds; `None` if it says no such pace.
    pub fn of(own: &Map<String, Value>, end: f64) -> Option<Self> {
        let interpolation = Interpolation::from_name(own.get("interpolation")?.as_str()?)?;
        let ms_between_keyframes = u32::try_from(own.get("ms_between_keyframes")?.as_u64()?).ok()?;
        if !MS_BETWEEN_KEYFRAMES_RANGE.contains(&ms_between_keyframes) {
            return None;
        }
        let list = |name: &str| own.get(name).and_then(Value::as_array);
        let (durations, easings, names) = (list("durations"), list("easings"), list("names"));
        let of_end = (end * 1000.0 / f64::from(ms_between_keyframes)).round();
        let count = durations.or(easings).map_or(of_end as usize, Vec::len);
        let interval = |at: usize| {
            let duration = durations.map_or(Some(1.0), |list| list.get(at)?.as_f64())?;
            let easing = easings.map_or(Some(Easing::Linear), |list| Easing::from_name(list.get(at)?.as_str()?))?;
            DURATION_RANGE.contains(&duration).then_some((duration, easing))
        };
        let intervals = (0..count.min(MOST_KEYFRAMES)).map(interval).collect::<Option<Vec<_>>>()?;
        let name = |at: usize| names.and_then(|names| Some(Arc::from(names.get(at)?.as_str()?)));
        let names = (0..=intervals.len()).map(name).collect();
        let pace = Self { interpolation, ms_between_keyframes, intervals, names };
        let ends = pace.times().last().copied().unwrap_or(0.0);
        (count > 0 && (ends - end).abs() < SAME_TIME).then_some(pace)
    }

    /// The times of the played keyframes in seconds.
    pub fn times(&self) -> Vec<f64> {
        let unit = f64::from(self.ms_between_keyframes) / 1000.0;
        let mut elapsed = 0.0;
        let mut times = vec![0.0];
        for (duration, _) in &self.intervals {
            elapsed += duration * unit;
            times.push(elapsed);
        }
        times
    }

    /// The animation, and how far it is from the motion; `None` if that is farther than `allowed`, so that the motion is another by now.
    /// `keys`: the times of the motion's keys, ascending.
    pub fn animation(&self, keys: &[f64], allowed: Tolerance, moved: &impl Moved) -> Option<(Animation, Tolerance)> {
        // At the key itself, so that no value is interpolated.
        let at_key = |seconds: f64| {
            let after = keys.partition_point(|&key| key < seconds);
            let near = [after.saturating_sub(1), after].into_iter().filter_map(|at| keys.get(at)).copied();
            near.min_by(|a, b| (a - seconds).abs().total_cmp(&(b - seconds).abs()))
                .filter(|key| (key - seconds).abs() < SAME_TIME)
                .unwrap_or(seconds)
        };
        let times = self.times();
        let poses: Vec<Pose> = times.iter().map(|&seconds| moved.pose_at(at_key(seconds))).collect();
        let last = poses.len() - 1;
        let ends = [beyond(&poses[1], &poses[0]), beyond(&poses[last - 1], &poses[last])];
        let mut keyframes = vec![Keyframe::new(ends[0].clone())];
        for (at, pose) in poses.into_iter().enumerate() {
            let (duration, easing) = self.intervals.get(at).copied().unwrap_or((1.0, Easing::Linear));
            keyframes.push(Keyframe { duration, easing, name: self.names[at].clone(), ..Keyframe::new(pose) });
        }
        keyframes.push(Keyframe::new(ends[1].clone()));
        if self.interpolation == Interpolation::CatmullRom {
            steer(&mut keyframes, self, &times, moved);
        }
        let list = KeyframeList::new(keyframes);
        let worst = self.worst(&list, &times, moved);
        let is_same = worst.degrees <= allowed.degrees && worst.units <= allowed.units;
        let (interpolation, ms_between_keyframes) = (self.interpolation, self.ms_between_keyframes);
        is_same.then_some((Animation { keyframes: list, interpolation, ms_between_keyframes }, worst))
    }

    /// The easing of an interval between played keyframes.
    pub fn easing(&self, interval: usize) -> Easing {
        self.intervals[interval].1
    }

    /// How far keyframes are from the motion, at worst.
    fn worst(&self, list: &KeyframeList, times: &[f64], moved: &impl Moved) -> Tolerance {
        let mut worst = Tolerance { degrees: 0.0, units: 0.0 };
        let Ok(range) = PlayRange::new(list) else { return worst };
        for (at, (_, easing)) in self.intervals.iter().enumerate() {
            for fraction in FRACTIONS {
                let pose = moved.pose_at(times[at] + (times[at + 1] - times[at]) * fraction);
                let alpha = easing.value(fraction) as f32;
                for (node, wanted) in pose.iter().enumerate() {
                    let rbt = RbtIndex::new(node);
                    let played = range.rbt_at(KeyframeIndex::new(at + 1), alpha, self.interpolation, rbt);
                    let off = Tolerance::between(played, wanted);
                    worst = Tolerance { degrees: worst.degrees.max(off.degrees), units: worst.units.max(off.units) };
                }
            }
        }
        worst
    }
}
