//! A channel as a glTF file has it, and what readers make of it between its keys.

use glam::{DVec4, Vec4};

use super::motion::{Property, aligned, slerp};

/// What a reader does between two keys.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reader {
    /// As the specification says.
    Exact,
    /// Blends the components of quaternions and normalises.
    ByComponents,
}

/// Keys of one property of one node.
#[derive(Clone, Debug)]
pub struct Keyed {
    /// The index of the node in the scene.
    pub node: usize,
    /// What moves.
    pub property: Property,
    /// When, ascending.
    pub seconds: Vec<f32>,
    /// A value for each time. A quaternion has the sign that is nearer to the one before.
    pub values: Vec<Vec4>,
    /// For each time the changes a second before and after it; empty for linear keys.
    pub tangents: Vec<[Vec4; 2]>,
}

impl Keyed {
    /// A channel without keys.
    pub fn new(node: usize, property: Property) -> Self {
        Self { node, property, seconds: Vec::new(), values: Vec::new(), tangents: Vec::new() }
    }

    /// Adds a key. One that is not later than the last one replaces it: times are rounded to single precision.
    pub fn push(&mut self, seconds: f32, value: DVec4, tangents: Option<[DVec4; 2]>) {
        if self.seconds.last().is_some_and(|&last| seconds <= last) {
            self.seconds.pop();
            self.values.pop();
            self.tangents.pop();
        }
        let before = self.values.last().map(|last| last.as_dvec4());
        let sign = match before {
            Some(before) if self.property == Property::Rotation && before.dot(value) < 0.0 => -1.0,
            _ => 1.0,
        };
        self.seconds.push(seconds);
        self.values.push((value * sign).as_vec4());
        if let Some(tangents) = tangents {
            self.tangents.push(tangents.map(|tangent| (tangent * sign).as_vec4()));
        }
    }

    /// The value that a reader shows at a time.
    pub fn at(&self, seconds: f64, reader: Reader) -> DVec4 {
        let after = self.seconds.partition_point(|&key| f64::from(key) <= seconds);
        let Some(before) = after.checked_sub(1) else { return self.value(0) };
        if after == self.seconds.len() {
            return self.value(before);
        }
        let (start, end) = (f64::from(self.seconds[before]), f64::from(self.seconds[after]));
        let fraction = (seconds - start) / (end - start);
        let (from, to) = (self.value(before), self.value(after));
        match (self.tangents.get(before), self.tangents.get(after)) {
            (Some([_, out]), Some([into, _])) => {
                let tangents = [out, into].map(|tangent| tangent.as_dvec4() * (end - start));
                hermite(self.property, [from, to], tangents, fraction)
            }
            _ => between(self.property, from, to, fraction, reader),
        }
    }

    fn value(&self, key: usize) -> DVec4 {
        let value = self.values[key].as_dvec4();
        if self.property == Property::Rotation { value.normalize() } else { value }
    }
}

/// The value between two linear keys.
pub fn between(property: Property, from: DVec4, to: DVec4, fraction: f64, reader: Reader) -> DVec4 {
    match (property, reader) {
        (Property::Rotation, Reader::Exact) => slerp(from, to, fraction),
        (Property::Rotation, Reader::ByComponents) => {
            let to = aligned(to, from);
            (from + (to - from) * fraction).normalize()
        }
        (Property::Translation | Property::Scale, _) => from + (to - from) * fraction,
    }
}

/// The value between two keys with tangents, each for the whole way between them (glTF 2.0, appendix C.5).
pub fn hermite(property: Property, [from, to]: [DVec4; 2], [out, into]: [DVec4; 2], t: f64) -> DVec4 {
    let (t2, t3) = (t * t, t * t * t);
    let value =
        from * (2.0 * t3 - 3.0 * t2 + 1.0) + out * (t3 - 2.0 * t2 + t) + to * (3.0 * t2 - 2.0 * t3) + into * (t3 - t2);
    if property == Property::Rotation { value.normalize() } else { value }
}
