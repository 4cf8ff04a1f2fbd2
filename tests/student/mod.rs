//! A student's program, with a mistake, with two or with none: it makes keyframes and prints what it shows. Written from the formulas and from
//! the mistakes' descriptions alone; it shares no code with the diagnosis.
#![allow(dead_code, missing_docs, reason = "each test uses a part")]

use std::fmt::Write as _;

/// w, x, y, z.
pub type Quaternion = [f64; 4];
pub type Placed = ([f64; 3], Quaternion);

/// Mistakes that can be made in linear playback.
pub const LINEAR: [&str; 18] = [
    "correct",
    "no-conditional-negation",
    "lerp-for-slerp",
    "nlerp-for-slerp",
    "nan-when-equal",
    "angle-not-halved",
    "identity-when-equal",
    "all-keyframes-played",
    "one-keyframe-early",
    "last-sample-missing",
    "quaternion-order-swapped",
    "integer-tick",
    "small-turns-frozen",
    "powers-for-slerp",
    "only-w-negated",
    "nan-where-the-axis-has-no-x",
    "translation-weights-swapped",
    "slerp-angle-from-cross-product",
];

/// Mistakes that can be made in Catmull-Rom playback.
pub const SPLINE: [&str; 26] = [
    "correct-catmull-rom",
    "no-conditional-negation",
    "lerp-for-slerp",
    "nlerp-for-slerp",
    "nan-when-equal",
    "angle-not-halved",
    "identity-when-equal",
    "second-control-point-on-wrong-keyframe",
    "no-division-by-six",
    "sixth-in-integers",
    "no-conditional-negation-in-control-points",
    "all-keyframes-played",
    "one-keyframe-early",
    "last-sample-missing",
    "quaternion-order-swapped",
    "integer-tick",
    "sixth-in-integers-in-rotations",
    "sixth-in-integers-in-translations",
    "small-turns-frozen",
    "powers-for-slerp",
    "only-w-negated",
    "nan-where-the-axis-has-no-x",
    "second-control-point-on-wrong-keyframe-in-translations",
    "translation-weights-swapped",
    "tangent-from-wrong-neighbour",
    "cubic-by-components",
];

/// Pairs of mistakes that can be made at once, in linear playback.
pub const LINEAR_PAIRS: [&str; 15] = [
    "no-conditional-negation + last-sample-missing",
    "no-conditional-negation + nlerp-for-slerp",
    "lerp-for-slerp + all-keyframes-played",
    "lerp-for-slerp + integer-tick",
    "nlerp-for-slerp + translation-weights-swapped",
    "nan-when-equal + nan-where-the-axis-has-no-x",
    "nan-when-equal + one-keyframe-early",
    "no-conditional-negation + nan-when-equal",
    "angle-not-halved + translation-weights-swapped",
    "identity-when-equal + last-sample-missing",
    "no-conditional-negation + quaternion-order-swapped",
    "small-turns-frozen + nan-where-the-axis-has-no-x",
    "only-w-negated + translation-weights-swapped",
    "powers-for-slerp + last-sample-missing",
    "slerp-angle-from-cross-product + last-sample-missing",
];

/// Pairs of mistakes that can be made at once, in Catmull-Rom playback.
pub const SPLINE_PAIRS: [&str; 18] = [
    "sixth-in-integers + last-sample-missing",
    "sixth-in-integers-in-rotations + last-sample-missing",
    "no-conditional-negation-in-control-points + sixth-in-integers-in-translations",
    "no-conditional-negation-in-control-points + last-sample-missing",
    "no-conditional-negation + no-conditional-negation-in-control-points",
    "nlerp-for-slerp + no-division-by-six",
    "lerp-for-slerp + second-control-point-on-wrong-keyframe",
    "second-control-point-on-wrong-keyframe + no-division-by-six",
    "second-control-point-on-wrong-keyframe + all-keyframes-played",
    "sixth-in-integers-in-rotations + second-control-point-on-wrong-keyframe-in-translations",
    "nan-when-equal + integer-tick",
    "identity-when-equal + all-keyframes-played",
    "quaternion-order-swapped + cubic-by-components",
    "one-keyframe-early + powers-for-slerp",
    "angle-not-halved + sixth-in-integers-in-translations",
    "all-keyframes-played + tangent-from-wrong-neighbour",
    "sixth-in-integers-in-rotations + translation-weights-swapped",
    "small-turns-frozen + second-control-point-on-wrong-keyframe-in-translations",
];

pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    /// From −1 to 1.
    pub fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn rotation(&mut self) -> Quaternion {
        loop {
            let q = [self.next(), self.next(), self.next(), self.next()];
            let length = dot(q, q).sqrt();
            if (0.2..1.0).contains(&length) {
                return q.map(|component| (component / length * 1e7).round() / 1e7);
            }
        }
    }
}

fn dot(a: Quaternion, b: Quaternion) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn negative(q: Quaternion) -> Quaternion {
    q.map(|component| -component)
}

fn times([aw, ax, ay, az]: Quaternion, [bw, bx, by, bz]: Quaternion) -> Quaternion {
    [
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
    ]
}

fn over(a: Quaternion, [w, x, y, z]: Quaternion) -> Quaternion {
    times(a, [w, -x, -y, -z])
}

/// So many keyframes of so many nodes; node 1 never turns, node 2 does not turn from keyframe 2 to keyframe 3.
pub fn keyframes(seed: u64, count: usize, nodes: usize) -> Vec<Vec<Placed>> {
    let mut random = Random::new(seed);
    let mut made: Vec<Vec<Placed>> = Vec::new();
    for keyframe in 0..count {
        let pose = (0..nodes)
            .map(|node| {
                let translation = [(); 3].map(|()| (random.next() * 5000.0).round() / 1000.0);
                let stays = keyframe > 0 && (node == 1 || (node == 2 && keyframe == 3));
                let rotation = if stays { made[keyframe - 1][node].1 } else { random.rotation() };
                (translation, rotation)
            })
            .collect();
        made.push(pose);
    }
    made
}

/// The same, but node 3 turns by 2 degrees a keyframe, and node 4 about z alone.
pub fn varied_keyframes(seed: u64, count: usize, nodes: usize) -> Vec<Vec<Placed>> {
    let mut made = keyframes(seed, count, nodes);
    let about_z = |degrees: f64| {
        let (sine, cosine) = (degrees / 2.0).to_radians().sin_cos();
        [cosine, 0.0, 0.0, sine]
    };
    for keyframe in 0..count {
        let before = made[keyframe.saturating_sub(1)][3].1;
        made[keyframe][3].1 = times(about_z(2.0), before);
        made[keyframe][4].1 = about_z(40.0 * keyframe as f64);
    }
    made
}

/// A keyframe file.
pub fn file(keyframes: &[Vec<Placed>], paths: &[String], scene: &str, interpolation: &str, ms: u32) -> String {
    let poses: Vec<_> = keyframes
        .iter()
        .map(|pose| {
            let entries: Vec<_> = pose
                .iter()
                .map(|(t, [w, x, y, z])| serde_json::json!({"translation": t, "rotation": [x, y, z, w]}))
                .collect();
            serde_json::json!({"pose": entries})
        })
        .collect();
    serde_json::json!({"format": "inbetween.keyframes", "version": 1, "scene": scene, "interpolation": interpolation,
        "ms_between_keyframes": ms, "nodes": paths, "keyframes": poses})
    .to_string()
}

/// Joined to a mistake's name by ` + `: the program computes in single precision.
pub const SINGLE: &str = "single precision";

/// The program.
pub struct Student<'a> {
    /// A name, or two joined by ` + `; perhaps also [`SINGLE`].
    pub mistake: &'a str,
    pub plays_splines: bool,
    pub keyframes: &'a [Vec<Placed>],
}

impl Student<'_> {
    fn makes(&self, mistake: &str) -> bool {
        self.mistake.split(" + ").any(|made| made == mistake)
    }

    /// What its numbers can hold.
    fn fit<const N: usize>(&self, numbers: [f64; N]) -> [f64; N] {
        let is_single = self.makes(SINGLE);
        numbers.map(|number| if is_single { f64::from(number as f32) } else { number })
    }

    fn times(&self, a: Quaternion, b: Quaternion) -> Quaternion {
        self.fit(times(a, b))
    }

    fn over(&self, a: Quaternion, b: Quaternion) -> Quaternion {
        self.fit(over(a, b))
    }

    fn power(&self, q: Quaternion, exponent: f64) -> Quaternion {
        let sine = (q[1] * q[1] + q[2] * q[2] + q[3] * q[3]).sqrt();
        // What the product of a quaternion and its inverse leaves of a rotation is rounding.
        let sine = if sine < 1e-12 || (self.makes(SINGLE) && q[0].abs() >= 1.0) { 0.0 } else { sine };
        if self.makes("nan-where-the-axis-has-no-x") && sine != 0.0 && q[1].abs() < 1e-12 {
            return [f64::NAN; 4];
        }
        let half_angle = f64::atan2(sine, q[0]);
        let turned = exponent * half_angle * if self.makes("angle-not-halved") { 2.0 } else { 1.0 };
        if sine == 0.0 && !self.makes("nan-when-equal") {
            return [1.0, 0.0, 0.0, 0.0];
        }
        let along = turned.sin() / sine;
        self.fit([turned.cos() + 0.0 * along, q[1] * along, q[2] * along, q[3] * along])
    }

    fn turn(&self, q: Quaternion, short: bool) -> Quaternion {
        match q {
            [w, x, y, z] if w < 0.0 && self.makes("only-w-negated") => [-w, x, y, z],
            _ if short && q[0] < 0.0 => negative(q),
            _ => q,
        }
    }

    fn slerp(&self, from: Quaternion, to: Quaternion, alpha: f64) -> Quaternion {
        let blended = |to: Quaternion| [0, 1, 2, 3].map(|c| (1.0 - alpha) * from[c] + alpha * to[c]);
        if self.makes("lerp-for-slerp") {
            return blended(to);
        }
        if self.makes("nlerp-for-slerp") {
            let is_far = dot(from, to) < 0.0 && !self.makes("no-conditional-negation");
            let q = blended(if is_far { negative(to) } else { to });
            return self.fit(q.map(|component| component / dot(q, q).sqrt()));
        }
        if self.makes("powers-for-slerp") {
            return self.times(self.power(from, 1.0 - alpha), self.power(to, alpha));
        }
        if self.makes("slerp-angle-from-cross-product") {
            let [_, a, b, c] = from;
            let [_, d, e, f] = to;
            let cross = [b * f - c * e, c * d - a * f, a * e - b * d];
            let omega = cross.iter().map(|part| part * part).sum::<f64>().sqrt().atan2(dot(from, to));
            if omega.sin().abs() < 1e-6 {
                return from;
            }
            let weights = [((1.0 - alpha) * omega).sin() / omega.sin(), (alpha * omega).sin() / omega.sin()];
            return self.fit([0, 1, 2, 3].map(|c| weights[0] * from[c] + weights[1] * to[c]));
        }
        let turn = self.turn(self.over(to, from), !self.makes("no-conditional-negation"));
        let is_still =
            turn[1].abs().max(turn[2].abs()).max(turn[3].abs()) < 1e-12 || (self.makes(SINGLE) && turn[0] >= 1.0);
        if self.makes("small-turns-frozen") && turn[0] > 0.9995 {
            return from;
        }
        if is_still && self.makes("identity-when-equal") {
            return [1.0, 0.0, 0.0, 0.0];
        }
        self.times(self.power(turn, alpha), from)
    }

    /// What is shown of a node between keyframe `start` of the list and the next.
    fn between(&self, start: usize, alpha: f64, node: usize) -> Placed {
        let last = self.keyframes.len() - 1;
        let c = |place: usize| self.keyframes[place.min(last)][node];
        let (from, to) = (c(start), c(start + 1));
        let weight = if self.makes("translation-weights-swapped") { 1.0 - alpha } else { alpha };
        let mix =
            |a: [f64; 3], b: [f64; 3]| self.fit([0, 1, 2].map(|axis| a[axis] * (1.0 - weight) + b[axis] * weight));
        if !self.plays_splines {
            return (mix(from.0, to.0), self.slerp(from.1, to.1, alpha));
        }
        let (before, after) = (c(start.saturating_sub(1)), c(start + 2));
        let share = |part: &str| match () {
            () if self.makes("no-division-by-six") => 1.0,
            () if self.makes("sixth-in-integers") || self.makes(&format!("sixth-in-integers-in-{part}")) => {
                f64::from(1 / 6)
            }
            () => 1.0 / 6.0,
        };
        let (of_moves, of_turns) = (share("translations"), share("rotations"));
        let wrong = "second-control-point-on-wrong-keyframe";
        let base = if self.makes(wrong) { from } else { to };
        let base_of_moves = if self.makes(&format!("{wrong}-in-translations")) { from } else { base };
        let short = !self.makes("no-conditional-negation-in-control-points");
        let ahead = if self.makes("tangent-from-wrong-neighbour") { from } else { to };
        let tangent =
            |to: Quaternion, from: Quaternion, share| self.power(self.turn(self.over(to, from), short), share);
        let d = (
            [0, 1, 2].map(|axis| from.0[axis] + of_moves * (ahead.0[axis] - before.0[axis])),
            self.times(tangent(ahead.1, before.1, of_turns), from.1),
        );
        let e = (
            [0, 1, 2].map(|axis| base_of_moves.0[axis] - of_moves * (after.0[axis] - from.0[axis])),
            self.times(tangent(after.1, from.1, -of_turns), base.1),
        );
        let step = |a: Placed, b: Placed| (mix(a.0, b.0), self.slerp(a.1, b.1, alpha));
        let (f, g, h) = (step(from, d), step(d, e), step(e, to));
        let (translation, rotation) = step(step(f, g), step(g, h));
        if self.makes("cubic-by-components") {
            // Catmull and Rom's own cubic.
            let cubic = |[a, b, c, d]: [f64; 4]| {
                let [linear, square, cube] = [c - a, 2.0 * a - 5.0 * b + 4.0 * c - d, 3.0 * b - a - 3.0 * c + d];
                b + alpha / 2.0 * (linear + alpha * (square + alpha * cube))
            };
            return (
                translation,
                [0, 1, 2, 3].map(|part| cubic([before, from, to, after].map(|corner| corner.1[part]))),
            );
        }
        (translation, rotation)
    }

    /// What is shown of a node at a key time.
    pub fn shows(&self, key_time: f64, node: usize) -> Placed {
        let (first, end) = match () {
            () if self.makes("all-keyframes-played") => (0, self.keyframes.len() - 1),
            () if self.makes("one-keyframe-early") => (2, self.keyframes.len() - 1),
            () => (1, self.keyframes.len() - 2),
        };
        let key_time = if self.makes("integer-tick") { key_time * 0.96 } else { key_time };
        let start = first + key_time.floor() as usize;
        let (translation, rotation) =
            if start >= end { self.keyframes[end][node] } else { self.between(start, key_time.fract(), node) };
        let [w, x, y, z] = rotation;
        (translation, if self.makes("quaternion-order-swapped") { [x, y, z, w] } else { rotation })
    }

    /// Samples as CSV, to so many decimals, at so many frames a second, with `ms_between_keyframes`; perhaps with milliseconds.
    pub fn samples(&self, frames_per_second: f64, ms_between_keyframes: f64, has_ms: bool, decimals: usize) -> String {
        let mut text = format!("key_time,rbt_ind,tx,ty,tz,rw,rx,ry,rz{}\n", if has_ms { ",ms" } else { "" });
        let last = (self.keyframes.len() - 3) as f64;
        for frame in 0.. {
            let ms = f64::from(frame) * 1000.0 / frames_per_second;
            let at_end = ms / ms_between_keyframes >= last;
            let key_time = (ms / ms_between_keyframes).min(last);
            if at_end && self.makes("last-sample-missing") {
                break;
            }
            for node in 0..self.keyframes[0].len() {
                let ([x, y, z], rotation) = self.shows(key_time, node);
                let _ = write!(text, "{key_time:.6},{node},{x:.decimals$},{y:.decimals$},{z:.decimals$}");
                for component in rotation {
                    let _ = if component.is_nan() {
                        write!(text, ",-nan(ind)")
                    } else {
                        write!(text, ",{component:.decimals$}")
                    };
                }
                let _ = if has_ms { writeln!(text, ",{:.3}", key_time * ms_between_keyframes) } else { writeln!(text) };
            }
            if at_end {
                break;
            }
        }
        text
    }
}
