//! The functions of the course's Python module, of `math` and of numpy that make numbers, vectors and rotations.

use glam::{DQuat, DVec3};

use crate::rotation_rules::{Mending, exact_rotation_from_euler_degrees};
use crate::words::{Phrase, texts};

/// The most numbers that a vector has.
pub(super) const MOST_NUMBERS: usize = 4;

/// A value before its purpose is known, in double precision, in which Python computes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Term {
    /// A number.
    Number(f64),
    /// Several numbers.
    Numbers(Numbers),
    /// A unit quaternion.
    Rotation(DQuat),
}

/// Up to [`MOST_NUMBERS`] numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Numbers {
    values: [f64; MOST_NUMBERS],
    count: usize,
    /// Whether it is an array, which has arithmetic, and not a tuple or a list.
    pub(super) is_array: bool,
}

impl Numbers {
    /// Adds a number; `None` if there are too many.
    pub(super) fn push(&mut self, number: f64) -> Option<()> {
        *self.values.get_mut(self.count)? = number;
        self.count += 1;
        Some(())
    }

    /// The numbers.
    pub(super) fn as_slice(&self) -> &[f64] {
        &self.values[..self.count]
    }

    /// The numbers, each changed.
    pub(super) fn map(self, change: impl Fn(f64) -> f64) -> Self {
        Self { values: self.values.map(change), ..self }
    }

    /// The numbers of two vectors of equal length, combined.
    pub(super) fn zip(self, other: Self, combine: impl Fn(f64, f64) -> f64) -> Option<Self> {
        let mut values = self.values;
        for (value, other) in values.iter_mut().zip(other.values) {
            *value = combine(*value, other);
        }
        let is_array = self.is_array || other.is_array;
        (self.count == other.count && is_array).then_some(Self { values, count: self.count, is_array })
    }

    fn as_array(self) -> Self {
        Self { is_array: true, ..self }
    }
}

/// The unit quaternion of components x, y, z and w; `None` if their length is not 1 to within the tolerance.
pub(super) fn unit_quaternion([x, y, z, w]: [f64; 4]) -> Option<DQuat> {
    let rotation = DQuat::from_xyzw(x, y, z, w);
    (Mending::of_length(rotation.length()) != Mending::Refuse).then(|| rotation.normalize())
}

/// The arguments of a call.
#[derive(Default)]
pub(super) struct Arguments<'a> {
    /// With the names of those that have one.
    pub(super) terms: Vec<(Option<&'a str>, Term)>,
}

impl Arguments<'_> {
    /// The argument with this name, or the unnamed one at this position.
    fn get(&self, position: usize, name: &str) -> Option<Term> {
        let named = self.terms.iter().find(|(given, _)| *given == Some(name));
        let placed = self.terms.get(position).filter(|(given, _)| given.is_none());
        named.or(placed).map(|&(_, term)| term)
    }

    /// A number, or the default if it is not given; `None` if it is something else.
    fn number_or(&self, position: usize, name: &str, default: f64) -> Option<f64> {
        match self.get(position, name) {
            None => Some(default),
            Some(Term::Number(number)) => Some(number),
            Some(_) => None,
        }
    }

    /// The only argument.
    fn only(&self) -> Option<Term> {
        match self.terms.as_slice() {
            [(None, term)] => Some(*term),
            _ => None,
        }
    }
}

/// A function: its arguments are given, its value returned, if there is one.
pub(super) type Function = fn(&Arguments<'_>) -> Option<Term>;

/// The function of a name, with the arguments that it expects; `None` for any other name.
pub(super) fn function(name: &str) -> Option<(Function, Phrase)> {
    let number = texts::TEXT_EXPECTED_NUMBER;
    Some(match name {
        "vec" | "vec3" | "Vec3" => (vector as Function, texts::TEXT_EXPECTED_VEC),
        // The type, as in np.array((0, 1, 0), 'f'), is no number, and is not evaluated.
        "array" | "asarray" => (vector, texts::TEXT_EXPECTED_VEC),
        "tuple" | "list" => (sequence, texts::TEXT_EXPECTED_VEC),
        "zeros" => (|arguments| filled(arguments, 0.0), number),
        "ones" => (|arguments| filled(arguments, 1.0), number),
        "normalized" | "normalize" => (normalized, texts::TEXT_EXPECTED_VEC),
        "quaternion" => (quaternion, texts::TEXT_EXPECTED_QUATERNION),
        "quaternion_from_euler" => (from_euler, texts::TEXT_EXPECTED_EULER),
        "quaternion_from_axis_angle" => (from_axis_angle, texts::TEXT_EXPECTED_AXIS_ANGLE),
        "quaternion_mul" => (product, texts::TEXT_EXPECTED_QUATERNIONS),
        "radians" | "deg2rad" => (|arguments| each(arguments, f64::to_radians), number),
        "degrees" | "rad2deg" => (|arguments| each(arguments, f64::to_degrees), number),
        "sin" => (|arguments| each(arguments, f64::sin), number),
        "cos" => (|arguments| each(arguments, f64::cos), number),
        "tan" => (|arguments| each(arguments, f64::tan), number),
        "sqrt" => (|arguments| each(arguments, f64::sqrt), number),
        "abs" | "fabs" => (|arguments| each(arguments, f64::abs), number),
        "float" | "float32" | "float64" => (|arguments| each(arguments, |number| number), number),
        "int" => (|arguments| each(arguments, f64::trunc), number),
        _ => return None,
    })
}

/// Whether only the first argument of a function counts.
pub(super) fn takes_one(name: &str) -> bool {
    matches!(name, "array" | "asarray")
}

/// Numbers, or one sequence. One number alone is a number: the course's `vec(2)` is an array of one number without a dimension.
fn vector(arguments: &Arguments<'_>) -> Option<Term> {
    match arguments.only() {
        Some(Term::Numbers(numbers)) => return Some(Term::Numbers(numbers.as_array())),
        Some(number @ Term::Number(_)) => return Some(number),
        _ => {}
    }
    let mut numbers = Numbers::default();
    for (name, term) in &arguments.terms {
        let (None, Term::Number(number)) = (name, term) else { return None };
        numbers.push(*number)?;
    }
    (!arguments.terms.is_empty()).then_some(Term::Numbers(numbers.as_array()))
}

fn sequence(arguments: &Arguments<'_>) -> Option<Term> {
    match arguments.only()? {
        Term::Numbers(numbers) => Some(Term::Numbers(Numbers { is_array: false, ..numbers })),
        _ => None,
    }
}

fn filled(arguments: &Arguments<'_>, value: f64) -> Option<Term> {
    let Term::Number(count) = arguments.only()? else { return None };
    let count = (1..=MOST_NUMBERS).find(|&whole| whole as f64 == count)?;
    Some(Term::Numbers(Numbers { values: [value; MOST_NUMBERS], count, is_array: true }))
}

fn normalized(arguments: &Arguments<'_>) -> Option<Term> {
    match arguments.only()? {
        Term::Numbers(numbers) => {
            let length = numbers.as_slice().iter().map(|number| number * number).sum::<f64>().sqrt();
            (length > 0.0).then(|| Term::Numbers(numbers.map(|number| number / length).as_array()))
        }
        rotation @ Term::Rotation(_) => Some(rotation),
        Term::Number(_) => None,
    }
}

fn each(arguments: &Arguments<'_>, change: impl Fn(f64) -> f64) -> Option<Term> {
    match arguments.only()? {
        Term::Number(number) => Some(Term::Number(change(number))),
        Term::Numbers(numbers) if numbers.is_array => Some(Term::Numbers(numbers.map(change))),
        _ => None,
    }
}

/// Components x, y, z, w; the first three may be a vector, and all may be missing.
fn quaternion(arguments: &Arguments<'_>) -> Option<Term> {
    let components = match arguments.get(0, "x") {
        Some(Term::Numbers(numbers)) => {
            let &[x, y, z] = numbers.as_slice() else { return None };
            let w = match arguments.get(3, "w").or(arguments.get(1, "w")) {
                Some(Term::Number(w)) => w,
                Some(_) => return None,
                None => 1.0,
            };
            [x, y, z, w]
        }
        _ => [
            arguments.number_or(0, "x", 0.0)?,
            arguments.number_or(1, "y", 0.0)?,
            arguments.number_or(2, "z", 0.0)?,
            arguments.number_or(3, "w", 1.0)?,
        ],
    };
    unit_quaternion(components).map(Term::Rotation)
}

fn from_euler(arguments: &Arguments<'_>) -> Option<Term> {
    let degrees = match arguments.get(usize::MAX, "radians") {
        Some(Term::Numbers(numbers)) => {
            let &[yaw, pitch, roll] = numbers.as_slice() else { return None };
            [yaw, pitch, roll].map(f64::to_degrees)
        }
        Some(_) => return None,
        None => [
            arguments.number_or(0, "yaw", 0.0)?,
            arguments.number_or(1, "pitch", 0.0)?,
            arguments.number_or(2, "roll", 0.0)?,
        ],
    };
    finite(exact_rotation_from_euler_degrees(degrees))
}

fn from_axis_angle(arguments: &Arguments<'_>) -> Option<Term> {
    let Some(Term::Numbers(axis)) = arguments.get(0, "axis") else { return None };
    let &[x, y, z] = axis.as_slice() else { return None };
    let radians = match arguments.get(usize::MAX, "radians") {
        Some(Term::Number(radians)) => radians,
        Some(_) => return None,
        None => arguments.number_or(1, "degrees", 0.0)?.to_radians(),
    };
    finite(DQuat::from_axis_angle(DVec3::new(x, y, z).try_normalize()?, radians))
}

/// The rotation by the second quaternion, then by the first.
fn product(arguments: &Arguments<'_>) -> Option<Term> {
    match (arguments.get(0, "q1")?, arguments.get(1, "q2")?) {
        (Term::Rotation(first), Term::Rotation(second)) => finite(first * second),
        _ => None,
    }
}

fn finite(rotation: DQuat) -> Option<Term> {
    rotation.is_finite().then(|| Term::Rotation(rotation.normalize()))
}
