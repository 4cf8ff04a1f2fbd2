//! The functions of the course's Python module that make vectors and rotations.

use glam::{Quat, Vec3};

use crate::rotation_rules::Mending;
use crate::rotation_rules::{rotation_about_axis, rotation_from_euler_degrees};
use crate::words::{Phrase, texts};

/// The names of the functions.
pub(super) const FUNCTIONS: [&str; 4] = ["vec", "quaternion", "quaternion_from_euler", "quaternion_from_axis_angle"];

/// Calls one of [`FUNCTIONS`].
///
/// # Errors
/// The expected arguments, as a phrase.
pub(super) fn call(function: &str, arguments: &Arguments<'_>) -> Result<Term, Phrase> {
    let (made, expected) = match function {
        "vec" => (vector(arguments), texts::TEXT_EXPECTED_VEC),
        "quaternion" => (quaternion(arguments), texts::TEXT_EXPECTED_QUATERNION),
        "quaternion_from_euler" => (from_euler(arguments), texts::TEXT_EXPECTED_EULER),
        _ => (from_axis_angle(arguments), texts::TEXT_EXPECTED_AXIS_ANGLE),
    };
    made.ok_or(expected)
}

/// An argument or value before its purpose is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Term {
    /// A number.
    Number(f32),
    /// Up to four numbers; the second field is how many are used.
    Numbers([f32; 4], usize),
    /// A unit quaternion.
    Rotation(Quat),
}

/// The arguments of a call: up to four, and those with a name.
#[derive(Default)]
pub(super) struct Arguments<'a> {
    pub(super) terms: Vec<(Option<&'a str>, Term)>,
}

impl Arguments<'_> {
    /// The argument with this name, or the unnamed one at this position.
    fn get(&self, position: usize, name: &str) -> Option<Term> {
        let named = self.terms.iter().find(|(given, _)| *given == Some(name));
        let placed = self.terms.get(position).filter(|(given, _)| given.is_none());
        named.or(placed).map(|&(_, term)| term)
    }

    fn number(&self, position: usize, name: &str) -> Option<f32> {
        match self.get(position, name) {
            Some(Term::Number(number)) => Some(number),
            _ => None,
        }
    }
}

fn vector(arguments: &Arguments<'_>) -> Option<Term> {
    if let [(None, term @ Term::Numbers(..))] = arguments.terms.as_slice() {
        return Some(*term);
    }
    let mut numbers = [0.0; 4];
    for (number, (name, term)) in numbers.iter_mut().zip(&arguments.terms) {
        let (None, Term::Number(given)) = (name, term) else { return None };
        *number = *given;
    }
    (!arguments.terms.is_empty()).then_some(Term::Numbers(numbers, arguments.terms.len()))
}

/// Components x, y, z, w; the first three may be a vector, and all may be missing.
fn quaternion(arguments: &Arguments<'_>) -> Option<Term> {
    let component = |position, name| match arguments.get(position, name) {
        None => Some(if name == "w" { 1.0 } else { 0.0 }),
        Some(Term::Number(number)) => Some(number),
        Some(_) => None,
    };
    let [x, y, z, w] = match arguments.get(0, "x") {
        Some(Term::Numbers([x, y, z, _], 3)) => {
            [x, y, z, arguments.number(3, "w").or(arguments.number(1, "w")).unwrap_or(1.0)]
        }
        _ => [component(0, "x")?, component(1, "y")?, component(2, "z")?, component(3, "w")?],
    };
    let rotation = Quat::from_xyzw(x, y, z, w);
    (Mending::of_length(rotation.length().into()) != Mending::Refuse).then(|| Term::Rotation(rotation.normalize()))
}

fn from_euler(arguments: &Arguments<'_>) -> Option<Term> {
    let degrees = match arguments.get(usize::MAX, "radians") {
        Some(Term::Numbers([yaw, pitch, roll, _], 3)) => [yaw, pitch, roll].map(f32::to_degrees),
        Some(_) => return None,
        None => {
            let angle = |position, name| match arguments.get(position, name) {
                None => Some(0.0),
                Some(Term::Number(number)) => Some(number),
                Some(_) => None,
            };
            [angle(0, "yaw")?, angle(1, "pitch")?, angle(2, "roll")?]
        }
    };
    let rotation = rotation_from_euler_degrees(degrees);
    rotation.is_finite().then(|| Term::Rotation(rotation.normalize()))
}

fn from_axis_angle(arguments: &Arguments<'_>) -> Option<Term> {
    let Some(Term::Numbers([x, y, z, _], 3)) = arguments.get(0, "axis") else { return None };
    let radians = match arguments.get(usize::MAX, "radians") {
        Some(Term::Number(radians)) => radians.into(),
        Some(_) => return None,
        None => f64::from(arguments.number(1, "degrees").unwrap_or(0.0)).to_radians(),
    };
    let axis = Vec3::new(x, y, z).as_dvec3().try_normalize()?.as_vec3();
    let rotation = rotation_about_axis(axis, radians);
    rotation.is_finite().then(|| Term::Rotation(rotation.normalize()))
}
