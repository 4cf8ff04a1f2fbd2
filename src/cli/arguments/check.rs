//! Arguments of `check`.

use std::path::PathBuf;

use clap::Args;

/// Arguments of `check`.
#[derive(Debug, Args)]
pub struct CheckArguments {
    /// Keyframes: keyframe files or texts, of at most 1 GiB each.
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Print JSON: an object a line for each FILE, with ok, or with its problems.
    #[arg(long)]
    pub json: bool,
}
