//! Arguments of `compare`.

use std::path::PathBuf;

use clap::Args;

use super::values::tolerance;
use crate::flip::DEFAULT_TOLERANCE;

/// Arguments of `compare`.
#[derive(Debug, Args)]
pub struct CompareArguments {
    /// The first image; or a folder of PNG images.
    #[arg(value_name = "A.png|DIR")]
    pub first: PathBuf,
    /// Images to compare it with, of the same size, each by itself; or a folder, whose images are compared with those of the same names.
    #[arg(required = true, value_name = "B.png|DIR")]
    pub others: Vec<PathBuf>,
    /// The largest score that counts as equal, 0 to 1. The score is the mean FLIP error of the worst thousandth of the pixels.
    #[arg(long, value_name = "T", default_value_t = DEFAULT_TOLERANCE, value_parser = tolerance)]
    pub tolerance: f32,
    /// Write a PNG of the differences: black where equal, brighter for larger differences. Of several images it is a folder.
    #[arg(short, long, value_name = "DIFF.png|DIR")]
    pub output: Option<PathBuf>,
    /// Print JSON, an object a line for each pair: a, b, score, mean (FLIP's own number: the mean of all pixels), largest, striking (the share of pixels with an error above 0.3), tolerance, within.
    #[arg(long)]
    pub json: bool,
}
