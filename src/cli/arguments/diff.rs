//! Arguments of `diff`.

use std::path::PathBuf;

use clap::Args;

use super::values::interpolation;
use crate::interpolation::Interpolation;
use crate::rbt::LARGEST_COORDINATE;

/// Arguments of `diff`.
#[derive(Debug, Args)]
pub struct DiffArguments {
    /// Keyframes: a keyframe file or a text, of at most 1 GiB.
    pub a: PathBuf,
    /// Keyframes to compare them with, each by itself.
    #[arg(required = true, value_name = "B")]
    pub others: Vec<PathBuf>,
    /// The tolerance of translations, in scene units.
    #[arg(long, value_name = "UNITS", default_value_t = 1e-3, value_parser = tolerance_of_poses)]
    pub tolerance_translation: f64,
    /// The tolerance of rotations, in degrees.
    #[arg(long, value_name = "DEGREES", default_value_t = 0.1, value_parser = tolerance_of_poses)]
    pub tolerance_rotation: f64,
    /// Frames a second to compare, 1 to 1000. The end is always compared.
    #[arg(long, value_name = "N", default_value_t = 60, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub fps: u32,
    /// Print JSON: an object a line for each B.
    #[arg(long)]
    pub json: bool,
    /// The interpolation to use for both instead of those of the files.
    #[arg(long, value_name = "NAME", value_parser = interpolation())]
    pub interpolation: Option<Interpolation>,
}

fn tolerance_of_poses(text: &str) -> Result<f64, String> {
    let tolerance =
        text.trim().parse().ok().filter(|tolerance| (0.0..=f64::from(LARGEST_COORDINATE)).contains(tolerance));
    tolerance.ok_or_else(|| format!("{text:?} is not a number from 0 to 1e6"))
}
