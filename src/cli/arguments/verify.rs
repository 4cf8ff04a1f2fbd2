//! Arguments of `verify`.

use std::path::PathBuf;

use clap::Args;
use glob::Pattern;

use super::values::tolerance;

/// Arguments of `verify`.
#[derive(Debug, Args)]
pub struct VerifyArguments {
    /// The folder with pictures.json and the references.
    pub folder: PathBuf,
    /// Replace the references by the pictures drawn now.
    #[arg(long)]
    pub update: bool,
    /// The folder for drawn pictures, differences and index.html, a page that shows what differs [default: DIR/actual].
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Only pictures with such a name; *, ? and [abc] stand for other letters. May be repeated.
    #[arg(long, value_name = "NAME", value_parser = pattern)]
    pub only: Vec<Pattern>,
    /// The largest score that counts as equal, 0 to 1, instead of the list's tolerances.
    #[arg(long, value_name = "T", conflicts_with = "update", value_parser = tolerance)]
    pub tolerance: Option<f32>,
    /// Print the results as JSON instead of lines.
    #[arg(long, conflicts_with = "update")]
    pub json: bool,
    /// Also write the results as JUnit XML, which CI services read.
    #[arg(long, value_name = "FILE", conflicts_with = "update")]
    pub junit: Option<PathBuf>,
}

fn pattern(text: &str) -> Result<Pattern, String> {
    Pattern::new(text).map_err(|error| format!("{text:?} is no pattern: {}", error.msg))
}
