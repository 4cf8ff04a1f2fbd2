//! What a glTF animation does to the nodes of a tree.

use glam::{DQuat, DVec3};

use super::tree::{LEAST_SCALE, SAME_SCALE, TreeNode, Trs};
use crate::gltf::json::Index;
use crate::gltf::{Course, Curve, Document, GltfError, Sampled};
use crate::words::{Message, texts};

/// How long before a step its last key lies, in seconds.
const BEFORE_STEP: f64 = 1e-3;
/// The most times that splines and steps add.
const MOST_TIMES: usize = 1 << 20;
/// How many samples a second a spline gets at least, before they are made fewer.
const SPLINE_SAMPLES: f64 = 120.0;

/// What moves one node.
#[derive(Clone, Debug, Default)]
pub(super) struct NodeMotion {
    pub translation: Option<Curve<DVec3>>,
    pub rotation: Option<Curve<DQuat>>,
    pub scale: Option<Curve<DVec3>>,
}

impl NodeMotion {
    /// Whether it moves rigidly.
    pub fn is_rigid(&self) -> bool {
        self.translation.is_some() || self.rotation.is_some()
    }
}

/// An animation of a tree.
#[derive(Clone, Debug)]
pub(super) struct Motion {
    /// By node of the tree.
    pub nodes: Vec<NodeMotion>,
    /// The times of the first and the last key, in seconds.
    pub span: [f64; 2],
}

impl Motion {
    /// No motion.
    pub fn none(nodes: usize) -> Self {
        Self { nodes: vec![NodeMotion::default(); nodes], span: [0.0; 2] }
    }

    /// Reads an animation. A scale that stays the same becomes that of the rest. `notes` gets what is left out.
    pub fn read(
        document: &Document<'_>,
        animation: Index,
        tree: &mut [TreeNode],
        notes: &mut Vec<Message>,
    ) -> Result<Self, GltfError> {
        let mut motion = Self::none(tree.len());
        let mut span = [f64::INFINITY, f64::NEG_INFINITY];
        let of_file: std::collections::HashMap<Index, usize> =
            tree.iter().enumerate().map(|(at, node)| (node.index, at)).collect();
        for (number, channel) in document.root.animations[animation].channels.iter().enumerate() {
            let at = format!("/animations/{animation}/channels/{number}");
            let Some(node) = channel.target.node else {
                notes.push(texts::gltf_note_pointer(at));
                continue;
            };
            if node >= document.root.nodes.len() {
                return Err(GltfError::leads_nowhere(at, &super::tree::place(node)));
            }
            // What moves another scene is not of this one.
            let Some(&place) = of_file.get(&node) else { continue };
            let node = &mut tree[place];
            let moved = &mut motion.nodes[place];
            let change = node.change;
            let seconds = match channel.target.path.as_str() {
                "translation" => {
                    let curve = document.vectors_over_time(animation, channel.sampler)?;
                    &moved.translation.insert(curve.map(|value| change.translation(value))).seconds
                }
                "rotation" => {
                    let curve = document.rotations_over_time(animation, channel.sampler)?;
                    &moved.rotation.insert(curve.map(|value| change.rotation(value))).seconds
                }
                "scale" => {
                    let curve = document.vectors_over_time(animation, channel.sampler)?;
                    let Some(curve) = scale(&curve, node, &at)? else { continue };
                    notes.push(texts::gltf_note_scale_keys(&node.path));
                    &moved.scale.insert(curve).seconds
                }
                "weights" => {
                    notes.push(texts::gltf_note_weights(&node.path));
                    continue;
                }
                other => {
                    notes.push(texts::gltf_note_channel(at, other));
                    continue;
                }
            };
            span = [span[0].min(seconds[0]), span[1].max(seconds[seconds.len() - 1])];
        }
        if span[0] <= span[1] {
            motion.span = span;
        }
        Ok(motion)
    }

    /// The transform of a node at a time in seconds.
    pub fn at(&self, tree: &[TreeNode], node: usize, seconds: f64) -> Trs {
        let NodeMotion { translation, rotation, scale } = &self.nodes[node];
        let rest = tree[node].rest;
        Trs {
            translation: translation.as_ref().map_or(rest.translation, |curve| curve.value_at(seconds)),
            rotation: rotation.as_ref().map_or(rest.rotation, |curve| curve.value_at(seconds)),
            scale: scale.as_ref().map_or(rest.scale, |curve| curve.value_at(seconds)),
        }
    }

    /// Times between which these nodes move straight, or nearly: those of all keys, and more within splines and around steps.
    pub fn times(&self, nodes: impl Iterator<Item = usize>) -> Vec<f64> {
        let mut times = Vec::new();
        for node in nodes.map(|node| &self.nodes[node]) {
            node.translation.iter().for_each(|curve| add_times(curve, &mut times));
            node.rotation.iter().for_each(|curve| add_times(curve, &mut times));
        }
        times.sort_by(f64::total_cmp);
        times.dedup();
        times
    }
}

fn add_times<V>(curve: &Curve<V>, times: &mut Vec<f64>) {
    times.extend(&curve.seconds);
    for pair in curve.seconds.windows(2) {
        if times.len() > MOST_TIMES {
            return;
        }
        let length = pair[1] - pair[0];
        match curve.course {
            Course::Linear => {}
            Course::Step => times.extend((length > BEFORE_STEP).then_some(pair[1] - BEFORE_STEP)),
            Course::Cubic => {
                let parts = (length * SPLINE_SAMPLES).ceil().clamp(4.0, 1000.0);
                times.extend((1..parts as usize).map(|part| pair[0] + length * part as f64 / parts));
            }
        }
    }
}

/// The curve of a scale, above 0; `None` if it stays the same, which is then the scale of the rest.
fn scale(curve: &Curve<DVec3>, node: &mut TreeNode, at: &str) -> Result<Option<Curve<DVec3>>, GltfError> {
    let signs = node.change.signs;
    if curve.values.iter().any(|value| (*value * signs).min_element() < 0.0) {
        return Err(GltfError::new(at, texts::gltf_in_mirroring(&node.path)));
    }
    let positive = curve.map(|value| value * signs);
    let first = positive.values[0].max(DVec3::splat(LEAST_SCALE));
    let is_same = |value: DVec3| ((value - first) / first).abs().max_element() < SAME_SCALE;
    if positive.seconds.iter().chain(&midway(&positive.seconds)).all(|&at| is_same(positive.value_at(at))) {
        node.set_scale(first);
        return Ok(None);
    }
    Ok(Some(positive))
}

/// A third of the way from each time to the next: where a spline leaves equal values, it has left them there.
fn midway(seconds: &[f64]) -> Vec<f64> {
    seconds.windows(2).map(|pair| pair[0] + (pair[1] - pair[0]) / 3.0).collect()
}

/// How far a value of timed keys may be from the curve.
pub(super) trait Distance: Sampled {
    /// How far two values are apart, in parts of what is allowed.
    fn apart(a: Self, b: Self, allowed: f64) -> f64;
}

impl Distance for DVec3 {
    fn apart(a: Self, b: Self, allowed: f64) -> f64 {
        a.distance(b) / allowed
    }
}

impl Distance for DQuat {
    fn apart(a: Self, b: Self, allowed: f64) -> f64 {
        let chord = (a - b).length().min((a + b).length());
        4.0 * (chord / 2.0).min(1.0).asin() / allowed
    }
}

/// The most timed keys that a curve becomes before splines are no longer halved.
const MOST_KEYS: usize = 1 << 18;
/// The most halvings of a spline between two keys.
const MOST_HALVINGS: u32 = 10;
/// How long before a step its last timed key lies, in seconds.
const TIMED_BEFORE_STEP: f64 = 1e-6;

/// Timed keys, which are interpolated linearly, that are a curve: exactly for `LINEAR`, with a millionth of a second from value to value
/// for `STEP`, and within `allowed` (units, or radians) for `CUBICSPLINE`.
pub(super) fn timed_keys<V: Distance>(curve: &Curve<V>, allowed: f64) -> Vec<(f64, V)> {
    let mut keys: Vec<(f64, V)> = vec![(curve.seconds[0], curve.values[0])];
    for (at, pair) in curve.seconds.windows(2).enumerate() {
        match curve.course {
            Course::Linear => {}
            Course::Step => {
                let before = (pair[1] - TIMED_BEFORE_STEP).max(f64::midpoint(pair[0], pair[1]));
                keys.push((before, curve.values[at]));
            }
            Course::Cubic => halved(curve, [pair[0], pair[1]], allowed, MOST_HALVINGS, &mut keys),
        }
        keys.push((pair[1], curve.values[at + 1]));
    }
    keys
}

/// Adds keys within a part of a spline until straight lines between them are near enough.
fn halved<V: Distance>(curve: &Curve<V>, [from, to]: [f64; 2], allowed: f64, halvings: u32, keys: &mut Vec<(f64, V)>) {
    let (start, end) = (curve.value_at(from), curve.value_at(to));
    let is_near = [0.25, 0.5, 0.75].into_iter().all(|alpha| {
        V::apart(V::between(start, end, alpha), curve.value_at(from + (to - from) * alpha), allowed) <= 1.0
    });
    if halvings == 0 || is_near || keys.len() > MOST_KEYS {
        return;
    }
    let middle = f64::midpoint(from, to);
    halved(curve, [from, middle], allowed, halvings - 1, keys);
    keys.push((middle, curve.value_at(middle)));
    halved(curve, [middle, to], allowed, halvings - 1, keys);
}
