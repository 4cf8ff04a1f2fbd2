//! Arguments of `compare`.

use std::path::PathBuf;

use clap::Args;

use super::values::tolerance;
use crate::flip::DEFAULT_TOLERANCE;

/// Arguments of `compare`.
#[derive(Debug, Args)]
pub struct CompareArguments {
    /// The first image.
    #[arg(value_name = "A.png")]
    pub first: PathBuf,
    /// The second image, of the same size.
    #[arg(value_name = "B.png")]
    pub second: PathBuf,
    /// The largest score that counts as equal, 0 to 1. The score is the mean FLIP error of the worst thousandth of the pixels.
    #[arg(long, value_name = "T", default_value_t = DEFAULT_TOLERANCE, value_parser = tolerance)]
    pub tolerance: f32,
    /// Write a PNG of the differences: black where equal, brighter for larger differences.
    #[arg(short, long, value_name = "DIFF.png")]
    pub output: Option<PathBuf>,
    /// Print JSON: score, mean (FLIP's own number: the mean of all pixels), largest, tolerance, within.
    #[arg(long)]
    pub json: bool,
}
