//! LDR-FLIP: the error of each pixel.

use std::f32::consts::PI;
use std::thread;

use super::colour::{hunt_lab_from_linear, hyab, linear_from_srgb_levels, linear_from_ycxcz, ycxcz_from_linear};
use super::features;
use super::filter::{Plane, kernel};

/// A screen 0.7 m wide with 3840 pixels in a row, seen from 0.7 m: FLIP's own default.
pub const PIXELS_PER_DEGREE: f32 = 0.7 * 3840.0 / 0.7 * PI / 180.0;

/// Exponent of the distance between colours.
const COLOUR_EXPONENT: f32 = 0.7;
/// The part of the largest distance below which errors take up [`MOST_OF_ERRORS`] of the range.
const SMALL_DISTANCES: f32 = 0.4;
const MOST_OF_ERRORS: f32 = 0.95;

/// Intermediate data of a picture: the luminance plane, and the filtered pixels in CIELAB.
struct Seen {
    luminance: Plane,
    lab: Vec<[f32; 3]>,
}

/// The FLIP error of each pixel, 0 to 1, of two pictures of one size, composited over a grey backdrop (linear light, 0 to 1).
pub fn errors([width, _]: [usize; 2], first: &[u8], second: &[u8], backdrop: f32) -> Vec<f32> {
    let (first, second) = thread::scope(|scope| {
        let other = scope.spawn(|| see(width, second, backdrop));
        let first = see(width, first, backdrop);
        (first, other.join().expect("a comparison does not panic"))
    });
    let features = features::differences(&first.luminance, &second.luminance);
    let (green, blue) = (hunt_lab_from_linear([0.0, 1.0, 0.0]), hunt_lab_from_linear([0.0, 0.0, 1.0]));
    let largest = hyab(green, blue).powf(COLOUR_EXPONENT);
    let colours = first.lab.iter().zip(&second.lab);
    colours
        .zip(features)
        .map(|((&a, &b), feature)| {
            let colour = spread(hyab(a, b).powf(COLOUR_EXPONENT), largest).min(1.0);
            if colour > 0.0 { colour.powf(1.0 - feature) } else { 0.0 }
        })
        .collect()
}

/// Maps a distance to an error from 0 to 1. Most of the range is for small distances.
fn spread(distance: f32, largest: f32) -> f32 {
    let bend = SMALL_DISTANCES * largest;
    if distance < bend {
        MOST_OF_ERRORS / bend * distance
    } else {
        MOST_OF_ERRORS + (distance - bend) / (largest - bend) * (1.0 - MOST_OF_ERRORS)
    }
}

fn see(width: usize, rgba: &[u8], backdrop: f32) -> Seen {
    let levels = linear_from_srgb_levels();
    let mut planes = [const { Vec::new() }; 3];
    for pixel in rgba.chunks_exact(4) {
        let opacity = f32::from(pixel[3]) / 255.0;
        let linear = [pixel[0], pixel[1], pixel[2]]
            .map(|level| levels[usize::from(level)] * opacity + backdrop * (1.0 - opacity));
        for (plane, value) in planes.iter_mut().zip(ycxcz_from_linear(linear)) {
            plane.push(value);
        }
    }
    let [y, cx, cz] = planes.map(|values| Plane { width, values });
    let blurred = [blur(&y, &[(1.0, 0.0047)]), blur(&cx, &[(1.0, 0.0053)]), blur(&cz, &[(34.1, 0.04), (13.5, 0.025)])];
    let lab = (0..y.values.len())
        .map(|pixel| {
            let [y, cx, cz] = &blurred;
            hunt_lab_from_linear(linear_from_ycxcz([y[pixel], cx[pixel], cz[pixel]]))
        })
        .collect();
    let luminance = Plane { width, values: y.values.iter().map(|value| (value + 16.0) / 116.0).collect() };
    Seen { luminance, lab }
}

/// Filters a plane by the eye's contrast sensitivity: a sum of Gaussians a·√(π/b)·exp(−π²r²/b), r in degrees, of weight 1.
fn blur(plane: &Plane, gaussians: &[(f32, f32)]) -> Vec<f32> {
    // The radius is three standard deviations of the widest Gaussian of all channels.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small positive number")]
    let radius = (3.0 * (0.04 / (2.0 * PI * PI)).sqrt() * PIXELS_PER_DEGREE).ceil() as u16;
    let parts: Vec<(f32, Vec<f32>)> = gaussians
        .iter()
        .map(|&(a, b)| {
            let samples = kernel(radius, |x| (-PI * PI * (x / PIXELS_PER_DEGREE).powi(2) / b).exp());
            let sum: f32 = samples.iter().sum();
            (a * (PI / b).sqrt() * sum * sum, samples.iter().map(|sample| sample / sum).collect())
        })
        .collect();
    let total: f32 = parts.iter().map(|(weight, _)| weight).sum();
    let mut sum = vec![0.0; plane.values.len()];
    for (weight, samples) in &parts {
        for (sum, value) in sum.iter_mut().zip(plane.filtered(samples, samples).values) {
            *sum += weight / total * value;
        }
    }
    sum
}
