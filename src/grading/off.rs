//! How far a node that was shown is from what is right.

use glam::{DQuat, DVec3, DVec4};

use super::rubric::Credit;
use crate::animation_diff::distances;
use crate::diagnosis::{Row, Tolerances as Rounding};
use crate::rbt::Rbt;

/// A printed rotation whose length is further from 1 than this, beside its rounding, is no rotation: it scales what it turns.
const LENGTH_ERROR: f64 = 1e-3;

/// Why a sample is beyond any tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// A number is NaN or infinite.
    NoNumber,
    /// The rotation has this length.
    Length(f64),
    /// The node is never shown.
    Missing,
}

/// How far one node is off at one moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Off {
    /// The distance of translations, in scene units.
    pub units: f64,
    /// The angle between rotations, in degrees.
    pub degrees: f64,
    /// What remains of both distances if every printed number may be off by its rounding.
    beyond: (f64, f64),
    /// Why it is beyond any tolerance; the distances are then 0.
    pub fault: Option<Fault>,
}

impl Off {
    /// The distance of two transforms, neither of them printed.
    #[must_use]
    pub fn between(shown: Rbt, right: Rbt) -> Self {
        let (units, degrees) = distances(shown, right);
        Self { units, degrees, beyond: (units, degrees), fault: None }
    }

    /// Nothing is comparable.
    pub fn faulty(fault: Fault) -> Self {
        Self { units: 0.0, degrees: 0.0, beyond: (f64::INFINITY, f64::INFINITY), fault: Some(fault) }
    }

    /// The share of the points that it earns.
    #[must_use]
    pub fn share(&self, credit: &Credit) -> f64 {
        credit.share(self.beyond.0, self.beyond.1)
    }

    /// How large it is beside the rounding, in units of the tolerances: the larger of both errors.
    #[must_use]
    pub fn weight(&self, credit: &Credit) -> f64 {
        let [units, degrees] = weights(self.beyond, credit);
        units.max(degrees)
    }

    /// Whether it is larger than another: first beside the rounding, then with it.
    #[must_use]
    pub fn is_worse_than(&self, other: &Self, credit: &Credit) -> bool {
        let rank = |off: &Self| {
            let [units, degrees] = weights((off.units, off.degrees), credit);
            (off.weight(credit), units.max(degrees))
        };
        rank(self) > rank(other)
    }

    /// Whether it is beyond the tolerances, but within them if the numbers are as far off as they may be.
    #[must_use]
    pub fn is_rounding(&self, credit: &Credit) -> bool {
        let [units, degrees] = weights((self.units, self.degrees), credit);
        self.weight(credit) <= 1.0 && units.max(degrees) > 1.0
    }

    /// Whether the translation is within the tolerances, and whether the rotation is.
    #[must_use]
    pub fn parts_within(&self, credit: &Credit) -> [bool; 2] {
        let tolerances = credit.bands[0].tolerances;
        [self.beyond.0 <= tolerances.translation, self.beyond.1 <= tolerances.rotation_degrees]
    }

    /// The nearer translation and the nearer rotation of two distances of one sample.
    #[must_use]
    pub fn nearer(self, other: Self) -> Self {
        let (moved, turned) = (self.beyond.0 <= other.beyond.0, self.beyond.1 <= other.beyond.1);
        Self {
            units: if moved { self.units } else { other.units },
            degrees: if turned { self.degrees } else { other.degrees },
            beyond: (self.beyond.0.min(other.beyond.0), self.beyond.1.min(other.beyond.1)),
            fault: self.fault,
        }
    }

    /// Whether the error of the rotation is the larger one, in units of the tolerances.
    #[must_use]
    pub fn is_turn(&self, credit: &Credit) -> bool {
        let beyond = weights(self.beyond, credit);
        let [units, degrees] = weights((self.units, self.degrees), credit);
        (beyond[1], degrees) > (beyond[0], units)
    }

    /// The error in words, such as `2.600 degrees`: the larger one in units of the tolerances.
    #[must_use]
    pub fn amount(&self, credit: &Credit) -> String {
        if self.is_turn(credit) { format!("{:.3} degrees", self.degrees) } else { format!("{:.4} units", self.units) }
    }
}

/// Distances of translations and of rotations in units of the tolerances.
fn weights((units, degrees): (f64, f64), credit: &Credit) -> [f64; 2] {
    let tolerances = credit.bands[0].tolerances;
    [units / tolerances.translation.max(1e-9), degrees / tolerances.rotation_degrees.max(1e-9)]
}

/// A printed transform.
#[derive(Clone, Copy)]
pub struct Printed<'a> {
    /// The numbers.
    pub row: &'a Row,
    /// How far each may be off.
    pub rounding: &'a Rounding,
}

impl Printed<'_> {
    /// Why it is beyond any tolerance, if it is.
    #[must_use]
    pub fn fault(&self) -> Option<Fault> {
        let Row { translation, rotation_wxyz, .. } = self.row;
        if !translation.is_finite() || rotation_wxyz.iter().any(|part| !part.is_finite()) {
            return Some(Fault::NoNumber);
        }
        let length = DVec4::from(*rotation_wxyz).length();
        let rounding = DVec4::from(self.rounding.rotation).length();
        ((length - 1.0).abs() > LENGTH_ERROR + rounding).then_some(Fault::Length(length))
    }

    /// How far it is from the nearest point of the ways between right transforms, of which there is at least one.
    #[must_use]
    pub fn off(&self, way: &[(DVec3, DQuat)]) -> Off {
        if let Some(fault) = self.fault() {
            return Off::faulty(fault);
        }
        let near = |index: usize| {
            let (next, here) = (way.get(index + 1).unwrap_or(&way[index]), &way[index]);
            let (units, units_beyond) = self.units(here.0, next.0);
            let (degrees, degrees_beyond) = self.degrees(here.1, next.1);
            Off { units, degrees, beyond: (units_beyond, degrees_beyond), fault: None }
        };
        (1..way.len().saturating_sub(1).max(1)).map(near).fold(near(0), Off::nearer)
    }

    /// The distance of translations from a straight way, and what remains of it beside the rounding.
    fn units(&self, from: DVec3, to: DVec3) -> (f64, f64) {
        let shown = self.row.translation;
        let along = to - from;
        let fraction = ((shown - from).dot(along) / along.length_squared().max(1e-300)).clamp(0.0, 1.0);
        let apart = shown - (from + along * fraction);
        let beyond = (apart.abs() - DVec3::from(self.rounding.translation)).max(DVec3::ZERO);
        (apart.length(), beyond.length())
    }

    /// The angle to a way from one rotation to another that is near, in degrees, and what remains of it beside the rounding.
    fn degrees(&self, from: DQuat, to: DQuat) -> (f64, f64) {
        let wxyz = |q: DQuat| DVec4::new(q.w, q.x, q.y, q.z);
        let printed = DVec4::from(self.row.rotation_wxyz);
        let rounding = DVec4::from(self.rounding.rotation);
        let towards = |near: DVec4, q: DVec4| if near.dot(q) < 0.0 { -q } else { q };
        let from = towards(printed, wxyz(from));
        let along = towards(from, wxyz(to)) - from;
        let fraction = ((printed - from).dot(along) / along.length_squared().max(1e-300)).clamp(0.0, 1.0);
        let right = (from + along * fraction).normalize();
        let of_chord = |chord: f64| (4.0 * (chord / 2.0).min(1.0).asin()).to_degrees();
        let beyond = |shown: DVec4| ((shown - right).abs() - rounding).max(DVec4::ZERO).length();
        // What is printed is a little longer or shorter than what was shown.
        let shown = printed.normalize();
        (of_chord((shown - right).length()), of_chord(beyond(shown).min(beyond(printed))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::animation_diff::Tolerances;
    use crate::pose::RbtIndex;

    const SIX: Rounding = Rounding { translation: [5e-7; 3], rotation: [5e-7; 4] };
    const TWO: Rounding = Rounding { translation: [5e-3; 3], rotation: [5e-3; 4] };

    fn row(translation: [f64; 3], rotation: DQuat) -> Row {
        let rotation_wxyz = [rotation.w, rotation.x, rotation.y, rotation.z];
        let translation = translation.into();
        Row { key_time: 0.0, key_time_error: 0.0, node: RbtIndex::new(0), translation, rotation_wxyz }
    }

    fn credit() -> Credit {
        Credit::new(Tolerances::default(), Vec::new())
    }

    #[test]
    fn distances_are_in_units_and_degrees() {
        let turned = DQuat::from_rotation_x(2.6_f64.to_radians());
        let right = [(DVec3::ZERO, DQuat::IDENTITY)];
        for sign in [turned, -turned] {
            let row = row([0.0, 0.022, 0.0], sign);
            let off = Printed { row: &row, rounding: &SIX }.off(&right);
            assert!((off.units - 0.022).abs() < 1e-9 && (off.degrees - 2.6).abs() < 1e-9, "{off:?}");
            assert_eq!((off.share(&credit()), off.amount(&credit()).as_str()), (0.0, "2.600 degrees"));
        }
        let half = row([0.0; 3], DQuat::from_xyzw(0.0, 0.0, 1.0, 0.0));
        assert!((Printed { row: &half, rounding: &SIX }.off(&right).degrees - 180.0).abs() < 1e-9);
    }

    #[test]
    fn half_a_unit_of_the_last_decimal_is_no_error() {
        let right = DQuat::from_xyzw(0.184_999, 0.365_001, 0.544_999, 0.731_8).normalize();
        let rounded = DQuat::from_vec4((DVec4::from(right) * 100.0).round() / 100.0);
        let row = row([1.004_9, 0.0, 0.0], rounded);
        let way = [(DVec3::X, right)];
        assert_eq!(Printed { row: &row, rounding: &TWO }.off(&way).share(&credit()), 1.0);
        assert_eq!(Printed { row: &row, rounding: &SIX }.off(&way).share(&credit()), 0.0);
    }

    #[test]
    fn what_is_no_rotation_is_beyond_any_tolerance() {
        let lax = Credit::new(Tolerances { translation: 1e6, rotation_degrees: 1e6 }, Vec::new());
        let way = [(DVec3::ZERO, DQuat::IDENTITY)];
        let mut long = row([0.0; 3], DQuat::IDENTITY);
        long.rotation_wxyz[0] = 1.01;
        let off = Printed { row: &long, rounding: &SIX }.off(&way);
        assert_eq!((off.share(&lax), off.fault), (0.0, Some(Fault::Length(1.01))));
        assert_eq!(Printed { row: &long, rounding: &TWO }.off(&way).share(&lax), 1.0);
        let none = row([f64::NAN, 0.0, 0.0], DQuat::IDENTITY);
        assert_eq!(Printed { row: &none, rounding: &SIX }.off(&way).fault, Some(Fault::NoNumber));
    }

    #[test]
    fn anywhere_on_the_way_is_right() {
        let (from, to) = (DQuat::IDENTITY, DQuat::from_rotation_y(0.02));
        let way = [(DVec3::ZERO, from), (DVec3::X, to), (DVec3::X * 2.0, DQuat::from_rotation_y(0.04))];
        for (at, turn) in [(0.3, 0.006), (1.4, 0.028)] {
            let row = row([at, 0.0, 0.0], DQuat::from_rotation_y(turn));
            assert_eq!(Printed { row: &row, rounding: &SIX }.off(&way).share(&credit()), 1.0, "{at}");
        }
        let row = row([2.3, 0.0, 0.0], from);
        assert!((Printed { row: &row, rounding: &SIX }.off(&way).units - 0.3).abs() < 1e-9);
    }
}
