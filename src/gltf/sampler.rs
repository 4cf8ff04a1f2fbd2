//! Animation samplers: values over time (glTF 2.0, section 3.11 and appendix C).

use glam::{DQuat, DVec3};

use super::document::{Document, GltfError};
use super::json::Index;
use crate::words::texts;

/// How a sampler goes from one key to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Course {
    /// `LINEAR`; rotations by slerp, the short way.
    Linear,
    /// `STEP`: the value of the key before.
    Step,
    /// `CUBICSPLINE`: Hermite splines with tangents in values a second.
    Cubic,
}

/// A value that samplers have.
pub trait Sampled: Copy {
    /// The value at a fraction, 0 to 1, between two.
    #[must_use]
    fn between(from: Self, to: Self, alpha: f64) -> Self;
    /// The sum of values, each with its factor.
    #[must_use]
    fn sum(terms: [(f64, Self); 4]) -> Self;
}

impl Sampled for DVec3 {
    fn between(from: Self, to: Self, alpha: f64) -> Self {
        from * (1.0 - alpha) + to * alpha
    }

    fn sum(terms: [(f64, Self); 4]) -> Self {
        terms.into_iter().map(|(factor, value)| value * factor).sum()
    }
}

impl Sampled for DQuat {
    fn between(from: Self, to: Self, alpha: f64) -> Self {
        from.slerp(to, alpha).normalize()
    }

    fn sum(terms: [(f64, Self); 4]) -> Self {
        let sum =
            terms.into_iter().fold(Self::from_xyzw(0.0, 0.0, 0.0, 0.0), |sum, (factor, value)| sum + value * factor);
        // Splines through opposite rotations may pass through nothing.
        if sum.length_squared() > 1e-24 { sum.normalize() } else { terms[0].1 }
    }
}

/// Keys and what is between them. Before the first and after the last key, the value of that key holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve<V> {
    /// The keys' times in seconds, ascending; never empty.
    pub seconds: Vec<f64>,
    /// The keys' values.
    pub values: Vec<V>,
    /// How it goes from key to key.
    pub course: Course,
    /// For each key the tangents before and after it, a second; empty but for [`Course::Cubic`].
    tangents: Vec<[V; 2]>,
}

impl<V: Sampled> Curve<V> {
    /// The value at a time in seconds; at a key's time exactly the key's.
    #[must_use]
    pub fn value_at(&self, seconds: f64) -> V {
        let after = self.seconds.partition_point(|&key| key <= seconds);
        let Some(before) = after.checked_sub(1) else { return self.values[0] };
        let (from, start) = (self.values[before], self.seconds[before]);
        if after == self.seconds.len() || seconds == start || self.course == Course::Step {
            return from;
        }
        let (to, length) = (self.values[after], self.seconds[after] - start);
        let alpha = (seconds - start) / length;
        if self.course == Course::Linear {
            return V::between(from, to, alpha);
        }
        let (square, cube) = (alpha * alpha, alpha * alpha * alpha);
        V::sum([
            (2.0 * cube - 3.0 * square + 1.0, from),
            (length * (cube - 2.0 * square + alpha), self.tangents[before][1]),
            (-2.0 * cube + 3.0 * square, to),
            (length * (cube - square), self.tangents[after][0]),
        ])
    }

    /// The same curve with each value changed by a linear map.
    #[must_use]
    pub fn map<W>(&self, change: impl Fn(V) -> W) -> Curve<W> {
        Curve {
            seconds: self.seconds.clone(),
            values: self.values.iter().map(|&value| change(value)).collect(),
            course: self.course,
            tangents: self.tangents.iter().map(|pair| pair.map(&change)).collect(),
        }
    }
}

impl Document<'_> {
    /// A sampler of translations or scales.
    ///
    /// # Errors
    /// [`GltfError`]: it leads nowhere, its times do not ascend, it has too few values.
    pub fn vectors_over_time(&self, animation: Index, sampler: Index) -> Result<Curve<DVec3>, GltfError> {
        self.curve(animation, sampler, |numbers: [f32; 3]| DVec3::from(numbers.map(f64::from)))
    }

    /// A sampler of rotations: unit quaternions.
    ///
    /// # Errors
    /// [`GltfError`]: it leads nowhere, its times do not ascend, it has too few values, a rotation is none.
    pub fn rotations_over_time(&self, animation: Index, sampler: Index) -> Result<Curve<DQuat>, GltfError> {
        let mut curve =
            self.curve(animation, sampler, |numbers: [f32; 4]| DQuat::from_array(numbers.map(f64::from)))?;
        for (key, rotation) in curve.values.iter_mut().enumerate() {
            let length = rotation.length();
            if length < 1e-3 {
                return Err(GltfError::new(place(animation, sampler), texts::gltf_rotation(key)));
            }
            // What is of unit length in single precision stays to the bit.
            if (length - 1.0).abs() > 1e-6 {
                *rotation = rotation.normalize();
            }
        }
        Ok(curve)
    }

    fn curve<const N: usize, V: Sampled>(
        &self,
        animation: Index,
        sampler: Index,
        value: impl Fn([f32; N]) -> V,
    ) -> Result<Curve<V>, GltfError> {
        let at = place(animation, sampler);
        let json = self.root.animations.get(animation).and_then(|animation| animation.samplers.get(sampler));
        let json = json.ok_or_else(|| GltfError::leads_nowhere(format!("/animations/{animation}"), &at))?;
        let error = |problem| GltfError::new(at.as_str(), problem);
        let course = match json.interpolation.as_deref() {
            None | Some("LINEAR") => Course::Linear,
            Some("STEP") => Course::Step,
            Some("CUBICSPLINE") => Course::Cubic,
            Some(other) => return Err(error(texts::gltf_interpolation(other))),
        };
        let seconds: Vec<f64> = self.floats::<1>(json.input)?.into_iter().map(|[seconds]| seconds.into()).collect();
        if seconds.is_empty() || seconds.windows(2).any(|pair| pair[0] >= pair[1]) {
            return Err(error(texts::GLTF_TIMES.into()));
        }
        let values: Vec<V> = self.floats(json.output)?.into_iter().map(value).collect();
        let each = if course == Course::Cubic { 3 } else { 1 };
        if values.len() != seconds.len() * each {
            return Err(error(texts::gltf_value_count(values.len(), seconds.len() * each)));
        }
        let (values, tangents) = if course == Course::Cubic {
            let triples = values.chunks_exact(3);
            (triples.clone().map(|key| key[1]).collect(), triples.map(|key| [key[0], key[2]]).collect())
        } else {
            (values, Vec::new())
        };
        Ok(Curve { seconds, values, course, tangents })
    }
}

/// A sampler's place in the JSON.
fn place(animation: Index, sampler: Index) -> String {
    format!("/animations/{animation}/samplers/{sampler}")
}
