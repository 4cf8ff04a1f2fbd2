//! Arguments of `check`.

use std::path::PathBuf;

use clap::Args;

/// Arguments of `check`.
#[derive(Debug, Args)]
pub struct CheckArguments {
    /// Keyframe files, of at most 1 GiB each.
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
}
