//! The two weights of `slerp` as polynomials, fitted for each fraction.

use std::f64::consts::PI;
use std::sync::LazyLock;

/// Number of points at which the polynomials interpolate the weights, besides 0.
const NODES: usize = 9;

/// `slerp`'s weights of its two ends for one fraction, as polynomials in `1 − |cos θ|`, lowest power first; θ, the angle between the
/// quaternions, is at most a quarter turn, because the nearer sign is used.
///
/// They are exact for equal quaternions: the weights are then `1 − α` and `α`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights {
    /// The fraction itself.
    pub alpha: f32,
    /// Coefficients for `sin((1 − α)θ)/sin θ`.
    pub from: [f32; NODES + 1],
    /// Coefficients for `sin(αθ)/sin θ`.
    pub to: [f32; NODES + 1],
}

impl Weights {
    /// The weights at a fraction from 0 to 1.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "the blends are in f32")]
    pub fn at(alpha: f32) -> Self {
        let fit = &*FIT;
        let fraction = f64::from(alpha);
        // Each weight minus its value at 0, divided by the variable.
        let (mut from, mut to) = ([0.0; NODES], [0.0; NODES]);
        for (index, node) in fit.nodes.iter().enumerate() {
            let (sine, cosine) = (fraction * node.theta).sin_cos();
            let to_weight = sine / node.sine;
            let from_weight = cosine - (1.0 - node.versine) * to_weight;
            from[index] = (from_weight - (1.0 - fraction)) / node.versine;
            to[index] = (to_weight - fraction) / node.versine;
        }
        let mut weights = Self { alpha, from: [0.0; NODES + 1], to: [0.0; NODES + 1] };
        weights.from[0] = (1.0 - fraction) as f32;
        weights.to[0] = alpha;
        for (power, row) in fit.coefficient_from_value.iter().enumerate() {
            let sum = |values: &[f64; NODES]| row.iter().zip(values).map(|(a, b)| a * b).sum::<f64>();
            weights.from[power + 1] = sum(&from) as f32;
            weights.to[power + 1] = sum(&to) as f32;
        }
        weights
    }
}

/// An interpolation node of the polynomials.
#[derive(Clone, Copy, Default)]
struct Node {
    /// `1 − cos θ`.
    versine: f64,
    /// θ in radians.
    theta: f64,
    /// `sin θ`.
    sine: f64,
}

/// The data that does not depend on the fraction.
struct Fit {
    nodes: [Node; NODES],
    /// The inverse of Vandermonde's matrix: a row for each power.
    coefficient_from_value: [[f64; NODES]; NODES],
}

/// Chebyshev's nodes on [0, 1] and Lagrange's polynomials through them.
static FIT: LazyLock<Fit> = LazyLock::new(|| {
    let mut nodes = [Node::default(); NODES];
    for (index, node) in (0..).zip(&mut nodes) {
        let versine = 0.5 - 0.5 * (PI * (f64::from(2 * index) + 1.0) / (2.0 * NODES as f64)).cos();
        let theta = (1.0 - versine).acos();
        *node = Node { versine, theta, sine: theta.sin() };
    }
    let mut coefficient_from_value = [[0.0; NODES]; NODES];
    for (index, node) in nodes.iter().enumerate() {
        // The product of (x − x_j)/(x_i − x_j) over all other nodes j.
        let mut product = [0.0; NODES];
        product[0] = 1.0;
        for (_, other) in nodes.iter().enumerate().filter(|(other, _)| *other != index) {
            let mut longer = [0.0; NODES];
            for (power, &coefficient) in product.iter().enumerate() {
                longer[power] -= coefficient * other.versine;
                if let Some(above) = longer.get_mut(power + 1) {
                    *above += coefficient;
                }
            }
            product = longer.map(|coefficient| coefficient / (node.versine - other.versine));
        }
        for (row, coefficient) in coefficient_from_value.iter_mut().zip(product) {
            row[index] = coefficient;
        }
    }
    Fit { nodes, coefficient_from_value }
});
