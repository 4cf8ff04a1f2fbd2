//! FLIP's feature metric: differences of edges and points amplify the error.

use super::filter::{Plane, kernel};
use super::pixel_error::PIXELS_PER_DEGREE;

/// The width of the most visible features, in degrees.
const FEATURE_WIDTH: f32 = 0.082;
/// How much a difference of features matters.
const FEATURE_EXPONENT: f32 = 0.5;

/// The strength of edges and of points in a plane of luminances (0 to 1): two planes, 0 to √2.
struct Features {
    edges: Vec<f32>,
    points: Vec<f32>,
}

/// The difference of the features (edges and points) of two luminance planes, 0 to 1 for each pixel.
pub fn differences(first: &Plane, second: &Plane) -> Vec<f32> {
    let (first, second) = (features(first), features(second));
    let pair = |a: &[f32], b: &[f32], pixel: usize| (a[pixel] - b[pixel]).abs();
    (0..first.edges.len())
        .map(|pixel| {
            let edge = pair(&first.edges, &second.edges, pixel);
            let point = pair(&first.points, &second.points, pixel);
            (edge.max(point) * std::f32::consts::FRAC_1_SQRT_2).powf(FEATURE_EXPONENT).min(1.0)
        })
        .collect()
}

fn features(luminance: &Plane) -> Features {
    let deviation = 0.5 * FEATURE_WIDTH * PIXELS_PER_DEGREE;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small positive number")]
    let radius = (3.0 * deviation).ceil() as u16;
    let bell = |x: f32| (-x * x / (2.0 * deviation * deviation)).exp();
    let smooth = {
        let samples = kernel(radius, bell);
        let sum: f32 = samples.iter().sum();
        samples.iter().map(|sample| sample / sum).collect::<Vec<_>>()
    };
    let slope = balanced(&kernel(radius, |x| -x * bell(x)));
    let bend = balanced(&kernel(radius, |x| (x * x / (deviation * deviation) - 1.0) * bell(x)));
    let lengths = |derivative: &[f32]| {
        let along_x = luminance.filtered(derivative, &smooth).values;
        let along_y = luminance.filtered(&smooth, derivative).values;
        along_x.into_iter().zip(along_y).map(|(x, y)| x.hypot(y)).collect()
    };
    Features { edges: lengths(&slope), points: lengths(&bend) }
}

/// A kernel scaled so that its positive samples sum to 1 and its negative ones to −1.
fn balanced(samples: &[f32]) -> Vec<f32> {
    let positive: f32 = samples.iter().filter(|sample| **sample > 0.0).sum();
    let negative: f32 = -samples.iter().filter(|sample| **sample < 0.0).sum::<f32>();
    samples.iter().map(|&sample| sample / if sample > 0.0 { positive } else { negative }).collect()
}
