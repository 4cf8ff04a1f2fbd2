//! Easing: maps the fraction of an interval between two keyframes from elapsed to shown.

use std::f64::consts::{FRAC_PI_2, TAU};

/// The shape of an easing curve, after Robert Penner's easing functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Curve {
    /// `1 − cos(x π/2)`.
    Sine,
    /// `x²`.
    Quad,
    /// `x³`.
    Cubic,
    /// A cubic that overshoots by 10 %.
    Back,
    /// A bouncing ball.
    Bounce,
    /// A damped spring.
    Elastic,
}

/// The end of the interval at which an easing curve is slow.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Ends {
    /// Slow at the beginning.
    In,
    /// Slow at the end.
    Out,
    /// Slow at both ends.
    InOut,
}

/// The easing of an interval.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Easing {
    /// Constant speed.
    #[default]
    Linear,
    /// The interval shows the keyframe at which it begins.
    Hold,
    /// Along a curve.
    Curve(Curve, Ends),
}

const NAMES: [(Curve, [&str; 3]); 6] = [
    (Curve::Sine, ["sine-in", "sine-out", "sine-in-out"]),
    (Curve::Quad, ["quad-in", "quad-out", "quad-in-out"]),
    (Curve::Cubic, ["cubic-in", "cubic-out", "cubic-in-out"]),
    (Curve::Back, ["back-in", "back-out", "back-in-out"]),
    (Curve::Bounce, ["bounce-in", "bounce-out", "bounce-in-out"]),
    (Curve::Elastic, ["elastic-in", "elastic-out", "elastic-in-out"]),
];

impl Easing {
    /// Every easing, in menu order.
    pub fn all() -> impl Iterator<Item = Self> {
        let curves = NAMES
            .iter()
            .flat_map(|&(curve, _)| [Ends::In, Ends::Out, Ends::InOut].map(|ends| Self::Curve(curve, ends)));
        [Self::Linear, Self::Hold].into_iter().chain(curves)
    }

    /// Its name in files: `linear`, `hold`, `sine-in-out`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Hold => "hold",
            Self::Curve(curve, ends) => {
                let names = NAMES.iter().find(|(named, _)| *named == curve).map(|(_, names)| names);
                names.expect("every curve has its names")[ends as usize]
            }
        }
    }

    /// The easing with this name in files; `None` if there is none.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::all().find(|easing| easing.name() == name)
    }

    /// The eased fraction: 0 at 0 and 1 at 1, exactly; `back` and `elastic` leave [0, 1] in between. `hold` is 0 below 1.
    #[must_use]
    pub fn value(self, fraction: f64) -> f64 {
        match self {
            _ if fraction <= 0.0 => 0.0,
            _ if fraction >= 1.0 => 1.0,
            Self::Linear => fraction,
            Self::Hold => 0.0,
            Self::Curve(curve, Ends::In) => curve.rise(fraction),
            Self::Curve(curve, Ends::Out) => 1.0 - curve.rise(1.0 - fraction),
            Self::Curve(curve, Ends::InOut) if fraction < 0.5 => 0.5 * curve.rise_of_half(2.0 * fraction),
            Self::Curve(curve, Ends::InOut) => 1.0 - 0.5 * curve.rise_of_half(2.0 - 2.0 * fraction),
        }
    }

    /// The fractions between 0 and 1 at which the speed jumps, ascending.
    #[must_use]
    pub fn kinks(self) -> Vec<f64> {
        let Self::Curve(Curve::Bounce, ends) = self else { return Vec::new() };
        let of_in = || GROUND.map(|fraction| 1.0 - fraction).into_iter().rev();
        match ends {
            Ends::In => of_in().collect(),
            Ends::Out => GROUND.to_vec(),
            Ends::InOut => {
                let first = of_in().map(|fraction| 0.5 * fraction);
                first.chain(GROUND.map(|fraction| 0.5 + 0.5 * fraction)).collect()
            }
        }
    }
}

impl Curve {
    /// The curve that is slow at the beginning, for a fraction between 0 and 1. The formulas are Robert Penner's, as at
    /// <https://easings.net>.
    fn rise(self, x: f64) -> f64 {
        match self {
            Self::Sine => 1.0 - (x * FRAC_PI_2).cos(),
            Self::Quad => x * x,
            Self::Cubic => x * x * x,
            Self::Back => backed(x, OVERSHOOT),
            Self::Bounce => 1.0 - bounced(1.0 - x),
            Self::Elastic => -(2.0_f64.powf(10.0 * x - 10.0)) * ((10.0 * x - 10.75) * TAU / 3.0).sin(),
        }
    }

    /// The first half of the curve that is slow at both ends, scaled to fractions and values from 0 to 1. Of `back` and `elastic` it is not
    /// the curve that is slow at the beginning: Penner's overshoot there is larger, and his spring slower.
    fn rise_of_half(self, x: f64) -> f64 {
        match self {
            Self::Back => backed(x, 1.525 * OVERSHOOT),
            Self::Elastic => -(2.0_f64.powf(10.0 * x - 10.0)) * ((10.0 * x - 11.125) * TAU / 4.5).sin(),
            Self::Sine | Self::Quad | Self::Cubic | Self::Bounce => self.rise(x),
        }
    }
}

/// Makes the overshoot of `back` 10 %.
const OVERSHOOT: f64 = 1.701_58;

/// A cubic that first goes back, the farther the larger the overshoot.
fn backed(x: f64, overshoot: f64) -> f64 {
    x * x * ((overshoot + 1.0) * x - overshoot)
}

/// The width of all bounces, of which the first one is 1 to the ground.
const WIDTH: f64 = 2.75;
/// When the ball is on the ground, before the end.
const GROUND: [f64; 3] = [1.0 / WIDTH, 2.0 / WIDTH, 2.5 / WIDTH];

/// The distance that a dropped ball has fallen, with three bounces: 0 at 0, and 1 (the ground) at 1.
fn bounced(x: f64) -> f64 {
    const HEIGHT: f64 = 7.5625;
    let (middle, floor) = if x < GROUND[0] {
        (0.0, 0.0)
    } else if x < GROUND[1] {
        (1.5, 0.75)
    } else if x < GROUND[2] {
        (2.25, 0.9375)
    } else {
        (2.625, 0.984_375)
    };
    let x = x - middle / WIDTH;
    HEIGHT * x * x + floor
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_easing_meets_both_ends_and_reads_back() {
        assert_eq!(Easing::all().count(), 20);
        for easing in Easing::all() {
            assert_eq!((easing.value(0.0), easing.value(1.0)), (0.0, 1.0), "{}", easing.name());
            assert_eq!(Easing::from_name(easing.name()), Some(easing));
            let mut before = easing.value(0.0);
            for step in 1..1000 {
                let value = easing.value(f64::from(step) / 1000.0);
                assert!((-0.4..=1.4).contains(&value), "{} at {step}: {value}", easing.name());
                assert!((value - before).abs() < 0.05 || easing == Easing::Hold, "{} jumps at {step}", easing.name());
                before = value;
            }
        }
    }

    #[test]
    fn the_speed_jumps_at_the_kinks_and_nowhere_else() {
        const STEP: f64 = 1e-7;
        for easing in Easing::all() {
            let speed = |from: f64| (easing.value(from + STEP) - easing.value(from)) / STEP;
            let jump = |at: f64| (speed(at) - speed(at - STEP)).abs();
            let kinks = easing.kinks();
            assert!(kinks.is_sorted() && kinks.iter().all(|&kink| jump(kink) > 0.5), "{} {kinks:?}", easing.name());
            // Between them the speed changes little by little.
            for at in (1..1000).map(|step| f64::from(step) / 1000.0) {
                let far = (speed(at - 4e-4) - speed(at + 4e-4)).abs();
                let is_at_kink = kinks.iter().any(|kink| (kink - at).abs() <= 5e-4);
                assert!(far < 0.5 || is_at_kink, "{} at {at}: {far}", easing.name());
            }
        }
    }

    #[test]
    fn known_values() {
        let at = |name: &str, fraction| Easing::from_name(name).unwrap().value(fraction);
        assert_eq!(at("quad-in", 0.5), 0.25);
        assert_eq!(at("quad-out", 0.5), 0.75);
        assert_eq!(at("cubic-in-out", 0.25), 0.0625);
        assert_eq!(at("hold", 0.999), 0.0);
        assert!((at("sine-in-out", 0.5) - 0.5).abs() < 1e-12);
        assert!(at("back-in", 0.3) < 0.0 && at("back-out", 0.7) > 1.0);
        // By the formulas at easings.net, in another language.
        for (name, fraction, expected) in [
            ("back-in-out", 0.25, -0.099_681_843_75),
            ("back-in-out", 0.75, 1.099_681_843_75),
            ("elastic-in-out", 0.25, 0.011_969_444_423_734_026),
            ("elastic-in-out", 0.4, -0.117_461_578_485_772_4),
            ("elastic-in-out", 0.6, 1.117_461_578_485_772_4),
            ("elastic-in", 0.7, 0.125),
        ] {
            assert!((at(name, fraction) - expected).abs() < 1e-9, "{name} at {fraction}: {}", at(name, fraction));
        }
    }
}
