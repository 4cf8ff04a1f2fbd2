//! Chooses the keys of a channel: as few as stay within a tolerance, or one for each frame.

use glam::DVec4;

use super::keyed::{Keyed, Reader, between, hermite};
use super::motion::{Motion, Property, Span, aligned, angle_between};

/// The fewest and the most cells of a span. Keys lie between cells, so there are many more cells than keys.
const CELLS: std::ops::RangeInclusive<usize> = 16..=4096;
/// So many cells together are tried: of two, the middle would not show how unevenly readers turn that blend by components.
const TRIED: usize = 4;
/// So many cells in the shortest step that is allowed are enough.
const CELLS_OF_SHORTEST: usize = 16;
/// They may be off by so much of the tolerance. The error of a line grows with the square of its length, so a step has some sixteen cells.
const ERROR_OF_LINE: f64 = 1.0 / 16.0;
/// The error of a cubic grows with the fourth power.
const ERROR_OF_CUBIC: f64 = 1.0 / 256.0;

/// How the values between keys are said.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Curves {
    /// Straight from key to key.
    #[default]
    Linear,
    /// Cubic, with tangents.
    Cubic,
}

/// As few keys as stay within a tolerance in the channel's own units: radians, scene units, factors. Keyframes and timed keys are keys.
pub fn within(motion: &Motion, tolerance: f64, curves: Curves) -> Keyed {
    keyed(motion, curves, |span| {
        let mut fractions = vec![0.0];
        for ends in smooth_parts(span, motion.property).windows(2) {
            let inner = Cells::of(span, motion.property, [ends[0], ends[1]], tolerance, curves).chosen(tolerance);
            fractions.extend(inner.into_iter().filter(|&fraction| fraction > 0.0 && fraction < 1.0));
        }
        fractions.push(1.0);
        fractions.dedup();
        fractions
    })
}

/// Where the parts of a span begin and end that are smooth, as fractions.
fn smooth_parts(span: &Span, property: Property) -> Vec<f64> {
    let ([start, end], shortest) = (span.smooth(property), span.shortest_step());
    let mut ends = vec![start];
    for kink in span.kinks() {
        if kink - ends[ends.len() - 1] >= shortest && end - kink >= shortest {
            ends.push(kink);
        }
    }
    ends.push(end);
    ends
}

/// A key for each frame from 0 s, and one at the end. Timed keys are keys too.
pub fn each_frame(motion: &Motion, frames_per_second: u32, curves: Curves) -> Keyed {
    let last = motion.spans.last().map_or(0.0, |span| span.seconds[1]);
    keyed(motion, curves, |span| {
        let is_end = |end: usize| !motion.is_of_keyframes || (end == 1 && span.seconds[1] == last);
        let rate = f64::from(frames_per_second);
        let frames = (span.seconds[0] * rate).ceil() as u64..=(span.seconds[1] * rate).floor() as u64;
        let frames = frames.map(|frame| ((frame as f64 / rate - span.seconds[0]) / span.length()).clamp(0.0, 1.0));
        let is_at_end = |end: usize, off: f64| is_end(end) && off < span.shortest_step();
        let frames = frames.filter(|&fraction| !is_at_end(0, fraction) && !is_at_end(1, 1.0 - fraction));
        let mut fractions: Vec<f64> = is_end(0).then_some(0.0).into_iter().chain(frames).collect();
        fractions.extend(is_end(1).then_some(1.0));
        fractions.dedup();
        fractions
    })
}

/// A key of a channel before its signs are chosen.
struct Knot {
    seconds: f32,
    value: DVec4,
    /// The changes a second before and after it.
    tangents: [DVec4; 2],
}

/// The keys at the chosen fractions of each span.
fn keyed(motion: &Motion, curves: Curves, fractions: impl Fn(&Span) -> Vec<f64>) -> Keyed {
    let mut keyed = Keyed::new(motion.node, motion.property);
    let mut last: Option<Knot> = None;
    if motion.is_constant() {
        keyed.push(0.0, motion.rest, None);
        return keyed;
    }
    let mut push =
        |knot: Knot| keyed.push(knot.seconds, knot.value, (curves == Curves::Cubic).then_some(knot.tangents));
    for span in &motion.spans {
        for fraction in fractions(span) {
            let mut knot = knot(span, motion.property, fraction, curves);
            match last.take() {
                // The end of a span is the beginning of the next one.
                Some(before) if before.seconds >= knot.seconds => {
                    let is_negated = motion.property == Property::Rotation && before.value.dot(knot.value) < 0.0;
                    knot.tangents[0] = if is_negated { -before.tangents[0] } else { before.tangents[0] };
                }
                Some(before) => push(before),
                None => {}
            }
            last = Some(knot);
        }
    }
    last.into_iter().for_each(push);
    keyed
}

fn knot(span: &Span, property: Property, fraction: f64, curves: Curves) -> Knot {
    let seconds = (span.seconds[0] + fraction * span.length()) as f32;
    // The value is that of the rounded time, but at the ends, whose values others read as keyframes.
    let rounded = ((f64::from(seconds) - span.seconds[0]) / span.length()).clamp(f64::EPSILON, 1.0 - f64::EPSILON);
    let value = match fraction {
        0.0 => span.ends[0],
        1.0 => span.ends[1],
        _ => span.value(property, rounded),
    };
    let tangents = match curves {
        Curves::Linear => [DVec4::ZERO; 2],
        Curves::Cubic => {
            // In a jump nothing has a slope.
            let [start, end] = span.smooth(property);
            let is_smooth = (start..=end).contains(&fraction);
            [(-1.0, fraction > start), (1.0, fraction < end)].map(|(side, is_inside)| {
                let is_inside = is_inside && is_smooth;
                if is_inside { span.derivative(property, fraction, value, side) / span.length() } else { DVec4::ZERO }
            })
        }
    };
    Knot { seconds, value, tangents }
}

/// A span at equal steps.
struct Cells {
    property: Property,
    /// Where the first cell begins and the last one ends, as fractions of the span.
    ends: [f64; 2],
    /// So many make the shortest step between two keys.
    shortest: usize,
    values: Vec<DVec4>,
    /// For cubics, the changes before and after each value, per cell.
    tangents: Vec<[DVec4; 2]>,
}

impl Cells {
    /// So many cells that a step within the tolerance has several.
    fn of(span: &Span, property: Property, ends: [f64; 2], tolerance: f64, curves: Curves) -> Self {
        let mut count = *CELLS.start();
        loop {
            let cells = Self::counted(span, property, ends, count, curves);
            let error = match curves {
                Curves::Linear => ERROR_OF_LINE,
                Curves::Cubic => ERROR_OF_CUBIC,
            };
            let is_fine = cells.shortest >= CELLS_OF_SHORTEST || cells.have_steps_within(tolerance * error);
            if span.is_constant() || count >= *CELLS.end() || is_fine {
                return cells;
            }
            count *= 2;
        }
    }

    fn counted(span: &Span, property: Property, ends: [f64; 2], count: usize, curves: Curves) -> Self {
        let step = (ends[1] - ends[0]) / count as f64;
        let fraction = |cell: usize| if cell == count { ends[1] } else { ends[0] + step * cell as f64 };
        let values: Vec<DVec4> = (0..=count).map(|cell| span.value(property, fraction(cell))).collect();
        let tangents = match curves {
            Curves::Linear => Vec::new(),
            Curves::Cubic => {
                let tangent = |cell: usize, side| span.derivative(property, fraction(cell), values[cell], side) * step;
                let side = |cell: usize, side, is_there: bool| if is_there { tangent(cell, side) } else { DVec4::ZERO };
                (0..=count).map(|cell| [side(cell, -1.0, cell > 0), side(cell, 1.0, cell < count)]).collect()
            }
        };
        let shortest = (span.shortest_step() / step).ceil().max(1.0) as usize;
        Self { property, ends, shortest, values, tangents }
    }

    fn have_steps_within(&self, tolerance: f64) -> bool {
        (0..self.values.len() - TRIED).step_by(TRIED).all(|cell| self.fits(cell, cell + TRIED, tolerance))
    }

    /// The fractions of the keys: from each one the longest step that fits.
    fn chosen(&self, tolerance: f64) -> Vec<f64> {
        let last = self.values.len() - 1;
        let fraction = |cell: usize| match cell {
            0 => self.ends[0],
            _ if cell == last => self.ends[1],
            _ => self.ends[0] + (self.ends[1] - self.ends[0]) * cell as f64 / last as f64,
        };
        let mut keys = vec![0];
        let (mut from, mut step) = (0, 1);
        while from < last {
            step = self.longest_step(from, step, tolerance);
            from += step;
            keys.push(from);
        }
        // What is left for the last step may be so short that readers take its two keys for one.
        if let [.., before, inner, _] = keys[..] {
            let at = keys.len() - 2;
            let middle = usize::midpoint(before, last);
            let is_short = last - inner < self.shortest;
            if is_short && middle - before < self.shortest {
                keys.truncate(at);
                self.spread(&mut keys, last);
            } else if is_short || (self.fits(before, middle, tolerance) && self.fits(middle, last, tolerance)) {
                keys[at] = middle.min(inner);
            }
        }
        keys.into_iter().map(fraction).collect()
    }

    /// Adds the last key. It is less than two of the shortest steps away, which all such steps before share.
    fn spread(&self, keys: &mut Vec<usize>, last: usize) {
        let shortest = keys.windows(2).rev().take_while(|pair| pair[1] - pair[0] == self.shortest).count();
        let first = keys.len() - 1 - shortest;
        let (start, steps) = (keys[first], shortest + 1);
        for step in 1..steps {
            keys[first + step] = start + (last - start) * step / steps;
        }
        keys.push(last);
    }

    /// The longest step that fits, found from one that was so before.
    fn longest_step(&self, from: usize, guess: usize, tolerance: f64) -> usize {
        let most = self.values.len() - 1 - from;
        let fits = |step: usize| self.fits(from, from + step, tolerance);
        // The shortest step always serves.
        let shortest = self.shortest.min(most);
        let (mut good, mut bad) = (shortest, most + 1);
        let mut step = guess.min(most);
        loop {
            if step <= good || fits(step) {
                good = good.max(step);
                if good == most || bad <= most {
                    break;
                }
                step = (2 * good).min(most);
            } else {
                bad = step;
                if good > shortest || step <= 2 * shortest {
                    break;
                }
                step /= 2;
            }
        }
        while good + 1 < bad {
            let middle = usize::midpoint(good, bad);
            if fits(middle) { good = middle } else { bad = middle }
        }
        good
    }

    /// Whether what readers show between two cells stays within a tolerance of the values between them.
    fn fits(&self, from: usize, to: usize, tolerance: f64) -> bool {
        let length = (to - from) as f64;
        let (start, end) = (self.values[from], self.values[to]);
        let is_near = |shown: DVec4, cell: usize| {
            let value = self.values[cell];
            let error = match self.property {
                Property::Rotation => angle_between(shown, value),
                Property::Translation | Property::Scale => (shown - value).length(),
            };
            error <= tolerance
        };
        let fraction = |cell: usize| (cell - from) as f64 / length;
        if self.tangents.is_empty() {
            let shown = |cell, reader| between(self.property, start, end, fraction(cell), reader);
            let readers: &[Reader] = match self.property {
                Property::Rotation => &[Reader::ByComponents, Reader::Exact],
                Property::Translation | Property::Scale => &[Reader::Exact],
            };
            return (from + 1..to).all(|cell| readers.iter().all(|&reader| is_near(shown(cell, reader), cell)));
        }
        let ([_, out], [mut into, _]) = (self.tangents[from], self.tangents[to]);
        let mut end = end;
        if self.property == Property::Rotation && start.dot(end) < 0.0 {
            (end, into) = (aligned(end, start), -into);
        }
        let tangents = [out * length, into * length];
        (from + 1..to).all(|cell| is_near(hermite(self.property, [start, end], tangents, fraction(cell)), cell))
    }
}
