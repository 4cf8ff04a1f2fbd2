//! What moves, in double precision: for each channel of each node its value at any time, as the program plays it.
//!
//! The formulas are those of [`crate::interpolation`], which has single precision: here they must be exact far beyond the tolerance.

use glam::{DQuat, DVec4, Vec4};

use crate::interpolation::Interpolation;
use crate::keyframe::{Animation, Easing, Keyframe, PlayRange, to_f64};
use crate::pose::RbtIndex;
use crate::scene::{Channel, NodeKind, SceneGraph, Tracks};

/// The shortest time between two keys, in which a jump is written too. Two keys of one time are not allowed, and Blender makes one of keys
/// that are closer than 1/100 of its frames, of which it has 24 a second.
const SHORTEST_STEP: f64 = 1.0 / 2304.0;
/// What counts as a jump, in components of quaternions and in scene units.
const SMALLEST_JUMP: f64 = 1e-6;
/// A fraction of a span in which nothing moves by more than a jump, unless it jumps.
const INSTANT: f64 = 1e-9;
/// The step of a difference quotient, as a fraction of a span.
const DERIVATIVE_STEP: f64 = 1e-6;

/// A property of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Property {
    /// In the parent's space, in scene units.
    Translation,
    /// A unit quaternion.
    Rotation,
    /// Along each axis.
    Scale,
}

impl Property {
    /// Its name in a glTF file.
    pub const fn path(self) -> &'static str {
        match self {
            Self::Translation => "translation",
            Self::Rotation => "rotation",
            Self::Scale => "scale",
        }
    }

    /// A value with a quaternion of unit length: those of files are so but for rounding.
    pub fn unit(self, value: DVec4) -> DVec4 {
        if self == Self::Rotation { value.normalize() } else { value }
    }

    /// The value at a fraction of the way between two, as the program plays it.
    pub fn blend(self, from: DVec4, to: DVec4, alpha: f64) -> DVec4 {
        match self {
            Self::Translation | Self::Scale => from + (to - from) * alpha,
            Self::Rotation => slerp(from, to, alpha),
        }
    }
}

/// Spherical interpolation the short way, of unit quaternions as x, y, z, w.
pub fn slerp(from: DVec4, to: DVec4, alpha: f64) -> DVec4 {
    let to = aligned(to, from);
    // The angle by the chord, which is exact for small ones too.
    let half_angle = 2.0 * (0.5 * (to - from).length()).min(1.0).asin();
    let sine = half_angle.sin();
    if sine < 1e-9 {
        return (from + (to - from) * alpha).normalize();
    }
    (from * ((1.0 - alpha) * half_angle).sin() / sine + to * (alpha * half_angle).sin() / sine).normalize()
}

/// Of a quaternion and its negative, which are one rotation, the one nearer to another.
pub fn aligned(rotation: DVec4, to: DVec4) -> DVec4 {
    if rotation.dot(to) < 0.0 { -rotation } else { rotation }
}

/// The angle between two rotations in radians. Exact for small ones.
pub fn angle_between(a: DVec4, b: DVec4) -> f64 {
    4.0 * (0.5 * (aligned(a, b) - b).length()).min(1.0).asin()
}

/// A smooth part of a channel.
#[derive(Clone, Debug)]
pub struct Span {
    /// When it begins and ends, in seconds.
    pub seconds: [f64; 2],
    /// The values there, to the bit: rotations are not normalised again.
    pub ends: [DVec4; 2],
    easing: Easing,
    curve: Curve,
}

#[derive(Clone, Debug)]
enum Curve {
    Line([DVec4; 2]),
    /// By de Casteljau's six blends.
    Bezier([DVec4; 4]),
}

/// The motion of one property of one node.
#[derive(Clone, Debug)]
pub struct Motion {
    /// The index of the node in the scene.
    pub node: usize,
    /// What moves.
    pub property: Property,
    /// One after the other, without gaps. Empty where nothing moves.
    pub spans: Vec<Span>,
    /// The value before the first span, and without spans always.
    pub first: DVec4,
    /// The same, to the bit.
    pub rest: DVec4,
    /// Whether its spans are the intervals between keyframes; else they are those between timed keys.
    pub is_of_keyframes: bool,
}

impl Span {
    /// How long it lasts, in seconds.
    pub fn length(&self) -> f64 {
        self.seconds[1] - self.seconds[0]
    }

    /// The shortest step between two keys, as a fraction.
    pub fn shortest_step(&self) -> f64 {
        shortest_step(self.seconds[1]) / self.length()
    }

    /// The fractions at which its speed jumps, ascending.
    pub fn kinks(&self) -> Vec<f64> {
        if self.is_constant() { Vec::new() } else { self.easing.kinks() }
    }

    /// Whether nothing moves in it.
    pub fn is_constant(&self) -> bool {
        match &self.curve {
            Curve::Line([from, to]) => from == to,
            Curve::Bezier(points) => points.iter().all(|point| *point == points[0]),
        }
    }

    /// The value at a fraction, from 0 to 1.
    pub fn value(&self, property: Property, fraction: f64) -> DVec4 {
        let (first, last) = match &self.curve {
            Curve::Line([from, to]) => (*from, *to),
            Curve::Bezier([from, .., to]) => (*from, *to),
        };
        match (self.easing.value(fraction), &self.curve) {
            (0.0, _) => first,
            (1.0, _) => last,
            (alpha, Curve::Line([from, to])) => property.blend(*from, *to, alpha),
            (alpha, Curve::Bezier(points)) => {
                let blend = |a, b| property.blend(a, b, alpha);
                let [ab, bc, cd] = [0, 1, 2].map(|at| blend(points[at], points[at + 1]));
                blend(blend(ab, bc), blend(bc, cd))
            }
        }
    }

    /// The change of the value with the fraction, per whole span, just before (`side` −1) or just after (1) a fraction. The quaternions of
    /// the neighbourhood have the signs of `at`, the value there.
    pub fn derivative(&self, property: Property, fraction: f64, at: DVec4, side: f64) -> DVec4 {
        let step = side * DERIVATIVE_STEP;
        let value = |steps: f64| {
            let value = self.value(property, fraction + steps * step);
            if property == Property::Rotation { aligned(value, at) } else { value }
        };
        (value(1.0) * 4.0 - value(0.0) * 3.0 - value(2.0)) / (2.0 * step)
    }

    /// The fractions between which it is smooth. Some easings jump at an end, and `hold` at the last keyframe.
    pub fn smooth(&self, property: Property) -> [f64; 2] {
        let gap = self.shortest_step();
        let jumps = |outer: f64, inner: f64| {
            let (outer, inner) = (self.value(property, outer), self.value(property, inner));
            let outer = if property == Property::Rotation { aligned(outer, inner) } else { outer };
            (outer - inner).abs().max_element() > SMALLEST_JUMP
        };
        [if jumps(0.0, INSTANT) { gap } else { 0.0 }, if jumps(1.0, 1.0 - INSTANT) { 1.0 - gap } else { 1.0 }]
    }
}

/// The shortest step to a key at a time, in seconds: both times are rounded to single precision, and again to that of frames.
fn shortest_step(seconds: f64) -> f64 {
    let late = seconds as f32;
    SHORTEST_STEP + 2.0 * f64::from(late - late.next_down())
}

impl Motion {
    /// The value at a time in seconds.
    pub fn at(&self, seconds: f64) -> DVec4 {
        let after = self.spans.partition_point(|span| span.seconds[0] <= seconds);
        let Some(span) = after.checked_sub(1).map(|index| &self.spans[index]) else { return self.first };
        span.value(self.property, ((seconds - span.seconds[0]) / span.length()).min(1.0))
    }

    /// From when to when in seconds it jumps.
    pub fn jumps(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        self.spans.iter().flat_map(|span| {
            let [from, to] = span.seconds;
            let jumps = if !self.is_of_keyframes && span.length() < 1.1 * shortest_step(to) {
                // Two timed keys as near as that are a jump as a whole.
                [[from, to], [to, to]]
            } else {
                let [start, end] = span.smooth(self.property).map(|fraction| from + fraction * span.length());
                [[from, start], [end, to]]
            };
            jumps.into_iter().filter(|[from, to]| from < to)
        })
    }

    /// Whether it has one value at all times.
    pub fn is_constant(&self) -> bool {
        self.spans.iter().all(Span::is_constant)
            && self.spans.iter().all(|span| span.value(self.property, 0.0) == self.first)
    }
}

/// All motions of a scene, those of a node together, nodes in the scene's order.
pub fn motions(scene: &SceneGraph, animation: Option<(&Animation, &PlayRange<'_>)>) -> Vec<Motion> {
    let intervals = animation.map(|(animation, range)| Intervals::of(animation, range));
    let mut motions = Vec::new();
    for (id, node) in scene.nodes_with_ids() {
        match &node.kind {
            NodeKind::Rbt(rbt) => {
                if let Some(intervals) = &intervals {
                    motions.extend(intervals.motions(id.get(), *rbt));
                }
            }
            NodeKind::Control(tracks) => motions.extend(timed(id.get(), tracks)),
            NodeKind::Shape(_) => {}
        }
    }
    motions
}

/// The intervals between the played keyframes.
struct Intervals<'a> {
    animation: &'a Animation,
    /// When each played keyframe is reached, in seconds.
    seconds: Vec<f64>,
}

impl<'a> Intervals<'a> {
    fn of(animation: &'a Animation, range: &PlayRange<'_>) -> Self {
        let unit = f64::from(animation.ms_between_keyframes) / 1000.0;
        let seconds = (0..=range.last_key_time()).map(|played| to_f64(&range.timing().at_keyframe(played)) * unit);
        Self { animation, seconds: seconds.collect() }
    }

    fn motions(&self, node: usize, rbt: RbtIndex) -> [Motion; 2] {
        [Property::Translation, Property::Rotation].map(|property| {
            let keyframes = self.animation.keyframes.as_slice();
            let of_keyframe = |keyframe: &Keyframe| {
                let rbt = keyframe.pose.get(rbt);
                match property {
                    Property::Rotation => Vec4::from(rbt.rotation).as_dvec4(),
                    Property::Translation | Property::Scale => rbt.translation.extend(0.0).as_dvec4(),
                }
            };
            let values: Vec<DVec4> = keyframes.iter().map(|keyframe| property.unit(of_keyframe(keyframe))).collect();
            let span = |(played, seconds): (usize, &[f64])| {
                let at = played + 1;
                let curve = match self.animation.interpolation {
                    Interpolation::Linear => Curve::Line([values[at], values[at + 1]]),
                    Interpolation::CatmullRom => {
                        let lengths = [at - 1, at, at + 1].map(|before| keyframes[before].duration);
                        Curve::Bezier(catmull_rom(property, [at - 1, at, at + 1, at + 2].map(|c| values[c]), lengths))
                    }
                };
                let ends = [at, at + 1].map(|at| of_keyframe(&keyframes[at]));
                Span { seconds: [seconds[0], seconds[1]], ends, easing: keyframes[at].easing, curve }
            };
            let spans = self.seconds.windows(2).enumerate().map(span).collect();
            Motion { node, property, spans, first: values[1], rest: of_keyframe(&keyframes[1]), is_of_keyframes: true }
        })
    }
}

/// The control points of the middle one of three intervals of these lengths.
fn catmull_rom(property: Property, [c0, c1, c2, c3]: [DVec4; 4], [before, own, after]: [f64; 3]) -> [DVec4; 4] {
    let [start, end] = [before, after].map(|beside| own / (3.0 * (beside + own)));
    if property != Property::Rotation {
        return [c1, c1 + (c2 - c0) * start, c2 - (c3 - c1) * end, c2];
    }
    // A part of the turn from one rotation to another, done after a third one.
    let turned = |from: DVec4, to: DVec4, part: f64, third: DVec4| {
        let turn = DQuat::from_vec4(to) * DQuat::from_vec4(from).conjugate();
        let power = DQuat::from_vec4(slerp(DQuat::IDENTITY.into(), turn.into(), part.abs()));
        let power = if part < 0.0 { power.conjugate() } else { power };
        DVec4::from((power * DQuat::from_vec4(third)).normalize())
    };
    [c1, turned(c0, c2, start, c1), turned(c1, c3, -end, c2), c2]
}

/// The motions of a control node, by its timed keys.
fn timed(node: usize, tracks: &Tracks) -> Vec<Motion> {
    let channels = [
        (Channel::Translation, Property::Translation),
        (Channel::Rotation, Property::Rotation),
        (Channel::Scale, Property::Scale),
    ];
    let motion = |(channel, property): (Channel, Property)| {
        let track = tracks.get(channel)?;
        let mut keys: Vec<(f64, DVec4)> =
            track.keys().map(|(seconds, numbers)| (seconds, numbers.as_dvec4())).collect();
        slow_down_jumps(&mut keys);
        let rest = keys[0].1;
        let first = property.unit(rest);
        let mut motion = Motion { node, property, spans: Vec::new(), first, rest, is_of_keyframes: false };
        for pair in keys.windows(2) {
            let [(start, from), (end, to)] = [pair[0], pair[1]];
            if end <= 0.0 {
                motion.rest = to;
                continue;
            }
            let (start, from) = if start < 0.0 {
                // A glTF file has no times below 0.
                motion.rest = property.blend(property.unit(from), property.unit(to), -start / (end - start));
                (0.0, motion.rest)
            } else {
                (start, from)
            };
            motion.spans.push(Span {
                seconds: [start, end],
                ends: [from, to],
                easing: Easing::Linear,
                curve: Curve::Line([from, to].map(|value| property.unit(value))),
            });
        }
        motion.first = property.unit(motion.rest);
        Some(motion)
    };
    channels.into_iter().filter_map(motion).collect()
}

/// Moves keys that a jump follows to an earlier time, so that the jump takes the shortest step.
fn slow_down_jumps(keys: &mut [(f64, DVec4)]) {
    for at in 2..keys.len() {
        let [before, start, end] = [at - 2, at - 1, at].map(|key| keys[key].0);
        let step = shortest_step(end);
        // One that was written so is not moved again for its rounding.
        if end - start < 0.9 * step {
            keys[at - 1].0 = (end - step).max(f64::midpoint(before, start)).min(start);
        }
    }
}
