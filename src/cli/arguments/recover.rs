//! Arguments of `recover`.

use std::path::PathBuf;

use clap::Args;

/// Arguments of `recover`.
#[derive(Debug, Args)]
pub struct RecoverArguments {
    /// The journal; without it, the newest one that was left.
    #[arg(value_name = "JOURNAL")]
    pub journal: Option<PathBuf>,
    /// List the journals that hold what was not saved.
    #[arg(long, conflicts_with_all = ["journal", "output"])]
    pub list: bool,
    /// The keyframe file to write [default: NAME.recovered.json beside the keyframe file NAME.json].
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
    /// Print JSON: an object a line for each journal.
    #[arg(long)]
    pub json: bool,
}
