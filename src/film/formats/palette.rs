//! A palette of at most 255 colours for a whole film.

use std::collections::{BTreeMap, BTreeSet};

use super::oklab::{Lab, distance_squared, from_levels, to_levels};
use crate::picture::Image;

/// Colours in a palette; the one after them is transparent.
pub const MOST_COLOURS: usize = 255;
/// Approximate number of pixels that are read from the sampled pictures.
const SAMPLED_PIXELS: usize = 120_000;
/// How often the colours move to the middle of those that are nearest to them. After that they hardly move.
const ROUNDS: usize = 8;

/// The palette of a film.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Palette {
    colours: Vec<[u8; 3]>,
    is_exact: bool,
}

impl Palette {
    /// The palette of a film from sample pictures: their own colours if they are few, otherwise 255 that are as near to theirs as can be to
    /// the eye. Pixels with less than half opacity are ignored.
    #[must_use]
    pub fn of(pictures: &[Image]) -> Self {
        let pixels =
            || pictures.iter().flat_map(|picture| picture.rgba.chunks_exact(4)).filter(|pixel| pixel[3] >= 128);
        let mut few = BTreeSet::new();
        for pixel in pixels() {
            few.insert([pixel[0], pixel[1], pixel[2]]);
            if few.len() > MOST_COLOURS {
                // An odd step that does not divide usual widths samples every column.
                let step = (pixels().count() / SAMPLED_PIXELS).max(1) | 1;
                return Self { colours: found(&points(pixels().step_by(step))), is_exact: false };
            }
        }
        Self { colours: few.into_iter().collect(), is_exact: true }
    }

    /// The colours.
    #[must_use]
    pub fn colours(&self) -> &[[u8; 3]] {
        &self.colours
    }

    /// Whether it has all colours of the sample pictures.
    #[must_use]
    pub const fn is_exact(&self) -> bool {
        self.is_exact
    }
}

/// A colour of the samples, and how many pixels have it.
type Point = (Lab, f32);

/// The mean colours of cells of four levels a channel: thousands instead of a hundred thousand.
fn points<'a>(pixels: impl Iterator<Item = &'a [u8]>) -> Vec<Point> {
    let mut cells: BTreeMap<[u8; 3], ([u32; 3], u32)> = BTreeMap::new();
    for pixel in pixels {
        let (sums, count) = cells.entry([pixel[0] >> 2, pixel[1] >> 2, pixel[2] >> 2]).or_default();
        (0..3).for_each(|channel| sums[channel] += u32::from(pixel[channel]));
        *count += 1;
    }
    let means = cells.into_values();
    means.map(|(sums, count)| (from_levels(sums.map(|sum| sum as f32 / count as f32)), count as f32)).collect()
}

/// Colours with a small mean square of the distance to the nearest: first by splitting (Wu 1991, without his table), then by k-means.
fn found(points: &[Point]) -> Vec<[u8; 3]> {
    let mut groups = vec![Group::of(points.to_vec())];
    while groups.len() < MOST_COLOURS {
        let widest = (0..groups.len()).max_by(|&a, &b| groups[a].spread.total_cmp(&groups[b].spread)).unwrap_or(0);
        let Some(halves) = groups[widest].halves() else { break };
        let [first, second] = halves.map(Group::of);
        groups[widest] = first;
        groups.push(second);
    }
    let mut middles: Vec<Lab> = groups.iter().map(|group| group.middle).collect();
    for _ in 0..ROUNDS {
        let mut sums = vec![([0.0_f64; 3], 0.0_f64); middles.len()];
        for (colour, weight) in points {
            let (sum, all) = &mut sums[nearest(&middles, *colour)];
            (0..3).for_each(|part| sum[part] += f64::from(colour[part] * weight));
            *all += f64::from(*weight);
        }
        for (middle, (sum, all)) in middles.iter_mut().zip(sums) {
            if all > 0.0 {
                *middle = sum.map(|part| (part / all) as f32);
            }
        }
    }
    let colours: BTreeSet<[u8; 3]> = middles.into_iter().map(to_levels).collect();
    colours.into_iter().collect()
}

/// The index of the colour nearest to another; of equally near ones the first.
pub fn nearest(colours: &[Lab], colour: Lab) -> usize {
    let mut best = (f32::INFINITY, 0);
    for (index, other) in colours.iter().enumerate() {
        let distance = distance_squared(*other, colour);
        if distance < best.0 {
            best = (distance, index);
        }
    }
    best.1
}

/// Colours that share one of the palette, until they are split.
struct Group {
    points: Vec<Point>,
    middle: Lab,
    /// The axis along which they lie farthest apart.
    axis: usize,
    /// The sum of squared distances from the middle along it.
    spread: f32,
}

impl Group {
    fn of(points: Vec<Point>) -> Self {
        let all: f32 = points.iter().map(|(_, weight)| weight).sum();
        let sum =
            |value: &dyn Fn(Lab) -> f32| points.iter().map(|(colour, weight)| value(*colour) * weight).sum::<f32>();
        let middle = [0, 1, 2].map(|axis| sum(&|colour| colour[axis]) / all.max(1.0));
        let spreads = [0, 1, 2].map(|axis| sum(&|colour| (colour[axis] - middle[axis]).powi(2)));
        let axis = (1..3).fold(0, |best, axis| if spreads[axis] > spreads[best] { axis } else { best });
        Self { points, middle, axis, spread: spreads[axis] }
    }

    /// Those below the middle and the others; `None` if all are the same.
    fn halves(&self) -> Option<[Vec<Point>; 2]> {
        let is_below = |(colour, _): &Point| colour[self.axis] < self.middle[self.axis];
        let (below, above): (Vec<Point>, Vec<Point>) = self.points.iter().copied().partition(is_below);
        (!below.is_empty() && !above.is_empty()).then_some([below, above])
    }
}
