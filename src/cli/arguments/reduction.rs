//! Arguments of commands that make keyframes of animations with a pose for each frame.

use clap::Args;

use super::values::{interpolation, positive};
use crate::interchange::reduce::{Choice, Tolerance};
use crate::interpolation::Interpolation;
use crate::rbt::LARGEST_COORDINATE;

/// How an animation becomes keyframes.
#[derive(Debug, Args)]
pub struct ReductionArguments {
    /// How far each node may be from the animation, in its parent's space: degrees, or degrees and scene units [default: 0.5 degree and
    /// a thousandth of the size].
    #[arg(long, value_name = "DEGREES[,UNITS]", value_parser = tolerance)]
    tolerance: Option<Asked>,
    /// Make so many keyframes a second, instead of as few as are within the tolerance.
    #[arg(long, value_name = "FPS", conflicts_with = "tolerance", value_parser = positive)]
    every: Option<f64>,
    /// The interpolation for which keyframes are made [default: linear].
    #[arg(long, value_name = "NAME", value_parser = interpolation())]
    interpolation: Option<Interpolation>,
}

/// A tolerance, where units may be left out.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Asked {
    degrees: f64,
    units: Option<f64>,
}

impl ReductionArguments {
    /// Whether nothing is asked for.
    pub fn is_usual(&self) -> bool {
        self.tolerance.is_none() && self.every.is_none() && self.interpolation.is_none()
    }

    /// Which keyframes are made. `usual`: the tolerance without arguments.
    pub fn choice(&self, usual: Tolerance) -> Choice {
        match (self.every, self.tolerance) {
            (Some(fps), _) => Choice::Every(fps),
            (None, None) => Choice::Within(usual),
            (None, Some(Asked { degrees, units })) => {
                Choice::Within(Tolerance { degrees, units: units.unwrap_or(usual.units) })
            }
        }
    }

    /// The interpolation for which they are made.
    pub fn interpolation(&self) -> Interpolation {
        self.interpolation.unwrap_or(Interpolation::Linear)
    }
}

fn tolerance(text: &str) -> Result<Asked, String> {
    let number =
        |text: &str, most: f64| text.trim().parse().ok().filter(|number: &f64| *number > 0.0 && *number <= most);
    let (degrees, units) = text.split_once(',').map_or((text, None), |(degrees, units)| (degrees, Some(units)));
    let units = units.map(|units| number(units, LARGEST_COORDINATE.into()));
    match (number(degrees, 180.0), units) {
        (Some(degrees), None) => Ok(Asked { degrees, units: None }),
        (Some(degrees), Some(Some(units))) => Ok(Asked { degrees, units: Some(units) }),
        _ => Err(format!(
            "{text:?} is not DEGREES or DEGREES,UNITS, as in 0.5 or 0.5,0.01: above 0, at most 180 and 1e6"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances() {
        assert_eq!(tolerance("0.5"), Ok(Asked { degrees: 0.5, units: None }));
        assert_eq!(tolerance("2, 0.01"), Ok(Asked { degrees: 2.0, units: Some(0.01) }));
        for bad in ["", "0", "-1", "181", "1,", "1,0", "1,1e7", "nan", "1,2,3"] {
            assert!(tolerance(bad).is_err(), "{bad}");
        }
    }
}
