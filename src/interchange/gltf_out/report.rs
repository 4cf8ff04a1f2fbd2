//! What is said of an export.

use serde_json::{Value, json};

use super::Tolerance;
use crate::words::{Message, texts};

/// The worst of all nodes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Worst {
    /// How far it is off: in degrees, or in scene units.
    pub off: f64,
    /// The path of the node.
    pub node: String,
    /// When, in seconds.
    pub seconds: f64,
}

/// How exact an animation is, as measured at many times in the world.
#[derive(Clone, Debug, PartialEq)]
pub struct Exactness {
    /// The bound; `None` where frames were asked for.
    pub asked: Option<Tolerance>,
    /// Whether the keys have tangents, for readers that follow the specification; else straight keys, for these and for readers that blend
    /// the components of quaternions.
    pub is_cubic: bool,
    /// In degrees.
    pub turned: Worst,
    /// In scene units.
    pub moved: Worst,
}

impl Exactness {
    /// Whether the bound holds; without one it does.
    #[must_use]
    pub fn is_within(&self) -> bool {
        self.asked.is_none_or(|asked| self.turned.off <= asked.degrees && self.moved.off <= asked.units)
    }

    /// As the file says it.
    #[must_use]
    pub fn json(&self) -> Value {
        let readers: &[&str] = if self.is_cubic { &["cubic"] } else { &["slerp", "normalised components"] };
        json!({
            "space": "world",
            "readers": readers,
            "bound": self.asked.map(|asked| json!({ "degrees": asked.degrees, "units": asked.units })),
            "worst_rotation": { "degrees": self.turned.off, "node": self.turned.node, "seconds": self.turned.seconds },
            "worst_translation": { "units": self.moved.off, "node": self.moved.node, "seconds": self.moved.seconds },
        })
    }
}

/// What an export has and has not.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// The nodes of the file.
    pub nodes: usize,
    /// The channels that move.
    pub channels: usize,
    /// The keys of all channels.
    pub keys: usize,
    /// The time of the last key, in seconds.
    pub seconds: f32,
    /// How exact the animation is; `None` if nothing moves.
    pub exactness: Option<Exactness>,
    /// How many shapes were left out, as asked.
    pub shapes_left_out: usize,
    /// The paths of shapes whose colours change: the file has the colours at 0 s.
    pub colours_left_out: Vec<String>,
}

impl Report {
    /// The report in sentences: what there is, how exact it is, and the warnings.
    #[must_use]
    pub fn messages(&self) -> Vec<Message> {
        let mut messages = vec![match &self.exactness {
            Some(_) => texts::gltf_out_animated(
                texts::count_nodes(self.nodes),
                texts::count_channels(self.channels),
                texts::count_keys(self.keys),
                whole_ms(self.seconds.into()),
            ),
            None => texts::gltf_out_still(texts::count_nodes(self.nodes)),
        }];
        if let Some(exactness) = &self.exactness {
            let Exactness { turned, moved, .. } = exactness;
            messages.push(texts::gltf_out_turned(at_most(turned.off), &turned.node, whole_ms(turned.seconds)));
            messages.push(texts::gltf_out_moved(at_most(moved.off), &moved.node, whole_ms(moved.seconds)));
        }
        messages.extend(self.warnings());
        messages
    }

    /// Of these sentences those that a user must know: a bound that could not be met, and what was left out.
    #[must_use]
    pub fn warnings(&self) -> Vec<Message> {
        let mut messages = Vec::new();
        if let Some(asked) = self.exactness.as_ref().filter(|exactness| !exactness.is_within()).and_then(|e| e.asked) {
            messages.push(texts::gltf_out_beyond(asked.degrees, asked.units));
        }
        if self.shapes_left_out > 0 {
            messages.push(texts::gltf_out_no_shapes(self.shapes_left_out));
        }
        if let Some(first) = self.colours_left_out.first() {
            messages.push(texts::gltf_out_no_colours(self.colours_left_out.len(), first));
        }
        messages
    }
}

/// Smaller errors are those of double precision.
const NO_ERROR: f64 = 1e-12;

/// An error with two significant digits, rounded up.
fn at_most(error: f64) -> f64 {
    if error < NO_ERROR {
        return 0.0;
    }
    let unit = 10.0_f64.powf(error.log10().floor() - 1.0);
    // The text has the digits alone, without what doubles add.
    format!("{:.1e}", (error / unit).ceil() * unit).parse().unwrap_or(error)
}

/// Seconds to the millisecond.
fn whole_ms(seconds: f64) -> f64 {
    (seconds * 1000.0).round() / 1000.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_rounded_up() {
        for (error, said) in [
            (0.0, 0.0),
            (3e-14, 0.0),
            (0.007_63, 0.0077),
            (0.01, 0.01),
            (9.89e-5, 9.9e-5),
            (9.91e-5, 1e-4),
            (123.0, 130.0),
        ] {
            assert_eq!(at_most(error), said, "{error}");
        }
    }
}
