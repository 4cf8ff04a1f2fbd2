//! Arguments of `verify`.

use std::path::PathBuf;

use clap::Args;

/// Arguments of `verify`.
#[derive(Debug, Args)]
pub struct VerifyArguments {
    /// The folder with pictures.json and the references.
    pub folder: PathBuf,
    /// Replace the references by the pictures drawn now.
    #[arg(long)]
    pub update: bool,
    /// The folder for drawn pictures and differences [default: DIR/actual].
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
}
