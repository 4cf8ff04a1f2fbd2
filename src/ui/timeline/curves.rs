//! Curves of one node over time, without painting.

use std::ops::RangeInclusive;

use super::columns::Columns;
use super::half_turn::degrees_between;
use crate::interpolation::Interpolation;
use crate::keyframe::{KeyframeIndex, KeyframeList, PlayRange};
use crate::pose::RbtIndex;
use crate::rbt::Rbt;
use crate::words::{Phrase, texts};

/// Half the time interval of the difference quotient for speeds, in units.
const HALF_STEP: f64 = 0.004;

/// The quantity that a graph shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// x, y and z in the parent's space.
    Translation,
    /// Degrees from the first keyframe's rotation.
    Angle,
    /// Units a second.
    Speed,
    /// Degrees a second.
    AngularSpeed,
}

impl Quantity {
    /// All of them, in the order of the legend.
    pub const ALL: [Self; 4] = [Self::Translation, Self::Angle, Self::Speed, Self::AngularSpeed];

    /// What people call it.
    pub const fn name(self) -> Phrase {
        match self {
            Self::Translation => texts::TRANSLATION,
            Self::Angle => texts::QUANTITY_ANGLE,
            Self::Speed => texts::QUANTITY_SPEED,
            Self::AngularSpeed => texts::QUANTITY_ANGULAR_SPEED,
        }
    }

    /// The unit that follows its numbers.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Translation => "",
            Self::Angle => "°",
            Self::Speed => " /s",
            Self::AngularSpeed => "°/s",
        }
    }
}

/// One node's movement under one interpolation.
#[derive(Clone, Copy)]
pub struct Movement<'a> {
    list: &'a KeyframeList,
    range: &'a PlayRange<'a>,
    columns: &'a Columns,
    interpolation: Interpolation,
    rbt: RbtIndex,
    seconds_per_unit: f64,
}

impl<'a> Movement<'a> {
    /// The movement of a node; `ms` between keyframes.
    pub fn new(
        list: &'a KeyframeList,
        range: &'a PlayRange<'a>,
        columns: &'a Columns,
        interpolation: Interpolation,
        rbt: RbtIndex,
        ms: u32,
    ) -> Self {
        Self { list, range, columns, interpolation, rbt, seconds_per_unit: f64::from(ms) / 1000.0 }
    }

    /// Where the node is at a time.
    fn rbt_at(&self, time: f64) -> Rbt {
        let key_time = self.columns.key_at(time);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it lies in the list")]
        let start = key_time.floor() as usize + 1;
        #[expect(clippy::cast_possible_truncation, reason = "a fraction needs no more than f32")]
        let alpha = self.list.as_slice()[start].easing.value(key_time.fract()) as f32;
        self.range.rbt_at(KeyframeIndex::new(start), alpha, self.interpolation, self.rbt)
    }

    /// What a graph shows at a time: three values of the translation, one of all else.
    pub fn values(&self, quantity: Quantity, time: f64) -> [f32; 3] {
        match quantity {
            Quantity::Translation => self.rbt_at(time).translation.to_array(),
            Quantity::Angle => {
                let first = self.list.as_slice()[0].pose.get(self.rbt).rotation;
                [degrees_between(first, self.rbt_at(time).rotation); 3]
            }
            Quantity::Speed | Quantity::AngularSpeed => {
                let (first, last) = (self.columns.time(1), self.columns.time(self.list.len() - 2));
                let (before, after) = ((time - HALF_STEP).max(first), (time + HALF_STEP).min(last));
                let (from, to) = (self.rbt_at(before), self.rbt_at(after));
                let way = match quantity {
                    Quantity::Speed => from.translation.distance(to.translation),
                    _ => degrees_between(from.rotation, to.rotation),
                };
                #[expect(clippy::cast_possible_truncation, reason = "it is for points on a screen")]
                let seconds = ((after - before) * self.seconds_per_unit) as f32;
                [if seconds > 0.0 { way / seconds } else { 0.0 }; 3]
            }
        }
    }

    /// Sample times of a range with the given step, and the times of keyframes that are not closer together than that.
    pub fn times(&self, seen: &RangeInclusive<f64>, step: f64) -> Vec<f64> {
        let (first, last) = (self.columns.time(1), self.columns.time(self.list.len() - 2));
        let (from, to) = (seen.start().max(first), seen.end().min(last));
        let mut times = Vec::new();
        if from > to {
            return times;
        }
        // Samples are multiples of the step, so that the curve does not flicker while it is panned.
        let mut next = (from / step).floor() * step;
        let keyframes = self.columns.within(&(from..=to));
        let own = if keyframes.len() < 400 { keyframes } else { 0..0 };
        times.push(from);
        while next < to {
            if next > from {
                times.push(next);
            }
            next += step;
        }
        times.extend(own.map(|index| self.columns.time(index)));
        times.push(to);
        times.sort_by(f64::total_cmp);
        times.dedup();
        times
    }
}

/// The least and the largest of some values, with room beyond them; never empty.
pub fn room(values: impl Iterator<Item = f32>, least: f32) -> (f32, f32) {
    let (low, high) = values
        .filter(|value| value.is_finite())
        .fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    if low > high {
        return (0.0, least);
    }
    let more = ((high - low) * 0.1).max((least - (high - low)) / 2.0);
    (low - more, high + more)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keyframe::Keyframe;
    use crate::pose::Pose;
    use glam::{Quat, Vec3};

    fn list(xs: &[f32]) -> KeyframeList {
        let rbt = |&x: &f32| Rbt::new(Vec3::new(x, 0.0, 0.0), Quat::from_rotation_y(x));
        KeyframeList::new(xs.iter().map(|x| Keyframe::new(Pose::new(vec![rbt(x)]))).collect())
    }

    #[test]
    fn speed_and_angle_are_those_of_the_movement() {
        let list = list(&[0.0, 0.0, 0.5, 1.5, 2.0]);
        let mut columns = Columns::default();
        columns.update(&list);
        let range = PlayRange::new(&list).unwrap();
        let movement = Movement::new(&list, &range, &columns, Interpolation::Linear, RbtIndex::new(0), 500);
        for (quantity, time, expected) in [
            (Quantity::Translation, 0.5, 0.25),
            (Quantity::Angle, 1.0, 0.5_f32.to_degrees()),
            (Quantity::Speed, 0.5, 1.0),
            (Quantity::Speed, 1.5, 2.0),
            (Quantity::Speed, 0.0, 1.0),
            (Quantity::AngularSpeed, 1.5, 2.0_f32.to_degrees()),
        ] {
            let value = movement.values(quantity, time)[0];
            assert!((value - expected).abs() < expected * 1e-3, "{quantity:?} at {time}: {value}, not {expected}");
        }
        let times = movement.times(&(-5.0..=9.0), 0.3);
        assert_eq!((times.first(), times.last()), (Some(&0.0), Some(&2.0)));
        assert!(times.contains(&1.0) && times.is_sorted());
    }

    #[test]
    fn there_is_room_round_values() {
        assert_eq!(room([1.0, 1.0].into_iter(), 2.0), (0.0, 2.0));
        assert_eq!(room([].into_iter(), 2.0), (0.0, 2.0));
        let (low, high) = room([0.0, 10.0, f32::NAN].into_iter(), 1.0);
        assert!((low, high) == (-1.0, 11.0));
    }
}
